"""The engine: a scene, advanced step by step.

Read it in the order in which data flows: scene (what is simulated), tables (the same as rows),
world (the step: the stages in their order), broad_phase, narrow_phase, contact_solver with
contact_motion and two_points, touches (callbacks), recording and run (what is left behind).
"""
