"""Wrong answers of teachers: each one belief, worked out in a style of its own.

When they were first tried, by the models that NINTH was tried with and those written after it,
35 of 60 were recognised, and seven earned full marks.
"""

from __future__ import annotations

from course.recognition.students import Wrong

TENTH = (
    Wrong(
        "1.1",
        "head-on means that body 2 always comes from the right, so the sign of v2 is "
        "set to minus whatever was given",
        ("signs",),
        """
def elastic_1d(m1, v1, m2, v2):
    # Formelsammlung, gerader zentraler Stoss:
    #   u1 = (m1 v1 + m2 (2 v2 - v1)) / (m1 + m2),  v2 negativ, da entgegengesetzt
    c1 = abs(v1)
    c2 = -abs(v2)          # body 2 runs against body 1
    u1 = (m1 * c1 + m2 * (2 * c2 - c1)) / (m1 + m2)
    u2 = (m2 * c2 + m1 * (2 * c1 - c2)) / (m1 + m2)
    return u1, u2
""",
    ),
    Wrong(
        "1.2",
        "bodies that stick share the kinetic energy, so the common speed follows from "
        "energy and momentum only gives the direction",
        ("keeps_energy",),
        """
import math


def inelastic_1d(m1, v1, m2, v2):
    # energy cannot be lost, so E_before = 1/2 (m1 + m2) V^2
    energy = 0.5 * m1 * v1**2 + 0.5 * m2 * v2**2
    speed = math.sqrt(2 * energy / (m1 + m2))
    # V is a square root, the sign comes from the momentum
    if m1 * v1 + m2 * v2 < 0:
        speed = -speed
    return speed, speed
""",
    ),
    Wrong(
        "1.3",
        "the impulse is over when both have the same velocity (only the compression "
        "half of the elastic hit is counted)",
        ("stops_only",),
        """
def elastic_impulse_1d(m1, v1, m2, v2):
    # Kraftstoss = Impulsaenderung. While they press on each other both reach the
    # common velocity V; from then on they no longer push.
    V = (m1 * v1 + m2 * v2) / (m1 + m2)
    delta_p2 = m2 * V - m2 * v2
    return delta_p2
""",
    ),
    Wrong(
        "2.1",
        "after a collision the bodies fly off in opposite directions, so speeds of "
        "separation and approach are sums of absolute values",
        ("speeds_added_up",),
        """
def restitution_1d(v1, v2, v1_after, v2_after):
    # speeds, not velocities -> absolute values
    approach = abs(v1) + abs(v2)        # they come towards each other
    separation = abs(v1_after) + abs(v2_after)  # they go away from each other
    return separation / approach
""",
    ),
    Wrong(
        "2.2",
        "e is the part of the energy (seen from the centre of mass) that is kept, so "
        "speeds go with its root",
        ("energy_restitution",),
        """
from math import sqrt


def collide_1d(m1, v1, m2, v2, restitution):
    V = (m1 * v1 + m2 * v2) / (m1 + m2)
    # Wirkungsgrad des Stosses: E' = e * E in the centre-of-mass frame, so u' = sqrt(e) * u
    k = sqrt(restitution)
    return V - k * (v1 - V), V - k * (v2 - V)
    # test: e=1 gives elastic, e=0 gives V for both. ok!
""",
    ),
    Wrong(
        "2.3",
        "squares the factor again at every bounce, so the 3rd height has e^14 in place of e^6",
        ("squares_again_each_time",),
        """
def bounce_heights(height, restitution, count):
    heights = []
    factor = restitution
    h = height
    for n in range(count):
        factor = factor**2     # v -> e v, h goes with v^2
        h = h * factor
        heights.append(h)
    return heights
""",
    ),
    Wrong(
        "2.4",
        "a ball that bounces less than a millimetre high lies still, so the loop may end there",
        ("threshold",),
        """
import math


def rest_time(height, restitution, gravity):
    t = math.sqrt(2 * height / gravity)   # the drop
    h = height * restitution**2
    while h > 0.001:                      # below 1 mm nobody sees it bounce
        t += 2 * math.sqrt(2 * h / gravity)   # up and down
        h *= restitution**2
    return t
""",
    ),
    Wrong(
        "3.1",
        "mirrors at the normal (angle in = angle out, with the ray pointing away from "
        "the wall), so the ray comes back reversed",
        ("opposite_sign",),
        """
import numpy as np


def reflect(incident, normal):
    # Reflexionsgesetz: Einfallswinkel = Ausfallswinkel, measured from the Lot.
    # The Lot is the mirror axis:  R = 2 (L . n) n - L
    L = np.asarray(incident, float)
    n = np.asarray(normal, float)
    lot_part = np.dot(L, n) * n
    return 2 * lot_part - L
""",
    ),
    Wrong(
        "3.2",
        "the mirror formula v - 2 (v.n) n gets a restitution by multiplying its last term with e",
        ("one_plus", "term"),
        """
import numpy as np


def bounce(velocity, normal, restitution):
    vn = velocity @ normal
    if vn >= 0:
        return velocity
    # mirror: v - 2 (v.n) n, and now not all of it comes back
    return velocity - 2 * restitution * vn * normal
""",
    ),
    Wrong(
        "3.3",
        "the ball must be taken back along its own path to where it touched, in place "
        "of straight out along the normal",
        ("direction",),
        """
import numpy as np


def resolve_wall(position, velocity, normal, depth, restitution):
    vn = np.dot(velocity, normal)
    if vn == 0:
        return position + depth * normal, velocity
    # it has been in the wall for this long
    t = depth / abs(vn)
    if vn < 0:
        touching = position - velocity * t       # rewind
        return touching, velocity - (1 + restitution) * vn * normal
    # already on its way out: let it finish
    return position + velocity * t, velocity
""",
    ),
    Wrong(
        "4.2",
        "the relative speed in the impulse formula is the length of the relative "
        "velocity, not its part along the normal",
        ("speed_for_approach",),
        """
import numpy as np


def resolve_circles(v1, m1, v2, m2, normal, restitution):
    v_rel = v1 - v2                      # velocity of 1 as seen from 2
    if np.dot(v_rel, normal) <= 0:       # they separate
        return v1, v2
    # reduzierte Masse und Betrag der Relativgeschwindigkeit
    mu = m1 * m2 / (m1 + m2)
    J = (1 + restitution) * mu * np.linalg.norm(v_rel)
    # smooth: the push acts along the normal
    return v1 - J / m1 * normal, v2 + J / m2 * normal
""",
    ),
    Wrong(
        "4.2",
        "circles approach only when each moves towards the other; a fast one that "
        "catches up with a slow one is left alone",
        ("towards_each_other", "gate", "condition", "case", "unchanged"),
        """
import numpy as np


def resolve_circles(v1, m1, v2, m2, normal, restitution):
    a = float(np.dot(v1, normal))   # 1 along the line of centres
    b = float(np.dot(v2, normal))   # 2 along the line of centres
    towards_2 = a > 0
    towards_1 = b < 0
    if not (towards_2 and towards_1):
        return v1, v2
    V = (m1 * a + m2 * b) / (m1 + m2)
    a2 = V - restitution * (a - V)
    b2 = V - restitution * (b - V)
    return v1 + (a2 - a) * normal, v2 + (b2 - b) * normal
""",
    ),
    Wrong(
        "4.3",
        "the lighter circle moves by all of the depth, and the heavier one by that "
        "times the ratio of masses, so together they move too far",
        ("the_lighter_all_and_more",),
        """
import math


def separate(p1, m1, p2, m2, normal, depth):
    if m1 == math.inf:
        return p1, p2 + depth * normal
    if m2 == math.inf:
        return p1 - depth * normal, p2
    if m1 <= m2:
        s1 = depth              # the light one makes way
        s2 = depth * m1 / m2    # s1 : s2 = m2 : m1
    else:
        s2 = depth
        s1 = depth * m2 / m1
    return p1 - s1 * normal, p2 + s2 * normal
""",
    ),
    Wrong(
        "4.4",
        'a fixed circle may be given a "very big" mass of 1000 kg to avoid inf/inf; it '
        "then recoils a little",
        ("infinite",),
        """
import math

BIG = 1000.0


def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    # inf / inf is nan, so use a mass that is practically a wall
    if math.isinf(m1):
        m1 = BIG
    if math.isinf(m2):
        m2 = BIG
    total = m1 + m2
    p1_new = p1 - normal * depth * m2 / total
    p2_new = p2 + normal * depth * m1 / total
    closing = (v1 - v2) @ normal
    if closing > 0:
        J = (1 + restitution) * closing * m1 * m2 / total
        v1 = v1 - J / m1 * normal
        v2 = v2 + J / m2 * normal
    return p1_new, v1, p2_new, v2
""",
    ),
    Wrong(
        "5.1",
        "the centroid of a polygon is the mean of its vertices",
        ("average_of_the_vertices",),
        """
import numpy as np


def moment_of_inertia(mass, vertices):
    pts = np.asarray(vertices, dtype=float)
    schwerpunkt = pts.mean(axis=0)
    pts = pts - schwerpunkt
    zaehler = 0.0
    nenner = 0.0
    n = len(pts)
    for i in range(n):
        p = pts[i]
        q = pts[(i + 1) % n]
        kreuz = p[0] * q[1] - p[1] * q[0]
        zaehler += (p @ p + p @ q + q @ q) * kreuz
        nenner += kreuz
    return mass / 6 * zaehler / nenner
""",
    ),
    Wrong(
        "5.2",
        "v = omega r from the formula book, with r as a vector: the spin's part points "
        "outward along r",
        ("along_the_lever",),
        """
import numpy as np


def contact_velocity(v, w, r):
    # Bahngeschwindigkeit v = omega * r, plus die Schwerpunktsgeschwindigkeit
    bahn = w * np.asarray(r, float)
    return np.asarray(v, float) + bahn
""",
    ),
    Wrong(
        "5.3",
        "the lever arm is the distance from the centre to the contact, whatever the "
        "direction of the push",
        ("full_distance",),
        """
import numpy as np


def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    # translation of both
    k = 1 / m_a + 1 / m_b
    # rotation of both: arm^2 / I, arm = distance from centre of mass to contact
    arm_a = np.hypot(r_a[0], r_a[1])
    arm_b = np.hypot(r_b[0], r_b[1])
    k += arm_a**2 / i_a + arm_b**2 / i_b
    return k
""",
    ),
    Wrong(
        "5.4",
        "limits first and divides by k afterwards, so the limit mu jn is put on a "
        "velocity instead of an impulse",
        ("limit",),
        """
import numpy as np


def friction_impulse(vt, jn, friction, k):
    limit = friction * jn
    # stop the sliding, but not more than the limit
    return -np.clip(vt, -limit, limit) / k
""",
    ),
    Wrong(
        "5.5",
        "the normal impulse that presses the disc is m |vn|, the 1 + e of the bounce is "
        "forgotten in Coulomb's limit",
        ("factor_missing", "term"),
        """
import numpy as np


def bounce_with_spin(velocity, w, radius, normal, restitution, friction):
    n = np.asarray(normal, float)
    t = np.array([-n[1], n[0]])
    vn = velocity @ n
    vt = velocity @ t
    if vn >= 0:
        return velocity, w
    inertia = 0.5 * radius**2
    # the contact is at -radius n, so the spin moves it by -w radius along t
    slide = vt - w * radius
    needed = -slide / (1 + radius**2 / inertia)
    jn = abs(vn)                     # mass is 1: this is what presses
    jt = max(-friction * jn, min(friction * jn, needed))
    v_new = -restitution * vn * n + (vt + jt) * t
    w_new = w - radius * jt / inertia
    return v_new, w_new
""",
    ),
    Wrong(
        "6.1",
        "an edge of length zero ends the polygon (break in place of continue), so the "
        "axes after it are lost",
        ("break_off", "passed_over"),
        """
import numpy as np


def sat_axes(vertices):
    axes = []
    last = vertices[-1]
    for vertex in vertices:
        dx, dy = vertex - last
        length = (dx * dx + dy * dy) ** 0.5
        if length == 0:
            break            # doubled vertex: no edge here
        axes.append(np.array([dy, -dx]) / length)
        last = vertex
    return axes
""",
    ),
    Wrong(
        "6.3",
        "only thinks of B inside A; if A lies inside B, the shared length counts as the way out",
        ("gate", "other"),
        """
def overlap(interval_a, interval_b):
    a0, a1 = interval_a
    b0, b1 = interval_b
    if a1 <= b0 or b1 <= a0:
        return None
    # B is completely inside A: it has to get out of one of the two ends
    if a0 <= b0 and b1 <= a1:
        return min(b1 - a0, a1 - b0)
    # else: the common part of both
    return min(a1, b1) - max(a0, b0)
""",
    ),
    Wrong(
        "6.4",
        "A's first vertex to B's first vertex tells on which side B lies",
        ("case", "from_b_to_a"),
        """
import numpy as np


def mtv(vertices_a, vertices_b):
    A, B = np.asarray(vertices_a, float), np.asarray(vertices_b, float)
    best = None
    for poly in (A, B):
        for i in range(len(poly)):
            e = poly[(i + 1) % len(poly)] - poly[i]
            l = np.hypot(*e)
            if l == 0:
                continue
            n = np.array([e[1], -e[0]]) / l
            a, b = A @ n, B @ n
            right = a.max() - b.min()    # B leaves along +n
            left = b.max() - a.min()     # B leaves along -n
            if right <= 0 or left <= 0:
                return None
            depth = min(right, left)
            if best is None or depth < best[1]:
                best = (n, depth)
    n, depth = best
    # the normal has to point from A to B
    if (B[0] - A[0]) @ n < 0:
        n = -n
    return n, depth
""",
    ),
    Wrong(
        "6.5",
        "the kept end comes first and the cut point second; a segment that begins "
        "outside comes back in the other direction",
        ("cut_always_last",),
        """
import numpy as np


def clip(start, end, normal, offset):
    ds = np.dot(start, normal) - offset
    de = np.dot(end, normal) - offset
    if ds > 0 and de > 0:
        return None
    if ds <= 0 and de <= 0:
        return start, end
    cut = start + (end - start) * ds / (ds - de)
    inner = start if ds <= 0 else end
    return inner, cut
""",
    ),
    Wrong(
        "6.6",
        "farther from the outline than the radius means no overlap, asked before "
        "whether the centre is inside",
        ("far_from_the_outline_is_apart",),
        """
import numpy as np


def nearest(p, a, b):
    ab = b - a
    if not ab.any():
        return a
    t = np.clip((p - a) @ ab / (ab @ ab), 0, 1)
    return a + t * ab


def circle_against_polygon(centre, radius, vertices):
    best_d, best_q = np.inf, None
    inside = True
    for a, b in zip(vertices, np.roll(vertices, -1, axis=0)):
        q = nearest(centre, a, b)
        d = np.linalg.norm(centre - q)
        if d < best_d:
            best_d, best_q = d, q
        edge, to = b - a, centre - a
        if edge[0] * to[1] - edge[1] * to[0] < 0:
            inside = False
    if best_d >= radius:
        return None                       # too far away
    n = (centre - best_q) / best_d
    if inside:
        return -n, radius + best_d
    return n, radius - best_d
""",
    ),
    Wrong(
        "7.1",
        "the circles close in along the line of centres as it is now, so t is the gap "
        "over the closing speed, also when they pass beside each other",
        ("the_gap_closes_evenly",),
        """
import numpy as np


def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d = p2 - p1
    dist = np.sqrt(d @ d)
    if dist == 0:
        return None
    # s = v t with the speed at which the distance gets smaller
    closing = -((v2 - v1) @ d) / dist
    if closing <= 0:
        return None
    gap = dist - (r1 + r2)
    if gap <= 0:
        return 0.0
    t = gap / closing
    return t if t <= dt else None
""",
    ),
    Wrong(
        "7.2",
        "gravity below 1e-9 is as good as none, so a ball that moves up never comes back",
        ("threshold", "a_little_gravity_is_none"),
        """
import math

EPS = 1e-9  # never compare floats with ==


def time_to_floor(height, velocity, gravity):
    if abs(gravity) < EPS:
        # no gravity: straight line
        if velocity >= 0:
            return None
        return height / -velocity
    root = math.sqrt(velocity**2 + 2 * gravity * height)
    if velocity > 0:
        return (velocity + root) / gravity
    if height == 0 and velocity < 0:
        return 0.0
    if root == velocity:      # 0 and 0: lies on the floor
        return 0.0
    return 2 * height / (root - velocity)
""",
    ),
    Wrong(
        "7.3",
        "the path is unfolded at each wall as a mirror image and only the velocity is "
        "multiplied by e; the way after the wall is as long as without the loss",
        ("mirrors_the_rest",),
        """
import numpy as np


def advance(p, v, room, restitution, dt):
    # Spiegelbild: fly through the wall and fold back, once per impact
    p_new, v_new = [], []
    for x, u, L in zip(p, v, room):
        x = x + u * dt
        while x < 0 or x > L:
            if x < 0:
                x = -x
            else:
                x = 2 * L - x
            u = -restitution * u
        p_new.append(x)
        v_new.append(u)
    return np.array(p_new), np.array(v_new)
""",
    ),
    Wrong(
        "7.4",
        "each circle's first hit is with its nearest neighbour, so only the nearest one is asked",
        ("the_nearest_pair",),
        """
import math

import numpy as np


def _meet(d, v, R):
    a, b, c = v @ v, d @ v, d @ d - R * R
    if b >= 0:
        return None
    if c <= 0:
        return 0.0
    disc = b * b - a * c
    if disc < 0:
        return None
    return c / (-b + math.sqrt(disc))


def next_event(positions, velocities, radii):
    best = None
    n = len(radii)
    for i in range(n):
        # broad phase: who is nearest?
        others = [j for j in range(n) if j != i]
        gaps = [np.linalg.norm(positions[j] - positions[i]) - radii[i] - radii[j] for j in others]
        j = others[int(np.argmin(gaps))]
        t = _meet(positions[j] - positions[i], velocities[j] - velocities[i], radii[i] + radii[j])
        if t is not None and (best is None or t < best[0]):
            best = (t, min(i, j), max(i, j))
    return best
""",
    ),
    Wrong(
        "7.5",
        "the answer is always floor(pi sqrt(M)), because it is so for M = 100^k",
        ("digits_of_pi",),
        """
import math


def pi_collisions(mass_ratio):
    # video: 1 -> 3, 100 -> 31, 10000 -> 314, so it is the digits of pi
    return math.floor(math.pi * math.sqrt(mass_ratio))
""",
    ),
    Wrong(
        "8.2",
        "the second run always has half the step of the first, so the ratio of the errors is 2^p",
        ("as_if_halved",),
        """
import math


def observed_order(dt_1, error_1, dt_2, error_2):
    # E ~ dt^p : half the step -> error / 2^p
    if dt_1 < dt_2:
        error_1, error_2 = error_2, error_1
    return math.log2(error_1 / error_2)
""",
    ),
    Wrong(
        "8.3",
        "takes logarithms to base 10 for the line, and goes back with exp",
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
        "gives up at the first failed row of the right work (any failed instead of all failed)",
        ("one_failure_is_enough",),
        """
import math


def best_split(table, sweeps):
    best = None
    for substeps, iterations, error in table:
        if substeps * iterations != sweeps:
            continue
        if math.isinf(error):
            return None          # the run has failed
        if best is None or error < best[2]:
            best = (int(substeps), int(iterations), error)
    if best is None:
        return None
    return best[0], best[1]
""",
    ),
    Wrong(
        "8.5",
        "the place in the filtered table is the number of the row",
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
        "9.2",
        "rounds the number of sweeps to the nearest whole number instead of up",
        ("to_the_nearest",),
        """
import math


def sweeps_needed(light, heavy, left):
    # (M/(M+m))^n = left  ->  n = ln(left) / ln(M/(M+m)), log1p for big M
    q = -math.log1p(light / heavy)
    n = math.log(left) / q
    return max(1, round(n))
""",
    ),
    Wrong(
        "9.3",
        "friction is always -mu jn, as if the tip slid to the positive side every time",
        ("always_to_the_left",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    # jt = -mu jn, Reibung wirkt entgegen
    # vn + knn jn + knt jt = 0
    k = knn - knt * friction
    if k <= 0:
        return None
    return -vn / k
""",
    ),
    Wrong(
        "9.4",
        "the torque impulse is the length of the lever times the length of the impulse, "
        "without the angle between them or the sense of turning",
        ("torque_of_lengths",),
        """
import numpy as np


def energy_ratio(mass, inertia, velocity, w, arm, impulse):
    # Drehmoment = Kraft mal Hebelarm
    hebel = np.linalg.norm(arm)
    stoss = np.linalg.norm(impulse)
    w_neu = w + hebel * stoss / inertia
    v_neu = velocity + impulse / mass
    e_vor = 0.5 * mass * (velocity @ velocity) + 0.5 * inertia * w**2
    e_nach = 0.5 * mass * (v_neu @ v_neu) + 0.5 * inertia * w_neu**2
    return e_nach / e_vor
""",
    ),
    Wrong(
        "9.5",
        "sorts the pairs by approach at the start of a round and strikes them in this "
        "order with stale ranks, instead of looking for the fastest again after each "
        "strike",
        (),
        """
import numpy as np


def one_by_one(masses, velocities):
    v = np.array(velocities, dtype=float)
    m = masses
    while True:
        approach = v[:-1] - v[1:]
        order = [k for k in np.argsort(-approach) if approach[k] >= 1e-9]
        if not order:
            return v
        for k in order:                       # fastest first
            a, b = v[k], v[k + 1]
            if a - b < 1e-9:
                continue
            V = (m[k] * a + m[k + 1] * b) / (m[k] + m[k + 1])
            v[k], v[k + 1] = 2 * V - a, 2 * V - b
""",
    ),
    Wrong(
        "10.2",
        "any body with corners calls for rotation, even the static floor under smooth discs",
        ("floors_turn",),
        """
import math
from itertools import combinations


def effects_called_for(bodies, gravity):
    effects = set()
    dynamic = [b for b in bodies if b[0] > 0]
    if dynamic and any(g != 0 for g in gravity):
        effects.add("gravity")
    for a, b in combinations(bodies, 2):
        if a[0] == 0 and b[0] == 0:
            continue
        if min(a[2], b[2]) > 0:
            effects.add("restitution")
        if math.sqrt(a[3] * b[3]) > 0:
            effects.add("friction")
            effects.add("rotation")       # rubbing turns
        if a[1] > 0 or b[1] > 0:
            effects.add("rotation")       # corners turn
    if any(b[4] != 0 for b in dynamic):
        effects.add("rotation")
    return sorted(effects)
""",
    ),
    Wrong(
        "10.3",
        "at worst the lightest disc gets all the momentum (sum of m |v|), though it is "
        "the energy that is limited",
        ("all_the_momentum",),
        """
import numpy as np


def fastest_way(masses, velocities, dt):
    speeds = np.sqrt((velocities**2).sum(axis=1))
    # Impulserhaltung: nobody can have more than all of the momentum
    p_total = (masses * speeds).sum()
    v_max = p_total / masses.min()
    return v_max * dt
""",
    ),
    Wrong(
        "10.4",
        "the turning point belongs to the flight as soon as it lies in the future, even "
        "if the flight ends before",
        ("condition",),
        """
def box_of_flight(position, velocity, radius, gravity, duration):
    box = []
    for x, v, g in zip(position, velocity, gravity):
        places = [x, x + v * duration + 0.5 * g * duration**2]
        if g != 0:
            t_top = -v / g            # v + g t = 0
            if t_top > 0:
                places.append(x + v * t_top + 0.5 * g * t_top**2)
        box += [min(places) - radius, max(places) + radius]
    return tuple(box)
""",
    ),
    Wrong(
        "10.5",
        "a body sleeps if it and those that touch it are still; islands are not "
        "followed any further",
        ("only_neighbours",),
        """
def bodies_asleep(inverse_masses, still, touches):
    asleep = []
    n = len(still)
    for a in range(n):
        if inverse_masses[a] == 0:
            continue
        if not still[a]:
            continue
        neighbours = [b for b in range(n) if b != a and touches[a, b] and inverse_masses[b] > 0]
        if all(still[b] for b in neighbours):
            asleep.append(a)
    return asleep
""",
    ),
    Wrong(
        "11.1",
        "two boxes share a point only if a corner of one lies in the other, so boxes "
        "that cross like a plus are missed",
        ("corners_inside",),
        """
from itertools import combinations


def _corners(box):
    l, r, lo, hi = box
    return [(l, lo), (l, hi), (r, lo), (r, hi)]


def _has(box, point):
    return box[0] <= point[0] <= box[1] and box[2] <= point[1] <= box[3]


def near_pairs(boxes):
    pairs = []
    for i, j in combinations(range(len(boxes)), 2):
        a, b = boxes[i], boxes[j]
        if any(_has(a, c) for c in _corners(b)) or any(_has(b, c) for c in _corners(a)):
            pairs.append((i, j))
    return pairs
""",
    ),
    Wrong(
        "11.2",
        "both bodies receive arm x J for their spin with a plus; the minus of the "
        "opposite impulse on a is only used for its velocity",
        ("both_turn_the_same_way",),
        """
import numpy as np


def _x(a, b):
    return a[0] * b[1] - a[1] * b[0]


def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    m_a, i_a, w_a = a[0], a[1], a[4]
    m_b, i_b, w_b = b[0], b[1], b[4]
    v_a, v_b = np.array(a[2:4], float), np.array(b[2:4], float)

    def relative():
        at_a = v_a + w_a * np.array([-arm_a[1], arm_a[0]])
        at_b = v_b + w_b * np.array([-arm_b[1], arm_b[0]])
        return at_b - at_a

    def k(u):
        return 1 / m_a + 1 / m_b + _x(arm_a, u) ** 2 / i_a + _x(arm_b, u) ** 2 / i_b

    def push(J):
        nonlocal v_a, v_b, w_a, w_b
        v_a = v_a - J / m_a
        v_b = v_b + J / m_b
        w_a = w_a + _x(arm_a, J) / i_a
        w_b = w_b + _x(arm_b, J) / i_b

    n = np.asarray(normal, float)
    vn = relative() @ n
    if vn >= 0:
        return v_a, w_a, v_b, w_b
    jn = -(1 + restitution) * vn / k(n)
    push(jn * n)
    t = np.array([-n[1], n[0]])
    jt = -(relative() @ t) / k(t)
    jt = np.clip(jt, -friction * jn, friction * jn)
    push(jt * t)
    return v_a, w_a, v_b, w_b
""",
    ),
    Wrong(
        "11.3",
        "finds all overlaps once and then works through this list, with normals and "
        "depths that are stale after the first pair has moved",
        ("stale",),
        """
from itertools import combinations

import numpy as np


def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    p = positions + velocities * dt
    v = velocities + np.asarray(gravity) * dt
    # detection
    contacts = []
    for i, j in combinations(range(len(masses)), 2):
        d = p[j] - p[i]
        dist = np.hypot(d[0], d[1])
        depth = radii[i] + radii[j] - dist
        if depth > 0:
            n = d / dist if dist > 0 else np.array([1.0, 0.0])
            contacts.append((i, j, n, depth))
    # response
    for i, j, n, depth in contacts:
        total = 1 / masses[i] + 1 / masses[j]
        vn = (v[j] - v[i]) @ n
        if vn < 0:
            J = -(1 + restitution) * vn / total * n
            v[i] -= J / masses[i]
            v[j] += J / masses[j]
        p[i] -= depth / masses[i] / total * n
        p[j] += depth / masses[j] / total * n
    # walls
    for i in range(len(masses)):
        for axis in (0, 1):
            low, high = radii[i], room[axis] - radii[i]
            if p[i, axis] < low:
                p[i, axis] = low
                if v[i, axis] < 0:
                    v[i, axis] *= -restitution
            elif p[i, axis] > high:
                p[i, axis] = high
                if v[i, axis] > 0:
                    v[i, axis] *= -restitution
    return p, v
""",
    ),
    Wrong(
        "11.6",
        "takes the half life for the time constant of the exponential: exp(-t/T), as in "
        "the book's damped oscillation",
        ("fades_by_e",),
        """
import numpy as np


def knock(loudness, frequency, half_life, rate, count):
    if frequency >= rate / 2:
        return np.zeros(count)
    t = np.arange(count) / rate
    # gedaempfte Schwingung: y = A exp(-t/T) sin(2 pi f t)
    return loudness * np.exp(-t / half_life) * np.sin(2 * np.pi * frequency * t)
""",
    ),
    Wrong(
        "A.2",
        "the recoil is shot_mass * muzzle_speed / ship_mass, as if the muzzle speed "
        "were measured from the ground",
        ("term",),
        """
import numpy as np


def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    direction = np.array([np.cos(heading), np.sin(heading)])
    # actio = reactio: m_shot * v_shot = m_ship * v_recoil
    ship = velocity - shot_mass * muzzle_speed / ship_mass * direction
    # as seen from the ship the shot has muzzle_speed
    shot = ship + muzzle_speed * direction
    return ship, shot
""",
    ),
    Wrong(
        "A.3",
        "every pair is worked out from the velocities at the beginning, and all changes "
        "are added up at the end",
        ("all_from_the_old_velocities",),
        """
import numpy as np


def collide_all(positions, velocities, masses, radii, restitution):
    v = np.asarray(velocities, float)
    change = np.zeros_like(v)
    n = len(masses)
    for i in range(n):
        for j in range(i + 1, n):
            d = positions[j] - positions[i]
            dist = np.sqrt(d @ d)
            if dist == 0 or dist >= radii[i] + radii[j]:
                continue
            u = d / dist
            closing = (v[i] - v[j]) @ u
            if closing <= 0:
                continue
            J = (1 + restitution) * closing / (1 / masses[i] + 1 / masses[j])
            change[i] -= J / masses[i] * u
            change[j] += J / masses[j] * u
    return v + change
""",
    ),
    Wrong(
        "B.2",
        "the bumper's normal is always at right angles to it, on the side of the ball, "
        "even at the round ends",
        ("never_off_a_right_angle",),
        """
import numpy as np

RADIUS = 12.0
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0


def bumper_contact(position):
    way = BUMPER_END - BUMPER_START
    t = (position - BUMPER_START) @ way / (way @ way)
    t = min(1.0, max(0.0, t))
    closest = BUMPER_START + t * way
    gap = np.linalg.norm(position - closest)
    depth = RADIUS + BUMPER_HALF_THICKNESS - gap
    if depth <= 0:
        return None
    normal = np.array([-way[1], way[0]]) / np.linalg.norm(way)
    if (position - closest) @ normal < 0:
        normal = -normal        # the ball is on the other side
    return normal, depth
""",
    ),
    Wrong(
        "B.4",
        "chapter 07 says that a step goes on after an impact, so the ball still flies "
        "for the time it spent in the wall, with its new velocity",
        ("flies_on_from_the_wall",),
        """
import numpy as np

WIDTH, HEIGHT = 600.0, 400.0
RADIUS = 12.0
RESTITUTION = 0.95
TIME_STEP = 1 / 60
BUMPER_START = np.array([260.0, 160.0])
BUMPER_END = np.array([340.0, 240.0])
BUMPER_HALF_THICKNESS = 8.0
NORMALS = {
    "top": np.array([0.0, 1.0]),
    "bottom": np.array([0.0, -1.0]),
    "left": np.array([1.0, 0.0]),
    "right": np.array([-1.0, 0.0]),
}


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
    t = min(1.0, max(0.0, (position - BUMPER_START) @ way / (way @ way)))
    d = position - (BUMPER_START + t * way)
    dist = np.sqrt(d @ d)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    return (d / dist, depth) if depth > 0 else None


def resolve(position, velocity, normal, depth):
    position = position + depth * normal
    vn = velocity @ normal
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position, velocity


def step(position, velocity, dt=TIME_STEP):
    position = position + velocity * dt
    hits = []

    def one(name, normal, depth):
        nonlocal position, velocity
        vn = velocity @ normal
        coming = vn < 0
        position, velocity = resolve(position, velocity, normal, depth)
        if coming:
            hits.append(name)
            # it touched the wall this long ago; do not lose the rest of the step
            rest = min(depth / -vn, dt)
            position = position + velocity * rest

    bumper = bumper_contact(position)
    if bumper is not None:
        one("bumper", *bumper)
    for name, normal, depth in wall_contacts(position):
        one(name, normal, depth)
    return position, velocity, hits
""",
    ),
    Wrong(
        "K.2",
        "the grown brick is a plain rectangle, so a ball that passes a corner "
        "diagonally touches too early",
        ("square_corners",),
        """
import numpy as np

HORIZON = 1.0


def brick_impact(position, velocity, radius, box):
    # Minkowski: grow the brick, shrink the ball to a point, then the slab test
    low = np.array([box[0] - radius, box[1] - radius])
    high = np.array([box[0] + box[2] + radius, box[1] + box[3] + radius])
    t_in, t_out = -np.inf, np.inf
    normal = None
    for k in (0, 1):
        if velocity[k] == 0:
            if not low[k] < position[k] < high[k]:
                return None
            continue
        t1 = (low[k] - position[k]) / velocity[k]
        t2 = (high[k] - position[k]) / velocity[k]
        sign = -1.0
        if t1 > t2:
            t1, t2 = t2, t1
            sign = 1.0
        if t1 > t_in:
            t_in = t1
            normal = np.zeros(2)
            normal[k] = sign
        t_out = min(t_out, t2)
    if normal is None or t_in > t_out or t_in < 0 or t_in > HORIZON:
        return None
    return t_in, normal
""",
    ),
    Wrong(
        "K.3",
        "broken bricks are deleted from the array and the place in what is left is "
        "noted, so later numbers are shifted",
        ("places_among_those_left",),
        """
import numpy as np

HORIZON = 1.0


def brick_impact(position, velocity, radius, box):
    x, y, w, h = box
    found = []
    # faces
    for k, lo, hi in ((0, x, x + w), (1, y, y + h)):
        o_lo, o_hi = ((y, y + h), (x, x + w))[k]
        for side, at in ((-1.0, lo - radius), (1.0, hi + radius)):
            if velocity[k] * side < 0:
                t = (at - position[k]) / velocity[k]
                if t >= 0 and o_lo <= position[1 - k] + velocity[1 - k] * t <= o_hi:
                    n = np.zeros(2)
                    n[k] = side
                    found.append((t, n))
    # corners
    for corner in ((x, y), (x + w, y), (x, y + h), (x + w, y + h)):
        d = position - np.array(corner)
        a, b, c = velocity @ velocity, d @ velocity, d @ d - radius**2
        if b < 0 and b * b >= a * c:
            t = c / (-b + np.sqrt(b * b - a * c))
            if t >= 0:
                n = d + velocity * t
                found.append((t, n / np.linalg.norm(n)))
    found = [f for f in found if f[0] <= HORIZON]
    return min(found, key=lambda f: f[0]) if found else None


def fly(position, velocity, radius, bricks, duration):
    left = np.array(bricks, float)
    broken = []
    while True:
        hits = []
        for k in range(len(left)):
            hit = brick_impact(position, velocity, radius, left[k])
            if hit is not None and hit[0] <= duration:
                hits.append((hit[0], k, hit[1]))
        if not hits:
            return position + velocity * duration, velocity, broken
        t, k, normal = min(hits, key=lambda h: h[0])
        position = position + velocity * t
        velocity = velocity - 2 * (velocity @ normal) * normal
        duration -= t
        broken.append(k)
        left = np.delete(left, k, axis=0)
""",
    ),
    Wrong(
        "C.1",
        "after a strike the shock simply runs on to the right; the row is swept left to "
        "right again and again, instead of going back to the leftmost pair",
        ("sweep_after_sweep",),
        """
import numpy as np

SLOWEST = 1e-12


def collide_row(masses, velocities, restitution):
    v = np.array(velocities, dtype=float)
    something_happened = True
    while something_happened:
        something_happened = False
        for i in range(len(v) - 1):
            if v[i] - v[i + 1] > SLOWEST:
                m1, m2 = masses[i], masses[i + 1]
                V = (m1 * v[i] + m2 * v[i + 1]) / (m1 + m2)
                v[i] = V - restitution * (v[i] - V)
                v[i + 1] = V - restitution * (v[i + 1] - V)
                something_happened = True
    return v
""",
    ),
    Wrong(
        "C.2",
        "the string pendulum pulls back with -g/l times the angle, the book's formula "
        "for small angles",
        ("small_angles",),
        """
GRAVITY = 9.81


def swing_step(angle, rate, length, dt):
    # Fadenpendel: phi'' = -g/l * phi
    rate = rate - GRAVITY / length * angle * dt
    angle = angle + rate * dt
    return angle, rate
""",
    ),
    Wrong(
        "D.2",
        "the centre is lifted from h to the length of the diagonal, though both are "
        "twice as high as the centre",
        ("whole_diagonal",),
        """
import math

GRAVITY = 9.81


def toppling_rate(width, height):
    # 1/2 I w^2 = m g (h_top - h_now)
    diagonal = math.sqrt(width**2 + height**2)
    lift = diagonal - height
    inertia_per_mass = diagonal**2 / 3
    return math.sqrt(2 * GRAVITY * lift / inertia_per_mass)
""",
    ),
    Wrong(
        "D.3",
        "the chain ends at the first domino that does not touch the next one (break), "
        "so pairs further on that do touch get no push",
        ("break_off", "ends_at_the_first_that_stands_free"),
        """
import math

import numpy as np

GRAVITY = 9.81


def chain(angles, rates, height, spacing, dt, steps):
    a = np.array(angles, float)
    w = np.array(rates, float)
    reach = math.asin(spacing / height)
    for _ in range(int(steps)):
        w += 3 * GRAVITY / (2 * height) * np.sin(a) * dt
        a += w * dt
        for k in range(len(a) - 1):
            if a[k] <= reach:
                break                 # the wave has not come further
            if w[k] > w[k + 1]:
                w[k] = w[k + 1] = (w[k] + w[k + 1]) / 2
        flat = a > math.pi / 2
        a[flat] = math.pi / 2
        w[flat] = 0
    return a, w
""",
    ),
    Wrong(
        "P.1",
        "rows are as far apart as the balls in a row, so the rack is too long",
        ("square_rows",),
        """
import numpy as np


def rack(apex, radius, gap):
    s = 2 * radius + gap
    balls = []
    for row in range(5):
        for k in range(row + 1):
            balls.append([apex[0] + row * s, apex[1] + (k - row / 2) * s])
    return np.array(balls)
""",
    ),
    Wrong(
        "P.2",
        "the x part of the impulse is the strength of the stroke; right only for "
        "strokes to the right",
        ("pushed_along_x_alone",),
        """
import numpy as np


def strike(impulse, offset, mass, radius):
    velocity = np.asarray(impulse) / mass
    # torque impulse = offset * J, to the left of the centre turns it clockwise
    inertia = 2 / 5 * mass * radius**2
    spin = -offset * impulse[0] / inertia
    return velocity, spin
""",
    ),
    Wrong(
        "P.3",
        "each ball divides by its own count, so the two balls of a pair receive unequal impulses",
        ("each_by_its_own_count",),
        """
import numpy as np

TOUCHING = 2.001
ROUNDS = 20


def share_impact(positions, velocities, radius, restitution):
    p = np.asarray(positions, float)
    v = np.array(velocities, float)
    n = len(p)
    for _ in range(ROUNDS):
        pairs = []
        count = np.zeros(n, int)
        for i in range(n):
            for j in range(i + 1, n):
                d = p[j] - p[i]
                dist = np.linalg.norm(d)
                if dist > TOUCHING * radius:
                    continue
                u = d / dist
                closing = (v[i] - v[j]) @ u
                if closing > 0:
                    pairs.append((i, j, u, closing))
                    count[i] += 1
                    count[j] += 1
        dv = np.zeros_like(v)
        for i, j, u, closing in pairs:
            alone = (1 + restitution) * closing / 2      # equal masses
            dv[i] -= alone / count[i] * u
            dv[j] += alone / count[j] * u
        v += dv
    return v
""",
    ),
    Wrong(
        "S.2",
        "the damper brakes all of the relative velocity of two neighbours, also the "
        "part across the spring",
        ("damps_across_the_springs",),
        """
import numpy as np


def ring_forces(positions, velocities, length, stiffness, damping):
    forces = np.zeros_like(positions, dtype=float)
    n = len(positions)
    for i in range(n):
        j = (i + 1) % n
        d = positions[j] - positions[i]
        dist = np.linalg.norm(d)
        # Federkraft + Daempferkraft (F = -d * v_rel)
        f = stiffness * (dist - length) * d / dist
        f = f + damping * (velocities[j] - velocities[i])
        forces[i] += f
        forces[j] -= f
    return forces
""",
    ),
    Wrong(
        "S.3",
        "the gas pushes every mass straight away from the middle of the ring; right "
        "only for a regular ring",
        ("by_the_chord_from_the_middle",),
        """
import numpy as np


def pressure_forces(positions, area, stiffness):
    nxt = np.roll(positions, -1, axis=0)
    prev = np.roll(positions, 1, axis=0)
    now = 0.5 * np.sum(positions[:, 0] * nxt[:, 1] - positions[:, 1] * nxt[:, 0])
    p = stiffness * (area / now - 1)
    middle = positions.mean(axis=0)
    forces = np.zeros_like(positions, dtype=float)
    for i in range(len(positions)):
        out = positions[i] - middle
        out = out / np.linalg.norm(out)
        # the edges before and after, half of each: size of the two half pushes together
        chord = np.linalg.norm(nxt[i] - prev[i])
        forces[i] = p * chord / 2 * out
    return forces
""",
    ),
)
