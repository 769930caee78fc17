"""What a submission may use."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Limits:
    """What a submission may use; each bound is far above what any task needs."""

    seconds_to_load: float = 10.0
    seconds_a_call: float = 3.0
    cpu_seconds: int = 20
    bytes_of_memory: int = 1_500_000_000
    bytes_an_answer: int = 2_000_000
