"""The colours of figures and programs, after Okabe and Ito, Color Universal Design (2008).

They are told apart with any kind of colour blindness. Colour is never the only cue all the
same: a second one (a label, a line style, a marker) always stands beside it.

On a dark ground they stand as published. On white four of them are too pale to read: there all are
darker, in the same hues.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Palette:
    """Seven colours, each as "#" and six hexadecimal digits."""

    blue: str
    orange: str
    green: str
    vermilion: str
    purple: str
    sky: str
    yellow: str


PUBLISHED = Palette("#0072B2", "#E69F00", "#009E73", "#D55E00", "#CC79A7", "#56B4E9", "#F0E442")
ON_WHITE = Palette("#0068A6", "#C48800", "#00805C", "#C24A00", "#B3548C", "#439CD6", "#F0E442")
"""Words can be written in blue, green, vermilion and purple (contrast 4.5 and more); lines also in
orange and sky (3 and more); yellow is for areas alone."""


def rgb(color: str) -> tuple[int, int, int]:
    """Return a colour of a palette as red, green and blue, 0 to 255.

    >>> rgb(PUBLISHED.orange)
    (230, 159, 0)
    """
    return int(color[1:3], 16), int(color[3:5], 16), int(color[5:7], 16)
