"""Wrong models of chapter 10: who may sleep."""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.course.grading.task import edited, wrong_model

Vector: TypeAlias = Any
Table: TypeAlias = Any


@wrong_model("10.5", "A still body carries one that trembles. Will it stay still?")
def each_for_itself(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """What is still may sleep."""
    return [n for n in range(len(still)) if inverse_masses[n] > 0 and still[n]]


@wrong_model("10.5", "The neighbour of a neighbour moves. Does that reach the body?")
def only_neighbours(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """What is still and touches nothing that moves may sleep."""
    free = [n for n in range(len(still)) if inverse_masses[n] > 0]
    awake = [n for n in free if not still[n]]
    return [n for n in free if still[n] and not any(touches[n][k] for k in awake)]


@wrong_model("10.5", "A push goes on from body to body. After how many of them does it end?")
@edited(
    only_neighbours,
    {
        "    return [": (
            "    awake = [n for n in free if n in awake or any(touches[n][k] for k in awake)]\n"
            "    return ["
        )
    },
)
def neighbours_of_neighbours() -> None:
    """What is still, as its neighbours are and theirs, may sleep."""


@wrong_model(
    "10.5", "Two piles stand on one floor. Does the floor carry a push from one to the other?"
)
def floors_join(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """Whatever hangs together by contacts is one island, the floor included."""
    count = len(still)
    awake = {n for n in range(count) if not still[n]}
    for _ in range(count):
        awake |= {n for n in range(count) if any(touches[n][k] for k in awake)}
    return [n for n in range(count) if inverse_masses[n] > 0 and n not in awake]


@wrong_model("10.5", "One body still flies. Must a pile far away stay awake for it?")
def all_or_none(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """The scene sleeps when everything in it is still."""
    return [n for n in range(len(still)) if inverse_masses[n] > 0] if all(still) else []


@wrong_model("10.5", "Is the floor in your answer? Can it be pushed?")
def floors_sleep(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """The floor sleeps too."""
    count = len(still)
    awake = {n for n in range(count) if not still[n]}
    for _ in range(count):
        near = {n for n in range(count) if any(touches[n][k] for k in awake)}
        awake |= {n for n in near if inverse_masses[n] > 0}
    return [n for n in range(count) if n not in awake]


@wrong_model("10.5", "You go through the bodies once. Who wakes one that you have passed already?")
def woken_in_one_pass(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """Going through the bodies once, from the first to the last, wakes all that have to wake."""
    free = [n for n in range(len(still)) if inverse_masses[n] > 0]
    awake = {n for n in free if not still[n]}
    for n in free:
        awake |= {n} if any(touches[n][k] for k in awake) else set()
    return [n for n in free if n not in awake]


@wrong_model("10.5", "One of a pile is still and the others move. May the pile sleep?")
def one_still_is_enough(inverse_masses: Vector, still: Vector, touches: Table) -> list[int]:
    """An island sleeps if one of its bodies is still."""
    free = [n for n in range(len(still)) if inverse_masses[n] > 0]
    asleep = {n for n in free if still[n]}
    for _ in free:
        asleep |= {n for n in free if any(touches[n][k] for k in asleep)}
    return sorted(asleep)


@wrong_model("10.5", "A body hangs in space and touches nothing. Is it an island?")
@edited(
    floors_sleep,
    {
        "for n in range(count) if n not in": (
            "for n in range(count) if inverse_masses[n] > 0 and any(touches[n]) and n not in"
        )
    },
)
def alone_is_no_island() -> None:
    """An island has two bodies or more, so what touches nothing never sleeps."""
