"""The questions themselves: every number in the bank, worked out again without the bank."""

from __future__ import annotations

import math
from fractions import Fraction as F  # noqa: N817 - written many times below

import pytest

from lesson_code.course.quiz.bank import ChoiceQuestion, NumericQuestion, load_bank

QUESTIONS = {question.id: question for chapter in load_bank() for question in chapter.questions}
NUMERIC = {key: q for key, q in QUESTIONS.items() if isinstance(q, NumericQuestion)}
CHOICE = {key: q for key, q in QUESTIONS.items() if isinstance(q, ChoiceQuestion)}

ROUNDING = 1e-12
"""The bank writes a number to 16 digits; nothing else may separate it from the answer here."""

LONGEST_OPTION = 90
"""Characters: radio buttons do not wrap, and a notebook's page has room for so many."""


def squared(*components: F) -> F:
    """Return the square of a vector's length."""
    return sum((c * c for c in components), F(0))


def mirrored_y(normal_part_times: int) -> F:
    """Return the y component of (3, -4) after its part along (0.6, 0.8) is removed so often."""
    nx, ny = F(3, 5), F(4, 5)
    return -4 - normal_part_times * (3 * nx - 4 * ny) * ny


def rolling(k: F) -> F:
    """Return at which speed a body rolls that slid at 6 m/s; its inertia is k m r^2."""
    return 6 / (1 + k)


def let_through(reach: F) -> F:
    """Return how many per cent of balls pass that are stopped on so many m of a step of 0.5 m."""
    return 100 * (1 - reach / (50 * F(1, 100)))


E = F(4, 5)

# For each numeric question: the answer, and the wrong values in the order of the bank, each by
# the mistake that its feedback speaks of.
ANSWERS: dict[str, tuple[F | float, list[F | float]]] = {
    "00-unit-normal": (
        F(3, math.isqrt(3**2 + 4**2)),
        [F(3), F(3, 3 + 4), F(4, 5), F(3, 3**2 + 4**2), F(-3, 5)],
    ),
    "01-momentum": (
        F(2 * 3 + 5 * -1),
        [F(2 * 3 + 5 * 1), F(5 * 1 - 2 * 3), F((2 + 5) * (3 - 1)), F(3 - 1)],
    ),
    "01-sticking": (
        F(3 * 4 + 1 * -2, 3 + 1),
        [
            F(3 * 4 + 1 * 2, 3 + 1),
            F(4 - 2, 2),
            F(3 * 4, 3 + 1),
            F(1 * 4 + 3 * -2, 3 + 1),
            F(3 * 4 - 2),
        ],
    ),
    "01-velocity-change": (F(-6, 12), [F(6, 12), F(6, 3), F(-6, 3), F(-6, 12 + 3), F(-6 * 12)]),
    "02-measure": (
        F(4 - -2, 5 - -3),
        [
            F(4 - -2, 5 - 3),
            F(4 - 2, 5 - -3),
            F(4 - 2, 5 - 3),
            F(5 - -3, 4 - -2),
            F(-2 - 4, 5 - -3),
            squared(F(-2), F(4)) / squared(F(5), F(-3)),
        ],
    ),
    "02-heights": (2 * E ** (2 * 3), [2 * E**3, 2 * E ** (2 * 2), 2 * E ** (2 * 4), E ** (2 * 3)]),
    "02-energy-lost": (
        100 * (1 - F(9, 10) ** 2),
        [
            100 * F(9, 10) ** 2,
            100 * (1 - F(9, 10)),
            100 * F(9, 10),
            100 * (1 - F(9, 10)) ** 2,
            1 - F(9, 10) ** 2,
        ],
    ),
    "03-reflect": (
        mirrored_y(2),
        [
            mirrored_y(1),
            F(4),
            -mirrored_y(2),
            mirrored_y(-2),
            3 - 2 * (3 * F(3, 5) - 4 * F(4, 5)) * F(3, 5),
            -4 - 2 * (-4 * F(4, 5)) * F(4, 5),
        ],
    ),
    "03-bounce": (
        math.sqrt(squared(F(3), 5 * E)),
        [
            math.sqrt(squared(3 * E, 5 * E)),
            math.sqrt(squared(F(3), F(5))),
            5 * E,
            3 + 5 * E,
            math.sqrt(3**2 + 5**2 * E),
        ],
    ),
    "04-depth": (
        F(2) + F(7, 2) - math.isqrt(3**2 + 4**2),
        [
            math.isqrt(3**2 + 4**2) - (F(2) + F(7, 2)),
            F(math.isqrt(3**2 + 4**2)),
            F(2) + F(7, 2),
            (F(2) + F(7, 2)) ** 2 - (3**2 + 4**2),
            F(2) + F(7, 2) - (3 + 4),
        ],
    ),
    "04-impulse": (
        F(3, 4) * F(3, 2) * 4,
        [
            F(3, 4) * 2 * F(3, 2) * 4,
            F(3, 4) * 2 * 4,
            F(3, 4) * 4,
            (1 + 3) * F(3, 2) * 4,
            (F(1, 1) + F(1, 3)) * F(3, 2) * 4,
            F(3, 4) * F(1, 2) * 4,
        ],
    ),
    "04-split": (
        F(4, 10) * F(3, 1 + 3),
        [F(4, 10) / 2, F(4, 10) * F(1, 1 + 3), F(4, 10), F(4, 10) / 3],
    ),
    "05-contact-velocity": (
        3 - F(-4) * F(-1, 2),
        [3 - F(-4) * F(1, 2), F(3), -F(-4) * F(-1, 2), F(3 - 4)],
    ),
    "05-clamp": (
        -min(F(1, 2) * 4, F(3 * 2)),
        [F(-3 * 2), F(1, 2) * 4, F(3 * 2), -min(F(4), F(3 * 2)), -F(1, 2), F(-3)],
    ),
    "05-roll": (
        rolling(F(1, 2)),
        [rolling(F(1)), rolling(F(2, 5)), math.sqrt(6**2 / (1 + F(1, 2))), F(6), F(0)],
    ),
    "06-overlap": (
        F(min(40 - 22, 32 - 0)),
        [F(min(40, 32) - max(0, 22)), F(max(40 - 22, 32 - 0)), F(40 - 32), F(22 - 0), F(40 - 0)],
    ),
    "06-inside": (
        F(1, 2) + F(1, 5),
        [F(1, 2) - F(1, 5), F(1, 5), F(1, 2), F(1, 2) + 2 * F(1, 5)],
    ),
    "07-escape": (
        let_through(F(1, 10) + F(1, 20)),
        [
            100 - let_through(F(1, 10) + F(1, 20)),
            let_through(2 * F(1, 10) + F(1, 10)),
            let_through(F(1, 10) + F(1, 10)),
            let_through(F(1, 10)),
            let_through(F(1, 10) + F(1, 20)) / 100,
        ],
    ),
    "07-first-touch": (
        F(14 - math.isqrt(5**2 - 3**2), 3 + 2),
        [
            F(14, 3 + 2),
            F(14 + math.isqrt(5**2 - 3**2), 3 + 2),
            F(14 - math.isqrt(5**2 - 3**2), 3),
            F(14 - 5, 3 + 2),
            F(14 - math.isqrt(5**2 - 3**2), 3 - 2),
        ],
    ),
    "08-order": (
        F(1),  # 24/8 = ((1/60) / (1/180))^p
        [F(24, 8), math.log2(24 / 8), F(-1), F(2)],
    ),
    "08-late": (
        100 * (1 + F(1, 2)) * 6 * F(1, 50) / 2,
        [
            100 * (1 + F(1, 2)) * 6 * F(1, 50),
            100 * 6 * F(1, 50) / 2,
            100 * (1 + F(1)) * 6 * F(1, 50) / 2,
            100 * (1 - F(1, 2)) * 6 * F(1, 50) / 2,
            (1 + F(1, 2)) * 6 * F(1, 50) / 2,
        ],
    ),
    "09-sweeps": (
        100 * F(3, 3 + 1) ** 2,
        [
            100 * F(3, 3 + 1),
            100 * (1 - 2 * F(1, 3 + 1)),
            100 * F(1, 3 + 1) ** 2,
            100 * F(1, 2) ** 2,
        ],
    ),
    "09-jumps": (
        F(9, 10) * F((3 - 1) ** 2, 3) ** 2,
        [
            F(9, 10) * F((3 - 1) ** 2, 3),
            F(9, 10) * F((3 - 1) ** 2, 3) ** 4,
            F(9, 10) * F((3 - 1) ** 2, 3) * 2,
            F(9, 10) * 3**2,
        ],
    ),
    "10-pair": (
        math.sqrt(0.9 * 0.4),
        [F(9, 10), F(9, 10) * F(4, 10), (F(9, 10) + F(4, 10)) / 2, F(4, 10), F(0)],
    ),
    "10-bound": (
        math.sqrt(8 * 3**2 / 0.5),
        [F(3), math.sqrt(8 * 3**2 / 2), math.sqrt(8 * 3**2 / 2 / 0.5), F(8 * 3) / F(1, 2)],
    ),
    "11-step": (
        5 - (2 + 3) * F(1, 10),
        [5 - (3 + 4) * F(1, 10), 5 - 2 * F(2, 10) - 5 * F(2, 10) ** 2, 5 - 4 * F(1, 10), F(5, 10)],
    ),
    "11-pairs": (F(20 * 19, 2), [F(20 * 20), F(20 * 19), F(20 * 20, 2), F(20)]),
}


def test_numeric_questions_all_have_an_independent_answer() -> None:
    """No numeric question of the bank escapes the table above."""
    assert set(ANSWERS) == set(NUMERIC)


@pytest.mark.parametrize("key", ANSWERS)
def test_value_equals_independent_answer(key: str) -> None:
    """The bank's answer is what exact arithmetic gives."""
    assert abs(NUMERIC[key].value - ANSWERS[key][0]) <= ROUNDING


@pytest.mark.parametrize("key", ANSWERS)
def test_wrong_values_equal_the_mistakes_they_are_named_for(key: str) -> None:
    """Each recognised wrong value is what its mistake gives, in exact arithmetic."""
    in_bank = [wrong.value for wrong in NUMERIC[key].wrong_values]
    assert len(in_bank) == len(ANSWERS[key][1])
    assert all(
        abs(w - x) <= ROUNDING for w, x in zip(in_bank, map(float, ANSWERS[key][1]), strict=True)
    )


def test_measured_restitution_scene_keeps_momentum() -> None:
    """Question 02-measure is a collision that can happen: equal masses keep momentum."""
    assert 5 + -3 == -2 + 4


def test_equal_masses_only_the_exchange_keeps_momentum_and_energy_and_changes_something() -> None:
    """Of the options of 01-equal-masses one alone obeys both laws and is a collision."""
    before = (3, -1)
    afters = {"a": (-3, 1), "b": (1, 1), "c": (0, 3), "d": (-1, 3), "e": (3, -1)}
    right = [
        letter
        for letter, after in afters.items()
        if sum(after) == sum(before)
        and sum(v * v for v in after) == sum(v * v for v in before)
        and after != before
    ]
    question = CHOICE["01-equal-masses"]
    written = [
        f"v1\N{PRIME} = {v1} m/s, v2\N{PRIME} = {v2} m/s".replace("-", "\N{MINUS SIGN}")
        for v1, v2 in afters.values()
    ]
    assert [option.text for option in question.options] == written
    assert right == [question.answer]


@pytest.mark.parametrize(
    ("key", "right"),
    [
        ("01-heavy-moves-less", "Δv = J/m"),
        ("03-normal-part", "The normal component of I: a vector"),
        ("03-gate", "v·N < 0"),
        ("03-either-normal", "N stands twice"),
        ("04-separating", "Move them apart by 0.1 m; leave their velocities alone"),
        ("01-wall", "Ball \N{MINUS SIGN}5 m/s, wall 0 m/s"),
        ("02-zeno", "Infinitely often, and it rests after a finite time"),
        ("05-off-centre", "At the middle"),
        ("05-extra-vertex", "Nothing: the body is the same"),
        ("05-what-is-kept", "The total momentum and the total angular momentum"),
        ("07-zero", "The hit is lost"),
        ("07-at-the-instant", "Nothing, or something only if rounding"),
        ("09-cradle", "two equations for five unknowns"),
        ("09-energy", "more energy after the impact"),
        ("10-side", "call for an effect that turns out not to be needed"),
        ("10-island", "floors do not join islands"),
        ("11-gate", "only who moves into the wall is turned round"),
    ],
)
def test_right_option_says(key: str, right: str) -> None:
    """The lesson's own questions are in the bank, with the answer the lesson gives."""
    assert right in CHOICE[key].right_option.text


def test_chapters_ask_four_to_six_questions_with_a_number_from_chapter_01_on() -> None:
    """Each chapter has four to six questions, and after the first one at least one number."""
    for chapter in load_bank():
        assert 4 <= len(chapter.questions) <= 6
        kinds = {type(question) for question in chapter.questions}
        assert NumericQuestion in kinds


def test_option_texts_fit_on_a_line() -> None:
    """No option is longer than a radio button's line."""
    texts = [option.text for question in CHOICE.values() for option in question.options]
    assert max(map(len, texts)) <= LONGEST_OPTION


def test_texts_hold_no_markup() -> None:
    """The same text is read in a terminal and in a notebook, so it has no Markdown or TeX."""
    for chapter in load_bank():
        assert not set(repr(chapter)) & set("`$*#\\")


def test_right_options_do_not_give_themselves_away() -> None:
    """Every letter up to d is right somewhere, and none more than half of the time."""
    answers = [question.answer for question in CHOICE.values()]
    assert set("abcd") <= set(answers)
    assert max(answers.count(letter) for letter in answers) <= len(answers) / 2
