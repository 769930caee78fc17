// A velocity that meets a wall, and what becomes of it: by the bounce, and by e times the mirror image.

const radians = (degrees) => (degrees * Math.PI) / 180;
const speed = ([x, y]) => Math.hypot(x, y).toFixed(2);

export default {
  program: "formulas",
  panels: [{ view: [-6.5, 6.5, -3.6, 6], width: 520 }],
  numbers: {
    vx: { label: "I along x, m/s", low: -5, high: 5, start: 3, step: 0.1 },
    vy: { label: "I along y, m/s", low: -5, high: 5, start: -3, step: 0.1 },
    tilt: { label: "tilt of the wall, degrees", low: -40, high: 40, start: 0, step: 1 },
    e: { label: "restitution e", low: 0, high: 1, start: 0.5, step: 0.05 },
  },
  handles: [
    {
      label: "Where I begins: arrow keys move it",
      at: ({ vx, vy }) => [-vx, -vy],
      moved: (_, [x, y]) => ({ vx: -x, vy: -y }),
    },
  ],

  draw(lesson, { vx, vy, tilt, e }, pen) {
    const v = [vx, vy];
    const normal = [Math.sin(radians(tilt)), Math.cos(radians(tilt))];
    const after = lesson.bounce(v, normal, e);
    const wrong = lesson.scaled_reflection(v, normal, e);
    pen.wall([0, 0], normal, 5);
    pen.arrow([-vx, -vy], v);
    pen.text([-vx, -vy], "I", { shift: [0, -20], bold: true });
    pen.arrow([0, 0], normal.map((x) => 1.6 * x), { name: "N", color: "grey" });
    pen.arrow([0, 0], wrong, { name: "e R", color: "vermilion", dashed: true });
    pen.arrow([0, 0], after, { name: "bounce", color: "blue" });
    const leaves = v[0] * normal[0] + v[1] * normal[1] >= 0;
    return leaves
      ? `The velocity leads away from the wall: the bounce leaves it alone, at ${speed(after)} m/s.`
      : `In at ${speed(v)} m/s, out at ${speed(after)} m/s by the bounce, at ${speed(wrong)} m/s by e R.`;
  },
};
