"""simulate(): one door to every solver, ours, pymunk's and Box2D's."""

from __future__ import annotations

from typing import Any

from lesson_code.engine.combination import Combination, combination
from lesson_code.engine.event_driven import ExactSolver, record_exact
from lesson_code.engine.plan import Plan
from lesson_code.engine.recording import Sample, Stepper, record
from lesson_code.engine.run import Run
from lesson_code.engine.scene import Scene
from lesson_code.engine.stepper import SOLVERS, EngineStepper, choose_code
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
        "auto": the one that suits the scene; at present always "sequential".
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
        the last; only the first and the last; or those at given times, s.

    Returns
    -------
    Run
        The states, the impulses, and what follows from them.

    Raises
    ------
    ValueError
        An argument is out of range, the bodies are heaped into one another without end, or the
        scene is not one for the exact solver.
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
    chosen = "sequential" if solver == "auto" else solver
    sweeps, parts = (1, 4) if chosen == "substep" else (10, 1)
    sweeps = _count("iterations", sweeps if iterations is None else iterations)
    settings: dict[str, Any] = {
        "dt": one_number("dt", dt, positive),
        "iterations": 1 if chosen in ("naive", "direct") else sweeps,
        "substeps": _count("substeps", parts if substeps is None else substeps),
        "combine": combination(combine),
    }
    settings |= _impact_rules(chosen, impacts, restitution_law)
    reason = "asked for" if solver == chosen else "it solves every scene"
    if chosen == "exact":
        pair = settings["combine"]
        exact = ExactSolver(scene, combine=pair, compiled=compiled, duration=duration)
        return record_exact(exact, duration, sample, reason)
    if chosen in OTHERS:
        if compiled is not None:
            raise ValueError(f"compiled must be None for {chosen}, got {compiled!r}")
        plan = Plan(chosen, reason, *OTHERS[chosen])
        return record(_other(chosen, scene, settings), scene, duration, sample, plan)
    steps = duration / settings["dt"]
    code = choose_code(scene, chosen, steps, settings["iterations"], compiled)
    stepper = EngineStepper(scene, solver=chosen, compiled=code.compiled, **settings)
    plan = Plan(chosen, reason, code.code, code.reason)
    return record(stepper, scene, duration, sample, plan)


def _other(solver: str, scene: Scene, settings: dict[str, Any]) -> Stepper:
    """Return another engine at work on a scene; it is loaded only when asked for."""
    if solver == "pymunk":
        from lesson_code.reference.pymunk_reference import PymunkStepper

        return PymunkStepper(scene, **settings)
    from lesson_code.reference.box2d_reference import Box2DStepper

    return Box2DStepper(scene, **settings)


def _impact_rules(solver: str, impacts: str, restitution_law: str) -> dict[str, str]:
    """Return what the direct solver is to be told of impacts, or refuse what a solver has not."""
    chosen = {"impacts": impacts, "restitution_law": restitution_law}
    for name, value in chosen.items():
        first, *_ = IMPACT_CHOICES[name]
        if value not in IMPACT_CHOICES[name]:
            raise ValueError(
                f"{name} must be one of {', '.join(IMPACT_CHOICES[name])}, got {value!r}"
            )
        if solver != "direct" and value != first:
            raise ValueError(f"{name} must be {first!r} unless solver is 'direct', got {value!r}")
    return chosen if solver == "direct" else {}


def _count(name: str, value: int) -> int:
    """Return a number of times, or refuse what is none."""
    number = one_number(name, value, positive)
    if not number.is_integer():
        raise ValueError(f"{name} must be a whole number, got {value!r}")
    return int(number)
