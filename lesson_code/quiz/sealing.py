"""The question bank of a student's copy: every key and every feedback sealed, with a salt each.

What is asked stays readable; what is right, and what is said to an answer, does not. A seal keeps a
glance and a search from finding a key. It keeps no secret from a determined reader, who has this
program too: the instructor's copy grades.
"""

from __future__ import annotations

import base64
import hashlib
import json
import tomllib
import zlib
from itertools import cycle
from typing import Any

SECRET = {
    "choice": ("option",),
    "numeric": ("value", "tolerance", "wrong_value", "right_feedback", "wrong_feedback"),
}
"""What is sealed of a question, by its kind."""


def seal_chapter(toml: str) -> str:
    """Return a chapter's TOML text with the secrets of each question sealed.

    Raises
    ------
    ValueError
        The text is not TOML.
    """
    table = tomllib.loads(toml)
    lines = [f"title = {json.dumps(table['title'], ensure_ascii=False)}"]
    for question in table["question"]:
        lines += ["", "[[question]]"]
        for key, value in _sealed(question).items():
            lines.append(f"{key} = {json.dumps(value, ensure_ascii=False)}")
    return "\n".join(lines) + "\n"


def _sealed(question: dict[str, Any]) -> dict[str, Any]:
    """Return a question with its secrets under one seal."""
    hidden = {key: question[key] for key in SECRET[question["kind"]]}
    shown = {key: value for key, value in question.items() if key not in hidden}
    text = json.dumps(hidden, sort_keys=True).encode()
    salt = hashlib.sha256(b"salt" + question["id"].encode() + text).hexdigest()[:16]
    return shown | {"salt": salt, "sealed": _turned(zlib.compress(text), salt, question["id"])}


def open_question(question: dict[str, Any]) -> dict[str, Any]:
    """Return a question as it was before it was sealed; one that is not sealed, as it is."""
    if "sealed" not in question:
        return question
    packed = base64.b64decode(question["sealed"])
    secrets: dict[str, Any] = json.loads(
        zlib.decompress(_with_key(packed, question["salt"], question["id"]))
    )
    return {k: v for k, v in question.items() if k not in ("salt", "sealed")} | secrets


def _turned(packed: bytes, salt: str, name: str) -> str:
    """Return bytes under a key, as text."""
    return base64.b64encode(_with_key(packed, salt, name)).decode()


def _with_key(packed: bytes, salt: str, name: str) -> bytes:
    """Return bytes with a question's own key laid over them, or taken off again."""
    key = hashlib.sha512(f"{salt} {name}".encode()).digest()
    return bytes(a ^ b for a, b in zip(packed, cycle(key)))
