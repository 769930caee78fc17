"""Draws a session: the program's own picture, what keys add to it, and the panel."""

from __future__ import annotations

from lesson_code.view.pygame.game import Game
from lesson_code.view.pygame.laboratory import Laboratory
from lesson_code.view.pygame.legend import SHARED
from lesson_code.view.pygame.panel import Panel
from lesson_code.view.pygame.picture import Picture
from lesson_code.view.pygame.program import ImpactEffects
from lesson_code.view.pygame.session import Session
from lesson_code.view.pygame.window import YELLOW, Window, pygame

HELP = (("R", "start again"), ("T   TAB", "colours   sliders"), ("H", "all keys"))
"""What the panel says of the keys that all programs share; the page of help has them all."""

GHOST = 130
"""Of 255: how bright another game is."""


class Painter:
    """Draws a session into a window."""

    def __init__(self, session: Session, picture: Picture) -> None:
        self._session, self._picture = session, picture
        self.panel = Panel(picture.window, session.program.title)
        self._laboratory = Laboratory(session, picture)

    def draw(self) -> None:
        """Draw field and panel and show them; from then on the mouse means places in them."""
        session, program, picture = self._session, self._session.program, self._picture
        picture.clear()
        program.draw(session.game, picture, session.effects)
        if session.effects.sparks is not None:
            session.effects.sparks.draw(picture)
        if session.ghost is not None:
            self._draw_ghost(session.ghost)
        picture.notice(session.game.notice)
        self._laboratory.draw()
        self._draw_panel()
        session.camera, session.field = picture.camera, pygame.Rect((0, 0), picture.size)
        picture.window.show()

    def _draw_ghost(self, ghost: Game) -> None:
        """Draw another game dimmed behind this one, where this one is darker."""
        window = self._picture.window
        pale = Picture(
            Window(pygame.Surface(window.surface.get_size())), self._session.program.camera
        )
        pale.clear()
        self._session.program.draw(ghost, pale, ImpactEffects())
        pale.window.surface.fill((GHOST, GHOST, GHOST), special_flags=pygame.BLEND_RGB_MULT)
        window.surface.blit(
            pale.window.surface, pale.seen, pale.seen, special_flags=pygame.BLEND_RGB_MAX
        )

    def _draw_panel(self) -> None:
        """Draw title, clock, read-outs, curves, and keys, sliders or legend."""
        session, program = self._session, self._session.program
        self.panel.begin()
        self.panel.readings([("clock", f"{session.ledger.last.time:.2f} s")])
        self.panel.scale(program.length, self._picture.camera.scale)
        self.panel.readings(program.readings(session.game))
        self.panel.readings(session.switched(), YELLOW)
        if program.more is not None:
            program.more(session.game, self.panel)
        session.rails = {}
        if "legend" in session.shown:
            self.panel.legend(program.legend + SHARED)
            self.panel.keys((("T", "back to the keys"),))
        elif "sliders" in session.shown:
            self.panel.slide(session.slider_values())
            self.panel.keys((("TAB", "back to the keys"),))
            session.rails = self.panel.sliders
        else:
            self.panel.keys(program.keys + HELP)
