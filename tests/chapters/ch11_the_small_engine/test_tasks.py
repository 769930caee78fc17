"""The tasks of chapter 11: what they expect is what the engine does, and what is drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from random import Random

import numpy as np
import pytest

from lesson_code.chapters.ch11_the_small_engine import tasks
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import Arguments
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.small_engine import hit as small_hit
from lesson_code.engine.small_engine import mover_of, simulate_small
from lesson_code.evidence.scenes.events import box
from lesson_code.geometry.shapes import Circle
from lesson_code.reference.contact_closed_forms import Struck, impact_with_friction

ROUNDING = 1e-12
"""The numbers below are of order 1 to 100, and each is the result of a few dozen operations."""

STREAMS = [Random(seed) for seed in range(60)]  # noqa: S311 - not for secrets

near_pairs = task_by_id("11.1").expected
hit = task_by_id("11.2").expected
step_discs = task_by_id("11.3").expected


def drawn(cases: Callable[[Random], Iterable[Arguments]]) -> list[Arguments]:
    """Return what a criterion draws, over many seeds."""
    return [arguments for stream in STREAMS for arguments in cases(stream)]


# What is expected


def test_pairs_expected_are_worked_by_hand() -> None:
    """Two that overlap, one that touches the first along an edge, one above it."""
    boxes = ((0, 2, 0, 2), (1, 3, 1, 3), (2, 4, -1, 0.5), (0, 2, 5, 6))
    assert near_pairs(boxes) == [(0, 1), (0, 2)]


def test_hit_expected_is_the_small_engines() -> None:
    """Of discs whose arms are their radii, with spin and friction."""
    for a, arm_a, b, arm_b, n, e, mu in drawn(tasks.rough_bodies)[:40]:
        surface = Material(e, mu)
        movers = [
            mover_of(
                Body(
                    Circle(1),
                    mass=mass,
                    inertia=inertia,
                    velocity=(vx, vy),
                    angular_velocity=w,
                    position=(-arm[0], -arm[1]),
                    material=surface,
                )
            )
            for (mass, inertia, vx, vy, w), arm in ((a, arm_a), (b, arm_b))
        ]
        small_hit(movers[0], movers[1], np.zeros(2), np.array(n), 0.0)
        v_a, w_a, v_b, w_b = hit(a, arm_a, b, arm_b, n, e, mu)
        np.testing.assert_allclose(
            [*v_a, w_a, *v_b, w_b],
            [*movers[0].velocity, movers[0].w, *movers[1].velocity, movers[1].w],
            atol=ROUNDING,
        )


def test_hit_expected_of_smooth_bodies_is_the_closed_form() -> None:
    """Without friction there is one right answer, and it comes from elsewhere."""
    for a, arm_a, b, arm_b, n, e, mu in drawn(tasks.beside_the_centres):
        first, second = (
            Struck(1 / body[0], 1 / body[1], body[2:4], body[4], arm)
            for body, arm in ((a, arm_a), (b, arm_b))
        )
        right = impact_with_friction(first, second, n, e, mu)
        v_a, w_a, v_b, w_b = hit(a, arm_a, b, arm_b, n, e, mu)
        np.testing.assert_allclose([v_a, v_b], right.velocities, atol=ROUNDING)
        np.testing.assert_allclose([w_a, w_b], right.angular_velocities, atol=ROUNDING)


@pytest.mark.parametrize("cases", [tasks.free_discs, tasks.discs_that_meet])
def test_step_expected_is_the_small_engines(
    cases: Callable[[Random], Iterable[Arguments]],
) -> None:
    """Smooth discs in a room: away from the walls the two steps are the same."""
    for p, v, masses, radii, e, gravity, room, dt in drawn(cases)[:20]:
        surface = Material(e, 0.0)
        discs = [
            Body(Circle(r), mass=m, position=x, velocity=u, material=surface)
            for x, u, m, r in zip(p, v, masses, radii, strict=True)
        ]
        scene = Scene([*box(room[0], room[1], surface), *discs], gravity=gravity)
        after = simulate_small(scene, dt, dt=dt, sample="end")
        positions, velocities = step_discs(p, v, masses, radii, e, gravity, room, dt)
        np.testing.assert_allclose(positions, after.positions[-1, 4:], atol=ROUNDING)
        np.testing.assert_allclose(velocities, after.velocities[-1, 4:], atol=ROUNDING)


def test_step_expected_at_walls_by_hand() -> None:
    """Out through the left wall at 2 m/s, e = 1/2; and one that comes back in already."""
    positions, velocities = step_discs(
        ((0.4, 2.0), (0.3, 6.0)), ((-2.0, 1.0), (2.0, 0.0)), (1, 1), (0.5, 0.5), 0.5, (0, 0),
        (9, 9), 0.1,
    )  # fmt: skip
    np.testing.assert_allclose(positions, [(0.5, 2.1), (0.5, 6.0)], atol=ROUNDING)
    np.testing.assert_allclose(velocities, [(1.0, 1.0), (2.0, 0.0)], atol=ROUNDING)


# What is drawn


def test_drawn_hits_slide_and_grip() -> None:
    """Of the rough ones half slide on at Coulomb's limit, and half stop sliding."""
    slides = []
    for a, arm_a, b, arm_b, n, e, mu in drawn(tasks.rough_bodies):
        v_a, w_a, v_b, w_b = hit(a, arm_a, b, arm_b, n, e, mu)
        t = np.array([-n[1], n[0]])
        turned = [w * np.array([-arm[1], arm[0]]) for w, arm in ((w_a, arm_a), (w_b, arm_b))]
        slides.append(abs((v_b + turned[1] - v_a - turned[0]) @ t) > 1e-6)
    assert slides.count(False) >= len(slides) / 3
    assert slides.count(True) >= len(slides) / 3


def test_drawn_hits_approach_where_they_should() -> None:
    """Two of three of the parting ones are left alone; all others change."""
    changed = [hit(*given)[1] != given[0][4] for given in drawn(tasks.parting_bodies)]
    assert changed == [False, False, True] * (len(changed) // 3)
    for cases in (tasks.beside_the_centres, tasks.rough_bodies):
        assert all(hit(*given)[1] != given[0][4] for given in drawn(cases))


def test_drawn_boxes_have_pairs_and_others() -> None:
    """Who names all pairs, or none, earns nothing."""
    for cases in (tasks.apart_in_one_direction, tasks.crossed_and_nested, tasks.many_boxes):
        for (boxes,) in drawn(cases):
            assert 0 < len(near_pairs(boxes)) < len(boxes) * (len(boxes) - 1) / 2


def test_drawn_discs_meet_one_at_a_time() -> None:
    """The order of the pairs makes no difference, so nobody loses points by it."""
    for cases in (tasks.discs_that_meet, tasks.all_at_once):
        for p, v, _, radii, _, _, _, dt in drawn(cases):
            places = np.array(p) + np.array(v) * dt
            overlaps = [
                (i, j)
                for i in range(len(radii))
                for j in range(i)
                if np.hypot(*(places[i] - places[j])) < radii[i] + radii[j]
            ]
            met = [disc for pair in overlaps for disc in pair]
            assert overlaps
            assert len(met) == len(set(met))


# What is said


def test_messages_say_why() -> None:
    """What becomes of the momentum."""
    body = (2.0, 1.0, 3.0, 0.0, 0.0)
    given: Arguments = (body, (1, 0), (1.0, 1.0, 0.0, 0.0, 0.0), (-1, 0), (1.0, 0.0), 1.0, 0.0)
    told = tasks.momentum_of_both(given, ((0.0, 0.0), 0.0, (1.0, 0.0), 0.0))
    assert told == "Momentum (6, 0) kg m/s before and (1, 0) after."
