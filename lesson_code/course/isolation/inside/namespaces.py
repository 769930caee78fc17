"""A machine of its own for the server: few files, no network, no other process, no other user.

The folders that Python needs are mounted read-only under their own names in an empty root. All
else that the machine holds has no name there. The kernel ends every process of a process
namespace with its first one, so nothing that a submission starts outlives it.
"""

from __future__ import annotations

import os
import signal
import stat
from collections.abc import Iterable
from pathlib import Path

from . import system

DEVICES = ("/dev/null", "/dev/zero", "/dev/urandom")

NEW = (
    system.CLONE_NEWNS
    | system.CLONE_NEWNET
    | system.CLONE_NEWIPC
    | system.CLONE_NEWUTS
    | system.CLONE_NEWPID
)

WORKING_FOLDER = "/submission"

FOLDER_SIZE = "size=16m,nr_inodes=1000,mode=0700"
"""What a submission may write: 16 MB in 1,000 files, in memory, for as long as it is graded."""


class ProcessNamespaces:
    """A new process namespace for each next child, in which the child is the first process."""

    def __init__(self) -> None:
        self._own = os.open("/proc/self/ns/pid", os.O_RDONLY | os.O_CLOEXEC)

    def prepare(self) -> None:
        """Put the next child into a new process namespace."""
        system.setns(self._own, system.CLONE_NEWPID)
        system.unshare(system.CLONE_NEWPID)


def enter(mounts: Iterable[tuple[str, bool]], root: str) -> ProcessNamespaces:
    """Move this process into namespaces of its own, and return those of its children.

    Parameters
    ----------
    mounts : iterable of (path, bool)
        What can be read afterwards, and where True stands, what is empty afterwards; outer folders
        come before those within them.
    root : path
        An empty folder; the new root is mounted on it.

    Raises
    ------
    OSError
        The system does not allow it.
    """
    _unshare()
    _mount_root(list(mounts), root)
    _go_on_as_first_process()
    apart = ProcessNamespaces()
    system.pivot_root(root)
    _protect("/")
    return apart


def _unshare() -> None:
    """Leave the machine's namespaces; who is not root becomes the only user of a new one first."""
    user, group = os.getuid(), os.getgid()
    if user == 0:
        system.unshare(NEW)
        return
    system.unshare(NEW | system.CLONE_NEWUSER)
    Path("/proc/self/setgroups").write_text("deny")
    Path("/proc/self/uid_map").write_text(f"{user} {user} 1")
    Path("/proc/self/gid_map").write_text(f"{group} {group} 1")


def _go_on_as_first_process() -> None:
    """Go on in the first process of the new process namespace; this one waits for its end."""
    if first := os.fork():
        system.close_from(3)
        os.waitpid(first, 0)
        os._exit(0)
    system.prctl(system.PR_SET_PDEATHSIG, signal.SIGKILL)


def _protect(place: str) -> None:
    """Make one mount read-only."""
    protect = system.MS_RDONLY | system.MS_NOSUID | system.MS_NODEV
    system.mount("", place, "", system.MS_REMOUNT | system.MS_BIND | protect)


def _mount_root(mounts: list[tuple[str, bool]], root: str) -> None:
    """Mount an empty root, and in it what can be read."""
    system.mount("", "/", "", system.MS_REC | system.MS_PRIVATE)
    system.mount("tmpfs", root, "tmpfs", system.MS_NOSUID | system.MS_NODEV, "mode=0755,size=1m")
    for path in DEVICES:
        system.mount(path, _place(root, path), "", system.MS_BIND)
    for path, is_hidden in mounts:
        place = _place(root, path)
        if not is_hidden:
            system.mount(path, place, "", system.MS_BIND | system.MS_REC)
            system.protect_tree(place)
        elif os.path.isdir(place):  # noqa: PTH112 - paths are texts on this side
            flags = system.MS_NOSUID | system.MS_NODEV
            system.mount("tmpfs", place, "tmpfs", flags, "mode=0755,size=64k")
        else:
            system.mount(DEVICES[0], place, "", system.MS_BIND)
    for path, is_hidden in mounts:
        if is_hidden:
            _protect(root + path)
    os.mkdir(root + WORKING_FOLDER)  # noqa: PTH102


def _place(root: str, path: str) -> str:
    """Return where a path is to be mounted, made there as what it is: a folder, or a file."""
    place = Path(root + path)
    if place.exists():
        return str(place)
    place.parent.mkdir(parents=True, exist_ok=True)
    if stat.S_ISDIR(os.stat(path).st_mode):  # noqa: PTH116
        place.mkdir(exist_ok=True)
    else:
        place.touch()
    return str(place)


def mount_folder(path: str, user: int, group: int) -> None:
    """Mount an empty folder that belongs to a user, and from which no machine code is run."""
    flags = system.MS_NOSUID | system.MS_NODEV | system.MS_NOEXEC
    system.mount("tmpfs", path, "tmpfs", flags, f"{FOLDER_SIZE},uid={user},gid={group}")


def unmount_folder(path: str) -> None:
    """Take a folder off, with all that is in it."""
    system.unmount(path)
