// A box has landed flat, and a solver visits its two contacts in turn: what each visit does to both corners.

import { power, written } from "../../view/browser/figure.js";

const MASS = 1; // kg
const SPEED = 1; // m/s, downwards
const RESTITUTION = 0.5;
const MOST = 60; // visits
const LOWEST = -12; // the power of ten at which the chart of what is left begins
const ARROW = 1.6; // m for 1 m/s

const speed = (value) => `${written(value, 0.001)} m/s`;

/** Visit the corners in turn. Returns the state before the first visit and after each. */
function visits(lesson, width, height) {
  const half = width / 2;
  const corners = [[-half, -height / 2], [half, -height / 2], [half, height / 2], [-half, height / 2]];
  const inertia = lesson.polygon_inertia(MASS, corners);
  const arms = [-half, half]; // of the left and of the right contact: their lever arms about the centre
  const states = [{ vy: -SPEED, w: 0, impulses: [0, 0] }];
  for (let visit = 0; visit < MOST; visit++) {
    const { vy, w, impulses } = states[visit];
    const side = visit % 2;
    const vn = vy + w * arms[side] - RESTITUTION * SPEED; // from the velocity that it should have
    const m_eff = lesson.effective_mass(0, 1 / MASS, 0, 1 / inertia, 0, arms[side]);
    const sum = lesson.normal_impulse(vn, m_eff, 0, impulses[side]);
    const given = sum - impulses[side];
    const next = side ? [impulses[0], sum] : [sum, impulses[1]];
    states.push({ vy: vy + given / MASS, w: w + (given * arms[side]) / inertia, impulses: next });
  }
  const [shared, own] = [1 / MASS - half ** 2 / inertia, 1 / MASS + half ** 2 / inertia];
  return { states, factor: (shared / own) ** 2 };
}

export default {
  program: "formulas",
  panels: [
    { view: [-4, 4, -2.2, 10.8], width: 260 },
    { view: [0, MOST / 2, LOWEST, 1], width: 380, height: 300 },
  ],
  gap: 76,
  top: 24,
  bottom: 44,
  numbers: {
    visits: { label: "visits to a contact", low: 0, high: MOST, start: 1, step: 1 },
    width: { label: "width of the box, m", low: 0.5, high: 5, start: 1, step: 0.1 },
    height: { label: "height of the box, m", low: 0.5, high: 10, start: 4, step: 0.1 },
  },
  handles: [
    {
      label: "Upper right corner of the box",
      at: ({ width, height }) => [width / 2, height],
      moved: (_, [x, y]) => ({ width: 2 * x, height: y }),
      says: ({ width, height }) => `${written(width, 0.1)} m wide, ${written(height, 0.1)} m high`,
      step: 0.05,
    },
    {
      label: "Number of visits",
      panel: 1,
      at: ({ visits }) => [visits / 2, LOWEST + 1],
      moved: (_, [x]) => ({ visits: Math.round(2 * x) }),
      says: ({ visits }) => `${Math.round(visits)} visits`,
      step: 0.5,
    },
  ],

  draw(lesson, { visits: seen, width, height }, pen, chart) {
    const { states, factor } = visits(lesson, width, height);
    const count = Math.round(seen);
    const { vy, w } = states[count];
    const corners = [vy - (w * width) / 2, vy + (w * width) / 2];
    pen.wall([0, 0], [0, 1], 3.6);
    pen.polygon([[-width / 2, 0], [width / 2, 0], [width / 2, height], [-width / 2, height]], { color: "blue" });
    corners.forEach((v, side) => {
      const x = (side - 0.5) * width;
      const isNext = count > 0 && (count - 1) % 2 === side;
      pen.line([[x - 0.3, ARROW * RESTITUTION * SPEED], [x + 0.3, ARROW * RESTITUTION * SPEED]], { color: "green", thick: 2 });
      pen.arrow([x, 0], [0, ARROW * v], { color: isNext ? "vermilion" : "ink" });
      pen.text([x, 0], speed(v), { shift: [side ? 10 : -10, -4], anchor: side ? "start" : "end", size: 13, bold: isNext });
    });
    chart.axes("sweeps (two visits each)", "spin that is left, rad/s", "y");
    const left = states.map((state, k) => [k / 2, Math.log10(Math.abs(state.w))]).filter(([, y]) => y > LOWEST);
    for (const [x, y] of left.slice(1)) if (Number.isInteger(x)) chart.dot([x, y], { color: "blue" });
    if (count > 0 && Math.abs(w) > 10 ** LOWEST) chart.circle([count / 2, Math.log10(Math.abs(w))], 0.42, { color: "vermilion", filled: false, thick: 2.5 });
    chart.line([[count / 2, LOWEST], [count / 2, 1]], { color: "grey", thick: 1, dashed: true });
    const law = factor > 1e-12 ? `Each sweep leaves ${written(factor, 0.001)} of the spin.` : "Here the contacts do not feel each other: one sweep is enough.";
    if (count === 0) return `Both corners come down at ${speed(SPEED)}. They should go up at ${speed(RESTITUTION * SPEED)}, the green mark. ${law}`;
    const where = count % 2 ? "left" : "right";
    const other = count % 2 ? corners[1] : corners[0];
    const spin = Math.abs(w) < 10 ** LOWEST ? "less than " + power(LOWEST) : Math.abs(w) < 0.001 ? "about " + power(Math.round(Math.log10(Math.abs(w)))) : written(Math.abs(w), 0.001);
    return `Visit ${count}, to the ${where} corner: it goes up as it should, the other one at ${speed(other)}. The box turns at ${spin} rad/s. ${law}`;
  },
};
