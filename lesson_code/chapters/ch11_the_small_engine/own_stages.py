"""Stages of a step that asks a reader's functions: each turns bodies into a task's arguments."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from lesson_code.chapters.ch11_the_small_engine import own_answers as answers
from lesson_code.chapters.ch11_the_small_engine.own_manifold import disc_manifold, manifold_of
from lesson_code.engine.small_engine import (
    OURS,
    Mover,
    Parts,
    box_of,
    corners_of,
    numbers_near,
    push,
    surfaces,
)
from lesson_code.formulas import (
    contact_velocity,
    effective_mass,
    friction_impulse,
    normal_impulse,
)
from lesson_code.formulas.arithmetic import cross, dot, perpendicular
from lesson_code.geometry import Circle, Manifold, mtv

if TYPE_CHECKING:
    from lesson_code.chapters.ch11_the_small_engine.own_engine import OwnEngine


class OwnStages:
    """What a step of the small engine calls, with the reader's functions inside.

    Parameters
    ----------
    engine : OwnEngine
        Asks the functions.
    dt : float
        s, of a step.
    """

    def __init__(self, engine: OwnEngine, dt: float) -> None:
        self._engine, self._dt = engine, dt
        self.parts = Parts(self.pairs_near, self.contact, self.hit, self.separate)

    def pairs_near(self, bodies: list[Mover]) -> Iterator[tuple[Mover, Mover]]:
        """Yield the pairs that the broad phase finds."""
        self._engine.time += self._dt

        def form(answer: Any) -> set[tuple[int, int]]:
            pairs = [(i, j) for i, j in answers.pairs(answer) if i >= 0]
            return {(i, j) for i, j in pairs if bodies[i].inv_m + bodies[j].inv_m > 0}

        def same(theirs: Any, ours: Any) -> bool:  # they may leave out what does not meet, and add
            left_out = ours - theirs
            return all(OURS.contact(bodies[i], bodies[j]) is None for i, j in left_out)

        found = self._engine.ask(
            "near_pairs",
            np.array([box_of(body) for body in bodies]),
            form=form,
            right=lambda: set(numbers_near(bodies)),
            same=same,
        )
        for i, j in sorted(found):
            yield bodies[i], bodies[j]

    def contact(self, a: Mover, b: Mover) -> Manifold | None:
        """Return where two bodies overlap, as the functions of chapters 04 and 06 see it."""
        right = OURS.contact(a, b)
        if isinstance(a.body.shape, Circle) and isinstance(b.body.shape, Circle):
            return self._of_discs(a, b, right)
        if isinstance(a.body.shape, Circle):
            turned = self._of_disc(b, a, _turned(right))
            return _turned(turned)
        if isinstance(b.body.shape, Circle):
            return self._of_disc(a, b, right)
        return self._of_polygons(a, b, right)

    def _of_discs(self, a: Mover, b: Mover, right: Manifold | None) -> Manifold | None:
        """Return where two discs overlap."""
        given = (a.position, _radius(a), b.position, _radius(b))
        found = self._engine.ask(
            "circle_contact", *given, form=answers.way_out, right=lambda: _way_out(right)
        )
        return _as_manifold(found, b)

    def _of_disc(self, a: Mover, b: Mover, right: Manifold | None) -> Manifold | None:
        """Return where a polygon a and a disc b overlap."""
        given = (b.position, _radius(b), corners_of(a))
        found = self._engine.ask(
            "circle_against_polygon", *given, form=answers.way_out, right=lambda: _way_out(right)
        )
        return _as_manifold(found, b)

    def _of_polygons(self, a: Mover, b: Mover, right: Manifold | None) -> Manifold | None:
        """Return where two polygons overlap: an edge of one, clipped at the ends of the other's."""
        corners = corners_of(a), corners_of(b)
        found = self._engine.ask("mtv", *corners, form=answers.way_out, right=lambda: mtv(*corners))
        if found is None:
            return None
        normal, _ = found
        if not self._engine.functions["clip"].is_own:
            return right and replace(right, normal=normal)
        return manifold_of(normal, *corners, self._clip)

    def _clip(self, start: Any, end: Any, normal: Any, offset: float) -> Any:
        """Return the part of a segment on the inner side of a line, or None."""
        return self._engine.ask(
            "clip",
            *(start, end, normal, offset),
            form=answers.segment,
            right=lambda: None,
            same=lambda *_: True,  # the narrow phase of ours clips in another way
        )

    def hit(self, a: Mover, b: Mover, point: Any, normal: Any, depth: float) -> None:
        """Bounce two bodies off each other at a point."""
        if not self._engine.functions["hit"].is_own:
            return self._hit_of_chapter_05(a, b, point, normal, depth)
        arms = _arms(a, b, point, normal, depth)
        rows = [np.array([*_matter(body), *body.velocity, body.w]) for body in (a, b)]
        given = (rows[0], arms[0], rows[1], arms[1], normal, *surfaces(a, b))

        def right() -> Any:
            struck = replace(a), replace(b)
            OURS.hit(*struck, point, normal, depth)
            return struck[0].velocity, struck[0].w, struck[1].velocity, struck[1].w

        after = self._engine.ask("hit", *given, form=answers.motions, right=right)
        a.velocity, a.w, b.velocity, b.w = after
        return None

    def _hit_of_chapter_05(self, a: Mover, b: Mover, point: Any, normal: Any, depth: float) -> None:
        """Bounce them off each other by the functions of chapter 05."""
        arms = _arms(a, b, point, normal, depth)
        e, mu = surfaces(a, b)
        v, k = self._approach(a, b, arms, normal)
        jn = float(normal_impulse(v, 1 / k, e))
        push(a, b, *arms, jn * normal)
        tangent = perpendicular(normal)
        v, k = self._approach(a, b, arms, tangent)
        jt = self._engine.ask(
            "friction_impulse", v, jn, mu, k,
            form=answers.number, right=lambda: float(friction_impulse(v, 1 / k, mu, jn)),
        )  # fmt: skip
        push(a, b, *arms, jt * tangent)

    def _approach(
        self, a: Mover, b: Mover, arms: tuple[Any, Any], along: Any
    ) -> tuple[float, float]:
        """Return the relative velocity at a contact along a direction, and how far it gives way."""
        points = [self._velocity_at(body, arm) for body, arm in zip((a, b), arms, strict=True)]
        (m_a, i_a), (m_b, i_b) = _matter(a), _matter(b)
        inverses = (a.inv_m, b.inv_m, a.inv_i, b.inv_i)
        levers = cross(arms[0], along), cross(arms[1], along)
        k = self._engine.ask(
            "inverse_effective_mass",
            *(m_a, i_a, arms[0], m_b, i_b, arms[1], along),
            form=answers.positive_number,
            right=lambda: 1 / float(effective_mass(*inverses, *levers)),
        )
        return float(dot(points[1] - points[0], along)), k

    def _velocity_at(self, body: Mover, arm: Any) -> Any:
        """Return the velocity of the point at an arm from the centre."""
        given = (body.velocity, body.w, arm)
        return self._engine.ask(
            "contact_velocity", *given, form=answers.vector, right=lambda: contact_velocity(*given)
        )

    def separate(self, a: Mover, b: Mover, normal: Any, depth: float) -> None:
        """Move two bodies apart."""

        def right() -> Any:
            apart = replace(a), replace(b)
            OURS.separate(*apart, normal, depth)
            return apart[0].position, apart[1].position

        given = (a.position, _matter(a)[0], b.position, _matter(b)[0], normal, depth)
        found = self._engine.ask("separate", *given, form=answers.two_vectors, right=right)
        a.position, b.position = found


def _arms(a: Mover, b: Mover, point: Any, normal: Any, depth: float) -> tuple[Any, Any]:
    """Return what leads from each centre to its own surface."""
    half = depth / 2 * normal
    return point + half - a.position, point - half - b.position


def _matter(body: Mover) -> tuple[float, float]:
    """Return mass and moment of inertia; infinite for what nothing can push or turn."""
    mass, inertia = (1 / value if value else math.inf for value in (body.inv_m, body.inv_i))
    return mass, inertia


def _radius(body: Mover) -> float:
    """Return the radius of a disc."""
    return float(body.body.shape.bounding_radius)


def _way_out(found: Manifold | None) -> tuple[Any, float] | None:
    """Return normal and depth."""
    return None if found is None else (found.normal, float(found.penetrations.max()))


def _as_manifold(found: tuple[Any, float] | None, disc: Mover) -> Manifold | None:
    """Return the manifold of a disc that lies where the normal points to."""
    return None if found is None else disc_manifold(*found, disc.position, _radius(disc))


def _turned(found: Manifold | None) -> Manifold | None:
    """Return a manifold with the normal from b to a."""
    return None if found is None else replace(found, normal=-found.normal)
