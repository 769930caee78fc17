"""Slips about borders, sizes, mix-ups and the course of things: what they make of an answer."""

from __future__ import annotations

import ast

import pytest
from course.recognition.students import Wrong
from course.recognition.test_recognition import judged, verdict_of

from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.recognition.candidates import rarer_slips
from lesson_code.course.grading.recognition.in_source import RightAnswer, rarer_changes

MADE = (
    ("return 0 < t < dt", "condition", "return 0 < t"),
    ("return 0 < t < dt", "condition", "return t < dt"),
    ("return a < b", "strict", "return a <= b"),
    ("return a <= 0", "threshold", "return a <= 0.001"),
    ("return a >= b", "threshold", "return a >= b - 0.001"),
    ("return ceil(a)", "whole", "return int(round(a))"),
    ("return a // b", "whole", "return round(a / b)"),
    ("return max(-b, min(-a / k, b))", "limit", "return max(-b, min(-a, b)) / k"),
    ("return max(-1, min(1, a)) * k", "limit", "return max(-1, min(1, a * k))"),
    ("return None", "nothing", "return 0.0"),
    ("return hypot(a, b)", "length", "return abs(a) + abs(b)"),
    ("return dot(a, b)", "along", "return (a @ a) ** 0.5"),
    ("return a - b", "absolute", "return abs(a) - abs(b)"),
    ("return a - b", "one_sided", "return max(0, a - b)"),
    ("return a ** 2 + b ** 2", "squares", "return (a + b) ** 2"),
    ("return sqrt(a + b)", "squares", "return sqrt(a) + sqrt(b)"),
    ("for x in a:\n if x:\n  continue", "break_off", "break"),
    ("for x in a:\n if x:\n  b += x", "only_one", "b += x\n            break"),
    ("for x in a:\n b += x", "count", "for x in list(a)[1:]:"),
    ("return [x for x in a if x > 0]", "break_off", "if not [x > 0 for x in [one_]][0]"),
    ("if f(a):\n b = 1", "gate", "if True:"),
    ("a, b = (b, a)\nreturn b", "updated", "a = b\n        b = a"),
    ("b = f(a)\na += 1\nreturn b", "sequence", "a += 1\n    b = f(a)"),
    ("a = a + 1\nreturn a * b", "stale", "return old_value_a * b"),
    ("for x in b:\n c = f(a)\n a += c", "stale", "c = f(a)\n    for x in b"),
    ("left = dt\nfor x in a:\n left -= x", "anew", "left = dt\n        left -= x"),
    ("return (1 + k) * a", "as_one", "return (1 + 1) * a"),
    ("while a:\n a -= 1", "rounds", "in range(10):"),
    ("return log(a)", "base", "return log(a) * 0.434"),
    ("return 0.5 ** a", "base", "return 2.718281828459045 ** (-a)"),
    ("return 0.5 ** a", "straight", "return 1 - a"),
    ("return sin(a)", "straight", "return a"),
    ("return f(a, b, k)", "exchanged", "return f(a, k, b)"),
    ("return where(a, b, k)", "gate", "return where(a, k, b)"),
    ("return f(a)", "not_called", "return a"),
    ("mass = a\nreturn f(mass)", "fixed", "return f(1e309)"),
    ("return min(a), max(a)", "ends", "return (a[0], a[-1])"),
    ("return sum(a)", "count", "return sum(list(a)[:-1])"),
    ("return a / b", "whole", "return a // b"),
    ("return a / b", "ratio", "return a - b"),
    ("return k * a", "twice", "return k * a * k"),
    ("return a / (1 / b + 1 / k)", "together", "return a * (b + k)"),
    ("return a ** 2", "power_less", "return a ** 0.5"),
    ("return a[t]", "index", "return a[1 - t]"),
    ("return a / 3", "number", "return a / 2"),
    ("t = a + b\nreturn t, a - b", "sign", "t = a - b\n    return (t, a + b)"),
    ("return clip(a, b, k)", "clamp", "return maximum(a, b)"),
    ("return a * a + a * b + b * b", "factor", "return a * a + 2 * (a * b) + b * b"),
    ("return dot(a - b, k)", "along", "return (a @ a) ** 0.5 - (b @ b) ** 0.5"),
    ("t = a + b\nfor x in k:\n b += t * x", "stale", "b += a * x"),
    ("t = a ** 2 + b ** 2\nreturn t + a ** 2", "power", "t = a + b\n    return t + a ** 2"),
    ("t = a + b\nreturn a - t, b - t", "updated", "a = a - t\n        t = a + b"),
    ("a, b = (b + t, a + t)", "updated", "b = a + t\n        a = b + t"),
)
"""Lines of a right answer, the kind of a slip in them, and what stands there after it."""


@pytest.mark.parametrize(("lines", "kind", "expected"), MADE)
def test_slip_of_a_kind_is_made_and_taken_back(lines: str, kind: str, expected: str) -> None:
    """One of the slips of the kind writes what is expected, and the answer is left as it was."""
    body = "\n".join(f" {line}" for line in lines.splitlines())
    definition = ast.parse(f"def f(a, b, k, t, dt, left):\n{body}").body[0]
    assert isinstance(definition, ast.FunctionDef)
    answer = RightAnswer(definition, {})
    before, found = ast.unparse(definition), []
    for made, _, put, take_back in rarer_changes(answer):
        put()
        found += [ast.unparse(ast.fix_missing_locations(definition))] if made == kind else []
        take_back()
        assert ast.unparse(definition) == before
    assert any(expected in text for text in found), found


def test_nothing_is_mixed_up_in_what_is_compared() -> None:
    """A factor that counts twice in a comparison only moves a few calls to its other side."""
    definition = ast.parse("def f(a, b):\n if a * b < 2:\n  return a\n return b").body[0]
    assert isinstance(definition, ast.FunctionDef)
    made = {kind for kind, *_ in rarer_changes(RightAnswer(definition, {}))}
    assert "strict" in made
    assert not made & {"twice", "number"}


def test_rarer_slips_are_made_once_and_ask_a_question() -> None:
    """Each has a hint that asks and a misconception."""
    task = task_by_id("5.4")
    assert rarer_slips(task) is rarer_slips(task)
    assert all(model.hint.endswith("?") and model.misconception for model in rarer_slips(task))


SOME_CASES = Wrong(
    "6.4",
    "the first corners say which way the normal points",
    ("case", "sign"),
    """
import numpy as np

def mtv(a, b):
    ways = []
    for shape in (a, b):
        for n in range(len(shape)):
            x, y = shape[n] - shape[n - 1]
            if not x and not y:
                continue
            axis = np.array([y, -x]) / np.hypot(x, y)
            right, left = max(a @ axis) - min(b @ axis), max(b @ axis) - min(a @ axis)
            ways += [(right, axis), (left, -axis)]
    depth, normal = min(ways, key=lambda way: way[0])
    if depth <= 0:
        return None
    return normal if (b[0] - a[0]) @ normal > 0 else -normal, depth
""",
)

ALONG_THE_PATH = Wrong(
    "3.3",
    "the ball is taken back along its path, as long as it was in the wall",
    ("direction",),
    """
def resolve_wall(position, velocity, normal, depth, restitution):
    vn = velocity @ normal
    back = position - velocity * depth / abs(vn)
    return back, velocity - (1 + restitution) * min(vn, 0) * normal
""",
)


@pytest.mark.parametrize("wrong", [SOME_CASES, ALONG_THE_PATH], ids=lambda wrong: wrong.task)
def test_mistake_in_some_cases_and_one_of_direction_are_recognised(wrong: Wrong) -> None:
    """Where no mistake explains all calls, one that explains the wrong ones is said, as that."""
    (diagnosis,) = verdict_of(wrong).diagnoses
    assert any(word in diagnosis.name for word in wrong.found)
    assert diagnosis.hint.endswith("?")


@pytest.mark.parametrize(
    ("task", "kind", "change"),
    [
        ("7.1", "no_answer", "-1 if t is None else t"),
        ("7.1", "scaled", "t and t / dt"),
        ("7.3", "complement", "advance(p, v, room, 1 - restitution, dt)"),
    ],
)
def test_rarer_change_around_a_right_answer_is_recognised(
    task: str, kind: str, change: str
) -> None:
    """Something else for None, an argument as a factor of the answer, 1 - e for e."""
    asked = task_by_id(task)
    arguments = ", ".join(asked.parameters)
    names = {asked.function: asked.expected}
    exec(f"def slip({arguments}):\n t = {asked.function}({arguments})\n return {change}", names)  # noqa: S102
    found = judged(asked, names["slip"]).diagnoses
    assert [kind] == [diagnosis.name for diagnosis in found]
