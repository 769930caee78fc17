"""How a scene was simulated: by which solver, in which code, and why."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Plan:
    """The solver that ran, the code it ran as, and the reasons.

    Attributes
    ----------
    solver : str
        Its name, as :func:`lesson_code.simulate` takes it.
    reason : str
        Why this one.
    code : str
        "plain Python", "compiled", or that of another engine.
    code_reason : str
        Why that.

    Examples
    --------
    >>> print(Plan(solver="sequential", reason="asked for"))
    solver: sequential (asked for); plain Python (a small run)
    """

    solver: str
    reason: str
    code: str = "plain Python"
    code_reason: str = "a small run"

    def __str__(self) -> str:
        """Return the plan as a line of text."""
        return f"solver: {self.solver} ({self.reason}); {self.code} ({self.code_reason})"
