"""The small engine with a reader's own functions in it, from the exercises.

Where a function is not written yet, the workbook's is lent and named. Where it fails, or first
answers otherwise than the workbook's does for the same bodies, that is named too.
"""

from __future__ import annotations

import textwrap
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from lesson_code.chapters.ch11_the_small_engine import own_answers as answers
from lesson_code.chapters.ch11_the_small_engine.own_stages import OwnStages
from lesson_code.course.grading.own import own_functions
from lesson_code.engine.core.run import Run
from lesson_code.engine.core.scene import Body, Scene
from lesson_code.engine.small_engine import simulate_small
from lesson_code.geometry import Polygon, Segment

STEPS: dict[str, tuple[str, ...]] = {
    "broad phase": ("11.1",),
    "narrow phase": ("4.1", "6.6", "6.4", "6.5"),
    "impulse calculation": ("11.2", "5.2", "5.3", "5.4"),
    "position correction": ("4.3",),
    "velocity update": ("5.1",),
}
"""The steps of the pipeline, and the tasks whose functions do them."""

WIDEST_LINE = 27
"""Letters that a box of the diagram has room for."""


class OwnEngine:
    """An engine made of a reader's functions.

    Parameters
    ----------
    root : Path, optional
        The workbook whose exercises are read; by default the one around the current folder.

    Attributes
    ----------
    functions : dict of str to OwnFunction
        What the reader has written, by the function's name.
    differences : dict of str to str
        By the function's name: where it failed in the last run, or first answered otherwise than
        the workbook's.
    time : float
        Of the step that is made now, s.

    Examples
    --------
    >>> OwnEngine().functions["hit"].task.id
    '11.2'
    """

    def __init__(self, root: Path | None = None) -> None:
        self.functions = own_functions((task for tasks in STEPS.values() for task in tasks), root)
        self.differences: dict[str, str] = {}
        self.time = 0.0

    def __str__(self) -> str:
        """Return a line for each function: whose it is, and its marks."""
        return "\n".join(own.line for own in self.functions.values())

    @property
    def report(self) -> str:
        """What went wrong in the last run, and which functions are lent."""
        lent = [name for name, own in self.functions.items() if not own.is_own]
        is_all = len(lent) == len(self.functions)
        lines = [*self.differences.values()]
        if not lines and not is_all:
            lines.append("no function of yours answered otherwise")
        if lent:
            lines.append("all functions are lent" if is_all else f"lent: {', '.join(lent)}")
        return "\n".join(lines)

    @property
    def boxes(self) -> dict[str, str]:
        """The functions in each step of the pipeline, for its diagram."""
        names = {own.task.id: name for name, own in self.functions.items()}
        marked = {
            task: name if self.functions[name].is_own else f"({name})"
            for task, name in names.items()
        }
        return {
            step: textwrap.fill("  ".join(marked[task] for task in ids), WIDEST_LINE)
            for step, ids in STEPS.items()
        }

    def simulate(self, scene: Scene, duration: float, *, dt: float = 1 / 60) -> Run:
        """Run a scene of circles and polygons.

        Parameters
        ----------
        scene : Scene
            Without damping and callbacks.
        duration, dt : float
            s.

        Raises
        ------
        ValueError
            The scene has damping, callbacks, or a segment.
        """
        self.time, self.differences = 0.0, {}
        bodies = tuple(map(self._with_own_inertia, scene.bodies))
        moved = replace(scene, bodies=bodies)
        return simulate_small(moved, duration, dt=dt, parts=OwnStages(self, dt).parts)

    def ask(
        self,
        name: str,
        *given: Any,
        form: Callable[[Any], Any],
        right: Callable[[], Any],
        same: Callable[[Any, Any], bool] = answers.are_near,
    ) -> Any:
        """Return a function's answer; the workbook's where there is none, or none to go on with.

        Parameters
        ----------
        name : str
            Of the function.
        *given
            Its arguments. Arrays are copied: a function may change what it is given.
        form : callable
            Brings an answer to the form the engine takes, and raises where it cannot.
        right : callable
            Returns the workbook's answer, in that form.
        same : callable
            Whether two answers are equally right.
        """
        own, expected = self.functions[name], right()
        if own.function is None:
            return expected
        try:
            answer = form(own.function(*(np.array(g) if np.ndim(g) else g for g in given)))
        except Exception as error:  # a reader's code may raise anything
            own.give_up(f"failed at {self.time:.3f} s with {type(error).__name__}: {error}")
            self.differences[name] = f"{own.task.title} {own.said}"
            return expected
        if not same(answer, expected):
            self._note_difference(name, answer, expected)
        return answer

    def _note_difference(self, name: str, theirs: Any, ours: Any) -> None:
        """Write down where a function first answers otherwise than the workbook's."""
        said = f"{self.functions[name].task.title} differs first at {self.time:.3f} s"
        values = f"{answers.written(theirs)}, and the workbook's {answers.written(ours)}"
        self.differences.setdefault(name, f"{said}: {values}")

    def _with_own_inertia(self, body: Body) -> Body:
        """Return a body with the moment of inertia that the reader's function gives it."""
        shape = body.shape
        if isinstance(shape, Segment):
            raise ValueError("scene must have no segments: task 6.6 is about polygons")
        if body.inertia is None or not isinstance(shape, Polygon):
            return body
        corners = np.array(shape.vertices)
        given = ("moment_of_inertia", body.mass, corners)
        inertia = self.ask(*given, form=answers.positive_number, right=lambda: body.inertia)
        return replace(body, inertia=inertia)
