// How wrong a run is at each length of its step, by three methods, and which step is short enough.

import { scene } from "../../view/browser/world.js";
import { written } from "../../view/browser/figure.js";

const DURATION = 2; // s
const LOOKS = 10; // times at which the place is compared with the right one, evenly spread
const RATES = [15, 20, 30, 40, 60, 80, 120, 160, 240, 320]; // steps a second; LOOKS go into all of them
const POINTS = 100; // after the first, of the right path; LOOKS go into them
const RADIUS = 0.5; // m, of every ball
const GRAVITY = 10; // m/s²
const DROP = 1; // m
const ROOM = 1.5; // m, from the middle of the room to each wall
const FLYING = 1.7; // m/s, between the walls
const SLIDING = 3; // m/s, at the start
const RUBBING = 0.2; // friction
const E_STEP = 0.05; // of the restitution that can be set, from 0 to 1
const REST = 30; // ms without a change
const LOWEST = -5; // the power of ten of the smallest error that is drawn; what is smaller lies on the axis
const MOST = 3.2; // the power of ten at which the chart ends

const METHODS = [
  { name: "sweeps", color: "blue", parts: 1 },
  { name: "sweeps, steps split at impacts", color: "green", parts: 1, isSplit: true },
  { name: "4 sub-steps", color: "vermilion", parts: 4 },
];

/** Each scene: its bodies, the number that is looked at, and what it should be. */
const SCENES = [
  {
    name: "a ball that bounces",
    axis: "height, m",
    view: [-0.25, 1.1], // in steps of 1/15 s it is found 0.24 m in the floor
    describe: (e) => ({ gravity: [0, -GRAVITY], bodies: [floor(e, 0), ball({ position: [0, DROP + RADIUS] }, e, 0)] }),
    seen: ({ y }) => y - RADIUS,
    right: rightBounce,
  },
  {
    name: "a ball between two walls",
    axis: "x, m",
    view: [-1.2, 1.2],
    describe: () => ({ bodies: [wall(-ROOM), wall(ROOM), ball({ velocity: [FLYING, 0] }, 1, 0)] }),
    seen: ({ x }) => x,
    right: rightBetweenWalls,
  },
  {
    name: "a disc that slides until it rolls",
    axis: "x, m",
    view: [0, 5],
    describe: () => ({ gravity: [0, -GRAVITY], bodies: [floor(0, RUBBING), ball({ position: [0, RADIUS], velocity: [SLIDING, 0] }, 0, RUBBING)] }),
    seen: ({ x }) => x,
    right: rightRolling,
  },
  {
    name: "a fall without an impact",
    axis: "height, m",
    view: [-21, 1],
    describe: () => ({ gravity: [0, -GRAVITY], bodies: [ball({}, 0, 0)] }),
    seen: ({ y }) => y,
    right: (_, t) => (-GRAVITY * t * t) / 2,
  },
];

const floor = (restitution, friction) => ({ segment: [[-30, 0], [30, 0]], restitution, friction });
const wall = (x) => ({ segment: [[x, -2], [x, 2]], restitution: 1, friction: 0 });
const ball = (placed, restitution, friction) => ({ circle: RADIUS, mass: 1, restitution, friction, ...placed });

/** The height of a ball that falls and bounces, arc after arc. */
function rightBounce(lesson, t, e) {
  let speed = Math.sqrt(2 * GRAVITY * DROP);
  let since = t + speed / GRAVITY; // the fall is the second half of an arc
  while (since > (2 * speed) / GRAVITY && speed > 1e-6) {
    since -= (2 * speed) / GRAVITY;
    speed = lesson.bounce([0, -speed], [0, 1], e)[1];
  }
  return speed > 1e-6 ? since * (speed - (GRAVITY * since) / 2) : 0;
}

/** The place of a ball that flies to and fro at one speed. */
function rightBetweenWalls(_, t) {
  const half = ROOM - RADIUS;
  const way = (FLYING * t + half) % (4 * half);
  return way <= 2 * half ? way - half : 3 * half - way;
}

/** The place of a disc that friction slows until it rolls, with two thirds of its speed. */
function rightRolling(_, t) {
  const rolls = SLIDING / (3 * RUBBING * GRAVITY);
  const slid = Math.min(t, rolls);
  return SLIDING * slid - (RUBBING * GRAVITY * slid * slid) / 2 + (2 / 3) * SLIDING * (t - slid);
}

/** Run a scene; return its places after every so many steps, from the start. */
function run(lesson, shown, e, method, rate, every) {
  const program = method.parts > 1 ? lesson.substep : lesson.sequential;
  const world = scene(program, { ...shown.describe(e), dt: 1 / rate, substeps: method.parts });
  if (method.isSplit) world.state.reach = 0; // every body that moves is watched
  const body = world.bodies.at(-1);
  const places = [shown.seen(body)];
  for (let step = every; step <= DURATION * rate; step += every) {
    program.advance(every);
    places.push(shown.seen(body));
  }
  return places;
}

/** Return the largest distance from the right path at the times that are looked at, m. */
function errorOf(lesson, shown, e, method, rate, path) {
  const places = run(lesson, shown, e, method, rate, (DURATION * rate) / LOOKS);
  return Math.max(...places.map((place, k) => Math.abs(place - path[(k * POINTS) / LOOKS])));
}

const known = {}; // by scene and, where one bounces, restitution
let waiting; // for the page to be at rest

/** Return the right path, and the errors of each method: they change with these two only. */
function knownOf(lesson, shown, e) {
  const found = (known[keyOf(shown, e)] ??= foundOf(lesson, shown, e));
  if (shown.describe.length) findAhead(lesson, shown);
  return found;
}

const keyOf = ({ name, describe }, e) => `${name} ${describe.length ? e : ""}`;

/** Find the errors of the next restitution that the slider can be set to, when the page is at rest. */
function findAhead(lesson, shown) {
  clearTimeout(waiting);
  const all = Array.from({ length: 1 / E_STEP + 1 }, (_, k) => Number((k * E_STEP).toFixed(2)));
  const next = all.find((e) => !known[keyOf(shown, e)]);
  if (next !== undefined) waiting = setTimeout(() => knownOf(lesson, shown, next), REST);
}

function foundOf(lesson, shown, e) {
  const path = Array.from({ length: POINTS + 1 }, (_, k) => shown.right(lesson.formulas, (k * DURATION) / POINTS, e));
  return { path, errors: METHODS.map((method) => RATES.map((rate) => errorOf(lesson, shown, e, method, rate, path))) };
}

/** Return the place of the first rate from which on all errors are small enough, or -1. */
function enough(found, most) {
  for (let k = found.length - 1; k >= 0; k--) if (found[k] > most) return k + 1 < found.length ? k + 1 : -1;
  return 0;
}

const metres = (value) => (value < 0.001 ? `${value < 1e-9 ? "less than 1e\u22129" : value.toExponential(0).replace("-", "\u2212")} m` : `${written(value, 0.001)} m`);
const level = (value) => Math.max(Math.log10(value), LOWEST);

export default {
  programs: ["sequential", "substep", "formulas"],
  left: 44,
  top: 66,
  bottom: 44,
  panels: [
    { view: [0, DURATION, 0, 1], width: 270, height: 260 },
    { view: [1, MOST, LOWEST, 0.5], width: 300, height: 260 },
  ],
  gap: 66,
  numbers: {
    scene: { label: "scene", names: SCENES.map(({ name }) => name), start: 0 },
    method: { label: "method on the left", names: METHODS.map(({ name }) => name), start: 0 },
    rate: { label: "steps a second", low: 15, high: 480, start: 20, step: 5 },
    power: { label: "how wrong may it be: 10 to the", low: -4.5, high: 0, start: -1.5, step: 0.05 },
    e: { label: "restitution of the ball that bounces", low: 0, high: 1, start: 0.8, step: E_STEP },
  },
  handles: [
    {
      label: "Line of what is allowed: up and down arrow keys move it",
      panel: 1,
      at: ({ power }) => [MOST - 0.1, power],
      moved: (_, [, y]) => ({ power: y }),
      says: ({ power }) => metres(10 ** power),
      step: 0.05,
    },
  ],

  draw(lesson, { scene: which, method: chosen, rate: asked, power, e }, path, chart) {
    const [shown, method] = [SCENES[which], METHODS[chosen]];
    const rate = Math.round(asked / 5) * 5;
    const [low, high] = shown.view;
    const at = (t, place) => [t, (place - low) / (high - low)];
    drawPath(path, shown, at);
    const { path: right, errors: found } = knownOf(lesson, shown, e);
    path.line(right.map((place, k) => at((k * DURATION) / POINTS, place)), { color: "grey", thick: 2 });
    const every = Math.ceil(rate / 60); // so many steps from one point to the next
    const points = run(lesson, shown, e, method, rate, every).map((place, k) => at((k * every) / rate, place));
    path.line(points, { color: method.color, thick: 1.5, dashed: true });
    if (rate <= 60) for (const point of points) path.dot(point, { color: method.color });
    path.legend([0, 1 + 58 / path.height], [["right", { color: "grey" }], [`${method.name}, ${rate} steps a second`, { color: method.color, dashed: true }]]);

    chart.axes("steps a second, sub-steps counted", "", "xy");
    chart.text([1, 0.5], "largest error, m", { anchor: "start", size: 13, shift: [-36, -52] });
    const allowed = 10 ** power;
    chart.line([[1, power], [MOST, power]], { dashed: true, thick: 1.5 });
    const answers = METHODS.map((each, m) => {
      const points = found[m].map((error, k) => [Math.log10(each.parts * RATES[k]), level(error)]);
      chart.line(points, { color: each.color });
      for (const point of points) chart.dot(point, { color: each.color });
      const first = enough(found[m], allowed);
      if (first < 0) return `${each.name}: none of these`;
      chart.put("circle", { cx: chart.x(points[first][0]).toFixed(1), cy: chart.y(points[first][1]).toFixed(1), r: 8, fill: "none", "stroke-width": 2.5, color: each.color });
      return `${each.name}: ${each.parts * RATES[first]}`;
    });
    METHODS.forEach(({ name, color }, k) => {
      const at = (right) => [MOST - (190 - right) / chart.scale, 0.5 + (44 - 16 * k) / chart.scaleY];
      chart.line([at(0), at(24)], { color });
      chart.text(at(30), name, { anchor: "start", size: 12, shift: [0, 4] });
    });
    const error = errorOf(lesson, shown, e, method, rate, right);
    return `${shown.name[0].toUpperCase()}${shown.name.slice(1)}, ${method.name}, ${rate} steps a second: wrong by up to ${metres(error)}. Within ${metres(allowed)}, in steps or sub-steps a second: ${answers.join("; ")}.`;
  },
};

/** Draw the axes of the path, whose places run from 0 to 1 in the panel. */
function drawPath(pen, { axis, view: [low, high] }, at) {
  pen.line([[0, 1], [0, 0], [DURATION, 0]], { thick: 1, color: "grey" });
  for (const t of [0, 0.5, 1, 1.5, 2]) pen.text([t, 0], written(t, 0.1), { shift: [0, 17], size: 12 });
  const stride = high - low > 10 ? 5 : high - low > 3 ? 1 : 0.5;
  for (let value = Math.ceil(low / stride) * stride; value <= high; value += stride)
    pen.text(at(0, value), written(value, stride), { shift: [-6, 4], anchor: "end", size: 12 });
  pen.text([DURATION / 2, 0], "time, s", { shift: [0, 36], size: 13 });
  pen.text([0, 1], axis, { anchor: "start", size: 13, shift: [0, -10] });
}
