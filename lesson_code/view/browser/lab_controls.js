// The controls of the collision lab: buttons, switches, a card of numbers for each body; and what
// a screen reader is told.

function made(kind, attributes = {}, words = "") {
  const element = document.createElement(kind);
  for (const key in attributes) element.setAttribute(key, attributes[key]);
  element.textContent = words;
  return element;
}

/** Put a part that the reader opens below the others; what is in it is drawn when it opens. */
function part(lab, title, isOpen) {
  const details = put(lab.place, "details");
  put(details, "summary", {}, title);
  details.open = isOpen;
  details.addEventListener("toggle", () => lab.draw());
  return details;
}

function put(parent, kind, attributes, words) {
  const element = made(kind, attributes, words);
  parent.append(element);
  return element;
}

function button(parent, words, pressed) {
  const made = put(parent, "button", { ...FREE_KEYS, type: "button" }, words);
  made.addEventListener("click", pressed);
  return made;
}

function check(parent, label, isOn, changed) {
  const whole = put(parent, "label");
  const box = put(whole, "input", { ...FREE_KEYS, type: "checkbox" });
  box.checked = isOn;
  whole.append(` ${label}`);
  box.addEventListener("change", () => changed(box.checked));
  return { whole, box };
}

function select(parent, label, options, changed) {
  const whole = put(parent, "label", {}, `${label} `);
  const box = put(whole, "select", FREE_KEYS);
  for (const [kind, names] of Array.isArray(options) ? [["", options]] : Object.entries(options)) {
    const group = kind ? put(box, "optgroup", { label: kind }) : box;
    for (const name of names) put(group, "option", {}, name);
  }
  box.addEventListener("change", () => changed(box.value));
  return { whole, box };
}

class Controls {
  constructor(lab) {
    this.lab = lab;
    const { place } = lab;
    this.buttons(put(place, "div", { class: "lab-row" }));
    this.error = put(place, "p", { role: "alert" });
    this.told = put(place, "p", { class: "unseen", role: "status" });
    this.words = put(place, "p", { class: "lab-words" });
    this.settings(put(place, "div", { class: "lab-row" }), put(place, "div", { class: "lab-row" }));
    this.cards = put(place, "div");
    const last = put(place, "div", { class: "lab-row" });
    this.adds = button(last, "Add a body", () => lab.edit((setup) => setup.bodies.push(lab.another())));
    button(last, "Save as file", () => this.save());
    const opens = put(last, "label", { class: "lab-button" }, "Open a file");
    const file = put(opens, "input", { ...FREE_KEYS, class: "unseen", type: "file", accept: ".json,application/json" });
    file.addEventListener("change", () => this.openFile(file));
    this.link = put(last, "a", { href: "#" }, "Link to this set-up");
    this.link.addEventListener("click", (event) => this.share(event));
    put(place, "p", {}, KEYS);
  }

  /** Give all surfaces an elasticity or a friction, those of their own included. */
  coat(setup, name, value) {
    setup[name] = value;
    for (const one of setup.bodies) delete one[name];
  }

  /** Put the link into the address, and onto the clipboard where that is allowed; go on with the run. */
  async share(event) {
    event.preventDefault();
    history.replaceState(null, "", this.link.href);
    const isCopied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    this.told.textContent = this.link.textContent = isCopied ? "The link is copied" : "The address holds the set-up";
    setTimeout(() => (this.link.textContent = "Link to this set-up"), 3000); // ms: long enough to be read
  }

  /** Hand the set-up over as a scene file. */
  save() {
    const href = URL.createObjectURL(new Blob([`${JSON.stringify(this.lab.setup, null, 1)}\n`], { type: "application/json" }));
    made("a", { href, download: "scene.json" }).click();
    setTimeout(() => URL.revokeObjectURL(href), 1000); // ms: the download has begun
  }

  /** Begin with the set-up of a scene file, or say what is wrong with it. */
  async openFile(box) {
    const [file] = box.files;
    if (!file) return;
    try {
      this.lab.open(understood(JSON.parse(await file.text())));
    } catch (error) {
      this.error.textContent = `${file.name} holds no scene: ${error.message}`;
    }
    box.value = ""; // so that the same file can be opened again
  }

  /** A number that can be typed, or changed with the arrow keys. */
  number(parent, label, range, changed, spoken = label) {
    const whole = put(parent, "label", {}, `${label} `);
    const { low: min, high: max, step } = range;
    const box = put(whole, "input", { ...FREE_KEYS, type: "number", min, max, step: "any", "aria-label": spoken });
    box.addEventListener("keydown", (event) => {
      const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      if (!way) return;
      event.preventDefault(); // by whole steps
      changed(limited(rounded(Number(box.value) + way * step * (event.shiftKey ? 10 : 1), step), range));
    });
    box.addEventListener("input", () => {
      const value = box.valueAsNumber;
      this.lab.typing = box;
      if (fits(value, range)) changed(value);
    });
    box.addEventListener("change", () => {
      this.lab.typing = null;
      this.lab.refresh(); // what is out of range is put right
    });
    return { whole, box };
  }

  buttons(row) {
    this.runs = button(row, "Run", () => this.lab.run(!this.lab.isRunning));
    this.runs.className = "lab-go";
    this.back = button(row, "Step back", () => this.lab.go(this.lab.count - 1));
    button(row, "Step", () => this.lab.go(this.lab.count + 1));
    button(row, "Reset", () => this.lab.open(this.lab.setup, this.preset.box.value));
    check(row, "Slow", false, (isOn) => (this.lab.isSlow = isOn));
    this.clock = put(row, "span", { class: "lab-value lab-clock" });
  }

  settings(row, shows) {
    this.preset = select(row, "Begin with", { "": [OWN], ...CHAPTERS }, (name) => PRESETS[name] && this.lab.openPreset(name));
    this.ways = select(row, "Motion", ["on a line", "in the plane"], (value) =>
      this.lab.edit((setup) => (setup.dimensions = value === "on a line" ? 1 : 2)),
    );
    this.numbers = Object.entries(SETTINGS).map(([name, range]) => {
      const whole = put(row, "label", {}, `${range.label} `);
      const { low: min, high: max, step } = range;
      const box = put(whole, "input", { ...FREE_KEYS, type: "range", min, max, step });
      const value = put(whole, "span", { class: "lab-value" });
      box.addEventListener("input", () => this.lab.edit((setup) => this.coat(setup, name, box.valueAsNumber)));
      return { name, whole, box, value, ...range };
    });
    this.switches = Object.entries(SWITCHES).map(([name, { label, isPlane }]) => {
      const parts = check(row, label, false, (isOn) => this.lab.edit((setup) => (setup[name] = isOn)));
      return { name, isPlane, ...parts };
    });
    put(shows, "span", {}, "Show");
    for (const [name, label] of Object.entries(SHOWN))
      check(shows, label, this.lab.shown[name], (isOn) => {
        this.lab.shown[name] = isOn;
        this.lab.refresh();
      });
  }

  /** A card of numbers for each body, if they are few. */
  deal() {
    const { bodies } = this.lab.setup;
    const isFew = bodies.length <= MOST_WITH_NUMBERS;
    this.adds.hidden = bodies.length >= MOST_WITH_NUMBERS;
    this.cards.replaceChildren();
    this.boxes = (isFew ? bodies : []).map((_, k) => {
      const card = put(this.cards, "fieldset");
      put(card, "legend", {}, `Body ${k + 1}`);
      const shape = select(card, "shape", SHAPE_NAMES, (value) => this.lab.edit((setup) => (setup.bodies[k].shape = value)));
      const fields = Object.entries(FIELDS).filter(([, { label }]) => label);
      const numbers = fields.map(([name, range]) => {
        const changed = (value) => this.lab.edit((setup) => (setup.bodies[k][name] = value));
        return { name, ...range, ...this.number(card, range.label, range, changed, `${range.label}, of body ${k + 1}`) };
      });
      const takes = button(card, "Remove", () => this.lab.edit((setup) => setup.bodies.splice(k, 1)));
      takes.setAttribute("aria-label", `Remove body ${k + 1}`);
      return { shape, numbers };
    });
  }

  /** Show the state of the lab. */
  show() {
    const isTrack = this.lab.setup.dimensions === 1;
    this.clock.textContent = `t = ${decimal(this.lab.count * DT)} s`;
    this.back.disabled = this.lab.count <= this.lab.saved[0][0];
    this.ways.box.value = isTrack ? "on a line" : "in the plane";
    for (const { name, box, value, whole, isPlane } of this.numbers) {
      box.value = this.lab.setup[name];
      value.textContent = this.lab.setup[name];
      whole.hidden = isPlane && isTrack;
    }
    for (const { name, box, whole, isPlane } of this.switches) {
      box.checked = Boolean(this.lab.setup[name]);
      whole.hidden = isPlane && isTrack;
    }
    this.boxes.forEach(({ shape, numbers }, k) => {
      shape.box.value = this.lab.setup.bodies[k].shape;
      for (const { name, box, whole, isPlane, isFixed, isPolygon } of numbers) {
        whole.hidden = (isPlane && isTrack) || (isPolygon && this.lab.setup.bodies[k].shape !== "polygon");
        const now = (isFixed ? this.lab.setup : this.lab.world).bodies[k][name];
        if (box !== this.lab.typing) box.value = Number(now.toFixed(4));
      }
    });
    this.speak();
  }

  speak() {
    const isTrack = this.lab.setup.dimensions === 1;
    const { mass, px, py, energy, potential, vx, vy } = this.lab.world.totals();
    const lost = this.lab.first.energy + this.lab.first.potential - energy - potential;
    const floor = -fallIn(this.lab.setup) * halfRoom(this.lab.setup)[1] * mass; // J, of bodies whose centres lie on it
    const height = fallIn(this.lab.setup) ? `, energy of height above the floor ${decimal(potential - floor)} J` : "";
    const parts = [
      `Momentum ${tuple(px, py, isTrack)} kg m/s`,
      `kinetic energy ${decimal(energy)} J${height}`,
      `energy lost since t = 0: ${decimal(lost)} J`,
      `velocity of the centre of mass ${tuple(vx, vy, isTrack)} m/s`,
    ];
    const words = `${parts.join("; ")}.${this.lab.account.struck()}`;
    this.words.textContent = words;
    const few = this.lab.setup.bodies.length <= MOST_WITH_NUMBERS ? this.each(isTrack) : "";
    this.lab.canvas.setAttribute("aria-label", `${this.lab.setup.bodies.length} bodies at ${decimal(this.lab.count * DT)} s. ${few}`);
    clearTimeout(this.waits);
    if (!this.lab.isRunning) this.waits = setTimeout(() => (this.told.textContent = `${this.clock.textContent}. ${few}${words}`), REST);
  }

  each(isTrack) {
    const say = ({ x, y, vx, vy }, k) => `Body ${k + 1} at ${tuple(x, y, isTrack)} m, velocity ${tuple(vx, vy, isTrack)} m/s. `;
    return this.lab.world.bodies.slice(0, this.lab.setup.bodies.length).map(say).join("");
  }
}

const OWN = "a set-up of your own";
const KEYS =
  "Keys on the picture: 1 to 8 choose a body, the arrows move it, Shift and the arrows change its velocity, + and \u2212 its size. " +
  "Drag the small square of a chosen body to change its size.";

const LAB_STYLE = `
  [data-lab] { max-width: 100%; font: 14px/1.4 sans-serif; }
  [data-lab] canvas { display: block; width: 100%; max-width: 56em; touch-action: pan-y; }
  [data-lab] canvas.lab-chart { touch-action: auto; }
  [data-lab] :is(details, ul) { margin: 8px 0; max-width: 56em; }
  [data-lab] ul { padding-left: 1.3em; font-variant-numeric: tabular-nums; }
  [data-lab] pre { white-space: pre-wrap; max-width: 56em; font-size: 13px; }
  [data-lab] :is(p, fieldset) { max-width: 56em; box-sizing: border-box; }
  [data-lab] summary { cursor: pointer; font-weight: bold; }
  [data-lab] .lab-row { display: flex; flex-wrap: wrap; gap: 6px 14px; align-items: center; margin: 8px 0; }
  [data-lab] .lab-row label { display: inline-flex; gap: 6px; align-items: center; }
  [data-lab] .lab-words { min-height: 4.2em; margin: 6px 0; font-variant-numeric: tabular-nums; }
  [data-lab] :is(button, input, select) { font: inherit; margin: 0; }
  [data-lab] :is(button, .lab-button) { padding: 4px 12px; min-width: 4.5em; }
  [data-lab] .lab-button { position: relative; background: ButtonFace; color: ButtonText; border: 1px solid ButtonBorder; border-radius: 3px; }
  [data-lab] .lab-button:focus-within { outline: 3px solid; outline-offset: 2px; }
  [data-lab] .lab-go { font-weight: bold; min-width: 6em; }
  [data-lab] .lab-value { font-variant-numeric: tabular-nums; font-weight: bold; min-width: 2.5em; display: inline-block; }
  [data-lab] input[type="range"] { width: 8em; vertical-align: middle; }
  [data-lab] fieldset { display: grid; grid-template-columns: repeat(auto-fill, minmax(7em, 1fr)); gap: 4px 12px;
    border: 1px solid color-mix(in srgb, currentColor 40%, transparent); margin: 6px 0; padding: 4px 10px 8px; align-items: end; }
  [data-lab] fieldset :is(input, select) { width: 100%; box-sizing: border-box; }
  [data-lab] fieldset label { display: grid; }
  [data-lab] .lab-plan { border-collapse: collapse; display: table; margin: 0; }
  [data-lab] .lab-plan :is(th, td) { text-align: left; vertical-align: top; font-weight: normal; padding: 2px 12px 2px 0; }
  [data-lab] .lab-plan td:nth-child(2) { white-space: nowrap; }
  [data-lab] .lab-plan tr:not(.lab-out) :is(th, td:nth-child(2)) { font-weight: bold; }
  [data-lab] a { color: inherit; text-decoration: underline; }
  [data-lab] [hidden] { display: none !important; }
  [data-lab] [role="alert"] { color: inherit; font-weight: bold; margin: 0; }
  [data-lab] .unseen { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  @media print { [data-lab] :is(button, fieldset, .lab-row) { display: none; } }
`;
