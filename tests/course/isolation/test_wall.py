"""The wall on each rung: what a child has, what it has not, and what is left of it afterwards."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest

from lesson_code.course.isolation import (
    Children,
    IsolationError,
    Limits,
    Rung,
    StudentProcess,
    isolated,
    opened,
    paths,
    warm_server,
)
from lesson_code.course.isolation.fresh_process import FreshProcess
from lesson_code.course.isolation.inside import disk, landlock, seccomp
from lesson_code.course.isolation.rungs import RUNGS
from lesson_code.course.isolation.warm_server import WarmServer

from .conftest import BY_NAME, open_or_skip, units

LINUX = pytest.mark.skipif(sys.platform != "linux", reason="walls are built on Linux alone")
FULL = ("namespaces", "bubblewrap")
"""The rungs that are made to keep everything away."""

ENVIRONMENT = {
    "HOME",
    "LC_CTYPE",
    "OPENBLAS_NUM_THREADS",
    "PWD",
    "PYGAME_HIDE_SUPPORT_PROMPT",
    "SDL_AUDIODRIVER",
    "SDL_VIDEODRIVER",
    "TMPDIR",
}


@pytest.fixture
def temporary(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the folder in which temporary folders are made, empty and open to other users."""
    for folder in (tmp_path, *list(tmp_path.parents)[:3]):  # under pytest-xdist one more
        with contextlib.suppress(PermissionError):
            folder.chmod(0o755)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    return tmp_path


def test_rung_is_worth_what_a_child_could_not_do(rung: Rung) -> None:
    """Where files, network or processes are within reach, the level is not "full"."""
    try:
        children, in_force = opened(rung, Limits())
    except IsolationError as error:
        pytest.skip(str(error))
    children.close()
    assert in_force.level == ("full" if rung.name in FULL else "limits")
    assert str(in_force).startswith(f"{in_force.level} (")
    assert in_force.as_dict()["rung"] == rung.name


def test_isolation_full_is_refused_where_a_rung_lets_something_through(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Without the full rungs, "full" is an error that names each reason; less is not."""
    low = tuple(rung for rung in RUNGS if rung.name not in FULL)
    monkeypatch.setattr("lesson_code.course.isolation.rungs.RUNGS", low)
    with (
        pytest.raises(IsolationError, match=r"isolation full is not to be had here \(limits: .*;"),
        isolated(Limits(), "full"),
    ):
        pass
    if os.name == "posix" and os.geteuid() == 0 and not paths.is_readable_by_others():
        pytest.skip("root cannot give this Python to another user")
    with isolated(Limits(), "none") as (_, in_force):
        assert in_force.level != "full"


def test_isolation_full_is_refused_if_a_canary_can_be_read(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a child can do counts, and not what a rung is called."""
    deeds = {"be root": False, "network": False, "read files": True}
    monkeypatch.setattr(WarmServer, "possible", lambda *_: deeds)
    with pytest.raises(IsolationError, match="gives limits"), isolated(Limits(), "full"):
        pass


def test_no_rung_gives_a_submission_the_rights_of_root(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where a child would be root, not even "none" is to be had: nothing is run."""
    monkeypatch.setattr(WarmServer, "possible", lambda *_: {"be root": True})
    with (
        pytest.raises(IsolationError, match="a child would have root's rights"),
        isolated(Limits(), "none", "namespaces"),
    ):
        pass


def test_isolation_of_an_unknown_level_is_refused_by_name() -> None:
    """A level that does not exist is an error that lists those that do."""
    with (
        pytest.raises(ValueError, match="must be full, limits or none, got 'high'"),
        isolated(Limits(), "high"),
    ):
        pass


def test_isolation_is_full_for_an_ordinary_user_too(root: Path) -> None:
    """Nobody, who is not root and owns nothing, gets the same level as root does."""
    if os.name != "posix" or os.geteuid() != 0:
        pytest.skip("only root can become nobody; for others all tests here say it")
    if not paths.is_readable_by_others() or not os.access(sys.executable, os.X_OK):
        pytest.skip("nobody cannot run this Python: it lies where only root can read")
    program = (
        "from lesson_code.course.isolation import Limits, isolated\n"
        "with isolated(Limits()) as (_, in_force): print(in_force.level, in_force.rung)"
    )
    ran = subprocess.run(
        [sys.executable, "-c", program],
        user=65_534, group=65_534, extra_groups=[],
        env={"PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    with isolated(Limits()) as (_, in_force):
        assert ran.stdout.split() == [in_force.level, in_force.rung], ran.stderr


def test_child_has_an_empty_folder_and_environment(children: Children) -> None:
    """The child has an empty folder, no input, and none of the parent's environment or paths."""
    source = """\
import os, sys
def f():
    mine = os.getcwd() in sys.path or "" in sys.path
    lesson = [name for name in sys.modules if "lesson_code" in name]
    return os.listdir("."), os.read(0, 10).decode(), sorted(os.environ), mine, lesson, sys.argv[1:]
"""
    with StudentProcess(units(source), children) as student:
        listing, read, names, in_path, lesson, arguments = student.call("f", ()).value
    assert (listing, read, in_path, lesson) == ([], "", False, [])
    assert set(names) <= ENVIRONMENT
    assert not any("exercise" in argument for argument in arguments)


def test_child_can_import_what_answers_need(children: Children) -> None:
    """The standard library and installed packages are there, those not loaded before too."""
    source = """\
def f():
    import csv, numpy.fft, numpy.random, pygame, random, statistics
    return pygame.Vector2(3, 4 + 0 * random.random())
"""
    with StudentProcess(units(source), children) as student:
        assert student.call("f", ()).value == [3.0, 4.0]


def test_child_spends_no_time_on_what_acts_after_a_fork(children: Children) -> None:
    """Each fork would seed random, and look through the threads; answers seldom want either."""
    source = (
        "import sys\ndef f():\n    return [n for n in ('random', 'threading') if n in sys.modules]"
    )
    with StudentProcess(units(source), children) as student:
        assert student.call("f", ()).value == []


def test_child_can_use_files_and_threads_of_its_own(rung: Rung, children: Children) -> None:
    """A folder to write in and threads are allowed: a careless answer is no hostile one.

    Where the folder is on a disk, nothing can be written.
    """
    source = """\
import pathlib, tempfile, threading
def f():
    pathlib.Path("note").write_text("1")
    with tempfile.TemporaryFile() as file:
        file.write(b"1")
    done = []
    thread = threading.Thread(target=lambda: done.append(1))
    thread.start()
    thread.join()
    return done
"""
    with StudentProcess(units(source), children) as student:
        outcome = student.call("f", ())
    if rung.name in FULL:
        assert outcome.value == [1]
    else:
        assert outcome.kind == "raised"


@LINUX
def test_secrets_are_not_in_the_memory_of_a_child(children: Children) -> None:
    """Of tasks, wrong models, expected values and keys, no trace is mapped, open or loaded.

    The child searches all of its own memory for words of a hint, the names of the modules that
    hold tasks, and a value that the parent expects. They are handed over as patterns that do not
    match themselves.
    """
    secrets = ("[O]nly equal masses exchange", "[g]rading.wrong_models", "[g]rading/tasks")
    source = """\
import os, re, sys
def f(*secrets):
    patterns = [re.compile(secret.encode()) for secret in secrets]
    found, searched = set(), 0
    with open("/proc/self/maps") as maps, open("/proc/self/mem", "rb", buffering=0) as memory:
        for line in maps.readlines():
            if not re.match(r"[0-9a-f]+-[0-9a-f]+ r", line) or "[v" in line:
                continue
            begin, end = (int(n, 16) for n in line.split()[0].split("-"))
            while begin < end:
                memory.seek(begin)
                try:
                    block = memory.read(min(end - begin, 1 << 20))
                except OSError:
                    break
                searched += len(block)
                found |= {pattern.pattern.decode() for pattern in patterns if pattern.search(block)}
                begin += len(block) or (1 << 20)
    return searched > 10_000_000, sorted(found)
def g():
    folder = "/proc/self/fd"
    links = [os.path.join(folder, n) for n in os.listdir(folder)]
    return sorted(os.readlink(link).split(":")[0] for link in links if os.path.exists(link))
def h(): return [name for name in sys.modules if "lesson" in name or "grading" in name]
"""
    with StudentProcess(units(source), children) as student:
        searched, opened_files = student.call("f", secrets), student.call("g", ())
        modules = student.call("h", ()).value
    assert modules == []
    if searched.kind == "returned":
        assert searched.value == [True, []]
    else:  # it cannot even see itself
        assert "/proc/self" in searched.text
    if opened_files.kind == "returned":
        assert set(opened_files.value) <= {"/dev/null", "socket", "pipe"}
    else:
        assert "/proc/self" in opened_files.text


@LINUX
def test_server_holds_no_secret_of_the_grader(rung: Rung) -> None:
    """The memory that children are forked from has no trace of tasks either, seen from outside."""
    children = open_or_skip(rung, Limits())
    try:
        if not isinstance(children, WarmServer):
            pytest.skip("there is no server")
        with StudentProcess(units("def f(): return 1"), children) as student:
            student.call("f", ())
            texts = [_memory_of(process) for process in _processes(children)]
    finally:
        children.close()
    assert sum(map(len, texts)) > 10_000_000
    for text in texts:
        assert b"Only equal masses exchange" not in text
        assert b"lesson_code.course.grading.tasks" not in text


def _processes(children: Children) -> list[int]:
    """Return all processes that run for those children."""
    assert isinstance(children, WarmServer | FreshProcess)
    assert children._process is not None
    return [children._process.pid, *_descendants(children._process.pid)]


def _descendants(process: int) -> list[int]:
    """Return the processes that descend from one."""
    text = Path(f"/proc/{process}/task/{process}/children").read_text()
    found = [int(word) for word in text.split()]
    return found + [below for child in found for below in _descendants(child)]


def _memory_of(process: int) -> bytes:
    """Return what is in the memory of a process, as far as this user may read it."""
    text = bytearray()
    try:
        maps = Path(f"/proc/{process}/maps").read_text().splitlines()
        with Path(f"/proc/{process}/mem").open("rb", buffering=0) as memory:
            for line in (line for line in maps if " rw" in line):
                begin, end = (int(number, 16) for number in line.split()[0].split("-"))
                memory.seek(begin)
                text += memory.read(end - begin)
    except OSError:
        if os.geteuid() == 0:
            raise
        pytest.skip("the server cannot be looked into, not even by its own user")
    return bytes(text)


@pytest.mark.skipif(os.name != "posix", reason="processes are forked on POSIX systems alone")
def test_end_of_a_submission_ends_its_threads_and_processes(rung: Rung, temporary: Path) -> None:
    """Afterwards no process of the submission is left, and no folder."""
    source = """\
import os, threading, time
def f():
    threading.Thread(target=time.sleep, args=(60,)).start()
    try:
        started = os.fork()
    except OSError:
        return os.getpid(), 0
    if not started:
        time.sleep(60)
    return os.getpid(), started
"""
    children = open_or_skip(rung, Limits())
    before = set(temporary.iterdir())
    with StudentProcess(units(source), children) as student:
        seen = student.call("f", ()).value
        running = _processes(children)
        assert seen[1] == 0 or rung.name == "process"
    children.close()
    _wait_for_end_of(running)
    assert len(before) == (rung.name == "limits")
    assert list(temporary.iterdir()) == []


def _wait_for_end_of(processes: list[int]) -> None:
    """Wait until some processes have ended; a killed orphan is buried by the system's init."""
    for _ in range(100):
        if all(_state(process) in ("gone", "Z") for process in processes):
            return
        time.sleep(0.02)
    pytest.fail(f"still running: {processes}")


def _state(process: int) -> str:
    """Return the state of a process, as the system shows it."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(") ")[2].partition(" ")[0]
    except OSError:
        return "gone"


def test_daemon_that_leaves_its_group_is_ended_too(rung: Rung) -> None:
    """A process that becomes an orphan in a session of its own does not outlive the submission."""
    if rung.name == "process":
        pytest.skip("a fresh process on its own cannot see to that, and says so")
    source = """\
import os, time
def f():
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            time.sleep(60)
        os._exit(0)
    time.sleep(0.1)
"""
    children = open_or_skip(rung, Limits())
    with StudentProcess(units(source), children) as student:
        outcome = student.call("f", ())
        running = _processes(children)
        assert outcome.kind == "raised"  # seccomp lets nobody fork
    children.close()
    _wait_for_end_of(running)


def test_server_ends_with_the_parent() -> None:
    """A grader that is killed leaves no server behind."""
    children = open_or_skip(BY_NAME["namespaces"], Limits())
    running = _processes(children)
    assert isinstance(children, WarmServer)
    assert children._control is not None
    children._control.close()  # what the system does for a parent that is gone
    _wait_for_end_of(running)
    children._control = None
    children.close()


def test_server_that_dies_is_started_again() -> None:
    """A server that is killed, by a submission perhaps, costs the next submission nothing."""
    children = open_or_skip(BY_NAME["namespaces"], Limits())
    for process in _processes(children):
        with contextlib.suppress(ProcessLookupError):  # the first one took it along
            os.kill(process, signal.SIGKILL)
    with StudentProcess(units("def f(): return 1"), children) as student:
        assert student.call("f", ()).value == 1
    children.close()


def test_server_that_cannot_be_started_again_is_no_mark(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a server, a submission is not given 0 points: the run says what is wrong."""
    children = open_or_skip(BY_NAME["namespaces"], Limits())
    assert isinstance(children, WarmServer)
    monkeypatch.setattr(children, "_wrapper", ("/bin/false",))
    monkeypatch.setattr(warm_server, "SECONDS_TO_START", 1.0)
    for process in _processes(children):
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, signal.SIGKILL)
    with (
        pytest.raises(IsolationError, match="did not start"),
        StudentProcess(units("def f(): return 1"), children),
    ):
        pass
    children.close()


def test_each_child_has_a_folder_of_its_own(rung: Rung, quick: Limits, temporary: Path) -> None:
    """A submission that deletes its folder and dies is called again in a new one."""
    source = """\
import os, shutil
def f():
    shutil.rmtree(os.getcwd(), ignore_errors=True)
    os._exit(0)
def g():
    return os.listdir(os.getcwd())
"""
    children = open_or_skip(rung, quick)
    with StudentProcess(units(source), children, quick) as student:
        assert student.call("f", ()).kind == "crashed"
        assert student.call("g", ()).value == []
    children.close()
    assert list(temporary.iterdir()) == []


@LINUX
@pytest.mark.parametrize("name", ["namespaces", "bubblewrap", "limits"])
def test_folders_nested_by_the_thousand_are_removed(name: str, temporary: Path) -> None:
    """A tree too deep for any path, with a folder nobody may enter, is removed all the same."""
    source = """\
import os
def f():
    for _ in range(1500):
        os.mkdir("d")
        os.chdir("d")
    os.umask(0o777)
    os.mkdir("locked")
"""
    children = open_or_skip(BY_NAME[name], Limits())
    with StudentProcess(units(source), children) as student:
        outcome = student.call("f", ())
        assert outcome.kind != "raised" or name == "limits" or "No space" in outcome.text
    children.close()
    assert list(temporary.iterdir()) == []


@LINUX
def test_disk_is_not_filled(rung: Rung, quick: Limits) -> None:
    """Who writes more than 16 MB, or a thousand files, is refused or ended."""
    if rung.name == "process":
        pytest.skip("a fresh process on its own cannot see to that")
    source = """\
import time
def f(files, size):
    for number in range(files):
        with open(str(number), "wb") as file:
            file.write(b"x" * size)
    time.sleep(0.3)
"""
    children = open_or_skip(rung, quick)
    for files, size in ((30, 999_000), (3_000, 1)):
        with StudentProcess(units(source), children, Limits()) as student:
            outcome = student.call("f", (files, size))
            if rung.name == "limits":  # on a disk nothing can be written at all
                assert outcome.kind == "raised"
                continue
            assert outcome.kind == "crashed" or "No space left" in outcome.text
            assert student.call("f", (1, 1)).kind == "returned"
    children.close()


def test_removal_follows_no_link(tmp_path: Path) -> None:
    """What a link in a folder leads to stays, be it a file or a folder."""
    kept = tmp_path / "kept"
    kept.mkdir()
    (kept / "file").write_text("1")
    folder = tmp_path / "folder"
    (folder / "deep" / "deeper").mkdir(parents=True)
    (folder / "link").symlink_to(kept)
    (folder / "deep" / "deeper" / "link").symlink_to(kept / "file")
    disk.remove(str(folder))
    assert not folder.exists()
    assert (kept / "file").read_text() == "1"


@pytest.mark.parametrize("machine", sorted(seccomp.ARCHITECTURES))
def test_seccomp_program_allows_reading_and_no_network(machine: str) -> None:
    """The filter, run here by hand, lets computing pass and refuses the rest with its reason."""
    allowed = seccomp.numbers(seccomp.ALLOWED, machine)
    refused = seccomp.numbers(seccomp.REFUSED, machine)
    clone, (kill, kill_thread) = seccomp.CLONE[machine], seccomp.SIGNALS[machine]
    run = _Filter(seccomp.program(machine, process=7), seccomp.ARCHITECTURES[machine])
    assert run(allowed["read"]) == seccomp.ALLOW
    assert run(allowed["exit_group"]) == seccomp.ALLOW
    for name in ("socket", "execve", "flock"):
        assert run(refused[name]) == seccomp.REFUSE | 1
    asks = {clone, kill, kill_thread, seccomp.PRLIMIT[machine]}
    asks |= {seccomp.FCNTL[machine], seccomp.IOCTL[machine]}
    for number in {*range(1_000), 100_000, 0x4000_0000, 0xFFFF_FFFF} - asks:
        is_refused = seccomp.REFUSE | (1 if number in refused.values() else 38)
        assert run(number) == (seccomp.ALLOW if number in allowed.values() else is_refused)
    assert run(clone, seccomp.CLONE_THREAD | 0x100) == seccomp.ALLOW
    assert run(clone, 17) == seccomp.REFUSE | 1
    assert run(kill, 7) == seccomp.ALLOW
    assert run(kill, 8) == seccomp.REFUSE | 1
    for table, these, others in (
        (seccomp.FCNTL, seccomp.FCNTL_ALLOWED, {"F_SETLK": 6, "F_SETOWN": 8, "F_SETSIG": 10}),
        (seccomp.IOCTL, seccomp.IOCTL_ALLOWED, {"TIOCSTI": 0x5412, "SIOCGIFCONF": 0x8912}),
    ):
        assert {run(table[machine], 3, what) for what in these.values()} == {seccomp.ALLOW}
        assert {run(table[machine], 3, what) for what in others.values()} == {seccomp.REFUSE | 1}
        assert run(table[machine], 0, 0x8912) == seccomp.REFUSE | 1
    assert run(allowed["read"], architecture=1) == seccomp.KILL
    assert set(allowed).isdisjoint(refused)


class _Filter:
    """Runs a filter as the kernel does."""

    def __init__(self, lines: list[seccomp.Instruction], architecture: int) -> None:
        self._lines = lines
        self._architecture = architecture

    def __call__(
        self, number: int, first: int = 0, second: int = 0, architecture: int | None = None
    ) -> int:
        """Return what becomes of a system call."""
        known = self._architecture if architecture is None else architecture
        data = {
            seccomp.NUMBER: number,
            seccomp.ARCHITECTURE: known,
            seccomp.FIRST_ARGUMENT: first,
            seccomp.SECOND_ARGUMENT: second,
        }
        at, loaded = 0, 0
        while True:
            operation, if_true, if_false, operand = self._lines[at]
            at += 1
            if operation == seccomp.RETURN:
                return operand
            if operation == seccomp.LOAD:
                loaded = data[operand]
            elif operation == seccomp.EQUAL:
                at += if_true if loaded == operand else if_false
            elif operation == seccomp.AT_LEAST:
                at += if_true if loaded >= operand else if_false
            else:
                at += if_true if loaded & operand else if_false


def test_landlock_rights_are_those_of_the_kernel() -> None:
    """Reading and writing are told apart, and nothing is in both."""
    assert landlock.READ == 0b1101
    assert landlock.ALL_WRITES == 0b111_1111_1111_0010
    assert landlock.READ & landlock.ALL_WRITES == 0


@LINUX
def test_probe_finds_every_deed_possible_where_there_is_no_wall(tmp_path: Path) -> None:
    """A deed that could never succeed would prove nothing when it fails behind a wall."""
    (tmp_path / "canary").write_text("canary")
    with socket.create_server(("127.0.0.1", 0)) as server, socket.socket() as inherited:
        target = {
            "folder": str(tmp_path),
            "port": server.getsockname()[1],
            "process": os.getpid(),
            "shared": os.__file__,
            "copies": paths.copies(),
            "packages": ("rich",),
        }
        code = (
            "import json, os, resource, sys\n"
            "from lesson_code.course.isolation.inside import probe\n"
            f"os.dup2({inherited.fileno()}, 3)\n"
            "os.dup2(3, 4)\n"
            "resource.setrlimit(resource.RLIMIT_NPROC, (5_000, 5_000))\n"
            f"print(json.dumps(probe.attempts({target!r})))"
        )
        ran = subprocess.run(
            [sys.executable, "-c", code],
            pass_fds=[inherited.fileno()], capture_output=True, text=True, check=True,
        )  # fmt: skip
    possible = json.loads(ran.stdout)
    assert {deed for deed, could in possible.items() if not could} <= {"be root"}
    assert possible["be root"] == (os.geteuid() == 0)


@LINUX
@pytest.mark.parametrize("name", ["installed", "renamed", "archive"])
def test_every_copy_of_the_workbook_is_hidden(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A second workbook in a readable place cannot be read: as it is, under a name, as a wheel."""
    place = tmp_path / "libraries" / "deep"
    place.mkdir(parents=True)
    copy = place / {"installed": "lesson_code", "archive": "collision_workbook-0.1.0.whl"}.get(
        name, "mine"
    )
    if name == "archive":
        copy.write_bytes(b"answers")
    else:
        for wing in paths.WINGS:
            (copy / wing).mkdir(parents=True)
        (copy / "secret.py").write_text("answers")
    (place / "library.py").write_text("a library")
    for folder in (place, *list(place.parents)[:4]):
        with contextlib.suppress(PermissionError):
            folder.chmod(0o755)
    everything = (*paths.readable(), str(tmp_path / "libraries"))
    monkeypatch.setattr(paths, "readable", lambda: everything)
    paths.hidden.cache_clear()
    source = f"""\
from pathlib import Path
def f():
    copy = Path({str(copy)!r})
    return [p.name for p in copy.iterdir()] if copy.is_dir() else copy.read_text()
def g(): return Path({str(place / "library.py")!r}).read_text()
"""
    try:
        assert str(copy) in paths.copies()
        for rung in FULL:
            children = open_or_skip(BY_NAME[rung], Limits())
            with StudentProcess(units(source), children) as student:
                read, beside = student.call("f", ()), student.call("g", ()).value
            children.close()
            assert not read.value
            assert beside == "a library"
    finally:
        paths.hidden.cache_clear()


@LINUX
@pytest.mark.parametrize("rung", FULL)
def test_package_beyond_the_list_is_not_there(rung: str) -> None:
    """Not even with the finder removed that refuses it in words."""
    source = """\
import sys
def f(): import pymunk
def g():
    del sys.meta_path[0]
    import pymunk
"""
    children = open_or_skip(BY_NAME[rung], Limits())
    with StudentProcess(units(source), children) as student:
        said, gone = student.call("f", ()).text, student.call("g", ()).text
    children.close()
    assert "pymunk cannot be imported while an answer is graded" in said
    assert "No module named 'pymunk'" in gone
