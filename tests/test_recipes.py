"""The recipes of CONTRIBUTING, followed in a copy: their lists of files are true."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
CONTRIBUTING = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
SECONDS = 300
NOT_COPIED = shutil.ignore_patterns("__pycache__", "golden", ".*", "workbook")

pytestmark = pytest.mark.full


def files_of(recipe: str) -> list[str]:
    """Return the files that a recipe lists."""
    part = CONTRIBUTING.split(f"\n### {recipe}\n")[1].split("\n##")[0]
    return re.findall(r"^- `([^`]+)`", part, re.M)


def of_chapter(name: str, file: str) -> str:
    """Return which file of a chapter a recipe means."""
    return file.replace("NN_TOPIC", name)


class Copy:
    """A copy of the project, in which a recipe is followed."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        for name in ("lesson_code", "notebooks/source", "exercises", "solutions", "tests/chapters"):
            shutil.copytree(ROOT / name, folder / name, ignore=NOT_COPIED)
        for name in ("README.md", "pyproject.toml", "notebooks/00_start_here.ipynb"):
            shutil.copy(ROOT / name, folder / name)

    def change(self, path: str, edit: Callable[[str], str]) -> None:
        """Write a file again, or for the first time."""
        file = self.folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        before = file.read_text(encoding="utf-8") if file.exists() else ""
        after = edit(before)
        assert after != before, path
        file.write_text(after, encoding="utf-8")

    def run(self, *command: str) -> str:
        """Run Python here with this copy's code, and return what it prints."""
        ran = subprocess.run(
            [sys.executable, *command],
            cwd=self.folder,
            env=os.environ | {"PYTHONPATH": str(self.folder), "COLUMNS": "200"},
            capture_output=True,
            text=True,
            timeout=SECONDS,
            check=False,
        )
        assert ran.returncode == 0, ran.stdout + ran.stderr
        return ran.stdout

    def workbook(self, *arguments: str) -> str:
        """Run the workbook command here, and return what it prints."""
        return self.run("-c", f"from lesson_code.cli import app; app({list(arguments)})")

    def faults(self, exercise: str) -> str:
        """Return what `workbook check --exercises` says of one exercise."""
        return self.run(
            "-c",
            "from pathlib import Path\n"
            "from lesson_code.course.grading import exercises, self_check\n"
            f"one = exercises.exercise_by_name({exercise!r})\n"
            "self_check.exercises = lambda: (one,)\n"
            "found = self_check.faults(Path())\n"
            "print([f for f in found if not f.endswith('belongs to no exercise')])",
        ).strip()


@pytest.fixture
def copy(tmp_path: Path) -> Copy:
    """Return a copy of the project."""
    return Copy(tmp_path)


# A task: one more of chapter 01, after the pattern of the last one

WRONG = '''

@wrong_model("1.4", "A truck meets a fly head on. Does the truck lose half its speed?")
def average(m1, v1, m2, v2):
    """Both go on at the average of their velocities."""
    return (v1 + v2) / 2


@wrong_model("1.4", "What unit does your answer have?")
def momentum_itself(m1, v1, m2, v2):
    """The velocity is the momentum."""
    return m1 * v1 + m2 * v2


@wrong_model("1.4", "Which mass belongs to which velocity?")
def other_weights(m1, v1, m2, v2):
    """Each velocity is weighted with the other body's mass."""
    return (m2 * v1 + m1 * v2) / (m1 + m2)
'''

RIGHT = '''

@alternative("1.4")
def by_the_difference(m1, v1, m2, v2):
    """The first velocity, corrected."""
    return v1 + m2 / (m1 + m2) * (v2 - v1)
'''

SOLUTION = '''
# %% [markdown]
# ## Task 1.4 The common velocity (3 points)


# %% tags=["task"]
def common_velocity_1d(m1, v1, m2, v2):
    """Return the velocity of the centre of mass, m/s."""
    return (m1 * v1 + m2 * v2) / (m1 + m2)


# %% tags=["check", "nbval-check-output"]
check_task("1.4", common_velocity_1d)
'''


def with_a_task(tasks: str) -> str:
    """Return tasks with one more, written like the last one."""
    head, last = tasks.rstrip().removesuffix(")").rsplit("    Task(\n", 1)
    new = last.replace('"1.3"', '"1.4"').replace("elastic_impulse_1d", "common_velocity_1d")
    new = new.replace("expected=_impulse", "expected=_common_velocity")
    expected = (
        "def _common_velocity(m1: float, v1: float, m2: float, v2: float) -> float:\n"
        '    """Return the velocity after an inelastic collision."""\n'
        "    return float(inelastic_1d(m1, v1, m2, v2)[0])\n\n\n"
    )
    head = head.replace("TASKS = (", f"{expected}TASKS = (")
    return f"{head}    Task(\n{last}    Task(\n{new})\n"


def followed_by(text: str) -> Callable[[str], str]:
    """Return what puts something at the end of a file."""
    return lambda file: file + text


def test_task_is_four_files(copy: Copy) -> None:
    """It is found, its solution has full marks, and its wrong models are recognised."""
    files = files_of("Add a task")
    assert len(files) <= 4
    edits = (with_a_task, followed_by(WRONG), followed_by(RIGHT), followed_by(SOLUTION))
    for file, edit in zip(files, edits, strict=True):
        topic = file.replace("chNN_TOPIC", "ch01_one_dimension").replace(
            "NN_TOPIC", "01_one_dimension"
        )
        copy.change(topic, edit)
    copy.workbook("regenerate", "01")
    assert "0 of 4 tasks, 0 of 13 points" in copy.workbook("watch", "01", "--list")
    assert copy.faults("01") == "[]"


# A chapter: chapter 01 once more, as chapter 12

ROW = (
    "| [12 Carts](notebooks/12_carts.ipynb) | [exercise](exercises/12_carts.ipynb) "
    "| compute any collision on a line |\n"
)
NOTEBOOK = """# %% [markdown]
# # 12 Carts
#
# **After this notebook you will be able to**
#
# 1. push a cart; 2. stop it; 3. say why.

# %%
from lesson_code.course.quiz.notebook import show_quiz

show_quiz("12")
"""
TESTS = '''"""The tasks of chapter 12."""

from lesson_code.course.grading.exercises import task_by_id


def test_equal_masses_exchange_their_velocities() -> None:
    """Worked by hand."""
    assert tuple(task_by_id("12.1").expected(1, 2, 1, 0)) == (0, 2)
'''


def renumbered(text: str) -> str:
    """Return a file of chapter 01 as one of chapter 12."""
    text = text.replace("ch01_one_dimension", "ch12_carts").replace("One dimension", "Carts")
    return re.sub(r'"1\.(\d)"', r'"12.\1"', text).replace('"01-', '"12-')


def like_chapter_01(file: str) -> Callable[[str], str]:
    """Return what writes a file of the new chapter after that of chapter 01."""
    model = of_chapter("01_one_dimension", file)
    return lambda _: renumbered((ROOT / model).read_text(encoding="utf-8"))


def test_chapter_is_ten_files(copy: Copy) -> None:
    """Quiz, tasks, notebook and exercise are found by being there."""
    files = files_of("Add a chapter")
    assert len(files) <= 10
    edits = {
        "notebooks/source/NN_TOPIC.py": lambda _: NOTEBOOK,
        "tests/chapters/chNN_TOPIC/test_tasks.py": lambda _: TESTS,
    }
    for file in files:
        copy.change(of_chapter("12_carts", file), edits.get(file) or like_chapter_01(file))
    made = copy.workbook("regenerate", "12").splitlines()
    folders = ("notebooks", "solutions", "exercises")
    assert made == [*(f"{where}/12_carts.ipynb" for where in folders), "README.md"]
    assert ROW in (copy.folder / "README.md").read_text(encoding="utf-8")
    assert "12_carts.ipynb: 0 of 3 tasks" in copy.workbook("watch", "12", "--list")
    assert copy.faults("12_carts") == "[]"
    count = "from lesson_code.course.quiz import load_quiz; print(len(load_quiz('12').questions))"
    assert int(copy.run("-c", count)) >= 4
    tests = ("tests/chapters/ch12_carts", "tests/chapters/test_questions.py")
    assert "failed" not in copy.run("-m", "pytest", "-q", *tests, "-k", "12 or exchange or worked")


# A program

TITLE = '"""A marble.\n\nA marble that rolls along a line.\n"""\n'
GAME = '''"""A marble that rolls."""

from __future__ import annotations

import numpy as np

from lesson_code.engine.live_world import TIME_STEP
from lesson_code.view.pygame.game import Game
from lesson_code.view.pygame.picture import Camera, Picture
from lesson_code.view.pygame.program import ImpactEffects, Program, Readings
from lesson_code.view.pygame.window import ORANGE


class Marble(Game):
    """Where it is."""

    def reset(self) -> None:
        """Put it back."""
        self.place = 0.0

    def step(self) -> None:
        """Let it roll."""
        self.place += TIME_STEP

    def snapshot(self) -> np.ndarray:
        """Return where it is."""
        return np.array([self.place])


def draw(game: Marble, picture: Picture, effects: ImpactEffects) -> None:
    """Draw it."""
    picture.disc((game.place, 0.0), 0.2, ORANGE)


def readings(game: Marble) -> Readings:
    """Return where it is."""
    return [("place", f"{game.place:.2f} m")]


PROGRAM = Program(
    name="marble", title="A marble", game=Marble, draw=draw, readings=readings,
    keys=(("R", "reset"),), camera=Camera(left=-4.0, bottom=-2.0, scale=100.0),
)
'''


def test_program_is_two_files(copy: Copy) -> None:
    """It is listed, and it plays."""
    files = files_of("Add a program")
    assert len(files) == 2
    for file, text in zip(files, (TITLE, GAME), strict=True):
        copy.change(file.replace("NAME", "marble"), lambda _, text=text: text)
    assert "A marble that rolls along a line." in copy.workbook("play", "--help")
    played = copy.workbook("play", "marble", "--headless", "--frames", "5")
    assert played.startswith("Frames: 5")


# A solver

SOLVER = '''"""Sequential impulses that remember nothing."""

from lesson_code.engine.core.solver import Solver
from lesson_code.engine.solvers.naive import store, warm_start
from lesson_code.engine.solvers.sequential import SOLVER as USUAL

SOLVER = Solver(
    name="forgetful",
    stages=USUAL.stages._replace(warm_start=warm_start, store=store),
    lacks={"warm_starting": "the forgetful solver remembers nothing"},
)
'''
SOLVER_TESTS = '''"""The forgetful solver."""

from lesson_code import Body, Circle, Scene, simulate


def test_forgetful_solver_runs_a_scene() -> None:
    """It is asked for by name, and runs."""
    discs = [Body(Circle(0.5), position=(x, 0), velocity=(-x, 0), mass=1.0) for x in (-1, 1)]
    run = simulate(Scene(discs), 2.0, solver="forgetful")
    assert run.plan.solver == "forgetful"
'''


def test_solver_is_two_files(copy: Copy) -> None:
    """`simulate` finds it, and its plan names it."""
    files = files_of("Add a solver")
    assert len(files) == 2
    made = [file.replace("NAME", "forgetful") for file in files]
    for file, text in zip(made, (SOLVER, SOLVER_TESTS), strict=True):
        copy.change(file, lambda _, text=text: text)
    assert "1 passed" in copy.run("-m", "pytest", "-q", made[1])


# An effect

EFFECT = '''"""Standstill: what damping has made slower than can be seen stops."""

from __future__ import annotations

from lesson_code.engine.core.rows import World
from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.flags import Effects
from lesson_code.engine.effects.question import Effect, Finding

SLOWEST = 1e-3
"""m/s."""


def rule(facts: Facts) -> Finding:
    """Ask whether motion dies away."""
    if facts.damping > 0.0:
        return Finding(True, "motion dies away")
    return Finding(False, "the rate is 0")


EFFECT = Effect(rule=rule, place=115, functions=("stop",), needs_collisions=False)


def stop(world: World, effects: Effects) -> None:
    """Stop all bodies that are that slow."""
    for body in world.bodies:
        if body.vx * body.vx + body.vy * body.vy < SLOWEST * SLOWEST:
            body.vx = 0.0
            body.vy = 0.0
'''
CHOSEN = "standstill or stops or plan or rule or nothing"
STAGE_AFTER = "        accelerate(world, effects)\n"
STAGE = "    if effects.standstill:\n        stop(world, effects)\n"
STAGE_IMPORT = "from lesson_code.engine.effects.standstill import stop\n"
EFFECT_PAIR = (
    '        pair("standstill", Scene(calm.bodies, damping=RATE), calm, "damped | not damped"),\n'
)
EFFECT_TESTS = '''"""Standstill."""

import pytest

from lesson_code import Body, Circle, Scene, simulate


@pytest.mark.parametrize("compiled", [False, True])
def test_damped_disc_stops(compiled: bool) -> None:
    """exp(-10 x 1) m/s is less than a thousandth; exp(-10 x 0.5) is not."""
    disc = Body(Circle(1), mass=1, velocity=(1, 0))
    run = simulate(Scene([disc], damping=10.0), 1.0, solver="sequential", compiled=compiled)
    assert run.velocities[30, 0, 0] > 0.0
    assert run.velocities[-1, 0, 0] == 0.0
    assert "standstill" in run.plan.used
'''


def with_the_stage(step: str) -> str:
    """Return the order of the stages with the new one, in a step and in a sub-step."""
    first, *others = step.split("\n\n\ndef ", 1)
    step = "\n\n\ndef ".join([f"{first}\n{STAGE_IMPORT.rstrip()}", *others])
    return step.replace(STAGE_AFTER, STAGE_AFTER + STAGE)


def with_the_draw(bits: str) -> str:
    """Return the comparison of bits with scenes that do not call for the effect."""
    like = '    "damping": lambda seed: Spared(crowd(seed, damping=False)),\n'
    return bits.replace(like, like + like.replace('"damping"', '"standstill"'))


def test_effect_is_at_most_five_files(copy: Copy) -> None:
    """It is planned, run plain and compiled, measured, and changes nothing where it is spared."""
    files = files_of("Add an effect")
    assert len(files) <= 5
    for name in ("engine", "evidence"):
        shutil.copytree(ROOT / "tests" / name, copy.folder / "tests" / name, ignore=NOT_COPIED)
    for name in ("conftest.py", "tiers.py", "contacts.py"):
        shutil.copy(ROOT / "tests" / name, copy.folder / "tests" / name)
    damping = '        pair("damping",'
    edits: list[Callable[[str], str]] = [
        lambda _: EFFECT,
        with_the_stage,
        lambda text: text.replace(damping, EFFECT_PAIR + damping),
        lambda _: EFFECT_TESTS,
        with_the_draw,
    ]
    made = [file.replace("NAME", "standstill") for file in files]
    for file, edit in zip(made, edits, strict=True):
        copy.change(file, edit)
    tests = [*made[3:], "tests/engine/core/test_plan.py", "tests/engine/effects/test_rules.py"]
    assert "failed" not in copy.run("-m", "pytest", "-q", "--full", *tests, "-k", CHOSEN)
    costs = ("measure", "effects", "--quick", "--only", "standstill")
    assert "standstill" in copy.workbook(*costs)
