"""The plan of a live world: what the scene calls for, and what runs."""

from __future__ import annotations

import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, Segment
from lesson_code.engine import live_world
from lesson_code.engine.effects.choice import choose_effects
from lesson_code.engine.effects.question import Question
from lesson_code.engine.live_world import LiveWorld

ALWAYS = {
    *(
        "collisions",
        "outlines",
        "manifolds",
        "internal_edges",
        "continuous",
        "restitution",
        "friction",
    ),
    *("rotation", "gravity", "damping", "warm_starting", "position_correction", "impulse_record"),
}
"""What every live world reckons with."""

ROUGH = Material(restitution=0.4, friction=0.3)

SCENES = {
    "nothing": Scene([]),
    "one ball": Scene([Body(Circle(1), mass=1.0)]),
    "gas": Scene([Body(Circle(0.1), position=(k, 0), mass=1.0) for k in range(3)]),
    "floor": Scene(
        [
            Body(Segment((-5, 0), (5, 0)), material=ROUGH),
            Body(Polygon.box(1, 1), position=(0, 2), mass=1.0, material=ROUGH),
        ],
        gravity=(0, -9.81),
        damping=0.1,
    ),
    "many": Scene([Body(Circle(0.1), position=(k, 0), mass=1.0) for k in range(90)]),
}


def world_of(scene: Scene) -> LiveWorld:
    """Return a live world of a scene."""
    return LiveWorld(scene.bodies, gravity=scene.gravity, damping=scene.damping)


@pytest.mark.parametrize("name", SCENES)
def test_plan_tells_what_the_scene_calls_for(name: str) -> None:
    """Reason for reason as the engine's rules have it, and no more is left out than may be."""
    scene = SCENES[name]
    plan = world_of(scene).plan()
    expected = choose_effects(Question(scene, plan.solver))
    told = [(c.name, c.called_for, c.reason) for c in plan.effects]
    assert told == [(c.name, c.called_for, c.reason) for c in expected]


@pytest.mark.parametrize("name", SCENES)
def test_plan_tells_what_runs(name: str) -> None:
    """Everything but sleep and callbacks; a grid where there are many bodies."""
    world = world_of(SCENES[name])
    assert set(world.plan().used) == ALWAYS | ({"broad_phase"} if name == "many" else set())


def test_plan_in_machine_code_tells_of_the_grid() -> None:
    """Compiled, a world has the grid."""
    world = world_of(SCENES["many"])
    world.compile()
    assert world.plan().effect("broad_phase").used
    assert world.plan().code == "compiled"


def test_plan_tells_why_a_world_is_in_plain_python(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few bodies are; many at first, and where nothing can compile them."""
    assert world_of(SCENES["many"]).plan().code_reason == "machine code is still to be made"
    assert world_of(SCENES["gas"]).plan().code == "plain Python"
    crowd = [Body(Circle(0.1), position=(k, 0), mass=1.0) for k in range(120)]
    monkeypatch.setattr(live_world, "why_no_compiler", lambda: "Numba is not installed")
    plan = LiveWorld(crowd).plan()
    assert (plan.code, plan.code_reason) == ("plain Python", "Numba is not installed")


def test_plan_is_of_the_bodies_as_they_are_now() -> None:
    """A ball at rest that is thrown hard can move by more than half of its width in a step."""
    world = world_of(SCENES["gas"])
    assert world.plan().effect("continuous").verdict == "forced"
    world.throw(0, (50.0, 0.0))
    assert world.plan().effect("continuous").verdict == "used"


def test_plan_tells_which_solver_moves_the_world_and_why() -> None:
    """Few bodies: direct. Many that fly and bounce: exact. Many that come to rest: sub-steps."""
    few = world_of(SCENES["floor"]).plan()
    assert (few.solver, few.reason) == ("direct", "few bodies: all contacts are solved at once")
    bouncy = [
        Body(Circle(0.1), position=(k, 0), mass=1.0, material=Material(1.0)) for k in range(90)
    ]
    assert LiveWorld(bouncy).plan().solver == "exact"
    assert LiveWorld(bouncy, gravity=(0, -9.81)).plan().solver == "exact"
    assert LiveWorld(bouncy, gravity=(0, -9.81), damping=0.1).plan().solver == "substep"
    assert LiveWorld(bouncy[:64], damping=0.1).plan().solver == "direct"
    assert LiveWorld(bouncy[:3], iterations=4).plan().reason == "sweeps are asked for"
