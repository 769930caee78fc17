"""What the tests of the grader share: the workbook, and submissions made on the spot."""

from __future__ import annotations

import ast
import inspect
import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeAlias

import pytest

from lesson_code.course.grading.grader import Grader
from lesson_code.course.grading.task import KnownAnswer
from lesson_code.course.isolation import Limits
from lesson_code.course.notebooks.root import find_root

Write: TypeAlias = Callable[..., Path]


@pytest.fixture(scope="session")
def root() -> Path:
    """Return the workbook's folder."""
    return find_root(Path(__file__).parent)


@pytest.fixture(scope="session")
def grader() -> Iterator[Grader]:
    """Yield a grader for all submissions that need no limits of their own."""
    with Grader() as started:
        yield started


@pytest.fixture(scope="session")
def quick() -> Limits:
    """Return limits that a call which hangs or takes memory meets soon."""
    return Limits(seconds_a_call=0.5, bytes_of_memory=600_000_000)


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Return a function that writes a submission: one text for a .py, cells for a notebook."""

    def write_submission(name: str, *sources: str, exercise: str | None = None) -> Path:
        path = tmp_path / name
        text = json.dumps(_notebook(sources, exercise)) if name.endswith(".ipynb") else sources[0]
        path.write_text(text, encoding="utf-8")
        return path

    return write_submission


def _notebook(sources: tuple[str, ...], exercise: str | None) -> dict[str, Any]:
    """Return a notebook of code cells."""
    return {
        "cells": [
            {
                "cell_type": "code",
                "execution_count": None,
                "id": f"cell-{number}",
                "metadata": {},
                "outputs": [],
                "source": source,
            }
            for number, source in enumerate(sources)
        ],
        "metadata": {"workbook": {"exercise": exercise}} if exercise else {},
        "nbformat": 4,
        "nbformat_minor": 5,
    }


def source_as_answer(model: KnownAnswer, function_name: str) -> str:
    """Return the model's source as a student would hand it in: undecorated, renamed, untyped."""
    tree = ast.parse(inspect.getsource(model.function))
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)
    definition.name, definition.decorator_list = function_name, []
    definition.returns = None
    for argument in definition.args.args:
        argument.annotation = None
    return ast.unparse(tree)
