"""What keys add to the picture of any program: arrows with values, centre of mass, energy, help."""

from __future__ import annotations

import math
from heapq import nlargest
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from lesson_code.engine.core.callbacks import Touch
from lesson_code.engine.core.scene import XY
from lesson_code.view.pygame.legend import CENTRE, IMPULSE, MOMENTUM, VELOCITY
from lesson_code.view.pygame.picture import FAR, Picture
from lesson_code.view.pygame.program import Program, short
from lesson_code.view.pygame.session import ACTIONS, NEWS_STEPS, Session
from lesson_code.view.pygame.window import (
    BACKGROUND,
    BLUE,
    FADED_INK,
    GREEN,
    INK,
    SKY,
    VERMILION,
    YELLOW,
    Colour,
    Window,
    blend,
    pygame,
)

SMALL = 18
"""Points: height of a line in the field."""

LARGEST_ARROW = 90.0
"""Points: of the longest arrow; a round number of m/s or kg m/s makes as many."""

MOST_VALUES = 14
"""Bodies with values beside their arrows; more would hide one another. All have arrows."""

MOST_ROUND_ARROWS = 60
"""Arrows with heads; more are drawn as lines that end in a dot."""

Rows: TypeAlias = NDArray[np.float64]
Value: TypeAlias = tuple[list[float], list[float], str, Colour]
"""Tail and way of an arrow, px, and what is written beside it."""


class Laboratory:
    """Draws what a session shows beside the program's own picture.

    Its arrows keep their scale, until one becomes too long for it.
    """

    def __init__(self, session: Session, picture: Picture) -> None:
        self._session, self._picture = session, picture
        self._longest = {"velocities": 0.0, "momenta": 0.0, "impulses": 0.0}

    @property
    def _window(self) -> Window:
        return self._picture.window

    def draw(self) -> None:
        """Draw all that is asked for, over the picture."""
        shown = self._session.shown
        if not shown:
            return
        legend: list[tuple[Colour, str, float]] = []
        self._taken = list(self._picture.labels)
        self._values: list[Value] = []
        unit = self._session.program.length
        matter = self._session.game.matter()
        states, mass = matter.states, matter.mass
        if "velocities" in shown:
            per = self._arrows("velocities", states, states[:, 3:5], VELOCITY.colour, f"{unit}/s")
            legend.append((VELOCITY.colour, f"velocity {per:g} {unit}/s", per))
        if "momenta" in shown:
            p = states[:, 3:5] * mass[:, None]
            per = self._arrows("momenta", states, p, MOMENTUM.colour, f"kg {unit}/s")
            legend.append((MOMENTUM.colour, f"momentum {per:g} kg {unit}/s", per))
        if "impulses" in shown:
            per = self._impulses()
            legend.append((IMPULSE.colour, f"impulse {per:g} N s", per))
        if "centre" in shown and len(mass):
            self._centre(states, mass)
            legend.append((CENTRE.colour, "centre of mass", 0.0))
        if "energy" in shown:
            self._energy()
        if legend:
            self._legend(legend)
        for value in self._values:
            self._value(*value)
        if "help" in shown:
            draw_help(self._picture, self._session.program)

    # Arrows

    def _arrows(self, kind: str, states: Rows, along: Rows, colour: Colour, unit: str) -> float:
        """Draw an arrow on each body; return what an arrow of full length stands for."""
        sizes = np.hypot(*along.T) if len(along) else np.zeros(0)
        per = self._full(kind, float(sizes.max(initial=0.0)))
        pixels = LARGEST_ARROW * self._window.unit / per
        tails = self._picture.camera.places_of(states[:, :2])
        up = self._picture.camera.up
        with np.errstate(over="ignore"):
            ways = np.clip(along * (pixels, -pixels * up), -FAR, FAR)
        if {"velocities", "momenta"} <= self._session.shown:  # side by side: they are parallel
            apart = self._window.px(3) * (1 if kind == "momenta" else -1)
            beside = np.column_stack([-ways[:, 1], ways[:, 0]])
            beside /= np.maximum(np.hypot(*ways.T), 1e-9)[:, None]
            tails = tails + apart * beside
        if len(sizes) > MOST_ROUND_ARROWS:
            self._strokes(tails, ways, colour)
            return per
        rows = list(zip(tails.tolist(), ways.tolist(), sizes.tolist(), strict=True))
        for tail, tip, _ in rows:
            self._window.arrow((tail[0], tail[1]), (tip[0], tip[1]), colour, width=2.5)
        if len(rows) <= MOST_VALUES:
            for tail, tip, size in rows:
                if size * pixels > 1:
                    self._values.append((tail, tip, f"{short(size)} {unit}", colour))
        return per

    def _full(self, kind: str, largest: float) -> float:
        """Return a round number that no arrow so far has gone beyond."""
        self._longest[kind] = max(self._longest[kind], largest)
        return round_above(self._longest[kind])

    def _strokes(self, tails: Rows, along: Rows, colour: Colour) -> None:
        """Draw lines with dots at their ends."""
        surface, side = self._window.surface, self._window.px(3)
        dot = pygame.Surface((side, side)).convert()
        dot.fill(colour)
        tips = tails + along
        for tail, tip in zip(tails.tolist(), tips.tolist(), strict=True):
            pygame.draw.line(surface, colour, tail, tip)
        surface.blits([(dot, corner) for corner in (tips - side / 2).tolist()], False)

    def _value(self, tail: list[float], along: list[float], words: str, colour: Colour) -> None:
        """Write a value beyond the tip of an arrow, or where else there is room for it."""
        x, y, size = tail[0] + along[0], tail[1] + along[1], math.hypot(*along)
        box = pygame.Rect(0, 0, self._window.width(words, SMALL), self._window.px(SMALL - 4))
        ux, uy = along[0] / size, along[1] / size
        beyond = box.width / 2 * abs(ux) + box.height / 2 * abs(uy) + self._window.px(4)
        for k in (0, 1, -1, 2, -2, 3, -3):
            side = k * box.height
            box.center = round(x + beyond * ux - side * uy), round(y + beyond * uy + side * ux)
            box.clamp_ip(self._picture.seen)
            if box.collidelist(self._taken) < 0:
                self._taken.append(box)
                self._written(words, box.center, colour)
                return

    def _written(self, words: str, place: tuple[float, float], colour: Colour) -> None:
        """Write a line on a dark ground of its own."""
        box = pygame.Rect(0, 0, self._window.width(words, SMALL), self._window.px(SMALL - 4))
        box.center = round(place[0]), round(place[1])
        self._window.surface.fill(BACKGROUND, box.inflate(self._window.px(4), 0))
        self._window.text(words, place, colour=colour, size=SMALL, anchor="center")

    def _impulses(self) -> float:
        """Draw the impulses of the last half second; return what a full arrow stands for."""
        session, camera = self._session, self._picture.camera
        touches = (touch for step, touch in session.news if step > session.steps - NEWS_STEPS)
        strongest = nlargest(MOST_VALUES, touches, key=size_of)[::-1]
        per = self._full("impulses", size_of(strongest[-1]) if strongest else 0.0)
        pixels = LARGEST_ARROW * self._window.unit / per
        for touch in strongest:
            jx, jy = impulse_of(touch)
            place = camera.world_to_screen(touch.points[0])
            along = jx * pixels, -jy * pixels * camera.up
            pygame.draw.circle(self._window.surface, VERMILION, place, self._window.px(3))
            self._window.arrow(place, along, IMPULSE.colour, width=3.0)
            if math.hypot(*along) > 1:
                words = f"{short(size_of(touch))} N s"
                self._values.append(([*place], [*along], words, IMPULSE.colour))
        return per

    # Centre of mass, energy, scale

    def _centre(self, states: Rows, mass: Rows) -> None:
        """Draw a cross at the centre of mass."""
        total = float(mass.sum())
        place = mass @ states[:, :2] / total
        velocity = mass @ states[:, 3:5] / total
        x, y = self._picture.camera.world_to_screen((float(place[0]), float(place[1])))
        reach = self._window.px(9)
        for dx, dy in ((reach, reach), (reach, -reach)):
            ends = (x - dx, y - dy), (x + dx, y + dy)
            pygame.draw.line(self._window.surface, BACKGROUND, *ends, self._window.px(5))
            pygame.draw.line(self._window.surface, CENTRE.colour, *ends, self._window.px(2))
        unit = self._session.program.length
        words = f"{short(math.hypot(*velocity))} {unit}/s"
        self._written(words, (x, y + self._window.px(22)), CENTRE.colour)

    def _energy(self) -> None:
        """Draw the energy as a bar of its parts, below two lines that a program may write."""
        row = self._session.ledger.last
        parts = [
            ("motion", row.moving, SKY),
            ("rotation", row.turning, GREEN),
            ("height", row.height, BLUE),
            ("springs", row.other, YELLOW),
        ]
        parts = [part for part in parts if abs(part[1]) > 0 or part[0] == "motion"]
        parts += [("lost", row.lost, VERMILION)]
        seen, px = self._picture.seen, self._window.px
        line = px(SMALL)
        size = px(300), line * (len(parts) + 2) + px(14)
        box = self._box(pygame.Rect((seen.left + px(10), seen.top + px(70)), size))
        whole = sum(abs(value) for _, value, _ in parts) or 1.0
        y = box.top + px(6)
        for name, value, colour in parts:
            bar = round(abs(value) / whole * px(110))
            self._window.text(name, (box.left + px(8), y), size=SMALL)
            self._window.surface.fill(colour, (box.left + px(78), y + px(3), bar, line - px(6)))
            self._window.text(
                f"{short(value)} J", (box.right - px(8), y), size=SMALL, anchor="topright"
            )
            y += line
        for words in (f"sum {short(row.energy)} J", f"put in by hand {short(row.given)} J"):
            self._window.text(words, (box.left + px(8), y), colour=FADED_INK, size=SMALL)
            y += line

    def _box(self, box: pygame.Rect) -> pygame.Rect:
        """Return a box, empty and with a rim, in which no value is written."""
        self._window.surface.fill(BACKGROUND, box)
        pygame.draw.rect(self._window.surface, FADED_INK, box, 1)
        self._taken.append(box)
        return box

    def _legend(self, entries: list[tuple[Colour, str, float]]) -> None:
        """Say what the arrows stand for, at the bottom left."""
        seen, px = self._picture.seen, self._window.px
        full = LARGEST_ARROW * self._window.unit
        wide = max(self._window.width(words, SMALL) for _, words, _ in entries)
        box = pygame.Rect(0, 0, full + wide + px(36), px(SMALL) * len(entries) + px(10))
        box.bottomleft = seen.left + px(10), seen.bottom - px(10)
        y = self._box(box).top + px(5)
        for colour, words, per in entries:
            tail = box.left + px(10), y + px(SMALL) / 2
            if per:
                self._window.arrow(tail, (full, 0.0), colour, width=2.5)
            place = tail[0] + full + px(12), y
            self._window.text(words, place, colour=colour, size=SMALL)
            y += px(SMALL)


def impulse_of(touch: Touch) -> XY:
    """Return the impulse that the second body of a touch received, N s."""
    (nx, ny), normal, tangent = touch.normal, touch.normal_impulse, touch.tangent_impulse
    return normal * nx - tangent * ny, normal * ny + tangent * nx


def size_of(touch: Touch) -> float:
    """Return its size, N s."""
    return math.hypot(touch.normal_impulse, touch.tangent_impulse)


def round_above(value: float) -> float:
    """Return the smallest of 1, 2, 5, 10, 20 ... that is no smaller; 1 for 0.

    >>> round_above(3.2), round_above(0.02), round_above(0.0)
    (5.0, 0.02, 1.0)
    """
    if not value > 0:
        return 1.0
    power = 10.0 ** math.floor(math.log10(value))
    return next(k * power for k in (1.0, 2.0, 5.0, 10.0) if k * power >= value * (1 - 1e-12))


def draw_help(picture: Picture, program: Program) -> None:
    """Draw the page of help over the field: the program's keys, those of all, and what is not."""
    window, seen = picture.window, picture.seen
    px, line = window.px, window.px(19)
    page = seen.inflate(-px(40), -px(30))
    window.surface.fill(blend(BACKGROUND, INK, 0.06), page)
    pygame.draw.rect(window.surface, FADED_INK, page, 1)
    columns = page.left + px(16), page.left + px(380)
    y = _table(window, program.title, program.keys, (columns[0], page.top + px(14)))
    mouse = (("right button", "take hold of any body"),) * ("grab" not in program.forbids)
    y = _table(window, "mouse, in every program", mouse, (columns[0], y + line // 2))
    for name, reason in program.forbids.items():
        for k, words in enumerate(window.wrapped(f"no {name}: {reason}", px(340), SMALL)):
            window.text(words, (columns[0], y + k * line), colour=FADED_INK, size=SMALL)
        y += (k + 1) * line
    y = page.top + px(14)
    for group in dict.fromkeys(action.group for action in ACTIONS):
        rows = tuple((a.label, a.meaning) for a in ACTIONS if a.group == group)
        y = _table(window, group, rows, (columns[1], y)) + line // 3


def _table(
    window: Window, title: str, rows: tuple[tuple[str, str], ...], place: tuple[int, int]
) -> int:
    """Write keys and what they do below a title; return where the next line begins, px."""
    x, y = place
    line = window.px(19)
    window.text(title, (x, y), colour=SKY, size=SMALL)
    for key, meaning in rows:
        y += line
        window.text(key, (x, y), size=SMALL)
        window.text(meaning, (x + window.px(112), y), colour=FADED_INK, size=SMALL)
    return y + line
