// The code that has just run: the lesson's formulas as they stand in Python, called once more with the
// numbers of the strongest contact of the last impact, beside what the engine gave it.

const AGREES = 1e-9; // of the impulse: far above rounding

class Code {
  /** Take the lesson's formulas, as a program and as the text of their functions. */
  constructor(lab, formulas, functions) {
    Object.assign(this, { lab, formulas });
    this.part = part(lab, "The code that has just run", false);
    put(this.part, "pre", {}, functions);
    this.calls = put(this.part, "pre", { class: "lab-calls" });
    this.words = put(this.part, "p");
  }

  show() {
    if (!this.part.open || !this.lab.history?.length) return;
    const contact = this.lab.hit && strongest(this.lab.hit.contacts);
    const before = contact && this.lab.history[this.lab.hit.count - 1]?.bodies;
    this.calls.hidden = !before;
    if (before) this.call(contact, before);
    else this.words.textContent = contact ? "So many bodies keep no velocities of their own." : "No two bodies have met yet.";
  }

  /** Call the formulas with the numbers of a contact, and compare. */
  call({ row, normal_impulse, tangent_impulse }, before) {
    const { bodies } = this.lab.world;
    const [a, b] = [row.a, row.b].map((k) => {
      const { inv_m, inv_i } = bodies[k];
      return { vx: 0, vy: 0, w: 0, ...before[k], inv_m, inv_i };
    });
    const normal = [row.nx, row.ny];
    const along = ([x, y], to_a, to_b) => (b.vx - a.vx) * x + (b.vy - a.vy) * y + b.w * to_b - a.w * to_a;
    const calls = [];
    const called = (result, name, given) => {
      const value = this.formulas[name](...Object.values(given));
      const said = Object.entries(given).map(([key, number]) => `${key}=${digits(number)}`);
      calls.push(`${result} = ${name}(${said.join(", ")})\n# ${result} = ${digits(value)}`);
      return value;
    };
    const yielding = { inv_m_a: a.inv_m, inv_m_b: b.inv_m, inv_i_a: a.inv_i, inv_i_b: b.inv_i };
    const arms = (to_a, to_b) => ({ ...yielding, ra_x_n: to_a, rb_x_n: to_b });
    const m_eff = called("m_eff", "effective_mass", arms(row.ra_x_n, row.rb_x_n));
    const vn = along(normal, row.ra_x_n, row.rb_x_n);
    const jn = called("jn", "normal_impulse", { vn, m_eff, restitution: row.restitution, accumulated: 0 });
    const found = [[jn, normal_impulse]];
    if (row.friction > 0) {
      const m_eff_t = called("m_eff_t", "effective_mass", arms(row.ra_x_t, row.rb_x_t));
      const vt = along([-row.ny, row.nx], row.ra_x_t, row.rb_x_t) + row.skew * jn;
      const given = { vt, m_eff_t, friction: row.friction, normal_impulse: jn, accumulated: 0 };
      found.push([called("jt", "friction_impulse", given), tangent_impulse]);
    }
    const agree = found.every(([ours, given]) => Math.abs(ours - given) <= AGREES * Math.max(Math.abs(jn), normal_impulse));
    const gave = `The engine gave this contact jn = ${digits(normal_impulse)} N s` + (row.friction > 0 ? `, jt = ${digits(tangent_impulse)} N s.` : ".");
    const why =
      "It is more than one impact by itself: gravity acted in the same step, or contacts that share a body were visited again and again until they agreed.";
    this.calls.textContent = calls.join("\n");
    this.words.textContent = `${gave} ${agree ? "That is what the formulas say." : why}`;
  }
}

/** Return a number with at most six digits, as Python takes it. */
const digits = (value) => String(Number(value.toPrecision(6)));
