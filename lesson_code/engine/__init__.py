"""The engine: a scene, advanced step by step, or from collision to collision.

Read it in the order in which data flows: scene (what is simulated), tables (the same as rows),
step (all stages in their order), broad_phase, narrow_phase, a file of solvers, touches (callbacks),
recording and run (what is left behind). stepper puts them to work on a scene, and live_world on
bodies that come and go.

continuous splits a step at the impacts of fast bodies. event_driven is the solver that has no step
at all. effects says what of all this a scene calls for, and compiled makes machine code of it.
"""
