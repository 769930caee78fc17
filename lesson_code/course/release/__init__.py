"""The student's copy of the workbook: made, and searched for what it must not hold."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from lesson_code.course.fresh_copies import write_folder
from lesson_code.course.release.bundle import bundle_files, write_zip
from lesson_code.course.release.leaks import leaks

__all__ = ["LeakError", "Release", "release"]


class LeakError(ValueError):
    """A student's copy would hold something of the instructor's; the message says what."""


@dataclass(frozen=True)
class Release:
    """A student's copy: its folder, its zip, and how many files it has."""

    folder: Path
    archive: Path
    files: int


def release(root: Path, folder: Path) -> Release:
    """Write the student's copy of a workbook into a folder, and into a zip beside it.

    It is searched first; where something would leak, nothing is written.

    Parameters
    ----------
    root : Path
        The instructor's workbook.
    folder : Path
        New or empty.

    Raises
    ------
    LeakError
        It holds what students must not have.
    ValueError
        The folder holds something, or the workbook is a student's copy.
    """
    archive = folder.resolve().with_name(f"{folder.resolve().name}.zip")
    if archive.exists():
        raise ValueError(f"{archive}: is there already; name another folder")
    files = bundle_files(root)
    found = list(leaks(files, root))
    if found:
        raise LeakError("nothing was written, since this would leak:\n" + "\n".join(found))
    write_folder(files, folder)
    write_zip(files, archive)
    return Release(folder, archive, len(files))
