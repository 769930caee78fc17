"""Wrong answers as one who has marked many sheets expects them, a mistake each.

Whoever wrote them had seen the texts of the tasks only. When they were first tried, 71 of 75 were
explained, 70 of them rightly, and none earned full marks.
"""

from __future__ import annotations

from course.recognition.students import Wrong

ELEVENTH = (
    Wrong(
        "1.1",
        "Copies the factor (m1 - m2) into the second formula, where it should be (m2 - m1).",
        ("sign",),
        """
def elastic_1d(m1, v1, m2, v2):
    m = m1 + m2
    v1_new = ((m1 - m2) * v1 + 2 * m2 * v2) / m
    v2_new = ((m1 - m2) * v2 + 2 * m1 * v1) / m
    return v1_new, v2_new
""",
    ),
    Wrong(
        "1.2",
        "Takes body 2 to be at rest, as in the example in the schoolbook.",
        (
            "ignored",
            "term",
        ),
        """
def inelastic_1d(m1, v1, m2, v2):
    p = m1 * v1
    v = p / (m1 + m2)
    return (v, v)
""",
    ),
    Wrong(
        "1.3",
        "Takes the change of momentum of body 1, which is the impulse with the other sign.",
        ("impulse_on_the_first",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    v_cm = (m1 * v1 + m2 * v2) / (m1 + m2)
    v1_after = 2 * v_cm - v1
    # impulse = change of momentum
    return m1 * v1_after - m1 * v1
""",
    ),
    Wrong(
        "2.1",
        "Believes that the speeds always add, as when bodies meet head on and fly apart.",
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
        "Believes that both bodies come out with e times the elastic velocities.",
        ("scaled_elastic_velocities",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    e = restitution
    w1 = (m1 * v1 - m2 * v1 + 2 * m2 * v2) / (m1 + m2)
    w2 = (m2 * v2 - m1 * v2 + 2 * m1 * v1) / (m1 + m2)
    return e * w1, e * w2
""",
    ),
    Wrong(
        "2.3",
        "Believes that each height is e times the one before (that is true of the speeds).",
        ("speed_factor_for_height",),
        """
def bounce_heights(height, restitution, count):
    heights = []
    h = height
    for i in range(count):
        h = h * restitution
        heights.append(h)
    return heights
""",
    ),
    Wrong(
        "2.4",
        "Counts the way down only: forgets that each bounce goes up and down again.",
        ("forgets_the_way_up",),
        """
import math

def rest_time(height, restitution, gravity):
    # first fall t0, then t0*e, t0*e^2, ... geometric series
    t0 = math.sqrt(2 * height / gravity)
    return t0 / (1 - restitution)
""",
    ),
    Wrong(
        "3.1",
        "Takes the formula for a ray that points away from the mirror: 2 (n.I) n - I.",
        ("opposite_sign",),
        """
import numpy as np

def reflect(incident, normal):
    return 2 * np.dot(normal, incident) * normal - incident
""",
    ),
    Wrong(
        "3.2",
        "Takes the 2 of the mirror formula times e, where 1 + e belongs.",
        (
            "one_plus",
            "term",
        ),
        """
import numpy as np

def bounce(velocity, normal, restitution):
    vn = velocity @ normal
    if vn >= 0:
        return velocity
    return velocity - 2 * restitution * vn * normal
""",
    ),
    Wrong(
        "3.3",
        "Leaves a ball that moves out alone altogether: it is not moved out of the wall either.",
        ("gate_before_position",),
        """
import numpy as np

def resolve_wall(position, velocity, normal, depth, restitution):
    vn = np.dot(velocity, normal)
    if vn > 0:
        # already leaving, nothing to do
        return position, velocity
    new_position = position + depth * normal
    new_velocity = velocity - (1 + restitution) * vn * normal
    return new_position, new_velocity
""",
    ),
    Wrong(
        "4.1",
        "Forgets to divide the difference of the centres by its length.",
        ("not_normalised",),
        """
import math
import numpy as np

def circle_contact(p1, r1, p2, r2):
    dx = p2[0] - p1[0]
    dy = p2[1] - p1[1]
    dist = math.sqrt(dx * dx + dy * dy)
    if dist >= r1 + r2:
        return None
    depth = r1 + r2 - dist
    if dist == 0:
        return np.array([1.0, 0.0]), depth
    return np.array([dx, dy]), depth
""",
    ),
    Wrong(
        "4.2",
        "Loses the parts of the velocities along the tangent.",
        (
            "ignored",
            "parts",
        ),
        """
import numpy as np

def resolve_circles(v1, m1, v2, m2, normal, restitution):
    u1 = np.dot(v1, normal)
    u2 = np.dot(v2, normal)
    if u1 <= u2:
        return v1, v2
    # one-dimensional collision along the normal
    u = (m1 * u1 + m2 * u2) / (m1 + m2)
    w1 = u - restitution * m2 * (u1 - u2) / (m1 + m2)
    w2 = u + restitution * m1 * (u1 - u2) / (m1 + m2)
    return w1 * normal, w2 * normal
""",
    ),
    Wrong(
        "4.3",
        "Moves each of two free circles by half of the depth, whatever their masses.",
        ("half_each",),
        """
import math

def separate(p1, m1, p2, m2, normal, depth):
    if m1 == math.inf:
        return p1, p2 + depth * normal
    if m2 == math.inf:
        return p1 - depth * normal, p2
    return p1 - depth / 2 * normal, p2 + depth / 2 * normal
""",
    ),
    Wrong(
        "4.4",
        "Overwrites v1 before the relative velocity for v2 is worked out.",
        ("updated",),
        """
import numpy as np

def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    a = 1 / m1
    b = 1 / m2
    p1 = p1 - normal * depth * a / (a + b)
    p2 = p2 + normal * depth * b / (a + b)
    if (v2 - v1) @ normal < 0:
        v1 = v1 + (1 + restitution) * ((v2 - v1) @ normal) * a / (a + b) * normal
        v2 = v2 - (1 + restitution) * ((v2 - v1) @ normal) * b / (a + b) * normal
    return p1, v1, p2, v2
""",
    ),
    Wrong(
        "5.1",
        "Adds the term of the parallel axis theorem on the way to the centroid.",
        ("parallel_axis_added",),
        """
import numpy as np

def moment_of_inertia(mass, vertices):
    area2 = 0.0
    cx = cy = 0.0
    total = 0.0
    n = len(vertices)
    for i in range(n):
        x1, y1 = vertices[i]
        x2, y2 = vertices[(i + 1) % n]
        c = x1 * y2 - x2 * y1
        area2 += c
        cx += (x1 + x2) * c
        cy += (y1 + y2) * c
        total += c * (x1**2 + x1 * x2 + x2**2 + y1**2 + y1 * y2 + y2**2)
    cx = cx / (3 * area2)
    cy = cy / (3 * area2)
    about_origin = mass * total / (6 * area2)
    # Steiner: I = I0 + m d^2
    return about_origin + mass * (cx**2 + cy**2)
""",
    ),
    Wrong(
        "5.2",
        "Takes v = w r as a vector along r: the turning moves the point outward.",
        ("along_the_lever",),
        """
import numpy as np

def contact_velocity(v, w, r):
    # v_total = v + omega * r
    return np.array([v[0] + w * r[0], v[1] + w * r[1]])
""",
    ),
    Wrong(
        "5.3",
        "Takes the whole length of the lever, not the part of it across the direction.",
        ("full_distance",),
        """
import numpy as np

def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    k = 1 / m_a + 1 / m_b
    k += np.linalg.norm(r_a) ** 2 / i_a
    k += np.linalg.norm(r_b) ** 2 / i_b
    return k
""",
    ),
    Wrong(
        "5.4",
        "Believes that friction is always mu times the normal impulse.",
        ("always_at_the_limit",),
        """
def friction_impulse(vt, jn, friction, k):
    if vt > 0:
        return -friction * jn
    elif vt < 0:
        return friction * jn
    return 0.0
""",
    ),
    Wrong(
        "5.5",
        "Takes the sliding of the disc's centre: the spin has no part in it.",
        ("sliding_of_the_centre",),
        """
import numpy as np

def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    inertia = radius**2 / 2
    vn = velocity @ normal
    if vn >= 0:
        return velocity, w
    tangent = np.array([-normal[1], normal[0]])
    jn = -(1 + restitution) * vn
    vt = velocity @ tangent
    k = 1 + radius**2 / inertia
    jt = -vt / k
    jt = max(-friction * jn, min(friction * jn, jt))
    new_v = velocity + jn * normal + jt * tangent
    new_w = w - radius * jt / inertia
    return new_v, new_w
""",
    ),
    Wrong(
        "6.1",
        "Swaps x and y of the edge and forgets the minus sign.",
        (
            "sign",
            "upside_down",
        ),
        """
import numpy as np

def sat_axes(vertices):
    axes = []
    for i in range(len(vertices)):
        edge = vertices[(i + 1) % len(vertices)] - vertices[i]
        length = np.linalg.norm(edge)
        if length < 1e-12:
            continue
        axes.append(np.array([edge[1], edge[0]]) / length)
    return axes
""",
    ),
    Wrong(
        "6.2",
        "Begins the search for low and high at 0, so the shadow always reaches the origin.",
        ("starts_from_zero",),
        """
def project(vertices, axis):
    low = 0
    high = 0
    for v in vertices:
        d = v[0] * axis[0] + v[1] * axis[1]
        if d < low:
            low = d
        if d > high:
            high = d
    return low, high
""",
    ),
    Wrong(
        "6.3",
        "Takes the length of the common part, which is not the way out if one contains the other.",
        ("common_part",),
        """
def overlap(interval_a, interval_b):
    low = max(interval_a[0], interval_b[0])
    high = min(interval_a[1], interval_b[1])
    if high <= low:
        return None
    return high - low
""",
    ),
    Wrong(
        "6.4",
        "Tests the edges of polygon A only.",
        ("axes_of_a_only",),
        """
import numpy as np

def mtv(vertices_a, vertices_b):
    best = None
    for k in range(len(vertices_a)):
        edge = vertices_a[k] - vertices_a[k - 1]
        length = np.hypot(edge[0], edge[1])
        if length == 0:
            continue
        axis = np.array([edge[1], -edge[0]]) / length
        a = vertices_a @ axis
        b = vertices_b @ axis
        forward = a.max() - b.min()
        backward = b.max() - a.min()
        if forward <= 0 or backward <= 0:
            return None
        if best is None or forward < best[1]:
            best = (axis, forward)
        if backward < best[1]:
            best = (-axis, backward)
    return best
""",
    ),
    Wrong(
        "6.5",
        "Always gives the inner end first, so the direction turns round if the start is cut off.",
        ("cut_always_last",),
        """
def clip(start, end, normal, offset):
    d1 = start @ normal - offset
    d2 = end @ normal - offset
    if d1 <= 0 and d2 <= 0:
        return start, end
    if d1 > 0 and d2 > 0:
        return None
    cut = start + d1 / (d1 - d2) * (end - start)
    inside = start if d1 <= 0 else end
    return inside, cut
""",
    ),
    Wrong(
        "6.6",
        "Tests the faces only, as if the polygon grown by the radius had sharp corners.",
        ("edges_without_ends",),
        """
import numpy as np

def circle_against_polygon(centre, radius, vertices):
    best_distance = -np.inf
    best_normal = None
    n = len(vertices)
    for i in range(n):
        a = vertices[i]
        b = vertices[(i + 1) % n]
        e = b - a
        if not e.any():
            continue
        normal = np.array([e[1], -e[0]]) / np.linalg.norm(e)
        distance = (centre - a) @ normal
        if distance > best_distance:
            best_distance = distance
            best_normal = normal
    if best_distance >= radius:
        return None
    return best_normal, radius - best_distance
""",
    ),
    Wrong(
        "7.1",
        "Believes that the circles meet when their centres are closest.",
        ("nearest_approach_if_near_enough",),
        """
import math
import numpy as np

def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d = p2 - p1
    v = v2 - v1
    R = r1 + r2
    a = v @ v
    b = d @ v
    if b >= 0:
        return None          # parting, or the same velocity
    if d @ d <= R * R:
        return 0.0
    t = -b / a               # here the distance is least
    closest = d + v * t
    if closest @ closest > R * R:
        return None
    if t > dt:
        return None
    return t
""",
    ),
    Wrong(
        "7.2",
        "Lets a ball thrown up fall from where it was thrown, not from the top of its way.",
        ("falls_from_the_start",),
        """
import math

def time_to_floor(height, velocity, gravity):
    if velocity > 0:
        if gravity == 0:
            return None
        t_up = velocity / gravity
        t_down = math.sqrt(2 * height / gravity)
        return t_up + t_down
    if gravity == 0 and velocity == 0:
        return None
    root = math.sqrt(velocity**2 + 2 * gravity * height)
    return 2 * height / (root - velocity)
""",
    ),
    Wrong(
        "7.3",
        "Mirrors the way beyond the wall at its full length: only later steps are slower.",
        ("mirrors_the_rest",),
        """
import numpy as np

def advance(p, v, room, restitution, dt):
    p = np.array(p, dtype=float)
    v = np.array(v, dtype=float)
    p += v * dt
    for k in range(2):
        while p[k] < 0 or p[k] > room[k]:
            if p[k] < 0:
                p[k] = -p[k]
            else:
                p[k] = 2 * room[k] - p[k]
            v[k] = -restitution * v[k]
    return p, v
""",
    ),
    Wrong(
        "7.4",
        "Forgets that a negative time lies in the past: parting circles have met then.",
        (),
        """
import math
import numpy as np

def next_event(positions, velocities, radii):
    best = None
    n = len(radii)
    for i in range(n):
        for j in range(i + 1, n):
            d = positions[j] - positions[i]
            v = velocities[j] - velocities[i]
            a = v @ v
            b = d @ v
            c = d @ d - (radii[i] + radii[j]) ** 2
            if a == 0:
                continue
            if c <= 0:
                if b >= 0:
                    continue
                t = 0.0
            else:
                disc = b * b - a * c
                if disc < 0:
                    continue
                t = (-b - math.sqrt(disc)) / a
            if best is None or t < best[0]:
                best = (t, i, j)
    return best
""",
    ),
    Wrong(
        "7.5",
        "Stops counting when the outer block has turned round.",
        ("until_the_heavy_block_turns",),
        """
def pi_collisions(mass_ratio):
    M = mass_ratio
    V, v = -1.0, 0.0      # wall on the left
    count = 0
    while V < 0:
        # block hits block
        V, v = ((M - 1) * V + 2 * v) / (M + 1), (2 * M * V + (1 - M) * v) / (M + 1)
        count += 1
        # inner block hits the wall
        if v < 0:
            v = -v
            count += 1
    return count
""",
    ),
    Wrong(
        "8.1",
        "Takes the largest difference of a coordinate, not the largest distance.",
        ("the_larger_coordinate",),
        """
import numpy as np

def largest_error(places, right):
    return np.max(np.abs(places - right))
""",
    ),
    Wrong(
        "8.2",
        "Takes the second step to be half of the first.",
        ("as_if_halved",),
        """
import math

def observed_order(dt_1, error_1, dt_2, error_2):
    return math.log2(error_1 / error_2)
""",
    ),
    Wrong(
        "8.3",
        "Fits with the logarithm to base 10, and goes back with exp.",
        ("two_kinds_of_logarithm",),
        """
import numpy as np

def fit_power(steps, errors):
    x = np.log10(steps)
    y = np.log10(errors)
    p, shift = np.polyfit(x, y, 1)
    return p, np.exp(shift)
""",
    ),
    Wrong(
        "8.4",
        "Admits all rows that make no more sweeps than that.",
        ("at_most_so_many",),
        """
import math

def best_split(table, sweeps):
    best = None
    best_error = math.inf
    for substeps, iterations, error in table:
        if substeps * iterations <= sweeps and error < best_error:
            best_error = error
            best = (int(substeps), int(iterations))
    return best
""",
    ),
    Wrong(
        "8.5",
        "Gives the place among the good rows, not in the whole table.",
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
        "Adds the weights from the ground up, so the top box carries them all.",
        ("counted_from_the_floor",),
        """
import numpy as np

def tower_forces(masses, gravity):
    return np.cumsum(masses) * gravity
""",
    ),
    Wrong(
        "9.2",
        "Rounds the number of sweeps down.",
        ("rounded_down",),
        """
import math

def sweeps_needed(light, heavy, left):
    # (M/(M+m))^n = left  ->  n = ln(left) / ln(M/(M+m))
    n = math.log(left) / -math.log1p(light / heavy)
    return int(n)
""",
    ),
    Wrong(
        "9.3",
        "Lets friction always act in the negative direction, whichever way the tip slides.",
        ("always_to_the_left",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    # jt = -mu jn, so vn + (knn - mu knt) jn = 0
    k = knn - friction * knt
    if k <= 0:
        return None
    return -vn / k
""",
    ),
    Wrong(
        "9.4",
        "Believes that the energies add: the blow's own energy to the one before.",
        ("energies_add_up",),
        """
import numpy as np

def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    before = 0.5 * mass * (velocity @ velocity) + 0.5 * inertia * w**2
    dv = impulse / mass
    dw = (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    blow = 0.5 * mass * (dv @ dv) + 0.5 * inertia * dw**2
    return (before + blow) / before
""",
    ),
    Wrong(
        "9.5",
        "Believes that N balls, with N - 1 contacts, strike no more than N - 1 times.",
        ("one_strike_a_contact",),
        """
import numpy as np

def one_by_one(masses, velocities):
    v = np.array(velocities, dtype=float)
    m = masses
    for strike in range(len(v) - 1):
        approach = v[:-1] - v[1:]
        i = int(np.argmax(approach))
        if approach[i] < 1e-9:
            break
        J = 2 * m[i] * m[i + 1] / (m[i] + m[i + 1]) * approach[i]
        v[i] -= J / m[i]
        v[i + 1] += J / m[i + 1]
    return v
""",
    ),
    Wrong(
        "10.1",
        "Leaves out pairs of which either body is static, not only those of which both are.",
        ("floors_forgotten",),
        """
import math

def most_friction(inverse_masses, frictions):
    most = 0.0
    n = len(frictions)
    for i in range(n):
        for j in range(i + 1, n):
            if inverse_masses[i] == 0 or inverse_masses[j] == 0:
                continue
            mu = math.sqrt(frictions[i] * frictions[j])
            most = max(most, mu)
    return most
""",
    ),
    Wrong(
        "10.2",
        "Lets a static polygon call for rotation, too.",
        ("floors_turn",),
        """
import math
from itertools import combinations

def effects_called_for(bodies, gravity):
    effects = set()
    if any(g != 0 for g in gravity):
        effects.add("gravity")
    for a, b in combinations(bodies, 2):
        if a[0] == 0 and b[0] == 0:
            continue
        if min(a[2], b[2]) > 0:
            effects.add("restitution")
        if a[3] * b[3] > 0:
            effects.add("friction")
            effects.add("rotation")
    for body in bodies:
        # corners are hit off centre
        if body[1] > 0 or body[4] != 0:
            effects.add("rotation")
    return list(effects)
""",
    ),
    Wrong(
        "10.3",
        "Hands all the momentum to the lightest disc, not all the energy.",
        ("all_the_momentum",),
        """
import numpy as np

def fastest_way(masses, velocities, dt):
    speeds = np.linalg.norm(velocities, axis=1)
    total = np.sum(masses * speeds)
    return total / np.min(masses) * dt
""",
    ),
    Wrong(
        "10.4",
        "Takes in the turning point even if it is not reached during the flight.",
        ("turning_point_always",),
        """
import numpy as np

def box_of_flight(position, velocity, radius, gravity, duration):
    result = []
    for k in range(2):
        times = [0.0, duration]
        if gravity[k] != 0:
            times.append(-velocity[k] / gravity[k])
        places = [position[k] + velocity[k] * t + gravity[k] * t**2 / 2 for t in times]
        result.append(min(places) - radius)
        result.append(max(places) + radius)
    return tuple(result)
""",
    ),
    Wrong(
        "10.5",
        "Looks at the bodies a body touches itself, and not at those beyond.",
        ("only_neighbours",),
        """
def bodies_asleep(inverse_masses, still, touches):
    n = len(still)
    asleep = []
    for a in range(n):
        if inverse_masses[a] == 0 or not still[a]:
            continue
        ok = True
        for b in range(n):
            if touches[a, b] and inverse_masses[b] > 0 and not still[b]:
                ok = False
        if ok:
            asleep.append(a)
    return asleep
""",
    ),
    Wrong(
        "11.1",
        "Looks whether a corner of the later box lies in the earlier one.",
        ("corners_of_the_later_box",),
        """
def near_pairs(boxes):
    pairs = []
    for i in range(len(boxes)):
        left, right, low, high = boxes[i]
        for j in range(i + 1, len(boxes)):
            l, r, b, t = boxes[j]
            for x, y in [(l, b), (l, t), (r, b), (r, t)]:
                if left <= x <= right and low <= y <= high:
                    pairs.append((i, j))
                    break
    return pairs
""",
    ),
    Wrong(
        "11.2",
        "Takes the effective mass along the normal for the friction, too.",
        ("yields_alike_both_ways",),
        """
import numpy as np

def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]

def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    m_a, i_a, w_a = a[0], a[1], a[4]
    m_b, i_b, w_b = b[0], b[1], b[4]
    v_a = np.array(a[2:4], dtype=float)
    v_b = np.array(b[2:4], dtype=float)
    tangent = np.array([-normal[1], normal[0]])

    def sliding():
        at_a = v_a + w_a * np.array([-arm_a[1], arm_a[0]])
        at_b = v_b + w_b * np.array([-arm_b[1], arm_b[0]])
        return at_b - at_a

    vn = sliding() @ normal
    if vn >= 0:
        return v_a, w_a, v_b, w_b
    k = 1 / m_a + 1 / m_b + cross(arm_a, normal) ** 2 / i_a + cross(arm_b, normal) ** 2 / i_b
    jn = -(1 + restitution) * vn / k

    def push(j):
        nonlocal v_a, w_a, v_b, w_b
        v_a = v_a - j / m_a
        w_a = w_a - cross(arm_a, j) / i_a
        v_b = v_b + j / m_b
        w_b = w_b + cross(arm_b, j) / i_b

    push(jn * normal)
    jt = -(sliding() @ tangent) / k
    jt = min(max(jt, -friction * jn), friction * jn)
    push(jt * tangent)
    return v_a, w_a, v_b, w_b
""",
    ),
    Wrong(
        "11.3",
        "Lets the disc's centre reach the wall: forgets the radius there.",
        ("centres_at_the_walls",),
        """
import numpy as np

def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    x = np.array(positions, dtype=float)
    v = np.array(velocities, dtype=float)
    x = x + v * dt
    v = v + np.asarray(gravity) * dt
    n = len(x)
    for i in range(n):
        for j in range(i + 1, n):
            d = x[j] - x[i]
            dist = np.linalg.norm(d)
            depth = radii[i] + radii[j] - dist
            if depth <= 0:
                continue
            normal = d / dist
            wi, wj = 1 / masses[i], 1 / masses[j]
            vn = (v[j] - v[i]) @ normal
            if vn < 0:
                J = -(1 + restitution) * vn / (wi + wj)
                v[i] -= J * wi * normal
                v[j] += J * wj * normal
            x[i] -= depth * wi / (wi + wj) * normal
            x[j] += depth * wj / (wi + wj) * normal
    for i in range(n):
        for k in range(2):
            if x[i, k] < 0:
                x[i, k] = 0
                if v[i, k] < 0:
                    v[i, k] *= -restitution
            elif x[i, k] > room[k]:
                x[i, k] = room[k]
                if v[i, k] > 0:
                    v[i, k] *= -restitution
    return x, v
""",
    ),
    Wrong(
        "11.4",
        "Tests `pair in table` of an array, which is true as soon as one number matches.",
        ("one_number_in_the_column", "any_number_of_a_row"),
        """
import numpy as np

def touch_changes(before, now):
    before = np.array(before).reshape(-1, 2)
    now = np.array(now).reshape(-1, 2)
    begun = []
    for pair in now:
        if pair not in before:
            begun.append((int(pair[0]), int(pair[1])))
    parted = []
    for pair in before:
        if pair not in now:
            parted.append((int(pair[0]), int(pair[1])))
    return begun, parted
""",
    ),
    Wrong(
        "11.5",
        "Takes the half-life for the time constant of exp.",
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
        "Spreads the samples with linspace up to the end, so they lie too far apart.",
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
        "Takes the plain mean of the velocities away, without the masses.",
        ("nothing_taken_back",),
        """
import numpy as np

def split(velocity, masses, speed, heading):
    n = len(masses)
    angles = heading + 2 * np.pi * np.arange(n) / n
    pieces = speed * np.column_stack([np.cos(angles), np.sin(angles)])
    pieces = pieces - pieces.mean(axis=0)
    return pieces + velocity
""",
    ),
    Wrong(
        "A.2",
        "Takes the muzzle speed as seen from the ship before the shot.",
        ("seen_from_before",),
        """
import numpy as np

def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    direction = np.array([np.cos(heading), np.sin(heading)])
    shot = velocity + muzzle_speed * direction
    # momentum: (M + m) v = M ship + m shot
    ship = ((ship_mass + shot_mass) * velocity - shot_mass * shot) / ship_mass
    return ship, shot
""",
    ),
    Wrong(
        "A.3",
        "Works out every collision from the velocities at the beginning.",
        ("all_from_the_old_velocities",),
        """
import numpy as np

def collide_all(positions, velocities, masses, radii, restitution):
    new = np.array(velocities, dtype=float)
    n = len(masses)
    for i in range(n):
        for j in range(i + 1, n):
            d = positions[j] - positions[i]
            dist = np.linalg.norm(d)
            if dist == 0 or dist >= radii[i] + radii[j]:
                continue
            normal = d / dist
            vn = (velocities[j] - velocities[i]) @ normal
            if vn >= 0:
                continue
            J = -(1 + restitution) * vn / (1 / masses[i] + 1 / masses[j])
            new[i] -= J / masses[i] * normal
            new[j] += J / masses[j] * normal
    return new
""",
    ),
    Wrong(
        "B.1",
        "Takes y to point up, so top and bottom are exchanged.",
        ("y_points_upwards",),
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
    contacts = []
    if y + RADIUS > HEIGHT:
        contacts.append(("top", NORMALS["top"], y + RADIUS - HEIGHT))
    if y - RADIUS < 0:
        contacts.append(("bottom", NORMALS["bottom"], RADIUS - y))
    if x - RADIUS < 0:
        contacts.append(("left", NORMALS["left"], RADIUS - x))
    if x + RADIUS > WIDTH:
        contacts.append(("right", NORMALS["right"], x + RADIUS - WIDTH))
    return contacts
""",
    ),
    Wrong(
        "B.2",
        "Takes the closest point of the endless line, not of the segment.",
        ("endless_line",),
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


def bumper_contact(position):
    line = BUMPER_END - BUMPER_START
    t = np.dot(position - BUMPER_START, line) / np.dot(line, line)
    closest = BUMPER_START + t * line
    away = position - closest
    dist = np.linalg.norm(away)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return away / dist, depth
""",
    ),
    Wrong(
        "B.3",
        "Lets the restitution act on the whole velocity, along the wall too.",
        ("scales_the_tangent",),
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


def resolve(position, velocity, normal, depth):
    position = position + normal * depth
    vn = velocity @ normal
    if vn < 0:
        velocity = RESTITUTION * (velocity - 2 * vn * normal)
    return position, velocity
""",
    ),
    Wrong(
        "B.4",
        "Counts every contact as a hit, also when the ball is leaving already.",
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
    depths = {
        "top": RADIUS - y,
        "bottom": y + RADIUS - HEIGHT,
        "left": RADIUS - x,
        "right": x + RADIUS - WIDTH,
    }
    return [(name, NORMALS[name], d) for name, d in depths.items() if d > 0]


def bumper_contact(position):
    line = BUMPER_END - BUMPER_START
    t = (position - BUMPER_START) @ line / (line @ line)
    t = min(1.0, max(0.0, t))
    d = position - (BUMPER_START + t * line)
    dist = np.linalg.norm(d)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return d / dist, depth


def resolve(position, velocity, normal, depth):
    position = position + depth * normal
    vn = velocity @ normal
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position, velocity


def step(position, velocity, dt=TIME_STEP):
    hits = []
    position = position + velocity * dt
    bumper = bumper_contact(position)
    if bumper is not None:
        position, velocity = resolve(position, velocity, bumper[0], bumper[1])
        hits.append("bumper")
    for name, normal, depth in wall_contacts(position):
        position, velocity = resolve(position, velocity, normal, depth)
        hits.append(name)
    return position, velocity, hits
""",
    ),
    Wrong(
        "B.5",
        "Overwrites the list of hits in each step, so only the last step's remain.",
        ("last_steps_hits",),
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
    line = BUMPER_END - BUMPER_START
    t = (position - BUMPER_START) @ line / (line @ line)
    t = min(1.0, max(0.0, t))
    d = position - (BUMPER_START + t * line)
    dist = np.linalg.norm(d)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return d / dist, depth


def resolve(position, velocity, normal, depth):
    position = position + depth * normal
    vn = velocity @ normal
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position, velocity


def step(position, velocity, dt=TIME_STEP):
    hits = []
    position = position + velocity * dt
    bumper = bumper_contact(position)
    if bumper is not None:
        if velocity @ bumper[0] < 0:
            hits.append("bumper")
        position, velocity = resolve(position, velocity, *bumper)
    for name, normal, depth in wall_contacts(position):
        if velocity @ normal < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    return position, velocity, hits


def advance(position, velocity, elapsed):
    n = int(elapsed / TIME_STEP + 1e-9)
    hits = []
    for _ in range(n):
        position, velocity, hits = step(position, velocity)
    return position, velocity, hits, max(0.0, elapsed - n * TIME_STEP)
""",
    ),
    Wrong(
        "K.1",
        "Lets the sideways speed grow with the offset, not the angle.",
        ("sideways_by_the_offset",),
        """
import math

STEEPEST = math.radians(60)

def paddle_bounce(offset, speed):
    if offset > 1:
        offset = 1
    if offset < -1:
        offset = -1
    vx = offset * speed * math.sin(STEEPEST)
    vy = math.sqrt(speed**2 - vx**2)
    return vx, vy
""",
    ),
    Wrong(
        "K.2",
        "Takes the grown brick as a rectangle with sharp corners.",
        ("square_corners",),
        """
import numpy as np

HORIZON = 1.0

def brick_impact(position, velocity, radius, box):
    x, y, w, h = box
    low = [x - radius, y - radius]
    high = [x + w + radius, y + h + radius]
    t_in, t_out = -np.inf, np.inf
    normal = None
    for k in range(2):
        if velocity[k] == 0:
            if position[k] <= low[k] or position[k] >= high[k]:
                return None
            continue
        t1 = (low[k] - position[k]) / velocity[k]
        t2 = (high[k] - position[k]) / velocity[k]
        if t1 > t2:
            t1, t2 = t2, t1
        if t1 > t_in:
            t_in = t1
            normal = np.zeros(2)
            normal[k] = -np.sign(velocity[k])
        t_out = min(t_out, t2)
    if normal is None or t_in > t_out or t_in < 0 or t_in > HORIZON:
        return None
    return t_in, normal
""",
    ),
    Wrong(
        "K.3",
        "Reports the places in the list that is left, where the broken bricks are gone already.",
        ("places_among_those_left",),
        """
import math
import numpy as np

HORIZON = 1.0

def brick_impact(position, velocity, radius, box):
    x, y, w, h = box
    best = None
    # the four faces
    faces = [
        (0, x - radius, y, y + h, -1.0),
        (0, x + w + radius, y, y + h, 1.0),
        (1, y - radius, x, x + w, -1.0),
        (1, y + h + radius, x, x + w, 1.0),
    ]
    for k, place, low, high, sign in faces:
        if velocity[k] * sign >= 0:
            continue
        t = (place - position[k]) / velocity[k]
        along = position[1 - k] + t * velocity[1 - k]
        if t >= 0 and low <= along <= high and (best is None or t < best[0]):
            normal = np.zeros(2)
            normal[k] = sign
            best = (t, normal)
    # the four corners
    a = velocity @ velocity
    for corner in [(x, y), (x + w, y), (x, y + h), (x + w, y + h)]:
        d = position - np.array(corner)
        b = d @ velocity
        c = d @ d - radius**2
        disc = b * b - a * c
        if b >= 0 or disc < 0:
            continue
        t = (-b - math.sqrt(disc)) / a
        if t >= 0 and (best is None or t < best[0]):
            best = (t, (d + t * velocity) / radius)
    if best is None or best[0] > HORIZON:
        return None
    return best


def fly(position, velocity, radius, bricks, duration):
    left = list(bricks)
    broken = []
    time = duration
    while True:
        first = None
        for n, brick in enumerate(left):
            impact = brick_impact(position, velocity, radius, brick)
            if impact is None or impact[0] > time:
                continue
            if first is None or impact[0] < first[0]:
                first = (impact[0], impact[1], n)
        if first is None:
            break
        t, normal, n = first
        position = position + t * velocity
        velocity = velocity - 2 * (velocity @ normal) * normal
        time -= t
        broken.append(n)
        left.pop(n)
    return position + time * velocity, velocity, broken
""",
    ),
    Wrong(
        "C.1",
        "Goes along the row again and again, and does not go back to the leftmost pair each time.",
        ("sweep_after_sweep",),
        """
import numpy as np

SLOWEST = 1e-12

def collide_row(masses, velocities, restitution):
    v = np.array(velocities, dtype=float)
    busy = True
    while busy:
        busy = False
        for i in range(len(v) - 1):
            if v[i] - v[i + 1] > SLOWEST:
                m1, m2 = masses[i], masses[i + 1]
                J = (1 + restitution) * (v[i] - v[i + 1]) * m1 * m2 / (m1 + m2)
                v[i] -= J / m1
                v[i + 1] += J / m2
                busy = True
    return v
""",
    ),
    Wrong(
        "C.2",
        "Takes the angle for its sine, as the schoolbook does for small ones.",
        ("small_angles",),
        """
GRAVITY = 9.81

def swing_step(angle, rate, length, dt):
    rate = rate - GRAVITY / length * angle * dt
    angle = angle + rate * dt
    return angle, rate
""",
    ),
    Wrong(
        "C.3",
        "Goes through the pairs once in a step, from left to right, and not until none approaches.",
        ("one_pass_a_step",),
        """
import numpy as np

GRAVITY = 9.81

def cradle(angles, rates, length, dt, steps):
    a = np.array(angles, dtype=float)
    r = np.array(rates, dtype=float)
    for _ in range(int(steps)):
        r = r - GRAVITY / length * np.sin(a) * dt
        a = a + r * dt
        for i in range(len(a) - 1):
            if a[i] >= a[i + 1] and r[i] > r[i + 1]:
                r[i], r[i + 1] = r[i + 1], r[i]
    return a, r
""",
    ),
    Wrong(
        "D.1",
        "Takes the angle from the floor: height over width.",
        ("upside_down",),
        """
import math

def tipping_angle(width, height):
    return math.atan(height / width)
""",
    ),
    Wrong(
        "D.2",
        "Lifts the centre by the whole of diagonal minus height, not by half of it.",
        ("whole_diagonal",),
        """
import math

GRAVITY = 9.81

def toppling_rate(width, height):
    diagonal = math.sqrt(width**2 + height**2)
    lift = diagonal - height
    # 1/2 I w^2 = m g lift, the mass drops out
    inertia = (width**2 + height**2) / 3
    return math.sqrt(2 * GRAVITY * lift / inertia)
""",
    ),
    Wrong(
        "D.3",
        "Turns each domino by its old rate.",
        ("grows_by_the_old_rate",),
        """
import math
import numpy as np

GRAVITY = 9.81

def chain(angles, rates, height, spacing, dt, steps):
    a = [float(x) for x in angles]
    r = [float(x) for x in rates]
    n = len(a)
    touch = math.asin(spacing / height)
    for s in range(int(steps)):
        for i in range(n):
            pull = 3 * GRAVITY / (2 * height) * math.sin(a[i])
            a[i] += r[i] * dt
            r[i] += pull * dt
        for i in range(n - 1):
            if a[i] > touch and r[i] > r[i + 1]:
                mean = (r[i] + r[i + 1]) / 2
                r[i] = mean
                r[i + 1] = mean
        for i in range(n):
            if a[i] > math.pi / 2:
                a[i] = math.pi / 2
                r[i] = 0.0
    return np.array(a), np.array(r)
""",
    ),
    Wrong(
        "P.1",
        "Adds the whole gap to the way from row to row, where it is a part of a slanted side.",
        ("whole_gap_between_rows",),
        """
import math
import numpy as np

def rack(apex, radius, gap):
    balls = []
    for row in range(5):
        x = apex[0] + row * (math.sqrt(3) * radius + gap)
        for k in range(row + 1):
            y = apex[1] + (k - row / 2) * (2 * radius + gap)
            balls.append([x, y])
    return np.array(balls)
""",
    ),
    Wrong(
        "P.2",
        "Believes that an off-centre hit pushes less: only the part towards the centre counts.",
        ("spin_takes_a_part",),
        """
import math
import numpy as np

def strike(impulse, offset, mass, radius):
    inertia = 2 / 5 * mass * radius**2
    size = math.hypot(impulse[0], impulse[1])
    towards_centre = math.sqrt(1 - (offset / radius) ** 2)
    velocity = impulse / mass * towards_centre
    spin = -offset * size / inertia
    return velocity, spin
""",
    ),
    Wrong(
        "P.3",
        "Divides the impulse for each ball by that ball's own count.",
        ("each_by_its_own_count",),
        """
import numpy as np

TOUCHING = 2.001
ROUNDS = 20

def share_impact(positions, velocities, radius, restitution):
    v = np.array(velocities, dtype=float)
    n = len(v)
    for r in range(ROUNDS):
        pairs = []
        count = np.zeros(n)
        for i in range(n):
            for j in range(i + 1, n):
                d = positions[j] - positions[i]
                dist = np.linalg.norm(d)
                if dist > TOUCHING * radius:
                    continue
                normal = d / dist
                vn = (v[j] - v[i]) @ normal
                if vn < 0:
                    pairs.append((i, j, normal, vn))
                    count[i] += 1
                    count[j] += 1
        change = np.zeros((n, 2))
        for i, j, normal, vn in pairs:
            dv = -(1 + restitution) * vn / 2 * normal
            change[i] -= dv / count[i]
            change[j] += dv / count[j]
        v = v + change
    return v
""",
    ),
    Wrong(
        "S.1",
        "Forgets the edge from the last mass back to the first.",
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
        "S.2",
        "Damps the whole relative velocity, not the part of it along the spring.",
        ("damps_across_the_springs",),
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
        f = stiffness * (dist - length) * u + damping * (velocities[j] - velocities[i])
        forces[i] += f
        forces[j] -= f
    return forces
""",
    ),
    Wrong(
        "S.3",
        "Makes the normals unit vectors and forgets the length of the edges.",
        ("edges_alike",),
        """
import numpy as np

def pressure_forces(positions, area, stiffness):
    nxt = np.roll(positions, -1, axis=0)
    area_now = 0.5 * np.sum(positions[:, 0] * nxt[:, 1] - positions[:, 1] * nxt[:, 0])
    p = stiffness * (area / area_now - 1)
    edges = nxt - positions
    normals = np.column_stack([edges[:, 1], -edges[:, 0]])
    normals = normals / np.linalg.norm(normals, axis=1)[:, None]
    half = p * normals / 2
    return half + np.roll(half, 1, axis=0)
""",
    ),
    Wrong(
        "S.4",
        "Takes AIR v for a force and divides it by the mass.",
        ("air_as_a_force",),
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
    size = stiffness * (dist - length) + damping * np.sum(dv * u, axis=1)
    pull = size[:, None] * u
    return pull - np.roll(pull, 1, axis=0)


def pressure_forces(positions, area, stiffness):
    p = stiffness * (area / ring_area(positions) - 1)
    e = np.roll(positions, -1, axis=0) - positions
    half = 0.5 * p * np.column_stack([e[:, 1], -e[:, 0]])
    return half + np.roll(half, 1, axis=0)


def drop(positions, velocities, length, area, steps):
    x = np.array(positions, dtype=float)
    v = np.array(velocities, dtype=float)
    g = np.array([0.0, -GRAVITY])
    for _ in range(int(steps)):
        F = ring_forces(x, v, length, STIFFNESS, DAMPING) + pressure_forces(x, area, PRESSURE)
        F = F - AIR * v
        v = v + (F / MASS + g) * TIME_STEP
        x = x + v * TIME_STEP
        for i in range(len(x)):
            if x[i, 1] < 0:
                x[i, 1] = 0.0
                v[i, 1] = max(v[i, 1], 0.0)
                v[i, 0] *= GRIP
    return x, v
""",
    ),
)
