"""A run that plays in the notebook: what is displayed, and what it needs."""

from __future__ import annotations

import base64
import html
import json
import re
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import pytest

from lesson_code import Body, Circle, Material, Run, Scene, Segment, simulate
from lesson_code.view.svg import animation
from lesson_code.view.svg.animation import animate

ALT = 'A ball falls on a floor & "bounces" at e < 1.'
LARGEST = 300_000
"""Characters that thirty bodies over five seconds may take."""

BALL = Material(restitution=0.5, friction=0.4)


def falling(count: int = 1) -> Scene:
    """Return discs above a floor."""
    discs = [
        Body(Circle(0.3), position=(0.7 * (n % 6), 1 + n // 6), mass=1.0, material=BALL)
        for n in range(count)
    ]
    return Scene([Body(Segment((-20, 0), (20, 0)), material=BALL), *discs], gravity=(0, -9.81))


@pytest.fixture(scope="module")
def run() -> Run:
    """Return a disc that falls and bounces for a second."""
    return simulate(falling(), 1.0)


@pytest.fixture
def displayed(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, str]]:
    """Collect what is displayed, in place of a notebook's front end."""
    bundles: list[dict[str, str]] = []

    def collect(bundle: dict[str, str], *, raw: bool) -> None:
        assert raw
        bundles.append(bundle)

    monkeypatch.setattr(animation, "display", collect)
    return bundles


def shown(displayed: list[dict[str, str]], *given: Any, **options: Any) -> str:
    """Return the HTML of an animation."""
    animate(*given, **options)
    return displayed[-1]["text/html"]


def picture_in(page: str) -> Xml.Element:
    """Return the still picture."""
    [data] = re.findall(r'src="data:image/svg\+xml;base64,([^"]+)"', page)
    return Xml.fromstring(base64.b64decode(data))  # noqa: S314


def motion_in(page: str) -> dict[str, Any]:
    """Return what the script is given."""
    [text] = re.findall(r'^(\{"frames".*\})\);$', page, flags=re.MULTILINE)
    motion: dict[str, Any] = json.loads(text)
    return motion


def test_animation_is_html_with_a_text_for_who_cannot_see_it(run: Run, displayed: Any) -> None:
    """The text stands on the picture, escaped, and in words for terminals."""
    page = shown(displayed, run, ALT)
    [alt] = re.findall(r'<img alt="([^"]*)"', page)
    assert html.unescape(alt) == ALT
    assert set(displayed[0]) == {"text/html", "text/plain"}
    assert displayed[0]["text/plain"] == f"Animation: {ALT} (It plays in a browser.)"


def test_animation_fetches_nothing(run: Run, displayed: Any) -> None:
    """No address of any server, no import: it plays without a network."""
    page = shown(displayed, run, ALT)
    assert not re.search(r"https?:|//|import|fetch|src=(?!\"data:)", page)


def test_animation_is_the_same_text_for_the_same_run(run: Run, displayed: Any) -> None:
    """Nothing in it depends on when or where it was made."""
    assert shown(displayed, run, ALT) == shown(displayed, simulate(falling(), 1.0), ALT)


def test_animation_does_not_change_with_the_last_bits(run: Run, displayed: Any) -> None:
    """Errors of 1e-12 m, as between machines, are far below a tenth of a pixel."""
    noise = np.random.default_rng(seed=4).uniform(-1e-12, 1e-12, run.positions.shape)
    other = simulate(falling(), 1.0)
    object.__setattr__(other, "positions", other.positions + noise)
    assert shown(displayed, run, ALT) == shown(displayed, other, ALT)


def test_animations_have_names_of_their_own(run: Run, displayed: Any) -> None:
    """Two on one page do not take each other's figures."""
    names = [
        re.findall(r'data-animation="(run-[0-9a-f]{12})"', page)[0]
        for page in (shown(displayed, run, ALT), shown(displayed, run, ALT, fps=10))
    ]
    assert len(set(names)) == 2
    assert f'("{names[1]}",' in displayed[1]["text/html"]


def test_script_gets_what_it_asks_for(run: Run, displayed: Any) -> None:
    """Every field of the motion that the script reads is there, and none is there in vain."""
    page = shown(displayed, run, ALT)
    read = set(re.findall(r"motion\.(\w+)", page))
    assert read == set(motion_in(page))
    for attribute in ("data-body", "data-contacts"):
        assert f"[{attribute}]" in page


def test_script_is_written_without_its_comments(run: Run, displayed: Any) -> None:
    """They are for who reads the source, not for every notebook."""
    assert not re.search(r"^\s*//", shown(displayed, run, ALT), flags=re.MULTILINE)


def test_motion_ends_where_the_run_ended(run: Run, displayed: Any) -> None:
    """The differences add up: the last picture shows the last state, 30 pictures a second."""
    page = shown(displayed, run, ALT, around=(-5, 5, -1, 4))
    motion = motion_in(page)
    [[x, y, _]] = motion["bodies"]
    scale = 64.0  # px a metre: 10 m on 640 px
    assert (motion["frames"], motion["duration"]) == (31, pytest.approx(1.0))
    expected = 10 * scale * (run.positions[-1, 1] - (-5, 4)) * (1, -1)
    assert np.abs(np.array([sum(x), sum(y)]) - expected).max() <= 0.6  # half a tenth, rounded


def test_still_picture_is_that_of_a_chosen_time(run: Run, displayed: Any) -> None:
    """At the start, or where most is to be seen."""
    places = [
        next(g for g in picture_in(page).iter() if "data-body" in g.attrib).attrib["transform"]
        for page in (
            shown(displayed, run, ALT, around=(-5, 5, -1, 4)),
            shown(displayed, run, ALT, around=(-5, 5, -1, 4), still=1.0),
        )
    ]
    assert places[0] == "translate(320 192)"
    assert places[1] != places[0]


def test_several_runs_stand_side_by_side_with_their_titles(run: Run, displayed: Any) -> None:
    """Both have the same view, and one clock."""
    other = simulate(falling(), 1.0, solver="pymunk")
    page = shown(displayed, {"öurs": run, "pymunk": other}, ALT)
    words = [text.text for text in picture_in(page).iter() if text.tag.endswith("text")]
    assert words[:2] == ["öurs", "pymunk"]
    assert len(motion_in(page)["bodies"]) == 2


def test_several_runs_have_a_view_that_holds_them_all(displayed: Any) -> None:
    """A disc at the origin, and one 9 m to its right: both within the picture."""
    runs = [
        simulate(Scene([Body(Circle(0.5), position=(x, 0), velocity=(1, 0), mass=1.0)]), 0.5)
        for x in (0.0, 9.0)
    ]
    page = shown(displayed, {"left": runs[0], "right": runs[1]}, ALT)
    [[left, *_], [right, *_]] = motion_in(page)["bodies"]
    assert 0 < left[0] < right[0] < 10 * 313  # tenths of a pixel: (640 - 14) / 2 px wide


def test_fastest_velocity_is_a_sixth_of_the_picture(displayed: Any) -> None:
    """0.16 of the larger side: 102.4 px of 640."""
    scene = Scene([Body(Circle(0.5), velocity=(3, 4), mass=1.0)])
    page = shown(displayed, simulate(scene, 0.5), ALT, velocities=True, around=(-5, 5, -1, 4))
    [[_, _, _, vx, vy]] = motion_in(page)["bodies"]
    assert (vx, vy) == ([614], [-819])


def test_velocities_are_drawn_to_one_scale_which_is_written_down(run: Run, displayed: Any) -> None:
    """The fastest of all states has the longest arrow."""
    page = shown(displayed, run, ALT, velocities=True)
    fastest = np.hypot(*run.velocities[:, 1].T).max()
    words = [text.text for text in picture_in(page).iter() if text.tag.endswith("text")]
    assert words[-1] == f"longest arrow {fastest:.3g} m/s"
    assert len(motion_in(page)["bodies"][0]) == 5


def test_contacts_and_names_are_shown_when_asked_for(run: Run, displayed: Any) -> None:
    """Otherwise there are none."""
    page = shown(displayed, run, ALT)
    assert motion_in(page)["contacts"] == [[]]
    page = shown(displayed, run, ALT, contacts=True, names=True)
    assert any(motion_in(page)["contacts"][0])
    assert "1" in [text.text for text in picture_in(page).iter() if text.tag.endswith("text")]


def test_thirty_bodies_over_five_seconds_stay_small(displayed: Any) -> None:
    """A notebook with some of them can still be kept and read."""
    run = simulate(falling(30), 5.0, solver="pymunk")
    assert len(shown(displayed, run, ALT, contacts=True)) < LARGEST


@pytest.mark.parametrize("scene", [Scene(), Scene([Body(Circle(1.0))])], ids=["empty", "static"])
@pytest.mark.parametrize("duration", [0.0, 0.5])
def test_scenes_in_which_nothing_happens_have_an_animation(
    scene: Scene, duration: float, displayed: Any
) -> None:
    """Nothing is divided by a number of bodies, a speed or a duration that is zero."""
    page = shown(
        displayed, simulate(scene, duration), ALT, velocities=True, contacts=True, names=True
    )
    assert motion_in(page)["bodies"] == []


def test_animation_returns_nothing(run: Run, displayed: Any) -> None:
    """The last line of a cell may be `animate(...)`: nothing is displayed twice."""
    assert animate(run, ALT) is None  # type: ignore[func-returns-value]
    assert len(displayed) == 1


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"alt": " "}, "alt must say what the animation shows"),
        ({"runs": {}}, "runs must hold at least one run"),
        ({"fps": 0.0}, "fps must be"),
        ({"seconds": -1.0}, "seconds must be"),
        ({"still": 2.0}, "still must lie between"),
        ({"around": (1, 0, 0, 1)}, "around must"),
    ],
    ids=["no text", "no run", "no pictures", "no time", "no such time", "no view"],
)
def test_bad_arguments_are_refused(run: Run, displayed: Any, change: Any, message: str) -> None:
    """And nothing is displayed."""
    given: dict[str, Any] = {"runs": run, "alt": ALT, **change}
    with pytest.raises(ValueError, match=message):
        animate(**given)
    assert displayed == []
