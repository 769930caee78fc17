"""The same scene gives the same bits: twice, in another process, and continued half-way."""

from __future__ import annotations

import hashlib
import subprocess
import sys
from dataclasses import replace

import numpy as np
import tiers
from hypothesis import Phase, given, settings
from hypothesis import strategies as st
from tiers import share

from lesson_code import Body, Circle, Material, Polygon, Run, Scene, Segment, simulate

MATERIAL = Material(restitution=0.9, friction=0.4)


def walls(half: float) -> list[Body]:
    """Return the four walls of a square room."""
    corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    ends = zip(corners, corners[1:] + corners[:1], strict=True)
    return [Body(Segment(start, end), material=MATERIAL) for start, end in ends]


def room(seed: int) -> Scene:
    """Return a room with three discs that fly about."""
    rng = np.random.default_rng(seed)
    discs = [
        Body(
            Circle(rng.uniform(0.2, 0.4)),
            position=(x, rng.uniform(-1, 1)),
            velocity=rng.uniform(-5, 5, 2),
            angular_velocity=rng.uniform(-5, 5),
            mass=rng.uniform(0.5, 2),
            material=MATERIAL,
        )
        for x in (-1, 0, 1)
    ]
    return Scene([*walls(2.0), *discs])


def heap(seed: int) -> Scene:
    """Return 30 discs and boxes in a room, falling onto each other."""
    rng = np.random.default_rng(seed)
    bodies = [
        Body(
            Circle(0.3) if n % 2 else Polygon.box(0.6, 0.4),
            position=(n % 6 - 2.5 + rng.uniform(-0.1, 0.1), n // 6 * 0.7 - 3),
            angle=rng.uniform(-3, 3),
            mass=rng.uniform(0.5, 2),
            material=MATERIAL,
        )
        for n in range(30)
    ]
    return Scene([*walls(3.5), *bodies], gravity=(0, -9.81))


def fingerprint(run: Run) -> str:
    """Return a hash of every bit of a run's states and impulses."""
    digest = hashlib.sha256()
    for array in (run.positions, run.velocities, run.angles, run.angular_velocities):
        digest.update(array.tobytes())
    for array in (run.contacts.point, run.contacts.normal_impulse, run.contacts.tangent_impulse):
        digest.update(array.tobytes())
    return digest.hexdigest()


FRESH = """
import importlib.util, sys
sys.path.append(sys.argv[2])
spec = importlib.util.spec_from_file_location("repeatability", sys.argv[1])
module = importlib.util.module_from_spec(spec)
spec.loader.exec_module(module)
print(module.fingerprint(module.simulate(module.heap(5), 2.0, solver="sequential")))
"""


def test_run_of_a_heap_in_a_fresh_process_has_the_same_bits() -> None:
    """Nothing hangs on hash seeds, addresses, or what ran before."""
    first, again = (simulate(heap(5), 2.0, solver="sequential") for _ in range(2))
    command = [sys.executable, "-c", FRESH, __file__, tiers.__file__.removesuffix("tiers.py")]
    fresh = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    assert len(first.contacts) > 1000
    assert fingerprint(again) == fingerprint(first) == fresh.stdout.strip()


@settings(max_examples=share(10), phases=[Phase.explicit, Phase.generate])
@given(seed=st.integers(0, 10**9))
def test_run_continued_from_a_free_flight_has_the_same_bits(seed: int) -> None:
    """Where nothing overlaps the state is all there is: no clock, no memory of earlier steps."""
    scene = room(seed)
    whole = simulate(scene, 2.0, solver="sequential")
    step = int(np.flatnonzero(whole.max_penetration[:61] == 0)[-1])
    bodies = [
        replace(
            body,
            position=whole.positions[step, n],
            velocity=whole.velocities[step, n],
            angle=float(whole.angles[step, n]),
            angular_velocity=float(whole.angular_velocities[step, n]),
        )
        for n, body in enumerate(scene.bodies)
    ]
    rest = simulate(Scene(bodies), 2.0, solver="sequential")
    steps = len(whole.times) - step
    assert step < round(whole.contacts.time[-1] * 60)
    np.testing.assert_array_equal(rest.positions[:steps], whole.positions[step:])
    np.testing.assert_array_equal(rest.velocities[:steps], whole.velocities[step:])
    np.testing.assert_array_equal(rest.angles[:steps], whole.angles[step:])
