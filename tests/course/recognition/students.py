"""Wrong answers as students write them.

Their author had read the wrong models of chapters 01 to 03, and of no other. The slips were then
improved with these answers at hand, so that they show what is kept, and measure nothing new.

Each says what is wrong with it. `found` are words of which the diagnosis must hold one: the kind
of a slip, or the name of a wrong model. The names of 13 models were put in after they had been
found, and judged to be right.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Wrong:
    """An answer to a task, what is wrong with it, and the diagnoses that are right."""

    task: str
    cause: str
    found: tuple[str, ...]
    source: str


WRONG = (
    Wrong(
        "1.1",
        "no brackets around the sum of the masses",
        ("precedence",),
        """
def elastic_1d(m1, v1, m2, v2):
    a = ((m1 - m2) * v1 + 2 * m2 * v2) / m1 + m2
    b = ((m2 - m1) * v2 + 2 * m1 * v1) / m1 + m2
    return a, b
""",
    ),
    Wrong(
        "1.1",
        "m1 for m2 in the first line",
        ("other",),
        """
def elastic_1d(m1, v1, m2, v2):
    total = m1 + m2
    new_v1 = ((m1 - m2) * v1 + 2 * m1 * v2) / total
    new_v2 = ((m2 - m1) * v2 + 2 * m1 * v1) / total
    return new_v1, new_v2
""",
    ),
    Wrong(
        "1.1",
        "the sign between the two terms",
        ("sign",),
        """
def elastic_1d(m1, v1, m2, v2):
    total = m1 + m2
    return ((m1 - m2) * v1 - 2 * m2 * v2) / total, ((m2 - m1) * v2 + 2 * m1 * v1) / total
""",
    ),
    Wrong(
        "1.1",
        "results in the wrong order",
        ("order",),
        """
def elastic_1d(m1, v1, m2, v2):
    vc = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * vc - v2, 2 * vc - v1
""",
    ),
    Wrong(
        "1.1",
        "forgot to divide by the total mass",
        ("divisor",),
        """
def elastic_1d(m1, v1, m2, v2):
    return (m1 - m2) * v1 + 2 * m2 * v2, (m2 - m1) * v2 + 2 * m1 * v1
""",
    ),
    Wrong(
        "1.1",
        "rounds to two decimals",
        ("rounding",),
        """
def elastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return round(2 * v - v1, 2), round(2 * v - v2, 2)
""",
    ),
    Wrong(
        "1.2",
        "a minus in the momentum: believes that velocities are speeds",
        ("sign",),
        """
def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 - m2 * v2) / (m1 + m2)
    return v, v
""",
    ),
    Wrong(
        "1.2",
        "absolute velocities",
        ("absolute",),
        """
def inelastic_1d(m1, v1, m2, v2):
    p = m1 * abs(v1) + m2 * abs(v2)
    return p / (m1 + m2), p / (m1 + m2)
""",
    ),
    Wrong(
        "1.2",
        "momentum divided by half the mass",
        ("factor",),
        """
def inelastic_1d(m1, v1, m2, v2):
    average_mass = (m1 + m2) / 2
    v = (m1 * v1 + m2 * v2) / average_mass
    return [v, v]
""",
    ),
    Wrong(
        "1.3",
        "change of velocity for impulse",
        ("factor_missing", "divisor", "impulse"),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    v2_after = ((m2 - m1) * v2 + 2 * m1 * v1) / (m1 + m2)
    return v2_after - v2
""",
    ),
    Wrong(
        "1.3",
        "uses the first mass for the second body's momentum",
        ("other",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    v2_after = ((m2 - m1) * v2 + 2 * m1 * v1) / (m1 + m2)
    return m1 * (v2_after - v2)
""",
    ),
    Wrong(
        "1.3",
        "the final momentum instead of its change",
        ("term",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    v2_after = ((m2 - m1) * v2 + 2 * m1 * v1) / (m1 + m2)
    return m2 * v2_after
""",
    ),
    Wrong(
        "2.1",
        "the approach added up",
        ("sign",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    return (v2_after - v1_after) / (v1 + v2)
""",
    ),
    Wrong(
        "2.1",
        "no brackets around the denominator",
        ("precedence",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    return (v2_after - v1_after) / v1 - v2
""",
    ),
    Wrong(
        "2.2",
        "1 - e instead of 1 + e in the impulse",
        ("sign",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    j = (1 - restitution) * (v1 - v2) / (1 / m1 + 1 / m2)
    return v1 - j / m1, v2 + j / m2
""",
    ),
    Wrong(
        "2.2",
        "the impulse added to both",
        ("sign",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    j = (1 + restitution) * (v1 - v2) * m1 * m2 / (m1 + m2)
    return v1 + j / m1, v2 + j / m2
""",
    ),
    Wrong(
        "2.2",
        "the impulse is not divided by the masses",
        ("divisor",),
        """
def collide_1d(m1, v1, m2, v2, restitution):
    j = (1 + restitution) * (v1 - v2) * m1 * m2 / (m1 + m2)
    return v1 - j, v2 + j
""",
    ),
    Wrong(
        "2.3",
        "the first bounce counted as bounce number zero with e for e^2",
        ("starts_with_the_drop", "speed_factor_for_height", "power", "count"),
        """
def bounce_heights(height, restitution, count):
    heights = []
    for n in range(count):
        heights.append(height * restitution ** n)
    return heights
""",
    ),
    Wrong(
        "2.3",
        "one bounce too many",
        ("count",),
        """
def bounce_heights(height, restitution, count):
    out = []
    h = height
    for _ in range(count + 1):
        h = h * restitution ** 2
        out.append(h)
    return out
""",
    ),
    Wrong(
        "2.4",
        "the square root is missing",
        ("power", "root"),
        """
def rest_time(height, restitution, gravity):
    t = 2 * height / gravity
    return t * (1 + restitution) / (1 - restitution)
""",
    ),
    Wrong(
        "2.4",
        "2 g h for 2 h / g",
        ("quotient",),
        """
import math
def rest_time(height, restitution, gravity):
    t = math.sqrt(2 * height * gravity)
    return t * (1 + restitution) / (1 - restitution)
""",
    ),
    Wrong(
        "2.4",
        "forgot the factor 2 in the time of the first fall",
        ("factor",),
        """
import math
def rest_time(height, restitution, gravity):
    t0 = math.sqrt(height / gravity)
    return t0 + 2 * t0 * restitution / (1 - restitution)
""",
    ),
    Wrong(
        "3.1",
        "plus for minus",
        ("sign",),
        """
import numpy as np
def reflect(incident, normal):
    return incident + 2 * np.dot(incident, normal) * normal
""",
    ),
    Wrong(
        "3.1",
        "the velocity taken for the normal at the end",
        ("other", "exchanged"),
        """
import numpy as np
def reflect(incident, normal):
    return normal - 2 * np.dot(incident, normal) * incident
""",
    ),
    Wrong(
        "3.2",
        "the whole vector is reversed and scaled, and there is no gate",
        ("scales_the_tangent", "gate", "without_gate"),
        """
import numpy as np
def bounce(velocity, normal, restitution):
    r = velocity - 2 * np.dot(velocity, normal) * normal
    return restitution * r
""",
    ),
    Wrong(
        "3.2",
        "e where 1 + e belongs, and no gate",
        ("forgets_to_stop",),
        """
def bounce(velocity, normal, restitution):
    vn = velocity[0] * normal[0] + velocity[1] * normal[1]
    return velocity - restitution * vn * normal
""",
    ),
    Wrong(
        "3.2",
        "1 - e",
        ("sign",),
        """
import numpy as np
def bounce(velocity, normal, restitution):
    vn = np.dot(velocity, normal)
    if vn > 0:
        return velocity
    return velocity - (1 - restitution) * vn * normal
""",
    ),
    Wrong(
        "3.2",
        "the gate is missing and lossless bounces are right",
        ("without_gate", "gate"),
        """
import numpy as np
def bounce(velocity, normal, restitution):
    vn = np.dot(velocity, normal) * normal
    vt = velocity - vn
    return vt - restitution * vn
""",
    ),
    Wrong(
        "3.3",
        "moved along the velocity's side of the normal: minus",
        ("sign", "pushes_deeper"),
        """
import numpy as np
def resolve_wall(position, velocity, normal, depth, restitution):
    position = position - normal * depth
    vn = np.dot(velocity, normal)
    if vn < 0:
        velocity = velocity - (1 + restitution) * vn * normal
    return position, velocity
""",
    ),
    Wrong(
        "3.3",
        "velocity first, position second",
        ("order",),
        """
import numpy as np
def resolve_wall(position, velocity, normal, depth, restitution):
    position = position + normal * depth
    vn = np.dot(velocity, normal)
    if vn < 0:
        velocity = velocity - (1 + restitution) * vn * normal
    return velocity, position
""",
    ),
    Wrong(
        "4.1",
        "the normal points from 2 to 1",
        ("sign", "normal_from_2_to_1", "exchanged"),
        """
import numpy as np
def circle_contact(p1, r1, p2, r2):
    d = p1 - p2
    dist = np.sqrt(d[0] ** 2 + d[1] ** 2)
    if dist >= r1 + r2:
        return None
    if dist == 0:
        return np.array([1.0, 0.0]), r1 + r2
    return d / dist, r1 + r2 - dist
""",
    ),
    Wrong(
        "4.1",
        "negative depth",
        (
            "gap_as_depth",
            "sign",
        ),
        """
import numpy as np
def circle_contact(p1, r1, p2, r2):
    d = p2 - p1
    dist = np.linalg.norm(d)
    if dist >= r1 + r2:
        return None
    if dist == 0:
        return np.array([1.0, 0.0]), -(r1 + r2)
    return d / dist, dist - (r1 + r2)
""",
    ),
    Wrong(
        "4.1",
        "forgot the root of the distance; fails at equal centres",
        ("power", "root"),
        """
import numpy as np
def circle_contact(p1, r1, p2, r2):
    d = p2 - p1
    dist = d @ d
    if dist >= r1 + r2:
        return None
    return d / dist, r1 + r2 - dist
""",
    ),
    Wrong(
        "4.1",
        "depth and normal exchanged",
        ("order",),
        """
import numpy as np
def circle_contact(p1, r1, p2, r2):
    d = p2 - p1
    dist = np.linalg.norm(d)
    if dist >= r1 + r2:
        return None
    if dist == 0:
        return r1 + r2, (1.0, 0.0)
    return r1 + r2 - dist, d / dist
""",
    ),
    Wrong(
        "4.2",
        "v1 - v2 with the gate of v2 - v1",
        ("gate", "sign"),
        """
import numpy as np
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    vn = np.dot(v1 - v2, normal)
    if vn >= 0:
        return v1, v2
    j = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - j / m1 * normal, v2 + j / m2 * normal
""",
    ),
    Wrong(
        "4.2",
        "the impulse divided by the other body's mass",
        ("other", "exchanged"),
        """
import numpy as np
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    vn = np.dot(v2 - v1, normal)
    if vn > 0:
        return v1, v2
    j = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - j / m2 * normal, v2 + j / m1 * normal
""",
    ),
    Wrong(
        "4.2",
        "the impulse is not divided by the masses",
        ("divisor", "impulse"),
        """
import numpy as np
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    vn = np.dot(v2 - v1, normal)
    if vn > 0:
        return v1, v2
    j = -(1 + restitution) * vn / (1 / m1 + 1 / m2)
    return v1 - j * normal, v2 + j * normal
""",
    ),
    Wrong(
        "4.2",
        "reduced mass upside down",
        ("upside_down", "quotient"),
        """
import numpy as np
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    vn = np.dot(v2 - v1, normal)
    if vn > 0:
        return v1, v2
    j = -(1 + restitution) * vn * (m1 + m2) / (m1 * m2)
    return v1 - j / m1 * normal, v2 + j / m2 * normal
""",
    ),
    Wrong(
        "4.3",
        "each is moved in proportion to its own mass",
        ("in_proportion_to_mass", "exchanged", "weights_exchanged", "ratio_inverted", "heavier"),
        """
def separate(p1, m1, p2, m2, normal, depth):
    share1 = m1 / (m1 + m2)
    share2 = m2 / (m1 + m2)
    return p1 - share1 * depth * normal, p2 + share2 * depth * normal
""",
    ),
    Wrong(
        "4.3",
        "pushed together instead of apart",
        (
            "pushes_deeper",
            "sign",
        ),
        """
def separate(p1, m1, p2, m2, normal, depth):
    s = depth / (1 / m1 + 1 / m2)
    return p1 + s / m1 * normal, p2 - s / m2 * normal
""",
    ),
    Wrong(
        "4.4",
        "positions first, then velocities: another order of the four",
        ("order",),
        """
import numpy as np
def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    w1, w2 = 1 / m1, 1 / m2
    s = depth / (w1 + w2)
    p1 = p1 - s * w1 * normal
    p2 = p2 + s * w2 * normal
    vn = np.dot(v2 - v1, normal)
    if vn < 0:
        j = -(1 + restitution) * vn / (w1 + w2)
        v1 = v1 - j * w1 * normal
        v2 = v2 + j * w2 * normal
    return p1, p2, v1, v2
""",
    ),
    Wrong(
        "5.1",
        "divides by 12 in place of 6",
        ("factor",),
        """
import numpy as np
def moment_of_inertia(mass, vertices):
    x, y = vertices[:, 0], vertices[:, 1]
    x1, y1 = np.roll(x, -1), np.roll(y, -1)
    c = x * y1 - x1 * y
    a = c.sum() / 2
    cx = ((x + x1) * c).sum() / (6 * a)
    cy = ((y + y1) * c).sum() / (6 * a)
    i = (c * (x * x + x * x1 + x1 * x1 + y * y + y * y1 + y1 * y1)).sum() / 24
    return mass * (i / a - cx**2 - cy**2)
""",
    ),
    Wrong(
        "5.2",
        "the sign of the perpendicular",
        (
            "turns_clockwise",
            "sign",
        ),
        """
import numpy as np
def contact_velocity(v, w, r):
    return v + w * np.array([r[1], -r[0]])
""",
    ),
    Wrong(
        "5.2",
        "both components with a plus",
        ("sign",),
        """
def contact_velocity(v, w, r):
    return v[0] + w * r[1], v[1] + w * r[0]
""",
    ),
    Wrong(
        "5.3",
        "the arm is not squared",
        ("power",),
        """
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    a = r_a[0] * direction[1] - r_a[1] * direction[0]
    b = r_b[0] * direction[1] - r_b[1] * direction[0]
    return 1 / m_a + 1 / m_b + a / i_a + b / i_b
""",
    ),
    Wrong(
        "5.3",
        "the arm of a twice",
        ("other",),
        """
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    a = r_a[0] * direction[1] - r_a[1] * direction[0]
    b = r_a[0] * direction[1] - r_a[1] * direction[0]
    return 1 / m_a + 1 / m_b + a**2 / i_a + b**2 / i_b
""",
    ),
    Wrong(
        "5.3",
        "the mass itself, not its inverse",
        ("the_mass_itself", "upside_down", "effective_mass_itself", "inverse"),
        """
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    a = r_a[0] * direction[1] - r_a[1] * direction[0]
    b = r_b[0] * direction[1] - r_b[1] * direction[0]
    return 1 / (1 / m_a + 1 / m_b + a**2 / i_a + b**2 / i_b)
""",
    ),
    Wrong(
        "5.4",
        "times k in place of over k",
        (
            "multiplied_by_k",
            "quotient",
        ),
        """
def friction_impulse(vt, jn, friction, k):
    jt = -vt * k
    limit = friction * jn
    if jt > limit:
        return limit
    if jt < -limit:
        return -limit
    return jt
""",
    ),
    Wrong(
        "5.4",
        "only clamped from above",
        ("minmax", "one_side", "clamp", "unclamped"),
        """
def friction_impulse(vt, jn, friction, k):
    return min(-vt / k, friction * jn)
""",
    ),
    Wrong(
        "5.5",
        "the moment of inertia of a ring",
        ("factor", "ring"),
        """
import numpy as np
def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    t = np.array([-normal[1], normal[0]])
    vn = velocity @ normal
    if vn >= 0:
        return velocity, w
    vt = velocity @ t - w * radius
    jn = -(1 + restitution) * vn
    i = radius**2
    jt = max(-friction * jn, min(friction * jn, -vt / (1 + radius**2 / i)))
    return velocity + jn * normal + jt * t, w - radius * jt / i
""",
    ),
    Wrong(
        "5.5",
        "the spin changes the wrong way",
        ("sign",),
        """
import numpy as np
def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    t = np.array([-normal[1], normal[0]])
    vn = velocity @ normal
    if vn >= 0:
        return velocity, w
    vt = velocity @ t - w * radius
    jn = -(1 + restitution) * vn
    i = radius**2 / 2
    jt = max(-friction * jn, min(friction * jn, -vt / (1 + radius**2 / i)))
    return velocity + jn * normal + jt * t, w + radius * jt / i
""",
    ),
    Wrong(
        "6.1",
        "edges between a vertex and the one two before",
        ("edge", "sign", "index", "step"),
        """
import numpy as np
def sat_axes(vertices):
    axes = []
    for k in range(len(vertices)):
        e = vertices[k] - vertices[k - 2]
        n = np.array([-e[1], e[0]])
        axes.append(n / np.linalg.norm(n))
    return axes
""",
    ),
    Wrong(
        "6.2",
        "largest first",
        ("order", "minmax"),
        """
def project(vertices, axis):
    d = [v[0] * axis[0] + v[1] * axis[1] for v in vertices]
    return max(d), min(d)
""",
    ),
    Wrong(
        "6.2",
        "cross product for dot product",
        ("cross", "sign"),
        """
def project(vertices, axis):
    d = [v[0] * axis[1] - v[1] * axis[0] for v in vertices]
    return min(d), max(d)
""",
    ),
    Wrong(
        "6.3",
        "only looks at one side",
        ("b_is_always_on_the_right", "minmax", "one_side", "term", "common"),
        """
def overlap(interval_a, interval_b):
    d = interval_a[1] - interval_b[0]
    return d if d > 0 else None
""",
    ),
    Wrong(
        "6.4",
        "normal towards A",
        (
            "from_b_to_a",
            "sign",
        ),
        """
import numpy as np
def mtv(vertices_a, vertices_b):
    best = None
    for poly in (vertices_a, vertices_b):
        for k in range(len(poly)):
            e = poly[k] - poly[k - 1]
            n = np.array([e[1], -e[0]]) / np.hypot(*e)
            a, b = vertices_a @ n, vertices_b @ n
            for axis, d in ((n, a.max() - b.min()), (-n, b.max() - a.min())):
                if d <= 0:
                    return None
                if best is None or d < best[1]:
                    best = (-axis, d)
    return best
""",
    ),
    Wrong(
        "6.5",
        "keeps the other side",
        ("gate", "sign", "wrong_side", "other_side"),
        """
import numpy as np
def clip(start, end, normal, offset):
    a = offset - np.dot(start, normal)
    b = offset - np.dot(end, normal)
    if a > 0 and b > 0:
        return None
    if a <= 0 and b <= 0:
        return start, end
    t = a / (a - b)
    c = start + t * (end - start)
    if a > 0:
        return c, end
    return start, c
""",
    ),
    Wrong(
        "6.6",
        "depth without the radius",
        ("term",),
        """
import numpy as np
def circle_against_polygon(centre, radius, vertices):
    best, inside = None, True
    for k in range(len(vertices)):
        a, b = vertices[k - 1], vertices[k]
        e = b - a
        t = min(1, max(0, np.dot(centre - a, e) / np.dot(e, e)))
        way = centre - (a + t * e)
        if best is None or way @ way < best @ best:
            best = way
        if e[0] * (centre - a)[1] - e[1] * (centre - a)[0] <= 0:
            inside = False
    d = np.hypot(*best)
    if inside:
        return -best / d, d
    return (best / d, radius - d) if d < radius else None
""",
    ),
    Wrong(
        "7.1",
        "the later of the two times",
        ("sign", "later_root", "later"),
        """
import math
import numpy as np
def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d, v = p2 - p1, v2 - v1
    a, b, c = v @ v, 2 * d @ v, d @ d - (r1 + r2) ** 2
    if c <= 0 and b < 0:
        return 0.0
    disc = b * b - 4 * a * c
    if a == 0 or disc < 0 or b >= 0:
        return None
    t = (-b + math.sqrt(disc)) / (2 * a)
    return t if t <= dt else None
""",
    ),
    Wrong(
        "7.1",
        "r1 + r2 is not squared",
        ("power",),
        """
import math
import numpy as np
def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d, v = p2 - p1, v2 - v1
    a, b, c = v @ v, d @ v, d @ d - (r1 + r2)
    if b >= 0 or b * b - a * c < 0:
        return None
    if c <= 0:
        return 0.0
    t = (-b - math.sqrt(b * b - a * c)) / a
    return t if t <= dt else None
""",
    ),
    Wrong(
        "7.2",
        "4 g h for 2 g h",
        ("factor",),
        """
import math
def time_to_floor(height, velocity, gravity):
    if gravity == 0:
        return -height / velocity if velocity < 0 else None
    return (velocity + math.sqrt(velocity**2 + 4 * gravity * height)) / gravity
""",
    ),
    Wrong(
        "7.2",
        "divided by 2 g",
        ("factor",),
        """
import math
def time_to_floor(height, velocity, gravity):
    if gravity == 0:
        return -height / velocity if velocity < 0 else None
    return (velocity + math.sqrt(velocity**2 + 2 * gravity * height)) / (2 * gravity)
""",
    ),
    Wrong(
        "7.4",
        "the last event, not the first",
        ("minmax", "last", "latest"),
        """
import math
import numpy as np
def touch(p1, v1, r1, p2, v2, r2):
    d, v = p2 - p1, v2 - v1
    a, b, c = v @ v, d @ v, d @ d - (r1 + r2) ** 2
    if b >= 0 or b * b - a * c < 0:
        return None
    return 0.0 if c <= 0 else c / (-b + math.sqrt(b * b - a * c))
def next_event(positions, velocities, radii):
    best = None
    for j in range(len(radii)):
        for i in range(j):
            t = touch(positions[i], velocities[i], radii[i], positions[j], velocities[j], radii[j])
            if t is not None and (best is None or t > best[0]):
                best = (t, i, j)
    return best
""",
    ),
    Wrong(
        "7.5",
        "does not count the wall",
        ("wall", "term", "only_blocks", "count"),
        """
def pi_collisions(mass_ratio):
    u, v, n = 0.0, -1.0, 0
    while u > v:
        c = (u + mass_ratio * v) / (1 + mass_ratio)
        u, v = 2 * c - u, 2 * c - v
        n += 1
        if u < 0:
            u = -u
    return n
""",
    ),
    Wrong(
        "8.1",
        "the mean distance",
        ("mean", "average"),
        """
import numpy as np
def largest_error(places, right):
    return np.mean(np.linalg.norm(places - right, axis=1))
""",
    ),
    Wrong(
        "8.2",
        "ratio of the logarithms upside down",
        ("upside_down",),
        """
import math
def observed_order(dt_1, error_1, dt_2, error_2):
    return math.log(dt_1 / dt_2) / math.log(error_1 / error_2)
""",
    ),
    Wrong(
        "8.2",
        "one ratio the other way round",
        ("sign", "upside_down", "exchanged"),
        """
import math
def observed_order(dt_1, error_1, dt_2, error_2):
    return math.log(error_1 / error_2) / math.log(dt_2 / dt_1)
""",
    ),
    Wrong(
        "8.3",
        "C left as a logarithm",
        ("root", "logarithm", "log", "exp"),
        """
import numpy as np
def fit_power(steps, errors):
    p, c = np.polyfit(np.log(steps), np.log(errors), 1)
    return p, c
""",
    ),
    Wrong(
        "8.3",
        "x and y exchanged in the fit",
        ("step_over_error", "exchanged", "other"),
        """
import numpy as np
def fit_power(steps, errors):
    p, c = np.polyfit(np.log(errors), np.log(steps), 1)
    return p, np.exp(c)
""",
    ),
    Wrong(
        "9.1",
        "the weight above, without the box itself",
        ("without_the_box_itself", "count", "term", "above", "own"),
        """
def tower_forces(masses, gravity):
    return [sum(masses[n + 1:]) * gravity for n in range(len(masses))]
""",
    ),
    Wrong(
        "9.1",
        "from the top down",
        ("order", "top", "reversed"),
        """
import numpy as np
def tower_forces(masses, gravity):
    return np.cumsum(masses[::-1]) * gravity
""",
    ),
    Wrong(
        "9.3",
        "friction helps instead of hinders: sign of the rub",
        ("friction_drives", "sign", "friction_along"),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    s = 1 if vt > 0 else -1
    y = knn + s * friction * knt
    return -vn / y if y > 0 else None
""",
    ),
    Wrong(
        "9.4",
        "before over after",
        ("upside_down",),
        """
import numpy as np
def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    v = velocity + impulse / mass
    w2 = w + (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    e1 = 0.5 * mass * velocity @ velocity + 0.5 * inertia * w**2
    e2 = 0.5 * mass * v @ v + 0.5 * inertia * w2**2
    return e1 / e2
""",
    ),
    Wrong(
        "9.4",
        "the impulse taken for a change of velocity",
        ("divisor", "impulse"),
        """
import numpy as np
def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    v = velocity + impulse
    w2 = w + (arm[0] * impulse[1] - arm[1] * impulse[0]) / inertia
    e1 = mass * velocity @ velocity + inertia * w**2
    e2 = mass * v @ v + inertia * w2**2
    return e2 / e1
""",
    ),
    Wrong(
        "10.1",
        "arithmetic mean",
        ("mean", "average", "sum"),
        """
def most_friction(inverse_masses, frictions):
    best = 0.0
    n = len(frictions)
    for i in range(n):
        for j in range(i + 1, n):
            if inverse_masses[i] + inverse_masses[j] > 0:
                best = max(best, (frictions[i] + frictions[j]) / 2)
    return best
""",
    ),
    Wrong(
        "10.3",
        "the heaviest disc",
        ("minmax", "heaviest"),
        """
import numpy as np
def fastest_way(masses, velocities, dt):
    e = sum(m * (v @ v) for m, v in zip(masses, velocities))
    return np.sqrt(e / max(masses)) * dt
""",
    ),
    Wrong(
        "10.3",
        "half the energy is forgotten: 1/2 m v^2 in, m v^2 out",
        (
            "half_forgotten",
            "factor",
        ),
        """
import numpy as np
def fastest_way(masses, velocities, dt):
    e = sum(m * (v @ v) / 2 for m, v in zip(masses, velocities))
    return np.sqrt(e / min(masses)) * dt
""",
    ),
    Wrong(
        "10.4",
        "g t^2 without the half",
        ("factor",),
        """
def box_of_flight(position, velocity, radius, gravity, duration):
    out = []
    for x, v, g in zip(position, velocity, gravity):
        ts = [0, duration]
        if g != 0 and 0 < -v / g < duration:
            ts.append(-v / g)
        xs = [x + v * t + g * t**2 for t in ts]
        out += [min(xs) - radius, max(xs) + radius]
    return out
""",
    ),
    Wrong(
        "11.2",
        "rotation left out of the relative velocity",
        ("term", "spin", "rotation", "ignored"),
        """
import numpy as np
def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    def cr(p, q):
        return p[0] * q[1] - p[1] * q[0]
    m_a, i_a, v_a, w_a = a[0], a[1], a[2:4], a[4]
    m_b, i_b, v_b, w_b = b[0], b[1], b[2:4], b[4]
    lo, hi = 0, np.inf
    for n, e in ((normal, restitution), (np.array([-normal[1], normal[0]]), 0)):
        xa, xb = cr(arm_a, n), cr(arm_b, n)
        u = np.dot(v_b - v_a, n)
        k = 1 / m_a + 1 / m_b + xa**2 / i_a + xb**2 / i_b
        j = min(hi, max(lo, -(1 + e) * u / k))
        lo, hi = -friction * j, friction * j
        v_a, w_a = v_a - j / m_a * n, w_a - j / i_a * xa
        v_b, w_b = v_b + j / m_b * n, w_b + j / i_b * xb
    return v_a, w_a, v_b, w_b
""",
    ),
    Wrong(
        "D.1",
        "height over thickness",
        ("upside_down", "exchanged"),
        """
import math
def tipping_angle(thickness, height):
    return math.atan(height / thickness)
""",
    ),
    Wrong(
        "D.1",
        "in degrees",
        ("degrees",),
        """
import math
def tipping_angle(thickness, height):
    return math.degrees(math.atan(thickness / height))
""",
    ),
    Wrong(
        "C.2",
        "the angle in degrees inside the sine",
        ("degrees",),
        """
import math
def swing_step(angle, rate, length, dt):
    rate = rate - 9.81 / length * math.sin(math.degrees(angle)) * dt
    return angle + rate * dt, rate
""",
    ),
    Wrong(
        "K.1",
        "sine and cosine exchanged",
        ("order", "sine"),
        """
import math
def paddle_bounce(offset, speed):
    a = offset * math.radians(60)
    return speed * math.cos(a), speed * math.sin(a)
""",
    ),
    Wrong(
        "S.1",
        "twice the area",
        (
            "twice_the_area",
            "factor",
        ),
        """
def ring_area(positions):
    after = list(positions[1:]) + [positions[0]]
    return sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(positions, after))
""",
    ),
    Wrong(
        "A.2",
        "the shot's mass is not counted in the total",
        ("mass", "term", "other"),
        """
import numpy as np
def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    u = np.array([np.cos(heading), np.sin(heading)])
    ship = velocity - shot_mass / ship_mass * muzzle_speed * u
    return ship, ship + muzzle_speed * u
""",
    ),
)
