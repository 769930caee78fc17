"""Linked sources that are kept: to link one takes a tenth of a second, to find one a hundredth.

A source is used again while every file that it was taken from is as it was, and every name that its
functions use stands for the same. That is told in words: a function by its module and name, a
constant by its value. Where something has no such words, nothing is kept.
"""

from __future__ import annotations

import hashlib
import inspect
import sys
import types
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from lesson_code.engine.compiled import library
from lesson_code.engine.compiled.linker import Linked, Read

LINKER = ("linker.py", "known.py", "sources.py")
"""The files beside this one that say how a program is linked."""


def find(entry: Callable[..., Any], bound: Mapping[str, Any]) -> Linked | None:
    """Return the source that was linked for a function, if it is kept and still current."""
    with suppress(WordlessError, KeyError, TypeError, AttributeError, OSError, UnicodeDecodeError):
        for about, text in library.read(_name(entry, bound)):
            modules = {name: vars(sys.modules[name]) for name in about["names"]}
            read: Read = [
                (modules[module], {name: modules[module][name] for name in names})
                for module, names in about["names"].items()
            ]
            is_same = _files(modules) == about["files"] and _words(read) == about["names"]
            if is_same:
                return Linked(text.decode(), read)
    return None


def keep(entry: Callable[..., Any], bound: Mapping[str, Any], linked: Linked) -> None:
    """Keep the source that was linked for a function, if that can be done."""
    with suppress(WordlessError, OSError):
        names = _words(linked.read)
        about = {"files": _files(names), "names": names}
        library.write(library.place_to_write(), _name(entry, bound), about, linked.text.encode())


class WordlessError(Exception):
    """Something cannot be told in words that mean the same in another process."""


def in_words(value: Any) -> str:
    """Return words for a value, the same in every process that has the same files.

    Raises
    ------
    WordlessError
        There are none: it is a function inside another, or an object of some other kind.

    Examples
    --------
    >>> in_words((in_words, None, 0.1))
    '(lesson_code.engine.compiled.sources.in_words, None, 0.1)'
    """
    if value is None or isinstance(value, (bool, int, float, str)):
        return repr(value)
    if isinstance(value, tuple):
        return f"({', '.join(map(in_words, value))})"
    if isinstance(value, types.ModuleType):
        return value.__name__
    if isinstance(value, (type, types.FunctionType, types.BuiltinFunctionType)):
        words = f"{value.__module__}.{value.__qualname__}"
        if "<" not in words:  # else it is a lambda, or inside a function
            return words
    raise WordlessError(f"there are no words for {value!r}")


def _words(read: Read) -> dict[str, dict[str, str]]:
    """Return what all names stand for, in words, by their modules."""
    told: dict[str, dict[str, str]] = {}
    for module, names in read:
        of_module = told.setdefault(module["__name__"], {})
        of_module |= {name: in_words(value) for name, value in names.items()}
    return told


def _files(modules: Iterable[str]) -> dict[str, list[int]]:
    """Return when the files of modules and of the linker were changed, and how long they are."""
    paths = [Path(str(sys.modules[name].__file__)) for name in modules]
    paths += [Path(__file__).with_name(name) for name in LINKER]
    stats = {str(path): path.stat() for path in paths}
    return {path: [stat.st_mtime_ns, stat.st_size] for path, stat in stats.items()}


def _name(entry: Callable[..., Any], bound: Mapping[str, Any]) -> str:
    """Return the name of a source's file."""
    words = {name: in_words(value) for name, value in sorted(bound.items())}
    told = __file__, sys.version, in_words(inspect.unwrap(entry)), words
    return "source_" + hashlib.sha256(repr(told).encode()).hexdigest()[:20]
