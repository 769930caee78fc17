"""How long each live figure takes from a move of the pointer to the picture that follows from it.

Chromium draws frames as fast as it can meanwhile, and does not wait for a screen. What is measured
is the time from the arrival of the move in the page, where a frame begins, to the end of that
frame. The way of the move from the mouse to the page is Chromium's own, and the same for an empty
page; it stands beside it. Other work on the machine adds to both; so the processor's time that a
move costs the page's main thread is shown, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from statistics import median, quantiles
from typing import TYPE_CHECKING, Any, ClassVar

from rich.table import Table

from lesson_code.evidence.measurement import Measurement, table
from lesson_code.view.browser import stills
from lesson_code.view.browser.chromium import chromium
from lesson_code.view.browser.live import html_of

if TYPE_CHECKING:
    from playwright.sync_api import CDPSession, Locator, Page

LIMIT = 16.0
"""ms: a screen's frame."""

MOVES = 40
"""Of the pointer, with each point and slider of a figure."""

UNLIMITED = ("--disable-frame-rate-limit", "--disable-gpu-vsync")
"""Let Chromium draw a frame as soon as there is something new."""

VIEW: Any = {"width": 900, "height": 1000}

LISTENS = """() => {
    window.times = [];
    window.ways = [];
    const shown = new MessageChannel();
    let since = null;
    shown.port1.onmessage = () => { times.push(performance.now() - since); since = null; };
    addEventListener("pointermove", ({ timeStamp, buttons }) => {
        if (!buttons || since !== null) return;
        since = performance.now();
        ways.push(since - timeStamp);
        requestAnimationFrame(() => shown.port2.postMessage(null));
    }, true);
}"""
"""In the page: note the ms of each move of the held pointer on its way to the page, and from there
to the end of its frame."""

FRAME_IS_OVER = """() => new Promise((done) => {
    const shown = new MessageChannel();
    shown.port1.onmessage = done;
    requestAnimationFrame(() => shown.port2.postMessage(null));
})"""
"""In the page: wait for the end of a frame."""


@dataclass(frozen=True)
class Answer:
    """How fast a figure answers, over all of its points and sliders.

    Attributes
    ----------
    figure : str
        The chapter's folder and the figure's name.
    moves : int
        Of the pointer.
    median_ms, most_ms : float
        From the arrival of a move to the end of its frame: the median, and the 95th percentile.
    way_ms : float
        From the mouse to the page: the median.
    cpu_ms, most_cpu_ms : float
        The time of the processor that a move costs the page's main thread, its picture included:
        the median, and the 95th percentile.
    """

    figure: str
    moves: int
    median_ms: float
    most_ms: float
    way_ms: float
    cpu_ms: float
    most_cpu_ms: float


@dataclass(frozen=True)
class Answers(Measurement):
    """How fast all live figures answer."""

    command: ClassVar[str] = "measure figures"
    rows: ClassVar[dict[str, type]] = {"answers": Answer}

    limit_ms: float
    answers: tuple[Answer, ...]

    def tables(self) -> Iterator[Table]:
        """Yield a row for each figure."""
        columns: dict[str, Callable[[Answer], str]] = {
            "figure": lambda a: a.figure,
            "moves": lambda a: str(a.moves),
            "median, ms": lambda a: f"{a.median_ms:.1f}",
            "95 %, ms": lambda a: f"{a.most_ms:.1f}",
            f"within {self.limit_ms:.0f} ms": lambda a: (
                "yes" if a.most_ms <= self.limit_ms else "NO"
            ),
            "way, ms": lambda a: f"{a.way_ms:.1f}",
            "CPU, ms": lambda a: f"{a.cpu_ms:.1f}",
            "95 % CPU, ms": lambda a: f"{a.most_cpu_ms:.1f}",
        }
        yield table("From a move of the pointer to the picture", columns, self.answers)


def measure_answers(only: list[str] | None = None, *, moves: int = MOVES) -> Answers:
    """Move every point and every slider of live figures in Chromium.

    Parameters
    ----------
    only : list of str, optional
        Figures whose names begin so: ``"ch03"``.
    moves : int
        With each point and slider.

    Raises
    ------
    ValueError
        There is no such figure.
    NoBrowserError
        Playwright or Chromium is not installed.
    """
    names = [name for name in stills.names() if name.startswith(tuple(only or [""]))]
    if not names:
        raise ValueError(f"--only must begin a figure's name, such as ch03, got {only}")
    with chromium(*UNLIMITED) as browser:
        return Answers(
            LIMIT, tuple(_answer(browser.new_page(viewport=VIEW), n, moves) for n in names)
        )


def _answer(page: Page, figure: str, moves: int) -> Answer:
    """Return how fast a figure answers."""
    page.set_content(f"<!doctype html><body>{html_of(figure, figure, '')}</body>")
    page.wait_for_selector("figure[data-ready]")
    page.evaluate(LISTENS)
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable", {"timeDomain": "threadTicks"})
    busy: list[float] = []
    for part in page.locator(".handle, input[type=range]").all():
        busy += _drag(page, session, part, moves)
    times: list[float] = page.evaluate("times")
    way: list[float] = page.evaluate("ways")
    page.close()
    most = quantiles(times, n=20)[-1]
    most_busy = quantiles(busy, n=20)[-1]
    return Answer(
        figure=figure,
        moves=len(times),
        median_ms=median(times),
        most_ms=most,
        way_ms=median(way),
        cpu_ms=1e3 * median(busy),
        most_cpu_ms=1e3 * most_busy,
    )


def _drag(page: Page, session: CDPSession, part: Locator, moves: int) -> list[float]:
    """Take hold of a point or a slider, and move it to and fro; return what each move costs, s."""
    part.scroll_into_view_if_needed()
    box = part.bounding_box()
    if box is None:
        raise RuntimeError("a figure's points and sliders must be seen")
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    page.mouse.move(x, y)
    page.mouse.down()
    busy = [_busy(session)]
    for k in range(1, moves + 1):
        page.mouse.move(x + 60 * (k % 20 - 10) / 10, y + 20 * (k % 8 - 4) / 4)
        page.evaluate(FRAME_IS_OVER)
        busy.append(_busy(session))
    page.mouse.up()
    return [after - before for before, after in pairwise(busy)]


def _busy(session: CDPSession) -> float:
    """Return for how many seconds the page's main thread has used the processor."""
    found = session.send("Performance.getMetrics")["metrics"]
    return float(next(m["value"] for m in found if m["name"] == "TaskDuration"))
