// A heavy ball and a light one at rest: how far one of them may move in a step, and what a hit makes of it.

import { written } from "../../view/browser/figure.js";

const HEAVY = 100; // kg
const RADIUS = 0.1; // m, of the light ball, which is the thinnest body
const DOUBT = 1.5; // the rule multiplies the bound by it
const STEPS = [0, 1 / 30]; // s: the lengths of a step that are drawn
const TOP = 0.5; // m, of the chart
const ACROSS = [-1.6, 1.4]; // m, of the picture
const SHOWN = 0.25; // s: an arrow is the way made in this time

const ms = (seconds) => `${written(1000 * seconds, 0.1)} ms`;

export default {
  program: "formulas",
  top: 24,
  bottom: 44,
  panels: [
    { view: [...ACROSS, -1.4, 0.9], width: 300 },
    { view: [0, 1000 * STEPS[1], 0, TOP], width: 330, height: 230 },
  ],
  gap: 70,
  numbers: {
    speed: { label: "speed of the ball of 100 kg, m/s", low: 0.1, high: 4, start: 0.5, step: 0.1 },
    mass: { label: "mass of the small ball, kg", low: 0.1, high: 10, start: 1, step: 0.1 },
    dt: { label: "step, ms", low: 0.5, high: 33, start: 16.7, step: 0.1 },
  },
  handles: [
    {
      label: "Tip of the heavy ball's velocity",
      at: ({ speed }) => [-0.9 + SHOWN * speed, 0],
      moved: (_, [x]) => ({ speed: (x + 0.9) / SHOWN }),
      says: ({ speed }) => `${written(speed, 0.1)} metres a second`,
      step: 0.025,
    },
    {
      label: "Length of the step: left and right arrow keys",
      panel: 1,
      at: ({ dt }) => [dt, 0.025],
      moved: (_, [x]) => ({ dt: x }),
      says: ({ dt }) => `${written(dt, 0.1)} milliseconds`,
    },
  ],

  draw(lesson, { speed, mass, dt }, pen, chart) {
    const energy = (HEAVY * speed ** 2) / 2;
    const bound = Math.sqrt((2 * energy) / mass); // one body has all of it
    const [, struck] = lesson.elastic_1d(HEAVY, speed, mass, 0);
    const [step, room] = [dt / 1000, RADIUS];
    pen.circle([-0.9, 0], 0.5, { color: "blue" });
    pen.text([-0.9, 0], `${HEAVY} kg`, { shift: [0, -24], size: 13 });
    pen.circle([0, 0], RADIUS, { color: "vermilion" });
    pen.text([0, 0.16], `${written(mass, 0.1)} kg`, { size: 13, shift: [0, -4] });
    pen.arrow([-0.9, 0], [SHOWN * speed, 0], { color: "blue" });
    const rows = [["after the hit", struck, "vermilion"], ["with all the energy", bound, "ink"]];
    rows.forEach(([name, v, color], k) => {
      const y = -0.9 - 0.34 * k;
      const end = Math.min(v * step, 1.4 - ACROSS[0]);
      pen.line([[ACROSS[0], y], [ACROSS[0] + end, y]], { color, thick: 4 });
      pen.text([ACROSS[0], y], `${name}: ${written(v * step, 0.001)} m in a step`, { anchor: "start", shift: [0, -7], size: 13 });
    });
    chart.axes("step, ms", "m in a step");
    const line = (v, style) => {
      const end = Math.min(STEPS[1], TOP / v);
      chart.line([[0, 0], [1000 * end, v * end]], style);
    };
    line(struck, { color: "vermilion" });
    line(bound, {});
    line(DOUBT * bound, { dashed: true, thick: 1.5 });
    chart.line([[0, room], [1000 * STEPS[1], room]], { color: "green" });
    chart.line([[dt, 0], [dt, TOP]], { color: "grey", thick: 1, dashed: true });
    chart.legend([1, TOP], [
      ["bound with a margin", { dashed: true, thick: 1.5 }],
      ["bound by the energy", {}],
      ["after the hit", { color: "vermilion" }],
      ["half of its width", { color: "green" }],
    ]);
    const isWatched = DOUBT * bound * step > room;
    const need = !isWatched ? "nobody has to be watched" : struck * step > room ? "it has to be watched: after the hit it would move by more than half of its width" : "the rule says that it has to be watched, though after the hit it moves by less: a bound may err to one side";
    return `A hit gives the light ball ${written(struck, 0.01)} m/s; no ball can ever be faster than ${written(bound, 0.01)} m/s, the bound. At ${ms(step)} a step: ${need}.`;
  },
};
