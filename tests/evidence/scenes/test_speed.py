"""The scenes in which speed is measured: their sizes, their start, and that they are fair."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable

import numpy as np
import pytest

from lesson_code import Circle, MixingRule, simulate
from lesson_code.engine.core.mixing import MIXING_RULES
from lesson_code.evidence.scenes import speed as speed_scenes
from lesson_code.evidence.scenes.speed import BUILDERS, FRICTION, SIZES, SpeedScene
from lesson_code.reference.pymunk_reference import PymunkStepper
from lesson_code.reference.scene_mapping import coefficients, own_values

ROUNDING = 1e-12
"""Places of up to 100 m, each with a rounding of 1e-14 m."""

LARGEST_TRIED = 2_000
"""Bodies: larger scenes are built in the same way."""

RESTING = (
    speed_scenes.settled_discs,
    speed_scenes.stack,
    speed_scenes.pyramid,
)

SMALL = [(kind, size) for kind, sizes in SIZES.items() for size in sizes if size <= LARGEST_TRIED]


@pytest.fixture(scope="module", params=SMALL, ids=lambda small: f"{small[0]}-{small[1]}")
def speed_scene(request: pytest.FixtureRequest) -> SpeedScene:
    """Return each scene that is not too large to be tried."""
    kind, size = request.param
    return BUILDERS[kind](size)


def free_bodies(speed_scene: SpeedScene) -> int:
    """Return how many bodies can move."""
    return sum(not body.is_static for body in speed_scene.scene.bodies)


@pytest.mark.parametrize(
    ("build", "size", "count"),
    [
        (speed_scenes.gas, 10, 10),
        (speed_scenes.gas, 1_000, 1_000),
        (speed_scenes.dense_gas, 1_000, 1_000),
        (speed_scenes.settled_discs, 1, 1),
        (speed_scenes.settled_discs, 10, 10),
        (speed_scenes.settled_discs, 1_000, 1_000),
        (speed_scenes.settled_discs, 1_001, 1_001),
        (speed_scenes.stack, 20, 20),
        (speed_scenes.pyramid, 20, 210),
        (speed_scenes.bin_of_shapes, 500, 500),
    ],
)
def test_scene_has_as_many_bodies_as_its_size_says(
    build: Callable[[int], SpeedScene], size: int, count: int
) -> None:
    """A pyramid's size is its rows, n (n + 1)/2 boxes; every other's is its bodies."""
    assert free_bodies(build(size)) == count


def test_bodies_overlap_by_less_than_the_slop_at_the_start(speed_scene: SpeedScene) -> None:
    """Nothing is pushed apart: what is measured is the scene, not its repair."""
    assert (
        simulate(speed_scene.scene, 0.0, solver="sequential").max_penetration[0] <= speed_scene.slop
    )


def test_engines_are_given_equal_coefficients_without_callbacks(speed_scene: SpeedScene) -> None:
    """Pymunk's product and Box2D's rule make of the given values what ours makes of the pair."""
    bodies = speed_scene.scene.bodies
    for engine in ("pymunk", "box2d"):
        assert own_values(bodies, MixingRule(), MIXING_RULES[engine]) is not None
    free = {body.material for body in bodies if not body.is_static}
    every = {body.material for body in bodies}
    pairs = {coefficients(MixingRule(), a, b) for a in free for b in every}
    assert len(pairs) == 1
    assert pairs <= {(1.0, 0.0), (0.0, FRICTION)}


@pytest.mark.parametrize(
    "build", [speed_scenes.gas, speed_scenes.dense_gas, speed_scenes.bin_of_shapes]
)
def test_drawn_scene_is_another_one_for_another_seed_only(
    build: Callable[..., SpeedScene],
) -> None:
    """The same seed draws the same scene, to the last bit."""
    assert build(100, seed=3).scene == build(100, seed=3).scene
    assert build(100, seed=3).scene != build(100, seed=4).scene


@pytest.mark.parametrize("build", RESTING)
def test_built_scene_is_the_same_each_time(build: Callable[[int], SpeedScene]) -> None:
    """Nothing is drawn in it."""
    assert build(20) == build(20)


@pytest.mark.parametrize("covered", [0.3, 0.6])
def test_gas_covers_its_share_of_the_box(covered: float) -> None:
    """1,000 discs of 1 m fill no square of rows, but the box is a square all the same."""
    build = speed_scenes.gas if covered == 0.3 else speed_scenes.dense_gas
    scene = build(1_000).scene
    length = max(y for _, y in scene.bodies[1].shape.outline)
    assert 1_000 * math.pi / 4 / length**2 == pytest.approx(covered, abs=ROUNDING)
    places = np.array([body.position for body in scene.bodies[4:]])
    assert 0.5 < places.min() < places.max() < length - 0.5


def test_settled_disc_lies_in_the_gap_between_two_below_it() -> None:
    """Each touches its six neighbours by half of the slop, and the walls by as much."""
    speed_scene = speed_scenes.settled_discs(400)
    _, floor, _, *discs = speed_scene.scene.bodies
    places = np.array([disc.position for disc in discs])
    apart = np.hypot(*(places[:, None] - places[None, :]).transpose(2, 0, 1))
    touching = (np.abs(apart - (1 - speed_scene.slop / 2)) < ROUNDING).sum(axis=1)
    assert Counter(touching.tolist()).most_common(1)[0][0] == 6
    assert (apart[~np.eye(400, dtype=bool)] > 1 - speed_scene.slop).all()
    assert places[:, 1].min() - floor.shape.outline[0][1] == pytest.approx(
        0.5 - speed_scene.slop / 2, abs=ROUNDING
    )


@pytest.mark.parametrize("build", [speed_scenes.settled_discs, speed_scenes.pyramid])
def test_built_scene_is_at_rest_after_its_warm_up(build: Callable[[int], SpeedScene]) -> None:
    """Nothing has fallen from its place by more than the slop for each body under it."""
    speed_scene = build(5)
    run = simulate(
        speed_scene.scene, speed_scene.warm_up * speed_scene.dt, sample="end", solver="sequential"
    )
    moved = run.positions[-1] - run.positions[0]
    assert np.abs(moved).max() <= 5 * speed_scene.slop
    assert np.abs(run.velocities[-1]).max() < 0.05


def test_stack_still_stands_after_its_warm_up() -> None:
    """None of 20 boxes has moved aside; they have only sunk into each other."""
    speed_scene = speed_scenes.stack(20)
    run = simulate(
        speed_scene.scene, speed_scene.warm_up * speed_scene.dt, sample="end", solver="sequential"
    )
    moved = run.positions[-1] - run.positions[0]
    assert np.abs(moved[:, 0]).max() <= ROUNDING
    assert run.max_penetration[-1] < 0.02


def test_bin_holds_every_kind_of_shape_and_lets_none_out() -> None:
    """Circles, triangles, boxes and pentagons in equal numbers, inside of the walls to the end."""
    speed_scene = speed_scenes.bin_of_shapes(100)
    scene = speed_scene.scene
    kinds = Counter(len(body.shape.outline) for body in scene.bodies if not body.is_static)
    assert kinds == {0: 25, 3: 25, 4: 25, 5: 25}
    engine = PymunkStepper(
        scene,
        dt=speed_scene.dt,
        iterations=10,
        substeps=1,
        combine=MixingRule(),
        keep_impulses=False,
        slop=speed_scene.slop,
    )
    engine.advance(speed_scene.warm_up)
    states = np.array(engine.states())[3:]
    right = scene.bodies[2].position[0] - speed_scenes.THICK / 2
    assert states[:, 0].min() > 0.3
    assert states[:, 0].max() < right - 0.3
    assert states[:, 1].min() > 0.3
    assert np.abs(states[:, 3:5]).max() < 0.2


def test_slop_is_that_of_the_smallest_body(speed_scene: SpeedScene) -> None:
    """A two hundredth of its width: what our solver leaves alone, and pymunk is to be given."""
    widths = [
        2 * body.shape.radius if isinstance(body.shape, Circle) else body.shape.min_width
        for body in speed_scene.scene.bodies
        if not body.is_static
    ]
    assert speed_scene.slop == pytest.approx(min(widths) / 200)
    assert 0.004 < speed_scene.slop <= 0.005
