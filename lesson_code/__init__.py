"""The code of the collision workbook: what its notebooks explain, its checks and its programs run.

The folders are the wings of the house. Data flows one way, and each wing imports only from the
wings above it in this list (a test holds it to that):

parallel
    independent tasks over several cores, or a cluster
formulas
    the lesson's equations: pure functions of numbers
geometry
    shapes, and where and when they touch
engine
    a scene, advanced step by step or from collision to collision
reference
    answers that are not ours: closed forms, pymunk and Box2D
simulation
    ``simulate()``: one door to every solver
scene_file
    a scene as a file, the same for the simulator, the lab of the pages and Python
evidence
    claims compared with what was measured
view
    what figures, films, pages and windows are drawn with
course
    any course's machinery: grading, isolation, quiz, notebooks as files, pages; it knows no physics
chapters
    a folder for each chapter and program, which knows both the physics and the course
cli
    the ``workbook`` command
"""

import os
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from lesson_code.engine.core.callbacks import Callbacks
    from lesson_code.engine.core.mixing import MixingRule
    from lesson_code.engine.core.run import Run
    from lesson_code.engine.core.scene import Body, Material, Scene
    from lesson_code.evidence.ensembles import simulate_many
    from lesson_code.geometry.shapes import Circle, Polygon, Segment
    from lesson_code.scene_file import read_scene
    from lesson_code.simulation import simulate

__all__ = [
    "Body",
    "Callbacks",
    "Circle",
    "Material",
    "MixingRule",
    "Polygon",
    "Run",
    "Scene",
    "Segment",
    "read_scene",
    "simulate",
    "simulate_many",
]

__version__ = "0.1.0"

os.environ.setdefault("OPENBLAS_THREAD_TIMEOUT", "4")
# NumPy's threads for linear algebra sleep when they have nothing to do. Unless they are told before
# NumPy is imported, each spins for 2^26 cycles first: .05 s of the processor at every start.

_WHERE = {
    "Body": "engine.core.scene",
    "Callbacks": "engine.core.callbacks",
    "Circle": "geometry.shapes",
    "MixingRule": "engine.core.mixing",
    "Material": "engine.core.scene",
    "Polygon": "geometry.shapes",
    "Run": "engine.core.run",
    "Scene": "engine.core.scene",
    "Segment": "geometry.shapes",
    "read_scene": "scene_file",
    "simulate": "simulation",
    "simulate_many": "evidence.ensembles",
}


def __getattr__(name: str) -> object:
    """Load a public name when it is asked for: `workbook --help` must not wait for NumPy."""
    if name not in _WHERE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_WHERE[name]}"), name)
