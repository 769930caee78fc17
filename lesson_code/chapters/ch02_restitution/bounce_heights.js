// The height of a dropped ball over time: ever lower arcs, which end in finite time.

import { written } from "../../view/browser/figure.js";

const GRAVITY = 9.81; // m/s²
const UP = [0, 1];
const SEEN = 0.2; // pixels: lower arcs are not drawn
const POINTS = 24; // of an arc

export default {
  program: "formulas",
  left: 44,
  top: 24,
  bottom: 44,
  panels: [{ view: [-0.4, 9.6, 0, 1.4], width: 580, height: 300 }],
  numbers: {
    e: { label: "restitution e", low: 0, high: 1, start: 0.8, step: 0.01 },
    height: { label: "height of the drop, m", low: 0.1, high: 1.2, start: 1, step: 0.05 },
  },
  handles: [
    {
      label: "Where the ball is dropped: arrow keys move it",
      at: ({ height }) => [0, height],
      moved: (_, [, y]) => ({ height: y }),
      says: ({ height }) => `${written(height, 0.01)} m`,
      step: 0.05,
    },
  ],

  draw(lesson, { e, height }, pen) {
    const end = pen.view[1];
    const impact = Math.sqrt(2 * GRAVITY * height); // speed at the floor
    const fall = impact / GRAVITY;
    const points = [];
    const peaks = [];
    let [time, speed] = [-fall, impact]; // the fall is the second half of an arc
    while (time < end && (speed * speed * pen.scaleY) / (2 * GRAVITY) > SEEN) {
      const duration = (2 * speed) / GRAVITY;
      for (let k = 0; k <= POINTS; k++) {
        const since = (duration * k) / POINTS;
        const now = time + since;
        if (now >= 0 && now <= end) points.push([now, Math.max(since * (speed - (GRAVITY * since) / 2), 0)]);
      }
      if (time > 0) peaks.push([time + duration / 2, (speed * speed) / (2 * GRAVITY)]);
      time += duration;
      speed = lesson.bounce([0, -speed], UP, e)[1];
    }
    const rest = e < 1 ? lesson.rest_time(height, e, GRAVITY) : Infinity;
    if (rest < end) {
      points.push([rest, 0], [end, 0]);
      pen.line([[rest, 0], [rest, 1.28]], { color: "vermilion", dashed: true });
      const side = rest < end / 2 ? { shift: [6, 8], anchor: "start" } : { shift: [-6, 8], anchor: "end" };
      pen.text([rest, 1.32], `at rest from ${written(rest, 0.01)} s`, side);
    }
    pen.axes("time, s", "height, m");
    pen.line(points, { color: "blue" });
    pen.dot([0, height], { color: "blue" });
    for (const peak of peaks) if (peak[0] <= end && peak[1] > 0.02) pen.dot(peak, { color: "blue" });
    if (e === 0) return `The ball does not bounce: it lies on the floor from ${written(rest, 0.01)} s on.`;
    const high = lesson.bounce([0, -impact], UP, e)[1] ** 2 / (2 * GRAVITY);
    const first = `The first bounce reaches ${high < 0.005 ? "less than 0.01" : written(high, 0.01)} m.`;
    if (e === 1) return `${first} So does every other: the ball never rests.`;
    const beyond = rest < end ? "" : ", which is beyond the axis";
    return `${first} After infinitely many bounces the ball lies still from ${written(rest, 0.01)} s on${beyond}.`;
  },
};
