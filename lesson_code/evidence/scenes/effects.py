"""For each effect, a scene that needs it and one that does not, to measure what omitting it saves.

The two scenes of a pair differ as little as possible: in one coefficient, one force, one wall. So
they also show the cost of both in another engine, which has one program for all scenes.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, TypeAlias

from lesson_code.engine.core.callbacks import Callbacks
from lesson_code.engine.core.constants import QUIET_TIME
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.evidence.scenes.discs import CUSHIONS, rack_break
from lesson_code.evidence.scenes.events import ELASTIC, WALLS
from lesson_code.evidence.scenes.gas import ENERGY, MASS, gas_of
from lesson_code.evidence.scenes.rigid_bodies import GRAVITY, HALF_LENGTH
from lesson_code.evidence.scenes.speed import (
    COVERED,
    DT,
    FRICTION,
    THICK,
    pyramid,
    settled_discs,
)
from lesson_code.geometry.shapes import Circle, Polygon

MANY, FEW, CROWD = 100, 16, 400
"""Discs: in most scenes, below the limit for a grid, and far above it."""

ROWS = 8
"""Of a pyramid."""

STACKS, HIGH = 20, 5
"""Stacks that stand apart, and the boxes of each."""

BALLS, BALL_RESTITUTION = 5, 0.95
"""On the billiard table."""

NEARLY_STRAIGHT = 20
"""Times the width of the gas: the radius of circles that serve as its walls."""

FAINT, RATE = 1e-3, 1e-4
"""m/s^2 of gravity and 1/s of damping: so little that a gas stays the gas it is."""

BOUNCE = 0.75**2
"""Restitution of a pile; its root is exact, so that pymunk's product can be the same."""

LONG = 1e5
"""s: the duration given to the plan where it matters; no run is as long."""

WARM_UP, STEPS_TO_SLEEP = 60, round(4 * QUIET_TIME / DT)
"""Steps before a measurement; a stack comes to rest, and has then to be quiet for QUIET_TIME."""

Tells: TypeAlias = Callable[[Any], None]
"""Sets in pymunk's space what a scene needs there."""


@dataclass(frozen=True)
class EffectPair:
    """A scene that needs an effect and one that does not.

    Attributes
    ----------
    effect : str
        Its name.
    needs, spared : Scene
        The two scenes.
    difference : str
        The difference in words; the scene that needs the effect comes first.
    warm_up : int
        Steps before the measurement.
    duration : float
        s, as given to the engine.
    along : mapping
        Effects that are forced on, or left out, in all runs of the pair.
    in_pymunk : bool
        Whether the pair is one for pymunk too.
    tells_pymunk : callable, optional
        Sets in pymunk's space, for the scene that needs the effect, what a scene cannot express.
    """

    effect: str
    needs: Scene
    spared: Scene
    difference: str
    warm_up: int = WARM_UP
    duration: float = math.inf
    along: Mapping[str, bool] = field(default_factory=dict)
    in_pymunk: bool = True
    tells_pymunk: Tells | None = None


def gases() -> dict[str, Scene]:
    """Return gases without friction, that need few effects, by what they are.

    Between walls with corners the engine has to consider outlines.
    """
    return {"discs in a box of circles": between_circles(), "discs in a box": gas()}


def pairs() -> list[EffectPair]:
    """Return a pair of scenes for each effect, in the order of the stages."""
    calm, rough, smooth, tower = gas(), pile(), pile(friction=0.0), pyramid(ROWS).scene
    lone: dict[str, Any] = {"spared": abreast(meet=False), "duration": LONG}
    met: dict[str, Any] = {**lone, "along": {"collisions": True}, "in_pymunk": False}
    pair = EffectPair
    return [
        pair("collisions", abreast(meet=True), difference="discs meet | pass by", **lone),
        pair("broad_phase", gas(CROWD), gas(FEW), f"{CROWD} discs | {FEW}", in_pymunk=False),
        pair("outlines", calm, between_circles(), "straight walls | walls of circles"),
        pair("manifolds", with_boxes(), calm, "boxes and discs | discs"),
        pair("internal_edges", on_two_slabs(tower), tower, "a floor of two pieces | of one"),
        pair("continuous", gas(faster=2), calm, "a gas twice as fast | a gas", in_pymunk=False),
        pair("restitution", pile(BOUNCE), rough, f"a pile, e = {BOUNCE:.2f} | e = 0"),
        pair("friction", rough, smooth, f"a pile, mu = {FRICTION:.2f} | mu = 0"),
        pair("rotation", spinning(smooth), smooth, "smooth discs, one spins | none"),
        pair("gravity", Scene(calm.bodies, (0, -FAINT)), calm, f"g = {FAINT} m/s^2 | g = 0"),
        pair("damping", Scene(calm.bodies, damping=RATE), calm, f"a rate of {RATE} /s | of 0"),
        pair("warm_starting", rough, difference="a pile | discs that pass by", **met),
        pair("position_correction", rough, difference="a pile | discs that pass by", **met),
        EffectPair(
            *("sleeping", stacks(), calm, "stacks at rest | a gas"),
            warm_up=STEPS_TO_SLEEP,
            duration=LONG,
            along={"impulse_record": False},  # else what sleeps is written down in every step
            tells_pymunk=_let_sleep,
        ),
        pair("callbacks", heard(calm), calm, "a gas that is heard | is not", tells_pymunk=_hear),
        pair("impulse_record", rough, rough, "a pile that is read | is not", in_pymunk=False),
    ]


def gas(count: int = MANY, *, faster: float = 1.0) -> Scene:
    """Return elastic discs without friction in a box of four segments, perhaps faster."""
    return _changed(gas_of(count, COVERED, seed=1), lambda body: _faster(body, faster))


def heard(scene: Scene) -> Scene:
    """Return a scene with a callback for every contact that does nothing."""
    return Scene(scene.bodies, scene.gravity, scene.damping, Callbacks(post_solve=_ignore))


def pile(restitution: float = 0.0, friction: float = FRICTION) -> Scene:
    """Return discs at rest in an open box, which may bounce, or be smooth."""
    surface = Material(restitution, friction)
    return _changed(settled_discs(MANY).scene, lambda body: replace(body, material=surface))


def spinning(scene: Scene) -> Scene:
    """Return a scene whose last body spins."""
    *bodies, last = scene.bodies
    return Scene([*bodies, replace(last, angular_velocity=1.0)], scene.gravity)


def between_circles() -> Scene:
    """Return the gas between four circles so large that they are nearly straight: no corners."""
    scene = gas()
    length = max(y for _, y in scene.bodies[1].shape.outline)  # the wall at the top
    radius, middle = NEARLY_STRAIGHT * length, length / 2
    near, far = -radius, length + radius
    places = [(middle, near), (middle, far), (near, middle), (far, middle)]
    walls = [Body(Circle(radius), position=place, material=ELASTIC) for place in places]
    return Scene([*walls, *scene.bodies[WALLS:]])


def with_boxes() -> Scene:
    """Return the gas with every second disc replaced by a box."""
    box, scene = Polygon.box(0.8, 0.8), gas()
    boxed = [
        replace(body, shape=box, inertia=box.inertia_per_mass) if n % 2 else body
        for n, body in enumerate(scene.bodies[WALLS:])
    ]
    return Scene([*scene.bodies[:WALLS], *boxed])


def abreast(*, meet: bool) -> Scene:
    """Return discs in a row that fly side by side, or at each other between two that stand."""
    shape, speed = Circle(0.5), math.sqrt(2 * ENERGY / MASS)
    discs = [
        Body(
            shape,
            mass=MASS,
            position=(1.6 * n, 0),
            velocity=(speed * (-1) ** n, 0) if meet else (0, speed),
            material=ELASTIC,
        )
        for n in range(MANY)
    ]
    ends = [Body(shape, position=(1.6 * n, 0), material=ELASTIC) for n in (-1, MANY)]
    return Scene([*ends, *discs])


def on_two_slabs(scene: Scene) -> Scene:
    """Return a scene whose ground, body 0, a slab about x = 0, is cut in two there."""
    ground, *bodies = scene.bodies
    half, (_, y) = Polygon.box(HALF_LENGTH, THICK), ground.position
    halves = [
        replace(ground, shape=half, position=(x, y)) for x in (-HALF_LENGTH / 2, HALF_LENGTH / 2)
    ]
    return Scene([*halves, *bodies], scene.gravity)


def stacks() -> Scene:
    """Return stacks of boxes that stand apart on a slab."""
    surface, box, apart = Material(0.0, FRICTION), Polygon.box(1, 1), 3
    length = float(apart * STACKS)
    slab = Polygon.box(length, THICK)
    places = [(apart * (n + 0.5), k + 0.5) for n in range(STACKS) for k in range(HIGH)]
    return Scene(
        [
            Body(slab, position=(length / 2, -THICK / 2), material=surface),
            *(Body(box, mass=1.0, position=place, material=surface) for place in places),
        ],
        gravity=(0, -GRAVITY),
    )


def billiards() -> Scene:
    """Return a cue ball that comes at four others on a table with cushions.

    >>> sum(not body.is_static for body in billiards().bodies)
    5
    """
    return Scene(rack_break(BALL_RESTITUTION).bodies[: CUSHIONS + BALLS])


def _changed(scene: Scene, change: Callable[[Body], Body]) -> Scene:
    """Return a scene with every body changed."""
    return Scene(map(change, scene.bodies), scene.gravity, scene.damping, scene.callbacks)


def _faster(body: Body, times: float) -> Body:
    """Return a body whose velocity is multiplied."""
    vx, vy = body.velocity
    return replace(body, velocity=(times * vx, times * vy))


def _ignore(_touch: Any) -> None:
    """Receive a contact, and do nothing."""


def _let_sleep(space: Any) -> None:
    """Make pymunk put bodies to sleep that have been quiet for as long as in our engine."""
    space.sleep_time_threshold = QUIET_TIME


def _hear(space: Any) -> None:
    """Make pymunk report every contact."""
    space.on_collision(None, None, post_solve=lambda *_: None)
