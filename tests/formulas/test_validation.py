import inspect
import math
import re
from fractions import Fraction

import numpy as np
import pytest

from lesson_code import formulas
from lesson_code.formulas.validation import (
    UNIT_LENGTH_TOLERANCE,
    equation,
    finite,
    formula,
    unit_vector,
    vector,
)

# One call of every public formula, worked by hand: keyword arguments in the order of the
# signature, and the result. A new formula needs a row here, and its arguments one in RULES.
BY_HAND = {
    "elastic_1d": ({"m1": 1, "v1": 2, "m2": 3, "v2": -2}, (-4, 0)),
    "inelastic_1d": ({"m1": 1, "v1": 2, "m2": 3, "v2": -2}, (-1, -1)),
    "collide_1d": (
        {"m1": 1, "v1": 2, "m2": 3, "v2": -2, "restitution": 0.5},
        (-2.5, -0.5),
    ),
    "mass_fraction": ({"m1": 3, "m2": 1}, 0.75),
    "reduced_mass": ({"m1": 1, "m2": 3}, 0.75),
    "energy_lost_1d": ({"m1": 1, "v1": 2, "m2": 3, "v2": -2, "restitution": 0.5}, 4.5),
    "restitution_1d": ({"v1": 3, "v2": -1, "v1_after": -1, "v2_after": 1}, 0.5),
    "effective_mass": (
        {"inv_m_a": 1, "inv_m_b": 1, "inv_i_a": 0.5, "inv_i_b": 0.25, "ra_x_n": -2, "rb_x_n": 4},
        0.125,
    ),
    "normal_impulse": ({"vn": -4, "m_eff": 2, "restitution": 0.5, "accumulated": 1}, 13),
    "friction_impulse": (
        {"vt": 2, "m_eff_t": 1, "friction": 0.25, "normal_impulse": 6, "accumulated": 1},
        -1,
    ),
    "contact_velocity": ({"velocity": (3, 1), "angular_velocity": 2, "offset": (1, -1)}, (5, 3)),
    "disc_inertia": ({"mass": 4, "radius": 0.5}, 0.5),
    "polygon_area": ({"vertices": ((0, 0), (3, 0), (0, 6))}, 9),
    "polygon_centroid": ({"vertices": ((0, 0), (3, 0), (0, 6))}, (1, 2)),
    "polygon_inertia": ({"mass": 4, "vertices": ((0, 0), (3, 0), (0, 6))}, 10),
    "reflect": ({"incident": (3, -4), "normal": (0, 1)}, (3, 4)),
    "bounce": (
        {"velocity": (3, -4), "normal": (0, 1), "restitution": 0.5, "friction": 0.25},
        (1.5, 2),
    ),
    "scaled_reflection": ({"velocity": (3, -4), "normal": (0, 1), "restitution": 0.5}, (1.5, 2)),
    "momentum": ({"masses": (1, 2), "velocities": ((3, 0), (0, -1))}, (3, -2)),
    "kinetic_energy": (
        {
            "masses": (1, 2),
            "velocities": ((3, 0), (0, -1)),
            "inertias": (2, 4),
            "angular_velocities": (3, -1),
        },
        16.5,
    ),
    "angular_momentum": (
        {
            "masses": (1, 2),
            "positions": ((0, 2), (1, 0)),
            "velocities": ((3, 0), (0, -1)),
            "inertias": (2, 4),
            "angular_velocities": (3, -1),
            "about": (0, 0),
        },
        -6,
    ),
}

SUMMED = {
    "momentum",
    "kinetic_energy",
    "angular_momentum",
    "polygon_area",
    "polygon_centroid",
    "polygon_inertia",
}
"""These add up bodies or corners, so their shapes are their own: test_conservation.py and
test_rigid_body.py have them."""

VECTORS = {"incident", "velocity"}
"""A formula with one of these gives a vector; with none of them, a tuple is two numbers."""

NAN, INF, HUGE = math.nan, math.inf, 10**400

# For each rule: the value, the rule and the value as the message must say them.
FINITE = [
    (NAN, "finite", "nan"),
    (INF, "finite", "inf"),
    (-INF, "finite", "-inf"),
    ((1.0, NAN), "finite", "nan at index (1,)"),
    ((INF, 1.0), "finite", "inf at index (0,)"),
    (HUGE, "finite", "a number over 1e308"),
    ((1, HUGE), "finite", "a number over 1e308"),
    (Fraction(HUGE), "finite", "a number over 1e308"),
]
MASS = [
    (0, "> 0 kg", "0"),
    (-0.0, "> 0 kg", "-0.0"),
    (-1.0, "> 0 kg", "-1.0"),
    (Fraction(-1, 2), "> 0 kg", "-1/2"),
    (-INF, "> 0 kg", "-inf"),
    (NAN, "> 0 kg", "nan"),
    ((1.0, -2.0), "> 0 kg", "-2.0 at index (1,)"),
    ((NAN, 1.0), "> 0 kg", "nan at index (0,)"),
    (HUGE, "finite", "a number over 1e308"),
    ((1, HUGE), "finite", "a number over 1e308"),
]
POSITIVE = [
    (0, "> 0 and finite", "0"),
    (-1.0, "> 0 and finite", "-1.0"),
    (INF, "> 0 and finite", "inf"),
    (NAN, "> 0 and finite", "nan"),
    ((1.0, 0.0), "> 0 and finite", "0.0 at index (1,)"),
    (HUGE, "finite", "a number over 1e308"),
]
NON_NEGATIVE = [
    (-0.1, ">= 0 and finite", "-0.1"),
    (-5e-324, ">= 0 and finite", "-5e-324"),
    (INF, ">= 0 and finite", "inf"),
    (NAN, ">= 0 and finite", "nan"),
    ((1.0, -1.0), ">= 0 and finite", "-1.0 at index (1,)"),
    (HUGE, "finite", "a number over 1e308"),
]
UNIT_INTERVAL = [
    (-0.1, "between 0 and 1", "-0.1"),
    (1.1, "between 0 and 1", "1.1"),
    (1 + 1e-15, "between 0 and 1", "1.000000000000001"),
    (-5e-324, "between 0 and 1", "-5e-324"),
    (2, "between 0 and 1", "2"),
    (NAN, "between 0 and 1", "nan"),
    (INF, "between 0 and 1", "inf"),
    ((0.5, 1.5), "between 0 and 1", "1.5 at index (1,)"),
    (HUGE, "finite", "a number over 1e308"),
]
VECTOR = [
    ((NAN, 0.0), "finite", "nan at index (0,)"),
    ((0.0, INF), "finite", "inf at index (1,)"),
    (((0.0, 1.0), (-INF, 0.0)), "finite", "-inf at index (1, 0)"),
    ((0, HUGE), "finite", "a number over 1e308"),
    (3.0, "shape (..., 2)", "shape ()"),
    ((1.0, 2.0, 3.0), "shape (..., 2)", "shape (3,)"),
    (((1.0,), (2.0,)), "shape (..., 2)", "shape (2, 1)"),
    ((), "shape (..., 2)", "shape (0,)"),
]
UNIT_VECTOR = [
    *VECTOR,
    ((0.0, 0.0), "a unit vector (length 1 within 1e-09)", "length 0.0"),
    ((0, 2), "a unit vector", "length 2.0"),
    ((1 + 1e-6, 0.0), "a unit vector", "length 1.000001"),
    ((1 - 1e-6, 0.0), "a unit vector", "length 0.999999"),
    ((0.6, 0.6), "a unit vector", "length 0.848528"),
    ((1.5e308, 1.5e308), "a unit vector", "length inf"),
    (((1.0, 0.0), (0.0, 2.0)), "a unit vector", "length 2.0 at index (1,)"),
]
POLYGON = [
    (((0, 0), (NAN, 0), (0, 1)), "finite", "nan at index (1, 0)"),
    (((0, 0), (1, 0), (0, INF)), "finite", "inf at index (2, 1)"),
    (((0, 0), (1, 0), (0, HUGE)), "finite", "a number over 1e308"),
    (3.0, "shape (N, 2), N >= 3", "shape ()"),
    ((), "shape (N, 2), N >= 3", "shape (0,)"),
    (((0, 0), (1, 0)), "shape (N, 2), N >= 3", "shape (2, 2)"),
    (((0, 0, 0), (1, 0, 0), (0, 1, 0)), "shape (N, 2), N >= 3", "shape (3, 3)"),
    ((((0, 0), (1, 0), (0, 1)),) * 2, "shape (N, 2), N >= 3", "shape (2, 3, 2)"),
    (((1, 1), (1, 1), (1, 1)), "an area > 0 m^2, not lie on a line", "0"),
    (((0, 0), (1, 3), (2, 6)), "an area > 0 m^2, not lie on a line", "0"),
    (((0.1, 0.3), (0.2, 0.6), (0.7, 2.1)), "an area > 0 m^2", ""),  # on a line, but for rounding
    (((0, 0), (1, 1), (1, 0), (0, 1)), "an area > 0 m^2", "0"),  # crossed: +1/4 and -1/4 m^2
]

RULES = {
    **dict.fromkeys(("m1", "m2", "mass", "masses"), MASS),
    **dict.fromkeys(("v1", "v2", "v1_after", "v2_after", "vn", "vt"), FINITE),
    **dict.fromkeys(("angular_velocity", "angular_velocities"), FINITE),
    **dict.fromkeys(("ra_x_n", "rb_x_n"), FINITE),
    **dict.fromkeys(("m_eff", "m_eff_t", "radius"), POSITIVE),
    **dict.fromkeys(("friction", "normal_impulse", "inertias"), NON_NEGATIVE),
    **dict.fromkeys(("inv_m_a", "inv_m_b", "inv_i_a", "inv_i_b"), NON_NEGATIVE),
    "restitution": UNIT_INTERVAL,
    **dict.fromkeys(("incident", "velocity", "velocities", "offset"), VECTOR),
    **dict.fromkeys(("positions", "about"), VECTOR),
    "normal": UNIT_VECTOR,
    "vertices": POLYGON,
    ("normal_impulse", "accumulated"): NON_NEGATIVE,
    ("friction_impulse", "accumulated"): FINITE,
}
"""By argument, or by formula and argument where two formulas differ."""

NOT_NUMBERS = ["fast", b"1", None, 1j, (1, "2"), (1, None), (1j, 2), {}, object]
RAGGED = ((1, 2), (3,))


def call(name, **changed):
    """Return what the formula gives for the hand-worked arguments, some of them changed."""
    return getattr(formulas, name)(**{**BY_HAND[name][0], **changed})


def converted(value, kind):
    """Return a number, or every number of a vector, as another kind of number where it can be.

    Halves and quarters stay what they are: only whole numbers fit an integer type.
    """
    if isinstance(value, tuple):
        return [converted(item, kind) for item in value]
    return kind(value) if isinstance(value, int) else value


def assert_result(result, expected, tolerance=1e-15):
    """Assert that a result, a number, a pair or a vector, is the one worked by hand."""
    np.testing.assert_allclose(np.asarray(result, dtype=float), expected, rtol=tolerance)


ARGUMENTS = [(name, argument) for name, (row, _) in BY_HAND.items() for argument in row]
BAD_VALUES = [
    pytest.param(name, argument, *bad, id=f"{name}-{argument}={str(bad[0])[:20]}-{i}")
    for name, argument in ARGUMENTS
    for i, bad in enumerate(RULES.get((name, argument)) or RULES[argument])
]


def test_table_of_bad_input_covers_every_public_formula() -> None:
    """A formula, or an argument of one, without a row in this file's tables is noticed."""
    assert set(BY_HAND) == set(formulas.__all__)
    for name, (row, _) in BY_HAND.items():
        assert list(row) == list(inspect.signature(getattr(formulas, name)).parameters)


@pytest.mark.parametrize("name", BY_HAND)
def test_formula_worked_by_hand_is_right_by_keyword_and_by_position(name) -> None:
    """The tables' own calls are legal, so that what is refused below is refused for its fault."""
    row, expected = BY_HAND[name]
    assert_result(getattr(formulas, name)(**row), expected)
    assert_result(getattr(formulas, name)(*row.values()), expected)


@pytest.mark.parametrize(("name", "argument", "value", "rule", "shown"), BAD_VALUES)
def test_bad_value_is_refused_by_argument_rule_and_value(
    name, argument, value, rule, shown
) -> None:
    """A ValueError names the argument, the rule and the value (fault 31 of the source)."""
    pattern = f"^{argument} must (be|have) {re.escape(rule)}.*got {re.escape(shown)}"
    with pytest.raises(ValueError, match=pattern):
        call(name, **{argument: value})


@pytest.mark.parametrize("value", NOT_NUMBERS, ids=str)
@pytest.mark.parametrize(("name", "argument"), ARGUMENTS)
def test_bad_type_is_refused_by_argument_and_value(name, argument, value) -> None:
    """What is no real number gets a TypeError that names the argument and shows the value."""
    pattern = f"^{argument} must be a real number or an array of them, got {re.escape(repr(value))}"
    with pytest.raises(TypeError, match=pattern):
        call(name, **{argument: value})


@pytest.mark.parametrize(("name", "argument"), ARGUMENTS)
def test_bad_rows_of_unequal_length_are_refused_by_argument(name, argument) -> None:
    """A ragged list is no array."""
    with pytest.raises(ValueError, match=f"^{argument} must be a regular array, got rows of"):
        call(name, **{argument: RAGGED})


@pytest.mark.parametrize(
    ("name", "argument"), [pair for pair in ARGUMENTS if pair[0] not in SUMMED]
)
def test_bad_shape_beside_another_batch_is_refused_with_every_shape(name, argument) -> None:
    """Three values of one argument do not fit two of the next: the error lists all shapes."""
    row = BY_HAND[name][0]
    other = next(key for key in row if key != argument)
    stacks = {argument: [row[argument]] * 3, other: [row[other]] * 2}
    pattern = r"^arguments must have shapes that broadcast, got "
    with pytest.raises(ValueError, match=pattern) as caught:
        call(name, **stacks)
    for key in row:
        shape = {argument: (3,), other: (2,)}.get(key, ())
        assert f"{key} {shape}" in str(caught.value)


@pytest.mark.parametrize("name", [name for name in BY_HAND if "m2" in BY_HAND[name][0]])
@pytest.mark.parametrize(
    ("m1", "m2"), [(INF, INF), ([1, INF], INF), ([[1], [INF]], [2, INF])], ids=str
)
def test_both_masses_infinite_are_refused(name, m1, m2) -> None:
    """Of two immovable bodies neither can yield: there is no answer, in no place of an array."""
    with pytest.raises(ValueError, match=r"^m1 and m2 must not both be infinite: .*got inf"):
        call(name, m1=m1, m2=m2)


@pytest.mark.parametrize("name", [name for name in BY_HAND if "m2" in BY_HAND[name][0]])
def test_one_mass_infinite_is_accepted_in_every_place(name) -> None:
    """``math.inf`` is a legal mass and means immovable: no warning, no nan."""
    for m1, m2 in ((INF, 2), (2, INF), ([INF, 2], [2, INF])):
        assert not np.isnan(call(name, m1=m1, m2=m2)).any()


@pytest.mark.parametrize(("name", "argument"), [p for p in ARGUMENTS if p[1] == "restitution"])
@pytest.mark.parametrize("value", [0, 1, 0.0, 1.0, -0.0, Fraction(1, 3)])
def test_restitution_at_the_ends_is_accepted(name, argument, value) -> None:
    """Both ends of [0, 1] belong to it."""
    result = np.asarray(call(name, restitution=value), dtype=float)
    assert np.isfinite(result).all()


@pytest.mark.parametrize("name", [name for name in BY_HAND if "normal" in BY_HAND[name][0]])
@pytest.mark.parametrize("excess", [1e-10, -1e-10, 0.9e-9])
def test_normal_within_a_billionth_of_unit_length_is_accepted(name, excess) -> None:
    """1 + 1e-10 is rounding, not a mistake; the result is off by no more than that."""
    assert_result(call(name, normal=(0, 1 + excess)), BY_HAND[name][1], tolerance=1e-8)


def test_normal_is_unit_within_the_tolerance_the_lesson_fixes() -> None:
    """1e-9, on both sides."""
    assert UNIT_LENGTH_TOLERANCE == 1e-9
    for length in (1 + 1.1e-9, 1 - 1.1e-9):
        with pytest.raises(ValueError, match=r"^n must be a unit vector"):
            unit_vector("n", (length, 0.0))


@pytest.mark.parametrize("name", BY_HAND)
@pytest.mark.parametrize(
    "kind",
    [int, float, Fraction, np.float64, np.float32, np.float16, np.int64, np.int8, np.array],
)
def test_formula_of_any_kind_of_number_is_right(name, kind) -> None:
    """Python and NumPy numbers, Fractions and arrays of no dimension give the same answer."""
    row, expected = BY_HAND[name]
    result = getattr(formulas, name)(**{key: converted(x, kind) for key, x in row.items()})
    assert_result(result, expected)


@pytest.mark.parametrize("kind", [list, tuple, np.array, lambda x: np.array(x, dtype=object)])
@pytest.mark.parametrize("name", sorted(set(BY_HAND) - SUMMED))
def test_formula_of_sequences_gives_one_answer_for_each_place(name, kind) -> None:
    """Lists, tuples and arrays of any dtype all mean an array."""
    row, expected = BY_HAND[name]
    result = getattr(formulas, name)(**{key: kind([value] * 3) for key, value in row.items()})
    result = np.stack(result) if isinstance(expected, tuple) else np.asarray(result)
    pair = isinstance(expected, tuple) and not VECTORS & set(row)
    assert_result(result, np.stack([expected] * 3, axis=-1 if pair else 0))


@pytest.mark.parametrize("name", sorted(set(BY_HAND) - SUMMED))
def test_formula_broadcasts_every_argument_against_the_others(name) -> None:
    """One argument of shape (3, 1), the others (4,): a table of shape (3, 4)."""
    row, expected = BY_HAND[name]
    pair = isinstance(expected, tuple) and not VECTORS & set(row)
    for tall in row:
        table = {key: [value] * 4 for key, value in row.items()}
        table[tall] = [[row[tall]]] * 3
        results = getattr(formulas, name)(**table)
        for result, one in zip(results, expected, strict=True) if pair else [(results, expected)]:
            assert result.shape == (3, 4, *np.shape(one))
            assert_result(result, np.broadcast_to(one, result.shape))


@pytest.mark.parametrize("name", BY_HAND)
def test_formula_changes_no_argument_and_shares_no_memory(name) -> None:
    """Inputs are never changed in place, nor can they be through the result."""
    arrays = {
        key: np.array([value] * 3 if name not in SUMMED else value, dtype=float)
        for key, value in BY_HAND[name][0].items()
    }
    if name == "angular_momentum":
        arrays["about"] = np.zeros(2)
    before = {key: array.copy() for key, array in arrays.items()}
    for array in arrays.values():
        array.flags.writeable = False
    results = getattr(formulas, name)(**arrays)
    for key, array in arrays.items():
        np.testing.assert_array_equal(array, before[key])
        for result in results if isinstance(results, tuple) else (results,):
            assert not np.shares_memory(result, array)


@pytest.mark.parametrize("dtype", [np.uint8, np.int8, np.int64, np.uint64])
def test_velocities_as_narrow_integers_do_not_wrap_round(dtype) -> None:
    """np.uint8(1) - np.uint8(3) is 254 in NumPy; here it is -2, and equal masses swap."""
    u1, u2 = formulas.elastic_1d(dtype(100), dtype(1), dtype(100), dtype(3))
    assert (u1, u2) == (3, 1)
    u1, u2 = formulas.elastic_1d(*np.array([[100], [1], [100], [3]], dtype=dtype))
    assert (u1.item(), u2.item()) == (3, 1)


def test_formula_of_a_fraction_beside_an_array_gives_floats() -> None:
    """A Fraction beside vectors becomes a float: no array of Python objects comes out."""
    after = formulas.bounce([(3, -4), (0, -2)], (0, 1), Fraction(1, 2))
    assert after.dtype == float
    np.testing.assert_array_equal(after, [[3, 2], [0, 1]])


def test_formula_called_without_an_argument_is_refused() -> None:
    """The call is refused by the name of what is missing, as for any Python function."""
    with pytest.raises(TypeError, match="'v2'"):
        formulas.elastic_1d(1, 2, 3)
    with pytest.raises(TypeError, match="'speed'"):
        formulas.elastic_1d(1, 2, 3, 4, speed=5)


@formula(a=finite, b=finite)
def _product(a, b=2.0):
    """Return a b."""
    return a * b


@formula(returns_vector=True, v=vector)
def _swapped(v):
    """Return (y, x)."""
    return np.stack((v[1], v[0]))


def test_equation_of_a_formula_runs_the_same_lines_without_the_door() -> None:
    """What is undecorated checks nothing: nan in, nan out."""
    with pytest.raises(ValueError, match="a must be finite, got nan"):
        _product(NAN)
    assert math.isnan(equation(_product)(NAN))
    assert equation(_product)(3, 5) == _product(3, 5) == 15
    assert equation(equation(_product)) is equation(_product)


def test_equation_of_a_vector_formula_takes_components_first() -> None:
    """At the door (..., 2), inside (2, ...): the door moves the axis, both ways."""
    batch = np.array([[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]])
    np.testing.assert_array_equal(_swapped(batch), batch[:, ::-1])
    np.testing.assert_array_equal(equation(_swapped)(batch.T), batch.T[::-1])


@pytest.mark.parametrize("name", sorted(set(BY_HAND) - SUMMED))
def test_source_of_a_formula_shows_the_lines_that_run(name) -> None:
    """What a student sees of a formula is its own text: name, equation, docstring."""
    public = getattr(formulas, name)
    source = inspect.getsource(public)
    assert source.startswith("@formula(")
    assert f"def {name}(" in source
    assert public.__doc__ == equation(public).__doc__
    assert inspect.getsource(equation(public)) == source
    assert equation(public) is not public


def test_formula_with_an_argument_that_has_no_rule_is_refused() -> None:
    """Every argument needs one rule, and every rule an argument: said when it is defined."""

    def speed(distance, time):
        return distance / time

    for rules in ({"distance": finite}, {"distance": finite, "time": finite, "mass": finite}, {}):
        with pytest.raises(TypeError, match="speed: every argument needs one rule"):
            formula(**rules)(speed)


def test_formula_uses_defaults_and_checks_them_too() -> None:
    """An argument left out has its default."""
    assert _product(3) == 6
    np.testing.assert_array_equal(_product([1, 2]), [2, 4])


def test_formula_relation_sees_every_argument_by_name() -> None:
    """A rule on several arguments together is asked after each has passed its own."""
    seen = {}

    @formula(together=seen.update, a=finite, b=finite)
    def total(a, b=1):
        return a + b

    assert total(2) == 3
    assert seen == {"a": 2, "b": 1}
