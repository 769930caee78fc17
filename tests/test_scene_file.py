"""Scene files: what is written is what is read, and a broken one says what is wrong with it."""

from __future__ import annotations

import json
from math import cos, inf, pi, sin, sqrt
from pathlib import Path
from typing import Any

import pytest

from lesson_code import Body, Circle, Material, Polygon, Segment, read_scene, simulate
from lesson_code.scene_file import scene_of, set_up_of, understood, write_scene

ROUNDING = 1e-12
"""m: a coordinate of a few metres, shifted by a few."""

DISC = {"mass": 1, "size": 0.4}

BROKEN: list[tuple[Any, str]] = [
    ([], "a scene must be an object with fields, got []"),
    ({}, "bodies must be a list of at most 1000, got nothing"),
    ({"bodies": [DISC] * 1001}, "bodies must be a list of at most 1000, got 1001"),
    ({"bodies": [7]}, "bodies[0] must be an object with fields, got 7"),
    (
        {"bodies": [], "wind": 1},
        "a scene must have no field but dimensions, elasticity, friction, gravity, walls, room, "
        "bodies, got wind",
    ),
    ({"bodies": [], "dimensions": 3}, "dimensions must be 1 or 2, got 3"),
    ({"bodies": [], "dimensions": True}, "dimensions must be 1 or 2, got true"),
    ({"bodies": [], "elasticity": 101}, "elasticity must lie between 0 and 100, got 101"),
    ({"bodies": [], "friction": "high"}, 'friction must lie between 0 and 1, got "high"'),
    ({"bodies": [], "gravity": -1}, "gravity must lie between 0 and 20, got -1"),
    ({"bodies": [], "walls": 1}, "walls must be true or false, got 1"),
    ({"bodies": [], "room": 8}, "room must be [width, height], got 8"),
    ({"bodies": [], "room": [8, 0]}, "room[1] must lie between 1 and 100, got 0"),
    ({"bodies": [{"size": 1}]}, "bodies[0].mass must lie between 0.001 and 100, got nothing"),
    ({"bodies": [DISC, DISC | {"vx": 51}]}, "bodies[1].vx must lie between -50 and 50, got 51"),
    (
        {"bodies": [DISC | {"w": True}]},
        "bodies[0].w must lie between -1000000000 and 1000000000, got true",
    ),
    (
        {"bodies": [DISC | {"shape": "ring"}]},
        'bodies[0].shape must be one of disc, box, polygon, got "ring"',
    ),
    (
        {"bodies": [DISC | {"corners": 4.5}]},
        "bodies[0].corners must be a whole number between 3 and 20, got 4.5",
    ),
    (
        {"bodies": [DISC | {"elasticity": [1]}]},
        "bodies[0].elasticity must lie between 0 and 100, got [1]",
    ),
]
"""What is no scene, and what is said of it: in Python here, in a page in `test_scene_files.py`."""


@pytest.mark.parametrize(("given", "words"), BROKEN)
def test_broken_file_names_field_rule_and_value(tmp_path: Path, given: Any, words: str) -> None:
    """After the file's name."""
    path = tmp_path / "broken.json"
    path.write_text(json.dumps(given), encoding="utf-8")
    with pytest.raises(ValueError, match="holds no scene") as error:
        read_scene(path)
    assert str(error.value) == f"{path} holds no scene: {words}"


def test_file_that_is_no_json_is_named(tmp_path: Path) -> None:
    """A truncated file, and one that holds no text."""
    path = tmp_path / "broken.json"
    for content in (b'{"bodies": [', b"\xff\xfe"):
        path.write_bytes(content)
        with pytest.raises(ValueError, match=r"broken\.json holds no scene: "):
            read_scene(path)


def test_bodies_are_those_that_the_fields_describe() -> None:
    """Written out by hand: shapes, masses, motion, surfaces, walls, gravity."""
    scene = scene_of(
        {
            "elasticity": 80,
            "friction": 0.2,
            "gravity": True,
            "walls": True,
            "room": [8, 6],
            "bodies": [
                {"mass": 2, "size": 0.5, "x": 1, "y": 2, "vx": 3, "vy": 4, "angle": 5, "w": 6},
                {"shape": "box", "mass": 1, "size": 0.5, "friction": 0.9},
                {"shape": "polygon", "corners": 3, "mass": 1, "size": 0.2},
            ],
        }
    )
    disc, box, triangle, *walls = scene.bodies
    surface = Material(0.8, 0.2)
    motion: dict[str, Any] = {"angle": 5, "velocity": (3, 4), "angular_velocity": 6}
    assert disc == Body(Circle(0.5), mass=2, position=(1, 2), material=surface, **motion)
    assert box == Body(Polygon.box(1, 1), mass=1, material=Material(0.8, 0.9))
    corners = [(0.2 * cos(turn), 0.2 * sin(turn)) for turn in (0, 2 * pi / 3, 4 * pi / 3)]
    assert triangle.shape == Polygon(corners)
    assert [wall.shape for wall in walls] == [
        Segment((-4, -3), (4, -3)),
        Segment((4, -3), (4, 3)),
        Segment((4, 3), (-4, 3)),
        Segment((-4, 3), (-4, -3)),
    ]
    assert scene.gravity == (0, -9.81)


def test_track_neither_turns_nor_falls_nor_rubs() -> None:
    """Two equal masses on a track exchange their velocities, whatever else the file says."""
    bodies = [DISC | {"x": -2, "y": 1, "vx": 2, "vy": 1}, DISC | {"x": 2, "shape": "box", "w": 1}]
    scene = scene_of({"dimensions": 1, "friction": 1, "gravity": 9, "bodies": bodies})
    run = simulate(scene, 3.0, solver="sequential")
    assert run.velocities[-1].tolist() == [[0, 0], [pytest.approx(2), 0]]
    assert {body.inertia for body in scene.bodies} == {inf}


def test_what_is_written_is_read_again(tmp_path: Path) -> None:
    """Bodies with surfaces of their own, in a room, under gravity; and a track stays one."""
    bodies = [
        Body(Circle(0.25), mass=1.5, position=(1, -1), velocity=(2, 3), angular_velocity=4),
        Body(Polygon.box(0.5, 0.5), mass=2, angle=0.3, material=Material(0.25, 0.75)),
        Body(Polygon.regular(5, 0.5), mass=3, position=(-1, 2), material=Material(0.5, 0)),
    ]
    track = [Body(Circle(0.25), mass=1, inertia=inf, position=(1, 0), velocity=(-1, 0))]
    for given, gravity in ((bodies, 1.62), (track, 0.0)):
        made = set_up_of(given, surface=Material(0.5, 0), gravity=gravity, room=(8, 6))
        write_scene(tmp_path / "scene.json", made)
        read = read_scene(tmp_path / "scene.json")
        again = set_up_of(
            [body for body in read.bodies if not body.is_static],
            surface=Material(0.5, 0),
            gravity=gravity,
            room=(8, 6),
        )
        assert {**again, "bodies": None} == {**made, "bodies": None}
        for one, other in zip(again["bodies"], made["bodies"], strict=True):
            assert one == {**other, "size": pytest.approx(other["size"], abs=ROUNDING)}
    assert made["dimensions"] == 1


@pytest.mark.parametrize(
    ("body", "words"),
    [
        (Body(Circle(1)), r"bodies\[0\]\.mass must be given"),
        (Body(Circle(0.5), mass=1, inertia=inf, position=(0, 1)), r"bodies\[0\]\.inertia must be"),
        (Body(Polygon.box(1, 0.5), mass=1), r"bodies\[0\]\.shape must be a disc, a square or"),
        (Body(Circle(0.5), mass=1, velocity=(60, 0)), r"bodies\[0\]\.vx must lie .*, got 60"),
    ],
)
def test_body_that_a_file_cannot_hold_is_refused(body: Body, words: str) -> None:
    """With its place, and the field."""
    with pytest.raises(ValueError, match=words):
        set_up_of([body], surface=Material())


def test_box_is_no_polygon_of_four_corners() -> None:
    """The one stands on a side, the other on a corner: each comes back as it was."""
    for shape, size in (("box", 0.5), ("polygon", 0.5 * sqrt(2))):
        given = understood({"bodies": [{"shape": shape, "corners": 4, "mass": 1, "size": size}]})
        made = set_up_of(scene_of(given).bodies, surface=Material())
        assert made["bodies"][0]["shape"] == shape
        assert made["bodies"][0]["size"] == pytest.approx(size, abs=ROUNDING)
