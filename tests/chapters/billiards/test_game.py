"""The billiards program, headless: repeatable runs, inputs, errors, the picture, the solution."""

from __future__ import annotations

import importlib.util
import math
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
from tiers import share

from lesson_code.chapters.billiards import rules as billiards_table
from lesson_code.chapters.billiards.game import CLOTH, PROGRAM, Billiards, draw, readings
from lesson_code.chapters.billiards.rules import (
    CUSHIONS,
    LAUNCH,
    MAX_LAUNCH_SPEED,
    TABLE,
    TIME_STEP,
)
from lesson_code.view.pygame.frame import play
from lesson_code.view.pygame.game import Input
from lesson_code.view.pygame.painter import Painter
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.program import ImpactEffects
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.window import PURPLE, Window, pygame

SOLUTION = Path(__file__).parents[3] / "solutions" / "billiards.py"

AGREEMENT = 1e-9
"""px and px/s: the solution adds in another order, so that roundings differ."""


@pytest.fixture(scope="module")
def solution() -> ModuleType:
    """Return solutions/billiards.py as a module."""
    spec = importlib.util.spec_from_file_location("solution_billiards", SOLUTION)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.fixture
def picture(program_window: Window) -> Picture:
    """Return an empty picture of the table."""
    one = Picture(program_window, PROGRAM.camera)
    one.clear()
    return one


def game(velocity: tuple[float, float] = (0.0, 0.0)) -> Billiards:
    """Return a game whose ball lies at (100, 100)."""
    return Billiards(launch=((100.0, 100.0), velocity))


def run(one: Billiards, steps: int) -> None:
    """Let time pass."""
    for _ in range(steps):
        one.step()


def drag(one: Billiards, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Press, move and release the mouse."""
    for kind, place in (("down", start), ("move", end), ("up", end)):
        one.take(Input(kind, place=place))


# Runs


def test_play_headless_equals_the_tables_own_advance() -> None:
    """300 frames of the program are 300 steps of the table: bit for bit."""
    played = play(PROGRAM, frames=300, headless=True).game
    position, velocity, hits, _ = billiards_table.advance(*LAUNCH, 300 * TIME_STEP)
    assert played.snapshot().tolist() == [position.tolist(), velocity.tolist()]
    assert isinstance(played, Billiards)
    assert played.bounces == {name: hits.count(name) for name in CUSHIONS}


def test_play_with_a_seed_begins_with_the_shot_that_it_draws() -> None:
    """From the usual place at the usual speed; seed 0 is the lesson's own shot."""
    first, other = Billiards(0), Billiards(5)
    assert first.snapshot().tolist() == [list(LAUNCH[0]), list(LAUNCH[1])]
    assert other.position.tolist() == list(LAUNCH[0])
    assert other.velocity.tolist() != list(LAUNCH[1])
    assert math.hypot(*other.velocity) == pytest.approx(math.hypot(*LAUNCH[1]))


def test_play_twice_gives_the_same_picture(tmp_path: Path) -> None:
    """The same run twice ends the same, down to the bytes of the picture."""
    pictures = [tmp_path / "one.png", tmp_path / "two.png"]
    for path in pictures:
        play(PROGRAM, frames=100, headless=True, screenshot=path)
    assert pictures[0].read_bytes() == pictures[1].read_bytes()


def test_tour_launches_the_ball_as_a_hand_would() -> None:
    """The ball waits for the drag, which gives it the first shot's velocity again."""
    played = play(PROGRAM, frames=46, headless=True, tour=True).game
    assert isinstance(played, Billiards)
    assert played.time == pytest.approx(TIME_STEP)
    assert played.velocity.tolist() == list(LAUNCH[1])


def test_unfinished_task_stands_still_and_is_named() -> None:
    """The window says which function is missing, and goes on when it is there."""
    told = ["Task B.4: step", "", None]

    def advance(position: Any, velocity: Any, elapsed: float) -> Any:
        words = told.pop(0)
        if words is not None:
            raise NotImplementedError(words)
        return billiards_table.advance(position, velocity, elapsed)

    one, notices = Billiards(advance=advance), []
    for _ in range(3):
        one.step()
        notices.append(one.notice)
    assert notices == ["not written yet: Task B.4: step", "not written yet: advance", ""]
    assert one.time == pytest.approx(TIME_STEP)


@pytest.mark.parametrize(
    ("launch", "message"),
    [
        (((1, 1), (2000, 0)), "launch speed must be <= 1080 px/s"),
        (((math.nan, 1), (0, 0)), "launch position must be finite"),
    ],
)
def test_launch_that_is_none_is_refused(launch: Any, message: str) -> None:
    """The error names the argument, the rule and the value."""
    with pytest.raises(ValueError, match=message):
        Billiards(launch=launch)


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (None, "advance must return .*got None"),
        (((1, 2), (3, 4), []), "advance must return"),
        (((1, math.nan), (3, 4), [], 0.0), "position from advance must be finite"),
        (((1, 2), (3, 4, 5), [], 0.0), "velocity from advance must have shape"),
        (((1, 2), (3, 4), ["north"], 0.0), "hits from advance must be a list .*north"),
        (((1, 2), (3, 4), None, 0.0), "hits from advance must be a list"),
        (((1, 2), (3, 4), [], -1.0), "left_over from advance must be >= 0"),
    ],
)
def test_nonsense_from_a_students_advance_is_named(answer: Any, message: str) -> None:
    """What a student's function returns is checked, and the error says what was expected."""
    with pytest.raises(ValueError, match=message):
        play(PROGRAM, frames=1, headless=True, settings={"advance": lambda *_: answer})


def test_time_left_over_is_given_to_the_next_step() -> None:
    """A function that leaves half a step gets one and a half the next time."""
    given = []

    def lazy(position: Any, velocity: Any, elapsed: float) -> Any:
        given.append(elapsed)
        return position, velocity, [], TIME_STEP / 2

    run(Billiards(advance=lazy), 2)
    assert given == [TIME_STEP, TIME_STEP / 2 + TIME_STEP]


def test_time_left_over_does_not_grow_without_end() -> None:
    """A function that leaves everything over is not given ever more."""
    given = []

    def idle(position: Any, velocity: Any, elapsed: float) -> Any:
        given.append(elapsed)
        return position, velocity, [], elapsed

    run(Billiards(advance=idle), 100)
    assert max(given) < 0.3


# Inputs


def test_drag_from_the_ball_launches_along_the_arrow() -> None:
    """A drag of (50, -20) px gives (200, -80) px/s: the arrow shows a quarter of a second."""
    one = game()
    drag(one, (100, 100), (150, 80))
    np.testing.assert_allclose(one.velocity, (200, -80), atol=1e-9)
    assert one.time == 0


def test_mouse_points_at_the_table_with_y_down(program_window: Window) -> None:
    """A click on the pixel where the ball is drawn takes hold of it; a pixel is one px."""
    session = Session(PROGRAM, game(), Recording("billiards", 0))
    for kind, pixel in ((pygame.MOUSEBUTTONDOWN, (200, 200)), (pygame.MOUSEBUTTONUP, (250, 180))):
        session.handle(pygame.event.Event(kind, pos=pixel, button=1))
    assert isinstance(session.game, Billiards)
    # A pixel's centre lies half a pixel further.
    np.testing.assert_allclose(session.game.velocity, (202, -78), atol=1e-9)


def test_drag_too_far_is_capped() -> None:
    """No drag gives more than the speed at which the bumper holds."""
    one = game()
    drag(one, (100, 100), (590, 390))
    assert math.hypot(*one.velocity) == pytest.approx(MAX_LAUNCH_SPEED)


@pytest.mark.parametrize(
    ("start", "end"),
    [
        pytest.param((130, 100), (200, 100), id="not on the ball"),
        pytest.param((100, 100), (105, 103), id="released on the ball"),
    ],
)
def test_drag_that_is_none_leaves_the_ball_alone(
    start: tuple[float, float], end: tuple[float, float]
) -> None:
    """A press beside the ball, or a click on it, launches nothing."""
    one = game(velocity=(30.0, 0.0))
    drag(one, start, end)
    assert one.velocity.tolist() == [30, 0]


def test_aiming_stops_the_time() -> None:
    """While the player aims, nothing moves."""
    one = game(velocity=(60.0, 0.0))
    one.take(Input("down", place=(100.0, 100.0)))
    one.step()
    assert one.position.tolist() == [100, 100]
    one.take(Input("up", place=(100.0, 100.0)))
    one.step()
    assert one.position.tolist() == [101, 100]


def test_reset_plays_the_first_shot_again() -> None:
    """R puts ball, counts and time back to the first shot (fault 23: it must not add)."""
    one = Billiards()
    run(one, 300)
    one.take(Input("press", "r"))
    assert (one.position.tolist(), one.velocity.tolist()) == ([80, 80], [360, -280])
    assert (sum(one.bounces.values()), one.time, one.left_over, len(one.trail)) == (0, 0, 0, 1)


def test_all_five_time_is_when_the_last_cushion_was_hit() -> None:
    """The read-out says when the fifth of the five cushions was hit: 3.83 s in the first shot."""
    one = Billiards()
    run(one, 300)
    assert one.all_hit_at == pytest.approx(230 * TIME_STEP)
    assert ("all five hit", "in 3.83 s") in readings(one)


def test_listeners_hear_of_each_hit_with_its_impulse() -> None:
    """At the left cushion 600 px/s become 570: the impulse is 1170, along the inward normal."""
    one = Billiards(launch=((20.0, 200.0), (-600.0, 0.0)))
    heard: list[Any] = []
    one.listeners.append(heard.append)
    one.step()
    [touch] = heard
    assert (CUSHIONS[touch.body_a], touch.normal, touch.points) == ("left", (1, 0), ((0, 200),))
    assert touch.normal_impulse == pytest.approx(1170)


def test_ball_stays_on_the_table_whatever_is_dragged() -> None:
    """2,000 random drags from around the ball: it is never outside, nor faster than it may be."""
    rng = np.random.default_rng(99)
    one = game()
    for _ in range(2000):
        start = one.position + rng.uniform(-15, 15, 2)
        drag(one, tuple(start), tuple(rng.uniform(-50, 700, 2)))
        run(one, int(rng.integers(1, 5)))
        x, y = one.position
        assert 12 - 1e-9 <= x <= 588 + 1e-9
        assert 12 - 1e-9 <= y <= 388 + 1e-9
        assert math.hypot(*one.velocity) <= MAX_LAUNCH_SPEED * (1 + 1e-12)


# The picture


def test_picture_shows_the_bumper_where_the_physics_has_it(picture: Picture) -> None:
    """Pixels whose ball would be inside the capsule are the bumper's, others cloth (fault 29)."""
    draw(game(), picture, ImpactEffects())
    a, b = np.array(TABLE.bumper_start), np.array(TABLE.bumper_end)
    for i in range(240, 360):
        for j in range(140, 260):
            p = np.array((i + 0.5, j + 0.5))
            part = min(max((p - a) @ (b - a) / ((b - a) @ (b - a)), 0), 1)
            outside = math.hypot(*(p - a - part * (b - a))) - TABLE.bumper_half_thickness
            x, y = picture.camera.world_to_screen((i, j))
            colour = tuple(picture.window.surface.get_at((int(x), int(y))))[:3]
            if outside < -1:
                assert colour == PURPLE
            elif outside > 1:
                assert colour == CLOTH


@pytest.mark.parametrize("aiming", [False, True])
def test_picture_no_two_texts_overlap(
    program_window: Window, text_boxes: list[pygame.Rect], aiming: bool
) -> None:
    """All texts lie in the window and apart, with every count at 999 and everything shown."""
    one = game()
    one.bounces = dict.fromkeys(CUSHIONS, 999)
    one.time, one.all_hit_at = 9999.9, 9999.99
    one.shows_normals = True
    one.aim = (590.0, 390.0) if aiming else None
    session = Session(PROGRAM, one, Recording("billiards", 0))
    session.slow = True
    painter = Painter(session, Picture(program_window, PROGRAM.camera))
    painter.draw()
    assert len(text_boxes) > 30
    assert all(program_window.surface.get_rect().contains(box) for box in text_boxes)
    for k, box in enumerate(text_boxes):
        assert box.inflate(8, 0).collidelist(text_boxes[:k]) == -1


def test_picture_a_ball_that_flew_away_is_no_crash(picture: Picture) -> None:
    """A student's ball at 1e300 px is out of sight; the picture is drawn all the same."""
    one = game()
    one.position, one.velocity = np.array((1e300, -1e300)), np.array((-1e300, 1e12))
    one.trail.append((1e300, -1e300))
    draw(one, picture, ImpactEffects())
    corner = tuple(picture.window.surface.get_at((picture.seen.centerx, 150)))[:3]
    assert corner == CLOTH


# The solution of the exercise


def test_solution_random_states_agree_with_the_table(solution: ModuleType) -> None:
    """All five functions give the table's answers on random states, overlapping or not."""
    rng = np.random.default_rng(5)
    for _ in range(share(2000)):
        p, v = rng.uniform((-20, -20), (620, 420)), rng.uniform(-1000, 1000, 2)
        if rng.random() < 0.5:
            p = rng.uniform((235, 135), (365, 265))
        _same_contacts(solution.wall_contacts(p), billiards_table.wall_contacts(p))
        mine, theirs = solution.bumper_contact(p), billiards_table.bumper_contact(p)
        assert (mine is None) == (theirs is None)
        if theirs is not None:
            _same_contacts([("bumper", *mine)], [("bumper", *theirs)])
            _same(solution.resolve(p, v, *theirs), billiards_table.resolve(p, v, *theirs))
        _same(solution.step(p, v), billiards_table.step(p, v))
        _same(solution.step(p, v, 0.03), billiards_table.step(p, v, 0.03))
        _same(solution.advance(p, v, 0.11), billiards_table.advance(p, v, 0.11))


def test_solution_plays_the_same_game(solution: ModuleType) -> None:
    """The student's physics drives the same game: 480 steps, the same hits, the same place."""
    mine, theirs = Billiards(advance=solution.advance), Billiards()
    for one in (mine, theirs):
        run(one, 480)
    assert mine.bounces == theirs.bounces
    assert mine.position == pytest.approx(theirs.position, abs=1e-6)


def test_solution_has_the_tables_constants(solution: ModuleType) -> None:
    """The exercise is about the table that the window draws."""
    assert (TABLE.width, TABLE.height) == (solution.WIDTH, solution.HEIGHT)
    assert (TABLE.radius, TABLE.restitution) == (solution.RADIUS, solution.RESTITUTION)
    assert tuple(solution.BUMPER_START) == TABLE.bumper_start
    assert tuple(solution.BUMPER_END) == TABLE.bumper_end
    assert TABLE.bumper_half_thickness == solution.BUMPER_HALF_THICKNESS
    assert solution.TIME_STEP == TIME_STEP


def test_solution_docstrings_name_their_tasks_in_order(solution: ModuleType) -> None:
    """Stubs are made from the solution: each docstring starts with its task's number."""
    names = ["wall_contacts", "bumper_contact", "resolve", "step", "advance"]
    for number, name in enumerate(names, start=1):
        assert getattr(solution, name).__doc__.startswith(f"Task B.{number}: ")


def _same(mine: tuple[Any, ...], theirs: tuple[Any, ...]) -> None:
    """Compare vectors and times within rounding, lists of hits exactly."""
    assert len(mine) == len(theirs)
    for a, b in zip(mine, theirs, strict=True):
        if isinstance(b, list):
            assert a == b
        else:
            np.testing.assert_allclose(a, b, rtol=0, atol=AGREEMENT)


def _same_contacts(mine: list[Any], theirs: list[Any]) -> None:
    """Compare names exactly, normals and depths within rounding."""
    assert [contact[0] for contact in mine] == [contact[0] for contact in theirs]
    for a, b in zip(mine, theirs, strict=True):
        np.testing.assert_allclose(a[1], b[1], rtol=0, atol=AGREEMENT)
        assert a[2] == pytest.approx(b[2], abs=AGREEMENT)


def test_billiards_draws_the_vectors_of_each_bounce() -> None:
    """R = I - (1 + e) (I.N)N, and N is that of a wall, or of the bumper, whose ends have any."""
    game, seen = Billiards(), []
    for _ in range(240):
        game.step()
        if game.last_bounce is not None and game.last_bounce not in seen:
            seen.append(game.last_bounce)
    assert len(seen) >= 4
    for bounce in seen:
        i, part, r = (np.array(vector) for vector in bounce[1:])
        assert r == pytest.approx(i - (1 + TABLE.restitution) * part, abs=1e-9)
        n = part / -np.hypot(*part)
        walls = [np.hypot(*(n - normal)) for _, normal, _ in TABLE.walls]
        is_bumper = 100 < bounce.place[0] < 500 and 100 < bounce.place[1] < 300
        assert is_bumper or min(walls) < 1e-9
