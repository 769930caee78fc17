// Two polygons, every axis of the separating axis test, and the shortest way out.

import { written } from "../../view/browser/figure.js";

const BOX = [[-1.3, -0.65], [1.3, -0.65], [1.3, 0.65], [-1.3, 0.65]]; // m, A's corners
const TRIANGLE = [[-2 / 3, -1.3 / 3], [1.6 - 2 / 3, -1.3 / 3], [0.4 - 2 / 3, 2.6 / 3]]; // B's
const TILT = 15; // degrees, of A
const FOOT = 2.5; // m: how far from the middle the shadows of the axis that decides are drawn
const ALIKE = 1e-9; // of a cross product of unit vectors: parallel but for rounding

const radians = (degrees) => (degrees * Math.PI) / 180;
const metres = (value) => written(Math.abs(value), 0.01);
const out = (depth) => (depth < 0 ? `a gap of ${metres(depth)} m` : depth === 0 ? "shadows that touch" : `out after ${metres(depth)} m`);

/** Put the shapes into the tables of the program, and let it look for the overlap. */
function look(pair, { x, y, angle }) {
  pair.corners.resize(BOX.length + TRIANGLE.length);
  [...BOX, ...TRIANGLE].forEach(([local_x, local_y], k) => Object.assign(pair.corners.at(k), { local_x, local_y }));
  pair.axes.resize(pair.corners.length);
  Object.assign(pair.a, { angle: radians(TILT), first_corner: 0, corner_count: BOX.length });
  Object.assign(pair.b, { x, y, angle: radians(angle), first_corner: BOX.length, corner_count: TRIANGLE.length });
  pair.run("look");
}

/** Return the corners of a shape where it is. */
function corners(pair, shape) {
  const indices = Array.from({ length: shape.corner_count }, (_, k) => shape.first_corner + k);
  return indices.map((k) => [shape.x + pair.corners.at(k).x, shape.y + pair.corners.at(k).y]);
}

/** Return the different axes with their names: parallel edges of one polygon share one. */
function axes(pair) {
  const kept = [];
  for (const [letter, shape] of [["A", pair.a], ["B", pair.b]]) {
    let count = 0;
    for (let k = shape.first_corner; k < shape.first_corner + shape.corner_count; k++) {
      const { nx, ny, low_a, high_a, low_b, high_b } = pair.axes.at(k);
      const same = kept.find((axis) => axis.letter === letter && Math.abs(axis.nx * ny - axis.ny * nx) < ALIKE);
      if (same) same.edges.push(k);
      else {
        const depth = Math.min(high_a - low_b, high_b - low_a);
        kept.push({ letter, name: `${letter}${++count}`, edges: [k], nx, ny, low_a, high_a, low_b, high_b, depth });
      }
    }
  }
  return kept;
}

/** Draw the shadows of both polygons on an axis beside them. */
function shadows(pen, axis, a, b) {
  const n = [axis.nx, axis.ny];
  const across = axis.nx > 0 || (axis.nx === 0 && axis.ny < 0) ? [axis.ny, -axis.nx] : [-axis.ny, axis.nx];
  const at = (along, foot) => [along * n[0] + foot * across[0], along * n[1] + foot * across[1]];
  pen.line([at(-3, FOOT), at(3, FOOT)], { color: "grey", thick: 1.5 });
  pen.text(at(2.6, FOOT + 0.3), axis.name, { shift: [0, 5], bold: true });
  for (const [name, corners, low, high, color, foot] of [
    ["A", a, axis.low_a, axis.high_a, "blue", FOOT - 0.1],
    ["B", b, axis.low_b, axis.high_b, "vermilion", FOOT - 0.28],
  ]) {
    const along = corners.map(([x, y]) => x * n[0] + y * n[1]);
    for (const end of [Math.min(...along), Math.max(...along)])
      pen.line([corners[along.indexOf(end)], at(end, foot)], { color, thick: 1, "stroke-dasharray": "2 4" });
    pen.line([at(low, foot), at(high, foot)], { color, thick: 7 });
    pen.text(at(name === "A" ? low - 0.15 : high + 0.15, foot), name, { shift: [0, 4], size: 12 });
  }
}

/** Draw a row for each axis: both shadows as bars, and what they show. */
function rows(pen, found, decides) {
  found.forEach((axis, k) => {
    const [y, bold] = [found.length - k, axis === decides];
    pen.text([-3.4, y], axis.name, { anchor: "start", bold, shift: [0, -4] });
    const bar = (name, low, high, top, color) => {
      pen.polygon([[low, y + top], [high, y + top], [high, y + top - 0.2], [low, y + top - 0.2]], { color, thick: 1.5 });
      pen.text([low, y + top - 0.1], name, { shift: [-6, 4], anchor: "end", size: 11 });
    };
    bar("A", axis.low_a, axis.high_a, 0.32, "blue");
    bar("B", axis.low_b, axis.high_b, 0.1, "vermilion");
    pen.text([-3.4, y], out(axis.depth), { anchor: "start", bold, shift: [0, 23], size: 13 });
  });
}

export default {
  program: "geometry",
  panels: [
    { view: [-3.4, 3.4, -3.1, 2.7], width: 400 },
    { view: [-3.6, 3.6, 0.35, 5.6], width: 220, height: 341 },
  ],
  gap: 20,
  numbers: {
    x: { label: "x of B, m", low: -2.2, high: 2.2, start: 1, step: 0.01 },
    y: { label: "y of B, m", low: -1.8, high: 1.8, start: 0.6, step: 0.01 },
    angle: { label: "angle of B, degrees", low: -180, high: 180, start: 20, step: 1 },
  },
  handles: [
    {
      label: "B: arrow keys move it",
      at: ({ x, y }) => [x, y],
      moved: (_, [x, y]) => ({ x, y }),
      step: 0.01,
    },
    {
      label: "Handle that turns B",
      at: ({ x, y, angle }) => [x + 0.95 * Math.cos(radians(angle)), y + 0.95 * Math.sin(radians(angle))],
      moved: ({ x, y }, [toX, toY]) => ({ angle: Math.round((Math.atan2(toY - y, toX - x) * 180) / Math.PI) }),
      says: ({ angle }) => `${written(angle, 1)} degrees`,
      step: 0.05,
    },
  ],

  draw(pair, values, scene, list) {
    look(pair, values);
    const [a, b] = [corners(pair, pair.a), corners(pair, pair.b)];
    const found = axes(pair);
    const decides = found.find((axis) => axis.edges.includes(pair.found.edge));
    scene.polygon(a, { color: "blue" });
    scene.polygon(b, { color: "vermilion" });
    scene.text([-0.5, 0], "A", { shift: [0, 5], bold: true });
    scene.text([pair.b.x, pair.b.y], "B", { shift: [0, 5], bold: true });
    shadows(scene, decides, a, b);
    rows(list, found, decides);
    const { overlap, nx, ny } = pair.found;
    if (!(pair.manifold.count > 0))
      return `No overlap. Axis ${decides.name} shows ${out(Math.min(decides.depth, 0))}.`;
    const away = ([x, y]) => [x + overlap * nx, y + overlap * ny];
    scene.polygon(b.map(away), { color: "vermilion", filled: false, dashed: true });
    const deepest = b.reduce((best, at) => (at[0] * nx + at[1] * ny < best[0] * nx + best[1] * ny ? at : best));
    scene.arrow(deepest, [overlap * nx, overlap * ny]);
    const way = `(${written(nx, 0.01)}, ${written(ny, 0.01)})`;
    return `Overlap. The shortest way for B out of A is ${metres(overlap)} m along ${way}, on axis ${decides.name}.`;
  },
};
