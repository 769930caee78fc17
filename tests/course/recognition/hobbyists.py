"""Wrong answers of people who teach themselves, written from the texts of the tasks alone.

When they were first tried, 37 of 60 were recognised, none falsely; one earned full marks for some
inputs, and the draws of P.3 were mended.
"""

from __future__ import annotations

from course.recognition.students import Wrong

FIFTH = (
    Wrong(
        "1.1",
        "v1 is overwritten with the new velocity before v2 is computed, so the second formula "
        "uses the velocity after the hit instead of the one before",
        ("uses_updated_v1",),
        """
def elastic_1d(m1, v1, m2, v2):
    M = m1 + m2
    v1 = ((m1 - m2) * v1 + 2 * m2 * v2) / M
    v2 = ((m2 - m1) * v2 + 2 * m1 * v1) / M
    return v1, v2
""",
    ),
    Wrong(
        "1.2",
        "The student believes that kinetic energy is conserved even when the bodies stick "
        "together, and solves the energy equation for the common velocity",
        ("keeps_energy",),
        """
from math import sqrt


def inelastic_1d(m1, v1, m2, v2):
    # energy before = energy after
    energy = 0.5 * m1 * v1**2 + 0.5 * m2 * v2**2
    v = sqrt(2 * energy / (m1 + m2))
    # it goes where the bigger momentum goes
    if m1 * v1 + m2 * v2 < 0:
        v = -v
    return (v, v)
""",
    ),
    Wrong(
        "1.3",
        "The student thinks that two bodies swap their momenta in an elastic collision (it is "
        "the velocities that are swapped, and only for equal masses)",
        ("momenta_exchanged",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    momentum_of_1 = m1 * v1
    momentum_of_2 = m2 * v2
    # elastic: each one takes over the momentum of the other
    new_momentum_of_2 = momentum_of_1
    return new_momentum_of_2 - momentum_of_2
""",
    ),
    Wrong(
        "2.2",
        "The student takes e for the part of the kinetic energy that is kept in the centre-of- "
        "mass frame, so the velocities there are scaled with sqrt(e) instead of e",
        ("energy_restitution",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    # go into the frame of the centre of mass
    v_cm = (m1 * v1 + m2 * v2) / (m1 + m2)
    u1 = v1 - v_cm
    u2 = v2 - v_cm
    # after the hit the kinetic energy there is e times what it was
    factor = restitution ** 0.5
    u1 = -factor * u1
    u2 = -factor * u2
    # and back
    return u1 + v_cm, u2 + v_cm
""",
    ),
    Wrong(
        "2.3",
        "the list starts with the height of the drop, which counts as the first bounce, so "
        "every height stands one place too late",
        ("starts_with_the_drop",),
        """
def bounce_heights(height, restitution, count):
    heights = []
    h = height
    for i in range(count):
        heights.append(h)
        h = h * restitution * restitution
    return heights
""",
    ),
    Wrong(
        "2.4",
        "The student forgets that a bounce goes up and comes down again, and counts for every "
        "bounce only one of the two ways",
        ("forgets_the_way_up",),
        """
import math


def rest_time(height, restitution, gravity):
    t0 = math.sqrt(2 * height / gravity)  # the first fall
    # each next one takes e times as long: t0 + e t0 + e^2 t0 + ...
    return t0 / (1 - restitution)
""",
    ),
    Wrong(
        "3.1",
        "The student knows only horizontal and vertical walls from Pong, and turns round vx or "
        "vy depending on which part of the normal is larger; slanted walls come out wrong",
        ("flips_an_axis",),
        """
import numpy as np


def reflect(incident, normal):
    vx, vy = incident
    nx, ny = normal
    if abs(nx) > abs(ny):
        vx = -vx      # side wall
    else:
        vy = -vy      # floor or ceiling
    return np.array([vx, vy])
""",
    ),
    Wrong(
        "3.2",
        "The student thinks that restitution is what the wall takes by rubbing along it: the "
        "part along the wall is multiplied by e and the part across is turned round in full",
        ("parts",),
        """
import numpy as np


def bounce(velocity, normal, restitution):
    vn = np.dot(velocity, normal)
    if vn >= 0:
        return velocity.copy()
    across = vn * normal
    along = velocity - across
    return restitution * along - across
""",
    ),
    Wrong(
        "3.3",
        "a ball that is already on its way out is returned before the position has been "
        "corrected, so it stays inside the wall",
        ("gate_before_position",),
        """
import numpy as np


def resolve_wall(position, velocity, normal, depth, restitution):
    speed_in = -(velocity[0] * normal[0] + velocity[1] * normal[1])
    if speed_in <= 0:
        # nothing to do, it leaves
        return position, velocity
    new_position = position + depth * normal
    new_velocity = velocity + (1 + restitution) * speed_in * normal
    return new_position, new_velocity
""",
    ),
    Wrong(
        "4.1",
        "The student subtracts the squares of the distances and takes the root of that for the "
        "depth: sqrt(R^2 - d^2) instead of R - d",
        ("root_of_the_squares",),
        """
import math

import numpy as np


def circle_contact(p1, r1, p2, r2):
    dx = p2[0] - p1[0]
    dy = p2[1] - p1[1]
    missing = (r1 + r2) ** 2 - (dx * dx + dy * dy)
    if missing <= 0:
        return None
    d = math.hypot(dx, dy)
    n = np.array([dx / d, dy / d]) if d > 0 else np.array([1.0, 0.0])
    return n, math.sqrt(missing)
""",
    ),
    Wrong(
        "4.2",
        "The student uses the one-dimensional formula on the whole velocity vectors, so the "
        "circles also push each other sideways; the normal only decides whether they hit",
        ("one_dimension_on_each_axis",),
        """
import numpy as np


def resolve_circles(v1, m1, v2, m2, normal, restitution):
    v1 = np.asarray(v1, dtype=float)
    v2 = np.asarray(v2, dtype=float)
    if (v2 - v1) @ normal >= 0:
        return v1, v2
    p = m1 * v1 + m2 * v2
    total = m1 + m2
    new1 = (p + m2 * restitution * (v2 - v1)) / total
    new2 = (p + m1 * restitution * (v1 - v2)) / total
    return new1, new2
""",
    ),
    Wrong(
        "4.3",
        "The student multiplies the depth with the inverse masses but forgets to divide by "
        "their sum, so the two ways do not add up to the depth",
        ("depth_over_mass",),
        """
import math


def separate(p1, m1, p2, m2, normal, depth):
    w1 = 1 / m1   # 0 for the fixed one
    w2 = 1 / m2
    a = p1 - normal * depth * w1
    b = p2 + normal * depth * w2
    return a, b
""",
    ),
    Wrong(
        "4.4",
        "the normal is turned round to push circle 1 back and is not turned back again, so "
        "circle 2 is pushed the same way and the approach test has the wrong sign",
        ("turned_and_not_turned_back",),
        """
import math

import numpy as np


def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    inv1 = 0.0 if m1 == math.inf else 1.0 / m1
    inv2 = 0.0 if m2 == math.inf else 1.0 / m2
    inv = inv1 + inv2

    # circle 1 goes backwards
    normal = -normal
    p1 = p1 + normal * depth * inv1 / inv
    p2 = p2 + normal * depth * inv2 / inv

    closing = np.dot(v2 - v1, normal)
    if closing < 0:
        j = -(1 + restitution) * closing / inv
        v1 = v1 - j * inv1 * normal
        v2 = v2 + j * inv2 * normal
    return p1, v1, p2, v2
""",
    ),
    Wrong(
        "5.1",
        "The student thinks of the mass as sitting in the corners, and adds m/N times the "
        "squared distance of each corner from their mean",
        ("vertex_masses",),
        """
import numpy as np


def moment_of_inertia(mass, vertices):
    vertices = np.asarray(vertices, dtype=float)
    n = len(vertices)
    centre = vertices.sum(axis=0) / n
    total = 0.0
    for x, y in vertices - centre:
        total += mass / n * (x * x + y * y)
    return total
""",
    ),
    Wrong(
        "5.3",
        "The student remembers r^2 / I, which holds only if the direction is at right angles "
        "to the lever, and uses the whole length of the lever in place of its cross product "
        "with the direction",
        ("full_distance",),
        """
import numpy as np


def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    linear = 1 / m_a + 1 / m_b
    angular = np.dot(r_a, r_a) / i_a + np.dot(r_b, r_b) / i_b
    return linear + angular
""",
    ),
    Wrong(
        "5.4",
        "the limit is applied with min alone, so an impulse in the negative direction is never "
        "limited",
        ("clamped_on_one_side",),
        """
def friction_impulse(vt, jn, friction, k):
    jt = -vt / k            # this would stop it
    biggest = friction * jn
    jt = min(jt, biggest)
    return jt
""",
    ),
    Wrong(
        "5.5",
        "The student takes the lever from the centre to the contact along the normal, although "
        "the normal points from the wall to the disc, so that the contact is put on the far "
        "side of the disc",
        ("sign",),
        """
import numpy as np


def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    v = np.array(velocity, dtype=float)
    n = np.array(normal, dtype=float)
    vn = v @ n
    if vn >= 0:
        return v, w
    t = np.array([-n[1], n[0]])
    I = radius**2 / 2
    r = radius * n
    rxt = r[0] * t[1] - r[1] * t[0]

    jn = -(1 + restitution) * vn
    slip = v @ t + w * rxt
    k = 1 + rxt**2 / I
    jt = -slip / k
    jt = max(-friction * jn, min(friction * jn, jt))

    return v + jn * n + jt * t, w + rxt * jt / I
""",
    ),
    Wrong(
        "6.3",
        "The student returns the length that the two shadows share, which has no direction and "
        "is too short when one shadow lies inside the other",
        ("common_part",),
        """
def overlap(interval_a, interval_b):
    left = max(interval_a[0], interval_b[0])
    right = min(interval_a[1], interval_b[1])
    if right - left > 0:
        return right - left
    return None
""",
    ),
    Wrong(
        "6.4",
        "the shifts have signs, and the smallest is looked for without abs, so the most "
        "negative shift wins instead of the shortest",
        ("most_negative_shift",),
        """
import numpy as np


def _axes(poly):
    out = []
    for i in range(len(poly)):
        e = poly[(i + 1) % len(poly)] - poly[i]
        length = np.hypot(e[0], e[1])
        if length > 0:
            out.append(np.array([e[1], -e[0]]) / length)
    return out


def mtv(vertices_a, vertices_b):
    best = None
    best_axis = None
    for axis in _axes(vertices_a) + _axes(vertices_b):
        a = vertices_a @ axis
        b = vertices_b @ axis
        right = a.max() - b.min()     # B goes this far in the direction of the axis
        left = b.max() - a.min()      # ... or this far against it
        if right <= 0 or left <= 0:
            return None
        shift = right if right < left else -left
        if best is None or shift < best:
            best = shift
            best_axis = axis
    if best < 0:
        return -best_axis, -best
    return best_axis, best
""",
    ),
    Wrong(
        "6.5",
        "the student always puts the cut in place of the end of the segment, even when it is "
        "the start that lies on the outer side",
        ("cuts_the_end_always",),
        """
import numpy as np


def clip(start, end, normal, offset):
    ds = np.dot(start, normal) - offset
    de = np.dot(end, normal) - offset
    if ds > 0 and de > 0:
        return None
    if ds <= 0 and de <= 0:
        return start, end
    # it crosses the line: shorten it
    t = ds / (ds - de)
    cut = start + t * (end - start)
    return start, cut
""",
    ),
    Wrong(
        "6.6",
        "The student tests the circle against the lines of the edges only, and forgets that "
        "beyond the end of an edge the corner is the closest point",
        ("edges_without_ends",),
        """
import numpy as np


def circle_against_polygon(centre, radius, vertices):
    best_gap = -np.inf
    best_normal = None
    for k in range(len(vertices)):
        a = vertices[k]
        b = vertices[(k + 1) % len(vertices)]
        edge = b - a
        size = np.linalg.norm(edge)
        if size == 0:
            continue
        n = np.array([edge[1], -edge[0]]) / size    # outwards
        gap = np.dot(centre - a, n)
        if gap >= radius:
            return None
        if gap > best_gap:
            best_gap = gap
            best_normal = n
    return best_normal, radius - best_gap
""",
    ),
    Wrong(
        "7.1",
        "The student takes the time at which the centres are closest to each other for the "
        "time of the first touch",
        ("nearest_approach_if_near_enough",),
        """
import numpy as np


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d = p2 - p1
    v = v2 - v1
    reach = r1 + r2
    approach = d @ v
    if approach >= 0:
        return None                 # they part, or nothing changes
    if d @ d <= reach**2:
        return 0.0
    t = -approach / (v @ v)
    nearest = d + t * v
    if nearest @ nearest > reach**2:
        return None
    return float(t) if t <= dt else None
""",
    ),
    Wrong(
        "7.2",
        "The student adds the time of the rise to the time of a fall from the height at the "
        "start, and forgets that the ball falls from the top of its flight, which is higher",
        ("falls_from_the_start",),
        """
import math


def time_to_floor(height, velocity, gravity):
    if velocity <= 0:
        if height == 0 and velocity < 0:
            return 0.0
        if gravity == 0:
            return height / -velocity if velocity < 0 else None
        # this form does not lose digits
        return 2 * height / (-velocity + math.sqrt(velocity**2 + 2 * gravity * height))
    if gravity == 0:
        return None
    up = velocity / gravity
    down = math.sqrt(2 * height / gravity)
    return up + down
""",
    ),
    Wrong(
        "7.3",
        "The student mirrors the overshoot behind the wall at full length: the ball goes on "
        "for the rest of the step as if it had lost no speed in the impact",
        ("mirrors_the_rest",),
        """
import numpy as np


def advance(p, v, room, restitution, dt):
    new_p = np.array(p, dtype=float)
    new_v = np.array(v, dtype=float)
    for axis in (0, 1):
        x = p[axis] + v[axis] * dt
        u = v[axis]
        while x < 0 or x > room[axis]:
            if x < 0:
                x = -x
            else:
                x = 2 * room[axis] - x
            u = -u * restitution
        new_p[axis] = x
        new_v[axis] = u
    return new_p, new_v
""",
    ),
    Wrong(
        "7.4",
        '"if t" is used in place of "if t is not None", so a pair that meets now, at 0.0, is '
        "taken for one that never meets",
        ("now_is_no_time",),
        """
import math

import numpy as np


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d = p2 - p1
    v = v2 - v1
    R = r1 + r2
    b = np.dot(d, v)
    if b >= 0:
        return None
    c = np.dot(d, d) - R * R
    if c <= 0:
        return 0.0
    a = np.dot(v, v)
    disc = b * b - a * c
    if disc < 0:
        return None
    t = c / (-b + math.sqrt(disc))
    return t if t <= dt else None


def next_event(positions, velocities, radii):
    first = None
    n = len(radii)
    for i in range(n):
        for j in range(i + 1, n):
            t = sweep_circles(positions[i], velocities[i], radii[i],
                              positions[j], velocities[j], radii[j], math.inf)
            if t:
                if first is None or t < first[0]:
                    first = (t, i, j)
    return first
""",
    ),
    Wrong(
        "7.5",
        "The student thinks that everything is over as soon as the outer block goes away from "
        "the wall, although the inner one may still be faster and catch up with it",
        ("until_the_heavy_block_turns",),
        """
def pi_collisions(mass_ratio):
    M, m = float(mass_ratio), 1.0
    V, v = -1.0, 0.0           # towards the wall is negative
    hits = 0
    while V < 0:
        # the blocks
        V, v = ((M - m) * V + 2 * m * v) / (M + m), ((m - M) * v + 2 * M * V) / (M + m)
        hits += 1
        # the wall
        if v < 0:
            v = -v
            hits += 1
    return hits
""",
    ),
    Wrong(
        "8.2",
        "The student remembers the formula for a step that was halved, log2 of the ratio of "
        "the errors, and uses it for any two steps",
        ("as_if_halved",),
        """
import math


def observed_order(dt_1, error_1, dt_2, error_2):
    ratio = error_1 / error_2
    return math.log2(ratio)
""",
    ),
    Wrong(
        "8.3",
        "the line is fitted to logarithms of base 10, but the shift is turned back into C with exp",
        ("two_kinds_of_logarithm",),
        """
import numpy as np


def fit_power(steps, errors):
    p, shift = np.polyfit(np.log10(steps), np.log10(errors), 1)
    return float(p), float(np.exp(shift))
""",
    ),
    Wrong(
        "8.5",
        "The student thinks that less accuracy always costs less time, and takes the row with "
        "the largest error that is still allowed, without looking at the milliseconds",
        ("the_least_accurate",),
        """
def cheapest(table, allowed):
    best = None
    best_error = -1.0
    for number, (ms, error) in enumerate(table):
        if error <= allowed and error > best_error:
            best_error = error
            best = number
    return best
""",
    ),
    Wrong(
        "9.2",
        "The student thinks that each sweep takes away the same amount, m/(M + m) of the first "
        "approach, so that what is left falls in a straight line and not by a factor",
        ("same_amount_each_time",),
        """
import math


def sweeps_needed(light, heavy, left):
    taken_per_sweep = light / (light + heavy)
    to_take = 1 - left
    return math.ceil(to_take / taken_per_sweep)
""",
    ),
    Wrong(
        "9.3",
        "the friction is always put in as -mu jn, as for a tip that slides in the positive "
        "direction; the sign of vt is never used",
        ("always_to_the_left",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    # jt = -mu jn  ->  vn + (knn - mu knt) jn = 0
    effective = knn - friction * knt
    if effective <= 0:
        return None
    return -vn / effective
""",
    ),
    Wrong(
        "9.4",
        "The student computes the change of spin as length of the arm times size of the "
        "impulse over the inertia, whatever the angle between the two and whichever way it "
        "turns",
        ("torque_of_lengths",),
        """
import numpy as np


def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    def kinetic(v, spin):
        return 0.5 * mass * np.dot(v, v) + 0.5 * inertia * spin**2

    before = kinetic(velocity, w)
    v_after = velocity + impulse / mass
    w_after = w + np.linalg.norm(arm) * np.linalg.norm(impulse) / inertia
    return kinetic(v_after, w_after) / before
""",
    ),
    Wrong(
        "9.5",
        "The student thinks that a strike runs through the row from the left, and always takes "
        "the leftmost pair that approaches instead of the fastest one",
        ("leftmost_first",),
        """
import numpy as np


def one_by_one(masses, velocities):
    v = [float(x) for x in velocities]
    m = list(masses)
    k = 0
    while k < len(v) - 1:
        if v[k] - v[k + 1] > 1e-9:
            c = (m[k] * v[k] + m[k + 1] * v[k + 1]) / (m[k] + m[k + 1])
            v[k] = 2 * c - v[k]
            v[k + 1] = 2 * c - v[k + 1]
            k = 0               # start again from the left
        else:
            k += 1
    return np.array(v)
""",
    ),
    Wrong(
        "10.1",
        "a pair is left out if the product of the inverse masses is 0, that is, if either body "
        "is static, although only pairs of two static bodies never meet",
        ("floors_forgotten",),
        """
import math
from itertools import combinations


def most_friction(inverse_masses, frictions):
    most = 0.0
    for a, b in combinations(range(len(frictions)), 2):
        if inverse_masses[a] * inverse_masses[b] == 0:
            continue
        most = max(most, math.sqrt(frictions[a] * frictions[b]))
    return most
""",
    ),
    Wrong(
        "10.2",
        "The student thinks that only bodies with corners can turn, and forgets that a disc "
        "turns if it is rubbed or spins at the start",
        ("only_corners_turn",),
        """
import math
from itertools import combinations

import numpy as np


def effects_called_for(bodies, gravity):
    names = []
    pairs = [(a, b) for a, b in combinations(bodies, 2) if a[0] > 0 or b[0] > 0]
    movable = [b for b in bodies if b[0] > 0]

    if any(math.sqrt(a[3] * b[3]) > 0 for a, b in pairs):
        names.append("friction")
    if any(min(a[2], b[2]) > 0 for a, b in pairs):
        names.append("restitution")
    if movable and np.any(np.asarray(gravity) != 0):
        names.append("gravity")
    # discs look the same however they are turned
    if any(b[1] > 0 for b in movable):
        names.append("rotation")
    return names
""",
    ),
    Wrong(
        "10.3",
        "The student bounds the speed with momentum instead of energy: in the worst case the "
        "lightest disc gets the sum of all m v; but with walls momentum is no limit of that "
        "kind",
        ("all_the_momentum",),
        """
import numpy as np


def fastest_way(masses, velocities, dt):
    speeds = np.sqrt((np.asarray(velocities) ** 2).sum(axis=1))
    all_momentum = np.sum(masses * speeds)
    fastest = all_momentum / np.min(masses)
    return fastest * dt
""",
    ),
    Wrong(
        "10.4",
        "the turning point of the flight is looked for in y only, as if gravity always pulled "
        "straight down, though it is a vector with a part along x",
        ("turns_back_in_y_only",),
        """
def box_of_flight(position, velocity, radius, gravity, duration):
    x0, y0 = position
    vx, vy = velocity
    gx, gy = gravity
    T = duration

    x1 = x0 + vx * T + gx * T * T / 2
    y1 = y0 + vy * T + gy * T * T / 2

    left, right = min(x0, x1), max(x0, x1)
    low, high = min(y0, y1), max(y0, y1)

    # the top of the parabola
    if gy != 0:
        t_top = -vy / gy
        if 0 < t_top < T:
            y_top = y0 + vy * t_top + gy * t_top * t_top / 2
            low = min(low, y_top)
            high = max(high, y_top)

    return left - radius, right + radius, low - radius, high + radius
""",
    ),
    Wrong(
        "11.1",
        "the boxes are sorted by their left sides for a sweep, and the pairs are returned in "
        "the sorted order, so that often i > j",
        ("pairs_as_they_were_sorted",),
        """
import numpy as np


def near_pairs(boxes):
    order = sorted(range(len(boxes)), key=lambda n: boxes[n][0])
    pairs = []
    for place, i in enumerate(order):
        for j in order[place + 1:]:
            if boxes[j][0] > boxes[i][1]:
                break                       # all others begin even later
            if boxes[j][2] <= boxes[i][3] and boxes[i][2] <= boxes[j][3]:
                pairs.append((i, j))
    return pairs
""",
    ),
    Wrong(
        "11.2",
        "The student computes normal impulse and friction both from the velocities before the "
        "hit, and does not see that the normal impulse changes the sliding when the arms are "
        "slanted",
        ("sliding_before_the_blow",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, va, wa = a[0], a[1], np.array(a[2:4]), a[4]
    mb, ib, vb, wb = b[0], b[1], np.array(b[2:4]), b[4]
    tangent = np.array([-normal[1], normal[0]])

    def perp(r):
        return np.array([-r[1], r[0]])

    def k(d):
        return 1 / ma + 1 / mb + cross(arm_a, d) ** 2 / ia + cross(arm_b, d) ** 2 / ib

    rel = (vb + wb * perp(arm_b)) - (va + wa * perp(arm_a))
    vn = rel @ normal
    if vn >= 0:
        return va, wa, vb, wb

    jn = -(1 + restitution) * vn / k(normal)
    jt = np.clip(-(rel @ tangent) / k(tangent), -friction * jn, friction * jn)
    J = jn * normal + jt * tangent

    return (va - J / ma, wa - cross(arm_a, J) / ia,
            vb + J / mb, wb + cross(arm_b, J) / ib)
""",
    ),
    Wrong(
        "11.3",
        "gravity changes the velocities first, and the discs then move with the new velocities "
        "instead of those they had",
        ("falls_before_it_moves",),
        """
from itertools import combinations

import numpy as np


def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    x = np.array(positions, dtype=float)
    v = np.array(velocities, dtype=float)
    count = len(x)

    v += np.asarray(gravity) * dt
    x += v * dt

    for i, j in combinations(range(count), 2):
        way = x[j] - x[i]
        dist = np.linalg.norm(way)
        depth = radii[i] + radii[j] - dist
        if depth <= 0:
            continue
        n = way / dist if dist > 0 else np.array([1.0, 0.0])
        wi, wj = 1 / masses[i], 1 / masses[j]
        vn = np.dot(v[j] - v[i], n)
        if vn < 0:
            imp = -(1 + restitution) * vn / (wi + wj)
            v[i] -= imp * wi * n
            v[j] += imp * wj * n
        x[i] -= depth * wi / (wi + wj) * n
        x[j] += depth * wj / (wi + wj) * n

    for i in range(count):
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
        "np.isin compares single numbers and not pairs, so a pair counts as known if each of "
        "its bodies was in any pair of the other table",
        ("numbers_in_place_of_pairs",),
        """
import numpy as np


def touch_changes(before, now):
    before = np.asarray(before).reshape(-1, 2)
    now = np.asarray(now).reshape(-1, 2)
    is_old = np.isin(now, before).all(axis=1)
    is_still = np.isin(before, now).all(axis=1)
    begun = [(int(i), int(j)) for i, j in now[~is_old]]
    parted = [(int(i), int(j)) for i, j in before[~is_still]]
    return begun, parted
""",
    ),
    Wrong(
        "11.5",
        "The student takes the half-life for the time constant of exp(-t/T), after which 1/e "
        "of the light is left and not one half",
        ("e_in_place_of_two",),
        """
import numpy as np


def glow(brightness, hit, dt, half_life):
    faded = brightness * np.exp(-dt / half_life)
    return np.where(hit == 1, 1.0, faded)
""",
    ),
    Wrong(
        "11.6",
        "linspace with its end included makes the samples a little too far apart, count of "
        "them over the whole duration instead of one each 1/rate",
        ("with_the_end_of_the_time",),
        """
import numpy as np


def knock(loudness, frequency, half_life, rate, count):
    count = int(count)
    if frequency >= rate / 2:
        return np.zeros(count)
    t = np.linspace(0, count / rate, count)
    envelope = loudness * 0.5 ** (t / half_life)
    return envelope * np.sin(2 * np.pi * frequency * t)
""",
    ),
    Wrong(
        "A.1",
        "the surplus is the plain mean of the pieces' velocities, without their masses as "
        "weights, which takes nothing away and leaves the momentum changed",
        ("nothing_taken_back",),
        """
import numpy as np


def split(velocity, masses, speed, heading):
    n = len(masses)
    angles = heading + 2 * np.pi * np.arange(n) / n
    pieces = speed * np.column_stack((np.cos(angles), np.sin(angles)))
    surplus = pieces.mean(axis=0)
    return velocity + pieces - surplus
""",
    ),
    Wrong(
        "A.2",
        "The student takes the muzzle speed as seen from the ship before the shot, and forgets "
        "that the ship itself recoils while the shot leaves",
        ("seen_from_before",),
        """
import numpy as np


def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    direction = np.array([np.cos(heading), np.sin(heading)])
    shot = velocity + muzzle_speed * direction
    # momentum: what the shot gains, the ship loses
    ship = velocity - shot_mass / ship_mass * muzzle_speed * direction
    return ship, shot
""",
    ),
    Wrong(
        "A.3",
        "each pair is computed from the velocities at the beginning, not from those that the "
        "pairs before it have left, and a second hit overwrites the first",
        ("from_the_velocities_before",),
        """
import numpy as np


def collide_all(positions, velocities, masses, radii, restitution):
    result = velocities.copy()
    n = len(masses)
    for i in range(n):
        for j in range(i + 1, n):
            d = positions[j] - positions[i]
            dist = np.hypot(*d)
            if dist == 0 or dist >= radii[i] + radii[j]:
                continue
            normal = d / dist
            closing = np.dot(velocities[i] - velocities[j], normal)
            if closing <= 0:
                continue
            mu = masses[i] * masses[j] / (masses[i] + masses[j])
            J = (1 + restitution) * mu * closing * normal
            result[i] = velocities[i] - J / masses[i]
            result[j] = velocities[j] + J / masses[j]
    return result
""",
    ),
    Wrong(
        "B.2",
        "the place on the segment is kept from falling below 0 but not from rising above 1, so "
        "the bumper goes on for ever beyond its lower end",
        ("goes_on_beyond_one_end",),
        """
import numpy as np

RADIUS = 12.0
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0


def bumper_contact(position):
    seg = BUMPER_END - BUMPER_START
    t = np.dot(position - BUMPER_START, seg) / np.dot(seg, seg)
    if t < 0:
        t = 0
    closest = BUMPER_START + t * seg
    away = position - closest
    dist = np.sqrt(away[0] ** 2 + away[1] ** 2)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return away / dist, depth
""",
    ),
    Wrong(
        "B.4",
        "the contacts are looked for and resolved where the ball is at the beginning, and only "
        "then is it moved, so that it ends the step inside the wall",
        ("looks_before_it_moves",),
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
    depths = {"top": RADIUS - y, "bottom": y + RADIUS - HEIGHT,
              "left": RADIUS - x, "right": x + RADIUS - WIDTH}
    return [(name, NORMALS[name], d) for name, d in depths.items() if d > 0]


def bumper_contact(position):
    seg = BUMPER_END - BUMPER_START
    t = np.clip(np.dot(position - BUMPER_START, seg) / np.dot(seg, seg), 0, 1)
    away = position - (BUMPER_START + t * seg)
    dist = np.hypot(away[0], away[1])
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    return (away / dist, depth) if depth > 0 else None


def resolve(position, velocity, normal, depth):
    position = position + depth * normal
    vn = np.dot(velocity, normal)
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position, velocity


def step(position, velocity, dt=TIME_STEP):
    hits = []
    bumper = bumper_contact(position)
    if bumper is not None:
        normal, depth = bumper
        if np.dot(velocity, normal) < 0:
            hits.append("bumper")
        position, velocity = resolve(position, velocity, normal, depth)
    for name, normal, depth in wall_contacts(position):
        if np.dot(velocity, normal) < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    position = position + velocity * dt
    return position, velocity, hits
""",
    ),
    Wrong(
        "B.5",
        "The student does not see what the fixed step is for: the rest of the time is used up "
        "at once with one shorter step, and nothing is left over",
        ("uses_up_the_rest",),
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
    found = []
    for name, depth in (("top", RADIUS - position[1]),
                        ("bottom", position[1] - (HEIGHT - RADIUS)),
                        ("left", RADIUS - position[0]),
                        ("right", position[0] - (WIDTH - RADIUS))):
        if depth > 0:
            found.append((name, NORMALS[name], depth))
    return found


def bumper_contact(position):
    way = BUMPER_END - BUMPER_START
    part = np.dot(position - BUMPER_START, way) / np.dot(way, way)
    part = min(max(part, 0.0), 1.0)
    d = position - BUMPER_START - part * way
    dist = np.linalg.norm(d)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return d / dist, depth


def resolve(position, velocity, normal, depth):
    new_position = position + depth * normal
    vn = np.dot(velocity, normal)
    new_velocity = velocity.copy()
    if vn < 0:
        new_velocity = velocity - (1 + RESTITUTION) * vn * normal
    return new_position, new_velocity


def step(position, velocity, dt=TIME_STEP):
    position = position + velocity * dt
    hits = []
    contact = bumper_contact(position)
    if contact:
        if velocity @ contact[0] < 0:
            hits.append("bumper")
        position, velocity = resolve(position, velocity, *contact)
    for name, normal, depth in wall_contacts(position):
        if velocity @ normal < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    return position, velocity, hits


def advance(position, velocity, elapsed):
    all_hits = []
    whole = int(elapsed / TIME_STEP + 1e-9)
    for _ in range(whole):
        position, velocity, hits = step(position, velocity)
        all_hits += hits
    rest = elapsed - whole * TIME_STEP
    if rest > 1e-9 * TIME_STEP:
        # do not lose the last bit of time
        position, velocity, hits = step(position, velocity, rest)
        all_hits += hits
    return position, velocity, all_hits, 0.0
""",
    ),
    Wrong(
        "K.1",
        "The student makes the sideways part of the velocity proportional to the offset "
        "instead of the angle, and fills up the other part so that the speed stays",
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
        "K.3",
        "a broken brick is deleted from the list, and the places noted for later bricks are "
        "those in the list that has become shorter",
        ("places_among_those_left",),
        """
import math

import numpy as np

HORIZON = 1.0


def brick_impact(position, velocity, radius, box):
    x, y, w, h = box
    found = []
    low = np.array([x, y])
    high = np.array([x + w, y + h])
    for axis in (0, 1):
        other = 1 - axis
        if velocity[axis] == 0:
            continue
        if velocity[axis] > 0:
            face, sign = low[axis] - radius, -1.0
        else:
            face, sign = high[axis] + radius, 1.0
        t = (face - position[axis]) / velocity[axis]
        if t < -1e-12:
            continue
        t = max(t, 0.0)
        at = position[other] + velocity[other] * t
        if low[other] <= at <= high[other]:
            n = np.zeros(2)
            n[axis] = sign
            found.append((t, n))
    for cx in (x, x + w):
        for cy in (y, y + h):
            c = np.array([cx, cy])
            d = position - c
            b = d @ velocity
            a = velocity @ velocity
            if b >= 0 or a == 0:
                continue
            disc = b * b - a * (d @ d - radius**2)
            if disc < 0:
                continue
            t = (-b - math.sqrt(disc)) / a
            if t < -1e-12:
                continue
            t = max(t, 0.0)
            n = position + velocity * t - c
            found.append((t, n / np.linalg.norm(n)))
    found = [f for f in found if f[0] <= HORIZON]
    if not found:
        return None
    return min(found, key=lambda f: f[0])


def fly(position, velocity, radius, bricks, duration):
    position = np.array(position, dtype=float)
    velocity = np.array(velocity, dtype=float)
    wall = list(bricks)
    broken = []
    left = duration
    while True:
        first, which, normal = left, None, None
        for k, brick in enumerate(wall):
            impact = brick_impact(position, velocity, radius, brick)
            if impact is not None and impact[0] <= first:
                first, normal = impact
                which = k
        position = position + velocity * first
        if which is None:
            return position, velocity, broken
        velocity = velocity - 2 * (velocity @ normal) * normal
        left -= first
        broken.append(which)
        del wall[which]
""",
    ),
    Wrong(
        "C.1",
        "the student goes through the row once from left to right and does not go back, "
        "although a collision may set the pair on its left going again",
        ("one_pass",),
        """
import numpy as np

SLOWEST = 1e-12


def collide_row(masses, velocities, restitution):
    v = np.array(velocities, dtype=float)
    for i in range(len(v) - 1):
        approach = v[i] - v[i + 1]
        if approach > SLOWEST:
            m1, m2 = masses[i], masses[i + 1]
            J = (1 + restitution) * approach * m1 * m2 / (m1 + m2)
            v[i] -= J / m1
            v[i + 1] += J / m2
    return v
""",
    ),
    Wrong(
        "C.3",
        "whether neighbours touch is decided with the angles from before the swing, so "
        "collisions come one step too late",
        ("touching_before_the_swing",),
        """
import numpy as np

GRAVITY = 9.81


def swing_step(angle, rate, length, dt):
    rate = rate - GRAVITY / length * np.sin(angle) * dt
    return angle + rate * dt, rate


def cradle(angles, rates, length, dt, steps):
    a = np.array(angles, dtype=float)
    r = np.array(rates, dtype=float)
    for _ in range(int(steps)):
        touching = [a[i] >= a[i + 1] for i in range(len(a) - 1)]
        a, r = swing_step(a, r, length, dt)
        swapped = True
        while swapped:
            swapped = False
            for i in range(len(a) - 1):
                if touching[i] and r[i] > r[i + 1]:
                    r[i], r[i + 1] = r[i + 1], r[i]
                    swapped = True
                    break
    return a, r
""",
    ),
    Wrong(
        "D.1",
        "The student measures the angle of the diagonal from the floor instead of from the "
        "vertical, which is the same only for a square domino",
        ("upside_down",),
        """
import math


def tipping_angle(width, height):
    # the centre is half the width beside the edge and half the height above it
    return math.atan2(height / 2, width / 2)
""",
    ),
    Wrong(
        "D.3",
        "Stale the wrong way: the first domino gets the mean, and the second one is then given "
        "the mean of that new rate and its own, so that the two do not go on together",
        ("mean_of_the_mean",),
        """
import math

import numpy as np

GRAVITY = 9.81


def chain(angles, rates, height, spacing, dt, steps):
    angles = np.array(angles, float)
    rates = np.array(rates, float)
    reach = math.asin(spacing / height)
    n = len(angles)
    for s in range(int(steps)):
        rates += 3 * GRAVITY / (2 * height) * np.sin(angles) * dt
        angles += rates * dt
        for i in range(n - 1):
            if angles[i] > reach and rates[i] > rates[i + 1]:
                rates[i] = (rates[i] + rates[i + 1]) / 2
                rates[i + 1] = (rates[i] + rates[i + 1]) / 2
        for i in range(n):
            if angles[i] > math.pi / 2:
                angles[i] = math.pi / 2
                rates[i] = 0.0
    return angles, rates
""",
    ),
    Wrong(
        "P.2",
        "the size of the impulse is taken from its x part alone, which is right only for a "
        "stroke to the right as in the example",
        ("pushed_along_x_alone",),
        """
import numpy as np


def strike(impulse, offset, mass, radius):
    velocity = np.asarray(impulse) / mass
    inertia = 0.4 * mass * radius**2
    push = impulse[0]
    spin = -offset * push / inertia
    return velocity, spin
""",
    ),
    Wrong(
        "P.3",
        "the impulse of a pair is divided by the count of its first ball only, not by the "
        "larger of the two counts",
        ("by_the_count_of_the_first",),
        """
import numpy as np

TOUCHING = 2.001
ROUNDS = 20


def share_impact(positions, velocities, radius, restitution):
    x = np.asarray(positions, dtype=float)
    v = np.array(velocities, dtype=float)
    n = len(x)
    for _ in range(ROUNDS):
        pairs = []
        count = [0] * n
        for i in range(n):
            for j in range(i + 1, n):
                d = x[j] - x[i]
                dist = np.linalg.norm(d)
                if dist > TOUCHING * radius:
                    continue
                normal = d / dist
                closing = (v[i] - v[j]) @ normal
                if closing > 0:
                    pairs.append((i, j, normal, closing))
                    count[i] += 1
                    count[j] += 1
        change = np.zeros_like(v)
        for i, j, normal, closing in pairs:
            push = (1 + restitution) * closing / 2 / count[i]
            change[i] -= push * normal
            change[j] += push * normal
        v = v + change
    return v
""",
    ),
    Wrong(
        "S.1",
        "the sum stops at the last mass and leaves out the edge that leads back to the first one",
        ("ring_left_open",),
        """
def ring_area(positions):
    total = 0.0
    for i in range(len(positions) - 1):
        x1, y1 = positions[i]
        x2, y2 = positions[i + 1]
        total += x1 * y2 - x2 * y1
    return total / 2
""",
    ),
    Wrong(
        "S.3",
        "The student thinks that a gas pushes everything straight away from the centre of the "
        "ring, instead of at right angles to each edge",
        ("away_from_the_middle",),
        """
import numpy as np


def pressure_forces(positions, area, stiffness):
    nxt = np.roll(positions, -1, axis=0)
    now = 0.5 * np.sum(positions[:, 0] * nxt[:, 1] - positions[:, 1] * nxt[:, 0])
    pressure = stiffness * (area / now - 1)
    centre = positions.mean(axis=0)
    forces = np.zeros(positions.shape)
    for i in range(len(positions)):
        j = (i + 1) % len(positions)
        size = pressure * np.linalg.norm(positions[j] - positions[i])
        for k in (i, j):
            out = positions[k] - centre
            forces[k] += size / 2 * out / np.linalg.norm(out)
    return forces
""",
    ),
    Wrong(
        "S.4",
        "velocities and positions are changed mass by mass inside the loop, and the forces are "
        "computed anew for each mass, from a ring of which a part has moved already",
        ("mass_by_mass",),
        """
import numpy as np

MASS = 0.1
STIFFNESS, DAMPING = 300.0, 10.0
PRESSURE = 800.0
GRIP = 0.98
AIR = 1.5
GRAVITY = 9.81
TIME_STEP = 1 / 600


def ring_area(positions):
    x, y = positions[:, 0], positions[:, 1]
    return 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)


def ring_forces(positions, velocities, length, stiffness, damping):
    way = np.roll(positions, -1, axis=0) - positions
    dist = np.linalg.norm(way, axis=1)
    u = way / dist[:, None]
    dv = np.roll(velocities, -1, axis=0) - velocities
    pull = stiffness * (dist - length) + damping * np.sum(dv * u, axis=1)
    f = pull[:, None] * u
    return f - np.roll(f, 1, axis=0)


def pressure_forces(positions, area, stiffness):
    p = stiffness * (area / ring_area(positions) - 1)
    way = np.roll(positions, -1, axis=0) - positions
    push = p / 2 * np.column_stack((way[:, 1], -way[:, 0]))
    return push + np.roll(push, 1, axis=0)


def drop(positions, velocities, length, area, steps):
    x = np.array(positions, dtype=float)
    v = np.array(velocities, dtype=float)
    g = np.array([0.0, -GRAVITY])
    for _ in range(int(steps)):
        for i in range(len(x)):
            F = (ring_forces(x, v, length, STIFFNESS, DAMPING)
                 + pressure_forces(x, area, PRESSURE))
            v[i] += (F[i] / MASS - AIR * v[i] + g) * TIME_STEP
            x[i] += v[i] * TIME_STEP
            if x[i, 1] < 0:
                x[i, 1] = 0.0
                if v[i, 1] < 0:
                    v[i, 1] = 0.0
                v[i, 0] *= GRIP
    return x, v
""",
    ),
)
