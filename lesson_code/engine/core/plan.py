"""How a scene was simulated: by which solver, in which code, with which effects, and why."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field


@dataclass(frozen=True)
class EffectChoice:
    """Whether a run reckons with an effect, and why.

    Attributes
    ----------
    name : str
        As `simulate(effects=...)` takes it.
    used : bool
        Whether it is in the program.
    called_for : bool
        Whether the scene needs it.
    reason : str
        The rule's, in a sentence.
    """

    name: str
    used: bool
    called_for: bool
    reason: str

    @property
    def verdict(self) -> str:
        """The decision about the effect, in a word or two."""
        if self.used == self.called_for:
            return "used" if self.used else "left out"
        return "forced" if self.used else "switched off"


@dataclass(frozen=True)
class Plan:
    """The solver that ran, the code it ran as, the effects it reckoned with, and the reasons.

    It prints as a table, in a terminal and in a notebook.

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
    effects : tuple of EffectChoice
        What was simulated and what was left out; none for other engines.
    changes : tuple of str
        What callbacks have changed while the scene ran, and what the plan became.
    program : callable, optional
        Returns the source of the program that the plan leaves over.

    Examples
    --------
    >>> print(Plan(solver="sequential", reason="asked for"))
    solver: sequential (asked for); plain Python (a small run)
    """

    solver: str
    reason: str
    code: str = "plain Python"
    code_reason: str = "a small run"
    effects: tuple[EffectChoice, ...] = ()
    changes: tuple[str, ...] = ()
    program: Callable[[], str] | None = field(default=None, compare=False, repr=False)

    @property
    def headline(self) -> str:
        """Solver and code, with the reasons, in a line of text."""
        return f"solver: {self.solver} ({self.reason}); {self.code} ({self.code_reason})"

    def effect(self, name: str) -> EffectChoice:
        """Return what has become of an effect.

        Raises
        ------
        ValueError
            The plan says nothing of it.
        """
        for choice in self.effects:
            if choice.name == name:
                return choice
        names = ", ".join(choice.name for choice in self.effects) or "none"
        raise ValueError(f"name must be one of the plan's effects ({names}), got {name!r}")

    @property
    def used(self) -> tuple[str, ...]:
        """The names of the effects that were simulated."""
        return tuple(choice.name for choice in self.effects if choice.used)

    @property
    def left_out(self) -> tuple[str, ...]:
        """The names of the effects that were not."""
        return tuple(choice.name for choice in self.effects if not choice.used)

    def source(self) -> str:
        """Return the program that the plan leaves over: this is all that the scene needs.

        It is made of the engine's functions, with the branches of the effects that are left out
        taken away; compiled or not, a run does what it says.

        Raises
        ------
        ValueError
            The solver belongs to another engine.
        """
        if self.program is None:
            raise ValueError(f"solver must be one of ours to have a source here: {self.solver}")
        return self.program()

    def __str__(self) -> str:
        """Return the plan as text: its headline, and a row for each effect."""
        return "\n".join([self.headline, *self._rows(), *(f"  {line}" for line in self.changes)])

    def _rows(self) -> list[str]:
        """Return the effects as lines of a table."""
        width = max((len(choice.name) for choice in self.effects), default=0)
        return [f"  {c.name:<{width}}  {c.verdict:<12}  {c.reason}" for c in self.effects]

    def _repr_html_(self) -> str:
        """Return the plan as a table for a notebook."""
        from html import escape

        rows = "".join(
            f"<tr><td>{escape(c.name)}</td><td>{escape(c.verdict)}</td>"
            f'<td style="text-align: left">{escape(c.reason)}</td></tr>'
            for c in self.effects
        )
        head = "<tr><th>effect</th><th>verdict</th><th>reason</th></tr>"
        changes = "".join(f"<p>{escape(line)}</p>" for line in self.changes)
        return f"<p>{escape(self.headline)}</p><table>{head}{rows}</table>{changes}"
