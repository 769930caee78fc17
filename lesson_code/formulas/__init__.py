"""The lesson's equations: pure functions of numbers, one equation each.

Every function here checks its arguments and takes numbers or arrays that broadcast together;
vectors have shape (..., 2).
"""

from lesson_code.formulas.conservation import angular_momentum, kinetic_energy, momentum
from lesson_code.formulas.contact import effective_mass, friction_impulse, normal_impulse
from lesson_code.formulas.one_dimension import (
    collide_1d,
    elastic_1d,
    inelastic_1d,
    mass_fraction,
)
from lesson_code.formulas.reflection import bounce, reflect, scaled_reflection
from lesson_code.formulas.restitution import energy_lost_1d, reduced_mass, restitution_1d
from lesson_code.formulas.rigid_body import (
    contact_velocity,
    disc_inertia,
    polygon_area,
    polygon_centroid,
    polygon_inertia,
)

__all__ = [
    "angular_momentum",
    "bounce",
    "collide_1d",
    "contact_velocity",
    "disc_inertia",
    "effective_mass",
    "elastic_1d",
    "energy_lost_1d",
    "friction_impulse",
    "inelastic_1d",
    "kinetic_energy",
    "mass_fraction",
    "momentum",
    "normal_impulse",
    "polygon_area",
    "polygon_centroid",
    "polygon_inertia",
    "reduced_mass",
    "reflect",
    "restitution_1d",
    "scaled_reflection",
]
