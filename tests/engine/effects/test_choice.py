"""What becomes of the effects of a run: what is asked for, what solvers have, what is refused."""

from __future__ import annotations

from typing import Any

import pytest

from lesson_code import Body, Callbacks, Circle, Material, Scene, Segment, simulate
from lesson_code.engine.effects.choice import (
    EFFECTS,
    OPTIONAL,
    choose_effects,
    find,
    flags_of,
)
from lesson_code.engine.effects.flags import Effects
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers import our_solvers
from lesson_code.evidence.scenes.effects import EffectPair, pairs


def disc(x: float = 0.0, *surface: float | None, **rest: Any) -> Body:
    """Return a disc of 1 kg and 1 m across, whose surface is e, mu."""
    given: dict[str, Any] = {"mass": 1.0, "position": (x, 0.0), "material": Material(*surface)}
    return Body(Circle(0.5), **(given | rest))


def floor(*surface: float | None, **rest: Any) -> Body:
    """Return a line that nothing can push."""
    return Body(Segment((-9, -1), (9, -1)), material=Material(*surface), **rest)


EVERY_PAIR = [pytest.param(pair, id=pair.effect) for pair in pairs()]


@pytest.mark.parametrize("pair", EVERY_PAIR)
def test_effect_that_is_needed_cannot_be_left_out(pair: EffectPair) -> None:
    """It is refused by name, with the rule's reason; what is a saving may always be."""
    question = Question(pair.needs, duration=pair.duration)
    asked = {pair.effect: False}
    if pair.effect in OPTIONAL:
        assert dict(verdicts(question, asked))[pair.effect] == "switched off"
        return
    reason = find(question, pair.effect).reason
    with pytest.raises(ValueError) as refused:  # noqa: PT011 - the whole text is compared
        choose_effects(question, asked)
    said = f"effects[{pair.effect!r}] must not be False: the scene needs it ({reason})"
    assert str(refused.value) == said


@pytest.mark.parametrize("pair", EVERY_PAIR)
def test_effect_that_is_not_needed_may_be_left_out_or_forced(pair: EffectPair) -> None:
    """The plan says which of both has happened."""
    question = Question(pair.spared, duration=pair.duration)
    found = [dict(verdicts(question, {pair.effect: wish}))[pair.effect] for wish in (False, True)]
    always = pair.effect == "impulse_record"  # is called for by every scene
    assert found == (["switched off", "used"] if always else ["left out", "forced"])


def verdicts(question: Question, asked: dict[str, bool]) -> list[tuple[str, str]]:
    """Return what becomes of every effect."""
    return [(choice.name, choice.verdict) for choice in choose_effects(question, asked)]


def gravity_scene() -> Scene:
    """Return a ball that falls on a floor."""
    return Scene([disc(0, 0.5, 0.5), floor(0.5, 0.5)], gravity=(0, -10))


@pytest.mark.parametrize("name", ["gravity", "friction", "restitution", "collisions"])
@pytest.mark.parametrize("solver", ["auto", "sequential", "substep", "direct"])
def test_simulate_refuses_to_leave_out_what_the_scene_needs(name: str, solver: str) -> None:
    """Whoever solves it; the name stands in the error."""
    with pytest.raises(ValueError, match=rf"effects\['{name}'\] must not be False"):
        simulate(gravity_scene(), 1.0, solver=solver, effects={name: False})


@pytest.mark.parametrize(
    ("effects", "error", "words"),
    [
        ({"frictoin": True}, ValueError, "the names are collisions, .*; got 'frictoin'"),
        ({"friction": 1}, TypeError, r"effects\['friction'\] must be True or False, got 1"),
        ({"friction": None}, TypeError, r"effects\['friction'\] must be True or False, got None"),
        (["friction"], TypeError, "effects must be a mapping such as .*, got \\['friction'\\]"),
        ("friction", TypeError, "effects must be a mapping such as .*, got 'friction'"),
        ({3: True}, ValueError, "the names are .*; got 3"),
    ],
)
@pytest.mark.parametrize("solver", ["sequential", "auto"])
def test_effects_that_make_no_sense_are_refused(
    solver: str, effects: Any, error: type[Exception], words: str
) -> None:
    """With the argument, the rule and the value."""
    with pytest.raises(error, match=words):
        simulate(gravity_scene(), 0.1, solver=solver, effects=effects)


@pytest.mark.parametrize(
    ("solver", "name"), [(s.name, name) for s in our_solvers().values() for name in s.lacks]
)
def test_effect_that_a_solver_lacks_cannot_be_forced_on(solver: str, name: str) -> None:
    """It says why; and the plan shows it as left out for that reason."""
    question = Question(gravity_scene(), solver, duration=9.0)
    with pytest.raises(ValueError, match=rf"effects\['{name}'\] must not be True for '{solver}'"):
        choose_effects(question, {name: True})
    choice = {c.name: c for c in choose_effects(question)}[name]
    assert (choice.verdict, choice.reason) == ("left out", our_solvers()[solver].lacks[name])


def test_sleep_cannot_be_forced_on_where_callbacks_hear_of_every_contact() -> None:
    """A sleeping island has none to tell of."""
    scene = gravity_scene()
    heard = Scene(scene.bodies, scene.gravity, callbacks=Callbacks(post_solve=print))
    with pytest.raises(ValueError, match=r"effects\['sleeping'\] must not be True"):
        choose_effects(Question(heard, duration=9.0), {"sleeping": True})


@pytest.mark.parametrize("solver", ["pymunk", "box2d"])
def test_effects_of_other_engines_cannot_be_chosen(solver: str) -> None:
    """They have one program for all scenes."""
    with pytest.raises(ValueError, match=f"effects must be None for {solver}"):
        simulate(gravity_scene(), 0.1, solver=solver, effects={"friction": True})


# The plan of a solver


@pytest.mark.parametrize("solver", ["sequential", "substep", "direct", "naive", "exact"])
def test_every_effect_has_a_choice_in_the_order_of_the_rules(solver: str) -> None:
    """And each has a reason in words."""
    choices = choose_effects(Question(gravity_scene(), solver, duration=1.0))
    assert [choice.name for choice in choices] == list(EFFECTS)
    assert all(choice.reason and not choice.reason.endswith(".") for choice in choices)


@pytest.mark.parametrize(
    ("solver", "name"), [(s.name, name) for s in our_solvers().values() for name in s.built_in]
)
def test_effect_that_is_built_in_is_used_whatever_the_scene(solver: str, name: str) -> None:
    """Two smooth discs that meet; the plan says that the solver cannot do without."""
    smooth = Scene([disc(0, 0.0, 0.0, velocity=(1, 0)), disc(1.5, 0.0, 0.0)])
    reason = our_solvers()[solver].built_in[name]
    found = find(Question(smooth, solver, duration=1.0), name)
    assert (found.called_for, found.reason) == (True, reason)


def test_flags_are_those_of_the_choices() -> None:
    """What has a flag in the stages is set as it was chosen."""
    question = Question(gravity_scene(), duration=9.0)
    used = {choice.name: choice.used for choice in choose_effects(question, {"sleeping": False})}
    flags = flags_of(choose_effects(question, {"sleeping": False}))
    assert flags._asdict() == {name: used[name] for name in Effects._fields}
    assert flags.gravity
    assert not flags.damping
    assert not flags.sleeping
