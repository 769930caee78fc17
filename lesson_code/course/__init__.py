"""Any course's machinery: it finds the chapters, grades, asks the quiz and makes the pages.

Nothing here knows any physics; what a course is about stands in its chapters.
"""
