"""Wrong answers of pupils and first-years, written from the texts of the tasks alone.

When they were first tried, after what FIFTH had taught, 53 of 60 were recognised, none falsely.
"""

from __future__ import annotations

from course.recognition.students import Wrong

SIXTH = (
    Wrong(
        "1.1",
        "The second line already uses the new v1 instead of the velocity before the collision, "
        "because v1 was overwritten",
        ("uses_updated_v1",),
        """
def elastic_1d(m1, v1, m2, v2):
    total = m1 + m2
    v1 = ((m1 - m2) * v1 + 2 * m2 * v2) / total
    v2 = ((m2 - m1) * v2 + 2 * m1 * v1) / total
    return v1, v2
""",
    ),
    Wrong(
        "1.2",
        "The student believes that kinetic energy is what survives when the bodies stick "
        "together, and gets the common speed from it",
        ("keeps_energy",),
        """
import math


def inelastic_1d(m1, v1, m2, v2):
    # Energieerhaltung: 1/2 m1 v1^2 + 1/2 m2 v2^2 = 1/2 (m1 + m2) u^2
    E = 0.5 * m1 * v1**2 + 0.5 * m2 * v2**2
    u = math.sqrt(2 * E / (m1 + m2))
    if m1 * v1 + m2 * v2 < 0:
        u = -u
    return u, u
""",
    ),
    Wrong(
        "1.3",
        "The student stops at the moment of equal velocities (greatest compression) and "
        "forgets that an elastic collision pushes just as much again while the bodies spring "
        "back",
        ("stops_only",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    mu = m1 * m2 / (m1 + m2)  # reduced mass
    v_rel = v1 - v2
    J = mu * v_rel
    return J
""",
    ),
    Wrong(
        "2.1",
        "Speed is taken as the magnitude of each body's own velocity, so the approach is the "
        "sum of two speeds even if one body runs after the other",
        ("speeds_added_up",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    approach = abs(v1) + abs(v2)
    separation = abs(v1_after) + abs(v2_after)
    return separation / approach
""",
    ),
    Wrong(
        "2.2",
        "The student thinks that restitution scales the final velocities of the elastic "
        "collision, so that the momentum shrinks too",
        ("scaled_elastic_velocities",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    M = m1 + m2
    u1 = (m1 - m2) / M * v1 + 2 * m2 / M * v2
    u2 = 2 * m1 / M * v1 + (m2 - m1) / M * v2
    return restitution * u1, restitution * u2
""",
    ),
    Wrong(
        "2.3",
        "The height is appended before it is reduced, so the list starts with the drop height "
        "and ends one bounce early",
        ("starts_with_the_drop",),
        """
def bounce_heights(height, restitution, count):
    heights = []
    h = height
    for i in range(count):
        heights.append(h)
        h = h * restitution ** 2
    return heights
""",
    ),
    Wrong(
        "2.4",
        "The student sums only the times of falling and forgets that after each bounce the "
        "ball also needs the same time to go up",
        ("forgets_the_way_up",),
        """
from math import sqrt


def rest_time(height, restitution, gravity):
    # t0 + e t0 + e^2 t0 + ...  -> geometric progression
    t0 = sqrt(2 * height / gravity)
    return t0 / (1 - restitution)
""",
    ),
    Wrong(
        "3.1",
        "The vector is mirrored in the normal as an axis instead of in the wall, so the part "
        "along the wall is turned round and the ball goes on into the wall",
        ("opposite_sign",),
        """
import numpy as np


def reflect(incident, normal):
    d = np.asarray(incident, dtype=float)
    n = np.asarray(normal, dtype=float)
    return 2 * np.dot(d, n) * n - d
""",
    ),
    Wrong(
        "3.2",
        "The student puts e into the mirror formula as 2 e (v.n) n instead of (1 + e) (v.n) n, "
        "so with e = 0 the ball is not stopped at all",
        ("one_plus", "term"),
        """
import numpy as np


def bounce(velocity, normal, restitution):
    vn = velocity[0] * normal[0] + velocity[1] * normal[1]
    if vn >= 0:
        return velocity
    vx = velocity[0] - 2 * restitution * vn * normal[0]
    vy = velocity[1] - 2 * restitution * vn * normal[1]
    return np.array([vx, vy])
""",
    ),
    Wrong(
        "3.3",
        "The early return for a ball that is already leaving comes before the separation, so "
        "such a ball is left inside the wall",
        ("gate_before_position",),
        """
import numpy as np


def resolve_wall(position, velocity, normal, depth, restitution):
    speed_in = np.dot(velocity, normal)
    if speed_in >= 0:
        return position, velocity
    new_position = position + depth * normal
    new_velocity = velocity - (1 + restitution) * speed_in * normal
    return new_position, new_velocity
""",
    ),
    Wrong(
        "4.1",
        "To avoid the square root the squared distance is compared with r1**2 + r2**2 instead "
        "of (r1 + r2)**2, so shallow overlaps are missed",
        ("radii_squared_apart",),
        """
import numpy as np


def circle_contact(p1, r1, p2, r2):
    delta = np.array(p2, dtype=float) - np.array(p1, dtype=float)
    dist_sq = delta @ delta
    if dist_sq >= r1 ** 2 + r2 ** 2:
        return None
    dist = np.sqrt(dist_sq)
    if dist == 0:
        return np.array([1.0, 0.0]), r1 + r2
    return delta / dist, r1 + r2 - dist
""",
    ),
    Wrong(
        "4.2",
        "The one-dimensional formula is applied to x and to y separately, as if the push acted "
        "along both axes whatever the normal is",
        ("one_dimension_on_each_axis",),
        """
import numpy as np


def resolve_circles(v1, m1, v2, m2, normal, restitution):
    if np.dot(v2 - v1, normal) >= 0:
        return v1, v2
    v_cm = (m1 * v1 + m2 * v2) / (m1 + m2)
    after1 = v_cm - restitution * m2 / (m1 + m2) * (v1 - v2)
    after2 = v_cm - restitution * m1 / (m1 + m2) * (v2 - v1)
    return after1, after2
""",
    ),
    Wrong(
        "4.3",
        "Each circle is moved in proportion to its own mass, so that the heavier one goes "
        "further; the fixed case is patched by hand",
        ("in_proportion_to_mass",),
        """
import math


def separate(p1, m1, p2, m2, normal, depth):
    if math.isinf(m1):
        share1, share2 = 0.0, 1.0
    elif math.isinf(m2):
        share1, share2 = 1.0, 0.0
    else:
        share1 = m1 / (m1 + m2)
        share2 = m2 / (m1 + m2)
    return p1 - share1 * depth * normal, p2 + share2 * depth * normal
""",
    ),
    Wrong(
        "4.4",
        "A copied line was not changed: the velocity of circle 2 is changed with the inverse "
        "mass of circle 1",
        ("one_mass_for_both",),
        """
import numpy as np


def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    w1 = 1 / m1
    w2 = 1 / m2
    # push apart
    q1 = p1 - normal * depth * w1 / (w1 + w2)
    q2 = p2 + normal * depth * w2 / (w1 + w2)
    # bounce
    u = np.dot(v2 - v1, normal)
    u1, u2 = v1, v2
    if u < 0:
        j = -(1 + restitution) * u / (w1 + w2)
        u1 = v1 - j * w1 * normal
        u2 = v2 + j * w1 * normal
    return q1, u1, q2, u2
""",
    ),
    Wrong(
        "5.1",
        "The mean of the vertices is taken for the centroid of the area; this is wrong for "
        "irregular polygons and for a vertex in the middle of an edge",
        ("average_of_the_vertices",),
        """
import numpy as np


def moment_of_inertia(mass, vertices):
    pts = vertices - vertices.mean(axis=0)
    nxt = np.roll(pts, -1, axis=0)
    c = pts[:, 0] * nxt[:, 1] - pts[:, 1] * nxt[:, 0]
    q = (pts * pts).sum(1) + (pts * nxt).sum(1) + (nxt * nxt).sum(1)
    return mass * (c * q).sum() / (6 * c.sum())
""",
    ),
    Wrong(
        "5.2",
        "The lever is turned by 90 degrees clockwise instead of counter-clockwise, so the "
        "turning part has the wrong sign",
        ("turns_clockwise",),
        """
import numpy as np


def contact_velocity(v, w, r):
    x, y = r
    return np.array([v[0] + w * y, v[1] - w * x])
""",
    ),
    Wrong(
        "5.3",
        "The student takes the part of the lever along the push (dot product) where the "
        "perpendicular lever arm (cross product) belongs",
        ("dot_for_cross",),
        """
import numpy as np


def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    k = 0.0
    for m, i, r in ((m_a, i_a, r_a), (m_b, i_b, r_b)):
        lever = float(np.dot(r, direction))
        k += 1 / m + lever * lever / i
    return k
""",
    ),
    Wrong(
        "5.4",
        "Only the upper limit is applied; a negative impulse larger than the Coulomb limit is "
        "let through",
        ("clamped_on_one_side",),
        """
def friction_impulse(vt, jn, friction, k):
    limit = friction * jn
    wanted = -vt / k
    if wanted > limit:
        wanted = limit
    return wanted
""",
    ),
    Wrong(
        "5.5",
        "The sliding at the wall is computed from the centre's velocity alone; the student "
        "forgets that the spin moves the rim along the wall as well",
        ("sliding_of_the_centre",),
        """
import numpy as np


def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    n = np.asarray(normal, float)
    t = np.array([-n[1], n[0]])
    vn = velocity @ n
    if vn >= 0:
        return velocity, w
    jn = -(1 + restitution) * vn
    inertia = radius**2 / 2
    k = 1 + radius**2 / inertia
    vt = velocity @ t
    jt = np.clip(-vt / k, -friction * jn, friction * jn)
    new_v = velocity + jn * n + jt * t
    new_w = w - radius * jt / inertia
    return new_v, new_w
""",
    ),
    Wrong(
        "6.1",
        "The loop ends one edge too early: the edge from the last vertex back to the first is "
        "left out",
        ("last_edge_missing",),
        """
import numpy as np


def sat_axes(vertices):
    axes = []
    for i in range(len(vertices) - 1):
        ex = vertices[i + 1][0] - vertices[i][0]
        ey = vertices[i + 1][1] - vertices[i][1]
        length = np.hypot(ex, ey)
        if length == 0:
            continue
        axes.append(np.array([ey / length, -ex / length]))
    return axes
""",
    ),
    Wrong(
        "6.2",
        "Low and high start at 0, so the shadow always reaches to the origin even if the "
        "polygon lies far from it",
        ("starts_from_zero",),
        """
def project(vertices, axis):
    low = 0.0
    high = 0.0
    for v in vertices:
        s = v[0] * axis[0] + v[1] * axis[1]
        if s < low:
            low = s
        if s > high:
            high = s
    return low, high
""",
    ),
    Wrong(
        "6.3",
        "The length of the common part is returned; if one interval lies inside the other, B "
        "must move further than that to be out",
        ("common_part",),
        """
def overlap(interval_a, interval_b):
    common = min(interval_a[1], interval_b[1]) - max(interval_a[0], interval_b[0])
    return common if common > 0 else None
""",
    ),
    Wrong(
        "6.4",
        "The normal of the best axis is kept, but the depth that is returned is the one of the "
        "last axis that was tested",
        ("depth_of_the_last_axis",),
        """
import numpy as np


def mtv(vertices_a, vertices_b):
    axes = []
    for poly in (vertices_a, vertices_b):
        for k in range(len(poly)):
            edge = poly[(k + 1) % len(poly)] - poly[k]
            size = np.linalg.norm(edge)
            if size > 0:
                axes.append(np.array([edge[1], -edge[0]]) / size)

    smallest = float("inf")
    best_axis = None
    for axis in axes:
        a = vertices_a @ axis
        b = vertices_b @ axis
        right = a.max() - b.min()
        left = b.max() - a.min()
        depth = min(right, left)
        if depth <= 0:
            return None
        if depth < smallest:
            smallest = depth
            best_axis = axis if right <= left else -axis
    return best_axis, depth
""",
    ),
    Wrong(
        "6.6",
        "A centre inside the polygon is treated like one outside: the normal goes from the "
        "nearest edge point to the centre, which then leads deeper in",
        ("deeper_when_inside",),
        """
import numpy as np


def closest_point_on_segment(point, start, end):
    way = end - start
    part = np.dot(point - start, way) / np.dot(way, way)
    return start + min(max(part, 0.0), 1.0) * way


def circle_against_polygon(centre, radius, vertices):
    n = len(vertices)
    edges = [(vertices[i], vertices[(i + 1) % n]) for i in range(n)]
    candidates = [closest_point_on_segment(centre, start, end) for start, end in edges]
    nearest = min(candidates, key=lambda q: np.linalg.norm(centre - q))
    away = centre - nearest
    distance = np.linalg.norm(away)
    if distance >= radius:
        return None
    return away / distance, radius - distance
""",
    ),
    Wrong(
        "7.1",
        "Every overlap at the start counts as a meeting now; the student does not ask whether "
        "the circles approach or part",
        ("overlapping_is_always_now",),
        """
import math
import numpy as np


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    s = p2 - p1
    u = v2 - v1
    R = r1 + r2
    c = np.dot(s, s) - R * R
    if c <= 0:
        return 0.0
    a = np.dot(u, u)
    b = np.dot(s, u)
    if a == 0 or b >= 0:
        return None
    disc = b * b - a * c
    if disc < 0:
        return None
    t = c / (-b + math.sqrt(disc))
    return t if t <= dt else None
""",
    ),
    Wrong(
        "7.2",
        "The time to go up and the time to fall from the starting height are added; the "
        "student forgets that the ball falls from the higher turning point",
        ("falls_from_the_start",),
        """
import math


def time_to_floor(height, velocity, gravity):
    if gravity == 0:
        if velocity < 0:
            return height / -velocity
        return None
    if velocity > 0:
        t_up = velocity / gravity
        t_down = math.sqrt(2 * height / gravity)
        return t_up + t_down
    # thrown downwards or dropped
    u = -velocity
    return 2 * height / (u + math.sqrt(u * u + 2 * gravity * height)) if height > 0 else 0.0
""",
    ),
    Wrong(
        "7.3",
        "After each impact the rest is computed from the whole step (dt - t) and not from what "
        "was left, so a second wall makes the flight too long",
        ("rest_of_the_whole_step", "stale"),
        """
import numpy as np


def advance(p, v, room, restitution, dt):
    p = np.array(p, dtype=float)
    v = np.array(v, dtype=float)
    rest = dt
    for _ in range(1000):
        times = []
        for k in (0, 1):
            wall = room[k] if v[k] > 0 else 0.0
            times.append((wall - p[k]) / v[k] if v[k] != 0 else float("inf"))
        k = int(np.argmin(times))
        t = max(times[k], 0.0)
        if t >= rest:
            break
        p = p + v * t
        p[k] = room[k] if v[k] > 0 else 0.0
        v[k] = -restitution * v[k]
        rest = dt - t
    return p + v * rest, v
""",
    ),
    Wrong(
        "7.5",
        "The student thinks that all is over once the outer block has turned round, although "
        "the inner block may still be faster and catch up with it",
        ("until_the_heavy_block_turns",),
        """
def pi_collisions(mass_ratio):
    M = mass_ratio
    u = 0.0   # inner block, 1 kg
    V = -1.0  # outer block; the wall is on the left
    count = 0
    while V < 0:
        # blocks
        u, V = ((1 - M) * u + 2 * M * V) / (1 + M), ((M - 1) * V + 2 * u) / (1 + M)
        count += 1
        # wall
        if u < 0:
            u = -u
            count += 1
    return count
""",
    ),
    Wrong(
        "8.1",
        "The largest difference of a single coordinate is returned instead of the largest "
        "distance by Pythagoras",
        ("the_larger_coordinate",),
        """
import numpy as np


def largest_error(places, right):
    difference = np.abs(np.asarray(places) - np.asarray(right))
    return float(np.max(difference))
""",
    ),
    Wrong(
        "8.2",
        "The rule for a halved step is used, log2 of the ratio of errors, although the two "
        "steps may stand in any ratio",
        ("as_if_halved", "as_if_halved and absolute"),
        """
import math


def observed_order(dt_1, error_1, dt_2, error_2):
    if dt_1 > dt_2:
        return math.log2(error_1 / error_2)
    return math.log2(error_2 / error_1)
""",
    ),
    Wrong(
        "8.3",
        "The shift of the fitted line is returned as C, and not turned back from ln C with exp",
        ("logarithm_of_the_factor",),
        """
import numpy as np


def fit_power(steps, errors):
    x = np.log(steps)
    y = np.log(errors)
    p, C = np.polyfit(x, y, 1)
    return p, C
""",
    ),
    Wrong(
        "8.5",
        "argmin counts within the filtered table, so the number is that of the row among the "
        "good ones and not in the whole table",
        ("number_among_the_good",),
        """
import numpy as np


def cheapest(table, allowed):
    good = table[table[:, 1] <= allowed]
    if len(good) == 0:
        return None
    return int(np.argmin(good[:, 0]))
""",
    ),
    Wrong(
        "9.1",
        "The weights are added up from the floor, as if a box carried what lies below it "
        "instead of what stands on it",
        ("counted_from_the_floor",),
        """
import numpy as np


def tower_forces(masses, gravity):
    forces = []
    load = 0.0
    for m in masses:
        load += m * gravity
        forces.append(load)
    return np.array(forces)
""",
    ),
    Wrong(
        "9.2",
        "The number from the logarithms is cut off by int, so one sweep too few is counted",
        ("rounded_down",),
        """
import math


def sweeps_needed(light, heavy, left):
    per_sweep = -math.log1p(light / heavy)  # ln(M / (M + m))
    return int(math.log(left) / per_sweep)
""",
    ),
    Wrong(
        "9.3",
        "The friction impulse is always taken as -mu jn, whichever way the tip slides",
        ("always_to_the_left",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    # vn + knn*jn - friction*knt*jn = 0
    k = knn - friction * knt
    if k <= 0:
        return None
    return -vn / k
""",
    ),
    Wrong(
        "9.4",
        "The angular impulse is the product of the lengths of arm and impulse, without the "
        "angle between them and without a sense of rotation",
        ("torque_of_lengths",),
        """
import numpy as np


def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    before = 0.5 * mass * np.dot(velocity, velocity) + 0.5 * inertia * w**2
    v_new = velocity + impulse / mass
    L = np.linalg.norm(arm) * np.linalg.norm(impulse)
    w_new = w + L / inertia
    after = 0.5 * mass * np.dot(v_new, v_new) + 0.5 * inertia * w_new**2
    return after / before
""",
    ),
    Wrong(
        "10.1",
        "The condition leaves out every pair with a static body in it, not only pairs of two "
        'static bodies ("or" and "and" confused)',
        ("floors_forgotten",),
        """
import math
from itertools import combinations


def most_friction(inverse_masses, frictions):
    largest = 0.0
    for a, b in combinations(range(len(frictions)), 2):
        if inverse_masses[a] == 0 or inverse_masses[b] == 0:
            continue
        largest = max(largest, math.sqrt(frictions[a] * frictions[b]))
    return largest
""",
    ),
    Wrong(
        "10.3",
        "The fastest disc of the start is taken for the fastest ever; a light disc can get the "
        "energy of all the others",
        ("fastest_now",),
        """
import numpy as np


def fastest_way(masses, velocities, dt):
    speeds = np.linalg.norm(velocities, axis=1)
    return float(speeds.max() * dt)
""",
    ),
    Wrong(
        "10.4",
        "Only the two ends of the flight are looked at; the turning point of the parabola, "
        "which can lie outside, is forgotten",
        ("only_the_ends",),
        """
import numpy as np


def box_of_flight(position, velocity, radius, gravity, duration):
    start = np.asarray(position, dtype=float)
    end = start + velocity * duration + 0.5 * np.asarray(gravity) * duration**2
    left, low = np.minimum(start, end) - radius
    right, high = np.maximum(start, end) + radius
    return left, right, low, high
""",
    ),
    Wrong(
        "10.5",
        "The search walks through static bodies too, so all that stand on the same floor "
        "become one island",
        ("floors_join",),
        """
def bodies_asleep(inverse_masses, still, touches):
    n = len(inverse_masses)
    seen = set()
    asleep = []
    for start in range(n):
        if start in seen or inverse_masses[start] == 0:
            continue
        stack, island = [start], []
        seen.add(start)
        while stack:
            a = stack.pop()
            island.append(a)
            for b in range(n):
                if (touches[a, b] or touches[b, a]) and b not in seen:
                    seen.add(b)
                    stack.append(b)
        moving = [b for b in island if inverse_masses[b] != 0]
        if all(still[b] for b in moving):
            asleep += moving
    return asleep
""",
    ),
    Wrong(
        "11.2",
        "The sliding for the friction is measured before the normal impulse has acted, "
        "although that impulse turns the bodies and changes the sliding",
        ("sliding_before_the_blow",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, va, wa = a[0], a[1], np.array(a[2:4]), a[4]
    mb, ib, vb, wb = b[0], b[1], np.array(b[2:4]), b[4]
    tangent = np.array([-normal[1], normal[0]])

    def k(d):
        return 1 / ma + 1 / mb + cross(arm_a, d) ** 2 / ia + cross(arm_b, d) ** 2 / ib

    point_a = va + wa * np.array([-arm_a[1], arm_a[0]])
    point_b = vb + wb * np.array([-arm_b[1], arm_b[0]])
    relative = point_b - point_a
    vn, vt = relative @ normal, relative @ tangent
    if vn >= 0:
        return va, wa, vb, wb
    jn = -(1 + restitution) * vn / k(normal)
    jt = max(-friction * jn, min(friction * jn, -vt / k(tangent)))
    J = jn * normal + jt * tangent
    return (va - J / ma, wa - cross(arm_a, J) / ia, vb + J / mb, wb + cross(arm_b, J) / ib)
""",
    ),
    Wrong(
        "11.3",
        "The student lets gravity change the velocity first and moves the discs with the new "
        "velocity, as in the semi-implicit step of other programs",
        ("falls_before_it_moves",),
        """
import numpy as np


def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    x = np.array(positions, dtype=float)
    v = np.array(velocities, dtype=float)
    v += np.asarray(gravity) * dt
    x += v * dt
    n = len(x)
    for i in range(n):
        for j in range(i + 1, n):
            d = x[j] - x[i]
            dist = np.hypot(*d)
            depth = radii[i] + radii[j] - dist
            if depth <= 0:
                continue
            normal = d / dist if dist > 0 else np.array([1.0, 0.0])
            wi, wj = 1 / masses[i], 1 / masses[j]
            vn = (v[j] - v[i]) @ normal
            if vn < 0:
                jn = -(1 + restitution) * vn / (wi + wj)
                v[i] -= jn * wi * normal
                v[j] += jn * wj * normal
            x[i] -= depth * wi / (wi + wj) * normal
            x[j] += depth * wj / (wi + wj) * normal
    for i in range(n):
        for k in range(2):
            if x[i, k] < radii[i]:
                x[i, k] = radii[i]
                if v[i, k] < 0:
                    v[i, k] *= -restitution
            elif x[i, k] > room[k] - radii[i]:
                x[i, k] = room[k] - radii[i]
                if v[i, k] > 0:
                    v[i, k] *= -restitution
    return x, v
""",
    ),
    Wrong(
        "11.4",
        "Single bodies are remembered instead of pairs, so a new pair of two bodies that both "
        "touched something before is not seen as begun",
        ("numbers_in_place_of_pairs",),
        """
def touch_changes(before, now):
    bodies_before = set()
    for i, j in before:
        bodies_before.add(int(i))
        bodies_before.add(int(j))
    bodies_now = set()
    for i, j in now:
        bodies_now.add(int(i))
        bodies_now.add(int(j))

    begun = []
    for i, j in now:
        if int(i) not in bodies_before or int(j) not in bodies_before:
            begun.append((int(i), int(j)))
    parted = []
    for i, j in before:
        if int(i) not in bodies_now or int(j) not in bodies_now:
            parted.append((int(i), int(j)))
    return begun, parted
""",
    ),
    Wrong(
        "11.5",
        "The half-life is taken for the time constant of the exponential, so after one half- "
        "life 1/e is left instead of a half",
        ("e_in_place_of_two",),
        """
import numpy as np


def glow(brightness, hit, dt, half_life):
    faded = brightness * np.exp(-dt / half_life)
    return np.where(np.asarray(hit) == 1, 1.0, faded)
""",
    ),
    Wrong(
        "11.6",
        "linspace puts a sample on the end point as well, so the spacing is a little longer "
        "than 1 / rate",
        ("with_the_end_of_the_time",),
        """
import numpy as np


def knock(loudness, frequency, half_life, rate, count):
    if frequency >= rate / 2:
        return np.zeros(count)
    t = np.linspace(0.0, count / rate, count)
    return loudness * np.sin(2 * np.pi * frequency * t) * 0.5 ** (t / half_life)
""",
    ),
    Wrong(
        "A.2",
        "The muzzle speed is added to the ship's old velocity, so the shot is that fast seen "
        "from where the ship would have been and not from the recoiling ship",
        ("seen_from_before",),
        """
import numpy as np


def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    direction = np.array([np.cos(heading), np.sin(heading)])
    shot = velocity + muzzle_speed * direction
    # momentum: (M + m) v = M v_ship + m v_shot
    ship = ((ship_mass + shot_mass) * velocity - shot_mass * shot) / ship_mass
    return ship, shot
""",
    ),
    Wrong(
        "A.3",
        "All pairs are computed from the velocities at the start (the given array), so a later "
        "pair does not find what the earlier ones have left",
        ("all_from_the_old_velocities",),
        """
import numpy as np


def collide_all(positions, velocities, masses, radii, restitution):
    result = np.array(velocities, dtype=float)
    n = len(masses)
    for i in range(n):
        for j in range(i + 1, n):
            gap = positions[j] - positions[i]
            distance = np.linalg.norm(gap)
            if distance == 0 or distance >= radii[i] + radii[j]:
                continue
            normal = gap / distance
            approach = np.dot(velocities[j] - velocities[i], normal)
            if approach >= 0:
                continue
            impulse = -(1 + restitution) * approach / (1 / masses[i] + 1 / masses[j])
            result[i] = result[i] - impulse / masses[i] * normal
            result[j] = result[j] + impulse / masses[j] * normal
    return result
""",
    ),
    Wrong(
        "B.1",
        "One chain of elif tests the four walls, so in a corner only the first of the two "
        "walls is found",
        ("one_cushion_at_a_time",),
        """
import numpy as np

WIDTH, HEIGHT = 600.0, 400.0
RADIUS = 12.0
NORMALS = {
    "top": np.array([0.0, 1.0]),
    "bottom": np.array([0.0, -1.0]),
    "left": np.array([1.0, 0.0]),
    "right": np.array([-1.0, 0.0]),
}


def wall_contacts(position):
    x, y = position
    contacts = []
    if y < RADIUS:
        contacts.append(("top", NORMALS["top"], RADIUS - y))
    elif y > HEIGHT - RADIUS:
        contacts.append(("bottom", NORMALS["bottom"], y + RADIUS - HEIGHT))
    elif x < RADIUS:
        contacts.append(("left", NORMALS["left"], RADIUS - x))
    elif x > WIDTH - RADIUS:
        contacts.append(("right", NORMALS["right"], x + RADIUS - WIDTH))
    return contacts
""",
    ),
    Wrong(
        "B.2",
        "The foot of the perpendicular on the endless line is used; the student does not limit "
        "it to the segment, so the bumper has no round ends and goes on across the table",
        ("endless_line",),
        """
import numpy as np

RADIUS = 12.0
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0


def bumper_contact(position):
    axis = BUMPER_END - BUMPER_START
    axis = axis / np.linalg.norm(axis)
    along = np.dot(position - BUMPER_START, axis)
    foot = BUMPER_START + along * axis
    away = position - foot
    dist = np.linalg.norm(away)
    if dist == 0:
        return None
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth > 0:
        return away / dist, depth
    return None
""",
    ),
    Wrong(
        "B.4",
        "Every resolved contact is put on the list of hits, also one from which the ball was "
        "already moving away",
        ("counts_every_overlap",),
        """
import numpy as np

WIDTH, HEIGHT = 600.0, 400.0
RADIUS = 12.0
RESTITUTION = 0.95
TIME_STEP = 1 / 60
NORMALS = {
    "top": np.array([0.0, 1.0]),
    "bottom": np.array([0.0, -1.0]),
    "left": np.array([1.0, 0.0]),
    "right": np.array([-1.0, 0.0]),
}
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0


def wall_contacts(position):
    x, y = position
    depths = {"top": RADIUS - y, "bottom": y - HEIGHT + RADIUS,
              "left": RADIUS - x, "right": x - WIDTH + RADIUS}
    return [(name, NORMALS[name], d) for name, d in depths.items() if d > 0]


def bumper_contact(position):
    way = BUMPER_END - BUMPER_START
    part = np.clip(np.dot(position - BUMPER_START, way) / np.dot(way, way), 0, 1)
    away = position - (BUMPER_START + part * way)
    distance = np.linalg.norm(away)
    depth = RADIUS + BUMPER_HALF_THICKNESS - distance
    if depth <= 0:
        return None
    return away / distance, depth


def resolve(position, velocity, normal, depth):
    position = position + depth * normal
    vn = np.dot(velocity, normal)
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position, velocity


def step(position, velocity, dt=TIME_STEP):
    hits = []
    position = position + velocity * dt
    contact = bumper_contact(position)
    if contact is not None:
        position, velocity = resolve(position, velocity, *contact)
        hits.append("bumper")
    for name, normal, depth in wall_contacts(position):
        position, velocity = resolve(position, velocity, normal, depth)
        hits.append(name)
    return position, velocity, hits
""",
    ),
    Wrong(
        "K.1",
        "The sideways part of the velocity is made proportional to the offset instead of the "
        "angle; only the middle and the two ends come out right",
        ("sideways_by_the_offset",),
        """
import math

STEEPEST = math.radians(60)


def paddle_bounce(offset, speed):
    offset = max(-1.0, min(1.0, offset))
    vx = offset * speed * math.sin(STEEPEST)
    vy = math.sqrt(speed * speed - vx * vx)
    return (vx, vy)
""",
    ),
    Wrong(
        "K.2",
        "The brick grown by the radius is taken as a rectangle with sharp corners, so a ball "
        "that flies past a corner hits a corner that is not there",
        ("square_corners",),
        """
import math

import numpy as np

HORIZON = 1.0


def brick_impact(position, velocity, radius, box):
    lo = [box[0] - radius, box[1] - radius]
    hi = [box[0] + box[2] + radius, box[1] + box[3] + radius]
    t_in, t_out = -math.inf, math.inf
    axis = None
    for k in (0, 1):
        if velocity[k] == 0:
            if position[k] <= lo[k] or position[k] >= hi[k]:
                return None
            continue
        near, far = (lo[k], hi[k]) if velocity[k] > 0 else (hi[k], lo[k])
        ta = (near - position[k]) / velocity[k]
        tb = (far - position[k]) / velocity[k]
        if ta > t_in:
            t_in, axis = ta, k
        t_out = min(t_out, tb)
    if axis is None or t_in >= t_out or t_in < 0 or t_in > HORIZON:
        return None
    normal = np.zeros(2)
    normal[axis] = -np.sign(velocity[axis])
    return t_in, normal
""",
    ),
    Wrong(
        "C.1",
        "The row is gone through once from left to right; the student does not start again, so "
        "pairs that a later collision makes approach are forgotten",
        ("one_pass",),
        """
import numpy as np

SLOWEST = 1e-12


def collide_row(masses, velocities, restitution):
    v = [float(x) for x in velocities]
    for i in range(len(v) - 1):
        u = v[i] - v[i + 1]
        if u > SLOWEST:
            m, M = masses[i], masses[i + 1]
            j = (1 + restitution) * u * m * M / (m + M)
            v[i] -= j / m
            v[i + 1] += j / M
    return np.array(v)
""",
    ),
    Wrong(
        "C.2",
        "The angle is moved with the old rate (both lines in one tuple assignment), instead of "
        "the rate that has just changed",
        ("old_rate",),
        """
import math

GRAVITY = 9.81


def swing_step(angle, rate, length, dt):
    angle, rate = angle + rate * dt, rate - GRAVITY / length * math.sin(angle) * dt
    return angle, rate
""",
    ),
    Wrong(
        "D.1",
        "The angle of the diagonal above the floor is returned instead of its angle from the "
        "vertical: height and width have changed places",
        ("upside_down",),
        """
import math


def tipping_angle(width, height):
    # the diagonal must stand upright over the edge
    return math.atan(height / width)
""",
    ),
    Wrong(
        "D.3",
        "The first rate is overwritten with the mean before the second is computed, so the "
        "next domino gets a mean of the new rate and not the common one",
        ("mean_of_the_mean",),
        """
import math

import numpy as np

GRAVITY = 9.81


def chain(angles, rates, height, spacing, dt, steps):
    phi = np.array(angles, dtype=float)
    om = np.array(rates, dtype=float)
    limit = math.asin(spacing / height)
    for _ in range(int(steps)):
        om += 1.5 * GRAVITY / height * np.sin(phi) * dt
        phi += om * dt
        for i in range(len(phi) - 1):
            if phi[i] > limit and om[i] > om[i + 1]:
                om[i] = (om[i] + om[i + 1]) / 2
                om[i + 1] = (om[i] + om[i + 1]) / 2
        lying = phi > math.pi / 2
        phi[lying] = math.pi / 2
        om[lying] = 0.0
    return phi, om
""",
    ),
    Wrong(
        "P.1",
        "The rows stand a whole ball distance behind each other as on a square grid; the "
        "student forgets that the balls of the next row lie in the gaps, at sin 60 degrees of "
        "it",
        ("square_rows",),
        """
import numpy as np


def rack(apex, radius, gap):
    d = 2 * radius + gap
    balls = []
    for row in range(5):
        for k in range(row + 1):
            x = apex[0] + row * d
            y = apex[1] + (k - row / 2) * d
            balls.append([x, y])
    return np.array(balls)
""",
    ),
    Wrong(
        "P.3",
        "Each impulse changes the velocities at once, so the next pair of the same round sees "
        "changed velocities and the order of the pairs matters",
        ("changed_within_the_round",),
        """
import numpy as np

TOUCHING = 2.001
ROUNDS = 20


def share_impact(positions, velocities, radius, restitution):
    v = np.array(velocities, dtype=float)
    n = len(v)
    for _ in range(ROUNDS):
        pairs = []
        count = np.zeros(n, dtype=int)
        for i in range(n):
            for j in range(i + 1, n):
                d = positions[j] - positions[i]
                dist = np.linalg.norm(d)
                if dist <= TOUCHING * radius and np.dot(v[j] - v[i], d / dist) < 0:
                    pairs.append((i, j, d / dist))
                    count[i] += 1
                    count[j] += 1
        for i, j, normal in pairs:
            u = np.dot(v[j] - v[i], normal)
            half = -(1 + restitution) * u / 2 / max(count[i], count[j])
            v[i] -= half * normal
            v[j] += half * normal
    return v
""",
    ),
    Wrong(
        "S.2",
        "The loop stops at the last but one mass: the spring from the last mass to the first "
        "is missing, so the ring is an open chain",
        ("springs_left_open",),
        """
import numpy as np


def ring_forces(positions, velocities, length, stiffness, damping):
    F = np.zeros_like(positions, dtype=float)
    for i in range(len(positions) - 1):
        d = positions[i + 1] - positions[i]
        dist = np.sqrt(d[0] ** 2 + d[1] ** 2)
        u = d / dist
        f = stiffness * (dist - length) + damping * np.dot(velocities[i + 1] - velocities[i], u)
        F[i] += f * u
        F[i + 1] -= f * u
    return F
""",
    ),
    Wrong(
        "S.3",
        "The gas pushes every mass straight away from the middle of the ring instead of each "
        "edge at right angles; this is the same only for regular rings",
        ("away_from_the_middle",),
        """
import numpy as np


def pressure_forces(positions, area, stiffness):
    x, y = positions[:, 0], positions[:, 1]
    now = 0.5 * np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))
    p = stiffness * (area / now - 1)
    nxt = np.roll(positions, -1, axis=0)
    prev = np.roll(positions, 1, axis=0)
    lengths = np.linalg.norm(nxt - positions, axis=1)
    lengths_before = np.linalg.norm(positions - prev, axis=1)
    out = positions - positions.mean(axis=0)
    out = out / np.linalg.norm(out, axis=1)[:, None]
    return p * ((lengths + lengths_before) / 2)[:, None] * out
""",
    ),
)
