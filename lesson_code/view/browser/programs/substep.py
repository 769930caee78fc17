"""The stepped engine in sub-steps with soft contacts: the solver "substep"."""

from __future__ import annotations

from lesson_code.engine.solvers.substep import SOLVER
from lesson_code.view.browser.stepping import stepped_program

PROGRAM = stepped_program(SOLVER)
