"""A user for the child to become when the grader runs as root: one that no other process has."""

from __future__ import annotations

import os
import socket
from pathlib import Path

FIRST_USER, USERS = 65_000, 500
"""Debian keeps 65000 to 65533 free, and containers that map users at all map as many."""

NOBODY = 65_534
"""The user that owns nothing, on every system."""


class UnprivilegedUser:
    """A user id that no other grader uses for as long as this object is open.

    It is claimed by an abstract socket of that name, which the system gives to one alone and takes
    back when its owner ends, however that may be.
    """

    def __init__(self) -> None:
        self._claim = socket.socket(socket.AF_UNIX)
        start = os.getpid() % USERS
        order = [*range(start, USERS), *range(start)]
        free = (FIRST_USER + n for n in order if self._claims(FIRST_USER + n))
        self.id = next(free, NOBODY)  # with 500 graders at work, the last ones share a user

    def _claims(self, user: int) -> bool:
        """Return whether a user is free, and ours from now on."""
        if not is_mapped(user):
            return False
        try:
            self._claim.bind(f"\0collision-workbook-user-{user}")
        except OSError:
            return False
        return True

    def close(self) -> None:
        """Give the user back."""
        self._claim.close()


def is_mapped(user: int) -> bool:
    """Return whether a user exists in the namespace this process is in."""
    rows = (row.split() for row in Path("/proc/self/uid_map").read_text().splitlines())
    return any(int(first) <= user < int(first) + int(count) for first, _, count in rows)
