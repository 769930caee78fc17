"""A whole scene, stepped by pymunk with every convention of ours mapped to its own.

==========================  ==============================================================
ours                        pymunk's
==========================  ==============================================================
the pair's coefficients     set on each contact by a callback before it is solved, unless
                            pymunk's own rule, the product, is asked for
static body                 static, or kinematic when it has a velocity
damping rate c, 1/s         ``space.damping`` = exp(-c), the share of speed left after 1 s
polygon's vertices          unchanged; the mass and moment of inertia are given, not derived
normal, from a to b         turned round where pymunk lists the bodies the other way
==========================  ==============================================================

Everything else is pymunk's default: in particular its slop of 0.1 m, which is large for a
small body. Callbacks of a scene are not called: they belong to our engine.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pymunk
from numpy.typing import NDArray

from lesson_code.engine.broad_phase import bound
from lesson_code.engine.combination import RULES as COMBINATION_RULES
from lesson_code.engine.combination import UNSPECIFIED, Combination, combined
from lesson_code.engine.recording import EVENT_NUMBERS, STATE_NUMBERS, Event
from lesson_code.engine.room import refuse_heap
from lesson_code.engine.scene import Body, Material, Scene
from lesson_code.engine.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape


class PymunkStepper:
    """A scene that pymunk advances by steps of `dt`, each in `substeps` equal parts.

    Parameters
    ----------
    scene : Scene
        What is simulated.
    dt : float
        s, > 0.
    iterations : int
        Of pymunk's solver, in each sub-step.
    substeps : int
        Parts of a step.
    combine : Combination
        How a pair's coefficients come from its bodies'.

    Raises
    ------
    ValueError
        The bodies are heaped into one another.

    Attributes
    ----------
    visited : list of (int, int)
        The pairs that touched in the last sub-step, in the order in which pymunk visited them.
    corrects_coefficients : bool
        Whether each contact is given its coefficients by a callback, which costs time.
    """

    def __init__(
        self, scene: Scene, *, dt: float, iterations: int, substeps: int, combine: Combination
    ) -> None:
        _refuse_heap(scene)
        self.dt = dt
        self._substeps = substeps
        self._substeps_done = 0
        self._combine = combine
        self._materials = [body.material for body in scene.bodies]
        self.space = pymunk.Space()
        self.space.iterations = iterations
        self.space.gravity = scene.gravity
        self.space.damping = math.exp(-scene.damping)
        self.bodies = [_add(self.space, body) for body in scene.bodies]
        self._number = {body: number for number, body in enumerate(self.bodies)}
        self.visited: list[tuple[int, int]] = []
        self._events: list[Event] = []
        self._set_coefficients()
        self.space.on_collision(None, None, post_solve=self._note)

    def advance(self, steps: int) -> None:
        """Advance by so many steps of dt."""
        for _ in range(steps * self._substeps):
            self._substeps_done += 1
            self.visited.clear()
            self.space.step(self.dt / self._substeps)

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        rows = [(*b.position, b.angle, *b.velocity, b.angular_velocity) for b in self.bodies]
        return np.array(rows, dtype=float).reshape(-1, STATE_NUMBERS)

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10)."""
        return np.array(self._events, dtype=float).reshape(-1, EVENT_NUMBERS)

    def _set_coefficients(self) -> None:
        """Give pymunk the pairs' coefficients: its own product where that is right, else ours."""
        materials = sorted(set(self._materials), key=repr)
        pairs = [(a, b) for a in materials for b in materials]
        for body, material in zip(self.bodies, self._materials, strict=True):
            (shape,) = body.shapes
            shape.elasticity = _or_one(material.restitution)
            shape.friction = _or_one(material.friction)
        self.corrects_coefficients = any(self._pair(a, b) != _product(a, b) for a, b in pairs)
        if self.corrects_coefficients:
            self.space.on_collision(None, None, pre_solve=self._correct)

    def _pair(self, a: Material, b: Material) -> tuple[float, float]:
        """Return the restitution and the friction of a pair, by our rule."""
        return (
            combined(
                COMBINATION_RULES[self._combine.restitution],
                _or_unspecified(a.restitution),
                _or_unspecified(b.restitution),
            ),
            combined(
                COMBINATION_RULES[self._combine.friction],
                _or_unspecified(a.friction),
                _or_unspecified(b.friction),
            ),
        )

    def _correct(self, arbiter: pymunk.Arbiter, _space: pymunk.Space, _data: Any) -> None:
        """Set a contact's coefficients before it is solved."""
        a, b = (self._materials[self._number[body]] for body in arbiter.bodies)
        arbiter.restitution, arbiter.friction = self._pair(a, b)

    def _note(self, arbiter: pymunk.Arbiter, _space: pymunk.Space, _data: Any) -> None:
        """Write down what a pair has received in this step, at the middle of its points."""
        first, second = (self._number[body] for body in arbiter.bodies)
        self.visited.append((first, second))
        if arbiter.total_impulse == (0.0, 0.0):
            return
        normal, on_first = arbiter.normal, arbiter.total_impulse
        on_b = -on_first if first < second else on_first
        n = normal if first < second else -normal
        points = arbiter.contact_point_set.points
        middle = sum((p.point_a + p.point_b for p in points), pymunk.Vec2d.zero()) / (
            2 * len(points)
        )
        self._events.append(
            (
                *(self._substeps_done * self.dt / self._substeps,),
                *(min(first, second), max(first, second)),
                *(*middle, *n, on_b.dot(n), on_b.dot(n.perpendicular())),
                -min(p.distance for p in points),
            )
        )


def _refuse_heap(scene: Scene) -> None:
    """Refuse bodies heaped into one another: pymunk would go on until the memory is full."""
    world = world_of(scene, dt=1.0, iterations=0, combine=Combination())
    bound(world)
    refuse_heap(len(world.bodies), BROAD_PHASES[broad_phase_for(scene)](world))


def _add(space: pymunk.Space, body: Body) -> pymunk.Body:
    """Add a body and its shape to a space."""
    if body.mass is not None and body.inertia is not None:
        made = pymunk.Body(body.mass, body.inertia)
    elif body.velocity == (0.0, 0.0) and body.angular_velocity == 0.0:
        made = pymunk.Body(body_type=pymunk.Body.STATIC)
    else:
        made = pymunk.Body(body_type=pymunk.Body.KINEMATIC)
    made.position, made.angle = body.position, body.angle
    made.velocity, made.angular_velocity = body.velocity, body.angular_velocity
    space.add(made, _shape(made, body.shape))
    return made


def _shape(body: pymunk.Body, shape: Shape) -> pymunk.Shape:
    """Return pymunk's shape for one of ours."""
    match shape:
        case Circle():
            return pymunk.Circle(body, shape.radius)
        case Segment():
            return pymunk.Segment(body, shape.start, shape.end, shape.radius)
        case Polygon():
            return pymunk.Poly(body, shape.vertices)


def _product(a: Material, b: Material) -> tuple[float, float]:
    """Return the restitution and the friction that pymunk's own rule gives a pair."""
    return (
        _or_one(a.restitution) * _or_one(b.restitution),
        _or_one(a.friction) * _or_one(b.friction),
    )


def _or_one(coefficient: float | None) -> float:
    """Return a coefficient; one that is left to the other body is 1, which changes no product."""
    return 1.0 if coefficient is None else coefficient


def _or_unspecified(coefficient: float | None) -> float:
    """Return a coefficient as our tables hold it."""
    return UNSPECIFIED if coefficient is None else coefficient
