"""A submission's folder on the disk: how full it is, and how it is removed whatever is in it."""

from __future__ import annotations

import contextlib
import os
import shutil

MOST_BYTES, MOST_FILES = 16_000_000, 1_000
"""What a submission may write, as in a folder of its own in memory."""


def is_overfull(folder: str) -> bool:
    """Return whether a folder holds more bytes, or more files and folders, than it may."""
    total, count, waiting = 0, 0, [folder]
    while waiting:
        try:
            with os.scandir(waiting.pop()) as entries:
                for entry in entries:
                    total += entry.stat(follow_symlinks=False).st_size
                    count += 1
                    if total > MOST_BYTES or count > MOST_FILES:
                        return True
                    if entry.is_dir(follow_symlinks=False):
                        waiting.append(entry.path)
        except OSError:  # gone meanwhile, or too deep for a path: it is counted one level above
            continue
    return False


def remove(folder: str) -> None:
    """Remove a folder and all in it. What cannot be removed is left; nothing is raised.

    Folders are taken out of one another before they are removed, so that one nested by the
    thousand, whose path no system call would take, is as good as any.
    """
    with contextlib.suppress(OSError):
        _flatten(folder)
    shutil.rmtree(folder, ignore_errors=True)


def _flatten(folder: str) -> None:
    """Move all folders within a folder up into it, and remove everything else."""
    waiting, count = [folder], 0
    while waiting:
        inner = waiting.pop()
        os.chmod(inner, 0o700)  # noqa: PTH101
        with os.scandir(inner) as entries:
            found = [(entry.path, entry.is_dir(follow_symlinks=False)) for entry in entries]
        for path, is_folder in found:
            if not is_folder:
                os.unlink(path)  # noqa: PTH108
            elif inner == folder:
                waiting.append(path)
            else:
                count += 1
                os.chmod(path, 0o700)  # noqa: PTH101
                waiting.append(_moved(path, f"{folder}/moved-{count}"))
        if inner != folder:
            os.rmdir(inner)  # noqa: PTH106


def _moved(path: str, place: str) -> str:
    """Return where a folder stands after it has been moved."""
    os.rename(path, place)  # noqa: PTH104
    return place
