"""What runs on the student's side of the wall: it knows no task, no key and no expected value.

The package imports nothing of lesson_code, so that a child's memory holds none of its code.
"""
