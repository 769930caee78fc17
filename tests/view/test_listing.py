"""Functions out of a program's text."""

from __future__ import annotations

import pytest

from lesson_code.view.listing import functions, listing

PROGRAM = '''"""A module."""

LIMIT = 3


def first(x: int) -> int:
    """Say what it does.

    In many lines.
    """
    return x + LIMIT


def second() -> None:
    """Do nothing."""


def third(
    x: int,
) -> int:
    y = x

    return y
'''


def test_functions_have_their_text_without_docstrings() -> None:
    """Head and body, in the order of the program; one that has but a docstring, its head."""
    found = functions(PROGRAM)
    assert list(found) == ["first", "second", "third"]
    assert found["first"] == "def first(x: int) -> int:\n    return x + LIMIT"
    assert found["second"] == "def second() -> None:"
    assert found["third"] == "def third(\n    x: int,\n) -> int:\n    y = x\n\n    return y"


def test_listing_has_the_functions_asked_for_in_that_order() -> None:
    """With an empty line between them."""
    text = listing(PROGRAM, "second", "first")
    assert text == "def second() -> None:\n\ndef first(x: int) -> int:\n    return x + LIMIT"


def test_listing_refuses_what_is_not_there() -> None:
    """By name."""
    with pytest.raises(ValueError, match="functions in the program, got 'fourth'"):
        listing(PROGRAM, "fourth")
