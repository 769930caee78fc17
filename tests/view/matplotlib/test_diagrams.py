"""The pipeline diagram: every stage, in order, and nothing written over anything else."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from lesson_code.view.matplotlib import diagrams, style

STAGES = ["detection", "resolution", "post-processing"]
STEPS = {
    "detection": ["broad phase", "narrow phase"],
    "resolution": ["impulse calculation", "position correction", "velocity update"],
    "post-processing": ["callbacks", "effects", "sound"],
}
ALL_STEPS = [step for stage in STAGES for step in STEPS[stage]]


@pytest.fixture
def ax() -> Axes:
    """Return axes of the size the diagram asks for."""
    return style.figure(width=9, height=2.6)[1]  # type: ignore[no-any-return]


def places(ax: Axes) -> dict[str, tuple[float, float]]:
    """Return where each word stands."""
    return {text.get_text(): text.get_position() for text in ax.texts if text.get_text()}


def frames(ax: Axes) -> dict[str, float]:
    """Return how thick the frame round each step is."""
    boxes = [patch for patch in ax.patches if isinstance(patch, FancyBboxPatch)]
    return {
        word: min(
            (box for box in boxes if box.get_bbox().contains(x, y)),
            key=lambda box: box.get_bbox().width,
        ).get_linewidth()
        for word, (x, y) in places(ax).items()
        if word in ALL_STEPS
    }


def test_pipeline_returns_its_axes_without_a_frame(ax: Axes) -> None:
    """A diagram has no scale to show."""
    assert diagrams.pipeline(ax) is ax
    assert not ax.axison


def test_stages_stand_from_left_to_right_and_steps_below_them(ax: Axes) -> None:
    """Data flows to the right through the stages, and downward through the steps of each."""
    where = places(diagrams.pipeline(ax))
    assert list(where) == [word for stage in STAGES for word in (stage, *STEPS[stage])]
    assert [where[stage][0] for stage in STAGES] == sorted(where[stage][0] for stage in STAGES)
    for stage in STAGES:
        column = [where[word] for word in (stage, *STEPS[stage])]
        assert len({x for x, _ in column}) == 1
        assert [y for _, y in column] == sorted((y for _, y in column), reverse=True)


def test_arrows_lead_from_each_stage_to_the_next(ax: Axes) -> None:
    """Two arrows point to the right, each in the gap between two stages."""
    where = places(diagrams.pipeline(ax))
    arrows = [text for text in ax.texts if not text.get_text()]
    centres = [where[stage][0] for stage in STAGES]
    assert len(arrows) == 2
    for arrow, left, right in zip(arrows, centres, centres[1:], strict=False):
        tail, tip = arrow.get_position()[0], arrow.xy[0]  # type: ignore[attr-defined]
        assert left + 1.3 < tail < tip < right - 1.3


@pytest.mark.parametrize("marked", [(), ("impulse calculation",), tuple(ALL_STEPS)])
def test_marked_steps_have_the_thick_frame_and_no_others(ax: Axes, marked: tuple[str, ...]) -> None:
    """A thick frame says which steps a chapter is about."""
    thick = [step for step, width in frames(diagrams.pipeline(ax, marked)).items() if width > 2]
    assert thick == list(marked)


def test_unknown_step_is_refused_by_name(ax: Axes) -> None:
    """The error says which steps there are, and which was asked for; nothing is drawn."""
    with pytest.raises(ValueError, match=r"'broad phase'.*got 'fast phase'"):
        diagrams.pipeline(ax, ["broad phase", "fast phase"])
    assert not ax.patches


def test_unknown_step_with_functions_is_refused_by_name(ax: Axes) -> None:
    """The same for functions that are written below a step."""
    with pytest.raises(ValueError, match=r"functions must hold .*got 'fast phase'"):
        diagrams.pipeline(ax, functions={"fast phase": "sweep"})
    assert not ax.patches


def test_functions_stand_below_the_names_of_their_steps(
    assert_texts_are_clear: Callable[[Figure], None],
) -> None:
    """Each in the box of its step, at the size asked for, two lines of them too."""
    figure, ax = style.figure(width=9, height=4)
    written = {step: f"of_{step.split()[0]}\nand_another" for step in ALL_STEPS}
    where = places(diagrams.pipeline(ax, functions=written))
    for step, text in written.items():
        assert where[text][0] == where[step][0]
        assert 0 < where[step][1] - where[text][1] < diagrams.NAME + 2 * diagrams.LINE
    assert_texts_are_clear(figure)


@pytest.mark.parametrize("size", [(9, 2.6), (9, 2.9), (10.5, 3.4)])
def test_no_word_of_the_pipeline_is_cut_or_written_over_another(
    assert_texts_are_clear: Callable[[Figure], None], size: tuple[float, float]
) -> None:
    """At the size asked for, and larger, every word can be read."""
    figure, ax = style.figure(width=size[0], height=size[1])
    diagrams.pipeline(ax, ALL_STEPS)
    assert_texts_are_clear(figure)


def test_words_stay_within_their_boxes(
    texts_of: Callable[[Figure], dict[Text, Bbox]],
) -> None:
    """Each name fits the innermost box drawn round it."""
    figure, ax = style.figure(width=9, height=2.6)
    diagrams.pipeline(ax)
    texts = texts_of(figure)
    boxes = [patch.get_window_extent() for patch in ax.patches]
    for text, word in texts.items():
        centre = ((word.x0 + word.x1) / 2, (word.y0 + word.y1) / 2)
        box = min((b for b in boxes if b.contains(*centre)), key=lambda b: b.width)
        assert box.x0 < word.x0 < word.x1 < box.x1, text
        assert box.y0 < word.y0 < word.y1 < box.y1, text
