"""Lanes, as Numba compiles them: four numbers, four indices, four conditions, four records.

What :mod:`lesson_code.engine.compiled.lanes` says of one visit is compiled for four. Where an index
is four indices, a table gives four records, a field of these is four numbers, and what is computed
from them is computed by one instruction. LLVM divides it where a processor has narrower ones.

References
----------
LLVM Language Reference, Vector Type; Numba documentation, Low-level extension API.
"""

from __future__ import annotations

import operator
from collections.abc import Callable
from typing import Any

from llvmlite import ir
from numba.core import cgutils, types
from numba.core.imputils import (
    RefType,
    iternext_impl,
    lower_builtin,
    lower_getattr_generic,
    lower_setattr_generic,
)
from numba.core.typing.templates import (
    AbstractTemplate,
    AttributeTemplate,
    infer_getattr,
    infer_global,
    signature,
)
from numba.extending import intrinsic, models, overload, register_model
from numba.np import arrayobj

from lesson_code.engine.compiled.lanes import LANES, everywhere, in_lanes, where

NUMBER, WIDTH = 8, 8 * LANES
"""Bytes of a number, and of as many as there are lanes."""


class Lanes(types.Type):
    """The type of four numbers, indices or conditions."""


NUMBERS, INDICES, CONDITIONS = (Lanes(f"four {of}") for of in ("numbers", "indices", "conditions"))
ELEMENTS = {NUMBERS: ir.DoubleType(), INDICES: ir.IntType(64), CONDITIONS: ir.IntType(1)}


class Records(types.Type):
    """The type of four records of a table."""

    def __init__(self, record: types.Record) -> None:
        self.record = record
        super().__init__(name=f"four {record}")


class Turns(types.SimpleIteratorType):  # type: ignore[misc, name-defined]
    """The type of a loop that takes four turns at once."""


TURNS = Turns("turns in lanes", INDICES)


@register_model(Lanes)
class LanesModel(models.PrimitiveModel):
    """A vector, as LLVM calls it."""

    def __init__(self, manager: Any, kind: Any) -> None:
        super().__init__(manager, kind, ir.VectorType(ELEMENTS[kind], LANES))


@register_model(Records)
class RecordsModel(models.PrimitiveModel):
    """Where each of the records is."""

    def __init__(self, manager: Any, kind: Any) -> None:
        place = manager.lookup(kind.record).get_value_type()
        super().__init__(manager, kind, ir.ArrayType(place, LANES))


@register_model(Turns)
class TurnsModel(models.StructModel):
    """Which turn comes next, and the one after the last."""

    def __init__(self, manager: Any, kind: Any) -> None:
        members = [("next", types.CPointer(types.intp)), ("end", types.intp)]
        super().__init__(manager, kind, members)


# Numbers


def _joined(builder: Any, values: list[Any]) -> Any:
    """Return four values as a vector."""
    vector = ir.Constant(ir.VectorType(values[0].type, LANES), ir.Undefined)
    for lane, value in enumerate(values):
        vector = builder.insert_element(vector, value, ir.IntType(32)(lane))
    return vector


def _each(builder: Any, vector: Any) -> list[Any]:
    """Return the four values of a vector."""
    return [builder.extract_element(vector, ir.IntType(32)(lane)) for lane in range(LANES)]


def _in_lanes(context: Any, builder: Any, value: Any, kind: Any, wanted: Any = NUMBERS) -> Any:
    """Return a value that is the same for all lanes, or has one for each already, as a vector."""
    if isinstance(kind, Lanes):
        return value
    scalar = types.float64 if wanted is NUMBERS else types.intp
    return _joined(builder, LANES * [context.cast(builder, value, kind, scalar)])


def _learn(operation: Any, result: Lanes, build: Callable[[Any, list[Any]], Any]) -> None:
    """Teach Numba an operation on numbers in lanes, or on such and on a number for all of them."""

    class Typed(AbstractTemplate):
        def generic(self, given: Any, _by_name: Any) -> Any:
            fits = all(kind is NUMBERS or isinstance(kind, types.Number) for kind in given)
            return signature(result, *given) if fits and NUMBERS in given else None

    def lower(context: Any, builder: Any, typed: Any, given: Any) -> Any:
        pairs = zip(given, typed.args, strict=True)
        return build(builder, [_in_lanes(context, builder, value, kind) for value, kind in pairs])

    infer_global(operation)(Typed)
    for kinds in ((Lanes,), (Lanes, Lanes), (Lanes, types.Number), (types.Number, Lanes)):
        lower_builtin(operation, *kinds)(lower)


for add in (operator.add, operator.iadd):
    _learn(add, NUMBERS, lambda builder, given: builder.fadd(*given))
for subtract in (operator.sub, operator.isub):
    _learn(subtract, NUMBERS, lambda builder, given: builder.fsub(*given))
_learn(operator.mul, NUMBERS, lambda builder, given: builder.fmul(*given))
_learn(operator.truediv, NUMBERS, lambda builder, given: builder.fdiv(*given))
_learn(operator.neg, NUMBERS, lambda builder, given: builder.fneg(*given))


def _compared(sign: str) -> Callable[[Any, list[Any]], Any]:
    return lambda builder, given: builder.fcmp_ordered(sign, *given)


def _extreme(sign: str) -> Callable[[Any, list[Any]], Any]:
    """Return what chooses as Python does: the second value if it is beyond the first."""
    return lambda builder, given: builder.select(
        builder.fcmp_ordered(sign, given[1], given[0]), given[1], given[0]
    )


_learn(operator.lt, CONDITIONS, _compared("<"))
_learn(operator.le, CONDITIONS, _compared("<="))
_learn(operator.gt, CONDITIONS, _compared(">"))
_learn(operator.ge, CONDITIONS, _compared(">="))
_learn(operator.eq, CONDITIONS, _compared("=="))
_learn(max, NUMBERS, _extreme(">"))
_learn(min, NUMBERS, _extreme("<"))


# Conditions


@infer_global(operator.and_)
class BothHold(AbstractTemplate):
    """Of two conditions."""

    def generic(self, given: Any, _by_name: Any) -> Any:
        """Return the signature for conditions in lanes."""
        return signature(CONDITIONS, *given) if given == (CONDITIONS, CONDITIONS) else None


@lower_builtin(operator.and_, Lanes, Lanes)  # type: ignore[untyped-decorator]
def _both_hold(_context: Any, builder: Any, _typed: Any, given: Any) -> Any:
    return builder.and_(*given)


@intrinsic
def _chosen(_context: Any, condition: Any, one: Any, other: Any) -> Any:
    """Return one number or the other in each lane."""

    def build(context: Any, builder: Any, typed: Any, given: Any) -> Any:
        numbers = zip(given[1:], typed.args[1:], strict=True)
        return builder.select(given[0], *[_in_lanes(context, builder, v, k) for v, k in numbers])

    return NUMBERS(condition, one, other), build


@intrinsic
def _all_hold(_context: Any, condition: Any) -> Any:
    """Return whether a condition holds in all lanes."""

    def build(_context: Any, builder: Any, _typed: Any, given: Any) -> Any:
        bits = ir.IntType(LANES)
        return builder.icmp_unsigned("==", builder.bitcast(given[0], bits), bits(2**LANES - 1))

    return types.boolean(condition), build


# Numba compares the names of both functions' arguments, and would compare annotations.

overload(where)(
    lambda condition, one, other: (  # noqa: ARG005
        (lambda condition, one, other: _chosen(condition, one, other))  # type: ignore[call-arg]
        if condition is CONDITIONS
        else (lambda condition, one, other: one if condition else other)
    )
)
overload(everywhere)(
    lambda condition: (
        (lambda condition: _all_hold(condition))  # type: ignore[call-arg]
        if condition is CONDITIONS
        else (lambda condition: condition)
    )
)


# Loops and tables


@infer_global(in_lanes)
class InLanes(AbstractTemplate):
    """A loop in lanes."""

    def generic(self, given: Any, _by_name: Any) -> Any:
        """Return the signature for where it begins and ends."""
        return signature(TURNS, *given)


@lower_builtin(in_lanes, types.Integer, types.Integer)  # type: ignore[untyped-decorator]
def _turns(context: Any, builder: Any, typed: Any, given: Any) -> Any:
    turns = cgutils.create_struct_proxy(TURNS)(context, builder)
    first, turns.end = (
        context.cast(builder, value, kind, types.intp)
        for value, kind in zip(given, typed.args, strict=True)
    )
    turns.next = cgutils.alloca_once_value(builder, first)
    return turns._getvalue()


@lower_builtin("iternext", Turns)  # type: ignore[untyped-decorator]
@iternext_impl(RefType.UNTRACKED)  # type: ignore[untyped-decorator]
def _next_turns(context: Any, builder: Any, _typed: Any, given: Any, result: Any) -> None:
    """Give the next four turns."""
    turns = cgutils.create_struct_proxy(TURNS)(context, builder, value=given[0])
    first = builder.load(turns.next)
    is_left = builder.icmp_signed("<", first, turns.end)
    result.set_valid(is_left)
    with builder.if_then(is_left):
        result.yield_(_joined(builder, [builder.add(first, first.type(k)) for k in range(LANES)]))
        builder.store(builder.add(first, first.type(LANES)), turns.next)


@infer_global(operator.add)
class Further(AbstractTemplate):
    """Indices, and how much further on."""

    def generic(self, given: Any, _by_name: Any) -> Any:
        """Return the signature for indices in lanes and a number."""
        fits = len(given) == 2 and given[0] is INDICES and isinstance(given[1], types.Integer)
        return signature(INDICES, *given) if fits else None


@lower_builtin(operator.add, Lanes, types.Integer)  # type: ignore[untyped-decorator]
def _further(context: Any, builder: Any, typed: Any, given: Any) -> Any:
    return builder.add(given[0], _in_lanes(context, builder, given[1], typed.args[1], INDICES))


@infer_global(operator.getitem)
class RecordsAt(AbstractTemplate):
    """The records of a table at four indices."""

    def generic(self, given: Any, _by_name: Any) -> Any:
        """Return the signature for a table and indices in lanes."""
        table, place = given
        fits = place is INDICES and isinstance(getattr(table, "dtype", None), types.Record)
        return signature(Records(table.dtype), *given) if fits else None


@lower_builtin(operator.getitem, types.Array, Lanes)  # type: ignore[untyped-decorator]
def _records_at(context: Any, builder: Any, typed: Any, given: Any) -> Any:
    table = arrayobj.make_array(typed.args[0])(context, builder, given[0])
    places = [builder.gep(table.data, [index]) for index in _each(builder, given[1])]
    return cgutils.pack_array(builder, places)


@infer_getattr
class FieldOfRecords(AttributeTemplate):
    """A field of four records."""

    key = Records

    def generic_resolve(self, records: Any, name: str) -> Any:  # type: ignore[override]
        """Return the kind of the field."""
        kind = records.record.typeof(name)
        return NUMBERS if kind == types.float64 else INDICES


def _field_places(context: Any, builder: Any, kind: Any, records: Any, name: str) -> list[Any]:
    """Return where the field is in each of the records."""
    data = context.get_data_type(kind.record.typeof(name))
    return [
        cgutils.get_record_member(builder, record, kind.record.offset(name), data)
        for record in cgutils.unpack_tuple(builder, records, LANES)
    ]


@lower_getattr_generic(Records)  # type: ignore[untyped-decorator]
def _field(context: Any, builder: Any, kind: Any, records: Any, name: str) -> Any:
    """Return the field of all records.

    Four fields side by side are read at once from each record: LLVM sees that most of them are
    wanted, and turns four by four numbers around.
    """
    place = kind.record.offset(name)
    begin = place - place % WIDTH
    if kind.record.typeof(name) == types.float64 and begin + WIDTH <= kind.record.size:
        four = ir.VectorType(ir.DoubleType(), LANES)
        rows = [
            builder.load(cgutils.get_record_member(builder, record, begin, four), align=NUMBER)
            for record in cgutils.unpack_tuple(builder, records, LANES)
        ]
        column = ir.IntType(32)((place - begin) // NUMBER)
        return _joined(builder, [builder.extract_element(row, column) for row in rows])
    places = _field_places(context, builder, kind, records, name)
    values = [builder.load(place) for place in places]
    if kind.record.typeof(name) != types.float64:
        values = [builder.sext(value, ir.IntType(64)) for value in values]
    return _joined(builder, values)


@lower_setattr_generic(Records)  # type: ignore[untyped-decorator]
def _set_field(context: Any, builder: Any, typed: Any, given: Any, name: str) -> None:
    """Write the field of all records."""
    places = _field_places(context, builder, typed.args[0], given[0], name)
    for place, value in zip(places, _each(builder, given[1]), strict=True):
        builder.store(value, place)
