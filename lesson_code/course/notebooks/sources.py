"""Notebooks made from their sources.

Each notebook has one source, a script in the percent format in the folder ``source`` beside it.
From it the notebook is made, run and written in a normal form that is the same on every
machine: fixed cell ids, no execution times, no paths, no widget state.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

KERNELSPEC = {"display_name": "Python 3 (ipykernel)", "language": "python", "name": "python3"}
FOLDED = {
    "answer": {"source_hidden": True, "outputs_hidden": True},
    "plumbing": {"source_hidden": True},
}
"""What a cell's tag folds: the answer to a prediction, until it is made; imports and plotting."""

WIDGET_VIEW = "application/vnd.jupyter.widget-view+json"
FOLDERS = ("notebooks", "solutions")


def sources(root: Path) -> Iterator[tuple[Path, Path]]:
    """Yield each source in a workbook and the notebook made from it, in the order of chapters."""
    for folder in FOLDERS:
        for source in sorted((root / folder / "source").glob("*.py")):
            yield source, root / folder / f"{source.stem}.ipynb"


def is_solution(source: Path) -> bool:
    """Return whether a source is that of a solution, from which a student copy is made."""
    return source.parent.parent.name == "solutions"


def notebook_from(source: Path) -> Any:
    """Return the notebook that a source describes, without outputs, in normal form."""
    import jupytext

    notebook = jupytext.read(source, fmt="py:percent")
    return normal(notebook, exercise=source.stem if is_solution(source) else None)


def executed(notebook: Any, folder: Path) -> Any:
    """Return the notebook with its outputs, run top to bottom in a fresh kernel.

    Raises
    ------
    nbclient.exceptions.CellExecutionError
        A cell failed.
    """
    from nbclient import NotebookClient

    client = NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(folder)}})
    client.execute()
    return normal(notebook, exercise=notebook.metadata.get("workbook", {}).get("exercise"))


def normal(notebook: Any, exercise: str | None) -> Any:
    """Return the notebook in normal form, changed in place."""
    notebook.metadata.clear()
    notebook.metadata["kernelspec"] = dict(KERNELSPEC)
    notebook.metadata["language_info"] = {"name": "python"}
    if exercise:
        notebook.metadata["workbook"] = {"exercise": exercise}
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    seen: dict[str, int] = {}
    count = 0
    for cell in notebook.cells:
        cell.metadata = type(cell.metadata)(_kept_metadata(cell))
        cell["id"] = _cell_id(cell, seen)
        if cell.cell_type == "code":
            count += 1
            cell.execution_count = count if cell.outputs else None
            cell.outputs = [_normal_output(output) for output in _joined(cell.outputs)]
    return notebook


def _kept_metadata(cell: Any) -> dict[str, Any]:
    """Return a cell's tags, and how JupyterLab folds it because of them."""
    tags = cell.metadata.get("tags", [])
    folded = {key: True for tag in tags for key in FOLDED.get(tag, {})}
    if cell.cell_type == "markdown":
        folded.pop("outputs_hidden", None)
    return {key: kept for key, kept in (("tags", tags), ("jupyter", folded)) if kept}


def _cell_id(cell: Any, seen: dict[str, int]) -> str:
    """Return an id that depends on the cell's text alone, so that it stays when others move."""
    digest = hashlib.sha256(f"{cell.cell_type}\n{cell.source}".encode()).hexdigest()[:12]
    seen[digest] = seen.get(digest, 0) + 1
    return digest if seen[digest] == 1 else f"{digest}-{seen[digest]}"


def _joined(outputs: list[Any]) -> Iterator[Any]:
    """Yield outputs with neighbouring pieces of the same stream made one."""
    last = None
    for output in outputs:
        is_stream = output.output_type == "stream"
        if is_stream and last is not None and last.get("name") == output.name:
            last.text += output.text
            continue
        last = output if is_stream else None
        yield output


def _normal_output(output: Any) -> Any:
    """Return an output without what differs from run to run."""
    if "execution_count" in output:
        output.execution_count = None
    if "data" in output:
        output.data.pop(WIDGET_VIEW, None)
    return output


def text_of(notebook: Any) -> str:
    """Return a notebook as the text of its file."""
    return json.dumps(notebook, ensure_ascii=False, indent=1, sort_keys=True) + "\n"
