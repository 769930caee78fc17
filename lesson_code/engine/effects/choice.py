"""What a run reckons with: what its scene calls for, what its solver has, and what is asked for.

What is left out changes nothing, to the last bit. Two effects are savings: without a broad phase
or without sleep the result is the same, and only the time is not. They may be left out of any run;
and so may the record. To leave out another that is called for is an error.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from lesson_code.engine.effects.flags import Effects
from lesson_code.engine.effects.rules import RULES, Finding, Question, collisions
from lesson_code.engine.solvers import our_solvers

OPTIONAL = ("broad_phase", "sleeping", "impulse_record")
"""What may be left out although it is called for: no state of the run depends on it."""

OF_COLLISIONS = (
    *("broad_phase", "outlines", "manifolds", "seams", "continuous", "restitution", "friction"),
    *("warm_starting", "position_correction", "sleeping", "callbacks", "impulse_record"),
)
"""What no scene calls for in which nothing meets."""


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
        """What has become of it, in a word or two."""
        if self.used == self.called_for:
            return "used" if self.used else "left out"
        return "forced" if self.used else "switched off"


def capabilities(solver: str) -> tuple[Mapping[str, str], Mapping[str, str]]:
    """Return the effects that a solver lacks, and those that it cannot do without, and why.

    None of either where it is still to be chosen.
    """
    ours = our_solvers().get(solver)
    return (ours.lacks, ours.built_in) if ours else ({}, {})


def find(question: Question, name: str) -> Finding:
    """Return whether a scene calls for an effect, and why.

    Examples
    --------
    >>> from lesson_code import Body, Circle, Scene
    >>> find(Question(Scene([Body(Circle(1), mass=1.0)])), "friction")
    Finding(called_for=False, reason='no two bodies can meet within the run')
    """
    lacking, built_in = capabilities(question.solver)
    if name in lacking:
        return Finding(False, lacking[name])
    if name in OF_COLLISIONS:
        meeting = collisions(question)
        if not meeting.called_for:
            return Finding(False, meeting.reason)
    return Finding(True, built_in[name]) if name in built_in else RULES[name](question)


def choose_effects(
    question: Question, asked: Mapping[str, bool] | None = None
) -> tuple[EffectChoice, ...]:
    """Return what a run reckons with: what the scene calls for, and what the user has asked for.

    Parameters
    ----------
    question : Question
        The scene, and how it is to be run.
    asked : mapping from str to bool, optional
        True forces an effect on, False leaves it out.

    Raises
    ------
    ValueError
        There is no effect of that name, the solver does not have it, or the scene needs what is
        to be left out.
    TypeError
        `asked` is no mapping, or a value in it is neither True nor False.

    Examples
    --------
    >>> from lesson_code import Body, Circle, Scene
    >>> floor, ball = Body(Circle(1)), Body(Circle(1), mass=1.0, position=(0, 3))
    >>> by_name = {choice.name: choice for choice in choose_effects(Question(Scene([floor, ball])))}
    >>> by_name["gravity"].used, by_name["gravity"].reason
    (False, 'g = 0')
    """
    wishes = checked_wishes(asked)
    return tuple(_choice(question, name, wishes.get(name)) for name in RULES)


def flags_of(choices: tuple[EffectChoice, ...]) -> Effects:
    """Return the flags that the stages are made for."""
    used = names_used(choices)
    return Effects(**{name: name in used for name in Effects._fields})


def names_used(choices: tuple[EffectChoice, ...]) -> set[str]:
    """Return the names of the effects that a run reckons with."""
    return {choice.name for choice in choices if choice.used}


def checked_wishes(asked: Mapping[str, bool] | None) -> Mapping[str, bool]:
    """Return what has been asked for, or refuse what makes no sense."""
    if asked is None:
        return {}
    if not isinstance(asked, Mapping):
        raise TypeError(f'effects must be a mapping such as {{"friction": True}}, got {asked!r}')
    for name, value in asked.items():
        if name not in RULES:
            raise ValueError(f"effects: the names are {', '.join(RULES)}; got {name!r}")
        if not isinstance(value, bool):
            raise TypeError(f"effects[{name!r}] must be True or False, got {value!r}")
    return asked


def _choice(question: Question, name: str, wish: bool | None) -> EffectChoice:
    """Return what becomes of one effect."""
    called_for, reason = find(question, name)
    lacking, built_in = capabilities(question.solver)
    if wish is False and called_for and name not in OPTIONAL:
        is_built_in = reason == built_in.get(name)
        who = f"{question.solver!r} cannot do without" if is_built_in else "the scene needs it"
        raise ValueError(f"effects[{name!r}] must not be False: {who} ({reason})")
    if wish is True and (
        name in lacking or (name == "sleeping" and question.scene.callbacks.wanted)
    ):
        raise ValueError(
            f"effects[{name!r}] must not be True for {question.solver!r} here: {reason}"
        )
    return EffectChoice(name, called_for if wish is None else wish, called_for, reason)
