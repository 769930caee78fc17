// The picture of the collision lab: bodies, walls, arrows, paths, the centre of mass.

/** Return the distance from a body's centre to its farthest point, m. */
const reachOf = ({ shape, size }) => (shape === "box" ? Math.SQRT2 * size : size);

const BESIDE = 13; // pixels from one letter to the next

class Picture {
  constructor(lab, canvas) {
    Object.assign(this, { lab, canvas });
    new ResizeObserver(() => this.draw()).observe(canvas);
  }

  draw() {
    const { canvas } = this;
    if (!this.lab.world || canvas.clientWidth === 0) return;
    const [wide, high] = halfRoom(this.lab.setup);
    canvas.style.aspectRatio = `${2 * wide + 0.2} / ${2 * high + 0.2}`;
    const ratio = devicePixelRatio;
    const [width, height] = [canvas.clientWidth, (canvas.clientWidth * (2 * high + 0.2)) / (2 * wide + 0.2)];
    const [pixels, lines] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== pixels || canvas.height !== lines) Object.assign(canvas, { width: pixels, height: lines });
    const style = getComputedStyle(canvas);
    this.ink = style.color;
    this.colors ??= Object.fromEntries(LAB_COLORS.map((name) => [name, style.getPropertyValue(`--${name}`)]));
    this.scale = width / (2 * wide + 0.2);
    const pen = (this.pen = canvas.getContext("2d"));
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.setTransform(ratio * this.scale, 0, 0, -ratio * this.scale, (ratio * width) / 2, (ratio * height) / 2);
    this.place2d = pen.getTransform();
    this.drawWalls(wide, high);
    this.lab.setup.bodies.forEach((one, k) => this.drawBody(one, this.lab.world.bodies[k], k));
    if (this.lab.shown.paths) this.drawPaths();
    if (this.lab.shown.centre) this.drawCentre();
    this.lab.setup.bodies.forEach((one, k) => this.drawArrows(one, this.lab.world.bodies[k]));
    if (this.lab.chosen) this.drawChosen();
  }

  drawWalls(wide, high) {
    const { pen } = this;
    pen.strokeStyle = this.ink;
    pen.lineWidth = 3 / this.scale;
    pen.globalAlpha = this.lab.setup.walls ? 0.9 : 0.15;
    pen.strokeRect(-wide, -high, 2 * wide, 2 * high);
    if (this.lab.setup.dimensions === 1) {
      pen.globalAlpha = 0.3;
      pen.lineWidth = 1 / this.scale;
      pen.beginPath();
      pen.moveTo(-wide, 0);
      pen.lineTo(wide, 0);
      pen.stroke();
    }
    pen.globalAlpha = 1;
  }

  drawBody(body, { x, y, angle }, k) {
    const { shape, size } = body;
    const { pen } = this;
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const at = (a, b) => [x + cos * a - sin * b, y + sin * a + cos * b];
    pen.beginPath();
    if (shape === "disc") {
      pen.arc(x, y, size, angle, angle + 2 * Math.PI);
      if (this.lab.setup.dimensions === 2) pen.lineTo(...at(0.6 * size, 0)); // shows how it turns
    } else {
      for (const [a, b] of outline(body)) pen.lineTo(...at(a, b));
      pen.closePath();
    }
    pen.fillStyle = this.colors[LAB_COLORS[k % LAB_COLORS.length]];
    pen.globalAlpha = 0.35;
    pen.fill();
    pen.globalAlpha = 1;
    pen.strokeStyle = this.ink;
    pen.lineWidth = 1.5 / this.scale;
    pen.stroke();
    if (this.lab.setup.bodies.length <= 20) this.write([x, y - 0.55 * size], String(k + 1));
  }

  drawArrows({ mass }, { x, y, vx, vy }) {
    if (this.lab.setup.bodies.length > MOST_WITH_ARROWS) return;
    const { momenta, velocities } = this.lab.shown;
    const between = Math.abs(mass - 1) * ARROW * Math.hypot(vx, vy) * this.scale; // pixels from tip to tip
    if (momenta) this.arrow([x, y], [mass * vx, mass * vy], "purple", "p", velocities && between < BESIDE ? BESIDE : 0);
    if (velocities) this.arrow([x, y], [vx, vy], "green", "v");
  }

  /** Draw where each body has been. */
  drawPaths() {
    const { pen } = this;
    const past = this.lab.history.slice(-MOST_PATH);
    pen.lineWidth = 2 / this.scale;
    (past[0].bodies ?? []).forEach((_, k) => {
      pen.strokeStyle = this.colors[LAB_COLORS[k % LAB_COLORS.length]];
      pen.beginPath();
      for (const { bodies } of past) pen.lineTo(bodies[k].x, bodies[k].y);
      pen.stroke();
    });
  }

  /** Draw a ring around the body that keys move, and the handle that sets its size. */
  drawChosen() {
    const { pen, lab } = this;
    const { x, y } = lab.world.bodies[lab.chosen.k];
    pen.strokeStyle = this.ink;
    pen.lineWidth = 1 / this.scale;
    pen.setLineDash([3 / this.scale, 3 / this.scale]);
    pen.beginPath();
    pen.arc(x, y, reachOf(lab.setup.bodies[lab.chosen.k]) + 5 / this.scale, 0, 2 * Math.PI);
    pen.stroke();
    pen.setLineDash([]);
    const [hx, hy] = lab.hold.handle();
    const half = 5 / this.scale;
    pen.fillStyle = this.ink;
    pen.fillRect(hx - half, hy - half, 2 * half, 2 * half);
  }

  drawCentre() {
    const { pen } = this;
    pen.strokeStyle = this.ink;
    pen.lineWidth = 1.5 / this.scale;
    pen.setLineDash([4 / this.scale, 4 / this.scale]);
    pen.beginPath();
    for (const { x, y } of this.lab.history.slice(-MOST_PATH)) pen.lineTo(x, y);
    pen.stroke();
    pen.setLineDash([]);
    const { x, y } = this.lab.history.at(-1);
    const half = 7 / this.scale;
    pen.beginPath();
    pen.moveTo(x - half, y);
    pen.lineTo(x + half, y);
    pen.moveTo(x, y - half);
    pen.lineTo(x, y + half);
    pen.stroke();
    this.write([x, y], "CM", [16, -10]);
  }

  /** Draw an arrow whose name stands beyond its tip, some pixels to the right; momenta are broader. */
  arrow([x, y], [vx, vy], color, name, aside = 0) {
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
    this.write([x + dx, y + dy], name, [12 * ux + aside, -12 * uy]);
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
}
