"""Wrong models of chapter 11: callbacks, an effect, a sound."""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np

from lesson_code.chapters.ch11_the_small_engine.right_answers import all_samples_at_once
from lesson_code.course.grading.task import edited, wrong_model

Table: TypeAlias = Any
Vector: TypeAlias = Any


@wrong_model("11.4", "A box has lain on the floor for a minute. Does it begin to touch it again?")
def everything_that_touches(before: Table, now: Table) -> Any:
    """What touches now has begun to touch."""
    return [tuple(pair) for pair in now], [tuple(p) for p in before if list(p) not in now.tolist()]


@wrong_model("11.4", "Which of your two lists should a door use that opens when it is pressed?")
def begun_and_parted_swapped(before: Table, now: Table) -> Any:
    """What was there before and is no more has begun."""
    earlier, later = {tuple(p) for p in before}, {tuple(p) for p in now}
    return list(earlier - later), list(later - earlier)


@wrong_model("11.4", "A ball lies on the floor and now meets a second ball. Is that a new touch?")
def only_bodies_that_touched_nothing(before: Table, now: Table) -> Any:
    """A body that touches something already cannot begin to."""
    busy = {body for pair in before for body in pair}
    still = {body for pair in now for body in pair}
    return (
        [tuple(pair) for pair in now if not busy & set(pair)],
        [tuple(pair) for pair in before if not still & set(pair)],
    )


@wrong_model("11.4", "One pair parts and another one begins. Which of them is in which list?")
def all_changes_in_both(before: Table, now: Table) -> Any:
    """Whatever has changed is both."""
    changed = list({tuple(p) for p in before} ^ {tuple(p) for p in now})
    return changed, changed


@wrong_model(
    "11.4", "3 and 8 touch, and 3 and 5 begin to. What does `pair in table` ask of an array?"
)
def one_number_in_the_column(before: Table, now: Table) -> Any:
    """A pair is in a table if one of its numbers stands in the table, in the same column."""
    return (
        [tuple(pair) for pair in now if not (before == pair).any()],
        [tuple(pair) for pair in before if not (now == pair).any()],
    )


@wrong_model("11.5", "Half of it is left after one half-life. What is left after two? Nothing?")
def fades_by_a_fixed_amount(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """The light goes down evenly, to one half in a half-life."""
    return np.where(hit, 1.0, np.maximum(brightness * (1 - dt / (2 * half_life)), 0))


@wrong_model("11.5", "exp(-1) is 0.37. How much is left after one half-life by your formula?")
def e_in_place_of_two(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """A half-life is the time constant of the exponential."""
    return np.where(hit, 1.0, brightness * np.exp(-dt / half_life))


@wrong_model("11.5", "A slow computer makes half as many steps. Does its light last twice as long?")
def half_in_every_step(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """Every step takes one half."""
    return np.where(hit, 1.0, brightness / 2)


@wrong_model("11.5", "A body is hit just now. Should anyone see it at full brightness?")
def fades_at_once(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """What is hit is lit, and then everything fades."""
    return np.where(hit, 1.0, brightness) * 0.5 ** (dt / half_life)


@wrong_model("11.5", "A body that is bright already is hit again. Can it be brighter than full?")
def light_adds_up(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """A hit adds its light to what is there."""
    return brightness * 0.5 ** (dt / half_life) + hit


@wrong_model("11.6", "The sine takes radians. How many does one period have?")
@edited(all_samples_at_once, {"2 * np.pi * frequency": "frequency"})
def without_two_pi() -> None:
    """The sine's argument is f t."""


@wrong_model("11.6", "At the instant of the blow the membrane is at rest. What do you hear there?")
@edited(all_samples_at_once, {"np.sin": "np.cos"})
def begins_with_a_jump() -> None:
    """The sound is loudest where it begins: a cosine."""


@wrong_model("11.6", "Strike a bell. Does it ring for ever?")
@edited(all_samples_at_once, {"0.5 ** (t / half_life) * ": ""})
def never_dies_away() -> None:
    """A tone keeps its loudness."""


@wrong_model("11.6", "exp(-1) is 0.37. How loud is the tone after one half-life by your formula?")
@edited(all_samples_at_once, {"0.5 ** (t / half_life)": "np.exp(-t / half_life)"})
def fades_by_e() -> None:
    """After one half-life a tone has faded by the factor e."""


@wrong_model("11.6", "Sample a tone of 1,100 per second 1,000 times a second. Which tone is heard?")
@edited(all_samples_at_once, {"frequency >= rate / 2": "False"})
def any_tone_can_be_sampled() -> None:
    """The samples of a tone are heard as that tone, however high it is."""


@wrong_model("11.6", "Sample number k is heard at which time?")
@edited(all_samples_at_once, {"t / half_life": "t * rate / half_life"})
def a_sample_a_second() -> None:
    """The samples are numbered in seconds for the loudness."""


@wrong_model("11.4", "1 and 2 touched, and 3 and 4. Now 1 and 3 do: is that pair an old one?")
def numbers_in_place_of_pairs(before: Any, now: Any) -> Any:
    """A pair is known if both of its numbers are."""
    was, stays = ({int(n) for pair in pairs for n in pair} for pairs in (before, now))
    begun = [(int(i), int(j)) for i, j in now if not {int(i), int(j)} <= was]
    parted = [(int(i), int(j)) for i, j in before if not {int(i), int(j)} <= stays]
    return begun, parted


@wrong_model("11.4", "A pair moves up a row, as one above it has parted. Does it touch anew?")
def row_against_row(before: Any, now: Any) -> Any:
    """A pair that touches keeps its row in the table."""
    old, new = ([(int(i), int(j)) for i, j in pairs] for pairs in (before, now))
    begun = [pair for k, pair in enumerate(new) if old[k : k + 1] != [pair]]
    return begun, [pair for k, pair in enumerate(old) if new[k : k + 1] != [pair]]


@wrong_model("11.6", "The samples are 1/rate apart. Between ten samples, how many gaps are there?")
@edited(all_samples_at_once, {"np.arange(count) / rate": "np.linspace(0, count / rate, count)"})
def with_the_end_of_the_time() -> None:
    """The samples divide the whole time, its end included."""


@wrong_model("11.4", "A pair has parted. Is it in the table of those that touch now?")
def parted_are_those_that_stay(before: Table, now: Table) -> Any:
    """Those that touched before and touch now are in the second list."""
    earlier, later = {tuple(p) for p in before}, {tuple(p) for p in now}
    return list(later - earlier), list(later & earlier)


@wrong_model("11.4", "Nothing touched in the step before. Is that no news when something does?")
def nothing_without_a_step_before(before: Table, now: Table) -> Any:
    """Where one of the tables is empty, there is nothing to compare."""
    earlier, later = {tuple(p) for p in before}, {tuple(p) for p in now}
    both = bool(earlier and later)
    return list(later - earlier) if both else [], list(earlier - later) if both else []


@wrong_model("11.4", "In which order do the pairs stand? May a new one stand first?")
def new_ones_stand_last(before: Table, now: Table) -> Any:
    """As many pairs as there were before are old ones; those that follow are new."""
    return [tuple(p) for p in now[len(before) :]], [tuple(p) for p in before[len(now) :]]


@wrong_model("11.4", "A ball is lifted off the floor. In which of your lists do you say so?")
def nobody_parts(before: Table, now: Table) -> Any:
    """Only what begins counts."""
    earlier = {tuple(p) for p in before}
    return [tuple(p) for p in now if tuple(p) not in earlier], []


@wrong_model("11.5", "Half of it is left after one half-life. What does yours leave of it?")
def a_full_light_in_a_half_life(
    brightness: Vector, hit: Vector, dt: float, half_life: float
) -> Any:
    """The light goes down evenly, from 1 to 0 in a half-life."""
    return np.where(hit, 1.0, np.maximum(brightness - dt / half_life, 0.0))


@wrong_model("11.5", "Put dt = half_life into your formula. Is one half left?")
def logarithm_on_the_wrong_side(
    brightness: Vector, hit: Vector, dt: float, half_life: float
) -> Any:
    """The time constant is the half-life times ln 2."""
    return np.where(hit, 1.0, brightness * np.exp(-dt / (half_life * np.log(2))))


@wrong_model("11.5", "A longer half-life: does the light fade faster by your formula, or slower?")
def half_life_as_a_rate(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """The half-life is how fast the light fades."""
    return np.where(hit, 1.0, brightness * np.exp(-dt * half_life))


@wrong_model("11.5", "A step is shorter than the half-life. Does nothing fade in it?")
def half_at_once(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """The light stays for a half-life, and then it is one half."""
    return np.where(hit, 1.0, brightness / (1 if dt < half_life else 2))


@wrong_model("11.5", "How bright is what is hit, if it was dark before?")
def twice_as_bright(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """What is hit becomes twice as bright, up to 1."""
    return np.where(hit, np.minimum(1, 2 * brightness), brightness * 0.5 ** (dt / half_life))


@wrong_model("11.5", "One body is hit. Do the others light up with it?")
def all_light_up(brightness: Vector, hit: Vector, dt: float, half_life: float) -> Any:
    """Where there is a hit, everything lights up."""
    return np.ones(len(brightness)) if hit.any() else brightness * 0.5 ** (dt / half_life)


@wrong_model(
    "11.6", "At the instant of the blow the membrane is at rest. Is that your first sample?"
)
@edited(all_samples_at_once, {"np.arange(count)": "np.arange(1, count + 1)"})
def begins_with_the_second() -> None:
    """The first sample comes one step after the blow."""


@wrong_model("11.6", "A tone is too high. How many samples does the caller wait for?")
@edited(all_samples_at_once, {"np.zeros(count)": "[]"})
def none_for_what_is_too_high() -> None:
    """A tone that is too high has no samples."""


@wrong_model("11.6", "Half of it is left after one half-life. What is left after two? Nothing?")
@edited(all_samples_at_once, {"0.5 ** (t / half_life)": "np.maximum(1 - t / half_life / 2, 0)"})
def fades_evenly() -> None:
    """The loudness goes down evenly, to one half in a half-life."""


@wrong_model("11.6", "Ask for twice as many samples. Does the same blow ring twice as long?")
@edited(all_samples_at_once, {"0.5 ** (t / half_life)": "(1 - t * rate / count)"})
def fades_until_the_last_sample() -> None:
    """The tone has died away when the samples end."""


@wrong_model("11.6", "A bell rings out. Does its tone sink, or its loudness alone?")
@edited(all_samples_at_once, {"np.pi * frequency": "np.pi * frequency * 0.5 ** (t / half_life)"})
def sinks_as_it_fades() -> None:
    """The tone sinks as the loudness does."""


@wrong_model("11.6", "Which values has a sine between 1 and -1?")
@edited(
    all_samples_at_once,
    {"np.sin(2 * np.pi * frequency * t)": "np.sign(np.sin(2 * np.pi * frequency * t))"},
)
def up_or_down() -> None:
    """A tone is up in one half of its period and down in the other."""


@wrong_model("11.6", "Sample number k is heard at which time?")
@edited(all_samples_at_once, {"frequency * t": "frequency * t * rate"})
def a_tone_per_sample() -> None:
    """The samples are numbered in seconds for the tone."""


@wrong_model("11.4", "`row in table` asks NumPy for any equal number. Which rows does that find?")
def any_number_of_a_row(before: Table, now: Table) -> Any:
    """For a table that is not empty, `in` asks whether it holds the row."""
    before, now = np.asarray(before), np.asarray(now)
    begun = [tuple(pair) for pair in now if len(before) == 0 or pair not in before]
    return begun, [tuple(pair) for pair in before if len(now) == 0 or pair not in now]


@wrong_model("11.6", "There are rate samples in a second. How long do count of them last?")
@edited(all_samples_at_once, {"np.arange(count) / rate": "np.linspace(0, 1, int(count))"})
def lasts_one_second() -> None:
    """The samples divide one second."""


@wrong_model("11.4", "10 i + j: may two different pairs have the same number?")
def pairs_as_two_digits(before: Table, now: Table) -> Any:
    """A pair is kept as one number, its bodies' numbers being the digits."""
    old, new = ({10 * i + j: (i, j) for i, j in pairs} for pairs in (before, now))
    return [new[k] for k in new if k not in old], [old[k] for k in old if k not in new]


@wrong_model("11.6", "It fades by a half in each half-life. Does it wait for the end of one?")
@edited(all_samples_at_once, {"0.5 ** (t / half_life)": "0.5 ** (t // half_life)"})
def fades_in_jumps() -> None:
    """The loudness falls by a half at the end of each half-life."""
