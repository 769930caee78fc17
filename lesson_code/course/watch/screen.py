"""Where a session is written: a terminal with colours and a bar, or plain lines.

Plain lines are for screen readers and logs: nothing is overwritten or cleared, nothing is said by
a colour, a bar or a sign alone.
"""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Console
from rich.padding import Padding
from rich.progress_bar import ProgressBar
from rich.table import Table
from rich.text import Text


class Screen:
    """Writes what a session has to say.

    Parameters
    ----------
    console : rich.console.Console
        Where to.
    plain : bool
        In plain lines.
    """

    def __init__(self, console: Console, *, plain: bool) -> None:
        self._console = console
        self._plain = plain

    def begin(self) -> None:
        """Begin a new screenful."""
        if not self._plain:
            self._console.clear()

    def course(self, tasks: tuple[int, int], points: tuple[int, int]) -> None:
        """Say how far the course is."""
        told = f"{tasks[0]} of {tasks[1]} tasks right, {points[0]} of {points[1]} points"
        if self._plain:
            self.say(f"Course: {told}")
            return
        line = Table.grid(padding=(0, 2))
        line.add_row("Course", ProgressBar(points[1], points[0], width=30), told)
        self._console.print(line)

    def exercise(self, title: str, tasks: Sequence[tuple[str, bool]]) -> None:
        """Say what each task of an exercise has earned."""
        self.say("")
        self.say(title, style="bold")
        for line, is_right in tasks:
            if self._plain:
                self.say(f"{'right' if is_right else 'not right'}: {line}")
            else:
                sign = Text("✓ " if is_right else "✗ ", style="green" if is_right else "yellow")
                self._console.print(Text.assemble("  ", sign, line), soft_wrap=True)

    def help(self, title: str, steps: Sequence[str]) -> None:
        """Say what helps with a task."""
        self.say("")
        self.say(f"Next: {title}", style="bold")
        for step in steps:
            if self._plain:
                self.say(step)
            else:
                self._console.print(Padding(Text(step), (0, 0, 0, 2)))
        self.say("")

    def row(self, *cells: str) -> None:
        """Say a line of a list."""
        first, *rest = cells
        self.say(
            f"{first}: {', '.join(rest)}" if self._plain else "  ".join([f"{first:28}", *rest])
        )

    def code(self, source: str) -> None:
        """Show some code."""
        self.say("")
        self.say(source)

    def say(self, line: str, style: str | None = None) -> None:
        """Say a line as it is, without breaking it where it is plain."""
        self._console.print(
            line,
            style=None if self._plain else style,
            markup=False,
            highlight=False,
            soft_wrap=self._plain,
        )
