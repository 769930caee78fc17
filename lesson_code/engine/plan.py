"""How a scene was simulated: by which solver, and why."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Plan:
    """The solver that ran, and the reason for it.

    Attributes
    ----------
    solver : str
        Its name, as :func:`lesson_code.simulate` takes it.
    reason : str
        Why this one.

    Examples
    --------
    >>> print(Plan(solver="sequential", reason="asked for"))
    solver: sequential (asked for)
    """

    solver: str
    reason: str

    def __str__(self) -> str:
        """Return the plan as a line of text."""
        return f"solver: {self.solver} ({self.reason})"
