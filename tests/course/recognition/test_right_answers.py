"""Right answers, rewritten by a machine in ways nobody would: full marks, and no diagnosis."""

from __future__ import annotations

import ast
import copy
from collections.abc import Callable
from functools import partial
from typing import Any, ClassVar

import numpy as np
import pytest

from lesson_code.course.grading.exercises import exercises
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.recognition.candidates import right_answers
from lesson_code.course.grading.task import Task
from lesson_code.course.grading.verdict import judge

SEED = 17
"""Any; the answers are right for all."""

TASKS = [task for exercise in exercises() for task in exercise.tasks]


class Commuted(ast.NodeTransformer):
    """Turns every product round: a * b is b * a."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """Turn one product round, and those in it."""
        self.generic_visit(node)
        if isinstance(node.op, ast.Mult) and not _is_a_sequence(node):
            return ast.BinOp(node.right, ast.Mult(), node.left)
        return node


class AddedNegative(ast.NodeTransformer):
    """Writes every difference as a sum: a - b is a + -1.0 * b."""

    def visit_BinOp(self, node: ast.BinOp) -> ast.AST:
        """Rewrite one difference, and those in it."""
        self.generic_visit(node)
        if isinstance(node.op, ast.Sub) and _has_a_minus(node):
            return ast.BinOp(node.left, ast.Add(), ast.UnaryOp(ast.USub(), node.right))
        return node


class Doubled(ast.NodeTransformer):
    """Writes every sum twice over: a + b is (a + b + (a + b)) / 2."""

    def visit_Return(self, node: ast.Return) -> ast.AST:
        """Rewrite what is returned, and nothing else, since sums may count."""
        for part in ast.walk(node):
            for name, value in ast.iter_fields(part):
                if isinstance(value, ast.BinOp) and isinstance(value.op, ast.Sub):
                    whole = ast.BinOp(value, ast.Mult(), ast.Constant(1.0))
                    setattr(part, name, whole)
        return node


class TurnedRound(ast.NodeTransformer):
    """Writes every comparison the other way round: a < b is b > a."""

    TURNED: ClassVar[dict[type[ast.cmpop], type[ast.cmpop]]] = {
        ast.Lt: ast.Gt,
        ast.LtE: ast.GtE,
        ast.Gt: ast.Lt,
        ast.GtE: ast.LtE,
        ast.Eq: ast.Eq,
        ast.NotEq: ast.NotEq,
    }

    def visit_Compare(self, node: ast.Compare) -> ast.AST:
        """Turn one comparison of two values round, and those in it."""
        self.generic_visit(node)
        turned = self.TURNED.get(type(node.ops[0]))
        if len(node.ops) > 1 or turned is None:
            return node
        return ast.Compare(node.comparators[0], [turned()], [node.left])


def _is_a_sequence(node: ast.BinOp) -> bool:
    """Return whether a product may repeat a list, for which the order counts no more than here."""
    return any(isinstance(part, ast.List | ast.Tuple) for part in ast.walk(node))


def _has_a_minus(node: ast.BinOp) -> bool:
    """Return whether what is taken away is arithmetic, and no set or tuple."""
    return isinstance(node.right, ast.BinOp | ast.Constant | ast.Subscript)


WAYS = (Commuted, AddedNegative, Doubled, TurnedRound)
FORMS: dict[str, Callable[..., Any]] = {"list": list, "tuple": tuple, "scalars": np.float64}
"""All together 1,072 right answers in the full tier."""


@pytest.mark.one_in(4)
@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.title)
@pytest.mark.parametrize("way", WAYS)
def test_right_answer_in_another_form_gets_full_marks(
    task: Task, way: type[ast.NodeTransformer]
) -> None:
    """The order of factors and the form of a difference cost nothing, and need no hint."""
    for answer in right_answers(task.id, task.function):
        tree = way().visit(copy.deepcopy(answer.definition))
        module = ast.fix_missing_locations(ast.Module([tree], type_ignores=[]))
        names = {**answer.names, "count_round": lambda: None}
        exec(compile(module, "<right>", "exec"), names)  # noqa: S102 - the course's own source
        is_right(task, names["slip"])


@pytest.mark.one_in(4)
@pytest.mark.parametrize("task", TASKS, ids=lambda task: task.title)
@pytest.mark.parametrize("form", FORMS.values(), ids=FORMS)
def test_right_answer_of_another_type_gets_full_marks(task: Task, form: Callable[..., Any]) -> None:
    """Lists for tuples, tuples for arrays and NumPy's numbers for Python's are all right."""
    is_right(task, lambda *given: _as(form, task.expected(*given)))


def _as(form: Callable[..., Any], value: Any) -> Any:
    """Return an answer of another type."""
    if isinstance(value, list | tuple | np.ndarray):
        kind = tuple if form is np.float64 else form
        return kind([_as(form, item) for item in value])
    return form(value) if form is np.float64 and isinstance(value, float) else value


def is_right(task: Task, function: Callable[..., Any]) -> None:
    """Check that a function earns full marks, without a word."""
    verdict = judge(task, partial(call_here, {task.function: function}), SEED)
    assert verdict.lines == [f"{task.title}: {task.points}/{task.points} points"]
    assert verdict.diagnoses == ()
