"""The picture of the billiards program: the table, the ball, the arrows and the read-outs."""

from __future__ import annotations

import math
from collections.abc import Callable

from lesson_code.programs.billiards_game import (
    ARROW_SECONDS,
    RAIL,
    Game,
    launch_velocity,
    on_screen,
)
from lesson_code.programs.billiards_table import CUSHIONS, TABLE
from lesson_code.view.pygame_view import (
    BACKGROUND,
    FADED_INK,
    INK,
    ORANGE,
    PURPLE,
    SKY,
    SMALL_TEXT_SIZE,
    YELLOW,
    Colour,
    Place,
    Window,
    antialiased,
    blend,
    draw_capsule,
    pygame,
    smooth_disc,
)

CUSHION = 12
"""px: width of the cushions, the inner part of the rail."""

HUD_HEIGHT = 104
"""px: the strip with the read-outs, below the table."""

WINDOW_SIZE = (round(TABLE.width) + 2 * RAIL, round(TABLE.height) + 2 * RAIL + HUD_HEIGHT)

CLOTH: Colour = (18, 70, 78)
CUSHION_CLOTH: Colour = (10, 42, 48)
WOOD: Colour = (88, 62, 44)

HELP = "drag from the ball: launch    SPACE pause    R reset    V velocity    N normals    ESC quit"

COUNT_COLUMNS = (0, 128, 210, 318, 402, 500)
"""px from the table's left edge: total, top, bottom, left, right, bumper."""

READING_COLUMNS = (0, 160, 318, 402)
"""px from the table's left edge: speed, restitution, time, time of the fifth cushion."""


class Painter:
    """Draws the game; what never changes is painted once.

    Parameters
    ----------
    window : Window
        Where to draw.
    """

    def __init__(self, window: Window) -> None:
        self._window = window
        self._table = antialiased(WINDOW_SIZE, _paint_table, BACKGROUND)
        self._ball = smooth_disc(TABLE.radius, INK)
        self._flashes = {
            name: antialiased(WINDOW_SIZE, _painted_flash(name), YELLOW) for name in CUSHIONS
        }

    def draw(self, game: Game) -> None:
        """Draw everything and show it."""
        surface = self._window.surface
        surface.fill(BACKGROUND)
        surface.blit(self._table, (0, 0))
        for name in game.flashes:
            surface.blit(self._flashes[name], (0, 0))
        self._draw_trail(game)
        if game.shows_normals:
            self._draw_normals()
        self._draw_ball(game)
        self._draw_hud(game)
        self._draw_notice(game.notice or ("PAUSED" if game.paused else ""))
        self._window.show()

    def _draw_trail(self, game: Game) -> None:
        places = [on_screen(p) for p in game.trail]
        for index in range(1, len(places)):
            colour = blend(CLOTH, INK, index / len(places))
            pygame.draw.aaline(self._window.surface, colour, places[index - 1], places[index])

    def _draw_normals(self) -> None:
        for foot, normal in _normals():
            x, y = on_screen(foot)
            self._window.arrow((x, y), (40 * normal[0], 40 * normal[1]), SKY)
            label = f"({normal[0]:.4g}, {normal[1]:.4g})"
            beside = (x + 80 * normal[0], y + 56 * normal[1])
            self._window.text(label, beside, colour=SKY, size=SMALL_TEXT_SIZE, anchor="center")

    def _draw_ball(self, game: Game) -> None:
        x, y = on_screen(game.position)
        half = self._ball.get_width() / 2
        self._window.surface.blit(self._ball, (round(x - half), round(y - half)))
        velocity = game.velocity
        if game.aim is not None:
            velocity = launch_velocity(game.position, game.aim)
        if game.aim is not None or game.shows_velocity:
            tip = on_screen(game.position + velocity * ARROW_SECONDS)
            self._window.arrow((x, y), (tip[0] - x, tip[1] - y), ORANGE)

    def _draw_hud(self, game: Game) -> None:
        left, top = RAIL, round(TABLE.height) + 2 * RAIL + 14
        for column, words in zip(COUNT_COLUMNS, hud_counts(game), strict=True):
            self._window.text(words, (left + column, top))
        for column, words in zip(READING_COLUMNS, hud_readings(game), strict=True):
            self._window.text(words, (left + column, top + 28))
        self._window.text(HELP, (left, top + 60), colour=FADED_INK, size=SMALL_TEXT_SIZE)

    def _draw_notice(self, words: str) -> None:
        if words:
            centre = on_screen((TABLE.width / 2, TABLE.height / 4))
            rectangle = self._window.text(words, centre, anchor="center")
            pygame.draw.rect(self._window.surface, BACKGROUND, rectangle.inflate(24, 16))
            self._window.text(words, centre, anchor="center")


def hud_counts(game: Game) -> list[str]:
    """Return the first line of read-outs: hits in total and by cushion."""
    total = sum(game.bounces.values())
    return [f"bounces {total}", *(f"{name} {count}" for name, count in game.bounces.items())]


def hud_readings(game: Game) -> list[str]:
    """Return the second line of read-outs: speed, restitution, time."""
    if game.aim is None:
        speed = f"speed {math.hypot(*game.velocity):.0f} px/s"
    else:
        speed = f"launch {math.hypot(*launch_velocity(game.position, game.aim)):.0f} px/s"
    all_hit = "" if game.all_hit_at is None else f"all five hit in {game.all_hit_at:.2f} s"
    return [speed, f"restitution {TABLE.restitution:g}", f"{game.time:.1f} s", all_hit]


def _paint_table(surface: pygame.Surface, scale: int) -> None:
    """Paint wood, cushions, cloth and bumper."""
    table = (RAIL, RAIL, TABLE.width, TABLE.height)
    for grow, colour in ((RAIL, WOOD), (CUSHION, CUSHION_CLOTH), (0, CLOTH)):
        x, y, width, height = table
        frame = (x - grow, y - grow, width + 2 * grow, height + 2 * grow)
        surface.fill(colour, [round(side * scale) for side in frame])
    _paint_bumper(surface, scale, PURPLE)


def _paint_bumper(surface: pygame.Surface, scale: int, colour: Colour) -> None:
    """Paint the bumper exactly where the physics has it."""
    start, end = (
        (x * scale, y * scale) for x, y in map(on_screen, (TABLE.bumper_start, TABLE.bumper_end))
    )
    draw_capsule(surface, start, end, TABLE.bumper_half_thickness * scale, colour)


def _painted_flash(name: str) -> Callable[[pygame.Surface, int], None]:
    """Return what paints one cushion in the colour of a hit."""

    def paint(surface: pygame.Surface, scale: int) -> None:
        if name == "bumper":
            _paint_bumper(surface, scale, YELLOW)
        else:
            corners = [(x * scale, y * scale) for x, y in map(on_screen, _cushion(name))]
            pygame.draw.polygon(surface, YELLOW, corners)

    return paint


def _cushion(name: str) -> list[Place]:
    """Return the four corners of a wall's cushion, which lies outside the table."""
    w, h, c = TABLE.width, TABLE.height, CUSHION
    return {
        "top": [(0.0, 0.0), (w, 0.0), (w + c, -c), (-c, -c)],
        "bottom": [(0.0, h), (w, h), (w + c, h + c), (-c, h + c)],
        "left": [(0.0, 0.0), (0.0, h), (-c, h + c), (-c, -c)],
        "right": [(w, 0.0), (w, h), (w + c, h + c), (w + c, -c)],
    }[name]


def _normals() -> list[tuple[Place, Place]]:
    """Return foot and direction of every normal to draw: four walls, two sides of the bumper."""
    w, h = TABLE.width, TABLE.height
    feet = {"top": (w / 2, 0.0), "bottom": (w / 2, h), "left": (0.0, h / 2), "right": (w, h / 2)}
    walls = [(feet[name], normal) for name, normal, _ in TABLE.walls]
    (x1, y1), (x2, y2) = TABLE.bumper_start, TABLE.bumper_end
    nx, ny = TABLE.bumper_normal
    sides = []
    for sign in (1, -1):
        reach = sign * TABLE.bumper_half_thickness
        foot = ((x1 + x2) / 2 + reach * nx, (y1 + y2) / 2 + reach * ny)
        sides.append((foot, (sign * nx, sign * ny)))
    return walls + sides
