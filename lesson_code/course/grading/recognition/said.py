"""What is said of the mistakes that explain an answer: of each kind one, and not the vaguest."""

from __future__ import annotations

from lesson_code.course.grading.recognition.around import AS_IT_SHOULD_BE
from lesson_code.course.grading.recognition.candidates import in_general
from lesson_code.course.grading.task import Task, WrongModel

MOST_SAID = 2
"""Mistakes that explain the same and are both said; of more, none is."""

VAGUEST = ("ignored", "term", "factor_missing", "as_one", "complement", "scaled")
"""Kinds of slips that are not said where others, made in the same place, explain the same."""

SAYS_MORE = {
    "sign": ("minus",), "other": ("order",), "index": ("other",), "ignored": ("fixed",),
    "complement": ("as_one",),
    "power_less": ("power",), "power_more": ("root",),
}  # fmt: skip
"""By kind the kinds that say more of the same answer: all signs, not one; the order of all; whose
quantity it is, not its place; that a body never moves; that something counts as 1; what is left
out, not what is too much."""

PLAINEST = "given"
"""A kind that is said alone: nothing else need be thought of where nothing was done."""


def said_of(found: list[WrongModel]) -> tuple[WrongModel, ...]:
    """Return one model of each kind that explains an answer: the only one with names, if any."""
    kinds: dict[str, dict[str, WrongModel]] = {}
    for model in found:
        kinds.setdefault(model.name, {})[model.hint] = model
    if PLAINEST in kinds:
        kinds = {PLAINEST: kinds[PLAINEST]}
    for kind, others in SAYS_MORE.items():
        if kinds.keys() & set(others):
            kinds.pop(kind, None)
    for kind in VAGUEST:
        if len(kinds) > MOST_SAID:
            kinds.pop(kind, None)
    return tuple(_of_one_kind(list(models.values())) for models in kinds.values())


def common_first(task: Task, found: list[WrongModel]) -> tuple[WrongModel, ...]:
    """Return the listed mistake that is in all of some pairs, whatever the other one is."""
    return tuple(
        model
        for model in task.wrong_models
        if all(pair.name.startswith(f"{model.name} and ") for pair in found)
    )


def _of_one_kind(models: list[WrongModel]) -> WrongModel:
    """Return the model that stands for some of one kind."""
    unnamed = in_general(models[0])
    named = [model for model in models if model.hint != unnamed.hint]
    named = [model for model in named if AS_IT_SHOULD_BE in model.hint] or named
    return named[0] if len(named) == 1 else unnamed
