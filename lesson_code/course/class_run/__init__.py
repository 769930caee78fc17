"""A whole class graded: each submission matched to its student, graded in parallel, and none lost.

collect -> grade each file (journal) -> gradebook -> CSV, JSON, Gradescope, pages
"""

from lesson_code.course.class_run.gradebook import Gradebook
from lesson_code.course.class_run.roster import RosterError
from lesson_code.course.class_run.run import Hands, grade_class

__all__ = ["Gradebook", "Hands", "RosterError", "grade_class"]
