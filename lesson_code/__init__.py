"""The code of the collision workbook: what its notebooks explain, its checks and its programs run.

The folders are the wings of the house. Data flows one way, and each wing imports only from
the wings above it in this list (a test holds it to that):

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

from lesson_code.engine.callbacks import Callbacks
from lesson_code.engine.combination import Combination
from lesson_code.engine.run import Run
from lesson_code.engine.scene import Body, Material, Scene
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
]

__version__ = "0.1.0"
