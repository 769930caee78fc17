"""A whole scene, stepped by Box2D with every convention of ours mapped to its own.

==========================  ==============================================================
ours                        Box2D's
==========================  ==============================================================
the pair's coefficients     see :mod:`lesson_code.reference.box2d_reference.surfaces`
static body                 static, or kinematic when it has a velocity
damping rate c, 1/s         ``linear_damping`` = ``angular_damping`` = (exp(c h) - 1)/h, of
                            which a sub-step of h leaves the share 1/(1 + exp(c h) - 1)
mass, moment of inertia     given, not derived; an infinite moment is 0, Box2D's word for it
sub-steps                   its own: contacts are found once a step. In each it makes one
                            sweep before the bodies move, and one after
angle, any number           a direction, which is followed step by step
==========================  ==============================================================

Sleeping is off; warm starting and continuous detection against what nothing can push are on. Every
approach bounces (Box2D's threshold, 1 m/s unless it is set, is 0), and no speed is capped but a
spin, at an eighth of a turn a step. What cannot be changed, since it is compiled into Box2D: single
precision; a slop of 0.005 m; contacts that begin 0.02 m before bodies touch; a turn by atan(w h)
where w h is right, in a sub-step of h.

The binding tells no impulses of contacts: a run has none, and what is measured on them has no
result. Callbacks of a scene are not called: they belong to our engine.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.impulse_table import EVENT_NUMBERS
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.recording import Stepper, moved_on
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.reference.box2d_reference.library import box2d
from lesson_code.reference.box2d_reference.shapes import add_shape, refuse_what_box2d_cannot_do
from lesson_code.reference.box2d_reference.surfaces import Surface, surfaces
from lesson_code.reference.scene_mapping import refuse_heap

SUBSTEPS = 4
"""In a step: the advice of Box2D's manual."""

STRONGEST_DAMPING = 80.0
"""Of a sub-step: exp(-80) is as good as nothing, and exp(80) still fits in single precision."""

FASTEST = 1e9
"""m/s: Box2D caps speeds at 400 m/s unless it is told another number; its square must be finite."""


class Box2DStepper(Stepper):
    """A scene that Box2D advances by steps of `dt`, each in `substeps` parts.

    Parameters
    ----------
    scene : Scene
        What is simulated.
    dt : float
        s, > 0.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    substeps : int
        Box2D's own, in a step.
    follow_turns : bool
        Whether to look after each step how far each body has turned. Without it, which is faster,
        an angle is right but for whole turns.

    Raises
    ------
    ModuleNotFoundError
        Box2D is not installed.
    RuntimeError
        As many of Box2D's worlds are in use as it can hold: 128.
    ValueError
        The bodies are heaped into one another, or Box2D cannot hold one of them.

    Attributes
    ----------
    world : pyb2d3.World
        It must live as long as the bodies are asked.
    bodies : pyb2d3.Bodies
        The scene's, in its order.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        dt: float,
        combine: MixingRule,
        substeps: int = SUBSTEPS,
        follow_turns: bool = True,
    ) -> None:
        library = box2d()
        refuse_heap(scene)
        refuse_what_box2d_cannot_do(library, scene)
        all_surfaces = surfaces(scene.bodies, combine)
        self.dt = dt
        self._substeps = substeps
        self._follow_turns = follow_turns
        self.world = _world(library, scene)
        part = dt / substeps
        damping = math.expm1(min(scene.damping * part, STRONGEST_DAMPING)) / part
        self.bodies = library.Bodies()
        for body, own in zip(scene.bodies, all_surfaces, strict=True):
            self.bodies.append(_add(library, self.world, body, damping, own))
        self._angles = np.array([body.angle for body in scene.bodies], dtype=float)

    def advance(self, steps: int) -> None:
        """Advance by this many steps of dt."""
        for _ in range(steps):
            self.world.step(self.dt, self._substeps)
            if self._follow_turns:
                self._turn()

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        self._turn()
        return np.column_stack(
            (
                self.bodies.get_positions(),
                self._angles,
                self.bodies.get_linear_velocities(),
                self.bodies.get_angular_velocities(),
            )
        ).astype(float)

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return the states moved on at their velocities, shape (N, 6)."""
        return moved_on(self.states(), duration)

    def events(self) -> NDArray[np.float64]:
        """Return no impulses, shape (0, 10): the binding tells none."""
        return np.zeros((0, EVENT_NUMBERS))

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run, with the reason for the choice of this engine."""
        return Plan("box2d", reason, "C", "Box2D's own")

    def _turn(self) -> None:
        """Turn each angle on, the shorter way, to the direction that Box2D has by now."""
        cosines, sines = self.bodies.get_rotations().T
        turns = np.arctan2(sines, cosines) - self._angles
        self._angles += turns - 2 * np.pi * np.round(turns / (2 * np.pi))


def _world(library: Any, scene: Scene) -> Any:
    """Return an empty world with a scene's gravity and our settings."""
    world = library.World(
        gravity=scene.gravity, restitution_threshold=0.0, maximum_linear_speed=FASTEST
    )
    if not world.is_valid():
        raise RuntimeError("Box2D holds at most 128 worlds at once: let some steppers go")
    world.sleeping_enabled = False
    world.continuous_enabled = True
    return world


def _add(library: Any, world: Any, body: Body, damping: float, own: list[Surface]) -> Any:
    """Add a body to a world, with a shape for each surface, and return its number in Box2D."""
    made = world.create_body(
        type=_kind(library, body),
        position=body.position,
        rotation=library.make_rot(body.angle),
        linear_velocity=body.velocity,
        angular_velocity=body.angular_velocity,
        linear_damping=damping,
        angular_damping=damping,
    )
    for surface in own:
        add_shape(library, made, _definition(library, surface), body.shape)
    if body.mass is not None and body.inertia is not None:
        made.mass_data = _mass_data(library, body.mass, body.inertia)
    return made.id


def _definition(library: Any, surface: Surface) -> Any:
    """Return what Box2D is told of a shape besides its outline."""
    return library.shape_def(
        material=library.surface_material(
            restitution=surface.restitution, friction=surface.friction
        ),
        filter=library.make_filter(category_bits=surface.category, mask_bits=surface.mask),
        enable_contact_events=False,
    )


def _mass_data(library: Any, mass: float, inertia: float) -> Any:
    """Return a mass, kg, and a moment of inertia, kg m^2, as Box2D takes them."""
    data = library.MassData()
    data.mass, data.center = mass, (0.0, 0.0)
    data.rotational_inertia = 0.0 if math.isinf(inertia) else inertia
    return data


def _kind(library: Any, body: Body) -> Any:
    """Return Box2D's kind of body."""
    if not body.is_static:
        return library.BodyType.DYNAMIC
    moving = body.velocity != (0.0, 0.0) or body.angular_velocity != 0.0
    return library.BodyType.KINEMATIC if moving else library.BodyType.STATIC
