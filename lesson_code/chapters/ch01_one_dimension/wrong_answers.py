"""Wrong models of chapter 01: collisions on a line."""

from __future__ import annotations

from lesson_code.course.grading.task import wrong_model


@wrong_model(
    "1.1", "Only equal masses exchange velocities. What is m1 v1 + m2 v2 before and after?"
)
def always_swaps(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """In every elastic collision the bodies exchange their velocities."""
    return v2, v1


@wrong_model("1.1", "Try it with the second body already moving. Where did v2 go?")
def target_at_rest(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The formula for a target at rest serves for every target."""
    return (m1 - m2) / (m1 + m2) * v1, 2 * m1 / (m1 + m2) * v1


@wrong_model("1.1", "Your second line uses v1. Is that still the velocity before the collision?")
def uses_updated_v1(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The new v1 may be stored before v2' is computed from it."""
    v1 = ((m1 - m2) * v1 + 2 * m2 * v2) / (m1 + m2)
    v2 = ((m2 - m1) * v2 + 2 * m1 * v1) / (m1 + m2)
    return v1, v2


@wrong_model("1.1", "What happens to a fly that hits a truck: which of the two changes course?")
def masses_exchanged(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The heavier body is changed more by the collision."""
    v1_after = ((m2 - m1) * v1 + 2 * m1 * v2) / (m1 + m2)
    v2_after = ((m1 - m2) * v2 + 2 * m2 * v1) / (m1 + m2)
    return v1_after, v2_after


@wrong_model("1.1", "Is the total momentum after your collision the same as before, sign and all?")
def both_turn_round(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """In an elastic collision each body leaves as fast as it came."""
    return -v1, -v2


@wrong_model("1.1", "Is v1 - v2 how fast body 2 leaves, or how fast the two leave each other?")
def separation_as_velocity(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """Body 2 leaves at the speed of the approach; body 1 has the rest of the momentum."""
    v2_after = v1 - v2
    return (m1 * v1 + m2 * v2 - m2 * v2_after) / m1, v2_after


@wrong_model("1.2", "A truck meets a fly head on. Does the truck lose half its speed?")
def plain_average(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """Bodies that stick together go on at the average of their velocities."""
    return (v1 + v2) / 2, (v1 + v2) / 2


@wrong_model("1.2", "What unit does your answer have? Momentum is not yet a velocity.")
def momentum_as_velocity(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The common velocity is the total momentum."""
    return m1 * v1 + m2 * v2, m1 * v1 + m2 * v2


@wrong_model("1.2", "Which mass belongs to which velocity in the total momentum?")
def weights_exchanged(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """Each velocity is weighted with the other body's mass."""
    v = (m2 * v1 + m1 * v2) / (m1 + m2)
    return v, v


@wrong_model("1.2", "Two equal lumps of clay meet head on and stop. Where is their energy then?")
def keeps_energy(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """Sticking together keeps the kinetic energy."""
    v = ((m1 * v1**2 + m2 * v2**2) / (m1 + m2)) ** 0.5
    return (v, v) if m1 * v1 + m2 * v2 >= 0 else (-v, -v)


@wrong_model("1.2", "The first body is still there after the collision. Which mass now moves?")
def first_mass_vanishes(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The momentum is handed to the second body, which carries all of it alone."""
    v = (m1 * v1 + m2 * v2) / m2
    return v, v


@wrong_model("1.2", "Your bodies stick together. Can they go on with two velocities?")
def each_by_its_own_mass(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """Each body gets its velocity from the total momentum and its own mass."""
    p = m1 * v1 + m2 * v2
    return p / m1, p / m2


@wrong_model("1.3", "Your impulse stops the approach. What else does an elastic collision do?")
def stops_only(m1: float, v1: float, m2: float, v2: float) -> float:
    """The impulse that brings the bodies to the same velocity is all there is."""
    return (v1 - v2) * m1 * m2 / (m1 + m2)


@wrong_model("1.3", "Both bodies yield. Is their joint resistance more or less than one mass?")
def adds_masses(m1: float, v1: float, m2: float, v2: float) -> float:
    """The masses of both bodies resist together, so they add."""
    return 2 * (v1 - v2) * (m1 + m2)


@wrong_model("1.3", "Body 1 comes from the left. Which way does it push body 2?")
def impulse_on_the_first(m1: float, v1: float, m2: float, v2: float) -> float:
    """The impulse points the way the first body is thrown back."""
    return -2 * (v1 - v2) * m1 * m2 / (m1 + m2)


@wrong_model("1.3", "Does the impulse change if both bodies move 1 m/s faster to the right?")
def ignores_second_velocity(m1: float, v1: float, m2: float, v2: float) -> float:
    """Only the first body's velocity makes the blow."""
    return 2 * v1 * m1 * m2 / (m1 + m2)


@wrong_model("1.3", "A ball meets a truck at rest. Does it stop dead, whatever the truck's mass?")
def momenta_exchanged(m1: float, v1: float, m2: float, v2: float) -> float:
    """In an elastic collision the bodies exchange their momenta."""
    return m1 * v1 - m2 * v2


@wrong_model("1.1", "Your bodies exchange their momenta. Is the kinetic energy still what it was?")
def momenta_change_hands(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """In an elastic collision the bodies exchange their momenta."""
    return m2 * v2 / m1, m1 * v1 / m2


@wrong_model("1.3", "Body 2 had momentum before. How much of it does the blow have to give?")
def momentum_of_both(m1: float, v1: float, m2: float, v2: float) -> float:
    """The impulse is all the momentum that the bodies bring along."""
    return m1 * v1 + m2 * v2


@wrong_model("1.2", "A slow truck and a fast car stick together. Does the car change nothing?")
def the_heavier_decides(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The lighter body goes on with the heavier one, as fast as that was."""
    v = v1 if m1 > m2 else v2 if m2 > m1 else (v1 + v2) / 2
    return v, v


@wrong_model("1.3", "What unit has your answer: N s, or J?")
def energy_for_impulse(m1: float, v1: float, m2: float, v2: float) -> float:
    """The impulse is the energy that body 2 receives."""
    after = v2 + 2 * m1 * (v1 - v2) / (m1 + m2)
    return m2 * (after**2 - v2**2) / 2


@wrong_model("1.1", "Your bodies exchange their energies. Is the momentum still what it was?")
def energies_change_hands(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """In an elastic collision the bodies exchange their kinetic energies."""
    return v2 * (m2 / m1) ** 0.5, v1 * (m1 / m2) ** 0.5


@wrong_model("1.1", "A ball hits one that is twice as heavy. Does that one feel nothing?")
def the_heavier_is_a_wall(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """The heavier body goes on as it was, and the lighter one bounces off it as off a wall."""
    if m1 == m2:
        return v2, v1
    return (v1, 2 * v1 - v2) if m1 > m2 else (2 * v2 - v1, v2)


@wrong_model("1.1", "A body ten times as heavy is no wall: which momentum does it take up?")
def ten_times_is_a_wall(m1: float, v1: float, m2: float, v2: float) -> tuple[float, float]:
    """A body of ten times the mass stays as it is, as a wall does."""
    if m2 >= 10 * m1:
        return 2 * v2 - v1, v2
    if m1 >= 10 * m2:
        return v1, 2 * v1 - v2
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * v - v1, 2 * v - v2
