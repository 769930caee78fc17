// A tower of boxes with a load on top, after some steps by sweeps: how much of the weight each contact carries.

import { scene } from "../../view/browser/world.js";
import { written } from "../../view/browser/figure.js";

const RATE = 60; // steps a second
const GRAVITY = 10; // m/s²
const SURFACE = { friction: 0.5, restitution: 0 };
const SUNK = 4e-4; // m, between neighbours at the start
const BOX = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]; // m
const MOST = 6; // boxes
const OVER = 1.5; // a bar ends there: more of the force than it should be

const kilograms = (value) => `${written(value, 1)} kg`;

/** Return the tower after so many steps. */
function stepped(program, { boxes, load, sweeps, steps }) {
  const masses = [...Array(Math.round(boxes)).fill(1), load];
  const bodies = masses.map((mass, n) => ({ polygon: BOX, mass, position: [0, 0.5 + n - SUNK * (n + 1)], ...SURFACE }));
  const world = scene(program, {
    gravity: [0, -GRAVITY],
    iterations: Math.round(sweeps),
    bodies: [{ segment: [[-30, 0], [30, 0]], ...SURFACE }, ...bodies],
  });
  world.step(Math.round(steps));
  return { world, masses };
}

/** Return the force in each contact from the floor up, as part of the weight that it should carry. */
function carried({ impulses }, masses) {
  return masses.map((_, n) => {
    const forces = impulses.filter(({ a, b }) => Math.min(a, b) === n && Math.max(a, b) === n + 1);
    const force = forces.reduce((sum, { normal_impulse }) => sum + normal_impulse, 0) * RATE;
    const weight = GRAVITY * masses.slice(n).reduce((sum, mass) => sum + mass, 0);
    return force / weight;
  });
}

export default {
  program: "sequential",
  panels: [
    { view: [-2.4, 2.4, -0.4, MOST + 1.6], width: 170 },
    { view: [0, OVER, -0.4, MOST + 1.6], width: 420, height: 283 },
  ],
  bottom: 26,
  gap: 20,
  numbers: {
    boxes: { label: "boxes of 1 kg", low: 1, high: MOST, start: 1, step: 1 },
    load: { label: "mass of the load, kg", low: 1, high: 1000, start: 50, step: 1 },
    sweeps: { label: "sweeps a step", low: 1, high: 100, start: 10, step: 1 },
    steps: { label: "steps of 1/60 s", low: 1, high: 180, start: 1, step: 1 },
  },
  handles: [
    {
      label: "Height of the tower: up and down arrow keys",
      at: ({ boxes }) => [0, Math.round(boxes)],
      moved: (_, [, y]) => ({ boxes: Math.round(y) }),
      says: ({ boxes }) => `${Math.round(boxes)} ${boxes > 1 ? "boxes" : "box"} below the load`,
      step: 1,
    },
  ],

  draw(program, values, pen, chart) {
    const { world, masses } = stepped(program, values);
    const parts = carried(world, masses);
    pen.wall([0, 0], [0, 1], 2.2);
    masses.forEach((mass, n) => {
      const { x, y, angle } = world.bodies[n + 1];
      const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
      const corners = BOX.map(([px, py]) => [x + px * cos - py * sin, y + px * sin + py * cos]);
      const isSeen = corners.every(([cx, cy]) => Math.abs(cx) < 2.4 && cy > -0.3);
      if (isSeen) pen.polygon(corners, { color: n < masses.length - 1 ? "blue" : "orange" });
      if (isSeen && n === masses.length - 1) pen.text([x + 0.6, y], kilograms(mass), { anchor: "start", shift: [2, 5], size: 13 });
    });
    drawForces(chart, parts, masses);
    const [time, least] = [values.steps / RATE, Math.min(...parts)];
    const fallen = masses.some((_, n) => Math.abs(world.bodies[n + 1].y - (n + 0.5)) > 0.25);
    const when = `After ${written(values.steps, 1)} ${values.steps > 1 ? "steps" : "step"}${values.steps > 1 ? ` (${written(time, 0.01)} s)` : ""}`;
    if (fallen) return `${when} the tower no longer stands.`;
    if (values.steps > 1) return `${when} the tower stands. Of the weight above it, the weakest contact carries ${written(100 * least, 0.1)} %.`;
    const top = world.bodies[masses.length];
    const left = (-top.vy * RATE) / GRAVITY;
    const law = masses.length === 2 ? `; the law (M / (M + m)) to the power of ${values.sweeps} gives ${written((values.load / (values.load + 1)) ** values.sweeps, 0.001)}` : "";
    return `${when} the floor carries ${written(100 * parts[0], 0.1)} % of all the weight. Of what gravity has given the load, ${written(left, 0.001)} is left${law}.`;
  },
};

/** Draw a bar for each contact, at its height: the part of the weight above that it carries. */
function drawForces(chart, parts, masses) {
  const half = 0.32; // of a bar's height
  chart.line([[1, -0.2], [1, masses.length + 0.1]], { color: "green", dashed: true });
  chart.text([1, masses.length + 0.1], "all it should carry", { shift: [0, -8], size: 13 });
  parts.forEach((part, n) => {
    const end = Math.min(part, OVER);
    const y = n + 0.05;
    const color = Math.abs(part - 1) < 0.01 ? "green" : "vermilion";
    chart.polygon([[0, y - half], [end, y - half], [end, y + half], [0, y + half]], { color, thick: 1.5 });
    const weight = masses.slice(n).reduce((sum, mass) => sum + mass, 0);
    chart.text([1, y], `${written(100 * part, 0.1)} % of ${kilograms(weight)}`, { anchor: "start", shift: [8, 5], size: 13 });
  });
  chart.line([[0, -0.4], [0, masses.length + 0.1]], { color: "grey", thick: 1 });
  chart.text([0, -0.4], "force in each contact, from the floor up", { anchor: "start", shift: [0, 18], size: 13 });
}
