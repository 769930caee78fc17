"""Post-processing: what to call when bodies begin to touch, touch and part.

A callback receives the contacts of one pair of bodies at a time, as a :class:`Touch`. `begin`
and `pre_solve` come before the impulses and may change them; `post_solve` and `separate` come
after them. Visual effects and sound belong here.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, TypeAlias


@dataclass(slots=True)
class Touch:
    """Two bodies in contact during one step, as a callback sees them.

    Attributes
    ----------
    time : float
        End of the step, s. Before the impulses the solver with sub-steps gives the start of the
        step, where it finds contacts.
    body_a, body_b : int
        The bodies' places in the scene, a < b.
    normal : (float, float)
        Unit normal from a to b.
    points : tuple of (float, float)
        One or two contact points, midway between the two surfaces, m.
    penetration : float
        Of the deepest point, m; < 0 where the solver sees contacts before bodies touch.
    restitution, friction : float
        The pair's, >= 0; before the impulses a callback may set them for this step.
    ignored : bool
        Before the impulses a callback may set it: no impulse is applied in this step.
    normal_impulse, tangent_impulse : float
        What b received in this step, N s, summed over the points; 0 before the impulses.
        The tangent is the normal turned by +90 degrees.
    gravity : (float, float), optional
        A callback may set it, m/s^2: the gravity of the scene from the next step on.
    """

    time: float
    body_a: int
    body_b: int
    normal: tuple[float, float]
    points: tuple[tuple[float, float], ...]
    penetration: float
    restitution: float
    friction: float
    ignored: bool = False
    normal_impulse: float = 0.0
    tangent_impulse: float = 0.0
    gravity: tuple[float, float] | None = None


Callback: TypeAlias = Callable[[Touch], Any]


@dataclass(frozen=True)
class Callbacks:
    """The functions that a scene asks to have called; None: not called.

    Attributes
    ----------
    begin : callable, optional
        In the first step of a touch, before its impulses. Its settings hold for that step only;
        `pre_solve` is called in each.
    pre_solve : callable, optional
        In each step of a touch, before its impulses.
    post_solve : callable, optional
        In each step of a touch that is not ignored, after its impulses.
    separate : callable, optional
        In the first step without the touch. It receives the touch of the step before.

    Raises
    ------
    TypeError
        A callback cannot be called.

    Examples
    --------
    >>> sounds = []
    >>> callbacks = Callbacks(post_solve=lambda touch: sounds.append(touch.normal_impulse))
    >>> callbacks.wanted
    True
    """

    begin: Callback | None = None
    pre_solve: Callback | None = None
    post_solve: Callback | None = None
    separate: Callback | None = None

    def __post_init__(self) -> None:
        """Refuse a callback that cannot be called."""
        for name in ("begin", "pre_solve", "post_solve", "separate"):
            value = getattr(self, name)
            if value is not None and not callable(value):
                raise TypeError(f"{name} must be callable or None, got {value!r}")

    @property
    def wanted(self) -> bool:
        """Whether there is anything to call."""
        wanted = (self.begin, self.pre_solve, self.post_solve, self.separate)
        return any(callback is not None for callback in wanted)

    @property
    def may_change_impulses(self) -> bool:
        """Whether a callback comes before the impulses, and so may change them."""
        return self.begin is not None or self.pre_solve is not None
