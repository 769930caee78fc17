// Disc 1 comes along x and hits disc 2, which is at rest: where it is hit decides where both go.

import { written } from "../../view/browser/figure.js";

const SPEED = 3; // m/s, of disc 1
const SHOWN = 0.5; // s: an arrow is the way made in this time
const RIGHT = 1e-9; // of the product of two speeds: far above rounding (1e-16)
const radius = (mass) => 0.4 * Math.sqrt(mass); // m; both are cut from one plate
const times = (factor, [x, y]) => [factor * x, factor * y];
const plus = ([x, y], [dx, dy]) => [x + dx, y + dy];

/** Return the unit vector that is farthest from some directions, and does not point to the contact. */
function free(lesson, taken, contact) {
  const units = taken.filter((way) => Math.hypot(...way) > 1e-9).map((way) => times(1 / Math.hypot(...way), way));
  const nearness = (way) => Math.max(...units.map((unit) => lesson.dot(unit, way)));
  const turns = Array.from({ length: 24 }, (_, k) => [Math.cos((k * Math.PI) / 12), Math.sin((k * Math.PI) / 12)]);
  const ways = turns.filter((way) => lesson.dot(way, contact) < 0.2);
  return ways.reduce((best, way) => (nearness(way) < nearness(best) - 1e-9 ? way : best));
}

/** Draw a disc with its number, its velocity before (dashed) and after. */
function disc(lesson, pen, [number, color], centre, size, [before, after], contact) {
  pen.circle(centre, size, { color });
  const comes = times(-SHOWN, before);
  if (Math.hypot(...comes) > 0) pen.arrow(plus(centre, comes), times(-1, comes), { color, dashed: true });
  pen.arrow(centre, times(SHOWN, after), { color });
  const place = plus(centre, times(size + 0.15, free(lesson, [comes, after, contact, times(-1, contact)], contact)));
  pen.text(place, number, { shift: [0, 5], bold: true });
}

const moves = (speed) => (speed < 1e-9 ? "stops" : `leaves at ${written(speed, 0.01)} m/s`);

export default {
  program: "formulas",
  panels: [{ view: [-2.9, 4.3, -2.6, 2.6], width: 600 }],
  numbers: {
    offset: { label: "offset, in r1 + r2", low: -1, high: 1, start: 0.5, step: 0.01 },
    m1: { label: "mass of disc 1, kg", low: 0.5, high: 4, start: 1, step: 0.5 },
    m2: { label: "mass of disc 2, kg", low: 0.5, high: 4, start: 1, step: 0.5 },
    e: { label: "restitution e", low: 0, high: 1, start: 1, step: 0.05 },
  },
  handles: [
    {
      label: "Centre of disc 2: arrow keys move it round disc 1",
      at: ({ offset, m1, m2 }) => times(radius(m1) + radius(m2), [Math.sqrt(1 - offset * offset), offset]),
      moved: (_, [x, y]) => ({ offset: Number((y / Math.hypot(Math.max(x, 0), y) || 0).toFixed(2)) }),
      says: ({ offset }) => `offset ${written(offset, 0.01)}`,
      step: 0.05,
    },
  ],

  draw(lesson, { offset, m1, m2, e }, pen) {
    const n = [Math.sqrt(1 - offset * offset), offset];
    const [v1, v2] = [[SPEED, 0], [0, 0]];
    const impulse = lesson.smooth_impulse(v1, m1, v2, m2, n, e);
    const [after1, after2] = [plus(v1, times(-1 / m1, impulse)), times(1 / m2, impulse)];
    const lost = lesson.energy_lost_1d(m1, lesson.dot(v1, n), m2, lesson.dot(v2, n), e);
    const before = (m1 * SPEED * SPEED) / 2;
    const contact = times(radius(m1), n);
    const across = offset < 0 ? [offset, -n[0]] : [-offset, n[0]]; // away from where disc 1 goes
    pen.line([plus(contact, times(1.6, across)), plus(contact, times(-1.6, across))], { thick: 1, color: "grey" });
    disc(lesson, pen, ["1", "blue"], [0, 0], radius(m1), [v1, after1], n);
    const centre = times(radius(m1) + radius(m2), n);
    disc(lesson, pen, ["2", "orange"], centre, radius(m2), [v2, after2], times(-1, n));
    pen.arrow(plus(contact, times(1.45, across)), times(0.5, n), { name: "n", color: "grey" });
    const [one, two] = [after1, after2].map((velocity) => Math.hypot(...velocity));
    const isRight = one > 1e-9 && two > 1e-9 && Math.abs(lesson.dot(after1, after2)) < RIGHT * one * two;
    if (isRight) {
      const [side, up] = [times(0.18 / one, after1), times(0.18, n)];
      pen.line([side, plus(side, up), up], { thick: 1.5 });
    }
    pen.legend([-2.9, 2.6], [["before", { dashed: true }], ["after", {}]]);
    const left = `Of ${written(before, 0.01)} J, ${written(before - lost, 0.01)} J are left.`;
    if (two < 1e-9) return `Disc 1 only grazes disc 2: nothing changes. ${left}`;
    const angle = (Math.abs(Math.atan2(lesson.cross(after1, after2), lesson.dot(after1, after2))) * 180) / Math.PI;
    const between = one < 1e-9 ? "" : isRight ? ", at a right angle" : `, ${written(angle, 0.1)}° apart`;
    return `Disc 1 ${moves(one)}, disc 2 ${moves(two)} along n${between}. ${left}`;
  },
};
