// Two boxes that overlap, and what the clipping makes of them, step by step: from the normal to the contacts.

import { written } from "../../view/browser/figure.js";

const A = [[-1.5, -0.5], [1.5, -0.5], [1.5, 0.5], [-1.5, 0.5]]; // m
const B = [[-1, -0.5], [1, -0.5], [1, 0.5], [-1, 0.5]];
const LONG = 1.1; // m: how far the lines reach at which an edge is cut
const STEPS = ["shapes and normal", "reference edge", "incident edge", "cut at one end", "cut at the other end", "contact points"];

const rad = (degrees) => (degrees * Math.PI) / 180;
const metres = (value) => `${written(value, 0.01)} m`;
const spot = ([x, y]) => `(${written(x, 0.01)}, ${written(y, 0.01)})`;

/** Put both boxes into the tables of the program, let it look, and return what each step has found. */
function clipped(pair, { x, y, angle }) {
  pair.corners.resize(A.length + B.length);
  [...A, ...B].forEach(([local_x, local_y], k) => Object.assign(pair.corners.at(k), { local_x, local_y }));
  pair.axes.resize(pair.corners.length);
  Object.assign(pair.a, { first_corner: 0, corner_count: A.length });
  Object.assign(pair.b, { x, y, angle: rad(angle), first_corner: A.length, corner_count: B.length });
  pair.run("look");
  const { found, cut, measured, manifold } = pair;
  const corner = (shape, k) => [shape.x + pair.corners.at(k).x, shape.y + pair.corners.at(k).y];
  const outline = (shape) => Array.from({ length: shape.corner_count }, (_, k) => corner(shape, shape.first_corner + k));
  const edge = (shape, k) => [corner(shape, k), corner(shape, shape.first_corner + ((k + 1 - shape.first_corner) % shape.corner_count))];
  const shapes = { a: outline(pair.a), b: outline(pair.b) };
  if (!(manifold.count > 0)) return { ...shapes, isApart: true, gap: -found.overlap };
  const isOfA = found.is_of_a;
  const edges = { A: edge(pair.a, found.edge_a), B: edge(pair.b, found.edge_b) };
  const onB = [[x + cut.bx0, y + cut.by0], [x + cut.bx1, y + cut.by1]]; // the ends of the shared stretch
  const onA = [[cut.ax0, cut.ay0], [cut.ax1, cut.ay1]];
  return {
    ...shapes,
    n: [manifold.nx, manifold.ny],
    depth: found.overlap,
    reference: { name: isOfA ? "A" : "B", edge: isOfA ? edges.A : edges.B, color: isOfA ? "blue" : "vermilion" },
    incident: { name: isOfA ? "B" : "A", edge: isOfA ? edges.B : edges.A, color: isOfA ? "vermilion" : "blue" },
    kept: (isOfA ? onB : onA).slice(0, cut.count),
    facing: (isOfA ? onA : onB).slice(0, cut.count),
    depths: [measured.penetration0, measured.penetration1].slice(0, cut.count),
    contacts: manifold.count,
  };
}

/** Return the incident edge, its ends in the order in which its kept ends are. */
function ordered({ incident, kept, n }) {
  const along = ([x, y]) => y * n[0] - x * n[1];
  return [...incident.edge].sort((p, q) => along(p) - along(q)).map((end, k) => ({ end, kept: kept[Math.min(k, kept.length - 1)] }));
}

const isMoved = ({ end, kept }) => Math.hypot(end[0] - kept[0], end[1] - kept[1]) > 1e-9;

/** Draw the line through an end of the reference edge, along the normal, at which the other is cut. */
function cutLine(pen, { n, reference }, end) {
  const along = ([x, y]) => y * n[0] - x * n[1];
  const [x, y] = [...reference.edge].sort((p, q) => along(p) - along(q))[end];
  const at = (length) => [x + length * n[0], y + length * n[1]];
  pen.line([at(-LONG), at(LONG)], { color: "grey", thick: 1.5, dashed: true });
}

/** Draw the incident edge as it is after so many cuts; what is cut off is dotted. */
function drawIncident(pen, found, cuts) {
  const ends = ordered(found).map(({ end, kept }, k) => (k < cuts ? kept : end));
  pen.line(found.incident.edge, { color: found.incident.color, thick: 2, "stroke-dasharray": "2 5" });
  pen.line(ends, { color: found.incident.color, thick: 6 });
}

/** Draw where the contacts are: half way between both edges; hollow is what lies outside. */
function drawContacts(pen, { kept, facing, depths, n, reference }) {
  const inwards = reference.name === "A" ? -26 : 26; // pixels along n, into the reference shape
  kept.forEach(([x, y], k) => {
    const [toX, toY] = facing[k];
    pen.line([[x, y], [toX, toY]], { thick: 1.5 });
    const middle = [(x + toX) / 2, (y + toY) / 2];
    if (depths[k] > 0) pen.dot(middle);
    else pen.circle(middle, 0.05, { filled: false });
    pen.text(middle, depths[k] > 0 ? metres(depths[k]) : "outside", { shift: [inwards * n[0], 4 - inwards * n[1]], size: 13, bold: true });
  });
}

/** Return what each step says of its result, in a line. */
function results(found) {
  const { n, depth, reference, incident, depths, contacts } = found;
  const ends = ordered(found);
  const cut = (k) => (isMoved(ends[k]) ? `${spot(ends[k].end)} \u2192 ${spot(ends[k].kept)}` : `${spot(ends[k].end)} stays`);
  return [
    `n = ${spot(n)}, depth ${metres(depth)}`,
    `of ${reference.name}: ${reference.edge.map(spot).join(" to ")}`,
    `of ${incident.name}: ${incident.edge.map(spot).join(" to ")}`,
    cut(0),
    cut(1),
    `${contacts} of ${depths.length}: ${depths.map((d) => metres(d)).join(" and ")}`,
  ];
}

/** Say what a step has done. */
function told(step, found) {
  const { n, depth, reference, incident, depths, contacts } = found;
  const ends = ordered(found);
  const cut = (k) => (isMoved(ends[k]) ? `cuts: the end at ${spot(ends[k].end)} moves to ${spot(ends[k].kept)}.` : "cuts nothing off.");
  return [
    `B gets out of A by the shortest way along n = ${spot(n)}, ${metres(depth)} long.`,
    `The reference edge is the edge of ${reference.name} whose normal that is.`,
    `The incident edge is the edge of ${incident.name} that faces it most.`,
    `The line through one end of the reference edge ${cut(0)}`,
    `The line through its other end ${cut(1)}`,
    contacts === 2
      ? `Two contacts, with penetrations of ${depths.map(metres).join(" and ")}.`
      : `One contact, with a penetration of ${metres(Math.max(...depths))}${depths.length > 1 ? "; the other end lies outside" : ""}.`,
  ][step];
}

export default {
  program: "geometry",
  panels: [
    { view: [-2.4, 3, -1.1, 2.3], width: 480 },
    { view: [0, 1, 0, 1], width: 290, height: 320 },
  ],
  gap: 16,
  numbers: {
    step: { label: "step of the clipping", low: 1, high: 6, start: 4, step: 1, says: (k) => `${k}, ${STEPS[Math.round(k) - 1]}` },
    x: { label: "x of B, m", low: -2, high: 2.4, start: 1.3, step: 0.01 },
    y: { label: "y of B, m", low: -1.2, high: 1.6, start: 0.85, step: 0.01 },
    angle: { label: "angle of B, degrees", low: -180, high: 180, start: 13, step: 1 },
  },
  handles: [
    {
      label: "B: arrow keys move it",
      at: ({ x, y }) => [x, y],
      moved: (_, [x, y]) => ({ x, y }),
      says: ({ x, y }) => `x ${written(x, 0.01)}, y ${written(y, 0.01)} metres`,
      step: 0.01,
    },
    {
      label: "Handle that turns B",
      at: ({ x, y, angle }) => [x + 0.75 * Math.cos(rad(angle)), y + 0.75 * Math.sin(rad(angle))],
      moved: ({ x, y }, [toX, toY]) => ({ angle: Math.round((Math.atan2(toY - y, toX - x) * 180) / Math.PI) }),
      says: ({ angle }) => `${written(angle, 1)} degrees`,
      step: 0.05,
    },
  ],

  draw(pair, values, pen, list) {
    const found = clipped(pair, values);
    const step = Math.round(values.step) - 1;
    pen.polygon(found.a, { color: "blue" });
    pen.polygon(found.b, { color: "vermilion" });
    pen.text([-1.1, 0], "A", { shift: [0, 5], bold: true });
    pen.text([values.x, values.y], "B", { shift: [0, 5], bold: true });
    const lines = found.isApart ? STEPS.map(() => "") : results(found);
    STEPS.forEach((name, k) => {
      const reached = k <= step && !found.isApart;
      const y = 0.97 - k / 6;
      list.text([0, y], `${k + 1} ${name}`, { anchor: "start", bold: k === step, shift: [0, 4] });
      list.text([0, y], reached ? lines[k] : "\u2013", { anchor: "start", size: 13, shift: [14, 23] });
    });
    if (found.isApart) return `A and B lie ${metres(found.gap)} apart: there is nothing to clip, and no contact.`;
    if (step >= 1) pen.line(found.reference.edge, { color: found.reference.color, thick: 6 });
    if (step >= 3) cutLine(pen, found, 0);
    if (step >= 4) cutLine(pen, found, 1);
    if (step >= 2) drawIncident(pen, found, Math.max(0, Math.min(step - 2, 2)));
    if (step === 5) drawContacts(pen, found);
    const [[x0, y0], [x1, y1]] = found.reference.edge;
    const sign = found.reference.name === "A" ? 1 : -1;
    if (step < 5) pen.arrow([(x0 + x1) / 2, (y0 + y1) / 2], [0.6 * sign * found.n[0], 0.6 * sign * found.n[1]], { name: "n" });
    return told(step, found);
  },
};
