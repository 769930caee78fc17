"""Collisions: some two bodies may meet within the run.

Without them there is nothing to find, to solve or to tell, and bodies fly freely.
"""

from __future__ import annotations

from lesson_code.engine.effects.facts import Facts
from lesson_code.engine.effects.question import Effect, Finding, Rule


def rule(facts: Facts) -> Finding:
    """Ask whether any two bodies can meet, one of which can be pushed."""
    if facts.free_count > 0 and facts.body_count > 1 and facts.flights_meet:
        return Finding(True, "two bodies can meet")
    return Finding(False, "no two bodies can meet within the run")


EFFECT = Effect(
    rule=rule,
    place=10,
    functions=("find_pairs", "find_contacts", "prepare", "resolve"),
    needs_collisions=False,
)


def where_bodies_meet(facts: Facts, rule_of_effect: Rule) -> Finding:
    """Ask the rule of an effect that matters only if two bodies can meet."""
    meeting = rule(facts)
    return rule_of_effect(facts) if meeting.called_for else meeting
