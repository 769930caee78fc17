"""What the class's page says of a class: who, how marks are spread, and which answers are shown."""

from __future__ import annotations

import re
import tracemalloc

from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.class_run.answers import LONGEST_ANSWER, answer_in
from lesson_code.course.class_run.gradebook import Gradebook
from lesson_code.course.class_run.pages import class_page
from lesson_code.course.class_run.summary import spread_of

from .test_gradebook import book_of, hand_in, marks, paper

SHARES = st.lists(st.integers(0, 1000).map(lambda tenths: tenths / 10), min_size=1, max_size=40)


def book_of_answers(*answers: tuple[str, str | None]) -> Gradebook:
    """Return the marks of students whose answers to task 1.1 are wrong, as the model says."""
    given_ = {
        f"s{number}": marks(1, 3, 3, model=model) | {"answers": {"1.1": answer}}
        for number, (answer, model) in enumerate(answers)
    }
    return book_of(*(hand_in(name, paper(name)) for name in given_), marks_of=given_)


@given(shares=SHARES)
def test_spread_lies_within_the_marks_and_counts_everybody(shares: list[float]) -> None:
    """Lowest, quarters and highest are in order; the bars add up to the class."""
    spread = spread_of(shares)
    assert spread is not None
    quarters = [spread.first_quarter, spread.median, spread.third_quarter]
    ordered = [spread.lowest, *quarters, spread.highest]
    assert ordered == sorted(ordered)
    assert (spread.lowest, spread.highest) == (min(shares), max(shares))
    assert sum(spread.counts) == len(shares)
    assert spread.counts[-1] == sum(share >= 90 for share in shares)


def test_three_answers_show_a_misconception_the_commonest_first() -> None:
    """Answers that differ in spaces alone are one; of the rest the shorter comes first."""
    texts = ["return b", "return  b", "return cc", "return ddd", "return a", "return a", "return a"]
    book = book_of_answers(*((text, "always_swaps") for text in texts))
    (model,) = book.summary[0].misconceptions
    assert model.answers == ("return a", "return  b", "return cc")
    assert model.students == 7


def test_wrong_answers_without_a_model_are_listed_with_their_students() -> None:
    """They are what the instructor has to read; what was not written is not among them."""
    book = book_of_answers(("return 1", None), ("return 2", "always_swaps"), ("return 3", None))
    assert [student.id for student in book.summary[0].unexplained.who] == ["s0", "s2"]
    page = class_page(book)
    heading = page.index("Wrong answers that no model explains")
    assert "return 3" in page[heading:]
    assert re.search(r"67 %\s+\(2 of 3\)", page[heading:])


@given(body=st.text(max_size=80))
def test_answer_is_shown_as_text_whatever_stands_in_it(body: str) -> None:
    """No markup of a student's reaches the instructor's page, nor what turns writing round."""
    page = class_page(book_of_answers((f"<script>{body}</script>\u202e", None)))
    assert "<script" not in page
    assert "\u202e" not in page


def test_answer_ends_where_the_function_does() -> None:
    """The last definition counts, as in Python; a very long one is cut."""
    last = "def f(\n    a,\n):\n\n    return 2"
    source = f"def f(a):\n    return 1\n\n\ndef g():\n    pass\n\n{last}\nprint(f(1))"
    assert answer_in([source], "f") == last
    assert answer_in([source], "h") == ""
    long = answer_in(["def f():\n" + "    x = 1\n" * 1000], "f")
    assert long.endswith("\n...")
    assert len(long) <= LONGEST_ANSWER + 4


def test_answer_among_thousands_is_found_without_copies_of_the_rest() -> None:
    """A text of nothing but beginnings of a function took the grader 6 GB."""
    many = 'X = """' + "\ndef f(" * 20_000 + '"""'
    tracemalloc.start()
    found = answer_in([many, "def f(a):\n    return 1"], "f")
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert found == "def f(a):\n    return 1"
    assert most < 10_000_000
