"""simulate(): one door to every solver, ours, pymunk's and Box2D's."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import lesson_code.reference.solvers
from lesson_code.engine.core.mixing import MixingRule, mixing_rule
from lesson_code.engine.core.recording import Sample, step_times
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.core.solver import Request, Solver
from lesson_code.engine.effects.question import Question
from lesson_code.engine.solvers import our_solvers, solvers_in
from lesson_code.engine.solvers.choice import SolverChoice, solvers_for
from lesson_code.engine.stepper import run_in_steps
from lesson_code.formulas.validation import non_negative, one_number, positive

SOLVERS = our_solvers() | solvers_in(lesson_code.reference.solvers)
"""Ours, and the engines that are not ours, by name."""

NAMES = ("auto", *SOLVERS)
"""The solvers that a scene can be given to."""


def simulate(
    scene: Scene,
    duration: float,
    *,
    solver: str = "auto",
    dt: float = 1 / 60,
    iterations: int | None = None,
    substeps: int | None = None,
    combine: str | MixingRule = "workbook",
    effects: Mapping[str, bool] | None = None,
    compiled: bool | None = None,
    impacts: str = "simultaneous",
    restitution_law: str | None = None,
    sample: Sample = None,
) -> Run:
    """Simulate a scene for a duration, and return the run.

    Parameters
    ----------
    scene : Scene
        Bodies, gravity, damping, callbacks.
    duration : float
        s, >= 0.
    solver : str
        "sequential": sequential impulses, the solver of chapters 04 to 06.
        "substep": soft contacts in sub-steps; for heaps and crowds of many bodies. Rough impacts
        gain no energy: what Newton's restitution would gain is taken from the bounce.
        "naive": the first attempt, faults included.
        "direct": the contacts of bodies that touch are solved together, exactly; for great mass
        ratios, tall stacks and even loads. A step ends where bodies come to touch, and no energy
        is gained by its length; a step costs many times one of "sequential". `iterations` means
        nothing to it.
        "exact": from collision to collision, with no time step; for discs among bodies that do
        not move or move evenly. `dt`, `iterations` and `substeps` mean nothing to it.
        "pymunk": the same scene, stepped by pymunk.
        "box2d": the same scene, stepped by Box2D v3, where that is installed; without impulses.
        "auto": the one that suits the scene: "exact" for discs that fly freely, "direct" for few
        bodies, "substep" for others. ``run.plan`` says which, and why.
    dt : float
        The time step, s, > 0. All steps have this length, but for the last, which ends the run.
    iterations : int, optional
        Sweeps over the contacts in each step, >= 1; 10 unless given. For "substep": sweeps before
        and again after each of its motions, whose springs are as many times as stiff; 1 unless
        given. The naive solver makes one, and Box2D one before and one after each motion.
    substeps : int, optional
        Equal parts that a step is made in, >= 1, each with its own contacts and sweeps; 1 unless
        given. For "substep" and "box2d": motions in a step, for which contacts are found once; 4
        unless given.
    combine : str or MixingRule
        How a pair's restitution and friction come from its bodies': "workbook" (the smaller,
        the geometric mean), "pymunk" (products), "box2d" (the larger, the geometric mean).
    effects : mapping from str to bool, optional
        What to simulate, for those who know better than the rules: True forces an effect on,
        False leaves it out. One that the scene needs cannot be left out. The names are those in
        ``run.plan``, such as "friction" and "rotation".
    compiled : bool, optional
        Whether our own stages run as machine code, which Numba makes of them; the results are the
        same to the last bit. True: by a program with what the plan calls for, and no more; one that
        is not kept is compiled first, in half a minute. None: what takes least time. Where that
        program is not kept, a longer run takes one with every effect, which came ready-made; the
        first time half a second goes into its machine code. `run.plan` says what a run was made in.
    impacts : str
        Where bodies that touch are struck together: "simultaneous", all bounce at once, or
        "sequential", one pair after the other. A choice that only "direct" offers.
    restitution_law : str, optional
        "newton": e is a ratio of velocities, which may gain energy where there is friction too.
        "energetic": Stronge's, a ratio of work, which gains none. A choice that only "direct"
        offers: it takes "energetic" unless the other is given. All others know Newton's.
    sample : None, "end" or array_like, shape (F,)
        Which states to record: those after every step (for "exact", after every collision) and
        the last; only the first and the last; or those at given times, s. Where "auto" chooses
        the exact solver, None means those at every multiple of `dt`, as for all the others.

    Returns
    -------
    Run
        The states, the impulses, and what follows from them.

    Raises
    ------
    ValueError
        An argument is out of range, the bodies are heaped into one another without end, the
        scene is not one for the exact solver, or it needs an effect that is to be left out.
    TypeError
        An argument is of another kind.
    FloatingPointError
        A body has left the range of floating point.
    RuntimeError
        The exact solver finds no end of the collisions at one instant; "auto" takes another then.
    ModuleNotFoundError
        Box2D is asked for and not installed.

    Warns
    -----
    RuntimeWarning
        A step had too many impacts: fast bodies stood still for the rest of it, and are late.

    Examples
    --------
    Two equal discs meet head on, and swap their velocities.

    >>> from lesson_code import Body, Circle, Material, Scene
    >>> ball = Material(restitution=1.0)
    >>> scene = Scene([
    ...     Body(Circle(0.5), mass=1.0, position=(-1, 0), velocity=(2, 0), material=ball),
    ...     Body(Circle(0.5), mass=1.0, position=(1, 0), material=ball),
    ... ])
    >>> run = simulate(scene, duration=1.0)
    >>> run.velocities[-1].tolist()
    [[0.0, 0.0], [2.0, 0.0]]
    """
    if not isinstance(scene, Scene):
        raise TypeError(f"scene must be a Scene, got {scene!r}")
    if solver not in NAMES:
        raise ValueError(f"solver must be one of {', '.join(NAMES)}, got {solver!r}")
    duration = one_number("duration", duration, non_negative)
    if compiled is not None and not isinstance(compiled, bool):
        raise TypeError(f"compiled must be True, False or None, got {compiled!r}")
    asked = Request(
        scene=scene,
        duration=duration,
        dt=one_number("dt", dt, positive),
        iterations=None if iterations is None else _count("iterations", iterations),
        substeps=None if substeps is None else _count("substeps", substeps),
        combine=mixing_rule(combine),
        effects=effects,
        compiled=compiled,
        options=_options(solver, impacts=impacts, restitution_law=restitution_law),
        sample=sample,
    )
    if solver != "auto":
        return _run(SOLVERS[solver], asked)
    if sample is None:
        asked = replace(asked, sample=step_times(duration, asked.dt))
    question = Question(scene, "auto", asked.dt, duration, asked.combine)
    given = {"iterations": iterations, "substeps": substeps, "impact_rules": asked.options}
    choices = solvers_for(question, asked=given, effects=effects, compiled=compiled)
    return _first_that_can(choices, asked)


def _first_that_can(choices: Iterable[SolverChoice], asked: Request) -> Run:
    """Return the run of the first solver that finds an end."""
    refused = ""
    for name, reason in choices:
        try:
            request = replace(asked, reason=reason + refused, may_give_up=True)
            return _run(SOLVERS[name], request)
        except RuntimeError:
            if not SOLVERS[name].gives_up:
                raise
            refused = f"; {SOLVERS[name].gives_up}"
    raise AssertionError("the last choice, sequential, suits every scene")  # pragma: no cover


def _run(solver: Solver, asked: Request) -> Run:
    """Return a run by one solver."""
    return solver.run_scene(asked) if solver.run_scene else run_in_steps(asked, solver)


def _options(solver: str, **chosen: str | None) -> dict[str, str]:
    """Return the choices that only some solvers offer, or refuse what this one does not.

    Nothing where none is made, or where it is what every solver does.
    """
    made = {}
    for name, value in chosen.items():
        able = [s.name for s in SOLVERS.values() if name in s.options]
        values = SOLVERS[able[0]].options[name]
        if value is None or value == USUAL[name] == values[0]:
            continue
        if value not in values:
            raise ValueError(f"{name} must be one of {', '.join(values)}, got {value!r}")
        if solver in ("auto", *able):
            made[name] = value
        elif value != USUAL[name]:
            who = " or ".join(map(repr, able))
            usual = USUAL[name]
            raise ValueError(f"{name} must be {usual!r} unless solver is {who}, got {value!r}")
    return made


USUAL = {"impacts": "simultaneous", "restitution_law": "newton"}
"""What a solver does that offers no choice."""


def _count(name: str, value: int) -> int:
    """Return a number of times, or refuse what is none."""
    number = one_number(name, value, positive)
    if not number.is_integer():
        raise ValueError(f"{name} must be a whole number, got {value!r}")
    return int(number)
