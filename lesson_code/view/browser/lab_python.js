// The set-up as Python: the lines that build the same scene, run it, and print its plan of effects.

const SHAPES_IN_PYTHON = {
  disc: ({ size }) => `Circle(${size})`,
  box: ({ size }) => `Polygon.box(${2 * size}, ${2 * size})`,
  polygon: ({ size, corners }) => `polygon(${corners}, ${size})`,
};
const POLYGON = `
def polygon(corners, size):
    turns = [2 * pi * k / corners for k in range(corners)]
    return Polygon([(size * cos(turn), size * sin(turn)) for turn in turns])

`;

class AsPython {
  constructor(lab) {
    this.lab = lab;
    this.part = part(lab, "This set-up in Python, with its plan of effects", false);
    const words = "It makes the same steps, and says which effects were simulated, which were left out, and why. ";
    put(this.part, "p", {}, `${words}Saved as a file, read_scene("scene.json") of lesson_code returns the same scene.`);
    button(this.part, "Copy", () => navigator.clipboard?.writeText(this.text.textContent));
    this.text = put(this.part, "pre");
  }

  show() {
    if (this.part.open) this.text.textContent = pythonOf(this.lab.setup, Math.max(this.lab.count, 1));
  }
}

/** Return the surface of a body as Python: that of all, or its own. */
function ownSurface(setup, one) {
  const { restitution, friction } = surfaceOf(setup, one);
  return "elasticity" in one || "friction" in one ? `Material(restitution=${restitution}, friction=${friction})` : "surface";
}

/** Return a set-up and a number of steps as Python. */
function pythonOf(setup, steps) {
  const { dimensions, walls, bodies } = setup;
  const isTrack = dimensions === 1;
  const hasPolygon = bodies.some(({ shape }) => shape === "polygon");
  const [w, h] = halfRoom(setup);
  const { restitution, friction } = surfaceOf(setup);
  const lines = bodies.map(({ mass, x, y, vx, vy, angle, w: spin, ...one }) => {
    const where = isTrack ? `position=(${x}, 0), velocity=(${vx}, 0)` : `position=(${x}, ${y}), velocity=(${vx}, ${vy})`;
    const turn = isTrack ? ", inertia=inf" : (angle ? `, angle=${angle}` : "") + (spin ? `, angular_velocity=${spin}` : "");
    return `    Body(${SHAPES_IN_PYTHON[one.shape](one)}, mass=${mass}, ${where}${turn}, material=${ownSurface(setup, one)}),`;
  });
  const corners = [[-w, -h], [w, -h], [w, h], [-w, h]];
  const sides = corners.map((corner, k) => [corner, corners[(k + 1) % 4]]).filter((_, k) => !isTrack || k % 2);
  if (walls) lines.push(...sides.map(([a, b]) => `    Body(Segment((${a.join(", ")}), (${b.join(", ")})), material=surface),`));
  const names = ["Body", "Circle", "Material", "Polygon", "Scene", "Segment", "simulate"];
  const math = [hasPolygon && "cos", isTrack && "inf", hasPolygon && "pi", hasPolygon && "sin"].filter(Boolean);
  return [
    ...(math.length ? [`from math import ${math.join(", ")}`, ""] : []),
    `from lesson_code import ${names.join(", ")}`,
    hasPolygon ? `\n${POLYGON}` : "",
    `surface = Material(restitution=${restitution}, friction=${friction})`,
    "bodies = [", ...lines, "]",
    `scene = Scene(bodies, gravity=(0, ${-fallIn(setup)}))`,
    `run = simulate(scene, ${steps} / 60, solver="sequential")`,
    "print(run.plan)",
  ].join("\n");
}
