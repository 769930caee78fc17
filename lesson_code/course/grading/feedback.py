"""What a student is told: what was called, what came of it, what was expected and why.

No traceback: an error is named with its place in the student's own code, and with a question that
such an error usually answers.
"""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable
from typing import Any

from lesson_code.course.grading import difference
from lesson_code.course.grading.compare import shortened, told_apart, written
from lesson_code.course.grading.task import Arguments, Task
from lesson_code.course.grading.tried import TriedCall, of_any_answer
from lesson_code.course.isolation.inside.answers import plain
from lesson_code.course.isolation.inside.imports import THE_LIST
from lesson_code.course.isolation.inside.reading import AWAITED

NOT_WRITTEN = "not written yet"

LEFT_OUT = "which is left out"
"""What is said of an import that no answer may use, and of a line that waits."""

ON_ITS_OWN = "an answer stands on its own"

NO_ORDER = "returned a set where the order counts: a set has none, a list or tuple has"

SAYS_ALL = ("missing", "not called")
"""Kinds of outcome whose own words are the message: nothing was called."""

QUESTIONS = {
    "ZeroDivisionError": "Which inputs make that zero?",
    "NameError": "Is the name spelt as it was where it got its value?",
    "UnboundLocalError": "Does it get its value on every way through the function?",
    "IndexError": "How many entries are there? Counting starts at 0.",
    "TypeError": "Is each of these a number or a vector, as the task says?",
    "RecursionError": "When does the function stop calling itself?",
}
"""What to ask oneself after an error, by its name."""

HIDDEN = {
    "returned": "It returned something else than expected.",
    "raised": "It stopped with an error.",
    "unusable": "It returned something that is no number, vector or tuple.",
}
"""The message for each kind of outcome while inputs stay hidden: no word of it is the student's."""


HIDDEN_FORMS = {
    ("None", "number"): "It returned None where a number was asked for.",
    ("None", "list"): "It returned None where several values were asked for.",
    ("number", "list"): "It returned one number where several values were asked for.",
    ("list", "number"): "It returned several values where one number was asked for.",
    ("number", "None"): "It returned a number where None was asked for.",
    ("list", "None"): "It returned values where None was asked for.",
    ("text", "number"): "It returned a text where a number was asked for.",
    ("text", "list"): "It returned a text where several values were asked for.",
}
"""What may be said of an answer of another kind than asked for while inputs stay hidden."""


def message(task: Task, call: TriedCall, *, may_be_none: bool = False) -> tuple[str, str]:
    """Return what to say of a call that did not do what was asked, and the reason in short.

    The reason names no input: two failures of the same reason need not both be told at length. It
    is empty where nothing but the numbers is wrong.

    Parameters
    ----------
    task : Task
        What is asked.
    call : TriedCall
        What was called, what came of it, and what should have.
    may_be_none : bool
        Whether None is the right answer to some calls.
    """
    outcome = call.outcome
    if outcome.kind == "not written":
        return NOT_WRITTEN, NOT_WRITTEN
    if outcome.kind in SAYS_ALL:
        return outcome.text, outcome.text
    called = f"Called {call_of(task, call.arguments)}."
    if outcome.kind == "raised":
        said = f"{called} It stopped with {outcome.text}. {_question(outcome.text)}"
        return said.rstrip(), outcome.text
    if outcome.kind != "returned":
        said = f"it {outcome.text}" if outcome.kind == "unusable" else outcome.text
        return f"{called} {_sentence(said)}", outcome.text
    got, expected = call.got, call.wanted
    if _has_another_form(call) or got is None:
        got, expected = outcome.value, call.expected
    looks = difference.of_form(got, expected, may_be_none=may_be_none)
    if not looks:
        looks = _of_values(task, call)
        why = _explained(task, call.arguments, outcome.value)
        return f"{called} {' '.join(filter(None, (_shown(call), looks, why)))}", looks
    return f"{called} {_shown(call)} {looks}", looks


def _of_values(task: Task, call: TriedCall) -> str:
    """Return in a sentence how the values of an answer of the right form differ, or nothing."""
    given = dict(zip(task.parameters, plain(list(call.arguments)), strict=False))
    return difference.of_given(call.got, call.wanted, given) or difference.of_numbers(
        call.got, call.wanted
    )


def _has_another_form(call: TriedCall) -> bool:
    """Return whether an answer is of another kind than asked for, before its part is looked at."""
    got, expected = _kinds_of(call)
    return got != expected


def _shown(call: TriedCall) -> str:
    """Return what came and what was expected; what a criterion looks at beside what came."""
    returned = call.outcome.value
    if call.got is None and returned is not None:  # it has no part of the kind that is looked at
        return "It returned {}; expected {}.".format(*told_apart(returned, call.expected))
    got, expected = told_apart(call.got, call.wanted)
    if call.criterion.part is None or _first_kinds(call.got) == _first_kinds(returned):
        return f"It returned {got}; expected {expected}."
    return (
        f"It returned {shortened(written(returned))}, which counts as {got}; expected {expected}."
    )


def _first_kinds(value: Any) -> tuple[str, ...]:
    """Return of what kind a list is, and its first value, where a criterion puts it in order."""
    is_list = difference.kind_of(value) == "list"
    return ("list", *map(difference.kind_of, value[:1])) if is_list else (repr(value),)


def call_of(task: Task, arguments: Arguments) -> str:
    """Return a call as a message shows it: arguments with their names, where these are known."""
    values = list(map(written, arguments))
    if len(task.parameters) == len(values):
        pairs = zip(task.parameters, values, strict=True)
        values = [f"{name}={value}" for name, value in pairs]
    return f"{task.function}({', '.join(values)})"


def hidden_message(call: TriedCall) -> tuple[str, str]:
    """Return a message without inputs, values and the words of errors, and its reason in short.

    How many values were asked for is not said: that may tell a number of an input.
    """
    outcome = call.outcome
    if outcome.kind == "not written":
        return NOT_WRITTEN, NOT_WRITTEN
    if outcome.kind in SAYS_ALL:
        return outcome.text, outcome.text
    said = HIDDEN.get(outcome.kind, _sentence(outcome.text))
    if outcome.text == NO_ORDER:
        said = _sentence(f"it {NO_ORDER}")
    if outcome.kind == "returned":
        said = HIDDEN_FORMS.get(_kinds_of(call), said)
    return said, said


def _kinds_of(call: TriedCall) -> tuple[str, str]:
    """Return of what kind an answer is, and of what kind it should be."""
    return difference.kind_of(call.outcome.value), difference.kind_of(call.expected)


def _sentence(text: str) -> str:
    """Return a text as a sentence."""
    return f"{text[:1].upper()}{text[1:]}."


def _question(text: str) -> str:
    """Return what to ask oneself after an error, unless its text says the reason.

    >>> _question("NameError: name 'np' is not defined (your answer.py, line 2)")
    'Is `import numpy as np` missing?'
    """
    kind = text.partition(":")[0]
    name = text.removeprefix("NameError: name '").partition("'")[0]
    if LEFT_OUT in text:
        return ""
    if kind == "NameError" and (line := _import_of(name)):
        return f"Is `{line}` missing?"
    return QUESTIONS.get(kind, "")


def _import_of(name: str) -> str:
    """Return the import that is likely to be missing where a name is, or nothing."""
    if name == "np":
        return "import numpy as np"
    if name in ("numpy", "math", "cmath", "itertools", "functools", "random", "copy"):
        return f"import {name}"
    return f"from math import {name}" if hasattr(math, name) else ""


def _explained(task: Task, arguments: Arguments, answer: Any) -> str:
    """Return why an answer is wrong, if the task can say it of an answer of this form."""
    if task.explain is None:
        return ""
    explain = task.explain
    return shortened(str(of_any_answer(lambda: explain(arguments, answer), "")))


def left_out_name(text: str, left_out: dict[str, str]) -> str:
    """Return why a name is missing, if what gives it, or may give it, is left out when grading.

    >>> left_out_name("NameError: name 'mtv' is not defined", {"mtv": "an import of lesson_code"})
    'mtv comes from an import of lesson_code, which is left out: an answer stands on its own'
    >>> left_out_name("NameError: name 'mtv' is not defined", {"*": "an import of lesson_code"})
    'mtv may come from an import of lesson_code, which is left out: an answer stands on its own'
    >>> left_out_name("NameError: name 'plt' is not defined", {"plt": "an import of matplotlib"})
    "plt comes from an import of matplotlib, which is left out: answers can use Python's own ..."
    """
    name = text.removeprefix("NameError: name '").partition("'")[0]
    source = left_out.get(name) or left_out.get("*")
    if not text.startswith("NameError") or not source:
        return ""
    rules = {AWAITED: "give it its value without await", "an import of lesson_code": ON_ITS_OWN}
    comes = "comes" if name in left_out else "may come"
    return f"{name} {comes} from {source}, {LEFT_OUT}: {rules.get(source, THE_LIST)}"


def missing_function(function: str, others: Iterable[str], lost: dict[str, str]) -> str:
    """Return what to say of a function that is not there: why, or under which name it may be.

    Parameters
    ----------
    function : str
        The function that was asked for.
    others : iterable of str
        Functions of the submission that answer no task.
    lost : dict
        Why code could not be read, by the functions that stand in it.

    >>> missing_function("elastic_1d", ["elastic1d", "helper"], {})
    'there is no function named elastic_1d; did you mean elastic1d?'
    """
    if function in lost:
        return f"{function} could not be read ({lost[function]})"
    near = difflib.get_close_matches(function, list(others), n=1)
    if near:
        return f"{not_there(function)}; did you mean {near[0]}?"
    return not_there(function)


def not_there(function: str) -> str:
    """Return what is said of a function that nothing in a submission looks like."""
    return f"there is no function named {function}"
