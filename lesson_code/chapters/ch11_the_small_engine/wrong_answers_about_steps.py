"""Wrong models of chapter 11: a step."""

from __future__ import annotations

from lesson_code.chapters.ch11_the_small_engine.right_answers import pair_by_pair_and_wall_by_wall
from lesson_code.course.grading.task import edited, wrong_model


@wrong_model(
    "11.3", "Which velocity moves the disc in your step: that at its start, or that at its end?"
)
@edited(
    pair_by_pair_and_wall_by_wall,
    {"p = positions + velocities * dt": "p = positions + v * dt"},
)
def falls_before_it_moves() -> None:
    """Gravity comes first, and the new velocity moves the discs."""


@wrong_model("11.3", "Read step 1 of the task again. With which velocity do the discs move?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"positions + velocities * dt": "positions + velocities * dt + gravity * dt**2 / 2"},
)
def falls_as_it_moves() -> None:
    """In a step a disc moves by v t + g t^2 / 2, as in free fall."""


@wrong_model(
    "11.3",
    "A disc beyond the wall is on its way in already. Which way does it fly after your step?",
)
@edited(pair_by_pair_and_wall_by_wall, {"v[out, axis] *=": "v[left | right, axis] *="})
def walls_without_a_gate() -> None:
    """A disc beyond a wall is turned round."""


@wrong_model("11.3", "The disc has turned round. Is it still in the wall?")
@edited(pair_by_pair_and_wall_by_wall, {"p[:, axis] = np.clip(p[:, axis], low, high)": "pass"})
def nobody_is_put_back() -> None:
    """The velocity is turned round, and the disc comes out by itself."""


@wrong_model("11.3", "A disc has a size. Which part of it touches the wall first?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"low, high = radii, room[axis] - radii": "low, high = 0, room[axis]"},
)
def centres_at_the_walls() -> None:
    """A disc is beyond a wall where its centre is."""


@wrong_model("11.3", "Two discs overlap and part already. Why do you hit them?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"max(-(1 + restitution) * vn / k, 0)": "-(1 + restitution) * vn / k"},
)
def pairs_without_a_gate() -> None:
    """Discs that overlap hit each other."""


@wrong_model("11.3", "A heavy disc and a light one: do both give way by the same?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"depth / k / masses[i]": "depth / 2", "depth / k / masses[j]": "depth / 2"},
)
def half_each() -> None:
    """Each disc is moved by half of the overlap."""


@wrong_model("11.3", "A heavy disc and a light one overlap. Which of them gives way more?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {
        "depth / k / masses[i]": "depth * masses[i] / (masses[i] + masses[j])",
        "depth / k / masses[j]": "depth * masses[j] / (masses[i] + masses[j])",
    },
)
def heavier_gives_way() -> None:
    """Each disc is moved in proportion to its mass."""


@wrong_model("11.3", "A heavy disc and a light one overlap. Does the heavy one give way at all?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {
        "depth / k / masses[i]": "depth * (masses[i] < masses[j])",
        "depth / k / masses[j]": "depth * (masses[i] >= masses[j])",
    },
)
def lighter_alone_gives_way() -> None:
    """The lighter disc alone is moved, by all of the overlap."""


@wrong_model("11.3", "A smooth wall pushes along its normal. What of the velocity along it?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"v[out, axis] *= -restitution": "v[out, axis] *= -1\n        v[out] *= restitution"},
)
def walls_brake_along_them() -> None:
    """A bounce off a wall makes the whole velocity smaller."""


@wrong_model("11.3", "Where should a disc be that has been put back: at the wall, or before it?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"np.clip(p[:, axis], low, high)": "2 * np.clip(p[:, axis], low, high) - p[:, axis]"},
)
def mirrored_at_the_walls() -> None:
    """What a disc is beyond a wall, it is on this side of it after the step."""


@wrong_model("11.3", "Read the task's steps again. What comes first, the move or the impacts?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {"positions + velocities * dt": "positions.copy()", "return p, v": "return p + v * dt, v"},
)
def moves_in_the_end() -> None:
    """First all impacts are found, and then the discs move."""


@wrong_model("11.3", "A disc flies out to the right. How many walls has your room?")
@edited(pair_by_pair_and_wall_by_wall, {"room[axis] - radii": "np.inf"})
def two_walls() -> None:
    """A room has a floor, and a wall on the left."""


@wrong_model("11.3", "Two discs overlap and part already. Do they still have to be moved apart?")
@edited(
    pair_by_pair_and_wall_by_wall,
    {
        "depth / k / masses[i]": "depth * (vn < 0) / k / masses[i]",
        "depth / k / masses[j]": "depth * (vn < 0) / k / masses[j]",
    },
)
def apart_only_if_they_approach() -> None:
    """Discs that part come out of each other by themselves."""
