// A rubber ball is thrown over three grounds, once as it is and once without each effect: which bits change?

import { planOf } from "../../view/browser/plan.js";
import { scene } from "../../view/browser/world.js";
import { written } from "../../view/browser/figure.js";

const STEPS = 120; // of 1/60 s
const RADIUS = 0.4; // m
const RUBBER = { restitution: 0.8, friction: 0.8 };
const GROUNDS = [
  { name: "asphalt", restitution: 0.8, friction: 0.8 },
  { name: "ice", restitution: 0.8, friction: 0 },
  { name: "sand", restitution: 0, friction: 0.8 },
];
const GRAVITY = 10; // m/s²
const START = [0, 1.6]; // m, of ball 1
const RESTS = [2.6, RADIUS]; // m, where ball 2 lies
const WALL = 5.5; // m
const VIEW = [-0.8, 6.6, -0.3, 3.2];
const SHOWN = 0.25; // s: an arrow is the way made in this time,
const LONGEST = 3.6; // m, but it is no longer than this along x
const STATE = ["x", "y", "angle", "vx", "vy", "w"];
const BITS = 64; // of each number

/** Each effect that can be left out here, and the same scene without it. */
const EFFECTS = [
  { name: "friction", without: { mu: 0 } },
  { name: "rotation", without: { canTurn: false } },
  { name: "restitution", without: { e: 0 } },
  { name: "continuous", without: { isWatched: false } },
];

/** Return the scene as a world of the program. */
function worldOf(program, { ground, balls, vx, vy, w }, { mu, e, canTurn = true } = {}) {
  const surface = ({ restitution, friction }) => ({ restitution: e ?? restitution, friction: mu ?? friction });
  const ball = (given) => ({ circle: RADIUS, mass: 1, ...surface(RUBBER), ...(canTurn ? {} : { inertia: Infinity }), ...given });
  const fixed = (ends) => ({ segment: ends, ...surface(GROUNDS[ground]) });
  const thrown = ball({ position: START, velocity: [vx, vy], angular_velocity: canTurn ? w : 0 });
  return scene(program, {
    gravity: [0, -GRAVITY],
    bodies: [fixed([[-30, 0], [30, 0]]), fixed([[WALL, 0], [WALL, 30]]), thrown, ...(balls ? [ball({ position: RESTS })] : [])],
  });
}

/** Run the scene; return for each ball its states after every step, one behind the other. */
function run(program, values, without = {}) {
  const world = worldOf(program, values, without);
  if (without.isWatched === false) world.state.reach = Infinity; // nobody is watched for being fast
  const found = world.bodies.slice(2);
  const ways = found.map(() => new Float64Array((STEPS + 1) * STATE.length));
  for (let step = 0; step <= STEPS; step++) {
    if (step) program.advance(1);
    found.forEach((body, n) => ways[n].set(STATE.map((field) => body[field]), step * STATE.length));
  }
  return ways;
}

const tip = ({ vx, vy }) => [START[0] + Math.min(SHOWN * vx, LONGEST), START[1] + SHOWN * vy];

const placesOf = (way) => Array.from({ length: STEPS + 1 }, (_, k) => [way[k * STATE.length], way[k * STATE.length + 1]]);

/** Return how many bits of two runs differ, of how many, and how far apart they are at the most, m. */
function compare(one, other) {
  let [differing, all, most] = [0, 0, 0];
  one.forEach((way, n) => {
    const [a, b] = [way, other[n]].map((numbers) => new Uint32Array(numbers.buffer));
    for (let k = 0; k < a.length; k++) for (let left = a[k] ^ b[k]; left; left &= left - 1) differing++;
    all += BITS * way.length;
    const places = placesOf(other[n]);
    placesOf(way).forEach(([x, y], k) => (most = Math.max(most, Math.hypot(x - places[k][0], y - places[k][1]))));
  });
  return { differing, all, most };
}

const grouped = (count) => String(count).replace(/\B(?=(\d{3})+$)/g, ",");

function verdict({ differing, all, most }) {
  if (!differing) return "not one bit changes";
  const way = most === 0 ? "only how it turns" : most < 5e-4 ? "less than a millimetre" : `up to ${written(most, most < 10 ? 0.001 : 0.1)} m`;
  return `${grouped(differing)} of ${grouped(all)} bits change, ${way}`;
}

export default {
  programs: ["sequential", "plan"],
  panels: [
    { view: VIEW, width: 440 },
    { view: [0, 1, 0, 1], width: 300, height: 208 },
  ],
  gap: 20,
  numbers: {
    out: { label: "dotted: without", names: EFFECTS.map(({ name }) => name), start: 2 },
    ground: { label: "ground and wall", names: GROUNDS.map(({ name }) => name), start: 1 },
    balls: { label: "balls", names: ["one ball", "two balls"], start: 0 },
    vx: { label: "velocity along x, m/s", low: -8, high: 60, start: 3, step: 0.1 },
    vy: { label: "velocity along y, m/s", low: -8, high: 8, start: 0, step: 0.1 },
    w: { label: "spin, rad/s", low: -30, high: 30, start: 0, step: 1 },
  },
  handles: [
    {
      label: "Tip of the velocity of the ball",
      at: (values) => tip(values),
      moved: (_, [x, y]) => ({ vx: (x - START[0]) / SHOWN, vy: (y - START[1]) / SHOWN }),
      says: ({ vx, vy }) => `${written(vx, 0.1)}, ${written(vy, 0.1)} metres a second`,
      step: 0.05,
    },
  ],

  draw({ sequential: program, plan: rules }, values, pen, list) {
    const whole = run(program, values);
    const others = EFFECTS.map(({ without }) => run(program, values, without));
    const found = others.map((other) => compare(whole, other));
    const needed = planOf(rules, worldOf(program, values), STEPS / 60).filter(({ calledFor }) => calledFor).map(({ name }) => name);
    drawGround(pen, GROUNDS[values.ground]);
    whole.forEach((way, n) => drawBall(pen, way, others[values.out][n], n ? "orange" : "blue"));
    const [x, y] = tip(values);
    pen.arrow(START, [x - START[0], y - START[1]], { color: "blue" });
    const plan = EFFECTS.map(({ name }) => (needed.includes(name) ? "needed" : "left out"));
    EFFECTS.forEach(({ name }, k) => drawRow(list, 0.93 - 0.26 * k, { name, plan: plan[k], isShown: k === values.out }, found[k]));
    const told = EFFECTS.map(({ name }, k) => `Without ${name} (plan: ${plan[k]}) ${verdict(found[k])}.`);
    return `Two seconds on ${GROUNDS[values.ground].name}. ${told.join(" ")}`;
  },
};

function drawGround(pen, { name, restitution, friction }) {
  const [left, right, bottom, top] = VIEW;
  pen.polygon([[left, top], [left, bottom], [right, bottom], [right, top], [WALL, top], [WALL, 0], [left, 0]], { color: "grey", thick: 0 });
  pen.line([[left, 0], [WALL, 0], [WALL, top]], { thick: 2.5 });
  const rows = [["ball", RUBBER], [name, { restitution, friction }]];
  rows.forEach(([who, surface], row) =>
    pen.text([WALL, top], `${who}: mu = ${surface.friction}, e = ${surface.restitution}`, { anchor: "end", shift: [-8, 18 + 18 * row], size: 13 }),
  );
}

/** Draw a ball where it starts and ends, and its way: solid as it is, dotted without an effect. */
function drawBall(pen, way, other, color) {
  const [left, right, bottom, top] = VIEW;
  const isInside = ([x, y]) => x > left && x < right && y > bottom && y < top;
  const seen = (points) => {
    const end = points.findIndex((point) => !isInside(point));
    return end < 0 ? points : points.slice(0, end);
  };
  const [mine, without] = [seen(placesOf(way)), seen(placesOf(other))];
  if (mine.length > 1) pen.line(mine, { color, thick: 2 });
  if (without.length > 1) pen.line(without, { thick: 2, "stroke-dasharray": "2 5" });
  pen.circle(mine[0], RADIUS, { color });
  if (mine.length <= STEPS) return;
  const [[x, y], angle] = [mine[STEPS], way[STEPS * STATE.length + 2]];
  pen.circle([x, y], RADIUS, { color, dashed: true, filled: false, thick: 1.5 });
  pen.line([[x, y], [x + RADIUS * Math.cos(angle), y + RADIUS * Math.sin(angle)]], { color, thick: 1.5 });
}

/** Write what becomes of the scene without one effect, and draw which part of the bits change. */
function drawRow(list, y, { name, plan, isShown }, found) {
  list.text([0, y], `without ${name}`, { anchor: "start", bold: isShown });
  if (isShown) list.line([[0.5, y + 5 / list.scaleY], [0.65, y + 5 / list.scaleY]], { thick: 2, "stroke-dasharray": "2 5" });
  list.text([1, y], `plan: ${plan}`, { anchor: "end", size: 13 });
  list.text([0, y], verdict(found), { anchor: "start", size: 13, shift: [0, 18] });
  const at = y - 28 / list.scaleY;
  list.line([[0, at], [1, at]], { color: "grey", thick: 1 });
  if (found.differing) list.line([[0, at], [found.differing / found.all, at]], { color: "vermilion", thick: 5 });
}
