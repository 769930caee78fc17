# ---
# jupyter:
#   kernelspec:
#     display_name: Python 3 (ipykernel)
#     language: python
#     name: python3
# ---

# %% [markdown]
# # Exercise 06: SAT and manifolds
#
# Six functions to write, twenty points. Read notebook [06](../notebooks/06_sat_and_manifolds.ipynb)
# first. The first four build on each other: together they are the separating axis test.
#
# - Replace the `raise` line of each function with your answer. Do not change its name or its
#   arguments.
# - Run the cell below it. It calls your function with new numbers each time, and says what is
#   right and what is not.
# - You may add cells and helper functions of your own, and call the functions of earlier tasks.
#   Formulas from `lesson_code` do not count: imports of it are left out when your work is graded.
# - `workbook grade exercises/06_sat_and_manifolds.ipynb` marks the whole file.
#
# A polygon is convex. Its vertices are a NumPy array of shape (N, 2), counter-clockwise. The last
# edge leads from the last vertex back to the first. Normals have length 1. You may return arrays,
# lists or tuples.

# %%
import numpy as np

from lesson_code.course.grading import check_task

# %% [markdown]
# Two helpers from earlier chapters, to use as you like.


# %%
def cross(a, b):
    """Return a_x b_y - a_y b_x: positive when b lies counter-clockwise of a."""
    return a[0] * b[1] - a[1] * b[0]


def closest_point_on_segment(point, start, end):
    """Return the point of the segment from `start` to `end` that is closest to `point`."""
    way = end - start
    part = (point - start) @ way / (way @ way)
    return start + min(max(part, 0.0), 1.0) * way


# %% [markdown]
# ## Task 6.1 The axes (4 points)
#
# Return the unit normals of all edges. Order and sign are up to you, and an axis may come twice.
# Two neighbouring vertices may coincide. There is no edge between them: leave it out.


# %% tags=["task"]
def sat_axes(vertices):
    """Return the unit normal of each edge, as a list of axes."""
    edges = np.roll(vertices, -1, axis=0) - vertices
    return [np.array([y, -x]) / np.hypot(x, y) for x, y in edges if x or y]


# %% tags=["check", "nbval-check-output"]
check_task("6.1", sat_axes)

# %% [markdown] tags=["solution"]
# **Why.** `np.roll` puts the first vertex behind the last one, so no edge is forgotten. An edge
# turned by -90 degrees points out of a counter-clockwise polygon.

# %% [markdown]
# ## Task 6.2 The shadow (2 points)
#
# Return the shadow of a polygon on an axis through the origin: the pair (low, high).


# %% tags=["task"]
def project(vertices, axis):
    """Return (low, high), the interval that the polygon covers along a unit axis."""
    values = vertices @ axis
    return min(values), max(values)


# %% tags=["check", "nbval-check-output"]
check_task("6.2", project)

# %% [markdown] tags=["solution"]
# **Why.** The dot product says how far a vertex lies along the axis. A polygon reaches no farther
# than its vertices.

# %% [markdown]
# ## Task 6.3 The overlap of two shadows (3 points)
#
# Intervals are pairs (low, high). Return how far B must move along the axis, the shorter way, to
# be out of A: a length, whichever way it goes. Return `None` where they do not overlap. Touching
# is not overlapping.


# %% tags=["task"]
def overlap(interval_a, interval_b):
    """Return the shorter way by which B leaves A, or None without an overlap."""
    (low_a, high_a), (low_b, high_b) = interval_a, interval_b
    depth = min(high_a - low_b, high_b - low_a)
    return depth if depth > 0 else None


# %% tags=["check", "nbval-check-output"]
check_task("6.3", overlap)

# %% [markdown] tags=["solution"]
# **Why.** B leaves to the right after `high_a - low_b` and to the left after `high_b - low_a`. This
# holds too when one interval lies inside the other. The common part is then too short.

# %% [markdown]
# ## Task 6.4 The minimum translation vector (4 points)
#
# Return the pair (normal, depth): B moved by depth times normal is just out of A, and no shorter
# move does it. The normal points from A to B. Return `None` where the polygons do not overlap.


# %% tags=["task"]
def mtv(vertices_a, vertices_b):
    """Return (normal, depth) of the shortest move of B out of A, or None without an overlap."""
    best = None
    for axis in [*sat_axes(vertices_a), *sat_axes(vertices_b)]:
        (low_a, high_a), (low_b, high_b) = project(vertices_a, axis), project(vertices_b, axis)
        for normal, depth in ((axis, high_a - low_b), (-axis, high_b - low_a)):
            if depth <= 0:
                return None
            if best is None or depth < best[1]:
                best = normal, depth
    return best


# %% tags=["check", "nbval-check-output"]
check_task("6.4", mtv)

# %% [markdown] tags=["solution"]
# **Why.** Each axis gives two ways out, one in each direction. The shortest of all is the answer,
# and it brings its direction with it. Where a shape has its position plays no part.

# %% [markdown]
# ## Task 6.5 Clip a segment at a line (3 points)
#
# The line is all points p with p . normal = offset. Return the part of the segment on the inner
# side, p . normal <= offset, as the pair (start, end) in the same direction. Return `None` where
# nothing is left, not even a point. Where a point is left alone, it is both start and end.


# %% tags=["task"]
def clip(start, end, normal, offset):
    """Return (start, end) of the part of a segment with p . normal <= offset, or None."""
    beyond_start, beyond_end = np.dot(start, normal) - offset, np.dot(end, normal) - offset
    if beyond_start > 0 and beyond_end > 0:
        return None
    if beyond_start <= 0 and beyond_end <= 0:
        return start, end
    crossing = start + beyond_start / (beyond_start - beyond_end) * (end - start)
    return (crossing, end) if beyond_start > 0 else (start, crossing)


# %% tags=["check", "nbval-check-output"]
check_task("6.5", clip)

# %% [markdown] tags=["solution"]
# **Why.** Along the segment the distance from the line changes evenly. It is zero at the part
# `beyond_start / (beyond_start - beyond_end)` of the way, which is where the cut is made.

# %% [markdown]
# ## Task 6.6 A circle and a polygon (4 points)
#
# Return the pair (normal, depth) for a circle that overlaps a polygon, or `None`. The normal points
# from the polygon to the circle: the circle moved by depth times normal just touches. A circle that
# only touches does not overlap. The centre may lie inside the polygon, but not exactly on an edge.


# %% tags=["task"]
def circle_against_polygon(centre, radius, vertices):
    """Return (normal, depth) of a circle that overlaps a polygon, or None."""
    edges = list(zip(vertices, np.roll(vertices, -1, axis=0), strict=True))
    ways = [centre - closest_point_on_segment(centre, a, b) for a, b in edges]
    way = min(ways, key=lambda v: np.hypot(v[0], v[1]))
    distance = np.hypot(way[0], way[1])
    if all(cross(b - a, centre - a) > 0 for a, b in edges):  # the centre is inside
        return -way / distance, radius + distance
    return (way / distance, radius - distance) if distance < radius else None


# %% tags=["check", "nbval-check-output"]
check_task("6.6", circle_against_polygon)

# %% [markdown] tags=["solution"]
# **Why.** From outside, the closest point pushes the centre away from itself. From inside, the
# way out leads through the closest point, and one radius farther.
