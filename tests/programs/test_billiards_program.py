"""The billiards program, headless: repeatable runs, events, errors, the picture, the solution."""

from __future__ import annotations

import importlib.util
import math
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from lesson_code.programs import billiards_table
from lesson_code.programs.billiards import play
from lesson_code.programs.billiards_game import LONGEST_FRAME, Game, on_screen
from lesson_code.programs.billiards_picture import CLOTH, WINDOW_SIZE, Painter
from lesson_code.programs.billiards_table import (
    CUSHIONS,
    LAUNCH,
    MAX_LAUNCH_SPEED,
    TABLE,
    TIME_STEP,
)
from lesson_code.view.pygame_view import PURPLE, Window, open_window, pygame

SOLUTION = Path(__file__).parents[2] / "solutions" / "billiards.py"

AGREEMENT = 1e-9
"""px and px/s: the solution adds in another order, so that roundings differ."""


@pytest.fixture(autouse=True)
def _no_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run without screen and loudspeaker."""
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")


@pytest.fixture
def window() -> Iterator[Window]:
    """Return an open headless window."""
    with open_window(WINDOW_SIZE, "test", headless=True) as opened:
        yield opened


@pytest.fixture(scope="module")
def solution() -> ModuleType:
    """Return solutions/billiards.py as a module."""
    spec = importlib.util.spec_from_file_location("solution_billiards", SOLUTION)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def game(velocity: tuple[float, float] = (0.0, 0.0)) -> Game:
    """Return a game whose ball lies at (100, 100)."""
    return Game(billiards_table.advance, ((100.0, 100.0), velocity))


def key(name: int) -> Any:
    """Return the event of a key that is pressed."""
    return pygame.event.Event(pygame.KEYDOWN, key=name)


def mouse(kind: int, point: tuple[float, float], button: int = 1) -> Any:
    """Return a mouse event at a point of the table."""
    x, y = on_screen(point)
    return pygame.event.Event(kind, pos=(int(x), int(y)), button=button)


def drag(one: Game, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Press, move and release the mouse."""
    one.handle(mouse(pygame.MOUSEBUTTONDOWN, start))
    one.handle(mouse(pygame.MOUSEMOTION, end))
    one.handle(mouse(pygame.MOUSEBUTTONUP, end))


# Runs


def test_play_headless_equals_the_tables_own_advance() -> None:
    """300 frames of the program are 300 steps of the table: bit for bit."""
    outcome = play(frames=300, headless=True)
    position, velocity, hits, _ = billiards_table.advance(*LAUNCH, 300 * TIME_STEP)
    assert outcome.position == tuple(position)
    assert outcome.velocity == tuple(velocity)
    assert outcome.bounces == {name: hits.count(name) for name in CUSHIONS}
    assert outcome.frames == 300


def test_play_twice_gives_the_same_bits(tmp_path: Path) -> None:
    """The same run twice ends the same, down to the bytes of the picture."""
    pictures = [tmp_path / "one.png", tmp_path / "two.png"]
    first, second = (play(frames=100, headless=True, screenshot=path) for path in pictures)
    assert first == second
    assert pictures[0].read_bytes() == pictures[1].read_bytes()


def test_play_with_frames_ignores_the_clock() -> None:
    """A window that is open for a number of frames makes the same steps as a headless one."""
    assert play(frames=5) == play(frames=5, headless=True)


def test_play_other_launch_is_the_first_shot() -> None:
    """The run starts with the launch that was asked for."""
    outcome = play(frames=1, headless=True, launch=((300, 80), (60, 0)))
    assert outcome.position == (301, 80)


def test_play_escape_ends_a_window_without_frames() -> None:
    """Without `frames` the window stays until ESC or its close button."""
    for event in (key(pygame.K_ESCAPE), pygame.event.Event(pygame.QUIT)):
        pygame.display.init()
        pygame.event.post(event)
        assert play().frames == 0


def test_play_unfinished_task_headless_raises() -> None:
    """Where nobody watches, a stub's NotImplementedError is not swallowed."""
    with pytest.raises(NotImplementedError, match=r"Task B\.5"):
        play(_unfinished, frames=3, headless=True)


def test_play_unfinished_task_in_a_window_says_so() -> None:
    """An open window shows which task is missing, and waits until it is closed."""
    calls = []

    def unfinished(position: Any, velocity: Any, elapsed: float) -> Any:
        calls.append(elapsed)
        if len(calls) == 3:
            pygame.event.post(pygame.event.Event(pygame.QUIT))
        raise NotImplementedError("Task B.5: advance")

    outcome = play(unfinished)
    assert outcome.position == LAUNCH[0]
    assert outcome.frames == 3


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"headless": True}, "frames must be given when headless"),
        ({"frames": -1}, "frames must be a whole number >= 0, got -1"),
        ({"frames": 1.5}, "frames must be a whole number >= 0, got 1.5"),
        ({"frames": 1, "screenshot": "a.jpg"}, "screenshot must end in .png, got 'a.jpg'"),
        ({"frames": 1, "launch": ((1, 1), (2000, 0))}, "launch speed must be <= 1080 px/s"),
        ({"frames": 1, "launch": ((math.nan, 1), (0, 0))}, "launch position must be finite"),
    ],
)
def test_play_bad_arguments_are_refused(arguments: dict[str, Any], message: str) -> None:
    """The error names the argument, the rule and the value, before a window opens."""
    with pytest.raises(ValueError, match=message):
        play(**arguments)


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
def test_play_nonsense_from_a_students_advance_is_named(answer: Any, message: str) -> None:
    """What a student's function returns is checked, and the error says what was expected."""
    with pytest.raises(ValueError, match=message):
        play(lambda *_: answer, frames=1, headless=True)


# Events and time


def test_drag_from_the_ball_launches_along_the_arrow() -> None:
    """A drag of (50, -20) px gives (200, -80) px/s: the arrow shows a quarter of a second."""
    one = game()
    drag(one, (100, 100), (150, 80))
    # The mouse points at a pixel's centre, half a pixel further.
    np.testing.assert_allclose(one.velocity, (202, -78), atol=1e-9)
    assert one.time == 0


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


def test_aiming_and_pause_stop_the_time() -> None:
    """While the player aims or pauses, nothing moves."""
    one = game(velocity=(60.0, 0.0))
    one.handle(mouse(pygame.MOUSEBUTTONDOWN, (100, 100)))
    one.tick(TIME_STEP)
    one.handle(mouse(pygame.MOUSEBUTTONUP, (100, 100)))
    one.handle(key(pygame.K_SPACE))
    one.tick(TIME_STEP)
    assert one.position.tolist() == [100, 100]
    one.handle(key(pygame.K_SPACE))
    one.tick(TIME_STEP)
    assert one.position.tolist() == [101, 100]


def test_reset_plays_the_first_shot_again() -> None:
    """R puts ball, counts and time back to the first shot (fault 23: it must not add)."""
    one = Game(billiards_table.advance)
    for _ in range(300):
        one.tick(TIME_STEP)
    one.handle(key(pygame.K_r))
    assert (one.position.tolist(), one.velocity.tolist()) == ([80, 80], [360, -280])
    assert (sum(one.bounces.values()), one.time, one.left_over, len(one.trail)) == (0, 0, 0, 1)


def test_tick_long_frame_is_clamped() -> None:
    """A frame of 10 s counts as 0.25 s, which is 15 steps."""
    one = game(velocity=(60.0, 0.0))
    one.tick(10.0)
    assert one.position.tolist() == pytest.approx([115, 100])
    assert one.time == pytest.approx(LONGEST_FRAME)


def test_tick_uneven_frames_give_the_same_path() -> None:
    """Frames of random length make the same steps as even ones: what is left over is carried."""
    one = Game(billiards_table.advance)
    frames = np.random.default_rng(3).uniform(0.001, 0.04, 200)
    for frame in frames:
        one.tick(float(frame))
    steps = math.floor(frames.sum() / TIME_STEP)
    expected = billiards_table.advance(*LAUNCH, steps * TIME_STEP)
    assert one.position.tolist() == expected[0].tolist()
    assert one.left_over == pytest.approx(frames.sum() - steps * TIME_STEP, abs=1e-9)


def test_all_five_time_is_when_the_last_cushion_was_hit() -> None:
    """The read-out says when the fifth of the five cushions was hit: 3.83 s in the first shot."""
    one = Game(billiards_table.advance)
    for _ in range(300):
        one.tick(TIME_STEP)
    assert one.all_hit_at == pytest.approx(230 * TIME_STEP)


def test_random_events_crash_nothing(window: Window) -> None:
    """10,000 seeded random events, in 400 frames that are drawn, and the ball stays inside."""
    rng = np.random.default_rng(99)
    keys = [pygame.K_SPACE, pygame.K_r, pygame.K_v, pygame.K_n, pygame.K_g, pygame.K_x, 0]
    kinds = [pygame.MOUSEBUTTONDOWN, pygame.MOUSEMOTION, pygame.MOUSEBUTTONUP]
    others = [pygame.KEYUP, pygame.MOUSEWHEEL, pygame.WINDOWFOCUSLOST, pygame.USEREVENT]
    one, painter = Game(billiards_table.advance), Painter(window)
    handled = 0
    for _ in range(400):
        for _ in range(25):
            near = one.position + rng.uniform(-15, 15, 2)
            place = near if rng.random() < 0.5 else rng.uniform(-50, 700, 2)
            choice = rng.integers(6)
            if choice < 4:
                event = mouse(kinds[rng.integers(3)], tuple(place), int(rng.integers(1, 6)))
            elif choice == 4:
                event = key(keys[rng.integers(len(keys))])
            else:
                event = pygame.event.Event(others[rng.integers(len(others))])
            pygame.event.post(event)
        for event in pygame.event.get():
            one.handle(event)
            handled += 1
        one.tick(float(rng.uniform(0, 0.5)))
        painter.draw(one)
        x, y = one.position
        assert 12 - 1e-9 <= x <= 588 + 1e-9
        assert 12 - 1e-9 <= y <= 388 + 1e-9
        assert math.hypot(*one.velocity) <= MAX_LAUNCH_SPEED * (1 + 1e-12)
    assert handled >= 10_000
    assert one.running


# The picture


def test_screenshot_is_a_png_of_the_window(tmp_path: Path) -> None:
    """The last picture is saved, in the size of the window."""
    path = tmp_path / "table.png"
    play(frames=10, headless=True, screenshot=path)
    assert path.read_bytes().startswith(b"\x89PNG")
    assert pygame.image.load(path).get_size() == WINDOW_SIZE


def test_picture_shows_the_bumper_where_the_physics_has_it(window: Window) -> None:
    """Pixels whose ball would be inside the capsule are the bumper's, others cloth (fault 29)."""
    Painter(window).draw(game())
    a, b = np.array(TABLE.bumper_start), np.array(TABLE.bumper_end)
    for i in range(240, 360):
        for j in range(140, 260):
            p = np.array((i + 0.5, j + 0.5))
            part = min(max((p - a) @ (b - a) / ((b - a) @ (b - a)), 0), 1)
            outside = math.hypot(*(p - a - part * (b - a))) - TABLE.bumper_half_thickness
            x, y = on_screen((i, j))
            colour = tuple(window.surface.get_at((int(x), int(y))))[:3]
            if outside < -1:
                assert colour == PURPLE
            elif outside > 1:
                assert colour == CLOTH


@pytest.mark.parametrize("aiming", [False, True])
def test_picture_no_two_texts_overlap(
    window: Window, monkeypatch: pytest.MonkeyPatch, aiming: bool
) -> None:
    """All texts lie in the window and apart, with every count at 999 and everything shown."""
    one = Game(billiards_table.advance, LAUNCH)
    one.bounces = dict.fromkeys(CUSHIONS, 999)
    one.time, one.all_hit_at = 9999.9, 9999.99
    one.shows_normals = one.shows_velocity = True
    one.notice = "not written yet: Task B.1: wall_contacts"
    if aiming:
        one.aim = (590.0, 390.0)
    written: dict[str, pygame.Rect] = {}
    real_text = Window.text

    def noted(self: Window, words: str, *args: Any, **kwargs: Any) -> pygame.Rect:
        written[words] = real_text(self, words, *args, **kwargs)
        return written[words]

    monkeypatch.setattr(Window, "text", noted)
    Painter(window).draw(one)
    boxes = list(written.values())
    assert len(boxes) == 18
    assert all(window.surface.get_rect().contains(box) for box in boxes)
    assert all(box.inflate(8, 0).collidelist(boxes[:i]) == -1 for i, box in enumerate(boxes))


def test_picture_a_ball_that_flew_away_is_no_crash(window: Window) -> None:
    """A student's ball at 1e300 px is out of sight; the picture is drawn all the same."""
    one = game()
    one.position, one.velocity = np.array((1e300, -1e300)), np.array((-1e300, 1e12))
    one.shows_velocity = True
    one.trail.append((1e300, -1e300))
    Painter(window).draw(one)


# The solution of the exercise


def test_solution_random_states_agree_with_the_table(solution: ModuleType) -> None:
    """All five functions give the table's answers on 2,000 random states, overlapping or not."""
    rng = np.random.default_rng(5)
    for _ in range(2000):
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


def test_solution_in_the_window_plays_the_same_game(solution: ModuleType) -> None:
    """The student's physics drives the same window: 480 frames, the same hits, the same place."""
    mine, theirs = (
        play(advance, frames=480, headless=True)
        for advance in (solution.advance, billiards_table.advance)
    )
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


def _unfinished(position: Any, velocity: Any, elapsed: float) -> Any:
    raise NotImplementedError("Task B.5: advance")


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
