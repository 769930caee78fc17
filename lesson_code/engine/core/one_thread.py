"""One thread for linear algebra.

The systems of an island are small. Split among threads each takes five times as long, and on a busy
machine twenty times, while one thread waits for another; and the last bits of the answer depend on
how many threads there are.
"""

from __future__ import annotations

from contextlib import AbstractContextManager
from functools import cache
from typing import Any


def one_thread() -> AbstractContextManager[Any]:
    """Return a context in which NumPy's linear algebra takes one thread; then as many as before."""
    limit: AbstractContextManager[Any] = _libraries().limit(limits=1, user_api="blas")
    return limit


@cache
def _libraries() -> Any:
    """Return the libraries of linear algebra that are loaded; to find them takes 10 ms."""
    from threadpoolctl import ThreadpoolController

    return ThreadpoolController()
