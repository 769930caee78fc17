"""One mistake is charged once: a later answer that calls a wrong function is marked with ours."""

from __future__ import annotations

import math
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from clock import at_most

from lesson_code.course.grading import lending
from lesson_code.course.grading.check_task import check_task
from lesson_code.course.grading.exercises import Exercise, exercises, task_by_id
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.lending import Allowance, Lent, value_of
from lesson_code.course.grading.report import Report
from lesson_code.course.grading.self_check import answers_in
from lesson_code.course.grading.submission import read_submission
from lesson_code.course.grading.task import Task
from lesson_code.course.grading.verdict import judge
from lesson_code.course.isolation.inside.answers import Lent as StandIn
from lesson_code.course.isolation.inside.answers import in_the_form_of, lendable
from lesson_code.course.isolation.limits import Limits

from ..conftest import Write

SEED = 5
"""Any."""

CIRCLES = """\
import numpy as np

def resolve_circles(v1, m1, v2, m2, normal, restitution):
    j = (1 + restitution) * max(0.0, np.dot(v1 - v2, normal)) / (1 / m1 + 1 / m2) * normal
    return v1 - j / m1, v2 + j / m2

def separate(p1, m1, p2, m2, normal, depth):
    push = depth / (1 / m1 + 1 / m2) * normal
    return p1 - push / m1, p2 + push / m2

def apart(p1, m1, p2, m2, *, depth, normal):
    return separate(p1, m1, p2, depth=depth, normal=normal, m2=m2)

def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    p1, p2 = apart(p1, m1, p2, m2, normal=normal, depth=depth)
    v1, v2 = resolve_circles(v1, m1, v2, m2, normal, restitution)
    return p1, v1, p2, v2
"""

WRONG = CIRCLES.replace("p1 - push / m1, p2 + push / m2", "p1 + push / m1, p2 - push / m2")
LENT = "  marked with the workbook's `separate` in place of yours, which lost points in 4.3"


def graded(grader: Grader, write: Write, source: str) -> Report:
    """Return what a submission for chapter 04 has earned."""
    return grader.grade(write("answer.py", source), exercise="04", seed=SEED)


def test_mistake_is_charged_once_and_it_is_said(grader: Grader, write: Write) -> None:
    """What calls a wrong function, even through a helper, has full marks with ours in its place."""
    report = graded(grader, write, WRONG)
    assert [verdict.points for verdict in report.verdicts] == [0, 4, 0, 4]
    assert report.verdicts[3].lines == ["4.4 resolve_overlap: 4/4 points", LENT]
    assert report.as_dict()["tasks"][3]["lent"] == LENT.strip()


@pytest.mark.parametrize(
    "broken",
    [
        "def separate(p1, m1, p2, m2, normal, depth): raise NotImplementedError",
        "def separate(p1, m1, p2, m2, normal, depth): return 1 / 0",
        "def separate(p1): return p1",
        "separate = None",
        "del separate",
    ],
)
def test_function_that_is_not_there_or_fails_is_lent_too(
    broken: str, grader: Grader, write: Write
) -> None:
    """A task that was left out is charged once like one that is wrong."""
    report = graded(grader, write, f"{CIRCLES}\n{broken}\n")
    assert [verdict.points for verdict in report.verdicts] == [0, 4, 0, 4]


def test_right_answers_are_marked_as_they_are(grader: Grader, write: Write) -> None:
    """Nothing is lent to an answer whose own functions are right, nor to one that calls none."""
    assert not any(verdict.lent for verdict in graded(grader, write, CIRCLES).verdicts)
    calls_none = WRONG.replace("= apart(p1, m1, p2, m2, normal=normal, depth=depth)", "= p1, p2")
    assert not any(verdict.lent for verdict in graded(grader, write, calls_none).verdicts)


def test_own_mistake_of_a_later_task_is_charged_and_told(grader: Grader, write: Write) -> None:
    """With ours in place of the earlier one, points and messages are those of this answer."""
    report = graded(grader, write, WRONG.replace("return p1, v1, p2, v2", "return p1, v1, p2, -v2"))
    verdict = report.verdicts[3]
    assert verdict.points == 0
    assert verdict.lines[:2] == ["4.4 resolve_overlap: 0/4 points", LENT]
    assert "The fourth is minus what was expected; all else is right." in " ".join(verdict.lines)


def test_answer_that_is_right_with_its_own_wrong_function_keeps_its_points(
    grader: Grader, write: Write
) -> None:
    """An answer that knows its own helper's sign and turns it round is right as it stands."""
    both = WRONG.replace(
        "normal=normal, depth=depth)\n    v1", "normal=-normal, depth=depth)\n    v1"
    )
    report = graded(grader, write, both)
    assert [verdict.points for verdict in report.verdicts] == [0, 4, 0, 4]
    assert report.verdicts[3].lent == ()


LOOKS = """
import gc, inspect, sys
def resolve_overlap(*given):
    separate
    found = [type(separate).__name__, getattr(separate, "__code__", None) is None]
    try:
        inspect.getsource(separate)
        found.append("source")
    except (TypeError, OSError):
        found.append("no source")
    found.append([name for name in sys.modules if name.startswith("lesson_code")])
    raise ValueError(str(found))
"""


def test_code_of_ours_never_comes_to_the_student(grader: Grader, write: Write) -> None:
    """What stands in for a function has no code to look at, and no module of ours is loaded."""
    report = graded(grader, write, WRONG + LOOKS)
    assert "['Lent', True, 'no source', []]" not in str(report.verdicts[3].lines)  # nothing asked
    asks = LOOKS.replace("    separate\n", "    separate(*given[:1], *given[2:4], *given[5:8])\n")
    report = graded(grader, write, WRONG + asks)
    assert report.verdicts[3].lent
    assert "['Lent', True, 'no source', []]" in str(report.verdicts[3].lines)


FORGES = """
import json, os
def resolve_overlap(*given):
    separate
    line = json.dumps({"lend": "%s", "arguments": [1, 2], "number": %s}).encode()
    os.write(3, line + b"\\n")
    return given[0], given[1], given[3], given[4]
"""


@pytest.mark.parametrize("name", ["resolve_overlap", "resolve_circles", "__import__"])
def test_nothing_is_lent_but_the_earlier_functions_that_lost_points(
    name: str, grader: Grader, write: Write
) -> None:
    """Neither the task at hand, nor what was right, nor anything else can be asked for."""
    for number in range(1, 40, 13):
        report = graded(grader, write, WRONG + FORGES % (name, number))
        assert report.verdicts[3].points == 0


SECONDS_OF_THE_PARENT = 1.5
"""With all that judging costs: 0.5 s, and minutes if a loan has no end."""

ENDLESS = """
def resolve_overlap(*given):
    while True:
        try:
            separate(*given[:1], *given[2:4], *given[5:8])
        except ValueError:
            pass
"""


@pytest.mark.full
def test_asking_without_end_earns_nothing(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    """A submission borrows so many values and no more."""
    monkeypatch.setattr(lending, "MOST_VALUES", 100)
    with Grader(limits=Limits(seconds_a_call=0.3)) as impatient:
        report = graded(impatient, write, WRONG + ENDLESS)
    assert [verdict.points for verdict in report.verdicts] == [0, 4, 0, 0]


def lender(task_id: str, allowance: Allowance | None = None) -> Lent:
    """Return what lends the function of one task."""
    return Lent([task_by_id(task_id)], allowance or Allowance())


def test_request_that_is_refused_counts_as_any_other() -> None:
    """Otherwise it could be asked for without end, and the grader would read on and on."""
    allowance = Allowance()
    allowance.values = 2
    heights = lender("2.3", allowance)
    assert "refused" in (heights.reply("bounce_heights", [{}]) or ())
    assert "refused" in (heights.reply("bounce_heights", [10**400]) or ())
    assert heights.reply("bounce_heights", [1.0, 0.5, 1]) is None


@pytest.mark.full
def test_request_of_more_than_any_arguments_ends_the_loan(grader: Grader, write: Write) -> None:
    """400 kB at a time, as often as values may be asked for, cost the grader minutes."""
    given = "*given[:1], *given[2:4], *given[5:8]"
    large = ENDLESS.replace(given, "*[LONG] * 6")
    with at_most(SECONDS_OF_THE_PARENT):
        report = graded(grader, write, f"{WRONG}\nLONG = [0.5] * 1500\n{large}")
    assert [verdict.points for verdict in report.verdicts] == [0, 4, 0, 0]


def test_value_that_takes_too_long_is_refused_and_ends_nothing() -> None:
    """A student chooses the arguments: a count of 1e12 costs our process, and not the grader."""
    allowance = Allowance()
    heights = lender("2.3", allowance)
    assert "refused" in (heights.reply("bounce_heights", [1.0, 0.5, 10**12]) or ())
    allowance.seconds = lending.MOST_SECONDS
    assert heights.reply("bounce_heights", [1.0, 0.5, 2]) == {"value": {"array": [0.25, 0.0625]}}


@pytest.mark.parametrize(
    "arguments", [None, 3, {"a": 1}, [], [1], ["x", None, []], [math.nan] * 3, [[[1]]] * 3, "abc"]
)
def test_arguments_of_any_kind_are_refused_or_answered(arguments: Any) -> None:
    """Whatever a child asks with, there is an answer in the form agreed on."""
    assert set(lender("2.3").reply("bounce_heights", arguments) or ()) in ({"value"}, {"refused"})


def test_allowance_of_a_submission_runs_out() -> None:
    """After so many values nothing more is lent."""
    allowance = Allowance()
    allowance.values = 1
    one = lender("1.2", allowance)
    assert one.reply("inelastic_1d", [1, 2, 3, 4]) == {"value": [3.5, 3.5]}
    assert one.reply("inelastic_1d", [1, 2, 3, 4]) is None
    assert [task.id for task in one.used] == ["1.2"]


def test_clerk_imports_nothing_from_the_folder_it_is_started_in(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A class's folder may hold a numpy.py or a json.py of a student's."""
    for name in ("numpy", "json", "lesson_code", "random"):
        (tmp_path / f"{name}.py").write_text("open('was_here', 'w')\nraise SystemExit\n")
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend("")
    lending._clerk().close()
    assert lender("1.2").reply("inelastic_1d", [1, 2, 3, 4]) == {"value": [3.5, 3.5]}
    assert not (tmp_path / "was_here").exists()


def solved(exercise: Exercise, root: Path) -> dict[str, Any]:
    """Return what the solution of an exercise defines."""
    names: dict[str, Any] = {}
    for unit in read_submission(exercise.solution(root)).units:
        for source in unit.kept_sources:
            exec(source, names)  # noqa: S102 - the course's own source
    return names


def calls_of(exercise: Exercise, root: Path) -> list[tuple[Task, list[Task]]]:
    """Return the tasks whose solution calls functions of earlier tasks, with these."""
    submission = read_submission(exercise.solution(root))
    defined = {answer.name for answer, _ in answers_in(exercise.solution(root), exercise)}
    found = []
    for place, task in enumerate(exercise.tasks):
        used = submission.used_by(task.function) & defined
        if earlier := [each for each in exercise.tasks[:place] if each.function in used]:
            found.append((task, earlier))
    return found


@pytest.mark.one_in(2)
@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_every_solution_keeps_full_marks_with_values_that_are_lent(
    exercise: Exercise, root: Path
) -> None:
    """Lent values have the form that a solution's own have: arrays, tuples and None alike."""
    for task, earlier in calls_of(exercise, root):
        names = solved(exercise, root)
        for each in earlier:
            names[each.function] = StandIn(
                each.function, list(each.parameters), partial(asked, each), {}
            )
        verdict = judge(task, partial(call_here, names), SEED)
        assert verdict.is_full, verdict.lines


def test_value_is_asked_for_once_and_made_afresh_each_time() -> None:
    """What a student's code does to a vector that it was lent, the next call does not see."""
    loans: list[dict[str, Any]] = []

    def ask(loan: dict[str, Any]) -> dict[str, Any]:
        loans.append(loan)
        return {"value": {"array": [1.0, 2.0]}}

    lent = StandIn("f", ["x"], ask, {})
    lent(3.0)[0] = 9.0
    assert lent(x=3.0).tolist() == [1.0, 2.0]
    assert lent(4.0).tolist() == [1.0, 2.0]
    assert [loan["arguments"] for loan in loans] == [[3.0], [4.0]]


def asked(task: Task, loan: dict[str, Any]) -> dict[str, Any]:
    """Return the value of a call in this process."""
    return value_of(task.id, loan["arguments"])


def test_lendable_tells_arrays_vectors_and_tuples() -> None:
    """Arrays stay arrays and tuples tuples; floats in a tuple within a tuple are a vector."""
    value = ((0.5, 1.0), np.float64(2.0), None, [(1, 2)], "left", np.eye(1))
    assert lendable(value) == [
        {"array": [0.5, 1.0]}, 2.0, None, [[1, 2]], "left", {"array": [[1.0]]}
    ]  # fmt: skip


POLYGONS = """\
import numpy as np

def sat_axes(vertices):
    edges = [b - a for a, b in zip(vertices, np.roll(vertices, -1, axis=0))]
    return [edge / np.hypot(*edge) for edge in edges if edge.any()]

def project(vertices, axis):
    shadow = np.dot(vertices, axis)
    return min(shadow), max(shadow)

def mtv(vertices_a, vertices_b):
    ways = []
    for axis in sat_axes(vertices_a) + sat_axes(vertices_b):
        low_a, high_a = project(vertices_a, axis)
        low_b, high_b = project(vertices_b, axis)
        ways += [(high_a - low_b, list(axis)), (high_b - low_a, list(-axis))]
    depth, normal = min(ways)
    return (normal, depth) if depth > 0 else None
"""


def test_values_that_are_lent_have_the_form_of_the_students_own(
    grader: Grader, write: Write
) -> None:
    """Lists of axes are added where arrays would be summed: the mistake in 6.1 is charged once."""
    path = write("answer.py", POLYGONS)
    verdicts = {v.task.id: v for v in grader.grade(path, exercise="06", seed=SEED).verdicts}
    assert not verdicts["6.1"].is_full
    assert verdicts["6.4"].is_full
    assert [task.id for task in verdicts["6.4"].lent] == ["6.1"]


def test_check_cell_lends_in_the_form_of_the_students_own(capsys: pytest.CaptureFixture) -> None:
    """As the class's grader does, so that both give the same marks."""
    scope: dict[str, Any] = {}
    exec(POLYGONS, scope)  # noqa: S102
    check_task("6.4", scope["mtv"], seed=SEED)
    assert capsys.readouterr().out == "6.4 mtv: 4/4 points\n"


def test_form_that_does_not_fit_leaves_a_value_as_it_is() -> None:
    """A student's number, text or list of another kind tells nothing of the form of ours."""
    value = (np.array([1.0, 2.0]), 3.0)
    for own in (None, 2.0, "text", {}, 1j):
        assert in_the_form_of(own, value) is value
    normal, depth = in_the_form_of(([0, 1], 2), value)
    assert (normal, depth) == ([1.0, 2.0], 3.0)
    assert in_the_form_of(1j, np.array([1.0, 2.0])) == 1 + 2j
    assert in_the_form_of([], np.array([1.0, 2.0])) == [1.0, 2.0]
    assert in_the_form_of([1.0], None) is None
