"""Vectors of two numbers, as Numba compiles them: what an equation asks of NumPy's.

An equation takes a vector's components apart, ``a[0]`` and ``a[1]``, puts them together by
``np.stack``, and adds, subtracts and scales whole vectors. An array would need memory from the
heap; two numbers do not.
"""

from __future__ import annotations

import operator
from typing import Any

import numpy as np
from numba.core import cgutils, types
from numba.extending import intrinsic, models, overload, register_model


class VectorType(types.Type):
    """The type of a vector."""

    def __init__(self) -> None:
        super().__init__(name="Vector")


VECTOR = VectorType()


@register_model(VectorType)
class VectorModel(models.StructModel):
    """Two numbers in memory."""

    def __init__(self, manager: Any, vector: Any) -> None:
        super().__init__(manager, vector, [("x", types.float64), ("y", types.float64)])


def _vector(_context: Any, x: Any, y: Any) -> Any:
    """Return the vector of two components."""

    def build(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
        made = cgutils.create_struct_proxy(VECTOR)(context, builder)
        made.x, made.y = (
            context.cast(builder, value, kind, types.float64)
            for value, kind in zip(arguments, signature.args, strict=True)
        )
        return made._getvalue()

    return VECTOR(x, y), build


vector: Any = intrinsic(_vector)


def note(_numbers: Any, _result: Any) -> int:
    """Write a result, a number or two, into a table of numbers; return how many they are."""
    raise NotImplementedError("only compiled programs note their results so")


def _component(_context: Any, of: Any, place: Any) -> Any:
    """Return a vector's component, 0 or 1."""
    name = ("x", "y")[place.literal_value]

    def build(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        value = cgutils.create_struct_proxy(VECTOR)(context, builder, value=arguments[0])
        return getattr(value, name)

    return types.float64(of, place), build


component: Any = intrinsic(prefer_literal=True)(_component)


def _is_vector(*kinds: Any) -> bool:
    return all(kind is VECTOR for kind in kinds)


def _is_pair(kind: Any) -> bool:
    return kind is VECTOR or (isinstance(kind, types.BaseTuple) and len(kind) == 2)


def _is_number(*kinds: Any) -> bool:
    return all(isinstance(kind, (types.Number, types.Boolean)) for kind in kinds)


# Numba compares the names of both functions' arguments, and would compare annotations.

overload(operator.getitem)(
    lambda a, place: (  # noqa: ARG005
        (lambda a, place: component(a, 0) if place == 0 else component(a, 1))
        if _is_vector(a)
        else None
    )
)
overload(np.stack)(
    lambda arrays: (
        (lambda arrays: vector(arrays[0], arrays[1]))
        if isinstance(arrays, types.UniTuple) and _is_number(arrays.dtype)
        else None
    )
)
overload(operator.add)(
    lambda a, b: (lambda a, b: vector(a[0] + b[0], a[1] + b[1])) if _is_vector(a, b) else None
)
overload(operator.sub)(
    lambda a, b: (lambda a, b: vector(a[0] - b[0], a[1] - b[1])) if _is_vector(a, b) else None
)
overload(operator.mul)(
    lambda a, b: (
        (lambda a, b: vector(a * b[0], a * b[1])) if _is_number(a) and _is_vector(b) else None
    )
)
overload(note)(
    lambda _numbers, _result: (
        _note_number if _is_number(_result) else _note_pair if _is_pair(_result) else None
    )
)


def _note_number(_numbers, _result):  # type: ignore[no-untyped-def]
    _numbers[0].value = _result
    return 1


def _note_pair(_numbers, _result):  # type: ignore[no-untyped-def]
    _numbers[0].value = _result[0]
    _numbers[1].value = _result[1]
    return 2
