"""The rules of eight-ball: who has which balls, what is a foul, whose turn it is, who has won.

Balls 1 to 7 are solid, 9 to 15 striped. The first ball that is potted after the break decides who
has which. Whoever pots the 8 after all of their own wins; before that, or with a foul, loses.

References
----------
World Pool-Billiard Association, Rules of Play, 3: Eight Ball (2016), without called shots, and with
an 8 that is potted by the break put back.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

SOLIDS, STRIPES, EIGHT = frozenset(range(1, 8)), frozenset(range(9, 16)), 8


@dataclass(frozen=True)
class Shot:
    """What a stroke has done, once all balls lie still.

    Attributes
    ----------
    first : int or None
        The ball that the cue ball met first.
    potted : tuple of int
        The balls that have fallen, in order, without the cue ball.
    scratch : bool
        Whether the cue ball has fallen.
    cushion : bool
        Whether any ball has met a cushion after the first meeting.
    """

    first: int | None
    potted: tuple[int, ...] = ()
    scratch: bool = False
    cushion: bool = True


@dataclass(frozen=True)
class Match:
    """How a match stands before a stroke.

    Attributes
    ----------
    turn : int
        Who plays, 0 or 1.
    owner : int or None
        Who has the solids; None: the table is open.
    is_break : bool
        Whether the stroke is the first.
    foul : str
        What was wrong with the last stroke; "" where nothing was.
    winner : int or None
        Who has won.
    """

    turn: int = 0
    owner: int | None = None
    is_break: bool = True
    foul: str = ""
    winner: int | None = None

    def group(self, player: int) -> frozenset[int]:
        """Return the balls of a player; all but the 8 while the table is open."""
        if self.owner is None:
            return SOLIDS | STRIPES
        return SOLIDS if player == self.owner else STRIPES

    def wanted(self, left: Iterable[int]) -> frozenset[int]:
        """Return which balls the player has to meet first, of those on the table."""
        own = self.group(self.turn) & frozenset(left)
        return own or frozenset({EIGHT})


def foul_of(match: Match, shot: Shot, left: Iterable[int]) -> str:
    """Return what is wrong with a stroke, in words; `left` were on the table before it."""
    if shot.scratch:
        return "the cue ball fell"
    if shot.first is None:
        return "no ball was met"
    if not match.is_break and shot.first not in match.wanted(left):
        return f"ball {shot.first} was met first"
    if not shot.potted and not shot.cushion:
        return "no ball reached a cushion"
    return ""


def judge(match: Match, shot: Shot, left: Iterable[int]) -> Match:
    """Return how a match stands after a stroke; `left` were on the table before it.

    >>> judge(Match(is_break=False), Shot(first=3, potted=(3,)), range(1, 16)).owner
    0
    """
    left = frozenset(left)
    foul, other = foul_of(match, shot, left), 1 - match.turn
    if EIGHT in shot.potted and not match.is_break:
        wins = not foul and match.owner is not None and not match.group(match.turn) & left
        return replace(match, winner=match.turn if wins else other, foul=foul)
    own = [ball for ball in shot.potted if ball in match.group(match.turn)]
    owner = match.owner
    if owner is None and own and not foul and not match.is_break:
        owner = match.turn if own[0] in SOLIDS else other
    goes_on = bool(own) and not foul
    return Match(match.turn if goes_on else other, owner, is_break=False, foul=foul)
