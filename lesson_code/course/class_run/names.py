"""Names that students choose: shown so that they forge nothing, and safe for files and sheets.

A name may hold path separators, formulas, line ends, marks that turn the direction of writing, or
bytes that are no text. JSON keeps all but the last; everywhere else one of these forms stands.
"""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Callable, Iterable

LONGEST_SHOWN = 80
"""Characters of a name that are shown."""

LONGEST_STEM = 40
"""Characters of a name that go into the name of a file."""

LIKE_A_DIGEST = re.compile(r"(^|-)[0-9a-f]{8}$")
"""How the other names of files end, so that none that a student chooses is one of them."""

RESERVED = (
    "con",
    "prn",
    "aux",
    "nul",
    *(f"{port}{n}" for port in ("com", "lpt") for n in range(10)),
)
"""Names that Windows gives to devices."""

FORMULA_STARTS = ("=", "+", "-", "@", "\uff1d", "\uff0b", "\uff0d", "\uff20")
"""What makes a spreadsheet take a cell for a formula; the last four are the wide forms."""


def shown(name: str) -> str:
    r"""Return a name in a line, with all that is no visible character written out.

    Examples
    --------
    >>> shown("Zo\u00eb"), shown("a\u202eb\n")
    ('Zoë', 'a<U+202E>b<U+000A>')
    """
    line = visible(name)
    return line if len(line) <= LONGEST_SHOWN else f"{line[: LONGEST_SHOWN - 3]}..."


def encodable(text: str) -> str:
    r"""Return a text that UTF-8 can write: bytes that are no text are written out.

    >>> encodable("Zo\u00eb\udcff")
    'Zoë<U+DCFF>'
    """
    if text.isascii():
        return text
    return "".join(f"<U+{ord(c):04X}>" if "\ud800" <= c <= "\udfff" else c for c in text)


def told_apart(names: Iterable[str], form: Callable[[str], str]) -> dict[str, str]:
    """Return a form of each name, no two of them the same.

    A name that is its own form keeps it; of others with one form, the later have a number.

    Examples
    --------
    >>> told_apart(["ADA", "Ada", "ada"], str.lower)
    {'ADA': 'ada-2', 'Ada': 'ada-3', 'ada': 'ada'}
    """
    forms = {name: form(name) for name in names}
    taken = {name for name, written in forms.items() if written == name}
    for name, written in forms.items():
        number, free = 1, written
        while name != written and free in taken:
            number += 1
            free = f"{written}-{number}"
        taken.add(free)
        forms[name] = free
    return forms


def visible(text: str) -> str:
    r"""Return a text of any length in one line, with all that cannot be seen written out.

    >>> visible("one\ntwo")
    'one<U+000A>two'
    """
    return "".join(c if c.isprintable() else f"<U+{ord(c):04X}>" for c in text)


def file_stem(name: str) -> str:
    """Return a name for a file that belongs to a student: plain letters, with a short digest.

    Two names may share it; :func:`told_apart` gives the second of them a number.

    Examples
    --------
    >>> file_stem("ada")
    'ada'
    >>> file_stem("../../Ada")
    'ada-64ac56a4'
    """
    plain = unicodedata.normalize("NFKD", name).encode("ascii", "ignore").decode().lower()
    stem = re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:LONGEST_STEM]
    if stem and stem == name and not LIKE_A_DIGEST.search(stem) and stem not in RESERVED:
        return stem
    digest = hashlib.sha256(name.encode("utf-8", "surrogatepass")).hexdigest()[:8]
    return f"{stem}-{digest}" if stem else digest


def sheet_text(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula.

    Examples
    --------
    >>> sheet_text("=1+1"), sheet_text("Ada")
    ("'=1+1", 'Ada')
    """
    return f"'{text}" if text.lstrip().startswith(FORMULA_STARTS) else text


def same_name(name: str) -> str:
    """Return the form of a name under which two ways to write it are the same.

    Examples
    --------
    >>> same_name("Zoe\u0308") == same_name("ZO\u00cb")
    True
    """
    return unicodedata.normalize("NFC", name.strip()).casefold()
