"""``workbook measure``: the figures that the workbook states, measured again."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console
from rich.table import Table

from lesson_code.cli.shared import AsJson, clear_errors, console, errors, print_json, share_bar

if TYPE_CHECKING:
    from lesson_code.evidence.measurement import Measurement

measure = typer.Typer(no_args_is_help=True, help="Measure the figures that the workbook states.")

TABLE_WIDTH = 100
"""Columns that the widest tables need."""

Workers = Annotated[
    int | None,
    typer.Option(min=1, help="Processes that share the work; one for each core by default."),
]
Cluster = Annotated[
    str | None,
    typer.Option(
        metavar="ADDRESS",
        help='Share the work over a dask cluster: tcp://HOST:PORT, or "local" to start one here.',
    ),
]


@measure.command("chaos")
def measure_chaos(
    runs: Annotated[int, typer.Option(min=1, help="How many disturbed runs.")] = 28,
    workers: Workers = None,
    cluster: Cluster = None,
    as_json: AsJson = False,
) -> None:
    """How fast two gases of discs part that began almost alike."""
    from lesson_code.evidence import chaos

    with clear_errors():
        measured = chaos.measure_chaos(runs, workers=workers, cluster=cluster, progress="runs")
    if as_json:
        print_json(measured.as_dict())
    else:
        console.print(measured.as_table())


@measure.command("figures")
def measure_figures(
    only: Annotated[
        list[str] | None, typer.Option("--only", metavar="NAME", help="Only what begins so: ch03.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """How long each live figure takes, in Chromium, from a move of the pointer to its picture."""
    from lesson_code.view.browser.answer_times import measure_answers

    with clear_errors():
        measured = measure_answers(only)
    _show(measured, as_json)


@measure.command("frames")
def measure_frames(
    only: Annotated[
        list[str] | None, typer.Option("--only", metavar="PROGRAM", help="Only this program.")
    ] = None,
    frames: Annotated[int, typer.Option(min=1, help="Frames of each program.")] = 600,
    part: Annotated[int, typer.Option(min=1, help="Frames that a line stands for.")] = 600,
    balls: Annotated[int, typer.Option(min=0, max=600, help="In the simulator.")] = 500,
    shows: Annotated[bool, typer.Option("--shows", help="With all arrows and values.")] = False,
) -> None:
    """How long the frames of the programs take at 1920 x 1080, in ms of the processor."""
    from lesson_code.chapters.programs import load, program_summaries
    from lesson_code.view.pygame.frame_times import frame_times

    table = Table("program", "frames", "world", "picture", "95 % within")
    with clear_errors():
        for name in only or program_summaries():
            settings = {"balls": balls} if name == "simulator" else {}
            for one in frame_times(load(name), frames, part, shows=shows, settings=settings):
                ms = (f"{value:.2f}" for value in (one.world, one.picture, one.within))
                table.add_row(name, f"{one.first + 1} to {one.last}", *ms)
    console.print(table)


@measure.command("hard-cases")
def measure_cases(
    only: Annotated[
        list[str] | None, typer.Option("--only", metavar="FAMILY", help="Only this family.")
    ] = None,
    draws: Annotated[int, typer.Option(min=1, help="Draws of each family.")] = 3,
    peer_draws: Annotated[
        int | None,
        typer.Option(min=1, help="So many of them with the others; all by default."),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Of the first draw.")] = 0,
    replayed: Annotated[
        str | None,
        typer.Option("--replay", metavar="FAMILY:SEED", help="One draw, with its parameters."),
    ] = None,
    engines: Annotated[
        list[str] | None,
        typer.Option("--solver", help="ours, sequential, naive, pymunk or box2d; all by default."),
    ] = None,
    workers: Workers = None,
    cluster: Cluster = None,
    store: Annotated[
        bool, typer.Option("--store", help="Keep the result for the notebook, beside the others'.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Families of scenes in which solvers go wrong: ours beside sweeps, naive, pymunk, Box2D."""
    from lesson_code.evidence import hard_cases

    with clear_errors():
        if replayed is not None:
            _show(hard_cases.replay(*_family_and_seed(replayed), engines=engines), as_json)
            return
        measured = hard_cases.measure_hard_cases(
            only,
            draws=draws,
            peer_draws=peer_draws,
            seed=seed,
            engines=engines,
            workers=workers,
            cluster=cluster,
            progress="hard cases",
        )
    if store:
        before = hard_cases.stored() if measured.file.exists() else measured
        before.merged(measured).store()
    _show(measured, as_json)
    raise typer.Exit(1 if hard_cases.OURS in measured.engines and measured.not_held() else 0)


def _family_and_seed(text: str) -> tuple[str, int]:
    """Return the two parts of what is to be replayed."""
    name, _, seed = text.partition(":")
    if not seed.isdecimal():
        raise ValueError(f"--replay must be FAMILY:SEED with a seed >= 0, got {text!r}")
    return name, int(seed)


@measure.command("isolation")
def measure_isolation(
    only: Annotated[
        list[str] | None, typer.Option("--only", metavar="RUNG", help="Only this rung.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Run hostile submissions on every rung of isolation, and show what each stops."""
    from lesson_code.course.measuring.hostile_set import run_hostile_set
    from lesson_code.course.notebooks.root import find_root

    with clear_errors(), share_bar() as told:
        measured = run_hostile_set(find_root(), only or (), told)
    if as_json:
        print_json(measured.as_dict())
    else:
        Console(width=max(console.width, TABLE_WIDTH)).print(measured.as_table())
    raise typer.Exit(0 if measured.full_holds else 1)


@measure.command("grading")
def measure_grading(
    only: Annotated[
        list[str] | None, typer.Option("--only", metavar="RUNG", help="Only this rung.")
    ] = None,
    exercise: Annotated[
        str, typer.Option(help="Which exercise; with mix, all of them in turn.")
    ] = "01",
    workers: Workers = None,
    batches: Annotated[int, typer.Option(min=1, help="How often each takes its turn.")] = 5,
    as_json: AsJson = False,
) -> None:
    """Measure submissions graded a second, by rung of isolation, beside nbgrader."""
    from lesson_code.course.measuring import throughput
    from lesson_code.course.notebooks.root import find_root

    with clear_errors(), share_bar() as told:
        measured = throughput.measure_grading(
            find_root(), only, exercise=exercise, workers=workers, batches=batches, told=told
        )
    if as_json:
        print_json(measured.as_dict())
    else:
        Console(width=max(console.width, TABLE_WIDTH)).print(measured.as_table())


@measure.command("speed")
def speed(
    only: Annotated[
        list[str] | None,
        typer.Option(help="Only such parts: run, run-gas-100, gas-100, gas, held-50, ..."),
    ] = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="Small scenes and few repeats: under a minute.")
    ] = False,
    repeats: Annotated[
        int | None, typer.Option(min=1, help="Batches of each engine in each scene.")
    ] = None,
    profile: Annotated[
        str | None,
        typer.Option(metavar="SCENE", help="The time of each of our stages in a scene instead."),
    ] = None,
    store: Annotated[
        bool, typer.Option("--store", help="Put the whole runs where notebook 10 finds them.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """How fast the engines are: ours, pymunk, and Box2D where it is installed; whole runs first."""
    from lesson_code.evidence.measurement import machine_line
    from lesson_code.evidence.speed import measure_speed
    from lesson_code.evidence.speed.profile import profile_scene

    with clear_errors():
        if profile is not None:
            _show(profile_scene(profile), as_json)
            return
        if store and (quick or not set(only or ["run"]) <= {"run"}):
            raise ValueError(
                '--store needs all whole runs: leave out --quick, and --only but "run"'
            )
        with share_bar() as told:
            measured = measure_speed(repeats=repeats, quick=quick, only=only or (), told=told)
        if store and measured.whole_runs is not None:
            measured.whole_runs.store()
    if not as_json:
        console.print(machine_line(), highlight=False)
    _show(measured, as_json)


@measure.command("accuracy")
def measure_accuracy(
    quick: Annotated[
        bool, typer.Option("--quick", help="Coarse settings only, in plain Python.")
    ] = False,
    only: Annotated[
        list[str] | None,
        typer.Option(metavar="SCENE", help="Only scenes that begin so; can be repeated."),
    ] = None,
    repeats: Annotated[int, typer.Option(min=1, help="Timed runs of each point.")] = 7,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw a figure too: .png, .svg or .pdf.")
    ] = None,
    store: Annotated[
        bool, typer.Option("--store", help="Put the result where notebook 08 finds it.")
    ] = False,
    workers: Annotated[
        int, typer.Option(min=1, help="Processes that share the errors; times need one.")
    ] = 1,
    cluster: Cluster = None,
    as_json: AsJson = False,
) -> None:
    """Measure what accuracy costs: error against time of all methods, where answers are known."""
    from lesson_code.evidence import work_precision

    with clear_errors():
        if store and quick:
            raise ValueError("--store wants a full measurement, not a quick one")
        _check_figure(plot)
        result = work_precision.measure_accuracy(
            only or (),
            quick=quick,
            repeats=repeats,
            workers=workers,
            cluster=cluster,
            progress=errors.is_terminal,
        )
        if store:
            before = work_precision.stored() if result.file.exists() else result
            before.merged(result).store()
        if plot is not None:
            from lesson_code.chapters.ch08_what_accuracy_costs.figures import all_scenes

            all_scenes(result).savefig(plot)
    _show(result, as_json)


@measure.command("effects")
def measure_effects(
    only: Annotated[
        list[str] | None,
        typer.Option("--only", metavar="NAME", help="Only this effect; can be repeated."),
    ] = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="In plain Python and pymunk alone: a minute or two.")
    ] = False,
    repeats: Annotated[
        int | None, typer.Option(min=1, help="Batches of each run in each scene.")
    ] = None,
    plot: Annotated[
        Path | None, typer.Option(metavar="FILE", help="Draw a figure too: .png, .svg or .pdf.")
    ] = None,
    store: Annotated[
        bool, typer.Option("--store", help="Put the result where notebook 10 finds it.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Measure what an effect costs where it is needed, and what it saves to leave it out."""
    from lesson_code.evidence import effect_costs

    with clear_errors():
        if store and (quick or only):
            raise ValueError(
                "--store wants all effects, measured in full: leave out --quick, --only"
            )
        _check_figure(plot)
        with share_bar() as told:
            result = effect_costs.measure_effects(
                only or (), quick=quick, repeats=repeats, told=told
            )
        if store:
            result.store()
        if plot is not None:
            from lesson_code.chapters.ch10_only_what_the_scene_needs.figures import all_effects

            all_effects(result).savefig(plot)
    _show(result, as_json)


def _show(measured: Measurement, as_json: bool) -> None:
    """Print a result as one JSON object, or as tables."""
    if as_json:
        print_json(measured.as_dict())
    else:
        Console(width=max(console.width, TABLE_WIDTH)).print(*measured.tables())


def _check_figure(path: Path | None) -> None:
    """Refuse a figure that Matplotlib is not to write."""
    if path is not None and path.suffix not in (".png", ".svg", ".pdf"):
        raise ValueError(f"--plot must end in .png, .svg or .pdf, got {path.name!r}")
