"""A submission is read whatever it holds, or refused by name and reason."""

from __future__ import annotations

import io
import json
import os
import zipfile
from pathlib import Path
from typing import Any

import pytest
from clock import at_most

from lesson_code.course.grading import submission as submission_module
from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.submission import Submission, SubmissionError, read_submission
from lesson_code.course.isolation.inside.files import MOST_CELLS, MOST_CODE

from ..conftest import Write

ELASTIC = """\
def elastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return 2 * v - v1, 2 * v - v2
"""
INELASTIC = """\
def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v
"""
WRONG = "def elastic_1d(m1, v1, m2, v2):\n    return v1, v2\n"


def points(grader: Grader, path: Path) -> list[int]:
    """Return the points for each task of chapter 01."""
    return [verdict.points for verdict in grader.grade(path, exercise="01", seed=1).verdicts]


def kept(submission: Submission) -> list[str]:
    """Return the kept code of all units, group by group."""
    return [source for unit in submission.units for source in unit.kept_sources]


def zipped() -> bytes:
    """Return a zip archive."""
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as file:
        file.writestr("answer.py", ELASTIC)
    return archive.getvalue()


@pytest.mark.parametrize(
    ("name", "content", "reason"),
    [
        ("empty.py", b"", "is empty"),
        ("blank.ipynb", b" \n\t\n", "is empty"),
        ("bom_alone.py", b"\xef\xbb\xbf", "is empty"),
        ("binary.py", b"\x80\x81\xff", "is not text in UTF-8"),
        ("latin.py", "# Stoß".encode("latin-1"), "is not text in UTF-8"),
        ("zipped.ipynb", zipped(), "is not text in UTF-8"),
        ("answer.zip", zipped(), "ends in .ipynb or .py; unpack it first"),
        ("answer", b"x = 1", "ends in .ipynb or .py"),
        ("answer.tar.gz", b"", "ends in .ipynb or .py; unpack it first"),
        ("not_json.ipynb", b"x = 1", "is not a notebook (its text is not JSON)"),
        ("deep.ipynb", b"[" * 100_000, "is not a notebook (its text is not JSON)"),
        ("list.ipynb", b"[1, 2]", "is not a notebook (it has no list of cells)"),
        ("object.ipynb", b"{}", "is not a notebook (it has no list of cells)"),
        ("cells.ipynb", b'{"cells": {"a": 1}}', "is not a notebook (it has no list of cells)"),
        ("numbers.ipynb", b'{"cells": [1]}', "is not a notebook (it has no list of cells)"),
        ("old.ipynb", b'{"worksheets": []}', "is in the format of an old notebook; open it in"),
        ("no_cells.ipynb", b'{"cells": []}', "holds no code to grade"),
        ("comments.py", b"# nothing\n\n'''nothing'''\nprint(1)\n", "holds no code to grade"),
    ],
)
def test_read_refuses_what_is_no_submission(
    tmp_path: Path, name: str, content: bytes, reason: str
) -> None:
    """A file that cannot be graded is refused with its path and the reason, in one line."""
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(SubmissionError) as raised:
        read_submission(path)
    assert str(raised.value).startswith(f"{path}: ")
    assert reason in str(raised.value)
    assert "\n" not in str(raised.value)


def test_read_refuses_a_missing_file(tmp_path: Path) -> None:
    """A file that is not there is refused by its path."""
    with pytest.raises(SubmissionError, match=r"gone\.py: no such file"):
        read_submission(tmp_path / "gone.py")


def test_read_refuses_a_directory(tmp_path: Path) -> None:
    """A folder is no submission, even with the name of one."""
    (tmp_path / "folder.py").mkdir()
    with pytest.raises(SubmissionError, match="a submission is a file, and this is none"):
        read_submission(tmp_path / "folder.py")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes on this system")
def test_read_refuses_a_named_pipe(tmp_path: Path) -> None:
    """A named pipe is refused before it is opened, which would wait for ever."""
    os.mkfifo(tmp_path / "pipe.py")
    with pytest.raises(SubmissionError, match="a submission is a file, and this is none"):
        read_submission(tmp_path / "pipe.py")


@pytest.mark.parametrize("target", ["solution.py", "gone.py"])
def test_read_refuses_a_link(tmp_path: Path, target: str) -> None:
    """A link could lead to the solution, and is refused wherever it leads."""
    (tmp_path / "solution.py").write_text(ELASTIC)
    (tmp_path / "link.py").symlink_to(tmp_path / target)
    with pytest.raises(SubmissionError, match="a submission is a file, and this is a link"):
        read_submission(tmp_path / "link.py")


def test_read_refuses_a_large_file(write: Write, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file above the limit is refused before it is read."""
    monkeypatch.setattr(submission_module, "LARGEST_FILE", 10)
    with pytest.raises(SubmissionError, match="larger than"):
        read_submission(write("large.py", "x = 1\n" * 10))


def test_read_refuses_many_cells(write: Write) -> None:
    """A notebook with more cells than the limit is refused."""
    read_submission(write("most.ipynb", *["x = 1"] * MOST_CELLS))
    with pytest.raises(SubmissionError, match=f"has more than {MOST_CELLS} cells"):
        read_submission(write("more.ipynb", *["x = 1"] * (MOST_CELLS + 1)))


@pytest.mark.parametrize("name", ["answer.py", "answer.ipynb"])
def test_read_refuses_more_code_than_any_answer_has(write: Write, name: str) -> None:
    """Up to the limit it is read; what is beyond would cost the grader its own time and memory."""
    most = ELASTIC + "#" * (MOST_CODE - len(ELASTIC))
    assert read_submission(write(name, most)).functions == ("elastic_1d",)
    with pytest.raises(SubmissionError, match="has more than 1,000,000 characters of code"):
        read_submission(write(name, f"{most}#"))


@pytest.mark.parametrize("encoding", ["undefined", "punycode", "rot13", "hex", "no_such"])
def test_read_refuses_an_encoding_that_is_none_of_text(write: Write, encoding: str) -> None:
    """Whatever Python's own codecs end in, the file is refused in a line."""
    with pytest.raises(SubmissionError, match="is not text in UTF-8"):
        read_submission(write("answer.py", f"# coding: {encoding}\n{'.' * 100}-\n{ELASTIC}"))


@pytest.mark.full
def test_read_of_an_encoding_that_takes_long_costs_the_parent_nothing(write: Write) -> None:
    """Python decodes Punycode in a time that grows as the square of the length."""
    path = write("answer.py", f"# coding: punycode\nx-{'a' * 400_000}")
    with (
        at_most(SECONDS_OF_THE_PARENT),
        pytest.raises(SubmissionError, match=r"takes too much time or memory to read$"),
    ):
        read_submission(path)


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root reads every file")
@pytest.mark.parametrize("name", ["answer.py", "answer.ipynb"])
def test_read_refuses_what_this_user_may_not_read(write: Write, name: str) -> None:
    """The reason is the system's own."""
    path = write(name, ELASTIC)
    path.chmod(0)
    with pytest.raises(SubmissionError, match=r"cannot be read \(Permission denied\)"):
        read_submission(path)


SECONDS_OF_THE_PARENT = 0.15
"""For any file; it takes some thousandths, and parsing here took 2.4."""

LONG = 90_000
"""Characters: twenty times those of a chapter's answers."""


@pytest.mark.parametrize(
    "source",
    [
        'x = f"' + "{a}" * 66_000 + '"',
        'x = f"' + "b" * LONG + "{a}" * 1_900 + '"',
        'x = f"' + ("b" * 45 + "{a}") * 1_900 + '"',
        'x = f"' + ("b" * 45 + "{a}") * 1_900 + '" $',
        'x = f"' + ("b" * 85 + "{a:{b}}") * 950 + '"',
        'x = f"""' + ("b" * 85 + "{f'{a}'}") * 950 + '"""',
        'x = f"""' + "\n" * LONG + "{a}" * 1_900 + '"""',
    ],
    ids=["198 kB", "long before", "between", "wrong", "format", "nested", "lines"],
)
def test_read_of_f_strings_costs_the_grader_nothing(write: Write, source: str) -> None:
    """Whatever stands in f-strings, the grader's own processor time is a fraction of a second."""
    path = write("code.py", source)
    with at_most(SECONDS_OF_THE_PARENT):
        submission = read_submission(path)
    assert submission.functions == ()
    assert submission.left_out == {}


@pytest.mark.full
def test_read_names_what_takes_too_long_and_reads_the_rest(write: Write) -> None:
    """A cell that no parser gets through in time is named, and the functions lost with it."""
    slow = 'x = f"' + "{a}" * 200_000 + '"\n' + INELASTIC
    path = write("answer.ipynb", ELASTIC, slow)
    read = read_submission(path)
    assert read.unreadable == ("your cell 2: takes too much time or memory to read",)
    assert list(read.lost) == ["inelastic_1d"]
    assert read.functions == ("elastic_1d",)


def test_read_of_long_program_is_graded(write: Write, grader: Grader) -> None:
    """A program of 5,000 statements is read, sent and graded as a short one is."""
    assert points(grader, write("long.py", ELASTIC + "x = 1\n" * 5000))[0] == 4


def test_read_keeps_definitions_imports_and_assignments(write: Write) -> None:
    """Calls, docstrings and what a script does when run are left out; definitions stay."""
    path = write(
        "answer.py",
        '"""Text."""\nimport math\nprint(1)\nx: int = 2\ny = x\nclass A: pass\nf = lambda: 1\n'
        'pass\nif __name__ == "__main__":\n    1 / 0\nif x > 1:\n    z = 3\n',
    )
    assert kept(read_submission(path)) == [
        "import math",
        "x: int = 2",
        "y = x",
        "class A: pass",
        "f = lambda: 1",
        "if x > 1:\n    z = 3",
    ]


@pytest.mark.parametrize(
    "statement",
    [
        "import lesson_code",
        "import lesson_code.formulas as f",
        "from lesson_code import formulas",
        "from lesson_code.formulas import *",
        "import pymunk",
        "import matplotlib.pyplot as plt, scipy",
        "from pymunk.vec2d import Vec2d",
        "import lesson_codes",
    ],
)
def test_read_leaves_out_imports_that_are_not_on_the_list(write: Write, statement: str) -> None:
    """Each form of an import of lesson_code, and of any package that is not listed, is left out."""
    assert kept(read_submission(write("answer.py", f"{statement}\nx = 1"))) == ["x = 1"]


@pytest.mark.parametrize(
    ("statement", "stays"),
    [
        ("import numpy as np, pymunk", "import numpy as np"),
        ("import numpy.linalg", "import numpy.linalg"),
        ("from pygame import Vector2", "from pygame import Vector2"),
        ("from math import *", "from math import *"),
        ("from . import lesson_code", "from . import lesson_code"),
    ],
)
def test_read_keeps_imports_on_the_list(write: Write, statement: str, stays: str) -> None:
    """Python's own modules, NumPy and pygame stay, also where one statement imports others too."""
    assert kept(read_submission(write("answer.py", statement))) == [stays]


PLOTS = """\
import numpy as np
import matplotlib.pyplot as plt
from numba import njit
figure, axes = plt.subplots()
axis = axes[0]
axis.set_title("mine")
for height in range(3):
    axis.plot(height)
speeds = np.zeros(2)
@njit
"""


@pytest.mark.parametrize("name", ["answer.py", "answer.ipynb"])
def test_read_leaves_out_plots_and_compilers_and_keeps_the_answer(
    write: Write, name: str, grader: Grader
) -> None:
    """What needs an import that is left out goes with it; the answer beside it earns its marks."""
    path = write(name, PLOTS + ELASTIC.replace("m1,", "m1: plt.Axes,"))
    text = "\n".join(kept(read_submission(path)))
    assert not any(word in text for word in ("plt", "axis", "figure", "njit"))
    assert "speeds = np.zeros(2)" in text
    report = grader.grade(path, exercise="01", seed=1)
    assert report.verdicts[0].is_full
    assert report.notes == ()


def test_read_name_of_an_import_that_is_defined_again_is_not_missing(write: Write) -> None:
    """Whoever imports ours and then writes their own is graded for their own."""
    source = f"from lesson_code.formulas import elastic_1d, tau\nfrom math import tau\n{ELASTIC}"
    answer = "turn = tau\nswapped = elastic_1d(1, 2, 1, 3)\n"
    assert "\n".join(kept(read_submission(write("a.py", source + answer)))).endswith(answer.strip())


def test_read_syntax_error_in_one_cell_leaves_the_others(write: Write, grader: Grader) -> None:
    """A cell that is no Python is named with its line, and the other cells are graded."""
    path = write("answer.ipynb", ELASTIC, "x = 1\ny = (\n", INELASTIC)
    read = read_submission(path)
    assert read.unreadable == ("your cell 2, line 2: '(' was never closed, in: y = (",)
    assert points(grader, path) == [4, 3, 0]


def test_read_syntax_error_in_a_program_is_named(write: Write, grader: Grader) -> None:
    """A program that is no Python earns nothing, and the report says where it ends."""
    report = grader.grade(write("answer.py", f"{ELASTIC}\ndef f(:\n"), exercise="01", seed=1)
    assert report.points == 0
    assert report.notes == ("your answer.py, line 5: invalid syntax, in: def f(:",)


@pytest.mark.parametrize(
    "source",
    ["x = 1\0", "(" * 5000, "-" * 20_000 + "1", "if " + "-" * 900 + "1: pass", "x = " + "9" * 5000],
    ids=["null byte", "brackets", "signs", "deep condition", "digits"],
)
def test_read_of_code_that_breaks_the_parser_is_no_error_of_ours(
    write: Write, source: str, grader: Grader
) -> None:
    """Code beyond what the parser bears is left out; the other cells are graded."""
    assert points(grader, write("answer.ipynb", source, ELASTIC))[0] == 4


@pytest.mark.parametrize(
    "magic",
    [
        "%matplotlib inline",
        "%%time",
        "!ls -l",
        "  %time 1",
        "?len",
        "len?",
        "math.sin??",
        "files = !ls",
        "a, b = %timeit -o 1",
    ],
)
def test_read_magic_does_no_harm_to_its_cell(write: Write, magic: str, grader: Grader) -> None:
    """A line that only a notebook understands is left out, and its cell is graded."""
    indent = "if True:\n" if magic.startswith(" ") else ""
    path = write("answer.ipynb", f"{indent}{magic}\n\n{ELASTIC}")
    assert read_submission(path).unreadable == ()
    assert points(grader, path)[0] == 4


@pytest.mark.parametrize("indent", ["    ", "  ", "\t", "\n \n  "])
@pytest.mark.parametrize("magic", ["", "%timeit 1\n"])
def test_read_cell_that_is_indented_as_a_whole(
    write: Write, indent: str, magic: str, grader: Grader
) -> None:
    """IPython takes the first line's indent off all lines of a cell, and so does the grader."""
    empty, _, spaces = indent.rpartition("\n")
    cell = "".join(f"{spaces}{line}\n" for line in (magic + ELASTIC).splitlines())
    path = write("answer.ipynb", f"{empty}\n{cell}", INELASTIC)
    assert points(grader, path)[:2] == [4, 3]


def test_read_cell_whose_first_comment_alone_is_indented(write: Write) -> None:
    """What Python can read as it is stays as it is."""
    source = "      # mine\ndef f(x):\n    if x:\n        return 1\n"
    assert read_submission(write("answer.ipynb", source)).unreadable == ()


def test_read_indented_cell_names_the_line_of_its_error(write: Write) -> None:
    """The line is that of the student's own cell."""
    (said,) = read_submission(write("answer.ipynb", "\n  x = 1\n  y = (\n")).unreadable
    assert said.startswith("your cell 1, line 3: ")


def test_read_line_that_starts_with_an_operator_is_no_magic(write: Write) -> None:
    """A % at the start of a continued line is the remainder, and stays."""
    source = "x = (7\n     % 4)\ntext = '''\n%d\n!x\n'''"
    assert kept(read_submission(write("answer.ipynb", source))) == [
        "x = (7\n     % 4)\n\ntext = '''\n%d\n!x\n'''"
    ]


def test_read_magic_pattern_takes_time_in_proportion(write: Write) -> None:
    """A cell made to slow down the search for magics is read at once."""
    spaces, letters = " " * 45_000, "a" * 45_000
    read = read_submission(write("answer.ipynb", f"(\n{spaces}x\n{letters}", "x = 1"))
    assert len(read.unreadable) == 1


def test_read_added_split_retyped_and_deleted_cells_do_no_harm(
    tmp_path: Path, grader: Grader
) -> None:
    """Answers are found by their names, wherever in the notebook they stand."""
    cells: list[dict[str, Any]] = [
        {"cell_type": "markdown", "source": ["# Title"]},
        {"cell_type": "raw", "source": "not code ("},
        {"cell_type": "code", "source": ["import math\n", "from functools import partial"]},
        {"cell_type": "code", "source": INELASTIC.splitlines(keepends=True)},
        {"cell_type": "code", "source": ""},
        {"cell_type": "code"},
        {"cell_type": "code", "source": None},
        {"cell_type": "markdown", "source": ELASTIC},
        {"cell_type": "code", "source": ELASTIC, "metadata": "odd", "outputs": 3},
        {"source": WRONG},
    ]
    path = tmp_path / "answer.ipynb"
    path.write_text(json.dumps({"cells": cells, "metadata": []}))
    assert points(grader, path) == [4, 3, 0]


def test_read_function_defined_twice_the_last_counts(write: Write, grader: Grader) -> None:
    """As in Python, the last definition of a name is the one that is called."""
    assert points(grader, write("right_last.py", WRONG + ELASTIC))[0] == 4
    assert points(grader, write("wrong_last.ipynb", ELASTIC, WRONG))[0] == 0


def test_read_decorated_function_keeps_its_decorators(write: Write) -> None:
    """A decorator is part of the answer, on however many lines it stands."""
    source = "import functools\n\n\n@functools.lru_cache(\n    maxsize=2\n)\n@abs\n" + ELASTIC
    assert kept(read_submission(write("answer.py", source)))[1] == (
        "@functools.lru_cache(\n    maxsize=2\n)\n@abs\n" + ELASTIC.rstrip()
    )


def test_read_decorated_function_is_called_through_its_decorator(
    write: Write, grader: Grader
) -> None:
    """The decorated function is what is graded."""
    helper = "def swapped(f):\n    return lambda *a: f(*a)[::-1]\n\n\n@swapped\n"
    wrong_order = ELASTIC.replace("2 * v - v1, 2 * v - v2", "2 * v - v2, 2 * v - v1")
    assert points(grader, write("answer.py", helper + wrong_order))[0] == 4


def test_read_code_under_name_main_is_left_out(write: Write, grader: Grader) -> None:
    """What a program does when it is run is not done when it is graded."""
    path = write("answer.py", ELASTIC + "if '__main__' == __name__:\n" + "    elastic_1d = 0\n")
    assert points(grader, path)[0] == 4


@pytest.mark.parametrize("name", ["answer.py", "answer.ipynb"])
def test_read_byte_order_mark_and_crlf_do_no_harm(write: Write, name: str, grader: Grader) -> None:
    """A file saved on Windows, with a byte order mark and CRLF, earns what it earns elsewhere."""
    path = write(name, f"{ELASTIC}\n{INELASTIC}".replace("\n", "\r\n"))
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    assert points(grader, path) == [4, 3, 0]


def test_read_says_nothing_about_style(
    write: Write, recwarn: pytest.WarningsRecorder, grader: Grader
) -> None:
    """Python's own warnings about a student's code are not ours to print, nor errors."""
    source = f'pattern = "\\d"\nassert (1, "always")\n{ELASTIC}'
    assert points(grader, write("answer.py", source))[0] == 4
    assert not recwarn.list


def test_kept_sources_hold_the_kept_statements_alone(write: Write) -> None:
    """Of statements on one line, each is taken by itself, and an import cannot slip through."""
    source = "import lesson_code as c; x = 1; print(x); y = (2,\n  3)  # why\nz = 4"
    read = read_submission(write("answer.ipynb", source))
    assert kept(read) == ["x = 1\n\ny = (2,\n  3)\n\nz = 4"]


def test_kept_sources_of_a_program_are_one_a_statement(write: Write) -> None:
    """In a program each statement can fail by itself, as it does when it is graded."""
    assert kept(read_submission(write("answer.py", "x = 1\ny = 2"))) == ["x = 1", "y = 2"]


def test_kept_sources_survive_odd_line_ends(write: Write) -> None:
    """A form feed or a line separator within a text is no end of a line."""
    source = "a = '\u2028 \x0c \x1c'\ndef f():\n    return 1"
    assert kept(read_submission(write("answer.py", source)))[1] == "def f():\n    return 1"


def test_functions_are_listed_in_the_order_of_the_file(write: Write) -> None:
    """The names of all functions at the top level are listed, those in classes are not."""
    source = "def b(): pass\nclass A:\n    def c(self): pass\ndef a(): pass\nd = 1"
    assert read_submission(write("answer.ipynb", source)).functions == ("b", "a")


@pytest.mark.parametrize(
    ("metadata", "exercise"),
    [
        ({"workbook": {"exercise": "01_one_dimension"}}, "01_one_dimension"),
        ({"workbook": {"exercise": 3}}, None),
        ({"workbook": []}, None),
        ({}, None),
        (None, None),
    ],
)
def test_exercise_is_read_from_the_notebook(
    tmp_path: Path, metadata: Any, exercise: str | None
) -> None:
    """A notebook may say which exercise it is; anything but a name counts as silence."""
    path = tmp_path / "answer.ipynb"
    cells = [{"cell_type": "code", "source": "x = 1"}]
    path.write_text(json.dumps({"cells": cells, "metadata": metadata}))
    assert read_submission(path).exercise == exercise


SETS_UP = """\
SETTINGS = {}
SETTINGS.update(factor=2)
PARTS = [2]
PARTS.append(1)
print("not kept")
def elastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return SETTINGS["factor"] * v - v1, PARTS[0] * v - v2
"""


@pytest.mark.parametrize("name", ["answer.py", "answer.ipynb"])
def test_read_keeps_calls_that_set_things_up(write: Write, name: str, grader: Grader) -> None:
    """An answer that fills a table of its own at top level has it when it is called."""
    path = write(name, SETS_UP)
    assert "print" not in str(kept(read_submission(path)))
    assert grader.grade(path, exercise="01", seed=1).verdicts[0].is_full


@pytest.mark.parametrize("name", ["answer.py", "answer.ipynb"])
@pytest.mark.parametrize(
    "below", ["while True:\n    pass\n", "await nothing()\n", "x = await nothing()\n"]
)
def test_read_leaves_out_what_never_ends_or_waits(
    write: Write, name: str, below: str, grader: Grader
) -> None:
    """A demo below the answers takes no points away from what stands above it."""
    path = write(name, SETS_UP + below)
    assert grader.grade(path, exercise="01", seed=1).verdicts[0].is_full


def test_read_leaves_out_what_comes_of_an_await(write: Write, grader: Grader) -> None:
    """What is made of it goes along, the rest of its cell does not."""
    cell = f"c = 1\nd = c\na = await nothing()\nb = a + 1\nc = await nothing()\n{ELASTIC}"
    path = write("answer.ipynb", cell)
    assert kept(read_submission(path)) == [f"c = 1\n\nd = c\n\n{ELASTIC.strip()}"]
    assert grader.grade(path, exercise="01", seed=1).notes == ()


@pytest.mark.parametrize("magic", ["%%bash\nls -l | wc\n", "%%html\n<b>bold</b>\n"])
def test_read_cell_in_another_language_is_no_code(write: Write, magic: str) -> None:
    """Such a cell is nothing that could not be read."""
    submission = read_submission(write("answer.ipynb", SETS_UP, magic))
    assert submission.unreadable == ()


@pytest.mark.parametrize(
    ("name", "encoding", "first"),
    [
        ("answer.py", "utf-16", ""),
        ("answer.py", "latin-1", "# -*- coding: latin-1 -*-\n"),
        ("answer.PY", "utf-8", ""),
        ("answer.py", "utf-8-sig", "# coding: utf-8\n"),
    ],
)
def test_read_text_in_the_encoding_that_it_names(
    tmp_path: Path, name: str, encoding: str, first: str, grader: Grader
) -> None:
    """A mark of UTF-16, a coding cookie and capital letters in the suffix do no harm."""
    path = tmp_path / name
    path.write_bytes(f"{first}# Stoß\r\n{SETS_UP}".encode(encoding))
    assert grader.grade(path, exercise="01", seed=1).verdicts[0].is_full


@pytest.mark.parametrize("name", ["answer.py", "answer.ipynb"])
def test_read_names_of_any_alphabet(write: Write, name: str, grader: Grader) -> None:
    """Python looks such letters up in a module of its own, which the reader has to find."""
    greek = ELASTIC.replace("m1", "μ").replace("v1", "ω")
    assert greek != ELASTIC
    assert grader.grade(write(name, greek), exercise="01", seed=1).verdicts[0].is_full


@pytest.mark.parametrize("encoding", ["shift_jis", "gbk", "cp1252", "mac_roman"])
def test_read_program_in_any_encoding_of_text(tmp_path: Path, encoding: str) -> None:
    """A coding cookie may name whatever Python knows as text."""
    path = tmp_path / "answer.py"
    comment = "東京" if encoding in ("shift_jis", "gbk") else "Stoß"
    path.write_bytes(f"# coding: {encoding}\n# {comment}\n{ELASTIC}".encode(encoding))
    assert read_submission(path).functions == ("elastic_1d",)


def test_read_notebook_that_is_too_large_names_the_cause(
    write: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What makes a notebook large are its outputs."""
    monkeypatch.setattr("lesson_code.course.grading.submission.LARGEST_FILE", 10)
    with pytest.raises(SubmissionError, match="clear the outputs of its cells"):
        read_submission(write("answer.ipynb", SETS_UP))


def with_outputs(write: Write, outputs: str) -> Path:
    """Return a notebook with an answer and some outputs, written as JSON."""
    path = write("answer.ipynb", SETS_UP)
    text = path.read_text().replace('"outputs": []', f'"outputs": {outputs}')
    path.write_text(text)
    return path


def test_read_notebook_with_21_mb_of_outputs(write: Write, grader: Grader) -> None:
    """Films and printed loops do no harm: the answers count."""
    path = with_outputs(write, json.dumps([{"data": {"image/png": "i" * 21_000_000}}]))
    assert grader.grade(path, exercise="01", seed=1).verdicts[0].is_full


@pytest.mark.full
@pytest.mark.parametrize("unit", ["[[]]", '{"a": {}}', "1e5", '"text"'])
def test_read_of_49_mb_of_any_json_costs_the_parent_nothing(unit: str, write: Write) -> None:
    """The reader parses it, or is ended: in a line that names the cause."""
    many = 49_000_000 // (len(unit) + 2)
    path = with_outputs(write, f"[{', '.join([unit] * many)}]")
    with at_most(SECONDS_OF_THE_PARENT):
        try:
            said = str(read_submission(path).functions)
        except SubmissionError as error:
            said = str(error)
    assert "elastic_1d" in said or said.endswith("clear the outputs of its cells and save it"), said
