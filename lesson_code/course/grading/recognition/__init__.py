"""Why an answer is wrong: by the models that a chapter lists, and by slips that a machine makes.

A mistake is recognised where the answer differs from the right one. Of all wrong models that give
the student's own numbers there, and are right wherever the student is, those count that explain
the most criteria. Calls of a degenerate kind stand apart: there an answer often is right, or fails,
for a reason of its own. Where more than two kinds of mistakes explain the same, nothing is said.
"""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, TypeAlias

from lesson_code.course.grading.compare import agrees
from lesson_code.course.grading.recognition.candidates import (
    any_case,
    in_cases,
    inherited,
    listed,
    pairs,
    parameters,
    passed_over,
    rarer_slips,
    slips,
)
from lesson_code.course.grading.recognition.directions import direction_of
from lesson_code.course.grading.recognition.said import MOST_SAID, common_first, said_of
from lesson_code.course.grading.recognition.sampled import samples_of
from lesson_code.course.grading.recognition.telling import (
    holds_a_telling_number,
    is_degenerate,
    signature,
    telling_numbers,
    worked_out_numbers,
)
from lesson_code.course.grading.task import Task, WrongModel
from lesson_code.course.grading.tried import TriedCall
from lesson_code.course.isolation.inside.answers import arguments_from, plain
from lesson_code.course.isolation.inside.vectors import numbers, places_near, unwarned

ENOUGH_TELLING_CALLS = 2
"""Wrong calls with telling numbers that a listed model must explain if it explains a part."""

ENOUGH_TELLING_NUMBERS = 2
"""Numbers that tell, in all wrong calls, where a mistake is made in some cases only."""

ENOUGH_PLAIN_CALLS = 3
"""Wrong calls that a slip must explain where an answer holds no number that luck cannot give, and
from which on it is seen in which way a loop reaches too few."""

TASKS_REMEMBERED = 128
"""Tasks for which a grader keeps what models make of a draw: more than the course has."""

SINGLE = (listed, inherited, slips, rarer_slips)
LIKELIER_FIRST = (*SINGLE, pairs)
"""Where mistakes are looked for, in this order; a second one beside another is single."""

OF_CASES = (
    "gate", "condition", "and_or", "strict", "threshold", "unchanged", "minus", "sign", "order",
    "absolute", "one_sided", "clamp", "minmax", "whole", "only_one", "break_off", "stale",
)  # fmt: skip
"""Kinds of slips that may be made in some cases only: not those in a formula, since a formula is
the same in all."""

OF_ORDER = ("order",)
"""Kinds of slips after which an answer holds the right numbers."""

OF_SIZES = {"threshold": 2, "length": 3, "along": 2, "squares": 2}
"""Kinds of slips about how large something is, and how many wrong calls they must explain: of so
many sizes that are tried one may well put a single call on the other side of a border, or make
another thing the least."""

OF_ROUNDS = ("count", "only_one", "break_off", "once")
"""Kinds of slips by which a loop reaches too few: seldom seen, they cannot be told apart."""

SURE = "no_answer"
"""A kind that is seen from plain answers that are all the same: it is about nothing else."""

NEAR = 1e-6
"""Relative difference up to which two signatures may belong to answers that agree: far above the
tolerance of answers, and so small that few others come through."""

NO_ANSWER = "no answer"
"""Stands where a wrong model gives none; no task asks for these words."""


Number: TypeAlias = tuple[str, int]
"""The name of a criterion and the place of a call among its own: the same for all answers, also for
one after which a criterion's other calls were not made."""

Models: TypeAlias = Callable[[Task], tuple[WrongModel, ...]]

Numbered: TypeAlias = tuple[Number, TriedCall]


@dataclass(frozen=True)
class Diagnosis:
    """What explains an answer: a mistake, or one of two, and the criteria where it does."""

    mistakes: tuple[WrongModel, ...]
    criteria: tuple[str, ...]
    is_all: bool

    @property
    def name(self) -> str:
        """The name of the mistake, or both names."""
        return " or ".join(dict.fromkeys(mistake.name for mistake in self.mistakes))

    @property
    def hint(self) -> str:
        """The hint, or both."""
        return " Or: ".join(mistake.hint for mistake in self.mistakes)

    @property
    def misconception(self) -> str:
        """What a student believes who makes the mistake."""
        return " Or: ".join(mistake.misconception for mistake in self.mistakes)


def diagnoses(task: Task, calls: Sequence[TriedCall], seed: int) -> tuple[Diagnosis, ...]:
    """Return what explains a wrong answer: nothing, one mistake, or two in different criteria."""
    if all(call.is_right for call in calls):
        return ()
    evidence = Evidence(task, calls, seed)
    if not evidence.failed:
        return ()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of slips, which do what nobody would
        first = evidence.best(evidence.failed)
        if first is None:
            return ()
        rest = [name for name in evidence.failed if name not in first.criteria]
        second = evidence.best(rest, evidence.single(rest)) if rest else None
    return (first,) if second is None else (first, second)


class Evidence:
    """The calls of one answer, and what wrong models make of them."""

    def __init__(self, task: Task, calls: Sequence[TriedCall], seed: int) -> None:
        self._task = task
        self._made = _made_with(task, seed)
        self._calls: dict[str, list[Numbered]] = {}
        for call in calls:
            some = self._calls.setdefault(call.criterion.name, [])
            some.append(((call.criterion.name, len(some)), call))
        self._right = [
            (number, call)
            for some in self._calls.values()
            for number, call in some
            if call.is_right and not is_degenerate(call.arguments)
        ]
        self._wrong = {name: _telling(some) for name, some in self._calls.items()}
        failed = [name for name, some in self._wrong.items() if some]
        self.failed = [name for name in failed if not _all_degenerate(self._wrong[name])] or failed
        self._apart = [name for name in failed if name not in self.failed]

    def single(self, criteria: Sequence[str]) -> Sequence[Models]:
        """Return where a mistake in the rest of an answer is looked for: few calls tell no slip."""
        return SINGLE if self._telling_calls(criteria) >= ENOUGH_TELLING_CALLS else (listed,)

    def best(
        self, criteria: Sequence[str], looked_for: Sequence[Models] = LIKELIER_FIRST
    ) -> Diagnosis | None:
        """Return the mistakes that explain the most of some criteria, if they are at most two."""
        best: tuple[str, ...] = ()
        found: list[WrongModel] = []
        for models_of in looked_for:  # each is made if needed
            if models_of is pairs and not self._holds_enough(criteria):
                break
            explained = self._explained_by(models_of(self._task), criteria)
            if models_of is pairs and 2 * len(best) > len(criteria):
                explained = _with_one_of(found, explained)
            most = max(explained.values(), key=len, default=())
            some = [model for model, names in explained.items() if names == most]
            is_doubted = models_of is rarer_slips or best
            if len(most) > len(best) and not (
                is_doubted and len(self._said(some, most)) > MOST_SAID
            ):
                best, found = most, some
            if len(best) == len(criteria):
                break
        said = self._said(found, best) if best else self._in_some_cases(criteria)
        best = best or tuple(criteria)
        if len(said) > MOST_SAID:
            said = common_first(self._task, found)
        if not said:
            return None
        beside = [name for name in self._apart if self._gives_all(said[0], self._wrong[name])]
        return Diagnosis(said, (*best, *beside), is_all=len(best) == len(self.failed))

    def _in_some_cases(self, criteria: Sequence[str]) -> tuple[WrongModel, ...]:
        """Return what explains all wrong calls though it is wrong in others, too, or a direction.

        Then cases are told apart in another way than they should be.
        """
        told = [name for name in criteria if self._returned(name)]
        wrong = self._wrong_calls(criteria)
        calls = [call for _, call in wrong]
        kinds: Sequence[str] = OF_CASES
        if sum(map(telling_numbers, calls)) < ENOUGH_TELLING_NUMBERS:
            kinds = OF_ORDER  # what was worked out is right then, and may stand elsewhere
            if sum(map(worked_out_numbers, calls)) < ENOUGH_TELLING_NUMBERS:
                return ()
        found = [
            models[index]
            for models in (listed(self._task), slips(self._task), rarer_slips(self._task))
            for index in self._near(models, told[0])
            if models[index].name in kinds or (kinds is OF_CASES and models is listed(self._task))
            if self._is_seen(models[index], criteria)
            if self._gives_all(models[index], wrong)
        ]
        if found:
            said = self._said(found, criteria)
            return tuple(map(in_cases, said)) if len(said) <= MOST_SAID else (any_case(found[0]),)
        names = parameters(self._task)
        for seen_in in (direction_of, samples_of) if names and kinds is OF_CASES else ():
            seen = seen_in(self._task, names, calls)
            if seen is not None:
                return (seen,)
        return ()

    def _explained_by(
        self, models: tuple[WrongModel, ...], criteria: Sequence[str]
    ) -> dict[WrongModel, tuple[str, ...]]:
        """Return in which criteria each model explains the answer, of those that do.

        Only a listed model may explain a part: another one is tried in the first criterion alone.
        """
        told = [name for name in criteria if self._returned(name)]
        tried = told if models is listed(self._task) else told[:1]
        near = sorted({index for name in tried for index in self._near(models, name)})
        found = {models[index]: self._explained(models[index], criteria) for index in near}
        return {model: explained for model, explained in found.items() if explained}

    def _near(self, models: tuple[WrongModel, ...], criterion: str) -> Iterable[int]:
        """Return which models give nearly the first wrong answer that came back for a criterion.

        One number stands for each answer, so that thousands are compared at once.
        """
        number, call = self._returned(criterion)[0]
        key = id(models), number
        if key not in self._made:
            answers = (signature(self._answer(model, number, call)) for model in models)
            self._made[key] = models, numbers(answers, len(models))  # kept, and so is its id
        mine = signature(call.got)
        return places_near(self._made[key][1], mine, NEAR * max(1.0, abs(mine)))

    def _returned(self, criterion: str) -> list[Numbered]:
        """Return the wrong calls of a criterion in which something came back."""
        return [each for each in self._wrong[criterion] if each[1].outcome.kind == "returned"]

    def _explained(self, model: WrongModel, criteria: Sequence[str]) -> tuple[str, ...]:
        """Return in which of some criteria a model gives the student's own numbers.

        A slip explains all of them or none: there are so many slips that one may fit a part by
        luck.
        """
        explained = [name for name in criteria if self._gives_all(model, self._wrong[name])]
        if not explained or not self._gives_all(model, self._right):
            return ()
        if not self._is_seen(model, explained):
            return ()
        is_listed, is_part = model in self._task.wrong_models, len(explained) < len(criteria)
        told = [call for _, call in self._wrong_calls(explained)]
        telling = self._telling_calls(explained)
        if is_part and not (
            is_listed and telling >= ENOUGH_TELLING_CALLS and 2 * len(explained) >= len(criteria)
        ):
            return ()
        is_sure = is_listed or model.name == SURE or _varies(told)
        if telling or (is_sure and self._gives_every_call(model)):
            return tuple(explained)
        return ()

    def _said(self, found: list[WrongModel], criteria: Iterable[str]) -> tuple[WrongModel, ...]:
        """Return what is said of mistakes that explain some criteria."""
        if self._seen_in(criteria) < ENOUGH_PLAIN_CALLS:
            found = [passed_over(model) if model.name in OF_ROUNDS else model for model in found]
        return said_of(found)

    def _is_seen(self, model: WrongModel, criteria: Iterable[str]) -> bool:
        """Return whether some criteria hold enough wrong calls for a mistake to be seen in them."""
        return self._seen_in(criteria) >= OF_SIZES.get(model.name, 0)

    def _seen_in(self, criteria: Iterable[str]) -> int:
        """Return how many wrong calls some criteria hold."""
        return len(self._wrong_calls(criteria))

    def _wrong_calls(self, criteria: Iterable[str]) -> list[Numbered]:
        """Return the wrong calls of some criteria, one after the other."""
        return [each for name in criteria for each in self._wrong[name]]

    def _telling_calls(self, criteria: Iterable[str]) -> int:
        """Return how many wrong calls of some criteria hold a number that luck cannot give."""
        return sum(holds_a_telling_number(call) for _, call in self._wrong_calls(criteria))

    def _holds_enough(self, criteria: Iterable[str]) -> bool:
        """Return whether answers hold more than a whole number, which two mistakes give by luck."""
        return any(
            isinstance(call.got, list) or telling_numbers(call)
            for _, call in self._wrong_calls(criteria)
        )

    def _gives_every_call(self, model: WrongModel) -> bool:
        """Return whether a model does so in all calls, the right ones as well."""
        return all(self._gives_all(model, calls) for calls in self._calls.values())

    def _gives_all(self, model: WrongModel, calls: Iterable[Numbered]) -> bool:
        """Return whether a model does what the student's function did, failing where it failed."""
        return all(
            agrees(call.got, answer) if call.outcome.kind == "returned" else answer == NO_ANSWER
            for number, call in calls
            for answer in [self._answer(model, number, call)]
        )

    def _answer(self, model: WrongModel, number: Number, call: TriedCall) -> Any:
        """Return what a criterion looks at of a model's answer to a call."""
        key = model.function, number  # not its id, which another model may get later
        if key not in self._made:
            self._made[key] = answer_of(model, call)
        return self._made[key]


def _with_one_of(
    found: list[WrongModel], explained: dict[WrongModel, tuple[str, ...]]
) -> dict[WrongModel, tuple[str, ...]]:
    """Return the pairs that hold a mistake which explains most of an answer by itself."""
    first = tuple(f"{model.name} and " for model in found)
    return {pair: names for pair, names in explained.items() if pair.name.startswith(first)}


def answer_of(model: WrongModel, call: TriedCall) -> Any:
    """Return what a criterion looks at of a model's answer to a call, or NO_ANSWER."""
    part = call.criterion.part
    try:
        with unwarned(), contextlib.redirect_stdout(None):
            answer = plain(model(*arguments_from(call.arguments)))
            return answer if part is None else plain(part(answer))
    except Exception:  # a wrong model may fail in any way
        return NO_ANSWER


@lru_cache(maxsize=TASKS_REMEMBERED)
def _made_with(_task: Task, _seed: int) -> dict[tuple[Any, Number], Any]:
    """Return what models make of the calls that a seed draws: worked out once for a class."""
    return {}


def _telling(calls: list[Numbered]) -> list[Numbered]:
    """Return the wrong calls of a criterion: those that are not degenerate, if there are any."""
    wrong = [(number, call) for number, call in calls if not call.is_right]
    return [each for each in wrong if not is_degenerate(each[1].arguments)] or wrong


def _varies(calls: list[TriedCall]) -> bool:
    """Return whether there are enough plain answers to tell slips apart, and not all the same."""
    answers = [call.outcome.value for call in calls]
    return len(calls) >= ENOUGH_PLAIN_CALLS and any(answer != answers[0] for answer in answers)


def _all_degenerate(calls: list[Numbered]) -> bool:
    """Return whether all calls have a special case in them."""
    return all(is_degenerate(call.arguments) for _, call in calls)
