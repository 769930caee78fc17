// The collision lab: bodies to throw at each other. The stepped engine of the course moves them
// (world.js). What it begins with is in lab_setup.js; lab_picture.js draws it, lab_hold.js lets it
// be dragged, lab_controls.js set by number; lab_account.js adds up momenta, impulses and energy;
// lab_plan.js says which effects the scene calls for; lab_code.js shows the formulas with the
// numbers of a contact, and lab_python.js writes the set-up as Python.

/** Bring the lab to life in its place, with the engine, the formulas, and the text of their functions. */
export function startLab(program, formulas, functions, rules) {
  for (const place of document.querySelectorAll("[data-lab]:not([data-ready])")) new Lab(place, program, formulas, functions, rules);
}

class Lab {
  constructor(place, program, formulas, functions, rules) {
    const shown = { velocities: true, momenta: false, centre: false, paths: false };
    Object.assign(this, { place, program, isRunning: false, chosen: null, shown });
    place.setAttribute("data-ready", "");
    place.replaceChildren(made("style", {}, LAB_STYLE));
    put(place, "p", {}, HANDS);
    this.canvas = put(place, "canvas", { ...FREE_KEYS, role: "application", tabindex: 0 });
    this.controls = new Controls(this);
    this.account = new Account(this);
    this.plan = new PlanOfEffects(this, rules);
    this.code = new Code(this, formulas, functions);
    this.python = new AsPython(this);
    this.picture = new Picture(this, this.canvas);
    this.hold = new Hold(this);
    const draw = () => this.draw();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
    new MutationObserver(draw).observe(document.documentElement, { attributes: true });
    window.addEventListener("hashchange", () => this.read());
    if (!this.read()) this.openPreset(FIRST);
  }

  another() {
    return body(0, this.setup.dimensions === 1 ? 0 : 1.5, 0, 0, { size: 0.3 });
  }

  /** Choose a body for the keys and for its size, or none; return true. */
  choose(k) {
    this.chosen = k === null || this.setup.bodies.length > MOST_WITH_NUMBERS ? null : { k };
    this.picture.draw();
    return true;
  }

  refresh() {
    this.controls.show();
    this.draw();
  }

  draw() {
    this.picture.draw();
    this.account.show();
    this.plan.show();
    this.code.show();
    this.python.show();
  }

  // What happens

  /** Begin with a set-up; `name` is that of its preset. */
  open(setup, name = OWN) {
    this.run(false);
    this.begin(setup);
    this.controls.preset.box.value = name;
    this.controls.deal();
    this.refresh();
  }

  openPreset(name) {
    this.open(PRESETS[name](), name);
  }

  begin(setup) {
    this.setup = setup;
    if (this.chosen && this.chosen.k >= setup.bodies.length) this.chosen = null;
    this.world = scene(this.program, sceneOf(setup));
    Object.assign(this, { count: 0, saved: [[0, this.world.save(), null]], history: [], hit: null });
    this.first = this.world.totals();
    this.note();
    const { link } = this.controls;
    link.hidden = setup.bodies.length > MOST_WITH_ARROWS; // it would be longer than some take
    if (!link.hidden) link.href = `#lab=${encodeURIComponent(JSON.stringify(setup))}`;
    this.controls.error.textContent = "";
  }

  /** Read the set-up that the address holds; return whether it holds one. */
  read() {
    const found = /^#lab=(.*)$/.exec(location.hash);
    if (!found) return false;
    try {
      this.open(understood(JSON.parse(decodeURIComponent(found[1]))));
      return true;
    } catch (error) {
      if (!this.setup) this.openPreset(FIRST);
      this.controls.error.textContent = `The link holds no set-up: ${error.message}`;
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
    this.controls.preset.box.value = OWN;
    if (before !== setup.bodies.length) this.controls.deal();
    this.refresh();
  }

  /** Let a number of steps have been made, more or fewer than now. */
  go(count) {
    if (count < this.saved[0][0]) return;
    try {
      if (count < this.count) {
        while (this.saved.at(-1)[0] > count) this.saved.pop();
        const [at, state, hit] = this.saved.at(-1);
        this.world.restore(state);
        Object.assign(this, { count: at, hit });
        this.history.length = at + 1;
      }
      while (this.count < count) this.advance();
    } catch (error) {
      this.run(false);
      this.controls.error.textContent = error.message;
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
    this.saved.push([this.count, this.world.save(), this.hit]);
    const bytes = this.saved[0][1].tables.reduce((sum, table) => sum + table.byteLength, 0);
    if (this.saved.length * bytes > MOST_SAVED) this.saved.shift();
  }

  /** Note the sums, and of few bodies where each is; and the contacts of this step. */
  note() {
    const { world, count } = this;
    const few = this.setup.bodies.length <= MOST_WITH_ARROWS ? this.setup.bodies : null;
    const bodies = few?.map(({ mass }, k) => {
      const { x, y, vx, vy, angle, w } = world.bodies[k];
      return { x, y, vx, vy, angle, w, px: mass * vx, py: mass * vy };
    });
    this.history[count] = { ...world.totals(), bodies };
    if (world.impulses.length > 0) this.hit = { count, contacts: world.impulses.map((one) => this.noted(one)) };
  }

  /** Return a contact with its row, and how fast its bodies slide there after the step, m/s. */
  noted(contact) {
    const row = this.rowOf(contact);
    if (!row) return { ...contact, row, slip: 0 };
    const [a, b] = [row.a, row.b].map((k) => this.world.bodies[k]);
    const slip = (a.vx - b.vx) * row.ny + (b.vy - a.vy) * row.nx + b.w * row.rb_x_t - a.w * row.ra_x_t;
    return { ...contact, row, slip };
  }

  /** Return a copy of the engine's row of a contact: the pair's own, of two points that with this impulse. */
  rowOf({ a, b, normal_impulse }) {
    const { contacts, state } = this.program;
    let found = null;
    for (let k = 0; k < state.contact_count; k++) {
      const row = contacts.at(k);
      if (row.a === a && row.b === b && (!found || row.normal_impulse === normal_impulse)) found = copyOf(row);
    }
    return found;
  }

  run(isRunning) {
    if (isRunning === this.isRunning) return;
    this.isRunning = isRunning;
    this.controls.runs.textContent = isRunning ? "Pause" : "Run";
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
}

const FIRST = "Oblique hit";
const HANDS = "Drag a body, or the tip of its arrow. Then press Run.";
