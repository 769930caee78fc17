// The plan of effects of a world: what Python's rules, compiled, find in it (programs/plan.py), in
// Python's words. Bodies that fly freely are taken to meet: a hand may reach in.

/** Return of each effect its name, whether a run of the world calls for it, which takes some time in s, and why. */
export function planOf(rules, world, duration) {
  const { facts, bodies, finding, about } = rules;
  for (const table of rules.tables) table.resize(0); // forget the last scene
  for (const table of rules.tables) if (table.isSingle) table.resize(1);
  for (const name of ["gravity_x", "gravity_y", "damping", "dt", "restitution_rule", "friction_rule"]) facts[name] = world.state[name];
  facts.duration = duration;
  bodies.resize(world.bodies.length);
  world.bodies.forEach((body, k) => {
    const row = bodies.at(k);
    for (const field in row) row[field] = body[field];
  });
  rules.run("look");
  return about.plan.effects.map((name) => {
    rules.run(name);
    return { name, calledFor: finding.called_for, reason: filledIn(about.plan.words[finding.words], [finding.first, finding.second]) };
  });
}

/** Put numbers into the places of words, as Python's str.format does. */
function filledIn(words, numbers) {
  return words.replace(/\{:(?:\.(\d+))?([fg])\}/g, (_, digits, kind) =>
    kind === "f" ? numbers.shift().toFixed(Number(digits)) : general(numbers.shift(), Number(digits ?? 6)),
  );
}

function general(value, digits) {
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "inf").toLowerCase();
  const [mantissa, power] = value.toExponential(digits - 1).split("e").map(Number);
  if (power >= -4 && power < digits) return String(Number(value.toFixed(digits - 1 - power)));
  return `${mantissa}e${power < 0 ? "-" : "+"}${String(Math.abs(power)).padStart(2, "0")}`;
}
