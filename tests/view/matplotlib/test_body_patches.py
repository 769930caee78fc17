"""How bodies look: every shape at its place, turned, in colour or grey, with a name that fits."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex, to_rgba
from matplotlib.patches import Circle as CirclePatch
from matplotlib.patches import Polygon as PolygonPatch

from lesson_code import Body, Circle, Polygon, Scene, Segment
from lesson_code.view.framing import View
from lesson_code.view.matplotlib import body_patches, style

SAME: Any = {"rel": 1e-12, "abs": 1e-12}
"""A turn is a few products and sums of doubles."""


@pytest.fixture
def ax() -> Axes:
    """Return axes that show 10 by 5 m."""
    axes: Axes = style.figure(width=8, height=4)[1]
    axes.set(xlim=(-5, 5), ylim=(-1, 4))
    return axes


def draw(ax: Axes, *bodies: Body, color: str = style.BLUE, strength: float = 1.0) -> None:
    """Draw bodies as they start."""
    scene = Scene(bodies)
    places, angles = state(scene)
    body_patches.draw_static(ax, scene, places, angles, [color] * len(bodies))
    body_patches.draw_moving(ax, scene, places, angles, [color] * len(bodies), strength)


def state(scene: Scene) -> tuple[Any, Any]:
    """Return where bodies start."""
    places = np.reshape([body.position for body in scene.bodies], (-1, 2))
    return places, np.array([body.angle for body in scene.bodies])


def names_in(ax: Axes) -> dict[str, tuple[float, float]]:
    """Return what is written, and where."""
    return {text.get_text(): text.get_position() for text in ax.texts}


def name(ax: Axes, *bodies: Body, names: dict[int, str] | None = None) -> None:
    """Write the bodies' numbers, or other names."""
    scene = Scene(bodies)
    body_patches.write_names(
        ax, scene, *state(scene), names or {n: str(n) for n in range(len(bodies))}
    )


# Shapes


def test_circle_has_a_spoke_from_its_centre_at_its_angle(ax: Axes) -> None:
    """Turned by 90 degrees it points up."""
    draw(ax, Body(Circle(0.5), position=(1, 2), angle=np.pi / 2, mass=1.0))
    [patch], [spoke] = ax.patches, ax.lines
    assert isinstance(patch, CirclePatch)
    assert (patch.center, patch.radius) == ((1, 2), 0.5)
    assert spoke.get_xydata() == pytest.approx(np.array([(1, 2), (1, 2.5)]), **SAME)


def test_polygon_is_drawn_with_its_centroid_at_its_place(ax: Axes) -> None:
    """A 4 by 2 box, turned by 90 degrees, is 2 wide and 4 high."""
    draw(ax, Body(Polygon.box(4, 2), position=(1, 1), angle=np.pi / 2, mass=1.0))
    [patch] = ax.patches
    assert isinstance(patch, PolygonPatch)
    corners = patch.get_xy()[:4]
    assert corners == pytest.approx(np.array([(2, -1), (2, 3), (0, 3), (0, -1)]), **SAME)


def test_line_reaches_from_end_to_end(ax: Axes) -> None:
    """A segment without thickness is a line as wide as one can see."""
    draw(ax, Body(Segment((-1, 0), (1, 0)), position=(2, 1), angle=np.pi / 2))
    [line] = ax.lines
    ends = sorted(line.get_xydata().tolist())
    assert ends == pytest.approx(np.array([(2, 0), (2, 2)]), **SAME)


def test_thick_segment_is_everything_within_its_radius(ax: Axes) -> None:
    """Each corner of the outline lies at the radius from the line between the ends."""
    draw(ax, Body(Segment((-1, 0), (1, 0), 0.25)))
    [patch] = ax.patches
    assert isinstance(patch, PolygonPatch)
    corners = patch.get_xy()
    beyond = np.maximum(np.abs(corners[:, 0]) - 1, 0)
    assert np.hypot(beyond, corners[:, 1]) == pytest.approx(0.25, **SAME)
    assert corners[:, 0].max() == pytest.approx(1.25, **SAME)


def test_static_bodies_are_hatched_and_moving_ones_are_not(ax: Axes) -> None:
    """The hatching is the cue beside colour; the moving body lies in front, and shines through."""
    draw(ax, Body(Circle(1.0)), Body(Circle(1.0), mass=1.0))
    static, moving = ax.patches
    assert (static.get_hatch(), moving.get_hatch()) == ("////", None)
    assert static.get_zorder() < moving.get_zorder()
    assert moving.get_facecolor() == to_rgba(style.BLUE, body_patches.FILL)
    assert to_hex(moving.get_edgecolor()) == style.BLUE.lower()


def test_faint_bodies_are_in_the_same_colour_with_less_of_it(ax: Axes) -> None:
    """Half the strength is half of the colour in line and face."""
    draw(ax, Body(Circle(1.0), mass=1.0), strength=0.5)
    [patch] = ax.patches
    assert patch.get_edgecolor() == to_rgba(style.BLUE, 0.5)
    assert patch.get_facecolor() == to_rgba(style.BLUE, 0.5 * body_patches.FILL)


# Names


def test_name_stands_in_the_middle_of_its_body(ax: Axes) -> None:
    """As large as there is room, but no larger than other words."""
    name(ax, Body(Circle(1.0), position=(2, 1), mass=1.0))
    assert names_in(ax) == {"0": (2, 1)}
    assert ax.texts[0].get_fontsize() == body_patches.LARGEST_NAME


def test_name_of_an_endless_floor_stands_in_view_away_from_the_bodies(ax: Axes) -> None:
    """Its middle is at 0, where a box stands; its name is moved along it."""
    name(ax, Body(Segment((-1000, 0), (1000, 0))), Body(Polygon.box(1, 1), mass=1.0))
    x, y = names_in(ax)["0"]
    assert y == 0
    assert 1 < abs(x) < 5


def test_names_that_would_run_into_each_other_are_left_out(ax: Axes) -> None:
    """The first one stays."""
    discs = [Body(Circle(0.5), position=(0.05 * n, 0), mass=1.0) for n in range(2)]
    name(ax, *discs)
    assert [*names_in(ax)] == ["0"]


def test_name_out_of_view_is_left_out(ax: Axes) -> None:
    """It would stand outside the axes."""
    name(ax, Body(Circle(0.5), position=(9, 0), mass=1.0))
    assert names_in(ax) == {}


def test_names_of_few_small_bodies_are_written_and_of_many_are_not(ax: Axes) -> None:
    """A dozen numbers can be read beside their bodies; hundreds would hide them."""
    few = [Body(Circle(0.02), position=(0.6 * n - 3, 1), mass=1.0) for n in range(10)]
    name(ax, *few)
    assert len(names_in(ax)) == 10
    many = [Body(Circle(0.02), position=(0.6 * n - 3, 2), mass=1.0) for n in range(13)]
    ax.texts[0].remove()
    before = len(ax.texts)
    name(ax, *many)
    assert len(ax.texts) == before


def test_view_in_axes_is_what_they_show(ax: Axes) -> None:
    """Left, right, bottom, top."""
    assert body_patches.view_in(ax) == View(-5, 5, -1, 4)
