"""Which system calls a child may make: those that computing needs, and no others.

There is no network in them, no other process, and no way to change owner or mode of a file. A
filter is a program of the Berkeley Packet Filter that the kernel runs before every call.
"""

from __future__ import annotations

import ctypes
import errno
import os
import struct
from functools import cache
from itertools import groupby

from . import system

ARCHITECTURES = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}
COLUMN = {"x86_64": 1, "aarch64": 2}

# Name, number on x86_64, number on aarch64; a dash where the machine has no such call. Taken from
# the kernel's headers asm/unistd_64.h and asm-generic/unistd.h.
ALLOWED = """
read 0 63; write 1 64; readv 19 65; writev 20 66; pread64 17 67; pwrite64 18 68; preadv 295 69;
pwritev 296 70; lseek 8 62; close 3 57; close_range 436 436; dup 32 23; dup2 33 -; dup3 292 24;
pipe 22 -; pipe2 293 59; open 2 -; openat 257 56;
creat 85 -; stat 4 -; fstat 5 80; lstat 6 -; newfstatat 262 79; statx 332 291; access 21 -;
faccessat 269 48; faccessat2 439 439; readlink 89 -; readlinkat 267 78; statfs 137 43;
fstatfs 138 44; getdents 78 -; getdents64 217 61; getcwd 79 17; chdir 80 49; fchdir 81 50;
mkdir 83 -; mkdirat 258 34; rmdir 84 -; unlink 87 -; unlinkat 263 35; rename 82 -;
renameat 264 38; renameat2 316 276; ftruncate 77 46; fsync 74 82; fdatasync 75 83;
fallocate 285 47; copy_file_range 326 285; sendfile 40 71; poll 7 -;
ppoll 271 73; select 23 -; pselect6 270 72; epoll_create1 291 20; epoll_ctl 233 21;
epoll_wait 232 -; epoll_pwait 281 22; eventfd2 290 19; mmap 9 222; munmap 11 215;
mprotect 10 226; mremap 25 216; madvise 28 233; brk 12 214; msync 26 227;
membarrier 324 283; futex 202 98; futex_waitv 449 449; set_robust_list 273 99;
get_robust_list 274 100; rseq 334 293; set_tid_address 218 96; arch_prctl 158 -;
sched_yield 24 124; sched_getaffinity 204 123; getcpu 309 168; rt_sigaction 13 134;
rt_sigprocmask 14 135; rt_sigreturn 15 139; rt_sigsuspend 130 133; rt_sigpending 127 136;
rt_sigtimedwait 128 137; sigaltstack 131 132; pause 34 -; alarm 37 -; setitimer 38 103;
getitimer 36 102; restart_syscall 219 128; nanosleep 35 101; clock_nanosleep 230 115;
clock_gettime 228 113; clock_getres 229 114; gettimeofday 96 169; time 201 -; times 100 153;
getrusage 98 165; getrlimit 97 163; getpriority 140 141; getpid 39 172; getppid 110 173;
gettid 186 178; getuid 102 174; geteuid 107 175; getgid 104 176; getegid 108 177;
getgroups 115 158; getresuid 118 148; getresgid 120 150; getpgid 121 155; getpgrp 111 -;
getsid 124 156; uname 63 160; sysinfo 99 179; umask 95 166; getrandom 318 278; capget 125 90;
wait4 61 260; waitid 247 95; exit 60 93; exit_group 231 94
"""

REFUSED = """
socket 41 198; socketpair 53 199; fork 57 -; vfork 58 -; execve 59 221; execveat 322 281;
flock 73 32; mincore 27 232; fadvise64 221 223; ptrace 101 117;
process_vm_readv 310 270; process_vm_writev 311 271; unshare 272 97;
setns 308 268; mount 165 40; pivot_root 155 41; chroot 161 51; setuid 105 146; setgid 106 144;
chmod 90 -; fchmod 91 52; fchmodat 268 53; chown 92 -; fchown 93 55; fchownat 260 54;
prctl 157 167; tkill 200 130
"""
"""Refused in words that a student may read (Operation not permitted). All the rest does not
exist, which is what the C library expects of a kernel that lacks a call. A lock on a file that
neighbours share, or whether the kernel keeps it in memory, could be heard next door."""

FCNTL = {"x86_64": 72, "aarch64": 25}
FCNTL_ALLOWED = {
    "F_DUPFD": 0, "F_GETFD": 1, "F_SETFD": 2, "F_GETFL": 3, "F_SETFL": 4, "F_DUPFD_CLOEXEC": 1030,
}  # fmt: skip
"""No locks, no leases, and nobody told to send a signal to another process (F_SETOWN, F_SETSIG)."""

IOCTL = {"x86_64": 16, "aarch64": 29}
IOCTL_ALLOWED = {
    "TCGETS": 0x5401, "TIOCGWINSZ": 0x5413, "FIONREAD": 0x541B, "FIONBIO": 0x5421,
    "FIONCLEX": 0x5450, "FIOCLEX": 0x5451,
}  # fmt: skip
"""What Python asks of an open file. No network cards, no owner of a socket, no flags of a file."""

CLONE = {"x86_64": 56, "aarch64": 220}
CLONE_THREAD = 0x00010000
PRLIMIT = {"x86_64": 302, "aarch64": 261}
SIGNALS = {"x86_64": (62, 234), "aarch64": (129, 131)}
"""kill and tgkill; both name the process in their first argument."""

LOAD, EQUAL, AT_LEAST, ANY_BIT, RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
NUMBER, ARCHITECTURE, FIRST_ARGUMENT, SECOND_ARGUMENT = 0, 4, 16, 24
ALLOW, REFUSE, KILL = 0x7FFF0000, 0x00050000, 0x80000000

ANY_PROCESS = 0x7FFF_FFFE
"""Stands in a filter for the process it is made for; no system has a process of this number."""

Instruction = tuple[int, int, int, int]
"""Operation, how far to jump if true, how far if false, operand."""

Lines = list[Instruction]

ALLOWS: Instruction = (RETURN, 0, 0, ALLOW)
REFUSES: Instruction = (RETURN, 0, 0, REFUSE | errno.EPERM)
DENIES: Instruction = (RETURN, 0, 0, REFUSE | errno.ENOSYS)
"""What becomes of a call. One that is denied does not exist."""


def is_known_machine() -> bool:
    """Return whether the numbers of this machine's system calls are in the table."""
    return system.MACHINE in ARCHITECTURES


def numbers(table: str, machine: str) -> dict[str, int]:
    """Return the calls of a table that a machine has.

    >>> numbers("read 0 63; fork 57 -", "aarch64")
    {'read': 63}
    """
    rows = (entry.split() for entry in table.split(";"))
    return {row[0]: int(row[COLUMN[machine]]) for row in rows if row[COLUMN[machine]] != "-"}


def program(machine: str, process: int) -> Lines:
    """Return the filter for one process of a machine."""
    return [
        (LOAD, 0, 0, ARCHITECTURE),
        (EQUAL, 1, 0, ARCHITECTURES[machine]),
        (RETURN, 0, 0, KILL),
        (LOAD, 0, 0, NUMBER),
        *_searched(_ranges(_answers(machine, process))),
    ]


def _answers(machine: str, process: int) -> dict[int, Lines]:
    """Return the lines that answer each call that exists, by its number."""
    answers = {number: [REFUSES] for number in numbers(REFUSED, machine).values()}
    answers |= {number: [ALLOWS] for number in numbers(ALLOWED, machine).values()}
    answers[CLONE[machine]] = _if_argument(FIRST_ARGUMENT, ANY_BIT, CLONE_THREAD)
    answers[PRLIMIT[machine]] = _if_argument(FIRST_ARGUMENT, EQUAL, 0)
    for number in SIGNALS[machine]:
        answers[number] = _if_argument(FIRST_ARGUMENT, EQUAL, process)
    answers[FCNTL[machine]] = _if_argument(SECOND_ARGUMENT, EQUAL, *FCNTL_ALLOWED.values())
    answers[IOCTL[machine]] = _if_argument(SECOND_ARGUMENT, EQUAL, *IOCTL_ALLOWED.values())
    return answers


def _ranges(answers: dict[int, Lines]) -> list[tuple[int, Lines]]:
    """Return the least number of each range of calls with one answer, and that answer.

    >>> [(least, lines == [DENIES]) for least, lines in _ranges({1: [ALLOWS], 2: [ALLOWS]})]
    [(0, True), (1, False), (3, True)]
    """
    borders = sorted({0, *answers, *(number + 1 for number in answers)})
    ranges = groupby(borders, lambda number: answers.get(number, [DENIES]))
    return [(next(numbers), answer) for answer, numbers in ranges]


def _searched(ranges: list[tuple[int, Lines]]) -> Lines:
    """Return lines that find the range of a call by halves, and answer it.

    The kernel tries each new filter out on every number: by halves with a twelfth of the lines
    that one comparison after another would take.
    """
    if len(ranges) == 1:
        return ranges[0][1]
    half = len(ranges) // 2
    below, above = _searched(ranges[:half]), _searched(ranges[half:])
    return [(AT_LEAST, len(below), 0, ranges[half][0]), *below, *above]


def _if_argument(place: int, test: int, *values: int) -> Lines:
    """Return lines that allow a call if an argument passes a test with a value, or refuse it.

    The lower half of an argument is looked at, as the kernel does with these.
    """
    tests = [line for value in values for line in ((test, 0, 1, value), ALLOWS)]
    return [(LOAD, 0, 0, place), *tests, REFUSES]


class _Filter(ctypes.Structure):
    """A filter as the kernel takes it."""

    _fields_ = [("length", ctypes.c_ushort), ("lines", ctypes.c_char_p)]


@cache
def _packed(machine: str) -> bytes:
    """Return the filter as the kernel takes it, for the process ANY_PROCESS."""
    return b"".join(struct.pack("HBBI", *line) for line in program(machine, ANY_PROCESS))


def prepare() -> None:
    """Work the filter out, so that no child spends time on it."""
    if is_known_machine():
        _packed(system.MACHINE)


def restrict() -> None:
    """Restrict this process, and all it may start, to the calls allowed; there is no way back.

    Nothing is done on a machine whose calls are not in the table.
    """
    if not is_known_machine():
        return
    packed = _packed(system.MACHINE)
    packed = packed.replace(struct.pack("I", ANY_PROCESS), struct.pack("I", os.getpid()))
    handed = _Filter(len(packed) // struct.calcsize("HBBI"), packed)
    system.prctl(system.PR_SET_NO_NEW_PRIVS, 1)
    system.prctl(system.PR_SET_SECCOMP, 2, ctypes.byref(handed))
