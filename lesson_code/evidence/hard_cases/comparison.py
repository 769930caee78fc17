"""All hard cases, ours beside the others: measured, as a table, as JSON, and kept in a file."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Sequence
from contextlib import closing
from dataclasses import dataclass
from importlib.util import find_spec
from io import StringIO
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.table import Table

from lesson_code.evidence.hard_cases.case import OURS, SOLVERS, Outcome, run_case
from lesson_code.evidence.hard_cases.catalogue import CASES, by_theme, case_by_name
from lesson_code.parallel import WorkerDiedError, iter_tasks, usable_cores

VERSION = 1
"""Version of the form that :meth:`Comparison.as_dict` writes; it grows when a key changes."""

STORED = Path(__file__).with_name("stored.json")
"""What the notebook shows: it has no time to run all cases."""

HEADINGS = {"ours": "ours", "naive": "naive", "pymunk": "pymunk", "box2d": "Box2D"}


@dataclass(frozen=True)
class Comparison:
    """How each solver did in each case.

    Attributes
    ----------
    outcomes : tuple of Outcome
        In the order of the catalogue; of each case in the order of the solvers.
    """

    outcomes: tuple[Outcome, ...]

    @property
    def solvers(self) -> tuple[str, ...]:
        """Who took part."""
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

    def as_dict(self, *, with_seconds: bool = True) -> dict[str, Any]:
        """Return all of it as one JSON object; a value of None stands for no finite number."""
        return {
            "version": VERSION,
            "command": "measure hard-cases",
            "solvers": list(self.solvers),
            "held": {solver: self.held(solver) for solver in self.solvers},
            "cases": [self._case_as_dict(name, with_seconds) for name in self.names],
        }

    def _case_as_dict(self, name: str, with_seconds: bool) -> dict[str, Any]:
        """Return a case and its outcomes as a JSON object."""
        case = case_by_name(name)
        said = {
            key: getattr(case, key)
            for key in ("name", "theme", "title", "why", "law", "unit", "bound", "reason")
        }
        outcomes = {s: _outcome_as_dict(self.outcome(name, s), with_seconds) for s in self.solvers}
        return {**said, "ours": dict(case.ours), "outcomes": outcomes}

    def as_table(self) -> Table:
        """Return all of it as a table, grouped by theme; what does not hold the bound is marked."""
        table = Table(
            title="Hard cases: how far each solver is from what is right",
            caption="Over the bound: x. No result: -. Numbers as measured, 0 is right.",
            box=None,
            pad_edge=False,
        )
        table.add_column("case", max_width=20, no_wrap=True)
        table.add_column("unit", max_width=4)
        table.add_column("bound", justify="right", no_wrap=True)
        for solver in self.solvers:
            table.add_column(HEADINGS[solver], justify="right", no_wrap=True)
        for theme, cases in by_theme(tuple(map(case_by_name, self.names))).items():
            table.add_row(f"[bold]{theme}[/bold]")
            for case in cases:
                cells = [_cell(self.outcome(case.name, solver)) for solver in self.solvers]
                table.add_row(
                    f" {case.name}", case.unit, f"{case.bound:.0e}" if case.bound else "0", *cells
                )
        counts = [f"{self.held(solver)}" for solver in self.solvers]
        table.add_row(f"[bold]held, of {len(self.names)}[/bold]", "", "", *counts)
        return table

    def as_text(self, width: int = 100) -> str:
        """Return the table as plain text, so many columns wide."""
        paper = StringIO()
        Console(file=paper, width=width, force_jupyter=False, color_system=None).print(
            self.as_table()
        )
        return "\n".join(line.rstrip() for line in paper.getvalue().splitlines())


def _outcome_as_dict(outcome: Outcome, with_seconds: bool) -> dict[str, Any]:
    """Return an outcome as a JSON object."""
    value = outcome.value if math.isfinite(outcome.value) else None
    written: dict[str, Any] = {"value": value, "held": outcome.held, "error": outcome.error}
    return written | ({"seconds": round(outcome.seconds, 3)} if with_seconds else {})


def _cell(outcome: Outcome) -> str:
    """Return what was measured, marked if it is over the bound."""
    if math.isnan(outcome.value):
        return "[red]- x[/red]"
    text = _number(outcome.value)
    return f"{text}  " if outcome.held else f"[red]{text} x[/red]"


def _number(value: float) -> str:
    """Return a number in few characters."""
    if value == 0.0 or (value >= 1.0 and value.is_integer() and value < 1e4):
        return f"{value:.0f}"
    return f"{value:.1e}" if not 0.01 <= value < 1000 else f"{value:.3g}"


def installed_solvers() -> tuple[str, ...]:
    """Return ours and those of the others that can be run here."""
    return tuple(s for s in SOLVERS if s != "box2d" or find_spec("Box2D") is not None)


def measure_hard_cases(
    names: Sequence[str] | None = None,
    *,
    solvers: Sequence[str] | None = None,
    workers: int | None = None,
    cluster: str | None = None,
    progress: str | None = None,
) -> Comparison:
    """Run hard cases in every solver, over processes, and return how they did.

    A solver that takes its process with it has no result in that case; the others go on.

    Parameters
    ----------
    names : sequence of str, optional
        The cases; all by default.
    solvers : sequence of str, optional
        "ours" and others; all that are installed by default.
    workers, cluster, progress
        As :func:`lesson_code.parallel.map_tasks` takes them; but there are two workers at the
        least unless one is asked for. One alone would be this process, and die with a solver.

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
    # The long ones first, or the last one would keep everybody waiting.
    order = sorted(range(len(tasks)), key=lambda n: not case_by_name(tasks[n][0]).is_long)
    outcomes = dict(
        _outcomes([tasks[n] for n in order], workers=workers, cluster=cluster, progress=progress)
    )
    return Comparison(tuple(outcomes[task] for task in tasks))


Task = tuple[str, str]
"""The names of a case and of a solver."""


def run_task(task: Task) -> Outcome:
    """Return how a solver does in a case; both are given by name, so that a task can travel."""
    name, solver = task
    return run_case(case_by_name(name), solver)


def _outcomes(tasks: list[Task], **options: Any) -> Iterable[tuple[Task, Outcome]]:
    """Yield each task and what has become of it."""
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


def store(comparison: Comparison, path: Path = STORED) -> None:
    """Write a comparison into the file from which the notebook reads it; without times."""
    text = json.dumps(comparison.as_dict(with_seconds=False), indent=1)
    path.write_text(text + "\n", encoding="utf-8")


def stored(path: Path = STORED) -> Comparison:
    """Return the comparison that was stored.

    Raises
    ------
    ValueError
        The file is of another version.
    """
    read = json.loads(path.read_text(encoding="utf-8"))
    if read["version"] != VERSION:
        raise ValueError(f"version of {path.name} must be {VERSION}, got {read['version']}")
    return Comparison(
        tuple(
            Outcome(
                case["name"],
                solver,
                math.nan if outcome["value"] is None else float(outcome["value"]),
                float(case["bound"]),
                error=outcome["error"],
            )
            for case in read["cases"]
            for solver, outcome in case["outcomes"].items()
        )
    )
