"""What student code can import: Python's own modules and installed ones, never lesson_code."""

from __future__ import annotations

import sys
from typing import Any


class LessonCodeBlocked:
    """Refuses to import lesson_code: graded code has to stand on its own."""

    def find_spec(self, name: str, *_: Any) -> None:
        """Raise for lesson_code, and leave every other module to the next finder."""
        if name.partition(".")[0] == "lesson_code":
            raise ImportError("lesson_code cannot be imported while an answer is graded")


def forget_the_way_here(readable: tuple[str, ...]) -> None:
    """Keep on the path of imports only what a child may read, and block lesson_code everywhere."""
    sys.path[:] = [p for p in sys.path if any(f"{p}/".startswith(f"{r}/") for r in readable)]
    sys.argv[:] = [""]
    sys.meta_path.insert(0, LessonCodeBlocked())
