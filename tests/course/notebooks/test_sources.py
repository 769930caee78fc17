"""Notebooks from sources: the normal form is the same on every run and every machine."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import nbformat
import pytest
from nbformat.v4 import (
    new_code_cell,
    new_markdown_cell,
    new_notebook,
    new_output,
    new_raw_cell,
)

from lesson_code.course.notebooks.sources import (
    KERNELSPEC,
    WIDGET_VIEW,
    executed,
    is_solution,
    normal,
    notebook_from,
    sources,
    text_of,
)

SOURCE = """\
# ---
# jupyter:
#   kernelspec:
#     display_name: My kernel
#     name: mine
# ---

# %% [markdown]
# # Größe, 1 µm
#
# Text.

# %% tags=["nbval-check-output"] collapsed=true
import sys
print("one")
print("two")
print("oops", file=sys.stderr)

# %%
1 + 1

# %%
1 + 1

# %%
x = 3
"""


@pytest.fixture
def source(tmp_path: Path) -> Path:
    """Return a source in a workbook's folder of notebooks."""
    return written(tmp_path / "notebooks" / "source" / "07_sweep.py", SOURCE)


def written(path: Path, text: str) -> Path:
    """Write a file and the folders above it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return path


def notebook_with(*outputs: Any, **metadata: Any) -> Any:
    """Return a notebook of one executed code cell."""
    cell = new_code_cell("f()", outputs=list(outputs), execution_count=41, metadata=metadata)
    return new_notebook(cells=[cell])


def ids(notebook: Any) -> list[str]:
    """Return the ids of a notebook's cells."""
    return [cell.id for cell in notebook.cells]


def test_notebook_from_source_is_the_same_bytes_twice(source: Path) -> None:
    """Jupytext gives random cell ids; the normal form gives the same ones each time."""
    assert text_of(notebook_from(source)) == text_of(notebook_from(source))


def test_normal_form_of_the_normal_form_is_itself(source: Path) -> None:
    """To normalise twice changes nothing."""
    once = notebook_from(source)
    assert text_of(normal(copy.deepcopy(once), exercise=None)) == text_of(once)


def test_notebook_is_valid_and_reads_back_as_it_was_written(source: Path) -> None:
    """Nbformat accepts the file, and finds in it what was put there."""
    notebook = notebook_from(source)
    read = nbformat.reads(text_of(notebook), as_version=4)
    nbformat.validate(read)
    assert text_of(read) == text_of(notebook)
    assert "Größe, 1 µm" in text_of(notebook)
    assert text_of(notebook).endswith("}\n")


def test_keys_are_sorted_whatever_order_a_notebook_has_them_in(source: Path) -> None:
    """A difference between two versions is a difference in what they hold."""
    notebook = notebook_from(source)
    shuffled = {key: notebook[key] for key in reversed(notebook)}
    assert list(shuffled) != list(notebook)
    assert text_of(shuffled) == text_of(notebook)


def test_cell_ids_are_unique_and_stay_when_other_cells_move() -> None:
    """An id comes from the cell's own text; a repeated cell gets a number after it."""
    a, b = new_code_cell("a = 1"), new_markdown_cell("a = 1")
    one = ids(normal(new_notebook(cells=[a, b, new_code_cell("a = 1")]), None))
    two = ids(normal(new_notebook(cells=[new_raw_cell("new"), b, a]), None))
    assert len(set(one)) == 3
    assert one[2] == f"{one[0]}-2"
    assert two[1:] == [one[1], one[0]]


def test_cell_ids_of_many_equal_cells_are_valid() -> None:
    """A hundred equal cells have a hundred ids that nbformat accepts."""
    notebook = normal(new_notebook(cells=[new_code_cell("") for _ in range(100)]), None)
    nbformat.validate(notebook)
    assert len(set(ids(notebook))) == 100


def test_metadata_keeps_kernel_language_and_tags_only(source: Path) -> None:
    """Whatever else a front end writes into a notebook is left out."""
    notebook = notebook_from(source)
    assert notebook.metadata == {"kernelspec": KERNELSPEC, "language_info": {"name": "python"}}
    assert [cell.metadata for cell in notebook.cells] == [
        {},
        {"tags": ["nbval-check-output"]},
        {},
        {},
        {},
    ]


def test_execution_times_and_empty_tags_are_left_out() -> None:
    """Nbclient stores when each cell ran; that would differ on every run."""
    notebook = notebook_with(execution={"iopub.execute_input": "2026-01-01"}, tags=[])
    assert normal(notebook, None).cells[0].metadata == {}


def test_solution_names_its_exercise(tmp_path: Path) -> None:
    """The grader finds the exercise in the notebook itself, however the file is called."""
    source = written(tmp_path / "solutions" / "source" / "07_sweep.py", SOURCE)
    assert is_solution(source)
    assert notebook_from(source).metadata["workbook"] == {"exercise": "07_sweep"}


def test_neighbouring_pieces_of_one_stream_are_joined() -> None:
    """Where a stream is cut depends on the machine's mood; joined, it does not."""
    streams = [("stdout", "a"), ("stdout", "b"), ("stderr", "!"), ("stdout", "c"), ("stdout", "d")]
    outputs = [new_output("stream", name=name, text=text) for name, text in streams]
    picture = new_output("display_data", data={"image/png": ""})
    outputs.insert(4, picture)
    joined = normal(notebook_with(*outputs), None).cells[0].outputs
    assert [(o.get("name"), o.get("text")) for o in joined] == [
        ("stdout", "ab"),
        ("stderr", "!"),
        ("stdout", "c"),
        (None, None),
        ("stdout", "d"),
    ]


def test_widget_views_are_left_out_and_the_rest_of_the_bundle_stays() -> None:
    """A stored widget would show an error; its picture and text are for those who only read."""
    data = {WIDGET_VIEW: {"model_id": "8f0c"}, "image/png": "aGk=", "text/plain": "Figure: hi"}
    metadata = {"image/png": {"alt": "hi"}}
    output = new_output("display_data", data=data, metadata=metadata)
    kept = normal(notebook_with(output), None).cells[0].outputs[0]
    assert kept.data == {"image/png": "aGk=", "text/plain": "Figure: hi"}
    assert kept.metadata == metadata


def test_counts_follow_the_cells_and_are_null_without_outputs() -> None:
    """Nbval compares the cells that have a count, and a count needs outputs to compare."""
    result = new_output("execute_result", data={"text/plain": "2"}, execution_count=9)
    cells = [new_code_cell("x = 1"), new_markdown_cell("."), new_code_cell("2", outputs=[result])]
    first, _, second = normal(new_notebook(cells=cells), None).cells
    assert (first.execution_count, second.execution_count) == (None, 2)
    assert second.outputs[0].execution_count is None


def test_executed_notebook_is_run_in_its_folder_and_again_in_normal_form(source: Path) -> None:
    """The one run in a kernel: outputs are there, joined, and hold no execution metadata."""
    (source.parents[1] / "here.txt").touch()
    with source.open("a", encoding="utf-8") as file:
        file.write("\n# %%\nimport pathlib\nprint(pathlib.Path('here.txt').exists())\n")
    notebook = executed(notebook_from(source), source.parents[1])
    nbformat.validate(notebook)
    assert notebook.cells[1].outputs[0].text == "one\ntwo\n"
    assert notebook.cells[2].outputs[0].data["text/plain"] == "2"
    assert notebook.cells[-1].outputs[0].text == "True\n"
    assert ids(notebook) == ids(notebook_from(source))
    assert "iopub" not in text_of(notebook)
    assert json.loads(text_of(notebook))["metadata"]["language_info"] == {"name": "python"}


def test_sources_come_in_the_order_of_chapters_notebooks_first(tmp_path: Path) -> None:
    """Every source has its notebook one folder up."""
    for name in (
        "solutions/source/01_b.py",
        "notebooks/source/02_c.py",
        "notebooks/source/01_a.py",
    ):
        written(tmp_path / name, "")
    written(tmp_path / "notebooks" / "source" / "readme.txt", "")
    found = [notebook.relative_to(tmp_path).as_posix() for _, notebook in sources(tmp_path)]
    assert found == ["notebooks/01_a.ipynb", "notebooks/02_c.ipynb", "solutions/01_b.ipynb"]


def test_workbook_without_sources_has_none(tmp_path: Path) -> None:
    """An empty folder yields nothing, and no error."""
    assert list(sources(tmp_path)) == []


def test_tags_fold_cells() -> None:
    """Of an answer code and output are folded, of plumbing the code; text has no output."""
    notebook = notebook_with(tags=["answer"])
    notebook.cells.append(new_code_cell("import x", metadata={"tags": ["plumbing"]}))
    notebook.cells.append(new_markdown_cell("So.", metadata={"tags": ["answer"]}))
    assert [cell.metadata["jupyter"] for cell in normal(notebook, None).cells] == [
        {"source_hidden": True, "outputs_hidden": True},
        {"source_hidden": True},
        {"source_hidden": True},
    ]
