// What the collision lab begins with: a plain object, which a link or a file can hold. Its form is that
// of scene files (lesson_code/scene_file.py), where FORM comes from.

const DT = 1 / 60; // s, of a step
const SLOW = 0.25; // of the true speed
const MOST_STEPS = 4; // in a frame; a machine that is slower shows it slower
const { ranges: RANGES, shapes: SHAPE_NAMES, rooms: ROOMS, gravity: GRAVITY, most_bodies: MOST_BODIES } = FORM;
const ARROW = 0.4; // m for 1 m/s, or 1 kg m/s
const GRIP = 14; // pixels around a tip that can be taken hold of
const MOST_WITH_NUMBERS = 8;
const MOST_WITH_ARROWS = 50;
const MOST_PATH = 1200; // steps that a path goes back
const STEPS_A_SAVE = 30; // on the way back, fewer steps than this are made again
const MOST_SAVED = 64e6; // bytes
const REST = 400; // ms without a change, after which a screen reader is told
const FREE_KEYS = { "data-lm-suppress-shortcuts": "true" }; // makes JupyterLab leave the keys to us
const LAB_COLORS = ["blue", "orange", "green", "vermilion", "purple", "sky"];

const FIELDS = {
  mass: { ...RANGES.mass, label: "mass, kg", step: 0.1, isFixed: true },
  size: { ...RANGES.size, label: "size, m", step: 0.05, isFixed: true },
  corners: { ...RANGES.corners, label: "corners", step: 1, isFixed: true, isPolygon: true },
  x: { ...RANGES.x, label: "x, m", step: 0.1 },
  y: { ...RANGES.y, label: "y, m", step: 0.1, isPlane: true },
  vx: { ...RANGES.vx, label: "velocity x, m/s", step: 0.1 },
  vy: { ...RANGES.vy, label: "velocity y, m/s", step: 0.1, isPlane: true },
  angle: { ...RANGES.angle, label: "angle, rad", step: 0.1, isPlane: true },
  w: { ...RANGES.w, label: "spin, rad/s", step: 0.1, isPlane: true },
};
const SETTINGS = {
  elasticity: { ...RANGES.elasticity, label: "Elasticity, %", step: 5 },
  friction: { ...RANGES.friction, label: "Friction", step: 0.05, isPlane: true },
};
const SWITCHES = {
  gravity: { label: "Gravity", isPlane: true },
  walls: { label: "Walls" },
};
const SHOWN = { velocities: "Velocities", momenta: "Momenta", centre: "Centre of mass", paths: "Paths" };

const body = (x, y, vx, vy, more = {}) => ({ shape: "disc", mass: 1, size: 0.4, corners: 5, x, y, vx, vy, angle: 0, w: 0, ...more });
const track = (elasticity, bodies) => ({ dimensions: 1, elasticity, friction: 0, gravity: false, walls: true, bodies });
const plane = (elasticity, friction, gravity, bodies) => ({ dimensions: 2, elasticity, friction, gravity, walls: true, bodies });

const PRESETS = {
  "Oblique hit": () => plane(100, 0, false, [body(-2.5, -0.3, 3, 0), body(0.5, 0, 0, 0, { mass: 2, size: 0.5 })]),
  "Head on, equal masses": () => track(100, [body(-2, 0, 2, 0), body(2, 0, -1, 0)]),
  "Heavy on light": () => track(100, [body(-2.5, 0, 2, 0, { mass: 5, size: 0.5 }), body(0, 0, 0, 0, { size: 0.3 })]),
  "They stay together": () => track(0, [body(-2, 0, 2, 0, { shape: "box" }), body(1, 0, 0, 0, { shape: "box", mass: 2 })]),
  "Row of five": () => track(100, [body(-3.2, 0, 2, 0, { size: 0.3 }), ...[0, 1, 2, 3].map((k) => body(-0.5 + 0.61 * k, 0, 0, 0, { size: 0.3 }))]),
  "Friction makes spin": () => plane(60, 0.5, false, [body(-2.5, -0.4, 3, 0), body(0.5, 0, 0, 0, { size: 0.5 })]),
  "Polygons and discs that fall": () =>
    plane(30, 0.5, true, [0, 1, 2, 3, 4, 5].map((k) =>
      body(1.1 * (k % 3) - 1 + 0.2 * (k > 2), k > 2 ? 1.6 : 0, 0, 0, { shape: ["box", "disc", "polygon"][k % 3], corners: Math.max(3, 2 * k - 1), size: 0.3, angle: 0.3 * k }))),
  "Ball that bounces": () => plane(80, 0, true, [body(0, 1.8, 0, 0, { size: 0.2 })]),
  "Ball between mirrors": () => plane(100, 0, false, [body(-3, -1, 3, 2, { size: 0.15 })]),
  "Fast ball, thin plate": () =>
    plane(50, 0, false, [body(-3.5, 0, 50, 0, { size: 0.05 }), body(0, 0, 0, 0, { shape: "polygon", corners: 3, size: 0.1, mass: 5 })]),
  "Heavy on a light box": () =>
    plane(0, 0.6, true, [body(0, -2.2, 0, 0, { shape: "box", size: 0.3 }), body(0, -1.4, 0, 0, { shape: "box", size: 0.5, mass: 50 })]),
  "Rack of fifteen": () => plane(95, 0, false, [body(-3, 0.02, 8, 0, { size: 0.15 }), ...rack()]),
  "Gas of 500": () => plane(100, 0, false, gas(500)),
};

/** The presets by the chapter that is about them. */
const CHAPTERS = {
  "01 One dimension": ["Head on, equal masses", "Heavy on light", "They stay together"],
  "02 Restitution": ["Ball that bounces"],
  "03 Reflection": ["Ball between mirrors"],
  "04 Circles": ["Oblique hit", "Row of five"],
  "05 Spin and friction": ["Friction makes spin"],
  "06 SAT and manifolds": ["Polygons and discs that fall"],
  "07 Time of impact": ["Fast ball, thin plate"],
  "08 What accuracy costs": ["Rack of fifteen"],
  "09 Hard cases": ["Heavy on a light box"],
  "10 Only what the scene needs": ["Gas of 500"],
};

function rack() {
  const places = [0, 1, 2, 3, 4].flatMap((row) => Array.from({ length: row + 1 }, (_, k) => [row, k - row / 2]));
  return places.map(([row, side]) => body(0.5 + 0.262 * row, 0.302 * side, 0, 0, { size: 0.15 }));
}

function gas(count) {
  const columns = 28;
  return Array.from({ length: count }, (_, k) => {
    const turn = 2.399963 * k; // the golden angle: all directions alike
    return body(-3.8 + 0.28 * (k % columns), -2.3 + 0.26 * Math.floor(k / columns), 2 * Math.cos(turn), 2 * Math.sin(turn), { size: 0.06 });
  });
}

const said = (value) => (value === undefined || value === null ? "nothing" : JSON.stringify(value));

/** Return a set-up with every field checked, or say what is wrong: as scene_file.py does, in its words. */
function understood(given) {
  requireFields("a scene", given, ["dimensions", ...Object.keys(SETTINGS), "gravity", "walls", "room", "bodies"]);
  const { dimensions = 2, gravity = false, walls = false, room, bodies } = given;
  if (!ROOMS[dimensions] || typeof dimensions !== "number") throw new RangeError(`dimensions must be 1 or 2, got ${said(dimensions)}`);
  const settings = Object.entries(SETTINGS).map(([name, range]) => [name, numberIn(name, given[name], range)]);
  const fall = typeof gravity === "boolean" ? gravity : numberIn("gravity", gravity, RANGES.gravity);
  if (typeof walls !== "boolean") throw new RangeError(`walls must be true or false, got ${said(walls)}`);
  if (!Array.isArray(bodies) || bodies.length > MOST_BODIES)
    throw new RangeError(`bodies must be a list of at most ${MOST_BODIES}, got ${Array.isArray(bodies) ? bodies.length : said(bodies)}`);
  if (room !== undefined && !(Array.isArray(room) && room.length === 2))
    throw new RangeError(`room must be [width, height], got ${said(room)}`);
  return {
    dimensions,
    ...Object.fromEntries(settings),
    gravity: fall,
    walls,
    ...(room && { room: room.map((side, k) => numberIn(`room[${k}]`, side, RANGES.side)) }),
    bodies: bodies.map((one, k) => understoodBody(`bodies[${k}]`, one)),
  };
}

function understoodBody(name, one) {
  requireFields(name, one, ["shape", ...Object.keys(FIELDS), ...Object.keys(SETTINGS)]);
  const shape = one.shape === undefined ? "disc" : one.shape;
  if (!SHAPE_NAMES.includes(shape)) throw new RangeError(`${name}.shape must be one of ${SHAPE_NAMES.join(", ")}, got ${said(shape)}`);
  const checkedOf = (ranges, keys) => Object.fromEntries(keys.map((key) => [key, numberIn(`${name}.${key}`, one[key], ranges[key])]));
  const own = Object.keys(SETTINGS).filter((key) => key in one);
  return { shape, ...checkedOf(FIELDS, Object.keys(FIELDS)), ...checkedOf(SETTINGS, own) };
}

function requireFields(name, given, known) {
  if (given === null || typeof given !== "object" || Array.isArray(given))
    throw new RangeError(`${name} must be an object with fields, got ${said(given)}`);
  for (const key in given)
    if (!known.includes(key)) throw new RangeError(`${name} must have no field but ${known.join(", ")}, got ${key}`);
}

/** Return a number that a range allows, or what stands for one that is left out. */
function numberIn(name, value, range) {
  const taken = value ?? range.usual;
  if (fits(taken, range)) return taken;
  throw new RangeError(`${name} must ${range.is_whole ? "be a whole number" : "lie"} between ${range.low} and ${range.high}, got ${said(value)}`);
}

/** Return whether a value is a number that a range allows; corners are whole. */
const fits = (value, { low, high, is_whole }) =>
  typeof value === "number" && value >= low && value <= high && (!is_whole || Number.isInteger(value));

/** Return half of the width and of the height of a set-up's room, m. */
const halfRoom = ({ dimensions, room }) => (room ?? ROOMS[dimensions]).map((side) => side / 2);

/** Return the gravity of a set-up, m/s^2; true stands for that of the earth. */
const fallIn = ({ dimensions, gravity }) => (dimensions === 1 ? 0 : gravity === true ? GRAVITY : Number(gravity));

/** Return the restitution and the friction of a body, or with no body those of the walls. */
function surfaceOf({ dimensions, elasticity, friction }, one = {}) {
  return { restitution: (one.elasticity ?? elasticity) / 100, friction: dimensions === 1 ? 0 : one.friction ?? friction };
}

/** Return the corners of a body. The size of a box is half its width; that of a regular polygon is
 *  the distance from its centre to a corner. */
function outline({ shape, size, corners }) {
  if (shape === "box") return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [a * size, b * size]);
  const turn = (2 * Math.PI) / corners;
  return Array.from({ length: corners }, (_, k) => [size * Math.cos(k * turn), size * Math.sin(k * turn)]);
}

/** Return a set-up as the description of a scene; the walls come last. */
function sceneOf(setup) {
  const { walls, bodies } = setup;
  const isTrack = setup.dimensions === 1;
  const [w, h] = halfRoom(setup);
  const corners = [[-w, -h], [w, -h], [w, h], [-w, h]];
  const sides = corners.map((corner, k) => ({ segment: [corner, corners[(k + 1) % 4]], ...surfaceOf(setup) }));
  return {
    gravity: [0, -fallIn(setup)],
    dt: DT,
    bodies: [
      ...bodies.map(({ shape, mass, size, corners, x, y, vx, vy, angle, w: spin, ...own }) => ({
        ...(shape === "disc" ? { circle: size } : { polygon: outline({ shape, size, corners }) }),
        ...(isTrack
          ? { position: [x, 0], velocity: [vx, 0], inertia: Infinity }
          : { position: [x, y], velocity: [vx, vy], angle, angular_velocity: spin }),
        ...surfaceOf(setup, own),
        mass,
      })),
      ...(walls ? (isTrack ? [sides[1], sides[3]] : sides) : []),
    ],
  };
}

const decimal = (value, digits = 2) => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1").replace("-", "\u2212");
const tuple = (x, y, isTrack) => (isTrack ? decimal(x) : `(${decimal(x)}, ${decimal(y)})`);
const rounded = (value, step) => Number((Math.round(value / step) * step).toFixed(9));
const limited = (value, { low, high }) => Math.min(Math.max(value, low), high);
