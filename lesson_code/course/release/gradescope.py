"""The zip that Gradescope runs itself: the package, and the two programs that Gradescope calls.

It holds every hidden check, for Gradescope's container alone. There it stays in `source`, which
only root can read; what runs as another user is in `environment`, and holds none of it.
"""

from __future__ import annotations

import json
import secrets
import tomllib
from collections.abc import Sequence
from pathlib import Path

from lesson_code.course.class_run.autograder import SETTINGS
from lesson_code.course.fresh_copies import Files
from lesson_code.course.grading.check_task import LARGEST_SEED
from lesson_code.course.grading.exercises import exercise_by_name, exercises
from lesson_code.course.notebooks.root import require_instructors
from lesson_code.course.release.bundle import of_the_package

LEAST_ISOLATION = "limits"
"""A container often allows no namespaces. It holds one submission, and ends with it."""

SETUP = """\
#!/usr/bin/env bash
# Gradescope runs this once, as root. The default image (Ubuntu 22.04) has an older Python.
# Student code runs as another user, so that a Python which only root can read will not do.
set -euo pipefail
place="${1:-/autograder}"
fits() {
  setpriv --reuid=65534 --regid=65534 --clear-groups \\
    "$1" -c 'import ensurepip, sys; sys.exit(sys.version_info < (3, 11))' 2> /dev/null
}
find_python() {
  for python in python3 python3.1{4,3,2,1}; do fits "$python" && return; done
  false
}
find_python || { apt-get update && apt-get install -y python3-venv && find_python; } ||
  { apt-get install -y python3.11-venv && find_python; }
"$python" -m venv "$place/environment"
"$place/environment/bin/pip" install -q -c "$place/source/requirements.lock" \\
  -r "$place/source/requirements.txt"
chmod a+x "$place"
"""

RUN = """\
#!/usr/bin/env bash
# Gradescope runs this for every submission, as root. Student code runs as another user.
place="${1:-/autograder}"
chmod -R go= "$place/source" "$place/submission" "$place/results"
cd "$place/source" || exit 1
exec "$place/environment/bin/python" -m lesson_code.course.class_run.autograder "$place"
"""


def gradescope_files(root: Path, names: Sequence[str] = ()) -> Files:
    """Return what Gradescope unpacks into `source`.

    Parameters
    ----------
    root : Path
        The instructor's workbook.
    names : sequence of str
        Names or numbers of the exercises that are graded; all if there are none.

    Raises
    ------
    ValueError
        There is no such exercise, or the workbook is a student's copy.
    """
    require_instructors(root)
    chosen = [exercise_by_name(name) for name in names] or exercises()
    settings = {
        "exercises": [exercise.name for exercise in chosen],
        "isolation": LEAST_ISOLATION,
        "seed": secrets.randbelow(LARGEST_SEED),
    }
    project = tomllib.loads((root / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    files = {path.as_posix(): (root / path).read_bytes() for path in of_the_package(root)}
    files["requirements.lock"] = (root / "requirements.lock").read_bytes()
    files["requirements.txt"] = "\n".join([*project["dependencies"], ""]).encode()
    files[SETTINGS] = json.dumps(settings, indent=1).encode()
    files |= {"setup.sh": SETUP.encode(), "run_autograder": RUN.encode()}
    return dict(sorted(files.items()))
