// Makes an animation's still picture move. Python calls this with the animation's name, the least
// width of its controls in pixels, and the motion: see film.py. Lists of numbers hold the first
// value and then differences, in tenths of a pixel or of a degree.
function (name, controls, motion) {
  "use strict";
  const last = motion.frames - 1;

  function element(kind, attributes, parent) {
    const made = document.createElement(kind);
    for (const key in attributes) made.setAttribute(key, attributes[key]);
    parent.append(made);
    return made;
  }

  function sums(differences) {
    const values = [];
    let value = 0;
    for (let frame = 0; frame <= last; frame++) {
      value += differences[frame] || 0;
      values.push(value);
    }
    return values;
  }

  function arrow(x, y) {
    const length = Math.hypot(x, y);
    if (length < 1) return "";
    const ux = x / length, uy = y / length, tip = x + " " + y;
    const left = (x - 7 * ux - 3.5 * uy) + " " + (y - 7 * uy + 3.5 * ux);
    const right = (x - 7 * ux + 3.5 * uy) + " " + (y - 7 * uy - 3.5 * ux);
    return "M0 0L" + tip + "M" + left + "L" + tip + "L" + right;
  }

  function dots(places) {
    let path = "";
    for (let k = 0; k < places.length; k += 2) path += `M${places[k]} ${places[k + 1]}h0`;
    return path;
  }

  // The still picture is an image. Its drawing becomes part of the page, so that it can move.
  function opened(image) {
    const holder = document.createElement("div");
    holder.innerHTML = atob(image.src.split(",")[1]);
    const drawing = holder.firstElementChild;
    drawing.setAttribute("role", "img");
    drawing.setAttribute("aria-label", image.alt);
    drawing.setAttribute("style", "display:block;max-width:100%;height:auto");
    image.replaceWith(drawing);
    return drawing;
  }

  function start(figure) {
    figure.setAttribute("data-ready", "");
    const drawing = opened(figure.querySelector("img"));
    if (last < 1) return;
    const bodies = [...drawing.querySelectorAll("[data-body]")];
    const points = [...drawing.querySelectorAll("[data-contacts]")];
    const paths = motion.bodies.map((path) => path.map(sums));

    const bar = element("div", {
      "style": "display:flex;align-items:center;gap:10px;margin-top:4px;max-width:" +
        Math.max(controls, drawing.getAttribute("width")) + "px",
    }, figure);
    // On each control itself, this makes JupyterLab leave the keys to it.
    const ours = { "data-lm-suppress-shortcuts": "true" };
    const button = element("button", {
      ...ours, "type": "button", "style": "font:inherit;min-width:5.5em;padding:4px 8px;cursor:pointer",
    }, bar);
    const slider = element("input", {
      ...ours, "type": "range", "min": 0, "max": last, "step": 1, "aria-label": "time",
      "style": "flex:1;min-width:80px;margin:0",
    }, bar);
    const clock = element("span", {
      "style": "font-variant-numeric:tabular-nums;white-space:nowrap",
    }, bar);

    let shown = 0, playing = false, played = 0, before = 0;

    function show(frame) {
      shown = frame;
      bodies.forEach((body, n) => {
        const [x, y, angle, vx, vy] = paths[n].map((values) => values[frame] / 10);
        body.setAttribute("transform", `translate(${x} ${y})`);
        body.firstElementChild.setAttribute("transform", `rotate(${angle})`);
        if (vx !== undefined) body.lastElementChild.setAttribute("d", arrow(vx, vy));
      });
      motion.contacts.forEach((pictures, n) => {
        if (pictures.length) points[n].setAttribute("d", dots(pictures[frame]));
      });
      const time = motion.start + motion.duration * frame / last;
      clock.textContent = time.toFixed(motion.decimals) + " s";
      slider.value = frame;
      slider.setAttribute("aria-valuetext", clock.textContent);
    }

    function stop() {
      playing = false;
      button.textContent = shown === last ? "Play again" : "Play";
    }

    function tick(now) {
      if (!playing || !figure.isConnected) return;
      played += Math.min(Math.max(now - before, 0), 100) / 1000;
      before = now;
      const frame = Math.min(last, Math.floor(played / motion.seconds * last));
      if (frame !== shown) show(frame);
      if (frame === last) stop();
      else requestAnimationFrame(tick);
    }

    function toggle() {
      if (playing) return stop();
      if (shown === last) show(0);
      playing = true;
      played = shown / last * motion.seconds;
      before = performance.now();
      button.textContent = "Pause";
      requestAnimationFrame(tick);
    }

    button.addEventListener("click", toggle);
    slider.addEventListener("input", () => {
      show(Number(slider.value));
      stop();
    });
    slider.addEventListener("keydown", (event) => {
      if (event.key !== " ") return;
      event.preventDefault();
      toggle();
    });
    show(0);
    stop();
  }

  const waiting = `figure[data-animation=${name}]:not([data-ready])`;
  document.querySelectorAll(waiting).forEach(start);
}
