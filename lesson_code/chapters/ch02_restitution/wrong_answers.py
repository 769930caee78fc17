"""Wrong models of chapter 02: restitution."""

from __future__ import annotations

from lesson_code.course.grading.task import wrong_model


@wrong_model("2.1", "A ball that bounces back at all: should its restitution be negative?")
def sign_lost(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Separation and approach are both first velocity minus second."""
    return (v1_after - v2_after) / (v1 - v2)


@wrong_model("2.1", "Is restitution a ratio of speeds, or of energies?")
def as_energy_ratio(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Restitution is the part of the energy that comes back."""
    return ((v2_after - v1_after) / (v1 - v2)) ** 2


@wrong_model("2.1", "Is restitution a ratio of energies, and does an energy not need a mass?")
def energies_without_masses(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Restitution compares the squares of all velocities after with those before."""
    return (v1_after**2 + v2_after**2) / (v1**2 + v2**2)


@wrong_model("2.1", "Both fly on to the right after it. Does the larger speed tell how they part?")
def fastest_over_fastest(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Restitution compares the largest speed after with the largest before."""
    return max(abs(v1_after), abs(v2_after)) / max(abs(v1), abs(v2))


@wrong_model("2.1", "A light ball and a heavy one: does either speed alone tell how they parted?")
def first_body_only(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Restitution compares one body's own speed after with its speed before."""
    return -v1_after / v1


@wrong_model("2.1", "Which is larger after a lossy collision: the approach or the separation?")
def upside_down(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Restitution is approach over separation."""
    return (v1 - v2) / (v2_after - v1_after)


@wrong_model("2.2", "Add up the momentum after your collision. Where did the rest of it go?")
def scaled_elastic_velocities(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """The velocities after are e times those of an elastic collision."""
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return restitution * (2 * v - v1), restitution * (2 * v - v2)


@wrong_model("2.2", "For e = 0.25: does the separation come out as 0.25 or 0.5 of the approach?")
def energy_restitution(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """Restitution is the part of the energy of approach that comes back."""
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    approach = restitution**0.5 * (v1 - v2)
    return v - approach * m2 / (m1 + m2), v + approach * m1 / (m1 + m2)


@wrong_model("2.2", "With e = 1, is the kinetic energy after yours the same as before?")
def doubled_impulse(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """The impulse takes a factor 2 for the bounce and a factor 1 + e for the restitution."""
    impulse = 2 * (1 + restitution) * (v1 - v2) / (1 / m1 + 1 / m2)
    return v1 - impulse / m1, v2 + impulse / m2


@wrong_model("2.2", "With e = 0 your bodies do not touch each other's motion. What should they do?")
def forgets_to_stop(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """The impulse is e times the approach; nothing is needed to stop it first."""
    impulse = restitution * (v1 - v2) / (1 / m1 + 1 / m2)
    return v1 - impulse / m1, v2 + impulse / m2


@wrong_model("2.2", "Where are the masses in your answer?")
def equal_mass_formula(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """The formula for equal masses serves for all."""
    v, half_approach = (v1 + v2) / 2, (v1 - v2) / 2
    return v - restitution * half_approach, v + restitution * half_approach


@wrong_model("2.2", "Does a truck change its velocity as much as the fly that it meets?")
def half_the_separation_each(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """Each body leaves the common velocity with half of the separation."""
    v, half = (m1 * v1 + m2 * v2) / (m1 + m2), restitution * (v1 - v2) / 2
    return v - half, v + half


@wrong_model("2.3", "Speed comes back by the factor e. How does height depend on speed?")
def speed_factor_for_height(height: float, restitution: float, count: int) -> list[float]:
    """Each bounce multiplies the height by e."""
    return [height * restitution**n for n in range(1, count + 1)]


@wrong_model("2.3", "Is the height it is dropped from a height after a bounce?")
def starts_with_the_drop(height: float, restitution: float, count: int) -> list[float]:
    """The list starts with the height of the drop."""
    return [height * restitution ** (2 * n) for n in range(count)]


@wrong_model("2.3", "After two bounces, is the loss taken from the first height or the last?")
def loses_the_same_each_time(height: float, restitution: float, count: int) -> list[float]:
    """Every bounce takes the same height away."""
    lost = height * (1 - restitution**2)
    return [max(0.0, height - n * lost) for n in range(1, count + 1)]


@wrong_model("2.3", "Your first height is right. What does the second bounce start from?")
def one_bounce_only(height: float, restitution: float, count: int) -> list[float]:
    """Every bounce rises to e^2 of the first drop."""
    return [height * restitution**2 for _ in range(count)]


@wrong_model(
    "2.4", "Draw the height over time. How long is the first piece, and how long the next?"
)
def first_fall_like_the_others(height: float, restitution: float, gravity: float) -> float:
    """The drop takes as long as a whole flight up and down."""
    return float(2 * (2 * height / gravity) ** 0.5 / (1 - restitution))


@wrong_model("2.4", "The ball rises before it falls. How long is a flight up and down?")
def forgets_the_way_up(height: float, restitution: float, gravity: float) -> float:
    """Only the falls take time."""
    return float((2 * height / gravity) ** 0.5 / (1 - restitution))


@wrong_model("2.4", "Heights shrink by e^2 a bounce. By which factor do the flight times shrink?")
def times_shrink_like_heights(height: float, restitution: float, gravity: float) -> float:
    """Flight times shrink by e^2, as the heights do."""
    fall = (2 * height / gravity) ** 0.5
    return float(fall * (1 + restitution**2) / (1 - restitution**2))


@wrong_model("2.4", "You stop counting after ten bounces. How much time do all the others take?")
def ten_bounces(height: float, restitution: float, gravity: float) -> float:
    """After ten bounces the ball is as good as at rest."""
    fall = (2 * height / gravity) ** 0.5
    return float(fall + sum(2 * fall * restitution**n for n in range(1, 11)))


@wrong_model(
    "2.4", "How much time do two bounces take that reach 1 m and 0.25 m: 4 to 1, or 2 to 1?"
)
def falls_shrink_like_heights(height: float, restitution: float, gravity: float) -> float:
    """Each fall takes e^2 of the time of the one before, and nothing else takes time."""
    return float((2 * height / gravity) ** 0.5 / (1 - restitution**2))


@wrong_model("2.1", "One cart runs after the other. How fast do they approach: by the sum?")
def speeds_added_up(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Approach and separation are sums of speeds, whichever way each body goes."""
    return (abs(v1_after) + abs(v2_after)) / (abs(v1) + abs(v2))


@wrong_model("2.3", "In the second turn of your loop: which power of e do you multiply by?")
def squares_again_each_time(height: float, restitution: float, count: int) -> list[float]:
    """Each bounce squares the factor once more."""
    heights, factor = [], restitution
    for _ in range(int(count)):
        factor = factor * factor
        height = height * factor
        heights.append(height)
    return heights


@wrong_model("2.3", "e^2 after one bounce, e^4 after two. Which power of e have you after three?")
def power_doubles_each_time(height: float, restitution: float, count: int) -> list[float]:
    """Each bounce squares the factor between the drop and the height."""
    return [height * restitution ** (2**n) for n in range(1, int(count) + 1)]


@wrong_model("2.2", "A fly meets a train. Does the train come back with e times its speed?")
def each_as_from_a_wall(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """Each body bounces off the other as off a wall."""
    return -restitution * v1, -restitution * v2


@wrong_model("2.4", "Is the time on the moon what it is on earth?")
def always_on_earth(height: float, restitution: float, gravity: float) -> float:
    """Gravity is 9.81 m/s^2."""
    return float((2 * height / 9.81) ** 0.5 * (1 + restitution) / (1 - restitution))


@wrong_model("2.1", "Two carts roll on, equally fast. Do they approach each other?")
def sums_with_their_signs(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Restitution is the sum of the velocities after, over the sum of those before."""
    return (v1_after + v2_after) / (v1 + v2)


@wrong_model("2.1", "Two carts meet head on, both at 2 m/s. How fast do they approach?")
def differences_of_speeds(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Approach and separation are differences of speeds, whichever way each body goes."""
    return abs((abs(v2_after) - abs(v1_after)) / (abs(v1) - abs(v2)))


@wrong_model("2.1", "A perfect bounce has e = 1. What has it by your formula?")
def the_part_that_is_lost(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Restitution is the part of the speed that is lost."""
    return 1 - (v2_after - v1_after) / (v1 - v2)


@wrong_model("2.1", "A fly bounces off a train. Does either speed alone tell how they part?")
def mean_of_both_ratios(v1: float, v2: float, v1_after: float, v2_after: float) -> float:
    """Each body has a ratio of its speeds, and restitution is the mean of both."""
    return (abs(v1_after / v1) + abs(v2_after / v2)) / 2


@wrong_model("2.2", "With e = 0, do your bodies stick together? And is the momentum kept?")
def scaled_by_the_root(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """Restitution is the part of all energy that is left, so each speed is less by its root."""
    v, part = (m1 * v1 + m2 * v2) / (m1 + m2), restitution**0.5
    return part * (2 * v - v1), part * (2 * v - v2)


@wrong_model("2.2", "A light ball and a heavy one: is the momentum kept in yours?")
def exchanged_and_slowed(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """The bodies exchange their velocities, and e is left of them."""
    return restitution * v2, restitution * v1


@wrong_model("2.3", "How many heights were asked for, and is the drop a bounce?")
def begins_with_the_drop_besides(height: float, restitution: float, count: int) -> list[float]:
    """The height of the drop stands in front of the heights after the bounces."""
    return [height * restitution ** (2 * n) for n in range(int(count) + 1)]


@wrong_model("2.3", "A ball with e = 1 loses nothing. How high does yours rise then?")
def what_is_lost(height: float, restitution: float, count: int) -> list[float]:
    """Each height is what the bounce takes away: the part 1 - e^2 of the one before."""
    return [height * (1 - restitution**2) ** n for n in range(1, int(count) + 1)]


@wrong_model("2.3", "Which unit have the numbers that you return: m/s, or m?")
def speeds_for_heights(height: float, restitution: float, count: int) -> list[float]:
    """What is asked for is how fast the ball leaves the floor."""
    speed = (2 * 9.81 * height) ** 0.5
    return [float(speed * restitution**n) for n in range(1, int(count) + 1)]


@wrong_model("2.4", "Ten falls of 1 m, one after the other: do they last as long as one of 10 m?")
def one_fall_of_the_whole_way(height: float, restitution: float, gravity: float) -> float:
    """All ways up and down together take as long as one fall of that length."""
    way = height * (1 + restitution**2) / (1 - restitution**2)
    return float((2 * way / gravity) ** 0.5)


@wrong_model("2.2", "In Python 0 counts as false. What does `if not restitution` do at e = 0?")
def nothing_is_elastic(
    m1: float, v1: float, m2: float, v2: float, restitution: float
) -> tuple[float, float]:
    """A restitution of 0 has not been given, and is 1."""
    e = restitution or 1.0
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v - e * (v1 - v), v - e * (v2 - v)


@wrong_model("2.3", "How many heights are asked for? May the last ones be too small to see?")
def stops_below_a_centimetre(height: float, restitution: float, count: int) -> list[float]:
    """A ball that comes less than a centimetre high bounces no more."""
    heights = [height * restitution ** (2 * k) for k in range(1, count + 1)]
    return [h for h in heights if h >= 0.01]
