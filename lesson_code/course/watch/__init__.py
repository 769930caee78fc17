"""``workbook watch``: exercises checked each time they are saved.

files (what changed) -> check -> progress (kept) -> screen (rich, or plain lines)
"""

from lesson_code.course.watch.screen import Screen
from lesson_code.course.watch.session import WatchSession, listen

__all__ = ["Screen", "WatchSession", "listen"]
