"""Slips in the course of a calculation: what comes first, how often, and from which values."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator
from copy import deepcopy
from functools import partial
from itertools import chain
from typing import Literal, TypeAlias

from lesson_code.course.grading.recognition.trees import Edit, like, name_of, names_in

Change: TypeAlias = tuple[str, Callable[[], None], Callable[[], None]]
"""The kind of a slip, what makes it in a tree, and what takes it back."""

OLD = "old_value"
"""Begins the name of a value that is kept from before; no right answer uses it."""

TOOLS = {"kept": deepcopy}
"""What slips call, beside what an answer knows."""

Loop: TypeAlias = ast.For | ast.While
FIRST_FALSE = "next((at_ for at_, one_ in enumerate(a) if not b[0]), None)"

MOVED = ast.Assign | ast.AugAssign | ast.If | ast.For | ast.While | ast.Expr


def in_loops(node: ast.AST, parent: ast.AST) -> Iterator[Edit]:
    """Yield what may stand in the place of a node by a slip about how a loop goes on."""
    match node:
        case ast.Continue():
            yield "break_off", {}, ast.Break()
        case ast.Break():
            yield "break_off", {}, ast.Continue()
        case ast.If(test=test, body=body, orelse=[]) if isinstance(parent, Loop):
            yield "break_off", {}, ast.If(test, body, [ast.Break()])
            yield "only_one", {}, ast.If(test, [*body, ast.Break()], [])
        case ast.If(test=test, body=body, orelse=[_, *_] as other):
            both = [ast.If(test, body, []), *other]
            yield "gate", {}, ast.If(ast.Constant(True), both, [])
    if isinstance(node, ast.expr) and not isinstance(node, ast.Compare) and _is_asked(node, parent):
        for decided in (ast.UnaryOp(ast.Not(), node), ast.Constant(True), ast.Constant(False)):
            yield "gate", {}, decided
    match node:
        case ast.comprehension(target=target, iter=source, ifs=[test], is_async=0):
            one = ast.Name("one_", ast.Load())
            kept = ast.ListComp(
                test, [ast.comprehension(target, ast.List([one], ast.Load()), [], 0)]
            )
            until = like(FIRST_FALSE, source, kept)
            yield (
                "break_off",
                {},
                ast.comprehension(target, like("list(a)[:b]", source, until), [], 0),
            )
    if isinstance(parent, ast.For | ast.comprehension) and node is parent.iter:
        for kind, part in (
            ("count", "[1:]"), ("count", "[:-1]"), ("only_one", "[:1]"), ("only_one", "[-1:]"),
            ("sequence", "[::-1]"),
        ):  # fmt: skip
            yield kind, {}, like(f"list(a){part}", node)


def _is_asked(node: ast.expr, parent: ast.AST) -> bool:
    """Return whether a node is a condition."""
    if isinstance(parent, ast.If | ast.IfExp):
        return node is parent.test
    return isinstance(parent, ast.comprehension) and node in parent.ifs


def steps(definition: ast.FunctionDef) -> Iterator[Change]:
    """Yield each slip about the order of statements, and about the age of values."""
    for node in ast.walk(definition):
        for body in (getattr(node, "body", None), getattr(node, "orelse", None)):
            if isinstance(body, list) and body:
                yield from _exchanged(body)
                yield from _split(body)
                yield from _worked_out_again(body)
                for place, statement in enumerate(body):
                    if isinstance(statement, Loop):
                        yield from _across(body, place, statement)
                    yield from _stale(body, place, body[place + 1 :], statement)
                    yield from _made_from(statement, body[place + 1 :])


def _exchanged(body: list[ast.stmt]) -> Iterator[Change]:
    """Yield each statement right after the next one, or after all others."""
    last = len(body) - isinstance(body[-1], ast.Return)
    for first in range(last - 1):
        if isinstance(body[first], MOVED):
            for to in {first + 1, last - 1}:
                if isinstance(body[to], MOVED):
                    yield (
                        "sequence",
                        partial(_move, body, first, to),
                        partial(_move, body, to, first),
                    )


def _move(body: list[ast.stmt], start: int, end: int) -> None:
    body.insert(end, body.pop(start))


def _split(body: list[ast.stmt]) -> Iterator[Change]:
    """Yield values that get their names at once, one after the other, where that counts."""
    for place, statement in enumerate(body):
        match statement:
            case ast.Assign(targets=[ast.Tuple(elts=names)], value=ast.Tuple(elts=values)):
                each = [
                    ast.Assign([name], value) for name, value in zip(names, values, strict=True)
                ]
                for order in (each, each[::-1]):
                    once = ast.If(ast.Constant(True), list(order), [])
                    put = partial(body.__setitem__, place, once)
                    yield "updated", put, partial(body.__setitem__, place, statement)


def _worked_out_again(body: list[ast.stmt]) -> Iterator[Change]:
    """Yield two values of which the second is worked out from the first as it is by then."""
    for place, statement in enumerate(body):
        for name, first, second in _one_by_one(statement):
            whole = _depending(body[:place], name)
            run = _depending(body[_start_of_run(body, place) : place], name)
            for again in [whole, run] if run != whole else [whole]:
                once = ast.If(ast.Constant(True), [first, *again, second], [])
                put = partial(body.__setitem__, place, once)
                yield "updated", put, partial(body.__setitem__, place, statement)


def _one_by_one(statement: ast.stmt) -> Iterator[tuple[str, ast.stmt, ast.stmt]]:
    """Yield two values that are found at once as one under a name, and the other after that."""
    match statement:
        case ast.Assign(targets=[ast.Tuple(elts=[a, b])], value=ast.Tuple(elts=[one, other])):
            for first, value, later, another in ((a, one, b, other), (b, other, a, one)):
                yield _base(first), ast.Assign([first], value), ast.Assign([later], another)
        case ast.Return(value=ast.Tuple(elts=[one, other])):
            for value, rest, place in ((one, other, 0), (other, one, 1)):
                for name in sorted({part.id for part in names_in(value)}):
                    both: list[ast.expr] = [rest]
                    both.insert(place, ast.Name(name, ast.Load()))
                    kept = ast.Assign([ast.Name(name, ast.Store())], value)
                    yield name, kept, ast.Return(ast.Tuple(both, ast.Load()))


def _start_of_run(body: list[ast.stmt], place: int) -> int:
    """Return where the statements begin that only give names to values, up to a place."""
    while place > 0 and isinstance(body[place - 1], ast.Assign):
        place -= 1
    return place


def _depending(before: list[ast.stmt], name: str) -> list[ast.stmt]:
    """Return the statements that give names to values which depend on a name."""
    depending = {name}
    found: list[ast.stmt] = []
    for statement in before:
        if isinstance(statement, ast.Assign):
            changed = _changed_names(statement)
            if name not in changed and depending & {part.id for part in names_in(statement)}:
                depending |= {*changed}
                found.append(statement)
    return found


def _across(body: list[ast.stmt], place: int, loop: Loop) -> Iterator[Change]:
    """Yield each step of a loop done once before it, and each before it done in every round."""
    for inside, step in enumerate(loop.body):
        if isinstance(step, ast.Assign | ast.AugAssign):
            yield (
                "stale",
                partial(_shift, loop.body, inside, body, place),
                partial(_shift, body, place, loop.body, inside),
            )
    for before, step in enumerate(body[:place]):
        if isinstance(step, ast.Assign):
            yield (
                "anew",
                partial(_shift, body, before, loop.body, 1),
                partial(_shift, loop.body, 1, body, before),
            )
    for changed in ast.walk(loop):
        if isinstance(changed, ast.Assign | ast.AugAssign):
            yield from _stale(body, place, [loop], changed)


def _shift(source: list[ast.stmt], start: int, target: list[ast.stmt], end: int) -> None:
    target.insert(end, source.pop(start))


def _stale(
    body: list[ast.stmt], place: int, users: list[ast.stmt], changed: ast.stmt
) -> Iterator[Change]:
    """Yield what uses a value as it was before a place, though a statement has changed it."""
    changes: list[Change] = []
    for name in _changed_names(changed):
        read = [
            found
            for user in users
            for part in _parts(user)
            for found in [[each for each in names_in(part) if each.id == name]]
            if found
        ]
        for some in [*read, [*chain.from_iterable(read)]] if len(read) > 1 else read:
            keep = partial(_keep, body, place, name, some)
            yield "stale", keep, partial(_take_back, body, place, name, some)
        if read:
            everywhere = [*chain.from_iterable(read)]
            keep = partial(_keep, body, place, name, everywhere)
            changes.append(("stale", keep, partial(_take_back, body, place, name, everywhere)))
    if len(changes) > 1:
        yield "stale", partial(_each, changes, 1), partial(_each, changes[::-1], 2)


def _each(changes: list[Change], way: Literal[1, 2]) -> None:
    """Make all of some slips, or take them back."""
    for change in changes:
        change[way]()


def _made_from(made: ast.stmt, users: list[ast.stmt]) -> Iterator[Change]:
    """Yield what uses, for a value that is made by adding to another, that other one."""
    for name, first in _sources(made):
        found = [[each for each in names_in(part) if each.id == name] for part in _all_parts(users)]
        in_users = [[each for each in _read(user) if each.id == name] for user in users]
        for some in [*found, *in_users, list(chain.from_iterable(found))]:
            if some:
                yield "stale", partial(_rename, some, first), partial(_rename, some, name)


def _sources(made: ast.stmt) -> list[tuple[str, str]]:
    """Return the names that a statement gives to sums, each with that which its sum begins with."""
    match made:
        case ast.Assign(targets=[ast.Tuple(elts=targets)], value=ast.Tuple(elts=values)):
            pairs = list(zip(targets, values, strict=True))
        case ast.Assign(targets=[target], value=value):
            pairs = [(target, value)]
        case _:
            return []
    return [
        (name_of(target), name_of(value.left))
        for target, value in pairs
        if isinstance(value, ast.BinOp) and isinstance(value.op, ast.Add | ast.Sub)
        if name_of(target) and name_of(value.left) not in ("", name_of(target))
    ]


def _all_parts(users: list[ast.stmt]) -> list[ast.AST]:
    return [part for user in users for part in _parts(user)]


def _read(user: ast.stmt) -> list[ast.Name]:
    return [name for part in _parts(user) for name in names_in(part)]


def _rename(users: list[ast.Name], name: str) -> None:
    for user in users:
        user.id = name


def _changed_names(statement: ast.stmt) -> list[str]:
    """Return the names of values that a statement changes."""
    targets: list[ast.expr] = []
    match statement:
        case ast.AugAssign(target=target):
            targets = [target]
        case ast.Assign(targets=[ast.Tuple(elts=elements)]):
            targets = elements
        case ast.Assign(targets=targets):
            pass
    return [name for name in map(_base, targets) if name]


def _base(target: ast.expr) -> str:
    """Return the name of a value that is written to, as a whole or in part."""
    return name_of(target.value if isinstance(target, ast.Subscript) else target)


def _parts(statement: ast.stmt) -> Iterator[ast.AST]:
    """Yield the simple statements and the conditions in a statement."""
    for node in ast.walk(statement):
        match node:
            case ast.If(test=part) | ast.While(test=part) | ast.For(iter=part):
                yield part
            case ast.Assign() | ast.AugAssign() | ast.Return() | ast.Expr():
                yield node


def _keep(body: list[ast.stmt], place: int, name: str, users: list[ast.Name]) -> None:
    kept = like("kept(a)", ast.Name(name, ast.Load()))
    body.insert(place, ast.Assign([ast.Name(f"{OLD}_{name}", ast.Store())], kept))
    _rename(users, f"{OLD}_{name}")


def _take_back(body: list[ast.stmt], place: int, name: str, users: list[ast.Name]) -> None:
    body.pop(place)
    _rename(users, name)
