"""What live figures say: at values that their notebooks ask for, and where they could be wrong."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from lesson_code import Circle, Polygon
from lesson_code.geometry import collide, mtv, time_of_impact
from lesson_code.reference.event_closed_forms import escape_fraction
from lesson_code.reference.impact_closed_forms import flat_landing

from .test_live import opened, seen

if TYPE_CHECKING:
    from pathlib import Path

    from playwright.sync_api import Locator, Page

CARTS = "ch01_one_dimension/carts"
BOUNCES = "ch02_restitution/bounce_heights"
HEIGHTS = "ch02_restitution/read_e"
HIT = "ch04_circles/oblique_hit"
FRICTION = "ch05_spin_and_friction/friction_cone"
CLIPPING = "ch06_sat_and_manifolds/clipping"
POLYGONS = "ch06_sat_and_manifolds/two_polygons"
SWEEPS = "ch06_sat_and_manifolds/sweeps"
IMPACT = "ch07_time_of_impact/two_bodies"
WALL = "ch07_time_of_impact/steps_at_a_wall"


def put(figure: Locator, numbers: dict[str, float]) -> None:
    """Type numbers in, each into the box of a label that begins so."""
    for label, value in numbers.items():
        figure.locator("label", has_text=label).locator("input[type=number]").fill(str(value))


def choose(figure: Locator, label: str, name: str) -> None:
    """Choose an entry of the list with a label."""
    figure.locator("label", has_text=label).locator("select").select_option(label=name)


@pytest.mark.browser
@pytest.mark.parametrize(
    ("name", "numbers", "words"),
    [
        ("ch00_start_here/dot_product", {"angle": 90}, "b is beside a, at a right angle"),
        ("ch00_start_here/dot_product", {"angle": -135}, "b lies clockwise of a"),
        (CARTS, {}, "cart 1 stands still, cart 2 has +2.00 m/s"),
        (CARTS, {"mass of cart 2": 2, "restitution": 0.5}, "cart 1 stands still"),
        (CARTS, {"velocity of cart 2": 2}, "they never meet"),
        (CARTS, {"restitution": 0}, "2.00 J before and 1.00 J after; lost: 1.00 J"),
        (BOUNCES, {"restitution": 0.9}, "lies still from 8.58 s on."),
        (BOUNCES, {"restitution": 0.99}, "from 89.85 s on, which is beyond the axis"),
        (BOUNCES, {"restitution": 1}, "never rests"),
        (BOUNCES, {"restitution": 0}, "from 0.45 s on"),
        (HEIGHTS, {"height after": 0.25}, "e = 0.500"),
        (HEIGHTS, {"height after": 0.81}, "e = 0.900"),
        (HEIGHTS, {"height after": 1.01}, "something has added energy"),
        (HIT, {}, "at a right angle. Of 4.50 J, 4.50 J are left"),
        (HIT, {"mass of disc 2": 2}, "120.0° apart"),
        (HIT, {"offset": 0}, "Disc 1 stops, disc 2 leaves at 3.00 m/s"),
        (HIT, {"offset": -1}, "only grazes disc 2: nothing changes"),
        (FRICTION, {}, "slides on, at 1.00 m/s"),
        (FRICTION, {"friction": 0.75}, "sticks"),
        (FRICTION, {"friction": 0.5, "normal impulse": 6}, "sticks"),
        (FRICTION, {"friction": 0.74}, "slides on, at 0.04 m/s"),
        (FRICTION, {"sliding": 0}, "nothing to do"),
    ],
)
def test_figure_says_what_the_formulas_give(
    page: Page, tmp_path: Path, name: str, numbers: dict[str, float], words: str
) -> None:
    """By hand: m2 = m1 / e stops cart 1, T = sqrt(2 h / g) (1 + e) / (1 - e), mu jn = m vt."""
    figure = opened(page, tmp_path, name)
    put(figure, numbers)
    assert words in seen(figure)[1]


@pytest.mark.browser
def test_cart_is_as_large_as_its_own_mass_says(page: Page, tmp_path: Path) -> None:
    """Raising the mass of cart 2 leaves cart 1 alone; each side grows with its cube root."""
    figure = opened(page, tmp_path, CARTS)

    def sides() -> list[float]:
        found = [
            figure.locator(f"svg path.{color}:not([fill])").first for color in ("blue", "orange")
        ]
        return [cart.evaluate("cart => cart.getBBox().width") for cart in found]

    start = sides()
    put(figure, {"mass of cart 2": 8})
    assert sides() == pytest.approx([start[0], 2 * start[1]], abs=0.2)  # drawn to 0.1 pixels


@pytest.mark.browser
def test_two_polygons_part_as_python_says(page: Page, tmp_path: Path) -> None:
    """The way out, to the centimetres that are shown, for places of B drawn at random."""
    figure = opened(page, tmp_path, POLYGONS)
    box = placed([(-1.3, -0.65), (1.3, -0.65), (1.3, 0.65), (-1.3, 0.65)], (0, 0), 15)
    wedge = np.array([(0, 0), (1.6, 0), (0.4, 1.3)]) - np.array([2.0, 1.3]) / 3
    rng = np.random.default_rng(seed=6)
    overlaps = 0
    for _ in range(30):
        x, y, angle = (rng.uniform(-end, end) for end in (2.2, 1.8, 180))
        put(figure, {"x of B": x, "y of B": y, "angle of B": angle})
        way = mtv(box, placed(wedge, (x, y), angle))
        overlaps += way is not None
        if way is None:
            expected = "No overlap. Axis "
        else:
            (nx, ny), depth = way
            expected = f"out of A is {depth:.2f} m along ({nx:.2f}, {ny:.2f}), on axis "
        assert expected in seen(figure)[1].replace("\N{MINUS SIGN}", "-")
    assert 5 <= overlaps <= 25


@pytest.mark.browser
def test_clipping_ends_with_the_contacts_of_python(page: Page, tmp_path: Path) -> None:
    """How many, and how deep, in centimetres, for places of B drawn at random."""
    figure = opened(page, tmp_path, CLIPPING)
    put(figure, {"step of": 6})
    a, b = Polygon.box(3, 1), Polygon.box(2, 1)
    rng = np.random.default_rng(seed=8)
    counts = []
    for _ in range(30):
        x, y, angle = rng.uniform(-2, 2.4), rng.uniform(-1.2, 1.6), rng.uniform(-180, 180)
        put(figure, {"x of B": x, "y of B": y, "angle of B": angle})
        contact = collide(a, (0, 0, 0), b, (x, y, np.radians(angle)))
        counts.append(0 if contact is None else len(contact.points))
        words = seen(figure)[1]
        if contact is None:
            assert "no contact" in words
        else:
            assert words.startswith(("One contact", "Two contacts")[counts[-1] - 1])
            assert all(f"{depth:.2f} m" in words for depth in contact.penetrations)
    assert {*counts} == {0, 1, 2}


@pytest.mark.browser
@pytest.mark.parametrize(("width", "height", "sweeps"), [(1, 4, 1), (1, 10, 7), (5, 2, 3)])
def test_spin_that_sweeps_leave_is_that_of_the_closed_form(
    page: Page, tmp_path: Path, width: float, height: float, sweeps: int
) -> None:
    """Two visits make a sweep; written to a thousandth, or as a power of ten."""
    figure = opened(page, tmp_path, SWEEPS)
    put(figure, {"width": width, "height": height, "visits": 2 * sweeps})
    spin = abs(flat_landing(width, height, 1.0, 0.5, sweeps=sweeps)[1])
    assert spin >= 1e-3
    assert f"turns at {spin:.3f} rad/s" in seen(figure)[1]


@pytest.mark.browser
@pytest.mark.parametrize(
    ("speed", "thickness", "rate"), [(30, 0.1, 60), (60, 0.5, 30), (9, 0.1, 60), (50, 1.0, 40)]
)
def test_share_that_gets_through_a_wall_is_the_laws(
    page: Page, tmp_path: Path, speed: float, thickness: float, rate: int
) -> None:
    """A hundred places within a step, each followed by looks of the program: one may be off."""
    figure = opened(page, tmp_path, WALL)
    put(figure, {"speed": speed, "thickness": thickness, "steps a second": rate})
    law = escape_fraction(speed, 1 / rate, 0.1, thickness)
    through = int(seen(figure)[1].split("From ")[1].split(" of")[0])
    assert through == pytest.approx(100 * law, abs=1)


@pytest.mark.browser
def test_two_bodies_touch_when_python_says(page: Page, tmp_path: Path) -> None:
    """The time of impact, to the milliseconds that are shown, for motions drawn at random."""
    figure = opened(page, tmp_path, IMPACT)
    box, disc = Polygon.box(2, 1), Circle(0.5)
    rng = np.random.default_rng(seed=7)
    hits = 0
    for _ in range(30):
        x, y, w = rng.uniform(-4, 0), rng.uniform(-2.5, 2.5), rng.choice([0, rng.uniform(-3, 3)])
        vx, vy = rng.uniform(1, 5), rng.uniform(-1.5, 1.5)
        put(figure, {"x of": x, "y of": y, "along x": vx, "along y": vy, "spin": w})
        time = time_of_impact(box, (2, -0.5, 0), (0, 0, w), disc, (x, y, 0), (vx, vy, 0), 4)
        hits += time is not None
        words = "do not touch within 4 s" if time is None else f"first touch after {time:.3f} s."
        assert words in seen(figure)[1]
    assert 5 <= hits <= 25


def placed(corners: Any, place: tuple[float, float], degrees: float) -> Any:
    """Return corners, turned and then moved."""
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.asarray(corners) @ np.array([[cos, sin], [-sin, cos]]) + place
