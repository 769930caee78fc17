// The collision lab: bodies to throw at each other. The stepped engine of the course moves them
// (world.js); here they are drawn, dragged, counted up and set by number.
//
// A set-up is a plain object, and a link can hold it:
//
//   { dimensions: 2, elasticity: 80, friction: 0.2, gravity: false, walls: true,
//     bodies: [{ shape: "disc", mass: 1, size: 0.4, x: -2, y: 0, vx: 2, vy: 0, angle: 0, w: 0 }] }

const DT = 1 / 60; // s, of a step
const SLOW = 0.25; // of the true speed
const MOST_STEPS = 4; // in a frame; a machine that is slower shows it slower
const GRAVITY = 9.81; // m/s^2
const WIDTH = 4; // m, from the middle to each side
const HEIGHTS = { 1: 1, 2: 2.5 };
const ARROW = 0.4; // m for 1 m/s, or 1 kg m/s
const GRIP = 14; // pixels around a tip that can be taken hold of
const MOST_WITH_NUMBERS = 8;
const MOST_WITH_ARROWS = 50;
const MOST_PATH = 1200; // steps that the path of the centre of mass goes back
const MOST_BODIES = 1000;
const STEPS_A_SAVE = 30; // on the way back, fewer steps than this are made again
const MOST_SAVED = 64e6; // bytes
const REST = 400; // ms without a change, after which a screen reader is told
const FREE_KEYS = { "data-lm-suppress-shortcuts": "true" }; // makes JupyterLab leave the keys to us
const LAB_COLORS = ["blue", "orange", "green", "vermilion", "purple", "sky"];

const FIELDS = {
  mass: { label: "mass, kg", low: 0.1, high: 100, step: 0.1, isFixed: true },
  size: { label: "half width, m", low: 0.02, high: 1, step: 0.05, isFixed: true },
  x: { label: "x, m", low: -100, high: 100, step: 0.1 },
  y: { label: "y, m", low: -100, high: 100, step: 0.1, isPlane: true },
  vx: { label: "velocity x, m/s", low: -50, high: 50, step: 0.1 },
  vy: { label: "velocity y, m/s", low: -50, high: 50, step: 0.1, isPlane: true },
  angle: { low: -1e9, high: 1e9 },
  w: { low: -1e9, high: 1e9 },
};
const SETTINGS = {
  elasticity: { label: "Elasticity, %", low: 0, high: 100, step: 5, start: 100 },
  friction: { label: "Friction", low: 0, high: 1, step: 0.05, start: 0, isPlane: true },
};
const SWITCHES = {
  gravity: { label: "Gravity", isPlane: true },
  walls: { label: "Walls" },
};
const SHOWN = { velocities: "Velocities", momenta: "Momenta", centre: "Centre of mass" };

const body = (x, y, vx, vy, more = {}) => ({ shape: "disc", mass: 1, size: 0.4, x, y, vx, vy, angle: 0, w: 0, ...more });
const track = (elasticity, bodies) => ({ dimensions: 1, elasticity, friction: 0, gravity: false, walls: true, bodies });
const plane = (elasticity, friction, gravity, bodies) => ({ dimensions: 2, elasticity, friction, gravity, walls: true, bodies });

const PRESETS = {
  "Oblique hit": () => plane(100, 0, false, [body(-2.5, -0.3, 3, 0), body(0.5, 0, 0, 0, { mass: 2, size: 0.5 })]),
  "Head on, equal masses": () => track(100, [body(-2, 0, 2, 0), body(2, 0, -1, 0)]),
  "Heavy on light": () => track(100, [body(-2.5, 0, 2, 0, { mass: 5, size: 0.5 }), body(0, 0, 0, 0, { size: 0.3 })]),
  "They stay together": () => track(0, [body(-2, 0, 2, 0, { shape: "box" }), body(1, 0, 0, 0, { shape: "box", mass: 2 })]),
  "Row of five": () => track(100, [body(-3.2, 0, 2, 0, { size: 0.3 }), ...[0, 1, 2, 3].map((k) => body(-0.5 + 0.61 * k, 0, 0, 0, { size: 0.3 }))]),
  "Friction makes spin": () => plane(60, 0.5, false, [body(-2.5, -0.4, 3, 0), body(0.5, 0, 0, 0, { size: 0.5 })]),
  "Boxes and discs that fall": () =>
    plane(30, 0.5, true, [0, 1, 2, 3, 4, 5].map((k) =>
      body(1.1 * (k % 3) - 1 + 0.2 * (k > 2), k > 2 ? 1.6 : 0, 0, 0, { shape: k % 2 ? "disc" : "box", size: 0.3, angle: 0.3 * k }))),
  "Rack of fifteen": () => plane(95, 0, false, [body(-3, 0.02, 8, 0, { size: 0.15 }), ...rack()]),
  "Gas of 500": () => plane(100, 0, false, gas(500)),
};

function rack() {
  const places = [0, 1, 2, 3, 4].flatMap((row) => Array.from({ length: row + 1 }, (_, k) => [row, k - row / 2]));
  return places.map(([row, side]) => body(0.5 + 0.262 * row, 0.302 * side, 0, 0, { size: 0.15 }));
}

function gas(count) {
  const columns = 28;
  return Array.from({ length: count }, (_, k) => {
    const turn = 2.399963 * k; // the golden angle: all directions alike
    return body(-3.8 + 0.28 * (k % columns), -2.3 + 0.26 * Math.floor(k / columns), 2 * Math.cos(turn), 2 * Math.sin(turn), { size: 0.06 });
  });
}

/** Return a set-up with nothing in it that the lab does not know, or say what is wrong. */
function understood(given) {
  const flag = (name) => given[name] === true;
  const number = (name, value, { low, high, start = 0 }) => {
    const taken = value ?? start;
    if (typeof taken === "number" && taken >= low && taken <= high) return taken;
    throw new RangeError(`${name} must lie between ${low} and ${high}, got ${JSON.stringify(value)}`);
  };
  if (!Array.isArray(given?.bodies) || given.bodies.length > MOST_BODIES)
    throw new RangeError(`bodies must be a list of at most ${MOST_BODIES}`);
  const settings = Object.entries(SETTINGS).map(([name, range]) => [name, number(name, given[name], range)]);
  return {
    dimensions: given.dimensions === 1 ? 1 : 2,
    ...Object.fromEntries(settings),
    gravity: flag("gravity"),
    walls: flag("walls"),
    bodies: given.bodies.map((one, k) => ({
      shape: one.shape === "box" ? "box" : "disc",
      ...Object.fromEntries(Object.entries(FIELDS).map(([name, range]) => [name, number(`bodies[${k}].${name}`, one[name], range)])),
    })),
  };
}

/** Return a set-up as the description of a scene; the walls come last. */
function sceneOf({ dimensions, elasticity, friction, gravity, walls, bodies }) {
  const isTrack = dimensions === 1;
  const surface = { restitution: elasticity / 100, friction: isTrack ? 0 : friction };
  const [w, h] = [WIDTH, HEIGHTS[dimensions]];
  const corners = [[-w, -h], [w, -h], [w, h], [-w, h]];
  const sides = corners.map((corner, k) => ({ segment: [corner, corners[(k + 1) % 4]], ...surface }));
  return {
    gravity: [0, gravity && !isTrack ? -GRAVITY : 0],
    dt: DT,
    bodies: [
      ...bodies.map(({ shape, mass, size: s, x, y, vx, vy, angle, w: spin }) => ({
        ...(shape === "box" ? { polygon: [[-s, -s], [s, -s], [s, s], [-s, s]] } : { circle: s }),
        ...(isTrack
          ? { position: [x, 0], velocity: [vx, 0], inertia: Infinity }
          : { position: [x, y], velocity: [vx, vy], angle, angular_velocity: spin }),
        ...surface,
        mass,
      })),
      ...(walls ? (isTrack ? [sides[1], sides[3]] : sides) : []),
    ],
  };
}

const decimal = (value, digits = 2) => value.toFixed(digits).replace(/^-(0\.?0*)$/, "$1").replace("-", "\u2212");
const tuple = (x, y, isTrack) => (isTrack ? decimal(x) : `(${decimal(x)}, ${decimal(y)})`);
const rounded = (value, step) => Number((Math.round(value / step) * step).toFixed(9));
const limited = (value, { low, high }) => Math.min(Math.max(value, low), high);

/** Bring the lab to life in its place. */
export function startLab(program) {
  for (const place of document.querySelectorAll("[data-lab]:not([data-ready])")) new Lab(place, program);
}

class Lab {
  constructor(place, program) {
    Object.assign(this, { place, program, isRunning: false, shown: { velocities: true, momenta: false, centre: false } });
    place.setAttribute("data-ready", "");
    place.replaceChildren(this.made("style", {}, LAB_STYLE));
    this.canvas = this.put(place, "canvas", { role: "img" });
    this.words = this.put(place, "p", { class: "lab-words" });
    this.error = this.put(place, "p", { role: "alert" });
    this.told = this.put(place, "p", { class: "unseen", role: "status" });
    this.buttons(this.put(place, "div", { class: "lab-row" }));
    this.settings(this.put(place, "div", { class: "lab-row" }));
    this.cards = this.put(place, "div");
    const last = this.put(place, "p", { class: "lab-row" });
    this.adds = this.button(last, "Add a body", () => this.edit((setup) => setup.bodies.push(this.another())));
    this.link = this.put(last, "a", { href: "#" }, "Link to this set-up");
    this.pointer();
    new ResizeObserver(() => this.draw()).observe(this.canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.draw());
    new MutationObserver(() => this.draw()).observe(document.documentElement, { attributes: true });
    window.addEventListener("hashchange", () => this.read());
    if (!this.read()) this.open(PRESETS["Oblique hit"]());
  }

  // What is in the page

  made(kind, attributes = {}, words = "") {
    const element = document.createElement(kind);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    element.textContent = words;
    return element;
  }

  put(parent, kind, attributes, words) {
    const element = this.made(kind, attributes, words);
    parent.append(element);
    return element;
  }

  button(parent, words, pressed) {
    const button = this.put(parent, "button", { ...FREE_KEYS, type: "button" }, words);
    button.addEventListener("click", pressed);
    return button;
  }

  check(parent, label, isOn, changed) {
    const whole = this.put(parent, "label");
    const box = this.put(whole, "input", { ...FREE_KEYS, type: "checkbox" });
    box.checked = isOn;
    whole.append(` ${label}`);
    box.addEventListener("change", () => changed(box.checked));
    return { whole, box };
  }

  select(parent, label, options, changed) {
    const whole = this.put(parent, "label", {}, `${label} `);
    const box = this.put(whole, "select", FREE_KEYS);
    for (const option of options) this.put(box, "option", {}, option);
    box.addEventListener("change", () => changed(box.value));
    return { whole, box };
  }

  /** A number that can be typed, or changed with the arrow keys. */
  number(parent, label, range, changed, spoken = label) {
    const whole = this.put(parent, "label", {}, `${label} `);
    const { low: min, high: max, step } = range;
    const box = this.put(whole, "input", { ...FREE_KEYS, type: "number", min, max, step: "any", "aria-label": spoken });
    box.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      if (!way) return;
      event.preventDefault(); // by whole steps
      changed(limited(rounded(Number(box.value) + way * step * (event.shiftKey ? 10 : 1), step), range));
    });
    box.addEventListener("input", () => {
      const value = box.valueAsNumber;
      this.typing = box;
      if (value >= min && value <= max) changed(value);
    });
    box.addEventListener("change", () => {
      this.typing = null;
      this.refresh(); // what is out of range is put right
    });
    return { whole, box };
  }

  buttons(row) {
    this.runs = this.button(row, "Run", () => this.run(!this.isRunning));
    this.back = this.button(row, "Step back", () => this.go(this.count - 1));
    this.button(row, "Step", () => this.go(this.count + 1));
    this.button(row, "Reset", () => this.open(this.setup));
    this.check(row, "Slow", false, (isOn) => (this.isSlow = isOn));
    this.clock = this.put(row, "span", { class: "lab-value lab-clock" });
  }

  settings(row) {
    this.preset = this.select(row, "Begin with", ["Choose", ...Object.keys(PRESETS)], (name) => {
      if (PRESETS[name]) this.open(PRESETS[name]());
    });
    this.ways = this.select(row, "Motion", ["on a line", "in the plane"], (value) =>
      this.edit((setup) => (setup.dimensions = value === "on a line" ? 1 : 2)),
    );
    this.numbers = Object.entries(SETTINGS).map(([name, range]) => {
      const whole = this.put(row, "label", {}, `${range.label} `);
      const { low: min, high: max, step } = range;
      const box = this.put(whole, "input", { ...FREE_KEYS, type: "range", min, max, step });
      const value = this.put(whole, "span", { class: "lab-value" });
      box.addEventListener("input", () => this.edit((setup) => (setup[name] = box.valueAsNumber)));
      return { name, whole, box, value, ...range };
    });
    this.switches = Object.entries(SWITCHES).map(([name, { label, isPlane }]) => {
      const made = this.check(row, label, false, (isOn) => this.edit((setup) => (setup[name] = isOn)));
      return { name, isPlane, ...made };
    });
    for (const [name, label] of Object.entries(SHOWN))
      this.check(row, label, this.shown[name], (isOn) => {
        this.shown[name] = isOn;
        this.draw();
      });
  }

  /** A card of numbers for each body, if they are few. */
  deal() {
    const { bodies } = this.setup;
    const isFew = bodies.length <= MOST_WITH_NUMBERS;
    this.adds.hidden = bodies.length >= MOST_WITH_NUMBERS;
    this.cards.replaceChildren();
    this.boxes = (isFew ? bodies : []).map((_, k) => {
      const card = this.put(this.cards, "fieldset");
      this.put(card, "legend", {}, `Body ${k + 1}`);
      const shape = this.select(card, "shape", ["disc", "box"], (value) => this.edit((setup) => (setup.bodies[k].shape = value)));
      const fields = Object.entries(FIELDS).filter(([, { label }]) => label);
      const numbers = fields.map(([name, range]) => {
        const changed = (value) => this.edit((setup) => (setup.bodies[k][name] = value));
        return { name, ...range, ...this.number(card, range.label, range, changed, `${range.label}, of body ${k + 1}`) };
      });
      const takes = this.button(card, "Remove", () => this.edit((setup) => setup.bodies.splice(k, 1)));
      takes.setAttribute("aria-label", `Remove body ${k + 1}`);
      return { shape, numbers };
    });
  }

  another() {
    return body(0, this.setup.dimensions === 1 ? 0 : 1.5, 0, 0, { size: 0.3 });
  }

  // What happens

  /** Begin with a set-up. */
  open(setup) {
    this.run(false);
    this.begin(setup);
    this.deal();
    this.refresh();
  }

  begin(setup) {
    this.setup = setup;
    this.world = scene(this.program, sceneOf(setup));
    Object.assign(this, { count: 0, saved: [[0, this.world.save(), null]], path: [], impact: null });
    this.first = this.world.totals();
    this.note();
    this.link.hidden = setup.bodies.length > MOST_WITH_ARROWS; // it would be longer than some take
    this.link.href = `#lab=${encodeURIComponent(JSON.stringify(setup))}`;
    this.error.textContent = "";
  }

  /** Read the set-up that the address holds; return whether it holds one. */
  read() {
    const found = /^#lab=(.*)$/.exec(location.hash);
    if (!found) return false;
    try {
      this.open(understood(JSON.parse(decodeURIComponent(found[1]))));
      return true;
    } catch (error) {
      if (!this.setup) this.open(PRESETS["Oblique hit"]());
      this.error.textContent = `The link holds no set-up: ${error.message}`;
      return true;
    }
  }

  /** Change the set-up: from here on, with the bodies where they are. */
  edit(change) {
    const setup = structuredClone(this.setup);
    if (this.count > 0)
      setup.bodies.forEach((one, k) => {
        const { x, y, vx, vy, angle, w } = this.world.bodies[k];
        Object.assign(one, { x, y, vx, vy, angle, w });
      });
    const before = setup.bodies.length;
    change(setup);
    this.begin(setup);
    if (before !== setup.bodies.length) this.deal();
    this.refresh();
  }

  /** Let a number of steps have been made, more or fewer than now. */
  go(count) {
    if (count < this.saved[0][0]) return;
    try {
      if (count < this.count) {
        while (this.saved.at(-1)[0] > count) this.saved.pop();
        const [at, state, impact] = this.saved.at(-1);
        this.world.restore(state);
        Object.assign(this, { count: at, impact });
        this.path.length = at + 1;
      }
      while (this.count < count) this.advance();
    } catch (error) {
      this.run(false);
      this.error.textContent = error.message;
    }
    this.refresh();
  }

  advance() {
    this.world.step();
    this.count += 1;
    this.note();
    if (this.count % STEPS_A_SAVE === 0) this.save();
  }

  save() {
    this.saved.push([this.count, this.world.save(), this.impact]);
    const bytes = this.saved[0][1].tables.reduce((sum, table) => sum + table.byteLength, 0);
    if (this.saved.length * bytes > MOST_SAVED) this.saved.shift();
  }

  /** Note where the centre of mass is, and the strongest impulse of this step. */
  note() {
    const { x, y } = this.world.totals();
    this.path[this.count] = [x, y];
    for (const impulse of this.world.impulses) {
      const isLast = this.impact?.count === this.count;
      if (!isLast || impulse.normal_impulse > this.impact.normal_impulse) this.impact = { ...impulse, count: this.count };
    }
  }

  run(isRunning) {
    if (isRunning === this.isRunning) return;
    this.isRunning = isRunning;
    this.runs.textContent = isRunning ? "Pause" : "Run";
    if (!isRunning) return this.refresh();
    let before = performance.now();
    let owed = 0; // s
    const frame = (now) => {
      if (!this.isRunning || !this.place.isConnected) return;
      owed += ((now - before) / 1000) * (this.isSlow ? SLOW : 1);
      before = now;
      const steps = Math.floor(owed / DT);
      owed -= steps * DT;
      if (steps > 0) this.go(this.count + Math.min(steps, MOST_STEPS));
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  // What is seen

  refresh() {
    const isTrack = this.setup.dimensions === 1;
    this.clock.textContent = `t = ${decimal(this.count * DT)} s`;
    this.back.disabled = this.count <= this.saved[0][0];
    this.ways.box.value = isTrack ? "on a line" : "in the plane";
    for (const { name, box, value, whole, isPlane } of this.numbers) {
      box.value = this.setup[name];
      value.textContent = this.setup[name];
      whole.hidden = isPlane && isTrack;
    }
    for (const { name, box, whole, isPlane } of this.switches) {
      box.checked = this.setup[name];
      whole.hidden = isPlane && isTrack;
    }
    this.boxes.forEach(({ shape, numbers }, k) => {
      shape.box.value = this.setup.bodies[k].shape;
      for (const { name, box, whole, isPlane, isFixed } of numbers) {
        whole.hidden = isPlane && isTrack;
        const now = (isFixed ? this.setup : this.world).bodies[k][name];
        if (box !== this.typing) box.value = Number(now.toFixed(4));
      }
    });
    this.speak();
    this.draw();
  }

  speak() {
    const isTrack = this.setup.dimensions === 1;
    const { mass, px, py, energy, potential, vx, vy } = this.world.totals();
    const lost = this.first.energy + this.first.potential - energy - potential;
    const floor = -GRAVITY * HEIGHTS[2] * mass; // J, of bodies whose centres lie on it
    const height = this.setup.gravity && !isTrack ? `, energy of height above the floor ${decimal(potential - floor)} J` : "";
    const parts = [
      `Momentum ${tuple(px, py, isTrack)} kg m/s`,
      `kinetic energy ${decimal(energy)} J${height}`,
      `energy lost since t = 0: ${decimal(lost)} J`,
      `velocity of the centre of mass ${tuple(vx, vy, isTrack)} m/s`,
    ];
    const words = `${parts.join("; ")}.${this.struck()}`;
    this.words.textContent = words;
    const few = this.setup.bodies.length <= MOST_WITH_NUMBERS ? this.each(isTrack) : "";
    this.canvas.setAttribute("aria-label", `${this.setup.bodies.length} bodies at ${decimal(this.count * DT)} s. ${few}`);
    clearTimeout(this.waits);
    if (!this.isRunning) this.waits = setTimeout(() => (this.told.textContent = `${this.clock.textContent}. ${few}${words}`), REST);
  }

  each(isTrack) {
    const say = ({ x, y, vx, vy }, k) => `Body ${k + 1} at ${tuple(x, y, isTrack)} m, velocity ${tuple(vx, vy, isTrack)} m/s. `;
    return this.world.bodies.slice(0, this.setup.bodies.length).map(say).join("");
  }

  struck() {
    if (!this.impact) return "";
    const name = (k) => (k < this.setup.bodies.length ? `body ${k + 1}` : "a wall");
    const { a, b, normal_impulse, tangent_impulse, count } = this.impact;
    const rubbed = tangent_impulse === 0 ? "" : ` and ${decimal(Math.abs(tangent_impulse))} N s of friction`;
    return ` At ${decimal(count * DT)} s ${name(a)} and ${name(b)} gave each other ${decimal(normal_impulse)} N s${rubbed}.`;
  }

  draw() {
    const { canvas } = this;
    if (!this.world || canvas.clientWidth === 0) return;
    const high = HEIGHTS[this.setup.dimensions];
    canvas.style.aspectRatio = `${2 * WIDTH + 0.2} / ${2 * high + 0.2}`;
    const ratio = devicePixelRatio;
    const [width, height] = [canvas.clientWidth, (canvas.clientWidth * (2 * high + 0.2)) / (2 * WIDTH + 0.2)];
    const [pixels, lines] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== pixels || canvas.height !== lines) Object.assign(canvas, { width: pixels, height: lines });
    const style = getComputedStyle(canvas);
    this.ink = style.color;
    this.colors ??= Object.fromEntries(LAB_COLORS.map((name) => [name, style.getPropertyValue(`--${name}`)]));
    this.scale = width / (2 * WIDTH + 0.2);
    const pen = (this.pen = canvas.getContext("2d"));
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.setTransform(ratio * this.scale, 0, 0, -ratio * this.scale, (ratio * width) / 2, (ratio * height) / 2);
    this.place2d = pen.getTransform();
    this.drawWalls(high);
    this.setup.bodies.forEach((one, k) => this.drawBody(one, this.world.bodies[k], k));
    if (this.shown.centre) this.drawCentre();
    this.setup.bodies.forEach((one, k) => this.drawArrows(one, this.world.bodies[k]));
  }

  drawWalls(high) {
    const { pen } = this;
    pen.strokeStyle = this.ink;
    pen.lineWidth = 3 / this.scale;
    pen.globalAlpha = this.setup.walls ? 0.9 : 0.15;
    pen.strokeRect(-WIDTH, -high, 2 * WIDTH, 2 * high);
    if (this.setup.dimensions === 1) {
      pen.globalAlpha = 0.3;
      pen.lineWidth = 1 / this.scale;
      pen.beginPath();
      pen.moveTo(-WIDTH, 0);
      pen.lineTo(WIDTH, 0);
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }

  drawBody({ shape, size }, { x, y, angle }, k) {
    const { pen } = this;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const at = (a, b) => [x + cos * a - sin * b, y + sin * a + cos * b];
    pen.beginPath();
    if (shape === "box") {
      for (const [a, b] of [[-1, -1], [1, -1], [1, 1], [-1, 1]]) pen.lineTo(...at(a * size, b * size));
      pen.closePath();
    } else {
      pen.arc(x, y, size, angle, angle + 2 * Math.PI);
      if (this.setup.dimensions === 2) pen.lineTo(...at(0.6 * size, 0)); // shows how it turns
    }
    pen.fillStyle = this.colors[LAB_COLORS[k % LAB_COLORS.length]];
    pen.globalAlpha = 0.35;
    pen.fill();
    pen.globalAlpha = 1;
    pen.strokeStyle = this.ink;
    pen.lineWidth = 1.5 / this.scale;
    pen.stroke();
    if (this.setup.bodies.length <= 20) this.write([x, y - 0.55 * size], String(k + 1));
  }

  drawArrows({ mass }, { x, y, vx, vy }) {
    if (this.setup.bodies.length > MOST_WITH_ARROWS) return;
    if (this.shown.momenta) this.arrow([x, y], [mass * vx, mass * vy], "purple", "p");
    if (this.shown.velocities) this.arrow([x, y], [vx, vy], "green", "v");
  }

  drawCentre() {
    const { pen } = this;
    pen.strokeStyle = this.ink;
    pen.lineWidth = 1.5 / this.scale;
    pen.setLineDash([4 / this.scale, 4 / this.scale]);
    pen.beginPath();
    for (const point of this.path.slice(-MOST_PATH)) pen.lineTo(...point);
    pen.stroke();
    pen.setLineDash([]);
    const [x, y] = this.path.at(-1);
    const half = 7 / this.scale;
    pen.beginPath();
    pen.moveTo(x - half, y);
    pen.lineTo(x + half, y);
    pen.moveTo(x, y - half);
    pen.lineTo(x, y + half);
    pen.stroke();
    this.write([x, y], "CM", [16, -10]);
  }

  /** Draw an arrow whose name stands beyond its tip; momenta are broader. */
  arrow([x, y], [vx, vy], color, name) {
    const [dx, dy] = [ARROW * vx, ARROW * vy];
    const length = Math.hypot(dx, dy);
    if (length * this.scale < 2) return;
    const { pen } = this;
    const head = Math.min(9 / this.scale, length);
    const [ux, uy] = [dx / length, dy / length];
    pen.strokeStyle = this.colors[color];
    pen.lineWidth = (name === "p" ? 5 : 2.5) / this.scale;
    pen.globalAlpha = name === "p" ? 0.6 : 1;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(x + dx, y + dy);
    for (const side of [1, -1]) {
      pen.moveTo(x + dx, y + dy);
      pen.lineTo(x + dx - head * (ux - 0.5 * side * uy), y + dy - head * (uy + 0.5 * side * ux));
    }
    pen.stroke();
    pen.globalAlpha = 1;
    this.write([x + dx, y + dy], name, [12 * ux + (name === "p" ? 13 : 0), -12 * uy]);
  }

  /** Write words at a place, shifted by some pixels. */
  write([x, y], words, [right, down] = [0, 0]) {
    const { pen } = this;
    const { a, e, d, f } = this.place2d;
    pen.save();
    pen.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    Object.assign(pen, { font: "bold 14px sans-serif", textAlign: "center", textBaseline: "middle", fillStyle: this.ink });
    pen.fillText(words, (a * x + e) / devicePixelRatio + right, (d * y + f) / devicePixelRatio + down);
    pen.restore();
  }

  // What a pointer takes hold of: the tip of a velocity, or a body

  pointer() {
    const { canvas } = this;
    let held = null;
    const start = (event) => {
      const [x, y] = this.pointed(event);
      held = this.under(x, y);
      return held !== null;
    };
    canvas.addEventListener("touchstart", (event) => start(event.touches[0]) && event.preventDefault(), { passive: false });
    canvas.addEventListener("pointerdown", (event) => {
      if (!start(event)) return;
      this.typing = null;
      this.run(false);
      canvas.setPointerCapture(event.pointerId);
      event.preventDefault();
    });
    canvas.addEventListener("pointermove", (event) => {
      const [x, y] = this.pointed(event);
      if (held) this.drag(held, x, y);
      else canvas.style.cursor = this.under(x, y) ? "grab" : "";
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => (held = null));
  }

  pointed({ clientX, clientY }) {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return [(clientX - left - width / 2) / this.scale, (top + height / 2 - clientY) / this.scale];
  }

  under(x, y) {
    const bodies = this.world.bodies.slice(0, this.setup.bodies.length);
    const isNear = (px, py, reach) => Math.hypot(x - px, y - py) <= reach;
    const tip = ({ x, y, vx, vy }) => [x + ARROW * vx, y + ARROW * vy];
    const has = (k) => {
      const { x, y } = bodies[k];
      return [k, isNear(x, y, Math.max(this.setup.bodies[k].size, GRIP / this.scale)), isNear(...tip(bodies[k]), GRIP / this.scale)];
    };
    const found = bodies.map((_, k) => has(k));
    const showsTips = this.shown.velocities && bodies.length <= MOST_WITH_ARROWS;
    const byTip = showsTips && found.find(([k, isIn, isTip]) => isTip && Math.hypot(bodies[k].vx, bodies[k].vy) * ARROW * this.scale > GRIP);
    const chosen = byTip || found.find(([, isIn]) => isIn);
    if (!chosen) return null;
    const [k] = chosen;
    return { k, isTip: Boolean(byTip), from: [x - bodies[k].x, y - bodies[k].y] };
  }

  drag({ k, isTip, from }, x, y) {
    const high = HEIGHTS[this.setup.dimensions];
    const isTrack = this.setup.dimensions === 1;
    this.edit(({ bodies, walls }) => {
      const one = bodies[k];
      const inside = (value, half) => (walls ? Math.max(-half, Math.min(half, value)) : value);
      if (isTip) {
        one.vx = limited(rounded((x - one.x) / ARROW, 0.1), FIELDS.vx);
        one.vy = isTrack ? 0 : limited(rounded((y - one.y) / ARROW, 0.1), FIELDS.vy);
      } else {
        one.x = inside(rounded(x - from[0], 0.05), WIDTH - one.size);
        one.y = isTrack ? 0 : inside(rounded(y - from[1], 0.05), high - one.size);
      }
    });
  }
}

const LAB_STYLE = `
  [data-lab] { max-width: 100%; font: 14px/1.4 sans-serif; }
  [data-lab] canvas { display: block; width: 100%; max-width: 56em; touch-action: pan-y; }
  [data-lab] .lab-row { display: flex; flex-wrap: wrap; gap: 6px 14px; align-items: center; margin: 8px 0; }
  [data-lab] .lab-words { min-height: 4.2em; margin: 6px 0; max-width: 56em; font-variant-numeric: tabular-nums; }
  [data-lab] :is(button, input, select) { font: inherit; }
  [data-lab] button { padding: 4px 12px; min-width: 4.5em; }
  [data-lab] .lab-value { font-variant-numeric: tabular-nums; font-weight: bold; min-width: 2.5em; display: inline-block; }
  [data-lab] input[type="range"] { width: 8em; vertical-align: middle; }
  [data-lab] fieldset { display: flex; flex-wrap: wrap; gap: 4px 12px; border: 1px solid color-mix(in srgb, currentColor 40%, transparent);
    margin: 6px 0; padding: 4px 10px 8px; max-width: 56em; box-sizing: border-box; align-items: center; }
  [data-lab] fieldset input { width: 5em; }
  [data-lab] a { color: inherit; }
  [data-lab] [hidden] { display: none; }
  [data-lab] [role="alert"] { color: inherit; font-weight: bold; margin: 0; }
  [data-lab] .unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  @media print { [data-lab] :is(button, fieldset, .lab-row) { display: none; } }
`;
