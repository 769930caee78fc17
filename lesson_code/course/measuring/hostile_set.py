"""What each rung of isolation stops and what it cannot: hostile submissions, run on all of them."""

from __future__ import annotations

import os
import time
import tomllib
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rich.table import Table

from lesson_code.course.grading.exercises import exercise_by_name
from lesson_code.course.grading.submission import read_submission
from lesson_code.course.grading.verdict import judge
from lesson_code.course.isolation import (
    RUNGS,
    Children,
    InForce,
    IsolationError,
    Limits,
    Rung,
    StudentProcess,
    opened,
)
from lesson_code.course.isolation.call_outcome import CallOutcome
from lesson_code.course.measuring.processes import end, processes_below, processes_of_children

VERSION = 1
FOLDER = Path("tests") / "course" / "golden"
NEIGHBOUR = "right_notebook.ipynb"
SEED = 7

OPEN_TO_ALL, LEFT = ("/tmp", "/var/tmp", "/dev/shm"), "answers-for-a-friend"  # noqa: S108
"""Where a submission may leave something for the next one, and under which name it does."""

SECONDS_TO_END = 1
"""How long what was ended may take to be gone, on a machine that does other things too."""

LIMITS = Limits(seconds_to_load=2.0, seconds_a_call=0.5, bytes_of_memory=600_000_000)
"""Less than usual, so that what never ends is soon cut off."""


@dataclass(frozen=True)
class Hostile:
    """A hostile submission, and what it earns where everything it tries is stopped."""

    name: str
    path: Path
    exercise: str
    points: tuple[int, ...]
    runs: int = 1


@dataclass(frozen=True)
class OnRung:
    """The outcome of all hostile submissions on one rung: the isolation, and what got through."""

    rung: str
    in_force: InForce | None
    missing: str
    through: dict[str, tuple[str, ...]]

    @property
    def contained(self) -> int:
        """The number of submissions of which nothing got through."""
        return sum(not found for found in self.through.values())


@dataclass(frozen=True)
class HostileRuns:
    """The hostile set on every rung."""

    rungs: tuple[OnRung, ...]

    @property
    def full_holds(self) -> bool:
        """Whether nothing got through where the isolation was said to be full."""
        return all(
            on.contained == len(on.through)
            for on in self.rungs
            if on.in_force is not None and on.in_force.level == "full"
        )

    def as_dict(self) -> dict[str, Any]:
        """Return the runs as one JSON object."""
        return {
            "version": VERSION,
            "command": "measure isolation",
            "user": "root" if os.geteuid() == 0 else "not root",
            "rungs": [
                {
                    "rung": on.rung,
                    "isolation": None if on.in_force is None else on.in_force.as_dict(),
                    "missing": on.missing,
                    "submissions": len(on.through),
                    "contained": on.contained,
                    "got_through": {name: list(found) for name, found in on.through.items()},
                }
                for on in self.rungs
            ],
        }

    def as_table(self) -> Table:
        """Return a table of what got through, a row a submission."""
        there = [on for on in self.rungs if on.in_force is not None]
        who = "root" if os.geteuid() == 0 else "a user who is not root"
        table = Table(
            "submission", *(on.rung for on in there), title=f"What gets through, as {who}"
        )
        table.add_row("level", *(on.in_force.level for on in there if on.in_force))
        contained = (f"{on.contained} of {len(on.through)}" for on in there)
        table.add_row("contained", *contained, end_section=True)
        for name in there[0].through if there else ():
            table.add_row(
                name.replace("_", " "), *("\n".join(on.through[name]) or "-" for on in there)
            )
        missing = "; ".join(f"{on.rung}: {on.missing}" for on in self.rungs if on.missing)
        table.caption = f"- nothing. Not here: {missing}" if missing else "- nothing"
        return table


def run_hostile_set(
    root: Path,
    only: Iterable[str] = (),
    told: Callable[[str, float], None] = lambda *_: None,
) -> HostileRuns:
    """Run every hostile submission on every rung of isolation.

    Parameters
    ----------
    root : Path
        The workbook's folder.
    only : iterable of str
        Names of rungs; all by default.
    told : callable
        Receives progress messages, and the share of the work that is done.

    Raises
    ------
    ValueError
        There is no hostile set in that folder, or no such rung.
    """
    hostile = hostile_set(root)
    chosen = chosen_rungs(only)
    neighbour = root / FOLDER / NEIGHBOUR
    return HostileRuns(
        tuple(
            _on_rung(rung, hostile, neighbour, _share(told, at, len(chosen)))
            for at, rung in enumerate(chosen)
        )
    )


def chosen_rungs(names: Iterable[str]) -> list[Rung]:
    """Return the rungs of these names, the best first; all if there are no names.

    Raises
    ------
    ValueError
        There is no such rung.
    """
    known = [rung.name for rung in RUNGS]
    wanted = list(names) or known
    for name in wanted:
        if name not in known:
            raise ValueError(f"rung must be one of {', '.join(known)}, got {name!r}")
    return [rung for rung in RUNGS if rung.name in wanted]


def hostile_set(root: Path) -> list[Hostile]:
    """Return the hostile submissions of a workbook."""
    table = root / FOLDER / "golden.toml"
    if not table.is_file():
        raise ValueError(f"the hostile submissions are not in {root / FOLDER}")
    entries: dict[str, Any] = tomllib.loads(table.read_text(encoding="utf-8"))
    return [
        Hostile(
            Path(name).stem,
            table.parent / name,
            entry["exercise"],
            tuple(entry["points"]),
            entry.get("runs", 1),
        )
        for name, entry in entries.items()
        if name.startswith("hostile/")
    ]


def _share(told: Callable[[str, float], None], done: int, of: int) -> Callable[[str, float], None]:
    """Return a listener for one part of several."""
    return lambda what, share: told(what, (done + share) / of)


def _on_rung(
    rung: Rung,
    hostile: list[Hostile],
    neighbour: Path,
    told: Callable[[str, float], None],
) -> OnRung:
    """Return what comes of all hostile submissions on one rung."""
    try:
        children, in_force = opened(rung, LIMITS)
    except IsolationError as error:
        return OnRung(rung.name, None, str(error), {})
    if in_force.level == "none":
        children.close()
        return OnRung(rung.name, None, "not tried: nothing would hold what is run there", {})
    through = {}
    try:
        for at, each in enumerate(hostile):
            told(f"{rung.name}: {each.name}", at / len(hostile))
            through[each.name] = _what_got_through(children, each, neighbour)
    finally:
        children.close()
        end(processes_of_children())
    return OnRung(rung.name, in_force, "", through)


def _what_got_through(children: Children, hostile: Hostile, neighbour: Path) -> tuple[str, ...]:
    """Return in a few words each what a submission has reached, from inside and from outside."""
    found = []
    for _ in range(hostile.runs):
        points, outcome = _graded(children, hostile.path, hostile.exercise)
        if sum(points) > sum(hostile.points):
            found.append("earns more")
        if isinstance(outcome.value, list):
            found += [word for word in outcome.value if isinstance(word, str)]
    exercise = exercise_by_name("01")
    if sum(_graded(children, neighbour, exercise.name)[0]) != exercise.points:
        found.append("costs the next one marks")
    if left := _left_running():
        found.append("outlives its end")
        end(left)
    for folder in OPEN_TO_ALL:
        (Path(folder) / LEFT).unlink(missing_ok=True)
    return tuple(sorted(set(found)))


def _graded(children: Children, path: Path, exercise: str) -> tuple[list[int], CallOutcome]:
    """Return a submission's points, task by task, and what it says of itself."""
    tasks = exercise_by_name(exercise).tasks
    with StudentProcess(read_submission(path).units, children, LIMITS) as student:
        points = [judge(task, student.call, SEED).points for task in tasks]
        return points, student.call("got_through", ())


def _left_running() -> set[int]:
    """Return the processes of past children that are still there after a while."""
    for _ in range(SECONDS_TO_END * 20):
        left = processes_of_children() - processes_below(os.getpid())
        if not left:
            return set()
        time.sleep(0.05)
    return left
