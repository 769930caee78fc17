"""The warm server: Python and NumPy loaded once, a child forked for each submission.

It holds no task, no key and no expected value, and imports nothing of lesson_code. The parent
sends it, each in one packet: its orders; then ``{"fork": "answers"}`` with the child's end of a
socket, as often as it likes; and ``{"spent": true}``, which asks for the processor time of the
child. A child that runs is ended by any other packet, or by the parent's own end. Child and parent
talk over that socket alone.
"""

from __future__ import annotations

import contextlib
import gc
import importlib
import json
import os
import signal
import socket
import sys
from typing import Any

from . import answers, probe, system
from .imports import forget_the_way_here
from .wall import KINDS, Orders, Wall

LONGEST_PACKET = 60_000

SECONDS_BETWEEN_LOOKS = 0.05
"""How often a child's folder is looked into while it runs; most are gone before the first time."""

PRELOADED = (
    "cmath", "collections", "copy", "dataclasses", "decimal", "fractions", "functools",
    "itertools", "math", "numpy", "operator", "typing",
)  # fmt: skip
"""What answers import, loaded before the wall is closed, so that no child spends time on it.

Not random, nor statistics, which imports it: it is seeded anew after each fork, in 0.1 ms.
"""


class Server:
    """Forks a child at a time behind a wall, and ends it."""

    def __init__(self, control: socket.socket, wall: Wall) -> None:
        self._control = control
        self._wall = wall
        self._child: int | None = None

    def serve(self) -> None:
        """Do as the parent says, for as long as there is one."""
        while True:
            self._control.settimeout(None if self._child is None else SECONDS_BETWEEN_LOOKS)
            try:
                packet, descriptors, *_ = socket.recv_fds(self._control, LONGEST_PACKET, 1)
            except TimeoutError:
                if self._wall.is_overfull():
                    self._end_child()  # of which the parent learns by its silence
                continue
            request = json.loads(packet) if packet else {}
            if "spent" in request:
                self._control.send(json.dumps({"spent": self._spent()}).encode())
                continue
            self._end_child()
            if not packet:
                return
            if "fork" in request:
                self._start_child(request, descriptors[0])

    def _start_child(self, request: dict[str, Any], descriptor: int) -> None:
        """Fork a child that answers over a socket."""
        self._wall.before_fork()
        self._child = os.fork()
        if self._child == 0:
            self._become_child(request, descriptor)
        os.close(descriptor)

    def _become_child(self, request: dict[str, Any], descriptor: int) -> None:
        """Close the wall and answer; never return into the server's own code."""
        try:
            self._wall.close()
            os.dup2(descriptor, 3)
            system.close_from(4)
            _open_nothing()
            with open(3, "rb") as requests, open(3, "wb", closefd=False) as replies:
                if request["fork"] == "probe":
                    reply = {"possible": probe.attempts(request["target"])}
                    replies.write(json.dumps(reply).encode() + b"\n")
                else:
                    replies.write(b'{"wall": "closed"}\n')
                    replies.flush()
                    answers.serve(requests, replies)
        finally:
            os._exit(0)

    def _spent(self) -> float | None:
        """Return the processor time of the child, which it cannot change or hide."""
        return None if self._child is None else system.processor_time(self._child)

    def _end_child(self) -> None:
        """End the child, if there is one, and all that it has started."""
        if self._child is None:
            return
        for kill in (os.killpg, os.kill):
            with contextlib.suppress(OSError):
                kill(self._child, signal.SIGKILL)
        os.waitpid(self._child, 0)
        self._child = None
        self._wall.after_end()


def _open_nothing() -> None:
    """Open input and outputs anew: the flags of what all children share would outlive one."""
    nothing = os.open(os.devnull, os.O_RDWR)
    for descriptor in (0, 1, 2):
        os.dup2(nothing, descriptor)
    os.close(nothing)


def main() -> None:
    """Put up the wall that the parent orders, tell how that went, and serve."""
    control = socket.socket(fileno=int(sys.argv[2]))
    orders = Orders.from_dict(json.loads(control.recv(LONGEST_PACKET)))
    for name in PRELOADED:
        importlib.import_module(name)
    forget_the_way_here(orders.readable)
    answers.rehearse()
    gc.collect()
    gc.freeze()  # a child that cleans up need not copy what it shares with the server
    os.dup2(0, 2)  # nothing reads what a child may print
    try:
        wall = KINDS[orders.kind](orders)
        wall.build()
    except OSError as error:
        control.send(json.dumps({"error": str(error)}).encode())
        return
    control.send(b'{"ready": true}')
    Server(control, wall).serve()
    with contextlib.suppress(OSError):  # the parent may be gone, and cannot do it then
        os.rmdir(orders.folder)  # noqa: PTH106
