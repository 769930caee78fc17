"""The engine: a scene, advanced step by step, or from collision to collision.

Read it in the order in which data flows: scene (what is simulated), tables (the same as rows),
world (the step: the stages in their order), broad_phase, narrow_phase, contact_solver with
contact_motion and two_points, touches (callbacks), recording and run (what is left behind).

continuous splits a step at the impacts of fast bodies. event_driven is the other solver: it has
no step at all.
"""
