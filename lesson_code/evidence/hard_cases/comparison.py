"""All hard cases in every solver, side by side."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, Self

from rich.table import Table

from lesson_code.evidence.engines import has_box2d
from lesson_code.evidence.hard_cases.case import OURS, SOLVERS, Outcome, run_case
from lesson_code.evidence.hard_cases.catalogue import CASES, case_by_name
from lesson_code.evidence.measurement import Measurement, plain, table
from lesson_code.parallel import WorkerDiedError, iter_tasks, usable_cores

HEADINGS = {"ours": "ours", "naive": "naive", "pymunk": "pymunk", "box2d": "Box2D"}

SAID = ("name", "theme", "title", "why", "law", "unit", "bound", "reason", "ours")
"""The fields of a case that are stored beside its outcomes."""


@dataclass(frozen=True)
class Comparison(Measurement):
    """How each solver did in each case.

    Attributes
    ----------
    outcomes : tuple of Outcome
        In the order of the catalogue, and within a case in the order of the solvers.
    """

    command = "measure hard-cases"
    file = Path(__file__).with_name("stored.json")

    outcomes: tuple[Outcome, ...]

    @property
    def solvers(self) -> tuple[str, ...]:
        """The solvers that took part."""
        present = {outcome.solver for outcome in self.outcomes}
        return tuple(solver for solver in SOLVERS if solver in present)

    @property
    def names(self) -> tuple[str, ...]:
        """The cases that were run."""
        return tuple(dict.fromkeys(outcome.case for outcome in self.outcomes))

    def outcome(self, case: str, solver: str) -> Outcome:
        """Return how a solver did in a case."""
        return next(o for o in self.outcomes if (o.case, o.solver) == (case, solver))

    def held(self, solver: str) -> int:
        """Return how many cases a solver holds."""
        return sum(outcome.held for outcome in self.outcomes if outcome.solver == solver)

    def not_held(self, solver: str = OURS) -> list[str]:
        """Return the cases that a solver does not hold."""
        return [o.case for o in self.outcomes if o.solver == solver and not o.held]

    def without_times(self) -> Comparison:
        """Return the comparison without the seconds, which differ from run to run."""
        return Comparison(tuple(replace(outcome, seconds=math.nan) for outcome in self.outcomes))

    def as_dict(self) -> dict[str, Any]:
        """Return the comparison as one JSON object; null stands for a value that is not finite."""
        return {
            "version": self.version,
            "command": self.command,
            "solvers": list(self.solvers),
            "held": {solver: self.held(solver) for solver in self.solvers},
            "cases": [self._case_as_dict(name) for name in self.names],
        }

    def _case_as_dict(self, name: str) -> dict[str, Any]:
        case = case_by_name(name)
        outcomes = {solver: self.outcome(name, solver) for solver in self.solvers}
        said = {key: plain(getattr(case, key)) for key in SAID}
        return said | {"outcomes": {s: _measured(outcome) for s, outcome in outcomes.items()}}

    @classmethod
    def from_dict(cls, data: Mapping[str, Any]) -> Self:
        """Return the comparison that :meth:`as_dict` has written."""
        return cls(
            tuple(
                Outcome(
                    case["name"],
                    solver,
                    *(math.nan if outcome["value"] is None else outcome["value"], case["bound"]),
                    seconds=math.nan if outcome["seconds"] is None else outcome["seconds"],
                    error=outcome["error"],
                )
                for case in data["cases"]
                for solver, outcome in case["outcomes"].items()
            )
        )

    def tables(self) -> Iterator[Table]:
        """Yield the table, grouped by theme; values beyond the bound are marked."""
        columns: dict[str, Callable[[str], str]] = {
            "case": lambda name: f" {name}",
            "unit": lambda name: case_by_name(name).unit,
            "bound": lambda name: f"{case_by_name(name).bound:.0e}".replace("0e+00", "0"),
            **{HEADINGS[solver]: partial(self._cell, solver) for solver in self.solvers},
        }
        made = table(
            "Hard cases: how far each solver is from what is right",
            columns,
            self.names,
            words=2,
            group=lambda name: case_by_name(name).theme,
            caption="Over the bound: x. No result: -. Numbers as measured, 0 is right.",
            box=None,
        )
        made.columns[0].max_width, made.columns[1].max_width = 20, 4
        counts = [str(self.held(solver)) for solver in self.solvers]
        made.add_row(f"[bold]held, of {len(self.names)}[/bold]", "", "", *counts)
        yield made

    def _cell(self, solver: str, name: str) -> str:
        outcome = self.outcome(name, solver)
        if math.isnan(outcome.value):
            return "[red]- x[/red]"
        text = _number(outcome.value)
        return f"{text}  " if outcome.held else f"[red]{text} x[/red]"


def _measured(outcome: Outcome) -> dict[str, Any]:
    return {key: plain(getattr(outcome, key)) for key in ("value", "held", "error", "seconds")}


def _number(value: float) -> str:
    """Return a number in few characters.

    >>> _number(31.0), _number(0.25), _number(1.2345e-7)
    ('31', '0.25', '1.2e-07')
    """
    if value == 0.0 or (value >= 1.0 and value.is_integer() and value < 1e4):
        return f"{value:.0f}"
    return f"{value:.1e}" if not 0.01 <= value < 1000 else f"{value:.3g}"


def installed_solvers() -> tuple[str, ...]:
    """Return ours and those of the others that can be run here."""
    return tuple(s for s in SOLVERS if s != "box2d" or has_box2d())


def measure_hard_cases(
    names: Sequence[str] | None = None,
    *,
    solvers: Sequence[str] | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    progress: str | None = None,
) -> Comparison:
    """Run hard cases in every solver, over processes, and return how they did.

    A solver that kills its process has no result in that case; the others go on.

    Parameters
    ----------
    names : sequence of str, optional
        The cases; all by default.
    solvers : sequence of str, optional
        "ours" and others; all that are installed by default.
    workers, cluster, progress
        As :func:`lesson_code.parallel.map_tasks` takes them; but the default is at least two
        workers. A single worker would be this process, and would die with a solver.

    Raises
    ------
    ValueError
        There is no case, or no solver, of such a name.
    """
    cases = CASES if not names else tuple(map(case_by_name, names))
    chosen = tuple(solvers) if solvers else installed_solvers()
    for solver in chosen:
        if solver not in SOLVERS:
            raise ValueError(f"solver must be one of {', '.join(SOLVERS)}, got {solver!r}")
    if workers is None:
        workers = max(2, usable_cores())
    tasks = [(case.name, solver) for case in cases for solver in chosen]
    # The long ones first, or one of them would run alone at the end.
    order = sorted(range(len(tasks)), key=lambda n: not case_by_name(tasks[n][0]).is_long)
    outcomes = dict(
        _outcomes([tasks[n] for n in order], workers=workers, cluster=cluster, progress=progress)
    )
    return Comparison(tuple(outcomes[task] for task in tasks))


Task = tuple[str, str]
"""The names of a case and of a solver."""


def run_task(task: Task) -> Outcome:
    """Return how a solver does in a case; both are names, which can be sent to another process."""
    name, solver = task
    return run_case(case_by_name(name), solver)


def _outcomes(tasks: list[Task], **options: Any) -> Iterable[tuple[Task, Outcome]]:
    """Yield each task with its outcome."""
    named = [f"{name}, {solver}" for name, solver in tasks]
    with closing(iter_tasks(run_task, tasks, names=named, **options)) as done:
        for number, future in done:
            task = tasks[number]
            error = future.exception()
            if isinstance(error, WorkerDiedError):
                bound = case_by_name(task[0]).bound
                yield task, Outcome(*task, math.nan, bound, error=f"the process died: {error}")
            else:
                yield task, future.result()
