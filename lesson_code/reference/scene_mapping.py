"""Coefficients for other engines: values that give each pair ours by the engine's own rule.

An engine combines the coefficients of two bodies by a rule of its own. Often each body can be given
a value that this rule turns into what ours makes of the pair; then nothing has to be set contact by
contact, which costs a call for each.

==================  ==================  ==================  ===============================
ours                theirs              given               because
==================  ==================  ==================  ===============================
product             product             a                   a b = a b
geometric mean      product             sqrt(a)             sqrt(a) sqrt(b) = sqrt(a b)
smaller             product             a, if 0 or 1        min(a, 1) = a 1
smaller             larger              a, if all are a     min(a, a) = max(a, a)
==================  ==================  ==================  ===============================
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from typing import TypeAlias

from lesson_code.engine.core import capacity as room
from lesson_code.engine.core.broad_phase import bound, most_pairs
from lesson_code.engine.core.mixing import RULES, UNSPECIFIED, MixingRule, mixed
from lesson_code.engine.core.scene import Body, Material, Scene
from lesson_code.engine.core.tables import BROAD_PHASES, broad_phase_for, world_of

Pairs: TypeAlias = set[tuple[float, float]]


def coefficients(combine: MixingRule, a: Material, b: Material) -> tuple[float, float]:
    """Return the restitution and the friction of a pair, by our rule.

    Examples
    --------
    >>> coefficients(MixingRule("min", "max"), Material(0.4, 0.5), Material(0.8))
    (0.4, 0.5)
    """
    return (
        mixed(RULES[combine.restitution], *_held(a.restitution, b.restitution)),
        mixed(RULES[combine.friction], *_held(a.friction, b.friction)),
    )


def own_values(
    bodies: Sequence[Body], ours: MixingRule, theirs: MixingRule
) -> list[tuple[float, float]] | None:
    """Return a restitution and a friction for each body that make another rule equal to ours.

    They do so to the last bit, for all pairs of bodies that can push one another.

    Parameters
    ----------
    bodies : sequence of Body
        All bodies of a scene.
    ours : MixingRule
        How a pair's coefficients are to come from its bodies'.
    theirs : MixingRule
        What the other engine makes of the values that it is given.

    Returns
    -------
    list of (float, float), or None
        None: there are no such values among those that are tried.

    Examples
    --------
    A ball on a floor that leaves its friction to the ball; the other engine takes products.

    >>> from lesson_code.geometry.shapes import Circle, Segment
    >>> floor = Body(Segment((-5, 0), (5, 0)))
    >>> ball = Body(Circle(1.0), mass=1.0, material=Material(0.5, 0.25))
    >>> own_values([floor, ball], MixingRule(), MixingRule("product", "product"))
    [(1.0, 1.0), (0.5, 0.25)]
    """
    restitution = _values(
        [_or_unspecified(body.material.restitution) for body in bodies],
        bodies,
        RULES[ours.restitution],
        RULES[theirs.restitution],
    )
    friction = _values(
        [_or_unspecified(body.material.friction) for body in bodies],
        bodies,
        RULES[ours.friction],
        RULES[theirs.friction],
    )
    if restitution is None or friction is None:
        return None
    return list(zip(restitution, friction, strict=True))


def refuse_heap(scene: Scene) -> None:
    """Refuse bodies heaped into one another: pymunk would go on until the memory is full.

    Raises
    ------
    ValueError
        The bodies are heaped into one another.
    """
    count = len(scene.bodies)
    if math.comb(count, 2) <= most_pairs(count):
        return  # however they lie
    world = world_of(scene, dt=1.0, iterations=0, combine=MixingRule())
    bound(world)
    room.refuse_heap(count, BROAD_PHASES[broad_phase_for(scene)](world))


def _values(
    stated: list[float], bodies: Sequence[Body], ours: int, theirs: int
) -> list[float] | None:
    """Return a value for each body's coefficient with which their rule is ours."""
    pairs = _pairs_that_meet(stated, [body.is_static for body in bodies])
    for given in _candidates(set(stated)):
        if all(mixed(ours, a, b) == mixed(theirs, given[a], given[b]) for a, b in pairs):
            return [given[value] for value in stated]
    return None


def _candidates(stated: set[float]) -> list[dict[float, float]]:
    """Return the candidates for replacing each value, the simplest first.

    One that is left open becomes 1, 0, or the only one that is stated.
    """
    said = stated - {UNSPECIFIED}
    fills = [1.0, 0.0, *(said if len(said) == 1 else ())]
    filled = [{v: fill if v == UNSPECIFIED else v for v in stated} for fill in fills]
    roots = [{v: math.sqrt(value) for v, value in given.items()} for given in filled]
    return filled + roots


def _pairs_that_meet(stated: list[float], static: list[bool]) -> Pairs:
    """Return the values of all pairs of bodies of which at least one can be pushed."""
    count = Counter(stated)
    free = {value for value, fixed in zip(stated, static, strict=True) if not fixed}
    return {(a, b) for a in free for b in count if a != b or count[a] > 1}


def _held(a: float | None, b: float | None) -> tuple[float, float]:
    """Return two coefficients as our tables hold them."""
    return _or_unspecified(a), _or_unspecified(b)


def _or_unspecified(coefficient: float | None) -> float:
    """Return a coefficient; one that is left to the other body as our tables hold it."""
    return UNSPECIFIED if coefficient is None else coefficient
