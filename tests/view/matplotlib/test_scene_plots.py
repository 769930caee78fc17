"""Pictures of scenes: bodies, velocities, contacts, ways; what is drawn is what the run says."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import Circle as CirclePatch

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate
from lesson_code.view.matplotlib import scene_plots, style

READABLE: Any = Callable[[Figure], None]
ROUGH = Material(restitution=0.3, friction=0.4)
UP = (0.0, 1.0)


@pytest.fixture
def ax() -> Axes:
    """Return empty axes."""
    return style.figure()[1]  # type: ignore[no-any-return]


@pytest.fixture
def run(run_of: Any) -> Run:
    """Return a disc that comes down on a floor in three states, with an impulse in the second."""
    scene = Scene([Body(Segment((-4, 0), (4, 0))), Body(Circle(0.5), mass=2.0)], gravity=(0, -9.81))
    made: Run = run_of(
        scene,
        [0.0, 0.1, 0.2],
        [[(0, 0), (-1, 1.0)], [(0, 0), (0, 0.49)], [(0, 0), (1, 0.9)]],
        velocities=[[(0, 0), (3, -4)], [(0, 0), (2.5, 2)], [(0, 0), (2.5, 1)]],
        contacts=[(0.1, 0, 1, (0, 0), UP, 12.0, -1.0)],
    )
    return made


def circles(ax: Axes) -> list[CirclePatch]:
    """Return the circles that are drawn."""
    return [patch for patch in ax.patches if isinstance(patch, CirclePatch)]


# scene


def test_scene_is_drawn_as_it_starts(ax: Axes) -> None:
    """Each body at its place; the axes are named, and as large in x as in y."""
    scene = Scene([Body(Circle(0.5), position=(1, 2), mass=1.0), Body(Polygon.box(4, 1))])
    assert scene_plots.scene(ax, scene) is ax
    assert [circle.center for circle in circles(ax)] == [(1, 2)]
    assert len(ax.patches) == 2
    assert (ax.get_xlabel(), ax.get_ylabel(), ax.get_aspect()) == ("x, m", "y, m", 1)


@pytest.mark.parametrize(("time", "place"), [(0.0, (-1, 1)), (0.11, (0, 0.49)), (None, (1, 0.9))])
def test_run_is_drawn_at_a_time_and_else_as_it_ends(
    ax: Axes, run: Run, time: float | None, place: Any
) -> None:
    """The state that is nearest."""
    scene_plots.scene(ax, run, time)
    assert [circle.center for circle in circles(ax)] == [place]


def test_pictures_of_a_run_have_the_same_view_at_all_times(run: Run) -> None:
    """So they can be compared side by side."""
    views = []
    for time in run.times:
        ax = style.figure()[1]
        scene_plots.scene(ax, run, time)
        views.append((ax.get_xlim(), ax.get_ylim()))
    assert views[0] == views[1] == views[2]


def test_scene_around_a_place_shows_just_that(ax: Axes, run: Run) -> None:
    """The limits are those that were asked for."""
    scene_plots.scene(ax, run, around=(-2, 3, -1, 2))
    assert (ax.get_xlim(), ax.get_ylim()) == ((-2, 3), (-1, 2))


def test_names_and_colors_are_those_that_are_given(ax: Axes, run: Run) -> None:
    """By the bodies' numbers."""
    scene_plots.scene(ax, run, names={1: "ball"}, colors={1: style.GREEN})
    assert [text.get_text() for text in ax.texts] == ["ball"]
    assert to_hex(circles(ax)[0].get_edgecolor()) == style.GREEN.lower()


def test_names_can_be_the_numbers_of_all_bodies(ax: Axes, run: Run) -> None:
    """They are those that impulses speak of."""
    scene_plots.scene(ax, run, names=True)
    assert [text.get_text() for text in ax.texts] == ["0", "1"]


@pytest.mark.parametrize("argument", ["names", "colors"])
def test_body_that_does_not_exist_is_refused(ax: Axes, run: Run, argument: str) -> None:
    """The message says how many there are."""
    with pytest.raises(ValueError, match=f"{argument} must hold numbers of the 2 bodies, got 2"):
        scene_plots.scene(ax, run, **{argument: {2: style.BLUE}})


def test_empty_scene_is_drawn(ax: Axes) -> None:
    """As empty axes."""
    scene_plots.scene(ax, Scene(), names=True)
    assert len(ax.patches) == 0


# ghosts and trails


def test_ghosts_are_fainter_the_earlier(ax: Axes, run: Run) -> None:
    """The last one is in full colour, whatever the order of the times."""
    assert scene_plots.ghosts(ax, run, [0.2, 0.0, 0.1]) is ax
    strength = {circle.center: circle.get_edgecolor()[3] for circle in circles(ax)}
    assert strength[(-1, 1.0)] < strength[(0, 0.49)] < strength[(1, 0.9)] == 1


def test_ghosts_draw_what_stands_still_once(ax: Axes, run: Run) -> None:
    """The floor: one line; the spokes are the three others."""
    scene_plots.ghosts(ax, run, [0.0, 0.1, 0.2])
    assert len(ax.lines) == 4


def test_ghosts_need_a_time(ax: Axes, run: Run) -> None:
    """At least one."""
    with pytest.raises(ValueError, match="times must hold at least one time"):
        scene_plots.ghosts(ax, run, [])


def test_trails_are_the_ways_of_the_centres_with_a_dot_at_the_start(ax: Axes, run: Run) -> None:
    """Of what can be pushed; they end when asked."""
    scene_plots.trails(ax, run, until=0.1, colors={1: style.GREEN})
    way, start = ax.lines
    assert way.get_xydata().tolist() == [[-1, 1], [0, 0.49]]
    assert start.get_xydata().tolist() == [[-1, 1]]
    assert (start.get_marker(), way.get_color()) == ("o", style.GREEN)


def test_trails_of_some_bodies(ax: Axes, run: Run) -> None:
    """Those that are asked for, and no others."""
    scene_plots.trails(ax, run, bodies=[0])
    assert ax.lines[0].get_xydata().tolist() == [[0, 0]] * 3
    with pytest.raises(ValueError, match="bodies must hold numbers of the 2 bodies, got -1"):
        scene_plots.trails(ax, run, bodies=[-1])


# Legibility


def pile() -> Scene:
    """Return twenty discs between two walls on an endless floor."""
    walls = [
        Body(Segment((-50, 0), (50, 0)), material=ROUGH),
        Body(Segment((-2, 0), (-2, 5), 0.1)),
        Body(Segment((2, 0), (2, 5), 0.1)),
    ]
    discs = [disc(0.2 + 0.01 * n, (0.3 * (n % 7) - 1, 0.5 + 0.5 * n)) for n in range(20)]
    return Scene([*walls, *discs], gravity=(0, -9.81))


def disc(radius: float, position: tuple[float, float], speed: float = 0.0) -> Body:
    """Return a rough disc of 1 kg that moves to the right."""
    velocity = (speed, 0.0)
    return Body(Circle(radius), position=position, velocity=velocity, mass=1.0, material=ROUGH)


def incline(size: float) -> Scene:
    """Return a disc of so many metres on an incline."""
    ramp = Body(Segment((-9 * size, 3 * size), (0, 0)), material=ROUGH)
    return Scene([ramp, disc(0.5 * size, (-8 * size, 3.2 * size), size)], (0, -9.81 * size))


def stack() -> Scene:
    """Return ten boxes on a floor."""
    boxes = [
        Body(Polygon.box(1, 1), position=(0, 0.5 + n), mass=1.0, material=ROUGH) for n in range(10)
    ]
    return Scene([Body(Segment((-50, 0), (50, 0)), material=ROUGH), *boxes], gravity=(0, -9.81))


@pytest.mark.parametrize(
    "scene",
    [pile(), stack(), incline(1.0), incline(1e-3), incline(100.0)],
    ids=["pile", "stack", "incline", "millimetres", "hundreds of metres"],
)
@pytest.mark.parametrize("columns", [1, 2])
def test_no_word_is_cut_or_written_over_another(
    assert_texts_are_clear: READABLE, scene: Scene, columns: int
) -> None:
    """With numbers and a title, alone and side by side."""
    run = simulate(scene, 0.3, solver="pymunk")
    figure, axes = style.figure(columns, width=5.5 * columns, height=5)
    for ax in [axes] if columns == 1 else axes:
        scene_plots.scene(ax, run, names=True)
        ax.set_title("after 0.3 s")
    assert_texts_are_clear(figure)
