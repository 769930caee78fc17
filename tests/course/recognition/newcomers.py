"""Wrong answers of all chapters and programs, written from the texts of the tasks alone.

The author of FIRST and SECOND had not read the wrong models, that of THIRD and FOURTH those of some
chapters. Before models and slips were improved with the answers
at hand, 34 of 39 in FIRST were recognised, 14 of 20 in SECOND, 14 of 19 in THIRD and 15 of 20 in
FOURTH, each written before the improvements that came of the one before it; none was explained
falsely but one in FOURTH. (Two more earned full marks: the checks of 11.1 and B.5 were mended.)
"""

from __future__ import annotations

from course.recognition.students import Wrong

FIRST = (
    Wrong(
        "1.1",
        "the velocity of the centre of mass taken once, not twice",
        ("factor",),
        """
def elastic_1d(m1, v1, m2, v2):
    common = (m1 * v1 + m2 * v2) / (m1 + m2)
    return common - v1, common - v2
""",
    ),
    Wrong(
        "1.2",
        "divided by the product of the masses, not by their sum",
        ("product",),
        """
def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 * m2)
    return v, v
""",
    ),
    Wrong(
        "1.3",
        "the change of the velocity of body 2, without its mass",
        ("factor_missing",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    after = (2 * m1 * v1 + (m2 - m1) * v2) / (m1 + m2)
    return after - v2
""",
    ),
    Wrong(
        "2.1",
        "the kinetic energies, without masses, instead of the velocities",
        ("energies_without_masses",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    return (v1_after**2 + v2_after**2) / (v1**2 + v2**2)
""",
    ),
    Wrong(
        "2.2",
        "the separation is halved between both, whatever their masses",
        ("half_the_separation_each",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    common = (m1 * v1 + m2 * v2) / (m1 + m2)
    apart = restitution * (v1 - v2)
    return common - apart / 2, common + apart / 2
""",
    ),
    Wrong(
        "2.4",
        "a bounce takes the time up only, not up and down",
        ("forgets_the_way_up",),
        """
import math

def rest_time(height, restitution, gravity):
    first = math.sqrt(2 * height / gravity)
    total = first
    flight = first
    for bounce in range(3000):
        flight *= restitution
        total += flight
    return total
""",
    ),
    Wrong(
        "3.2",
        "restitution shrinks the whole velocity, not the part along the normal",
        ("scales_the_tangent",),
        """
def bounce(velocity, normal, restitution):
    along = velocity[0] * normal[0] + velocity[1] * normal[1]
    if along >= 0:
        return velocity
    mirrored = velocity - 2 * along * normal
    speed = (mirrored[0] ** 2 + mirrored[1] ** 2) ** 0.5
    return restitution * speed * mirrored / speed
""",
    ),
    Wrong(
        "3.3",
        "moved back along the path of the ball, not along the normal",
        ("back_along_the_path",),
        """
import numpy as np

def resolve_wall(position, velocity, normal, depth, restitution):
    along = np.dot(velocity, normal)
    back = -velocity / np.linalg.norm(velocity)
    position = position + depth * back
    if along < 0:
        velocity = velocity - (1 + restitution) * along * normal
    return position, velocity
""",
    ),
    Wrong(
        "4.1",
        "the depth of one circle's centre: only the first radius counts",
        (
            "ignored",
            "term",
        ),
        """
import numpy as np

def circle_contact(p1, r1, p2, r2):
    between = p2 - p1
    distance = np.hypot(*between)
    if distance >= r1 + r2:
        return None
    if distance == 0:
        return np.array([1.0, 0.0]), r1
    return between / distance, r1 - distance
""",
    ),
    Wrong(
        "4.2",
        "each changes by the impulse, not by impulse over mass",
        ("divisor",),
        """
import numpy as np

def resolve_circles(v1, m1, v2, m2, normal, restitution):
    approach = np.dot(v1 - v2, normal)
    if approach <= 0:
        return v1, v2
    j = (1 + restitution) * approach / (1 / m1 + 1 / m2)
    return v1 - j * normal, v2 + j * normal
""",
    ),
    Wrong(
        "4.4",
        "no condition: circles that part bounce, too",
        ("bounces_when_separating",),
        """
import numpy as np

def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    w1, w2 = 1 / m1, 1 / m2
    p1n = p1 - depth * w1 / (w1 + w2) * normal
    p2n = p2 + depth * w2 / (w1 + w2) * normal
    approach = np.dot(v1 - v2, normal)
    j = (1 + restitution) * approach / (w1 + w2)
    return p1n, v1 - j * w1 * normal, p2n, v2 + j * w2 * normal
""",
    ),
    Wrong(
        "5.1",
        "about the mean of the vertices, not about the centroid",
        ("average_of_the_vertices",),
        """
import numpy as np

def moment_of_inertia(mass, vertices):
    points = np.asarray(vertices) - np.mean(vertices, axis=0)
    total, area = 0.0, 0.0
    for k in range(len(points)):
        a, b = points[k], points[(k + 1) % len(points)]
        c = a[0] * b[1] - a[1] * b[0]
        area += c / 2
        total += c * (a @ a + a @ b + b @ b) / 12
    return mass * total / area
""",
    ),
    Wrong(
        "5.3",
        "the whole lever instead of its arm across the direction",
        ("full_distance",),
        """
import numpy as np

def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    return 1 / m_a + 1 / m_b + np.dot(r_a, r_a) / i_a + np.dot(r_b, r_b) / i_b
""",
    ),
    Wrong(
        "5.5",
        "the sliding is stopped as if the disc did not turn: k = 1 instead of 3",
        ("rim_as_heavy_as_the_disc",),
        """
import numpy as np

def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    vn = np.dot(velocity, normal)
    if vn >= 0:
        return velocity, w
    jn = -(1 + restitution) * vn
    tangent = np.array([-normal[1], normal[0]])
    r = -radius * normal
    point = velocity + w * np.array([-r[1], r[0]])
    vt = np.dot(point, tangent)
    jt = max(-friction * jn, min(friction * jn, -vt))
    velocity = velocity + jn * normal + jt * tangent
    w = w + (r[0] * tangent[1] - r[1] * tangent[0]) * jt / (radius**2 / 2)
    return velocity, w
""",
    ),
    Wrong(
        "6.3",
        "what they share, not the way out of one that holds the other",
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
        "6.5",
        "the cut is sought with the distances' sum, not their difference",
        ("sign",),
        """
import numpy as np

def clip(start, end, normal, offset):
    ds = np.dot(start, normal) - offset
    de = np.dot(end, normal) - offset
    if ds > 0 and de > 0:
        return None
    if ds <= 0 and de <= 0:
        return start, end
    cut = start + ds / (ds + de) * (end - start)
    return (cut, end) if ds > 0 else (start, cut)
""",
    ),
    Wrong(
        "6.6",
        "only edges are looked at, never the corners",
        ("edges_without_ends",),
        """
import numpy as np

def circle_against_polygon(centre, radius, vertices):
    best, best_normal = -1e9, None
    for i in range(len(vertices)):
        a, b = vertices[i], vertices[(i + 1) % len(vertices)]
        edge = b - a
        n = np.array([edge[1], -edge[0]]) / np.hypot(*edge)
        s = np.dot(centre - a, n)
        if s > best:
            best, best_normal = s, n
    if best >= radius:
        return None
    return best_normal, radius - best
""",
    ),
    Wrong(
        "7.1",
        "the centres meet: the radii are not taken off",
        ("as_if_head_on",),
        """
import numpy as np

def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    p, v = p2 - p1, v2 - v1
    b = np.dot(p, v)
    if b >= 0:
        return None
    distance = np.hypot(*p)
    if distance <= r1 + r2:
        return 0.0
    t = (distance - r1 - r2) / np.hypot(*v)
    miss = abs(p[0] * v[1] - p[1] * v[0]) / np.hypot(*v)
    if miss > r1 + r2 or t > dt:
        return None
    return t
""",
    ),
    Wrong(
        "7.3",
        "after the first wall no other is looked for",
        ("one_impact_a_step",),
        """
import numpy as np

def advance(p, v, room, restitution, dt):
    p, v = np.array(p, float), np.array(v, float)
    times = [((room[k] if v[k] > 0 else 0.0) - p[k]) / v[k] for k in range(2)]
    k = int(np.argmin(times))
    if times[k] >= dt:
        return p + v * dt, v
    p = p + v * times[k]
    v[k] *= -restitution
    return p + v * (dt - times[k]), v
""",
    ),
    Wrong(
        "7.5",
        "the collisions with the wall are not counted",
        ("walls_not_counted",),
        """
def pi_collisions(mass_ratio):
    m, a, b, n = mass_ratio, -1.0, 0.0, 0
    while True:
        if a < b:
            a, b = ((m - 1) * a + 2 * b) / (m + 1), ((1 - m) * b + 2 * m * a) / (m + 1)
            n += 1
        elif b < 0:
            b = -b
        else:
            return n
""",
    ),
    Wrong(
        "8.1",
        "the largest error of a coordinate, not of the distance",
        ("the_larger_coordinate",),
        """
import numpy as np

def largest_error(places, right):
    return float(np.abs(places - right).max())
""",
    ),
    Wrong(
        "8.3",
        "C read off without exp",
        ("logarithm_of_the_factor",),
        """
import numpy as np

def fit_power(steps, errors):
    slope, shift = np.polyfit(np.log(steps), np.log(errors), 1)
    return slope, shift
""",
    ),
    Wrong(
        "8.5",
        "the row with the least error of those good enough, not the fastest",
        ("the_most_accurate",),
        """
def cheapest(table, allowed):
    best = None
    for row, (milliseconds, error) in enumerate(table):
        if error <= allowed and (best is None or error < table[best][1]):
            best = row
    return best
""",
    ),
    Wrong(
        "9.1",
        "the weights below a box are added up, not those above it",
        ("counted_from_the_floor",),
        """
import numpy as np

def tower_forces(masses, gravity):
    return np.cumsum(masses) * gravity
""",
    ),
    Wrong(
        "9.3",
        "friction helps: its sign is that of the sliding",
        ("friction_drives",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    side = 1 if vt > 0 else -1
    denominator = knn + knt * friction * side
    if denominator <= 0:
        return None
    return -vn / denominator
""",
    ),
    Wrong(
        "9.4",
        "the spin after the blow forgets the moment of inertia",
        ("divisor",),
        """
import numpy as np

def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    before = mass * np.dot(velocity, velocity) / 2 + inertia * w**2 / 2
    v = velocity + impulse / mass
    w = w + (arm[0] * impulse[1] - arm[1] * impulse[0])
    return (mass * np.dot(v, v) / 2 + inertia * w**2 / 2) / before
""",
    ),
    Wrong(
        "10.1",
        "static pairs are counted, too",
        ("static_pairs_count",),
        """
def most_friction(inverse_masses, frictions):
    best = 0.0
    for i in range(len(frictions)):
        for j in range(i + 1, len(frictions)):
            best = max(best, (frictions[i] * frictions[j]) ** 0.5)
    return best
""",
    ),
    Wrong(
        "10.3",
        "the heaviest disc may have all the energy, not the lightest",
        ("heaviest_is_fastest",),
        """
import numpy as np

def fastest_way(masses, velocities, dt):
    energy = 0.5 * (masses * (velocities**2).sum(axis=1)).sum()
    return np.sqrt(2 * energy / masses.max()) * dt
""",
    ),
    Wrong(
        "10.4",
        "only the two ends of the flight, not its turning point",
        ("only_the_ends",),
        """
import numpy as np

def box_of_flight(position, velocity, radius, gravity, duration):
    end = position + velocity * duration + gravity * duration**2 / 2
    low = np.minimum(position, end) - radius
    high = np.maximum(position, end) + radius
    return low[0], high[0], low[1], high[1]
""",
    ),
    Wrong(
        "11.1",
        "boxes that only touch are left out",
        ("touching_is_apart",),
        """
def near_pairs(boxes):
    pairs = []
    for i, (l1, r1, b1, t1) in enumerate(boxes):
        for j, (l2, r2, b2, t2) in enumerate(boxes):
            if i < j and l1 < r2 and l2 < r1 and b1 < t2 and b2 < t1:
                pairs.append((i, j))
    return pairs
""",
    ),
    Wrong(
        "11.2",
        "friction sees the sliding from before the normal impulse",
        ("sliding_before_the_blow",),
        """
import numpy as np

def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]

def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, va, wa = a[0], a[1], np.array(a[2:4]), a[4]
    mb, ib, vb, wb = b[0], b[1], np.array(b[2:4]), b[4]
    t = np.array([-normal[1], normal[0]])
    rel = (vb + wb * np.array([-arm_b[1], arm_b[0]])) - (va + wa * np.array([-arm_a[1], arm_a[0]]))
    vn = np.dot(rel, normal)
    if vn >= 0:
        return va, wa, vb, wb

    def k(d):
        return 1 / ma + 1 / mb + cross(arm_a, d) ** 2 / ia + cross(arm_b, d) ** 2 / ib

    jn = -(1 + restitution) * vn / k(normal)
    jt = -np.dot(rel, t) / k(t)
    jt = max(-friction * jn, min(jt, friction * jn))
    p = jn * normal + jt * t
    return va - p / ma, wa - cross(arm_a, p) / ia, vb + p / mb, wb + cross(arm_b, p) / ib
""",
    ),
    Wrong(
        "A.1",
        "the mean velocity is taken off, not weighed by the masses",
        ("nothing_taken_back",),
        """
import numpy as np

def split(velocity, masses, speed, heading):
    n = len(masses)
    angles = heading + 2 * np.pi * np.arange(n) / n
    out = speed * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    out = out - out.mean(axis=0)
    return out + velocity
""",
    ),
    Wrong(
        "A.2",
        "the muzzle speed is that seen before the shot",
        ("seen_from_before",),
        """
import numpy as np

def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    direction = np.array([np.cos(heading), np.sin(heading)])
    shot = velocity + muzzle_speed * direction
    ship = velocity - shot_mass * muzzle_speed / ship_mass * direction
    return ship, shot
""",
    ),
    Wrong(
        "B.2",
        "the line is endless: no round ends",
        ("endless_line",),
        """
def bumper_contact(position):
    along = BUMPER_END - BUMPER_START
    t = np.dot(position - BUMPER_START, along) / np.dot(along, along)
    closest = BUMPER_START + t * along
    away = position - closest
    distance = np.hypot(away[0], away[1])
    depth = RADIUS + BUMPER_HALF_THICKNESS - distance
    if depth <= 0:
        return None
    return away / distance, depth
""",
    ),
    Wrong(
        "K.1",
        "sine and cosine change places: the angle is taken from the paddle",
        ("angle_from_the_horizontal",),
        """
def paddle_bounce(offset, speed):
    offset = max(-1.0, min(1.0, offset))
    angle = offset * STEEPEST
    return speed * math.cos(angle), speed * math.sin(angle)
""",
    ),
    Wrong(
        "C.2",
        "the angle moves by the old rate",
        ("old_rate",),
        """
import math

def swing_step(angle, rate, length, dt):
    new_rate = rate - GRAVITY / length * math.sin(angle) * dt
    return angle + rate * dt, new_rate
""",
    ),
    Wrong(
        "D.2",
        "about the centre: a twelfth, not a third",
        ("about_the_centre",),
        """
def toppling_rate(width, height):
    diagonal = math.hypot(width, height)
    lift = diagonal / 2 - height / 2
    inertia = (width**2 + height**2) / 12
    return math.sqrt(2 * GRAVITY * lift / inertia)
""",
    ),
    Wrong(
        "P.1",
        "the rows are 2 r apart, not 2 r cos 30",
        ("square_rows",),
        """
def rack(apex, radius, gap):
    spacing = 2 * radius + gap
    balls = []
    for row in range(ROWS):
        for k in range(row + 1):
            balls.append([apex[0] + row * spacing, apex[1] + (k - row / 2) * spacing])
    return np.array(balls)
""",
    ),
    Wrong(
        "P.2",
        "the moment of inertia of a disc, 1/2 m r^2",
        ("a_disc",),
        """
def strike(impulse, offset, mass, radius):
    velocity = np.array(impulse) / mass
    spin = -offset * np.hypot(impulse[0], impulse[1]) / (0.5 * mass * radius**2)
    return velocity, spin
""",
    ),
    Wrong(
        "S.3",
        "each mass gets the whole force of its edges, not half",
        ("whole_force_at_each_end",),
        """
def pressure_forces(positions, area, stiffness):
    now = 0.0
    n = len(positions)
    for i in range(n):
        x1, y1 = positions[i]
        x2, y2 = positions[(i + 1) % n]
        now += (x1 * y2 - x2 * y1) / 2
    pressure = stiffness * (area / now - 1)
    forces = np.zeros((n, 2))
    for i in range(n):
        j = (i + 1) % n
        edge = positions[j] - positions[i]
        push = pressure * np.array([edge[1], -edge[0]])
        forces[i] += push
        forces[j] += push
    return forces
""",
    ),
)

SECOND = (
    Wrong(
        "1.1",
        "the approach is taken for body 2's velocity after",
        ("separation_as_velocity",),
        """
def elastic_1d(m1, v1, m2, v2):
    after2 = v1 - v2
    after1 = (m1 * v1 + m2 * v2 - m2 * after2) / m1
    return after1, after2
""",
    ),
    Wrong(
        "2.3",
        "every height from the first drop: e^2 n h instead of e^(2n) h",
        ("power",),
        """
def bounce_heights(height, restitution, count):
    return [height * restitution**2 * n for n in range(1, count + 1)]
""",
    ),
    Wrong(
        "3.1",
        "the turned velocity: mirrored at the normal's line, not at the wall",
        ("opposite_sign",),
        """
import math

def reflect(incident, normal):
    a = math.atan2(normal[1], normal[0])
    b = math.atan2(incident[1], incident[0])
    speed = math.hypot(incident[0], incident[1])
    out = 2 * a - b
    return [speed * math.cos(out), speed * math.sin(out)]
""",
    ),
    Wrong(
        "4.3",
        "both move half of the depth, except a fixed one",
        ("half_each",),
        """
import math

def separate(p1, m1, p2, m2, normal, depth):
    if math.isinf(m1):
        return p1, p2 + depth * normal
    if math.isinf(m2):
        return p1 - depth * normal, p2
    return p1 - depth / 2 * normal, p2 + depth / 2 * normal
""",
    ),
    Wrong(
        "5.4",
        "friction is always at its limit, against the sliding",
        ("always_at_the_limit",),
        """
def friction_impulse(vt, jn, friction, k):
    if vt == 0:
        return 0.0
    return -friction * jn * vt / abs(vt)
""",
    ),
    Wrong(
        "6.4",
        "the normal is left as the axis comes: not turned from A to B",
        ("sign",),
        """
import numpy as np

def mtv(vertices_a, vertices_b):
    best = None
    for vs in (vertices_a, vertices_b):
        for i in range(len(vs)):
            e = vs[(i + 1) % len(vs)] - vs[i]
            if not e.any():
                continue
            n = np.array([e[1], -e[0]]) / np.hypot(*e)
            pa, pb = vertices_a @ n, vertices_b @ n
            d = min(pa.max() - pb.min(), pb.max() - pa.min())
            if d <= 0:
                return None
            if best is None or d < best[1]:
                best = n, d
    return best
""",
    ),
    Wrong(
        "7.2",
        "half of g is forgotten: h + v t = g t^2",
        ("half_forgotten",),
        """
import math

def time_to_floor(height, velocity, gravity):
    if gravity == 0:
        return -height / velocity if velocity < 0 else None
    root = math.sqrt(velocity**2 + 4 * gravity * height)
    if velocity > 0:
        return (velocity + root) / (2 * gravity)
    if height == 0:
        return 0.0
    return 2 * height / (root - velocity)
""",
    ),
    Wrong(
        "8.2",
        "the ratio of the errors over the ratio of the steps, without logarithms",
        ("ratio_of_ratios",),
        """
def observed_order(dt_1, error_1, dt_2, error_2):
    return (error_1 / error_2) / (dt_1 / dt_2)
""",
    ),
    Wrong(
        "9.2",
        "the number is rounded down",
        ("rounded_down",),
        """
import math

def sweeps_needed(light, heavy, left):
    return int(math.log(left) / -math.log1p(light / heavy))
""",
    ),
    Wrong(
        "9.5",
        "the pair that is leftmost strikes first, not the fastest",
        ("leftmost_first",),
        """
def one_by_one(masses, velocities):
    v = list(velocities)
    moved = True
    while moved:
        moved = False
        for i in range(len(v) - 1):
            if v[i] - v[i + 1] > 1e-9:
                m, n = masses[i], masses[i + 1]
                c = (m * v[i] + n * v[i + 1]) / (m + n)
                v[i], v[i + 1] = 2 * c - v[i], 2 * c - v[i + 1]
                moved = True
                break
    return v
""",
    ),
    Wrong(
        "10.5",
        "each body for itself: what touches it is not asked",
        ("each_for_itself",),
        """
def bodies_asleep(inverse_masses, still, touches):
    return [n for n in range(len(still)) if still[n] and inverse_masses[n] > 0]
""",
    ),
    Wrong(
        "11.3",
        "discs beyond a wall are put to the wall with their centre",
        ("centres_at_the_walls",),
        """
import numpy as np

def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    p = np.array(positions, float)
    v = np.array(velocities, float)
    p = p + v * dt
    v = v + np.asarray(gravity) * dt
    n = len(p)
    for i in range(n):
        for j in range(i + 1, n):
            d = p[j] - p[i]
            dist = np.hypot(*d)
            depth = radii[i] + radii[j] - dist
            if depth > 0:
                u = d / dist
                wi, wj = 1 / masses[i], 1 / masses[j]
                vn = np.dot(v[j] - v[i], u)
                if vn < 0:
                    jn = -(1 + restitution) * vn / (wi + wj)
                    v[i] -= jn * wi * u
                    v[j] += jn * wj * u
                p[i] -= depth * wi / (wi + wj) * u
                p[j] += depth * wj / (wi + wj) * u
    for i in range(n):
        for k in range(2):
            if p[i, k] < 0:
                p[i, k] = 0
                if v[i, k] < 0:
                    v[i, k] *= -restitution
            if p[i, k] > room[k]:
                p[i, k] = room[k]
                if v[i, k] > 0:
                    v[i, k] *= -restitution
    return p, v
""",
    ),
    Wrong(
        "A.3",
        "every pair sees the velocities from before, not what earlier ones have left",
        ("all_from_the_old_velocities",),
        """
import numpy as np

def collide_all(positions, velocities, masses, radii, restitution):
    old = velocities
    new = velocities.copy()
    for i in range(len(masses)):
        for j in range(i + 1, len(masses)):
            d = positions[j] - positions[i]
            dist = np.sqrt(d @ d)
            if dist == 0 or dist >= radii[i] + radii[j]:
                continue
            n = d / dist
            vn = (old[j] - old[i]) @ n
            if vn < 0:
                imp = -(1 + restitution) * vn / (1 / masses[i] + 1 / masses[j])
                new[i] -= imp / masses[i] * n
                new[j] += imp / masses[j] * n
    return new
""",
    ),
    Wrong(
        "B.1",
        "the centre, not the rim, has to be beyond the wall",
        ("forgets_the_radius",),
        """
def wall_contacts(position):
    x, y = position
    found = []
    for name, depth in (("top", -y), ("bottom", y - HEIGHT), ("left", -x), ("right", x - WIDTH)):
        if depth > 0:
            found.append((name, NORMALS[name], depth))
    return found
""",
    ),
    Wrong(
        "B.3",
        "2 RESTITUTION in place of 1 + RESTITUTION",
        ("one_plus",),
        """
def resolve(position, velocity, normal, depth):
    vn = velocity[0] * normal[0] + velocity[1] * normal[1]
    new_position = position + depth * normal
    if vn >= 0:
        return new_position, velocity.copy()
    return new_position, velocity - 2 * RESTITUTION * vn * normal
""",
    ),
    Wrong(
        "C.1",
        "one pass from left to right",
        ("one_pass",),
        """
def collide_row(masses, velocities, restitution):
    v = velocities.copy()
    for i in range(len(v) - 1):
        if v[i] - v[i + 1] > SLOWEST:
            m1, m2 = masses[i], masses[i + 1]
            j = (1 + restitution) * m1 * m2 / (m1 + m2) * (v[i] - v[i + 1])
            v[i] -= j / m1
            v[i + 1] += j / m2
    return v
""",
    ),
    Wrong(
        "D.1",
        "half the width over the full height",
        ("half_the_width",),
        """
def tipping_angle(width, height):
    return math.atan2(width / 2, height)
""",
    ),
    Wrong(
        "K.3",
        "after a brick the whole duration begins anew",
        (
            "step",
            "term",
        ),
        """
def _first(position, velocity, radius, box):
    x, y, w, h = box
    best = None
    for axis, lo, hi, other_lo, other_hi in (
        (0, x - radius, x + w + radius, y, y + h),
        (1, y - radius, y + h + radius, x, x + w),
    ):
        for side, sign in ((lo, -1.0), (hi, 1.0)):
            if velocity[axis] * sign >= 0:
                continue
            t = (side - position[axis]) / velocity[axis]
            other = position[1 - axis] + velocity[1 - axis] * t
            if t >= 0 and other_lo <= other <= other_hi and (best is None or t < best[0]):
                n = np.zeros(2)
                n[axis] = sign
                best = t, n
    for cx in (x, x + w):
        for cy in (y, y + h):
            d = position - np.array([cx, cy])
            a, b, c = velocity @ velocity, d @ velocity, d @ d - radius**2
            disc = b * b - a * c
            if disc < 0 or b >= 0:
                continue
            t = (-b - math.sqrt(disc)) / a
            if t >= 0 and (best is None or t < best[0]):
                best = t, (d + velocity * t) / radius
    return best


def fly(position, velocity, radius, bricks, duration):
    p, v = np.array(position, float), np.array(velocity, float)
    broken = []
    while True:
        found = None
        for k, brick in enumerate(bricks):
            if k in broken:
                continue
            hit = _first(p, v, radius, brick)
            if hit is not None and hit[0] <= duration and (found is None or hit[0] < found[0]):
                found = (*hit, k)
        if found is None:
            return p + v * duration, v, broken
        t, n, k = found
        p = p + v * t
        v = v - 2 * (v @ n) * n
        broken.append(k)
""",
    ),
    Wrong(
        "P.3",
        "the impulses are not divided by the number of pairs",
        ("every_pair_in_full",),
        """
def share_impact(positions, velocities, radius, restitution):
    v = velocities.copy()
    n = len(v)
    for _ in range(ROUNDS):
        change = np.zeros_like(v)
        for i in range(n):
            for j in range(i + 1, n):
                d = positions[j] - positions[i]
                dist = np.hypot(*d)
                if dist > TOUCHING * radius:
                    continue
                u = d / dist
                approach = np.dot(v[i] - v[j], u)
                if approach > 0:
                    dv = (1 + restitution) * approach / 2
                    change[i] -= dv * u
                    change[j] += dv * u
        v += change
    return v
""",
    ),
    Wrong(
        "S.2",
        "the damping takes the whole relative velocity",
        ("damps_across_the_springs",),
        """
def ring_forces(positions, velocities, length, stiffness, damping):
    n = len(positions)
    forces = np.zeros((n, 2))
    for i in range(n):
        j = (i + 1) % n
        d = positions[j] - positions[i]
        dist = np.hypot(*d)
        u = d / dist
        f = stiffness * (dist - length) * u + damping * (velocities[j] - velocities[i])
        forces[i] += f
        forces[j] -= f
    return forces
""",
    ),
)

THIRD = (
    Wrong(
        "1.2",
        "the momenta subtracted: the way of each body forgotten",
        ("sign",),
        """
def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 - m2 * v2) / (m1 + m2)
    return v, v
""",
    ),
    Wrong(
        "2.1",
        "the larger of the two speeds after over the larger before",
        ("fastest_over_fastest",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    return max(abs(v1_after), abs(v2_after)) / max(abs(v1), abs(v2))
""",
    ),
    Wrong(
        "2.2",
        "both bodies get the same change of velocity",
        ("equal_mass_formula",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    dv = (1 + restitution) * (v1 - v2) / 2
    return v1 - dv, v2 + dv
""",
    ),
    Wrong(
        "3.2",
        "e acts along the wall, and the normal part is only turned round",
        ("parts",),
        """
import numpy as np

def bounce(velocity, normal, restitution):
    vn = np.dot(velocity, normal)
    if vn >= 0:
        return velocity
    along = velocity - vn * normal
    return restitution * along - vn * normal
""",
    ),
    Wrong(
        "4.1",
        "the normal is not made a unit vector",
        ("not_normalised",),
        """
import numpy as np

def circle_contact(p1, r1, p2, r2):
    d = p2 - p1
    dist = np.linalg.norm(d)
    if dist >= r1 + r2:
        return None
    if dist == 0:
        return np.array([1.0, 0.0]), r1 + r2
    return d, r1 + r2 - dist
""",
    ),
    Wrong(
        "4.2",
        "the whole velocities are exchanged as on a line, component by component",
        ("one_dimension_on_each_axis",),
        """
import numpy as np

def resolve_circles(v1, m1, v2, m2, normal, restitution):
    if np.dot(v1 - v2, normal) <= 0:
        return v1, v2
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    part = restitution * (v1 - v2)
    return c - part * m2 / (m1 + m2), c + part * m1 / (m1 + m2)
""",
    ),
    Wrong(
        "5.2",
        "the lever is not turned: v + w r",
        ("along_the_lever",),
        """
def contact_velocity(v, w, r):
    return v + w * r
""",
    ),
    Wrong(
        "5.4",
        "the limit holds on one side only",
        ("clamped_on_one_side",),
        """
def friction_impulse(vt, jn, friction, k):
    return min(-vt / k, friction * jn)
""",
    ),
    Wrong(
        "6.1",
        "the edges themselves, made unit vectors",
        ("edges_for_normals",),
        """
import numpy as np

def sat_axes(vertices):
    out = []
    for a, b in zip(vertices, np.roll(vertices, -1, axis=0)):
        e = b - a
        if np.hypot(*e) > 0:
            out.append(e / np.hypot(*e))
    return out
""",
    ),
    Wrong(
        "6.4",
        "the largest overlap is kept",
        ("largest_overlap",),
        """
import numpy as np

def mtv(vertices_a, vertices_b):
    best = None
    for poly in (vertices_a, vertices_b):
        for i in range(len(poly)):
            e = poly[i] - poly[i - 1]
            size = np.hypot(*e)
            if size == 0:
                continue
            n = np.array([e[1], -e[0]]) / size
            a, b = vertices_a @ n, vertices_b @ n
            right, left = a.max() - b.min(), b.max() - a.min()
            if right <= 0 or left <= 0:
                return None
            if left < right:
                n, depth = -n, left
            else:
                depth = right
            if best is None or depth > best[1]:
                best = n, depth
    return best
""",
    ),
    Wrong(
        "7.4",
        "times in the past count too: the pair with the smallest root",
        ("meetings_of_the_past",),
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
            a, b, c = v @ v, d @ v, d @ d - (radii[i] + radii[j]) ** 2
            if a == 0 or b * b < a * c:
                continue
            t = (-b - math.sqrt(b * b - a * c)) / a
            if best is None or t < best[0]:
                best = t, i, j
    return best
""",
    ),
    Wrong(
        "8.4",
        "sweeps at most, not exactly",
        ("at_most_so_many",),
        """
import math

def best_split(table, sweeps):
    best = None
    for substeps, iterations, error in table:
        if substeps * iterations <= sweeps and not math.isinf(error):
            if best is None or error < best[2]:
                best = substeps, iterations, error
    return None if best is None else (best[0], best[1])
""",
    ),
    Wrong(
        "9.1",
        "each box's own weight only",
        ("own_weight",),
        """
def tower_forces(masses, gravity):
    return masses * gravity
""",
    ),
    Wrong(
        "10.2",
        "corners are forgotten where rotation is asked",
        ("corners_never_turn",),
        """
def effects_called_for(bodies, gravity):
    names = set()
    n = len(bodies)
    if gravity[0] != 0 or gravity[1] != 0:
        names.add("gravity")
    for i in range(n):
        if bodies[i][4] != 0:
            names.add("rotation")
        for j in range(i + 1, n):
            a, b = bodies[i], bodies[j]
            if a[0] == 0 and b[0] == 0:
                continue
            if min(a[2], b[2]) > 0:
                names.add("restitution")
            if a[3] * b[3] > 0:
                names.add("friction")
                names.add("rotation")
    return sorted(names)
""",
    ),
    Wrong(
        "11.2",
        "the impulse of friction is limited by mu alone, not by mu times jn",
        ("factor_missing",),
        """
import numpy as np

def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, wa = a[0], a[1], a[4]
    mb, ib, wb = b[0], b[1], b[4]
    va, vb = np.array([a[2], a[3]]), np.array([b[2], b[3]])
    perp = lambda r: np.array([-r[1], r[0]])
    cr = lambda p, q: p[0] * q[1] - p[1] * q[0]

    def relative():
        return vb + wb * perp(arm_b) - va - wa * perp(arm_a)

    def push(p):
        nonlocal va, vb, wa, wb
        va, vb = va - p / ma, vb + p / mb
        wa, wb = wa - cr(arm_a, p) / ia, wb + cr(arm_b, p) / ib

    def k(u):
        return 1 / ma + 1 / mb + cr(arm_a, u) ** 2 / ia + cr(arm_b, u) ** 2 / ib

    vn = np.dot(relative(), normal)
    if vn < 0:
        jn = -(1 + restitution) * vn / k(normal)
        push(jn * normal)
        t = perp(normal)
        jt = -np.dot(relative(), t) / k(t)
        jt = max(-friction, min(friction, jt))
        push(jt * t)
    return va, wa, vb, wb
""",
    ),
    Wrong(
        "A.2",
        "the muzzle speed is taken over the ground",
        ("seen_from_the_ground",),
        """
def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    d = np.array([np.cos(heading), np.sin(heading)])
    shot = muzzle_speed * d
    ship = ((ship_mass + shot_mass) * velocity - shot_mass * shot) / ship_mass
    return ship, shot
""",
    ),
    Wrong(
        "B.5",
        "what lacks less than a billionth of a step is no whole step",
        ("term", "loses_a_step_to_rounding"),
        """
def wall_contacts(position):
    found = []
    x, y = position
    for name, depth in (
        ("top", RADIUS - y),
        ("bottom", y + RADIUS - HEIGHT),
        ("left", RADIUS - x),
        ("right", x + RADIUS - WIDTH),
    ):
        if depth > 0:
            found.append((name, NORMALS[name], depth))
    return found


def bumper_contact(position):
    line = BUMPER_END - BUMPER_START
    t = min(1, max(0, (position - BUMPER_START) @ line / (line @ line)))
    d = position - BUMPER_START - t * line
    size = np.sqrt(d @ d)
    depth = RADIUS + BUMPER_HALF_THICKNESS - size
    return (d / size, depth) if depth > 0 else None


def resolve(position, velocity, normal, depth):
    vn = min(0, velocity @ normal)
    return position + depth * normal, velocity - (1 + RESTITUTION) * vn * normal


def step(position, velocity, dt=TIME_STEP):
    position = position + velocity * dt
    hits = []
    bumper = bumper_contact(position)
    if bumper:
        if velocity @ bumper[0] < 0:
            hits.append("bumper")
        position, velocity = resolve(position, velocity, *bumper)
    for name, normal, depth in wall_contacts(position):
        if velocity @ normal < 0:
            hits.append(name)
        position, velocity = resolve(position, velocity, normal, depth)
    return position, velocity, hits


def advance(position, velocity, elapsed):
    hits = []
    count = int(elapsed / TIME_STEP)
    for _ in range(count):
        position, velocity, new = step(position, velocity)
        hits += new
    return position, velocity, hits, elapsed - count * TIME_STEP
""",
    ),
    Wrong(
        "C.3",
        "balls that touch swap only once a step, in one pass",
        ("one_pass_a_step",),
        """
def swing_step(angle, rate, length, dt):
    rate = rate - GRAVITY / length * np.sin(angle) * dt
    return angle + rate * dt, rate


def cradle(angles, rates, length, dt, steps):
    angles, rates = np.array(angles), np.array(rates)
    for _ in range(int(steps)):
        for i in range(len(angles)):
            angles[i], rates[i] = swing_step(angles[i], rates[i], length, dt)
        for i in range(len(angles) - 1):
            if angles[i] >= angles[i + 1] and rates[i] > rates[i + 1]:
                rates[i], rates[i + 1] = rates[i + 1], rates[i]
    return angles, rates
""",
    ),
    Wrong(
        "D.3",
        "the pull uses the cosine of the angle",
        ("cosine_for_sine",),
        """
def chain(angles, rates, height, spacing, dt, steps):
    angles, rates = np.array(angles), np.array(rates)
    reach = math.asin(spacing / height)
    for _ in range(int(steps)):
        rates += 3 * GRAVITY / (2 * height) * np.cos(angles) * dt
        angles += rates * dt
        for i in range(len(angles) - 1):
            if angles[i] > reach and rates[i] > rates[i + 1]:
                rates[i] = rates[i + 1] = (rates[i] + rates[i + 1]) / 2
        lies = angles > math.pi / 2
        angles[lies] = math.pi / 2
        rates[lies] = 0
    return angles, rates
""",
    ),
    Wrong(
        "S.1",
        "the last edge, back to the first mass, is missing",
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
)

FOURTH = (
    Wrong(
        "2.4",
        "the falls alone, each shorter by e^2, not by e",
        ("falls_shrink_like_heights",),
        """
import math

def rest_time(height, restitution, gravity):
    fall = math.sqrt(2 * height / gravity)
    return fall / (1 - restitution**2)
""",
    ),
    Wrong(
        "3.1",
        "the part along the wall is turned round, too",
        ("straight_back",),
        """
import numpy as np

def reflect(incident, normal):
    tangent = np.array([-normal[1], normal[0]])
    return -np.dot(incident, normal) * normal - np.dot(incident, tangent) * tangent
""",
    ),
    Wrong(
        "3.3",
        "the condition is turned round: v . n > 0 bounces",
        ("bounces_only_when_leaving",),
        """
import numpy as np

def resolve_wall(position, velocity, normal, depth, restitution):
    position = position + normal * depth
    vn = np.dot(velocity, normal)
    if vn > 0:
        velocity = velocity - (1 + restitution) * vn * normal
    return position, velocity
""",
    ),
    Wrong(
        "4.2",
        "the approach is measured by speeds, not along the normal",
        ("speed_for_approach",),
        """
import numpy as np

def resolve_circles(v1, m1, v2, m2, normal, restitution):
    rel = v1 - v2
    if np.dot(rel, normal) <= 0:
        return v1, v2
    j = (1 + restitution) * np.linalg.norm(rel) * m1 * m2 / (m1 + m2)
    return v1 - j / m1 * normal, v2 + j / m2 * normal
""",
    ),
    Wrong(
        "4.3",
        "only the lighter one moves, by all of the depth",
        ("only_the_lighter_moves",),
        """
def separate(p1, m1, p2, m2, normal, depth):
    if m1 < m2:
        return p1 - depth * normal, p2
    return p1, p2 + depth * normal
""",
    ),
    Wrong(
        "5.1",
        "about the first vertex, without the shift to the centroid",
        (
            "ignored",
            "term",
        ),
        """
import numpy as np

def moment_of_inertia(mass, vertices):
    v = np.asarray(vertices, float) - vertices[0]
    nxt = np.roll(v, -1, axis=0)
    c = v[:, 0] * nxt[:, 1] - v[:, 1] * nxt[:, 0]
    q = (v * v).sum(1) + (v * nxt).sum(1) + (nxt * nxt).sum(1)
    return mass * (c * q).sum() / (6 * c.sum())
""",
    ),
    Wrong(
        "5.3",
        "the moments of inertia of both are added before they divide",
        ("turn_as_one",),
        """
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    ca = r_a[0] * direction[1] - r_a[1] * direction[0]
    cb = r_b[0] * direction[1] - r_b[1] * direction[0]
    return 1 / m_a + 1 / m_b + (ca - cb) ** 2 / (i_a + i_b)
""",
    ),
    Wrong(
        "5.5",
        "the spin changes the wrong way",
        ("torque_with_the_wrong_sign",),
        """
import numpy as np

def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    vn = velocity @ normal
    if vn >= 0:
        return velocity, w
    tangent = np.array([-normal[1], normal[0]])
    jn = -(1 + restitution) * vn
    slide = velocity @ tangent - w * radius
    jt = -slide / 3
    jt = min(max(jt, -friction * jn), friction * jn)
    return velocity + jn * normal + jt * tangent, w + 2 * jt / radius
""",
    ),
    Wrong(
        "6.2",
        "the shadow starts at the origin",
        ("starts_from_zero",),
        """
def project(vertices, axis):
    s = [float(x * axis[0] + y * axis[1]) for x, y in vertices]
    return min(0.0, min(s)), max(0.0, max(s))
""",
    ),
    Wrong(
        "6.6",
        "the nearest vertex decides, edges never do",
        ("corners_only",),
        """
import numpy as np

def circle_against_polygon(centre, radius, vertices):
    d = centre - vertices
    dist = np.hypot(d[:, 0], d[:, 1])
    k = int(dist.argmin())
    if dist[k] >= radius:
        return None
    return d[k] / dist[k], radius - dist[k]
""",
    ),
    Wrong(
        "7.2",
        "two times: up to the top and then down from the height it started at",
        ("falls_from_the_start",),
        """
import math

def time_to_floor(height, velocity, gravity):
    if gravity == 0:
        return height / -velocity if velocity < 0 else None
    if velocity < 0:
        return 2 * height / (math.sqrt(velocity**2 + 2 * gravity * height) - velocity)
    return velocity / gravity + math.sqrt(2 * height / gravity)
""",
    ),
    Wrong(
        "8.2",
        "the logarithms' ratio is upside down",
        ("upside_down",),
        """
import math

def observed_order(dt_1, error_1, dt_2, error_2):
    return math.log(dt_1 / dt_2) / math.log(error_1 / error_2)
""",
    ),
    Wrong(
        "9.2",
        "the light one's share is taken for what is left",
        ("masses_swapped",),
        """
import math

def sweeps_needed(light, heavy, left):
    return math.ceil(math.log(left) / math.log(light / (light + heavy)))
""",
    ),
    Wrong(
        "9.4",
        "the impulse's own energy is added, without the mixed terms",
        ("ignored", "term", "energies_add_up"),
        """
def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    before = mass * (velocity @ velocity) / 2 + inertia * w**2 / 2
    turn = arm[0] * impulse[1] - arm[1] * impulse[0]
    return (before + impulse @ impulse / (2 * mass) + turn**2 / (2 * inertia)) / before
""",
    ),
    Wrong(
        "10.1",
        "the mean of both coefficients, not the geometric mean",
        ("mean_of_both",),
        """
def most_friction(inverse_masses, frictions):
    best = 0.0
    n = len(frictions)
    for i in range(n):
        for j in range(i):
            if inverse_masses[i] > 0 or inverse_masses[j] > 0:
                best = max(best, (frictions[i] + frictions[j]) / 2)
    return best
""",
    ),
    Wrong(
        "10.4",
        "the disc's radius is forgotten",
        ("of_the_centre",),
        """
def box_of_flight(position, velocity, radius, gravity, duration):
    sides = []
    for x, v, g in zip(position, velocity, gravity):
        places = [x, x + v * duration + g * duration**2 / 2]
        if g != 0 and 0 < -v / g < duration:
            t = -v / g
            places.append(x + v * t + g * t**2 / 2)
        sides += [min(places), max(places)]
    return tuple(sides)
""",
    ),
    Wrong(
        "A.1",
        "the pieces' directions are not spread over the whole circle but the half",
        ("factor",),
        """
def split(velocity, masses, speed, heading):
    n = len(masses)
    a = heading + np.pi * np.arange(n) / n
    out = speed * np.column_stack((np.cos(a), np.sin(a)))
    return velocity + out - masses @ out / masses.sum()
""",
    ),
    Wrong(
        "B.2",
        "the bumper's thickness is forgotten",
        ("thin_bumper",),
        """
def bumper_contact(position):
    line = BUMPER_END - BUMPER_START
    t = np.clip(np.dot(position - BUMPER_START, line) / np.dot(line, line), 0, 1)
    away = position - (BUMPER_START + t * line)
    distance = np.linalg.norm(away)
    if distance >= RADIUS:
        return None
    return away / distance, RADIUS - distance
""",
    ),
    Wrong(
        "K.2",
        "the brick keeps square corners when it is grown",
        ("square_corners",),
        """
def brick_impact(position, velocity, radius, box):
    low = box[:2] - radius
    high = box[:2] + box[2:] + radius
    best = None
    for axis in (0, 1):
        if velocity[axis] == 0:
            continue
        side = -1.0 if velocity[axis] > 0 else 1.0
        face = low[axis] if velocity[axis] > 0 else high[axis]
        t = (face - position[axis]) / velocity[axis]
        other = position[1 - axis] + t * velocity[1 - axis]
        if 0 <= t <= HORIZON and low[1 - axis] <= other <= high[1 - axis]:
            normal = np.zeros(2)
            normal[axis] = side
            if best is None or t < best[0]:
                best = t, normal
    return best
""",
    ),
    Wrong(
        "S.4",
        "the positions move by the old velocities",
        ("moves_by_the_old_velocity",),
        """
def ring_area(p):
    q = np.roll(p, -1, axis=0)
    return float((p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]).sum() / 2)


def ring_forces(positions, velocities, length, stiffness, damping):
    along = np.roll(positions, -1, axis=0) - positions
    distance = np.hypot(along[:, 0], along[:, 1])
    u = along / distance[:, None]
    rate = ((np.roll(velocities, -1, axis=0) - velocities) * u).sum(axis=1)
    f = (stiffness * (distance - length) + damping * rate)[:, None] * u
    return f - np.roll(f, 1, axis=0)


def pressure_forces(positions, area, stiffness):
    pressure = stiffness * (area / ring_area(positions) - 1)
    along = np.roll(positions, -1, axis=0) - positions
    push = pressure * np.column_stack((along[:, 1], -along[:, 0]))
    return (push + np.roll(push, 1, axis=0)) / 2


def drop(positions, velocities, length, area, steps):
    x, v = np.array(positions), np.array(velocities)
    for _ in range(int(steps)):
        f = ring_forces(x, v, length, STIFFNESS, DAMPING) + pressure_forces(x, area, PRESSURE)
        a = f / MASS - AIR * v + np.array([0.0, -GRAVITY])
        x = x + v * TIME_STEP
        v = v + a * TIME_STEP
        low = x[:, 1] < 0
        x[low, 1] = 0
        v[low & (v[:, 1] < 0), 1] = 0
        v[low, 0] *= GRIP
    return x, v
""",
    ),
)
