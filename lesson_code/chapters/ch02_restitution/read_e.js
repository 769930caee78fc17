// Restitution read off two heights: of a drop, and of what comes back.

import { written } from "../../view/browser/figure.js";

const GRAVITY = 9.81; // m/s²
const BALL = 0.06; // m, the radius
const speedFrom = (height) => Math.sqrt(2 * GRAVITY * height);

/** Draw a ball's highest place, and the way between it and the floor. */
function ball(pen, x, height, color, name) {
  pen.line([[x, 0], [x, height]], { color, dashed: true, thick: 1.5 });
  pen.circle([x, height + BALL], BALL, { color });
  pen.text([x, height], `${name} ${written(height, 0.01)} m`, { shift: [24, -8], anchor: "start" });
}

export default {
  program: "formulas",
  left: 44,
  top: 24,
  bottom: 44,
  gap: 70,
  panels: [
    { view: [0, 2.8, 0, 2.3], width: 308 },
    { view: [0, 2, 0, 7], width: 210, height: 253 },
  ],
  numbers: {
    drop: { label: "height of the drop, m", low: 0.1, high: 2, start: 1, step: 0.01 },
    back: { label: "height after the bounce, m", low: 0, high: 2, start: 0.64, step: 0.01 },
  },
  handles: [
    {
      label: "Height of the drop: arrow keys move it",
      at: ({ drop }) => [0.4, drop + BALL],
      moved: (_, [, y]) => ({ drop: Number((y - BALL).toFixed(9)) }),
      says: ({ drop }) => `${written(drop, 0.01)} m`,
      step: 0.02,
    },
    {
      label: "Height after the bounce: arrow keys move it",
      at: ({ back }) => [1.7, back + BALL],
      moved: (_, [, y]) => ({ back: Number((y - BALL).toFixed(9)) }),
      says: ({ back }) => `${written(back, 0.01)} m`,
      step: 0.02,
    },
  ],

  draw(lesson, { drop, back }, heights, speeds) {
    const [down, up] = [-speedFrom(drop), speedFrom(back)];
    const e = lesson.restitution_1d(down, 0, up, 0); // the floor is the second body
    heights.axes("", "height, m");
    ball(heights, 0.4, drop, "blue", "from");
    ball(heights, 1.7, back, "orange", "to");
    speeds.axes("", "speed at the floor, m/s");
    speeds.arrow([0.5, -down], [0, down], { color: "blue" });
    speeds.arrow([1.5, 0], [0, up], { color: "orange" });
    speeds.text([0.5, 0], "before", { shift: [0, 20], size: 13 });
    speeds.text([1.5, 0], "after", { shift: [0, 20], size: 13 });
    const told =
      `It hits the floor at ${written(-down, 0.01)} m/s and leaves it at ${written(up, 0.01)} m/s: ` +
      `e = ${written(e, 0.001)}, the root of the heights' ratio, ${written(back / drop, 0.001)}.`;
    if (e > 1) return `${told} No ball that is only dropped comes back higher: something has added energy.`;
    return `${told} ${written(100 * (1 - back / drop), 0.1)} % of the energy is lost.`;
  },
};
