"""What stands between student code and this machine.

Student code runs in a child that answers calls with plain values. The parent judges: what is
expected never crosses to the child. A warm server (``inside.server``) forks a child for each
submission behind the best wall that the system allows (``rungs``), and the report says which.
"""

from lesson_code.course.isolation.in_force import InForce, IsolationError
from lesson_code.course.isolation.limits import Limits
from lesson_code.course.isolation.rungs import RUNGS, Children, Rung, isolated, opened
from lesson_code.course.isolation.student import StudentProcess

__all__ = [
    "RUNGS",
    "Children",
    "InForce",
    "IsolationError",
    "Limits",
    "Rung",
    "StudentProcess",
    "isolated",
    "opened",
]
