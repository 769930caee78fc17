"""One folder a chapter and a program: its tasks, right and wrong answers, figures, scenes and quiz.

Only what stands here knows both the physics and the course. A chapter is found by being here
(:mod:`lesson_code.course.chapters`); the first sentence of its docstring is its title.
"""
