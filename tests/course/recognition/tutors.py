"""Wrong answers that a tutor of pupils expects, written from the tasks alone.

When they were first tried, after what SEVENTH had taught, 46 of 60 were recognised.
"""

from __future__ import annotations

from course.recognition.students import Wrong

EIGHTH = (
    Wrong(
        "1.1",
        "Slip: overwrites v1 with its new value and then uses it in the formula for v2, which "
        "needs the old one.",
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
        "Believes that kinetic energy is kept when bodies stick together, and takes the common "
        "speed from it (with the sign of the momentum).",
        ("keeps_energy",),
        """
import math


def inelastic_1d(m1, v1, m2, v2):
    kinetic = 0.5 * m1 * v1**2 + 0.5 * m2 * v2**2
    speed = math.sqrt(2 * kinetic / (m1 + m2))
    # direction: where the larger momentum goes
    if m1 * v1 + m2 * v2 < 0:
        speed = -speed
    return speed, speed
""",
    ),
    Wrong(
        "1.3",
        "Treats momentum as a magnitude and takes the change of mass times speed, so that a "
        "reversal of direction counts as a difference and not as a sum.",
        ("absolute",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    v2_new = (2 * m1 * v1 + (m2 - m1) * v2) / (m1 + m2)
    before = m2 * abs(v2)
    after = m2 * abs(v2_new)
    return after - before
""",
    ),
    Wrong(
        "2.1",
        "Thinks that the speed of approach is always the sum of the two speeds, as if the bodies "
        "always came head-on and left in opposite directions.",
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
        "Takes e for the share of the (centre-of-mass) kinetic energy that survives, so the "
        "relative speed is multiplied by the root of e.",
        ("energy_restitution",),
        """
import math


def collide_1d(m1, v1, m2, v2, restitution):
    vc = (m1 * v1 + m2 * v2) / (m1 + m2)
    # energy seen from the centre of mass: e of it is left, speeds go with the square root
    k = math.sqrt(restitution)
    return vc - k * (v1 - vc), vc - k * (v2 - vc)
""",
    ),
    Wrong(
        "2.3",
        "Slip: the list starts with the height of the drop itself, so it is one bounce behind.",
        ("starts_with_the_drop",),
        """
def bounce_heights(height, restitution, count):
    heights = []
    h = height
    for _ in range(count):
        heights.append(h)
        h = h * restitution**2
    return heights
""",
    ),
    Wrong(
        "2.4",
        "Forgets that after each bounce the ball goes up and comes down again: each flight counts "
        "only once one way.",
        ("forgets_the_way_up",),
        """
from math import sqrt


def rest_time(height, restitution, gravity):
    first_fall = sqrt(2 * height / gravity)
    # every fall is e times as long as the one before: geometric series
    return first_fall / (1 - restitution)
""",
    ),
    Wrong(
        "3.1",
        "Mirrors the direction about the normal line instead of about the wall (angle out = 2 "
        "angle of normal - angle in, without the half turn).",
        ("opposite_sign",),
        """
import math

import numpy as np


def reflect(incident, normal):
    speed = math.hypot(incident[0], incident[1])
    a_in = math.atan2(incident[1], incident[0])
    a_normal = math.atan2(normal[1], normal[0])
    a_out = 2 * a_normal - a_in
    return np.array([speed * math.cos(a_out), speed * math.sin(a_out)])
""",
    ),
    Wrong(
        "3.2",
        "Slip: misplaced parenthesis, (1 + e vn) n instead of (1 + e) vn n.",
        ("precedence",),
        """
import numpy as np


def bounce(velocity, normal, restitution):
    vn = np.dot(velocity, normal)
    if vn >= 0:
        return velocity
    return velocity - (1 + restitution * vn) * normal
""",
    ),
    Wrong(
        "3.3",
        "Slip: returns early for a ball that already leaves, before the ball has been moved out "
        "of the wall.",
        ("gate_before_position",),
        """
import numpy as np


def resolve_wall(position, velocity, normal, depth, restitution):
    vn = velocity @ normal
    if vn >= 0:
        return position, velocity
    new_position = position + depth * normal
    tangent_part = velocity - vn * normal
    return new_position, tangent_part - restitution * vn * normal
""",
    ),
    Wrong(
        "3.3",
        "Thinks the ball must go back by the depth along the way it came, opposite to its "
        "velocity, instead of along the normal.",
        ("back_along_the_path",),
        """
import numpy as np


def resolve_wall(position, velocity, normal, depth, restitution):
    speed = np.linalg.norm(velocity)
    vn = float(np.dot(velocity, normal))
    if speed > 0 and vn < 0:
        position = position - depth * velocity / speed
        velocity = velocity - (1 + restitution) * vn * normal
    else:
        position = position + depth * normal
    return position, velocity
""",
    ),
    Wrong(
        "4.1",
        "Takes the overlap for the smaller of the two overlaps of the bounding squares and pushes "
        "along the x or y axis, as if circles were boxes.",
        ("out_along_an_axis",),
        """
import numpy as np


def circle_contact(p1, r1, p2, r2):
    d = p2 - p1
    reach = r1 + r2
    if d @ d >= reach**2:
        return None
    overlap_x = reach - abs(d[0])
    overlap_y = reach - abs(d[1])
    if overlap_x <= overlap_y:
        return np.array([1.0 if d[0] >= 0 else -1.0, 0.0]), overlap_x
    return np.array([0.0, 1.0 if d[1] >= 0 else -1.0]), overlap_y
""",
    ),
    Wrong(
        "4.2",
        "Uses the impulse per mass of two equal bodies, (1 + e)/2 of the approach for each, "
        "whatever the masses are.",
        ("masses_ignored",),
        """
import numpy as np


def resolve_circles(v1, m1, v2, m2, normal, restitution):
    closing = np.dot(v1 - v2, normal)
    if closing <= 0:
        return v1, v2
    change = 0.5 * (1 + restitution) * closing * normal
    return v1 - change, v2 + change
""",
    ),
    Wrong(
        "4.3",
        "Thinks that the heavier circle is moved further: shares the way in proportion to the "
        "masses instead of inversely.",
        ("in_proportion_to_mass",),
        """
import math

import numpy as np


def separate(p1, m1, p2, m2, normal, depth):
    if math.isinf(m1):
        return p1, p2 + depth * normal
    if math.isinf(m2):
        return p1 - depth * normal, p2
    part1 = m1 / (m1 + m2)
    part2 = m2 / (m1 + m2)
    return p1 - part1 * depth * normal, p2 + part2 * depth * normal
""",
    ),
    Wrong(
        "4.4",
        "Slip: computes the impulse again for the second circle after the velocity of the first "
        "was changed, so the second circle gets a wrong push.",
        ("updated",),
        """
import math

import numpy as np


def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    w1, w2 = 1 / m1, 1 / m2
    p1 = p1 - normal * depth * w1 / (w1 + w2)
    p2 = p2 + normal * depth * w2 / (w1 + w2)
    if (v2 - v1) @ normal < 0:
        v1 = v1 + (1 + restitution) * ((v2 - v1) @ normal) / (w1 + w2) * w1 * normal
        v2 = v2 - (1 + restitution) * ((v2 - v1) @ normal) / (w1 + w2) * w2 * normal
    return p1, v1, p2, v2
""",
    ),
    Wrong(
        "5.1",
        "Takes the mean of the vertices for the centroid, which goes wrong for irregular polygons "
        "and for a vertex in the middle of an edge.",
        ("average_of_the_vertices",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def moment_of_inertia(mass, vertices):
    centre = vertices.mean(axis=0)
    points = vertices - centre
    top, bottom = 0.0, 0.0
    for a, b in zip(points, np.roll(points, -1, axis=0)):
        c = cross(a, b)
        top += c * (a @ a + a @ b + b @ b)
        bottom += c
    return mass * top / (6 * bottom)
""",
    ),
    Wrong(
        "5.3",
        "Uses the whole length of the lever squared instead of its part across the direction, so "
        "even a push through the centre seems to turn the body.",
        ("full_distance",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    linear = 1 / m_a + 1 / m_b
    angular = np.dot(r_a, r_a) / i_a + np.dot(r_b, r_b) / i_b
    return linear + angular
""",
    ),
    Wrong(
        "5.4",
        "Slip: limits the impulse on the positive side only; a negative one may be as large as it "
        "likes.",
        ("clamped_on_one_side",),
        """
def friction_impulse(vt, jn, friction, k):
    wanted = -vt / k
    limit = friction * jn
    return min(wanted, limit)
""",
    ),
    Wrong(
        "5.5",
        "Believes that rough means that the disc always grips: friction makes it roll without "
        "sliding at once, with no Coulomb limit.",
        ("always_grips",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    vn = velocity @ normal
    if vn >= 0:
        return velocity, w
    inertia = radius**2 / 2
    jn = -(1 + restitution) * vn
    tangent = np.array([-normal[1], normal[0]])
    arm = -radius * normal
    slide = (velocity + w * np.array([-arm[1], arm[0]])) @ tangent
    k = 1 + cross(arm, tangent) ** 2 / inertia
    jt = -slide / k if friction > 0 else 0.0
    push = jn * normal + jt * tangent
    return velocity + push, w + cross(arm, push) / inertia
""",
    ),
    Wrong(
        "6.1",
        "Slip: loops over neighbouring vertices only and forgets the edge from the last vertex "
        "back to the first.",
        ("last_edge_missing",),
        """
import numpy as np


def sat_axes(vertices):
    axes = []
    for i in range(len(vertices) - 1):
        edge = vertices[i + 1] - vertices[i]
        length = np.hypot(edge[0], edge[1])
        if length < 1e-12:
            continue
        axes.append(np.array([edge[1], -edge[0]]) / length)
    return axes
""",
    ),
    Wrong(
        "6.3",
        "Takes the length of the common part for the way out, which is too short when one shadow "
        "lies inside the other.",
        ("common_part",),
        """
def overlap(interval_a, interval_b):
    low = max(interval_a[0], interval_b[0])
    high = min(interval_a[1], interval_b[1])
    common = high - low
    return common if common > 0 else None
""",
    ),
    Wrong(
        "6.4",
        "Tests the edge normals of A only, in the belief that these axes are enough for a pair of "
        "polygons.",
        ("axes_of_a_only",),
        """
import numpy as np


def mtv(vertices_a, vertices_b):
    best = None
    n = len(vertices_a)
    for i in range(n):
        e = vertices_a[(i + 1) % n] - vertices_a[i]
        size = np.linalg.norm(e)
        if size == 0:
            continue
        axis = np.array([e[1], -e[0]]) / size
        a, b = vertices_a @ axis, vertices_b @ axis
        forward = a.max() - b.min()   # B moves along +axis
        backward = b.max() - a.min()  # B moves along -axis
        if forward <= 0 or backward <= 0:
            return None
        for way, direction in ((forward, axis), (backward, -axis)):
            if best is None or way < best[1]:
                best = (direction, way)
    return best
""",
    ),
    Wrong(
        "6.6",
        "Forgets that a centre inside the polygon has to come out first: uses radius - distance "
        "there as for a centre outside, though the normal is turned.",
        ("difference_when_inside",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def closest_point_on_segment(point, start, end):
    way = end - start
    part = (point - start) @ way / (way @ way)
    return start + min(max(part, 0.0), 1.0) * way


def circle_against_polygon(centre, radius, vertices):
    inside = True
    nearest, shortest = None, np.inf
    for a, b in zip(vertices, np.roll(vertices, -1, axis=0)):
        if np.all(a == b):
            continue
        if cross(b - a, centre - a) < 0:
            inside = False
        q = closest_point_on_segment(centre, a, b)
        d = np.linalg.norm(centre - q)
        if d < shortest:
            nearest, shortest = q, d
    depth = radius - shortest
    if inside:
        return (nearest - centre) / shortest, abs(depth)
    if depth <= 0:
        return None
    return (centre - nearest) / shortest, depth
""",
    ),
    Wrong(
        "7.1",
        "Takes the moment of closest approach for the moment of the touch, if the circles come "
        "near enough then.",
        ("nearest_approach_if_near_enough",),
        """
import math

import numpy as np


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    gap, rel = p2 - p1, v2 - v1
    reach = r1 + r2
    b = gap @ rel
    if b >= 0:
        return None  # they part, or do not move relative to each other
    if gap @ gap <= reach**2:
        return 0.0
    t = -b / (rel @ rel)
    if np.linalg.norm(gap + t * rel) > reach or t > dt:
        return None
    return t
""",
    ),
    Wrong(
        "7.2",
        "For a ball thrown up, adds the time to rise to the time to fall from the starting "
        "height, and forgets the height gained on the way up.",
        ("falls_from_the_start",),
        """
import math


def time_to_floor(height, velocity, gravity):
    if height <= 0 and velocity < 0:
        return 0.0
    if gravity == 0:
        return height / -velocity if velocity < 0 else None
    if velocity > 0:
        rise = velocity / gravity
        fall = math.sqrt(2 * height / gravity)
        return rise + fall
    # falling already: stable form of the root
    return 2 * height / (-velocity + math.sqrt(velocity**2 + 2 * gravity * height))
""",
    ),
    Wrong(
        "7.3",
        "Slip: mirrors the place beyond the wall at full length, though after the impact the ball "
        "goes on with the reduced velocity.",
        ("mirrors_the_rest",),
        """
import numpy as np


def advance(p, v, room, restitution, dt):
    place = np.array(p, dtype=float) + np.array(v, dtype=float) * dt
    speed = np.array(v, dtype=float)
    for axis in range(2):
        while place[axis] < 0 or place[axis] > room[axis]:
            if place[axis] < 0:
                place[axis] = -place[axis]
            else:
                place[axis] = 2 * room[axis] - place[axis]
            speed[axis] *= -restitution
    return place, speed
""",
    ),
    Wrong(
        "7.5",
        "Thinks that all is over as soon as the outer block moves away from the wall, though the "
        "inner one may still be faster and catch up.",
        ("until_the_heavy_block_turns",),
        """
def pi_collisions(mass_ratio):
    M, m = float(mass_ratio), 1.0
    V, v = -1.0, 0.0       # the wall is on the left
    hits = 0
    while V < 0:
        V, v = ((M - m) * V + 2 * m * v) / (M + m), ((m - M) * v + 2 * M * V) / (M + m)
        hits += 1
        if v < 0:
            v = -v
            hits += 1
    return hits
""",
    ),
    Wrong(
        "8.1",
        "Looks for the largest difference of a single coordinate instead of the largest distance.",
        ("the_larger_coordinate",),
        """
import numpy as np


def largest_error(places, right):
    difference = np.abs(places - right)
    return float(difference.max())
""",
    ),
    Wrong(
        "8.2",
        "Uses the formula for a step that was halved (log2 of the ratio of errors) for any two "
        "steps.",
        (
            "absolute",
            "as_if_halved",
        ),
        """
import math


def observed_order(dt_1, error_1, dt_2, error_2):
    coarse, fine = (error_1, error_2) if dt_1 > dt_2 else (error_2, error_1)
    return math.log2(coarse / fine)
""",
    ),
    Wrong(
        "8.4",
        "Reads equal work as a budget: takes the best of all rows with at most so many sweeps.",
        ("at_most_so_many",),
        """
import math


def best_split(table, sweeps):
    winner = None
    least = math.inf
    for substeps, iterations, error in table:
        if substeps * iterations <= sweeps and error < least:
            least = error
            winner = (int(substeps), int(iterations))
    return winner
""",
    ),
    Wrong(
        "8.5",
        "Slip: filters the table first and returns the number of the row in the filtered table, "
        "not in the one given.",
        ("number_among_the_good",),
        """
import numpy as np


def cheapest(table, allowed):
    table = np.asarray(table)
    good = table[table[:, 1] <= allowed]
    if len(good) == 0:
        return None
    return int(np.argmin(good[:, 0]))
""",
    ),
    Wrong(
        "9.1",
        "Thinks that a box presses on its support only with what lies on top of it: leaves out "
        "the box's own weight.",
        ("without_the_box_itself",),
        """
import numpy as np


def tower_forces(masses, gravity):
    forces = []
    for i in range(len(masses)):
        load = sum(masses[i + 1:])
        forces.append(load * gravity)
    return np.array(forces)
""",
    ),
    Wrong(
        "9.3",
        "Slip: takes friction as always directed to the left, -mu jn, and forgets the case of a "
        "tip that slides to the left.",
        ("always_to_the_left",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    stiffness = knn - friction * knt
    if stiffness <= 0:
        return None
    return -vn / stiffness
""",
    ),
    Wrong(
        "9.4",
        "Sign slip in the torque: uses impulse x arm in place of arm x impulse, so the blow turns "
        "the body the wrong way.",
        ("turns_the_other_way",),
        """
import numpy as np


def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    def energy(v, spin):
        return 0.5 * mass * (v @ v) + 0.5 * inertia * spin**2

    torque_impulse = impulse[0] * arm[1] - impulse[1] * arm[0]
    return energy(velocity + impulse / mass, w + torque_impulse / inertia) / energy(velocity, w)
""",
    ),
    Wrong(
        "9.5",
        "Remembers Newton's cradle: lets each pair swap its velocities, which holds for equal "
        "masses only.",
        ("always_swaps",),
        """
import numpy as np


def one_by_one(masses, velocities):
    v = np.array(velocities, dtype=float)
    while True:
        approach = v[:-1] - v[1:]
        if approach.size == 0 or approach.max() < 1e-9:
            return v
        k = int(np.argmax(approach))
        v[k], v[k + 1] = v[k + 1], v[k]
""",
    ),
    Wrong(
        "10.2",
        "Thinks that bodies turn only if something rubs or if they spin already, and overlooks "
        "that a smooth polygon is pushed beside its centre.",
        ("corners_never_turn",),
        """
import numpy as np


def effects_called_for(bodies, gravity):
    names = set()
    if np.any(np.asarray(gravity) != 0) and any(b[0] > 0 for b in bodies):
        names.add("gravity")
    n = len(bodies)
    for i in range(n):
        for j in range(i + 1, n):
            if bodies[i][0] == 0 and bodies[j][0] == 0:
                continue
            if min(bodies[i][2], bodies[j][2]) > 0:
                names.add("restitution")
            if bodies[i][3] * bodies[j][3] > 0:
                names.add("friction")
    if "friction" in names or any(b[4] != 0 for b in bodies):
        names.add("rotation")
    return sorted(names)
""",
    ),
    Wrong(
        "10.3",
        "Believes that a disc can never become faster than the fastest one is now, though a light "
        "disc can gain speed from a heavy one.",
        ("fastest_now",),
        """
import numpy as np


def fastest_way(masses, velocities, dt):
    speeds = np.sqrt((np.asarray(velocities) ** 2).sum(axis=1))
    return float(speeds.max() * dt)
""",
    ),
    Wrong(
        "10.4",
        "Slip: looks at the turning point if it is in the future, but forgets to check that it "
        "still lies within the duration.",
        ("condition",),
        """
import numpy as np


def box_of_flight(position, velocity, radius, gravity, duration):
    result = []
    for x, v, g in zip(position, velocity, gravity):
        xs = [x, x + v * duration + g * duration**2 / 2]
        if g != 0:
            turn = -v / g
            if turn > 0:
                xs.append(x + v * turn + g * turn**2 / 2)
        result += [min(xs) - radius, max(xs) + radius]
    return tuple(result)
""",
    ),
    Wrong(
        "10.5",
        "Lets static bodies join islands too, so that all that stands on the same floor is one "
        "island and one moving body keeps all awake.",
        ("floors_join",),
        """
import numpy as np


def bodies_asleep(inverse_masses, still, touches):
    n = len(inverse_masses)
    label = list(range(n))
    changed = True
    while changed:
        changed = False
        for a in range(n):
            for b in range(n):
                if touches[a, b] and label[a] != label[b]:
                    label[a] = label[b] = min(label[a], label[b])
                    changed = True
    awake = {label[k] for k in range(n) if not still[k] and inverse_masses[k] > 0}
    return [k for k in range(n) if inverse_masses[k] > 0 and label[k] not in awake]
""",
    ),
    Wrong(
        "11.1",
        "Slip: sorts the boxes by their left sides for the sweep and returns the places in the "
        "sorted list instead of the original numbers.",
        ("places_after_sorting",),
        """
import numpy as np


def near_pairs(boxes):
    boxes = sorted([list(b) for b in boxes])
    pairs = []
    for i in range(len(boxes)):
        for j in range(i + 1, len(boxes)):
            if boxes[j][0] > boxes[i][1]:
                break
            if boxes[j][2] <= boxes[i][3] and boxes[i][2] <= boxes[j][3]:
                pairs.append((i, j))
    return pairs
""",
    ),
    Wrong(
        "11.2",
        "Stale value: friction works on the sliding there was before the normal impulse, though "
        "that impulse can turn the bodies and change it.",
        ("sliding_before_the_blow",),
        """
import numpy as np


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    m_a, i_a, w_a = a[0], a[1], a[4]
    m_b, i_b, w_b = b[0], b[1], b[4]
    v_a, v_b = np.array(a[2:4]), np.array(b[2:4])
    tangent = np.array([-normal[1], normal[0]])

    point_a = v_a + w_a * np.array([-arm_a[1], arm_a[0]])
    point_b = v_b + w_b * np.array([-arm_b[1], arm_b[0]])
    relative = point_b - point_a
    vn, vt = relative @ normal, relative @ tangent
    if vn >= 0:
        return v_a, w_a, v_b, w_b

    def k(d):
        return (1 / m_a + 1 / m_b + cross(arm_a, d) ** 2 / i_a
                + cross(arm_b, d) ** 2 / i_b)

    jn = -(1 + restitution) * vn / k(normal)
    jt = np.clip(-vt / k(tangent), -friction * jn, friction * jn)
    impulse = jn * normal + jt * tangent
    return (v_a - impulse / m_a, w_a - cross(arm_a, impulse) / i_a,
            v_b + impulse / m_b, w_b + cross(arm_b, impulse) / i_b)
""",
    ),
    Wrong(
        "11.4",
        "Slip: compares the two tables row by row, as if a pair kept its place, so a pair that "
        "only moved to another row counts as changed.",
        ("row_against_row",),
        """
def touch_changes(before, now):
    old = [(int(p[0]), int(p[1])) for p in before]
    new = [(int(p[0]), int(p[1])) for p in now]
    begun, parted = [], []
    for k in range(max(len(old), len(new))):
        was = old[k] if k < len(old) else None
        is_ = new[k] if k < len(new) else None
        if was != is_:
            if is_ is not None:
                begun.append(is_)
            if was is not None:
                parted.append(was)
    return begun, parted
""",
    ),
    Wrong(
        "11.6",
        "Confuses the half-life with the time constant: lets the tone fade by exp(-t / half_life) "
        "instead of halving it.",
        ("fades_by_e",),
        """
import numpy as np


def knock(loudness, frequency, half_life, rate, count):
    if 2 * frequency >= rate:
        return np.zeros(int(count))
    t = np.arange(int(count)) / rate
    return loudness * np.exp(-t / half_life) * np.sin(2 * np.pi * frequency * t)
""",
    ),
    Wrong(
        "A.1",
        "Takes off the plain mean of the pieces' velocities instead of the mean weighted with the "
        "masses, so the momentum changes when masses differ.",
        ("nothing_taken_back",),
        """
import numpy as np


def split(velocity, masses, speed, heading):
    n = len(masses)
    angles = heading + 2 * np.pi * np.arange(n) / n
    apart = speed * np.column_stack((np.cos(angles), np.sin(angles)))
    apart = apart - apart.mean(axis=0)
    return velocity + apart
""",
    ),
    Wrong(
        "A.2",
        "Confuses frames: adds the muzzle speed to the ship's velocity before the shot, though it "
        "is meant relative to the ship that already recoils.",
        ("seen_from_before",),
        """
import math

import numpy as np


def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    barrel = np.array([math.cos(heading), math.sin(heading)])
    shot = velocity + muzzle_speed * barrel
    total = (ship_mass + shot_mass) * velocity
    ship = (total - shot_mass * shot) / ship_mass
    return ship, shot
""",
    ),
    Wrong(
        "A.3",
        "Stale values: computes every pair from the velocities at the start and adds up the "
        "changes, instead of from those that earlier pairs have left.",
        ("all_from_the_old_velocities",),
        """
import numpy as np


def collide_all(positions, velocities, masses, radii, restitution):
    result = np.array(velocities, dtype=float)
    n = len(masses)
    for i in range(n):
        for j in range(i + 1, n):
            d = positions[j] - positions[i]
            dist = np.linalg.norm(d)
            if dist == 0 or dist >= radii[i] + radii[j]:
                continue
            normal = d / dist
            closing = (velocities[i] - velocities[j]) @ normal
            if closing <= 0:
                continue
            J = (1 + restitution) * closing / (1 / masses[i] + 1 / masses[j])
            result[i] -= J / masses[i] * normal
            result[j] += J / masses[j] * normal
    return result
""",
    ),
    Wrong(
        "B.1",
        "Thinks of y as growing upwards, so finds the top wall at large y and the bottom wall at "
        "y = 0.",
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
        "Uses the distance from the infinite line through the bumper and checks only that the "
        "ball is beside the segment, so the round ends do not push.",
        ("nothing_at_the_ends",),
        """
import numpy as np

RADIUS = 12.0
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0


def bumper_contact(position):
    along = BUMPER_END - BUMPER_START
    length = np.linalg.norm(along)
    along = along / length
    s = (position - BUMPER_START) @ along
    if s < 0 or s > length:
        return None
    foot = BUMPER_START + s * along
    away = position - foot
    distance = np.linalg.norm(away)
    depth = RADIUS + BUMPER_HALF_THICKNESS - distance
    if depth <= 0:
        return None
    return away / distance, depth
""",
    ),
    Wrong(
        "B.5",
        "Slip: rounds the number of steps to the nearest whole number, so a rest of more than "
        "half a step becomes a step too many.",
        ("whole",),
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
    depths = {
        "top": RADIUS - y,
        "bottom": y + RADIUS - HEIGHT,
        "left": RADIUS - x,
        "right": x + RADIUS - WIDTH,
    }
    return [(name, NORMALS[name], d) for name, d in depths.items() if d > 0]


def bumper_contact(position):
    way = BUMPER_END - BUMPER_START
    part = (position - BUMPER_START) @ way / (way @ way)
    closest = BUMPER_START + min(max(part, 0.0), 1.0) * way
    away = position - closest
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
    position = position + velocity * dt
    hits = []
    contact = bumper_contact(position)
    if contact is not None:
        if velocity @ contact[0] < 0:
            hits.append("bumper")
        position, velocity = resolve(position, velocity, *contact)
    for name, normal, depth in wall_contacts(position):
        if velocity @ normal < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    return position, velocity, hits


def advance(position, velocity, elapsed):
    steps = int(round(elapsed / TIME_STEP))
    hits = []
    for _ in range(steps):
        position, velocity, new = step(position, velocity)
        hits.extend(new)
    return position, velocity, hits, max(0.0, elapsed - steps * TIME_STEP)
""",
    ),
    Wrong(
        "K.1",
        "Makes the sideways part of the velocity grow in proportion to the offset, instead of the "
        "angle.",
        ("sideways_by_the_offset",),
        """
import math

STEEPEST = math.radians(60)


def paddle_bounce(offset, speed):
    part = max(-1.0, min(1.0, offset))
    vx = speed * math.sin(STEEPEST) * part
    vy = math.sqrt(speed**2 - vx**2)
    return vx, vy
""",
    ),
    Wrong(
        "K.2",
        "Takes the brick grown by the radius for a plain rectangle with sharp corners, so a ball "
        "that passes near a corner hits too early or in thin air.",
        ("square_corners",),
        """
import numpy as np

HORIZON = 1.0


def brick_impact(position, velocity, radius, box):
    low = np.array([box[0] - radius, box[1] - radius])
    high = np.array([box[0] + box[2] + radius, box[1] + box[3] + radius])
    enter, leave = -np.inf, np.inf
    normal = np.zeros(2)
    for axis in (0, 1):
        if velocity[axis] == 0:
            if not low[axis] < position[axis] < high[axis]:
                return None
            continue
        t1 = (low[axis] - position[axis]) / velocity[axis]
        t2 = (high[axis] - position[axis]) / velocity[axis]
        if min(t1, t2) > enter:
            enter = min(t1, t2)
            normal = np.zeros(2)
            normal[axis] = -np.sign(velocity[axis])
        leave = min(leave, max(t1, t2))
    if enter >= leave or enter < 0 or enter > HORIZON:
        return None
    return enter, normal
""",
    ),
    Wrong(
        "C.1",
        "Slip: goes through the row once from left to right and stops, and does not return to "
        "pairs that approach again after that.",
        ("one_pass",),
        """
import numpy as np

SLOWEST = 1e-12


def collide_row(masses, velocities, restitution):
    v = velocities.astype(float).copy()
    for i in range(len(v) - 1):
        closing = v[i] - v[i + 1]
        if closing > SLOWEST:
            m, n = masses[i], masses[i + 1]
            j = (1 + restitution) * closing * m * n / (m + n)
            v[i] -= j / m
            v[i + 1] += j / n
    return v
""",
    ),
    Wrong(
        "C.3",
        "Forgotten case: lets neighbours swap their rates as soon as they approach, without "
        "asking whether they touch.",
        ("swaps_at_a_distance",),
        """
import numpy as np

GRAVITY = 9.81


def swing_step(angle, rate, length, dt):
    rate = rate - GRAVITY / length * np.sin(angle) * dt
    return angle + rate * dt, rate


def cradle(angles, rates, length, dt, steps):
    angles = np.array(angles, dtype=float)
    rates = np.array(rates, dtype=float)
    for _ in range(int(steps)):
        for n in range(len(angles)):
            angles[n], rates[n] = swing_step(angles[n], rates[n], length, dt)
        n = 0
        while n < len(rates) - 1:
            if rates[n] > rates[n + 1]:
                rates[n], rates[n + 1] = rates[n + 1], rates[n]
                n = 0
            else:
                n += 1
    return angles, rates
""",
    ),
    Wrong(
        "D.2",
        "Thinks that the centre has to be lifted by its whole height above the edge at the top, "
        "half the diagonal, and forgets that it begins at half the height.",
        (
            "ignored",
            "term",
        ),
        """
import math

GRAVITY = 9.81


def toppling_rate(width, height):
    diagonal = math.hypot(width, height)
    lift = diagonal / 2
    # 1/2 * (w^2 + h^2)/3 * rate^2 = g * lift
    return math.sqrt(6 * GRAVITY * lift) / diagonal
""",
    ),
    Wrong(
        "D.3",
        "Treats the touch as an elastic hit of equal bodies: the two dominoes swap their rates "
        "instead of going on together with the mean.",
        ("exchange_their_rates",),
        """
import math

import numpy as np

GRAVITY = 9.81


def chain(angles, rates, height, spacing, dt, steps):
    a = np.array(angles, float)
    w = np.array(rates, float)
    contact = math.asin(spacing / height)
    for _ in range(int(steps)):
        w += 1.5 * GRAVITY / height * np.sin(a) * dt
        a += w * dt
        for k in range(len(a) - 1):
            if a[k] > contact and w[k] > w[k + 1]:
                w[k], w[k + 1] = w[k + 1], w[k]
        lying = a > math.pi / 2
        a[lying] = math.pi / 2
        w[lying] = 0.0
    return a, w
""",
    ),
    Wrong(
        "P.1",
        "Adds the gap to the distance of the rows in full, instead of taking the height of a "
        "triangle whose sides already contain the gap.",
        ("whole_gap_between_rows",),
        """
import numpy as np


def rack(apex, radius, gap):
    side = 2 * radius + gap
    row_distance = 2 * radius * np.sqrt(3) / 2 + gap
    balls = []
    for row in range(5):
        x = apex[0] + row * row_distance
        for k in range(row + 1):
            balls.append([x, apex[1] + (k - row / 2) * side])
    return np.array(balls)
""",
    ),
    Wrong(
        "P.3",
        "Slip: changes the velocities at once, pair by pair, so later pairs of a round see them "
        "already changed and the break is not symmetric.",
        ("changed_within_the_round",),
        """
from itertools import combinations

import numpy as np

TOUCHING = 2.001
ROUNDS = 20


def share_impact(positions, velocities, radius, restitution):
    v = np.array(velocities, dtype=float)
    n = len(v)
    for _ in range(ROUNDS):
        count = np.zeros(n)
        active = []
        for i, j in combinations(range(n), 2):
            d = positions[j] - positions[i]
            dist = np.linalg.norm(d)
            if dist <= TOUCHING * radius and (v[i] - v[j]) @ d > 0:
                active.append((i, j, d / dist))
                count[i] += 1
                count[j] += 1
        for i, j, u in active:
            push = 0.5 * (1 + restitution) * ((v[i] - v[j]) @ u) / max(count[i], count[j])
            v[i] -= push * u
            v[j] += push * u
    return v
""",
    ),
    Wrong(
        "S.2",
        "Damps with the size of the whole relative velocity instead of its part along the spring, "
        "so turning also counts and the sign is lost.",
        ("damps_the_speed",),
        """
import numpy as np


def ring_forces(positions, velocities, length, stiffness, damping):
    n = len(positions)
    forces = np.zeros((n, 2))
    for i in range(n):
        j = (i + 1) % n
        d = positions[j] - positions[i]
        dist = np.linalg.norm(d)
        u = d / dist
        relative = np.linalg.norm(velocities[j] - velocities[i])
        pull = stiffness * (dist - length) + damping * relative
        forces[i] += pull * u
        forces[j] -= pull * u
    return forces
""",
    ),
    Wrong(
        "S.3",
        "Slip: multiplies by the pressure and the unit normal and forgets the length of the edge, "
        "which is 1 in the example.",
        ("edges_alike",),
        """
import numpy as np


def pressure_forces(positions, area, stiffness):
    x, y = positions[:, 0], positions[:, 1]
    xn, yn = np.roll(x, -1), np.roll(y, -1)
    now = 0.5 * np.sum(x * yn - xn * y)
    pressure = stiffness * (area / now - 1)
    edges = np.roll(positions, -1, axis=0) - positions
    lengths = np.sqrt((edges**2).sum(axis=1))
    outward = np.column_stack((edges[:, 1], -edges[:, 0])) / lengths[:, None]
    half = 0.5 * pressure * outward
    return half + np.roll(half, 1, axis=0)
""",
    ),
    Wrong(
        "S.4",
        "Wrong order of updates: moves the masses with the old velocity and changes the velocity "
        "only afterwards.",
        ("moves_by_the_old_velocity",),
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
    nxt = np.roll(positions, -1, axis=0)
    return 0.5 * np.sum(positions[:, 0] * nxt[:, 1] - positions[:, 1] * nxt[:, 0])


def ring_forces(positions, velocities, length, stiffness, damping):
    d = np.roll(positions, -1, axis=0) - positions
    dist = np.linalg.norm(d, axis=1)
    u = d / dist[:, None]
    dv = np.roll(velocities, -1, axis=0) - velocities
    pull = stiffness * (dist - length) + damping * np.sum(dv * u, axis=1)
    f = pull[:, None] * u
    return f - np.roll(f, 1, axis=0)


def pressure_forces(positions, area, stiffness):
    p = stiffness * (area / ring_area(positions) - 1)
    d = np.roll(positions, -1, axis=0) - positions
    f = 0.5 * p * np.column_stack((d[:, 1], -d[:, 0]))
    return f + np.roll(f, 1, axis=0)


def drop(positions, velocities, length, area, steps):
    x = np.array(positions, dtype=float)
    v = np.array(velocities, dtype=float)
    for _ in range(int(steps)):
        f = ring_forces(x, v, length, STIFFNESS, DAMPING) + pressure_forces(x, area, PRESSURE)
        x = x + v * TIME_STEP
        v = v + (f / MASS - AIR * v + np.array([0.0, -GRAVITY])) * TIME_STEP
        below = x[:, 1] < 0
        x[below, 1] = 0.0
        v[below, 1] = np.maximum(v[below, 1], 0.0)
        v[below, 0] *= GRIP
    return x, v
""",
    ),
)
