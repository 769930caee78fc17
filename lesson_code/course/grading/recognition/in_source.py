"""Slips: small mistakes that a machine makes in a right answer, to find one in a wrong answer.

A sign, a factor of 2, another body's quantity, a missing bracket: nobody can list where each may
happen in each task. Here they are made in every right answer that the course knows of a task (its
solution and the unusual ones), one at a time, by rewriting its syntax tree; and in what goes into
the right formula and comes out of it. Each becomes a wrong model like those that a chapter lists:
its name is the kind of the slip, its docstring and its hint are made from the place.
"""

from __future__ import annotations

import ast
import inspect
import re
import textwrap
from collections.abc import Callable, Collection, Iterator
from dataclasses import dataclass, field
from functools import partial
from types import CodeType
from typing import Any, TypeAlias

from lesson_code.course.grading.recognition.borders import at_borders
from lesson_code.course.grading.recognition.edits import OPPOSITE, edits, parts_of
from lesson_code.course.grading.recognition.hints import HINTS, SAYS, UNNAMED
from lesson_code.course.grading.recognition.mixed_up import mixed_up
from lesson_code.course.grading.recognition.sizes import of_signs, of_sizes
from lesson_code.course.grading.recognition.steps import TOOLS, in_loops, steps
from lesson_code.course.grading.recognition.trees import Edit
from lesson_code.course.grading.task import Function, WrongModel
from lesson_code.course.isolation.inside.vectors import unwarned

MOST_ROUNDS = 200
"""Rounds of loops in one call of a slip, where a right answer makes few: a slip may make a loop
that never ends."""


Place: TypeAlias = tuple[str, dict[str, str], Callable[[], None], Callable[[], None]]
"""The kind of a slip, names, what makes it in a tree and what takes it back."""


EditsOf: TypeAlias = Callable[[ast.AST, ast.AST], Iterator[Edit]]
"""Yields what may stand in the place of a node below another."""


class TooManyRoundsError(ArithmeticError):
    """Raised in a slip whose loops do not end."""


@dataclass
class RightAnswer:
    """A right answer whose source may be rewritten, and the names that it uses."""

    definition: ast.FunctionDef
    names: dict[str, Any]
    most_rounds: int = field(default=MOST_ROUNDS, init=False)
    rounds: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        self.definition.decorator_list, self.definition.returns = [], None
        self.definition.name = "slip"
        self.names = {**self.names, **TOOLS, "count_round": self._count_round}
        for argument in self.definition.args.args:
            argument.annotation = None
        for node in ast.walk(self.definition):
            if isinstance(node, ast.For | ast.While):
                node.body.insert(0, ast.parse("count_round()").body[0])

    @property
    def parameters(self) -> list[str]:
        """The names of the arguments."""
        return [argument.arg for argument in self.definition.args.args]

    def _count_round(self) -> None:
        self.rounds += 1
        if self.rounds > self.most_rounds:
            raise TooManyRoundsError("its loops do not end")

    def compiled(self) -> CodeType:
        """Return the code of the answer as it is rewritten now."""
        tree = ast.Module([self.definition], type_ignores=[])
        try:
            return compile(tree, "<slip>", "exec")
        except TypeError:  # a new node has no line yet
            return compile(ast.fix_missing_locations(tree), "<slip>", "exec")

    def function(self, code: CodeType, **others: Function) -> Function:
        """Return the function that some code defines, with others in the place of some it calls."""
        made: dict[str, Any] = {}
        exec(code, {**self.names, **others}, made)  # noqa: S102 - the course's own source

        def slip(*arguments: Any) -> Any:
            self.rounds = 0
            with unwarned(invalid="raise", divide="raise"):  # LAPACK prints what it cannot use
                return made["slip"](*arguments)

        return slip


def of_function(function: Function) -> RightAnswer:
    """Return a function of the course as an answer whose source may be rewritten."""
    definition = ast.parse(textwrap.dedent(inspect.getsource(function))).body[0]
    if not isinstance(definition, ast.FunctionDef):
        raise TypeError(f"function must be defined by def, got {function.__name__}")
    return RightAnswer(definition, function.__globals__)


def slips_in(
    answer: RightAnswer, task: str, kinds: Collection[str] = tuple(HINTS)
) -> Iterator[WrongModel]:
    """Yield a wrong model for each slip of some kinds in the source of an answer."""
    yield from _made(answer, task, _places(answer, kinds))


def rarer_slips_in(answer: RightAnswer, task: str) -> Iterator[WrongModel]:
    """Yield a wrong model for each slip about borders, sizes and the course of things."""
    yield from _made(answer, task, rarer_changes(answer))


def _made(answer: RightAnswer, task: str, places: Iterator[Place]) -> Iterator[WrongModel]:
    """Yield the wrong model that is made in each of some places."""
    for kind, names, put, take_back in places:
        put()
        try:
            code = answer.compiled()
        except (SyntaxError, ValueError, TypeError):
            continue
        finally:
            take_back()
        yield model(task, kind, answer.function(code), names)


def pairs_in(
    answer: RightAnswer, task: str, first: Collection[str], second: Collection[str]
) -> Iterator[tuple[WrongModel, WrongModel]]:
    """Yield pairs of slips, one of some kinds and one of others; the second holds both."""
    for kind, names, put, take_back in list(_places(answer, first)):
        put()
        try:
            one = model(task, kind, answer.function(answer.compiled()), names)
            both = list(slips_in(answer, task, second))
        except (SyntaxError, ValueError, TypeError):
            continue
        finally:
            take_back()
        yield from ((one, other) for other in both)


def model(task: str, kind: str, function: Function, names: dict[str, str]) -> WrongModel:
    """Return a slip as a wrong model."""
    says = HINTS[kind].format_map({**UNNAMED, **names})
    first = f"{says.partition('. ')[0]}."
    is_name = any(name and first.startswith(name) for name in names.values())
    function.__doc__ = first if is_name else first[0].upper() + first[1:]
    function.__name__ = kind
    return WrongModel(task, function, SAYS + says)


def _places(answer: RightAnswer, kinds: Collection[str]) -> Iterator[Place]:
    """Yield each slip as what makes it in the tree and what takes it back.

    A slip that may be made in several places of the same shape, such as the divisor in the lines
    for both bodies, is made in each and in all of them.
    """
    yield from _edited(answer, _edits_in(answer), kinds)
    if "sequence" in kinds:
        yield from _exchanged_steps(answer)


def _edits_in(answer: RightAnswer) -> EditsOf:
    """Return what yields the slips at a node of an answer, of which it knows the names."""
    used = {node.id for node in ast.walk(answer.definition) if isinstance(node, ast.Name)}
    known = used | {*answer.parameters}
    return lambda node, parent: edits(node, parent, known)


def rarer_changes(answer: RightAnswer) -> Iterator[Place]:
    """Yield each slip about borders, sizes, what comes before what, and what is taken for what."""
    for edits_of in (at_borders, of_sizes, in_loops):
        yield from _edited(answer, edits_of, HINTS)
    for kind, put, take_back in steps(answer.definition):
        yield kind, {}, put, take_back
    yield from _edited(answer, _outside_comparisons(answer, mixed_up), HINTS)
    for alike in (_edits_in(answer), of_signs):
        yield from _in_statements(answer, alike)


def _outside_comparisons(answer: RightAnswer, edits_of: EditsOf) -> EditsOf:
    """Return what yields the same slips, but none in what is compared.

    There they change no number of an answer, but only on which side a few calls are.
    """
    compared = {
        id(part)
        for node in ast.walk(answer.definition)
        if isinstance(node, ast.Compare)
        for part in ast.walk(node)
    }
    return lambda node, parent: iter(()) if id(node) in compared else edits_of(node, parent)


def _edited(
    answer: RightAnswer,
    edits_of: EditsOf,
    kinds: Collection[str],
) -> Iterator[Place]:
    """Yield each slip of some kinds at a node, and those at nodes of the same shape together."""
    alike: dict[str, list[Place]] = {}
    for _, shape, place in _at_nodes(answer, edits_of, kinds):
        alike.setdefault(shape, []).append(place)
        yield place
    yield from (_all_of(places) for places in alike.values() if len(places) > 1)


def _in_statements(answer: RightAnswer, edits_of: EditsOf) -> Iterator[Place]:
    """Yield slips in all places of one statement, and in sums and differences of one shape."""
    everywhere: dict[str, int] = {}
    alike: dict[tuple[int, str], list[tuple[str, Place]]] = {}
    statements = _statements(answer.definition)
    for node, shape, place in _at_nodes(answer, edits_of, HINTS):
        everywhere[shape] = everywhere.get(shape, 0) + 1
        for here in {0, statements.get(id(node), 0)}:
            alike.setdefault((here, shape.replace("Sub()", "Add()")), []).append((shape, place))
    for found in alike.values():
        shapes = {shape for shape, _ in found}
        if len(shapes) > 1 or 1 < len(found) < sum(map(everywhere.__getitem__, shapes)):
            yield _all_of([place for _, place in found])


def _at_nodes(
    answer: RightAnswer,
    edits_of: EditsOf,
    kinds: Collection[str],
) -> Iterator[tuple[ast.AST, str, Place]]:
    """Yield each slip of some kinds at a node, with the node and the shape of the slip."""
    for parent in list(ast.walk(answer.definition)):
        for node, put in _children(parent):
            shape = ""
            for number, (kind, names, other) in enumerate(edits_of(node, parent)):
                if kind in kinds:
                    shape = shape or _shape(node)
                    ast.fix_missing_locations(other)  # a line; all others have theirs
                    shown = _shown(names, answer)
                    place = kind, shown, partial(put, other), partial(put, node)
                    yield node, f"{kind} {number} {shape}", place


def _statements(definition: ast.FunctionDef) -> dict[int, int]:
    """Return by the id of each node in which statement it is, conditions left out."""
    simple = (ast.Assign, ast.AugAssign, ast.Return, ast.Expr)
    found = [node for node in ast.walk(definition) if isinstance(node, simple)]
    return {id(part): number for number, node in enumerate(found, 1) for part in ast.walk(node)}


def _exchanged_steps(answer: RightAnswer) -> Iterator[Place]:
    """Yield each two statements after each other that give names to values, the other way round."""
    for node in ast.walk(answer.definition):
        body: Any = getattr(node, "body", ())
        for first in range(len(body) - 1) if isinstance(body, list) else ():
            if all(isinstance(x, ast.Assign | ast.AugAssign) for x in body[first : first + 2]):
                exchange = partial(_exchange, body, first)
                yield "sequence", {}, exchange, exchange


def _exchange(body: list[ast.stmt], first: int) -> None:
    body[first], body[first + 1] = body[first + 1], body[first]


def _all_of(places: list[Place]) -> Place:
    """Return some slips as one."""

    def put() -> None:
        for place in places:
            place[2]()

    def take_back() -> None:
        for place in reversed(places):
            place[3]()

    return places[0][0], {}, put, take_back


def _shape(node: ast.AST) -> str:
    """Return a node as text that is the same for either of a pair of names."""
    return re.sub(
        r"id='\w+'", lambda found: "".join(map(_sideless, parts_of(found[0]))), ast.dump(node)
    )


def _sideless(part: str) -> str:
    return "#" if part in OPPOSITE else part


def _children(parent: ast.AST) -> Iterator[tuple[ast.AST, Callable[[ast.AST], None]]]:
    """Yield the nodes right below a node, each with what puts another one in its place."""
    for name, value in list(ast.iter_fields(parent)):
        if isinstance(value, ast.AST):
            yield value, partial(setattr, parent, name)
        elif isinstance(value, list):
            for index, item in enumerate(value):
                if isinstance(item, ast.AST):
                    yield item, partial(value.__setitem__, index)


def _shown(names: dict[str, str], answer: RightAnswer) -> dict[str, str]:
    """Return names as a hint shows them, if all are of arguments, which the reader knows."""
    if not names or not set(names.values()) <= set(answer.parameters):
        return {}
    forms = {"of": " ({})", "by": " by {}"}
    return {key: forms.get(key, "{}").format(name) for key, name in names.items()}
