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
from lesson_code.course.grading.recognition.mixed_up import mixed_up
from lesson_code.course.grading.recognition.sizes import of_sizes
from lesson_code.course.grading.recognition.steps import TOOLS, in_loops, steps
from lesson_code.course.grading.recognition.trees import Edit
from lesson_code.course.grading.task import Function, WrongModel
from lesson_code.course.isolation.inside.vectors import unwarned

HINTS = {
    "sign": "a sign is turned round. What is added there, what taken away, and which way is plus?",
    "minus": "everything has the opposite sign. Which way is plus, and who acts on whom?",
    "factor": "a factor of 2 is missing or is one too many. Where does each 2 or 1/2 come from?",
    "factor_missing": "one factor{of} is left out. Do the units on both sides still fit?",
    "divisor": "a division{by} is left out. Do the units on both sides still fit?",
    "quotient": "a product and a quotient are exchanged. Do the units on both sides still fit?",
    "product": "a sum and a product are exchanged. Do the units on both sides still fit?",
    "one_plus": "1 + something is taken for twice that. What comes of it at 0?",
    "projection": "a whole vector stands where its part along a direction counts. Which one is it?",
    "share": "both get one half, whatever the masses. Which of the two should get more?",
    "upside_down": "a quotient is upside down. What should happen as its parts grow?",
    "term": "one term of a sum is left out. Which parts make up the whole?",
    "precedence": "brackets are missing. What does the division or the product take in?",
    "power": "a power is left out. Which quantities are squared, and where is a root taken?",
    "power_more": "{name} is squared, or its root is left out. Which unit comes out?",
    "power_less": "the root of {name} is taken, or its square is left out. Which unit comes out?",
    "root": "one function is left out: a root, an exponential, a logarithm. Which unit comes out?",
    "absolute": "absolute values stand where signs count. Which way does each thing go?",
    "other": "{wrong} stands where {right} belongs. Whose quantity is wanted there?",
    "exchanged": "{first} and {second} are exchanged. Which belongs where?",
    "ignored": "{name} does not count. What should change with it?",
    "alike": "{first} and {second} count as equal. What should change where they differ?",
    "unchanged": "{name} comes back as it came in. What should have become of it?",
    "given": "{name} as they came in. What should have become of them?",
    "index": "a component is taken for another. Which of x and y belongs there?",
    "order": "what is returned stands in another order. What was asked for first?",
    "gate": "a condition is turned round or not asked. When should something happen at all?",
    "minmax": "a largest and a smallest are exchanged. Which of the two is wanted?",
    "sine": "a sine and a cosine are exchanged. What should come at angle 0?",
    "cross": "a cross product is a dot product, or its order is turned. What does each measure?",
    "condition": "one of several conditions is left out. When does each of them decide?",
    "once": "a loop runs only once. When has it done all that it should?",
    "sequence": "two steps stand in the other order. Which one needs what the other has changed?",
    "parts": "the part along the normal {normal}, that across it {along}. What should each do?",
    "and_or": "an `and` and an `or` are exchanged. Must all hold, or is one enough?",
    "count": "a count is off by one. What is the first, and what the last?",
    "step": "one step is left out. Is each name brought up to date where it should be?",
    "degrees": "an angle is in degrees where radians belong, or the other way round. Which is it?",
    "rounding": "the answer is rounded. Can you return the number as it was worked out?",
    "strict": "a border counts on the other side. What should happen just there?",
    "threshold": "something small counts as nothing, or does not. How small may it really be?",
    "whole": "a number becomes whole in another way. Is it up, down, or to the nearest?",
    "not_whole": "a number is left as it is where a whole one belongs. What is counted there?",
    "limit": "a limit bounds another quantity, one factor on or back. What may not grow beyond it?",
    "rounds": "a loop ends after so many rounds. What says that it is really done?",
    "nothing": "0 and None are exchanged. What does each of them say?",
    "length": "something else stands for the length of a vector. What would Pythagoras say?",
    "along": "a length, or one component, stands for the part along a direction. Which is it?",
    "one_sided": "a number counts on one side of 0 only. What should it do on the other side?",
    "squares": "a function of a sum is taken for a sum, or the reverse. Is (a + b)^2 a^2 + b^2?",
    "break_off": "one that does not count ends it all. What of those that follow?",
    "passed_over": "one of several is passed over, or a loop ends too soon. Which one is missing?",
    "only_one": "only the first, or the last, of several counts. What of the others?",
    "updated": "a new value is used where its old one belongs. Which is it at that moment?",
    "stale": "an old value is used where it has changed. Which is it at that moment?",
    "anew": "each round begins again with the first value. What should it go on with?",
    "infinite": "a large number stands for infinity. What is 1 over each of them?",
    "case": "one case is taken for another. What tells them apart?",
    "as_one": "{name} counts as 1. What should change with it?",
    "complement": "what {name} leaves of 1 stands in its place. Which of the two was asked for?",
    "scaled": "the answer has {name} as one factor more, or one less. Which unit comes out?",
    "no_answer": "something stands where None was asked for. What should say that there is none?",
    "base": "a power or a logarithm has another base. Which one belongs there?",
    "straight": "a straight line stands for a curve. Does it still hold far from 0?",
    "ratio": "a difference stands for a quotient. Which unit comes out?",
    "together": "two masses are put together in another way. What if one of them is very large?",
    "number": "a number in the formula is another one. Where does it come from?",
    "twice": "one factor or divisor counts twice. How often does it belong there?",
    "ends": "the first and the last stand for the smallest and the largest. Are they in order?",
    "columns": "two columns of {name} are exchanged. What stands in which?",
    "not_called": "what goes into a function stands where that belongs which comes out. Which one?",
    "fixed": "{name} counts as endless, so that its body never moves. What should move it?",
    "summed_up": "each value is added to those before. Is each asked for by itself?",
    "from_one": "numbers begin with 1. Which number has the first one in Python?",
    "direction": "{name} is changed along {along}. In which direction should it be changed?",
    "signs": "{first} and {second} go in with other signs. Does each sign say a direction?",
    "clamp": "one side of a limit is left out. Can the number also be too small, or too large?",
}
"""By kind what a slip does, and a question. Before it stands SAYS."""

UNNAMED = {
    "of": "", "by": "", "wrong": "one quantity", "right": "another", "first": "one quantity",
    "second": "another", "name": "one quantity", "normal": "becomes another",
    "along": "as well",
}  # fmt: skip
"""What stands in a hint for names that a reader does not know."""

SAYS = "Your numbers are just those of a right answer in which "

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
    yield from _in_statements(answer, _edits_in(answer))


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
