"""How fast the engines are, side by side, as ``workbook measure speed`` prints it.

==============  =======================================================================
module          what it does
==============  =======================================================================
``whole_runs``  what a user waits for: fresh processes, from the import to the result
``user_program``  the program that these run, for each engine as its user writes it
``engines``     gives one scene to each engine
``quality``     measures how deep bodies overlap, and what energy does
``race``        runs the engines in turns, and times them
``piles``       looks for the least that lets a pile hold in each engine, and times that
``targets``     the ratios and limits to reach
``report``      all results, as tables or as one JSON object
``measure``     chooses what to measure, and does it
``profile``     the time of each stage of the engine in a scene
==============  =======================================================================

The scenes are in :mod:`lesson_code.evidence.scenes.speed`.
"""

from lesson_code.evidence.speed.measure import measure_speed

__all__ = ["measure_speed"]
