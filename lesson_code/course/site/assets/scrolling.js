// What is too wide for its place can be scrolled; this lets the arrow keys do it too.
"use strict";
{
  const boxes = [...document.querySelectorAll("pre, .formula, .table-wrapper")];
  const update = () => {
    const wide = boxes.map((box) => box.scrollWidth > box.clientWidth);
    boxes.forEach((box, n) => (wide[n] ? (box.tabIndex = 0) : box.removeAttribute("tabindex")));
  };
  addEventListener("resize", update);
  update();
}
