"""The colours of figures and programs: those of Okabe and Ito, Color Universal Design (2008).

They are told apart with any kind of colour blindness. Colour is never the only cue all the
same: a second one (a label, a line style, a marker) always stands beside it.
"""

from __future__ import annotations

BLUE = "#0072B2"
ORANGE = "#E69F00"
GREEN = "#009E73"
VERMILION = "#D55E00"
PURPLE = "#CC79A7"
SKY = "#56B4E9"
YELLOW = "#F0E442"


def rgb(color: str) -> tuple[int, int, int]:
    """Return a colour of the palette as red, green and blue, 0 to 255.

    >>> rgb(ORANGE)
    (230, 159, 0)
    """
    return int(color[1:3], 16), int(color[3:5], 16), int(color[5:7], 16)
