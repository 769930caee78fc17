// Judges the answers to the forms of the element it stands in. The verdicts are those of checker.py,
// and a test holds the two together. How answers are sealed, and folded cells hidden, is said in
// forms.py.
"use strict";
{
  const NUMBER = /^([+-]?(?:[0-9]+(?:[.,][0-9]*)?|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?)([\s\S]*)$/;
  const NAME_LENGTH = 16;

  // SHA-256, as FIPS 180-4 has it. The browser's own is missing in pages that come over plain HTTP.
  const fractions = (root, count) => {
    const found = [];
    for (let n = 2; found.length < count; n++) {
      let prime = true;
      for (let d = 2; d * d <= n; d++) if (n % d === 0) prime = false;
      if (prime) found.push(((n ** root % 1) * 2 ** 32) | 0);
    }
    return found;
  };
  const START = fractions(1 / 2, 8), ROUND = fractions(1 / 3, 64);
  const turn = (x, by) => (x >>> by) | (x << (32 - by));

  function padded(bytes) {
    const blocks = new Uint8Array(Math.ceil((bytes.length + 9) / 64) * 64);
    blocks.set(bytes);
    blocks[bytes.length] = 0x80;
    new DataView(blocks.buffer).setUint32(blocks.length - 4, bytes.length * 8);
    return new DataView(blocks.buffer);
  }

  function sha256(text) {
    const message = padded(new TextEncoder().encode(text));
    const state = [...START];
    for (let at = 0; at < message.byteLength; at += 64) {
      const w = Array.from({ length: 16 }, (_, k) => message.getInt32(at + 4 * k));
      for (let k = 16; k < 64; k++) {
        const x = w[k - 15], y = w[k - 2];
        w[k] = (w[k - 16] + w[k - 7] + (turn(x, 7) ^ turn(x, 18) ^ (x >>> 3)) +
          (turn(y, 17) ^ turn(y, 19) ^ (y >>> 10))) | 0;
      }
      let [a, b, c, d, e, f, g, h] = state;
      for (let k = 0; k < 64; k++) {
        const one = (h + (turn(e, 6) ^ turn(e, 11) ^ turn(e, 25)) + ((e & f) ^ (~e & g)) +
          ROUND[k] + w[k]) | 0;
        const two = ((turn(a, 2) ^ turn(a, 13) ^ turn(a, 22)) + ((a & b) ^ (a & c) ^ (b & c))) | 0;
        [a, b, c, d, e, f, g, h] = [(one + two) | 0, a, b, c, (d + one) | 0, e, f, g];
      }
      [a, b, c, d, e, f, g, h].forEach((value, k) => (state[k] = (state[k] + value) | 0));
    }
    const digest = new DataView(new ArrayBuffer(32));
    state.forEach((value, k) => digest.setInt32(4 * k, value));
    return new Uint8Array(digest.buffer);
  }

  const hex = (bytes) => Array.from(bytes, (b) => b.toString(16).padStart(2, "0")).join("");

  function opened(question, answer) {
    const name = hex(sha256(`${question.id}|${answer}|name`)).slice(0, NAME_LENGTH);
    const sealed = question.sealed[name];
    if (sealed === undefined) return [];
    const bytes = Uint8Array.from(sealed.match(/../g), (pair) => parseInt(pair, 16));
    for (let at = 0; at < bytes.length; at += 32) {
      const stream = sha256(`${question.id}|${answer}|${at / 32}`);
      for (let k = at; k < Math.min(at + 32, bytes.length); k++) bytes[k] ^= stream[k - at];
    }
    return JSON.parse(new TextDecoder().decode(bytes));
  }

  const bare = (unit) => unit.replace(/[\s·*]/g, "").toLowerCase();

  function number(text, unit) {
    const written = NUMBER.exec(text.trim().replace(/[\u2212\u2013]/g, "-"));
    if (!written || !["", bare(unit)].includes(bare(written[2]))) return NaN;
    return Number(written[1].replace(",", "."));
  }

  // The components of an arrow that is written as "x, y", or null.
  function components(text) {
    const tip = text.split(", ").map((part) => number(part, ""));
    return tip.length === 2 && tip.every(Number.isFinite) ? tip : null;
  }

  // Returns {right, feedback}, or null for an answer that cannot be read.
  function judge(question, answer) {
    if (question.spacing !== undefined) {
      const tip = components(answer);
      const lines = tip && tip.map((part) => Math.floor(part / question.spacing + 0.5)).join(" ");
      return tip && (opened(question, lines)[0] || opened(question, "otherwise")[0]);
    }
    if (question.tolerance === undefined) return opened(question, answer)[0] || null;
    const value = number(answer, question.unit);
    if (!Number.isFinite(value)) return null;
    const near = (said) => Math.abs(value - said.value) <= question.tolerance;
    const drawer = Math.floor(value / (2 * question.tolerance));
    return opened(question, String(drawer)).find(near) || opened(question, "otherwise")[0];
  }

  function answered(form, question) {
    const given = new FormData(form).getAll(question.id).join(", ");
    const verdict = judge(question, given);
    const line = form.querySelector(".verdict");
    line.textContent = verdict ? verdict.feedback : `Please give ${question.expected}.`;
    line.dataset.right = verdict ? verdict.right : "";
    if (!verdict) return false;
    const strong = document.createElement("strong");
    strong.textContent = `${given.trim()}: ${verdict.right ? "right" : "not right"}. `;
    line.prepend(strong);
    return true;
  }

  const ANSWER = "details.answer, .jp-CodeCell:not(:has(.quiz)):has(.jp-InputPlaceholder), " +
    ".jp-MarkdownCell:has(.answer)";

  // Opens the folded answer: in a page, or cell by cell in JupyterLab, which folds with a bar to click.
  function reveal(quiz) {
    const cells = [];
    let cell = quiz.closest(".jp-Cell, .cell");
    while ((cell = cell && cell.nextElementSibling) && cell.matches(ANSWER)) cells.push(cell);
    for (const folded of cells) {
      if (folded.matches("details")) folded.open = true;
      folded.querySelectorAll(".jp-InputPlaceholder, .jp-OutputPlaceholder").forEach((bar) =>
        (bar.querySelector(".jp-Placeholder-content") || bar).click());
    }
  }

  // The path of an arrow from the origin, as arrows.py has it.
  function arrowPath(x, y) {
    const angle = Math.atan2(y, x), head = Math.min(7, Math.hypot(x, y) / 2);
    const side = (by) => `M${x} ${y}l${-head * Math.cos(angle + by)} ${-head * Math.sin(angle + by)}`;
    return `M0 0L${x} ${y}${side(0.5)}${side(-0.5)}`;
  }

  // Lets the tip of an arrow be dragged on its sheet; the boxes below it say the same in numbers.
  function draws(form, question) {
    const sheet = form.querySelector(".sheet"), boxes = [...form.elements[question.id]];
    const drawn = sheet.querySelector(".drawn"), unit = Number(sheet.dataset.unit);
    const show = () => {
      const tip = components(boxes.map((box) => box.value).join(", "));
      drawn.setAttribute("d", tip ? arrowPath(tip[0] * unit, -tip[1] * unit) : "");
    };
    const onGrid = (at) => {
      const lines = Math.round(question.reach / question.spacing);
      const nearest = Math.round(at / unit / question.spacing);
      return Math.max(-lines, Math.min(lines, nearest)) * question.spacing;
    };
    const follow = (event) => {
      const at = new DOMPoint(event.clientX, event.clientY);
      const { x, y } = at.matrixTransform(sheet.getScreenCTM().inverse());
      [x, -y].forEach((part, k) => (boxes[k].value = onGrid(part) + 0));
      show();
    };
    sheet.addEventListener("pointerdown", (event) => {
      sheet.setPointerCapture(event.pointerId);
      follow(event);
    });
    sheet.addEventListener("pointermove", (event) => {
      if (sheet.hasPointerCapture(event.pointerId)) follow(event);
    });
    boxes.forEach((box) => box.addEventListener("input", show));
  }

  function start(quiz) {
    const forms = [...quiz.querySelectorAll("form")];
    const count = () => {
      const right = quiz.querySelectorAll('.verdict[data-right="true"]').length;
      const line = quiz.querySelector(".count");
      if (line) line.textContent = `${right} of ${forms.length} right`;
    };
    const foresees = quiz.classList.contains("predict");
    for (const form of forms) {
      const question = JSON.parse(form.dataset.question);
      if (question.spacing !== undefined) draws(form, question);
      form.addEventListener("submit", (event) => {
        event.preventDefault();
        if (answered(form, question) && foresees) reveal(quiz);
        count();
      });
    }
    quiz.querySelector(".reveal")?.addEventListener("click", () => reveal(quiz));
    quiz.querySelector(".asleep")?.remove();
    count();
  }

  start(document.currentScript.closest(".quiz"));
}
