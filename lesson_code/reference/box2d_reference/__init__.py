"""Reference: Box2D's results for the lesson's scenes.

This is the only package that imports Box2D, and it does so when a scene is run: Box2D is an
optional extra; everything else works without it. The binding, pyb2d3, is of Box2D v3, in single
precision: seven digits.

library
    Box2D itself, or what to install
shapes
    our shapes as Box2D's
surfaces
    our pairs' coefficients as values of Box2D's shapes
scene_run
    a whole scene, stepped by Box2D with every convention mapped
"""

from lesson_code.reference.box2d_reference.scene_run import Box2DStepper

__all__ = ["Box2DStepper"]
