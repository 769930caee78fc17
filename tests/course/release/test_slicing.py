"""What is kept of a module: some names, what they use, and nothing else."""

from __future__ import annotations

import pytest

from lesson_code.course.release.slicing import all_needed, sliced, used_names

MODULE = '''"""About this module."""

from __future__ import annotations

import math
from fractions import Fraction, gcd

LIMIT = 2.0
"""What the limit is for."""

OTHER = 3.0
"""What the other is for."""


def shown(x):
    """Say something."""
    return _helper(x) * LIMIT


def _helper(x):
    return math.sqrt(x)


def hidden(x):
    return Fraction(x) + OTHER


def decorated(f):
    return f


@decorated
def marked():
    return 1


TASKS = (hidden, shown)
'''


def test_slice_holds_what_a_name_uses_and_nothing_else() -> None:
    """Helpers, constants with their docstrings and imports come along; the rest does not."""
    kept = sliced(MODULE, {"shown"})
    for wanted in (
        "def shown",
        "def _helper",
        "LIMIT = 2.0",
        "What the limit is for",
        "import math",
    ):
        assert wanted in kept
    for left in ("hidden", "OTHER", "the other", "Fraction", "gcd", "TASKS", "marked"):
        assert left not in kept


def test_slice_runs_by_itself() -> None:
    """What is kept is a module that works."""
    names: dict[str, object] = {}
    exec(sliced(MODULE, {"shown", "marked"}), names)  # noqa: S102 - the text above
    assert names["shown"](9.0) == 6.0  # type: ignore[operator]
    assert names["marked"]() == 1  # type: ignore[operator]


def test_slice_of_nothing_is_the_modules_docstring() -> None:
    """It still says what it is about."""
    assert sliced(MODULE, set()).splitlines() == [
        '"""About this module."""',
        "",
        "from __future__ import annotations",
    ]


def test_slice_of_an_unknown_name_is_refused() -> None:
    """Nothing is silently left out."""
    with pytest.raises(ValueError, match="absent is not defined in this module"):
        sliced(MODULE, {"absent"})


def test_used_names_are_found_behind_both_ways_to_import() -> None:
    """A module under another name, and a name of a module; other packages do not count."""
    code = "from p.q import a as b\nfrom p.q.c import d\nfrom p.r import e\nb.x(b.y, d, e.z)"
    assert used_names(code, {"p.q.a", "p.q.c"}) == {"p.q.a": {"x", "y"}, "p.q.c": {"d"}}


def test_what_is_needed_follows_names_through_modules() -> None:
    """One name uses b of one module, which uses c of another one."""
    sources = {
        "p.one": "from p.two import b\n\n\ndef a():\n    return b()\n",
        "p.two": "from p import three\n\n\ndef b():\n    return three.c\n\n\ndef left(): ...\n",
        "p.three": "c = 1\nd = 2\n",
    }
    assert all_needed(sources, {"p.one": {"a"}}) == {
        "p.one": {"a"}, "p.two": {"b"}, "p.three": {"c"},
    }  # fmt: skip
