"""What colours and arrows mean: a mark is what draws them, and a line of the key that T shows."""

from __future__ import annotations

from dataclasses import dataclass

from lesson_code.view.pygame.window import (
    GREEN,
    INK,
    ORANGE,
    YELLOW,
    Colour,
    Window,
    pygame,
    smooth_disc,
)


@dataclass(frozen=True)
class Mark:
    """A colour in a shape, and what it means.

    Attributes
    ----------
    shape : str
        "disc", "ring", "arrow", "line" or "area".
    colour : Colour
        What it is drawn in.
    meaning : str
        A few words, for a line of the key.
    """

    shape: str
    colour: Colour
    meaning: str

    def draw(self, window: Window, box: pygame.Rect) -> None:
        """Draw it in the middle of a box, px."""
        px, surface, (x, y) = window.px, window.surface, box.center
        if self.shape == "arrow":
            window.arrow((box.left + 2, y), (box.width - 6, 0.0), self.colour, width=2.5)
        elif self.shape == "line":
            surface.fill(self.colour, (box.left, y - px(1), box.width, px(2)))
        elif self.shape == "area":
            surface.fill(self.colour, box.inflate(-px(6), -px(6)))
        elif self.shape == "ring":
            pygame.draw.circle(surface, self.colour, (x, y), px(6), px(2))
        else:
            sprite = smooth_disc(px(6), self.colour)
            surface.blit(sprite, sprite.get_rect(center=(x, y)))


VELOCITY = Mark("arrow", INK, "V: velocity")
MOMENTUM = Mark("arrow", ORANGE, "K: momentum")
IMPULSE = Mark("arrow", YELLOW, "I: impulse, from a red dot")
CENTRE = Mark("line", GREEN, "X: centre of mass, a cross")

SHARED = (VELOCITY, MOMENTUM, IMPULSE, CENTRE)
"""What keys add to the picture of any program."""
