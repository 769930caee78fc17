"""Independent tasks over the cores of this machine, or over a dask cluster.

:func:`map_tasks` is for whoever wants all results, :func:`iter_tasks` for whoever wants each as it
comes and wants to know of each task what became of it. A task's result depends on nothing but
the function and the task, so it is the same whoever does it.
"""

from lesson_code.parallel.outcome import Outcome, TasksFailedError, WorkerDiedError
from lesson_code.parallel.tasks import iter_tasks, map_tasks, usable_cores

__all__ = [
    "Outcome",
    "TasksFailedError",
    "WorkerDiedError",
    "iter_tasks",
    "map_tasks",
    "usable_cores",
]
