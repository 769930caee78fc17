"""Wrong answers that a beginner of 16 to 20 hands in, written before the slips were looked at.

When they were first tried, after what ELEVENTH had taught, 100 of 110 had a hint, and two of these
a false one; 104 have one now, and none is false.
"""

from __future__ import annotations

from course.recognition.students import Wrong

TWELFTH = (
    Wrong(
        "1.1",
        "adds v_centre once instead of twice",
        ("factor",),
        """
def elastic_1d(m1, v1, m2, v2):
    vc = (m1 * v1 + m2 * v2) / (m1 + m2)
    return vc - v1, vc - v2
""",
    ),
    Wrong(
        "1.1",
        "masses in the second formula not exchanged",
        ("sign",),
        """
def elastic_1d(m1, v1, m2, v2):
    M = m1 + m2
    v1_new = ((m1 - m2) * v1 + 2 * m2 * v2) / M
    v2_new = ((m1 - m2) * v2 + 2 * m1 * v1) / M
    return v1_new, v2_new
""",
    ),
    Wrong(
        "1.1",
        "forgets the second term: v2 after without m1's share",
        ("term",),
        """
def elastic_1d(m1, v1, m2, v2):
    u1 = (m1 - m2) / (m1 + m2) * v1 + 2 * m2 / (m1 + m2) * v2
    u2 = (m2 - m1) / (m1 + m2) * v2
    return u1, u2
""",
    ),
    Wrong(
        "1.1",
        "answers rounded to two places",
        ("rounding",),
        """
def elastic_1d(m1, v1, m2, v2):
    vc = (m1 * v1 + m2 * v2) / (m1 + m2)
    return round(2 * vc - v1, 2), round(2 * vc - v2, 2)
""",
    ),
    Wrong(
        "1.2",
        "mean of both velocities",
        ("plain_average",),
        """
def inelastic_1d(m1, v1, m2, v2):
    v = (v1 + v2) / 2
    return v, v
""",
    ),
    Wrong(
        "1.2",
        "weights exchanged",
        ("weights_exchanged",),
        """
def inelastic_1d(m1, v1, m2, v2):
    v = (m2 * v1 + m1 * v2) / (m1 + m2)
    return (v, v)
""",
    ),
    Wrong(
        "1.3",
        "impulse of body 1 instead of 2",
        ("impulse_on_the_first",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    v1_new = ((m1 - m2) * v1 + 2 * m2 * v2) / (m1 + m2)
    return m1 * (v1_new - v1)
""",
    ),
    Wrong(
        "1.3",
        "momentum afterwards instead of the change",
        (
            "ignored",
            "term",
        ),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    v2_new = ((m2 - m1) * v2 + 2 * m1 * v1) / (m1 + m2)
    return m2 * v2_new
""",
    ),
    Wrong(
        "2.1",
        "numerator the sum of speeds",
        ("speeds_added_up",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    return (abs(v2_after) + abs(v1_after)) / (abs(v1) + abs(v2))
""",
    ),
    Wrong(
        "2.1",
        "upside down",
        ("upside_down",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    return (v1 - v2) / (v2_after - v1_after)
""",
    ),
    Wrong(
        "2.2",
        "e multiplies only the first velocity's part",
        ("factor_missing",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    vc = (m1 * v1 + m2 * v2) / (m1 + m2)
    return vc + restitution * (vc - v1), vc + (vc - v2)
""",
    ),
    Wrong(
        "2.2",
        "minus: 1 - e in the impulse",
        (
            "sign",
            "term",
        ),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    mu = m1 * m2 / (m1 + m2)
    p = (1 - restitution) * mu * (v1 - v2)
    return v1 - p / m1, v2 + p / m2
""",
    ),
    Wrong(
        "2.2",
        "divides the impulse by the wrong masses",
        (
            "other",
            "exchanged",
        ),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    mu = m1 * m2 / (m1 + m2)
    p = (1 + restitution) * mu * (v1 - v2)
    return v1 - p / m2, v2 + p / m1
""",
    ),
    Wrong(
        "2.3",
        "begins with the drop height",
        ("starts_with_the_drop",),
        """
def bounce_heights(height, restitution, count):
    result = []
    h = height
    for i in range(count):
        result.append(h)
        h = h * restitution**2
    return result
""",
    ),
    Wrong(
        "2.3",
        "e times 2 instead of e squared",
        ("power",),
        """
def bounce_heights(height, restitution, count):
    out = []
    for i in range(count):
        height = height * restitution * 2
        out.append(height)
    return out
""",
    ),
    Wrong(
        "2.4",
        "each hop counted once instead of up and down",
        ("forgets_the_way_up",),
        """
def rest_time(height, restitution, gravity):
    t0 = (2 * height / gravity) ** 0.5
    return t0 + t0 * restitution / (1 - restitution)
""",
    ),
    Wrong(
        "2.4",
        "fall time with h/2g",
        ("factor",),
        """
def rest_time(height, restitution, gravity):
    t0 = (height / (2 * gravity)) ** 0.5
    return t0 * (1 + restitution) / (1 - restitution)
""",
    ),
    Wrong(
        "2.4",
        "sums fifty hops only, each with e instead of e^k",
        ("ten_bounces",),
        """
def rest_time(height, restitution, gravity):
    t0 = math.sqrt(2 * height / gravity)
    total = t0
    for k in range(1, 50):
        total += 2 * t0 * restitution
    return total
""",
    ),
    Wrong(
        "2.4",
        "hops shrink by e squared",
        ("times_shrink_like_heights",),
        """
def rest_time(height, restitution, gravity):
    t0 = math.sqrt(2 * height / gravity)
    q = restitution**2
    return t0 + 2 * t0 * q / (1 - q)
""",
    ),
    Wrong(
        "3.1",
        "2 (v.n) without n squared: subtracts from both components",
        ("factor_missing",),
        """
def reflect(incident, normal):
    k = 2 * (incident[0] * normal[0] + incident[1] * normal[1])
    return np.array([incident[0] - k, incident[1] - k])
""",
    ),
    Wrong(
        "3.1",
        "projects on the tangent: v - (v.n) n",
        ("slides_along",),
        """
def reflect(incident, normal):
    return incident - (incident @ normal) * normal
""",
    ),
    Wrong(
        "3.2",
        "gate the wrong way round",
        ("gate_inverted",),
        """
def bounce(velocity, normal, restitution):
    s = np.dot(velocity, normal)
    if s < 0:
        return velocity
    return velocity - (1 + restitution) * s * normal
""",
    ),
    Wrong(
        "3.2",
        "restitution squared",
        ("power_more",),
        """
def bounce(velocity, normal, restitution):
    s = np.dot(velocity, normal)
    if s >= 0:
        return velocity
    return velocity - (1 + restitution**2) * s * normal
""",
    ),
    Wrong(
        "3.2",
        "slow balls are left alone",
        ("too_slow_to_count",),
        """
def bounce(velocity, normal, restitution):
    s = np.dot(velocity, normal)
    if s > -0.1:
        return velocity
    return velocity - (1 + restitution) * s * normal
""",
    ),
    Wrong(
        "3.3",
        "moves half the depth",
        ("moves_half_the_depth",),
        """
def resolve_wall(position, velocity, normal, depth, restitution):
    position = position + 0.5 * depth * normal
    return position, bounce(velocity, normal, restitution)
""",
    ),
    Wrong(
        "3.3",
        "moved along the velocity back",
        ("back_along_the_path",),
        """
def resolve_wall(position, velocity, normal, depth, restitution):
    direction = velocity / np.hypot(*velocity)
    position = position - depth * direction
    return position, bounce(velocity, normal, restitution)
""",
    ),
    Wrong(
        "4.1",
        "depth is the distance of the centres minus radii (negative)",
        ("gap_as_depth",),
        """
def circle_contact(p1, r1, p2, r2):
    d = np.hypot(p2[0] - p1[0], p2[1] - p1[1])
    if d >= r1 + r2:
        return None
    n = (p2 - p1) / d if d > 0 else np.array([1.0, 0.0])
    return n, d - r1 - r2
""",
    ),
    Wrong(
        "4.1",
        "normal from 2 to 1",
        ("normal_from_2_to_1",),
        """
def circle_contact(p1, r1, p2, r2):
    way = p1 - p2
    d = np.linalg.norm(way)
    if d >= r1 + r2:
        return None
    if d == 0:
        return np.array([1.0, 0.0]), r1 + r2
    return way / d, r1 + r2 - d
""",
    ),
    Wrong(
        "4.1",
        "normal not divided by the distance",
        ("not_normalised",),
        """
def circle_contact(p1, r1, p2, r2):
    way = p2 - p1
    d = np.hypot(*way)
    if d >= r1 + r2:
        return None
    if d == 0:
        return np.array([1.0, 0.0]), r1 + r2
    return way, r1 + r2 - d
""",
    ),
    Wrong(
        "4.2",
        "impulse with mean mass",
        ("together",),
        """
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    vn = (v2 - v1) @ normal
    if vn >= 0:
        return v1, v2
    j = -(1 + restitution) * vn * (m1 + m2) / 2
    return v1 - j / m1 * normal, v2 + j / m2 * normal
""",
    ),
    Wrong(
        "4.2",
        "velocity 2 changes by the same sign",
        ("sign",),
        """
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    vn = (v2 - v1) @ normal
    if vn >= 0:
        return v1, v2
    j = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - j / m1 * normal, v2 - j / m2 * normal
""",
    ),
    Wrong(
        "4.2",
        "e only: (e) instead of (1 + e)",
        (
            "term",
            "product",
        ),
        """
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    vn = (v2 - v1) @ normal
    if vn >= 0:
        return v1, v2
    j = -restitution * vn / (1 / m1 + 1 / m2)
    return v1 - j / m1 * normal, v2 + j / m2 * normal
""",
    ),
    Wrong(
        "4.3",
        "each moved by the whole depth",
        ("the_whole_depth_each",),
        """
def separate(p1, m1, p2, m2, normal, depth):
    return p1 - depth * normal, p2 + depth * normal
""",
    ),
    Wrong(
        "4.3",
        "heavier moves further",
        ("in_proportion_to_mass",),
        """
def separate(p1, m1, p2, m2, normal, depth):
    if math.isinf(m1):
        return p1, p2 + depth * normal
    if math.isinf(m2):
        return p1 - depth * normal, p2
    M = m1 + m2
    return p1 - m1 / M * depth * normal, p2 + m2 / M * depth * normal
""",
    ),
    Wrong(
        "4.4",
        "bounces before masses: equal masses in separation",
        ("half_each_and_bounced",),
        """
def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    p1 = p1 - depth / 2 * normal
    p2 = p2 + depth / 2 * normal
    v1, v2 = resolve_circles(v1, m1, v2, m2, normal, restitution)
    return p1, v1, p2, v2
""",
    ),
    Wrong(
        "4.4",
        "only separated, velocities as they were",
        ("towards_each_other",),
        """
def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    q1, q2 = separate(p1, m1, p2, m2, normal, depth)
    return q1, v1, q2, v2
""",
    ),
    Wrong(
        "5.1",
        "about the origin, centroid not taken off",
        ("about_the_origin",),
        """
def moment_of_inertia(mass, vertices):
    total = area = 0.0
    n = len(vertices)
    for i in range(n):
        a, b = vertices[i], vertices[(i + 1) % n]
        w = cross(a, b)
        area += w / 2
        total += w * (a @ a + a @ b + b @ b) / 12
    return mass * total / area
""",
    ),
    Wrong(
        "5.1",
        "mixed term a.b counted twice",
        ("factor",),
        """
def moment_of_inertia(mass, vertices):
    c = np.zeros(2)
    area = total = 0.0
    n = len(vertices)
    for i in range(n):
        a, b = vertices[i], vertices[(i + 1) % n]
        w = cross(a, b)
        area += w / 2
        c = c + w * (a + b) / 6
        total += w * (a @ a + 2 * (a @ b) + b @ b) / 12
    c = c / area
    return mass * (total / area - c @ c)
""",
    ),
    Wrong(
        "5.2",
        "w times r, not turned",
        ("along_the_lever",),
        """
def contact_velocity(v, w, r):
    return v + w * r
""",
    ),
    Wrong(
        "5.2",
        "sign of the first component",
        ("swapped_without_sign",),
        """
def contact_velocity(v, w, r):
    return np.array([v[0] + w * r[1], v[1] + w * r[0]])
""",
    ),
    Wrong(
        "5.3",
        "inertia of a used for both arms",
        ("other",),
        """
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    a = cross(r_a, direction)
    b = cross(r_b, direction)
    return 1 / m_a + 1 / m_b + a * a / i_a + b * b / i_a
""",
    ),
    Wrong(
        "5.3",
        "returns the effective mass",
        ("the_mass_itself",),
        """
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    a = cross(r_a, direction)
    b = cross(r_b, direction)
    return 1 / (1 / m_a + 1 / m_b + a * a / i_a + b * b / i_b)
""",
    ),
    Wrong(
        "5.4",
        "limit without friction coefficient",
        ("factor_missing",),
        """
def friction_impulse(vt, jn, friction, k):
    j = -vt / k
    if j > jn:
        return jn
    if j < -jn:
        return -jn
    return j
""",
    ),
    Wrong(
        "5.4",
        "over the limit it slides without friction: 0",
        ("none_beyond_the_limit",),
        """
def friction_impulse(vt, jn, friction, k):
    j = -vt / k
    if abs(j) > friction * jn:
        return 0.0
    return j
""",
    ),
    Wrong(
        "5.5",
        "lever + radius n",
        ("sign",),
        """
def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    r = radius * normal
    t = np.array([-normal[1], normal[0]])
    v = contact_velocity(velocity, w, r)
    if v @ normal >= 0:
        return velocity, w
    I = radius**2 / 2
    jn = -(1 + restitution) * (v @ normal)
    jt = friction_impulse(v @ t, jn, friction, 1 + radius**2 / I)
    J = jn * normal + jt * t
    return velocity + J, w + cross(r, J) / I
""",
    ),
    Wrong(
        "5.5",
        "inertia of a ring",
        ("factor",),
        """
def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    r = -radius * normal
    t = np.array([-normal[1], normal[0]])
    v = contact_velocity(velocity, w, r)
    if v @ normal >= 0:
        return velocity, w
    I = radius**2
    jn = -(1 + restitution) * (v @ normal)
    jt = friction_impulse(v @ t, jn, friction, 1 + radius**2 / I)
    J = jn * normal + jt * t
    return velocity + J, w + cross(r, J) / I
""",
    ),
    Wrong(
        "6.1",
        "edges not divided by length",
        ("axes_not_unit",),
        """
def sat_axes(vertices):
    axes = []
    for i in range(len(vertices)):
        x, y = vertices[i] - vertices[i - 1]
        if x != 0 or y != 0:
            axes.append(np.array([y, -x]))
    return axes
""",
    ),
    Wrong(
        "6.1",
        "direction of the edge rather than its normal",
        ("edges_for_normals",),
        """
def sat_axes(vertices):
    axes = []
    for i in range(len(vertices)):
        e = vertices[i] - vertices[i - 1]
        l = np.hypot(*e)
        if l > 0:
            axes.append(e / l)
    return axes
""",
    ),
    Wrong(
        "6.2",
        "max and min of coordinates, then projected",
        ("shadow_of_the_box",),
        """
def project(vertices, axis):
    low = vertices.min(axis=0) @ axis
    high = vertices.max(axis=0) @ axis
    return low, high
""",
    ),
    Wrong(
        "6.2",
        "high minus low",
        ("low_and_length",),
        """
def project(vertices, axis):
    s = [v[0] * axis[0] + v[1] * axis[1] for v in vertices]
    return min(s), max(s) - min(s)
""",
    ),
    Wrong(
        "6.3",
        "the longer way",
        ("longer_way_out",),
        """
def overlap(interval_a, interval_b):
    x = interval_a[1] - interval_b[0]
    y = interval_b[1] - interval_a[0]
    if x <= 0 or y <= 0:
        return None
    return max(x, y)
""",
    ),
    Wrong(
        "6.3",
        "length of the common part",
        ("common_part",),
        """
def overlap(interval_a, interval_b):
    low = max(interval_a[0], interval_b[0])
    high = min(interval_a[1], interval_b[1])
    return high - low if high > low else None
""",
    ),
    Wrong(
        "6.4",
        "axes of A only",
        ("axes_of_a_only",),
        """
def mtv(vertices_a, vertices_b):
    best = None
    for axis in sat_axes(vertices_a):
        d = overlap(project(vertices_a, axis), project(vertices_b, axis))
        if d is None:
            return None
        if best is None or d < best[1]:
            if (vertices_b.mean(axis=0) - vertices_a.mean(axis=0)) @ axis < 0:
                axis = -axis
            best = axis, d
    return best
""",
    ),
    Wrong(
        "6.4",
        "goes on after a gap",
        ("a_gap_is_passed_over",),
        """
def mtv(vertices_a, vertices_b):
    best = None
    for axis in sat_axes(vertices_a) + sat_axes(vertices_b):
        la, ha = project(vertices_a, axis)
        lb, hb = project(vertices_b, axis)
        for n, d in ((axis, ha - lb), (-axis, hb - la)):
            if d <= 0:
                continue
            if best is None or d < best[1]:
                best = n, d
    return best
""",
    ),
    Wrong(
        "6.5",
        "crossing measured from the wrong end",
        ("counts_from_the_wrong_end",),
        """
def clip(start, end, normal, offset):
    s = start @ normal - offset
    e = end @ normal - offset
    if s > 0 and e > 0:
        return None
    if s <= 0 and e <= 0:
        return start, end
    x = start + e / (e - s) * (end - start)
    return (x, end) if s > 0 else (start, x)
""",
    ),
    Wrong(
        "6.5",
        "keeps the outer part",
        ("keeps_the_other_side",),
        """
def clip(start, end, normal, offset):
    s = start @ normal - offset
    e = end @ normal - offset
    if s < 0 and e < 0:
        return None
    if s >= 0 and e >= 0:
        return start, end
    x = start + s / (s - e) * (end - start)
    return (x, end) if s < 0 else (start, x)
""",
    ),
    Wrong(
        "6.5",
        "distances without sign",
        (
            "sign",
            "absolute",
        ),
        """
def clip(start, end, normal, offset):
    s = start @ normal - offset
    e = end @ normal - offset
    if s > 0 and e > 0:
        return None
    if s <= 0 and e <= 0:
        return start, end
    x = start + abs(s) / abs(s + e) * (end - start)
    return (x, end) if s > 0 else (start, x)
""",
    ),
    Wrong(
        "6.6",
        "centre inside not treated",
        ("deeper_when_inside",),
        """
def circle_against_polygon(centre, radius, vertices):
    best = None
    for i in range(len(vertices)):
        q = closest_point_on_segment(centre, vertices[i - 1], vertices[i])
        if best is None or np.linalg.norm(centre - q) < np.linalg.norm(best):
            best = centre - q
    d = np.linalg.norm(best)
    if d >= radius:
        return None
    return best / d, radius - d
""",
    ),
    Wrong(
        "6.6",
        "normal from circle to polygon",
        ("sign",),
        """
def circle_against_polygon(centre, radius, vertices):
    n = len(vertices)
    q = [closest_point_on_segment(centre, vertices[i], vertices[(i + 1) % n]) for i in range(n)]
    w = min((p - centre for p in q), key=lambda u: u @ u)
    d = math.sqrt(w @ w)
    inside = all(
        cross(vertices[(i + 1) % n] - vertices[i], centre - vertices[i]) > 0 for i in range(n)
    )
    if inside:
        return -w / d, radius + d
    return (w / d, radius - d) if d < radius else None
""",
    ),
    Wrong(
        "6.6",
        "squared distance compared with the radius",
        ("root",),
        """
def circle_against_polygon(centre, radius, vertices):
    n = len(vertices)
    ways = [
        centre - closest_point_on_segment(centre, vertices[i], vertices[(i + 1) % n])
        for i in range(n)
    ]
    w = min(ways, key=lambda u: u @ u)
    d = w @ w
    inside = all(
        cross(vertices[(i + 1) % n] - vertices[i], centre - vertices[i]) > 0 for i in range(n)
    )
    if inside:
        return -w / d, radius + d
    return (w / d, radius - d) if d < radius else None
""",
    ),
    Wrong(
        "7.1",
        "the later root",
        ("the_later_root",),
        """
def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d, v = p2 - p1, v2 - v1
    a, b, c = v @ v, 2 * (d @ v), d @ d - (r1 + r2) ** 2
    if c <= 0 and b < 0:
        return 0.0
    disc = b * b - 4 * a * c
    if disc < 0 or b >= 0:
        return None
    t = (-b + math.sqrt(disc)) / (2 * a)
    return t if t <= dt else None
""",
    ),
    Wrong(
        "7.1",
        "radii squared one by one",
        ("squares",),
        """
def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d, v = p2 - p1, v2 - v1
    a, b, c = v @ v, d @ v, d @ d - (r1**2 + r2**2)
    disc = b * b - a * c
    if b >= 0 or disc < 0:
        return None
    if c <= 0:
        return 0.0
    t = c / (-b + math.sqrt(disc))
    return t if t <= dt else None
""",
    ),
    Wrong(
        "7.2",
        "g t^2 without one half",
        ("half_forgotten",),
        """
def time_to_floor(height, velocity, gravity):
    root = math.sqrt(velocity**2 + 4 * gravity * height)
    if velocity < 0:
        return 2 * height / (root - velocity)
    if gravity == 0:
        return None
    return (velocity + root) / (2 * gravity)
""",
    ),
    Wrong(
        "7.2",
        "only to the top and down, from rest height: velocity ignored for the fall",
        ("falls_from_the_start",),
        """
def time_to_floor(height, velocity, gravity):
    if gravity == 0:
        return height / -velocity if velocity < 0 else None
    if velocity < 0:
        return 2 * height / (math.sqrt(velocity**2 + 2 * gravity * height) - velocity)
    return velocity / gravity + math.sqrt(2 * height / gravity)
""",
    ),
    Wrong(
        "7.3",
        "after the impact the whole step again",
        (
            "step",
            "term",
        ),
        """
def advance(p, v, room, restitution, dt):
    while True:
        t = (np.where(v > 0, room, 0.0) - p) / v
        k = np.argmin(t)
        if t[k] >= dt:
            return p + v * dt, v
        p = p + v * t[k]
        v = v.copy()
        v[k] = -restitution * v[k]
""",
    ),
    Wrong(
        "7.3",
        "e on both components",
        ("scales_the_tangent",),
        """
def advance(p, v, room, restitution, dt):
    left = dt
    while True:
        t = (np.where(v > 0, room, 0.0) - p) / v
        k = np.argmin(t)
        if t[k] >= left:
            return p + v * left, v
        p = p + v * t[k]
        left -= t[k]
        v = restitution * v
        v[k] = -v[k]
""",
    ),
    Wrong(
        "7.4",
        "returns the last instead of the first event",
        ("the_last_event",),
        """
def next_event(positions, velocities, radii):
    best = None
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            t = sweep_circles(
                positions[i],
                velocities[i],
                radii[i],
                positions[j],
                velocities[j],
                radii[j],
                math.inf,
            )
            if t is not None and (best is None or t > best[0]):
                best = (t, i, j)
    return best
""",
    ),
    Wrong(
        "7.4",
        "an event at once counts as none: if t",
        ("now_is_no_time",),
        """
def next_event(positions, velocities, radii):
    best = None
    for i in range(len(radii)):
        for j in range(i + 1, len(radii)):
            t = sweep_circles(
                positions[i],
                velocities[i],
                radii[i],
                positions[j],
                velocities[j],
                radii[j],
                math.inf,
            )
            if t and (best is None or t < best[0]):
                best = (t, i, j)
    return best
""",
    ),
    Wrong(
        "7.5",
        "counts the wall hits only",
        ("count",),
        """
def pi_collisions(mass_ratio):
    a, b, n = 0.0, -1.0, 0
    while a > b:
        c = (a + mass_ratio * b) / (1 + mass_ratio)
        a, b = 2 * c - a, 2 * c - b
        if a < 0:
            a = -a
            n += 1
    return n
""",
    ),
    Wrong(
        "8.1",
        "mean of the distances",
        ("the_mean_distance",),
        """
def largest_error(places, right):
    d = np.hypot(*(places - right).T)
    return d.mean()
""",
    ),
    Wrong(
        "8.1",
        "largest single component",
        ("the_larger_coordinate",),
        """
def largest_error(places, right):
    return np.max(np.abs(places - right))
""",
    ),
    Wrong(
        "8.2",
        "difference of errors over difference of steps",
        ("ratio",),
        """
def observed_order(dt_1, error_1, dt_2, error_2):
    return (math.log(error_1) - math.log(error_2)) / math.log(dt_1 - dt_2)
""",
    ),
    Wrong(
        "8.2",
        "steps the other way round",
        ("wrong_sign",),
        """
def observed_order(dt_1, error_1, dt_2, error_2):
    return math.log(error_1 / error_2) / math.log(dt_2 / dt_1)
""",
    ),
    Wrong(
        "8.3",
        "factor is not taken out of the logarithm",
        ("logarithm_of_the_factor",),
        """
def fit_power(steps, errors):
    p, c = np.polyfit(np.log(steps), np.log(errors), 1)
    return p, c
""",
    ),
    Wrong(
        "8.3",
        "axes exchanged in the fit",
        ("step_over_error",),
        """
def fit_power(steps, errors):
    p, c = np.polyfit(np.log(errors), np.log(steps), 1)
    return p, math.exp(c)
""",
    ),
    Wrong(
        "8.4",
        "sum instead of product for the sweeps",
        ("a_sum_of_sweeps",),
        """
def best_split(table, sweeps):
    rows = [r for r in table if r[0] + r[1] == sweeps and r[2] < math.inf]
    if not rows:
        return None
    best = min(rows, key=lambda r: r[2])
    return best[0], best[1]
""",
    ),
    Wrong(
        "8.4",
        "rows that failed are not left out, and largest error",
        ("minmax",),
        """
def best_split(table, sweeps):
    rows = [r for r in table if r[0] * r[1] == sweeps and r[2] < math.inf]
    if not rows:
        return None
    best = max(rows, key=lambda r: r[2])
    return best[0], best[1]
""",
    ),
    Wrong(
        "8.5",
        "smallest error among the allowed",
        ("the_most_accurate",),
        """
def cheapest(table, allowed):
    k = None
    for n in range(len(table)):
        if table[n][1] <= allowed and (k is None or table[n][1] < table[k][1]):
            k = n
    return k
""",
    ),
    Wrong(
        "9.1",
        "weight of the box alone",
        ("own_weight",),
        """
def tower_forces(masses, gravity):
    return np.array([m * gravity for m in masses])
""",
    ),
    Wrong(
        "9.1",
        "boxes below rather than above",
        ("counted_from_the_floor",),
        """
def tower_forces(masses, gravity):
    out = []
    s = 0
    for m in masses:
        s = s + m
        out.append(s * gravity)
    return np.array(out)
""",
    ),
    Wrong(
        "9.2",
        "light and heavy exchanged",
        ("masses_swapped",),
        """
def sweeps_needed(light, heavy, left):
    return math.ceil(math.log(left) / math.log(light / (light + heavy)))
""",
    ),
    Wrong(
        "9.2",
        "rounded to the nearest",
        ("to_the_nearest",),
        """
def sweeps_needed(light, heavy, left):
    return round(-math.log(left) / math.log(1 + light / heavy))
""",
    ),
    Wrong(
        "9.3",
        "sign of friction",
        ("friction_drives",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    s = 1 if vt > 0 else -1
    k = knn + s * friction * knt
    if k <= 0:
        return None
    return -vn / k
""",
    ),
    Wrong(
        "9.4",
        "cross product the other way round",
        ("turns_the_other_way",),
        """
def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    v2 = velocity + impulse / mass
    w2 = w + (arm[1] * impulse[0] - arm[0] * impulse[1]) / inertia
    e1 = mass * velocity @ velocity + inertia * w**2
    e2 = mass * v2 @ v2 + inertia * w2**2
    return e2 / e1
""",
    ),
    Wrong(
        "9.5",
        "equal masses: swaps velocities",
        ("always_swaps",),
        """
def one_by_one(masses, velocities):
    v = [float(x) for x in velocities]
    again = True
    while again:
        again = False
        for k in range(len(v) - 1):
            if v[k] - v[k + 1] > 1e-9:
                v[k], v[k + 1] = v[k + 1], v[k]
                again = True
    return v
""",
    ),
    Wrong(
        "9.5",
        "goes through the row once",
        ("one_pass",),
        """
def one_by_one(masses, velocities):
    v = np.array(velocities, dtype=float)
    for k in range(len(v) - 1):
        if v[k] > v[k + 1]:
            m, n = masses[k], masses[k + 1]
            c = (m * v[k] + n * v[k + 1]) / (m + n)
            v[k], v[k + 1] = 2 * c - v[k], 2 * c - v[k + 1]
    return v
""",
    ),
    Wrong(
        "10.1",
        "arithmetic mean",
        ("mean_of_both",),
        """
def most_friction(inverse_masses, frictions):
    m = 0.0
    for i in range(len(frictions)):
        for j in range(i):
            if inverse_masses[i] > 0 or inverse_masses[j] > 0:
                m = max(m, (frictions[i] + frictions[j]) / 2)
    return m
""",
    ),
    Wrong(
        "10.2",
        "restitution wanted if either bounces",
        ("bounces_alone",),
        """
def effects_called_for(bodies, gravity):
    need = []
    pairs = [(a, b) for a, b in combinations(bodies, 2) if a[0] > 0 or b[0] > 0]
    rubs = any(a[3] > 0 and b[3] > 0 for a, b in pairs)
    if rubs:
        need.append("friction")
    if gravity[0] != 0 or gravity[1] != 0:
        need.append("gravity")
    if any(max(a[2], b[2]) > 0 for a, b in pairs):
        need.append("restitution")
    if rubs or any(b[4] != 0 or (b[0] > 0 and b[1] > 0) for b in bodies):
        need.append("rotation")
    return need
""",
    ),
    Wrong(
        "10.3",
        "own fastest disc now",
        ("fastest_now",),
        """
def fastest_way(masses, velocities, dt):
    return max(np.hypot(*v) for v in velocities) * dt
""",
    ),
    Wrong(
        "10.3",
        "heaviest instead of lightest",
        ("heaviest_is_fastest",),
        """
def fastest_way(masses, velocities, dt):
    e = sum(m * (v @ v) for m, v in zip(masses, velocities))
    return (e / max(masses)) ** 0.5 * dt
""",
    ),
    Wrong(
        "10.4",
        "g t^2 without one half",
        ("factor",),
        """
def box_of_flight(position, velocity, radius, gravity, duration):
    box = []
    for k in range(2):
        ts = [0, duration]
        if gravity[k] != 0:
            top = -velocity[k] / gravity[k]
            if 0 < top < duration:
                ts.append(top)
        xs = [position[k] + velocity[k] * t + gravity[k] * t * t for t in ts]
        box.append(min(xs) - radius)
        box.append(max(xs) + radius)
    return box
""",
    ),
    Wrong(
        "10.4",
        "the top of the flight forgotten when the ball starts downwards only; uses v / g",
        ("only_the_ends",),
        """
def box_of_flight(position, velocity, radius, gravity, duration):
    box = []
    for k in range(2):
        ts = [0, duration]
        if gravity[k] != 0:
            top = velocity[k] / gravity[k]
            if 0 < top < duration:
                ts.append(top)
        xs = [position[k] + velocity[k] * t + gravity[k] * t * t / 2 for t in ts]
        box += [min(xs) - radius, max(xs) + radius]
    return box
""",
    ),
    Wrong(
        "10.5",
        "static bodies listed, too",
        ("floors_sleep",),
        """
def bodies_asleep(inverse_masses, still, touches):
    n = len(still)
    awake = [i for i in range(n) if not still[i] and inverse_masses[i] > 0]
    k = 0
    while k < len(awake):
        for j in range(n):
            if touches[awake[k], j] and j not in awake and inverse_masses[j] > 0:
                awake.append(j)
        k += 1
    return [i for i in range(n) if i not in awake]
""",
    ),
    Wrong(
        "10.5",
        "asks direct neighbours only",
        ("only_neighbours",),
        """
def bodies_asleep(inverse_masses, still, touches):
    n = len(still)
    out = []
    for i in range(n):
        if inverse_masses[i] == 0 or not still[i]:
            continue
        if all(still[j] or inverse_masses[j] == 0 for j in range(n) if touches[i, j]):
            out.append(i)
    return out
""",
    ),
    Wrong(
        "11.1",
        "x and y: one is enough",
        ("and_or",),
        """
def near_pairs(boxes):
    out = []
    for i in range(len(boxes)):
        for j in range(i + 1, len(boxes)):
            a, b = boxes[i], boxes[j]
            x = a[0] <= b[1] and b[0] <= a[1]
            y = a[2] <= b[3] and b[2] <= a[3]
            if x or y:
                out.append((i, j))
    return out
""",
    ),
    Wrong(
        "11.2",
        "the normal's k used for friction, too",
        ("yields_alike_both_ways",),
        """
def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, vax, vay, wa = a
    mb, ib, vbx, vby, wb = b
    va, vb = np.array([vax, vay]), np.array([vbx, vby])
    t = np.array([-normal[1], normal[0]])
    ra, rb = np.array([-arm_a[1], arm_a[0]]), np.array([-arm_b[1], arm_b[0]])
    u = (vb + wb * rb - va - wa * ra) @ normal
    if u >= 0:
        return va, wa, vb, wb
    k = 1 / ma + 1 / mb + cross(arm_a, normal) ** 2 / ia + cross(arm_b, normal) ** 2 / ib
    jn = -(1 + restitution) * u / k
    va, vb = va - jn / ma * normal, vb + jn / mb * normal
    wa, wb = wa - jn * cross(arm_a, normal) / ia, wb + jn * cross(arm_b, normal) / ib
    s = (vb + wb * rb - va - wa * ra) @ t
    jt = max(-friction * jn, min(friction * jn, -s / k))
    va, vb = va - jt / ma * t, vb + jt / mb * t
    wa, wb = wa - jt * cross(arm_a, t) / ia, wb + jt * cross(arm_b, t) / ib
    return va, wa, vb, wb
""",
    ),
    Wrong(
        "11.2",
        "friction limit not applied downwards",
        ("clamp",),
        """
def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, vax, vay, wa = a
    mb, ib, vbx, vby, wb = b
    va, vb = np.array([vax, vay]), np.array([vbx, vby])
    t = np.array([-normal[1], normal[0]])
    ra, rb = np.array([-arm_a[1], arm_a[0]]), np.array([-arm_b[1], arm_b[0]])
    u = (vb + wb * rb - va - wa * ra) @ normal
    if u >= 0:
        return va, wa, vb, wb
    k = 1 / ma + 1 / mb + cross(arm_a, normal) ** 2 / ia + cross(arm_b, normal) ** 2 / ib
    jn = -(1 + restitution) * u / k
    va, vb = va - jn / ma * normal, vb + jn / mb * normal
    wa, wb = wa - jn * cross(arm_a, normal) / ia, wb + jn * cross(arm_b, normal) / ib
    s = (vb + wb * rb - va - wa * ra) @ t
    k = 1 / ma + 1 / mb + cross(arm_a, t) ** 2 / ia + cross(arm_b, t) ** 2 / ib
    jt = min(friction * jn, -s / k)
    va, vb = va - jt / ma * t, vb + jt / mb * t
    wa, wb = wa - jt * cross(arm_a, t) / ia, wb + jt * cross(arm_b, t) / ib
    return va, wa, vb, wb
""",
    ),
    Wrong(
        "11.2",
        "friction does not turn the bodies",
        ("friction_does_not_turn",),
        """
def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, vax, vay, wa = a
    mb, ib, vbx, vby, wb = b
    va, vb = np.array([vax, vay]), np.array([vbx, vby])
    t = np.array([-normal[1], normal[0]])
    ra, rb = np.array([-arm_a[1], arm_a[0]]), np.array([-arm_b[1], arm_b[0]])
    u = (vb + wb * rb - va - wa * ra) @ normal
    if u >= 0:
        return va, wa, vb, wb
    k = 1 / ma + 1 / mb + cross(arm_a, normal) ** 2 / ia + cross(arm_b, normal) ** 2 / ib
    jn = -(1 + restitution) * u / k
    va, vb = va - jn / ma * normal, vb + jn / mb * normal
    wa, wb = wa - jn * cross(arm_a, normal) / ia, wb + jn * cross(arm_b, normal) / ib
    s = (vb + wb * rb - va - wa * ra) @ t
    k = 1 / ma + 1 / mb + cross(arm_a, t) ** 2 / ia + cross(arm_b, t) ** 2 / ib
    jt = max(-friction * jn, min(friction * jn, -s / k))
    va, vb = va - jt / ma * t, vb + jt / mb * t
    return va, wa, vb, wb
""",
    ),
    Wrong(
        "11.2",
        "inertia left out of k for friction",
        (
            "yields_by_moving_alone",
            "term",
        ),
        """
def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, vax, vay, wa = a
    mb, ib, vbx, vby, wb = b
    va, vb = np.array([vax, vay]), np.array([vbx, vby])
    t = np.array([-normal[1], normal[0]])
    ra, rb = np.array([-arm_a[1], arm_a[0]]), np.array([-arm_b[1], arm_b[0]])
    u = (vb + wb * rb - va - wa * ra) @ normal
    if u >= 0:
        return va, wa, vb, wb
    k = 1 / ma + 1 / mb + cross(arm_a, normal) ** 2 / ia + cross(arm_b, normal) ** 2 / ib
    jn = -(1 + restitution) * u / k
    va, vb = va - jn / ma * normal, vb + jn / mb * normal
    wa, wb = wa - jn * cross(arm_a, normal) / ia, wb + jn * cross(arm_b, normal) / ib
    s = (vb + wb * rb - va - wa * ra) @ t
    k = 1 / ma + 1 / mb
    jt = max(-friction * jn, min(friction * jn, -s / k))
    va, vb = va - jt / ma * t, vb + jt / mb * t
    wa, wb = wa - jt * cross(arm_a, t) / ia, wb + jt * cross(arm_b, t) / ib
    return va, wa, vb, wb
""",
    ),
    Wrong(
        "11.3",
        "gravity not used",
        (
            "ignored",
            "term",
        ),
        """
def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    p = positions + velocities * dt
    v = velocities.copy()
    n = len(p)
    for i in range(n):
        for j in range(i + 1, n):
            way = p[j] - p[i]
            d = np.hypot(way[0], way[1])
            if d < radii[i] + radii[j]:
                way = way / d
                depth = radii[i] + radii[j] - d
                a, b = 1 / masses[i], 1 / masses[j]
                u = (v[j] - v[i]) @ way
                if u < 0:
                    k = -(1 + restitution) * u / (a + b)
                    v[i] -= k * a * way
                    v[j] += k * b * way
                p[i] -= depth * a / (a + b) * way
                p[j] += depth * b / (a + b) * way
    for i in range(n):
        for x in (0, 1):
            if p[i][x] < radii[i]:
                p[i][x] = radii[i]
                if v[i][x] < 0:
                    v[i][x] *= -restitution
            if p[i][x] > room[x] - radii[i]:
                p[i][x] = room[x] - radii[i]
                if v[i][x] > 0:
                    v[i][x] *= -restitution
    return p, v
""",
    ),
    Wrong(
        "11.3",
        "discs are not pushed apart",
        (
            "step",
            "term",
        ),
        """
def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    p = positions + velocities * dt
    v = velocities + gravity * dt
    n = len(p)
    for i in range(n):
        for j in range(i + 1, n):
            way = p[j] - p[i]
            d = np.hypot(way[0], way[1])
            if d < radii[i] + radii[j]:
                way = way / d
                depth = radii[i] + radii[j] - d
                a, b = 1 / masses[i], 1 / masses[j]
                u = (v[j] - v[i]) @ way
                if u < 0:
                    k = -(1 + restitution) * u / (a + b)
                    v[i] -= k * a * way
                    v[j] += k * b * way
    for i in range(n):
        for x in (0, 1):
            if p[i][x] < radii[i]:
                p[i][x] = radii[i]
                if v[i][x] < 0:
                    v[i][x] *= -restitution
            if p[i][x] > room[x] - radii[i]:
                p[i][x] = room[x] - radii[i]
                if v[i][x] > 0:
                    v[i][x] *= -restitution
    return p, v
""",
    ),
    Wrong(
        "11.3",
        "walls take no speed away",
        ("factor_missing",),
        """
def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    p = positions + velocities * dt
    v = velocities + gravity * dt
    n = len(p)
    for i in range(n):
        for j in range(i + 1, n):
            way = p[j] - p[i]
            d = np.hypot(way[0], way[1])
            if d < radii[i] + radii[j]:
                way = way / d
                depth = radii[i] + radii[j] - d
                a, b = 1 / masses[i], 1 / masses[j]
                u = (v[j] - v[i]) @ way
                if u < 0:
                    k = -(1 + restitution) * u / (a + b)
                    v[i] -= k * a * way
                    v[j] += k * b * way
                p[i] -= depth * a / (a + b) * way
                p[j] += depth * b / (a + b) * way
    for i in range(n):
        for x in (0, 1):
            if p[i][x] < radii[i]:
                p[i][x] = radii[i]
                if v[i][x] < 0:
                    v[i][x] *= -1
            if p[i][x] > room[x] - radii[i]:
                p[i][x] = room[x] - radii[i]
                if v[i][x] > 0:
                    v[i][x] *= -1
    return p, v
""",
    ),
    Wrong(
        "11.3",
        "radius forgotten at the walls",
        ("centres_at_the_walls",),
        """
def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    p = positions + velocities * dt
    v = velocities + gravity * dt
    n = len(p)
    for i in range(n):
        for j in range(i + 1, n):
            way = p[j] - p[i]
            d = np.hypot(way[0], way[1])
            if d < radii[i] + radii[j]:
                way = way / d
                depth = radii[i] + radii[j] - d
                a, b = 1 / masses[i], 1 / masses[j]
                u = (v[j] - v[i]) @ way
                if u < 0:
                    k = -(1 + restitution) * u / (a + b)
                    v[i] -= k * a * way
                    v[j] += k * b * way
                p[i] -= depth * a / (a + b) * way
                p[j] += depth * b / (a + b) * way
    for i in range(n):
        for x in (0, 1):
            if p[i][x] < 0:
                p[i][x] = 0
                if v[i][x] < 0:
                    v[i][x] *= -restitution
            if p[i][x] > room[x]:
                p[i][x] = room[x]
                if v[i][x] > 0:
                    v[i][x] *= -restitution
    return p, v
""",
    ),
    Wrong(
        "11.4",
        "all pairs that touch now have begun",
        ("everything_that_touches",),
        """
def touch_changes(before, now):
    old = {tuple(p) for p in before}
    new = {tuple(p) for p in now}
    return list(new), list(old - new)
""",
    ),
    Wrong(
        "11.4",
        "begun and parted exchanged",
        ("begun_and_parted_swapped",),
        """
def touch_changes(before, now):
    old = {tuple(p) for p in before}
    new = {tuple(p) for p in now}
    return list(old - new), list(new - old)
""",
    ),
    Wrong(
        "11.5",
        "exp without ln 2",
        ("e_in_place_of_two",),
        """
def glow(brightness, hit, dt, half_life):
    return np.where(hit, 1.0, brightness * np.exp(-dt / half_life))
""",
    ),
    Wrong(
        "11.5",
        "added up: brightness + 1 where hit",
        ("light_adds_up",),
        """
def glow(brightness, hit, dt, half_life):
    out = brightness * 0.5 ** (dt / half_life)
    return out + hit
""",
    ),
    Wrong(
        "11.6",
        "2 pi forgotten",
        ("without_two_pi",),
        """
def knock(loudness, frequency, half_life, rate, count):
    if frequency >= rate / 2:
        return np.zeros(count)
    t = np.arange(count) / rate
    return loudness * np.sin(frequency * t) * 0.5 ** (t / half_life)
""",
    ),
    Wrong(
        "11.6",
        "samples begin at 1",
        ("begins_with_the_second",),
        """
def knock(loudness, frequency, half_life, rate, count):
    if frequency >= rate / 2:
        return np.zeros(count)
    t = np.arange(1, count + 1) / rate
    return loudness * np.sin(2 * math.pi * frequency * t) * 0.5 ** (t / half_life)
""",
    ),
    Wrong(
        "11.6",
        "fades per sample instead of per second",
        ("a_sample_a_second",),
        """
def knock(loudness, frequency, half_life, rate, count):
    if frequency >= rate / 2:
        return np.zeros(count)
    n = np.arange(count)
    t = n / rate
    return loudness * np.sin(2 * np.pi * frequency * t) * 0.5 ** (n / half_life)
""",
    ),
)
