// A figure that answers while it is moved: by dragging, by keys, by sliders, by numbers typed in.
//
// A chapter describes one in a module of its own:
//
//   export default {
//     program: "formulas",  // what computes: one of programs/; or programs: ["formulas", "exact"]
//     panels: [{ view: [-5, 5, -2, 4], width: 480 }],  // left, right, bottom, top; pixels
//     numbers: { e: { label: "restitution e", low: 0, high: 1, start: 0.5, step: 0.05 } },
//     handles: [{ label: "tip of the velocity", panel: 0, at, moved, says, step }],
//     draw(lesson, values, pen) { ... return "what can be seen, in words"; },
//   };
//
// `numbers` can be changed by slider and keyboard. One with `names`, in place of a range, is chosen
// from a list: its value is the place in it. A handle can be dragged, or moved by arrow keys in
// steps of `step`: `at(values)` says where it is, and `moved(values, [x, y])` what changes when it is
// put somewhere. A screen reader is told its place, or the words of `says(values)` instead.
// `draw` is called after each change; `lesson` holds the compiled functions of the course
// (program.js), or each of several programs by its name; one pen for each panel follows. Nothing
// else decides what is seen. On a narrow screen the panels stand one below the other, and letters,
// arrowheads and handles keep a size that can be read and touched.
//
// What a figure imports from this folder comes with it: world.js steps a scene.

const MARGIN = 14; // pixels between panels
const NARROW = 0.75; // of the drawing's width: with less room its panels stand one below the other
const GRIP = 14; // pixels: the radius of a handle
const LEAST = 0.86; // of their size: how small letters may become where the drawing has to shrink
const TIP = 9; // pixels: the length of an arrow's head
const QUIET = 400; // ms without a change, after which a screen reader is told what can be seen
const COLORS = ["blue", "orange", "green", "vermilion", "purple", "sky"]; // of the palette
const OURS = { "data-lm-suppress-shortcuts": "true" }; // makes JupyterLab leave the keys to us

/** Write a number with a true minus sign, and decimals as a step has them. */
export function written(value, step) {
  const decimals = (String(step).split(".")[1] ?? "").length;
  return value.toFixed(decimals).replace(/^-(0\.?0*)$/, "$1").replace("-", "\u2212");
}

const clamped = (value, low, high) => Math.min(Math.max(value, low), high);
const near = (value, step) => Number((Math.round(value / step) * step).toFixed(9));
const escaped = (words) => words.replace(/[&<>"]/g, (letter) => `&#${letter.charCodeAt(0)};`);

/** Draws in the units of one panel, x to the right and y upwards. */
class Pen {
  constructor(panel, left, top, zoom) {
    const [west, east, south, north] = panel.view;
    this.view = panel.view;
    this.scale = panel.width / (east - west);
    this.scaleY = panel.height ? panel.height / (north - south) : this.scale;
    Object.assign(this, { left, top, zoom, width: panel.width, height: this.scaleY * (north - south) });
    this.parts = [];
  }

  x = (value) => this.left + (value - this.view[0]) * this.scale;
  y = (value) => this.top + (this.view[3] - value) * this.scaleY;
  place = ([x, y]) => `${this.x(x).toFixed(1)} ${this.y(y).toFixed(1)}`;

  /** Put an element there, in a colour of the palette or in ink. */
  put(kind, attributes, words) {
    const { color = "ink", dashed = false, ...others } = attributes;
    const given = { ...others, ...(dashed ? { "stroke-dasharray": "6 4" } : {}) };
    const listed = Object.entries(given).map(([name, value]) => ` ${name}="${value}"`);
    const told = words === undefined ? "" : escaped(words);
    this.parts.push(`<${kind} class="${color}"${listed.join("")}>${told}</${kind}>`);
  }

  line(points, { thick = 2, ...style } = {}) {
    const d = "M" + points.map(this.place).join("L");
    this.put("path", { d, fill: "none", "stroke-width": thick, ...style });
  }

  polygon(points, { thick = 2, filled = true, ...style } = {}) {
    const d = `M${points.map(this.place).join("L")}Z`;
    this.put("path", { d, "stroke-width": thick, ...(filled ? {} : { fill: "none" }), ...style });
  }

  circle([x, y], radius, { thick = 2, filled = true, ...style } = {}) {
    const [cx, cy, r] = [this.x(x), this.y(y), radius * this.scale].map((v) => v.toFixed(1));
    this.put("circle", { cx, cy, r, "stroke-width": thick, ...(filled ? {} : { fill: "none" }), ...style });
  }

  dot([x, y], style = {}) {
    this.put("circle", { cx: this.x(x).toFixed(1), cy: this.y(y).toFixed(1), r: 3.5, fill: "var(--c)", ...style });
  }

  /** Draw an arrow; its name stands beyond its tip. One that has no length is a dot. */
  arrow(from, [vx, vy], { name = "", thick = 2.5, ...style } = {}) {
    const to = [from[0] + vx, from[1] + vy];
    const [dx, dy] = [vx * this.scale, -vy * this.scaleY];
    const length = Math.hypot(dx, dy);
    if (length < 1) this.dot(from, style);
    else {
      const [ux, uy] = [dx / length, dy / length];
      const [x, y] = [this.x(to[0]), this.y(to[1])];
      const head = Math.min(TIP * this.zoom, length);
      const wing = (side) =>
        `${(x - head * (ux - 0.5 * side * uy)).toFixed(1)} ${(y - head * (uy + 0.5 * side * ux)).toFixed(1)}`;
      const d = `M${this.place(from)}L${this.place(to)}M${wing(1)}L${this.place(to)}L${wing(-1)}`;
      this.put("path", { d, fill: "none", "stroke-width": thick, ...style });
      if (name) this.beside(to, [ux, uy], name);
    }
  }

  /** Write a name beyond the tip of an arrow that points along (ux, uy), in pixels. */
  beside(tip, [ux, uy], name) {
    const anchor = ux > 0.35 ? "start" : ux < -0.35 ? "end" : "middle";
    this.text(tip, name, { shift: [8 * ux, 8 * uy + (uy > 0 ? 10 : 0) + 3], anchor, bold: true });
  }

  /** Write words at a place, shifted by some pixels. They are always in ink. */
  text([x, y], words, { shift = [0, 0], anchor = "middle", bold = false, size = 14 } = {}) {
    const [right, down] = shift.map((pixels) => pixels * this.zoom);
    const place = { x: (this.x(x) + right).toFixed(1), y: (this.y(y) + down).toFixed(1) };
    const weight = bold ? { "font-weight": "bold" } : {};
    this.put("text", { ...place, "text-anchor": anchor, "font-size": size * this.zoom, ...weight }, words);
  }

  /** Say below a place, line by line, what lines of some style are: [[name, style], ...]. */
  legend([x, y], lines) {
    const at = (right, down) => [x + (right * this.zoom) / this.scale, y - (down * this.zoom) / this.scaleY];
    lines.forEach(([name, style], row) => {
      this.line([at(0, 18 * row + 10), at(28, 18 * row + 10)], style);
      this.text(at(36, 18 * row + 14), name, { anchor: "start", size: 13 });
    });
  }

  /** Draw a wall at a place, its unit normal pointing out of it. */
  wall([x, y], [nx, ny], half) {
    const at = (along, deep) => [x - along * ny - deep * nx, y + along * nx - deep * ny];
    const count = 12;
    for (let k = 0; k <= count; k++) {
      const along = -half + (2 * half * k) / count;
      this.line([at(along, 0), at(along - half / count, (1.2 * half) / count)], { thick: 1, color: "grey" });
    }
    this.line([at(-half, 0), at(half, 0)]);
  }

  /** Draw axes at the left and at the bottom, with numbers and names; one without a name has no numbers.
   *  An axis in `powers` ("x", "y" or "xy") runs over powers of ten. */
  axes(nameX, nameY, powers = "") {
    const [west, east, south, north] = this.view;
    this.line([[west, north], [west, south], [east, south]], { thick: 1, color: "grey" });
    for (const [value, words] of nameX ? marks(west, east, powers.includes("x")) : [])
      this.text([value, south], words, { shift: [0, 17], size: 12 });
    for (const [value, words] of marks(south, north, powers.includes("y")))
      this.text([west, value], words, { shift: [-6, 4], anchor: "end", size: 12 });
    this.text([(west + east) / 2, south], nameX, { shift: [0, 36], size: 13 });
    this.text([west, north], nameY, { shift: [0, -10], anchor: "start", size: 13 });
  }
}

function tickStep(low, high) {
  const rough = (high - low) / 5;
  const power = 10 ** Math.floor(Math.log10(rough));
  return near(power * [1, 2, 5, 10].find((nice) => nice * power >= rough), power);
}

/** Return the numbers that an axis shows, and how they are written; or exponents, as powers of ten. */
function marks(low, high, arePowers) {
  const step = Math.max(tickStep(low, high), arePowers ? 1 : 0);
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) {
    const value = near(k * step, step);
    found.push([value, arePowers ? power(value) : written(value, step)]);
  }
  return found;
}

/** Write a power of ten, as a number where that is short. */
export function power(exponent) {
  if (Math.abs(exponent) < 4) return written(10 ** exponent, 10 ** Math.min(exponent, 0));
  return "10" + [...String(exponent)].map((sign) => (sign === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[sign])).join("");
}

const STYLE = `
  [data-live] { max-width: 100%; margin: 0; font: 14px/1.4 sans-serif; }
  [data-live] svg { display: block; max-width: 100%; height: auto; touch-action: pan-y; overflow: visible; }
  [data-live] :is(g, g *) { stroke: var(--c); stroke-linejoin: round; }
  [data-live] .ink { --c: currentColor; }
  [data-live] .grey { --c: color-mix(in srgb, currentColor 55%, transparent); }
  ${COLORS.map((name) => `[data-live] .${name} { --c: color-mix(in oklab, var(--${name}) 75%, currentColor); }`).join("\n  ")}
  [data-live] :is(circle, path):not([fill]) { fill: color-mix(in srgb, var(--c) 18%, transparent); }
  [data-live] text { stroke: none; fill: currentColor; }
  [data-live] .handle { cursor: grab; touch-action: none; outline-offset: 2px; }
  [data-live] .handle circle { --c: currentColor; fill: transparent; stroke-width: 2; stroke-dasharray: 3 3; }
  [data-live] .handle:focus-visible { outline: none; }
  [data-live] .handle:focus-visible circle { stroke-width: 4; stroke-dasharray: none; }
  [data-live] label { display: grid; grid-template-columns: minmax(8em, 16em) minmax(7em, 16em) 5.5em; gap: 4px 12px;
    align-items: center; margin: 4px 0; }
  [data-live] :is(input, select) { font: inherit; width: 100%; box-sizing: border-box; margin: 0; }
  [data-live] p { margin: 6px 0; }
  [data-live] button { font: inherit; padding: 3px 10px; margin-top: 6px; }
  [data-live] .unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  @media (max-width: 36em) {
    [data-live] label { grid-template-columns: 1fr 5.5em; }
    [data-live] label :is(span, select) { grid-column: 1 / -1; }
  }
  @media print { [data-live] label, [data-live] button { display: none; } }
`;

/** Return the drawing of a figure at some values, and what can be seen in it. */
export function drawn(figure, lesson, values, isNarrow = false, zoom = 1) {
  const { left, gap, top, bottom } = roomOf(figure, isNarrow, zoom);
  const pens = [];
  let [right, down] = [left, 0];
  for (const panel of figure.panels) {
    pens.push(new Pen(panel, right, down, zoom));
    if (isNarrow) down += heightOf(panel) + top + bottom + MARGIN;
    else right += panel.width + gap;
  }
  const words = figure.draw(lesson, values, ...pens);
  return { words, pens, drawing: pens.flatMap((pen) => pen.parts).join("") };
}

/** Return the room that the letters around a figure's panels need. */
function roomOf({ left = 0, gap = MARGIN, top = 0, bottom = 0, panels }, isNarrow, zoom) {
  const side = isNarrow && panels.length > 1 ? Math.max(left, gap - MARGIN) : left;
  return { left: side * zoom, gap: gap * zoom, top: top * zoom, bottom: bottom * zoom };
}

const heightOf = ({ height, width, view: [west, east, south, north] }) => height ?? (width * (north - south)) / (east - west);

/** Return the view box of a figure's drawing, with the room that its axes need. */
export function sizeOf(figure, isNarrow = false, zoom = 1) {
  const { left, gap, top, bottom } = roomOf(figure, isNarrow, zoom);
  const sum = (numbers) => numbers.reduce((all, number) => all + number, 0);
  const { panels } = figure;
  const [widths, heights] = [panels.map(({ width }) => width), panels.map(heightOf)];
  const width = left + (isNarrow ? Math.max(...widths) : sum(widths) + gap * (panels.length - 1));
  const height = isNarrow ? sum(heights) + (top + bottom + MARGIN) * (panels.length - 1) : Math.max(...heights);
  return [0, -top, Math.ceil(width + 8), Math.ceil(height + top + bottom)];
}

/** Bring a figure to life where its still picture stands. */
export function start(name, figure, lesson) {
  const waiting = `figure[data-live="${name}"]:not([data-ready])`;
  document.querySelectorAll(waiting).forEach((place) => new Live(place, figure, lesson));
}

class Live {
  constructor(place, figure, lesson) {
    place.setAttribute("data-ready", "");
    Object.assign(this, { place, figure, lesson });
    this.values = this.first();
    this.still = place.querySelector("img");
    place.append(this.made("style", {}, STYLE));
    this.svg = this.drawn("svg", { role: "group", "aria-label": this.still.alt });
    this.fit();
    this.picture = this.drawn("g", { "aria-hidden": "true" }, this.svg);
    this.still.replaceWith(this.svg);
    this.handles = (figure.handles ?? []).map((handle) => this.handle(handle));
    this.words = this.made("p");
    this.told = this.made("p", { class: "unseen", role: "status" });
    const controls = this.made("div");
    this.controls = Object.entries(figure.numbers).map(([key, number]) => this.control(controls, key, number));
    const again = this.made("button", { ...OURS, type: "button" }, "Start again");
    again.addEventListener("click", () => this.set(this.first()));
    place.append(this.words, this.told, controls, again);
    this.show();
    new ResizeObserver(() => this.fit() && this.show()).observe(place);
  }

  first() {
    return Object.fromEntries(Object.entries(this.figure.numbers).map(([key, { start }]) => [key, start]));
  }

  /** Put the panels beside or below each other, as there is room, with letters that can be read; return
   *  whether that is new. */
  fit() {
    const room = this.place.clientWidth; // 0 where the figure is not seen yet
    const isNarrow = room < NARROW * sizeOf(this.figure)[2];
    const [once, twice] = [1, 2].map((zoom) => sizeOf(this.figure, isNarrow, zoom)[2]);
    const margins = LEAST * (twice - once); // they grow with the letters
    const zoom = room ? Math.max(1, Math.ceil((10 * (LEAST * once - margins)) / (room - margins)) / 10) : 1;
    if (isNarrow === this.isNarrow && zoom === this.zoom) return false;
    Object.assign(this, { isNarrow, zoom });
    const size = sizeOf(this.figure, isNarrow, zoom);
    this.svg.setAttribute("viewBox", size.join(" "));
    this.svg.setAttribute("width", size[2]);
    return true;
  }

  made(kind, attributes = {}, words = "") {
    const element = document.createElement(kind);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    element.textContent = words;
    return element;
  }

  drawn(kind, attributes, parent) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", kind);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    parent?.append(element);
    return element;
  }

  /** A number: a slider, and a box for those who know what they want; or a list to choose from. */
  control(parent, key, number) {
    const { label, low, high, step, names } = number;
    const row = this.made("label");
    row.append(this.made("span", {}, label));
    parent.append(row);
    if (names) {
      const list = this.made("select", OURS);
      names.forEach((name, value) => list.append(this.made("option", { value }, name)));
      list.addEventListener("change", () => this.set({ [key]: Number(list.value) }));
      row.append(list);
      return { key, list };
    }
    const given = { ...OURS, min: low, max: high, step };
    const slider = this.made("input", { ...given, type: "range", "aria-label": label });
    const box = this.made("input", { ...given, step: "any", type: "number", "aria-label": `${label}, as a number` });
    slider.addEventListener("input", () => this.set({ [key]: Number(slider.value) }));
    box.addEventListener("input", () => {
      const value = box.valueAsNumber;
      if (value >= low && value <= high) this.set({ [key]: value }, box);
    });
    box.addEventListener("change", () => this.set({})); // what is out of range is put right
    row.append(slider, box);
    return { key, slider, box, step, says: number.says };
  }

  /** A place in the drawing that can be dragged, or moved with the arrow keys. */
  handle(handle) {
    const { label, step = 0.1 } = handle;
    const group = this.drawn("g", {
      ...OURS, class: "handle", tabindex: 0, role: "slider", "aria-label": label, "aria-roledescription": "point that can be moved",
    }, this.svg);
    this.drawn("circle", { r: GRIP }, group);
    const moved = (to) => this.set(handle.moved(this.values, to));
    let from = null; // where on the handle it was taken hold of
    group.addEventListener("pointerdown", (event) => {
      const [x, y] = this.pointed(event, handle);
      const [atX, atY] = handle.at(this.values);
      from = [x - atX, y - atY];
      group.setPointerCapture(event.pointerId);
      group.focus();
      event.preventDefault();
    });
    group.addEventListener("pointermove", (event) => {
      if (!from) return;
      const [x, y] = this.pointed(event, handle);
      moved([near(x - from[0], step), near(y - from[1], step)]);
    });
    for (const end of ["pointerup", "pointercancel"]) group.addEventListener(end, () => (from = null));
    group.addEventListener("keydown", (event) => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (!way) return;
      event.preventDefault();
      event.stopPropagation();
      const size = event.shiftKey ? 10 * step : step;
      const [x, y] = handle.at(this.values);
      moved([near(x + way[0] * size, step), near(y + way[1] * size, step)]);
    });
    return { ...handle, step, group };
  }

  /** Return where an event points to, in the units of a handle's panel. */
  pointed(event, { panel = 0 }) {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
    const pen = this.pens[panel];
    return [(x - pen.left) / pen.scale + pen.view[0], pen.view[3] - (y - pen.top) / pen.scaleY];
  }

  /** Take other values, each within its range, and show what comes of them. */
  set(changed, typing = null) {
    for (const [key, value] of Object.entries(changed)) {
      const { low = 0, high, names } = this.figure.numbers[key];
      this.values[key] = clamped(value, low, high ?? names.length - 1);
    }
    this.show(typing);
  }

  show(typing = null) {
    const { words, pens, drawing } = drawn(this.figure, this.lesson, this.values, this.isNarrow, this.zoom);
    this.pens = pens;
    this.picture.innerHTML = drawing;
    this.words.textContent = words;
    this.svg.setAttribute("aria-label", words);
    clearTimeout(this.waits);
    this.waits = setTimeout(() => (this.told.textContent = words), QUIET);
    for (const { key, list, slider, box, step, says } of this.controls) {
      if (list) {
        list.value = this.values[key];
        continue;
      }
      slider.value = this.values[key];
      slider.setAttribute("aria-valuetext", says?.(this.values[key]) ?? written(this.values[key], step));
      if (box !== typing) box.value = String(Number(this.values[key].toFixed(6)));
    }
    for (const { group, at, says, panel = 0, step } of this.handles) {
      const [x, y] = at(this.values);
      group.setAttribute("transform", `translate(${pens[panel].place([x, y]).replace(" ", ",")}) scale(${this.zoom})`);
      group.setAttribute("aria-valuenow", x);
      group.setAttribute("aria-valuetext", says?.(this.values) ?? `${written(x, step)}, ${written(y, step)}`);
    }
  }
}
