"""What a rigid body is to a collision: how its points move, and how hard it is to turn.

=======  ==================================================================  ===========
symbol   meaning                                                             unit
=======  ==================================================================  ===========
v, w     velocity of the centre of mass; angular velocity, counter-          m/s, rad/s
         clockwise
r        from the centre of mass to a point of the body                      m
A, c     area and centroid of a polygon                                      m^2, m
I        moment of inertia about the centre of mass                          kg m^2
p, q     two corners that follow each other, seen from a third point         m
=======  ==================================================================  ===========

A polygon is cut into triangles, each with the sign of p x q, and the triangles are added up.
The signs make the sums right for every polygon whose edges do not cross: in either order,
convex or not, with or without further corners on its edges.
"""

from __future__ import annotations

from typing import Any, TypeAlias

from lesson_code.formulas.arithmetic import cross, dot
from lesson_code.formulas.validation import (
    Number,
    Vector,
    finite,
    formula,
    polygon_vertices,
    positive,
    vector,
)
from lesson_code.formulas.validation import mass as mass_rule

Pair: TypeAlias = tuple[float, float]


@formula(returns_vector=True, velocity=vector, angular_velocity=finite, offset=vector)
def contact_velocity(velocity: Vector, angular_velocity: Number, offset: Vector) -> Any:
    """Return the velocity of a point that is fixed to a moving and turning body.

    v_contact = v + w (-r_y, r_x)

    Parameters
    ----------
    velocity : array_like, shape (..., 2)
        Velocity of the centre of mass, m/s.
    angular_velocity : float or array
        rad/s, counter-clockwise.
    offset : array_like, shape (..., 2)
        r, from the centre of mass to the point, m.

    Returns
    -------
    ndarray, shape (..., 2)
        Velocity of the point, m/s.

    Raises
    ------
    ValueError
        A number is not finite, or a shape is not (..., 2).

    References
    ----------
    Goldstein, Poole and Safko, Classical Mechanics, 3rd ed., section 4.9: v = V + w x r.

    Examples
    --------
    A wheel of 0.5 m that rolls at 3 m/s: the lowest point stands still, the top moves at 6.

    >>> contact_velocity(velocity=(3, 0), angular_velocity=-6, offset=(0, -0.5))
    array([0., 0.])
    >>> contact_velocity(velocity=(3, 0), angular_velocity=-6, offset=(0, 0.5))
    array([6., 0.])
    """
    return (
        velocity[0] - angular_velocity * offset[1],
        velocity[1] + angular_velocity * offset[0],
    )


@formula(vertices=polygon_vertices)
def polygon_area(vertices: Vector) -> float:
    """Return the area of a polygon.

    A = 1/2 abs(sum of p x q)

    Parameters
    ----------
    vertices : array_like, shape (N, 2)
        Corners in order, either way round, m; N >= 3; edges must not cross.

    Returns
    -------
    float
        Area, m^2, > 0.

    Raises
    ------
    ValueError
        A coordinate is not finite, the shape is not (N, 2) with N >= 3, or all corners lie on
        one line.

    References
    ----------
    O'Rourke, Computational Geometry in C, 2nd ed., section 1.3: the area of a polygon.

    Examples
    --------
    >>> polygon_area([(0, 0), (2, 0), (2, 1), (0, 1)])
    2.0
    """
    twice = 0.0
    for k in range(len(vertices)):
        p, q = _edge(vertices, k)
        twice += cross(p, q)
    return abs(twice) / 2


@formula(returns_vector=True, vertices=polygon_vertices)
def polygon_centroid(vertices: Vector) -> Any:
    """Return the centroid of a polygon: the centre of mass of a plate of that shape.

    c = sum of (p + q)/3 (p x q)  /  sum of p x q

    Each triangle counts at its own centroid, a third of the sum of its corners. The mean of
    the corners is another point, unless the polygon is a triangle or regular.

    Parameters
    ----------
    vertices : array_like, shape (N, 2)
        Corners in order, either way round, m; N >= 3; edges must not cross.

    Returns
    -------
    ndarray, shape (2,)
        Centroid, m.

    Raises
    ------
    ValueError
        As for :func:`polygon_area`.

    Examples
    --------
    >>> polygon_centroid([(0, 0), (3, 0), (0, 3)])
    array([1., 1.])
    """
    x, y = _centroid(vertices)
    return vertices[0][0] + x, vertices[0][1] + y


@formula(mass=mass_rule, vertices=polygon_vertices)
def polygon_inertia(mass: Number, vertices: Vector) -> Any:
    """Return the moment of inertia of a polygonal plate about its centroid.

    I = m/6 sum of (p.p + p.q + q.q)(p x q)  /  sum of p x q,   p and q seen from the centroid

    Parameters
    ----------
    mass : float or array
        kg, > 0, spread evenly; ``math.inf`` for what cannot be turned.
    vertices : array_like, shape (N, 2)
        Corners in order, either way round, m; N >= 3; edges must not cross. It does not matter
        where their origin lies.

    Returns
    -------
    float or ndarray
        Moment of inertia, kg m^2, > 0.

    Raises
    ------
    ValueError
        The mass is not > 0, or as for :func:`polygon_area`.

    Examples
    --------
    A square of side 2 m has m (2^2 + 2^2)/12:

    >>> polygon_inertia(mass=3.0, vertices=[(0, 0), (2, 0), (2, 2), (0, 2)])
    2.0
    """
    centroid = _centroid(vertices)
    twice, squares = 0.0, 0.0
    for k in range(len(vertices)):
        p, q = _edge(vertices, k, centroid)
        weight = cross(p, q)
        twice += weight
        squares += (dot(p, p) + dot(p, q) + dot(q, q)) * weight
    return mass * (squares / (6 * twice))


@formula(mass=mass_rule, radius=positive)
def disc_inertia(mass: Number, radius: Number) -> Number:
    """Return the moment of inertia of a disc about its centre.

    I = m r^2 / 2

    Parameters
    ----------
    mass : float or array
        kg, > 0, spread evenly; ``math.inf`` for what cannot be turned.
    radius : float or array
        m, > 0.

    Returns
    -------
    float or array
        Moment of inertia, kg m^2, > 0.

    Raises
    ------
    ValueError
        The mass is not > 0, or the radius is not > 0 or not finite.

    Examples
    --------
    >>> disc_inertia(mass=4, radius=0.5)
    0.5
    """
    return mass * radius * radius / 2


def _edge(r: Vector, k: int, point: Pair = (0.0, 0.0)) -> tuple[Pair, Pair]:
    """Return p and q, the ends of an edge, seen from a point that is itself seen from corner 0.

    Near that corner numbers are small, wherever the origin lies.
    """
    p, q, first = r[k], r[(k + 1) % len(r)], r[0]
    return (
        (p[0] - first[0] - point[0], p[1] - first[1] - point[1]),
        (q[0] - first[0] - point[0], q[1] - first[1] - point[1]),
    )


def _centroid(r: Vector) -> Pair:
    """Return the centroid of a polygon, seen from corner 0."""
    x, y, twice = 0.0, 0.0, 0.0
    for k in range(len(r)):
        p, q = _edge(r, k)
        weight = cross(p, q)
        x, y = x + weight * ((p[0] + q[0]) / 3), y + weight * ((p[1] + q[1]) / 3)
        twice += weight
    return x / twice, y / twice
