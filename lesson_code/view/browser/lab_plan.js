// The plan of effects: what Python would simulate of the scene as it is set up, what it would leave
// out, and why.

class PlanOfEffects {
  /** Take the rules of the effects, as a program. */
  constructor(lab, rules) {
    Object.assign(this, { lab, rules });
    this.part = part(lab, "", false);
    this.title = this.part.querySelector("summary");
    put(this.part, "p", {}, PLAN_WORDS);
    this.rows = put(put(this.part, "table", { class: "lab-plan" }), "tbody");
  }

  /** Ask the rules anew if the world is another one: each set-up has its own. */
  show() {
    const { world } = this.lab;
    if (world === this.asked) return;
    this.asked = world;
    const found = planOf(this.rules, world, PLANNED);
    const used = found.filter(({ calledFor }) => calledFor).length;
    this.title.textContent = `The plan: ${used} of ${found.length} effects are needed`;
    this.rows.replaceChildren();
    for (const { name, calledFor, reason } of found) {
      const row = put(this.rows, "tr", calledFor ? {} : { class: "lab-out" });
      put(row, "th", { scope: "row" }, name.replaceAll("_", " "));
      put(row, "td", {}, calledFor ? "\u2713 used" : "\u2013 left out");
      put(row, "td", {}, reason);
    }
  }
}

const PLANNED = 10; // s
const PLAN_WORDS =
  `Python asks these rules before it runs a set-up, here for ${PLANNED} s, and passes over an effect that is left out: ` +
  "the result stays the same to the last bit. The page's own engine holds all of them all the time, but sleep.";
