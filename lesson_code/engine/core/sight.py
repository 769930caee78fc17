"""How far bodies see: from where on a contact is seen, and how far one may move unwatched."""

from __future__ import annotations

from typing import NamedTuple

from lesson_code.engine.core.constants import REACH


class Sight(NamedTuple):
    """Two parts of a body's width.

    Attributes
    ----------
    skin : float
        How far from its surface contacts are seen already.
    reach : float
        How far it may move in a step unwatched.
    """

    skin: float = 0.0
    reach: float = REACH


NO_SKIN = Sight()
"""Contacts are seen as soon as bodies overlap."""
