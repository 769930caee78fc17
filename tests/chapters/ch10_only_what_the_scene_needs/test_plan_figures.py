"""The table of plans has a dot where an effect is used."""

from __future__ import annotations

from collections.abc import Callable

import pytest
from matplotlib.figure import Figure

from lesson_code import Body, Circle, Scene, simulate
from lesson_code.chapters.ch10_only_what_the_scene_needs import plan_figures as plan_plots
from lesson_code.engine.core.plan import Plan
from lesson_code.view.matplotlib import style

DISCS = [Body(Circle(0.5), mass=1.0, position=(3.0 * n, 0)) for n in range(2)]
CALM, FALLING = Scene(DISCS), Scene(DISCS, gravity=(0, -10))


def planned() -> dict[str, Plan]:
    """Return the plans of a scene without gravity, and of one with it."""
    return {
        name: simulate(scene, 0.1, solver="sequential").plan
        for name, scene in (("calm", CALM), ("falling", FALLING))
    }


def test_plans_have_a_dot_for_each_effect_in_each_scene() -> None:
    """Full ones where it is used, rings where it is not: two sets for each scene."""
    plans = planned()
    _, ax = style.figure(width=6, height=5)
    plan_plots.plans(ax, plans)
    names = [label.get_text() for label in ax.get_yticklabels()]
    seen = [sorted(names[int(y)] for _, y in dots.get_offsets()) for dots in ax.collections]
    wanted = [sorted(group) for plan in plans.values() for group in (plan.used, plan.left_out)]
    assert seen == wanted
    assert [label.get_text() for label in ax.get_xticklabels()] == ["calm", "falling"]


def test_plans_can_be_read(assert_texts_are_clear: Callable[[Figure], None]) -> None:
    """No word is cut or written over another."""
    figure, ax = style.figure(width=6, height=5)
    plan_plots.plans(ax, planned())
    assert_texts_are_clear(figure)


def test_plans_of_other_engines_are_refused() -> None:
    """A plan without effects has no row in the table."""
    _, ax = style.figure()
    with pytest.raises(ValueError, match="planned must hold plans that name the same effects"):
        plan_plots.plans(ax, {**planned(), "other": Plan("pymunk", "asked for")})
