"""The text of a student's answer, for the instructor to read: cut out, never parsed or run."""

from __future__ import annotations

import re
from collections.abc import Iterable

LONGEST_ANSWER = 1_500
"""Characters. A chapter's answers take 200 to 600."""


def answer_in(sources: Iterable[str], function: str) -> str:
    r"""Return the last definition of a function at the left margin; if there is none, "".

    Examples
    --------
    >>> answer_in(["x = 1", "def f(a):\n    return a\n\nf(1)"], "f")
    'def f(a):\n    return a'
    """
    begins = re.compile(rf"^(async )?def[ \t]+{re.escape(function)}\b", re.MULTILINE)
    found = [(source, match.start()) for source in sources for match in begins.finditer(source)]
    if not found:
        return ""
    source, start = found[-1]
    lines = source[start : start + 2 * LONGEST_ANSWER].splitlines()
    ends = (n for n, line in enumerate(lines) if n and line[:1] not in ("", " ", "\t", ")", "#"))
    answer = "\n".join(lines[: next(ends, len(lines))]).rstrip()
    return answer if len(answer) <= LONGEST_ANSWER else f"{answer[:LONGEST_ANSWER]}\n..."
