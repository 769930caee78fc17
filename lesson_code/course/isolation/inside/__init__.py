"""What runs on the student's side of the wall: it knows no task, no key and no expected value.

The package imports nothing of lesson_code, so that nothing of it is in a child's memory.
"""
