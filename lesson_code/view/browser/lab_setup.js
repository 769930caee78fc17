// What the collision lab begins with: a plain object, which a link can hold.
//
//   { dimensions: 2, elasticity: 80, friction: 0.2, gravity: false, walls: true,
//     bodies: [{ shape: "disc", mass: 1, size: 0.4, x: -2, y: 0, vx: 2, vy: 0, angle: 0, w: 0 }] }

const DT = 1 / 60; // s, of a step
const SLOW = 0.25; // of the true speed
const MOST_STEPS = 4; // in a frame; a machine that is slower shows it slower
const GRAVITY = 9.81; // m/s^2
const WIDTH = 4; // m, from the middle to each side
const HEIGHTS = { 1: 1, 2: 2.5 };
const ARROW = 0.4; // m for 1 m/s, or 1 kg m/s
const GRIP = 14; // pixels around a tip that can be taken hold of
const MOST_WITH_NUMBERS = 8;
const MOST_WITH_ARROWS = 50;
const MOST_PATH = 1200; // steps that a path goes back
const MOST_BODIES = 1000;
const STEPS_A_SAVE = 30; // on the way back, fewer steps than this are made again
const MOST_SAVED = 64e6; // bytes
const REST = 400; // ms without a change, after which a screen reader is told
const FREE_KEYS = { "data-lm-suppress-shortcuts": "true" }; // makes JupyterLab leave the keys to us
const LAB_COLORS = ["blue", "orange", "green", "vermilion", "purple", "sky"];

const FIELDS = {
  mass: { label: "mass, kg", low: 0.1, high: 100, step: 0.1, isFixed: true },
  size: { label: "size, m", low: 0.02, high: 1, step: 0.05, isFixed: true },
  corners: { label: "corners", low: 3, high: 20, step: 1, start: 5, isFixed: true, isPolygon: true },
  x: { label: "x, m", low: -100, high: 100, step: 0.1 },
  y: { label: "y, m", low: -100, high: 100, step: 0.1, isPlane: true },
  vx: { label: "velocity x, m/s", low: -50, high: 50, step: 0.1 },
  vy: { label: "velocity y, m/s", low: -50, high: 50, step: 0.1, isPlane: true },
  angle: { label: "angle, rad", low: -1e9, high: 1e9, step: 0.1, isPlane: true },
  w: { label: "spin, rad/s", low: -1e9, high: 1e9, step: 0.1, isPlane: true },
};
const SETTINGS = {
  elasticity: { label: "Elasticity, %", low: 0, high: 100, step: 5, start: 100 },
  friction: { label: "Friction", low: 0, high: 1, step: 0.05, start: 0, isPlane: true },
};
const SWITCHES = {
  gravity: { label: "Gravity", isPlane: true },
  walls: { label: "Walls" },
};
const SHOWN = { velocities: "Velocities", momenta: "Momenta", centre: "Centre of mass", paths: "Paths" };
const SHAPE_NAMES = ["disc", "box", "polygon"];

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
      body(1.1 * (k % 3) - 1 + 0.2 * (k > 2), k > 2 ? 1.6 : 0, 0, 0, { shape: ["box", "disc", "polygon"][k % 3], corners: 2 * k - 1 || 3, size: 0.3, angle: 0.3 * k }))),
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

/** Return a set-up with nothing in it that the lab does not know, or say what is wrong. */
function understood(given) {
  const flag = (name) => given[name] === true;
  const number = (name, value, range) => {
    const taken = value ?? range.start ?? 0;
    if (fits(taken, range)) return taken;
    const kind = range.isPolygon ? "be a whole number" : "lie";
    throw new RangeError(`${name} must ${kind} between ${range.low} and ${range.high}, got ${JSON.stringify(value)}`);
  };
  if (!Array.isArray(given?.bodies) || given.bodies.length > MOST_BODIES)
    throw new RangeError(`bodies must be a list of at most ${MOST_BODIES}`);
  const settings = Object.entries(SETTINGS).map(([name, range]) => [name, number(name, given[name], range)]);
  return {
    dimensions: given.dimensions === 1 ? 1 : 2,
    ...Object.fromEntries(settings),
    gravity: flag("gravity"),
    walls: flag("walls"),
    bodies: given.bodies.map((one, k) => ({
      shape: SHAPE_NAMES.includes(one.shape) ? one.shape : "disc",
      ...Object.fromEntries(Object.entries(FIELDS).map(([name, range]) => [name, number(`bodies[${k}].${name}`, one[name], range)])),
    })),
  };
}

/** Return whether a value is a number that a range allows; corners are whole. */
const fits = (value, { low, high, isPolygon }) =>
  typeof value === "number" && value >= low && value <= high && (!isPolygon || Number.isInteger(value));

/** Return the corners of a body. The size of a box is half its width; that of a regular polygon is
 *  the distance from its centre to a corner. */
function outline({ shape, size, corners }) {
  if (shape === "box") return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([a, b]) => [a * size, b * size]);
  const turn = (2 * Math.PI) / corners;
  return Array.from({ length: corners }, (_, k) => [size * Math.cos(k * turn), size * Math.sin(k * turn)]);
}

/** Return a set-up as the description of a scene; the walls come last. */
function sceneOf({ dimensions, elasticity, friction, gravity, walls, bodies }) {
  const isTrack = dimensions === 1;
  const surface = { restitution: elasticity / 100, friction: isTrack ? 0 : friction };
  const [w, h] = [WIDTH, HEIGHTS[dimensions]];
  const corners = [[-w, -h], [w, -h], [w, h], [-w, h]];
  const sides = corners.map((corner, k) => ({ segment: [corner, corners[(k + 1) % 4]], ...surface }));
  return {
    gravity: [0, gravity && !isTrack ? -GRAVITY : 0],
    dt: DT,
    bodies: [
      ...bodies.map(({ shape, mass, size, corners, x, y, vx, vy, angle, w: spin }) => ({
        ...(shape === "disc" ? { circle: size } : { polygon: outline({ shape, size, corners }) }),
        ...(isTrack
          ? { position: [x, 0], velocity: [vx, 0], inertia: Infinity }
          : { position: [x, y], velocity: [vx, vy], angle, angular_velocity: spin }),
        ...surface,
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
