"""The picture that is dragged: its words, its parts, and that it is sound XML."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import numpy as np
import pytest

from lesson_code.chapters.ch06_sat_and_manifolds import sat_svg
from lesson_code.geometry import Polygon

A = np.array(Polygon.box(2.0, 1.0).vertices)
B = np.array(Polygon([(0.0, 0.0), (1.5, 0.0), (0.3, 1.2)]).vertices)

TENTH_OF_A_PIXEL = 0.051
"""px: places are written with one decimal."""


def drawn(shift: tuple[float, float]) -> ET.Element:
    """Return the picture with B moved by a shift, read as XML."""
    return ET.fromstring(sat_svg.picture(A, B + shift))  # noqa: S314 - our own text


def corners(picture: ET.Element, kind: str) -> np.ndarray:
    """Return the corners of a polygon in the picture, in metres."""
    [polygon] = [p for p in picture.iter("polygon") if p.get("class") == kind]
    pixels = np.array([pair.split(",") for pair in polygon.get("points", "").split()], dtype=float)
    return (pixels - sat_svg.MIDDLE) / (sat_svg.SCALE, -sat_svg.SCALE)


@pytest.mark.parametrize("shift", [(0.0, 0.0), (0.8, 0.6), (-2.2, 1.8), (2.2, -1.8)])
def test_picture_draws_both_polygons_to_scale(shift: tuple[float, float]) -> None:
    """Read back from the picture, the corners are those that were given."""
    picture = drawn(shift)
    for kind, vertices in (("a", A), ("b", B + shift)):
        tolerance = TENTH_OF_A_PIXEL / sat_svg.SCALE
        assert np.allclose(corners(picture, kind), vertices, rtol=0, atol=tolerance)


def test_picture_with_an_overlap_shows_where_b_only_touches() -> None:
    """The dashed copy of B lies half of the overlap's way out: B is 0.4 m in, along x."""
    shift = (1.0 - float(B[:, 0].min()) - 0.4, 0.0)
    moved = corners(drawn(shift), "moved")
    expected = np.add(B, (shift[0] + 0.4, 0.0))
    assert np.allclose(moved, expected, rtol=0, atol=TENTH_OF_A_PIXEL / sat_svg.SCALE)


def test_picture_of_polygons_apart_has_no_copy() -> None:
    """Without an overlap nothing is moved."""
    kinds = {polygon.get("class") for polygon in drawn((2.2, 0.0)).iter("polygon")}
    assert kinds == {"a", "b"}


def test_picture_has_a_row_for_every_axis_and_one_in_bold() -> None:
    """Names A1 to B3 stand in it; name and number of the axis that decides are bold."""
    texts = [(text.text, text.get("font-weight")) for text in drawn((0.8, 0.6)).iter("text")]
    rows = [text for text in texts if text[0] and text[0][-1].isdigit()]
    assert {name for name, _ in rows} == {"A1", "A2", "B1", "B2", "B3"}
    assert len([text for text, weight in texts if "out after" in str(text) and weight]) == 1


def test_picture_says_what_it_shows() -> None:
    """A screen reader is given the sentence that stands below the picture."""
    picture = drawn((0.8, 0.6))
    assert picture.get("role") == "img"
    assert picture.get("aria-label") == sat_svg.in_words(A, np.add(B, (0.8, 0.6)))


@pytest.mark.parametrize(
    ("shift", "words"),
    [
        (1.75, "Overlap. The shortest way for B out of A is 0.25 m along (1.00, 0.00)"),
        (-1.75, "Overlap. The shortest way for B out of A is 0.25 m along (-1.00, 0.00)"),
        (2.0, "No overlap. Axis A2 shows the two shadows touching."),
        (2.5, "No overlap. Axis A2 shows a gap of 0.50 m."),
    ],
)
def test_words_name_the_way_out_or_the_gap(shift: float, words: str) -> None:
    """A box beside its twin: deep on either side, touching, apart."""
    assert sat_svg.in_words(A, np.add(A, (shift, 0.1))).startswith(words)
