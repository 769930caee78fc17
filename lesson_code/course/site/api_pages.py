"""The pages of the public names: Sphinx writes them from the docstrings."""

from __future__ import annotations

import inspect
from importlib import import_module
from pathlib import Path

MODULES = (
    "lesson_code",
    "lesson_code.formulas",
    "lesson_code.geometry",
    "lesson_code.evidence",
    "lesson_code.course.grading",
)
"""Modules of which every name in ``__all__`` may be relied on."""

FOLDER = "api"

PAGE = """# {module}

```{{eval-rst}}
{entries}
```
"""


def write_api_pages(folder: Path) -> list[str]:
    """Write a page for each module into Sphinx's sources, and return the pages' names."""
    (folder / FOLDER).mkdir()
    for module in MODULES:
        (folder / FOLDER / f"{module}.md").write_text(api_page(module), encoding="utf-8")
    return [f"{FOLDER}/{module}" for module in MODULES]


def api_page(module: str) -> str:
    """Return the page of a module: what each of its public names is, in their order.

    >>> print(api_page("lesson_code.course.grading"))
    # lesson_code.course.grading
    <BLANKLINE>
    ```{eval-rst}
    .. autofunction:: lesson_code.course.grading.check_task
    ```
    <BLANKLINE>
    """
    loaded = import_module(module)
    entries = (_entry(module, name, getattr(loaded, name)) for name in loaded.__all__)
    return PAGE.format(module=module, entries="\n\n".join(entries))


def _entry(module: str, name: str, value: object) -> str:
    """Return what lets Sphinx describe a name; the index leads to the first page that does."""
    first = next(m for m in MODULES if getattr(import_module(m), name, None) is value)
    described = f".. auto{_kind(value)}:: {module}.{name}"
    return described if first == module else f"{described}\n   :no-index:"


def _kind(value: object) -> str:
    """Return what Sphinx calls a name of this value."""
    if inspect.isclass(value):
        return "exception" if issubclass(value, Exception) else "class"
    return "function" if inspect.isroutine(value) else "data"
