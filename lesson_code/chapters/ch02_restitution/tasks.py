"""Tasks of chapter 02: restitution."""

from __future__ import annotations

from collections.abc import Iterator
from random import Random
from typing import Any

from lesson_code.chapters import draws
from lesson_code.chapters.ch01_one_dimension.tasks import (
    catching_up,
    momentum_before_and_after,
    moving_against,
    target_at_rest,
)
from lesson_code.course.grading.compare import written
from lesson_code.course.grading.task import Arguments, Criterion, Task
from lesson_code.formulas import collide_1d, restitution_1d
from lesson_code.reference.closed_forms import bounce_heights, rest_time


def _lossy(pair: Arguments, stream: Random) -> Arguments:
    """Return the arguments of a collision with a restitution of its own."""
    return (*pair, draws.restitution(stream))


def lossy_target_at_rest(stream: Random) -> Iterator[Arguments]:
    """Draw lossy collisions with a body at rest."""
    yield from (_lossy(pair, stream) for pair in target_at_rest(stream))


def lossy_head_on(stream: Random) -> Iterator[Arguments]:
    """Draw lossy collisions of bodies that move against each other."""
    yield from (_lossy(pair, stream) for pair in moving_against(stream))


def lossy_catching_up(stream: Random) -> Iterator[Arguments]:
    """Draw lossy collisions of a faster body with a slower one."""
    yield from (_lossy(pair, stream) for pair in catching_up(stream))


def limits(stream: Random) -> Iterator[Arguments]:
    """Draw a pair, once elastic and once sticking."""
    pair = next(moving_against(stream))
    yield (*pair, 1.0)
    yield (*pair, 0.0)


def velocities_head_on(stream: Random) -> Iterator[Arguments]:
    """Draw the velocities before and after lossy head-on collisions; one body just goes on."""
    yield from draws.until(
        lambda drawn: any(
            v1 * v1_after > 0 or v2 * v2_after > 0 for v1, v2, v1_after, v2_after in drawn
        ),
        lambda: [_before_and_after(arguments) for arguments in lossy_head_on(stream)],
    )


def velocities_catching_up(stream: Random) -> Iterator[Arguments]:
    """Draw the velocities before and after a faster body has met a slower one; one turns back."""
    yield from draws.until(
        lambda drawn: any(v1_after < 0 for _, _, v1_after, _ in drawn),
        lambda: [_before_and_after(arguments) for arguments in lossy_catching_up(stream)],
    )


def _before_and_after(arguments: Arguments) -> Arguments:
    """Return v1, v2, v1', v2' of a collision."""
    v1_after, v2_after = collide_1d(*arguments)
    return arguments[1], arguments[3], float(v1_after), float(v2_after)


def one_bounce(stream: Random) -> Iterator[Arguments]:
    """Draw drops of which the first rebound is asked."""
    for _ in range(2):
        yield _drop_height(stream), draws.restitution(stream), 1


def several_bounces(stream: Random) -> Iterator[Arguments]:
    """Draw drops of which some rebounds are asked; the last ones of the third are tiny."""
    for count in (3, 5):
        yield _drop_height(stream), draws.restitution(stream), count
    yield _drop_height(stream), round(stream.uniform(0.1, 0.2), 2), 4


def elastic_drop(stream: Random) -> Iterator[Arguments]:
    """Draw a drop without loss: every rebound is as high as the drop."""
    yield _drop_height(stream), 1.0, 4


def drops_on_earth(stream: Random) -> Iterator[Arguments]:
    """Draw drops under the gravity of the earth."""
    for _ in range(2):
        yield _drop_height(stream), draws.restitution(stream), 9.81


def drops_elsewhere(stream: Random) -> Iterator[Arguments]:
    """Draw drops under other gravities, one of them onto clay, where nothing bounces."""
    yield _drop_height(stream), draws.restitution(stream), 1.62
    yield _drop_height(stream), 0.0, 3.71


def _drop_height(stream: Random) -> float:
    """Return a height to drop from, m."""
    return round(stream.uniform(0.5, 5.0), 2)


def energy_factor(arguments: Arguments, _answer: Any) -> str:
    """Say what the height after one bounce is, and why."""
    height, restitution = arguments[:2]
    factor = restitution**2
    return f"One bounce leaves e^2 = {written(factor)} of {written(height)} m."


TASKS = (
    Task(
        id="2.1",
        function="restitution_1d",
        section=1,
        objective="The restitution shown by four measured velocities.",
        expected=restitution_1d,
        criteria=(
            Criterion("bodies that met head on", velocities_head_on, points=2),
            Criterion("one body that caught up", velocities_catching_up),
        ),
    ),
    Task(
        id="2.2",
        function="collide_1d",
        section=2,
        objective="Both velocities after a collision with any restitution.",
        expected=collide_1d,
        criteria=(
            Criterion("the second at rest", lossy_target_at_rest),
            Criterion("head on", lossy_head_on),
            Criterion("one catching up", lossy_catching_up),
            Criterion("the limits e = 1 and e = 0", limits),
        ),
        explain=momentum_before_and_after,
    ),
    Task(
        id="2.3",
        function="bounce_heights",
        section=3,
        objective="The heights a ball reaches after each of its first bounces.",
        expected=bounce_heights,
        criteria=(
            Criterion("the first bounce", one_bounce),
            Criterion("several bounces", several_bounces),
            Criterion("no loss", elastic_drop),
        ),
        explain=energy_factor,
    ),
    Task(
        id="2.4",
        function="rest_time",
        section=4,
        objective="The time at which the bouncing has come to an end.",
        expected=rest_time,
        criteria=(
            Criterion("on earth", drops_on_earth, points=2),
            Criterion("on the moon, and onto clay", drops_elsewhere),
        ),
    ),
)
