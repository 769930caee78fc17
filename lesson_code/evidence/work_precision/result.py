"""What was measured: one point for each method, code and setting; and its form as JSON.

A point that has failed keeps its place: with its error, if it has one, and the word for what
happened.
"""

from __future__ import annotations

import json
import math
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, TypeAlias

from lesson_code.evidence.work_precision.methods import Setting

VERSION = 1
"""Version of the form that :meth:`WorkPrecision.as_dict` writes; it grows when a key changes."""

STORED = Path(__file__).with_name("stored.json")
"""A result that was measured once, for the notebook."""

Line: TypeAlias = tuple[str, str]
"""A method and its code."""


@dataclass(frozen=True)
class Point:
    """One method at one setting, in one code, in one scene.

    Attributes
    ----------
    scene, method, code : str
        Names; the code is "Python", "compiled", "C" or "C++".
    dt : float
        s; 0 for the method that has no step.
    iterations, substeps : int
        In a step.
    error : float
        In the scene's norm; ``math.inf`` where there is no answer at all.
    seconds : float
        The shortest of the repeats, s; ``math.nan`` where nothing was timed.
    contact_solves : int
        Visits to a contact: contacts times sweeps, over the whole run. -1: not known.
    pair_tests : int
        Pairs whose outlines were compared, over the whole run. -1: not known.
    failure : str
        What went wrong, in a word or two; "" where nothing did.
    """

    scene: str
    method: str
    code: str
    dt: float
    iterations: int
    substeps: int
    error: float
    seconds: float = math.nan
    contact_solves: int = -1
    pair_tests: int = -1
    failure: str = ""

    @property
    def setting(self) -> Setting:
        """What the method was told."""
        return Setting(self.dt, self.iterations, self.substeps)

    @property
    def line(self) -> Line:
        """The line it belongs to in a figure."""
        return self.method, self.code

    @property
    def milliseconds(self) -> float:
        """Its time, ms."""
        return 1e3 * self.seconds


@dataclass(frozen=True)
class WorkPrecision:
    """All points of a measurement, and where and how it was made.

    Attributes
    ----------
    points : tuple of Point
        In the order in which they were measured.
    repeats : int
        How often each was timed, unless it was slow.
    machine : dict
        Versions and the kind of processor.
    """

    points: tuple[Point, ...]
    repeats: int
    machine: dict[str, str]

    @property
    def scenes(self) -> list[str]:
        """The names of the scenes, in order."""
        return list(dict.fromkeys(point.scene for point in self.points))

    def of(self, scene: str) -> list[Point]:
        """Return the points of a scene.

        Raises
        ------
        ValueError
            It was not measured.
        """
        found = [point for point in self.points if point.scene == scene]
        if not found:
            raise ValueError(f"scene must be one of {', '.join(self.scenes)}, got {scene!r}")
        return found

    def lines(self, scene: str) -> dict[Line, list[Point]]:
        """Return the points of a scene, line by line."""
        lines: dict[Line, list[Point]] = {}
        for point in self.of(scene):
            lines.setdefault(point.line, []).append(point)
        return lines

    def as_dict(self) -> dict[str, Any]:
        """Return all of it as one JSON object; null stands for what is not known or not finite."""
        return {
            "version": VERSION,
            "command": "measure accuracy",
            "repeats": self.repeats,
            "machine": self.machine,
            "points": [_plain(asdict(point)) for point in self.points],
        }

    def merged(self, other: WorkPrecision) -> WorkPrecision:
        """Return a result in which scenes measured anew stand in the place of the old ones."""
        points = [point for point in self.points if point.scene not in other.scenes]
        points += other.points
        order = list(dict.fromkeys([*self.scenes, *other.scenes]))
        points.sort(key=lambda point: order.index(point.scene))
        return replace(other, points=tuple(points))


def from_dict(data: dict[str, Any]) -> WorkPrecision:
    """Return the result that was written as a JSON object.

    Raises
    ------
    ValueError
        It is of another version.
    """
    if data.get("version") != VERSION:
        raise ValueError(f"version must be {VERSION}, got {data.get('version')!r}")
    points = tuple(Point(**_full(point)) for point in data["points"])
    return WorkPrecision(points, data["repeats"], data["machine"])


def stored() -> WorkPrecision:
    """Return the result that the package holds."""
    return from_dict(json.loads(STORED.read_text(encoding="utf-8")))


def store(result: WorkPrecision, path: Path = STORED) -> None:
    """Write a result, a line for each point."""
    data = result.as_dict()
    points = ",\n".join("  " + json.dumps(point) for point in data.pop("points"))
    head = json.dumps(data, indent=1)[:-2]
    path.write_text(f'{head},\n "points": [\n{points}\n ]\n}}\n', encoding="utf-8")


MISSING = {"error": math.inf, "seconds": math.nan, "contact_solves": -1, "pair_tests": -1}
"""What null stands for in a point."""


def _plain(point: dict[str, Any]) -> dict[str, Any]:
    """Return a point as JSON can hold it; times with four digits, for they have no more."""
    seconds = float(f"{point['seconds']:.4g}")
    return {key: _or_null(key, value) for key, value in {**point, "seconds": seconds}.items()}


def _or_null(key: str, value: Any) -> Any:
    """Return a value, or None where it is not known or not finite."""
    unknown = isinstance(value, float) and not math.isfinite(value)
    return None if key in MISSING and (unknown or value == -1) else value


def _full(point: dict[str, Any]) -> dict[str, Any]:
    """Return the fields of a point, with null filled in."""
    return {key: MISSING[key] if value is None else value for key, value in point.items()}
