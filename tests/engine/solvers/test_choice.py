"""solver="auto": which solver is chosen, at the border of each rule, and what is said of it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from lesson_code import (
    Body,
    Callbacks,
    Circle,
    Material,
    Polygon,
    Scene,
    Segment,
    simulate,
)
from lesson_code.engine.core.constants import (
    MOST_DRIFTING,
    MOST_FALLING,
    MOST_FOR_DIRECT,
    MOST_STANDING,
    SKIN,
    TOUCHING,
)
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers import choice, exact
from lesson_code.engine.solvers.choice import (
    SolverChoice,
    flies_freely,
    is_apart,
    solvers_for,
)

ELASTIC = Material(restitution=1.0)
DULL, ROUGH = Material(restitution=0.9), Material(restitution=1.0, friction=0.5)


def disc(x: float = 0.0, **rest: Any) -> Body:
    """Return an elastic disc of 1 kg and radius 1/2 m."""
    given: dict[str, Any] = {"mass": 1.0, "position": (x, 0.0), "material": ELASTIC}
    return Body(Circle(0.5), **(given | rest))


def blocks(count: int, **rest: Any) -> Scene:
    """Return blocks in a row, which are not for the exact solver."""
    box = Polygon.box(1, 1)
    return Scene([Body(box, mass=1.0, position=(2.0 * n, 0)) for n in range(count)], **rest)


def choices(scene: Scene, asked: dict[str, Any] | None = None, **rest: Any) -> list[SolverChoice]:
    """Return the solvers that suit a scene."""
    return list(solvers_for(Question(scene, duration=1.0), asked=asked or {}, **rest))


def names(scene: Scene, asked: dict[str, Any] | None = None, **rest: Any) -> list[str]:
    """Return their names."""
    return [choice.solver for choice in choices(scene, asked, **rest)]


FLOOR = Body(Segment((-9, -2), (9, -2)), material=ELASTIC)


def test_discs_that_fly_freely_are_for_the_exact_solver() -> None:
    """With the others behind it, should it find no end."""
    assert names(Scene([disc(0), disc(3)])) == ["exact", "direct", "substep", "sequential"]


@pytest.mark.parametrize(
    ("scene", "expected"),
    [
        (Scene([disc(0), disc(3)]), True),
        (Scene([disc(0), FLOOR]), True),
        (Scene([FLOOR]), False),
        (Scene([disc(0), Body(Polygon.box(1, 1), mass=1.0, position=(3, 0))]), False),
        (Scene([disc(0), FLOOR], gravity=(0, -10)), True),
        (Scene([disc(0), disc(3)], gravity=(0, -10)), True),
        (Scene([disc(0), FLOOR, FLOOR], gravity=(0, -10)), True),
        (Scene([disc(0), disc(3, material=DULL)], gravity=(0, -10)), False),
        (Scene([disc(0), disc(3, material=ROUGH)], gravity=(0, -10)), False),
        (Scene([disc(0, material=DULL), FLOOR, FLOOR], gravity=(0, -10)), False),
        (Scene([disc(0), disc(3, material=Material(0.0))]), False),
        (Scene([disc(0), disc(3, material=Material(1e-9))]), True),
        (Scene([disc(0), disc(3)], callbacks=Callbacks(begin=print)), False),
        (Scene([disc(0), Body(Circle(1), position=(5, 0), velocity=(-1, 0))]), False),
    ],
    ids=[
        "discs", "a disc and a wall", "nobody to fly", "a block", "one under gravity",
        "two under gravity", "a wedge under gravity", "a dull one under gravity",
        "two that rub under gravity", "a dull one in a wedge", "that stay together",
        "that hardly bounce",
        "callbacks", "a wall that moves",
    ],
)  # fmt: skip
def test_exact_solver_is_for_discs_that_part_again(scene: Scene, expected: bool) -> None:
    """And under gravity for those that lose no energy, or a single one over one obstacle."""
    assert flies_freely(Question(scene, duration=1.0)) is expected


@pytest.mark.parametrize(
    ("gap", "expected"), [(-0.1, False), (0.0, False), (TOUCHING / 4, False), (4 * TOUCHING, True)]
)
def test_discs_that_touch_at_the_start_are_not_apart(gap: float, expected: bool) -> None:
    """Nearer than a millionth of the radius is touching; walls that overlap are of no interest."""
    assert is_apart(Scene([disc(0), disc(1 + gap), FLOOR, FLOOR])) is expected


@pytest.mark.parametrize("seed", range(8))
def test_bodies_that_fall_are_counted_as_if_all_had_been_looked_at(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Discs and turned boxes in columns, with gaps about as wide as the skin; and a floor."""
    rng = np.random.default_rng(seed)
    shapes = Circle(0.5), Polygon.box(1, 1)
    gaps = SKIN * rng.uniform(-1, 4, size=(6, 5)).cumsum(1)
    bodies = [
        Body(shapes[(row + column) % 2], mass=1.0, position=(2.0 * column, 0.5 + row + gap),
             angle=rng.uniform(0, 1e-3))
        for column, some in enumerate(gaps) for row, gap in enumerate(some)
    ]  # fmt: skip
    scene = Scene([Body(Segment((-9, 0), (20, 0))), *bodies], gravity=(0, -10))
    found = choice.falling(scene)
    monkeypatch.setattr(choice, "_with_neighbours", lambda scene: scene)
    assert 0 < found == choice.falling(scene) < len(bodies)


def test_few_bodies_are_for_the_direct_solver() -> None:
    """Static ones do not count, and no more than so many."""
    few, many = blocks(MOST_DRIFTING), blocks(MOST_DRIFTING + 1)
    assert names(Scene([*few.bodies, *[FLOOR] * 9])) == ["direct", "substep", "sequential"]
    assert names(many) == ["substep", "sequential"]


@pytest.mark.parametrize(
    ("count", "expected"), [(MOST_FOR_DIRECT, "direct"), (MOST_FOR_DIRECT + 1, "substep")]
)
def test_walls_that_move_may_press_bodies_together(count: int, expected: str) -> None:
    """Then no more of them are for the direct solver than where gravity does."""
    wall = Body(Segment((-9, -9), (-9, 9)), velocity=(1, 0))
    assert names(Scene([*blocks(count).bodies, wall]))[0] == expected


@pytest.mark.parametrize(
    ("standing", "falls", "expected"),
    [
        (0, MOST_FALLING, "direct"),
        (MOST_FOR_DIRECT - MOST_FALLING, MOST_FALLING, "direct"),
        (1, MOST_FALLING + 1, "substep"),
        (MOST_FOR_DIRECT, 1, "substep"),
        (MOST_STANDING, 0, "direct"),
        (MOST_STANDING + 1, 0, "substep"),
    ],
)
def test_direct_solver_is_for_few_that_fall_or_some_more_that_stand(
    standing: int, falls: int, expected: str
) -> None:
    """Those that fall cost most: each of their impacts is an impact of all that touch."""
    box, floor = Polygon.box(1, 1), Body(Segment((-500, 0), (500, 0)))
    places = [(2.0 * n, 0.5) for n in range(standing)] + [(2.0 * n, 5.0) for n in range(falls)]
    boxes = [Body(box, mass=1.0, position=place) for place in places]
    assert names(Scene([floor, *boxes], gravity=(0, -10)))[0] == expected


# What the user asks for


@pytest.mark.parametrize(
    ("asked", "expected"),
    [
        ({"impact_rules": {"impacts": "sequential"}}, ["direct"]),
        ({"iterations": 5}, ["sequential"]),
        ({"substeps": 2}, ["sequential"]),
        ({"impact_rules": {"impacts": "sequential"}, "iterations": 5}, ["direct"]),
        (
            {"iterations": None, "substeps": None, "impact_rules": {}},
            ["direct", "substep", "sequential"],
        ),
    ],
)
def test_setting_that_only_one_solver_has_decides(
    asked: dict[str, Any], expected: list[str]
) -> None:
    """Before what the scene is."""
    assert names(blocks(2), asked) == expected


@pytest.mark.parametrize(
    ("effects", "expected"),
    [
        ({"sleeping": True}, "direct"),
        ({"continuous": True}, "direct"),
        ({"friction": False}, "exact"),
        ({"damping": False}, "exact"),
        ({"friction": True}, "exact"),
    ],
)
def test_effect_that_a_solver_lacks_or_cannot_do_without_rules_it_out(
    effects: dict[str, bool], expected: str
) -> None:
    """Two discs, which would be for the exact one; and they run."""
    scene = Scene([disc(0), disc(3, velocity=(-4, 0))])
    assert names(scene, effects=effects)[0] == expected
    assert simulate(scene, 1.0, effects=effects).plan.solver == expected


def test_direct_solver_is_passed_over_where_friction_is_left_out() -> None:
    """It cannot do without; two smooth blocks can."""
    assert names(blocks(2), effects={"friction": False}) == ["substep", "sequential"]
    assert simulate(blocks(2), 0.1, effects={"friction": False}).plan.solver == "substep"
    with pytest.raises(ValueError, match="'direct' cannot do without"):
        simulate(two_that_meet(), 1.0, solver="direct", effects={"friction": False})


def two_that_meet() -> Scene:
    """Return two smooth blocks, one on its way to the other."""
    first, second = blocks(2).bodies
    return Scene([replace(first, velocity=(2.0, 0.0)), second])


def test_compiled_code_rules_the_direct_solver_out() -> None:
    """It works on arrays of its own."""
    assert names(blocks(2), compiled=True) == ["substep", "sequential"]


def test_what_the_solver_with_sub_steps_cannot_do_without_leaves_sweeps() -> None:
    """Each of its sub-steps begins with the impulses of the one before."""
    asked = {"warm_starting": False}
    assert names(blocks(MOST_DRIFTING + 1), effects=asked) == ["sequential"]


def test_last_choice_suits_every_scene() -> None:
    """Whatever is asked for: the sequential solver has every effect."""
    for effects in ({}, {"sleeping": True}, {"manifolds": True, "continuous": True}):
        assert names(blocks(2), effects=effects)[-1] == "sequential"


# Through the door


@pytest.mark.parametrize(
    ("scene", "solver"),
    [
        (Scene([disc(0), disc(3)]), "exact"),
        (blocks(3), "direct"),
        (blocks(MOST_DRIFTING + 1), "substep"),
    ],
    ids=["exact", "direct", "substep"],
)
def test_simulate_says_which_solver_it_has_chosen_and_why(scene: Scene, solver: str) -> None:
    """The first of the list, with its reason."""
    plan = simulate(scene, 0.1).plan
    assert (plan.solver, plan.reason) == choices(scene)[0]
    assert plan.solver == solver


def test_simulate_with_the_solver_that_is_chosen_gives_the_same_run() -> None:
    """Asked for by name, it makes the same states."""
    scene = blocks(3, gravity=(0, -10))
    auto, named = simulate(scene, 0.5), simulate(scene, 0.5, solver="direct")
    assert auto.positions.tobytes() == named.positions.tobytes()
    assert named.plan.reason == "asked for"


def test_simulate_goes_on_to_the_next_solver_when_the_exact_one_finds_no_end(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The plan says that it has; asked for by name, the exact solver's error stands."""

    def without_end(*_: Any) -> None:
        raise RuntimeError("no end")

    monkeypatch.setattr(exact, "record_exact", without_end)
    scene = Scene([disc(0), disc(3, velocity=(-4, 0))])
    plan = simulate(scene, 1.0).plan
    assert plan.solver == "direct"
    assert plan.reason.endswith("; the exact solver finds no end, or no order, of the collisions")
    with pytest.raises(RuntimeError, match="no end"):
        simulate(scene, 1.0, solver="exact")


@pytest.mark.filterwarnings("ignore:.*steps there were more than 64 impacts:RuntimeWarning")
def test_disc_between_walls_that_come_together_is_stepped() -> None:
    """It bounces more and more often: before they meet there are some 1e8 collisions."""
    walls = [
        Body(Circle(1), position=(3 * side, 0), velocity=(-side, 0), material=ELASTIC)
        for side in (-1, 1)
    ]
    scene = Scene([*walls, disc(0.1, velocity=(1, 0))])
    assert simulate(scene, 2.0).plan.solver == "direct"
