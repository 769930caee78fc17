"""simulate(): one door to every solver, ours and pymunk's."""

from __future__ import annotations

from typing import Any

from lesson_code.engine.combination import Combination, combination
from lesson_code.engine.event_driven import ExactSolver, record_exact
from lesson_code.engine.plan import Plan
from lesson_code.engine.recording import Sample, Stepper, record
from lesson_code.engine.run import Run
from lesson_code.engine.scene import Scene
from lesson_code.engine.stepper import SOLVERS, EngineStepper
from lesson_code.formulas.validation import non_negative, one_number, positive

NAMES = ("auto", *SOLVERS, "exact", "pymunk")
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
    iterations: int = 10,
    substeps: int = 1,
    combine: str | Combination = "workbook",
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
        "naive": the first attempt, faults included.
        "direct": the contacts of bodies that touch are solved together, exactly; for great mass
        ratios, tall stacks and even loads. `iterations` means nothing to it.
        "exact": from collision to collision, with no time step; for discs among bodies that do
        not move or move evenly. `dt`, `iterations` and `substeps` mean nothing to it.
        "pymunk": the same scene, stepped by pymunk.
        "auto": the one that suits the scene; at present always "sequential".
    dt : float
        The time step, s, > 0. All steps have this length.
    iterations : int
        Sweeps over the contacts in each step, >= 1. The naive solver makes one.
    substeps : int
        Equal parts that a step is made in, >= 1, each with its own contacts and sweeps.
    combine : str or Combination
        How a pair's restitution and friction come from its bodies': "workbook" (the smaller,
        the geometric mean), "pymunk" (products), "box2d" (the larger, the geometric mean).
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
    chosen = "sequential" if solver == "auto" else solver
    sweeps = _count("iterations", iterations)
    settings: dict[str, Any] = {
        "dt": one_number("dt", dt, positive),
        "iterations": 1 if chosen in ("naive", "direct") else sweeps,
        "substeps": _count("substeps", substeps),
        "combine": combination(combine),
    }
    settings |= _impact_rules(chosen, impacts, restitution_law)
    plan = _plan(solver, chosen)
    if chosen == "exact":
        exact = ExactSolver(scene, combine=settings["combine"])
        return record_exact(exact, duration, sample, plan)
    return record(_stepper(chosen, scene, settings), scene, duration, sample, plan)


def _stepper(solver: str, scene: Scene, settings: dict[str, Any]) -> Stepper:
    """Return a solver at work on a scene; pymunk is loaded only when it is asked for."""
    if solver == "pymunk":
        from lesson_code.reference.pymunk_reference import PymunkStepper

        return PymunkStepper(scene, **settings)
    return EngineStepper(scene, solver=solver, **settings)


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


def _plan(asked: str, chosen: str) -> Plan:
    """Return how a scene is simulated."""
    reason = "asked for" if asked == chosen else "it solves every scene"
    return Plan(chosen, reason)
