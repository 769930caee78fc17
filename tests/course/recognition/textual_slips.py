"""Slips made in the text of a right answer, token by token: not by the recogniser's own means."""

from __future__ import annotations

import io
import tokenize
from collections.abc import Iterator
from random import Random

OPERATORS = {
    "+": (("sign", "-"),),
    "-": (("sign", "+"),),
    "*": (("quotient", "/"),),
    "/": (("quotient", "*"),),
    "<": (("gate", ">"),),
    "<=": (("gate", ">"),),
    ">": (("gate", "<"),),
    ">=": (("gate", "<"),),
}
NUMBERS = {"2": (("factor", "1"), ("factor", "4")), "0.5": (("factor", "1"),)}
NAMES = {
    "m1": (("other", "m2"),),
    "m2": (("other", "m1"),),
    "v1": (("other", "v2"),),
    "v2": (("other", "v1"),),
    "r1": (("other", "r2"),),
    "p2": (("other", "p1"),),
    "m_a": (("other", "m_b"),),
    "i_b": (("other", "i_a"),),
    "min": (("minmax", "max"),),
    "max": (("minmax", "min"),),
    "sin": (("sine", "cos"),),
    "cos": (("sine", "sin"),),
    "sqrt": (("root", ""),),
    "and": (("and_or", "or"),),
    "or": (("and_or", "and"),),
}


def textual_slips(source: str) -> list[tuple[str, str]]:
    """Return each slip in a function's text as its kind and the text with it."""
    lines = source.splitlines(keepends=True)
    found = []
    for token in _in_the_body(source):
        table = {tokenize.OP: OPERATORS, tokenize.NUMBER: NUMBERS, tokenize.NAME: NAMES}
        for kind, other in table.get(token.type, {}).get(token.string, ()):
            row, column = token.start
            line = lines[row - 1]
            changed = f"{line[:column]}{other}{line[token.end[1] :]}"
            text = "".join([*lines[: row - 1], changed, *lines[row:]])
            if _is_code(text):
                found.append((kind, text))
    return found


def two_slips(source: str, stream: Random) -> tuple[str, str] | None:
    """Return two slips in one text, with both kinds, or None where there are not two."""
    first = textual_slips(source)
    if not first:
        return None
    kind, text = stream.choice(first)
    again = textual_slips(text)
    other, text = stream.choice(again)
    return f"{kind} and {other}", text


def _in_the_body(source: str) -> Iterator[tokenize.TokenInfo]:
    """Yield the tokens below the line that defines the function."""
    depth = 0
    for token in tokenize.generate_tokens(io.StringIO(source).readline):
        depth += (token.type == tokenize.INDENT) - (token.type == tokenize.DEDENT)
        if depth:
            yield token


def _is_code(text: str) -> bool:
    """Return whether some text can be compiled."""
    try:
        compile(text, "<slip>", "exec")
    except (SyntaxError, ValueError):
        return False
    return True
