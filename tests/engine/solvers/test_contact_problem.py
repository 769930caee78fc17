"""Contact problems: the error of an answer, the cases that impulses belong to, what is legal."""

from __future__ import annotations

import numpy as np

from lesson_code.engine.solvers.contact_problem import (
    BACKWARD,
    FORWARD,
    OPEN,
    SPRINGS,
    STICK,
    Problem,
    cases_of,
    complementarity_error,
    legal,
    spring_of,
    without_friction,
)


def test_error_is_the_largest_fault_as_a_velocity() -> None:
    """Half of the impulse that is needed leaves half of the approach; a pull is one, too."""
    ball = Problem(np.diag([2.0, 6.0]), np.array([-2.0, 0.0]), np.array([0.5]))
    assert complementarity_error(ball, np.array([0.5, 0.0])) == 1.0
    assert complementarity_error(ball, np.array([1.0, 0.0])) == 0.0
    assert complementarity_error(ball, np.array([1.0, 0.25])) == 1.5
    assert complementarity_error(ball, np.array([-1.0, 0.0])) == 4.0


def test_error_counts_friction_along_the_sliding() -> None:
    """With jt = mu jn forwards it slides forwards at 1 m/s: jt should be -mu jn."""
    ball = Problem(np.diag([1.0, 2.0]), np.array([-1.0, 0.0]), np.array([0.5]))
    assert complementarity_error(ball, np.array([1.0, 0.5])) == 1.0


def test_cases_of_impulses_are_read_off() -> None:
    """No push: open. Friction below, at, or at the other end of mu jn: sticks, slides, slides back.

    A contact without friction slides, with a friction of 0.
    """
    friction = np.array([0.5, 0.5, 0.5, 0.5, 0.0])
    x = np.array([0.0, 2.0, 2.0, 2.0, 2.0, 0.0, 0.5, 1.0, -1.0, 0.0])
    assert cases_of(friction, x).tolist() == [OPEN, STICK, FORWARD, BACKWARD, FORWARD]


def test_contact_without_friction_never_sticks() -> None:
    """Where mu = 0 all that is closed counts as sliding."""
    cases = without_friction(np.array([0.0, 0.0, 1.0]), np.array([STICK, OPEN, STICK]))
    assert cases.tolist() == [FORWARD, OPEN, STICK]


def test_legal_impulses_neither_pull_nor_exceed_the_cone() -> None:
    """What rounding has put beyond a limit goes back to it."""
    problem = Problem(np.eye(4), np.zeros(4), np.array([0.5, 0.5]))
    x = legal(problem, np.array([-1e-17, 2.0, 1e-17, -1.1]))
    assert x.tolist() == [0.0, 2.0, 0.0, -1.0]


def test_spring_is_a_part_of_the_mean_compliance() -> None:
    """So that grams and tonnes are treated alike."""
    problem = Problem(np.diag([1.0, 3.0]), np.zeros(2), np.zeros(1))
    assert spring_of(problem) == 2 * SPRINGS[0]
