"""The engine's plan for a live world: what its bodies call for, and what runs all the same."""

from __future__ import annotations

from lesson_code.engine.compiled.library import why_no_compiler
from lesson_code.engine.core.plan import Plan
from lesson_code.engine.core.scene import Scene
from lesson_code.engine.effects.choice import choose_effects
from lesson_code.engine.effects.question import Question
from lesson_code.engine.live_world import WORTH_COMPILING, LiveWorld

FORCED = (
    "Forced: the scene does not call for it, and this world reckons with it all the same, so that "
    "its program stays as it is when bodies join. That changes no digit of the result. "
    "Flashes and sounds are no callbacks of the scene: they are told after each step."
)
"""What the page has to say beside the table."""


def live_plan(world: LiveWorld) -> Plan:
    """Return what the bodies call for as they are now, and what the world reckons with.

    The rules are those of every run; its end is not known. Callbacks are no part of the scene: a
    live world tells them after a step.

    Examples
    --------
    >>> from lesson_code import Body, Circle
    >>> world = LiveWorld([Body(Circle(1), mass=1.0), Body(Circle(1), position=(0, 3), mass=1.0)])
    >>> plan = live_plan(world)
    >>> [(name, plan.effect(name).verdict) for name in ("collisions", "friction", "sleeping")]
    [('collisions', 'used'), ('friction', 'forced'), ('sleeping', 'left out')]
    """
    scene = Scene(world.bodies(), world.gravity, world.damping)
    question = Question(scene, dt=world.dt, combine=world.combine)
    return Plan(
        solver="sequential",
        reason="as in every program",
        code="compiled" if world.compiled else "plain Python",
        code_reason="many bodies" if world.compiled else _why_plain(world),
        effects=choose_effects(question, dict.fromkeys(effects_run(world), True)),
    )


def _why_plain(world: LiveWorld) -> str:
    """Return why a world is not in machine code."""
    if len(world) < WORTH_COMPILING:
        return f"fewer than {WORTH_COMPILING} bodies"
    return why_no_compiler() or "machine code is still to be made"


def effects_run(world: LiveWorld) -> tuple[str, ...]:
    """Return the names of the effects that a live world reckons with, whatever is in it."""
    pipeline = world.pipeline
    stages = {
        "broad_phase": world.broad_phase == "uniform_grid",
        "continuous": pipeline.is_continuous,
        "callbacks": pipeline.listener is not None,
        "impulse_record": pipeline.keeps_impulses,
    }
    return tuple(name for name, runs in {**pipeline.effects._asdict(), **stages}.items() if runs)
