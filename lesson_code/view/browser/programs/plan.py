"""The plan of effects: whether a scene calls for each effect, by the rule that Python's plan asks.

A page writes the rows of ``bodies`` and what ``facts`` says of the run, runs ``look``, and then the
entry that is named after an effect: ``finding`` is its answer. ``plan.js`` does all this. Machine
code has no words: those of the rules are told to the page in a list, and a finding holds a place
in it.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, get_type_hints

from lesson_code.engine.compiled.linker import link
from lesson_code.engine.compiled.program import Program
from lesson_code.engine.compiled.webassembly import WebProgram, table_program
from lesson_code.engine.effects.choice import EFFECTS
from lesson_code.engine.effects.collisions import where_bodies_meet
from lesson_code.engine.effects.facts import Seen, look
from lesson_code.engine.effects.question import Effect, Finding


@dataclass(slots=True)
class FindingRow:
    """A finding, with the place of its words in the list."""

    called_for: bool = False
    words: int = 0
    first: float = 0.0
    second: float = 0.0


Tables: type = NamedTuple("Tables", [*get_type_hints(Seen).items(), ("finding", FindingRow)])  # type: ignore[misc]
"""The tables that `look` works on, and the answer of a rule."""


class _Numbered(ast.NodeTransformer):
    """Replaces the words of findings by their places in a list."""

    def __init__(self, words: list[str]) -> None:
        self._words = words

    def visit_FunctionDef(self, node: ast.FunctionDef) -> ast.AST:
        """Leave out the docstring, which is no finding's."""
        if ast.get_docstring(node) is not None:
            del node.body[0]
        return self.generic_visit(node)

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """Write a finding out: two numbers, zero unless given."""
        self.generic_visit(node)
        if isinstance(node.func, ast.Name) and node.func.id == "Finding":
            given = [f"float({ast.unparse(number)})" for number in node.args[2:]]
            numbers = [*given, "0.0", "0.0"][:2]
            called_for, words = map(ast.unparse, node.args[:2])
            return ast.parse(f"({called_for}, {words}, {', '.join(numbers)})", mode="eval").body
        return node

    def visit_Attribute(self, node: ast.Attribute) -> ast.AST:
        """Read the verdict of a finding that is written out."""
        if node.attr == "called_for":
            return ast.Subscript(self.visit(node.value), ast.Constant(0), ast.Load())
        return node

    def visit_Constant(self, node: ast.Constant) -> ast.AST:
        """Return the place of words, which may be new."""
        if not isinstance(node.value, str):
            return node
        if node.value not in self._words:
            self._words.append(node.value)
        return ast.Constant(self._words.index(node.value))


def rule_entry(effect: Effect, words: list[str]) -> str:
    """Return the source that asks an effect's rule; its words go into the list."""
    entry: Callable[..., Finding] = effect.rule
    source = link(effect.rule)
    if effect.needs_collisions:
        entry, source = where_bodies_meet, link(where_bodies_meet, rule_of_effect=effect.rule)
    numbered = ast.unparse(_Numbered(words).visit(ast.parse(source)))
    fields = ", ".join(f"row.{field}" for field in FindingRow.__slots__)
    return "\n".join(
        [
            numbered,
            "def start(tables) -> None:",
            "    row = tables.finding",
            f"    {fields} = {entry.__name__}(tables.facts)",
        ]
    )


def plan_program() -> WebProgram:
    """Return the program that asks the rules of all effects."""
    seen = table_program(Tables, look)
    words: list[str] = []
    layout = seen.entries["look"].layout
    rules = {
        name: Program(rule_entry(effect, words), "start", layout)
        for name, effect in EFFECTS.items()
    }
    made = WebProgram({**seen.entries, **rules}, seen.about)
    return made.telling(plan={"effects": [*EFFECTS], "words": words})


PROGRAM = plan_program()
