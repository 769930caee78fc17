"""What a run reckons with: what its scene calls for, what its solver has, and what is asked for.

What is left out changes nothing, to the last bit. Two effects are savings: without a broad phase
or without sleep a run takes longer, and its result is the same. They may be left out of any run,
and so may the record of impulses. To leave out any other that is called for is an error.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import import_module

from lesson_code.engine.core.plan import EffectChoice
from lesson_code.engine.effects.flags import NAMES, Effects
from lesson_code.engine.effects.question import Effect, Finding, Question


def _found() -> dict[str, Effect]:
    """Return the effects of this folder by their names, in the order of the stages."""
    effects = {name: import_module(f"{__package__}.{name}").EFFECT for name in NAMES}
    return dict(sorted(effects.items(), key=lambda item: item[1].place))


EFFECTS = _found()
"""All effects, by name, in the order of the stages."""

OPTIONAL = tuple(name for name, effect in EFFECTS.items() if effect.is_optional)
"""What may be left out although it is called for: no state of the run depends on it."""

_EXACT = "collisions are computed at their times, not seen after a step"
_OWN = "the direct solver finds all impulses of an island at once"

LACKING: dict[str, dict[str, str]] = {
    "naive": {
        "friction": "the naive solver knows none",
        "continuous": "the naive solver looks for no fast bodies",
        "warm_starting": "the naive solver remembers nothing",
        "position_correction": "the naive solver shifts each pair as it visits it",
        "sleeping": "only the sequential solver lets islands sleep",
    },
    "direct": {"sleeping": "only the sequential solver lets islands sleep"},
    "substep": {"sleeping": "only the sequential solver lets islands sleep"},
    "exact": {
        "manifolds": "discs touch at one point",
        "seams": "at the end of a face a disc hops, onto the next one if there is one",
        "damping": "damped motion has no closed form here",
        "callbacks": "it calls none",
        "continuous": _EXACT,
        "warm_starting": "no contact lasts for a step: there are none",
        "position_correction": _EXACT,
        "sleeping": "a disc at rest has no events",
    },
}
"""Effects that a solver does not have, and why."""

BUILT_IN: dict[str, dict[str, str]] = {
    "direct": {"friction": _OWN, "warm_starting": "the cases of the last step are the first guess"},
    "substep": {"warm_starting": "each sub-step begins with the impulses of the one before"},
}
"""Effects that a solver cannot do without, whatever the scene calls for, and why."""


def find(question: Question, name: str) -> Finding:
    """Return whether a scene calls for an effect, and why.

    Examples
    --------
    >>> from lesson_code import Body, Circle, Scene
    >>> find(Question(Scene([Body(Circle(1), mass=1.0)])), "friction")
    Finding(called_for=False, reason='no two bodies can meet within the run')
    """
    return _find(question, name, EFFECTS["collisions"].rule(question))


def _find(question: Question, name: str, meeting: Finding) -> Finding:
    """Return it, where it is known whether bodies meet: most effects depend on that."""
    lacking, built_in = LACKING.get(question.solver, {}), BUILT_IN.get(question.solver, {})
    effect = EFFECTS[name]
    if name in lacking:
        return Finding(False, lacking[name])
    if effect.needs_collisions and not meeting.called_for:
        return Finding(False, meeting.reason)
    return Finding(True, built_in[name]) if name in built_in else effect.rule(question)


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
    meeting = EFFECTS["collisions"].rule(question)
    return tuple(
        _choice(question, name, _find(question, name, meeting), wishes.get(name))
        for name in EFFECTS
    )


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


def _choice(question: Question, name: str, found: Finding, wish: bool | None) -> EffectChoice:
    """Return what becomes of one effect."""
    called_for, reason = found
    if wish is False and called_for and not EFFECTS[name].is_optional:
        is_built_in = reason == BUILT_IN.get(question.solver, {}).get(name)
        who = f"{question.solver!r} cannot do without" if is_built_in else "the scene needs it"
        raise ValueError(f"effects[{name!r}] must not be False: {who} ({reason})")
    lacking = name in LACKING.get(question.solver, {})
    if wish is True and (lacking or EFFECTS[name].is_ruled_out(question)):
        raise ValueError(
            f"effects[{name!r}] must not be True for {question.solver!r} here: {reason}"
        )
    return EffectChoice(name, called_for if wish is None else wish, called_for, reason)
