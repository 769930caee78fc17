// Two unit vectors: how far one reaches along the other, and on which side of it the other lies.

import { written } from "../../view/browser/figure.js";

const along = (degrees) => [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
const NOTHING_ELSE = 1e-9; // far above the rounding of a cosine (1e-16), far below a degree (.017)
const sign = (value) => (value > NOTHING_ELSE ? 1 : value < -NOTHING_ELSE ? -1 : 0);
const FRONT = { 1: "in front of a", 0: "beside a, at a right angle", "-1": "behind a" };
const SIDE = { 1: "counter-clockwise of a", 0: "neither counter-clockwise nor clockwise of a", "-1": "clockwise of a" };

export default {
  program: "formulas",
  panels: [{ view: [-1.5, 1.5, -1.35, 1.35], width: 440 }],
  numbers: {
    angle: { label: "angle of b, degrees", low: -180, high: 180, start: 60, step: 1 },
  },
  handles: [
    {
      label: "Tip of b: arrow keys move it",
      at: ({ angle }) => along(angle),
      moved: (_, [x, y]) => ({ angle: Math.round((Math.atan2(y, x) * 180) / Math.PI) }),
      says: ({ angle }) => `${angle} degrees`,
      step: 0.05,
    },
  ],

  draw(lesson, { angle }, pen) {
    const [a, b] = [[1, 0], along(angle)];
    const [inFront, toTheLeft] = [lesson.dot(a, b), lesson.cross(a, b)];
    pen.circle([0, 0], 1, { filled: false, thick: 1, color: "grey" });
    pen.line([[0, -1.2], [0, 1.2]], { thick: 1, color: "grey", dashed: true });
    pen.text([1.5, 1.22], "in front", { anchor: "end" });
    pen.text([-1.5, 1.22], "behind", { anchor: "start" });
    pen.line([[0, 0], [inFront, 0]], { thick: 9, color: inFront < 0 ? "purple" : "green" });
    pen.line([b, [inFront, 0]], { dashed: true, thick: 1.5 });
    pen.arrow([0, 0], a, { color: "blue" });
    pen.text([0.5, 0], "a", { shift: [0, toTheLeft < 0 ? -12 : 24], bold: true });
    pen.arrow([0, 0], b, { color: "vermilion" });
    pen.text(b.map((part) => 1.17 * part), "b", { shift: [0, 5], bold: true });
    return (
      `a · b = ${written(inFront, 0.001)}: b is ${FRONT[sign(inFront)]}. ` +
      `a × b = ${written(toTheLeft, 0.001)}: b lies ${SIDE[sign(toTheLeft)]}.`
    );
  },
};
