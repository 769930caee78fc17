"""Student copies: signature and docstring stay, and nothing of the answer."""

from __future__ import annotations

import ast
from typing import Any

import pytest
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

from lesson_code.course.notebooks.student_copy import (
    student_notebook,
    student_program,
    student_source,
)

TASKS = {"f": "9.1"}
STUB = '    raise NotImplementedError("Task 9.1: f")'
ANSWER = "2 * secret"
LONG_SIGNATURE = """\
def f(
    x: dict[str, int],
    y=lambda a: {1: 2},  # kg
) -> float:
"""


def solution_notebook(*sources: str, tags: list[str] | None = None) -> Any:
    """Return an executed notebook of code cells, with a note to the instructor."""
    output = new_output("stream", name="stdout", text="9/9 points\n")
    note = new_markdown_cell("Why: secret.", metadata={"tags": ["solution"]})
    cells = [
        new_code_cell(s, outputs=[output], execution_count=1, metadata={"tags": tags or ["task"]})
        for s in sources
    ]
    return new_notebook(cells=[new_markdown_cell("# Exercise"), *cells, note])


@pytest.mark.parametrize(
    ("solution", "copy"),
    [
        pytest.param(
            f"def f(secret):\n    return {ANSWER}\n", f"def f(secret):\n{STUB}\n", id="plain"
        ),
        pytest.param(
            f'def f(x):\n    """Double it.\n\n    In m/s.\n    """\n    return {ANSWER}\n',
            f'def f(x):\n    """Double it.\n\n    In m/s.\n    """\n{STUB}\n',
            id="docstring",
        ),
        pytest.param(
            f'def f(x):\n    r"""Größe $\\alpha$, µm."""\n    return {ANSWER}',
            f'def f(x):\n    r"""Größe $\\alpha$, µm."""\n{STUB}',
            id="raw docstring, umlauts",
        ),
        pytest.param(
            f'def f(x):\n    ""\n    return {ANSWER}',
            f'def f(x):\n    ""\n{STUB}',
            id="empty docstring",
        ),
        pytest.param(f"def f(x): return {ANSWER}", f"def f(x):\n{STUB}", id="one line"),
        pytest.param(
            f'def f(x): """Double."""; return {ANSWER}',
            f'def f(x):\n    """Double."""\n{STUB}',
            id="one line with docstring",
        ),
        pytest.param(
            f'def f(x):\n    """Double."""; y = {ANSWER}\n    return y',
            f'def f(x):\n    """Double."""\n{STUB}',
            id="code beside the docstring",
        ),
        pytest.param(
            f"def f(x):\n    # {ANSWER}\n    return x", f"def f(x):\n{STUB}", id="comment first"
        ),
        pytest.param(
            f"def f(x):  # {ANSWER}\n    return x", f"def f(x):\n{STUB}", id="comment on the def"
        ),
        pytest.param(
            f"def f(x):\n    return x  # {ANSWER}\n\n    # {ANSWER}\n# next\ny = 1\n",
            f"def f(x):\n{STUB}\n# next\ny = 1\n",
            id="comments last",
        ),
        pytest.param(
            f"@cache\n@other(lambda: 1)\ndef f(x):\n    return {ANSWER}",
            f"@cache\n@other(lambda: 1)\ndef f(x):\n{STUB}",
            id="decorators",
        ),
        pytest.param(
            LONG_SIGNATURE + f"    return {ANSWER}",
            LONG_SIGNATURE + STUB,
            id="long signature",
        ),
        pytest.param(
            f"def f(x):\n    @cache\n    def g():\n        return {ANSWER}\n\n    return g()\n",
            f"def f(x):\n{STUB}\n",
            id="decorated function inside",
        ),
        pytest.param(
            f"def f(x):\n    text = '''\n{ANSWER}\n# no comment\n'''\n    return text\nz = 1",
            f"def f(x):\n{STUB}\nz = 1",
            id="text at the margin",
        ),
        pytest.param(
            f"async def f(x):\n    return {ANSWER}", f"async def f(x):\n{STUB}", id="async"
        ),
        pytest.param(
            f"def f(x):\r\n    '''Double\r\n    it.'''\r\n    return {ANSWER}\r\n",
            f"def f(x):\n    '''Double\n    it.'''\n{STUB}\n",
            id="CRLF",
        ),
        pytest.param(
            f"a = 'x\x0cy'\ndef f(x):\n    return {ANSWER}\nb = 2",
            f"a = 'x\x0cy'\ndef f(x):\n{STUB}\nb = 2",
            id="form feed",
        ),
        pytest.param(
            f"def f(x):\n    return {ANSWER}\ndef f(x):\n    return -{ANSWER}",
            f"def f(x):\n{STUB}\ndef f(x):\n{STUB}",
            id="written twice",
        ),
        pytest.param("def g(x):\n    return x", "def g(x):\n    return x", id="another function"),
        pytest.param("", "", id="nothing"),
    ],
)
def test_student_source_keeps_signature_and_docstring_and_nothing_else(
    solution: str, copy: str
) -> None:
    """The stub stands in place of the body, comments of the body included."""
    assert student_source(solution, TASKS) == copy
    assert ANSWER not in copy
    ast.parse(copy)


def test_stub_raises_with_the_number_of_the_task() -> None:
    """Whoever calls a stub learns which task is not written yet."""
    names: dict[str, Any] = {}
    exec(student_source("def f(x):\n    return x", TASKS), names)  # noqa: S102
    with pytest.raises(NotImplementedError, match=r"^Task 9\.1: f$"):
        names["f"](1)


def test_each_function_gets_its_own_stub() -> None:
    """Several tasks in one cell are told apart; the code between them stays."""
    solution = "def f(x): return 1\nk = 3\ndef h(x):\n    return 2\n"
    assert student_source(solution, {**TASKS, "h": "9.2"}) == (
        f'def f(x):\n{STUB}\nk = 3\ndef h(x):\n    raise NotImplementedError("Task 9.2: h")\n'
    )


def test_student_source_of_a_student_copy_is_itself() -> None:
    """A stub in place of a stub changes nothing."""
    once = student_source('def f(x):\n    """Double."""\n    return 2 * x\n', TASKS)
    assert student_source(once, TASKS) == once


def test_student_notebook_holds_no_outputs_no_counts_and_no_solution_cells() -> None:
    """What only the instructor should see is left out; tags of the other cells stay."""
    copy = student_notebook(solution_notebook("def f(x):\n    return secret", "f(1)"), TASKS)
    assert [cell.source for cell in copy.cells] == ["# Exercise", f"def f(x):\n{STUB}", "f(1)"]
    for cell in copy.cells[1:]:
        assert cell.outputs == []
        assert cell.execution_count is None
        assert cell.metadata.tags == ["task"]
    assert "secret" not in str(copy)


def test_student_notebook_leaves_the_solution_as_it_was() -> None:
    """The instructor's notebook is not changed by making the copy."""
    solution = solution_notebook("def f(x):\n    return 1")
    student_notebook(solution, TASKS)
    assert solution.cells[1].outputs
    assert "return 1" in solution.cells[1].source
    assert len(solution.cells) == 3


@pytest.mark.parametrize(
    "hidden",
    [
        "f = lambda x: 2 * x",
        "if True:\n    def f(x):\n        return 2 * x",
        "def g(x):\n    return x",
    ],
)
def test_answer_that_cannot_be_taken_out_is_refused(hidden: str) -> None:
    """A solution in another shape would be handed to the students as it is."""
    with pytest.raises(ValueError, match="must define f with def"):
        student_notebook(solution_notebook(hidden), TASKS)
    with pytest.raises(ValueError, match="must define f with def"):
        student_program(hidden, TASKS)


def test_function_in_a_solution_cell_alone_counts_as_missing() -> None:
    """The student needs a stub to fill in."""
    notebook = solution_notebook("def f(x):\n    return 1", tags=["solution"])
    with pytest.raises(ValueError, match="must define f with def"):
        student_notebook(notebook, TASKS)
