"""Wrong answers that once had full marks: each loses points, whatever is drawn."""

from __future__ import annotations

import ast
from typing import Any

import pytest
from tiers import share

from lesson_code.chapters import rows_of_balls
from lesson_code.course.grading.exercises import task_by_id
from lesson_code.course.grading.in_process import call_here
from lesson_code.course.grading.recognition.candidates import right_answers
from lesson_code.course.grading.task import Task
from lesson_code.course.grading.tried import TriedCall
from lesson_code.course.grading.verdict import drawn
from lesson_code.course.isolation.call_outcome import CallOutcome

MOST_SEEDS = 20
SEEDS = range(share(MOST_SEEDS, one_in=4))

OUTSIDE = "beyond_start > 0 and beyond_end > 0"

EDITS = {
    "a slow ball does not bounce": ("3.2", "v_n >= 0", "v_n >= -0.5"),
    "centres a millimetre apart coincide": ("4.1", "distance > 0", "distance > 0.001"),
    "circles meet if each moves towards the other": (
        *("4.2", "vn >= 0", "np.dot(v1, normal) <= 0 or np.dot(v2, normal) >= 0"),
    ),
    "friction grips up to vt = mu jn": (
        "5.4",
        "-vt / k",
        "-vt / k if abs(vt) < limit else -9 * vt",
    ),
    "a slow disc does not bounce": ("5.5", "normal) >= 0", "normal) >= -0.5"),
    "a level edge has no normal": ("6.1", "x or y", "x and y"),
    "the first vertex is left out": ("6.2", "vertices @ axis", "vertices[1:] @ axis"),
    "the last vertex is left out": ("6.2", "vertices @ axis", "vertices[:-1] @ axis"),
    "the last edge of B has no axis": ("6.4", "sat_axes(vertices_b)", "sat_axes(vertices_b)[:-1]"),
    "the first edge of A has no axis": ("6.4", "sat_axes(vertices_a)", "sat_axes(vertices_a)[1:]"),
    "a touch leaves not even a point": ("6.5", OUTSIDE, OUTSIDE.replace(">", ">=")),
    "a segment in the line is outside": (
        "6.5",
        OUTSIDE,
        f"beyond_start == beyond_end == 0 or {OUTSIDE}",
    ),
    "the last edge is left out": ("6.6", "strict=True))", "strict=True))[:-1]"),
    "the first edge is left out": ("6.6", "strict=True))", "strict=True))[1:]"),
    "the first edge within the radius counts": (
        *("6.6", "v: np.hypot(v[0], v[1])"),
        "v: np.hypot(v[0], v[1]) * (np.hypot(v[0], v[1]) >= radius)",
    ),
    "a circle that touches overlaps": ("6.6", "distance < radius", "distance <= radius"),
    "circles side by side meet at last": ("7.1", "b >= 0", "b > 0"),
    "so little gravity is none": ("7.2", "gravity > 0", "gravity > 1e-09"),
    "what hovers is as good as falling": ("7.2", "velocity < 0", "velocity <= 0"),
    "circle 0 meets nobody": ("7.4", "range(len(radii))", "range(1, len(radii))"),
    "neighbours in the list do not meet": ("7.4", "i + 1", "i + 2"),
    "all happens within a second": ("7.4", "math.inf", "1.0"),
    "all happens within ten seconds": ("7.4", "math.inf", "10.0"),
    "the first row is left out": ("8.4", "in table", "in table[1:]"),
    "the last row is left out": ("8.4", "in table", "in table[:-1]"),
    "row 0 is never the cheapest": ("8.5", "range(len(table))", "range(1, len(table))"),
    "what is left has to be less": ("9.2", "math.ceil(", "1 + math.floor("),
    "a slow tip does not approach": ("9.3", "vn >= 0", "vn >= -0.5"),
    "a tip at rest jams": ("9.3", "return 0.0", "return 0.0 if vn > 0 else None"),
    "a millimetre a second is quiet": ("9.5", "1e-09", "0.001"),
    "no row strikes more than twenty times": ("9.5", "while True", "for _ in range(20)"),
    "the first pair does not rub": (
        *("10.1", "combinations(range(len(frictions)), 2)"),
        "list(combinations(range(len(frictions)), 2))[1:]",
    ),
    "only the second body need be free": ("10.2", "a[0] > 0 or b[0] > 0", "b[0] > 0"),
    "the second e is that of the pair": ("10.2", "min(a[2], b[2])", "b[2]"),
    "only neighbours in the list meet": (
        *("10.2", "combinations(bodies, 2)", "zip(bodies, bodies[1:])"),
    ),
    "body 0 is the floor": ("10.5", "range(len(still))", "range(1, len(still))"),
    "an island has no more than seven": (
        *("10.5", "while spreading:"),
        "for _ in range(7):\n        if not spreading:\n            break",
    ),
    "boxes that touch from below are apart": ("11.1", "low <= other_high", "low < other_high"),
    "friction has no lower limit": ("11.2", "-friction * j", "-np.inf"),
    "a disc meets only its neighbours": ("11.3", "depth > 0", "depth > 0 and j == i + 1"),
    "a disc does not meet the next but one": ("11.3", "depth > 0", "depth > 0 and j != i + 2"),
    "the first disc does not meet the last": (
        *("11.3", "depth > 0", "depth > 0 and (i, j) != (0, len(p) - 1)"),
    ),
    "a disc is beyond one wall": (
        *("11.3", "v = np.where("),
        "one = inside[:, 0] != p[:, 0]\n    inside[one, 1] = p[one, 1]\n    v = np.where(",
    ),
    "a disc hits one other in a step": (
        *("A.3", "velocities[b] += impulse / masses[b] * normal"),
        "velocities[b] += impulse / masses[b] * normal\n                break",
    ),
    "a ball that touches overlaps": ("B.1", "depth > 0", "depth >= 0"),
    "less than a pixel is no overlap": ("B.2", "depth > 0", "depth > 1"),
    "all steps are of one length": ("B.4", "velocity * dt", "velocity * TIME_STEP"),
    "two corners are enough": ("K.2", "(low[0], high[1]), ", ""),
    "the chain ends at a domino that does not touch": (
        *("D.3", "if angles[k] > touch and rates[k] > rates[k + 1]:"),
        "if angles[k] <= touch:\n                break\n            if rates[k] > rates[k + 1]:",
    ),
}
"""What is believed; and the task, a piece of its solution, and what stands in its place."""

STALE_OVERLAPS = {
    "velocities + gravity * dt)": "velocities + gravity * dt)\n    q = p.copy()",
    "p[j] - p[i]": "q[j] - q[i]",
}

ONE_PARTNER = {
    "for i, j in": "met = set()\n    for i, j in",
    "if depth > 0:": "if depth > 0 and i not in met:\n            met.add(i)",
}


def has_full_marks(task: Task, function: Any, seed: int) -> bool:
    """Return whether a function answers all calls of a draw rightly; one wrong call decides."""
    return all(
        TriedCall(criterion, arguments, expected, _called(task, function, arguments)).is_right
        for criterion in task.criteria
        for arguments, expected in drawn(task, criterion, seed)
    )


def _called(task: Task, function: Any, arguments: Any) -> CallOutcome:
    return call_here({task.function: function}, task.function, arguments, seconds=0.5)


def seeds_with_full_marks(task_id: str, edits: dict[str, str]) -> list[int]:
    """Return the seeds whose draws do not tell an edited solution from the right one."""
    task = task_by_id(task_id)
    answer = right_answers(task.id, task.function)[0]
    source = ast.unparse(answer.definition)
    for old, new in edits.items():
        assert old in source, source
        source = source.replace(old, new)
    names = dict(answer.names)
    exec(source.replace("count_round()", "pass"), names)  # noqa: S102 - the course's own source
    return [seed for seed in SEEDS if has_full_marks(task, names["slip"], seed)]


@pytest.mark.parametrize("belief", EDITS)
def test_wrong_belief_loses_points_in_every_draw(belief: str) -> None:
    """What one sees only where it is drawn: slow, touching, first or last, at either body."""
    task, old, new = EDITS[belief]
    assert seeds_with_full_marks(task, {old: new}) == []
    assert seeds_with_full_marks(task, {}) == list(SEEDS)


@pytest.mark.parametrize("edits", [STALE_OVERLAPS, ONE_PARTNER], ids=["stale", "one partner"])
def test_overlaps_of_discs_found_otherwise_lose_points_in_every_draw(edits: dict[str, str]) -> None:
    """In a row of discs each pair changes what the next one finds; a disc may be in two pairs."""
    assert seeds_with_full_marks("11.3", edits) == []


@pytest.mark.parametrize(
    ("task", "right", "restitution"),
    [("9.5", rows_of_balls.fastest, ()), ("C.1", rows_of_balls.leftmost, (0.8,))],
)
@pytest.mark.parametrize("order", rows_of_balls.ORDERS, ids=lambda order: order.__name__)
def test_another_order_of_strikes_loses_points_in_every_draw(
    task: str, right: Any, restitution: tuple[float, ...], order: Any
) -> None:
    """Leftmost, rightmost, fastest, by rank, in sweeps: only the one that is asked for is right."""

    def answer(masses: Any, velocities: Any, restitution: float = 1.0) -> Any:
        return rows_of_balls.after_strikes(masses, velocities, restitution, order)

    found = [has_full_marks(task_by_id(task), answer, seed) for seed in SEEDS]
    assert found == [order is right] * len(SEEDS)


def test_first_hit_with_the_nearest_neighbour_loses_points_in_every_draw() -> None:
    """A circle's first hit may be with one far away."""
    task = task_by_id("7.4")

    def nearest_only(positions: Any, velocities: Any, radii: Any) -> Any:
        meetings = []
        for i in range(len(radii)):
            gaps = {
                j: abs(complex(*(positions[j] - positions[i]))) - radii[j]
                for j in range(len(radii))
                if j != i
            }
            places = sorted((i, min(gaps, key=lambda j: gaps[j])))
            found = task.expected(positions[places], velocities[places], radii[places])
            meetings += [(found[0], *places)] if found else []
        return min(meetings, default=None)

    assert not any(has_full_marks(task, nearest_only, seed) for seed in SEEDS)
