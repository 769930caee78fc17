import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from lesson_code.formulas import bounce, reflect, scaled_reflection

TRIGONOMETRY = 1e-12
"""Of a speed: directions come from sin and cos of a few radians, each right to 1e-15."""

TANGENT = 1e-12
"""Of a speed: what a bounce without friction may change the tangent part."""

GRAZING = 1e-6
"""Of a speed: a normal part below it may change sign by rounding, and with it the gate."""

EXACTLY_UNIT = [(1, 0), (0, 1), (-1, 0), (0, -1), (0.6, 0.8), (-0.8, 0.6), (0.28, -0.96)]

angles = st.floats(-math.pi, math.pi)
speeds = st.floats(1e-3, 1e3)
restitutions = st.floats(0, 1)
frictions = st.floats(0, 10)
components = st.floats(-1e3, 1e3, allow_subnormal=False)
velocities = st.tuples(components, components)


def direction(angle):
    """Return the unit vector at an angle."""
    return np.array([math.cos(angle), math.sin(angle)])


def parts(velocity, normal):
    """Return the normal part and the tangent part (a quarter turn on) of a velocity."""
    (x, y), (nx, ny) = velocity, normal
    return x * nx + y * ny, -x * ny + y * nx


def rotated(vector, angle):
    """Return a vector turned counter-clockwise."""
    (x, y), c, s = vector, math.cos(angle), math.sin(angle)
    return np.array([c * x - s * y, s * x + c * y])


def assert_close(measured, expected, scale, tolerance=TRIGONOMETRY):
    """Assert that two velocities differ by no more than a part of a speed."""
    np.testing.assert_allclose(measured, expected, rtol=0, atol=tolerance * scale)


# R = I - 2 (I . N) N
MIRRORED = {
    "straight down on a floor": ((0, -2), (0, 1), (0, 2)),
    "slanting on a floor": ((3, -4), (0, 1), (3, 4)),
    "right-hand wall": ((3, -4), (-1, 0), (-3, -4)),
    "along the wall": ((3, 0), (0, 1), (3, 0)),
    "at rest": ((0, 0), (0, 1), (0, 0)),
    "leaving is mirrored as well": ((3, 4), (0, 1), (3, -4)),
    "3-4-5 slope": ((5, 0), (0.6, 0.8), (1.4, -4.8)),  # I.N = 3
    "45 degree bumper, y down": ((1, 0), (math.sqrt(0.5), -math.sqrt(0.5)), (0, 1)),
}


@pytest.mark.parametrize(("incident", "normal", "mirrored"), MIRRORED.values(), ids=MIRRORED)
def test_mirror_image_worked_by_hand_is_found(incident, normal, mirrored) -> None:
    """R = I - 2 (I . N) N (Householder 1958)."""
    assert_close(reflect(incident, normal), mirrored, 5)


@given(speeds, angles, angles)
def test_mirror_image_leaves_at_the_angle_of_incidence(speed, incidence, normal) -> None:
    """A ray at angle a leaves a mirror with normal at angle b at 2 b + pi - a."""
    mirrored = reflect(speed * direction(incidence), direction(normal))
    assert_close(mirrored, speed * direction(2 * normal + math.pi - incidence), speed)


@given(velocities, angles)
def test_mirror_image_keeps_the_speed(velocity, angle) -> None:
    """A mirror changes direction, not speed."""
    speed = math.hypot(*velocity)
    assert math.hypot(*reflect(velocity, direction(angle))) == pytest.approx(
        speed, rel=TRIGONOMETRY
    )


@given(velocities, angles)
def test_mirror_image_of_the_mirror_image_is_the_original(velocity, angle) -> None:
    """Mirroring twice at one wall is the identity."""
    normal = direction(angle)
    assert_close(reflect(reflect(velocity, normal), normal), velocity, math.hypot(*velocity))


@given(velocities, angles)
def test_mirror_image_with_the_normal_reversed_is_the_same_bit_for_bit(velocity, angle) -> None:
    """R(I, N) = R(I, -N): the sign of N is squared away."""
    normal = direction(angle)
    np.testing.assert_array_equal(reflect(velocity, normal), reflect(velocity, -normal))


@given(velocities, angles, angles)
def test_mirror_image_of_a_rotated_scene_is_rotated(velocity, angle, turn) -> None:
    """The law knows no preferred direction."""
    turned = reflect(rotated(velocity, turn), direction(angle + turn))
    assert_close(turned, rotated(reflect(velocity, direction(angle)), turn), math.hypot(*velocity))


@given(velocities)
def test_mirror_image_at_a_level_floor_changes_the_sign_of_vy_exactly(velocity) -> None:
    """``vy *= -1`` is the special case of R for a level floor."""
    x, y = velocity
    np.testing.assert_array_equal(reflect(velocity, (0, 1)), (x, -y))


# Normal part times -e if it approaches; tangent part less at most mu jn.
BOUNCED = {
    "partly elastic": ((3, -4), (0, 1), 0.5, 0, (3, 2)),
    "elastic": ((3, -4), (0, 1), 1, 0, (3, 4)),
    "plastic keeps the tangent": ((3, -4), (0, 1), 0, 0, (3, 0)),
    "leaving": ((3, 4), (0, 1), 0.5, 1, (3, 4)),
    "along the wall": ((3, 0), (0, 1), 0.5, 1, (3, 0)),
    "friction slows": ((3, -4), (0, 1), 0.5, 0.25, (1.5, 2)),  # jn = 6, limit 1.5
    "friction stops": ((3, -4), (0, 1), 0.5, 1, (0, 2)),  # limit 6
    "friction the other way": ((-3, -4), (0, 1), 0.5, 0.25, (-1.5, 2)),
    "friction with e = 0": ((3, -4), (0, 1), 0, 0.5, (1, 0)),  # jn = 4, limit 2
    "3-4-5 slope": ((-5, 0), (0.6, 0.8), 0.5, 0, (-2.3, 3.6)),  # vn = -3, jn = 4.5
    "y down, bottom wall": ((280, 180), (0, -1), 0.95, 0, (280, -171)),
}


@pytest.mark.parametrize(
    ("velocity", "normal", "e", "mu", "after"), BOUNCED.values(), ids=list(BOUNCED)
)
def test_bounce_worked_by_hand_is_found(velocity, normal, e, mu, after) -> None:
    """Restitution acts on the normal part, friction on the tangent part (Brach 1991, ch. 1)."""
    assert_close(bounce(velocity, normal, e, mu), after, math.hypot(*velocity))


@given(velocities, angles, restitutions)
def test_bounce_without_friction_keeps_the_tangent_part(velocity, angle, e) -> None:
    """A smooth wall cannot hold on to what slides along it (fault 26 of the source)."""
    normal = direction(angle)
    _, before = parts(velocity, normal)
    _, after = parts(bounce(velocity, normal, e), normal)
    assert after == pytest.approx(before, rel=0, abs=TANGENT * math.hypot(*velocity))


@given(velocities, angles, restitutions, frictions)
def test_bounce_returns_the_part_e_of_the_approach(velocity, angle, e, mu) -> None:
    """The normal part is -e times what it was, whatever friction does to the other."""
    normal = direction(angle)
    before, _ = parts(velocity, normal)
    assume(before < 0)
    after, _ = parts(bounce(velocity, normal, e, mu), normal)
    assert after == pytest.approx(-e * before, rel=0, abs=TRIGONOMETRY * math.hypot(*velocity))


@given(velocities, st.sampled_from(EXACTLY_UNIT), restitutions, frictions)
def test_bounce_of_a_leaving_ball_changes_nothing(velocity, normal, e, mu) -> None:
    """The gate: v . n >= 0 is left alone to the last bit, e and mu regardless."""
    approach, _ = parts(velocity, normal)
    assume(approach >= 0)
    np.testing.assert_array_equal(bounce(velocity, normal, e, mu), velocity)


@given(velocities, angles, restitutions, frictions)
def test_bounce_with_friction_stays_in_coulombs_cone(velocity, angle, e, mu) -> None:
    """The tangent part changes by at most mu times the change of the normal part."""
    normal = direction(angle)
    vn, vt = parts(velocity, normal)
    un, ut = parts(bounce(velocity, normal, e, mu), normal)
    rounding = TRIGONOMETRY * (1 + mu) * math.hypot(*velocity)
    assert abs(ut - vt) <= mu * abs(un - vn) + rounding


@given(velocities, angles, restitutions, frictions)
def test_bounce_with_friction_never_reverses_the_sliding(velocity, angle, e, mu) -> None:
    """Friction slows the tangent part down to zero, and no further."""
    normal = direction(angle)
    rounding = TRIGONOMETRY * math.hypot(*velocity)
    _, before = parts(velocity, normal)
    _, after = parts(bounce(velocity, normal, e, mu), normal)
    assert after * math.copysign(1, before) >= -rounding
    assert abs(after) <= abs(before) + rounding


@given(velocities, angles, restitutions, frictions)
def test_bounce_never_gains_speed(velocity, angle, e, mu) -> None:
    """For one ball that cannot spin, no e up to 1 and no mu adds energy."""
    speed = math.hypot(*velocity)
    assert math.hypot(*bounce(velocity, direction(angle), e, mu)) <= speed * (1 + TRIGONOMETRY)


@given(speeds, angles, st.floats(-1.5, 1.5))
def test_bounce_at_restitution_one_leaves_at_the_angle_of_incidence(speed, normal, slant) -> None:
    """The limit e = 1 is the mirror: slant goes to the other side of the normal."""
    after = bounce(-speed * direction(normal + slant), direction(normal), 1)
    assert_close(after, speed * direction(normal - slant), speed)


@given(velocities, angles)
def test_bounce_at_restitution_zero_slides_along_the_wall(velocity, angle) -> None:
    """The limit e = 0 leaves no normal part, and all of the tangent part."""
    normal = direction(angle)
    vn, vt = parts(velocity, normal)
    assume(vn < 0)
    tangent = np.array([-normal[1], normal[0]])
    assert_close(bounce(velocity, normal, 0), vt * tangent, math.hypot(*velocity))


@given(velocities, angles, angles, restitutions, frictions)
def test_bounce_of_a_rotated_scene_is_rotated(velocity, angle, turn, e, mu) -> None:
    """The law knows no preferred direction."""
    turned = bounce(rotated(velocity, turn), direction(angle + turn), e, mu)
    after = rotated(bounce(velocity, direction(angle), e, mu), turn)
    assert_close(turned, after, (1 + mu) * math.hypot(*velocity))


@given(velocities, st.sampled_from(EXACTLY_UNIT), restitutions, frictions)
def test_bounce_in_a_mirror_is_mirrored(velocity, normal, e, mu) -> None:
    """With left and right exchanged the same bounce happens, to the last bit."""
    mirror = np.array([-1.0, 1.0])
    np.testing.assert_array_equal(
        bounce(mirror * velocity, mirror * normal, e, mu), mirror * bounce(velocity, normal, e, mu)
    )


@given(velocities, angles, restitutions)
def test_scaled_reflection_keeps_the_part_e_squared_of_the_energy(velocity, angle, e) -> None:
    """Scaling R keeps e^2 of all energy, the tangent's too; a leaving ball loses none."""
    normal = direction(angle)
    speed = math.hypot(*velocity)
    vn, _ = parts(velocity, normal)
    assume(abs(vn) > GRAZING * speed)
    kept = e if vn < 0 else 1
    after = scaled_reflection(velocity, normal, e)
    assert math.hypot(*after) == pytest.approx(kept * speed, rel=0, abs=TRIGONOMETRY * speed)


@given(velocities, st.sampled_from(EXACTLY_UNIT), restitutions)
def test_scaled_reflection_of_a_leaving_ball_changes_nothing(velocity, normal, e) -> None:
    """The gate is the same as that of a bounce: v . n >= 0 is left alone to the last bit."""
    approach, _ = parts(velocity, normal)
    assume(approach >= 0)
    np.testing.assert_array_equal(scaled_reflection(velocity, normal, e), velocity)


@given(speeds, angles, st.floats(-1.5, 1.5), restitutions)
def test_scaled_reflection_leaves_at_the_angle_of_incidence(speed, normal, slant, e) -> None:
    """The scaled image is as long as e says and points where the mirror image points."""
    after = scaled_reflection(-speed * direction(normal + slant), direction(normal), e)
    assert_close(after, e * speed * direction(normal - slant), speed)


def test_scaled_reflection_shrinks_the_tangent_part_where_a_bounce_keeps_it() -> None:
    """Fault 26 of the source: (280, 180) px/s on the bottom wall (y down), e = 0.95.

    e R gives (266, -171) and keeps .9025 of the energy; a bounce gives (280, -171) and .9715.
    """
    velocity, normal = (280, 180), (0, -1)
    scaled, right = scaled_reflection(velocity, normal, 0.95), bounce(velocity, normal, 0.95)
    assert_close(scaled, (266, -171), 333)
    assert_close(right, (280, -171), 333)
    before = 280**2 + 180**2
    assert (scaled @ scaled) / before == pytest.approx(0.9025, abs=1e-12)
    assert (right @ right) / before == pytest.approx(0.97149, abs=5e-6)  # 107641 / 110800


VELOCITIES = np.array([[3, -4], [3, 4], [0, -2], [-1, -1], [0, 0]])


def test_bounce_of_a_batch_with_one_wall_and_a_restitution_each_is_right() -> None:
    """Velocities (5, 2), normal (2,), restitution (5,): five bounces on one floor."""
    after = bounce(VELOCITIES, (0, 1), [0.5, 0.5, 0, 1, 1])
    np.testing.assert_array_equal(after, [[3, 2], [3, 4], [0, 0], [-1, 1], [0, 0]])


def test_bounce_of_one_velocity_with_many_restitutions_gives_one_result_each() -> None:
    """Restitution (4,) beside one velocity: four results of shape (4, 2)."""
    after = bounce((3, -4), (0, 1), [0, 0.25, 0.5, 1])
    np.testing.assert_array_equal(after, [[3, 0], [3, 1], [3, 2], [3, 4]])


def test_bounce_of_batches_in_two_directions_gives_a_table() -> None:
    """Velocities (5, 2) with restitutions (3, 1): shape (3, 5, 2), normal parts times e."""
    after = bounce(VELOCITIES, (0, 1), np.array([[0.0], [0.5], [1.0]]))
    assert after.shape == (3, 5, 2)
    np.testing.assert_array_equal(after[..., 0], np.tile([3, 3, 0, -1, 0], (3, 1)))
    np.testing.assert_array_equal(
        after[..., 1], [[0, 4, 0, 0, 0], [2, 4, 1, 0.5, 0], [4, 4, 2, 1, 0]]
    )


def test_bounce_with_a_friction_each_is_right() -> None:
    """Friction (3,) beside one velocity: frictionless, sliding, stopped."""
    after = bounce((3, -4), (0, 1), 0.5, friction=[0, 0.25, 1])
    np.testing.assert_array_equal(after, [[3, 2], [1.5, 2], [0, 2]])


def test_mirror_image_of_one_velocity_at_many_walls_gives_one_result_each() -> None:
    """One velocity beside normals (3, 2): three mirror images."""
    mirrored = reflect((3, -4), [(0, 1), (1, 0), (0, -1)])
    np.testing.assert_array_equal(mirrored, [[3, 4], [-3, -4], [3, 4]])


def test_scaled_reflection_of_a_batch_asks_each_velocity_whether_it_leaves() -> None:
    """The gate is asked per ball, restitution is given per ball."""
    after = scaled_reflection(VELOCITIES, (0, 1), [0.5, 0.5, 0, 1, 1])
    np.testing.assert_array_equal(after, [[1.5, 2], [3, 4], [0, 0], [-1, 1], [0, 0]])


def test_mirror_image_of_extreme_speeds_is_finite_and_right() -> None:
    """1e300 m/s and 1e-300 m/s are velocities like any other."""
    np.testing.assert_array_equal(reflect((3e300, -4e300), (0, 1)), [3e300, 4e300])
    after = bounce((3e-300, -4e-300), (0, 1), 0.5)
    np.testing.assert_allclose(after, [3e-300, 2e-300], rtol=TRIGONOMETRY)
