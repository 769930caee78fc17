"""The billiards table: hand-worked contacts, laws over long runs, the faults 24 to 30."""

from __future__ import annotations

import math
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pymunk
import pytest
from tiers import share

from lesson_code.chapters.billiards.rules import (
    CUSHIONS,
    LAUNCH,
    MAX_LAUNCH_SPEED,
    TABLE,
    TIME_STEP,
    advance,
    bumper_contact,
    resolve,
    step,
    wall_contacts,
)
from lesson_code.formulas import bounce, scaled_reflection

ROUNDING = 1e-12
"""px and px/s relative to a few hundred: a few roundings."""

LONG_RUN_ROUNDING = 1e-9
"""The same after thousands of steps."""

SOURCE_LAUNCH = ((80.0, 80.0), (280.0, -180.0))
"""The launch of the lesson this workbook grew out of, which was to hit everything (fault 27)."""

SIN_45 = math.sqrt(0.5)


def shots(count: int, speed: float | None = None) -> Iterator[tuple[Any, Any]]:
    """Yield seeded random shots: a place clear of walls and bumper, and a velocity."""
    rng = np.random.default_rng(2024)
    while count:
        position = rng.uniform((12, 12), (588, 388))
        angle = rng.uniform(0, 2 * math.pi)
        size = rng.uniform(0, MAX_LAUNCH_SPEED) if speed is None else speed
        if bumper_contact(position) is None:
            yield position, size * np.array((math.cos(angle), math.sin(angle)))
            count -= 1


def crosses_middle_line(before: Any, after: Any) -> bool:
    """Return whether the way from one place to another crosses the bumper's middle line."""
    a, b = np.array(TABLE.bumper_start), np.array(TABLE.bumper_end)

    def side(p: Any, start: Any, end: Any) -> float:
        u, w = end - start, p - start
        return float(u[0] * w[1] - u[1] * w[0])

    apart = side(before, a, b) * side(after, a, b) < 0
    return apart and side(a, before, after) * side(b, before, after) < 0


def perpendicular_distance(position: Any) -> float:
    """Return the distance from the bumper's middle line, positive at the upper right."""
    return float(np.dot(np.subtract(position, TABLE.bumper_start), TABLE.bumper_normal))


# Walls


@pytest.mark.parametrize(
    ("position", "expected"),
    [
        pytest.param((300, 9), [("top", (0, 1), 3)], id="top"),
        pytest.param((300, 393), [("bottom", (0, -1), 5)], id="bottom"),
        pytest.param((5, 100), [("left", (1, 0), 7)], id="left"),
        pytest.param((589, 100), [("right", (-1, 0), 1)], id="right"),
        pytest.param((590, 2), [("top", (0, 1), 10), ("right", (-1, 0), 2)], id="corner"),
        pytest.param((-8, 100), [("left", (1, 0), 20)], id="centre outside"),
        pytest.param((12, 388), [], id="touching two"),
        pytest.param((100, 100), [], id="free"),
    ],
)
def test_wall_contacts_hand_worked_give_inward_normals_and_depth(
    position: tuple[float, float], expected: list[tuple[str, tuple[float, float], float]]
) -> None:
    """Every overlapping wall is found, in order, with its inward normal; touching is not enough."""
    measured = [(name, tuple(normal), depth) for name, normal, depth in wall_contacts(position)]
    assert measured == expected


# Bumper


def test_bumper_normal_is_the_lessons() -> None:
    """The bumper stands at 45 degrees: its normal is (sin 45, -cos 45), y down."""
    np.testing.assert_allclose(TABLE.bumper_normal, (SIN_45, -SIN_45), atol=ROUNDING)


@pytest.mark.parametrize(
    ("position", "normal"),
    [
        pytest.param((310, 190), (SIN_45, -SIN_45), id="upper right side"),
        pytest.param((290, 210), (-SIN_45, SIN_45), id="lower left side"),
        pytest.param((250, 150), (-SIN_45, -SIN_45), id="upper end, head on"),
        pytest.param((260, 145), (0, -1), id="upper end, from above"),
        pytest.param((355, 240), (1, 0), id="lower end, from the right"),
    ],
)
def test_bumper_contact_sides_and_ends_push_away_from_the_closest_point(
    position: tuple[float, float], normal: tuple[float, float]
) -> None:
    """Both sides and both round ends of the bumper push the ball away (fault 29)."""
    contact = bumper_contact(position)
    assert contact is not None
    np.testing.assert_allclose(contact[0], normal, atol=ROUNDING)
    distance = 15 if 0 in normal else math.hypot(10, 10)
    assert contact[1] == pytest.approx(20 - distance, abs=ROUNDING)


def test_bumper_contact_far_behind_is_none() -> None:
    """A ball 200 px behind the bumper is left alone: it is no half-plane (fault 28)."""
    behind = np.array((300.0, 200.0)) - 200 * np.array(TABLE.bumper_normal)
    assert bumper_contact(behind) is None
    velocity = 100 * np.array(TABLE.bumper_normal)
    assert step(behind, velocity)[2] == []


def test_bumper_contact_random_places_agree_with_pymunk() -> None:
    """Normal and depth are those of pymunk's Segment with the same radius."""
    segment = pymunk.Segment(
        pymunk.Body(body_type=pymunk.Body.STATIC),
        TABLE.bumper_start,
        TABLE.bumper_end,
        TABLE.bumper_half_thickness,
    )
    segment.cache_bb()
    rng = np.random.default_rng(7)
    overlapping = 0
    for position in rng.uniform((225, 125), (375, 275), (2000, 2)):
        contact = bumper_contact(position)
        info = segment.point_query(tuple(position))
        depth = TABLE.radius - info.distance
        assert (contact is not None) == (depth > 0)
        if contact is not None:
            overlapping += 1
            np.testing.assert_allclose(contact[0], info.gradient, atol=1e-9)
            assert contact[1] == pytest.approx(depth, abs=1e-9)
    assert overlapping > 500


def test_step_bumper_from_both_sides_sends_the_ball_back() -> None:
    """A shot straight at either side comes straight back with restitution times its speed."""
    normal = np.array(TABLE.bumper_normal)
    for side in (normal, -normal):
        position, velocity, hits = step((300, 200) + 21 * side, -300 * side)
        assert hits == ["bumper"]
        np.testing.assert_allclose(velocity, 0.95 * 300 * side, atol=ROUNDING * 300)
        np.testing.assert_allclose(position, (300, 200) + 20 * side, atol=ROUNDING * 300)


# One contact


def test_resolve_overlap_separates_first() -> None:
    """The ball just touches afterwards, also when it was leaving anyway (fault 7)."""
    for velocity in ((-100, 30), (100, 30)):
        position, _ = resolve((5, 200), velocity, (1, 0), 7)
        assert position.tolist() == [12, 200]


def test_resolve_random_contacts_keep_the_tangent_part() -> None:
    """Restitution acts along the normal; the part along the wall is kept to 1e-12 (fault 26)."""
    rng = np.random.default_rng(26)
    for angle, vx, vy in rng.uniform((0, -1, -1), (2 * math.pi, 1, 1), (500, 3)):
        n, v = np.array((math.cos(angle), math.sin(angle))), np.array((vx, vy))
        after = resolve((300, 100), v, n, 1.0)[1]
        tangent = np.array((-n[1], n[0]))
        assert after @ tangent == pytest.approx(v @ tangent, abs=ROUNDING)
        expected = -0.95 * (v @ n) if v @ n < 0 else v @ n
        assert after @ n == pytest.approx(expected, abs=ROUNDING)


def test_resolve_fault_26_gives_the_lessons_numbers() -> None:
    """(280, 180) becomes (280, -171) on a level floor: energy .9715 of what it was, not .9025."""
    before = np.array((280.0, 180.0))
    after = resolve((300, 390), before, (0, -1), 2)[1]
    np.testing.assert_allclose(after, (280, -171), atol=ROUNDING * 300)
    assert after @ after / (before @ before) == pytest.approx(0.9715, abs=5e-5)


# One step


@pytest.mark.parametrize(
    ("start", "names", "signs"),
    [
        pytest.param((14, 14), ["top", "left"], (-1, -1), id="top left"),
        pytest.param((586, 14), ["top", "right"], (1, -1), id="top right"),
        pytest.param((14, 386), ["bottom", "left"], (-1, 1), id="bottom left"),
        pytest.param((586, 386), ["bottom", "right"], (1, 1), id="bottom right"),
    ],
)
def test_step_corner_reflects_off_both_walls(
    start: tuple[float, float], names: list[str], signs: tuple[int, int]
) -> None:
    """A corner turns both components round in the same step (fault 30)."""
    velocity = np.array(signs) * (300.0, 240.0)
    _, after, hits = step(start, velocity)
    assert hits == names
    np.testing.assert_allclose(after, -0.95 * velocity, atol=ROUNDING * 300)


def test_step_inside_a_wall_moving_in_is_not_thrown_out() -> None:
    """A ball that overlaps a wall and moves inward keeps its velocity (fault 24)."""
    position, velocity, hits = step((6, 200), (60, 0))
    assert velocity.tolist() == [60, 0]
    assert hits == []
    assert position.tolist() == [12, 200]


def test_step_bumper_beside_a_wall_leaves_the_ball_inside(monkeypatch: pytest.MonkeyPatch) -> None:
    """The walls come last: a bumper that pushes the ball out of the table does not succeed."""
    narrow = replace(TABLE, bumper_start=(25.0, 100.0), bumper_end=(25.0, 300.0))
    monkeypatch.setattr("lesson_code.chapters.billiards.rules.TABLE", narrow)
    position, velocity, hits = step((14, 200), (60, 0))
    assert hits == ["bumper", "left"]
    assert position.tolist() == [12, 200]
    assert velocity[0] == pytest.approx(60 * 0.95**2)


def test_step_free_flight_is_a_straight_line() -> None:
    """Without a contact the ball moves by v dt, and its velocity is untouched."""
    position, velocity, hits = step((100, 100), (60, -120), dt=0.5)
    assert (position.tolist(), velocity.tolist(), hits) == ([130, 40], [60, -120], [])


def test_step_never_changes_its_inputs() -> None:
    """The arrays that are passed in stay as they are."""
    position, velocity = np.array((5.0, 5.0)), np.array((-100.0, -100.0))
    step(position, velocity)
    advance(position, velocity, 0.5)
    assert (position.tolist(), velocity.tolist()) == ([5, 5], [-100, -100])


# Time


def test_advance_one_second_equals_sixty_steps() -> None:
    """1 s at once, 60 frames of 1/60 s and 60 single steps give the same bits (fault 25)."""
    at_once = advance(*LAUNCH, 1.0)
    p, v = LAUNCH
    q, w = LAUNCH
    for _ in range(60):
        p, v, _, left_over = advance(p, v, 1 / 60)
        q, w, _ = step(q, w)
        assert left_over == 0
    assert at_once[0].tolist() == p.tolist() == q.tolist()
    assert at_once[1].tolist() == v.tolist() == w.tolist()
    assert at_once[3] == 0


@pytest.mark.parametrize("frames_per_second", [24, 30, 50, 60, 75, 144, 240, 1000])
def test_advance_any_frame_rate_gives_the_same_path(frames_per_second: int) -> None:
    """With the rest carried over, the path does not depend on the frame rate: bit for bit."""
    p, v, left_over = *LAUNCH, 0.0
    hits: list[str] = []
    for _ in range(4 * frames_per_second):
        p, v, new_hits, left_over = advance(p, v, left_over + 1 / frames_per_second)
        hits += new_hits
    expected = advance(*LAUNCH, 4.0)
    assert (p.tolist(), v.tolist(), hits) == (
        expected[0].tolist(),
        expected[1].tolist(),
        expected[2],
    )
    assert left_over == pytest.approx(0, abs=1e-12)


def test_advance_less_than_a_step_returns_the_time() -> None:
    """A frame too short for a step moves nothing and gives all of its time back."""
    position, velocity, hits, left_over = advance(*LAUNCH, 0.01)
    assert (tuple(position), tuple(velocity), hits, left_over) == (*LAUNCH, [], 0.01)


# Launches


def test_launch_within_eight_seconds_hits_all_five() -> None:
    """The first shot hits all four walls and the bumper: the fifth at step 230, 3.83 s."""
    assert set(advance(*LAUNCH, 230 * TIME_STEP)[2]) == set(CUSHIONS)
    assert set(advance(*LAUNCH, 229 * TIME_STEP)[2]) != set(CUSHIONS)


@pytest.mark.parametrize(("dvx", "dvy"), [(5, 0), (-5, 0), (0, 5), (0, -5)])
def test_launch_a_little_different_hits_all_five_too(dvx: float, dvy: float) -> None:
    """The first shot is no lucky one: 5 px/s more or less still hit all five within 8 s."""
    position, (vx, vy) = LAUNCH
    assert set(advance(position, (vx + dvx, vy + dvy), 8.0)[2]) == set(CUSHIONS)


def test_source_launch_scaled_reflection_never_hits_the_bumper() -> None:
    """With the source's e R its own launch misses the bumper for 300 s, by 18 px (fault 27).

    e R keeps the direction of the mirror image, so the ball stays on the path of a table
    without loss, and that path goes round the bumper.
    """
    p, v = (np.array(part) for part in SOURCE_LAUNCH)
    nearest = math.inf
    for _ in range(300 * 60):
        p = p + v * TIME_STEP
        for _, normal, depth in wall_contacts(p):
            p, v = p + depth * normal, scaled_reflection(v, normal, TABLE.restitution)
        a, b = np.array(TABLE.bumper_start), np.array(TABLE.bumper_end)
        part = np.clip((p - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
        nearest = min(nearest, math.hypot(*(p - a - part * (b - a))) - 20)
    assert nearest == pytest.approx(18.6, abs=0.1)


def test_source_launch_on_this_table_needs_38_seconds() -> None:
    """With the right restitution the same launch finds the bumper, but only after 38 s."""
    assert "bumper" not in advance(*SOURCE_LAUNCH, 38.4)[2]
    assert "bumper" in advance(*SOURCE_LAUNCH, 38.5)[2]


# Long runs


def test_step_long_random_runs_stay_inside_and_never_gain_energy() -> None:
    """Shots for 10 s: the ball never leaves the table, and its speed never grows."""
    low, high = np.array((12.0, 12.0)), np.array((588.0, 388.0))
    for position, velocity in shots(share(40)):
        p, v = position, velocity
        for _ in range(600):
            speed = math.hypot(*v)
            p, v, hits = step(p, v)
            assert (p >= low - LONG_RUN_ROUNDING).all()
            assert (p <= high + LONG_RUN_ROUNDING).all()
            assert math.hypot(*v) <= speed * (1 + ROUNDING)
            assert hits or math.hypot(*v) == speed
            contact = bumper_contact(p)
            assert contact is None or contact[1] < LONG_RUN_ROUNDING


def test_max_launch_speed_is_less_than_the_bumpers_reach_a_step() -> None:
    """0.9 (radius + half thickness) / dt: 18 px a step, where 20 px would reach the middle line."""
    assert pytest.approx(1080) == MAX_LAUNCH_SPEED
    assert TABLE.radius + TABLE.bumper_half_thickness > MAX_LAUNCH_SPEED * TIME_STEP


def test_step_at_max_launch_speed_never_passes_the_bumper() -> None:
    """Aimed at the bumper from anywhere and at top speed, no step crosses its middle line."""
    rng = np.random.default_rng(11)
    count, hit = share(2000), 0
    for position, _ in shots(count):
        target = np.array(TABLE.bumper_start) + rng.uniform() * 80
        away = target - position
        p, v = position, away * (MAX_LAUNCH_SPEED / math.hypot(*away))
        for _ in range(math.ceil(math.hypot(*away) / 18)):
            before = p
            p, v, hits = step(p, v)
            assert not crosses_middle_line(before, p)
            if hits:
                break
        hit += "bumper" in hits
    assert hit == count


def test_step_far_above_max_launch_speed_does_pass_the_bumper() -> None:
    """The limit is needed: at 2.5 times that speed a step jumps over the bumper unseen."""
    normal = np.array(TABLE.bumper_normal)
    position, _, hits = step((300, 200) + 22 * normal, -2.5 * MAX_LAUNCH_SPEED * normal)
    assert hits == []
    assert perpendicular_distance(position) < -20


# The door


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: wall_contacts((math.nan, 1)), r"position must be finite, got nan"),
        (lambda: wall_contacts((1, 2, 3)), r"position must have shape .*got shape \(3,\)"),
        (lambda: bumper_contact((1, math.inf)), r"position must be finite, got inf"),
        (lambda: bumper_contact(((1, 2),)), r"position must have shape \(2,\)"),
        (lambda: resolve((0, 0), (0, 0), (1, 1), 1), r"normal must be a unit vector.*got length"),
        (lambda: resolve((0, 0), (0, 0), (1, 0), -1), r"depth must be >= 0 .*got -1"),
        (lambda: resolve((0, 0), (math.nan, 0), (1, 0), 1), r"velocity must be finite, got nan"),
        (lambda: step((0, 0), (0, 0), -0.1), r"dt must be >= 0 and finite, got -0.1"),
        (lambda: step((0, 0), (0, 0), [0.1, 0.2]), r"dt must be one number, got shape \(2,\)"),
        (lambda: advance((0, 0), (0, 0), math.nan), r"elapsed must be >= 0 .*got nan"),
        (lambda: advance((0, 0), (0, 0), math.inf), r"elapsed must be >= 0 .*got inf"),
    ],
)
def test_bad_input_is_refused_by_name(call: Any, message: str) -> None:
    """The error names the argument, the rule and the value."""
    with pytest.raises(ValueError, match=message):
        call()


def test_all_contacts_go_through_the_one_bounce(monkeypatch: pytest.MonkeyPatch) -> None:
    """Walls and bumper use lesson_code.formulas.bounce and nothing else."""
    calls = []

    def noted(velocity: Any, normal: Any, restitution: float) -> Any:
        calls.append(tuple(normal))
        return bounce(velocity, normal, restitution)

    monkeypatch.setattr("lesson_code.chapters.billiards.rules.bounce", noted)
    hits = advance(*LAUNCH, 8.0)[2]
    assert set(hits) == set(CUSHIONS)
    assert len(calls) >= len(hits)


def test_importing_the_table_imports_no_pygame() -> None:
    """The table is graded and read where no pygame is wanted."""
    program = (
        "import sys, lesson_code, lesson_code.chapters.billiards.rules; "
        "sys.exit('pygame' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0
