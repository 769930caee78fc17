// Moves polygon B with the pointer or the keys. What is to be seen is drawn by Python:
// this file sets x, y and angle, and shows the picture that comes back.

const STEP = 0.05; // m for an arrow key
const TURN = 5; // degrees for Q and E

const MOVES = {
  ArrowLeft: ["x", -STEP],
  ArrowRight: ["x", STEP],
  ArrowUp: ["y", STEP],
  ArrowDown: ["y", -STEP],
  q: ["angle", TURN],
  e: ["angle", -TURN],
};

function render({ model, el }) {
  const stage = document.createElement("div");
  stage.tabIndex = 0;
  stage.setAttribute("role", "application");
  stage.setAttribute("aria-label", model.get("label"));
  stage.dataset.lmSuppressShortcuts = "true"; // the arrow keys are ours here, not JupyterLab's
  stage.style.maxWidth = "780px";
  const hint = document.createElement("p");
  hint.textContent = model.get("hint");
  const words = document.createElement("p");
  words.setAttribute("role", "status");
  el.append(stage, hint, words);

  const show = () => {
    stage.innerHTML = model.get("picture");
    stage.querySelector(".b").style.cssText = "cursor: grab; touch-action: none";
    words.textContent = model.get("words");
  };
  const put = (name, value) => {
    const [low, high] = model.get("limits")[name];
    model.set(name, Math.min(high, Math.max(low, value)));
  };

  let grip = null; // while the pointer drags: how far B's place is from it, in m
  const inMetres = (event) => {
    const svg = stage.querySelector("svg");
    const at = new DOMPoint(event.clientX, event.clientY);
    const place = at.matrixTransform(svg.getScreenCTM().inverse());
    return { x: place.x / model.get("scale"), y: -place.y / model.get("scale") };
  };
  stage.addEventListener("pointerdown", (event) => {
    if (!event.target.closest(".b")) return;
    const pointer = inMetres(event);
    grip = { x: model.get("x") - pointer.x, y: model.get("y") - pointer.y };
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener("pointermove", (event) => {
    if (!grip) return;
    const pointer = inMetres(event);
    put("x", pointer.x + grip.x);
    put("y", pointer.y + grip.y);
    model.save_changes();
  });
  for (const end of ["pointerup", "pointercancel"]) {
    stage.addEventListener(end, () => (grip = null));
  }
  stage.addEventListener("keydown", (event) => {
    const move = MOVES[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!move || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const [name, change] = move;
    put(name, model.get(name) + change);
    model.save_changes();
  });

  model.on("change:picture", show);
  show();
}

export default { render };
