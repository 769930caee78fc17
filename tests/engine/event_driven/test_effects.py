"""What a scene does not call for is not in the exact solver's program, and nobody can tell."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import Phase, example, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, Scene, simulate
from lesson_code.engine.compiled.arrays import LINE, as_arrays
from lesson_code.engine.core.mixing import mixing_rule
from lesson_code.engine.event_driven import (
    ExactSolver,
    collisions,
    event_prediction,
    loop,
    solver,
    support,
)
from lesson_code.evidence.scenes.events import ball_in_a_box, box
from lesson_code.evidence.scenes.gas import gas_of

FORCED = dict.fromkeys(
    ("collisions", "outlines", "restitution", "friction", "rotation", "gravity"), True
)
"""Every effect that the solver may leave out, but the grid and the record."""

STAGES: dict[str, list[tuple[Any, str]]] = {
    "gravity": [
        (event_prediction, "circle_outline_impact_time"),
        (event_prediction, "circle_impact_time"),
        (event_prediction, "line_impact_time"),
        (event_prediction, "predict_end_of_rest"),
        (collisions, "bounce_or_rest"),
        (collisions, "meet_in_pile"),
        (loop, "go_on_along_face"),
        (loop, "count_event_in_piles"),
    ],
    "friction": [
        (collisions, "rubbing_impulse"),
        (collisions, "rub"),
        (event_prediction, "grip_time"),
        (support, "pull_with_friction"),
    ],
    "outlines": [(event_prediction, "outline_time")],
    "collisions": [(loop, "begin"), (loop, "next_event")],
    "impulse_record": [(solver, "note_impulse")],
}
"""The functions that each effect alone needs, where they are called from."""


def scene_with(
    seed: int,
    *,
    gravity: bool = False,
    friction: bool = False,
    restitution: bool = True,
    turns: bool = True,
    walls: bool = True,
) -> Scene:
    """Return up to 30 discs among obstacles, drawn at random, with some effects and not others."""
    rng = np.random.default_rng(seed)
    material = Material(rng.uniform(0.3, 1.0) if restitution else 0.0, 0.3 if friction else 0.0)
    discs = [
        Body(
            Circle(rng.uniform(0.1, 0.3)),
            mass=rng.uniform(0.5, 2),
            inertia=None if turns else math.inf,
            position=(k % 6 + 0.5 + rng.uniform(-0.1, 0.1), k // 6 + 0.5),
            velocity=rng.uniform(-3, 3, 2),
            angular_velocity=rng.uniform(-3, 3) if turns else 0.0,
            material=material,
        )
        for k in range(int(rng.integers(5, 31)))
    ]
    posts = [Body(Circle(0.1), position=(k, k), material=material) for k in range(1, 5)]
    post = Body(Circle(0.2), position=(-1, 2), velocity=(1, 0.1), material=material)
    obstacles = [*box(6.0, 6.0, material), *posts, post] if walls else [*posts, post]
    return Scene([*obstacles, *discs], gravity=(0.5, -9.0) if gravity else (0, 0))


def bits_of(scene: Scene, effects: dict[str, bool] | None = None) -> list[bytes]:
    """Return the bits of all states and impulses of half a second; zero has one sign here."""
    run = simulate(scene, 0.5, solver="exact", effects=effects)
    hits = run.contacts
    states = run.times, run.positions, run.angles, run.velocities, run.angular_velocities
    impulses = hits.time, hits.body_b, hits.point, hits.normal_impulse, hits.tangent_impulse
    return [(numbers + 0.0).tobytes() for numbers in (*states, *impulses)]


# Nobody can tell


@settings(max_examples=share(40), phases=[Phase.explicit, Phase.generate])
@given(
    seed=st.integers(0, 10**9),
    gravity=st.booleans(),
    friction=st.booleans(),
    restitution=st.booleans(),
    turns=st.booleans(),
    walls=st.booleans(),
)
@example(
    seed=10001, gravity=False, friction=False, restitution=True, turns=True, walls=False
)  # nobody meets anybody
def test_random_scene_runs_to_the_same_bits_with_every_effect_forced_on(
    seed: int, **called_for: bool
) -> None:
    """Whatever it calls for and whatever it does not."""
    scene = scene_with(seed, **called_for)
    assert bits_of(scene) == bits_of(scene, FORCED)


@settings(max_examples=share(20), phases=[Phase.explicit, Phase.generate])
@given(
    seed=st.integers(0, 10**9), gravity=st.booleans(), friction=st.booleans(), turns=st.booleans()
)
def test_random_scene_runs_to_the_same_bits_with_and_without_a_grid(
    seed: int, **called_for: bool
) -> None:
    """Hits are predicted from where discs began to move so: no border leaves a trace."""
    scene = scene_with(seed, **called_for)
    assert bits_of(scene, {"broad_phase": True}) == bits_of(scene, {"broad_phase": False})


def test_discs_that_never_meet_fly_to_the_same_bits_through_a_grid_or_with_no_program() -> None:
    """Forty fall side by side; with collisions forced on they cross some hundred borders."""
    discs = [Body(Circle(0.4), mass=1.0, position=(k, 0.1 * k)) for k in range(40)]
    scene = Scene(discs, gravity=(0.0, -9.81))
    times = np.linspace(0, 3, 50)
    free = simulate(scene, 3.0, solver="exact", sample=times)
    forced = simulate(scene, 3.0, solver="exact", sample=times, effects={"collisions": True})
    assert "collisions" in free.plan.left_out
    assert free.positions.tobytes() == forced.positions.tobytes()
    assert free.velocities.tobytes() == forced.velocities.tobytes()


# It is not in the program


@pytest.mark.one_in(3)
@pytest.mark.parametrize(
    ("effect", "scene"),
    [
        ("gravity", scene_with(1, friction=True)),
        ("friction", scene_with(2, gravity=True)),
        ("outlines", scene_with(3, walls=False)),
        ("collisions", Scene([Body(Circle(0.3), mass=1.0, velocity=(1, 0))])),
        ("impulse_record", gas_of(30, 0.3, seed=1)),
    ],
)
def test_stage_of_an_effect_that_is_left_out_is_never_called(
    effect: str, scene: Scene, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nor is it in the source."""
    asked = {"impulse_record": False} if effect == "impulse_record" else None
    called: list[str] = []
    for module, name in STAGES[effect]:
        monkeypatch.setattr(module, name, lambda *_, name=name: called.append(name))
    running = ExactSolver(scene, combine=mixing_rule("workbook"), effects=asked)
    running.advance(1.0)
    plan = running.plan("a test")
    assert effect in plan.left_out
    assert called == []
    monkeypatch.undo()
    source = plan.source()
    assert all(f"def {name}(" not in source for _, name in STAGES[effect])


@pytest.mark.parametrize("effect", STAGES)
def test_stages_of_an_effect_are_in_the_program_of_a_scene_that_calls_for_it(effect: str) -> None:
    """So that their names here are right."""
    scene = scene_with(4, gravity=True, friction=True)
    source = ExactSolver(scene, combine=mixing_rule("workbook")).plan("a test").source()
    assert all(f"def {name}(" in source for _, name in STAGES[effect])


def test_fields_of_a_disc_in_a_frictionless_gas_fill_two_lines_of_a_processor() -> None:
    """Those of gravity, friction, turning and resting are gone; neighbours read the first line."""
    gas = ExactSolver(gas_of(30, 0.3, seed=1), combine=mixing_rule("workbook"))
    discs: Any = as_arrays(gas.tables, gas.plan("a test").source()).discs
    fields = discs.dtype.fields
    unused = {"ax", "ay", "alpha", "angle", "w", "inv_i", "friction", "support", "face", "held"}
    assert not unused & set(fields)
    assert discs.dtype.itemsize == 2 * LINE
    read = {"time", "x", "y", "vx", "vy", "radius", "cell_x", "cell_y", "next_in_slot", "changes"}
    assert all(fields[name][1] < LINE for name in read)


# Bad input


@pytest.mark.parametrize("effect", ["collisions", "outlines", "restitution", "gravity"])
def test_leaving_out_what_a_scene_needs_is_refused_by_name(effect: str) -> None:
    """With the reason."""
    scene = scene_with(4, gravity=True, friction=True)
    with pytest.raises(ValueError, match=rf"effects\['{effect}'\] must not be False: the scene"):
        simulate(scene, 1.0, solver="exact", effects={effect: False})


@pytest.mark.parametrize(
    "effect", ["internal_edges", "damping", "callbacks", "continuous", "sleeping"]
)
def test_forcing_on_what_the_exact_solver_lacks_is_refused(effect: str) -> None:
    """It would not be in the program."""
    with pytest.raises(ValueError, match=rf"effects\['{effect}'\] must not be True for 'exact'"):
        simulate(ball_in_a_box(), 1.0, solver="exact", effects={effect: True})


def test_run_without_collisions_goes_no_further_than_it_was_planned_for() -> None:
    """Beyond it the two discs meet."""
    discs = [
        Body(Circle(0.5), mass=1.0, velocity=(1, 0)),
        Body(Circle(0.5), mass=1.0, position=(9, 0)),
    ]
    running = ExactSolver(Scene(discs), combine=mixing_rule("workbook"), duration=2.0)
    running.advance(2.0)
    with pytest.raises(ValueError, match=r"until must be <= 2\.0 s: later bodies may meet"):
        running.advance(2.5)
