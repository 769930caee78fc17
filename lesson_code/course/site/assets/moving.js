// Lets the sliders of a page choose among the pictures that lesson_code/course/site/moving.py has drawn
// ahead. They come in a file of their own, which is fetched when a slider is first touched.
"use strict";
{
  const arrived = new Map();

  // Called by that file: a script, because a page opened from a folder may not fetch data.
  window.drawnAhead = (name, packed) => arrived.get(name)(packed);

  async function unpacked(packed) {
    const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    const { lines, pictures, words } = await new Response(stream).json();
    return {
      picture: (state) => pictures[state].map((line) => lines[line]).join("\n"),
      words: (state) => words[state] || "",
    };
  }

  function load(name, address) {
    return new Promise((resolve, reject) => {
      arrived.set(name, resolve);
      const script = document.createElement("script");
      script.onerror = () => reject(new Error(`${address} is missing`));
      script.src = address;
      document.head.append(script);
    }).then(unpacked);
  }

  function start(figure) {
    const image = figure.querySelector("img");
    const words = figure.querySelector("[role=status]");
    const sliders = [...figure.querySelectorAll("input")].map((input) => ({
      input,
      output: input.parentElement.querySelector("output"),
      values: JSON.parse(input.dataset.values),
    }));
    const { name, pictures } = figure.dataset;
    let drawn = null, address = null;

    async function show() {
      for (const { input, output, values } of sliders) {
        output.textContent = values[input.value];
        input.setAttribute("aria-valuetext", values[input.value]);
      }
      const wanted = () =>
        sliders.reduce((at, { input, values }) => at * values.length + Number(input.value), 0);
      const state = wanted();
      drawn ||= load(name, pictures);
      const { picture, words: said } = await drawn;
      if (state !== wanted()) return; // a slider has moved on meanwhile
      if (address) URL.revokeObjectURL(address);
      address = URL.createObjectURL(new Blob([picture(state)], { type: "image/svg+xml" }));
      image.src = address;
      image.dataset.state = state;
      if (said(state)) words.textContent = said(state);
    }

    for (const { input } of sliders) {
      input.addEventListener("input", show);
      input.disabled = false;
    }
  }

  document.querySelectorAll("figure.moving").forEach(start);
}
