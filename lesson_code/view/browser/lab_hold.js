// What a hand takes hold of in the collision lab: a body, the tip of its velocity, the handle of its
// size; by pointer, finger or keys.

const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const SIZES = { "+": 1, "=": 1, "-": -1 };

class Hold {
  constructor(lab) {
    this.lab = lab;
    this.pointer();
    lab.canvas.addEventListener("keydown", (event) => this.key(event) && event.preventDefault());
  }

  /** Choose, move, throw or scale a body by a key; return whether the key was one for that. */
  key({ key, shiftKey, altKey, ctrlKey, metaKey }) {
    const { lab } = this;
    if (altKey || ctrlKey || metaKey || lab.setup.bodies.length > MOST_WITH_NUMBERS) return false;
    if (key === "Escape") return lab.choose(null);
    if (lab.setup.bodies[key - 1]) return lab.choose(key - 1);
    const [way, grows] = [WAYS[key], SIZES[key]];
    if ((!way && !grows) || !lab.setup.bodies.length) return false;
    if (!lab.chosen) lab.choose(0);
    const change = (one, name, by) => (one[name] = limited(rounded(one[name] + by, 0.05), FIELDS[name]));
    lab.edit(({ dimensions, bodies }) => {
      const one = bodies[lab.chosen.k];
      if (grows) return change(one, "size", 0.05 * grows);
      const [right, up] = dimensions === 1 ? [way[0], 0] : way;
      change(one, shiftKey ? "vx" : "x", right * (shiftKey ? 0.1 : 0.05));
      change(one, shiftKey ? "vy" : "y", up * (shiftKey ? 0.1 : 0.05));
    });
    return true;
  }

  pointer() {
    const { canvas } = this.lab;
    let held = null;
    const start = (event) => {
      const [x, y] = this.pointed(event);
      held = this.under(x, y);
      this.lab.choose(held ? held.k : null);
      return held !== null;
    };
    canvas.addEventListener("touchstart", (event) => start(event.touches[0]) && event.preventDefault(), { passive: false });
    canvas.addEventListener("pointerdown", (event) => {
      if (!start(event)) return;
      this.lab.typing = null;
      this.lab.run(false);
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
    const { left, top, width, height } = this.lab.canvas.getBoundingClientRect();
    return [(clientX - left - width / 2) / this.lab.picture.scale, (top + height / 2 - clientY) / this.lab.picture.scale];
  }

  /** Return where the handle is that sets the size of the chosen body. */
  handle() {
    const { k } = this.lab.chosen;
    const { x, y, angle } = this.lab.world.bodies[k];
    const { size } = this.lab.setup.bodies[k];
    return [x + size * Math.cos(angle), y + size * Math.sin(angle)];
  }

  /** Return whether a point lies on that handle, and nearer to it than to the body's centre. */
  isOnHandle(x, y) {
    if (!this.lab.chosen) return false;
    const [hx, hy] = this.handle();
    const centre = this.lab.world.bodies[this.lab.chosen.k];
    const away = Math.hypot(x - hx, y - hy);
    return away * this.lab.picture.scale <= GRIP && away < Math.hypot(x - centre.x, y - centre.y);
  }

  under(x, y) {
    if (this.isOnHandle(x, y)) return { k: this.lab.chosen.k, isSize: true };
    const bodies = this.lab.world.bodies.slice(0, this.lab.setup.bodies.length);
    const isNear = (px, py, reach) => Math.hypot(x - px, y - py) <= reach;
    const tip = ({ x, y, vx, vy }) => [x + ARROW * vx, y + ARROW * vy];
    const has = (k) => {
      const { x, y } = bodies[k];
      return [k, isNear(x, y, Math.max(this.lab.setup.bodies[k].size, GRIP / this.lab.picture.scale)), isNear(...tip(bodies[k]), GRIP / this.lab.picture.scale)];
    };
    const found = bodies.map((_, k) => has(k));
    const showsTips = this.lab.shown.velocities && bodies.length <= MOST_WITH_ARROWS;
    const byTip = showsTips && found.find(([k, isIn, isTip]) => isTip && Math.hypot(bodies[k].vx, bodies[k].vy) * ARROW * this.lab.picture.scale > GRIP);
    const chosen = byTip || found.find(([, isIn]) => isIn);
    if (!chosen) return null;
    const [k] = chosen;
    return { k, isTip: Boolean(byTip), from: [x - bodies[k].x, y - bodies[k].y] };
  }

  drag({ k, isTip, isSize, from }, x, y) {
    const [wide, high] = halfRoom(this.lab.setup);
    const isTrack = this.lab.setup.dimensions === 1;
    this.lab.edit(({ bodies, walls }) => {
      const one = bodies[k];
      const inside = (value, half) => (walls ? Math.max(-half, Math.min(half, value)) : value);
      if (isSize) {
        one.size = limited(rounded(Math.hypot(x - one.x, y - one.y), 0.05), FIELDS.size);
      } else if (isTip) {
        one.vx = limited(rounded((x - one.x) / ARROW, 0.1), FIELDS.vx);
        one.vy = isTrack ? 0 : limited(rounded((y - one.y) / ARROW, 0.1), FIELDS.vy);
      } else {
        one.x = inside(rounded(x - from[0], 0.05), wide - one.size);
        one.y = isTrack ? 0 : inside(rounded(y - from[1], 0.05), high - one.size);
      }
    });
  }
}
