"""The plan: how it prints, what it answers, and the program that it leaves over."""

from __future__ import annotations

import ast
import re

import pytest

from lesson_code import Body, Circle, Material, Polygon, Scene, simulate
from lesson_code.engine.core.plan import EffectChoice, Plan
from lesson_code.engine.effects.choice import EFFECTS


def discs() -> Scene:
    """Return two discs without friction that hit each other."""
    ball = Material(restitution=0.5)
    return Scene(
        [
            Body(Circle(0.5), mass=1.0, velocity=(2, 0), material=ball),
            Body(Circle(0.5), mass=1.0, position=(2, 0), material=ball),
        ]
    )


CHOICES = (
    EffectChoice("gravity", used=False, called_for=False, reason="g = 0"),
    EffectChoice("friction", used=True, called_for=True, reason="a pair has mu = 0.5"),
    EffectChoice("damping", used=True, called_for=False, reason="the rate is 0"),
    EffectChoice("sleeping", used=False, called_for=True, reason="a < b & so on"),
)

PLAN = Plan("sequential", "asked for", effects=CHOICES)


def test_plan_prints_as_a_table() -> None:
    """A line for the solver, and a row for each effect with verdict and reason."""
    assert str(PLAN).splitlines() == [
        "solver: sequential (asked for); plain Python (a small run)",
        "  gravity   left out      g = 0",
        "  friction  used          a pair has mu = 0.5",
        "  damping   forced        the rate is 0",
        "  sleeping  switched off  a < b & so on",
    ]


def test_plan_is_a_table_in_a_notebook() -> None:
    """The same words, in cells; what means something in HTML is escaped."""
    html = PLAN._repr_html_()
    rows = re.findall(r"<tr><td>(.*?)</td><td>(.*?)</td><td.*?>(.*?)</td></tr>", html)
    assert rows[0] == ("gravity", "left out", "g = 0")
    assert rows[3] == ("sleeping", "switched off", "a &lt; b &amp; so on")
    assert PLAN.headline in html


def test_plan_without_effects_is_a_line() -> None:
    """As other engines have it."""
    plan = Plan("pymunk", "asked for", "C", "pymunk's own")
    assert str(plan) == plan.headline == "solver: pymunk (asked for); C (pymunk's own)"


def test_plan_lists_what_is_used_and_what_is_left_out() -> None:
    """Forced is used; switched off is left out."""
    assert PLAN.used == ("friction", "damping")
    assert PLAN.left_out == ("gravity", "sleeping")
    assert PLAN.effect("damping") is CHOICES[2]


@pytest.mark.parametrize("plan", [PLAN, Plan("pymunk", "asked for")])
def test_plan_refuses_effects_that_it_does_not_know(plan: Plan) -> None:
    """With the names that it knows."""
    names = ", ".join(choice.name for choice in plan.effects) or "none"
    with pytest.raises(ValueError, match=rf"one of the plan's effects \({names}\), got 'spin'"):
        plan.effect("spin")


def test_plan_of_another_engine_has_no_source() -> None:
    """Its program is not ours."""
    with pytest.raises(ValueError, match="solver must be one of ours to have a source here"):
        simulate(discs(), 0.1, solver="pymunk").plan.source()


@pytest.mark.parametrize("solver", ["sequential", "substep", "direct", "naive", "exact"])
def test_plan_of_ours_has_every_effect_and_a_source(solver: str) -> None:
    """The source is a program of functions, each with its docstring."""
    plan = simulate(discs(), 1.0, solver=solver).plan
    assert tuple(choice.name for choice in plan.effects) == tuple(EFFECTS)
    module = ast.parse(plan.source())
    functions = [node for node in module.body if isinstance(node, ast.FunctionDef)]
    assert len(functions) > 3
    assert all(ast.get_docstring(function) for function in functions)


def test_source_holds_less_where_the_scene_needs_less() -> None:
    """Discs without friction, spin and gravity: no line speaks of these."""
    least = simulate(discs(), 0.1, solver="sequential").plan.source()
    every = dict.fromkeys(set(EFFECTS) - {"callbacks"}, True)
    most = simulate(discs(), 0.1, solver="sequential", effects=every).plan.source()
    assert len(least) < len(most) / 2
    for word in ("friction", "gravity", "angle", "tangent_mass", "cos", "asleep", "damping"):
        assert word not in _code(least), word
        assert word in _code(most), word


def _code(source: str) -> str:
    """Return a program without docstrings and comments."""
    module = ast.parse(source)
    for node in module.body:
        if isinstance(node, ast.FunctionDef) and ast.get_docstring(node):
            node.body = node.body[1:] or [ast.Pass()]
    return ast.unparse(module)


def test_plan_is_that_of_the_end_of_the_run() -> None:
    """A step is split at impacts only once a fast body is met: then the source has it."""
    ball = Material(restitution=1.0)
    wall = Body(Polygon.box(1, 9), position=(5, 0), material=ball)

    def source(speed: float) -> str:
        thrown = Body(Circle(0.2), mass=1.0, velocity=(speed, 0), material=ball)
        return simulate(Scene([thrown, wall]), 0.1, solver="sequential").plan.source()

    assert "time_to_impact" not in source(1.0)
    assert "time_to_impact" in source(200.0)
