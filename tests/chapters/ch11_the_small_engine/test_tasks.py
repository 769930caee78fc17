"""The tasks of chapter 11: what they expect is what the engine does, and what is drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import combinations
from random import Random

import numpy as np
import pytest

from lesson_code.chapters.ch11_the_small_engine import tasks
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.task import Arguments
from lesson_code.engine.core.callbacks import Callbacks, Touch
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.live_world import LiveWorld
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
touch_changes = task_by_id("11.4").expected
glow = task_by_id("11.5").expected
knock = task_by_id("11.6").expected


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


def test_wall_that_is_hit_keeps_its_velocity() -> None:
    """Infinite mass and moment of inertia: all that the wall does not take, the body does."""
    walls = [given for given in drawn(tasks.beside_the_centres) if given[0][0] == np.inf]
    assert walls
    for a, arm_a, b, arm_b, n, e, _ in walls:
        v_a, w_a, v_b, w_b = hit(a, arm_a, b, arm_b, n, e, 0.0)
        assert [*v_a, w_a] == list(a[2:])
        at_a, at_b = (
            np.array(v) + w * np.array([-arm[1], arm[0]])
            for v, w, arm in ((v_a, w_a, arm_a), (v_b, w_b, arm_b))
        )
        before = np.array(b[2:4]) + b[4] * np.array([-arm_b[1], arm_b[0]]) - at_a
        assert (at_b - at_a) @ n == pytest.approx(-e * (before @ n), abs=1e-9)


def test_touches_expected_are_those_the_engine_tells() -> None:
    """A live world's own callbacks, while discs hit each other between walls."""
    told: dict[str, set[tuple[int, int]]] = {"begin": set(), "separate": set()}

    def note(kind: str) -> Callable[[Touch], None]:
        return lambda touch: told[kind].add(tuple(sorted((touch.body_a, touch.body_b))))

    listener = Callbacks(begin=note("begin"), separate=note("separate"))
    soft = Material(0.0, 0.5)
    discs = [
        Body(Circle(0.5), mass=1.0, position=(1.5 * k, 3.0), velocity=(1.0 - k, 0), material=soft)
        for k in range(4)
    ]
    floor = box(12.0, 9.0, soft)
    world = LiveWorld([*floor, *discs], gravity=(0.0, -9.81), callbacks=listener)
    before: set[tuple[int, int]] = set()
    changes = 0
    for _ in range(240):
        for kind in told.values():
            kind.clear()
        world.step()
        now = (before | told["begin"]) - told["separate"]
        begun, parted = touch_changes(sorted(before), sorted(now))
        assert {tuple(pair) for pair in begun} == told["begin"] - told["separate"]
        assert {tuple(pair) for pair in parted} == told["separate"] & before
        changes, before = changes + len(begun) + len(parted), now
    assert changes >= 4


def test_light_expected_is_halved_after_every_half_life_by_any_steps() -> None:
    """One step of three half-lives, and thirty of a tenth each: an eighth is left."""
    assert glow((0.8, 0.3), (0, 1), 0.6, 0.2) == pytest.approx([0.1, 1.0], abs=ROUNDING)
    light = [0.8]
    for _ in range(30):
        light = glow(light, (0,), 0.02, 0.2)
    assert light == pytest.approx([0.1], abs=ROUNDING)


def test_sound_expected_is_that_of_a_damped_spring() -> None:
    """By differences, x'' + 2 c x' + (w^2 + c^2) x = 0 holds for exp(-c t) sin(w t)."""
    rate, half_life, frequency = 1e5, 0.02, 440.0
    x = np.array(knock(0.7, frequency, half_life, rate, 2000))
    w, c, h = 2 * np.pi * frequency, np.log(2) / half_life, 1 / rate
    acceleration = (x[2:] - 2 * x[1:-1] + x[:-2]) / h**2
    velocity = (x[2:] - x[:-2]) / (2 * h)
    left_over = acceleration + 2 * c * velocity + (w * w + c * c) * x[1:-1]
    largest_term = w * w * 0.7
    assert np.abs(left_over).max() < (w * h) ** 2 / 6 * largest_term  # of second order in h
    assert x[0] == 0.0
    assert x[1] > 0


def test_tone_that_is_too_high_would_be_heard_as_a_lower_one() -> None:
    """Samples of f and of rate - f differ in their sign alone, so there is silence instead."""
    k = np.arange(9)
    np.testing.assert_allclose(
        np.sin(2 * np.pi * 600 * k / 1000), -np.sin(2 * np.pi * 400 * k / 1000), atol=ROUNDING
    )
    assert knock(0.5, 600, 0.1, 1000, 9) == [0.0] * 9
    assert knock(0.5, 500, 0.1, 1000, 9) == [0.0] * 9
    assert any(knock(0.5, 499, 0.1, 1000, 9))


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
        assert all(hit(*given)[3] != given[2][4] for given in drawn(cases))


def test_drawn_boxes_have_pairs_and_others() -> None:
    """Who names all pairs, or none, earns nothing."""
    for cases in (tasks.apart_in_one_direction, tasks.crossed_and_nested, tasks.many_boxes):
        for (boxes,) in drawn(cases):
            assert 0 < len(near_pairs(boxes)) < len(boxes) * (len(boxes) - 1) / 2


def test_drawn_discs_meet_one_at_a_time_or_have_two_partners() -> None:
    """The order of the pairs makes no difference but in two scenes, where a disc is in two pairs.

    In one, no two of a pair are neighbours. In the other, the last two of a row meet only where the
    pairs before have left them.
    """
    meeting = [overlaps(world) for world in drawn(tasks.discs_that_meet)]
    assert meeting[2::3] == [[(0, 2), (0, 4), (1, 3)]] * (len(meeting) // 3)
    one_by_one = [*meeting[::3], *meeting[1::3], *map(overlaps, drawn(tasks.all_at_once)[::2])]
    for found in one_by_one:
        met = [disc for pair in found for disc in pair]
        assert found
        assert len(met) == len(set(met))
    for world in drawn(tasks.all_at_once)[1::2]:
        assert overlaps(world) == [(0, 1), (1, 2), (4, 5)]
        p, _ = step_discs(*map(np.asarray, world))
        reach = world[3][2] + world[3][3]
        assert np.hypot(*(p[3] - p[2])) == pytest.approx(reach, abs=ROUNDING)


def overlaps(world: Arguments) -> list[tuple[int, int]]:
    """Return the pairs of discs that overlap once all have moved."""
    p, v, _, radii, _, _, _, dt = world
    places = np.array(p) + np.array(v) * dt
    return [
        (i, j)
        for i, j in combinations(range(len(radii)), 2)
        if np.hypot(*(places[i] - places[j])) < radii[i] + radii[j]
    ]


# What is said


def test_messages_say_why() -> None:
    """What becomes of the momentum."""
    body = (2.0, 1.0, 3.0, 0.0, 0.0)
    given: Arguments = (body, (1, 0), (1.0, 1.0, 0.0, 0.0, 0.0), (-1, 0), (1.0, 0.0), 1.0, 0.0)
    told = tasks.momentum_of_both(given, ((0.0, 0.0), 0.0, (1.0, 0.0), 0.0))
    assert told == "Momentum (6, 0) kg m/s before and (1, 0) after."
