"""The code of the collision workbook: what its notebooks explain, its checks and its programs run.

The folders are the wings of the house. Data flows one way, and each wing imports only from
the wings above it in this list (a test holds it to that):

parallel
    independent tasks over several cores, or a cluster
formulas
    the lesson's equations: pure functions of numbers
geometry
    shapes, and where they touch
engine
    a scene, advanced step by step
reference
    answers that are not ours: closed forms, and pymunk
simulation
    ``simulate()``: one door to every solver
evidence
    claims compared with what was measured
view
    figures, interactive figures and the pygame window
programs
    the pygame programs
quiz
    one bank of questions, one checker
notebook_tools
    notebooks made from their sources, student copies, runs under nbval
grading
    the exercises' tasks, wrong models, isolation of student code, reports
cli
    the ``workbook`` command
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from lesson_code.engine.callbacks import Callbacks
    from lesson_code.engine.combination import Combination
    from lesson_code.engine.run import Run
    from lesson_code.engine.scene import Body, Material, Scene
    from lesson_code.evidence.ensembles import simulate_many
    from lesson_code.geometry.shapes import Circle, Polygon, Segment
    from lesson_code.simulation import simulate

__all__ = [
    "Body",
    "Callbacks",
    "Circle",
    "Combination",
    "Material",
    "Polygon",
    "Run",
    "Scene",
    "Segment",
    "simulate",
    "simulate_many",
]

__version__ = "0.1.0"

_WHERE = {
    "Body": "engine.scene",
    "Callbacks": "engine.callbacks",
    "Circle": "geometry.shapes",
    "Combination": "engine.combination",
    "Material": "engine.scene",
    "Polygon": "geometry.shapes",
    "Run": "engine.run",
    "Scene": "engine.scene",
    "Segment": "geometry.shapes",
    "simulate": "simulation",
    "simulate_many": "evidence.ensembles",
}


def __getattr__(name: str) -> object:
    """Load a public name when it is asked for: `workbook --help` must not wait for NumPy."""
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_WHERE[name]}"), name)
