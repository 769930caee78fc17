import math
from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.evidence import CheckFailedError, check, check_bound

NAN, INF = math.nan, math.inf

# measured, expected, tolerance, and the line as it must stand in a notebook
TRUE = {
    "equal": (2.0, 2.0, 0, "2, expected 2"),
    "rounding is cleared away": (0.1 + 0.2, 0.3, 1e-12, "0.3, expected 0.3 within 1e-12"),
    "1e-17 is written as 0": (1e-17, 0, 1e-12, "0, expected 0 within 1e-12"),
    "-1e-17 is written as 0, not -0": (-1e-17, 0, 1e-12, "0, expected 0 within 1e-12"),
    "-0.0 is written as 0": (-0.0, 0, 0, "0, expected 0"),
    "tolerance itself is within": (1.5, 1.0, 0.5, "1.5, expected 1 within 0.5"),
    "six digits": (1 / 3, 1 / 3, 0, "0.333333, expected 0.333333"),
    "no digit below a large tolerance": (123456.7, 123444.4, 100, "123500, expected 123400"),
    "tiny numbers compared exactly": (1e-20, 1e-20, 0, "1e-20, expected 1e-20"),
    "tiny tolerance": (1e-300, 1e-300, 5e-324, "1e-300, expected 1e-300"),
    "integers in full": (31415926, 31415926, 0, "31415926, expected 31415926"),
    "integer of any length": (10**400, 10**400, 0, f"{10**400}, expected {10**400}"),
    "integers with a tolerance": (1234567, 1234571, 100, "1234600, expected 1234600"),
    "int and float": (2, 2.0, 0, "2, expected 2"),
    "fraction": (Fraction(1, 4), 0.25, 0, "0.25, expected 0.25"),
    "NumPy scalars": (np.float64(2.5), np.float32(2.5), 0, "2.5, expected 2.5"),
    "array of no dimension": (np.array(2.5), 2.5, 0, "2.5, expected 2.5"),
    "tuple and array": ((1, 2), np.array([1.0, 2.0]), 0, "(1, 2), expected (1, 2)"),
    "one number for all": ([3, 3, 3], 3, 0, "(3, 3, 3), expected 3"),
    "fractions in a list": ([Fraction(1, 2)], [0.5], 0, "(0.5), expected (0.5)"),
    "narrow integers": (
        np.array([1, 3], dtype=np.uint8),
        np.array([3, 1], dtype=np.uint8),
        2,
        "(1, 3), expected (3, 1) within 2",
    ),
    "infinity": (INF, INF, 0, "inf, expected inf"),
    "infinity with a tolerance": (-INF, -INF, 1, "-inf, expected -inf within 1"),
    "infinity in an array": ([1, INF], [1, INF], 1e-9, "(1, inf), expected (1, inf)"),
    "nothing and nothing": ([], [], 0, "(), expected ()"),
    "six numbers are written": (range(6), list(range(6)), 0, "(0, 1, 2, 3, 4, 5), expected (0, 1,"),
    "seven are counted": (
        range(7),
        list(range(7)),
        0,
        "7 numbers, expected as many: none is off at all",
    ),
    "truths, too": (np.ones(9, bool), [True] * 9, 0, "9 numbers, expected as many: none is off"),
    "against one": (np.full(10**5, 0.1), 0.1, 0, "100000 numbers, expected 0.1: none is off"),
    "noise in a long array": (
        np.linspace(0, 1e-16, 9),
        0,
        1e-12,
        "9 numbers, expected 0 within 1e-12: none is off by more than 1e-15",
    ),
    "the worst of a long array": (
        np.arange(9) + 3e-5,
        np.arange(9),
        1e-3,
        "9 numbers, expected as many within 0.001: none is off by more than 0.0001",
    ),
    "true": (True, True, 0, "True, expected True"),
    "NumPy's true is Python's": (np.True_, True, 0, "True, expected True"),
    "false from an array": (np.zeros(3).any(), False, 0, "False, expected False"),
    "truth in an array": (np.array([True, False]), [True, False], 0, "(True, False), expected (T"),
    "none": (None, None, 0, "None, expected None"),
    "text": ("elastic", "elastic", 0, "elastic, expected elastic"),
    "texts": (["a", "b"], ["a", "b"], 0, "['a', 'b'], expected ['a', 'b']"),
    "texts in an array": (np.array(["a", "b"]), ["a", "b"], 0, "['a', 'b'], expected ['a', 'b']"),
    "none among numbers": ([None, 0.5], [None, 0.5], 0, "[None, 0.5], expected [None, 0.5]"),
    "complex": (1j, 1j, 0, "1j, expected 1j"),
}

# measured, expected, tolerance, and how the message must say what is wrong
FALSE = {
    "too far": (2.0, 1.0, 0.5, "2, expected 1 within 0.5 (off by 1)"),
    "just too far": (1.0 + 1e-9, 1.0, 1e-10, "(off by 1e-09)"),
    "zero tolerance means exactly": (0.1 + 0.2, 0.3, 0, "(off by 5.55e-17)"),
    "a fraction is not its float": (Fraction(1, 3), 1 / 3, 0, "0.333333, expected 0.333333"),
    "integers beyond floats": (2**53 + 1, 2**53, 0, "(off by 1)"),
    "one of many": ([1, 2, 3.5], [1, 2, 3], 0.1, "(off by 0.5)"),
    "one of very many": (np.arange(9), np.arange(9)[::-1], 1, "9 numbers, 0 to 8, expected 9"),
    "nan measured": (NAN, 1.0, 1, "nan, expected 1 within 1 (off by nan)"),
    "nan expected": (1.0, NAN, 1, "1, expected nan within 1 (off by nan)"),
    "nan and nan": (NAN, NAN, 0, "nan, expected nan (off by nan)"),
    "nan in an array": ([1.0, NAN], [1.0, NAN], 1, "(1, nan), expected (1, nan)"),
    "nan in a long array": ([NAN] * 9, 0, 1, "9 numbers, nan"),
    "nan in an array, one number for all": ([NAN, NAN], NAN, 0, "(off by nan)"),
    "infinity and a number": (INF, 1.0, 1e300, "inf, expected 0 within 1e+300"),
    "opposite infinities": (INF, -INF, 1e300, "inf, expected -inf"),
    "difference overflows": (1e308, -1e308, 1, "(off by inf)"),
    "other shape": ([1, 2], [1, 2, 3], 0, "(shape (2,), not (3,))"),
    "same numbers, other shape": ([[1, 2], [3, 4]], [1, 2, 3, 4], 0, "(shape (2, 2), not (4,))"),
    "shape that would broadcast": (np.ones((3, 1)), np.ones((1, 3)), 0, "(shape (3, 1), not"),
    "number for an array": (3, [3, 3], 0, "(shape (), not (2,))"),
    "nothing is not a number": ([], 5, 0, "(shape (0,), not ())"),
    "true is not 1": (True, 1, 0, "True, expected 1 (not the same)"),
    "1 is not true": (1.0, True, 0, "1, expected True (not the same)"),
    "false is not none": (False, None, 0, "False, expected None (not the same)"),
    "none is not 0": (None, 0.0, 0, "None, expected 0 (not the same)"),
    "none is not nan": (None, NAN, 0, "(not the same)"),
    "none does not agree with none beside it": ([None], None, 0, "(not the same)"),
    "NumPy's true is not 1": (np.True_, 1, 0, "True, expected 1 (not the same)"),
    "other truth": (np.True_, False, 0, "True, expected False (not the same)"),
    "text is not a number": ("1", 1, 0, "1, expected 1 (not the same)"),
    "texts are not numbers": (["1"], [1], 0, "(not the same)"),
    "bytes are not a number": (b"3", 3, 0, "(not the same)"),
    "other text": ("elastic", "plastic", 5, "elastic, expected plastic within 5 (not the same)"),
    "imaginary part": (np.array([1j]), np.array([2j]), 0, "(not the same)"),
    "ragged": ([[1], [1, 2]], [[1], [1, 3]], 0, "(not the same)"),
}


@pytest.mark.parametrize(("measured", "expected", "tolerance", "line"), TRUE.values(), ids=TRUE)
def test_line_of_a_true_claim_is_the_only_one_printed(
    capsys, measured, expected, tolerance, line
) -> None:
    """A claim that holds prints one line: the claim, both values, the tolerance."""
    check("the claim", measured, expected, tolerance)
    printed = capsys.readouterr().out
    assert printed.startswith(f"ok    the claim: {line}")
    assert printed.count("\n") == 1
    assert printed.endswith("\n")
    assert (" within " in printed) == (tolerance > 0)


@pytest.mark.parametrize(("measured", "expected", "tolerance", "line"), FALSE.values(), ids=FALSE)
def test_line_of_a_false_claim_is_raised_and_not_printed(
    capsys, measured, expected, tolerance, line
) -> None:
    """A claim that does not hold stops the notebook and says how far off it is."""
    with pytest.raises(CheckFailedError) as caught:
        check("the claim", measured, expected, tolerance)
    message = str(caught.value)
    assert message.startswith("FALSE the claim: ")
    assert line in message
    assert "\n" not in message
    assert capsys.readouterr().out == ""


def test_failure_is_an_assertion_error() -> None:
    """Test runners report a failed claim as a failure, not as a crash."""
    assert issubclass(CheckFailedError, AssertionError)


@given(st.floats(-1e6, 1e6), st.floats(-0.999, 0.999), st.sampled_from([1e-12, 1e-6, 1, 100]))
def test_agreement_within_the_tolerance_holds_and_beyond_it_does_not(x, part, tolerance) -> None:
    """Any part of the tolerance passes, either side; twice the tolerance and rounding does not."""
    spacing = 4 * math.ulp(abs(x) + tolerance)  # adding the difference to x rounds
    near, far = x + part * (tolerance - spacing), x + 2 * tolerance + spacing
    if tolerance > spacing:
        check("near", near, x, tolerance)
    with pytest.raises(CheckFailedError):
        check("far", far, x, tolerance)


@given(st.floats(0.001, 0.999).map(lambda x: round(x, 6)), st.floats(-1e-15, 1e-15))
def test_line_does_not_show_noise_below_the_tolerance(value, noise) -> None:
    """Two machines whose results differ by rounding print the same line."""
    lines = [_printed(value + shift) for shift in (0, noise)]
    assert lines[0] == lines[1]


def _printed(measured):
    """Return what a check of this measurement prints."""
    with pytest.MonkeyPatch.context() as patch:
        lines = []
        patch.setattr("builtins.print", lines.append)
        check("the claim", measured, measured, 1e-12)
    (line,) = lines
    return line


@pytest.mark.parametrize("tolerance", [-1e-300, -1, NAN, INF, -INF])
def test_tolerance_negative_infinite_or_nan_is_refused(capsys, tolerance) -> None:
    """Such a tolerance would make every claim false, or every claim true."""
    with pytest.raises(ValueError, match=f"^tolerance must be >= 0 and finite, got {tolerance}"):
        check("the claim", 1, 1, tolerance)
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("tolerance", ["1e-9", None, 1j])
def test_tolerance_that_is_no_number_is_refused(tolerance) -> None:
    """The error names the argument and shows the value."""
    with pytest.raises(TypeError, match=r"^tolerance must be a real number .*, got "):
        check("the claim", 1, 1, tolerance)


def test_arrays_that_are_checked_are_not_changed() -> None:
    """Neither side of a claim is written to."""
    measured, expected = np.array([1.0, 2.0]), np.array([1.5, 2.0])
    measured.flags.writeable = expected.flags.writeable = False
    check("the claim", measured, expected, 0.5)
    np.testing.assert_array_equal(measured, [1, 2])
    np.testing.assert_array_equal(expected, [1.5, 2])


@pytest.mark.parametrize(
    ("measured", "bounds", "line"),
    [
        (-0.251, {"at_most": 0}, "-0.25, at most 0"),
        (497, {"at_least": 250}, "497, at least 250"),
        ([3e-16, -2e-17], {"at_most": 1e-12}, "under 1e-15, at most 1e-12"),
        ([1.5, 2.5], {"at_least": 1, "at_most": 3}, "1.5 to 2.5, at least 1 and at most 3"),
        (1.0, {"at_least": 1, "at_most": 1}, "1, at least 1 and at most 1"),
    ],
)
def test_bound_is_printed_with_what_was_measured(capsys, measured, bounds, line) -> None:
    """One line: the claim, the smallest and the largest number, the bounds."""
    check_bound("the claim", measured, **bounds)
    assert capsys.readouterr().out == f"ok    the claim: {line}\n"


@pytest.mark.parametrize("measured", [0.9, NAN, [1, 0.5], [1, NAN], -INF])
def test_number_beyond_a_bound_stops_the_notebook(capsys, measured) -> None:
    """A single one is enough, and nan keeps no bound."""
    with pytest.raises(CheckFailedError, match=r"FALSE the claim: .*, at least 1"):
        check_bound("the claim", measured, at_least=1)
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize(("measured", "bounds"), [(1, {}), ([], {"at_least": 1})])
def test_bound_needs_a_bound_and_a_number(measured, bounds) -> None:
    """A check that cannot fail is refused."""
    with pytest.raises(ValueError, match="a bound and a number must be given"):
        check_bound("the claim", measured, **bounds)
