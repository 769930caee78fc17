"""The question bank of a student's copy: questions to read, keys salted and hashed.

A choice question keeps the hash of its right letter, and the feedback to each letter sealed with
that letter. A number cannot be found again from a hash, since answers near it are right too: it is
sealed with the salt alone, and so is an arrow. All this keeps a key from a glance and from a
search. It is no secret from a determined reader, who has this program and can try every letter:
the instructor's copy grades.
"""

from __future__ import annotations

import base64
import hashlib
import json
import tomllib
import zlib
from itertools import cycle
from string import ascii_lowercase
from typing import Any, TypeAlias

Table: TypeAlias = dict[str, Any]

SECRET = {
    "choice": ("option",),
    "numeric": ("value", "tolerance", "wrong_value", "right_feedback", "wrong_feedback"),
    "arrow": ("value", "wrong_value", "right_feedback", "wrong_feedback"),
}
"""What does not stand in a sealed question as it is, by its kind."""


def seal_quiz(toml: str) -> str:
    """Return a chapter's TOML text with the key and the feedback of each question sealed.

    Raises
    ------
    ValueError
        The text is not TOML.
    """
    table = tomllib.loads(toml)
    lines = [f"title = {_written(table['title'])}"]
    for kind in ("question", "predict"):
        for question in table.get(kind, []):
            lines += ["", f"[[{kind}]]"]
            lines += [f"{key} = {_written(value)}" for key, value in _sealed(question).items()]
    return "\n".join(lines) + "\n"


def open_question(question: Table) -> Table:
    """Return a question as it was before it was sealed; one that is not sealed, as it is."""
    if "salt" not in question:
        return question
    shown = {key: value for key, value in question.items() if key not in SEALED_KEYS}
    salt = f"{question['salt']} {question['id']}"
    if question["kind"] != "choice":
        secrets: Table = json.loads(_opened(question["sealed"], salt))
        return shown | secrets
    options: list[Table] = []
    for letter, text, sealed in zip(
        ascii_lowercase, question["options"], question["feedback"], strict=False
    ):
        option = {"text": text, "feedback": _opened(sealed, f"{salt} {letter}")}
        right = {"right": True} if _hash(f"{salt} {letter}") == question["key"] else {}
        options.append(option | right)
    return shown | {"option": options}


SEALED_KEYS = ("salt", "options", "key", "feedback", "sealed")
"""What stands in a sealed question instead."""


def _sealed(question: Table) -> Table:
    """Return a question with its secrets hashed and sealed, under a salt of its own."""
    secrets = {key: question[key] for key in SECRET[question["kind"]]}
    shown = {key: value for key, value in question.items() if key not in secrets}
    text = json.dumps(secrets, sort_keys=True)
    token = _hash(f"{question['id']} {text}")[:16]
    salt = f"{token} {question['id']}"
    if question["kind"] != "choice":
        return shown | {"salt": token, "sealed": _closed(text, salt)}
    options = question["option"]
    lettered = list(zip(ascii_lowercase, options, strict=False))
    (right,) = (letter for letter, option in lettered if option.get("right"))
    return shown | {
        "salt": token,
        "options": [option["text"] for option in options],
        "key": _hash(f"{salt} {right}"),
        "feedback": [_closed(o["feedback"], f"{salt} {letter}") for letter, o in lettered],
    }


def _written(value: Any) -> str:
    """Return a text, a number, a list or a table of them as TOML."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_written(key)} = {_written(v)}" for key, v in value.items()) + "}"
    return json.dumps(value, ensure_ascii=False)


def _hash(text: str) -> str:
    """Return a hash of a text."""
    return hashlib.sha256(f"key {text}".encode()).hexdigest()


def _closed(text: str, key: str) -> str:
    """Return a text under a key."""
    return base64.b64encode(_laid_over(zlib.compress(text.encode()), key)).decode()


def _opened(sealed: str, key: str) -> str:
    """Return the text under a key."""
    return zlib.decompress(_laid_over(base64.b64decode(sealed), key)).decode()


def _laid_over(packed: bytes, key: str) -> bytes:
    """Return bytes with a key laid over them, or taken off again."""
    mask = hashlib.sha512(key.encode()).digest()
    return bytes(a ^ b for a, b in zip(packed, cycle(mask), strict=False))
