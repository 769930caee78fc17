"""Plausible wrong formulas, one file a chapter.

They exist once: notebooks show them failing, the grader recognises them, and the tests use them
to prove that the checks can tell wrong from right. A docstring is the misconception.
"""
