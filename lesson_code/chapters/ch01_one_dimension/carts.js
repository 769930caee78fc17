// Two carts before and after they meet, seen from the ground and from their centre of mass.

import { written } from "../../view/browser/figure.js";

const PLACES = [-4, 4]; // of the carts in each row; 1 unit is 1 m/s
const COLORS_OF = ["blue", "orange"];
const ROWS = { ground: [13, 9], centre: [4.2, 0.2] }; // the track's height, before and after
const BARS = [-3.1, -4.1]; // the same for momenta and energies
const ROOM = 9; // for the longest bar
const LEVEL = 0.45; // of arrows above the track

const signed = (value) => (value >= 0.005 ? "+" : "") + written(value, 0.01);
const sum = ([one, two]) => one + two;

/** Draw the carts on a track with their velocities. */
function row(pen, track, name, masses, velocities) {
  pen.line([[-13, track], [13, track]], { thick: 1, color: "grey" });
  pen.text([-13, track + 2.5], name, { anchor: "start", size: 13 });
  PLACES.forEach((place, k) => {
    const [half, color] = [0.5 * Math.cbrt(masses[k]), COLORS_OF[k]];
    const corners = [[-half, 0], [half, 0], [half, 2 * half], [-half, 2 * half]];
    pen.polygon(corners.map(([x, y]) => [place + x, track + y]), { color });
    pen.arrow([place, track + LEVEL], [velocities[k], 0], { color });
    pen.text([place, track + 2.5], `${k + 1}: ${signed(velocities[k])} m/s`, { size: 13 });
  });
}

/** Draw momenta tip to tail, before and after: both end at the same total. */
function momenta(pen, before, after) {
  const ends = [before, after].flatMap((pair) => [0, pair[0], sum(pair)]);
  const [low, high] = [Math.min(...ends), Math.max(...ends)];
  const unit = ROOM / Math.max(high - low, 1e-9);
  const at = (value) => -10.4 + unit * (value - low);
  [before, after].forEach((pair, k) => {
    pen.line([[at(0), BARS[k] + 0.35], [at(0), BARS[k] - 0.35]], { thick: 1 });
    pen.arrow([at(0), BARS[k] + 0.17], [unit * pair[0], 0], { color: "blue" });
    pen.arrow([at(pair[0]), BARS[k] - 0.17], [unit * pair[1], 0], { color: "orange" });
  });
  pen.line([[at(sum(before)), BARS[0] + 0.5], [at(sum(before)), BARS[1] - 0.5]], { thick: 1, dashed: true });
}

/** Draw energies as bars, before and after; what is lost is dashed. */
function energies(pen, before, after) {
  const unit = ROOM / Math.max(sum(before), 1e-9);
  const bar = (from, length, y, style) => {
    const corners = [[from, y - 0.3], [from + length, y - 0.3], [from + length, y + 0.3], [from, y + 0.3]];
    if (length * pen.scale > 1) pen.polygon(corners, style);
  };
  [before, after].forEach((pair, k) => {
    const [one, two] = pair.map((energy) => unit * energy);
    bar(3, one, BARS[k], { color: "blue" });
    bar(3 + one, two, BARS[k], { color: "orange" });
    bar(3 + one + two, unit * sum(before) - one - two, BARS[k], { color: "grey", dashed: true, filled: false });
  });
}

const speedOf = (velocity) => (Math.abs(velocity) < 1e-9 ? "stands still" : `has ${signed(velocity)} m/s`);

export default {
  program: "formulas",
  panels: [{ view: [-13.2, 13.2, -5.2, 17.7], width: 620 }],
  numbers: {
    m1: { label: "mass of cart 1, kg", low: 0.1, high: 10, start: 1, step: 0.1 },
    v1: { label: "velocity of cart 1, m/s", low: -3, high: 3, start: 2, step: 0.1 },
    m2: { label: "mass of cart 2, kg", low: 0.1, high: 10, start: 1, step: 0.1 },
    v2: { label: "velocity of cart 2, m/s", low: -3, high: 3, start: 0, step: 0.1 },
    e: { label: "restitution e", low: 0, high: 1, start: 1, step: 0.05 },
  },
  handles: PLACES.map((place, k) => ({
    label: `Tip of the velocity of cart ${k + 1}: arrow keys move it`,
    at: (values) => [place + values[`v${k + 1}`], ROWS.ground[0] + LEVEL],
    moved: (_, [x]) => ({ [`v${k + 1}`]: x - place }),
    says: (values) => `${signed(values[`v${k + 1}`])} m/s`,
  })),

  draw(lesson, { m1, v1, m2, v2, e }, pen) {
    const [masses, before] = [[m1, m2], [v1, v2]];
    const meet = v1 > v2; // cart 1 is on the left
    const after = meet ? lesson.collide_1d(m1, v1, m2, v2, e) : before;
    const centre = lesson.inelastic_1d(m1, v1, m2, v2)[0];
    const seen = (velocities) => velocities.map((velocity) => velocity - centre);
    pen.text([-13, 16.8], "seen from the ground", { anchor: "start", bold: true });
    row(pen, ROWS.ground[0], "before", masses, before);
    row(pen, ROWS.ground[1], "after", masses, after);
    pen.text([-13, 8], `seen from the centre of mass, which moves at ${signed(centre)} m/s`, { anchor: "start", bold: true });
    row(pen, ROWS.centre[0], "before", masses, seen(before));
    row(pen, ROWS.centre[1], "after", masses, seen(after));
    const momentum = (velocities) => velocities.map((velocity, k) => masses[k] * velocity);
    const energy = (velocities) => velocities.map((velocity, k) => (masses[k] * velocity * velocity) / 2);
    pen.text([-10.4, -1.9], "momenta, tip to tail", { anchor: "start", bold: true });
    pen.text([3, -1.9], "energies (dashed: lost)", { anchor: "start", bold: true });
    ["before", "after"].forEach((name, k) => pen.text([-13, BARS[k]], name, { shift: [0, 4], anchor: "start", size: 13 }));
    momenta(pen, momentum(before), momentum(after));
    energies(pen, energy(before), energy(after));
    const total = `${signed(sum(momentum(before)))} kg m/s`;
    const had = `${written(sum(energy(before)), 0.01)} J`;
    if (!meet) return `Cart 1 does not catch up with cart 2: they never meet. Momentum ${total} and energy ${had} stay as they are.`;
    return (
      `After: cart 1 ${speedOf(after[0])}, cart 2 ${speedOf(after[1])}. Momentum ${total} before and ` +
      `${signed(sum(momentum(after)))} kg m/s after. Energy ${had} before and ${written(sum(energy(after)), 0.01)} J after; ` +
      `lost: ${written(lesson.energy_lost_1d(m1, v1, m2, v2, e), 0.01)} J.`
    );
  },
};
