// A disc flies at a box that may turn: when they first touch, and what a program that looks at a time sees.

import { written } from "../../view/browser/figure.js";

const HALF = [1, 0.5]; // m, of the box's width and height
const BOX = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => [x * HALF[0], y * HALF[1]]);
const CENTRE = [2, -0.5]; // m, of the box
const RADIUS = 0.5; // m, of the disc
const DURATION = 4; // s: how far the search looks ahead
const SHOWN = 0.5; // s: an arrow is the way made in this time

const turned = (angle) => ([x, y]) => [
  CENTRE[0] + x * Math.cos(angle) - y * Math.sin(angle),
  CENTRE[1] + x * Math.sin(angle) + y * Math.cos(angle),
];

/** Put both bodies into the tables of the program, let it look at them, and ahead. */
function impact(pair, { x, y, vx, vy, w }) {
  pair.corners.resize(BOX.length);
  BOX.forEach(([local_x, local_y], k) => Object.assign(pair.corners.at(k), { local_x, local_y }));
  pair.axes.resize(BOX.length);
  const turning = { x: CENTRE[0], y: CENTRE[1], angle: 0, vx: 0, vy: 0, w };
  Object.assign(pair.a, turning, { first_corner: 0, corner_count: BOX.length, bounding_radius: Math.hypot(...HALF) });
  Object.assign(pair.b, { x, y, vx, vy, radius: RADIUS, bounding_radius: RADIUS });
  pair.found.duration = DURATION;
  pair.run("look");
  const overlaps = pair.manifold.count > 0;
  pair.run("look_ahead");
  return { overlaps, time: pair.found.time };
}

export default {
  program: "geometry",
  panels: [{ view: [-4.4, 4.6, -3, 3], width: 600 }],
  numbers: {
    x: { label: "x of the disc, m", low: -4, high: 4, start: -3, step: 0.1 },
    y: { label: "y of the disc, m", low: -2.5, high: 2.5, start: 1, step: 0.1 },
    vx: { label: "velocity along x, m/s", low: -5, high: 5, start: 2, step: 0.1 },
    vy: { label: "velocity along y, m/s", low: -5, high: 5, start: -0.4, step: 0.1 },
    w: { label: "spin of the box, rad/s", low: -3, high: 3, start: 0, step: 0.1 },
    look: { label: "look at the time, s", low: 0, high: DURATION, start: 2.6, step: 0.1 },
  },
  handles: [
    {
      label: "The disc: arrow keys move it",
      at: ({ x, y }) => [x, y],
      moved: (_, [x, y]) => ({ x, y }),
      says: ({ x, y }) => `x ${written(x, 0.1)}, y ${written(y, 0.1)} metres`,
    },
    {
      label: "Tip of its velocity",
      at: ({ x, y, vx, vy }) => [x + SHOWN * vx, y + SHOWN * vy],
      moved: ({ x, y }, [toX, toY]) => ({ vx: (toX - x) / SHOWN, vy: (toY - y) / SHOWN }),
      says: ({ vx, vy }) => `${written(vx, 0.1)}, ${written(vy, 0.1)} metres a second`,
      step: 0.05,
    },
  ],

  draw(pair, values, pen) {
    const { x, y, vx, vy, w, look } = values;
    const { overlaps, time } = impact(pair, values);
    const place = (t) => [x + vx * t, y + vy * t];
    const box = (t, style) => pen.polygon(BOX.map(turned(w * t)), style);
    const end = Math.min(time, DURATION);
    pen.line([place(0), place(end)], { color: "grey", thick: 1, dashed: true });
    box(look, { color: "vermilion", filled: false, dashed: true, thick: 1.5 });
    pen.circle(place(look), RADIUS, { color: "blue", filled: false, dashed: true, thick: 1.5 });
    box(time <= DURATION ? time : 0, { color: "vermilion" });
    if (time <= DURATION) {
      pen.circle(place(time), RADIUS, { color: "blue" });
      pen.text(place(time), `${written(time, 0.001)} s`, { shift: [0, 5], size: 13 });
    }
    pen.circle([x, y], RADIUS, { color: "blue", filled: !(time <= DURATION) });
    pen.arrow([x, y], [SHOWN * vx, SHOWN * vy], { color: "blue" });
    const seen = `Dashed: where a program that looks after ${written(look, 0.1)} s finds them.`;
    if (overlaps) return "They overlap from the start: there is no first touch to find.";
    if (!(time <= DURATION)) return `They do not touch within ${DURATION} s. ${seen}`;
    return `They first touch after ${written(time, 0.001)} s. ${seen}`;
  },
};
