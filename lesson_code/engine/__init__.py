"""The engine: a scene, advanced step by step, or from collision to collision.

Read it in the order in which data flows: scene (what is simulated), tables (the scene as rows),
step (all stages in their order), broad_phase, narrow_phase, a file of solvers, touches (callbacks),
recording and run (what is left behind). stepper puts them to work on a scene, and live_world on
bodies that come and go.

continuous splits a step at the impacts of fast bodies. event_driven is the solver without time
steps. effects decides which of these parts a scene needs, and compiled makes machine code.
"""
