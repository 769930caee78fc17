"""The check cell: one line for full marks, and what there is to mend."""

from __future__ import annotations

import sys
from functools import partial
from typing import Any

import pytest

from lesson_code.course.grading import check_task as check_task_in_notebooks
from lesson_code.course.grading.check_task import check_criterion, check_task, left_out_of, lines_of
from lesson_code.course.grading.exercises import exercises, task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.task import Task
from lesson_code.course.grading.verdict import judge

ALL_TASKS = [task for exercise in exercises() for task in exercise.tasks]
CHECK_TASK_MODULE = sys.modules[check_task.__module__]


def wrong(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """Return what no formula gives."""
    return m1, m2


@pytest.mark.one_in(3)
@pytest.mark.parametrize("task", ALL_TASKS, ids=lambda task: task.title)
def test_check_of_right_answer_prints_the_same_line_whatever_the_seed(
    task: Task, capsys: pytest.CaptureFixture[str]
) -> None:
    """A full mark prints one line that depends on nothing but the task."""
    for seed in (0, 1, 9999, None):
        check_task(task.id, task.expected, seed=seed)
    assert (
        capsys.readouterr().out.splitlines()
        == [f"{task.id} {task.function}: {task.points}/{task.points} points"] * 4
    )


@pytest.mark.one_in(6)
@pytest.mark.parametrize("task", ALL_TASKS, ids=lambda task: task.title)
def test_check_of_criterion_raises_exactly_where_its_points_are_lost(task: Task) -> None:
    """For every wrong model and the right answer; what is said holds no call."""
    for answer in (task.expected, *(model.function for model in task.wrong_models)):
        verdict = judge(task, partial(call_here, {task.function: answer}), 3, hide_inputs=True)
        for criterion in verdict.criteria:
            said = ""
            try:
                check_criterion(task.id, criterion.name, answer, seed=3)
            except AssertionError as error:
                said = str(error)
            assert bool(said) == (criterion.points < criterion.full_points)
            assert f"{task.function}(" not in said.partition("hint: ")[0]
    with pytest.raises(ValueError, match="criterion must be one of"):
        check_criterion(task.id, "no such", task.expected, seed=3)


def test_check_of_stub_says_not_written_yet(capsys: pytest.CaptureFixture[str]) -> None:
    """A stub gets one line, without a list of failures."""

    def stub(*_: object) -> None:
        raise NotImplementedError("Task 1.1: elastic_1d")

    check_task("1.1", stub)
    assert capsys.readouterr().out == "1.1 elastic_1d: 0/4 points (not written yet)\n"


def test_check_of_wrong_model_prints_marks_messages_hint_and_seed(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """A wrong answer gets what is right, what is not and why, the hint, and the seed."""
    check_task("1.1", lambda *given: (given[3], given[1]), seed=1)
    lines = capsys.readouterr().out.splitlines()
    assert lines[:2] == ["1.1 elastic_1d: 1/4 points", "  right: equal masses"]
    assert lines[2].startswith("  unequal masses, the second at rest: Called elastic_1d(")
    assert lines[3:] == [
        "  for the same reason: unequal masses, head on; unequal masses, one catching up",
        f"  hint: {task_by_id('1.1').wrong_models[0].hint}",
        "  (inputs drawn with seed 1)",
    ]


def test_check_of_unrecognised_answer_prints_no_hint(capsys: pytest.CaptureFixture[str]) -> None:
    """An answer that no wrong model gives gets messages and no hint."""
    check_task("1.1", lambda m1, v1, m2, v2: (m1 + v2, 7 * m2 - v1), seed=1)
    assert "hint" not in capsys.readouterr().out


def test_check_prints_the_seed_that_repeats_it(capsys: pytest.CaptureFixture[str]) -> None:
    """With the printed seed the same check prints the same again."""
    check_task("1.1", wrong)
    first = capsys.readouterr().out
    seed = int(first.rstrip(")\n").rpartition(" ")[2])
    check_task("1.1", wrong, seed=seed)
    assert capsys.readouterr().out == first


def test_check_draws_other_inputs_from_run_to_run(capsys: pytest.CaptureFixture[str]) -> None:
    """Without a seed, ten checks do not all draw the same inputs."""
    for _ in range(10):
        check_task("1.3", wrong)
    seeds = {line for line in capsys.readouterr().out.splitlines() if "seed" in line}
    assert len(seeds) > 1


def test_check_of_endless_loop_is_cut_off(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A loop without an end is interrupted after the limit and named as the reason."""

    def endless(*_: object) -> None:
        while True:
            pass

    monkeypatch.setattr(CHECK_TASK_MODULE, "call_here", partial(call_here, seconds=0.1))
    check_task("1.1", endless)
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "1.1 elastic_1d: 0/4 points"
    assert lines[1].endswith(" It did not finish within 0.1 s.")


def test_check_of_printing_answer_prints_the_marks_alone(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """An answer that prints earns the same single line."""

    def talks(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
        print("1.2 inelastic_1d: 99/3 points")  # noqa: T201
        return ((m1 * v1 + m2 * v2) / (m1 + m2),) * 2

    check_task("1.2", talks)
    assert capsys.readouterr().out == "1.2 inelastic_1d: 3/3 points\n"


def test_check_of_something_that_is_no_function(capsys: pytest.CaptureFixture[str]) -> None:
    """What cannot be called earns nothing and is named."""
    check_task("1.1", 3.0)  # type: ignore[arg-type]
    assert "there is no function named elastic_1d" in capsys.readouterr().out


def test_check_of_unknown_task_is_refused() -> None:
    """A number that no task has is an error."""
    with pytest.raises(ValueError, match=r"task must be one of .* got '9\.9'"):
        check_task("9.9", wrong)


def test_check_task_is_what_notebooks_import() -> None:
    """``from lesson_code.course.grading import check_task`` gives the function."""
    assert check_task_in_notebooks is check_task


def test_lines_of_half_written_answer_are_one_line_with_its_points() -> None:
    """Where only some inputs reach the stub, the others keep their points."""

    def half(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
        if m1 == m2:
            return v2, v1
        raise NotImplementedError

    verdict = judge(task_by_id("1.1"), partial(call_here, {"elastic_1d": half}), 1)
    assert lines_of(verdict) == ["1.1 elastic_1d: 1/4 points (not written yet)"]


def test_check_says_which_names_grading_leaves_out(capsys: pytest.CaptureFixture[str]) -> None:
    """An answer that takes the lesson's formula is right here and fails when it is graded."""
    names: dict[str, object] = {"__name__": "notebook"}
    source = (
        "from lesson_code.formulas import reflect as ours\n"
        "def helper(v, n):\n    return ours(v, n)\n"
        "def reflect(v, n):\n    return helper(v, n)\n"
    )
    exec(source, names)  # noqa: S102 - a notebook's cell
    check_task("3.1", names["reflect"])  # type: ignore[arg-type]
    last = capsys.readouterr().out.splitlines()[-1]
    assert last == "  grading leaves out imports of lesson_code, and so ours"


@pytest.mark.parametrize(
    ("source", "line"),
    [
        (
            "import pymunk as pm\ndef helper(v, n): return pm.Vec2d(*v)\n"
            "def reflect(v, n): return helper(v, n)\n",
            "  grading leaves out imports of pymunk, and so pm; answers can use Python's own",
        ),
        (
            "from matplotlib.path import Path\ndef reflect(v, n): return [Path for _ in v]\n",
            "  grading leaves out imports of matplotlib, and so Path; answers can use Python's own",
        ),
        (
            "def reflect(v, n):\n    import pymunk.vec2d\n    return pymunk.vec2d.Vec2d(*v)\n",
            "  grading leaves out imports of pymunk; answers can use Python's own",
        ),
        (
            "def reflect(v, n):\n    def inner():\n        from lesson_code import formulas\n"
            "        return formulas\n    return inner()\n",
            "  grading leaves out imports of lesson_code",
        ),
    ],
    ids=["alias in a helper", "name", "inside a function", "inside a nested one"],
)
def test_check_names_imports_that_are_not_on_the_list(
    source: str, line: str, capsys: pytest.CaptureFixture[str]
) -> None:
    """What grading leaves out is named, at top level and inside a function."""
    names: dict[str, object] = {"__name__": "__main__"}
    exec(source, names)  # noqa: S102 - a notebook's cell
    check_task("3.1", names["reflect"])  # type: ignore[arg-type]
    assert capsys.readouterr().out.splitlines()[-1].startswith(line)


def test_check_names_no_import_that_is_on_the_list() -> None:
    """Python's own modules, NumPy, pygame and what the notebook itself defines are not named."""
    names: dict[str, object] = {"__name__": "__main__"}
    source = (
        "import math, numpy as np\nfrom pygame import Vector2\nfrom functools import partial\n"
        "from numpy.linalg import norm\nclass Own: pass\nE = Own()\n"
        "def helper(x): return math.pi * np.abs(norm(x)) * partial(Vector2)\n"
        "def reflect(v, n):\n    import cmath\n    return helper(v), cmath.pi, Own, E, len(v)\n"
    )
    exec(source, names)  # noqa: S102 - a notebook's cell
    assert left_out_of(names["reflect"]) == []  # type: ignore[arg-type]


def in_a_notebook(source: str) -> dict[str, Any]:
    """Return what a notebook's cell defines."""
    names: dict[str, Any] = {"__name__": "__main__"}
    exec(source, names)  # noqa: S102 - a notebook's cell
    return names


OVERLAP = """\
import numpy as np

def resolve_circles(v1, m1, v2, m2, normal, restitution):
    j = (1 + restitution) * max(0.0, np.dot(v1 - v2, normal)) / (1 / m1 + 1 / m2) * normal
    return v1 - j / m1, v2 + j / m2

def separate(p1, m1, p2, m2, normal, depth):
    return p1, p2

def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    return (*separate(p1, m1, p2, m2, normal, depth),
            *resolve_circles(v1, m1, v2, m2, normal, restitution))
"""


def test_check_charges_one_mistake_once(capsys: pytest.CaptureFixture[str]) -> None:
    """What is right but for a function of an earlier task prints the line of full marks."""
    ordered = OVERLAP.replace("return (*sep", "a, b, c, d = (*sep") + "    return a, c, b, d\n"
    names = in_a_notebook(ordered)
    check_task("4.4", names["resolve_overlap"], seed=3)
    assert capsys.readouterr().out == "4.4 resolve_overlap: 4/4 points\n"
    check_task("4.3", names["separate"], seed=3)
    assert capsys.readouterr().out.startswith("4.3 separate: 0/4 points\n")


def test_check_of_a_wrong_answer_names_the_wrong_functions_it_calls(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """An answer with a mistake of its own is told of the other's, too."""
    check_task("4.4", in_a_notebook(OVERLAP)["resolve_overlap"], seed=3)
    last = capsys.readouterr().out.splitlines()[-1]
    assert last == "  it calls your `separate`, which lost points in 4.3"


def test_check_of_an_answer_that_displays_a_value_names_nothing() -> None:
    """Jupyter's display is there while an answer is graded, imported or not."""
    names: dict[str, Any] = {"__name__": "notebook"}
    source = "from IPython.display import display\ndef reflect(v, n):\n    display(v)\n"
    exec(source, names)  # noqa: S102 - a notebook's cell
    assert left_out_of(names["reflect"]) == []
