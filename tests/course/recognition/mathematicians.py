"""Wrong answers of pupils and of mathematicians who begin to program, from the tasks alone.

When they were first tried, after what FIFTH and SIXTH had taught, 43 of 60 were recognised, two of
them by a detour that was not their cause.
"""

from __future__ import annotations

from course.recognition.students import Wrong

SEVENTH = (
    Wrong(
        "1.1",
        "Solves momentum and energy as a quadratic for v1' and takes the root with plus, which "
        "is the state before the collision",
        ("other", "sign", "given"),
        """
import math

def elastic_1d(m1, v1, m2, v2):
    P = m1 * v1 + m2 * v2
    K = m1 * v1 ** 2 + m2 * v2 ** 2
    # put v2' = (P - m1 x)/m2 into the energy
    a = m1 * (m1 + m2)
    b = -2 * P * m1
    c = P ** 2 - m2 * K
    delta = max(b * b - 4 * a * c, 0.0)
    x = (-b + math.sqrt(delta)) / (2 * a)
    y = (P - m1 * x) / m2
    return x, y
""",
    ),
    Wrong(
        "1.1",
        "Overwrites v1 with the new velocity and then uses it as if it were the old one in the "
        "formula for v2'",
        ("uses_updated_v1",),
        """
def elastic_1d(m1, v1, m2, v2):
    soma = m1 + m2
    v1 = ((m1 - m2) * v1 + 2 * m2 * v2) / soma
    v2 = ((m2 - m1) * v2 + 2 * m1 * v1) / soma
    return (v1, v2)
""",
    ),
    Wrong(
        "1.3",
        "Counts the impulse only until both bodies have the same velocity (the squeeze) and "
        "forgets that the spring-back pushes as much again",
        ("stops_only",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    # at the moment of greatest compression both move with u
    u = (m1 * v1 + m2 * v2) / (m1 + m2)
    return m2 * (u - v2)
""",
    ),
    Wrong(
        "2.2",
        "Believes that e is the part of the kinetic energy that is left, so the velocities in "
        "the centre-of-mass frame shrink with sqrt(e)",
        ("energy_restitution",),
        """
import math

def collide_1d(m1, v1, m2, v2, restitution):
    vs = (m1 * v1 + m2 * v2) / (m1 + m2)
    u1 = v1 - vs
    u2 = v2 - vs
    k = math.sqrt(restitution)
    return vs - k * u1, vs - k * u2
""",
    ),
    Wrong(
        "2.2",
        "Forgets the brackets round 1 + e, so that the product is not with the sum",
        (),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    mu = m1 * m2 / (m1 + m2)
    J = mu * 1 + restitution * (v1 - v2)
    v1n = v1 - J / m1
    v2n = v2 + J / m2
    return (v1n, v2n)
""",
    ),
    Wrong(
        "2.3",
        "Squares e again in every turn of the loop, so the factor becomes e^2, e^4, e^8 "
        "instead of always e^2",
        ("squares_again_each_time",),
        """
def bounce_heights(height, restitution, count):
    alturas = []
    e = restitution
    h = height
    for i in range(int(count)):
        e = e * e
        h = h * e
        alturas.append(h)
    return alturas
""",
    ),
    Wrong(
        "2.4",
        "Sums the flight times as a geometric series with the ratio of the heights, e^2, "
        "instead of that of the times, e",
        ("times_shrink_like_heights",),
        """
import math

def rest_time(height, restitution, gravity):
    q = restitution ** 2          # each bounce is q times as high
    first = math.sqrt(2 * height / gravity)
    return first + 2 * first * q / (1 - q)
""",
    ),
    Wrong(
        "3.1",
        "Lays the angle of reflection off to the same side of the normal as the angle of "
        "incidence, so the ball flies back where it came from",
        ("straight_back",),
        """
import numpy as np

def reflect(incident, normal):
    speed = np.hypot(incident[0], incident[1])
    normal_angle = np.arctan2(normal[1], normal[0])
    back = np.arctan2(-incident[1], -incident[0])
    incidence = back - normal_angle
    out = normal_angle + incidence
    return speed * np.array([np.cos(out), np.sin(out)])
""",
    ),
    Wrong(
        "3.2",
        "Thinks of walls only as floors or side walls: flips one component, the one where the "
        "normal is larger",
        ("bounces_along_an_axis",),
        """
import numpy as np

def bounce(velocity, normal, restitution):
    vx, vy = velocity
    nx, ny = normal
    if vx * nx + vy * ny >= 0:
        return np.array([vx, vy])
    if abs(nx) > abs(ny):
        vx = -restitution * vx
    else:
        vy = -restitution * vy
    return np.array([vx, vy])
""",
    ),
    Wrong(
        "3.3",
        "Moves the ball back by the depth along the path it came, not along the normal of the wall",
        ("back_along_the_path",),
        """
import numpy as np

def resolve_wall(position, velocity, normal, depth, restitution):
    p = np.array(position, dtype=float)
    v = np.array(velocity, dtype=float)
    n = np.array(normal, dtype=float)
    v_len = np.linalg.norm(v)
    if v_len > 0:
        direction = v / v_len
        p = p - depth * direction
    across = v.dot(n)
    if across < 0:
        v = v - (1 + restitution) * across * n
    return p, v
""",
    ),
    Wrong(
        "4.1",
        "Compares the squared distance with r1^2 + r2^2 instead of (r1 + r2)^2, so circles "
        "that overlap a little are missed",
        ("radii_squared_apart",),
        """
import numpy as np

def circle_contact(p1, r1, p2, r2):
    d = np.asarray(p2, float) - np.asarray(p1, float)
    d2 = d @ d
    if d2 >= r1**2 + r2**2:
        return None
    if d2 == 0:
        return np.array([1.0, 0.0]), r1 + r2
    dist = d2 ** 0.5
    return d / dist, r1 + r2 - dist
""",
    ),
    Wrong(
        "4.2",
        "Uses the formulas of the collision on a line for the whole vectors, so that the part "
        "along the tangent is exchanged too",
        ("one_dimension_on_each_axis",),
        """
import numpy as np

def resolve_circles(v1, m1, v2, m2, normal, restitution):
    if np.dot(v2 - v1, normal) >= 0:
        return v1, v2
    M = m1 + m2
    u = (m1 * v1 + m2 * v2) / M
    w1 = u - restitution * m2 / M * (v1 - v2)
    w2 = u + restitution * m1 / M * (v1 - v2)
    return w1, w2
""",
    ),
    Wrong(
        "4.4",
        "Copies the line of circle 1 for circle 2 and leaves the inverse mass of circle 1 in "
        "the update of v2",
        ("one_mass_for_both",),
        """
import numpy as np

def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    w1 = 1 / m1
    w2 = 1 / m2
    total = w1 + w2
    new_p1 = p1 - normal * depth * w1 / total
    new_p2 = p2 + normal * depth * w2 / total
    new_v1 = v1.copy()
    new_v2 = v2.copy()
    closing = float(np.dot(v1 - v2, normal))
    if closing > 0:
        j = (1 + restitution) * closing / total
        new_v1 = v1 - j * w1 * normal
        new_v2 = v2 + j * w1 * normal
    return new_p1, new_v1, new_p2, new_v2
""",
    ),
    Wrong(
        "5.1",
        "Thinks of the mass as sitting in the corners: mass/N at each vertex, at its distance "
        "from the mean of the vertices",
        ("vertex_masses",),
        """
import numpy as np

def moment_of_inertia(mass, vertices):
    V = np.array(vertices, dtype=float)
    center = V.mean(axis=0)
    r2 = ((V - center) ** 2).sum(axis=1)
    return mass / len(V) * r2.sum()
""",
    ),
    Wrong(
        "5.1",
        "Has the integral about the origin right, but adds m d^2 instead of taking it away to "
        "come to the centroid",
        ("parallel_axis_added",),
        """
import numpy as np

def moment_of_inertia(mass, vertices):
    n = len(vertices)
    A = Sx = Sy = I0 = 0.0
    for k in range(n):
        x0, y0 = vertices[k]
        x1, y1 = vertices[(k + 1) % n]
        det = x0 * y1 - x1 * y0
        A += det / 2
        Sx += (x0 + x1) * det / 6
        Sy += (y0 + y1) * det / 6
        I0 += det * (x0*x0 + x0*x1 + x1*x1 + y0*y0 + y0*y1 + y1*y1) / 12
    cx, cy = Sx / A, Sy / A
    # Steiner
    return mass * I0 / A + mass * (cx**2 + cy**2)
""",
    ),
    Wrong(
        "5.3",
        "Uses the whole length of the lever, |r|^2/I, which is right only when the push is at "
        "right angles to the lever",
        ("full_distance",),
        """
import numpy as np

def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    k = 0
    for m, i, r in [(m_a, i_a, r_a), (m_b, i_b, r_b)]:
        k += 1 / m + np.linalg.norm(r) ** 2 / i
    return k
""",
    ),
    Wrong(
        "5.4",
        "Thinks that friction is gone once its limit is passed: if it cannot stop the sliding "
        "the contact slips freely",
        ("none_beyond_the_limit",),
        """
def friction_impulse(vt, jn, friction, k):
    needed = -vt / k
    limit = friction * jn
    if abs(needed) <= limit:
        return needed
    else:
        return 0.0
""",
    ),
    Wrong(
        "5.5",
        "Forgets that the disc gives way by turning too: takes k = 1/m for the tangent, and so "
        "the impulse of friction is up to three times too large",
        ("rim_as_heavy_as_the_disc",),
        """
import numpy as np

def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    n = np.array(normal, float)
    t = np.array([-n[1], n[0]])
    vn = velocity @ n
    if vn >= 0:
        return velocity, w
    arm = -radius * n
    vt = velocity @ t - w * radius
    jn = -(1 + restitution) * vn
    jt = np.clip(-vt, -friction * jn, friction * jn)
    I = radius ** 2 / 2
    new_v = velocity + jn * n + jt * t
    new_w = w + (arm[0] * t[1] - arm[1] * t[0]) * jt / I
    return new_v, new_w
""",
    ),
    Wrong(
        "6.1",
        "Takes the direction from the centre of the polygon to the middle of the edge for the "
        "edge's normal, which holds only for rectangles and regular polygons",
        ("from_the_middle_to_the_edges",),
        """
import numpy as np

def sat_axes(vertices):
    centre = np.mean(vertices, axis=0)
    axes = []
    for i in range(len(vertices)):
        a = vertices[i]
        b = vertices[(i + 1) % len(vertices)]
        if np.allclose(a, b):
            continue
        d = (a + b) / 2 - centre
        axes.append(d / np.linalg.norm(d))
    return axes
""",
    ),
    Wrong(
        "6.4",
        "Decides which way the normal points by where B lies as seen from the origin, not as "
        "seen from A",
        ("direction_from_the_centres",),
        """
import numpy as np

def mtv(vertices_a, vertices_b):
    A = np.asarray(vertices_a, float)
    B = np.asarray(vertices_b, float)
    best_depth, best_axis = np.inf, None
    for poly in (A, B):
        edges = np.roll(poly, -1, axis=0) - poly
        for ex, ey in edges:
            L = np.hypot(ex, ey)
            if L == 0:
                continue
            axis = np.array([ey, -ex]) / L
            pa, pb = A @ axis, B @ axis
            o = min(pa.max() - pb.min(), pb.max() - pa.min())
            if o <= 0:
                return None
            if o < best_depth:
                best_depth, best_axis = o, axis
    if np.dot(B.mean(axis=0), best_axis) < 0:
        best_axis = -best_axis
    return best_axis, best_depth
""",
    ),
    Wrong(
        "6.5",
        "Collects the points inside first and the cut point last, so a segment that comes in "
        "from outside is returned the wrong way round",
        ("cut_always_last",),
        """
import numpy as np

def clip(start, end, normal, offset):
    ds = np.dot(start, normal) - offset
    de = np.dot(end, normal) - offset
    pts = []
    if ds <= 0:
        pts.append(start)
    if de <= 0:
        pts.append(end)
    if ds * de < 0:
        t = ds / (ds - de)
        pts.append(start + t * (end - start))
    if len(pts) == 0:
        return None
    if len(pts) == 1:
        pts.append(pts[0])
    return pts[0], pts[1]
""",
    ),
    Wrong(
        "6.6",
        "Forgets that the centre may lie inside: uses centre minus closest point and radius "
        "minus distance there too",
        ("deeper_when_inside",),
        """
import numpy as np

def closest_point_on_segment(point, start, end):
    way = end - start
    part = np.dot(point - start, way) / np.dot(way, way)
    return start + min(max(part, 0.0), 1.0) * way

def circle_against_polygon(centre, radius, vertices):
    closest = None
    smallest = float("inf")
    for i in range(len(vertices)):
        q = closest_point_on_segment(centre, vertices[i - 1], vertices[i])
        dist = np.linalg.norm(centre - q)
        if dist < smallest:
            smallest = dist
            closest = q
    if smallest >= radius:
        return None
    return (centre - closest) / smallest, radius - smallest
""",
    ),
    Wrong(
        "7.1",
        "Takes the time of closest approach for the time of the first touch",
        ("nearest_approach_if_near_enough",),
        """
import numpy as np

def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d = np.array(p2) - np.array(p1)
    u = np.array(v2) - np.array(v1)
    R = r1 + r2
    du = np.dot(d, u)
    if du >= 0:
        return None                 # they part
    if np.dot(d, d) <= R * R:
        return 0.0
    t = -du / np.dot(u, u)
    gap = d + u * t
    if np.linalg.norm(gap) > R or t > dt:
        return None
    return t
""",
    ),
    Wrong(
        "7.2",
        "Divides the height by the mean of start and impact speed, as if the ball went "
        "straight down, also when it first flies up",
        ("ignored", "term"),
        """
import math

def time_to_floor(height, velocity, gravity):
    if gravity == 0 and velocity >= 0:
        return None
    if height == 0 and velocity <= 0:
        return 0.0
    impact = math.sqrt(velocity ** 2 + 2 * gravity * height)
    mean_speed = (abs(velocity) + impact) / 2
    return height / mean_speed
""",
    ),
    Wrong(
        "7.3",
        "Mirrors the whole path beyond the wall back in, and forgets that the rest of the step "
        "is flown with the slower velocity",
        ("mirrors_the_rest",),
        """
import numpy as np

def advance(p, v, room, restitution, dt):
    q = np.array(p, float) + np.array(v, float) * dt
    w = np.array(v, float)
    for k in range(2):
        while q[k] < 0 or q[k] > room[k]:
            if q[k] < 0:
                q[k] = -q[k]
            else:
                q[k] = 2 * room[k] - q[k]
            w[k] = -restitution * w[k]
    return q, w
""",
    ),
    Wrong(
        "7.4",
        "Keeps the smallest time, but updates the pair at every meeting it finds, so that the "
        "last pair is returned with the first time",
        ("the_pair_looked_at_last",),
        """
import math
import numpy as np

def next_event(positions, velocities, radii):
    t_min = math.inf
    pair = None
    n = len(radii)
    for i in range(n):
        for j in range(i + 1, n):
            dp = positions[j] - positions[i]
            dv = velocities[j] - velocities[i]
            R = radii[i] + radii[j]
            b = dp @ dv
            if b >= 0:
                continue
            c = dp @ dp - R**2
            if c <= 0:
                t = 0.0
            else:
                a = dv @ dv
                disc = b*b - a*c
                if disc < 0:
                    continue
                t = c / (-b + math.sqrt(disc))
            t_min = min(t_min, t)
            pair = (i, j)
    if pair is None:
        return None
    return t_min, pair[0], pair[1]
""",
    ),
    Wrong(
        "7.5",
        "Stops counting as soon as the outer block has turned round, though the inner one may "
        "still be faster and catch it again",
        ("until_the_heavy_block_turns",),
        """
def pi_collisions(mass_ratio):
    M = mass_ratio
    V, v = -1.0, 0.0        # wall is at the left
    n = 0
    while V < 0:
        V, v = ((M - 1) * V + 2 * v) / (M + 1), ((1 - M) * v + 2 * M * V) / (M + 1)
        n += 1
        if v < 0:
            v = -v
            n += 1
    return n
""",
    ),
    Wrong(
        "8.2",
        "Remembers the formula for a step that is halved, log2 of the ratio of errors, and "
        "uses it for any two steps",
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
        "Fits with logarithms to base 10 but comes back with exp, so that C is wrong and p is "
        "right",
        ("two_kinds_of_logarithm",),
        """
import math
import numpy as np

def fit_power(steps, errors):
    X = np.log10(steps)
    Y = np.log10(errors)
    a, b = np.polyfit(X, Y, 1)
    return float(a), math.exp(b)
""",
    ),
    Wrong(
        "8.5",
        "Returns the place in the filtered list instead of the number of the row in the whole "
        "table",
        ("number_among_the_good",),
        """
import numpy as np

def cheapest(table, allowed):
    T = np.array(table, dtype=float).reshape(-1, 2)
    good = T[T[:, 1] <= allowed]
    if len(good) == 0:
        return None
    return int(np.argmin(good[:, 0]))
""",
    ),
    Wrong(
        "9.1",
        "Thinks that a box carries only its own weight and that of the next box, as if the "
        "ones higher up rested on their neighbours only",
        ("the_next_box_alone",),
        """
def tower_forces(masses, gravity):
    forces = []
    for i, m in enumerate(masses):
        f = m * gravity
        if i + 1 < len(masses):
            f += masses[i + 1] * gravity
        forces.append(f)
    return forces
""",
    ),
    Wrong(
        "9.3",
        "Takes dry friction for a drag that is proportional to the sliding speed, jt = -mu jn "
        "vt, instead of only having its sign",
        ("grows_with_the_sliding",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    denominator = knn - friction * vt * knt
    if denominator <= 0:
        return None
    return -vn / denominator
""",
    ),
    Wrong(
        "9.4",
        "Adds the energy that the blow would give to a body at rest to the old energy, without "
        "the mixed terms",
        ("energies_add_up",),
        """
import numpy as np

def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    before = mass * np.dot(velocity, velocity) / 2 + inertia * w**2 / 2
    dv = np.array(impulse) / mass
    dw = (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    gain = mass * np.dot(dv, dv) / 2 + inertia * dw**2 / 2
    return (before + gain) / before
""",
    ),
    Wrong(
        "9.5",
        "Picks the pair whose left ball has the largest velocity, not the pair whose approach "
        "(the difference) is fastest",
        ("leftmost_first",),
        """
def one_by_one(masses, velocities):
    v = [float(x) for x in velocities]
    m = list(masses)
    while True:
        k = -1
        for i in range(len(v) - 1):
            if v[i] - v[i + 1] > 1e-9:
                if k < 0 or v[i] > v[k]:
                    k = i
        if k < 0:
            return v
        a, b = v[k], v[k + 1]
        ma, mb = m[k], m[k + 1]
        v[k] = ((ma - mb) * a + 2 * mb * b) / (ma + mb)
        v[k + 1] = ((mb - ma) * b + 2 * ma * a) / (ma + mb)
""",
    ),
    Wrong(
        "10.2",
        "Looks at each body by itself: one body with e > 0 or mu > 0 is enough, though in a "
        "pair the other one may make it zero",
        ("each_body_by_itself",),
        """
import numpy as np

def effects_called_for(bodies, gravity):
    needed = set()
    movable = [b for b in bodies if b[0] > 0]
    if len(movable) > 0 and (gravity[0] != 0 or gravity[1] != 0):
        needed.add("gravity")
    if len(movable) > 0 and len(bodies) > 1:
        for inv, corners, e, mu, w in bodies:
            if e > 0:
                needed.add("restitution")
            if mu > 0:
                needed.add("friction")
            if inv > 0 and corners > 0:
                needed.add("rotation")
    for b in bodies:
        if b[4] != 0:
            needed.add("rotation")
    if "friction" in needed:
        needed.add("rotation")
    return sorted(needed)
""",
    ),
    Wrong(
        "10.4",
        "Always puts the turning point at t = -v/g into the box, without asking whether it "
        "lies within the flight",
        ("turning_point_always",),
        """
import numpy as np

def box_of_flight(position, velocity, radius, gravity, duration):
    out = []
    for x, v, g in zip(position, velocity, gravity):
        values = [x, x + v * duration + g * duration ** 2 / 2]
        if g != 0:
            t = -v / g
            values.append(x + v * t + g * t ** 2 / 2)
        out.append(min(values) - radius)
        out.append(max(values) + radius)
    return tuple(out)
""",
    ),
    Wrong(
        "10.5",
        "Looks only at the direct neighbours of a body and not at the whole chain of those "
        "that touch",
        ("only_neighbours",),
        """
import numpy as np

def bodies_asleep(inverse_masses, still, touches):
    asleep = []
    N = len(still)
    for a in range(N):
        if inverse_masses[a] == 0 or not still[a]:
            continue
        neighbours = [b for b in range(N) if touches[a, b] and b != a and inverse_masses[b] > 0]
        if all(still[b] for b in neighbours):
            asleep.append(a)
    return asleep
""",
    ),
    Wrong(
        "11.1",
        "Thinks that boxes share a point only if a corner of one lies in the other, and so "
        "misses boxes that cross like a plus sign",
        ("corners_inside",),
        """
import numpy as np

def corner_inside(p, q):
    for x in (p[0], p[1]):
        for y in (p[2], p[3]):
            if q[0] <= x <= q[1] and q[2] <= y <= q[3]:
                return True
    return False

def near_pairs(boxes):
    result = []
    for j in range(len(boxes)):
        for i in range(j):
            if corner_inside(boxes[i], boxes[j]) or corner_inside(boxes[j], boxes[i]):
                result.append((i, j))
    return result
""",
    ),
    Wrong(
        "11.2",
        "Computes the sliding once at the start, before the normal impulse, and lets friction "
        "stop that old value",
        ("sliding_before_the_blow",),
        """
import numpy as np

def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]

def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, va, wa = a[0], a[1], np.array([a[2], a[3]]), a[4]
    mb, ib, vb, wb = b[0], b[1], np.array([b[2], b[3]]), b[4]
    tangent = np.array([-normal[1], normal[0]])
    pa = va + wa * np.array([-arm_a[1], arm_a[0]])
    pb = vb + wb * np.array([-arm_b[1], arm_b[0]])
    rel = pb - pa
    vn = rel.dot(normal)
    vt = rel.dot(tangent)
    if vn >= 0:
        return va, wa, vb, wb
    kn = 1/ma + 1/mb + cross(arm_a, normal)**2/ia + cross(arm_b, normal)**2/ib
    kt = 1/ma + 1/mb + cross(arm_a, tangent)**2/ia + cross(arm_b, tangent)**2/ib
    jn = -(1 + restitution) * vn / kn
    jt = max(-friction * jn, min(friction * jn, -vt / kt))
    J = jn * normal + jt * tangent
    return (va - J / ma, wa - cross(arm_a, J) / ia, vb + J / mb, wb + cross(arm_b, J) / ib)
""",
    ),
    Wrong(
        "11.3",
        "Changes the velocity by gravity first and moves with the new velocity, as in an "
        "earlier chapter, though here the disc moves first",
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
            dist = np.linalg.norm(d)
            depth = radii[i] + radii[j] - dist
            if depth <= 0:
                continue
            nrm = d / dist if dist > 0 else np.array([1.0, 0.0])
            wi, wj = 1 / masses[i], 1 / masses[j]
            closing = (v[j] - v[i]) @ nrm
            if closing < 0:
                J = -(1 + restitution) * closing / (wi + wj)
                v[i] -= J * wi * nrm
                v[j] += J * wj * nrm
            x[i] -= depth * wi / (wi + wj) * nrm
            x[j] += depth * wj / (wi + wj) * nrm
    for i in range(n):
        for k in (0, 1):
            lo, hi = radii[i], room[k] - radii[i]
            if x[i, k] < lo:
                x[i, k] = lo
                if v[i, k] < 0:
                    v[i, k] *= -restitution
            elif x[i, k] > hi:
                x[i, k] = hi
                if v[i, k] > 0:
                    v[i, k] *= -restitution
    return x, v
""",
    ),
    Wrong(
        "11.5",
        "Fades by the straight line through half a light at one half-life, a factor 1 - dt/(2 "
        "half_life) each step, so that it depends on the length of the steps",
        ("fades_by_a_fixed_amount",),
        """
import numpy as np

def glow(brightness, hit, dt, half_life):
    fraction = max(0.0, 1 - 0.5 * dt / half_life)
    return np.where(np.asarray(hit) == 1, 1.0, np.asarray(brightness) * fraction)
""",
    ),
    Wrong(
        "11.6",
        "Spreads the samples with linspace up to and including the end, so that they are not "
        "quite 1/rate apart",
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
        "Takes away the plain mean of the pieces' velocities, not the mean weighted with the "
        "masses, so that the momentum still changes",
        ("nothing_taken_back",),
        """
import numpy as np

def split(velocity, masses, speed, heading):
    n = len(masses)
    pieces = []
    for k in range(n):
        angle = heading + 2 * np.pi * k / n
        pieces.append([speed * np.cos(angle), speed * np.sin(angle)])
    pieces = np.array(pieces)
    drift = pieces.mean(axis=0)
    return velocity + pieces - drift
""",
    ),
    Wrong(
        "A.3",
        "Reads all velocities from the old array and writes to a copy, so that later pairs do "
        "not see what the earlier ones have changed",
        ("all_from_the_old_velocities",),
        """
import numpy as np

def collide_all(positions, velocities, masses, radii, restitution):
    new_velocities = np.array(velocities, dtype=float)
    n = len(masses)
    for i in range(n):
        for j in range(i + 1, n):
            delta = positions[j] - positions[i]
            distance = np.linalg.norm(delta)
            if distance == 0 or distance >= radii[i] + radii[j]:
                continue
            normal = delta / distance
            approach = np.dot(velocities[i] - velocities[j], normal)
            if approach <= 0:
                continue
            impulse = (1 + restitution) * approach / (1 / masses[i] + 1 / masses[j])
            new_velocities[i] -= impulse / masses[i] * normal
            new_velocities[j] += impulse / masses[j] * normal
    return new_velocities
""",
    ),
    Wrong(
        "B.1",
        "Thinks of y as pointing up, as in mathematics, and looks for the top wall at y = "
        "HEIGHT and for the bottom wall at y = 0",
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
        "Projects on the unit direction, which gives pixels, but clamps the result to 0..1 as "
        "if it were a part of the length",
        ("length_taken_for_a_part",),
        """
import numpy as np

RADIUS = 12.0
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0

def bumper_contact(position):
    segment = BUMPER_END - BUMPER_START
    length = np.linalg.norm(segment)
    direction = segment / length
    t = np.dot(position - BUMPER_START, direction)
    t = max(0.0, min(1.0, t))
    closest = BUMPER_START + t * direction
    diff = position - closest
    dist = np.linalg.norm(diff)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return diff / dist, depth
""",
    ),
    Wrong(
        "B.4",
        "Notes a hit for every contact that is resolved, also when the ball was already moving "
        "away from that wall",
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
    depths = [("top", RADIUS - y), ("bottom", y + RADIUS - HEIGHT),
              ("left", RADIUS - x), ("right", x + RADIUS - WIDTH)]
    return [(name, NORMALS[name], d) for name, d in depths if d > 0]


def bumper_contact(position):
    way = BUMPER_END - BUMPER_START
    t = np.dot(position - BUMPER_START, way) / np.dot(way, way)
    closest = BUMPER_START + min(max(t, 0.0), 1.0) * way
    diff = position - closest
    dist = np.linalg.norm(diff)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return diff / dist, depth


def resolve(position, velocity, normal, depth):
    new_position = position + depth * normal
    vn = np.dot(velocity, normal)
    if vn < 0:
        return new_position, velocity - (1 + RESTITUTION) * vn * normal
    return new_position, velocity.copy()


def step(position, velocity, dt=TIME_STEP):
    hits = []
    position = position + velocity * dt
    contact = bumper_contact(position)
    if contact is not None:
        position, velocity = resolve(position, velocity, contact[0], contact[1])
        hits.append("bumper")
    for name, normal, depth in wall_contacts(position):
        position, velocity = resolve(position, velocity, normal, depth)
        hits.append(name)
    return position, velocity, hits
""",
    ),
    Wrong(
        "B.5",
        "Overwrites the list of hits in every step, so that only those of the last step are "
        "returned",
        ("ignored", "step"),
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
    way = BUMPER_END - BUMPER_START
    t = np.dot(position - BUMPER_START, way) / np.dot(way, way)
    closest = BUMPER_START + min(max(t, 0.0), 1.0) * way
    diff = position - closest
    dist = np.linalg.norm(diff)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    if depth <= 0:
        return None
    return diff / dist, depth


def resolve(position, velocity, normal, depth):
    new_position = position + depth * normal
    vn = np.dot(velocity, normal)
    if vn < 0:
        return new_position, velocity - (1 + RESTITUTION) * vn * normal
    return new_position, velocity.copy()


def step(position, velocity, dt=TIME_STEP):
    position = position + velocity * dt
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
    return position, velocity, hits


def advance(position, velocity, elapsed):
    n_steps = int(elapsed / TIME_STEP + 1e-9)
    hits = []
    for _ in range(n_steps):
        position, velocity, hits = step(position, velocity)
    left_over = max(0.0, elapsed - n_steps * TIME_STEP)
    return position, velocity, hits, left_over
""",
    ),
    Wrong(
        "K.1",
        "Lets the sideways part of the velocity grow in proportion to the offset, instead of "
        "the angle",
        ("sideways_by_the_offset",),
        """
import math

STEEPEST = math.radians(60)

def paddle_bounce(offset, speed):
    offset = max(-1, min(1, offset))
    vx = offset * speed * math.sin(STEEPEST)
    vy = math.sqrt(speed ** 2 - vx ** 2)
    return (vx, vy)
""",
    ),
    Wrong(
        "K.2",
        "Grows the brick to a larger rectangle with square corners, and so hits it there too "
        "early and with the normal of a face",
        ("square_corners",),
        """
import math
import numpy as np

HORIZON = 1.0

def brick_impact(position, velocity, radius, box):
    x, y, w, h = box
    lo = [x - radius, y - radius]
    hi = [x + w + radius, y + h + radius]
    t_in, t_out = -math.inf, math.inf
    normal = None
    for k in range(2):
        if velocity[k] == 0:
            if position[k] <= lo[k] or position[k] >= hi[k]:
                return None
            continue
        t1 = (lo[k] - position[k]) / velocity[k]
        t2 = (hi[k] - position[k]) / velocity[k]
        if max(t1, t2) < t_out:
            t_out = max(t1, t2)
        if min(t1, t2) > t_in:
            t_in = min(t1, t2)
            normal = np.zeros(2)
            normal[k] = -1.0 if velocity[k] > 0 else 1.0
    if normal is None or t_in > t_out or t_in < 0 or t_in > HORIZON:
        return None
    return t_in, normal
""",
    ),
    Wrong(
        "K.3",
        "Takes the broken brick out of the list and then notes places in the shortened list, "
        "not those in `bricks`",
        ("places_among_those_left",),
        """
import math

import numpy as np

HORIZON = 1.0


def brick_impact(position, velocity, radius, box):
    x, y, w, h = box
    lo, hi = (x, y), (x + w, y + h)
    best = None
    for k in (0, 1):
        if velocity[k] == 0:
            continue
        face, sign = (lo[k] - radius, -1.0) if velocity[k] > 0 else (hi[k] + radius, 1.0)
        t = (face - position[k]) / velocity[k]
        other = position[1 - k] + velocity[1 - k] * t
        if t >= 0 and lo[1 - k] <= other <= hi[1 - k] and (best is None or t < best[0]):
            normal = np.zeros(2)
            normal[k] = sign
            best = (t, normal)
    for cx in (lo[0], hi[0]):
        for cy in (lo[1], hi[1]):
            d = position - np.array([cx, cy])
            a, b, c = velocity @ velocity, d @ velocity, d @ d - radius**2
            disc = b * b - a * c
            if b >= 0 or disc < 0:
                continue
            t = (-b - math.sqrt(disc)) / a
            if t >= 0 and (best is None or t < best[0]):
                best = (t, (d + velocity * t) / radius)
    if best is None or best[0] > HORIZON:
        return None
    return best


def fly(position, velocity, radius, bricks, duration):
    remaining = [b for b in bricks]
    broken = []
    time_left = duration
    while True:
        first = None
        for k, brick in enumerate(remaining):
            impact = brick_impact(position, velocity, radius, brick)
            if impact is None or impact[0] > time_left:
                continue
            if first is None or impact[0] < first[0]:
                first = (impact[0], impact[1], k)
        if first is None:
            break
        t, normal, k = first
        position = position + velocity * t
        velocity = velocity - 2 * np.dot(velocity, normal) * normal
        time_left -= t
        remaining.pop(k)
        broken.append(k)
    return position + velocity * time_left, velocity, broken
""",
    ),
    Wrong(
        "C.1",
        "Goes through the row once from left to right and does not go back to pairs that have "
        "begun to approach again",
        ("one_pass",),
        """
import numpy as np

SLOWEST = 1e-12

def collide_row(masses, velocities, restitution):
    v = np.array(velocities, dtype=float)
    for i in range(len(v) - 1):
        diff = v[i] - v[i + 1]
        if diff > SLOWEST:
            m, M = masses[i], masses[i + 1]
            J = (1 + restitution) * diff * m * M / (m + M)
            v[i] -= J / m
            v[i + 1] += J / M
    return v
""",
    ),
    Wrong(
        "C.3",
        "Keeps the two rates for the swap in a slice, which is a view and no copy, so that the "
        "second ball gets back its own rate",
        ("ignored",),
        """
import numpy as np

GRAVITY = 9.81

def cradle(angles, rates, length, dt, steps):
    angles = np.array(angles, dtype=float)
    rates = np.array(rates, dtype=float)
    n = len(angles)
    for _ in range(int(steps)):
        rates += -GRAVITY / length * np.sin(angles) * dt
        angles += rates * dt
        i = 0
        while i < n - 1:
            if angles[i] >= angles[i + 1] and rates[i] > rates[i + 1]:
                old = rates[i:i + 2]
                rates[i] = old[1]
                rates[i + 1] = old[0]
                i = 0
            else:
                i += 1
    return angles, rates
""",
    ),
    Wrong(
        "D.1",
        "Takes the angle of the diagonal over the base for the angle of the lean, so that a "
        "slim domino would lean farther than a wide one",
        ("upside_down",),
        """
import math

def tipping_angle(width, height):
    return math.atan2(height, width)
""",
    ),
    Wrong(
        "D.3",
        "Writes the mean into the first rate and then computes the mean once more for the "
        "second domino, with the changed first rate",
        ("mean_of_the_mean",),
        """
import math
import numpy as np

GRAVITY = 9.81

def chain(angles, rates, height, spacing, dt, steps):
    a = np.array(angles, dtype=float)
    r = np.array(rates, dtype=float)
    touch = math.asin(spacing / height)
    for s in range(int(steps)):
        for i in range(len(a)):
            r[i] += 3 * GRAVITY / (2 * height) * math.sin(a[i]) * dt
            a[i] += r[i] * dt
        for i in range(len(a) - 1):
            if a[i] > touch and r[i] > r[i + 1]:
                r[i] = (r[i] + r[i + 1]) / 2
                r[i + 1] = (r[i] + r[i + 1]) / 2
        for i in range(len(a)):
            if a[i] > math.pi / 2:
                a[i] = math.pi / 2
                r[i] = 0.0
    return a, r
""",
    ),
    Wrong(
        "P.2",
        "Thinks that a stroke off the centre moves the ball less, because a part of the push "
        "goes into the spin",
        ("spin_takes_a_part",),
        """
import numpy as np

def strike(impulse, offset, mass, radius):
    part = np.sqrt(max(0.0, 1 - (offset / radius) ** 2))
    velocity = np.asarray(impulse, float) / mass * part
    inertia = 0.4 * mass * radius ** 2
    spin = -offset * np.linalg.norm(impulse) / inertia
    return velocity, spin
""",
    ),
    Wrong(
        "P.3",
        "Counts all pairs that touch, and not only those that also approach, before it divides "
        "the impulses",
        ("all_that_touch_count",),
        """
import numpy as np

TOUCHING = 2.001
ROUNDS = 20

def share_impact(positions, velocities, radius, restitution):
    v = np.array(velocities, dtype=float)
    n = len(v)
    contacts = []
    count = [0] * n
    for i in range(n):
        for j in range(i + 1, n):
            d = positions[j] - positions[i]
            dist = np.linalg.norm(d)
            if dist <= TOUCHING * radius:
                contacts.append((i, j, d / dist))
                count[i] += 1
                count[j] += 1
    for _ in range(ROUNDS):
        dv = np.zeros_like(v)
        for i, j, normal in contacts:
            closing = (v[i] - v[j]) @ normal
            if closing > 0:
                J = (1 + restitution) * closing / 2 / max(count[i], count[j])
                dv[i] -= J * normal
                dv[j] += J * normal
        v = v + dv
    return v
""",
    ),
    Wrong(
        "S.2",
        "Lets the damper answer to the size of the relative velocity, in whatever direction, "
        "not to its part along the spring",
        ("damps_the_speed",),
        """
import numpy as np

def ring_forces(positions, velocities, length, stiffness, damping):
    F = np.zeros((len(positions), 2))
    N = len(positions)
    for a in range(N):
        b = (a + 1) % N
        d = positions[b] - positions[a]
        dist = np.sqrt(d[0] ** 2 + d[1] ** 2)
        u = d / dist
        rel = velocities[b] - velocities[a]
        pull = stiffness * (dist - length) + damping * np.sqrt(rel[0] ** 2 + rel[1] ** 2)
        F[a] += pull * u
        F[b] -= pull * u
    return F
""",
    ),
    Wrong(
        "S.3",
        "Thinks that a gas pushes away from the middle of the ring, not at right angles to "
        "each edge",
        ("edges_away_from_the_middle",),
        """
import numpy as np

def pressure_forces(positions, area, stiffness):
    nxt = np.roll(positions, -1, axis=0)
    now = 0.5 * np.sum(positions[:, 0] * nxt[:, 1] - positions[:, 1] * nxt[:, 0])
    p = stiffness * (area / now - 1)
    middle = positions.mean(axis=0)
    edge_mid = (positions + nxt) / 2 - middle
    out = edge_mid / np.linalg.norm(edge_mid, axis=1, keepdims=True)
    lengths = np.linalg.norm(nxt - positions, axis=1, keepdims=True)
    half = 0.5 * p * lengths * out
    return half + np.roll(half, 1, axis=0)
""",
    ),
    Wrong(
        "S.4",
        "Adds g to the forces before the division by the mass, as if the acceleration of "
        "gravity were a force",
        ("gravity_over_the_mass",),
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
    d = np.roll(positions, -1, axis=0) - positions
    dist = np.linalg.norm(d, axis=1)
    u = d / dist[:, None]
    rel = np.roll(velocities, -1, axis=0) - velocities
    pull = stiffness * (dist - length) + damping * np.sum(rel * u, axis=1)
    f = pull[:, None] * u
    return f - np.roll(f, 1, axis=0)


def pressure_forces(positions, area, stiffness):
    p = stiffness * (area / ring_area(positions) - 1)
    d = np.roll(positions, -1, axis=0) - positions
    out = np.column_stack([d[:, 1], -d[:, 0]])
    half = p * out / 2
    return half + np.roll(half, 1, axis=0)


def drop(positions, velocities, length, area, steps):
    x = positions.copy()
    v = velocities.copy()
    for _ in range(int(steps)):
        force = ring_forces(x, v, length, STIFFNESS, DAMPING) + pressure_forces(x, area, PRESSURE)
        force[:, 1] -= GRAVITY
        v = v + (force / MASS - AIR * v) * TIME_STEP
        x = x + v * TIME_STEP
        for i in range(len(x)):
            if x[i, 1] < 0:
                x[i, 1] = 0
                v[i, 1] = max(v[i, 1], 0)
                v[i, 0] *= GRIP
    return x, v
""",
    ),
)
