"""The linker: what a program is made of, and that it does what the functions it is made of do."""

from __future__ import annotations

import ast
import dis
import importlib.util
import inspect
import itertools
import sys
import textwrap
import types
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from lesson_code import MixingRule, Scene
from lesson_code.engine.compiled import link, linker
from lesson_code.engine.core import contact_frame
from lesson_code.engine.core.broad_phase import longest_way
from lesson_code.engine.core.capacity import add_capacity
from lesson_code.engine.core.pipeline import Pipeline
from lesson_code.engine.core.rows import World
from lesson_code.engine.core.step import advance, rigid_part
from lesson_code.engine.core.tables import BROAD_PHASES
from lesson_code.engine.effects.flags import EVERY_EFFECT, Effects
from lesson_code.engine.solvers import our_solvers
from lesson_code.engine.solvers import sequential as contact_solver
from lesson_code.engine.stepper import EngineStepper
from lesson_code.evidence.scenes.events import balls_at_wall, turning_rod
from lesson_code.evidence.scenes.gas import gas_of
from lesson_code.evidence.scenes.speed import bin_of_shapes
from lesson_code.formulas import elastic_1d

Make = Callable[..., types.ModuleType]

numbers = itertools.count()


@pytest.fixture
def make(tmp_path: Path) -> Iterator[Make]:
    """Return a way to make modules of this project, from source."""
    names: list[str] = []

    def made(source: str, **names_in_it: Any) -> types.ModuleType:
        name = f"lesson_code.made_up_{next(numbers)}"
        path = tmp_path / f"{name}.py"
        path.write_text(textwrap.dedent(source))
        spec = importlib.util.spec_from_file_location(name, path)
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        vars(module).update(names_in_it)
        names.append(name)
        sys.modules[name] = module
        spec.loader.exec_module(module)
        return module

    yield made
    for name in names:
        del sys.modules[name]


def run(source: str) -> dict[str, Any]:
    """Return what stands in a program, as plain Python."""
    program: dict[str, Any] = {}
    exec(compile(source, "program", "exec"), program)  # noqa: S102 - our own
    return program


def body(source: str, name: str) -> list[str]:
    """Return the statements of a function of a program, as text."""
    [found] = [
        f for f in ast.parse(source).body if isinstance(f, ast.FunctionDef) and f.name == name
    ]
    return [ast.unparse(statement) for statement in found.body]


# What is taken


def test_function_in_which_nothing_is_decided_is_taken_as_it_stands() -> None:
    """The very text that a reader is shown, comments and all."""
    assert inspect.getsource(contact_frame.central_velocity).rstrip() in link(
        contact_frame.central_velocity
    )
    program = link(longest_way)
    assert inspect.getsource(longest_way).rstrip() in program
    assert program.startswith("from __future__ import annotations\n\nimport math\n\n\ndef longest")


@pytest.mark.parametrize("function", [
    contact_solver.solve_contact, contact_solver.pseudo_speed_of,
    contact_solver.solve_pseudo_velocity,
    contact_frame.apply_impulses, contact_frame.set_frame,
], ids=lambda function: function.__name__)  # fmt: skip
def test_lines_that_the_lesson_shows_are_lines_of_the_program(function: Any) -> None:
    """What `inspect.getsource` shows of a visit is what runs."""
    stages = our_solvers()["sequential"].stages_for({})
    pipeline = Pipeline(rigid_part, BROAD_PHASES["uniform_grid"], stages)
    assert inspect.getsource(function).rstrip() in link(advance, pipeline=pipeline)


def test_functions_stand_after_those_that_they_call(make: Make) -> None:
    """Each once, however often it is called."""
    module = make("""
        def low(x):
            return x + 1

        def middle(x):
            return low(x) * low(x)

        def high(x):
            return middle(x) - low(x)
        """)
    source = link(module.high)
    names = [node.name for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]
    assert names == ["low", "middle", "high"]
    assert run(source)["high"](2) == 6


def test_functions_of_one_name_from_two_modules_are_both_taken(make: Make) -> None:
    """The second is given its module's name too, and each call finds its own."""
    other = make("def size(x):\n    return 10 * x\n")
    module = make("""
        def size(x):
            return x

        def both(x):
            return size(x) + other.size(x)
        """, other=other)  # fmt: skip
    source = link(module.both)
    assert source.count("def size(") == 1
    assert source.count(f"def {other.__name__.rpartition('.')[2]}_size(") == 1
    assert run(source)["both"](1) == 11


def test_formula_is_taken_without_the_door_that_checks_its_numbers() -> None:
    """The bare lines: what `equation` gives."""
    source = link(contact_frame.set_frame)
    assert "def effective_mass(" in source
    assert "@" not in source


# What is worked out


def test_equation_that_a_formula_asks_for_by_name_is_taken_too() -> None:
    """`equation(collide_1d)(...)` skips the door in Python, and is a plain call in a program."""
    source = link(inspect.unwrap(elastic_1d))
    assert "    return collide_1d(m1, v1, m2, v2, 1)" in source
    assert "def mass_fraction(" in source
    assert "equation" not in source


def test_branches_that_cannot_be_reached_disappear(make: Make) -> None:
    """Of an `if`, of `a if b else c`, of `and` and `or`; what is not decided stays."""
    module = make("""
        def f(x, stages, listener):
            if stages.outlines:
                x += 1
            elif x > 5:
                x += 2
            if listener is not None:
                listener.hear(x)
            if stages.manifolds and x > 1:
                x += 4
            if stages.rotation and x > 1:
                x += 8
            return x if stages.internal_edges else -x
        """)
    flags = Effects(outlines=False, manifolds=False, rotation=True, internal_edges=False)
    source = link(module.f, stages=flags, listener=None)
    assert body(source, "f") == [
        "if x > 5:\n    x += 2",
        "if x > 1:\n    x += 8",
        "return -x",
    ]
    for x in (0, 2, 6):
        assert run(source)["f"](x) == module.f(x, flags, None)


def test_lines_after_a_return_that_is_certain_disappear(make: Make) -> None:
    """And what only they would have called."""
    module = make("""
        def costly(x):
            return x

        def f(x, listener):
            if listener is None:
                return x
            return costly(x)
        """)
    assert body(link(module.f, listener=None), "f") == ["return x"]
    assert "costly" not in link(module.f, listener=None)


def test_block_that_is_left_empty_still_is_a_block(make: Make) -> None:
    """A loop that has nothing to do any more does nothing."""
    module = make("""
        def f(x, listener):
            for _ in range(3):
                if listener is not None:
                    x += 1
            return x
        """)
    source = link(module.f, listener=None)
    assert body(source, "f")[0] == "for _ in range(3):\n    pass"
    assert run(source)["f"](7) == 7


def test_arguments_that_are_known_disappear_from_call_and_function(make: Make) -> None:
    """And a call of a stage is a call of the function that it stands for."""
    module = make("""
        def add(x, y=2):
            return x + y

        def twice(stage, x, y):
            return stage(stage(x, y), y)

        def f(x, stages):
            stage, y = stages.stage, 3
            return twice(stage, x, y)
        """)

    class Stages(tuple[Any, ...]):
        """Stands for a named tuple."""

        _fields = ("stage",)
        stage = staticmethod(module.add)

    source = link(module.f, stages=Stages())
    assert body(source, "f") == ["y = 3", "return twice(x, y)"]
    assert body(source, "twice") == ["return add(add(x, y), y)"]
    assert run(source)["f"](1) == 7


def test_function_with_other_stages_is_another_function(make: Make) -> None:
    """Once for each of them."""
    module = make("""
        def one(x):
            return x + 1

        def two(x):
            return x + 2

        def through(stage, x):
            return stage(x)

        def f(x):
            return through(one, x) * through(two, x) * through(one, x)
        """)
    source = link(module.f)
    assert source.count("through(x: ") + source.count("through(x)") == 5  # two of them defined
    assert run(source)["f"](1) == 12


def test_local_name_hides_that_of_the_module(make: Make) -> None:
    """A parameter or a variable is no constant, whatever the module calls so."""
    module = make("""
        SIZE = 5.0
        count = 3

        def f(SIZE):
            count = SIZE + 1
            return count
        """)
    source = link(module.f)
    assert "SIZE = 5.0" not in source
    assert run(source)["f"](1) == 2


# Constants and other names


def test_constants_stand_at_the_top_with_their_values_of_now(make: Make) -> None:
    """Another value makes another program."""
    module = make("""
        import math
        SHARE, NAME, MOST = 0.1 + 0.2, "disc", math.inf

        def f(x):
            return SHARE if x < MOST else NAME
        """)
    source = link(module.f)
    for line in ("SHARE = 0.30000000000000004", "MOST = float('inf')", "NAME = 'disc'"):
        assert f"\n{line}\n" in source
    assert run(source)["f"](1) == 0.1 + 0.2
    module.SHARE = 0.5
    assert link(module.f) != source
    assert run(link(module.f))["f"](1) == 0.5


def test_program_is_linked_once_until_something_in_it_changes(make: Make) -> None:
    """A constant, a function that is called, or one that is bound: what it depends on."""
    source = """
        SHARE = 0.5

        def share(x):
            return SHARE * x

        def f(x, then):
            return then(share(x))

        def twice(x):
            return 2 * x
        """
    module = make(source)
    first = link(module.f, then=module.twice)
    assert link(module.f, then=module.twice) is first
    module.SHARE = 0.25
    changed = link(module.f, then=module.twice)
    assert run(changed)["f"](1) == 0.5
    module.share = module.twice
    assert run(link(module.f, then=module.twice))["f"](1) == 4
    assert run(link(module.f, then=module.share))["f"](1) == 4


def modules_of(*folders: str) -> list[Path]:
    """Return the files of some wings of the house."""
    house = Path(inspect.getfile(linker)).parents[2]
    return [path for folder in folders for path in sorted((house / folder).rglob("*.py"))]


def test_source_of_a_function_ends_where_the_parser_says() -> None:
    """The linker does not parse modules: it takes a function up to the next line at the margin."""
    for path in modules_of("engine", "geometry", "formulas"):
        text = path.read_text(encoding="utf-8")
        lines = text.splitlines()
        parsed = {
            node.name: "\n".join(lines[node.lineno - 1 : node.end_lineno])
            for node in ast.parse(text).body
            if isinstance(node, ast.FunctionDef)
        }
        found = {match[1]: match[0].rstrip() for match in linker.FUNCTION.finditer(text)}
        assert found == parsed, path.name


@pytest.mark.parametrize("value", [float("-inf"), (0.5, float("inf")), 2**40, -0.0, 1e-320])
def test_constant_of_any_size_keeps_its_bits(make: Make, value: Any) -> None:
    """Infinities too, which have no literal."""
    module = make("def f():\n    return VALUE\n", VALUE=value)
    assert repr(run(link(module.f))["f"]()) == repr(value)


def test_constant_with_two_values_in_two_modules_is_refused(make: Make) -> None:
    """There is but one top of a program."""
    other = make("SHARE = 0.5\n\ndef g(x):\n    return SHARE * x\n")
    module = make("""
        SHARE = 0.25

        def f(x):
            return SHARE * other.g(x)
        """, other=other)  # fmt: skip
    with pytest.raises(TypeError, match="SHARE in g must have one value in the whole program"):
        link(module.f)


@pytest.mark.parametrize("value", [[1.0], {"a": 1}, {1.0}, np.zeros(2)])
def test_name_that_stands_for_nothing_a_program_can_hold_is_refused(make: Make, value: Any) -> None:
    """The error names it, where it is used, and what it is."""
    module = make("def f(x):\n    return TABLE\n", TABLE=value)
    with pytest.raises(TypeError, match="TABLE in f must be a function, class or constant: "):
        link(module.f)


# The engine

EFFECTS = {
    "every effect": EVERY_EFFECT,
    "discs and walls": Effects(manifolds=False),
    "smooth discs": Effects(
        outlines=False, manifolds=False, internal_edges=False, friction=False, rotation=False
    ),
    "a flight": Effects(collisions=False),
    "sleep": Effects(sleeping=True),
}


@pytest.mark.one_in(9)
@pytest.mark.parametrize("effects", EFFECTS.values(), ids=EFFECTS)
@pytest.mark.parametrize("broad_phase", BROAD_PHASES)
@pytest.mark.parametrize("solver", ["sequential", "substep", "naive"])
def test_program_of_the_engine_is_python(solver: str, broad_phase: str, effects: Effects) -> None:
    """One entry with the tables as its only argument, and no name that stands for nothing."""
    make_part = our_solvers()[solver].make_part
    for splits_steps in (True, False):
        pipeline = Pipeline(
            make_part, BROAD_PHASES[broad_phase], our_solvers()[solver].stages_for({}), None,
            effects,
            splits_steps=splits_steps,
        )  # fmt: skip
        source = link(advance, pipeline=pipeline)
        program = run(source)
        assert list(inspect.signature(program["advance"]).parameters) == ["world"]
        functions = [f for f in program.values() if isinstance(f, types.FunctionType)]
        used = {name for function in functions for name in globals_of(function)}
        assert used - program.keys() <= set(program["__builtins__"])
        assert ("time_to_impact" in source) == splits_steps
        assert "pipeline" not in source.replace("the pipeline", "")


def globals_of(function: types.FunctionType) -> set[str]:
    """Return the global names that a function uses."""
    instructions = dis.get_instructions(function)
    return {step.argval for step in instructions if step.opname == "LOAD_GLOBAL"}


def cornered() -> Scene:
    """Return boxes, triangles, pentagons and discs in a bin."""
    return bin_of_shapes(12).scene


SCENES = {
    "a gas": gas_of(30, 0.4, seed=2),
    "a bin": cornered(),
    "fast balls": balls_at_wall(80.0, count=6, dt=1 / 60),
    "a turning rod": turning_rod(40.0, phase=0.3, dt=1 / 60),
}


def at_work(scene: Scene, solver: str) -> EngineStepper:
    """Return a solver at work on a scene."""
    return EngineStepper(
        scene, solver=solver, dt=1 / 60, iterations=4, substeps=2, combine=MixingRule()
    )


@pytest.mark.one_in(9)
@pytest.mark.parametrize("scene", SCENES.values(), ids=SCENES)
@pytest.mark.parametrize("solver", ["sequential", "substep", "naive"])
def test_program_as_plain_python_has_the_bits_of_the_functions(
    scene: Scene, solver: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What the linker works out and leaves out changes nothing; in every sort of pipeline."""
    usual = at_work(scene, solver)
    usual.advance(40)
    called_for = usual.pipeline.effects
    every = EVERY_EFFECT._replace(continuous=called_for.continuous)  # which some solvers lack
    for broad_phase, effects in (("uniform_grid", every), ("", called_for)):
        linked = at_work(scene, solver)
        pipeline = linked.pipeline._replace(effects=effects, splits_steps=True)
        if broad_phase:
            pipeline = pipeline._replace(broad_phase=BROAD_PHASES[broad_phase])
        program = run(link(advance, pipeline=pipeline))["advance"]
        linked.world = advanced(program, linked.world, usual.world.state.steps_done)
        assert linked.states().tobytes() == usual.states().tobytes()


@pytest.mark.parametrize("law", ["newton", "energetic"])
def test_stages_of_the_direct_solver_are_imported(law: str) -> None:
    """They stay outside; a rule for impacts comes with them. The bits are the same."""
    usual, linked = (
        EngineStepper(
            cornered(), solver="direct", dt=1 / 60, iterations=1, substeps=1,
            combine=MixingRule(),
            options={"restitution_law": law},
            splits_steps=True,
        )
        for _ in range(2)
    )  # fmt: skip
    usual.advance(20)
    source = link(advance, pipeline=linked.pipeline)
    assert "from lesson_code.engine.solvers.direct import solve as direct_solve" in source
    linked.world = advanced(run(source)["advance"], linked.world, 20)
    assert (linked.states() + 0.0).tobytes() == (usual.states() + 0.0).tobytes()


def advanced(program: Callable[[World], bool], world: World, steps: int) -> World:
    """Return the tables after so many steps by a program; its impulses are thrown away."""
    world.state.steps_left = steps
    while not program(world):
        world.state.impulse_count = 0
        world = add_capacity(world)
    return world
