"""The event-driven solver: exact, from collision to collision, with no time step.

Read loop (from event to event), event_prediction (what can happen to a disc), collisions (what then
happens), support (resting), motion, queue and cells. Its discs live each in a time of their own.
solver drives the loop for a scene, as plain Python or compiled. Gravity, friction, turning,
restitution and outlines are in the loop only where the scene calls for them (`effects`).
"""

from lesson_code.engine.event_driven.recording import record_exact
from lesson_code.engine.event_driven.solver import ExactSolver, why_not

__all__ = ["ExactSolver", "record_exact", "why_not"]
