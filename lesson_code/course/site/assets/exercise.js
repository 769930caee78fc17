// The exercises of a page: answers are kept in the browser, checked by Python in a worker, and saved
// as a file that `workbook grade` takes. What is on the page, and what Python runs, is made by
// lesson_code/course/site/page_exercises.py. Python is loaded when something is checked, not before.
"use strict";
{
  const AT_MOST = 10_000; // ms for a check, once Python is there; the answers take some ms
  const GONE = "It was stopped after 10 s. Does a loop in it never end?";
  const exercise = JSON.parse(document.getElementById("exercise").textContent);
  const forms = [...document.querySelectorAll("form.task")];
  const SCRIPT = document.currentScript.src.replace(/[^/]*$/, `exercises/${exercise.name}.js`);

  // Runs in the worker. Each file is checked against its sum before it is used.
  function worker() {
    const said = (message) => self.postMessage(message);
    async function start({ pyodide, files, entry, lesson }) {
      const got = {};
      await Promise.all(Object.entries(files).map(async ([name, integrity]) => {
        const answer = await fetch(pyodide + name, { integrity });
        if (!answer.ok) throw new Error(`${answer.status} for ${pyodide + name}`);
        got[name] = await answer.arrayBuffer();
      }));
      const blob = (name, type) => URL.createObjectURL(new Blob([got[name]], { type }));
      const ask = self.fetch;
      self.fetch = (address, ...rest) => String(address).endsWith("pyodide.asm.wasm")
        ? Promise.resolve(new Response(got["pyodide.asm.wasm"], { headers: { "Content-Type": "application/wasm" } }))
        : ask(address, ...rest);
      const { loadPyodide } = await import(blob("pyodide.mjs", "text/javascript"));
      const made = await import(blob("pyodide.asm.mjs", "text/javascript"));
      const python = await loadPyodide({
        indexURL: pyodide,
        createPyodideModule: made.default,
        stdLibURL: blob("python_stdlib.zip", "application/zip"),
        lockFileContents: LOCK,
      });
      python.unpackArchive(lesson, "zip", { extractDir: "/lesson" });
      python.runPython("import sys; sys.path.insert(0, '/lesson')");
      return python.pyimport(entry);
    }
    let lesson;
    self.onmessage = async ({ data }) => {
      try {
        if (data.start) {
          lesson = await start(data.start);
          said({ ready: true });
        } else said(JSON.parse(lesson.checked(JSON.stringify(data.cells), data.task, data.named)));
      } catch (error) {
        said({ failed: String(error.message || error) });
      }
    };
  }

  // The package's part for this exercise; its script calls workbookPython.
  const lesson = () => new Promise((resolve, reject) => {
    const script = document.createElement("script");
    window.workbookPython = (text) => resolve(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)));
    script.onerror = () => reject(new Error(`did not get ${SCRIPT}`));
    script.src = SCRIPT;
    document.head.append(script);
  });

  // Python: one worker, made when first asked, and again after it was stopped.
  const python = { worker: null, ready: null, ended: null };

  function begin() {
    const lock = { info: exercise.lock, packages: {} };
    const text = `(${worker})();`.replace("LOCK", JSON.stringify(JSON.stringify(lock)));
    // In a page from a folder a worker cannot be a blob; one in its address may not ask our server.
    const address = location.protocol === "file:" ? `data:text/javascript,${encodeURIComponent(text)}`
      : URL.createObjectURL(new Blob([text], { type: "text/javascript" }));
    python.worker = new Worker(address, { type: "module" });
    python.ready = lesson().then((bytes) => answerTo({
      start: {
        pyodide: new URL(exercise.pyodide, document.baseURI).href,
        files: exercise.files, entry: exercise.entry, lesson: bytes,
      },
    }));
  }

  function end(why) {
    if (python.worker) python.worker.terminate();
    python.worker = python.ready = null;
    if (python.ended) python.ended({ stopped: why });
  }

  const answerTo = (message) => new Promise((resolve) => {
    python.ended = resolve;
    python.worker.onmessage = ({ data }) => resolve(data);
    python.worker.onerror = (event) => resolve({ failed: event.message });
    python.worker.postMessage(message);
  });

  async function checked(message) {
    if (!python.worker) begin();
    const begun = await python.ready.catch((error) => ({ failed: error.message }));
    if (!begun.ready) {
      end();
      return begun.stopped ? begun : { failed: `Python could not be loaded: ${begun.failed}. ` +
        "It comes from the network, or from the server that these pages come from." };
    }
    const timer = setTimeout(() => end(GONE), AT_MOST);
    const answer = await answerTo(message);
    clearTimeout(timer);
    return answer;
  }

  // Answers, kept from visit to visit. Where the browser keeps nothing, they last as long as the page.
  const key = (form) => `workbook ${exercise.name} ${form.dataset.task}`;
  const asGiven = (form) => form.querySelector("textarea").defaultValue;
  const kept = (form) => { try { return localStorage.getItem(key(form)); } catch { return null; } };
  function keep(form) {
    const text = form.querySelector("textarea").value;
    try {
      if (text === asGiven(form)) localStorage.removeItem(key(form));
      else localStorage.setItem(key(form), text);
    } catch { /* as said above */ }
  }

  // The notebook with the answers in it.
  function answered() {
    const notebook = structuredClone(exercise.notebook);
    for (const form of forms) {
      const lines = form.querySelector("textarea").value.split(/(?<=\n)/);
      notebook.cells[form.dataset.cell - 1].source = lines;
    }
    return notebook;
  }

  const codeOf = (cell) => [cell.source].flat().join("");
  const isCheck = (cell) => (cell.metadata.tags || []).includes("check");

  function cellsUpTo(form) {
    return answered().cells.slice(0, form.dataset.cell)
      .map((cell, place) => [cell, `your cell ${place + 1}`])
      .filter(([cell]) => cell.cell_type === "code" && !isCheck(cell))
      .map(([cell, name]) => [name, codeOf(cell)]);
  }

  const FILES = {
    ipynb: () => JSON.stringify(answered(), null, 1) + "\n",
    py: () => answered().cells.filter((cell) => cell.cell_type === "code" && !isCheck(cell))
      .map((cell) => codeOf(cell).replace(/^from lesson_code.*\n?/gm, "").trim())
      .filter(Boolean).join("\n\n\n") + "\n",
  };

  function save(kind) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([FILES[kind]()], { type: "text/plain" }));
    link.download = `${exercise.name}.${kind}`;
    link.click();
    URL.revokeObjectURL(link.href);
  }

  function show(form, { lines = [], printed = "", failed, stopped }) {
    const marks = form.querySelector(".marks");
    const box = form.querySelector(".printed");
    box.textContent = printed;
    box.hidden = !printed;
    box.tabIndex = 0;
    marks.replaceChildren(...(failed ? [failed] : stopped ? [stopped] : lines).map((line, place) => {
      const part = document.createElement("p");
      part.textContent = line.trim();
      part.className = line.startsWith("  hint: ") ? "hint" : place ? "" : "earned";
      return part;
    }));
    const points = /: (\d+)\/(\d+) points/.exec(lines[0] || "");
    form.dataset.points = points ? points[1] : 0;
    marks.dataset.full = Boolean(points && points[1] === points[2]);
    const sum = forms.reduce((total, each) => total + Number(each.dataset.points || 0), 0);
    document.querySelector(".take .sum").textContent = `${sum} of ${exercise.points} points`;
  }

  async function check(form) {
    const stop = form.querySelector(".stop"), button = form.querySelector("[type=submit]");
    for (const each of forms) each.querySelector("[type=submit]").disabled = true;
    stop.hidden = false;
    const loads = !python.worker;
    form.querySelector(".marks").textContent = loads
      ? `Python is being loaded: ${exercise.megabytes} MB the first time.` : "Checking.";
    const { task, function: named } = form.dataset;
    const answer = await checked({ cells: cellsUpTo(form), task, named });
    stop.hidden = true;
    for (const each of forms) each.querySelector("[type=submit]").disabled = false;
    show(form, answer);
    if (document.activeElement === document.body) button.focus();
  }

  // Tab indents, and after Escape it leads on, as without a script.
  function typed(event, area) {
    if (event.key === "Escape") area.dataset.leave = "yes";
    else if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) area.form.requestSubmit();
    else if (event.key === "Enter") {
      const line = area.value.slice(0, area.selectionStart).split("\n").at(-1);
      const deeper = /:\s*$/.test(line) ? "    " : "";
      event.preventDefault();
      document.execCommand("insertText", false, `\n${/^ */.exec(line)[0]}${deeper}`);
    } else if (event.key === "Tab" && !event.shiftKey && !area.dataset.leave) {
      event.preventDefault();
      document.execCommand("insertText", false, "    ");
    } else delete area.dataset.leave;
  }

  for (const form of forms) {
    const area = form.querySelector("textarea");
    area.value = kept(form) ?? asGiven(form);
    area.addEventListener("input", () => keep(form));
    area.addEventListener("keydown", (event) => typed(event, area));
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      check(form);
    });
    form.querySelector(".stop").addEventListener("click", () => end("Stopped."));
    form.querySelector(".over").addEventListener("click", () => {
      area.value = asGiven(form);
      keep(form);
      area.focus();
    });
  }
  for (const button of document.querySelectorAll("[data-take]")) {
    button.addEventListener("click", () => save(button.dataset.take));
  }
}
