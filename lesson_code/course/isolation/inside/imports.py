"""What student code can import: Python's own modules and a few packages, never lesson_code.

The child's finder says so in words. Behind a full wall the files of other packages are not there.
"""

from __future__ import annotations

import sys
from typing import Any

PACKAGES = ("numpy", "pygame")
"""What an answer may import beside Python's own modules: what the exercises themselves import."""

BUILD_DATA = "_sysconfigdata_"
"""How the module begins that says how Python was built; `from numpy import *` imports it, and its
name differs from system to system."""

THE_LIST = "answers can use Python's own modules, NumPy and pygame"


def may_be_imported(module: str) -> bool:
    """Return whether an answer may import a module.

    >>> [may_be_imported(name) for name in ("math", "numpy.linalg", "pymunk", "lesson_code")]
    [True, True, False, False]
    """
    root = module.partition(".")[0]
    return root in sys.stdlib_module_names or root in PACKAGES or root.startswith(BUILD_DATA)


class OnlyTheList:
    """Refuses to import anything else: graded code has to stand on its own."""

    def find_spec(self, name: str, *_: Any) -> None:
        """Raise for a module beyond the list, and leave every other one to the next finder."""
        if not may_be_imported(name):
            root = name.partition(".")[0]
            text = f"{root} cannot be imported while an answer is graded: {THE_LIST}"
            raise ModuleNotFoundError(text, name=root)


def forget_the_way_here(readable: tuple[str, ...]) -> None:
    """Keep on the path of imports only what a child may read, and import only what is listed."""
    sys.path[:] = [p for p in sys.path if any(_overlap(p, r) for r in readable)]
    sys.argv[:] = [""]
    sys.meta_path.insert(0, OnlyTheList())


def _overlap(entry: str, readable: str) -> bool:
    """Return whether an entry of the path lies in a readable folder, or holds one as a package."""
    return f"{entry}/".startswith(f"{readable}/") or readable.rpartition("/")[0] == entry
