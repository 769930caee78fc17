"""A whole scene, stepped by pymunk with every convention of ours mapped to its own.

==========================  ==============================================================
ours                        pymunk's
==========================  ==============================================================
the pair's coefficients     each body is given values whose product, pymunk's own rule, is the
                            pair's; where there are none, set on each contact by a callback
static body                 static, or kinematic when it has a velocity
damping rate c, 1/s         ``space.damping`` = exp(-c), the share of speed left after 1 s
polygon's vertices          unchanged; the mass and moment of inertia are given, not derived
normal, from a to b         turned round where pymunk lists the bodies the other way
==========================  ==============================================================

Everything else is pymunk's default unless it is asked for: in particular its slop of 0.1 m, which
is large for a small body. Callbacks of a scene are not called: they belong to our engine.
"""

from __future__ import annotations

import math
import statistics
from typing import Any, Literal

import numpy as np
import pymunk
from numpy.typing import NDArray

from lesson_code.engine.core.frames import STATE_NUMBERS
from lesson_code.engine.core.impulse_table import EVENT_NUMBERS
from lesson_code.engine.core.mixing import MIXING_RULES, MixingRule
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.recording import Event, Stepper, moved_on
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.formulas.validation import non_negative, one_number
from lesson_code.geometry.shapes import Circle, Polygon, Segment, Shape
from lesson_code.reference.scene_mapping import coefficients, own_values, refuse_heap

CELL_WIDTH, CELLS_PER_BODY = 3.0, 1
"""Of pymunk's spatial hash: the width of a cell, in widths of the median body, and how many cells.

Its manual suggests 1 and 10: with those a gas of 1,000 discs takes a fifth longer, one of 100,000
nearly twice as long, and a pile as long as with these.
"""


class PymunkStepper(Stepper):
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
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    keep_impulses : bool
        Whether to write down what each pair receives. It costs a call for each pair and step:
        without it there are no events, nothing is `visited`, and pymunk runs as fast as it can.
    broad_phase : "tree" or "hash"
        How pymunk finds the pairs: by its tree of boxes, or by a grid whose cells are three times
        as wide as the median body.
    slop : float, optional
        Overlap that pymunk leaves alone, m, >= 0. None, the default, is pymunk's own: 0.1 m.

    Raises
    ------
    ValueError
        The bodies are heaped into one another, or an argument is out of range.

    Attributes
    ----------
    visited : list of (int, int)
        The pairs that touched in the last sub-step, in the order in which pymunk visited them.
    corrects_coefficients : bool
        Whether each contact is given its coefficients by a callback, which costs time.
    """

    def __init__(
        self,
        scene: Scene,
        *,
        dt: float,
        iterations: int,
        substeps: int,
        combine: MixingRule,
        keep_impulses: bool = True,
        broad_phase: Literal["tree", "hash"] = "tree",
        slop: float | None = None,
    ) -> None:
        refuse_heap(scene)
        self.dt = dt
        self._substeps = substeps
        self._substeps_done = 0
        self._combine = combine
        self._materials = [body.material for body in scene.bodies]
        self.space = _space(scene, iterations, broad_phase, slop)
        self.bodies = [_add(self.space, body) for body in scene.bodies]
        self._number = {body: number for number, body in enumerate(self.bodies)}
        self.visited: list[tuple[int, int]] = []
        self._events: list[Event] = []
        self._set_coefficients(scene)
        if keep_impulses:
            self.space.on_collision(None, None, post_solve=self._note)

    def advance(self, steps: int) -> None:
        """Advance by this many steps of dt."""
        part = self.dt / self._substeps
        for _ in range(steps * self._substeps):
            self._substeps_done += 1
            self.visited.clear()
            self.space.step(part)

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        rows = [(*b.position, b.angle, *b.velocity, b.angular_velocity) for b in self.bodies]
        return np.array(rows, dtype=float).reshape(-1, STATE_NUMBERS)

    def states_after(self, duration: float) -> NDArray[np.float64]:
        """Return the states moved on at their velocities, shape (N, 6)."""
        return moved_on(self.states(), duration)

    def events(self) -> NDArray[np.float64]:
        """Return the impulses of all steps so far, shape (K, 10)."""
        return np.array(self._events, dtype=float).reshape(-1, EVENT_NUMBERS)

    def plan(self, reason: str) -> Plan:
        """Return how the scene is run, with the reason for the choice of this engine."""
        return Plan("pymunk", reason, "C", "pymunk's own")

    def forget_contacts(self) -> None:
        """Make the space forget its contacts; nothing collides in it afterwards.

        A space that is thrown away looks through all of them for each of its shapes: with 100,000
        bodies in a heap that takes half an hour.
        """
        collides_with_nothing = pymunk.ShapeFilter(mask=0)
        for shape in self.space.shapes:
            shape.filter = collides_with_nothing
        self.space.collision_persistence = 0
        for _ in range(2):  # the first step finds that nothing touches, the second forgets
            self.space.step(self.dt)

    def _set_coefficients(self, scene: Scene) -> None:
        """Give pymunk the pairs' coefficients: by its own product where that can be, else ours."""
        values = own_values(scene.bodies, self._combine, MIXING_RULES["pymunk"])
        self.corrects_coefficients = values is None
        if values is None:
            self.space.on_collision(None, None, pre_solve=self._correct)
            return
        for body, (restitution, friction) in zip(self.bodies, values, strict=True):
            (shape,) = body.shapes
            shape.elasticity, shape.friction = restitution, friction

    def _correct(self, arbiter: pymunk.Arbiter, _space: pymunk.Space, _data: Any) -> None:
        """Set a contact's coefficients before it is solved."""
        a, b = (self._materials[self._number[body]] for body in arbiter.bodies)
        arbiter.restitution, arbiter.friction = coefficients(self._combine, a, b)

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


def _space(
    scene: Scene, iterations: int, broad_phase: Literal["tree", "hash"], slop: float | None
) -> pymunk.Space:
    """Return an empty space with a scene's surroundings and pymunk's settings."""
    space = pymunk.Space()
    space.iterations = iterations
    space.gravity = scene.gravity
    space.damping = math.exp(-scene.damping)
    if slop is not None:
        space.collision_slop = one_number("slop", slop, non_negative)
    if broad_phase not in ("tree", "hash"):
        raise ValueError(f"broad_phase must be tree or hash, got {broad_phase!r}")
    if broad_phase == "hash" and scene.bodies:
        width = statistics.median(body.shape.min_width for body in scene.bodies)
        space.use_spatial_hash(CELL_WIDTH * width, CELLS_PER_BODY * len(scene.bodies))
    return space


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
