// The account that the collision lab keeps: momenta tip to tail before and after the last impact, the
// impulse of each contact, graphs over time, and all values as CSV.

const MOST_LISTED = 12;
const MOST_DRAWN = 600; // points of a line
const DASHES = [[], [7, 4], [2, 3], [9, 3, 2, 3]]; // a cue beside colour
const EDGE = { left: 52, right: 60, top: 34, bottom: 30 }; // pixels around a graph
const NARROW = 480; // pixels
const BELOW = 16; // pixels from one arrow to the next, where all lie on a line
const SLIPS = 1e-9; // of Coulomb's limit, and m/s: rounding, where friction stands at it, or nothing slides

const each = (name, letter) => ({ bodies }) => (bodies ?? []).slice(0, MOST_WITH_NUMBERS).map((one, k) => [`${letter}${k + 1}`, one[name]]);
const GRAPHS = {
  "Energy, J": ({ energy, potential }, first) => [
    ["kinetic", energy],
    ["height", potential - first.potential],
    ["sum", energy + potential - first.potential],
  ],
  "Momentum of all, kg m/s": ({ px, py }) => [["x", px], ["y", py]],
  "Momentum x of each body, kg m/s": each("px", "p"),
  "Momentum y of each body, kg m/s": each("py", "p"),
  "Position x of each body, m": each("x", "x"),
  "Position y of each body, m": each("y", "y"),
};

/** Return the contact with the largest impulse along its normal. */
const strongest = (contacts) => contacts.reduce((most, one) => (one.normal_impulse > most.normal_impulse ? one : most));

class Account {
  constructor(lab) {
    this.lab = lab;
    this.momenta = part(lab, "Momenta and impulses", true);
    this.chain = put(this.momenta, "canvas", { role: "img", class: "lab-chart" });
    this.list = put(this.momenta, "ul");
    this.graphs = part(lab, "Graphs and values", false);
    this.kind = select(this.graphs, "Show", Object.keys(GRAPHS), () => this.show());
    button(this.graphs, "Save the values as CSV", () => this.download());
    this.graph = put(this.graphs, "canvas", { role: "img", class: "lab-chart" });
    for (const canvas of [this.chain, this.graph]) new ResizeObserver(() => this.show()).observe(canvas);
  }

  show() {
    if (!this.lab.history?.length) return;
    if (this.momenta.open) this.showMomenta();
    if (this.graphs.open) this.showGraph();
  }

  /** Say what the strongest contact of the last impact gave. */
  struck() {
    const { hit } = this.lab;
    if (!hit) return "";
    return ` At ${decimal(hit.count * DT)} s ${this.told(strongest(hit.contacts))}.`;
  }

  told({ a, b, normal_impulse, tangent_impulse }) {
    const name = (k) => (k < this.lab.setup.bodies.length ? `body ${k + 1}` : "a wall");
    const rubbed = tangent_impulse === 0 ? "" : ` and ${decimal(Math.abs(tangent_impulse))} N s of friction`;
    return `${name(a)} and ${name(b)} gave each other ${decimal(normal_impulse)} N s${rubbed}`;
  }

  /** Return whether a contact sticks, or slips on: then friction stands at Coulomb's limit, and the bodies
   *  still slide. */
  grip({ row, normal_impulse, tangent_impulse, slip }) {
    if (!row?.friction) return "";
    const isSpent = Math.abs(tangent_impulse) >= row.friction * normal_impulse * (1 - SLIPS);
    return isSpent && Math.abs(slip) > SLIPS ? `, slips on at ${decimal(Math.abs(slip))} m/s` : ", sticks";
  }

  /** Return the momenta of the bodies before the last impact and after it, or only those of now. */
  sides() {
    const { history, hit } = this.lab;
    const at = (title, row) => ({ title, bodies: row?.bodies ?? [], sum: [row?.px ?? 0, row?.py ?? 0] });
    return hit ? [at("before", history[hit.count - 1]), at("after", history[hit.count])] : [at("now", history.at(-1))];
  }

  showMomenta() {
    const sides = this.sides();
    const { hit } = this.lab;
    const isTrack = this.lab.setup.dimensions === 1;
    const say = (x, y) => tuple(x, y, isTrack);
    const sums = sides.map(({ title, sum }) => `${title} ${say(...sum)}`).join(", ");
    const lines = [`${hit ? `Last impact at ${decimal(hit.count * DT)} s. ` : ""}Sum of the momenta, kg m/s: ${sums}.`];
    if (hit && this.lab.setup.gravity) lines[0] += ` Between the two lies a step of ${decimal(DT, 3)} s, in which gravity acts, too.`;
    if (sides.length === 2) {
      const [before, after] = sides;
      before.bodies.slice(0, MOST_WITH_NUMBERS).forEach((one, k) => {
        const then = after.bodies[k];
        const change = say(then.px - one.px, then.py - one.py);
        lines.push(`Body ${k + 1}: ${say(one.px, one.py)} before, ${say(then.px, then.py)} after, change ${change} kg m/s.`);
      });
      for (const contact of hit.contacts.slice(0, MOST_LISTED)) {
        const where = `at ${tuple(contact.x, contact.y)} m, normal ${tuple(contact.nx, contact.ny)}`;
        lines.push(`Contact ${where}: ${this.told(contact)}${this.grip(contact)}.`);
      }
      const more = hit.contacts.length - MOST_LISTED;
      if (more > 0) lines.push(`And ${more} contacts more.`);
    }
    this.list.replaceChildren(...lines.map((line) => made("li", {}, line)));
    this.chain.setAttribute("aria-label", `Momenta tip to tail. ${lines[0]}`);
    this.drawMomenta(sides, isTrack);
  }

  /** Draw the momenta tip to tail, with their sum from the first tail to the last tip. */
  drawMomenta(sides, isTrack) {
    const isNarrow = this.chain.clientWidth < NARROW; // then one side stands below the other
    const height = 170;
    const sheet = this.sheet(this.chain, isNarrow ? height * sides.length : height);
    if (!sheet) return;
    const { pen, width } = sheet;
    const chains = sides.map(({ bodies }) => bodies.reduce((points, { px, py }) => {
      const [x, y] = points.at(-1);
      return [...points, [x + px, isTrack ? 0 : y + py]];
    }, [[0, 0]]));
    const range = (axis) => [0, 1].map((end) => Math[end ? "max" : "min"](...chains.flat().map((point) => point[axis])));
    const [[left, right], [low, high]] = [range(0), range(1)];
    const wide = isNarrow ? width : width / sides.length;
    const room = isTrack ? BELOW * chains[0].length : 0; // pixels: on a line the arrows stand below each other
    const scale = Math.min((wide - 100) / (right - left || 1), (height - 70) / (high - low || 1));
    sides.forEach(({ title }, side) => {
      const [from, top] = isNarrow ? [0, side * height] : [side * wide, 0];
      const at = ([x, y], row) => [
        from + wide / 2 + scale * (x - (left + right) / 2),
        top + 20 + (height - 20) / 2 - scale * (y - (low + high) / 2) + (isTrack ? BELOW * row - room / 2 : 0),
      ];
      pen.fillStyle = sheet.ink;
      pen.textAlign = "left";
      pen.fillText(title, from + 8, top + 12);
      const points = chains[side];
      const isNamed = points.length <= MOST_WITH_NUMBERS + 1;
      points.slice(1).forEach((tip, k) => {
        const name = isNamed ? `p${k + 1}` : "";
        this.shaft(sheet, at(points[k], k), at(tip, k), { color: this.colored(k), name, isBeyond: isTrack });
      });
      const [tail, tip] = [points[0], points.at(-1)].map((point) => at(point, points.length));
      this.shaft(sheet, tail, tip, { color: sheet.ink, name: "sum", isBeyond: true, dash: [5, 4] });
    });
  }

  /** Draw an arrow, named beyond its tip or in its middle. */
  shaft({ pen, ink }, [x, y], [tx, ty], { color, name, isBeyond, dash = [] }) {
    const length = Math.hypot(tx - x, ty - y);
    if (length < 1) return;
    const [ux, uy] = [(tx - x) / length, (ty - y) / length];
    const head = Math.min(9, length);
    Object.assign(pen, { strokeStyle: color, lineWidth: 2.5, fillStyle: ink, textAlign: "center" });
    pen.setLineDash(dash);
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(tx, ty);
    pen.stroke();
    pen.setLineDash([]);
    pen.beginPath();
    for (const side of [1, -1]) {
      pen.moveTo(tx, ty);
      pen.lineTo(tx - head * (ux - 0.5 * side * uy), ty - head * (uy + 0.5 * side * ux));
    }
    pen.stroke();
    if (isBeyond) pen.fillText(name, tx + 20 * ux, ty + 12 * uy);
    else pen.fillText(name, (x + tx) / 2 + 16 * uy, (y + ty) / 2 - 12 * Math.abs(ux));
  }

  showGraph() {
    const { history } = this.lab;
    const title = this.kind.box.value;
    const rows = history.map((row) => GRAPHS[title](row, history[0]));
    const names = rows[0].map(([name]) => name);
    const last = rows.at(-1).map(([name, value]) => `${name} ${decimal(value)}`).join(", ");
    const end = `${title}, over ${decimal((history.length - 1) * DT)} s`;
    this.graph.setAttribute("aria-label", names.length ? `${end}: at the end ${last}.` : `${end}: too many bodies for lines of their own.`);
    const sheet = this.sheet(this.graph, 220);
    if (sheet) this.drawGraph(sheet, title, names, rows);
  }

  drawGraph(sheet, title, names, rows) {
    const { pen, width, height, ink } = sheet;
    const values = rows.flat().map(([, value]) => value);
    let [low, high] = [0, 0];
    for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
    if (high - low < 1e-9) high = low + 1;
    const duration = Math.max((rows.length - 1) * DT, 1);
    const x = (time) => EDGE.left + (time / duration) * (width - EDGE.left - EDGE.right);
    const y = (value) => height - EDGE.bottom - ((value - low) / (high - low)) * (height - EDGE.top - EDGE.bottom);
    Object.assign(pen, { strokeStyle: ink, fillStyle: ink, lineWidth: 1, textAlign: "left" });
    pen.fillText(names.length ? title : `${title}: too many bodies`, 8, 12);
    pen.globalAlpha = 0.5;
    pen.strokeRect(x(0), y(high), x(duration) - x(0), y(low) - y(high));
    pen.beginPath();
    pen.moveTo(x(0), y(0));
    pen.lineTo(x(duration), y(0));
    pen.stroke();
    pen.globalAlpha = 1;
    pen.textAlign = "right";
    for (const value of new Set([low, 0, high])) pen.fillText(decimal(value, 1), EDGE.left - 6, y(value));
    pen.textAlign = "center";
    pen.fillText("0", x(0), height - EDGE.bottom + 14);
    pen.fillText(`${decimal(duration, 1)} s`, x(duration), height - EDGE.bottom + 14);
    const stride = Math.ceil(rows.length / MOST_DRAWN);
    let lowest = Infinity; // of the names at the ends of the lines, which keep clear of each other
    const ends = names.map((name, k) => [name, k, y(rows.at(-1)[k][1])]).sort((a, b) => b[2] - a[2]);
    for (const [name, k, place] of ends) {
      pen.strokeStyle = this.colored(k);
      pen.lineWidth = 2;
      pen.setLineDash(DASHES[k % DASHES.length]);
      pen.beginPath();
      rows.forEach((row, n) => (n % stride === 0 || n === rows.length - 1) && pen.lineTo(x(n * DT), y(row[k][1])));
      pen.stroke();
      pen.setLineDash([]);
      lowest = Math.min(place, lowest - 14);
      pen.textAlign = "left";
      pen.fillText(name, x((rows.length - 1) * DT) + 4, lowest);
    }
  }

  colored(k) {
    return this.lab.picture.colors[LAB_COLORS[k % LAB_COLORS.length]];
  }

  /** Return a clean canvas with its pen, or null where it is not seen. */
  sheet(canvas, height) {
    const width = canvas.clientWidth;
    if (width === 0 || !this.lab.picture?.colors) return null;
    Object.assign(canvas, { width: Math.round(width * devicePixelRatio), height: Math.round(height * devicePixelRatio) });
    canvas.style.height = `${height}px`;
    const pen = canvas.getContext("2d");
    pen.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    Object.assign(pen, { font: "13px sans-serif", textBaseline: "middle" });
    return { pen, width, height, ink: getComputedStyle(canvas).color };
  }

  /** Return the values of every step as CSV. */
  csv() {
    const { history } = this.lab;
    const one = ["x", "y", "angle", "vx", "vy", "w"];
    const sums = ["energy", "potential", "px", "py", "x", "y"];
    const heads = ["time", "kinetic_energy", "potential_energy", "momentum_x", "momentum_y", "centre_x", "centre_y"];
    const of = (history[0].bodies ?? []).flatMap((_, k) => one.map((name) => `${name}_${k + 1}`));
    const lines = history.map((row, count) => [
      count * DT,
      ...sums.map((name) => row[name]),
      ...(row.bodies ?? []).flatMap((values) => one.map((name) => values[name])),
    ]);
    return [[...heads, ...of], ...lines].map((line) => `${line.join(",")}\n`).join("");
  }

  download() {
    const href = URL.createObjectURL(new Blob([this.csv()], { type: "text/csv" }));
    made("a", { href, download: "collision_lab.csv" }).click();
    setTimeout(() => URL.revokeObjectURL(href));
  }
}
