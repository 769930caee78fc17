"""The rules of eight-ball, stroke by stroke."""

from __future__ import annotations

import pytest

from lesson_code.chapters.pool.eight_ball import Match, Shot, foul_of, judge

ALL = range(1, 16)
OPEN, SOLIDS_MINE = Match(is_break=False), Match(owner=0, is_break=False)


@pytest.mark.parametrize(
    ("match", "shot", "left", "foul"),
    [
        (OPEN, Shot(3), ALL, ""),
        (OPEN, Shot(8), ALL, "ball 8 was met first"),
        (OPEN, Shot(None), ALL, "no ball was met"),
        (OPEN, Shot(3, scratch=True), ALL, "the cue ball fell"),
        (OPEN, Shot(3, cushion=False), ALL, "no ball reached a cushion"),
        (OPEN, Shot(3, (3,), cushion=False), ALL, ""),
        (SOLIDS_MINE, Shot(9), ALL, "ball 9 was met first"),
        (SOLIDS_MINE, Shot(8), ALL, "ball 8 was met first"),
        (SOLIDS_MINE, Shot(8), (8, 9, 10), ""),
    ],
)
def test_foul_is_named(match: Match, shot: Shot, left: tuple[int, ...], foul: str) -> None:
    """What has to be met first depends on whose balls are left."""
    assert foul_of(match, shot, left) == foul


def test_first_ball_after_the_break_decides_the_groups() -> None:
    """Not that of the break; and with a foul nothing is decided."""
    assert judge(Match(), Shot(1, (4,)), ALL).owner is None
    assert judge(OPEN, Shot(1, (4,)), ALL).owner == 0
    assert judge(OPEN, Shot(9, (9, 2)), ALL).owner == 1
    assert judge(OPEN, Shot(1, (4,), scratch=True), ALL).owner is None


def test_turn_goes_on_with_an_own_ball_only() -> None:
    """A ball of the other player, none, or a foul: the other one plays."""
    assert judge(SOLIDS_MINE, Shot(1, (4,)), ALL).turn == 0
    assert judge(SOLIDS_MINE, Shot(1, (12,)), ALL).turn == 1
    assert judge(SOLIDS_MINE, Shot(1), ALL).turn == 1
    assert judge(SOLIDS_MINE, Shot(1, (4,), scratch=True), ALL).turn == 1


@pytest.mark.parametrize(
    ("shot", "left", "winner"),
    [
        (Shot(8, (8,)), (8, 9), 0),
        (Shot(8, (8,), scratch=True), (8, 9), 1),
        (Shot(1, (1, 8)), (1, 8, 9), 1),
        (Shot(1, (8,)), ALL, 1),
    ],
)
def test_eight_decides_the_match(shot: Shot, left: tuple[int, ...], winner: int) -> None:
    """After all own balls it wins; too early, or with a foul, it loses."""
    assert judge(SOLIDS_MINE, shot, left).winner == winner


def test_eight_of_the_break_decides_nothing() -> None:
    """It is put back."""
    assert judge(Match(), Shot(1, (8,)), ALL).winner is None
