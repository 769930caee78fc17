"""The menu of all programs: a picture of each; the one under the mouse plays itself."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from lesson_code.view.pygame.panel import PROGRAM_SIZE
from lesson_code.view.pygame.picture import FIELD_SIZE, Picture
from lesson_code.view.pygame.program import Program
from lesson_code.view.pygame.recording import Recording
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.window import (
    BACKGROUND,
    FADED_INK,
    INK,
    UNSEEN,
    YELLOW,
    Window,
    open_window,
    pygame,
)

COLUMNS = 3
MARGIN, WORDS = 14, 108
"""Points: between tiles, and the least width for the words beside a picture."""

FIRST_STEPS, LAST_STEP = 40, 900
"""Steps of its tour after which a program is first drawn, and those after which it starts anew."""


@dataclass(frozen=True)
class Entry:
    """A program in the menu.

    Attributes
    ----------
    name, summary : str
        What is typed to open it, and what one sees.
    load : callable
        Returns the program.
    """

    name: str
    summary: str
    load: Callable[[], Program]


class Tile:
    """A program's picture, drawn when it is first wanted."""

    def __init__(self, entry: Entry) -> None:
        self.entry = entry
        self.surface: pygame.Surface | None = None

    def begin(self) -> None:
        """Start the program's tour, and draw it."""
        program = self.entry.load()
        self._session = Session(program, program.game(0), Recording(program.name, 0))
        self._session.tour = program.tour
        self.surface = pygame.Surface(FIELD_SIZE)
        self._picture = Picture(Window(self.surface), program.camera, beside=0)
        for _ in range(FIRST_STEPS):
            self._session.step()
        self.draw()

    def go_on(self) -> None:
        """Make a step and draw it; after the last one begin anew."""
        if self.surface is None or self._session.steps >= LAST_STEP:
            self.begin()
        self._session.step()
        self.draw()

    def draw(self) -> None:
        """Draw the field."""
        session = self._session
        self._picture.clear()
        session.program.draw(session.game, self._picture, session.effects)


class Menu:
    """All programs, one of which is marked.

    Parameters
    ----------
    entries : sequence of Entry
        Shown in this order.
    """

    def __init__(self, entries: Sequence[Entry]) -> None:
        self.tiles = [Tile(entry) for entry in entries]
        self.marked = 0
        self.chosen: str | None = None
        self.running = True
        self.boxes: list[pygame.Rect] = []

    def handle(self, event: pygame.event.Event) -> None:
        """Take one event of the window."""
        if event.type == pygame.QUIT:
            self.running = False
        elif event.type == pygame.KEYDOWN:
            self._press(pygame.key.name(event.key))
        elif event.type in (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN):
            under = [k for k, box in enumerate(self.boxes) if box.collidepoint(event.pos)]
            self.marked = under[0] if under else self.marked
            if under and event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
                self._choose(under[0])

    def _press(self, key: str) -> None:
        """Move the mark, choose or quit."""
        moves = {"left": -1, "right": 1, "up": -COLUMNS, "down": COLUMNS}
        if key in moves:
            self.marked = min(max(self.marked + moves[key], 0), len(self.tiles) - 1)
        elif key.isdecimal() and 1 <= int(key) <= len(self.tiles):
            self._choose(int(key) - 1)
        elif key in ("return", "space"):
            self._choose(self.marked)
        elif key == "escape":
            self.running = False

    def _choose(self, number: int) -> None:
        """End the menu with a program."""
        self.chosen, self.running = self.tiles[number].entry.name, False

    def step(self) -> None:
        """Draw one picture that is missing, or let the marked program go on."""
        missing = [tile for tile in self.tiles if tile.surface is None]
        if missing:
            missing[0].begin()
        else:
            self.tiles[self.marked].go_on()

    def draw(self, window: Window) -> None:
        """Draw all tiles with their names."""
        window.surface.fill(BACKGROUND)
        width, height = window.surface.get_size()
        rows = -(-len(self.tiles) // COLUMNS)
        margin, head = window.px(MARGIN), window.px(34)
        wide = (width - margin) // COLUMNS - margin
        high = (height - head - margin) // rows - margin
        title = "Arrows and ENTER, a number or a click open a program; ESC quits"
        window.text(title, (margin, window.px(10)), size=20)
        self.boxes = []
        for k, tile in enumerate(self.tiles):
            place = margin + k % COLUMNS * (wide + margin), head + k // COLUMNS * (high + margin)
            box = pygame.Rect(place, (wide, high))
            self.boxes.append(box)
            self._draw_tile(window, k, tile, box)

    def _draw_tile(self, window: Window, number: int, tile: Tile, box: pygame.Rect) -> None:
        """Draw a tile: its picture in the form of the field, and the words beside it."""
        is_marked, px = number == self.marked, window.px
        high = min(box.height, (box.width - window.px(WORDS)) * 3 // 4)
        picture = pygame.Rect(box.topleft, (high * 4 // 3, high))
        if tile.surface is not None:
            scaled = pygame.transform.smoothscale(tile.surface, picture.size)
            window.surface.blit(scaled, picture)
        rim = YELLOW if is_marked else FADED_INK
        pygame.draw.rect(window.surface, rim, picture, px(2) if is_marked else 1)
        left, y = picture.right + px(8), box.top
        window.text(f"{number + 1}  {tile.entry.name}", (left, y), colour=rim, size=19)
        for line in window.wrapped(tile.entry.summary, box.right - left, 15):
            y += px(16)
            window.text(line, (left, y + px(8)), colour=INK if is_marked else FADED_INK, size=15)


def choose(
    entries: Sequence[Entry],
    size: tuple[int, int] = PROGRAM_SIZE,
    when_shown: Callable[[], None] = lambda: None,
) -> str | None:
    """Show the menu, and return the name of the program that was chosen; None: it was closed.

    `when_shown` is called once it has a window.

    Raises
    ------
    RuntimeError
        There is no screen to open a window on.
    """
    menu = Menu(entries)
    with open_window(size, "Programs of the workbook") as window:
        if pygame.display.get_driver() in UNSEEN:
            raise RuntimeError("no screen to show the menu on")
        when_shown()
        while menu.running:
            for event in pygame.event.get():
                menu.handle(event)
            menu.step()
            menu.draw(window)
            window.show()
            window.wait()
    return menu.chosen
