// A disc that spins is thrown onto a rough floor: its path, and how each bounce trades spin for speed.

import { scene } from "../../view/browser/world.js";
import { written } from "../../view/browser/figure.js";

const STEPS = 150; // of 1/60 s
const RADIUS = 0.3; // m
const SHOWN = 0.4; // s: an arrow is the way made in this time
const [LEFT, RIGHT] = [-3.5, 4]; // m, that is seen

export default {
  program: "sequential",
  panels: [{ view: [LEFT, RIGHT, -0.25, 3], width: 640 }],
  numbers: {
    restitution: { label: "restitution", low: 0, high: 1, start: 0.8, step: 0.01 },
    friction: { label: "friction", low: 0, high: 1, start: 0.4, step: 0.01 },
    spin: { label: "spin, rad/s, counter-clockwise", low: -30, high: 30, start: 15, step: 1 },
    height: { label: "height of the centre, m", low: 0.4, high: 2.7, start: 2, step: 0.1 },
    vx: { label: "velocity along x, m/s", low: -5, high: 5, start: 1.5, step: 0.1 },
    vy: { label: "velocity along y, m/s", low: -5, high: 3, start: 0, step: 0.1 },
  },
  handles: [
    {
      label: "The disc: up and down arrow keys move it",
      at: ({ height }) => [0, height],
      moved: (_, [, y]) => ({ height: y }),
      says: ({ height }) => `${written(height, 0.1)} metres high`,
    },
    {
      label: "Tip of its velocity",
      at: ({ height, vx, vy }) => [SHOWN * vx, height + SHOWN * vy],
      moved: ({ height }, [x, y]) => ({ vx: x / SHOWN, vy: (y - height) / SHOWN }),
      says: ({ vx, vy }) => `${written(vx, 0.1)}, ${written(vy, 0.1)} metres a second`,
      step: 0.04,
    },
  ],

  draw(program, { restitution, friction, spin, height, vx, vy }, pen) {
    const surface = { restitution, friction };
    const world = scene(program, {
      gravity: [0, -9.81],
      bodies: [
        { segment: [[-90, 0], [90, 0]], ...surface },
        { circle: RADIUS, mass: 1, position: [0, height], velocity: [vx, vy], angular_velocity: spin, ...surface },
      ],
    });
    const disc = world.bodies[1];
    const states = [{ x: disc.x, y: disc.y, angle: disc.angle, vx, w: spin }];
    const bounces = []; // the states right after one begins
    let touched = false;
    for (let step = 1; step <= STEPS; step++) {
      world.step();
      const state = { x: disc.x, y: disc.y, angle: disc.angle, vx: disc.vx, w: disc.w };
      if (world.impulses.length && !touched) bounces.push(state);
      touched = world.impulses.length > 0;
      states.push(state);
    }
    const first = bounces[0];
    const isSeen = ({ x, y }) => x > LEFT + RADIUS && x < RIGHT - RADIUS && y < 3;
    pen.polygon([[LEFT, 0], [RIGHT, 0], [RIGHT, -0.2], [LEFT, -0.2]], { color: "grey", thick: 0 });
    pen.line([[LEFT, 0], [RIGHT, 0]]);
    const end = states.findIndex((state) => !isSeen(state));
    const seen = end < 0 ? states : states.slice(0, end);
    pen.line(seen.map(({ x, y }) => [x, y]), { color: "blue" });
    drawDisc(pen, states[0], {});
    for (const state of bounces.slice(0, 4).filter((state) => seen.includes(state))) drawDisc(pen, state, { filled: false, dashed: true });
    drawDisc(pen, seen.at(-1), {});
    pen.arrow([0, height], [SHOWN * vx, SHOWN * vy], { color: "vermilion" });
    const said = (v, w) => `${written(v, 0.01)} m/s along the floor and ${written(w, 0.1)} rad/s`;
    const after = first ? ` The first bounce makes ${said(first.vx, first.w)} of it.` : " It does not reach the floor.";
    const slip = first && Math.abs(first.vx + RADIUS * first.w) < 0.005 ? " It sticks there: the point that touches stands still." : first ? " It slips all through it." : "";
    return `The disc comes with ${said(vx, spin)}.${after}${slip}`;
  },
};

/** Draw the disc with a line that shows how it has turned. */
function drawDisc(pen, { x, y, angle }, style) {
  pen.circle([x, y], RADIUS, { color: "blue", thick: 1.5, ...style });
  pen.line([[x, y], [x + RADIUS * Math.cos(angle), y + RADIUS * Math.sin(angle)]], { color: "blue", thick: 1.5 });
}
