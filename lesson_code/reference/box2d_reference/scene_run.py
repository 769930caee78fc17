"""A whole scene, stepped by Box2D with every convention of ours mapped to its own.

==========================  ==============================================================
ours                        Box2D's
==========================  ==============================================================
the pair's coefficients     each body is given values that Box2D's own rule (the larger
                            restitution, the geometric mean of the frictions) turns into
                            the pair's; where there are none, set on each contact when it
                            begins
static body                 static, or kinematic when it has a velocity
damping rate c, 1/s         ``linearDamping`` = ``angularDamping`` = (1 - exp(-c h))/h, of
                            which a step of h leaves the share exp(-c h)
mass, moment of inertia     given, not derived; an infinite moment is 0, Box2D's word for it
iterations                  velocity iterations; those for positions are set apart
normal, from a to b         turned round where Box2D lists the bodies the other way
tangent, +90 degrees        Box2D's is -90 degrees: the impulse changes its sign
==========================  ==============================================================

Sleeping is off; warm starting and continuous detection are on. What cannot be changed, since it is
compiled into Box2D: single precision; a slop of 0.005 m; no bounce below an approach of 1 m/s; no
body moves more than 2 m in a step. Callbacks of a scene are not called: they belong to our engine.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.mixing import MIXING_RULES, MixingRule
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.recording import EVENT_NUMBERS, STATE_NUMBERS, Event, moved_on
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.geometry.manifold import collide
from lesson_code.reference.box2d_reference.fixtures import (
    fixture_shapes,
    refuse_what_box2d_cannot_do,
)
from lesson_code.reference.box2d_reference.library import box2d
from lesson_code.reference.scene_mapping import coefficients, own_values, refuse_heap


class Box2DStepper:
    """A scene that Box2D advances by steps of `dt`, each in `substeps` equal parts.

    Parameters
    ----------
    scene : Scene
        What is simulated.
    dt : float
        s, > 0.
    iterations : int
        Of Box2D's solver for velocities, in each sub-step.
    substeps : int
        Parts of a step.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    position_iterations : int
        Of Box2D's solver for overlaps, in each sub-step; 3 is its manual's advice.
    keep_impulses : bool
        Whether to write down what each pair receives, which costs a call for each pair and step.

    Raises
    ------
    ModuleNotFoundError
        Box2D is not installed.
    ValueError
        The bodies are heaped into one another, or Box2D cannot hold one of them.

    Attributes
    ----------
    corrects_coefficients : bool
        Whether each new contact is given its coefficients by a callback, which costs time.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        dt: float,
        iterations: int,
        substeps: int,
        combine: MixingRule,
        position_iterations: int = 3,
        keep_impulses: bool = True,
    ) -> None:
        library = box2d()
        refuse_heap(scene)
        refuse_what_box2d_cannot_do(scene)
        self.dt = dt
        self._part = dt / substeps
        self._substeps = substeps
        self._substeps_done = 0
        self._iterations = iterations, position_iterations
        self._combine = combine
        self._scene = scene
        self._events: list[Event] = []
        values = own_values(scene.bodies, combine, MIXING_RULES["box2d"])
        self.corrects_coefficients = values is None
        self.world = library.b2World(gravity=scene.gravity)
        self.world.SetAllowSleeping(False)  # the binding overlooks the constructor's doSleep
        self.world.warmStarting = self.world.continuousPhysics = True
        damping = -math.expm1(-scene.damping * self._part) / self._part
        given = values or [(0.0, 0.0)] * len(scene.bodies)
        self.bodies = [
            _add(library, self.world, number, body, damping, *given[number])
            for number, body in enumerate(scene.bodies)
        ]
        wanted = {"BeginContact": self._correct} if self.corrects_coefficients else {}
        self._listener = _listener(library, wanted, self._note if keep_impulses else None)
        self.world.contactListener = self._listener

    def advance(self, steps: int) -> None:
        """Advance by this many steps of dt."""
        for _ in range(steps * self._substeps):
            self._substeps_done += 1
            self.world.Step(self._part, *self._iterations)

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        rows = [
            (*body.position, body.angle, *body.linearVelocity, body.angularVelocity)
            for body in self.bodies
        ]
        return np.array(rows, dtype=float).reshape(-1, STATE_NUMBERS)

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return the states moved on at their velocities, shape (N, 6)."""
        return moved_on(self.states(), duration)

    def events(self) -> NDArray[np.float64]:
        """Return the impulses so far, shape (K, 10); points and depths as the step leaves them."""
        return np.array(self._events, dtype=float).reshape(-1, EVENT_NUMBERS)

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run, with the reason for the choice of this engine."""
        return Plan("box2d", reason, "C++", "Box2D's own")

    def _correct(self, contact: Any) -> None:
        """Set a new contact's coefficients; Box2D keeps them until it ends."""
        a, b = (self._scene.bodies[n].material for n in _numbers(contact))
        contact.restitution, contact.friction = coefficients(self._combine, a, b)

    def _note(self, contact: Any, impulse: Any) -> None:
        """Write down what a pair has received in this step, at the middle of its points."""
        count = contact.manifold.pointCount
        along, across = sum(impulse.normalImpulses[:count]), sum(impulse.tangentImpulses[:count])
        if along == 0.0 and across == 0.0:
            return
        first, second = _numbers(contact)
        manifold = contact.worldManifold
        normal, points = tuple(manifold.normal), manifold.points[:count]
        side = 1.0 if first < second else -1.0
        a, b = min(first, second), max(first, second)
        self._events.append(
            (
                *(self._substeps_done * self._part, a, b),
                *(sum(point[axis] for point in points) / count for axis in (0, 1)),
                *(side * normal[0], side * normal[1], along, -across, self._depth(a, b)),
            )
        )

    def _depth(self, a: int, b: int) -> float:
        """Return the current overlap of two bodies, m, by our definition."""
        poses = [(*self.bodies[n].position, self.bodies[n].angle) for n in (a, b)]
        shapes = [self._scene.bodies[n].shape for n in (a, b)]
        contact = collide(shapes[0], poses[0], shapes[1], poses[1])
        return 0.0 if contact is None else float(max(contact.penetrations))


def _listener(
    library: Any,
    methods: dict[str, Callable[..., None]],
    note: Callable[[Any, Any], None] | None,
) -> Any:
    """Return a listener with the wanted methods alone, or None: each costs a call for a contact."""
    if note is not None:
        methods = methods | {"PostSolve": note}
    if not methods:
        return None
    bound = {name: staticmethod(method) for name, method in methods.items()}
    return type("Listener", (library.b2ContactListener,), bound)()


def _numbers(contact: Any) -> tuple[int, int]:
    """Return the places in the scene of a contact's two bodies, in Box2D's order."""
    return contact.fixtureA.body.userData, contact.fixtureB.body.userData


def _add(
    library: Any,
    world: Any,
    number: int,
    body: Body,
    damping: float,
    restitution: float,
    friction: float,
) -> Any:
    """Add a body and its fixtures to a world."""
    made = world.CreateBody(
        type=_kind(library, body),
        position=body.position,
        angle=body.angle,
        linearVelocity=body.velocity,
        angularVelocity=body.angular_velocity,
        linearDamping=damping,
        angularDamping=damping,
        userData=number,
    )
    for shape in fixture_shapes(library, body.shape):
        made.CreateFixture(
            library.b2FixtureDef(shape=shape, restitution=restitution, friction=friction)
        )
    if body.mass is not None and body.inertia is not None:
        inertia = 0.0 if math.isinf(body.inertia) else body.inertia
        made.massData = library.b2MassData(mass=body.mass, center=(0.0, 0.0), I=inertia)
    return made


def _kind(library: Any, body: Body) -> int:
    """Return Box2D's kind of body."""
    if not body.is_static:
        return int(library.b2_dynamicBody)
    moving = body.velocity != (0.0, 0.0) or body.angular_velocity != 0.0
    return int(library.b2_kinematicBody if moving else library.b2_staticBody)
