"""A running world that a player can reach into: bodies join and leave, are pushed and are moved.

It runs the engine's own solvers; :mod:`lesson_code.engine.live_solver` says which, and why. Bodies
are known by numbers of their own, which stay the same while others come and go; the engine's tables
are made anew only then.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from copy import copy, deepcopy
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled.library import why_no_compiler
from lesson_code.engine.core.callbacks import Callbacks
from lesson_code.engine.core.frames import STATE_FIELDS
from lesson_code.engine.core.impulse_table import NO_IMPULSES
from lesson_code.engine.core.mixing import MixingRule
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.scene import XY, Body, Scene, body_at
from lesson_code.engine.effects.callbacks import StepTouches, TouchListener
from lesson_code.engine.effects.choice import choose_effects, names_used
from lesson_code.engine.effects.question import Question
from lesson_code.engine.live_solver import (
    SWEEPS_ASKED,
    WORTH_COMPILING,
    Flight,
    has_program,
    solver_for,
    stepped_solver_for,
    stepper_for,
)
from lesson_code.engine.matter import Matter
from lesson_code.engine.solvers.choice import SolverChoice
from lesson_code.engine.stepper import EngineStepper

TIME_STEP = 1 / 60
"""s: one frame of a program, and one step of its world."""

STEPS_ON_THE_GROUND = 10
"""Steps until discs that the exact solver could not take are offered to it again: by then what
touched has mostly parted."""


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
    iterations : int, optional
        Sweeps over the contacts in a step: the sequential solver makes them. None: the solver that
        suits the bodies.
    combine : MixingRule
        How a pair's coefficients come from its bodies'.
    callbacks : Callbacks
        Told after each step which pairs have begun to touch, touch, or have parted. The step is
        over then, so that `pre_solve` is never called.

    Attributes
    ----------
    steps : int
        How many steps have been made.
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
        iterations: int | None = None,
        combine: MixingRule = MixingRule(),  # noqa: B008 - it never changes
        callbacks: Callbacks = Callbacks(),  # noqa: B008 - it never changes
    ) -> None:
        self.gravity, self.damping, self.dt = gravity, damping, dt
        self.combine, self._iterations = combine, iterations
        self._listener = TouchListener(callbacks) if callbacks.wanted else None
        self.steps = 0
        self._in_code: frozenset[str] = frozenset()  # the solvers that go in machine code
        self._bodies: dict[int, Body] = dict(enumerate(bodies))
        self._held: dict[int, Body] = {}
        self._flight: Flight | None = None
        self._flown: NDArray[np.float64] | None = None  # the states, where a flight has led to them
        self._known: Matter | None = None
        self._flies_from = 0
        self._next = len(self._bodies)
        self._at_work: EngineStepper | None = None
        self.impulses = NO_IMPULSES

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
        self._held.pop(number, None)

    def clear(self) -> None:
        """Take everything out of the world."""
        self._land()
        self._bodies, self._held = {}, {}
        self._at_work = None

    def hold(self, number: int) -> None:
        """Hold a body still: until it is released, nothing can push it.

        Others bounce off it as off a wall, so that nothing but its own energy is lost.
        """
        self._write_back()
        body = self._bodies[number]
        self._held[number] = body
        self._bodies[number] = replace(
            body, mass=None, inertia=None, velocity=(0.0, 0.0), angular_velocity=0.0
        )

    def release(self, number: int, velocity: XY = (0.0, 0.0)) -> None:
        """Let a body go that is held, with a velocity, m/s; nothing if it is not held."""
        if number in self._held:
            self._write_back()
            held, body = self._held.pop(number), self._bodies[number]
            self._bodies[number] = replace(
                body, mass=held.mass, inertia=held.inertia, velocity=velocity
            )

    # Where they are, and how they move

    def states(self) -> NDArray[np.float64]:
        """Return x, y, angle, vx, vy, w of every body, shape (N, 6)."""
        return self._engine.states() if self._flown is None else self._flown.copy()

    def position(self, number: int) -> XY:
        """Return where a body is, m."""
        row = self._row(number)
        return float(row.x), float(row.y)

    def velocity(self, number: int) -> XY:
        """Return how a body moves, m/s."""
        row = self._row(number)
        return float(row.vx), float(row.vy)

    def angle(self, number: int) -> float:
        """Return how far a body has turned, rad."""
        return float(self._row(number).angle)

    def spin(self, number: int) -> float:
        """Return how fast a body turns, rad/s."""
        return float(self._row(number).w)

    def move(self, number: int, position: XY) -> None:
        """Put a body somewhere else, m."""
        self._land()
        row = self._row(number)
        row.x, row.y = position

    def throw(self, number: int, velocity: XY, spin: float | None = None) -> None:
        """Give a body a velocity, m/s, and perhaps a spin, rad/s."""
        self._land()
        row = self._row(number)
        row.vx, row.vy = velocity
        if spin is not None:
            row.w = spin

    def push(self, number: int, impulse: XY, arm: XY = (0.0, 0.0)) -> None:
        """Give a body an impulse, N s, at a point `arm` from its centre, m."""
        self._land()
        row, (jx, jy) = self._row(number), impulse
        row.vx += jx * row.inv_m
        row.vy += jy * row.inv_m
        row.w += (arm[0] * jy - arm[1] * jx) * row.inv_i

    def coat(self, **coefficients: float) -> None:
        """Give every body another restitution, another friction, or both, by name."""
        self._write_back()
        for number, body in self._bodies.items():
            self._bodies[number] = replace(body, material=replace(body.material, **coefficients))

    def weigh(self, number: int, mass: float) -> None:
        """Give a body another mass, kg; its inertia changes with it."""
        self._write_back()
        body = self._bodies[number]
        inertia = body.inertia and body.mass and body.inertia * mass / body.mass
        self._bodies[number] = replace(body, mass=mass, inertia=inertia)

    def pull(self, gravity: XY) -> None:
        """Set the gravity, m/s^2."""
        self._write_back()
        self.gravity = gravity

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
        self._known = self._flown = None
        if not self._fly():
            self._advance_engine()
        self.steps += 1
        if self._listener is not None:
            touches = StepTouches(self.impulses, self._engine.world, self.numbers, self.time)
            self._listener.tell(touches, self.time, self.numbers)

    def _advance_engine(self) -> None:
        """Let the engine make a step."""
        engine = self._engine
        try:
            engine.advance(1)
        except FloatingPointError:
            raise _lost(self.numbers[engine.world.state.lost_body]) from None
        self.impulses = engine.take_events()

    def _fly(self) -> bool:
        """Let the exact solver make a step, and return whether it has."""
        engine = self._engine
        if self.solver != "exact":
            return False
        try:
            flight = self._in_flight()
            states, impulses = flight.advance(self.dt)
        except RuntimeError:
            self._land()
            self._flies_from = self.steps + STEPS_ON_THE_GROUND
            return False
        if not np.isfinite(states).all():
            raise _lost(self.numbers[int(np.argmin(np.isfinite(states).all(axis=1)))])
        _put(engine.world.bodies, states)
        self._flown = states
        impulses[:, 0] += self.time - flight.time + self.dt
        self.impulses = impulses
        return True

    def _in_flight(self) -> Flight:
        """Return the exact solver at work on the bodies as they are."""
        if self._flight is None:
            scene = Scene(self.bodies(), self.gravity, self.damping)
            compiled = None if "exact" in self._in_code else False
            self._flight = Flight(scene, self.combine, compiled)
        return self._flight

    def _land(self) -> None:
        """Give up what the exact solver has foreseen, and what is known: something changes."""
        self._flight = self._flown = self._known = None

    @property
    def wants_code(self) -> bool:
        """Whether plain Python makes its steps, and takes long for them."""
        return self.steps > 0 and self._is_slow and not self.compiled

    @property
    def _is_slow(self) -> bool:
        """Whether plain Python takes long for a step, and machine code can be had."""
        solver = self.solver
        many = len(self) >= WORTH_COMPILING or solver == "substep"
        return many and has_program(solver)

    @property
    def compiled(self) -> bool:
        """Whether the steps of the solver at work are made in machine code."""
        return self.solver in self._in_code

    @property
    def solver(self) -> str:
        """The solver that makes its next step."""
        stepped = self._engine.solver
        flies = self._choice.solver == "exact" and self.steps >= self._flies_from
        return "exact" if flies else stepped

    def compile(self) -> None:
        """Go on in machine code from here, with the same results to the last bit.

        It takes seconds where its program is not kept. If another solver takes over, that one
        begins in plain Python.
        """
        solver = self.solver
        self._in_code |= {solver}
        if solver != "exact":
            self._engine.compile()
        elif self._flight is not None:
            self._flight.solver.compile()

    def plan(self) -> Plan:
        """Return what the bodies call for as they are now, and what the world reckons with.

        The rules are those of every run; its end is not known. Callbacks are no part of the scene:
        they are told after a step.

        Examples
        --------
        >>> from lesson_code import Body, Circle
        >>> discs = [Body(Circle(1), mass=1.0, position=(0, 3 * k)) for k in (0, 1)]
        >>> plan = LiveWorld(discs).plan()
        >>> [(name, plan.effect(name).verdict) for name in ("collisions", "rotation", "sleeping")]
        [('collisions', 'used'), ('rotation', 'forced'), ('sleeping', 'left out')]
        """
        engine, scene = self._engine, Scene(self.bodies(), self.gravity, self.damping)
        name, reason = self._choice
        if name == "exact" and self._at_exact_work():
            return self._in_flight().solver.plan(reason)
        question = Question(scene, engine.plan("").solver, dt=self.dt, combine=self.combine)
        run = dict.fromkeys(names_used(engine.effects), True)
        plan = replace(engine.plan(reason), effects=choose_effects(question, run))
        if not has_program(plan.solver):
            return plan
        reason = "plain Python takes long for its steps" if self.compiled else self._why_plain()
        return replace(plan, code_reason=reason)

    def _at_exact_work(self) -> bool:
        """Return whether the exact solver can take the bodies as they are."""
        try:
            self._in_flight()
        except RuntimeError:
            return False
        return True

    def _why_plain(self) -> str:
        """Return why it is not in machine code."""
        if not self._is_slow:
            return f"fewer than {WORTH_COMPILING} bodies"
        return why_no_compiler() or "machine code is still to be made"

    # What can be told of it

    def momentum(self) -> XY:
        """Return the total momentum of all bodies that can be pushed, kg m/s."""
        return self.matter().momentum

    def angular_momentum(self) -> float:
        """Return their total angular momentum about the origin, kg m^2/s."""
        return self.matter().angular_momentum

    def kinetic_energy(self) -> float:
        """Return their kinetic energy, that of spin included, J."""
        return self.matter().kinetic_energy

    def touching(self) -> frozenset[int]:
        """Return the numbers of the bodies that were pushed by another one in the last step."""
        numbers = self.numbers
        return frozenset(numbers[int(k)] for k in np.unique(self.impulses[:, 1:3]))

    def matter(self) -> Matter:
        """Return the bodies that can be pushed, as they are now."""
        if self._known is None:
            self._known = Matter(self.states()[self._free], self._mass, self._inertia)
        return self._known

    # Copies

    def __deepcopy__(self, memo: dict[int, Any]) -> LiveWorld:
        """Return a world that goes on from here on its own, with the same results."""
        twin = memo[id(self)] = copy(self)
        twin._bodies, twin._held = dict(self._bodies), dict(self._held)
        twin._flight = self._flight and self._flight.twin()
        twin._at_work = self._at_work and self._at_work.twin()
        twin._listener = deepcopy(self._listener, memo)
        return twin

    # Inside

    @property
    def _engine(self) -> EngineStepper:
        """The engine at work on the bodies; made anew if some have come or gone."""
        if self._at_work is None:
            scene = Scene(self._bodies.values(), self.gravity, self.damping)
            self._choice = self._solver_of(scene)
            steps = stepped_solver_for(scene) if self._choice.solver == "exact" else self._choice
            self._at_work = stepper_for(
                scene,
                steps.solver,
                dt=self.dt,
                iterations=self._iterations,
                combine=self.combine,
                compiled=steps.solver in self._in_code,
            )
            self._place = {number: place for place, number in enumerate(self._bodies)}
            self._weigh_all(self._at_work)
            self.impulses = NO_IMPULSES
        return self._at_work

    def _weigh_all(self, engine: EngineStepper) -> None:
        """Note which bodies can be pushed, with their masses and inertias."""
        inv_m, inv_i = (np.array(engine.column(n), dtype=float) for n in ("inv_m", "inv_i"))
        self._free = inv_m > 0
        with np.errstate(divide="ignore"):
            self._mass = 1 / inv_m[self._free]
            self._inertia = np.where(inv_i > 0, 1 / inv_i, 0.0)[self._free]

    def _solver_of(self, scene: Scene) -> SolverChoice:
        """Return the solver that moves the bodies."""
        if self._iterations is not None:
            return SWEEPS_ASKED
        return solver_for(Question(scene, "auto", self.dt, combine=self.combine))

    def _row(self, number: int) -> Any:
        """Return a body's row in the tables of the engine."""
        engine = self._engine
        return engine.row(self._place[number])

    def _write_back(self) -> None:
        """Note down where all bodies are, before the tables are given up."""
        self._land()
        if self._at_work is not None:
            self._bodies = dict(zip(self._bodies, self.bodies(), strict=True))
            self._at_work = None


def _stands_where_it_was_put(body: Body, state: list[float]) -> bool:
    """Return whether a body that nothing can push has not been moved, and does not move."""
    x, y, _, *motion = state
    return body.is_static and (x, y) == body.position and motion == [0.0, 0.0, 0.0]


def _put(rows: Any, states: NDArray[np.float64]) -> None:
    """Put bodies where they have got to: rows, or the records that they are compiled as."""
    if isinstance(rows, np.ndarray):
        for name, column in zip(STATE_FIELDS, states.T, strict=True):
            rows[name] = column
        return
    for row, state in zip(rows, states.tolist(), strict=True):
        row.x, row.y, row.angle, row.vx, row.vy, row.w = state


def _lost(number: int) -> FloatingPointError:
    """Return the error that names a body which no number describes any more."""
    return FloatingPointError(f"body {number} has left the range of floating point")
