"""A submission behind the wall: of what it says, nothing is believed but plain values."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from tiers import share

from lesson_code.course.isolation import Children, Limits, Rung, StudentProcess
from lesson_code.course.isolation.call_outcome import LONGEST_TEXT, CallOutcome
from lesson_code.course.isolation.inside.disk import MOST_BYTES

from .conftest import units

POSIX = pytest.mark.skipif(os.name != "posix", reason="limits are set on POSIX systems alone")
LINUX = pytest.mark.skipif(sys.platform != "linux", reason="other systems count by the clock")
FORGE = """\
import json, os
def forge(**reply):
    line = json.dumps(reply).encode() + b"\\n"
    for descriptor in range(3, 21):
        try:
            os.write(descriptor, line)
        except OSError:
            pass
"""


def test_call_returns_plain_values(children: Children) -> None:
    """Vectors go over as arrays and come back as lists; numbers stay what they are."""
    source = "def f(n, v): return n, v, type(n).__name__, type(v).__name__, v.shape"
    with StudentProcess(units(source), children) as student:
        outcome = student.call("f", (2, (3.0, 4.0)))
    assert outcome == CallOutcome("returned", [2, [3.0, 4.0], "int", "ndarray", [2]])


def test_call_returns_every_float_to_the_last_bit(best: Children) -> None:
    """A float comes back as the float it was, infinities and nan too."""
    numbers = (0.1, -1e-320, 1.7976931348623157e308, 2.0**-1074, float("inf"))
    with StudentProcess(
        units("def f(*numbers): return (*numbers, numbers[-1] * 0)"), best
    ) as student:
        *same, nan = student.call("f", numbers).value
    assert same == list(numbers)
    assert nan != nan


def test_call_of_missing_function_says_so(best: Children) -> None:
    """A function that was not handed in is missing, and no crash."""
    with StudentProcess(units("x = 1"), best) as student:
        assert student.call("f", ()) == CallOutcome("missing", text="there is no function named f")


def test_calls_share_one_process_until_one_fails(children: Children, quick: Limits) -> None:
    """State is kept from call to call; after a crash it starts afresh."""
    source = "import os\nn = []\ndef f(): n.append(0); return len(n)\ndef g(): os._exit(0)"
    with StudentProcess(units(source), children, quick) as student:
        assert [student.call("f", ()).value for _ in range(3)] == [1, 2, 3]
        assert student.call("g", ()).kind == "crashed"
        assert student.call("f", ()).value == 1


def test_submission_leaves_no_state_to_the_next(children: Children) -> None:
    """What one submission changes in Python's own modules, the next one does not see."""
    spoils = "import math, numpy\nmath.tau = numpy.pi = 3.0\ndef f(): return math.tau, numpy.pi"
    looks = "import math, numpy\ndef f(): return math.tau, numpy.pi"
    with StudentProcess(units(spoils), children) as student:
        assert student.call("f", ()).value == [3.0, 3.0]
    with StudentProcess(units(looks), children) as student:
        assert student.call("f", ()).value == [6.283185307179586, 3.141592653589793]


def test_child_that_is_prepared_serves_one_submission(children: Children) -> None:
    """However often the next child is asked for beforehand, each submission has its own."""
    source = "import os\ndef f():\n    os.environ['SEEN'] = os.environ.get('SEEN', '') + 'x'\n"
    source += "    return os.environ['SEEN']\n"
    for times in (2, 0, 1):
        for _ in range(times):
            children.prepare()
        with StudentProcess(units(source), children) as student:
            assert student.call("f", ()).value == "x"


def test_load_errors_are_kept_and_the_rest_is_loaded(best: Children) -> None:
    """What failed while loading is told in a line each."""
    parts = (*units("1 / 0"), *units("def f(): return 1"))
    with StudentProcess(parts, best) as student:
        assert student.call("f", ()).value == 1
        assert student.load_errors == ["ZeroDivisionError (your test, line 1)"]


def test_load_errors_repeat_no_word_of_the_error(best: Children) -> None:
    """Neither its text nor the name of its class: both may hold what the code has read."""
    source = "class Secret(Exception): pass\nx = 1\ndef f(): raise Secret(x)\ny = f()"
    with StudentProcess(units(source), best) as student:
        assert student.load_errors == ["an error of its own (your test, line 4)"]


def test_load_that_hangs_keeps_what_stands_before_it(best: Children) -> None:
    """A statement that does not finish is named; what stands above it answers, below it nothing."""
    source = "def f(): return 1\nn = 1\nwhile n: n += 1\ndef g(): return 2"
    with StudentProcess(units(source), best, Limits(seconds_to_load=0.4)) as student:
        assert student.call("f", ()).value == 1
        assert student.call("g", ()).kind == "missing"
        assert "it did not finish within 0.4 s; it is left out" in student.load_errors[0]


@pytest.mark.parametrize(
    ("source", "kind", "text"),
    [
        ("import os; os._exit(0)", "crashed", "used more than it may, while it was loaded"),
        ("import ctypes; ctypes.string_at(0)", "crashed", "used more than it may, while it was"),
    ],
)
def test_load_that_dies_fails_every_call_at_once(
    best: Children, source: str, kind: str, text: str
) -> None:
    """Code that cannot be loaded is not tried again for each call."""
    with StudentProcess(units(f"def f(): return 1\n{source}"), best) as student:
        began = time.perf_counter()
        outcomes = [student.call("f", ()) for _ in range(20)]
        assert time.perf_counter() - began < Limits().seconds_to_load
    assert {outcome.kind for outcome in outcomes} == {kind}
    assert text in outcomes[0].text


class Scripted:
    """Makes children that say what they are told to say."""

    def __init__(self, *replies: dict[str, Any]) -> None:
        self._replies = iter(replies)

    def open(self) -> None:
        """Do nothing."""

    def start(self) -> Scripted:
        """Return itself: it is its own channel."""
        return self

    def ask(self, line: bytes, seconds: float) -> bytes:  # noqa: ARG002
        """Return the next reply, numbered as asked for; an empty one is a crash."""
        reply = next(self._replies)
        return json.dumps(reply | {"number": json.loads(line)["number"]}).encode() if reply else b""

    def spent(self) -> None:
        """Do not know."""

    def end(self) -> None:
        """Do nothing."""

    def close(self) -> None:
        """Do nothing."""


def test_load_errors_of_a_second_child_are_not_listened_to() -> None:
    """What code says that is loaded again could tell what it was called with before."""
    first, later = [[0, 0, "KeyError"]], [[0, 0, "ValueError"]]
    again = Scripted({"loaded": first}, {}, {"loaded": later}, {"kind": "returned"})
    with StudentProcess(units("x = 1"), again) as student:
        assert student.call("f", (0.82,)).kind == "crashed"
        assert student.call("f", (0.82,)).kind == "returned"
        assert student.load_errors == ["KeyError (your test, line 1)"]


@POSIX
def test_child_runs_under_the_limits_it_was_given(
    children_with: Callable[[Limits], Children],
) -> None:
    """Memory, CPU time, file size and open files are limited, and cannot be raised again."""
    source = """\
import resource
def f():
    names = ("AS", "CPU", "FSIZE", "NOFILE", "CORE")
    return [resource.getrlimit(getattr(resource, "RLIMIT_" + name)) for name in names]
def g():
    with open("file", "wb") as file:
        file.write(b"x" * 2_000_000)
"""
    limits = Limits(seconds_a_submission=6, bytes_of_memory=900_000_000)
    with StudentProcess(units(source), children_with(limits), limits) as student:
        *_, bytes_a_file = student.call("f", ()).value[2]
        assert bytes_a_file in (0, 1_000_000)
        most = [900_000_000, 7, bytes_a_file, 64, 0]
        assert student.call("f", ()).value == [[limit, limit] for limit in most]
        assert student.call("g", ()).text.startswith(("OSError: [Errno 27]", "PermissionError"))


@POSIX
def test_nothing_of_a_submission_comes_to_a_disk(children: Children, rung: Rung) -> None:
    """Where its folder is on a disk not one byte can be written; in memory it has a size."""
    source = """\
import os
def f():
    written = 0
    try:
        for number in range(60):
            with open(str(number), "wb") as file:
                file.write(b"x" * 1_000_000)
            written += 1
    except OSError:
        pass
    return written, sum(entry.stat().st_size for entry in os.scandir())
"""
    with StudentProcess(units(source), children) as student:
        files, size = student.call("f", ()).value
    if rung.name in ("namespaces", "bubblewrap"):
        assert 0 < size < MOST_BYTES + 1_000_000
    else:
        assert files == size == 0


@POSIX
def test_submission_has_a_budget_of_processor_time(
    children_with: Callable[[Limits], Children],
) -> None:
    """What all calls of a submission may use together is bounded; then nothing is called."""
    limits = Limits(seconds_a_submission=1, seconds_a_call=8.0)
    source = "def f():\n    while True: pass\ndef g(): return 1"
    with StudentProcess(units(source), children_with(limits), limits) as student:
        assert student.call("g", ()).value == 1
        for function in "fg":
            text = "the submission used up its 1 s of processor time"
            assert student.call(function, ()) == CallOutcome("not called", text=text)


@POSIX
def test_child_is_ended_by_the_system_where_the_grader_does_not(
    children_with: Callable[[Limits], Children],
) -> None:
    """The system ends a child that uses more than the whole submission may."""
    limits = Limits(seconds_a_submission=1)
    source = "def f():\n    while True: pass"
    patient = Limits(seconds_a_submission=100, seconds_a_call=100)
    with StudentProcess(units(source), children_with(limits), patient) as student:
        assert student.call("f", ()).kind == "crashed"


BURN = """
import time
def f(seconds):
    began = time.process_time()
    while time.process_time() - began < seconds: pass
    return 1
"""


@pytest.fixture
def neighbours() -> Iterator[None]:
    """Keep every core busy, three times over, with processes of equal rank."""
    command = [sys.executable, "-c", "print(flush=True)\nwhile True: pass"]
    busy = [
        subprocess.Popen(command, stdout=subprocess.PIPE, start_new_session=True)
        for _ in range(3 * (os.cpu_count() or 1))
    ]
    for process in busy:
        assert process.stdout is not None
        with process.stdout:
            process.stdout.readline()  # it runs
    yield
    for process in busy:
        process.kill()
        process.wait()


@LINUX
@pytest.mark.usefixtures("neighbours")
def test_call_with_busy_neighbours_has_its_whole_time(children: Children) -> None:
    """Time is the processor's: what others use of it is not charged to a call."""
    limits = Limits(seconds_a_call=0.6)
    with StudentProcess(units(BURN), children, limits) as student:
        began = time.perf_counter()
        outcomes = [student.call("f", (0.3,)) for _ in range(3)]
        took = time.perf_counter() - began
    assert outcomes == [CallOutcome("returned", 1)] * 3
    assert took > 3 * limits.seconds_a_call  # the neighbours were busy: the clock would not do


def test_call_that_is_cut_off_is_tried_once_more_alone(best: Children) -> None:
    """What is slow for the state it finds, and not by itself, gets its marks."""
    source = f"""{BURN}
n = []
def g():
    n.append(0)
    if len(n) > 1: f(60)
    return 1
"""
    limits = Limits(seconds_a_call=0.2)
    with StudentProcess(units(source), best, limits) as student:
        assert [student.call("g", ()).kind for _ in range(2)] == ["returned", "returned"]


def test_function_that_hangs_is_not_called_for_ever(best: Children) -> None:
    """It is called for two criteria, once more alone, and leaves the others their time."""
    limits = Limits(seconds_a_call=0.2, seconds_a_submission=2)
    with StudentProcess(units(f"{BURN}\ndef g(): return 1"), best, limits) as student:
        kinds = [student.call("f", (60.0,)).kind for _ in range(20)]
        assert kinds == ["timeout"] * 2 + ["not called"] * 18
        assert "f was not called again" in student.call("f", (60.0,)).text
        assert student.call("g", ()).value == 1


@pytest.mark.parametrize("body", ["while True: pass", "import time; time.sleep(1e9)"])
def test_call_without_an_end_ends(children: Children, body: str) -> None:
    """What computes is ended by the processor's time, what sleeps by the clock."""
    limits = Limits(seconds_a_call=0.2)
    with StudentProcess(units(f"def f():\n    {body}"), children, limits) as student:
        began = time.perf_counter()
        assert student.call("f", ()).kind == "timeout"
        assert time.perf_counter() - began < 10.0


def test_call_that_hangs_is_a_timeout(children: Children, quick: Limits) -> None:
    """A call that does not come back is cut off after the limit, and the child with it."""
    source = "import time\ndef f(): time.sleep(60)\ndef g(): return 1"
    with StudentProcess(units(source), children, quick) as student:
        began = time.perf_counter()
        assert student.call("f", ()) == CallOutcome(
            "timeout", text="it did not finish within 0.5 s"
        )
        assert time.perf_counter() - began < 10.0
        assert student.call("g", ()).value == 1


@pytest.mark.parametrize(
    "reply",
    [
        '"kind": "returned", "value": [1, 2]',
        '"kind": "returned", "value": [1, 2], "number": 99',
        '"loaded": 5',
        '"number": [2]',
    ],
)
def test_forged_reply_without_the_number_asked_for_is_a_crash(
    best: Children, quick: Limits, reply: str
) -> None:
    """A line out of turn ends the child, so that it cannot be taken for the next answer."""
    source = f"{FORGE}\ndef f(): forge(**{{{reply}}})\ndef g(): return 1"
    with StudentProcess(units(source), best, quick) as student:
        outcome = student.call("f", ())
        assert outcome.kind == "crashed"
        assert outcome.text == "it wrote where only the grader's own lines may stand"
        assert student.call("g", ()) == CallOutcome("returned", 1)


@pytest.mark.parametrize(
    "reply",
    [
        {},
        {"kind": "passed"},
        {"kind": ["returned"]},
        {"kind": None, "value": 1},
        {"kind": "returned", "value": {"points": 4}},
        {"kind": "returned", "value": 10**400},
        {"kind": "returned", "value": [[[[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]]]},
        {"kind": "timeout"},
        {"kind": "raised", "text": ["not", "words"]},
    ],
    ids=str,
)
def test_forged_reply_of_another_form_cannot_be_read(
    best: Children, quick: Limits, reply: dict[str, Any]
) -> None:
    """With the right number too, nothing but the agreed kinds and plain values comes through."""
    source = f"{FORGE}\ndef f(): forge(number=2, **{reply})"
    with StudentProcess(units(source), best, quick) as student:
        outcome = student.call("f", ())
    assert outcome == CallOutcome("crashed", text="the answer could not be read")


@pytest.mark.parametrize(
    "loaded",
    [5, None, {"a": 1}, "text", [1, None, {}], [["a", 0, "E"]], [[9, 0, "E"]], [[0, -1, "E"]],
     [[0, 0]], [[0, True, ["E"]]], [[0, 0, "f(0.82) = 3"]]],
    ids=str,
)  # fmt: skip
def test_forged_reply_to_loading_does_no_harm(best: Children, quick: Limits, loaded: Any) -> None:
    """Whatever stands where the load errors belong, nothing of it is repeated."""
    source = f"{FORGE}\nforge(number=1, loaded={loaded!r})"
    with StudentProcess(units(source), best, quick) as student:
        known = "an error of its own (your test, line 1)"
        assert set(student.load_errors) <= {known}


@pytest.mark.parametrize("line", ['b"[" * 200_000', 'b"\\\\xff\\\\xfe"', 'b"9" * 5000', 'b"no"'])
def test_forged_line_that_is_no_json_is_a_crash(best: Children, quick: Limits, line: str) -> None:
    """A line that breaks a JSON reader ends the child and not the parent."""
    source = f"""\
import os
def f():
    for descriptor in range(3, 21):
        try:
            os.write(descriptor, {line} + b"\\n")
        except OSError:
            pass
"""
    with StudentProcess(units(source), best, quick) as student:
        assert student.call("f", ()).kind == "crashed"


@POSIX
def test_parent_does_not_store_what_it_has_not_asked_for(children: Children) -> None:
    """Lines written without end stay in the pipe and do not fill the parent's memory."""
    source = """\
import json, os, threading
block = b'{"number": 0}\\n' * 10_000
def flood():
    while True:
        for descriptor in range(3, 21):
            try:
                os.write(descriptor, block)
            except OSError:
                pass
def f():
    for descriptor in range(3, 21):
        try:
            os.write(descriptor, b'{"kind": "returned", "value": 1, "number": 2}\\n')
        except OSError:
            pass
    threading.Thread(target=flood, daemon=True).start()
"""
    with StudentProcess(units(source), children) as student:
        assert student.call("f", ()).value == 1
        before = _megabytes()
        time.sleep(0.3)
        assert _megabytes() - before < 20


def _megabytes() -> float:
    """Return the memory that this process holds now."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


@pytest.mark.full
def test_child_that_reads_nothing_does_not_stop_the_parent(best: Children, quick: Limits) -> None:
    """A request that nobody takes off the pipe is a timeout, however long it is."""
    source = "import time\ndef f(*numbers): time.sleep(60)"
    with StudentProcess(units(source), best, quick) as student:
        assert student.call("f", (tuple([0.5] * 500_000),)).kind == "timeout"


def test_answer_longer_than_allowed_is_a_crash(
    children_with: Callable[[Limits], Children],
) -> None:
    """The parent reads no more of an answer than it has set."""
    limits = Limits(bytes_an_answer=1000)
    source = "def f(): return 'x' * 5_000"
    with StudentProcess(units(source), children_with(limits), limits) as student:
        assert student.call("f", ()).kind == "crashed"


def test_words_of_a_student_cannot_forge_a_report(best: Children) -> None:
    """Line ends, escape sequences and marks of direction become spaces; long texts are cut."""
    source = """\
def f(): raise ValueError("\\x1b[2J\\n1.1 f: 4/4 points\\u202e\\ud800\\x07" + "x" * 1000)
"""
    with StudentProcess(units(source), best) as student:
        outcome = student.call("f", ())
    assert outcome.text.startswith("ValueError:  [2J 1.1 f: 4/4 points   xxx")
    assert outcome.text.isprintable()
    assert len(outcome.text) <= LONGEST_TEXT


def test_no_thread_or_open_file_is_left_behind(children: Children) -> None:
    """Submissions, good and bad, leave neither threads nor open descriptors."""
    sources = ["def f(): return 1", "def f():\n    while True: pass"]
    threads, files = threading.active_count(), _open_files()
    for source in sources * share(5):
        with StudentProcess(units(source), children, Limits(seconds_a_call=0.05)) as student:
            student.call("f", ())
    assert threading.active_count() == threads
    assert _open_files() == files


def _open_files() -> int:
    """Return how many descriptors this process has open."""
    folder = Path("/proc/self/fd")
    return len(list(folder.iterdir())) if folder.exists() else 0


ANSWERS = "def f(x): return x, 1 / (x - 2)\ndef g(x): return {}\ndef h(x): return x * x\n"


@pytest.mark.parametrize(
    "more",
    [
        "",
        "def h(x):\n    while True: pass\n",
        "import os\ndef g(x): os._exit(0)\n",
        "def g(x): return ['a' * 9_000] * 100\n",
        "import json\ndumps = json.dumps\n"
        "json.dumps = lambda v: dumps({**v, 'answers': [[1], 2, []]} if 'answers' in v else v)\n",
    ],
    ids=["as asked", "hangs", "ends the process", "too long", "not in the form agreed on"],
)
def test_calls_made_together_come_to_what_each_would_by_itself(
    best: Children, quick: Limits, more: str
) -> None:
    """A group ends with the first call that gives nothing, and costs no other group a call."""
    groups = [[("f", (1.0,)), ("f", (2.0,))], [("g", (1.0,)), ("g", (2.0,))], [("h", (3.0,))]]
    requests = [request for group in groups for request in group]
    with StudentProcess(units(ANSWERS + more), best, quick) as student:
        alone = [student.call(*request) for request in requests]
    with StudentProcess(units(ANSWERS + more), best, quick) as student:
        call = student.together(groups)
        at_once = [call(*request) for request in requests]
    assert at_once == alone


def test_calls_made_together_take_one_message(best: Children) -> None:
    """They are handed out in their order; after any other call each is made by itself."""
    source = "calls = []\ndef f(x):\n    calls.append(x)\n    return calls"
    with StudentProcess(units(source), best) as student:
        call = student.together([[("f", (1.0,)), ("f", (2.0,)), ("f", (3.0,))]])
        assert student.call("f", (4.0,)).value == [1.0, 2.0, 3.0, 4.0]
        assert call("f", (1.0,)).value == [1.0]
        assert call("f", (5.0,)).value == [1.0, 2.0, 3.0, 4.0, 5.0]
        assert call("f", (2.0,)).value == [1.0, 2.0, 3.0, 4.0, 5.0, 2.0]
