"""A whole class graded: each submission matched to its student, graded in parallel, and none lost.

roster, collect -> grade each file (journal) -> gradebook (changes) -> CSV, JSON, pages, imports
"""

from lesson_code.course.class_run.gradebook import Gradebook
from lesson_code.course.class_run.run import Hands, grade_class
from lesson_code.course.class_run.sheets import SheetError

__all__ = ["Gradebook", "Hands", "SheetError", "grade_class"]
