"""A running world that a player can reach into: bodies join and leave, are pushed and are moved.

It runs the engine's own step. Bodies are known by numbers of their own, which stay the same while
others come and go; the engine's tables are made anew only then.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import fields, replace
from functools import cached_property
from operator import attrgetter
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled import as_arrays, as_numbers, compiled_function, link
from lesson_code.engine.core.broad_phase import uniform_grid
from lesson_code.engine.core.callbacks import Callbacks
from lesson_code.engine.core.capacity import make_room
from lesson_code.engine.core.mixing import Combination
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.recording import EVENT_NUMBERS
from lesson_code.engine.core.rows import ImpulseRow
from lesson_code.engine.core.scene import XY, Body, Scene, body_at
from lesson_code.engine.core.step import advance, rigid_part
from lesson_code.engine.core.tables import BROAD_PHASES, broad_phase_for, world_of
from lesson_code.engine.solvers.sequential import SOLVER
from lesson_code.engine.stepper import STATE_FIELDS
from lesson_code.engine.touch_teller import TouchTeller
from lesson_code.formulas import angular_momentum, kinetic_energy, momentum

TIME_STEP = 1 / 60
"""s: one frame of a program, and one step of its world."""

WORTH_COMPILING = 100
"""Bodies: plain Python moves fewer of them in half a frame."""

IMPULSE = attrgetter(*(field.name for field in fields(ImpulseRow)))
"""All fields of a row of impulses; many times faster than :func:`dataclasses.astuple`."""

NO_IMPULSES: NDArray[np.float64] = np.empty((0, EVENT_NUMBERS))

ANY_SCENE = Pipeline(rigid_part, uniform_grid, SOLVER.stages_for({}))
"""The stages with every effect: whatever joins the world, its machine code stays the same."""


class LiveWorld:
    """Bodies that the engine moves step by step, and that anybody may change between two steps.

    Parameters
    ----------
    bodies : iterable of Body
        Those that are there from the start; they get the numbers 0, 1, 2, ...
    gravity : (float, float)
        m/s^2.
    damping : float
        1/s, >= 0.
    dt : float
        The time step, s.
    iterations : int
        Sweeps over the contacts in a step.
    combine : Combination
        How a pair's coefficients come from its bodies'.
    callbacks : Callbacks
        Told after each step which pairs have begun to touch, touch, or have parted. The step is
        over then, so that `pre_solve` is never called.

    Attributes
    ----------
    steps : int
        How many steps have been made.
    pipeline : Pipeline
        The stages in plain Python; machine code always has the grid.
    impulses : ndarray, shape (K, 10)
        Of the last step: time, body a, body b, point x and y, normal x and y (a to b), normal
        and tangent impulse on b in N s, penetration in m. Bodies by their places in `numbers`.

    Examples
    --------
    >>> from lesson_code import Body, Circle
    >>> world = LiveWorld()
    >>> ball = world.add(Body(Circle(0.5), mass=2.0))
    >>> world.push(ball, (3.0, 0.0))
    >>> world.velocity(ball)
    (1.5, 0.0)
    """

    def __init__(
        self,
        bodies: Iterable[Body] = (),
        *,
        gravity: XY = (0.0, 0.0),
        damping: float = 0.0,
        dt: float = TIME_STEP,
        iterations: int = 10,
        combine: Combination = Combination(),  # noqa: B008 - it never changes
        callbacks: Callbacks = Callbacks(),  # noqa: B008 - it never changes
    ) -> None:
        self.gravity, self.damping, self.dt = gravity, damping, dt
        self.combine, self._iterations = combine, iterations
        self._teller = TouchTeller(callbacks, combine)
        self.steps = 0
        self.compiled = False
        self._bodies: dict[int, Body] = dict(enumerate(bodies))
        self._next = len(self._bodies)
        self._tables: Any = None
        self._build()

    def __len__(self) -> int:
        """Return how many bodies there are."""
        return len(self._bodies)

    def __contains__(self, number: int) -> bool:
        """Return whether a body is in the world."""
        return number in self._bodies

    # Who is there

    @property
    def numbers(self) -> tuple[int, ...]:
        """The numbers of all bodies, in the order of :meth:`states`."""
        return tuple(self._bodies)

    @property
    def time(self) -> float:
        """The time that has passed, s."""
        return self.steps * self.dt

    def body(self, number: int) -> Body:
        """Return a body's shape, mass and material; where it was put, not where it is."""
        return self._bodies[number]

    def items(self) -> Iterator[tuple[int, Body]]:
        """Yield number and body of all."""
        return iter(self._bodies.items())

    def bodies(self) -> list[Body]:
        """Return all bodies as they are: where they have got to, and how they move."""
        return [
            body if _stands_where_it_was_put(body, state) else body_at(body, state)
            for body, state in zip(self._bodies.values(), self.states().tolist(), strict=True)
        ]

    def add(self, body: Body) -> int:
        """Let a body join, and return its number."""
        self._write_back()
        number = self._next
        self._bodies[number] = body
        self._next += 1
        return number

    def remove(self, number: int) -> None:
        """Take a body out of the world."""
        self._write_back()
        del self._bodies[number]

    def clear(self) -> None:
        """Take everything out of the world."""
        self._bodies = {}
        self._tables = None

    # Where they are, and how they move

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        return np.column_stack([self._column(name) for name in STATE_FIELDS])

    def position(self, number: int) -> XY:
        """Return where a body is, m."""
        return self._get("x", number), self._get("y", number)

    def velocity(self, number: int) -> XY:
        """Return how a body moves, m/s."""
        return self._get("vx", number), self._get("vy", number)

    def angle(self, number: int) -> float:
        """Return how far a body has turned, rad."""
        return self._get("angle", number)

    def spin(self, number: int) -> float:
        """Return how fast a body turns, rad/s."""
        return self._get("w", number)

    def move(self, number: int, position: XY) -> None:
        """Put a body somewhere else, m."""
        self._set("x", number, position[0])
        self._set("y", number, position[1])

    def throw(self, number: int, velocity: XY, spin: float | None = None) -> None:
        """Give a body a velocity, m/s, and perhaps a spin, rad/s."""
        self._set("vx", number, velocity[0])
        self._set("vy", number, velocity[1])
        if spin is not None:
            self._set("w", number, spin)

    def push(self, number: int, impulse: XY, arm: XY = (0.0, 0.0)) -> None:
        """Give a body an impulse, N s, at a point `arm` from its centre, m."""
        (vx, vy), (jx, jy) = self.velocity(number), impulse
        inv_m, inv_i = self._get("inv_m", number), self._get("inv_i", number)
        turning = (arm[0] * jy - arm[1] * jx) * inv_i
        self.throw(number, (vx + jx * inv_m, vy + jy * inv_m), self.spin(number) + turning)

    def push_all(self, impulses: NDArray[np.float64]) -> None:
        """Give every body an impulse at its centre, N s, shape (N, 2)."""
        inv_m = self._column("inv_m")
        self._write("vx", self._column("vx") + impulses[:, 0] * inv_m)
        self._write("vy", self._column("vy") + impulses[:, 1] * inv_m)

    def coat(self, *, restitution: float) -> None:
        """Give every body another restitution."""
        self._write_back()
        for number, body in self._bodies.items():
            self._bodies[number] = replace(
                body, material=replace(body.material, restitution=restitution)
            )

    def pull(self, gravity: XY) -> None:
        """Let another gravity act, m/s^2."""
        self.gravity = gravity
        state = self._ready().state
        state.gravity_x, state.gravity_y = gravity

    # Time

    def step(self) -> None:
        """Let one time step pass, and tell the callbacks.

        Raises
        ------
        FloatingPointError
            A body has left the range of floating point.
        ValueError
            The bodies overlap in so many pairs that no memory would hold them.
        """
        self._ready().state.steps_left = 1
        self.impulses = NO_IMPULSES
        while not self._run():
            self._clear_the_way()
        self.steps += 1
        self._take_impulses()
        self._teller.tell(self.time, self.impulses, self._bodies)

    def _clear_the_way(self) -> None:
        """Do away with what has stopped a step: a table that is full."""
        state = self._tables.state
        if state.lost_body >= 0:
            number = self.numbers[state.lost_body]
            raise FloatingPointError(f"body {number} has left the range of floating point")
        self._take_impulses()
        self._tables = make_room(self._tables)

    def compile(self) -> None:
        """Go on in machine code, with the same results to the last bit; it takes a while."""
        self._write_back()
        self.compiled = True
        self._ready().state.steps_left = 0
        self._run()

    @property
    def broad_phase(self) -> str:
        """The name of the way in which candidate pairs are found."""
        return "uniform_grid" if self.compiled else broad_phase_for(Scene(self._bodies.values()))

    @cached_property
    def source(self) -> str:
        """The program that is compiled."""
        return link(advance, pipeline=ANY_SCENE)

    # What can be told of it

    def momentum(self) -> XY:
        """Return the total momentum of all bodies that can be pushed, kg m/s."""
        state, mass, _ = self._matter()
        x, y = momentum(mass, state[:, 3:5]) if len(mass) else (0.0, 0.0)
        return float(x), float(y)

    def angular_momentum(self) -> float:
        """Return their total angular momentum about the origin, kg m^2/s."""
        state, mass, inertia = self._matter()
        if not len(mass):
            return 0.0
        return float(angular_momentum(mass, state[:, 0:2], state[:, 3:5], inertia, state[:, 5]))

    def kinetic_energy(self) -> float:
        """Return their kinetic energy, that of spin included, J."""
        state, mass, inertia = self._matter()
        return (
            float(kinetic_energy(mass, state[:, 3:5], inertia, state[:, 5])) if len(mass) else 0.0
        )

    def touching(self) -> frozenset[int]:
        """Return the numbers of the bodies that were pushed by another one in the last step."""
        numbers = self.numbers
        return frozenset(numbers[int(k)] for k in np.unique(self.impulses[:, 1:3]))

    # Inside

    def _matter(self) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
        """Return states, masses and inertias of the bodies that can be pushed."""
        inv_m, inv_i = self._column("inv_m"), self._column("inv_i")
        free = inv_m > 0
        with np.errstate(divide="ignore"):
            inertia = np.where(inv_i[free] > 0, 1 / inv_i[free], 0.0)
        return self.states()[free], 1 / inv_m[free], inertia

    def _build(self) -> None:
        """Make the engine's tables of the bodies as they are."""
        scene = Scene(self._bodies.values(), self.gravity, self.damping)
        self._tables = world_of(scene, self.dt, self._iterations, self.combine)
        self._index = {number: place for place, number in enumerate(self._bodies)}
        self.pipeline = ANY_SCENE._replace(broad_phase=BROAD_PHASES[broad_phase_for(scene)])
        self.impulses = NO_IMPULSES
        if self.compiled:
            self._program = compiled_function(self.source, "advance")
            self._tables = as_arrays(self._tables, self.source)

    def _ready(self) -> Any:
        """Return the tables, made anew if bodies have come or gone."""
        if self._tables is None:
            self._build()
        return self._tables

    def _run(self) -> bool:
        """Make the steps that are left; return whether all are made."""
        if self.compiled:
            return bool(self._program(self._ready()))
        return advance(self._ready(), self.pipeline)

    def _write_back(self) -> None:
        """Note down where all bodies are, before the tables are given up."""
        if self._tables is not None:
            self._bodies = dict(zip(self._bodies, self.bodies(), strict=True))
            self._tables = None

    def _column(self, name: str) -> NDArray[np.float64]:
        """Return one field of all bodies, shape (N,)."""
        rows = self._ready().bodies
        if self.compiled:
            return np.array(rows[name], dtype=float)
        return np.array([getattr(row, name) for row in rows], dtype=float)

    def _write(self, name: str, values: NDArray[np.float64]) -> None:
        """Change one field of all bodies."""
        rows = self._ready().bodies
        if self.compiled:
            rows[name] = values
        else:
            for row, value in zip(rows, values.tolist(), strict=True):
                setattr(row, name, value)

    def _get(self, name: str, number: int) -> float:
        """Return one field of one body."""
        row = self._ready().bodies[self._index[number]]
        return float(row[name] if self.compiled else getattr(row, name))

    def _set(self, name: str, number: int, value: float) -> None:
        """Change one field of one body."""
        rows, place = self._ready().bodies, self._index[number]
        if self.compiled:
            rows[name][place] = value
        else:
            setattr(rows[place], name, value)

    def _take_impulses(self) -> None:
        """Take the impulses out of their table; a step may fill it more than once."""
        tables = self._tables
        count = tables.state.impulse_count
        if count:
            rows = tables.impulses[:count]
            told = as_numbers(rows) if self.compiled else np.array([IMPULSE(row) for row in rows])
            self.impulses = np.concatenate([self.impulses, told])
        tables.state.impulse_count = 0


def _stands_where_it_was_put(body: Body, state: list[float]) -> bool:
    """Return whether a body that nothing can push has not been moved, and does not move."""
    x, y, _, *motion = state
    return body.is_static and (x, y) == body.position and motion == [0.0, 0.0, 0.0]
