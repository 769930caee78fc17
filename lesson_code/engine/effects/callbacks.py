"""Callbacks: a scene's own functions are told of its contacts, pair by pair."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby
from typing import TypeAlias

from lesson_code.engine.core.callbacks import Callback, Callbacks, Touch
from lesson_code.engine.core.contact_motion import contact_point
from lesson_code.engine.core.rows import ContactRow, World
from lesson_code.engine.effects.question import Effect, Finding, Question
from lesson_code.formulas.validation import non_negative, one_number, one_vector

Pair: TypeAlias = tuple[int, int]
XY: TypeAlias = tuple[float, float]


def rule(question: Question) -> Finding:
    """Ask whether the scene wants to be told of contacts."""
    wanted = question.scene.callbacks.wanted
    return Finding(wanted, "the scene asks to be told" if wanted else "the scene has none")


EFFECT = Effect(rule=rule, place=150, functions=("before_impulses", "after_impulses"))


class TouchListener:
    """Follows which pairs touch, and calls a scene's callbacks in the order of the contacts."""

    def __init__(self, callbacks: Callbacks) -> None:
        self._callbacks = callbacks
        self._gravity: XY | None = None
        self._touching: dict[Pair, Touch] = {}
        self._parted: list[Touch] = []

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

    def _call(self, callback: Callback | None, touch: Touch) -> None:
        """Call a callback, if there is one, and see whether it has changed gravity."""
        if callback is not None:
            callback(touch)
        if touch.gravity is not None:
            x, y = one_vector("gravity", touch.gravity)
            self._gravity, touch.gravity = (float(x), float(y)), None


def _by_pair(world: World) -> Iterable[tuple[Pair, list[ContactRow]]]:
    """Yield each pair with its contacts, which stand side by side in the table."""
    in_use = world.contacts[: world.state.contact_count]
    for pair, contacts in groupby(in_use, key=lambda contact: (contact.a, contact.b)):
        yield pair, list(contacts)


def _touch(world: World, contacts: list[ContactRow], time: float) -> Touch:
    """Return what a callback is told of one pair's contacts."""
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
