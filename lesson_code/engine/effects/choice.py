"""What a run reckons with: what its scene calls for, what its solver has, and what is asked for.

What is left out changes nothing, to the last bit. Two effects are savings: without a broad phase
or without sleep a run takes longer, and its result is the same. They may be left out of any run,
and so may the record of impulses. To leave out any other that is called for is an error.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from importlib import import_module

from lesson_code.engine.core.plan import EffectChoice
from lesson_code.engine.effects.collisions import where_bodies_meet
from lesson_code.engine.effects.flags import NAMES, Effects
from lesson_code.engine.effects.question import Effect, Finding, Question
from lesson_code.engine.solvers import our_solvers


def _found() -> dict[str, Effect]:
    """Return the effects of this folder by their names, in the order of the stages."""
    effects = {name: import_module(f"{__package__}.{name}").EFFECT for name in NAMES}
    return dict(sorted(effects.items(), key=lambda item: item[1].place))


EFFECTS = _found()
"""All effects, by name, in the order of the stages."""

OPTIONAL = tuple(name for name, effect in EFFECTS.items() if effect.is_optional)
"""What may be left out although it is called for: no state of the run depends on it."""


@cache
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
    >>> find(Question(Scene([Body(Circle(1), mass=1.0)])), "friction").reason
    'no two bodies can meet within the run'
    """
    lacking, built_in = capabilities(question.solver)
    effect = EFFECTS[name]
    if name in lacking and name != "collisions":
        return Finding(False, lacking[name])
    rule = (lambda _: Finding(True, built_in[name])) if name in built_in else effect.rule
    facts = question.facts
    return where_bodies_meet(facts, rule) if effect.needs_collisions else rule(facts)


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
    return tuple(_choice(question, name, wishes.get(name)) for name in EFFECTS)


IN_ANY_SCENE = ("broad_phase", "impulse_record")
"""Effects without which a run cannot be made by a program for any scene: its tables are made for a
grid, or not, and its impulses are written down, or not."""


def suit_any_scene(choices: Iterable[EffectChoice]) -> bool:
    """Return whether a program that has every effect does what a run with these asks for.

    It does not where something is left out that the scene calls for.
    """
    return all(c.used or not (c.called_for or c.name in IN_ANY_SCENE) for c in choices)


def flags_of(choices: tuple[EffectChoice, ...]) -> Effects:
    """Return the flags that the stages are made for."""
    return Effects(**{choice.name: choice.used for choice in choices})


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
        if name not in EFFECTS:
            raise ValueError(f"effects: the names are {', '.join(EFFECTS)}; got {name!r}")
        if not isinstance(value, bool):
            raise TypeError(f"effects[{name!r}] must be True or False, got {value!r}")
    return asked


def _choice(question: Question, name: str, wish: bool | None) -> EffectChoice:
    """Return what becomes of one effect."""
    found = find(question, name)
    called_for, reason = found.called_for, found.reason
    lacking, built_in = capabilities(question.solver)
    if wish is False and called_for and not EFFECTS[name].is_optional:
        is_built_in = reason == built_in.get(name)
        who = f"{question.solver!r} cannot do without" if is_built_in else "the scene needs it"
        raise ValueError(f"effects[{name!r}] must not be False: {who} ({reason})")
    if wish is True and (name in lacking or EFFECTS[name].is_ruled_out(question.facts)):
        raise ValueError(
            f"effects[{name!r}] must not be True for {question.solver!r} here: {reason}"
        )
    return EffectChoice(name, called_for if wish is None else wish, called_for, reason)
