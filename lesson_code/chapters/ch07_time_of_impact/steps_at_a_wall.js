// A ball that is looked at at the ends of steps, and a wall: from which places it is stopped, and from which it is not.

import { written } from "../../view/browser/figure.js";

const RADIUS = 0.1; // m, of the ball
const FARTHEST = 2.2; // m, from the middle of the wall: what is seen
const HALF = 9; // m, of the wall's height: the way out of it is never up
const STARTS = 100; // how many places within a step are tried
const STRIP = -0.62; // m: where they are drawn
const MOST = 100; // steps that a ball is followed for

/** Put wall and ball into the tables of the program. */
function placed(pair, { speed, thickness }) {
  pair.corners.resize(4);
  const half = thickness / 2;
  [[-half, -HALF], [half, -HALF], [half, HALF], [-half, HALF]].forEach(([local_x, local_y], k) =>
    Object.assign(pair.corners.at(k), { local_x, local_y }),
  );
  pair.axes.resize(4);
  Object.assign(pair.a, { first_corner: 0, corner_count: 4, bounding_radius: Math.hypot(half, HALF) });
  Object.assign(pair.b, { y: 0, vx: speed, radius: RADIUS, bounding_radius: RADIUS });
}

/** Return what a look at a place finds: nothing, a wall to be pushed back from, or one to be pushed on from. */
function look(pair, x) {
  pair.b.x = x;
  pair.run("look");
  return pair.manifold.count === 0 ? "free" : pair.manifold.nx < 0 ? "back" : "on";
}

/** Follow a ball step by step, until it is stopped or has left. Returns its places and how it ended. */
function followed(pair, first, way, reach) {
  const places = [];
  for (let x = first; x <= reach && places.length < MOST; x += way) {
    places.push(x);
    if (look(pair, x) === "back") return { places, isStopped: true };
  }
  return { places, isStopped: false };
}

/** Return the place at which the ball first touches the wall, from its time of impact. */
function touch(pair, { speed }) {
  look(pair, -FARTHEST);
  pair.found.duration = 9;
  pair.run("look_ahead");
  return -FARTHEST + speed * pair.found.time;
}

/** Draw in a strip, one step long, what becomes of a ball whose last step begins there. */
function drawStrip(pen, passes, left, way) {
  let from = 0;
  for (let k = 1; k <= STARTS; k++) {
    if (passes[k] === passes[from]) continue;
    const ends = [from, k].map((place) => [left + (place * way) / STARTS, STRIP]);
    pen.line(ends, { color: passes[from] ? "vermilion" : "blue", thick: passes[from] ? 5 : 13 });
    from = k;
  }
}

export default {
  program: "geometry",
  panels: [{ view: [-FARTHEST, FARTHEST, -0.98, 0.52], width: 640 }],
  numbers: {
    speed: { label: "speed of the ball, m/s", low: 2, high: 60, start: 30, step: 1 },
    thickness: { label: "thickness of the wall, m", low: 0.02, high: 1, start: 0.1, step: 0.02 },
    rate: { label: "steps a second", low: 30, high: 240, start: 60, step: 10 },
    phase: { label: "how far on the last step before the wall begins", low: 0, high: 0.99, start: 0.3, step: 0.01 },
  },
  handles: [
    {
      label: "Place of the ball before the wall: left and right arrow keys move it",
      at: ({ speed, rate, thickness, phase }) => [-RADIUS - thickness / 2 - (1 - phase) * (speed / rate), 0],
      moved: ({ speed, rate, thickness }, [x]) => ({ phase: 1 + (x + RADIUS + thickness / 2) / (speed / rate) }),
      says: ({ phase }) => `${written(phase, 0.01)} of a step before the last one`,
      step: 0.005,
    },
  ],

  draw(pair, values, pen) {
    const { speed, thickness, rate, phase } = values;
    placed(pair, values);
    const way = speed / rate;
    const contact = touch(pair, values);
    const last = contact - (1 - phase) * way; // the last place before the wall
    const { places, isStopped } = followed(pair, last, way, FARTHEST);
    const passes = Array.from({ length: STARTS }, (_, k) => {
      const from = contact - way + ((k + 0.5) * way) / STARTS;
      return !followed(pair, from, way, thickness + RADIUS).isStopped;
    });
    drawStrip(pen, passes, contact - way, way);
    pen.polygon([[-thickness / 2, -0.4], [thickness / 2, -0.4], [thickness / 2, 0.4], [-thickness / 2, 0.4]], { thick: 1.5 });
    for (let x = last - way; x > -FARTHEST + RADIUS; x -= way) pen.circle([x, 0], RADIUS, { color: "blue", thick: 1.5 });
    places.forEach((x) => {
      if (x < FARTHEST - RADIUS) pen.circle([x, 0], RADIUS, { color: isStopped && x === places.at(-1) ? "green" : "blue", thick: 1.5 });
    });
    pen.circle([contact, 0], RADIUS, { filled: false, thick: 2, dashed: true });
    pen.line([[last, -RADIUS], [last, STRIP]], { color: "grey", thick: 1, dashed: true });
    pen.text([contact - way, STRIP], "thick: from here it is stopped; thin: it gets through", { anchor: "start", size: 13, shift: [0, 24] });
    pen.text([contact, 0.44], "first touch", { size: 13, anchor: "end", shift: [-4, 6] });
    pen.line([[contact, 0.4], [contact, RADIUS]], { color: "grey", thick: 1 });
    const law = Math.max(0, 1 - (RADIUS + thickness / 2) / way);
    const share = `From ${passes.filter((through) => through).length} of ${STARTS} places it gets through; the law says ${written(100 * law, 1)} %.`;
    return `A step is ${written(way, 0.001)} m long. ${isStopped ? "This ball is stopped" : "This ball gets through the wall"}. ${share}`;
  },
};
