"""Figures of chapter 01: two carts, and what two laws say to three formulas."""

from __future__ import annotations

from lesson_code.chapters.ch01_one_dimension import wrong_answers as wrong
from lesson_code.chapters.ch02_restitution.wrong_answers import doubled_impulse
from lesson_code.formulas import elastic_1d
from lesson_code.view.browser.show import show
from lesson_code.view.matplotlib import plots, style

BEFORE = (2.0, -1.0)
"""Velocities, m/s, of carts of 1 kg and 3 kg."""


def before_and_after() -> None:
    """Show two carts before and after an elastic collision."""
    after = elastic_1d(1, BEFORE[0], 3, BEFORE[1])
    fig, ax = style.figure(width=6.4, height=2.8)
    plots.carts(ax, 1, [BEFORE, after], 3, ["before", "after an elastic collision"])
    show(
        fig,
        "Two carts. Before: cart 1 (1 kg) at +2 m/s, cart 2 (3 kg) at -1 m/s. After: cart 1 at "
        "-2.5 m/s, cart 2 at +0.5 m/s.",
    )


def two_laws() -> None:
    """Show momentum and energy before and after, by the right formula and by two wrong ones."""
    answers = {
        "right": elastic_1d(1, BEFORE[0], 3, BEFORE[1]),
        "impulse doubled": doubled_impulse(1, BEFORE[0], 3, BEFORE[1], 1.0),
        "always swaps": wrong.always_swaps(1, BEFORE[0], 3, BEFORE[1]),
    }
    cases, start = list(answers), BEFORE
    momenta = [(a, 3 * b) for a, b in (start, *answers.values())]
    energies = [(a**2 / 2, 3 * b**2 / 2) for a, b in (start, *answers.values())]
    fig, (left, right) = style.figure(2, width=10.5, height=3.6)
    plots.before_and_after(left, cases, [momenta[0]] * 3, momenta[1:], "momentum, kg m/s")
    plots.before_and_after(right, cases, [energies[0]] * 3, energies[1:], "energy, J")
    left.get_legend().remove()
    show(
        fig,
        "Momentum and energy of a pair before and after, for the right formula and two wrong ones. "
        "The doubled impulse keeps the momentum but multiplies the energy; the swap keeps neither.",
    )
