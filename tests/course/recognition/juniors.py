"""Wrong answers of young game programmers, and of a class that learns formulas by rote.

When they were first tried, by the models that EIGHTH was tried with, 54 of 60 were recognised.
"""

from __future__ import annotations

from course.recognition.students import Wrong

NINTH = (
    Wrong(
        "1.1",
        'thinks that "no energy is lost" means that each body keeps its own speed and simply '
        "turns round",
        ("both_turn_round",),
        """
def elastic_1d(m1, v1, m2, v2):
    # kinetic energy has v squared, so if both just reverse, the energy is the same
    v1_new = -v1
    v2_new = -v2
    return v1_new, v2_new
""",
    ),
    Wrong(
        "1.1",
        "overwrites v1 with the new velocity and then uses it in the formula for v2",
        ("uses_updated_v1",),
        """
def elastic_1d(m1, v1, m2, v2):
    M = m1 + m2
    v1 = ((m1 - m2) * v1 + 2 * m2 * v2) / M
    v2 = ((m2 - m1) * v2 + 2 * m1 * v1) / M
    return (v1, v2)
""",
    ),
    Wrong(
        "1.2",
        "finds the common velocity from kinetic energy, which is not conserved when bodies stick "
        "together",
        ("keeps_energy",),
        """
import math


def inelastic_1d(m1, v1, m2, v2):
    energy = 0.5 * m1 * v1 ** 2 + 0.5 * m2 * v2 ** 2
    speed = math.sqrt(2 * energy / (m1 + m2))
    # the direction is that of the body with more momentum
    if m1 * v1 + m2 * v2 < 0:
        speed = -speed
    return speed, speed
""",
    ),
    Wrong(
        "2.1",
        "takes the sum of the two speeds for the speed of approach and of separation, whichever "
        "way the bodies go",
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
        "sign slip in the second line: the relative velocity after is added as v2 - v1 and not as "
        "v1 - v2",
        ("sign",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    e = restitution
    p = m1 * v1 + m2 * v2
    u1 = (p - m2 * e * (v1 - v2)) / (m1 + m2)
    u2 = u1 + e * (v2 - v1)
    return u1, u2
""",
    ),
    Wrong(
        "2.4",
        "the factor e^2 by which the heights shrink is used for the times of the hops as well",
        ("times_shrink_like_heights",),
        """
import math


def rest_time(height, restitution, gravity):
    fall = math.sqrt(2 * height / gravity)
    q = restitution ** 2          # from bounce to bounce
    # geometric series: up and down, up and down ...
    return fall + 2 * fall * q / (1 - q)
""",
    ),
    Wrong(
        "3.1",
        'remembers "flip the component that the normal has", which is right for walls along x or '
        "y only",
        ("flips_each_component",),
        """
import numpy as np


def reflect(incident, normal):
    flip = 1 - 2 * np.abs(normal)   # 1 along the wall, -1 across it
    return incident * flip
""",
    ),
    Wrong(
        "3.2",
        "puts e into the mirror formula as a factor, 2 e (v.n) n, where (1 + e) belongs",
        (
            "one_plus",
            "term",
        ),
        """
import numpy as np


def bounce(velocity, normal, restitution):
    vn = np.dot(velocity, normal)
    if vn >= 0:
        return velocity
    return velocity - 2 * restitution * vn * normal
""",
    ),
    Wrong(
        "3.3",
        "moves the ball back along its path by the depth and not out along the normal",
        ("back_along_the_path",),
        """
import numpy as np


def resolve_wall(position, velocity, normal, depth, restitution):
    speed = np.linalg.norm(velocity)
    if speed > 0:
        # it came from there, so go back there
        position = position - depth * velocity / speed
    else:
        position = position + depth * normal
    vn = velocity @ normal
    if vn < 0:
        velocity = velocity - (1 + restitution) * vn * normal
    return position, velocity
""",
    ),
    Wrong(
        "4.1",
        "treats the circles as their bounding boxes: overlap on both axes, pushed out along the "
        "axis with less of it",
        (
            "gate",
            "out_along_an_axis",
        ),
        """
import numpy as np


def circle_contact(p1, r1, p2, r2):
    dx = p2[0] - p1[0]
    dy = p2[1] - p1[1]
    ox = r1 + r2 - abs(dx)
    oy = r1 + r2 - abs(dy)
    if ox <= 0 or oy <= 0:
        return None
    if ox <= oy:
        return np.array([1.0 if dx >= 0 else -1.0, 0.0]), ox
    return np.array([0.0, 1.0 if dy >= 0 else -1.0]), oy
""",
    ),
    Wrong(
        "4.2",
        "lets each circle receive an impulse in proportion to the other's mass, so that the two "
        "impulses are not equal and opposite",
        ("impulses_by_the_other_mass",),
        """
import numpy as np


def resolve_circles(v1, m1, v2, m2, normal, restitution):
    closing = np.dot(v1 - v2, normal)
    if closing <= 0:
        return v1, v2
    dv = (1 + restitution) * closing
    # the heavier the other one is, the harder it hits me
    impulse_on_1 = m2 * dv
    impulse_on_2 = m1 * dv
    return v1 - impulse_on_1 / m1 * normal, v2 + impulse_on_2 / m2 * normal
""",
    ),
    Wrong(
        "4.3",
        'reads "in inverse proportion to the masses" as depth / mass, and does not make the two '
        "ways add up to the depth",
        ("depth_over_mass",),
        """
import numpy as np


def separate(p1, m1, p2, m2, normal, depth):
    way1 = depth / m1
    way2 = depth / m2
    new1 = np.array(p1, dtype=float) - way1 * np.array(normal)
    new2 = np.array(p2, dtype=float) + way2 * np.array(normal)
    return new1, new2
""",
    ),
    Wrong(
        "4.4",
        "returns early when the circles do not approach, before they were moved apart",
        ("returns_before_separating",),
        """
import numpy as np


def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    rel = np.dot(v2 - v1, normal)
    if rel >= 0:
        return p1, v1, p2, v2      # nothing to do
    w1, w2 = 1 / m1, 1 / m2
    total = w1 + w2
    p1 = p1 - normal * depth * w1 / total
    p2 = p2 + normal * depth * w2 / total
    j = -(1 + restitution) * rel / total
    v1 = v1 - j * w1 * normal
    v2 = v2 + j * w2 * normal
    return p1, v1, p2, v2
""",
    ),
    Wrong(
        "5.1",
        "puts the mass in equal parts into the corners, as if the polygon were a few point masses",
        ("vertex_masses",),
        """
import numpy as np


def moment_of_inertia(mass, vertices):
    n = len(vertices)
    centre = vertices.mean(axis=0)
    total = 0
    for corner in vertices:
        r = np.linalg.norm(corner - centre)
        total += mass / n * r ** 2     # I = sum of m r^2
    return total
""",
    ),
    Wrong(
        "5.2",
        'uses "v = omega r" with vectors, so that the rotation drives the point outward along the '
        "lever",
        ("along_the_lever",),
        """
import numpy as np


def contact_velocity(v, w, r):
    v_rot = w * r
    return v + v_rot
""",
    ),
    Wrong(
        "5.3",
        "copied the line of body a for body b and forgot to change the lever",
        (
            "index",
            "other",
        ),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    part_a = 1 / m_a + cross(r_a, direction) ** 2 / i_a
    part_b = 1 / m_b + cross(r_a, direction) ** 2 / i_b
    return part_a + part_b
""",
    ),
    Wrong(
        "5.4",
        "limits the impulse on the positive side only, so a contact that slides forward gets more "
        "than mu jn",
        ("clamped_on_one_side",),
        """
def friction_impulse(vt, jn, friction, k):
    needed = -vt / k
    limit = friction * jn
    return min(needed, limit)
""",
    ),
    Wrong(
        "5.5",
        "the lever to the contact is taken along the normal, on the far side of the disc, instead "
        "of against it",
        ("sign",),
        """
import numpy as np


def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    vn = velocity @ normal
    if vn >= 0:
        return velocity, w
    inertia = radius ** 2 / 2
    tangent = np.array([-normal[1], normal[0]])
    r = radius * normal
    surface = velocity + w * np.array([-r[1], r[0]])
    vt = surface @ tangent
    jn = -(1 + restitution) * vn
    rxt = r[0] * tangent[1] - r[1] * tangent[0]
    k = 1 + rxt ** 2 / inertia
    jt = np.clip(-vt / k, -friction * jn, friction * jn)
    return velocity + jn * normal + jt * tangent, w + rxt * jt / inertia
""",
    ),
    Wrong(
        "6.1",
        "off by one: the loop ends before the edge from the last vertex back to the first",
        ("last_edge_missing",),
        """
import numpy as np


def sat_axes(vertices):
    axes = []
    for i in range(len(vertices) - 1):
        edge = vertices[i + 1] - vertices[i]
        size = np.hypot(edge[0], edge[1])
        if size < 1e-12:
            continue
        axes.append(np.array([edge[1], -edge[0]]) / size)
    return axes
""",
    ),
    Wrong(
        "6.3",
        "takes the length that the shadows share for the way out, which is too short where one "
        "lies within the other, and has no direction",
        ("common_part",),
        """
def overlap(interval_a, interval_b):
    low = max(interval_a[0], interval_b[0])
    high = min(interval_a[1], interval_b[1])
    shared = high - low
    return shared if shared > 0 else None
""",
    ),
    Wrong(
        "6.4",
        "tests the normals of A twice because of a copied variable, and never those of B",
        ("axes_of_a_only",),
        """
import numpy as np


def _normals(poly):
    e = np.roll(poly, -1, axis=0) - poly
    lengths = np.hypot(e[:, 0], e[:, 1])
    e = e[lengths > 1e-12] / lengths[lengths > 1e-12][:, None]
    return [np.array([y, -x]) for x, y in e]


def mtv(vertices_a, vertices_b):
    best_depth = np.inf
    best_normal = None
    for axis in _normals(vertices_a) + _normals(vertices_a):
        a = vertices_a @ axis
        b = vertices_b @ axis
        forward = a.max() - b.min()     # move B along +axis
        backward = b.max() - a.min()    # move B along -axis
        if forward <= 0 or backward <= 0:
            return None
        if forward < best_depth:
            best_depth, best_normal = forward, axis
        if backward < best_depth:
            best_depth, best_normal = backward, -axis
    return best_normal, best_depth
""",
    ),
    Wrong(
        "6.6",
        "compares the circle with the lines of the edges only, so beyond a corner it takes the "
        "face's normal and finds hits that are none",
        ("edges_without_ends",),
        """
import numpy as np


def circle_against_polygon(centre, radius, vertices):
    best = -np.inf
    normal = None
    n = len(vertices)
    for k in range(n):
        a, b = vertices[k], vertices[(k + 1) % n]
        edge = b - a
        length = np.linalg.norm(edge)
        if length == 0:
            continue
        out = np.array([edge[1], -edge[0]]) / length
        distance = np.dot(centre - a, out)
        if distance >= radius:
            return None
        if distance > best:
            best, normal = distance, out
    return normal, radius - best
""",
    ),
    Wrong(
        "7.1",
        "returns the time at which the centres are closest, and not the earlier one at which the "
        "rims first touch",
        ("nearest_approach_if_near_enough",),
        """
import numpy as np


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d = p2 - p1
    v = v2 - v1
    if d @ v >= 0:
        return None
    R = r1 + r2
    if d @ d <= R * R:
        return 0.0
    t = -(d @ v) / (v @ v)
    if t > dt:
        return None
    nearest = d + v * t
    if nearest @ nearest > R * R:
        return None
    return t
""",
    ),
    Wrong(
        "7.2",
        "adds the time up, v/g, to the time of a fall from the initial height, and forgets that "
        "the ball falls from higher up and fast",
        (
            "as_if_let_go",
            "falls_from_the_start",
        ),
        """
import math


def time_to_floor(height, velocity, gravity):
    if height <= 0 and velocity < 0:
        return 0.0
    if gravity == 0:
        if velocity >= 0:
            return None
        return height / -velocity
    t_up = max(velocity, 0.0) / gravity
    t_down = math.sqrt(2 * height / gravity)
    return t_up + t_down
""",
    ),
    Wrong(
        "7.3",
        "mirrors the overshoot at the wall at its full length; the rest of the step is not flown "
        "at the slower speed",
        ("mirrors_the_rest",),
        """
import numpy as np


def advance(p, v, room, restitution, dt):
    p = np.array(p, dtype=float) + np.array(v, dtype=float) * dt
    v = np.array(v, dtype=float)
    for axis in (0, 1):
        while p[axis] < 0 or p[axis] > room[axis]:
            if p[axis] < 0:
                p[axis] = -p[axis]
            else:
                p[axis] = 2 * room[axis] - p[axis]
            v[axis] = -restitution * v[axis]
    return p, v
""",
    ),
    Wrong(
        "7.4",
        "stores the pair outside of the if, so the answer names the last pair that meets, with "
        "the time of the first",
        ("the_pair_looked_at_last",),
        """
import math

import numpy as np


def _meet(d, v, reach):
    b = d @ v
    if b >= 0:
        return None
    c = d @ d - reach ** 2
    if c <= 0:
        return 0.0
    disc = b * b - (v @ v) * c
    if disc < 0:
        return None
    return c / (-b + math.sqrt(disc))


def next_event(positions, velocities, radii):
    t_best = math.inf
    pair = None
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            t = _meet(positions[j] - positions[i], velocities[j] - velocities[i],
                      radii[i] + radii[j])
            if t is None:
                continue
            if t < t_best:
                t_best = t
            pair = (i, j)
    if pair is None:
        return None
    return t_best, pair[0], pair[1]
""",
    ),
    Wrong(
        "7.5",
        "thinks that all is over as soon as the outer block turns round, and does not see that "
        "the inner one may still catch up with it",
        ("until_the_heavy_block_turns",),
        """
def pi_collisions(mass_ratio):
    M = mass_ratio
    outer, inner = -1.0, 0.0       # the wall is at the left
    count = 0
    while outer < 0:
        new_outer = ((M - 1) * outer + 2 * inner) / (M + 1)
        new_inner = ((1 - M) * inner + 2 * M * outer) / (M + 1)
        outer, inner = new_outer, new_inner
        count += 1
        if inner < 0:
            inner = -inner
            count += 1
    return count
""",
    ),
    Wrong(
        "8.1",
        "takes the largest difference of a single coordinate for the distance",
        ("the_larger_coordinate",),
        """
import numpy as np


def largest_error(places, right):
    return float(np.max(np.abs(places - right)))
""",
    ),
    Wrong(
        "8.2",
        "remembers log2 of the ratio of the errors, which holds only if the second step is half "
        "of the first",
        ("as_if_halved",),
        """
import math


def observed_order(dt_1, error_1, dt_2, error_2):
    # every halving of the step divides the error by 2^p
    return math.log2(error_1 / error_2)
""",
    ),
    Wrong(
        "8.3",
        "fits with log10 but turns the shift back with exp, so that C is wrong",
        ("two_kinds_of_logarithm",),
        """
import numpy as np


def fit_power(steps, errors):
    x = np.log10(steps)
    y = np.log10(errors)
    slope, shift = np.polyfit(x, y, 1)
    return slope, np.exp(shift)
""",
    ),
    Wrong(
        "8.5",
        "throws out the bad rows first and then returns the place in the shortened list",
        ("number_among_the_good",),
        """
import numpy as np


def cheapest(table, allowed):
    good = [row for row in table if row[1] <= allowed]
    if not good:
        return None
    times = [row[0] for row in good]
    return times.index(min(times))
""",
    ),
    Wrong(
        "9.1",
        "sums the masses from the lowest up, so each contact carries the boxes below it and not "
        "those above",
        ("counted_from_the_floor",),
        """
import numpy as np


def tower_forces(masses, gravity):
    forces = []
    load = 0.0
    for m in masses:
        load += m * gravity
        forces.append(load)
    return forces
""",
    ),
    Wrong(
        "9.2",
        "thinks that each sweep takes the same amount m/(M+m) of the first approach away, and not "
        "of what is left",
        ("same_amount_each_time",),
        """
import math


def sweeps_needed(light, heavy, left):
    taken = light / (heavy + light)
    return math.ceil((1 - left) / taken)
""",
    ),
    Wrong(
        "9.3",
        "takes friction as -mu jn whichever way the tip slides; the sign of vt is forgotten",
        ("always_to_the_left",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    # jt = -friction * jn  ->  vn + (knn - knt * friction) * jn = 0
    k = knn - friction * knt
    if k <= 0:
        return None
    return -vn / k
""",
    ),
    Wrong(
        "9.4",
        'learned "torque is force times arm" and multiplies the lengths, whatever the angle and '
        "the sense of turning",
        ("torque_of_lengths",),
        """
import numpy as np


def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    def energy(v, spin):
        return mass * (v @ v) / 2 + inertia * spin ** 2 / 2

    v_after = velocity + impulse / mass
    w_after = w + np.linalg.norm(arm) * np.linalg.norm(impulse) / inertia
    return energy(v_after, w_after) / energy(velocity, w)
""",
    ),
    Wrong(
        "10.2",
        "thinks that a body which does not spin at the start never will, so rotation is only "
        "needed for an initial spin",
        ("only_what_turns_already",),
        """
import math
from itertools import combinations

import numpy as np


def effects_called_for(bodies, gravity):
    names = set()
    if np.any(np.asarray(gravity) != 0) and any(b[0] > 0 for b in bodies):
        names.add("gravity")
    for a, b in combinations(bodies, 2):
        if a[0] == 0 and b[0] == 0:
            continue
        if min(a[2], b[2]) > 0:
            names.add("restitution")
        if math.sqrt(a[3] * b[3]) > 0:
            names.add("friction")
    for b in bodies:
        if b[4] != 0:
            names.add("rotation")
    return sorted(names)
""",
    ),
    Wrong(
        "10.3",
        "takes the sum of the sizes of all momenta as the limit, given to the lightest disc, "
        "where the energy is the limit",
        ("all_the_momentum",),
        """
import numpy as np


def fastest_way(masses, velocities, dt):
    momentum = 0.0
    for m, v in zip(masses, velocities):
        momentum += m * np.hypot(*v)
    top_speed = momentum / min(masses)
    return top_speed * dt
""",
    ),
    Wrong(
        "10.4",
        "looks at the beginning and the end of the flight only, and forgets the turning point in "
        "between",
        ("only_the_ends",),
        """
import numpy as np


def box_of_flight(position, velocity, radius, gravity, duration):
    x0 = np.asarray(position, float)
    x1 = x0 + velocity * duration + gravity * duration ** 2 / 2
    lo = np.minimum(x0, x1) - radius
    hi = np.maximum(x0, x1) + radius
    return lo[0], hi[0], lo[1], hi[1]
""",
    ),
    Wrong(
        "10.5",
        "asks a body's direct neighbours only, and does not follow the island to the next ones",
        ("only_neighbours",),
        """
import numpy as np


def bodies_asleep(inverse_masses, still, touches):
    n = len(still)
    asleep = []
    for a in range(n):
        if inverse_masses[a] == 0 or not still[a]:
            continue
        ok = True
        for b in range(n):
            if (touches[a, b] or touches[b, a]) and inverse_masses[b] > 0 and not still[b]:
                ok = False
        if ok:
            asleep.append(a)
    return asleep
""",
    ),
    Wrong(
        "11.2",
        "measures the sliding before the normal impulse and uses this stale value for the friction",
        ("sliding_before_the_blow",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, mb, ib = a[0], a[1], b[0], b[1]
    va, wa, vb, wb = a[2:4].copy(), a[4], b[2:4].copy(), b[4]

    def perp(r):
        return np.array([-r[1], r[0]])

    def k(d):
        return 1 / ma + 1 / mb + cross(arm_a, d) ** 2 / ia + cross(arm_b, d) ** 2 / ib

    tangent = perp(normal)
    rel = (vb + wb * perp(arm_b)) - (va + wa * perp(arm_a))
    vn, vt = rel @ normal, rel @ tangent
    if vn >= 0:
        return va, wa, vb, wb
    jn = -(1 + restitution) * vn / k(normal)
    jt = max(-friction * jn, min(friction * jn, -vt / k(tangent)))
    J = jn * normal + jt * tangent
    va = va - J / ma
    wa = wa - cross(arm_a, J) / ia
    vb = vb + J / mb
    wb = wb + cross(arm_b, J) / ib
    return va, wa, vb, wb
""",
    ),
    Wrong(
        "11.3",
        "lets gravity change the velocity first and moves the discs with the new velocity",
        ("falls_before_it_moves",),
        """
import numpy as np


def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    x = np.array(positions, float)
    v = np.array(velocities, float)
    v += np.asarray(gravity) * dt
    x += v * dt
    n = len(x)
    for i in range(n):
        for j in range(i + 1, n):
            d = x[j] - x[i]
            dist = np.linalg.norm(d)
            depth = radii[i] + radii[j] - dist
            if depth <= 0:
                continue
            nrm = d / dist if dist > 0 else np.array([1.0, 0.0])
            wi, wj = 1 / masses[i], 1 / masses[j]
            rel = (v[j] - v[i]) @ nrm
            if rel < 0:
                J = -(1 + restitution) * rel / (wi + wj)
                v[i] -= J * wi * nrm
                v[j] += J * wj * nrm
            x[i] -= nrm * depth * wi / (wi + wj)
            x[j] += nrm * depth * wj / (wi + wj)
    for i in range(n):
        for c in range(2):
            if x[i, c] < radii[i]:
                x[i, c] = radii[i]
                if v[i, c] < 0:
                    v[i, c] *= -restitution
            elif x[i, c] > room[c] - radii[i]:
                x[i, c] = room[c] - radii[i]
                if v[i, c] > 0:
                    v[i, c] *= -restitution
    return x, v
""",
    ),
    Wrong(
        "11.5",
        "takes the half-life for the time constant and fades by exp(-dt / half_life)",
        ("e_in_place_of_two",),
        """
import numpy as np


def glow(brightness, hit, dt, half_life):
    fade = np.exp(-dt / half_life)
    return np.where(np.asarray(hit) != 0, 1.0, np.asarray(brightness) * fade)
""",
    ),
    Wrong(
        "11.6",
        "linspace with its end point included stretches the samples, which should be 1 / rate "
        "apart",
        ("with_the_end_of_the_time",),
        """
import numpy as np


def knock(loudness, frequency, half_life, rate, count):
    count = int(count)
    if frequency >= rate / 2:
        return np.zeros(count)
    t = np.linspace(0, count / rate, count)
    return loudness * np.sin(2 * np.pi * frequency * t) * 0.5 ** (t / half_life)
""",
    ),
    Wrong(
        "A.1",
        "takes the plain mean of the pieces' velocities away, as if the momentum did not depend "
        "on their masses",
        ("nothing_taken_back",),
        """
import numpy as np


def split(velocity, masses, speed, heading):
    n = len(masses)
    angles = heading + 2 * np.pi * np.arange(n) / n
    out = speed * np.column_stack([np.cos(angles), np.sin(angles)])
    out = out - out.mean(axis=0)
    return velocity + out
""",
    ),
    Wrong(
        "A.2",
        "takes the muzzle speed as seen from the frame in which both rested, and not from the "
        "ship that recoils",
        ("seen_from_before",),
        """
import numpy as np


def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    direction = np.array([np.cos(heading), np.sin(heading)])
    shot = velocity + muzzle_speed * direction
    # recoil: m v = M V
    ship = velocity - shot_mass * muzzle_speed / ship_mass * direction
    return ship, shot
""",
    ),
    Wrong(
        "A.3",
        "computes each collision from the velocities at the beginning and writes the results over "
        "each other",
        ("from_the_velocities_before",),
        """
import numpy as np


def collide_all(positions, velocities, masses, radii, restitution):
    result = velocities.copy()
    for i in range(len(masses)):
        for j in range(i + 1, len(masses)):
            gap = positions[j] - positions[i]
            dist = np.sqrt(gap @ gap)
            if dist == 0 or dist >= radii[i] + radii[j]:
                continue
            n = gap / dist
            approach = (velocities[i] - velocities[j]) @ n
            if approach <= 0:
                continue
            J = (1 + restitution) * approach * masses[i] * masses[j] / (masses[i] + masses[j])
            result[i] = velocities[i] - J / masses[i] * n
            result[j] = velocities[j] + J / masses[j] * n
    return result
""",
    ),
    Wrong(
        "B.1",
        "thinks in a frame with y up, so the top wall is looked for at y = HEIGHT and the bottom "
        "one at 0",
        ("y_points_upwards",),
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
    depths = {
        "top": y + RADIUS - HEIGHT,
        "bottom": RADIUS - y,
        "left": RADIUS - x,
        "right": x + RADIUS - WIDTH,
    }
    return [(name, NORMALS[name], d) for name, d in depths.items() if d > 0]
""",
    ),
    Wrong(
        "B.2",
        "forgets to keep the part between 0 and 1, so that the bumper goes on beyond its ends",
        ("endless_line",),
        """
import numpy as np

RADIUS = 12.0
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0


def bumper_contact(position):
    ab = BUMPER_END - BUMPER_START
    t = np.dot(position - BUMPER_START, ab) / np.dot(ab, ab)
    closest = BUMPER_START + t * ab
    away = position - closest
    distance = np.linalg.norm(away)
    depth = RADIUS + BUMPER_HALF_THICKNESS - distance
    if depth <= 0 or distance == 0:
        return None
    return away / distance, depth
""",
    ),
    Wrong(
        "B.4",
        "resolves the contacts at the old position first and moves the ball at the end of the step",
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
    depths = [("top", RADIUS - y), ("bottom", y + RADIUS - HEIGHT),
              ("left", RADIUS - x), ("right", x + RADIUS - WIDTH)]
    return [(name, NORMALS[name], d) for name, d in depths if d > 0]


def bumper_contact(position):
    ab = BUMPER_END - BUMPER_START
    t = min(max((position - BUMPER_START) @ ab / (ab @ ab), 0.0), 1.0)
    away = position - (BUMPER_START + t * ab)
    distance = np.linalg.norm(away)
    depth = RADIUS + BUMPER_HALF_THICKNESS - distance
    if depth <= 0:
        return None
    return away / distance, depth


def resolve(position, velocity, normal, depth):
    position = position + depth * normal
    vn = velocity @ normal
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position, velocity


def step(position, velocity, dt=TIME_STEP):
    hits = []
    contact = bumper_contact(position)
    if contact is not None:
        normal, depth = contact
        if velocity @ normal < 0:
            hits.append("bumper")
        position, velocity = resolve(position, velocity, normal, depth)
    for name, normal, depth in wall_contacts(position):
        if velocity @ normal < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    position = position + velocity * dt
    return position, velocity, hits
""",
    ),
    Wrong(
        "K.1",
        "makes the sideways velocity proportional to the offset, where the angle should be "
        "proportional to it",
        ("sideways_by_the_offset",),
        """
import math

import numpy as np

STEEPEST = math.radians(60)


def paddle_bounce(offset, speed):
    offset = max(-1.0, min(1.0, offset))
    vx = offset * speed * math.sin(STEEPEST)
    vy = math.sqrt(speed ** 2 - vx ** 2)
    return vx, vy
""",
    ),
    Wrong(
        "K.2",
        "grows the brick by the radius on all sides but leaves its corners square, so the ball "
        "hits corners too early",
        ("square_corners",),
        """
import math

import numpy as np

HORIZON = 1.0


def brick_impact(position, velocity, radius, box):
    low = np.array([box[0] - radius, box[1] - radius])
    high = np.array([box[0] + box[2] + radius, box[1] + box[3] + radius])
    t_in, t_out = -math.inf, math.inf
    normal = None
    for axis in (0, 1):
        if velocity[axis] == 0:
            if position[axis] <= low[axis] or position[axis] >= high[axis]:
                return None
            continue
        t1 = (low[axis] - position[axis]) / velocity[axis]
        t2 = (high[axis] - position[axis]) / velocity[axis]
        if t1 > t2:
            t1, t2 = t2, t1
        if t1 > t_in:
            t_in = t1
            normal = np.zeros(2)
            normal[axis] = -1.0 if velocity[axis] > 0 else 1.0
        t_out = min(t_out, t2)
    if normal is None or t_in >= t_out or t_in < 0 or t_in > HORIZON:
        return None
    return t_in, normal
""",
    ),
    Wrong(
        "C.1",
        "goes once through the row from left to right and does not look again for pairs that "
        "approach now",
        ("one_pass",),
        """
import numpy as np

SLOWEST = 1e-12


def collide_row(masses, velocities, restitution):
    v = np.array(velocities, dtype=float)
    for k in range(len(v) - 1):
        approach = v[k] - v[k + 1]
        if approach > SLOWEST:
            ml, mr = masses[k], masses[k + 1]
            J = (1 + restitution) * approach * ml * mr / (ml + mr)
            v[k] -= J / ml
            v[k + 1] += J / mr
    return v
""",
    ),
    Wrong(
        "C.2",
        "uses the small-angle formula -g/l angle of the harmonic pendulum at all angles",
        ("small_angles",),
        """
GRAVITY = 9.81


def swing_step(angle, rate, length, dt):
    omega_squared = GRAVITY / length
    rate = rate - omega_squared * angle * dt
    angle = angle + rate * dt
    return angle, rate
""",
    ),
    Wrong(
        "D.2",
        "uses the moment of inertia about the centre, 1/12, from the formula sheet although the "
        "domino turns about its edge",
        ("about_the_centre",),
        """
import math

GRAVITY = 9.81


def toppling_rate(width, height):
    diagonal = math.hypot(width, height)
    lift = diagonal / 2 - height / 2
    inertia_per_mass = (width ** 2 + height ** 2) / 12
    # 1/2 I w^2 = m g lift
    return math.sqrt(2 * GRAVITY * lift / inertia_per_mass)
""",
    ),
    Wrong(
        "D.3",
        "lets equal dominoes swap their rates like balls of a cradle, where they should go on "
        "together with the mean",
        ("exchange_their_rates",),
        """
import math

import numpy as np

GRAVITY = 9.81


def chain(angles, rates, height, spacing, dt, steps):
    a = np.array(angles, dtype=float)
    w = np.array(rates, dtype=float)
    touch = math.asin(spacing / height)
    for _ in range(int(steps)):
        w += 1.5 * GRAVITY / height * np.sin(a) * dt
        a += w * dt
        for i in range(len(a) - 1):
            if a[i] > touch and w[i] > w[i + 1]:
                w[i], w[i + 1] = w[i + 1], w[i]
        down = a > math.pi / 2
        a[down] = math.pi / 2
        w[down] = 0.0
    return a, w
""",
    ),
    Wrong(
        "P.1",
        "sets the rows a whole ball's distance apart, and forgets that the balls of the next row "
        "lie in the gaps",
        ("square_rows",),
        """
import numpy as np


def rack(apex, radius, gap):
    pitch = 2 * radius + gap
    balls = []
    for row in range(5):
        x = apex[0] + row * pitch
        bottom = apex[1] - row * pitch / 2
        for k in range(row + 1):
            balls.append([x, bottom + k * pitch])
    return np.array(balls)
""",
    ),
    Wrong(
        "P.2",
        "believes that a push beside the centre moves the ball less because a part of it goes "
        "into the spin",
        ("spin_takes_a_part",),
        """
import numpy as np


def strike(impulse, offset, mass, radius):
    share = np.sqrt(1 - (offset / radius) ** 2)
    velocity = share * impulse / mass
    inertia = 0.4 * mass * radius ** 2
    spin = -offset * np.linalg.norm(impulse) / inertia
    return velocity, spin
""",
    ),
    Wrong(
        "P.3",
        "changes the velocities at once inside of the loop over the pairs, so later pairs of the "
        "same round see the new ones",
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
        count = [0] * n
        for i in range(n):
            for j in range(i + 1, n):
                d = positions[j] - positions[i]
                dist = np.linalg.norm(d)
                if dist == 0 or dist > TOUCHING * radius:
                    continue
                if (v[i] - v[j]) @ d > 0:
                    pairs.append((i, j, d / dist))
                    count[i] += 1
                    count[j] += 1
        for i, j, normal in pairs:
            approach = (v[i] - v[j]) @ normal
            dv = (1 + restitution) * approach / 2 / max(count[i], count[j])
            v[i] -= dv * normal
            v[j] += dv * normal
    return v
""",
    ),
    Wrong(
        "S.2",
        "damps the whole relative velocity of two masses and not only its part along the spring",
        ("damps_across_the_springs",),
        """
import numpy as np


def ring_forces(positions, velocities, length, stiffness, damping):
    along = np.roll(positions, -1, axis=0) - positions
    dist = np.linalg.norm(along, axis=1, keepdims=True)
    u = along / dist
    dv = np.roll(velocities, -1, axis=0) - velocities
    pull = stiffness * (dist - length) * u + damping * dv
    return pull - np.roll(pull, 1, axis=0)
""",
    ),
    Wrong(
        "S.3",
        "uses the unit normal of each edge and forgets to multiply by the edge's length, which "
        "shows only if it is not 1",
        ("edges_alike",),
        """
import numpy as np


def pressure_forces(positions, area, stiffness):
    n = len(positions)
    now = 0.0
    for i in range(n):
        x0, y0 = positions[i]
        x1, y1 = positions[(i + 1) % n]
        now += (x0 * y1 - x1 * y0) / 2
    pressure = stiffness * (area / now - 1)
    force = np.zeros((n, 2))
    for i in range(n):
        k = (i + 1) % n
        edge = positions[k] - positions[i]
        outward = np.array([edge[1], -edge[0]]) / np.linalg.norm(edge)
        force[i] += pressure * outward / 2
        force[k] += pressure * outward / 2
    return force
""",
    ),
)
