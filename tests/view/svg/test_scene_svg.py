"""The still picture of an animation: well-formed, in place, the same on every machine."""

from __future__ import annotations

import re
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

from lesson_code import Body, Circle, Polygon, Scene, Segment
from lesson_code.view.framing import View
from lesson_code.view.matplotlib import style
from lesson_code.view.svg import scene_svg
from lesson_code.view.svg.scene_svg import PlacedState, Sheet, ticks

SVG = "{http://www.w3.org/2000/svg}"
SHEET = Sheet(View(0, 10, 0, 5), 20.0, ("",))
"""20 px a metre, 200 px wide and 100 high."""

BALL = Body(Circle(1.0), mass=1.0)
FLOOR = Body(Segment((0, 0), (10, 0)))


def state_of(scene: Scene, sheet: Sheet = SHEET, contacts: Any = ()) -> PlacedState:
    """Return the state that a scene starts in."""
    places = np.reshape([body.position for body in scene.bodies], (-1, 2))
    turns = np.array([body.angle for body in scene.bodies])
    none = np.zeros((len(scene.bodies), 2), dtype=np.int64)
    return PlacedState(sheet.placed(places), sheet.turned(turns), none, contacts)


def drawn(scene: Scene, names: Any = None, sheet: Sheet = SHEET, **rest: Any) -> Xml.Element:
    """Return the SVG of one scene, read as XML."""
    picture = scene_svg.picture(sheet, scene, state_of(scene, sheet, **rest), names or {})
    return Xml.fromstring(scene_svg.drawing(sheet, [picture], "a note", "abc"))  # noqa: S314


def moving_groups(svg: Xml.Element) -> list[Xml.Element]:
    """Return what a script can move."""
    return [group for group in svg.iter(f"{SVG}g") if "data-body" in group.attrib]


def texts(svg: Xml.Element) -> list[str]:
    """Return all words."""
    return [text.text or "" for text in svg.iter(f"{SVG}text")]


# Where things stand


def test_places_have_y_down_and_their_origin_at_the_top_left() -> None:
    """The view's top left corner is (0, 0); 1 m right of it and 2 m below is (20, 40) px."""
    assert SHEET.placed([(0, 5), (1, 3)]).tolist() == [[0, 0], [200, 400]]


def test_angles_are_clockwise_tenths_of_a_degree() -> None:
    """A quarter turn counter-clockwise is -900."""
    assert SHEET.turned([np.pi / 2, 0.0]).tolist() == [-900, 0]


@pytest.mark.parametrize("pixels", [0.0, 0.25, 12.5, 320.0, 100 / 3, -0.5])
def test_rounding_of_round_places_does_not_hang_on_the_last_bit(pixels: float) -> None:
    """Bodies at rest have round places: their edges of rounding lie elsewhere."""
    near = ticks([pixels - 1e-9, pixels, pixels + 1e-9])
    assert len(set(near.tolist())) == 1


def test_sheet_fits_the_width_or_the_height() -> None:
    """A wide view fills the width, a tall one the height; two side by side share the width."""
    wide = Sheet.fitted(View(0, 10, 0, 5), [""], width=640, height=420)
    tall = Sheet.fitted(View(0, 5, 0, 10), [""], width=640, height=420)
    two = Sheet.fitted(View(0, 10, 0, 5), ["", ""], width=640, height=420)
    assert (wide.picture, tall.picture, two.picture) == ((640, 320), (210, 420), (313, 156))
    assert two.size == (640, 156 + scene_svg.FOOTER)


def test_titles_have_a_line_of_their_own() -> None:
    """It is there only when there is a title."""
    sheet = Sheet(SHEET.view, 20.0, ("ours", "pymunk"))
    assert sheet.size == (2 * 200 + scene_svg.GAP, 100 + scene_svg.TITLE + scene_svg.FOOTER)
    assert SHEET.size == (200, 100 + scene_svg.FOOTER)


# What is drawn


def test_drawing_is_well_formed_and_holds_no_address_but_the_name_of_its_kind() -> None:
    """XML reads it, and nothing in it is fetched from anywhere."""
    scene = Scene([BALL, FLOOR, Body(Polygon.box(1, 1)), Body(Segment((-1, 0), (1, 0), 0.2))])
    picture = scene_svg.picture(SHEET, scene, state_of(scene), {0: "<&>"})
    text = scene_svg.drawing(SHEET, [picture], "5 < 6", "abc")
    assert Xml.fromstring(text).attrib["viewBox"] == "0 0 200 124"  # noqa: S314
    assert re.findall(r"\w+://[^\"]*", text) == ["http://www.w3.org/2000/svg"]


def test_moving_body_is_a_group_at_its_place_with_a_group_inside_that_turns() -> None:
    """The ball of radius 1 m at (2, 3) m has radius 20 px, a spoke, and stands at (40, 40) px."""
    body = Body(Circle(1.0), position=(2, 3), angle=np.pi / 6, mass=1.0)
    [group] = moving_groups(drawn(Scene([FLOOR, body])))
    turning, arrow = list(group)
    circle, spoke = list(turning)
    assert group.attrib == {"data-body": "1", "transform": "translate(40 40)"}
    assert turning.attrib["transform"] == "rotate(-30)"
    assert circle.attrib == {"r": "20"}
    assert spoke.attrib == {"d": "M0 0H20"}
    assert arrow.attrib["d"] == ""


def test_static_body_is_grey_and_hatched_behind_the_others() -> None:
    """It carries nothing that a script could move; its hatching has the drawing's own name."""
    svg = drawn(Scene([BALL, Body(Polygon.box(2, 1))]))
    static = next(g for g in svg.iter(f"{SVG}g") if "data-body" not in g.attrib)
    assert (static.attrib["stroke"], static.attrib["fill"]) == (style.GREY, "url(#hatch-abc)")
    assert svg.find(f".//{SVG}pattern").attrib["id"] == "hatch-abc"  # type: ignore[union-attr]
    assert static[0].attrib["d"] == "M-20 10L20 10L20 -10L-20 -10Z"


def test_wall_with_a_velocity_moves() -> None:
    """Nothing can push it, but it does not stand still either."""
    walls = [Body(Circle(1.0), velocity=(1, 0)), Body(Circle(1.0), angular_velocity=2.0)]
    scene = Scene([FLOOR, *walls])
    assert (scene_svg.moving(scene), scene_svg.still(scene)) == ([1, 2], [0])


def test_segment_with_a_thickness_has_round_ends() -> None:
    """A rod of 2 m and 0.2 m thickness: two half circles of 2 px at +-20 px."""
    [group] = moving_groups(drawn(Scene([Body(Segment((-1, 0), (1, 0), 0.1), mass=1.0)])))
    assert group[0][0].attrib["d"] == "M20 2A2 2 0 0 0 20 -2L-20 -2A2 2 0 0 0 -20 2Z"


def test_segment_without_thickness_is_a_line() -> None:
    """Wide enough to be seen."""
    [group] = moving_groups(drawn(Scene([Body(Segment((-1, 0), (1, 0)), mass=1.0)])))
    line = group[0][0].attrib
    assert line["stroke-width"] == "2.5"
    assert line["d"] in ("M-20 0L20 0", "M20 0L-20 0")


def test_body_smaller_than_a_pixel_can_still_be_seen() -> None:
    """A millimetre at 20 px a metre is drawn with a radius of half a pixel."""
    [group] = moving_groups(drawn(Scene([Body(Circle(1e-3), mass=1.0)])))
    assert group[0][0].attrib == {"r": "0.5"}


def test_name_stands_on_its_body_and_does_not_turn_with_it() -> None:
    """It stands in the group that moves, beside the one that turns."""
    svg = drawn(Scene([BALL, BALL]), names={0: "A"})
    first, second = moving_groups(svg)
    assert texts(svg) == ["A", "2 m", "a note"]
    assert [child.tag for child in first] == [f"{SVG}{kind}" for kind in ("g", "text", "path")]
    assert [child.tag for child in second] == [f"{SVG}{kind}" for kind in ("g", "path")]


@pytest.mark.parametrize(("count", "written"), [(12, 12), (13, 0)])
def test_names_of_few_small_bodies_are_written_and_of_many_are_not(
    count: int, written: int
) -> None:
    """A dozen numbers can be read beside their bodies; hundreds would hide them."""
    tiny = [Body(Circle(0.1), mass=1.0)] * count
    svg = drawn(Scene(tiny), names={n: str(n) for n in range(count)})
    assert len(texts(svg)) - 2 == written


def test_contact_points_are_dots_on_one_path() -> None:
    """They stand where they are, in pixels."""
    svg = drawn(Scene([BALL]), contacts=(10, 20, 30, 40))
    [path] = [p for p in svg.iter(f"{SVG}path") if "data-contacts" in p.attrib]
    assert path.attrib["d"] == "M10 20h0M30 40h0"
    assert path.attrib["stroke-linecap"] == "round"


def test_scale_bar_is_a_round_length_of_at_most_a_quarter_of_the_width() -> None:
    """A view 10 m wide at 20 px a metre: 2 m, 40 px."""
    svg = drawn(Scene())
    bar = next(p for p in svg.iter(f"{SVG}path") if "h40" in p.attrib.get("d", ""))
    assert "2 m" in texts(svg)
    assert bar.attrib["stroke"] == style.INK


@pytest.mark.parametrize(
    ("vector", "path"),
    [
        ((200, 0), "M0 0L20 0M13 3.5L20 0L13 -3.5"),
        ((0, -200), "M0 0L0 -20M3.5 -13L0 -20L-3.5 -13"),
        ((9, 0), ""),
        ((0, 0), ""),
    ],
    ids=["right", "up", "too short", "none"],
)
def test_arrow_has_its_tip_at_the_end_of_the_vector(vector: Any, path: str) -> None:
    """In tenths of a pixel, y down; less than a pixel is no arrow."""
    assert scene_svg.arrow(*vector) == path
