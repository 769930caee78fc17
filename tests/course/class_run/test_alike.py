"""Copies are remarked with both passages; what was found by another way is not."""

from __future__ import annotations

import ast
import inspect
import json
import textwrap
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from lesson_code.course.class_run import Gradebook, Hands, grade_class
from lesson_code.course.class_run.alike import FEWEST, Passage, _alike_pairs, _lesson
from lesson_code.course.class_run.exports import as_dict
from lesson_code.course.class_run.pages import class_page, student_page
from lesson_code.course.grading.exercises import Exercise, exercises
from lesson_code.course.isolation.inside.winnowing import K, W, fingerprints, winnowed

from .conftest import RIGHT, MakeClass


class Renamed(ast.NodeTransformer):
    """Calls arguments and variables otherwise, and says something else."""

    def visit_Name(self, node: ast.Name) -> ast.Name:
        """Rename a variable."""
        return ast.Name(f"my_{node.id}", node.ctx)

    def visit_arg(self, node: ast.arg) -> ast.arg:
        """Rename an argument."""
        return ast.arg(f"my_{node.arg}")

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.FunctionDef:
        """Say something else."""
        self.generic_visit(node)
        start = 1 if ast.get_docstring(node) is not None else 0
        node.body[:start] = [ast.Expr(ast.Constant("My own work."))]
        return node


def code_of(exercise: Exercise, root: Path) -> str:
    """Return the code of an exercise's solution."""
    text = exercise.solution(root).read_text(encoding="utf-8")
    if exercise.suffix == ".py":
        return text
    cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "code"]
    return "\n\n".join("".join(cell["source"]) for cell in cells)


def prints_of(source: str) -> dict[str, frozenset[str]]:
    """Return the fingerprints of each function in some code."""
    body = ast.parse(source).body
    return {found["name"]: frozenset(found["prints"]) for found in fingerprints(body)}


@pytest.mark.parametrize("exercise", exercises(), ids=lambda exercise: exercise.name)
def test_fingerprints_do_not_depend_on_names_comments_and_layout(
    exercise: Exercise, root: Path
) -> None:
    """Every solution, with other names and another docstring, has those that it had."""
    source = code_of(exercise, root)
    other = ast.unparse(Renamed().visit(ast.parse(source)))
    assert prints_of(source)
    assert prints_of(source) == prints_of(other)


SEQUENCES = st.lists(st.sampled_from("abcdef"), max_size=30)


@given(SEQUENCES, SEQUENCES, SEQUENCES, SEQUENCES, st.lists(st.integers(), min_size=K + W - 1))
def test_sequences_with_enough_in_common_share_a_fingerprint(
    before: list[str], after: list[str], other: list[str], end: list[str], common: list[int]
) -> None:
    """K + W - 1 nodes in a row, wherever they stand: the guarantee of winnowing."""
    shared = list(map(str, common))
    one, two = before + shared + after, other + shared + end
    assert set(winnowed(one)) & set(winnowed(two))


def known(exercise: Exercise, root: Path) -> dict[str, list[tuple[str, frozenset[str]]]]:
    """Return the names and fingerprints of the right answers that are known to each task."""
    solutions = prints_of(code_of(exercise, root))
    found = {}
    for task in exercise.tasks:
        named = [("solution", solutions[task.function])]
        for answer in task.alternatives:
            try:
                source = textwrap.dedent(inspect.getsource(answer.function))
            except OSError:  # made by editing the text of another one
                continue
            named.append((answer.name, next(iter(prints_of(source).values()))))
        found[task.id] = named
    return found


def test_right_answers_by_other_ways_are_not_remarked(root: Path) -> None:
    """No two of them are alike, though one hand wrote them all; nor is one like a formula.

    Where two are, as from_hit_to_hit and the solution in 7.5, the task is said to have one form.
    """
    formulas = [passage for passage in _lesson() if "/chapters/" not in passage.name]
    one_form = {task.id for e in exercises() for task in e.tasks if task.has_one_form}
    coincide: set[str] = set()
    count = 0
    for exercise in exercises():
        for task, answers in known(exercise, root).items():
            passages = [Passage((), name, "", prints) for name, prints in answers]
            count += len(passages)
            for k, passage in enumerate(passages):
                for other in [*passages[:k], *formulas]:
                    twins = alike(passage, other)
                    assert not twins or (task in one_form and k), (task, passage.name, other.name)
                    coincide |= {task} if twins else set()
    assert count > 150
    assert coincide == one_form


def alike(one: Passage, other: Passage) -> bool:
    """Return whether two passages would be remarked if they were of different hands."""
    hands = [Passage(("one",), "", "", one.prints), Passage(("other",), "", "", other.prints)]  # type: ignore[arg-type]
    return bool(list(_alike_pairs(hands)))


CONTACT = """
import numpy as np

def circle_contact(p1, r1, p2, r2):
    # the line of centres
    offset = np.asarray(p2, dtype=float) - np.asarray(p1, dtype=float)
    distance = np.hypot(offset[0], offset[1])
    depth = r1 + r2 - distance
    if depth <= 0:
        return None
    if distance == 0:
        return np.array([1.0, 0.0]), depth
    normal = offset / distance
    return normal, depth
"""

OWN = """
import math

def circle_contact(p1, r1, p2, r2):
    dx, dy = p2[0] - p1[0], p2[1] - p1[1]
    gap = math.sqrt(dx * dx + dy * dy)
    if gap >= r1 + r2:
        return None
    n = (dx / gap, dy / gap) if gap else (1, 0)
    return n, r1 + r2 - gap
"""


CALLS = "def circle_contact(p1, r1, p2, r2):\n    return helper((p1, p2), (p1, p2), r1, r2)\n"


@pytest.fixture
def book(make_class: MakeClass, root: Path, tmp_path: Path) -> Gradebook:
    """Return the marks of four students: two copies, one answer of its own, one of the lesson."""
    copied = ast.unparse(Renamed().visit(ast.parse(CONTACT)))
    for ours in ("np", "float"):
        copied = copied.replace(f"my_{ours}", ours)
    rules = root / "lesson_code" / "chapters" / "pool" / "rules.py"
    packed = renamed_in(rules, "share_impact")
    folder = make_class(
        {
            "ada/04_circles.py": CONTACT,
            "bob/04_circles.py": copied,
            "cyd/04_circles.py": OWN,
            "dan/04_circles.py": f"{CALLS}\n\n{packed}\n",
        }
    )
    return grade_class(folder, tmp_path / "out", exercises=["04"], seed=7, hands=Hands(1))


def renamed_in(path: Path, function: str) -> str:
    """Return a function of a module as its text, under another name."""
    source = path.read_text(encoding="utf-8")
    part = next(n for n in ast.parse(source).body if getattr(n, "name", "") == function)
    return (ast.get_source_segment(source, part) or "").replace(function, "helper")


def test_copies_are_remarked_with_both_passages(book: Gradebook) -> None:
    """A renamed copy, and a helper that is the lesson's; not what everybody writes in short."""
    said = as_dict(book)["alike"]
    found = [[(p["who"], p["function"]) for p in alike["passages"]] for alike in said]
    assert found == [
        [([], "lesson_code/chapters/pool/rules.py: share_impact"), (["dan"], "helper")],
        [(["ada"], "circle_contact"), (["bob"], "circle_contact")],
    ]
    assert "# the line of centres" in said[1]["passages"][0]["text"]
    assert "my_offset" in said[1]["passages"][1]["text"]
    assert all("passages" not in r for s in as_dict(book)["students"] for r in s["exercises"])


def test_packed_formulas_are_remarked_one_by_one(
    make_class: MakeClass, root: Path, tmp_path: Path
) -> None:
    """Of a file that packs all formulas, each function that is long enough is shown."""
    paths = sorted((root / "lesson_code" / "formulas").rglob("*.py"))
    functions = [
        part
        for path in paths
        for part in ast.parse(path.read_text(encoding="utf-8")).body
        if isinstance(part, ast.FunctionDef)
    ]
    packed = "\n\n".join(ast.unparse(Renamed().visit(part)) for part in functions)
    folder = make_class({"eve/05_spin_and_friction.py": packed})
    book = grade_class(folder, tmp_path / "out", exercises=["05"], seed=7, hands=Hands(1))
    said = json.loads((tmp_path / "out" / "grades.json").read_text(encoding="utf-8"))["alike"]
    page = (tmp_path / "out" / "class.html").read_text(encoding="utf-8")
    remarked = {passage["function"] for alike in said for passage in alike["passages"]}
    long = {name for name, prints in prints_of(packed).items() if len(prints) >= FEWEST}
    assert len(long) >= 10
    assert long <= remarked
    assert all(alike["passages"][0]["who"] == [] for alike in said)
    assert all(name in page for name in long)
    assert book.students[0].status == "graded"


def test_of_very_many_functions_the_longest_are_compared_and_it_is_said(
    make_class: MakeClass, tmp_path: Path
) -> None:
    """A copy is found among hundreds of short ones, and a class page takes no hours."""
    short = "".join(f"def f{n}():\n    aa = bb = {n}\n    return aa + bb\n" for n in range(300))
    folder = make_class({"ada/04_circles.py": CONTACT, "bob/04_circles.py": f"{short}\n{CONTACT}"})
    book = grade_class(folder, tmp_path / "out", exercises=["04"], seed=7, hands=Hands(1))
    [alike] = book.alike
    assert [passage.name for passage in alike.passages] == ["circle_contact"] * 2
    assert [student.notes for student in book.students] == [
        (),
        ("bob/04_circles.py: only its 100 longest functions are compared",),
    ]


def test_remark_changes_no_mark_and_no_student_sees_it(book: Gradebook) -> None:
    """The class's page has the passages; a student's has neither them nor a word of it."""
    page = class_page(book)
    assert "Answers that are alike" in page
    assert "the lesson, lesson_code/chapters/pool/rules.py: share_impact" in page
    ada, bob, *_ = book.students
    assert ada.points == bob.points > 0
    for student in book.students:
        assert "alike" not in student_page(student, book)
        assert "share_impact" not in student_page(student, book)


BLOCKS = """
def pi_collisions(mass_ratio):
    inner, outer, count = 0.0, -1.0, 0
    while inner > outer:
        centre = (inner + mass_ratio * outer) / (1 + mass_ratio)
        inner, outer, count = 2 * centre - inner, 2 * centre - outer, count + 1
        if inner < 0:
            inner, count = -inner, count + 1
    return count
"""


def test_honest_answers_to_a_task_of_one_form_are_not_remarked(
    make_class: MakeClass, tmp_path: Path
) -> None:
    """Both have full marks, long enough to tell as they are; nobody is named for it."""
    other = ast.unparse(Renamed().visit(ast.parse(BLOCKS)))
    assert len(prints_of(BLOCKS)["pi_collisions"]) >= FEWEST
    folder = make_class({"ada/07_time_of_impact.py": BLOCKS, "bob/07_time_of_impact.py": other})
    book = grade_class(folder, tmp_path / "out", exercises=["07"], seed=7, hands=Hands(1))
    assert [student.points for student in book.students] == [3, 3]
    assert book.alike == ()


MEAN = """
def inelastic_1d(m1, v1, m2, v2):
    whole_mass = m1 + m2
    shared = (m1 * v1 + m2 * v2) / whole_mass
    return shared, shared

def elastic_impulse_1d(m1, v1, m2, v2):
    reduced_mass = m1 * m2 / (m1 + m2)
    return 2 * reduced_mass * (closing := v1 - v2)
"""
"""Short answers with names of their author's own."""


def test_short_answers_word_for_word_are_remarked(make_class: MakeClass, tmp_path: Path) -> None:
    """Four names of one's own in the same short functions tell; other names, or a crowd, do not."""
    other = MEAN.replace("whole_mass", "total").replace("reduced_mass", "mu")
    crowd = {f"many-{n}/01_one_dimension.py": RIGHT for n in range(5)}
    folder = make_class(
        {
            "ada/01_one_dimension.py": MEAN,
            "bob/01_one_dimension.py": f"# mine\n{MEAN}",
            "cyd/01_one_dimension.py": other,
            **crowd,
        }
    )
    book = grade_class(folder, tmp_path / "out", exercises=["01"], seed=7, hands=Hands(1))
    assert [[s.label for s in alike.who] for alike in book.alike] == [["ada", "bob"]]


def test_answer_of_one_form_is_remarked_word_for_word(
    make_class: MakeClass, tmp_path: Path
) -> None:
    """Everybody's answer to 7.5 has one form, but not one's own names."""
    folder = make_class({f"{name}/07_time_of_impact.py": BLOCKS for name in ("ada", "bob")})
    book = grade_class(folder, tmp_path / "out", exercises=["07"], seed=7, hands=Hands(1))
    assert [[s.label for s in alike.who] for alike in book.alike] == [["ada", "bob"]]


def test_what_is_short_is_no_evidence() -> None:
    """An answer of a formula or two has too few fingerprints to be remarked at all."""
    short = prints_of(
        "def f(m1, v1, m2, v2):\n    c = (m1 * v1 + m2 * v2) / (m1 + m2)\n    return c, c"
    )
    assert len(short["f"]) < FEWEST
