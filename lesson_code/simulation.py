"""simulate(): one door to every solver, ours, pymunk's and Box2D's."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from lesson_code.engine.core.mixing import Combination, combination
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.recording import Sample, Stepper, record, step_times
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.effects.question import Question
from lesson_code.engine.event_driven import ExactSolver, record_exact
from lesson_code.engine.solvers.choice import SolverChoice, solvers_for
from lesson_code.engine.stepper import SOLVERS, EngineStepper
from lesson_code.formulas.validation import non_negative, one_number, positive

OTHERS = {"pymunk": ("C", "pymunk's own"), "box2d": ("C++", "Box2D's own")}
"""Engines that are not ours, and what their code is."""

NAMES = ("auto", *SOLVERS, "exact", *OTHERS)
"""The solvers that a scene can be given to."""

IMPACT_CHOICES = {
    "impacts": ("simultaneous", "sequential"),
    "restitution_law": ("newton", "energetic"),
}
"""What may be said of impacts; the first is what every solver does."""


def simulate(
    scene: Scene,
    duration: float,
    *,
    solver: str = "auto",
    dt: float = 1 / 60,
    iterations: int | None = None,
    substeps: int | None = None,
    combine: str | Combination = "workbook",
    effects: Mapping[str, bool] | None = None,
    compiled: bool | None = None,
    impacts: str = "simultaneous",
    restitution_law: str = "newton",
    sample: Sample = None,
) -> Run:
    """Let a scene run for a while, and return what happened.

    Parameters
    ----------
    scene : Scene
        Bodies, gravity, damping, callbacks.
    duration : float
        s, >= 0.
    solver : str
        "sequential": sequential impulses, the solver of chapters 04 to 06.
        "substep": soft contacts in sub-steps; for high stacks and heavy bodies on light ones.
        "naive": the first attempt, faults included.
        "direct": the contacts of bodies that touch are solved together, exactly; for great mass
        ratios, tall stacks and even loads. `iterations` means nothing to it.
        "exact": from collision to collision, with no time step; for discs among bodies that do
        not move or move evenly. `dt`, `iterations` and `substeps` mean nothing to it.
        "pymunk": the same scene, stepped by pymunk.
        "box2d": the same scene, stepped by Box2D, where that is installed.
        "auto": the one that suits the scene: "exact" for discs that fly freely, "direct" for few
        bodies, "substep" for heavy bodies on light ones, "sequential" for others. ``run.plan``
        says which, and why.
    dt : float
        The time step, s, > 0. All steps have this length.
    iterations : int, optional
        Sweeps over the contacts in each step, >= 1; 10 unless given. For "substep": sweeps before
        and again after each of its motions; 1 unless given. The naive solver makes one.
    substeps : int, optional
        Equal parts that a step is made in, >= 1, each with its own contacts and sweeps; 1 unless
        given. For "substep": motions in a step, for which contacts are found once; 4 unless given.
    combine : str or Combination
        How a pair's restitution and friction come from its bodies': "workbook" (the smaller,
        the geometric mean), "pymunk" (products), "box2d" (the larger, the geometric mean).
    effects : mapping from str to bool, optional
        What to simulate, for those who know better than the rules: True forces an effect on,
        False leaves it out. One that the scene needs cannot be left out. The names are those in
        ``run.plan``, such as "friction" and "rotation".
    compiled : bool, optional
        Whether our own stages run as machine code, which Numba makes of them; the results are the
        same to the last bit. None: if the run is large enough to repay it, and can be compiled.
    impacts : str
        Where bodies that touch are struck together: "simultaneous", all bounce at once, or
        "sequential", one pair after the other. A choice that only "direct" offers.
    restitution_law : str
        "newton": e is a ratio of velocities. "energetic": Stronge's, a ratio of work, which gains
        no energy where there is friction too. A choice that only "direct" offers.
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
        The exact solver finds no end of the collisions at one instant.
    ModuleNotFoundError
        Box2D is asked for and not installed.

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
    settings: dict[str, Any] = {
        "dt": one_number("dt", dt, positive),
        "iterations": None if iterations is None else _count("iterations", iterations),
        "substeps": None if substeps is None else _count("substeps", substeps),
        "combine": combination(combine),
        "effects": effects,
        "compiled": compiled,
    }
    rules = _impact_rules(solver, impacts, restitution_law)
    if solver != "auto":
        return _simulate(
            scene, duration, SolverChoice(solver, "asked for"), settings, rules, sample
        )
    if sample is None:
        sample = step_times(duration, settings["dt"])
    question = Question(scene, "auto", settings["dt"], duration, settings["combine"])
    asked = {**settings, "impact_rules": rules}
    choices = solvers_for(question, asked=asked, effects=effects, compiled=compiled)
    return _first_that_can(choices, scene, duration, settings, rules, sample)


def _first_that_can(
    choices: Iterable[SolverChoice],
    scene: Scene,
    duration: float,
    settings: dict[str, Any],
    rules: dict[str, str],
    sample: Sample,
) -> Run:
    """Return the run of the first solver that finds an end; the exact one alone may not."""
    refused = ""
    for choice in choices:
        choice = choice._replace(reason=choice.reason + refused)
        try:
            return _simulate(scene, duration, choice, settings, rules, sample)
        except RuntimeError:
            if choice.solver != "exact":
                raise
            refused = "; the exact solver finds no end of the collisions"
    raise AssertionError("the last choice, sequential, suits every scene")  # pragma: no cover


def _simulate(
    scene: Scene,
    duration: float,
    choice: SolverChoice,
    settings: dict[str, Any],
    rules: dict[str, str],
    sample: Sample,
) -> Run:
    """Return a run by one solver."""
    solver, reason = choice
    if solver == "exact":
        chosen = {name: settings[name] for name in ("combine", "effects", "compiled")}
        return record_exact(
            ExactSolver(scene, duration=duration, **chosen), duration, sample, reason
        )
    settings = _with_counts(solver, settings)
    if solver in OTHERS:
        other, plan = _other(solver, scene, settings), Plan(solver, reason, *OTHERS[solver])
        return record(other, scene, duration, sample, plan)
    if solver == "direct":
        settings |= rules
    stepper = EngineStepper(scene, solver=solver, duration=duration, **settings)
    run = record(stepper, scene, duration, sample, stepper.plan(reason))
    return replace(run, plan=stepper.plan(reason))  # as it was in the end


def _with_counts(solver: str, settings: dict[str, Any]) -> dict[str, Any]:
    """Return the settings, with the numbers of sweeps and sub-steps that a solver makes."""
    sweeps, parts = (1, 4) if solver == "substep" else (10, 1)
    if solver in ("naive", "direct"):
        sweeps, settings = 1, {**settings, "iterations": None}
    return {
        **settings,
        "iterations": settings["iterations"] or sweeps,
        "substeps": settings["substeps"] or parts,
    }


def _other(solver: str, scene: Scene, settings: dict[str, Any]) -> Stepper:
    """Return another engine at work on a scene; it is loaded only when asked for.

    It has one program for all scenes, and that is compiled.
    """
    settings = dict(settings)
    for name in ("compiled", "effects"):
        if (value := settings.pop(name)) is not None:
            raise ValueError(f"{name} must be None for {solver}, got {value!r}")
    if solver == "pymunk":
        from lesson_code.reference.pymunk_reference import PymunkStepper

        return PymunkStepper(scene, **settings)
    from lesson_code.reference.box2d_reference import Box2DStepper

    return Box2DStepper(scene, **settings)


def _impact_rules(solver: str, impacts: str, restitution_law: str) -> dict[str, str]:
    """Return what the direct solver is to be told of impacts, or refuse what a solver has not.

    Nothing where that is the default.
    """
    chosen = {"impacts": impacts, "restitution_law": restitution_law}
    for name, value in chosen.items():
        first, *_ = IMPACT_CHOICES[name]
        if value not in IMPACT_CHOICES[name]:
            raise ValueError(
                f"{name} must be one of {', '.join(IMPACT_CHOICES[name])}, got {value!r}"
            )
        if solver not in ("direct", "auto") and value != first:
            raise ValueError(f"{name} must be {first!r} unless solver is 'direct', got {value!r}")
    defaults = {name: first for name, (first, *_) in IMPACT_CHOICES.items()}
    return {} if chosen == defaults else chosen


def _count(name: str, value: int) -> int:
    """Return a number of times, or refuse what is none."""
    number = one_number(name, value, positive)
    if not number.is_integer():
        raise ValueError(f"{name} must be a whole number, got {value!r}")
    return int(number)
