"""How fast the engines are, side by side, as ``workbook measure speed`` prints it.

==============  =======================================================================
module          what it does
==============  =======================================================================
``engines``     gives one scene to each engine
``quality``     measures how deep bodies overlap, and what energy does
``race``        runs the engines in turns, and times them
``piles``       looks for the least that lets a pile hold in each engine, and times that
``few_bodies``  compares the exact solver with pymunk at equal error
``processes``   measures in fresh processes: imports, first runs, memory
``targets``     the ratios and limits to reach
``report``      all results, as tables or as one JSON object
``measure``     chooses what to measure, and does it
``profile``     the time of each stage of the engine in a scene
==============  =======================================================================

The scenes are in :mod:`lesson_code.evidence.scenes.speed`.
"""

from lesson_code.evidence.speed.measure import measure_speed

__all__ = ["measure_speed"]
