"""Wrong answers of all chapters and programs, a mistake each, written from the tasks alone.

They are a sample of 469, most of them of those that were not explained, or wrongly. When all were
first tried, after what TWELFTH had taught, 403 had the right hint and five a false or misleading
one; after it, 432 and none.
"""

from __future__ import annotations

from course.recognition.students import Wrong

THIRTEENTH = (
    Wrong(
        "1.1",
        "the velocity of the centre of mass from speeds",
        ("absolute",),
        """
def elastic_1d(m1, v1, m2, v2):
    V = (m1 * abs(v1) + m2 * abs(v2)) / (m1 + m2)
    return (2 * V - v1, 2 * V - v2)
""",
    ),
    Wrong(
        "1.1",
        "leaves body 2 out of the momentum of the centre of mass, as if it were always at rest",
        (
            "sign",
            "term",
        ),
        """
elastic_1d = lambda m1, v1, m2, v2: (
    2 * (m1 * v1) / (m1 + m2) - v1,
    2 * (m1 * v1) / (m1 + m2) - v2,
)
""",
    ),
    Wrong(
        "2.3",
        "squares the factor anew for each bounce, so the exponent doubles",
        ("power_doubles_each_time",),
        """
def bounce_heights(height, restitution, count):
    result = []
    factor = restitution
    for i in range(count):
        factor = factor**2
        result.append(height * factor)
    return result
""",
    ),
    Wrong(
        "2.3",
        "returns inside the loop after the first bounce",
        ("once",),
        """
def bounce_heights(height, restitution, count):
    heights = []
    for k in range(1, count + 1):
        heights.append(height * restitution ** (2 * k))
        return heights
    return heights
""",
    ),
    Wrong(
        "3.1",
        "uses the already changed x in the dot product for the y component",
        ("updated",),
        """
def reflect(incident, normal):
    x, y = incident
    nx, ny = normal
    x = x - 2 * (x * nx + y * ny) * nx
    y = y - 2 * (x * nx + y * ny) * ny
    return x, y
""",
    ),
    Wrong(
        "3.2",
        "asks whether the ball falls (vy < 0) instead of whether it moves against the normal",
        ("along",),
        """
def bounce(velocity, normal, restitution):
    if velocity[1] < 0:
        velocity = velocity - (1 + restitution) * np.dot(velocity, normal) * normal
    return velocity
""",
    ),
    Wrong(
        "4.1",
        "gives depth 0 for coinciding centres because the distance is 0",
        (),
        """
def circle_contact(p1, r1, p2, r2):
    d = p2 - p1
    dist = float(np.hypot(*d))
    if dist == 0.0:
        return np.array([1.0, 0.0]), dist
    depth = (r1 + r2) - dist
    if depth > 0:
        return d / dist, depth
""",
    ),
    Wrong(
        "4.2",
        "uses the updated v1 to compute the impulse for circle 2",
        ("updated",),
        """
def resolve_circles(v1, m1, v2, m2, normal, restitution):
    mu = m1 * m2 / (m1 + m2)
    if np.dot(v2 - v1, normal) >= 0:
        return v1, v2
    v1 = v1 + (1 + restitution) * mu * np.dot(v2 - v1, normal) / m1 * normal
    v2 = v2 - (1 + restitution) * mu * np.dot(v2 - v1, normal) / m2 * normal
    return v1, v2
""",
    ),
    Wrong(
        "5.1",
        "ends the sums of the moment at the last but one vertex, so an edge is missing",
        ("count",),
        """
def centroid(vs):
    a = cx = cy = 0.0
    for i in range(len(vs)):
        x0, y0 = vs[i]
        x1, y1 = vs[i - len(vs) + 1]
        d = x0 * y1 - x1 * y0
        a += d
        cx += (x0 + x1) * d
        cy += (y0 + y1) * d
    return np.array([cx / (3 * a), cy / (3 * a)])


def moment_of_inertia(mass, vertices):
    c = centroid(vertices)
    num = den = 0
    for i in range(len(vertices) - 1):
        p = vertices[i] - c
        q = vertices[i + 1] - c
        num += (p @ p + p @ q + q @ q) * cross(p, q)
        den += cross(p, q)
    return mass * num / (6 * den)
""",
    ),
    Wrong(
        "6.1",
        "leaves out every edge in which x or y does not change, instead of both",
        ("no_level_and_no_upright_edges",),
        """
def sat_axes(vertices):
    axes = []
    n = len(vertices)
    for i in range(n):
        x0, y0 = vertices[i]
        x1, y1 = vertices[(i + 1) % n]
        dx, dy = x1 - x0, y1 - y0
        if dx == 0 or dy == 0:
            continue
        L = (dx * dx + dy * dy) ** 0.5
        axes.append((-dy / L, dx / L))
    return axes
""",
    ),
    Wrong(
        "6.3",
        "looks only at the way to the right: assumes that B lies right of A",
        ("leaves_on_the_right",),
        """
def overlap(interval_a, interval_b):
    way = interval_a[1] - interval_b[0]
    if way <= 0 or interval_b[1] <= interval_a[0]:
        return None
    return way
""",
    ),
    Wrong(
        "6.5",
        "returns None where a single point of the segment lies on the line",
        ("the_line_is_outside",),
        """
def clip(start, end, normal, offset):
    a = np.dot(start, normal) - offset
    b = np.dot(end, normal) - offset
    if a >= 0 and b >= 0:
        return None
    if a <= 0 and b <= 0:
        return start, end
    cut = start + (end - start) * a / (a - b)
    return (start, cut) if a < 0 else (cut, end)
""",
    ),
    Wrong(
        "6.5",
        "always puts the inner end first, so the segment is turned when the start is cut",
        ("cut_always_last",),
        """
def clip(start, end, normal, offset):
    a = np.dot(start, normal) - offset
    b = np.dot(end, normal) - offset
    if a > 0 and b > 0:
        return None
    if a <= 0 and b <= 0:
        return start, end
    point = start + a / (a - b) * (end - start)
    inner = start if a <= 0 else end
    return inner, point
""",
    ),
    Wrong(
        "6.5",
        "cuts the end only and forgets that the start may be outside",
        ("only_the_end_is_cut",),
        """
def clip(start, end, normal, offset):
    ds, de = np.dot(start, normal), np.dot(end, normal)
    if ds > offset and de > offset:
        return None
    if de > offset:
        part = (offset - ds) / (de - ds)
        end = start + part * (end - start)
    return start, end
""",
    ),
    Wrong(
        "7.1",
        "steps through the time in a hundred samples and returns the first sample that overlaps",
        ("sampled",),
        """
def sweep_circles(p1, v1, r1, p2, v2, r2, dt):
    d, v = p2 - p1, v2 - v1
    if d @ v >= 0:
        return None
    end = dt if dt != math.inf else 100.0
    for t in np.linspace(0, end, 101):
        if np.linalg.norm(d + v * t) <= r1 + r2:
            return float(t)
    return None
""",
    ),
    Wrong(
        "7.2",
        "thinks that without gravity nothing ever lands, also a ball that moves down",
        ("no_gravity_no_landing",),
        """
def time_to_floor(height, velocity, gravity):
    if gravity == 0:
        return None
    s = math.sqrt(velocity * velocity + 2 * gravity * height)
    if velocity > 0:
        return (velocity + s) / gravity
    return 2 * height / (s - velocity)
""",
    ),
    Wrong(
        "7.5",
        "counts a collision with the wall after every collision of the blocks",
        ("the_wall_after_every_strike",),
        """
def pi_collisions(mass_ratio):
    inner = 0.0
    outer = -1.0
    collisions = 0
    while outer < inner:
        V = (inner + mass_ratio * outer) / (mass_ratio + 1)
        inner = 2 * V - inner
        outer = 2 * V - outer
        collisions += 1
        inner = abs(inner)
        collisions += 1
    return collisions
""",
    ),
    Wrong(
        "8.1",
        "takes the norm along the wrong axis: one length for all x and one for all y",
        ("axis",),
        """
def largest_error(places, right):
    return np.max(np.linalg.norm(places - right, axis=0))
""",
    ),
    Wrong(
        "8.4",
        "returns None as soon as one of the rows with these sweeps has failed",
        ("one_failure_is_enough",),
        """
def best_split(table, sweeps):
    rows = [row for row in table if row[0] * row[1] == sweeps]
    if len(rows) == 0 or any(math.isinf(row[2]) for row in rows):
        return None
    rows.sort(key=lambda row: row[2])
    return tuple(rows[0][:2])
""",
    ),
    Wrong(
        "9.3",
        "takes the absolute value of the divisor so that a jamming tip gets a positive impulse",
        ("a_jam_pushes_back",),
        """
def sliding_impulse(vn, vt, knn, knt, friction):
    if vn >= 0:
        return 0.0
    k = abs(knn - math.copysign(friction, vt) * knt)
    return -vn / k if k else None
""",
    ),
    Wrong(
        "9.5",
        "lets all approaching pairs strike at the same time in each round, from the old velocities",
        ("all_that_approach_at_once",),
        """
def one_by_one(masses, velocities):
    v = np.array(velocities, dtype=float)
    m = np.array(masses, dtype=float)
    for _ in range(2000):
        u = v[:-1] - v[1:]
        hit = u > 1e-9
        if not hit.any():
            break
        j = np.where(hit, 2 * u * m[:-1] * m[1:] / (m[:-1] + m[1:]), 0)
        v[:-1] -= j / m[:-1]
        v[1:] += j / m[1:]
    return v
""",
    ),
    Wrong(
        "10.2",
        "forgets that what spins at the start calls for rotation",
        ("spin_forgotten",),
        """
def effects_called_for(bodies, gravity):
    effects = []
    fr = re = False
    for i in range(len(bodies)):
        for j in range(i):
            a, b = bodies[i], bodies[j]
            if a[0] + b[0] > 0:
                fr = fr or a[3] * b[3] > 0
                re = re or min(a[2], b[2]) > 0
    if fr:
        effects.append("friction")
    if re:
        effects.append("restitution")
    if np.any(gravity):
        effects.append("gravity")
    if fr or any(row[0] > 0 and row[1] > 0 for row in bodies):
        effects.append("rotation")
    return effects
""",
    ),
    Wrong(
        "10.2",
        "leaves restitution and friction out of pairs with a static body (and instead of or)",
        ("floors_meet_nobody",),
        """
def effects_called_for(bodies, gravity):
    names = set()
    if np.linalg.norm(gravity) != 0:
        names.add("gravity")
    for a, b in combinations(bodies, 2):
        if a[0] > 0 and b[0] > 0:
            if min(a[2], b[2]) > 0:
                names.add("restitution")
            if a[3] * b[3] > 0:
                names.add("friction")
                names.add("rotation")
    if any(b[4] != 0 for b in bodies):
        names.add("rotation")
    if any(b[0] != 0 and b[1] != 0 for b in bodies):
        names.add("rotation")
    return list(names)
""",
    ),
    Wrong(
        "10.4",
        "returns left, low, right, high",
        ("order",),
        """
def box_of_flight(position, velocity, radius, gravity, duration):
    lo, hi = [], []
    for i in range(2):
        t = [0, duration]
        if gravity[i]:
            s = -velocity[i] / gravity[i]
            if 0 <= s <= duration:
                t.append(s)
        x = [position[i] + velocity[i] * u + gravity[i] * u * u / 2 for u in t]
        lo.append(min(x) - radius)
        hi.append(max(x) + radius)
    return lo[0], lo[1], hi[0], hi[1]
""",
    ),
    Wrong(
        "11.2",
        "takes the sliding from before the normal impulse",
        ("sliding_before_the_blow",),
        """
def hit(a, arm_a, b, arm_b, normal, restitution, friction):
    ma, ia, wa = a[0], a[1], a[4]
    mb, ib, wb = b[0], b[1], b[4]
    va, vb = a[2:4], b[2:4]
    t = np.array([-normal[1], normal[0]])
    rel = vb + wb * np.array([-arm_b[1], arm_b[0]]) - va - wa * np.array([-arm_a[1], arm_a[0]])
    vn, vt = rel @ normal, rel @ t
    if vn >= 0:
        return va, wa, vb, wb
    kn = 1 / ma + 1 / mb + cross(arm_a, normal) ** 2 / ia + cross(arm_b, normal) ** 2 / ib
    kt = 1 / ma + 1 / mb + cross(arm_a, t) ** 2 / ia + cross(arm_b, t) ** 2 / ib
    jn = -(1 + restitution) * vn / kn
    jt = max(-friction * jn, min(friction * jn, -vt / kt))
    J = jn * normal + jt * t
    return va - J / ma, wa - cross(arm_a, J) / ia, vb + J / mb, wb + cross(arm_b, J) / ib
""",
    ),
    Wrong(
        "11.3",
        "moves discs apart only if they approach",
        ("apart_only_if_they_approach",),
        """
def step_discs(positions, velocities, masses, radii, restitution, gravity, room, dt):
    p = positions + velocities * dt
    v = velocities + gravity * dt
    for i, j in combinations(range(len(masses)), 2):
        n = p[j] - p[i]
        dist = np.linalg.norm(n)
        n = n / dist
        depth = radii[i] + radii[j] - dist
        vn = (v[j] - v[i]) @ n
        if depth > 0 and vn < 0:
            k = 1 / masses[i] + 1 / masses[j]
            jn = -(1 + restitution) * vn / k
            v[i] = v[i] - jn / masses[i] * n
            v[j] = v[j] + jn / masses[j] * n
            p[i] = p[i] - depth / k / masses[i] * n
            p[j] = p[j] + depth / k / masses[j] * n
    for i in range(len(masses)):
        for k in (0, 1):
            lo, hi = radii[i], room[k] - radii[i]
            if p[i, k] < lo:
                p[i, k] = lo
                if v[i, k] < 0:
                    v[i, k] = -v[i, k] * restitution
            if p[i, k] > hi:
                p[i, k] = hi
                if v[i, k] > 0:
                    v[i, k] = -v[i, k] * restitution
    return p, v
""",
    ),
    Wrong(
        "11.4",
        "uses `in` on a NumPy array, which is true if any single number fits",
        ("any_number_of_a_row",),
        """
def touch_changes(before, now):
    begun = [tuple(p) for p in now if len(before) == 0 or p not in before]
    parted = [tuple(p) for p in before if len(now) == 0 or p not in now]
    return begun, parted
""",
    ),
    Wrong(
        "11.6",
        "spreads the samples over one whole second with linspace, whatever count and rate are",
        ("lasts_one_second",),
        """
def knock(loudness, frequency, half_life, rate, count):
    if frequency >= rate / 2:
        return np.zeros(int(count))
    t = np.linspace(0, 1, int(count))
    return loudness * np.sin(2 * np.pi * frequency * t) * 0.5 ** (t / half_life)
""",
    ),
    Wrong(
        "B.1",
        "returns the walls in the order left, right, top, bottom",
        ("order",),
        """
def wall_contacts(position):
    result = []
    size = (WIDTH, HEIGHT)
    names = (("left", "right"), ("top", "bottom"))
    for axis in (0, 1):
        low = RADIUS - position[axis]
        high = position[axis] - (size[axis] - RADIUS)
        if low > 0:
            result.append((names[axis][0], NORMALS[names[axis][0]], low))
        if high > 0:
            result.append((names[axis][1], NORMALS[names[axis][1]], high))
    return result
""",
    ),
    Wrong(
        "B.4",
        "asks whether the ball moves into the wall after it has been resolved",
        ("asks_afterwards",),
        """
def wall_contacts(position):
    x, y = position
    d = {"top": RADIUS - y, "bottom": y + RADIUS - HEIGHT}
    d |= {"left": RADIUS - x, "right": x + RADIUS - WIDTH}
    return [(k, NORMALS[k], d[k]) for k in d if d[k] > 0]


def bumper_contact(position):
    way = BUMPER_END - BUMPER_START
    t = min(max((position - BUMPER_START) @ way / (way @ way), 0.0), 1.0)
    d = position - BUMPER_START - t * way
    dist = np.hypot(*d)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    return (d / dist, depth) if depth > 0 else None


def resolve(position, velocity, normal, depth):
    vn = velocity @ normal
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position + depth * normal, velocity.copy()



def step(position, velocity, dt=TIME_STEP):
    p = position + dt * velocity
    v = velocity
    hits = []
    c = bumper_contact(p)
    if c:
        p, v = resolve(p, v, c[0], c[1])
        if v @ c[0] < 0:
            hits.append("bumper")
    for name, n, d in wall_contacts(p):
        p, v = resolve(p, v, n, d)
        if v @ n < 0:
            hits.append(name)
    return p, v, hits
""",
    ),
    Wrong(
        "B.4",
        "ignores the argument dt and always moves by TIME_STEP",
        ("default",),
        """
def wall_contacts(position):
    x, y = position
    d = {"top": RADIUS - y, "bottom": y + RADIUS - HEIGHT}
    d |= {"left": RADIUS - x, "right": x + RADIUS - WIDTH}
    return [(k, NORMALS[k], d[k]) for k in d if d[k] > 0]


def bumper_contact(position):
    way = BUMPER_END - BUMPER_START
    t = min(max((position - BUMPER_START) @ way / (way @ way), 0.0), 1.0)
    d = position - BUMPER_START - t * way
    dist = np.hypot(*d)
    depth = RADIUS + BUMPER_HALF_THICKNESS - dist
    return (d / dist, depth) if depth > 0 else None


def resolve(position, velocity, normal, depth):
    vn = velocity @ normal
    if vn < 0:
        velocity = velocity - (1 + RESTITUTION) * vn * normal
    return position + depth * normal, velocity.copy()



def step(position, velocity, dt=TIME_STEP):
    position = position + velocity * TIME_STEP
    hits = []
    contacts = []
    b = bumper_contact(position)
    if b:
        moving_in = bool(velocity @ b[0] < 0)
        position, velocity = resolve(position, velocity, *b)
        hits += ["bumper"] * moving_in
    for name, normal, depth in wall_contacts(position):
        moving_in = bool(velocity @ normal < 0)
        position, velocity = resolve(position, velocity, normal, depth)
        hits += [name] * moving_in
    return position, velocity, hits
""",
    ),
    Wrong(
        "P.3",
        "does not halve: takes (1 + e) u as the change of velocity of each of two equal balls",
        ("the_whole_change_for_each",),
        """
def share_impact(positions, velocities, radius, restitution):
    v = velocities + 0.0
    for _ in range(ROUNDS):
        jobs = []
        c = {}
        for i in range(len(v)):
            for j in range(i + 1, len(v)):
                d = positions[j] - positions[i]
                L = d.dot(d) ** 0.5
                u = (v[i] - v[j]).dot(d) / L
                if L <= TOUCHING * radius and u > 0:
                    jobs.append((i, j, d / L, u))
                    c[i] = c.get(i, 0) + 1
                    c[j] = c.get(j, 0) + 1
        for i, j, n, u in jobs:
            share = max(c[i], c[j])
            v[i] = v[i] - (1 + restitution) * u / share * n
            v[j] = v[j] + (1 + restitution) * u / share * n
    return v
""",
    ),
    Wrong(
        "P.3",
        "compares the distance with TOUCHING itself and forgets that it counts in radii",
        ("as_one",),
        """
def share_impact(positions, velocities, radius, restitution):
    v = velocities.copy()
    for _ in range(ROUNDS):
        hits = []
        for i in range(len(v)):
            for j in range(i + 1, len(v)):
                way = positions[j] - positions[i]
                size = np.hypot(*way)
                if size <= TOUCHING:
                    speed = (v[i] - v[j]) @ way / size
                    if speed > 0:
                        hits.append((i, j, way / size, speed))
        load = np.zeros(len(v))
        for i, j, _n, _s in hits:
            load[[i, j]] += 1
        delta = np.zeros(v.shape)
        for i, j, n, s in hits:
            J = (1 + restitution) * s / 2 / max(load[i], load[j]) * n
            delta[i] -= J
            delta[j] += J
        v = v + delta
    return v
""",
    ),
    Wrong(
        "K.2",
        "samples the flight at small steps instead of computing the time",
        ("sampled",),
        """
def brick_impact(position, velocity, radius, box):
    steps = 2000
    for k in range(steps + 1):
        t = HORIZON * k / steps
        c = position + velocity * t
        q = np.clip(c, box[:2], box[:2] + box[2:])
        d = c - q
        dist = np.hypot(*d)
        if 0 < dist <= radius:
            return t, d / dist
    return None
""",
    ),
    Wrong(
        "K.3",
        "goes on with the whole duration after a hit instead of with the time that is left",
        (
            "step",
            "term",
        ),
        """
def face_hits(p, v, r, box):
    low = np.array([box[0], box[1]])
    high = low + box[2:]
    out = []
    for k in (0, 1):
        o = 1 - k
        for edge, s in ((low[k] - r, -1.0), (high[k] + r, 1.0)):
            if v[k] * s < 0:
                t = (edge - p[k]) / v[k]
                across = p[o] + v[o] * t
                if t >= 0 and low[o] <= across <= high[o]:
                    n = np.zeros(2)
                    n[k] = s
                    out.append((t, n))
    return out


def corner_hits(p, v, r, box):
    out = []
    for x in (box[0], box[0] + box[2]):
        for y in (box[1], box[1] + box[3]):
            d = p - np.array([x, y])
            a, b, c = v @ v, d @ v, d @ d - r * r
            if b < 0 and b * b >= a * c:
                t = (-b - math.sqrt(b * b - a * c)) / a
                if t >= 0:
                    out.append((t, (d + v * t) / r))
    return out



def brick_impact(position, velocity, radius, box):
    hits = face_hits(position, velocity, radius, box) + corner_hits(position, velocity, radius, box)
    hits = [h for h in hits if h[0] <= HORIZON]
    return min(hits, key=lambda h: h[0]) if hits else None



def fly(position, velocity, radius, bricks, duration):
    p, v = position.copy(), velocity.copy()
    alive = list(range(len(bricks)))
    broken = []
    while True:
        found = []
        for k in alive:
            hit = brick_impact(p, v, radius, bricks[k])
            if hit is not None and hit[0] <= duration:
                found.append((hit[0], k, hit[1]))
        if not found:
            break
        t, k, n = min(found, key=lambda f: f[0])
        p = p + v * t
        v = v - 2 * (v @ n) * n
        alive.remove(k)
        broken.append(k)
    return p + v * duration, v, broken
""",
    ),
    Wrong(
        "C.3",
        "asks for the larger angle only (> for >=), so that balls that hang at rest do not touch",
        ("strict",),
        """
def cradle(angles, rates, length, dt, steps):
    a = np.array(angles, float)
    r = np.array(rates, float)
    for _ in range(int(steps)):
        r += -GRAVITY / length * np.sin(a) * dt
        a += r * dt
        again = True
        while again:
            again = False
            for i in range(len(a) - 1):
                if a[i] > a[i + 1] and r[i] > r[i + 1]:
                    r[i], r[i + 1] = r[i + 1], r[i]
                    again = True
                    break
    return a, r
""",
    ),
)
