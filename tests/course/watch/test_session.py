"""A session of ``workbook watch``: what it says to a save, and to each command."""

from __future__ import annotations

import json
import queue
import threading
from collections.abc import Callable

import pytest

from lesson_code.course.grading.task import WrongModel
from lesson_code.course.watch import session as sessions
from lesson_code.course.watch.session import listen

from .conftest import BILLIARDS, ONE, Desk

MakeDesk = Callable[..., Desk]
SWAPS: WrongModel = ONE.tasks[0].wrong_models[0]


def test_session_begins_where_there_is_something_to_do(make_desk: MakeDesk) -> None:
    """The course's progress is shown, each task of the exercise, and what is next."""
    desk = make_desk()
    desk.session.begin()
    desk.session.show()
    said = desk.said()
    assert f"Course: 0 of 8 tasks right, 0 of {ONE.points + BILLIARDS.points} points" in said
    assert "not right: 1.1 elastic_1d: 0/4 points" in said
    assert "Next: 1.1 elastic_1d\nNot written yet. Both velocities" in said


def test_save_shows_what_is_right_and_goes_on_to_the_next_task(make_desk: MakeDesk) -> None:
    """After a right answer its points count, and the next task is shown."""
    desk = make_desk()
    desk.save("right")
    said = desk.said()
    assert "right: 1.1 elastic_1d: 4/4 points" in said
    assert "Course: 1 of 8 tasks right, 4 of" in said
    assert "Next: 1.2 inelastic_1d" in said


def test_hints_go_a_step_further_with_each_failed_save(make_desk: MakeDesk) -> None:
    """First what came of the call, then a question, then the misconception itself."""
    desk = make_desk()
    for try_ in range(3):
        desk.save_text(f"# {try_}\ndef elastic_1d(m1, v1, m2, v2):\n    return v2, v1\n")
        said = desk.said()
        assert "It returned" in said
        assert (f"A question: {SWAPS.hint}" in said) == (try_ >= 1)
        assert (SWAPS.misconception in said) == (try_ >= 2)


def test_hints_can_be_asked_for_and_come_to_an_end(make_desk: MakeDesk) -> None:
    """Each request shows the next step alone; after the last one it says who else can help."""
    desk = make_desk()
    desk.save("swaps")
    desk.said()
    desk.session.obey("h\n")
    said = desk.said()
    assert SWAPS.hint in said
    assert "It returned" not in said
    for _ in range(6):
        desk.session.obey("h\n")
    assert "Ask whoever teaches you." in desk.said()


def test_saving_the_same_again_is_no_further_try(make_desk: MakeDesk) -> None:
    """Help does not run ahead of somebody who presses save twice."""
    desk = make_desk()
    desk.save("swaps")
    desk.said()
    desk.save("swaps")
    assert SWAPS.hint not in desk.said()


def test_solution_is_shown_after_passing_and_not_before(make_desk: MakeDesk) -> None:
    """Of a task that is right, and of no other."""
    desk = make_desk()
    desk.save("swaps")
    desk.said()
    desk.session.obey("s\n")
    assert desk.said() == "A solution is shown once your own answer is right.\n"
    desk.save("right")
    desk.said()
    desk.session.obey("s\n")
    said = desk.said()
    assert "v_centre = (m1 * v1 + m2 * v2) / (m1 + m2)" in said
    assert "def inelastic_1d" not in said


def test_solution_is_not_there_in_a_students_copy(make_desk: MakeDesk) -> None:
    """It says so, and does not fail."""
    desk = make_desk()
    desk.save("right")
    ONE.solution(desk.root).unlink()
    desk.said()
    desk.session.obey("s\n")
    assert "this copy holds no solutions" in desk.said()


def test_reset_asks_first_keeps_a_backup_and_forgets_the_points(make_desk: MakeDesk) -> None:
    """Anything but yes leaves the file alone."""
    desk = make_desk()
    path = ONE.student_copy(desk.root)
    fresh = path.read_bytes()
    desk.save("right")
    mine = path.read_bytes()
    for answer in ("no\n", "y\n", "q\n"):
        desk.session.obey("r\n")
        desk.session.obey(answer)
        assert path.read_bytes() == mine
    desk.session.obey("r\n")
    desk.session.obey("yes\n")
    assert path.read_bytes() == fresh
    backup = desk.root / "exercises" / "backups" / "01_one_dimension-1.ipynb"
    assert backup.read_bytes() == mine
    assert "kept in exercises/backups/01_one_dimension-1.ipynb" in desk.said()
    assert desk.session.progress.count([ONE]) == (0, 3)


def test_list_and_next_lead_through_the_course(make_desk: MakeDesk) -> None:
    """Every exercise has a line; next skips none and comes round again."""
    desk = make_desk()
    desk.session.begin()
    desk.said()
    desk.session.obey("l\n")
    assert "01_one_dimension.ipynb: 0 of 3 tasks, 0 of 10 points\n" in desk.said()
    desk.session.obey("n\n")
    assert desk.session.current is BILLIARDS
    desk.session.obey("n\n")
    assert desk.session.current is ONE


def test_file_that_cannot_be_read_is_said_and_the_session_goes_on(make_desk: MakeDesk) -> None:
    """Broken JSON, no file, a syntax error: a line each, with the place where there is one."""
    desk = make_desk()
    path = ONE.student_copy(desk.root)
    path.write_text("{", encoding="utf-8")
    desk.session.saved(ONE)
    assert "is not a notebook (its text is not JSON)" in desk.said()
    desk.save_text("def elastic_1d(m1, v1, m2, v2):\n    return (v1\n")
    assert "Left out: your cell 1, line 2: '(' was never closed" in desk.said()
    path.unlink()
    desk.session.saved(ONE)
    assert "is not there. r puts it back." in desk.said()
    desk.session.obey("r\n")
    desk.session.obey("yes\n")
    assert path.exists()


def test_progress_is_kept_and_nothing_is_checked_twice(make_desk: MakeDesk) -> None:
    """The next session knows the points; a file that has changed meanwhile is checked first."""
    make_desk().save("right")
    again = make_desk()
    again.session.begin()
    assert "01_one_dimension" not in again.said()
    assert again.session.progress.points([ONE]) == (4, 10)
    ONE.student_copy(again.root).write_text('{"cells": []}', encoding="utf-8")
    third = make_desk()
    third.session.begin()
    assert "holds no code" in third.said()


def test_progress_file_that_is_broken_is_begun_anew(make_desk: MakeDesk) -> None:
    """Whatever stands in it."""
    desk = make_desk()
    for text in ("", "[]", '{"tasks": {"1.1": 3}, "checked": {}}', "\x00"):
        (desk.root / "exercises" / ".progress.json").write_text(text)
        assert make_desk().session.progress.points([ONE]) == (0, 10)


def test_whole_course_done_is_said(make_desk: MakeDesk) -> None:
    """With every task right there is nothing left to mend."""
    desk = make_desk()
    desk.session.exercises = (ONE,)
    solution = json.loads(ONE.solution(desk.root).read_text(encoding="utf-8"))
    answers = [c["source"] for c in solution["cells"] if "task" in c["metadata"].get("tags", [])]
    desk.save_text("\n\n".join("".join(source) for source in answers))
    assert "All of it is right. That is the whole course." in desk.said()
    desk.session.obey("h")
    assert "Nothing is left to mend" in desk.said()


def test_plain_says_all_in_words_and_screen_with_signs(make_desk: MakeDesk) -> None:
    """Plain lines hold no escape, sign or bar; the screen has them beside the words."""
    for plain in (True, False):
        desk = make_desk(plain=plain)
        desk.save("right")
        said = desk.said()
        assert ("\x1b" in said) is not plain
        assert ("✓" in said) is not plain
        assert ("━" in said) is not plain
        assert "1.1 elastic_1d: 4/4 points" in said


def test_run_sees_a_save_and_obeys_lines(
    make_desk: MakeDesk, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A file that is written while it watches is checked; q ends it, an unknown line is helped."""
    monkeypatch.setattr(sessions, "SECONDS_BETWEEN_LOOKS", 0.02)
    desk = make_desk()
    lines: queue.Queue[str] = queue.Queue()
    running = threading.Thread(target=desk.session.run, args=(lines,))
    running.start()
    cell = {"cell_type": "code", "source": "def elastic_1d(*_): return 0, 0", "metadata": {}}
    text = json.dumps({"cells": [cell], "metadata": {}})
    ONE.student_copy(desk.root).write_text(text, encoding="utf-8")
    for _ in range(500):
        if "It returned (0, 0)" in desk.written.getvalue():
            break
        running.join(0.02)
    lines.put("what\n")
    lines.put("q\n")
    running.join(10)
    assert not running.is_alive()
    assert "It returned (0, 0)" in desk.written.getvalue()
    assert desk.written.getvalue().rstrip().endswith("(then Enter)")


def test_listening_ends_with_its_source() -> None:
    """Where standard input is closed, watching goes on without commands."""
    lines: queue.Queue[str] = queue.Queue()
    source = iter(["h\n", "q\n", ""])
    listen(lines, lambda: next(source))
    assert [lines.get_nowait() for _ in range(2)] == ["h\n", "q\n"]
    assert lines.empty()
