"""One submission in a Python of its own, for systems that cannot fork a warm one.

Its requests come on standard input, its answers go to standard output.
"""

from __future__ import annotations

import os
import sys

from . import answers, limits
from .imports import forget_the_way_here


def main() -> None:
    """Keep the pipes to the parent for ourselves, lower the limits, and serve."""
    requests, replies = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    nothing = os.open(os.devnull, os.O_RDWR)
    for descriptor in (0, 1, 2):
        os.dup2(nothing, descriptor)
    cpu_seconds, bytes_of_memory, *readable, _ = sys.argv[2:]
    forget_the_way_here(tuple(readable))
    limits.lower(int(cpu_seconds), int(bytes_of_memory))
    answers.serve(requests, replies)
