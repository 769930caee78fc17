"""Right answers as students write them who took another way: each with the way it goes.

`RIGHT` earn full marks. `LACKING` are right but for one thing, which the message has to name.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Unusual:
    """A right answer: which task it answers, what is unusual in it, and its source.

    `says` is what the message must say of an answer that lacks something.
    """

    task: str
    way: str
    source: str
    says: str = ""


RIGHT = (
    Unusual("1.1", "exact fractions of its inputs", """\
from fractions import Fraction as F
def elastic_1d(m1, v1, m2, v2):
    m1, v1, m2, v2 = map(F, (m1, v1, m2, v2))
    return [((m1 - m2) * v1 + 2 * m2 * v2) / (m1 + m2), ((m2 - m1) * v2 + 2 * m1 * v1) / (m1 + m2)]
"""),
    Unusual("1.1", "a generator", """\
def elastic_1d(m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    for v in (v1, v2):
        yield 2 * c - v
"""),
    Unusual("1.1", "a linear system", """\
from numpy import *
def elastic_1d(m1, v1, m2, v2):
    return linalg.solve([[m1, m2], [-1, 1]], [m1 * v1 + m2 * v2, v1 - v2])
"""),
    Unusual("1.1", "decimals", """\
from decimal import Decimal, getcontext
getcontext().prec = 40
def elastic_1d(*given):
    m1, v1, m2, v2 = (Decimal(float(x)) for x in given)
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * c - v1, 2 * c - v2
"""),
    Unusual("1.2", "a lambda that is assigned", """\
inelastic_1d = lambda m1, v1, m2, v2: 2 * ((m1 * v1 + m2 * v2) / (m1 + m2),)
"""),
    Unusual("1.2", "a NumPy average, filled in", """\
import numpy as np
def inelastic_1d(m1, v1, m2, v2):
    return np.full(2, np.average([v1, v2], weights=[m1, m2]))
"""),
    Unusual("1.3", "a walrus and a NumPy scalar", """\
import numpy as np
def elastic_impulse_1d(m1, v1, m2, v2):
    return np.float64(2) * (reduced := m1 * m2 / (m1 + m2)) * (v1 - v2)
"""),
    Unusual("1.3", "an array of no dimensions", """\
import numpy as np
def elastic_impulse_1d(m1, v1, m2, v2):
    return np.array(2 * (v1 - v2) / (1 / m1 + 1 / m2))
"""),
    Unusual("1.3", "a value that is displayed on the way", """\
from IPython.display import display, Markdown
def elastic_impulse_1d(m1, v1, m2, v2):
    reduced = m1 * m2 / (m1 + m2)
    display(reduced)
    return 2 * reduced * (v1 - v2)
"""),
    Unusual("2.1", "try and except for what cannot be", """\
def restitution_1d(v1, v2, v1_after, v2_after):
    try:
        return abs(v2_after - v1_after) / abs(v1 - v2)
    except ZeroDivisionError:
        return None
"""),
    Unusual("2.2", "one step of kinetic theory: a class with methods", """\
class Ball:
    def __init__(self, m, v):
        self.m, self.v = m, v
    def kick(self, j):
        return self.v + j / self.m
def collide_1d(m1, v1, m2, v2, restitution):
    a, b = Ball(m1, v1), Ball(m2, v2)
    j = (1 + restitution) * (b.v - a.v) / (1 / a.m + 1 / b.m)
    return a.kick(j), b.kick(-j)
"""),
    Unusual("2.2", "a mixture of elastic and inelastic, by keyword", """\
def mixed(*, elastic, inelastic, e):
    return e * elastic + (1 - e) * inelastic
def collide_1d(m1, v1, m2, v2, restitution=1.0):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return tuple(mixed(e=restitution, inelastic=c, elastic=2 * c - v) for v in (v1, v2))
"""),
    Unusual("2.2", "a named tuple", """\
from typing import NamedTuple
class After(NamedTuple):
    v1: float
    v2: float
def collide_1d(m1, v1, m2, v2, restitution):
    J = -(1 + restitution) * (v2 - v1) * m1 * m2 / (m1 + m2)
    return After(v2=v2 + J / m2, v1=v1 - J / m1)
"""),
    Unusual("2.3", "recursion", """\
def bounce_heights(height, restitution, count):
    if count == 0:
        return []
    h = height * restitution ** 2
    return [h] + bounce_heights(h, restitution, count - 1)
"""),
    Unusual("2.3", "itertools", """\
from itertools import accumulate, repeat
from operator import mul
def bounce_heights(height, restitution, count):
    return list(accumulate(repeat(restitution ** 2, count), mul, initial=height))[1:]
"""),
    Unusual("2.3", "a map", """\
def bounce_heights(height, restitution, count):
    return map(lambda n: height * restitution ** n, range(2, 2 * count + 1, 2))
"""),
    Unusual("2.3", "NumPy's powers of whole numbers", """\
import numpy as np
def bounce_heights(height, restitution, count):
    return height * np.power(restitution, 2 * np.arange(1, count + 1))
"""),
    Unusual("2.4", "a sum until it no longer changes", """\
def rest_time(height, restitution, gravity):
    t, flight = 0.0, (2 * height / gravity) ** 0.5
    t = flight
    while True:
        flight *= restitution
        if t + 2 * flight == t:
            return t
        t += 2 * flight
"""),
    Unusual("3.1", "complex numbers", """\
def reflect(incident, normal):
    z, n = complex(*incident), complex(*normal)
    return -n * n * z.conjugate()
"""),
    Unusual("3.1", "a reflection matrix", """\
import numpy as np
def reflect(incident, normal):
    H = np.eye(2) - 2 * np.outer(normal, normal)
    return (H @ incident.reshape(2, 1)).ravel()
"""),
    Unusual("3.1", "angles", """\
from math import atan2, hypot, cos, sin, pi
def reflect(incident, normal):
    a, b = atan2(incident[1], incident[0]), atan2(normal[1], normal[0])
    out = 2 * b + pi - a
    return hypot(*incident) * cos(out), hypot(*incident) * sin(out)
"""),
    Unusual("3.1", "pygame's own reflection", """\
import pygame
def reflect(incident, normal):
    return pygame.Vector2(*incident).reflect(pygame.math.Vector2(*normal))
"""),
    Unusual("3.1", "a rotated frame, and a closure", """\
import numpy as np
def frame(n):
    R = np.array([[n[0], n[1]], [-n[1], n[0]]])
    def flipped(v):
        return R.T @ (np.array([-1, 1]) * (R @ v))
    return flipped
def reflect(incident, normal): return frame(normal)(incident)
"""),
    Unusual("3.2", "a match statement and default arguments", """\
import numpy as np
def bounce(velocity, normal, restitution, *, dot=np.dot):
    match bool(dot(velocity, normal) < 0):
        case True:
            along = dot(velocity, normal) * normal
            return velocity - along - restitution * along
        case False:
            return velocity
"""),
    Unusual("3.2", "in place, on what it was given", """\
import numpy as np
def bounce(velocity, normal, restitution):
    velocity -= (1 + restitution) * min(velocity @ normal, 0) * normal
    return velocity
"""),
    Unusual("3.3", "a dataclass with a property", """\
from __future__ import annotations
from dataclasses import dataclass
import numpy as np
@dataclass
class Ball:
    p: np.ndarray
    v: np.ndarray
    def hit(self, n: np.ndarray, e: float) -> Ball:
        s = self.v.dot(n)
        return self if s > 0 else Ball(self.p, self.v - (1 + e) * s * n)
    def __iter__(self):
        return iter((self.p, self.v))
def resolve_wall(position, velocity, normal, depth, restitution):
    return Ball(position + depth * normal, velocity).hit(normal, restitution)
"""),
    Unusual("4.1", "one early return after another, and complex numbers", """\
def circle_contact(p1, r1, p2, r2):
    way = complex(*p2) - complex(*p1)
    if abs(way) >= r1 + r2: return None
    if way == 0: return [1, 0], r1 + r2
    return way / abs(way), r1 + r2 - abs(way)
"""),
    Unusual("4.2", "projection matrices", """\
import numpy as np
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    P = np.outer(normal, normal)
    u = P @ (v1 - v2)
    if u @ normal <= 0:
        return np.vstack([v1, v2])
    mu = m1 * m2 / (m1 + m2)
    return np.vstack([v1 - mu / m1 * (1 + restitution) * u, v2 + mu / m2 * (1 + restitution) * u])
"""),
    Unusual("4.2", "a rotated frame and one dimension", """\
import numpy as np
def one_d(m1, u1, m2, u2, e):
    c = (m1 * u1 + m2 * u2) / (m1 + m2)
    return c - e * (u1 - c), c - e * (u2 - c)
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    nx, ny = normal
    R = np.array([[nx, ny], [-ny, nx]])
    a, b = R @ v1, R @ v2
    if a[0] > b[0]:
        a[0], b[0] = one_d(m1, a[0], m2, b[0], restitution)
    return R.T @ a, R.T @ b
"""),
    Unusual("4.3", "shares of a whole, with the fixed one apart", """\
from math import isinf
def separate(p1, m1, p2, m2, normal, depth):
    if isinf(m1): share = 0
    elif isinf(m2): share = 1
    else: share = m2 / (m1 + m2)
    return list(p1 - share * depth * normal), list(p2 + (1 - share) * depth * normal)
"""),
    Unusual("4.4", "all in one, with a global constant", """\
import numpy as np
NOTHING = 0.0
def resolve_overlap(p1, v1, m1, p2, v2, m2, normal, depth, restitution):
    w = np.array([1 / m1, 1 / m2]) * (-1, 1)
    k = np.abs(w).sum()
    J = max(NOTHING, (1 + restitution) * np.dot(v1 - v2, normal)) / k
    p = np.stack([p1, p2]) + np.outer(w, normal) * depth / k
    v = np.stack([v1, v2]) + np.outer(w, normal) * J
    return p[0], v[0], p[1], v[1]
"""),
    Unusual("5.1", "triangles from the centroid", """\
import numpy as np
def area(a, b): return (a[0] * b[1] - a[1] * b[0]) / 2
def moment_of_inertia(mass, vertices):
    n = len(vertices)
    pairs = [(vertices[i - 1], vertices[i]) for i in range(n)]
    A = sum(area(a, b) for a, b in pairs)
    c = sum(area(a, b) * (a + b) / 3 for a, b in pairs) / A
    I = 0
    for a, b in ((a - c, b - c) for a, b in pairs):
        I += area(a, b) * (a @ a + a @ b + b @ b) / 6
    return mass * I / A
"""),
    Unusual("5.2", "i times r", """\
def contact_velocity(v, w, r):
    return complex(*v) + 1j * w * complex(*r)
"""),
    Unusual("5.2", "NumPy's cross product in space", """\
import numpy as np
def contact_velocity(v, w, r):
    return v + np.cross([0, 0, w], [*r, 0])[:2]
"""),
    Unusual("5.3", "a Jacobian and a mass matrix", """\
import numpy as np
def inverse_effective_mass(m_a, i_a, r_a, m_b, i_b, r_b, direction):
    d = np.asarray(direction)
    turn = lambda r: r[0] * d[1] - r[1] * d[0]
    J = np.array([-d[0], -d[1], -turn(r_a), d[0], d[1], turn(r_b)])
    return J @ np.diag([1 / m_a, 1 / m_a, 1 / i_a, 1 / m_b, 1 / m_b, 1 / i_b]) @ J.T
"""),
    Unusual("5.4", "the middle of three", """\
import numpy as np
friction_impulse = lambda vt, jn, friction, k: np.median([-friction * jn, -vt / k, friction * jn])
"""),
    Unusual("5.4", "signs and sizes", """\
from math import copysign
def friction_impulse(vt, jn, friction, k):
    if not vt:
        return 0
    stick = abs(vt) / k
    slide = friction * jn
    return copysign(stick if stick < slide else slide, -vt)
"""),
    Unusual("6.1", "complex edges", """\
import numpy as np
def sat_axes(vertices):
    z = np.array([complex(x, y) for x, y in vertices])
    e = np.roll(z, -1) - z
    e = e[abs(e) > 0]
    return -1j * e / abs(e)
"""),
    Unusual("6.2", "a sorted list, its ends", """\
def project(vertices, axis):
    first, *_, last = sorted(float(x * axis[0] + y * axis[1]) for x, y in vertices)
    return {"low": first, "high": last}.values()
"""),
    Unusual("6.3", "a conditional chain, with unpacked intervals", """\
def overlap(interval_a, interval_b):
    (a, b), (c, d) = interval_a, interval_b
    return None if b <= c or d <= a else min(b - c, d - a)
"""),
    Unusual("6.5", "cut as a polygon is cut, with a while loop", """\
def clip(start, end, normal, offset):
    points, inside = [start, end], []
    i = 0
    while i < 2:
        p, q = points[i], points[1 - i]
        a, b = p @ normal - offset, q @ normal - offset
        if a <= 0: inside.append(p)
        elif b <= 0: inside.append((p * -b + q * a) / (a - b))
        i += 1
    return inside or None
"""),
    Unusual("7.2", "NumPy's roots, the stable way round", """\
import numpy as np
def time_to_floor(height, velocity, gravity):
    w = np.sqrt(velocity * velocity + 2 * gravity * height)
    with np.errstate(all="ignore"):
        t = np.where(velocity < 0, 2 * height / (w - velocity), np.divide(velocity + w, gravity))
    return t if np.isfinite(t) else None
"""),
    Unusual("7.5", "digits by trigonometry", """\
import math
def pi_collisions(mass_ratio):
    return math.ceil(math.pi / math.atan(mass_ratio ** -0.5)) - 1
"""),
    Unusual("8.1", "the longest of vectors, by key", """\
def largest_error(places, right):
    worst = max(zip(places, right), key=lambda both: sum((both[0] - both[1]) ** 2))
    return sum((a - b) ** 2 for a, b in zip(*worst)) ** .5
"""),
    Unusual("8.3", "the normal equations", """\
import numpy as np
def fit_power(steps, errors):
    A = np.column_stack((np.log(steps), np.ones(len(steps))))
    p, c = np.linalg.inv(A.T @ A) @ A.T @ np.log(errors)
    return p, np.exp(c)
"""),
    Unusual("8.5", "NumPy's masks, and a whole number of its own type", """\
import numpy as np
def cheapest(table, allowed):
    table = np.asarray(table, dtype=float)
    costs = np.where(table[:, 1] <= allowed, table[:, 0], np.inf)
    best = np.argmin(costs)
    return best if np.isfinite(costs[best]) else None
"""),
    Unusual("9.1", "sums from the top down", """\
def tower_forces(masses, gravity):
    total, forces = 0.0, []
    for m in reversed(masses):
        total += m
        forces.insert(0, total * gravity)
    return tuple(forces)
"""),
    Unusual("9.2", "a whole number found by halving", """\
from math import log1p, log
def sweeps_needed(light, heavy, left):
    enough = lambda n: n * log1p(light / heavy) >= log(1 / left)
    low, high = 0, 1
    while not enough(high):
        high *= 2
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if enough(middle) else (middle, high)
    return high
"""),
    Unusual("10.1", "a comprehension with a default", """\
def most_friction(inverse_masses, frictions):
    both = list(zip(inverse_masses, frictions))
    pairs = [(one, two) for i, one in enumerate(both) for two in both[:i]]
    return max(((f * g) ** 0.5 for (w, f), (u, g) in pairs if w or u), default=0)
"""),
    Unusual("11.1", "NumPy's whole tables", """\
import numpy as np
def near_pairs(boxes):
    l, r, b, t = boxes.T
    near = (l[:, None] <= r) & (l <= r[:, None]) & (b[:, None] <= t) & (b <= t[:, None])
    return np.argwhere(np.triu(near, 1))
"""),
    Unusual("10.2", "a set of names", """\
from itertools import combinations
def effects_called_for(bodies, gravity):
    pairs = [(a, b) for a, b in combinations(bodies, 2) if a[0] > 0 or b[0] > 0]
    found = {"friction"} if any(a[3] * b[3] > 0 for a, b in pairs) else set()
    if gravity.any():
        found.add("gravity")
    if any(min(a[2], b[2]) > 0 for a, b in pairs):
        found.add("restitution")
    if any(b[4] or (b[0] > 0 and (b[1] or "friction" in found)) for b in bodies):
        found.add("rotation")
    return found
"""),
    Unusual("10.5", "a difference of sets", """\
def bodies_asleep(inverse_masses, still, touches):
    free = {n for n, w in enumerate(inverse_masses) if w}
    awake = left = {n for n in free if not still[n]}
    while left:
        left = {b for a in left for b in free if touches[a][b]} - awake
        awake = awake | left
    return free - awake
"""),
    Unusual("11.1", "a set of pairs", """\
def near_pairs(boxes):
    return {
        (i, j)
        for j, (l, r, b, t) in enumerate(boxes)
        for i, (le, ri, bo, to) in enumerate(boxes[:j])
        if l <= ri and le <= r and b <= to and bo <= t
    }
"""),
    Unusual("11.4", "two differences of sets", """\
def touch_changes(before, now):
    earlier, later = ({tuple(map(int, pair)) for pair in pairs} for pairs in (before, now))
    return later - earlier, earlier - later
"""),
    Unusual("D.1", "the angle of a complex number", """\
import cmath
def tipping_angle(width, height): return cmath.phase(complex(height, width))
"""),
    Unusual("A.2", "polar form", """\
import cmath
def fire(velocity, ship_mass, shot_mass, muzzle_speed, heading):
    shot = cmath.rect(muzzle_speed, heading)
    ship = complex(*velocity) - shot * shot_mass / (ship_mass + shot_mass)
    return ship, ship + shot
"""),
    Unusual("C.2", "state in a list", """\
import numpy as np
def swing_step(angle, rate, length, dt):
    state = [angle, rate]
    state[1] -= 9.81 * np.sin(state[0]) / length * dt
    state[0] += state[1] * dt
    return np.array(state)
"""),
    Unusual("1.1", "a frame that moves with the first", """\
def elastic_1d(m1, v1, m2, v2):
    u = v2 - v1
    return v1 + 2 * m2 * u / (m1 + m2), v1 + (m2 - m1) * u / (m1 + m2)
"""),
    Unusual("1.1", "an impulse by bisection of the energy", """\
def elastic_1d(m1, v1, m2, v2):
    def gain(j):
        return j * (v2 - v1) + j * j / 2 * (1 / m1 + 1 / m2)
    low, high = (v1 - v2) / (1 / m1 + 1 / m2), 10 * (v1 - v2) / (1 / m1 + 1 / m2)
    for _ in range(200):
        j = (low + high) / 2
        low, high = (j, high) if gain(j) * (v1 - v2) < 0 or gain(j) < 0 else (low, j)
    return v1 - j / m1, v2 + j / m2
"""),
    Unusual("1.1", "a class whose call is the answer", """\
class Elastic:
    def __call__(self, m1, v1, m2, v2):
        c = (m1 * v1 + m2 * v2) / (m1 + m2)
        return 2 * c - v1, 2 * c - v2
elastic_1d = Elastic()
"""),
    Unusual("1.1", "partial application, and a cache", """\
from functools import lru_cache, partial
@lru_cache(maxsize=None)
def both(factor, m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return factor * c - v1, factor * c - v2
elastic_1d = partial(both, 2)
"""),
    Unusual("1.2", "a deque", """\
from collections import deque
def inelastic_1d(m1, v1, m2, v2):
    return deque([(m1 * v1 + m2 * v2) / (m1 + m2)] * 2, maxlen=2)
"""),
    Unusual("1.2", "an array of the array module", """\
from array import array
def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return array("d", (v, v))
"""),
    Unusual("1.3", "an integral of the force, by fsum", """\
from math import fsum
def elastic_impulse_1d(m1, v1, m2, v2):
    n, peak = 1000, 2 * (v1 - v2) / (1 / m1 + 1 / m2)
    return fsum([peak / n] * n)
"""),
    Unusual("1.3", "names of another alphabet", """\
def elastic_impulse_1d(m1, v1, m2, v2):
    μ = 1 / (1 / m1 + 1 / m2)
    Δv = v1 - v2
    return 2 * μ * Δv
"""),
    Unusual("2.3", "a while loop that pops", """\
def bounce_heights(height, restitution, count):
    left, found = list(range(count)), []
    while left:
        left.pop()
        height *= restitution * restitution
        found += [height]
    return found
"""),
    Unusual("2.3", "a generator that is delegated to", """\
def forever(height, factor):
    while True:
        height *= factor
        yield height
def bounce_heights(height, restitution, count):
    from itertools import islice
    yield from islice(forever(height, restitution ** 2), count)
"""),
    Unusual("2.4", "the sum in closed form, through a context", """\
import contextlib, decimal
def rest_time(height, restitution, gravity):
    with decimal.localcontext() as context:
        context.prec = 30
        h, e, g = (decimal.Decimal(float(x)) for x in (height, restitution, gravity))
        return (2 * h / g).sqrt() * (1 + e) / (1 - e)
"""),
    Unusual("3.1", "the part along the wall, kept", """\
def reflect(incident, normal):
    (x, y), (nx, ny) = incident, normal
    t = (-ny, nx)
    along, into = x * t[0] + y * t[1], x * nx + y * ny
    return [a * along - b * into for a, b in zip(t, normal)]
"""),
    Unusual("3.1", "einsum", """\
import numpy as np
def reflect(incident, normal):
    return incident - 2 * np.einsum("i,i,j->j", incident, normal, normal)
"""),
    Unusual("3.1", "a masked array without a mask", """\
import numpy as np
def reflect(incident, normal):
    v = np.ma.array(incident)
    return v - 2 * np.ma.dot(v, np.ma.array(normal)) * normal
"""),
    Unusual("3.2", "an exception as a gate", """\
class Leaves(Exception): pass
def bounce(velocity, normal, restitution):
    try:
        s = sum(a * b for a, b in zip(velocity, normal))
        if s >= 0: raise Leaves
        return tuple(a - (1 + restitution) * s * b for a, b in zip(velocity, normal))
    except Leaves:
        return tuple(velocity)
    finally:
        pass
"""),
    Unusual("4.1", "hypot and a string of conditions", """\
from math import dist
def circle_contact(p1, r1, p2, r2):
    d = dist(p1, p2)
    n = [(b - a) / d for a, b in zip(p1, p2)] if d else (1.0, 0.0)
    return (n, r1 + r2 - d) if d < r1 + r2 else None
"""),
    Unusual("5.2", "a matrix that turns by a right angle", """\
import numpy as np
def contact_velocity(v, w, r):
    return v + w * np.array([[0, -1], [1, 0]]) @ r
"""),
    Unusual("5.4", "clip", """\
import numpy as np
def friction_impulse(vt, jn, friction, k):
    return np.clip(-vt / k, -friction * jn, friction * jn)
"""),
    Unusual("6.2", "NumPy's peaks, as an iterator", """\
import numpy as np
def project(vertices, axis):
    shadow = np.asarray(vertices) @ axis
    return iter((shadow.min(), shadow.max()))
"""),
    Unusual("6.3", "a heap", """\
import heapq
def overlap(interval_a, interval_b):
    depth = min(heapq.nsmallest(1, (interval_a[1] - interval_b[0], interval_b[1] - interval_a[0])))
    return depth if depth > 0 else None
"""),
)  # fmt: skip

LACKING = (
    Unusual("3.1", "single precision", """\
import numpy as np
def reflect(incident, normal):
    i, n = np.float32(incident), np.float32(normal)
    return i - 2 * np.dot(i, n) * n
""", "float32"),
    Unusual("3.1", "a column", """\
import numpy as np
def reflect(incident, normal):
    i, n = np.array(incident).reshape(2, 1), np.array(normal).reshape(2, 1)
    return i - 2 * n @ (n.T @ i)
""", "yours is a column. np.ravel(...) helps"),
    Unusual("3.1", "a column of a matrix", """\
import numpy as np
def reflect(incident, normal):
    i, n = np.asmatrix(incident).T, np.asmatrix(normal).T
    return i - 2 * n * (n.T * i)
""", "yours is a column. np.ravel(...) helps"),
    Unusual("1.1", "names for its values", """\
def elastic_1d(m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return {"v1": 2 * c - v1, "v2": 2 * c - v2}
""", "returned an object of type dict, which is no number, vector or tuple"),
    Unusual("1.1", "a set", """\
def elastic_1d(m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return {2 * c - v1, 2 * c - v2}
""", "returned a set where the order counts"),
    Unusual("11.1", "a list of pairs without order", """\
def near_pairs(boxes):
    return [
        frozenset((i, j))
        for j, (l, r, b, t) in enumerate(boxes)
        for i, (le, ri, bo, to) in enumerate(boxes[:j])
        if l <= ri and le <= r and b <= to and bo <= t
    ]
""", "returned a set where the order counts"),
    Unusual("1.3", "a list of one number", """\
def elastic_impulse_1d(m1, v1, m2, v2):
    return [2 * (v1 - v2) / (1 / m1 + 1 / m2)]
""", "One number was asked for"),
    Unusual("2.4", "three decimals", """\
def rest_time(height, restitution, gravity):
    return round((2 * height / gravity) ** 0.5 * (1 + restitution) / (1 - restitution), 5)
""", "Is something rounded?"),
    Unusual("1.1", "a printed answer", """\
def elastic_1d(m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    print(2 * c - v1, 2 * c - v2)
""", "is a return missing?"),
    Unusual("1.1", "a coroutine", """\
async def elastic_1d(m1, v1, m2, v2):
    c = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * c - v1, 2 * c - v2
""", "type coroutine"),
)  # fmt: skip
