"""Tasks of chapter 01: collisions on a line."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

from lesson_code.chapters import draws
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.formulas import collide_1d, elastic_1d, inelastic_1d


def equal_masses(stream: Random) -> Iterator[Arguments]:
    """Draw two bodies of the same mass."""
    for _ in range(2):
        m, (v1, v2) = round(stream.uniform(0.5, 4.0), 2), draws.head_on(stream)
        yield m, v1, m, v2


def target_at_rest(stream: Random) -> Iterator[Arguments]:
    """Draw a body that hits one at rest, also one that is far lighter or heavier."""
    for _ in range(2):
        m1, m2 = draws.unequal_masses(stream)
        yield m1, draws.speed(stream), m2, 0.0
    light, heavy = round(stream.uniform(0.5, 2.0), 2), round(stream.uniform(30, 60), 2)
    yield light, draws.speed(stream), heavy, 0.0
    yield heavy, draws.speed(stream), light, 0.0


def moving_against(stream: Random) -> Iterator[Arguments]:
    """Draw unequal bodies that move against each other."""
    for _ in range(3):
        (m1, m2), (v1, v2) = draws.unequal_masses(stream), draws.head_on(stream)
        yield m1, v1, m2, v2


def catching_up(stream: Random) -> Iterator[Arguments]:
    """Draw an unequal pair of which the first catches up with the second."""
    for _ in range(3):
        (m1, m2), (v1, v2) = draws.unequal_masses(stream), draws.catching_up(stream)
        yield m1, v1, m2, v2


def momentum_before_and_after(arguments: Arguments, answer: Any) -> str:
    """Say what the momentum was and what the answer makes of it."""
    m1, v1, m2, v2 = arguments[:4]
    before = _total_momentum(m1, v1, m2, v2)
    try:
        v1_after, v2_after = map(float, answer)
        after = m1 * v1_after + m2 * v2_after
    except (TypeError, ValueError):
        return f"Two velocities were asked for; the momentum before is {written(before)} kg m/s."
    if written(after) == written(before):
        return (
            f"Momentum stays {written(before)} kg m/s, as it should. The bodies approach at "
            f"{written(v1 - v2)} m/s and part, by yours, at {written(v2_after - v1_after)} m/s."
        )
    return f"Momentum before {written(before)} kg m/s, after yours {written(after)} kg m/s."


def _total_momentum(m1: float, v1: float, m2: float, v2: float) -> float:
    """Return the momentum of two bodies on a line, kg m/s."""
    return m1 * v1 + m2 * v2


def _impulse(m1: float, v1: float, m2: float, v2: float) -> float:
    """Return the impulse on body 2: what its momentum gains in an elastic collision."""
    return float(m2 * (collide_1d(m1, v1, m2, v2, 1)[1] - v2))


TASKS = (
    Task(
        id="1.1",
        function="elastic_1d",
        section=3,
        objective="Both velocities after an elastic collision of any two bodies on a line.",
        expected=elastic_1d,
        criteria=(
            Criterion("equal masses", equal_masses),
            Criterion("unequal masses, the second at rest", target_at_rest),
            Criterion("unequal masses, head on", moving_against),
            Criterion("unequal masses, one catching up", catching_up),
        ),
        explain=momentum_before_and_after,
    ),
    Task(
        id="1.2",
        function="inelastic_1d",
        section=2,
        objective="The common velocity of two bodies that stick together, given twice.",
        expected=inelastic_1d,
        criteria=(
            Criterion("equal masses", equal_masses),
            Criterion("unequal masses, head on", moving_against),
            Criterion("unequal masses, one catching up", catching_up),
        ),
        explain=momentum_before_and_after,
    ),
    Task(
        id="1.3",
        function="elastic_impulse_1d",
        section=1,
        objective="The impulse that body 2 receives in an elastic collision.",
        expected=_impulse,
        criteria=(
            Criterion("the second at rest", target_at_rest),
            Criterion("head on", moving_against),
            Criterion("one catching up", catching_up),
        ),
    ),
)
