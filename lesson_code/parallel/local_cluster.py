"""A dask cluster on this machine, run as a program: ``python -m`` this module, WORKERS, DEATHS.

It writes its address in a line, and ends when its input does. It is a program of its own because
dask starts a new worker whenever one has died, and each new worker imports the script that is
running. Here that is these lines, and not a user's.
"""

from __future__ import annotations

import logging
import sys
from contextlib import suppress
from importlib import import_module
from typing import Any

ON_THIS_MACHINE = "127.0.0.1"
"""Nobody else can give such a cluster work."""


def main(workers: int, deaths: int) -> None:
    """Run so many workers, one for each core where it is 0, until standard input ends.

    A task that has cost `deaths` workers has failed.
    """
    dask: Any = import_module("distributed")
    import_module("dask.config").set({"distributed.scheduler.allowed-failures": deaths - 1})
    cluster = dask.LocalCluster(
        n_workers=workers or None,
        threads_per_worker=1,
        host=ON_THIS_MACHINE,
        dashboard_address=None,
        silence_logs=logging.CRITICAL,
    )
    print(cluster.scheduler_address, flush=True)  # noqa: T201 - what the caller waits for
    sys.stdin.read()
    with suppress(Exception):  # a worker that is just being started cannot be closed: it is killed
        cluster.close()


if __name__ == "__main__":
    with suppress(KeyboardInterrupt):
        main(int(sys.argv[1]), int(sys.argv[2]))
