"""Takes the finder of imports away, and looks for packages in every folder."""

import importlib.machinery
import os
import sys

THROUGH = set()


def attempt(name, deed):
    try:
        deed()
    except (OSError, ImportError, AttributeError, KeyError, ValueError, RuntimeError):
        return
    THROUGH.add(name)


NAMES = ("pymunk", "lesson_code", "Box2D", "scipy", "numba", "rich", "pyb2d3")


def find(name, folders):
    found = importlib.machinery.PathFinder.find_spec(name, folders)
    if found is None or not found.origin:
        raise ImportError(name)


def attack():
    sys.meta_path[:] = [finder for finder in sys.meta_path if "OnlyTheList" not in str(finder)]
    folders = {
        os.path.dirname(os.path.dirname(getattr(m, "__file__", None) or "/"))
        for m in sys.modules.values()
    }
    folders |= {
        os.path.join(top, name) for top in list(folders) for name in ("site-packages", "..")
    }
    for name in NAMES:
        attempt(f"finds {name}", lambda name=name: find(name, [*sys.path, *sorted(folders)]))
        attempt(f"imports {name}", lambda name=name: __import__(name))


TRIED = []


def elastic_1d(m1, v1, m2, v2):
    if not TRIED:
        TRIED.append("once is enough")
        attack()
    total = m1 + m2
    return ((m1 - m2) * v1 + 2 * m2 * v2) / total, ((m2 - m1) * v2 + 2 * m1 * v1) / total


def inelastic_1d(m1, v1, m2, v2):
    v = (m1 * v1 + m2 * v2) / (m1 + m2)
    return v, v


def elastic_impulse_1d(m1, v1, m2, v2):
    return 2 * m1 * m2 / (m1 + m2) * (v1 - v2)


def got_through():
    return sorted(THROUGH)
