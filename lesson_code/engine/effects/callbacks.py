"""Callbacks: functions that receive the contacts, pair by pair, in the order of the contacts.

A scene's callbacks are called within the step. Machine code cannot call them, so a live world calls
its own after the step, from the recorded impulses.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from itertools import groupby
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.compiled.arrays import column
from lesson_code.engine.core.callbacks import Callback, Callbacks, Touch
from lesson_code.engine.core.contact_motion import contact_point
from lesson_code.engine.core.impulse_table import NO_IMPULSES
from lesson_code.engine.core.mixing import mixed
from lesson_code.engine.core.rows import ContactRow, World
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding
from lesson_code.formulas.validation import non_negative, one_number, one_vector

Pair: TypeAlias = tuple[int, int]
XY: TypeAlias = tuple[float, float]

MOST_NUMBERS = 2**31
"""More bodies than a live world will ever have had: two of their numbers make one."""


def rule(facts: Facts) -> Finding:
    """Ask whether the scene wants to be told of contacts."""
    if facts.hears_contacts:
        return Finding(True, "the scene asks to be told")
    return Finding(False, "the scene has none")


EFFECT = Effect(rule=rule, place=150, functions=("before_impulses", "after_impulses"))


class TouchListener:
    """Follows which pairs touch, and calls a scene's callbacks in the order of the contacts."""

    def __init__(self, callbacks: Callbacks) -> None:
        self._callbacks = callbacks
        self._gravity: XY | None = None
        self._touching: dict[Pair, Touch] = {}
        self._parted: list[Touch] = []
        self._told = StepTouches()

    def new_gravity(self) -> XY | None:
        """Return the gravity that a callback has set since this was last asked; None: none has."""
        gravity, self._gravity = self._gravity, None
        return gravity

    def before_impulses(self, world: World) -> None:
        """Call `begin` and `pre_solve`, and do to the contacts what they have set.

        Raises
        ------
        ValueError
            A callback has set a coefficient that is negative or not finite, or a gravity that is
            no vector.
        """
        before, self._touching = self._touching, {}
        kept: list[ContactRow] = []
        ignored: list[ContactRow] = []
        for pair, contacts in _by_pair(world):
            touch = _touch(world, contacts, time=world.state.time)
            self._touching[pair] = touch
            if pair not in before:
                self._call(self._callbacks.begin, touch)
            self._call(self._callbacks.pre_solve, touch)
            restitution = one_number("restitution", touch.restitution, non_negative)
            friction = one_number("friction", touch.friction, non_negative)
            for contact in contacts:
                contact.restitution, contact.friction = restitution, friction
            (ignored if touch.ignored else kept).extend(contacts)
        world.contacts[: world.state.contact_count] = kept + ignored
        world.state.contact_count = len(kept)
        self._parted = [touch for pair, touch in before.items() if pair not in self._touching]

    def after_impulses(self, world: World) -> None:
        """Call `post_solve` for each pair that touches, then `separate` for those that parted."""
        for pair, contacts in _by_pair(world):
            touch = self._touching[pair]
            touch.time = world.state.time
            touch.normal_impulse = sum(contact.normal_impulse for contact in contacts)
            touch.tangent_impulse = sum(contact.tangent_impulse for contact in contacts)
            self._call(self._callbacks.post_solve, touch)
        for touch in self._parted:
            self._call(self._callbacks.separate, touch)

    def tell(self, touches: StepTouches, time: float, present: Container[int]) -> None:
        """Tell of a step that is over; of a pair that has parted only if both are still present."""
        before, self._told = self._told, touches
        new = np.setdiff1d(touches.pairs, before.pairs, assume_unique=True)
        told = new if self._callbacks.post_solve is None else touches.pairs
        begun = set(new.tolist())
        for pair, touch in touches.among(told).items():
            if pair in begun:
                self._call(self._callbacks.begin, touch)
            self._call(self._callbacks.post_solve, touch)
        if self._callbacks.separate is not None:
            parted = np.setdiff1d(before.pairs, touches.pairs, assume_unique=True)
            for touch in before.among(parted).values():
                if touch.body_a in present and touch.body_b in present:
                    touch.time = time
                    self._call(self._callbacks.separate, touch)

    def _call(self, callback: Callback | None, touch: Touch) -> None:
        """Call a callback, if there is one, and see whether it has changed gravity."""
        if callback is not None:
            callback(touch)
        if touch.gravity is not None:
            x, y = one_vector("gravity", touch.gravity)
            self._gravity, touch.gravity = (float(x), float(y)), None


class StepTouches:
    """The touches of a step that is over; each is made from its impulses when somebody asks for it.

    A heap of 500 discs has a thousand in each step, few of which are new.

    Parameters
    ----------
    impulses : ndarray, shape (K, 10)
        Of the step; the bodies by their places in the tables.
    world : World, optional
        The tables; None where there are no impulses.
    numbers : sequence of int
        The numbers that the bodies have of their own, in the order of their places.
    time : float
        s, at the end of the step.

    Attributes
    ----------
    pairs : ndarray of int
        The pairs that touch: a number for each two.
    """

    def __init__(
        self,
        impulses: NDArray[np.float64] = NO_IMPULSES,
        world: World | None = None,
        numbers: Sequence[int] = (),
        time: float = 0.0,
    ) -> None:
        self._impulses, self._numbers, self._time = impulses, numbers, time
        a, b = np.array(numbers, dtype=np.int64)[impulses[:, 1:3].astype(np.int64).T]
        self._pair_of_each = a * MOST_NUMBERS + b
        self.pairs = np.unique(self._pair_of_each)
        if world is not None:
            self._e, self._mu = (
                np.array(column(world.bodies, name)) for name in ("restitution", "friction")
            )
            self._rules = world.state.restitution_rule, world.state.friction_rule

    def among(self, pairs: NDArray[np.int64]) -> dict[int, Touch]:
        """Return the touches of some of the pairs, in the order of their contacts."""
        chosen = np.isin(self._pair_of_each, pairs)
        rows: dict[int, list[list[float]]] = {}
        found = self._pair_of_each[chosen].tolist(), self._impulses[chosen].tolist()
        for pair, row in zip(*found, strict=True):
            rows.setdefault(pair, []).append(row)
        return {pair: self._touch(some) for pair, some in rows.items()}

    def _touch(self, rows: list[list[float]]) -> Touch:
        """Return the touch that one pair's impulses make."""
        first, (e_rule, mu_rule) = rows[0], self._rules
        a, b = int(first[1]), int(first[2])
        return Touch(
            time=self._time,
            body_a=self._numbers[a],
            body_b=self._numbers[b],
            normal=(first[5], first[6]),
            points=tuple((row[3], row[4]) for row in rows),
            penetration=max(row[9] for row in rows),
            restitution=mixed(e_rule, float(self._e[a]), float(self._e[b])),
            friction=mixed(mu_rule, float(self._mu[a]), float(self._mu[b])),
            normal_impulse=sum(row[7] for row in rows),
            tangent_impulse=sum(row[8] for row in rows),
        )


def _by_pair(world: World) -> Iterable[tuple[Pair, list[ContactRow]]]:
    """Yield each pair with its contacts, which stand side by side in the table."""
    in_use = world.contacts[: world.state.contact_count]
    for pair, contacts in groupby(in_use, key=lambda contact: (contact.a, contact.b)):
        yield pair, list(contacts)


def _touch(world: World, contacts: list[ContactRow], time: float) -> Touch:
    """Return the touch that a callback receives for one pair's contacts."""
    first = contacts[0]
    return Touch(
        time=time,
        body_a=first.a,
        body_b=first.b,
        normal=(first.nx, first.ny),
        points=tuple(
            contact_point(contact, world.bodies[contact.a], world.bodies[contact.b])
            for contact in contacts
        ),
        penetration=max(contact.penetration for contact in contacts),
        restitution=first.restitution,
        friction=first.friction,
    )
