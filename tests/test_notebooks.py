"""Every committed notebook keeps the rules of the course: its form, its words, its outputs."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from html import unescape
from itertools import pairwise
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import nbformat
import pytest

from lesson_code.course.chapters import chapters_with
from lesson_code.course.grading.gaps import all_gaps
from lesson_code.course.quiz.bank import chapter_numbers, load_quiz

ROOT = Path(__file__).parents[1]
README = (ROOT / "README.md").read_text(encoding="utf-8")
CHAPTERS = sorted((ROOT / "notebooks").glob("*.ipynb"))
PARTS = {
    number: [path for path in CHAPTERS if path.stem.startswith(number)]
    for number in chapter_numbers()
}
"""The notebooks of each chapter, in the order in which they are read: most have one."""

SOLUTIONS = sorted((ROOT / "solutions").glob("*.ipynb"))
STUDENT_COPIES = sorted((ROOT / "exercises").glob("*.ipynb"))
ALL = [*CHAPTERS, *SOLUTIONS, *STUDENT_COPIES]

CONVERTED = [
    number
    for number, paths in PARTS.items()
    if any("@gap(" in path.read_text(encoding="utf-8") for path in paths)
]
"""Chapters in which the reader predicts and writes: all that have a gap."""

MOST_LINES_IN_A_CELL = 15
MOST_WORDS_IN_A_PARAGRAPH = 119
SHORTEST_ALT_TEXT = 30
"""Characters: less than this cannot say what is in a figure."""

LARGEST_ANIMATION = 300_000
"""Characters: what thirty bodies need for five seconds, with room to spare."""

ANIMATION = re.compile(r'<figure data-animation="[^"]*"[^>]*><img alt="([^"]*)"')
ADDRESS = re.compile(r"\bat 0x[0-9a-f]{4,}|<[\w.]+ object at")
ABSOLUTE_PATH = re.compile(
    r"(?<![\w:/.])/(?:home|root|tmp|usr|var|work|opt|Users|private|mnt|etc)\b/?|\b[A-Z]:\\"
)
EMOJI = re.compile(r"[\U0001f000-\U0001faff\u2600-\u27bf\u2b50\ufe0f]")
LINK = re.compile(r"\[[^]]*]\(([^)\s]+)")


def read(path: Path) -> Any:
    """Return a notebook."""
    return nbformat.read(path, as_version=4)


def code_cells(path: Path) -> list[Any]:
    """Return a notebook's code cells."""
    return [cell for cell in read(path).cells if cell.cell_type == "code"]


def prose(path: Path) -> list[str]:
    """Return the text of each markdown cell."""
    return [cell.source for cell in read(path).cells if cell.cell_type == "markdown"]


def paragraphs(text: str) -> list[str]:
    """Return the paragraphs of some markdown: headings, formulas and list items apart."""
    text = re.sub(r"\$\$.*?\$\$", "\n\n", text, flags=re.DOTALL)
    parts = re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.)\s)|^#+ .*$", text, flags=re.MULTILINE)
    return [part for part in parts if part.strip()]


def outputs(path: Path) -> Iterator[tuple[int, Any]]:
    """Yield each output, with the number of its code cell, from 1."""
    for number, cell in enumerate(code_cells(path), start=1):
        for output in cell.outputs:
            yield number, output


def words_in(output: Any) -> str:
    """Return whatever text an output holds, pictures left out."""
    data = {k: v for k, v in output.get("data", {}).items() if not k.startswith("image/")}
    return "\n".join(
        map(str, [output.get("text", ""), *data.values(), output.get("traceback", "")])
    )


def chapters(function: Any) -> Any:
    """Run a test for each notebook of a chapter, each part for itself."""
    return pytest.mark.parametrize("path", CHAPTERS, ids=lambda path: path.stem)(function)


def whole_chapters(function: Any) -> Any:
    """Run a test for each chapter, its parts together."""
    return pytest.mark.parametrize("number", PARTS)(function)


def code_of(number: str) -> str:
    """Return the code of a chapter, all parts together."""
    return "\n".join(cell.source for path in PARTS[number] for cell in code_cells(path))


def prose_of(number: str) -> str:
    """Return the text of a chapter, all parts together."""
    return "\n".join(text for path in PARTS[number] for text in prose(path))


def notebooks(function: Any) -> Any:
    """Run a test for each notebook of the workbook."""
    ids = [f"{path.parent.name}-{path.stem}" for path in ALL]
    return pytest.mark.parametrize("path", ALL, ids=ids)(function)


def test_there_are_notebooks_to_look_at() -> None:
    """The tests below find what they are about."""
    assert len(CHAPTERS) >= 4
    assert len(SOLUTIONS) == len(STUDENT_COPIES) >= 3


# Every chapter's form


@chapters
def test_chapter_opens_with_its_number_and_three_things_to_learn(path: Path) -> None:
    """The first cell has the title, and three numbered things the reader will be able to do."""
    first = prose(path)[0]
    assert first.startswith(f"# {path.stem.partition('_')[0]} ")
    _, found, aims = first.partition("you will be able to")
    assert found
    assert re.findall(r"^(\d)\. ", aims, flags=re.MULTILINE) == ["1", "2", "3"]


@chapters
def test_chapter_says_what_it_needs_and_how_long_it_takes(path: Path) -> None:
    """Prerequisites and time stand in the first cell."""
    first = prose(path)[0]
    assert "**You need**" in first
    assert re.search(r"\*\*Time:\*\*\s+about\s+\d+\s+minutes", first)


def minutes_stated(path: Path) -> int:
    """Return how long a notebook takes, as its first cell says."""
    stated = re.search(r"\*\*Time:\*\*\s+about\s+(\d+)\s+minutes", prose(path)[0])
    assert stated
    return int(stated[1])


@chapters
def test_minutes_are_counted(path: Path) -> None:
    """100 words a minute, 3 for a function or a figure to move, 1 for a question; up to the next 5.

    Notebook 00 tells the reader so.
    """
    code = "\n".join(cell.source for cell in code_cells(path))
    count = len(" ".join(prose(path)).split()) / 100
    count += 3 * len(re.findall(r"^(?:@gap|live|lab)\(", code, re.MULTILINE))
    count += len(re.findall(r"^predict\(", code, re.MULTILINE))
    if "show_quiz(" in code:
        count += len(load_quiz(path.stem[:2]).questions)
    assert minutes_stated(path) == 5 * math.ceil(count / 5)


@pytest.mark.parametrize("text", [prose_of("00"), README], ids=["notebook 00", "README"])
def test_both_tracks_are_named_with_their_hours(text: str) -> None:
    """They are the sums of the minutes, to half an hour."""
    said = " ".join(text.split())
    advanced = [path for path in CHAPTERS if path.stem[:2] in ("08", "09", "10")]
    for track, paths in (("core", set(CHAPTERS) - set(advanced)), ("advanced", advanced)):
        hours = re.search(rf"{track} track\b.*?about (\d+) hours", said)
        assert hours
        assert abs(int(hours[1]) - sum(map(minutes_stated, paths)) / 60) <= 0.5


def test_readme_names_the_shortest_and_the_longest_notebook() -> None:
    """In minutes."""
    named = re.search(r"notebooks of (\d+) to (\d+) minutes", README)
    assert named
    minutes = sorted(map(minutes_stated, CHAPTERS))
    assert [int(named[1]), int(named[2])] == [minutes[0], minutes[-1]]


@whole_chapters
def test_chapter_ends_with_its_key_takeaways(number: str) -> None:
    """At least four, in the part that has the quiz."""
    texts = prose(PARTS[number][-1])
    (first,) = [k for k, text in enumerate(texts) if re.search(r"^## .*Key takeaways", text, re.M)]
    taken = texts[first].partition("Key takeaways")[2].partition("\n## ")[0]
    assert len(re.findall(r"^- ", taken, re.MULTILINE)) >= 4


@chapters
def test_checks_show_what_was_measured(path: Path) -> None:
    """No comparison is made before a check, which would then print that True is True."""
    code = "\n".join(cell.source for cell in code_cells(path))
    assert not re.findall(r"^\s*check\(.*bool\(.*", code, re.MULTILINE)


@whole_chapters
def test_chapter_has_its_own_quiz(number: str) -> None:
    """One cell of its last part shows it, under a heading that says so; no other part does."""
    assert re.findall(r"^.*show_quiz\(.*$", code_of(number), re.MULTILINE) == [
        f'show_quiz("{number}")'
    ]
    last = "\n".join(prose(PARTS[number][-1]))
    assert re.search(r"^## \d+ Quiz$", last, flags=re.MULTILINE)


@whole_chapters
def test_chapter_has_something_to_move(number: str) -> None:
    """At least one figure answers to a hand."""
    assert re.search(r"^(explore|live)\(", code_of(number), re.MULTILINE)


@whole_chapters
def test_chapter_breaks_something_on_purpose(number: str) -> None:
    """A section shows what goes wrong, and why; the gate of chapter 03 is one too."""
    headings = re.findall(r"^## .*$", prose_of(number), flags=re.MULTILINE)
    assert any("Break it on purpose" in heading for heading in headings)


@whole_chapters
def test_chapter_closes_with_what_was_checked_and_sources(number: str) -> None:
    """The last cell says what was checked, what comes next, and where it is from."""
    path = PARTS[number][-1]
    last = prose(path)[-1]
    assert read(path).cells[-1].source == last
    assert last.startswith("## What was checked")
    assert "**Checked here:**" in last
    assert "**Next:**" in last
    assert "**Sources.**" in last


@whole_chapters
def test_chapter_closes_with_its_exercise_its_program_and_its_challenge(number: str) -> None:
    """What the reader can do now stands there with the commands; what is linked is there."""
    path = PARTS[number][-1]
    last = prose(path)[-1].partition("**Do now:**")[2].partition("**Sources.**")[0]
    last = " ".join(last.split())
    linked = {Path(link).name for link in LINK.findall(last)}
    program = re.search(r"`workbook play (\w+)`", last)
    assert program
    assert program[1] in {chapter.name for chapter in chapters_with("game.py")}
    assert linked & {file.name for file in (ROOT / "exercises").glob("*.py")}
    if exercise := {file.name for file in STUDENT_COPIES if file.stem.startswith(number)}:
        assert linked & exercise
        assert "`workbook watch" in last


@whole_chapters
def test_part_ends_with_a_paragraph_that_leads_to_the_next(number: str) -> None:
    """It says what the reader can do now; and the next part says that it needs this one."""
    for path, follows in pairwise(PARTS[number]):
        last = read(path).cells[-1].source
        assert last.startswith("You can now ")
        assert len(paragraphs(last)) == 1
        assert f"]({follows.name})" in last.partition("**Next:**")[2]
        needed = prose(follows)[0].partition("**You need**")[2].partition("**Time:**")[0]
        assert path.stem.partition("_")[0] in needed


@whole_chapters
def test_sections_are_numbered_without_gaps(number: str) -> None:
    """A section can be pointed to by its number, in whichever part it stands."""
    numbers = re.findall(r"^## (\d+) ", prose_of(number), flags=re.MULTILINE)
    assert [int(number) for number in numbers] == [*range(1, len(numbers) + 1)]
    assert len(numbers) >= 5


# What the reader does


THE_ANSWER = '<b class="answer">The answer.</b>'
"""Begins a text that belongs to an answer."""


def has_tag(cell: Any, tag: str) -> bool:
    """Return whether a cell has a tag."""
    return tag in cell.metadata.get("tags", [])


def asks(cell: Any) -> bool:
    """Return whether a cell asks for a prediction, or belongs to the answer of one."""
    return has_tag(cell, "answer") or cell.source.startswith('predict("')


@whole_chapters
def test_predictions_are_asked_once_and_where_they_stand_in_the_quiz_file(number: str) -> None:
    """Each prediction of the chapter's file is asked in its notebooks, in the file's order."""
    asked = re.findall(r'^predict\("([^"]*)"\)', code_of(number), re.MULTILINE)
    assert asked == [question.id for question in load_quiz(number).predictions]


@chapters
def test_every_prediction_has_its_answer_folded_below(path: Path) -> None:
    """A prediction is a cell of its own; the cell that answers it follows and is folded."""
    cells = read(path).cells
    for cell, follows in pairwise(cells):
        if cell.source.startswith("predict("):
            assert len(cell.source.splitlines()) == 1
            assert has_tag(follows, "answer"), cell.source
        if has_tag(follows, "answer"):
            assert asks(cell), follows.source
            is_text = follows.cell_type == "markdown"
            assert not is_text or cell.cell_type == "code", follows.source
            assert not is_text or has_tag(cell, "answer"), follows.source


@chapters
def test_first_line_of_an_answer_gives_nothing_away(path: Path) -> None:
    """JupyterLab shows the first line of folded code; text, which it does not fold, is marked.

    A marked text is out of sight while the code above it is folded. So code stands above it.
    """
    for cell in read(path).cells:
        if has_tag(cell, "answer"):
            first = cell.source.splitlines()[0]
            is_code = cell.cell_type == "code"
            assert first.startswith("# ") if is_code else first == THE_ANSWER, first


@pytest.mark.parametrize("number", CONVERTED)
def test_nobody_is_asked_to_predict_in_prose(number: str) -> None:
    """Every prompt is a form that hides its answer."""
    assert not re.search(r"\*\*Predict|[Pp]redict first", prose_of(number))


GAP = re.compile(r'@gap\("([^"]*)"\)\ndef (\w+)\(.*\):\n(?:    .*\n)?    return \.\.\.')
"""A function that the reader is to write: its id and its name."""


@pytest.mark.parametrize("number", CONVERTED)
def test_reader_writes_functions_in_every_part(number: str) -> None:
    """Each gap stands in its chapter's notebooks, open, and is used further down in that part.

    A part has two or three of them.
    """
    gaps = []
    for path in PARTS[number]:
        code = "\n".join(cell.source for cell in code_cells(path))
        written = GAP.findall(code)
        gaps += [name for name, _ in written]
        assert 2 <= len(written) <= 3, path.stem
        for _, function in written:
            assert len(re.findall(rf"\b{function}\b", code)) > 1, function
    assert gaps == [each.id for each in all_gaps() if each.id.startswith(number)]


PLUMBING = re.compile(
    r"^\s*(import |from |fig\b|ax\b|axes\b|show\(|plots\.|style\.|scene_plots\.|for ax|\w+\.set\()"
)
"""A line that imports or draws: a figure is one named call of the chapter's ``figures.py``."""

MOST_PLUMBING = 0.1
"""Of the code lines that are not folded."""


@chapters
def test_plumbing_is_folded(path: Path) -> None:
    """Nearly all lines that a reader sees are about the subject."""
    lines = [
        line
        for cell in code_cells(path)
        if not has_tag(cell, "plumbing")
        for line in cell.source.splitlines()
        if line.strip()
    ]
    plumbing = [line for line in lines if PLUMBING.match(line)]
    assert len(plumbing) < MOST_PLUMBING * len(lines), plumbing


# Words


@notebooks
def test_paragraphs_are_short(path: Path) -> None:
    """No paragraph has 120 words or more."""
    long = [
        part[:60]
        for text in prose(path)
        for part in paragraphs(text)
        if len(part.split()) > MOST_WORDS_IN_A_PARAGRAPH
    ]
    assert long == []


@notebooks
def test_there_are_no_emoji(path: Path) -> None:
    """Neither in the prose nor in the code."""
    assert EMOJI.findall("\n".join(cell.source for cell in read(path).cells)) == []


@notebooks
def test_links_to_files_lead_somewhere(path: Path) -> None:
    """Every link that is not to the web is to a file of the workbook."""
    links = [link for text in prose(path) for link in LINK.findall(text)]
    local = [unquote(link.partition("#")[0]) for link in links if "://" not in link]
    assert [link for link in local if link and not (path.parent / link).is_file()] == []


# Code


@notebooks
def test_code_cells_are_short(path: Path) -> None:
    """No code cell but a folded one has over 15 lines, empty ones between not counted."""
    long = {
        number: lines
        for number, cell in enumerate(code_cells(path), start=1)
        if not has_tag(cell, "plumbing")
        and (lines := sum(1 for line in cell.source.splitlines() if line.strip()))
        > MOST_LINES_IN_A_CELL
    }
    assert long == {}


@notebooks
def test_code_cells_define_no_classes_and_load_no_files(path: Path) -> None:
    """Notebooks tell, `lesson_code` computes; nothing is read from anywhere else."""
    code = "\n".join(cell.source for cell in code_cells(path))
    assert not re.search(r"^class |\bopen\(|\burlopen\(|^[%!]", code, flags=re.MULTILINE)


# Figures


@notebooks
def test_every_picture_has_an_alt_text_and_says_it_in_words_too(path: Path) -> None:
    """Who cannot see a figure, or has no browser, reads what is in it."""
    for number, output in outputs(path):
        if any(kind.startswith("image/") for kind in output.get("data", {})):
            alt = output.metadata.get("image/png", {}).get("alt", "")
            assert len(alt) >= SHORTEST_ALT_TEXT, f"code cell {number}"
            assert alt in output.data["text/plain"], f"code cell {number}"


@notebooks
def test_every_animation_has_an_alt_text_and_says_it_in_words_too(path: Path) -> None:
    """What holds for pictures holds for those that move; they are also small enough to keep."""
    for number, output in outputs(path):
        page = output.get("data", {}).get("text/html", "")
        for text in ANIMATION.findall(page):
            alt = unescape(text)
            assert len(alt) >= SHORTEST_ALT_TEXT, f"code cell {number}"
            assert alt in output.data["text/plain"], f"code cell {number}"
            assert len(page) <= LARGEST_ANIMATION, f"code cell {number}"


SMALLEST_TYPE = 9.0
"""Points in a drawn figure, pixels in one to move: smaller type is read on no phone."""


def test_no_figure_has_tiny_type() -> None:
    """Each size of type that a figure names, in Python or in SVG, can be read."""
    named = re.compile(r"""\b(?:fontsize=|labelsize=|"font\.size": |font-size[=:]\s*"?)([\d.]+)""")
    files = [*ROOT.glob("notebooks/source/*.py"), *ROOT.glob("lesson_code/**/*.py")]
    files += ROOT.glob("lesson_code/chapters/*/*.svg")
    sizes = [
        (float(size), file.name)
        for file in files
        for size in named.findall(file.read_text(encoding="utf-8"))
    ]
    assert len(sizes) > 100
    assert [found for found in sizes if found[0] < SMALLEST_TYPE] == []


@chapters
def test_chapter_has_figures(path: Path) -> None:
    """There is at least one picture, stored for those who only read."""
    assert any("image/png" in output.get("data", {}) for _, output in outputs(path))


# Outputs


@notebooks
def test_outputs_hold_no_paths_and_no_memory_addresses(path: Path) -> None:
    """What is stored is the same on every machine."""
    for number, output in outputs(path):
        found = [p.search(words_in(output)) for p in (ADDRESS, ABSOLUTE_PATH)]
        assert found == [None, None], f"code cell {number}"


@notebooks
def test_code_names_no_place_on_one_machine(path: Path) -> None:
    """Code and prose hold no absolute path."""
    for cell in read(path).cells:
        assert ABSOLUTE_PATH.search(cell.source) is None


@notebooks
def test_nothing_is_stored_of_when_and_where_it_ran(path: Path) -> None:
    """Metadata is what the kernel needs, tags and folding; no widget's state, no errors."""
    notebook = read(path)
    assert set(notebook.metadata) <= {"kernelspec", "language_info", "workbook"}
    for cell in notebook.cells:
        assert set(cell.metadata) <= {"tags", "jupyter"}
        for output in cell.get("outputs", []):
            assert set(output.get("metadata", {})) <= {"image/png"}
            assert not [kind for kind in output.get("data", {}) if "widget" in kind]
            assert output.output_type != "error"
            assert output.get("name") != "stderr"


@notebooks
def test_notebook_is_valid_and_its_cells_have_unique_ids(path: Path) -> None:
    """Every front end opens it without a word."""
    notebook = read(path)
    nbformat.validate(notebook)
    ids = [cell.id for cell in notebook.cells]
    assert len(set(ids)) == len(ids)


@pytest.mark.parametrize("path", [*CHAPTERS, *SOLUTIONS], ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_cells_were_run_top_to_bottom(path: Path) -> None:
    """Counts are those of one run from the top: the n-th code cell has n, or prints nothing."""
    for number, cell in enumerate(code_cells(path), start=1):
        assert cell.execution_count == (number if cell.outputs else None)


@pytest.mark.parametrize("path", STUDENT_COPIES, ids=lambda path: path.stem)
def test_student_copies_hold_no_outputs_and_nothing_for_the_instructor(path: Path) -> None:
    """What is handed out was never run, and has no cell of the solution."""
    assert list(outputs(path)) == []
    assert all(cell.execution_count is None for cell in code_cells(path))
    assert not [c for c in read(path).cells if "solution" in c.metadata.get("tags", [])]


@pytest.mark.parametrize("path", SOLUTIONS, ids=lambda path: path.stem)
def test_solutions_show_full_marks(path: Path) -> None:
    """The stored output of each check cell is a line with all the points."""
    checks = [cell for cell in code_cells(path) if "check" in cell.metadata.get("tags", [])]
    assert checks
    for cell in checks:
        points = re.search(r"(\d+)/(\d+) points", words_in(cell.outputs[0]))
        assert points
        assert points[1] == points[2]
