"""The cost of each effect, and the saving without it, as ``workbook measure effects`` prints them.

===========  ===========================================================================
module       what it does
===========  ===========================================================================
``calls``    counts the calls of the functions that only an effect needs
``runners``  gives a scene to our engine or to pymunk, with an effect in or out
``measure``  times them in turns
``result``   the figures and their targets
===========  ===========================================================================

The scenes are in :mod:`lesson_code.evidence.scenes.effects`.
"""

from lesson_code.evidence.effect_costs.measure import measure_effects
from lesson_code.evidence.effect_costs.result import CODES, EffectCost, EffectCosts

stored = EffectCosts.stored

__all__ = ["CODES", "EffectCost", "EffectCosts", "measure_effects", "stored"]
