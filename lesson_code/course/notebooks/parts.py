"""The parts of a chapter's notebook: ``07_time_of_impact``, then ``07b_from_event_to_event``.

Most chapters have one. The names of parts sort in the order in which they are read, and their
sections are numbered through.
"""

from __future__ import annotations

import json
import re
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Part:
    """A notebook of a chapter: its name without the suffix, and its text without the code."""

    name: str
    prose: str

    @property
    def title(self) -> str:
        """Its number and what it is about: ``07b From event to event``."""
        return self.prose.partition("\n")[0].removeprefix("# ")

    def has_section(self, number: int) -> bool:
        """Return whether a section of this number stands in it."""
        return re.search(rf"^## {number} ", self.prose, re.MULTILINE) is not None


def parts(root: Path, chapter: str) -> list[Part]:
    """Return the parts of a chapter's notebook, in the order in which they are read.

    Parameters
    ----------
    root : Path
        The workbook.
    chapter : str
        The chapter's number, "07".
    """
    paths = sorted((root / "notebooks").glob(f"{chapter}*.ipynb"))
    return [Part(path.stem, _prose(path)) for path in paths]


def _prose(path: Path) -> str:
    """Return the text of a notebook's markdown cells; none of a file that is no notebook."""
    try:
        cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
        texts = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "markdown"]
    except (OSError, ValueError, LookupError, TypeError):  # a reader may have done anything to it
        return ""
    return "\n\n".join(texts)
