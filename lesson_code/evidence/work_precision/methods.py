"""The methods that are compared, the settings they are tried at, and one run of each.

Plain Python and compiled code give the same bits. So an error is measured once for both; only the
times are two.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from lesson_code.engine.core.constants import SLOP
from lesson_code.engine.core.mixing import MIXING_RULES
from lesson_code.engine.core.recording import record
from lesson_code.engine.core.run import Run
from lesson_code.engine.event_driven import ExactSolver, record_exact
from lesson_code.evidence.engines import Stepper, has_box2d, stepper_for
from lesson_code.evidence.work_precision.scenes import PrecisionScene

STEP = 1 / 60
"""s: the step in which sweeps are split."""

STEPS = tuple(1 / (30 * 2**n) for n in range(8))
"""s: from 1/30 to 1/3840."""

SPLITS = ((1, 10), (2, 5), (5, 2), (10, 1), (1, 100), (2, 50), (4, 25), (10, 10), (20, 5), (100, 1))
"""Sub-steps and iterations in a step: their product is 10 or 100 sweeps."""

SPRING_SPLITS = ((5, 1), (1, 5), (1, 50), (2, 25), (5, 10), (10, 5), (25, 2), (50, 1))
"""The same for the solver with sub-steps, which sweeps twice in each iteration."""

BOX2D_SPLITS = ((1, 1), (2, 1), (5, 1), (10, 1), (25, 1), (50, 1))
"""Sub-steps of Box2D, which has no iterations: it sweeps once before and once after each motion."""

PARTS = ((1, 1), (2, 1), (4, 1), (10, 1))
"""Sub-steps of the naive solver, which sweeps once, and of the direct one, which need not."""

COMPILED, PLAIN = "compiled", "Python"


@dataclass(frozen=True, order=True)
class Setting:
    """A method's setting: the step, s, and the number of sweeps in one.

    A dt of 0 stands for no step at all: the exact solver's.
    """

    dt: float
    iterations: int
    substeps: int

    @property
    def sweeps(self) -> int:
        """Sweeps over the contacts in a step, half of them for relaxing where there are such."""
        return self.iterations * self.substeps

    def __str__(self) -> str:
        """Return the setting in words."""
        if self.dt == 0.0:
            return "no steps"
        return f"1/{1 / self.dt:.0f} s, {self.substeps} x {self.iterations}"


@dataclass(frozen=True)
class Method:
    """A way to move a scene in time.

    Attributes
    ----------
    name : str
        As :func:`lesson_code.simulate` takes it.
    codes : tuple of str
        What it runs as: its points are timed in each.
    iterations, substeps : int
        Where the length of the step is what is swept.
    sweeps_an_iteration : int
        How often all contacts are visited in an iteration.
    """

    name: str
    codes: tuple[str, ...]
    iterations: int = 10
    substeps: int = 1
    sweeps_an_iteration: int = 1

    def settings(self, scene: PrecisionScene) -> Iterator[Setting]:
        """Yield the settings that it is tried at, the cheapest first."""
        if self.name == "exact":
            yield Setting(0.0, 1, 1)
        elif scene.swept == "dt":
            for dt in STEPS:
                yield Setting(dt, self.iterations, self.substeps)
        else:
            yield from (Setting(STEP, iterations, n) for n, iterations in self._splits())

    def _splits(self) -> tuple[tuple[int, int], ...]:
        """Return the sub-steps and iterations where these are what is varied."""
        if self.name == "substep":
            return SPRING_SPLITS
        if self.name == "box2d":
            return BOX2D_SPLITS
        if self.name == "direct":
            return PARTS[:3]  # each costs seconds in a tall stack, and none is wrong
        return PARTS if self.name == "naive" else SPLITS


METHODS = {
    method.name: method
    for method in (
        Method("naive", (PLAIN,), iterations=1),
        Method("sequential", (COMPILED, PLAIN)),
        Method("substep", (COMPILED, PLAIN), iterations=1, substeps=4, sweeps_an_iteration=2),
        Method("direct", (PLAIN,), iterations=1),
        Method("exact", (PLAIN,), iterations=1),
        Method("pymunk", ("C",)),
        Method("box2d", ("C",), iterations=1, substeps=4, sweeps_an_iteration=2),
    )
}
"""All methods, by name. The direct solver's Python calls LAPACK's linear algebra."""


def methods_here() -> list[Method]:
    """Return the methods that can run on this machine."""
    return [m for m in METHODS.values() if m.name != "box2d" or has_box2d()]


def stepper(scene: PrecisionScene, method: Method, setting: Setting, *, compiled: bool) -> Stepper:
    """Return a solver that advances a scene by steps, writing nothing down.

    Raises
    ------
    ValueError
        The method refuses the scene.
    """
    own: dict[str, Any] = {}
    if method.name == "pymunk":
        own["slop"] = None if scene.own_slop else our_slop(scene)
    elif method.name != "box2d":
        own["compiled"] = compiled
    sweeps = {"iterations": setting.iterations, "substeps": setting.substeps}
    return stepper_for(method.name, scene.scene, dt=setting.dt, **sweeps, **own)


def exact_solver(scene: PrecisionScene) -> ExactSolver:
    """Return the exact solver at the start of a scene.

    Raises
    ------
    ValueError
        It cannot take the scene.
    """
    return ExactSolver(scene.scene, combine=MIXING_RULES["workbook"], keep_impulses=False)


def our_slop(scene: PrecisionScene) -> float:
    """Return the overlap that our solver leaves alone, m, to be given to pymunk."""
    return SLOP * min(body.shape.min_width for body in scene.scene.bodies if not body.is_static)


def sampled(scene: PrecisionScene, method: Method, setting: Setting, *, compiled: bool) -> Run:
    """Return the run of a method, with states where the error is looked at.

    Raises
    ------
    ValueError
        The method refuses the scene.
    FloatingPointError
        It has lost a body.
    """
    reason = "to be measured"
    if method.name == "exact":
        return record_exact(exact_solver(scene), scene.duration, scene.times, reason)
    made = stepper(scene, method, setting, compiled=compiled)
    return record(made, scene.scene, scene.duration, scene.times, reason)
