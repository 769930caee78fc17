// A world in a page, from a plain description of a scene. What it does is the program's.
//
//   const world = scene(await load("sequential.wasm"), {
//     gravity: [0, -9.81],
//     bodies: [
//       { circle: 0.5, position: [0, 2], mass: 1, restitution: 0.8 },
//       { polygon: [[-1, -1], [1, -1], [1, 1], [-1, 1]], position: [3, 1], mass: 2, friction: 0.5 },
//       { segment: [[-10, 0], [10, 0]] }, // no mass: nothing can push it
//     ],
//   });
//   world.step();
//   world.bodies[0].y; // and x, angle, vx, vy, w, in the units and with the signs of Python
//   world.impulses; // of this step: a, b, x, y, nx, ny, normal_impulse, tangent_impulse, ...
//
// A polygon is seen from its centroid, which stands at its position; a segment may have a radius.
// A scene may have damping; dt, iterations, substeps; and combine: { restitution, friction }, the
// rules by which a pair's coefficients come from those of its bodies.

const finite = (value) => typeof value === "number" && Number.isFinite(value);
const pair = (value) => Array.isArray(value) && value.length === 2 && value.every(finite);
const RULES = {
  finite: [finite, "must be a finite number"],
  pair: [pair, "must be [x, y]"],
  positive: [(value) => finite(value) && value > 0, "must be > 0"],
  weight: [(value) => value > 0, "must be > 0"], // Infinity: nothing can push or turn it
  natural: [(value) => finite(value) && value >= 0, "must be >= 0"],
  share: [(value) => finite(value) && value >= 0 && value <= 1, "must lie between 0 and 1"],
  count: [(value) => Number.isInteger(value) && value > 0, "must be a whole number > 0"],
  corners: [
    (value) => Array.isArray(value) && value.length > 2 && value.every(pair),
    "must be a list of at least three corners [x, y]",
  ],
  ends: [
    (value) =>
      Array.isArray(value) && value.length === 2 && value.every(pair) && String(value[0]) !== String(value[1]),
    "must be two ends [x, y] that differ",
  ],
};
const SHAPES = { circle: "positive", polygon: "corners", segment: "ends" };

/** Return a value that keeps a rule, or what stands for it if it is left out. */
function checked(name, value, rule, otherwise) {
  if (value === undefined || value === null) {
    if (otherwise !== undefined) return otherwise;
  } else if (RULES[rule][0](value)) return value;
  throw new RangeError(`${name} ${RULES[rule][1]}, got ${JSON.stringify(value)}`);
}

/** Return a world that a program steps. The program can have one at a time. */
export function scene(program, description) {
  return new World(program, description);
}

export class World {
  constructor(program, description) {
    this.program = program;
    for (const table of program.tables) table.resize(0);
    for (const table of program.tables) if (table.isSingle) table.resize(1);
    this.settle(description);
    this.write(description.bodies ?? []);
    const fault = program.run("set_up");
    if (fault) throw new RangeError(`bodies[${this.state.lost_body}]: ${program.about.scene.faults[fault]}`);
    program.slots.resize(this.state.slot_count + 1);
    program.fixed_slots.resize(this.state.slot_count);
    program.colours.resize(program.about.scene.colours);
    this.impulses = [];
  }

  get state() {
    return this.program.state;
  }

  /** The time that has passed, s. */
  get time() {
    return this.state.steps_done * this.state.whole;
  }

  /** Return the sums over all bodies with a mass: centre of mass and its velocity, momentum,
   *  kinetic energy with spin, and the energy of height. */
  totals() {
    const { gravity_x, gravity_y } = this.state;
    const sums = { mass: 0, x: 0, y: 0, px: 0, py: 0, energy: 0, potential: 0 };
    for (const { inv_m, inv_i, mass, x, y, vx, vy, w } of this.bodies) {
      if (inv_m === 0) continue;
      sums.mass += mass;
      sums.x += mass * x;
      sums.y += mass * y;
      sums.px += mass * vx;
      sums.py += mass * vy;
      sums.energy += (mass * (vx * vx + vy * vy) + (inv_i > 0 ? (w * w) / inv_i : 0)) / 2;
      sums.potential -= mass * (gravity_x * x + gravity_y * y);
    }
    const whole = sums.mass || 1;
    return { ...sums, x: sums.x / whole, y: sums.y / whole, vx: sums.px / whole, vy: sums.py / whole };
  }

  /** Make steps, and keep the impulses of the last one. */
  step(steps = 1) {
    if (steps > 1) this.program.advance(steps - 1);
    this.impulses = [];
    this.program.advance(1, (record, count) => {
      for (let k = 0; k < count; k++) this.impulses.push(copyOf(record.at(k)));
    });
  }

  /** Return the whole world as it is now, for `restore`. */
  save() {
    const memory = this.program.exports.memory.buffer;
    const tables = this.program.tables.map(({ address, length, bytes }) => memory.slice(address, address + length * bytes));
    return { tables, impulses: this.impulses };
  }

  /** Go back to what `save` has returned. */
  restore({ tables, impulses }) {
    this.program.tables.forEach((table, k) => {
      table.resize(tables[k].byteLength / table.bytes);
      new Uint8Array(this.program.exports.memory.buffer).set(new Uint8Array(tables[k]), table.address);
    });
    this.impulses = impulses;
  }

  /** Write down what acts on all bodies, and how steps are made. */
  settle(description) {
    const { usual, mixing } = this.program.about.scene;
    const [gravity_x, gravity_y] = checked("gravity", description.gravity, "pair", [0, 0]);
    const dt = checked("dt", description.dt, "positive", usual.dt);
    const damping = checked("damping", description.damping, "natural", 0);
    const [iterations, substeps] = ["iterations", "substeps"].map((name) =>
      checked(name, description[name], "count", usual[name]),
    );
    Object.assign(this.state, { gravity_x, gravity_y, damping, dt, whole: dt, iterations, substeps, skin: usual.skin });
    for (const name of ["restitution", "friction"]) {
      const rule = description.combine?.[name] ?? usual[name];
      if (!(rule in mixing))
        throw new RangeError(`combine.${name} must be one of ${Object.keys(mixing).join(", ")}, got ${rule}`);
      this.state[`${name}_rule`] = mixing[rule];
    }
  }

  /** Write down the bodies. */
  write(bodies) {
    const { program } = this;
    for (const name of ["bodies", "places", "order", "boxes"]) program[name].resize(bodies.length);
    this.bodies = bodies.map((body, k) => {
      const name = (field) => `bodies[${k}].${field}`;
      const taken = (field, rule, otherwise) => checked(name(field), body[field], rule, otherwise);
      const outline = outlineOf(body, name);
      const [x, y] = taken("position", "pair", [0, 0]);
      const [vx, vy] = taken("velocity", "pair", [0, 0]);
      const first = program.corners.length;
      program.corners.resize(first + outline.length);
      outline.forEach(([local_x, local_y], n) => Object.assign(program.corners.at(first + n), { local_x, local_y }));
      return Object.assign(program.bodies.at(k), {
        x, y, vx, vy,
        angle: taken("angle", "finite", 0),
        w: taken("angular_velocity", "finite", 0),
        radius: body.circle ?? (body.segment ? taken("radius", "natural", 0) : 0),
        corner_count: outline.length,
        mass: taken("mass", "weight", Infinity),
        inertia: taken("inertia", "weight", 0),
        restitution: taken("restitution", "share", -1),
        friction: taken("friction", "natural", -1),
      });
    });
  }
}

/** Return the outline of a body's shape: back along a segment first, as in Python. */
function outlineOf(body, name) {
  const shapes = Object.keys(SHAPES).filter((shape) => shape in body);
  if (shapes.length !== 1)
    throw new TypeError(`${name("shape")} must be one of ${Object.keys(SHAPES).join(", ")}, got ${shapes.join(" and ") || "none"}`);
  const [shape] = shapes;
  const points = checked(name(shape), body[shape], SHAPES[shape]);
  return { circle: [], polygon: points, segment: [points[1], points[0]] }[shape];
}

function copyOf(row) {
  const copy = {};
  for (const field in row) copy[field] = row[field];
  return copy;
}
