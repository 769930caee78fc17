// The part of I along the normal, taken away once and twice; the normal need not have length 1.

const radians = (degrees) => (degrees * Math.PI) / 180;
const components = ([x, y]) => `(${x.toFixed(2)}, ${y.toFixed(2)})`;

export default {
  program: "formulas",
  panels: [{ view: [-7, 7, -5.6, 6], width: 520 }],
  numbers: {
    vx: { label: "I along x, m/s", low: -5, high: 5, start: 2, step: 0.1 },
    vy: { label: "I along y, m/s", low: -5, high: 5, start: -4, step: 0.1 },
    tilt: { label: "tilt of the wall, degrees", low: -40, high: 40, start: 20, step: 1 },
    times: { label: "times (I·N)N is taken away", low: 0, high: 2, start: 2, step: 0.1 },
    length: { label: "length of N", low: 0.5, high: 1.5, start: 1, step: 0.05 },
  },
  handles: [
    {
      label: "Where I begins: arrow keys move it",
      at: ({ vx, vy }) => [-vx, -vy],
      moved: (_, [x, y]) => ({ vx: -x, vy: -y }),
    },
  ],

  draw(lesson, { vx, vy, tilt, times, length }, pen) {
    const [v, unit] = [[vx, vy], [Math.sin(radians(tilt)), Math.cos(radians(tilt))]];
    const normal = unit.map((part) => length * part);
    const twice = lesson.reflect(v, normal);
    const without = (count) => v.map((part, k) => part + (count / 2) * (twice[k] - part));
    const after = without(times);
    pen.wall([0, 0], unit, 5);
    pen.arrow([-vx, -vy], v);
    pen.text([-vx, -vy], "I", { shift: [0, -20], bold: true });
    pen.line([[0, 0], v], { color: "grey", dashed: true });
    pen.line([v, twice], { color: "vermilion", dashed: true });
    for (const [count, name] of [[1, "once"], [2, "twice"]]) {
      pen.dot(without(count), { color: "vermilion" });
      pen.text(without(count), name, { shift: [12, -6], anchor: "start", size: 13 });
    }
    pen.arrow([0, 0], normal.map((part) => 1.6 * part), { name: "N", color: "grey" });
    pen.arrow([0, 0], after, { color: "blue" });
    const speeds = [v, after].map(([x, y]) => Math.hypot(x, y));
    const keeps = Math.abs(speeds[0] - speeds[1]) < 5e-3 ? "as fast as before" : "not as fast as before";
    return (
      `I = ${components(v)}; ${times.toFixed(1)} times (I·N)N taken away leaves ` +
      `${components(after)} m/s: ${speeds[1].toFixed(2)} m/s, ${keeps}.`
    ).replaceAll("-", "\u2212");
  },
};
