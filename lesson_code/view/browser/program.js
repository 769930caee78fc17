// The lesson's own functions in a page, compiled from the Python that it shows (see programs/).
//
//   const p = await load("formulas.wasm");
//   p.reflect([3, -4], [0, 1]);                    // [3, 4], as in Python
//
//   const pair = await load("geometry.wasm");      // a program that works on tables of rows
//   pair.a.radius = 0.5;                           // fields have the names they have in Python
//   pair.b.radius = 1;
//   pair.b.x = 1.25;
//   pair.run("look");
//   pair.manifold.penetration0;                    // 0.25
//
// A program tells itself what its functions take, and how its tables lie in memory.

const SECTION = "workbook"; // of the module, in which it tells this
const LINE = 64; // bytes; a table begins at a multiple of this
const PAGE = 65536; // bytes, by which a memory grows
const KINDS = { f8: "Float64", i4: "Int32", b1: "Uint8" }; // of NumPy, and of a DataView

/** Load a program from an address, or from the bytes of its file. */
export async function load(source) {
  const isBytes = source instanceof ArrayBuffer || ArrayBuffer.isView(source);
  const bytes = isBytes ? source : await (await fetch(source)).arrayBuffer();
  const module = await WebAssembly.compile(bytes);
  const [section] = WebAssembly.Module.customSections(module, SECTION);
  const about = JSON.parse(new TextDecoder().decode(section));
  return new Program(await WebAssembly.instantiate(module, { env: Math }), about);
}

class Program {
  constructor({ exports }, about) {
    this.about = about;
    this.exports = exports;
    this.end = exports.__heap_base.value; // of the memory in use
    this.result = this.reserve(16); // what an entry returns, then how it has failed
    this.words = this.reserve(16 * about.tables.length);
    this.tables = about.tables.map((table) => new Table(this, table));
    for (const table of this.tables) this[table.name] = table.isSingle ? table.at(0) : table;
    for (const [name, taken] of Object.entries(about.functions ?? {}))
      this[name] = (...given) => this.call(name, taken, given);
  }

  /** The memory; it is another object once it has grown. */
  get view() {
    if (this.seen?.buffer !== this.exports.memory.buffer)
      this.seen = new DataView(this.exports.memory.buffer);
    return this.seen;
  }

  /** Return the address of so many bytes that nothing else uses. They are zero. */
  reserve(bytes) {
    const address = Math.ceil(this.end / LINE) * LINE;
    this.end = address + bytes;
    const more = Math.ceil((this.end - this.exports.memory.buffer.byteLength) / PAGE);
    if (more > 0) this.exports.memory.grow(more);
    return address;
  }

  /** Run an entry on the tables, and return the number that it returns. */
  run(entry) {
    if (this.hasMoved) this.tell();
    if (this.exports[entry](this.result, this.result + 8, this.words))
      throw new Error(`${entry} has stopped at an error`);
    return this.view.getFloat64(this.result, true);
  }

  /** Write down where the tables are, and how long. */
  tell() {
    this.tables.forEach(({ address, length }, k) => {
      this.view.setBigUint64(this.words + 16 * k, BigInt(address), true);
      this.view.setBigUint64(this.words + 16 * k + 8, BigInt(length), true);
    });
    this.hasMoved = false;
  }

  /** Make steps; the tables must be as engine/core/tables.py makes them. The record of impulses is
   *  handed to `take` when it is full and at the end, and then emptied. */
  advance(steps, take = () => {}) {
    const { state } = this;
    state.steps_left = steps;
    while (!this.run("advance")) {
      if (state.lost_body >= 0)
        throw new RangeError(`body ${state.lost_body} has left the range of floating point`);
      this.hand(take);
      this.grow();
    }
    this.hand(take);
  }

  /** Go on until a time, from event to event, and note the states of all discs at the moments
   *  before it. Returns whether a collision has stopped it, as state.stops_at_collision asks. */
  advanceTo(until, take = () => {}) {
    const { state, impulses } = this;
    const { stops, events_a_call, record_rows } = this.about.events;
    state.until = Math.min(until, Number.MAX_VALUE);
    for (;;) {
      const stop = this.run("advance");
      if (stop === stops.NO_END)
        throw new Error(`the exact solver finds no end of the collisions at ${state.now} s`);
      if (stop === stops.NO_ORDER)
        throw new Error(`the exact solver finds no order of two collisions at ${state.now} s`);
      if (stop === stops.PAUSE) {
        state.events_left = events_a_call;
        continue;
      }
      this.hand(take);
      if (stop !== stops.RECORD_FULL) return stop === stops.COLLISION;
      impulses.resize(Math.min(2 * impulses.length + 1, record_rows));
    }
  }

  hand(take) {
    if (this.state.impulse_count > 0) take(this.impulses, this.state.impulse_count);
    this.state.impulse_count = 0;
  }

  /** Give each table that was too small the rows that it wants, and some to grow into. */
  grow() {
    const { wanted, spare, large, large_spare, fewest_rows, ...most } = this.about.capacity;
    const { state, bodies } = this;
    if (state.pairs_wanted > most.pairs_per_body * bodies.length + most.pairs_anyway)
      throw new RangeError(
        "bodies must not be heaped into one another: " +
          `${bodies.length} of them overlap in ${state.pairs_wanted} pairs or more`,
      );
    for (const [field, tables] of Object.entries(wanted)) {
      const rows = state[field];
      if (rows === 0) continue;
      const more = Math.max(fewest_rows, Math.trunc((rows < large ? spare : large_spare) * rows));
      for (const name of tables) if (this[name].length < more) this[name].resize(more);
      state[field] = 0;
    }
  }

  /** Call a function: numbers, [x, y] for a vector, [[x, y], ...] for a polygon. */
  call(name, taken, given) {
    if (given.length > taken.length)
      throw new TypeError(`${name} takes ${taken.length} arguments, got ${given.length}`);
    const numbers = [];
    taken.forEach(([argument, kind, otherwise], k) => {
      const value = given[k] === undefined ? otherwise : given[k];
      if (!IS[kind](value))
        throw new TypeError(`${argument} must be ${WORDS[kind]}, got ${JSON.stringify(value)}`);
      if (kind !== "polygon") return numbers.push(...[value].flat());
      this.corners.resize(value.length);
      value.forEach(([x, y], corner) => Object.assign(this.corners.at(corner), { x, y }));
    });
    this.numbers.resize(Math.max(numbers.length, 2));
    numbers.forEach((value, place) => (this.numbers.at(place).value = value));
    const count = this.run(name);
    const results = Array.from({ length: count }, (_, place) => this.numbers.at(place).value);
    return count === 1 ? results[0] : results;
  }
}

const isNumber = (value) => typeof value === "number" && !Number.isNaN(value);
const isVector = (value) => Array.isArray(value) && value.length === 2 && value.every(isNumber);
const isPolygon = (value) => Array.isArray(value) && value.length > 2 && value.every(isVector);
const IS = { number: isNumber, vector: isVector, polygon: isPolygon };
const WORDS = {
  number: "a number",
  vector: "[x, y]",
  polygon: "a list of at least three corners [x, y]",
};

/** Where a row lies in its table: no name, since a field may have any. */
const PLACE = Symbol("place");

/** A table of rows. A row is an object with the fields that it has in Python. */
class Table {
  constructor(program, { name, single, bytes, fields }) {
    Object.assign(this, { program, name, isSingle: single, bytes, length: 0, capacity: 0 });
    this.starts = Object.entries(fields).filter(([, [, , start]]) => start !== undefined);
    this.Row = class {
      constructor(place) {
        this[PLACE] = place;
      }
    };
    const table = this;
    for (const [field, [offset, kind]] of Object.entries(fields)) {
      const [get, set] = [`get${KINDS[kind]}`, `set${KINDS[kind]}`];
      Object.defineProperty(this.Row.prototype, field, {
        get() {
          const value = program.view[get](table.address + bytes * this[PLACE] + offset, true);
          return kind === "b1" ? value === 1 : value;
        },
        set(value) {
          program.view[set](table.address + bytes * this[PLACE] + offset, value, true);
        },
        enumerable: true,
      });
    }
    this.address = program.reserve(0);
    if (single) this.resize(1);
  }

  /** Return a row, whose fields can be read and written. It stays the row of this place. */
  at(place) {
    if (!(place >= 0 && place < this.length))
      throw new RangeError(`${this.name} must have a row ${place}, but has ${this.length}`);
    return new this.Row(place);
  }

  /** Give the table so many rows. Those that it had stay; a new one begins as it does in Python. */
  resize(rows) {
    const had = this.length;
    if (rows > this.capacity) {
      const address = this.program.reserve(rows * this.bytes);
      const memory = new Uint8Array(this.program.exports.memory.buffer);
      memory.copyWithin(address, this.address, this.address + had * this.bytes);
      Object.assign(this, { address, capacity: rows });
    }
    this.length = rows;
    this.program.hasMoved = true;
    if (rows <= had) return;
    const from = this.address + had * this.bytes;
    new Uint8Array(this.program.exports.memory.buffer, from, (rows - had) * this.bytes).fill(0);
    for (const [field, [, , start]] of this.starts)
      for (let place = had; place < rows; place++) this.at(place)[field] = Number(start);
  }
}
