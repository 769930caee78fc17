// A scene of two discs, run once as it is and once without each effect: what changes, and what does not.

import { scene } from "../../view/browser/world.js";
import { written } from "../../view/browser/figure.js";

const STEPS = 120; // of 1/60 s
const RADII = [0.4, 0.4]; // m
const MASSES = [1, 1]; // kg
const START = [0, 1.6]; // m, of disc 1
const RESTS = [2.6, 0.4]; // m, where disc 2 lies
const WALL = 5.5; // m
const SHOWN = 0.25; // s: an arrow is the way made in this time

/** What each effect is, and the same scene without it. */
const EFFECTS = [
  { name: "gravity", without: (values) => ({ ...values, gravity: 0 }) },
  { name: "restitution", without: (values) => ({ ...values, e: 0 }) },
  { name: "friction", without: (values) => ({ ...values, floor: 0, discs: 0 }) },
  { name: "rotation", without: (values) => ({ ...values, w: 0, inertia: Infinity }) },
  { name: "continuous", without: (values) => ({ ...values, isBlind: true }) },
];

/** Run a scene; return for each disc its states x, y, angle after every step. */
function run(program, { gravity, e, floor, discs, vx, vy, w, inertia, isBlind }) {
  const disc = (n, given) => ({ circle: RADII[n], mass: MASSES[n], restitution: e, friction: discs, inertia, ...given });
  const fixed = (ends) => ({ segment: ends, restitution: e, friction: floor });
  const world = scene(program, {
    gravity: [0, -gravity],
    bodies: [
      fixed([[-30, 0], [30, 0]]),
      fixed([[WALL, 0], [WALL, 30]]),
      disc(0, { position: START, velocity: [vx, vy], angular_velocity: w }),
      disc(1, { position: RESTS }),
    ],
  });
  if (isBlind) world.state.reach = Infinity; // nobody is watched for being fast
  const found = world.bodies.slice(2);
  const ways = found.map(({ x, y, angle }) => [[x, y, angle]]);
  for (let step = 0; step < STEPS; step++) {
    program.advance(1);
    found.forEach(({ x, y, angle }, n) => ways[n].push([x, y, angle]));
  }
  return ways;
}

/** Return how far two runs are apart at the most, m, and whether every number of theirs is the same. */
function apart(one, other) {
  let [most, isSame] = [0, true];
  one.forEach((way, n) =>
    way.forEach((state, k) => {
      const [x, y] = other[n][k];
      most = Math.max(most, Math.hypot(state[0] - x, state[1] - y));
      isSame &&= state.every((value, field) => value === other[n][k][field]);
    }),
  );
  return { most, isSame };
}

const verdict = ({ most, isSame }) => (isSame ? "no bit changes" : most < 5e-4 ? (most > 0 ? "less than a millimetre" : "only how it turns") : `up to ${written(most, 0.001)} m apart`);

export default {
  program: "sequential",
  panels: [
    { view: [-0.8, 6, -0.3, 4.2], width: 480 },
    { view: [0, 1, 0, 1], width: 240, height: 300 },
  ],
  gap: 20,
  numbers: {
    out: { label: "leave out", names: EFFECTS.map(({ name }) => name), start: 3 },
    vx: { label: "velocity of disc 1 along x, m/s", low: -8, high: 60, start: 5, step: 0.1 },
    vy: { label: "velocity of disc 1 along y, m/s", low: -8, high: 8, start: 0, step: 0.1 },
    w: { label: "spin of disc 1, rad/s", low: -30, high: 30, start: 0, step: 1 },
    gravity: { label: "gravity, m/s\u00b2", low: 0, high: 20, start: 10, step: 0.5 },
    e: { label: "restitution of all", low: 0, high: 1, start: 0.8, step: 0.05 },
    floor: { label: "friction of floor and wall", low: 0, high: 1, start: 0.4, step: 0.05 },
    discs: { label: "friction of the discs", low: 0, high: 1, start: 0, step: 0.05 },
  },
  handles: [
    {
      label: "Tip of the velocity of disc 1",
      at: ({ vx, vy }) => [Math.min(START[0] + SHOWN * vx, WALL + 0.4), START[1] + SHOWN * vy],
      moved: (_, [x, y]) => ({ vx: (x - START[0]) / SHOWN, vy: (y - START[1]) / SHOWN }),
      says: ({ vx, vy }) => `${written(vx, 0.1)}, ${written(vy, 0.1)} metres a second`,
      step: 0.05,
    },
  ],

  draw(program, values, pen, list) {
    const whole = run(program, values);
    const others = EFFECTS.map(({ without }) => run(program, without(values)));
    const found = others.map((other) => apart(whole, other));
    pen.polygon([[-0.8, 4.2], [-0.8, -0.2], [5.7, -0.2], [5.7, 4.2], [WALL, 4.2], [WALL, 0], [-0.8, 0]], { color: "grey", thick: 0 });
    pen.line([[-0.8, 0], [WALL, 0], [WALL, 4.2]], { thick: 2.5 });
    const inside = ([x, y]) => x > -0.8 && x < 6 && y > -0.3 && y < 4.2;
    pen.text([WALL, 0], `mu = ${written(values.floor, 0.01)}`, { anchor: "end", shift: [-6, -6], size: 12 });
    const seen = (way) => {
      const end = way.findIndex((state) => !inside(state));
      return end < 0 ? way : way.slice(0, end);
    };
    whole.forEach((way, n) => {
      const color = n ? "orange" : "blue";
      const [mine, other] = [seen(way), seen(others[values.out][n])];
      if (mine.length > 1) pen.line(mine, { color, thick: 2 });
      if (other.length > 1) pen.line(other, { thick: 2, "stroke-dasharray": "2 5" });
      pen.circle(way[0], RADII[n], { color });
      pen.text(way[0], String(n + 1), { shift: [0, 5], bold: true });
      pen.text(way[0], `mu = ${written(values.discs, 0.01)}`, { shift: [0, -34], size: 12 });
      const last = mine.at(-1);
      if (mine.length === way.length) drawTurned(pen, last, RADII[n], { color, dashed: true, filled: false, thick: 1.5 });
    });
    pen.arrow(START, [Math.min(SHOWN * values.vx, WALL + 0.4 - START[0]), SHOWN * values.vy], { color: "blue" });
    list.text([0, 0.95], "the same scene without", { anchor: "start", size: 13 });
    EFFECTS.forEach(({ name }, k) => {
      const y = 0.82 - 0.17 * k;
      list.text([0, y], name, { anchor: "start", bold: k === values.out });
      list.text([0, y], verdict(found[k]), { anchor: "start", size: 13, bold: k === values.out, shift: [14, 20] });
    });
    const names = EFFECTS.filter((_, k) => found[k].isSame).map(({ name }) => name);
    const free = names.length ? `To leave out ${names.join(" or ")} changes no bit.` : "Each of the five changes something.";
    return `Two seconds: solid as it is, dotted without ${EFFECTS[values.out].name}: ${verdict(found[values.out])}. ${free}`;
  },
};

/** Draw a disc with a line that shows how it has turned. */
function drawTurned(pen, [x, y, angle], radius, style) {
  pen.circle([x, y], radius, style);
  pen.line([[x, y], [x + radius * Math.cos(angle), y + radius * Math.sin(angle)]], { color: style.color, thick: 1.5 });
}
