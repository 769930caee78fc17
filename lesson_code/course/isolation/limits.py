"""What a submission may use."""

from __future__ import annotations

from dataclasses import dataclass

PATIENCE = 5
"""Seconds of the clock for each second of processor time: what sleeps ends then, and what has to
share the processor with four others does not."""


@dataclass(frozen=True)
class Limits:
    """What a submission may use; each bound is far above what any task needs.

    Seconds are of the processor, so that a busy machine changes no mark. All that a submission
    does counts towards `seconds_a_submission`. All files of a student share `seconds_a_student`.
    """

    seconds_to_load: float = 10.0
    seconds_a_call: float = 3.0
    seconds_a_submission: int = 30
    seconds_a_student: int = 600
    bytes_of_memory: int = 1_500_000_000
    bytes_an_answer: int = 500_000

    def seconds_a_file(self, files: int) -> int:
        """Return what each of a student's files may use, whichever is graded first.

        >>> [Limits().seconds_a_file(files) for files in (1, 20, 21, 200)]
        [30, 30, 28, 3]
        """
        return max(1, min(self.seconds_a_submission, self.seconds_a_student // max(1, files)))

    @property
    def seconds_a_child(self) -> int:
        """Where the system itself ends a child: after the grader, which can say why, would."""
        return self.seconds_a_submission + 1
