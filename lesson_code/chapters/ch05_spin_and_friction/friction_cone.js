// Coulomb's limit as a cone of impulses, and as a ramp with a floor and a ceiling.

import { written } from "../../view/browser/figure.js";

const M_EFF = 1; // kg, along the tangent
const ROUNDING = 1e-12; // part of the sliding that is none: far above that of a number (1e-16)
const FASTEST = 6; // m/s

export default {
  program: "formulas",
  left: 40,
  top: 66,
  bottom: 44,
  gap: 66,
  panels: [
    { view: [-7.2, 7.2, -0.8, 7], width: 340 },
    { view: [-7.2, 7.2, -6.6, 6.6], width: 250, height: 184 },
  ],
  numbers: {
    mu: { label: "friction coefficient μ", low: 0, high: 1.5, start: 0.5, step: 0.05 },
    sliding: { label: "sliding, m/s", low: -FASTEST, high: FASTEST, start: 3, step: 0.1 },
    jn: { label: "normal impulse, N s", low: 0, high: 6, start: 4, step: 0.1 },
  },
  handles: [
    {
      label: "Tip of the impulse that would stop the sliding: arrow keys move it",
      at: ({ sliding, jn }) => [-M_EFF * sliding, jn],
      moved: (_, [x, y]) => ({ sliding: -x / M_EFF, jn: y }),
      says: ({ sliding, jn }) => `tangent ${written(-M_EFF * sliding, 0.01)}, normal ${written(jn, 0.01)} N s`,
    },
    {
      label: "Sliding on the axis of the ramp: arrow keys move it",
      panel: 1,
      at: ({ sliding }) => [sliding, 0],
      moved: (_, [x]) => ({ sliding: x }),
      says: ({ sliding }) => `${written(sliding, 0.01)} m/s`,
    },
  ],

  draw(lesson, { mu, sliding, jn }, cone, ramp) {
    const friction = (vt) => lesson.friction_impulse(vt, M_EFF, mu, jn);
    const [needed, given] = [-M_EFF * sliding, friction(sliding)];
    const [, east, , north] = cone.view;
    const rim = Math.min(north, east / mu); // where the cone leaves the picture
    cone.polygon([[0, 0], [mu * rim, rim], [mu * rim, north], [-mu * rim, north], [-mu * rim, rim]], { color: "sky", thick: 0 });
    for (const side of [-1, 1]) cone.line([[0, 0], [side * mu * rim, rim]], { color: "blue", thick: 1.5 });
    cone.line([[-east, 0], [east, 0]], { color: "grey", thick: 1 });
    cone.line([[-east, jn], [east, jn]], { color: "grey", dashed: true, thick: 1 });
    cone.axes("tangent impulse, N s", "normal impulse, N s");
    cone.arrow([0, 0], [given, jn], { thick: 4 });
    cone.arrow([0, 0], [needed, jn], { color: "vermilion", dashed: true });
    cone.legend([-east, north + 64 / cone.scaleY], [
      ["would stop the sliding", { color: "vermilion", dashed: true }],
      ["the contact's impulse", { thick: 4 }],
    ]);
    ramp.line([[-FASTEST, 0], [FASTEST, 0]], { color: "grey", thick: 1 });
    ramp.line([[0, -FASTEST], [0, FASTEST]], { color: "grey", thick: 1 });
    ramp.axes("sliding before, m/s", "friction impulse, N s");
    ramp.line(Array.from({ length: 241 }, (_, k) => FASTEST * (k / 120 - 1)).map((vt) => [vt, friction(vt)]), { color: "blue" });
    ramp.line([[sliding, 0], [sliding, given]], { dashed: true, thick: 1.5 });
    ramp.dot([sliding, given]);
    if (sliding === 0) return "Nothing slides, so friction has nothing to do.";
    const left = sliding + given / M_EFF;
    const told =
      `To stop the sliding takes ${written(Math.abs(needed), 0.01)} N s; Coulomb's limit is ` +
      `${written(mu, 0.01)} · ${written(jn, 0.01)} = ${written(mu * jn, 0.01)} N s.`;
    const sticks = Math.abs(left) < ROUNDING * Math.abs(sliding);
    return `${told} ${sticks ? "The contact sticks." : `The contact slides on, at ${written(left, 0.01)} m/s.`}`;
  },
};
