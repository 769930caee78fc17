"""The class run on a dask cluster, of which a worker dies."""

from __future__ import annotations

import importlib.util
import os
import signal
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from lesson_code.course.class_run import Hands, grade_class
from lesson_code.course.class_run.journal import Journal
from lesson_code.parallel import executors

from .conftest import RIGHT, SWAPS, MakeClass, contents_of

pytestmark = [
    pytest.mark.skipif(
        importlib.util.find_spec("distributed") is None,
        reason="needs dask: pip install -e '.[cluster]'",
    ),
    pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such signals"),
]

STUDENTS = {f"s{n:02d}.py": (RIGHT, SWAPS)[n % 2] for n in range(40)}


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    """Return the address of a cluster of two workers on this machine."""
    with executors.local_cluster(2) as cluster:
        yield cluster.scheduler_address


def workers_of(address: str) -> list[int]:
    """Return the processes of a cluster's workers."""
    import distributed

    with distributed.Client(address, set_as_default=False) as client:
        return list(client.run(os.getpid).values())


def test_class_on_a_cluster_loses_no_mark_with_a_worker_killed_half_way(
    make_class: MakeClass, tmp_path: Path, address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever did the work, and whoever died: the same bytes as by one process here."""
    folder = make_class(STUDENTS)
    victim = workers_of(address)[0]
    written: list[Any] = []
    write = Journal.write

    def killing_half_way(journal: Journal, paper: Any, marks: Any) -> None:
        written.append(paper.name)
        if len(written) == len(STUDENTS) // 2:
            os.kill(victim, signal.SIGKILL)
        write(journal, paper, marks)

    with monkeypatch.context() as patch:
        patch.setattr(Journal, "write", killing_half_way)
        book = grade_class(folder, tmp_path / "there", seed=7, hands=Hands(cluster=address))
    assert sorted(written) == sorted(STUDENTS)
    assert [student.points for student in book.students] == [10, 1] * 20
    assert victim not in workers_of(address)
    grade_class(folder, tmp_path / "here", seed=7, hands=Hands(1))
    assert contents_of(tmp_path / "there") == contents_of(tmp_path / "here")


def test_workers_of_a_cluster_need_no_shared_folder(
    make_class: MakeClass, tmp_path: Path, address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What stands in a file travels with the task: a path that only this machine has will do."""
    folder = make_class({"01_one_dimension.py": RIGHT, "zip.zip": "PK", "empty.py": ""})
    monkeypatch.chdir(tmp_path)
    book = grade_class(Path(folder.name), Path("out"), seed=7, hands=Hands(cluster=address))
    assert {student.id: student.points for student in book.students} == {
        "01_one_dimension": 10, "empty": 0, "zip": 0,
    }  # fmt: skip
    assert book.students[2].problems == (
        "zip.zip: a submission ends in .ipynb or .py; unpack it first",
    )
