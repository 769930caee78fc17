"""What the reader of notebook 09 writes: how slowly sweeps carry a load, and a weight, down."""

from __future__ import annotations

from random import Random

from lesson_code.course.grading.gaps import Gap
from lesson_code.course.grading.task import wrong_model


def part_left(ratio: float, sweeps: float) -> float:
    """Return which part of the load's velocity some sweeps leave."""
    return float((ratio / (ratio + 1)) ** sweeps)


@wrong_model("09-left", "A sweep takes a part of what is left. Is that as much each time?")
def the_same_amount_each_time(ratio: float, sweeps: float) -> float:
    """Every sweep takes the same amount."""
    return 1 - sweeps / (ratio + 1)


@wrong_model("09-left", "Which of the two loses more velocity to the other: the load, or the box?")
def the_share_of_the_box(ratio: float, sweeps: float) -> float:
    """What is left is the box's share of the mass."""
    return float((1 / (ratio + 1)) ** sweeps)


@wrong_model("09-left", "That is one sweep. What does the next one leave of what is left?")
def one_sweep_alone(ratio: float, sweeps: float) -> float:
    """All sweeps together leave what one leaves."""
    return ratio / (ratio + 1)


def sweeps_to_hear(boxes: int) -> int:
    """Return after how many sweeps the floor has heard of the highest box."""
    return boxes


@wrong_model("09-heard", "Two boxes: the floor is visited first. Has the load pushed by then?")
def one_too_few(boxes: int) -> int:
    """A sweep passes the weight on by one contact, and the first is free."""
    return boxes - 1


@wrong_model("09-heard", "Which contact is visited first, and where does the weight come from?")
def one_sweep_is_enough(boxes: int) -> int:
    """A sweep visits all contacts, so one is enough."""
    return 1


@wrong_model("09-heard", "Does the news have to come back up before the floor has heard it?")
def there_and_back(boxes: int) -> int:
    """The news goes down and up again."""
    return 2 * boxes


def load_and_sweeps(stream: Random) -> tuple[float, ...]:
    """Draw a ratio of masses and a number of sweeps."""
    return round(stream.uniform(1.5, 60), 1), stream.randint(2, 30)


def tower(stream: Random) -> tuple[int]:
    """Draw a number of boxes."""
    return (stream.randint(2, 40),)


GAPS = (
    Gap("09-left", part_left, load_and_sweeps,
        (the_same_amount_each_time, the_share_of_the_box, one_sweep_alone)),
    Gap("09-heard", sweeps_to_hear, tower, (one_too_few, one_sweep_is_enough, there_and_back)),
)  # fmt: skip
