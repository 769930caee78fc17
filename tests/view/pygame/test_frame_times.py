"""The measurement of frames: its parts, not its times, which no test holds."""

from __future__ import annotations

from lesson_code.chapters.programs import load
from lesson_code.view.pygame.frame_times import frame_times


def test_run_is_measured_in_parts() -> None:
    """Seven frames in parts of three: two whole ones and the rest, each with times above 0."""
    parts = list(frame_times(load("simulator"), 7, 3, shows=True, settings={"balls": 20}))
    assert [(one.first, one.last) for one in parts] == [(0, 3), (3, 6), (6, 7)]
    assert all(one.world > 0 and one.picture > 0 for one in parts)
    assert all(one.within >= max(one.world, one.picture) for one in parts)
