"""A recording: seed and settings of a game and all inputs, each with the step it came before."""

from __future__ import annotations

import json
from collections import defaultdict
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from lesson_code.view.pygame.game import MOUSE, Input

VERSION = 1
KINDS = ("press", "release", "set", "keep", "restore", "forget", "show", "open", *MOUSE)


class Recording:
    """What a player did, written down or played again.

    Parameters
    ----------
    program : str
        The program's name.
    seed : int
        Of the game.
    settings : mapping, optional
        What else the game is made with; a player's functions are not written down.

    Attributes
    ----------
    is_played : bool
        Whether it comes from a file and is played again.
    steps : int
        How long it is then; 0 before.

    Examples
    --------
    >>> recording = Recording("cradle", seed=1)
    >>> recording.note(7, Input("press", "r"))
    >>> recording.as_dict(steps=60)["inputs"]
    [[7, 'press', 'r', 0.0, 0.0]]
    """

    def __init__(
        self, program: str, seed: int, settings: Mapping[str, Any] = MappingProxyType({})
    ) -> None:
        self.program, self.seed = program, seed
        self.settings = {name: value for name, value in settings.items() if isinstance(value, int)}
        self.is_played = False
        self._inputs: dict[int, list[Input]] = defaultdict(list)
        self.steps = 0

    def note(self, step: int, given: Input) -> None:
        """Write down an input that came before a step."""
        self._inputs[step].append(given)

    def inputs_at(self, step: int) -> list[Input]:
        """Return the inputs to play before a step; none unless a recording is played."""
        return self._inputs.get(step, []) if self.is_played else []

    def forget_from(self, step: int) -> None:
        """Forget the inputs from a step on; not those of a file that is played."""
        if not self.is_played:
            for late in [known for known in self._inputs if known >= step]:
                del self._inputs[late]

    def before(self, step: int) -> list[Input]:
        """Return the inputs that came before a step."""
        return self._inputs.get(step, [])

    def is_over(self, step: int) -> bool:
        """Return whether a recording that is played has come to its end."""
        return self.is_played and step >= self.steps

    def as_dict(self, steps: int) -> dict[str, Any]:
        """Return all of it as plain values."""
        return {
            "version": VERSION,
            "program": self.program,
            "seed": self.seed,
            "settings": self.settings,
            "steps": steps,
            "inputs": [
                [step, given.kind, given.key, *given.place]
                for step, some in sorted(self._inputs.items())
                for given in some
            ],
        }

    def write(self, path: str | Path, steps: int) -> None:
        """Write it to a file."""
        Path(path).write_text(json.dumps(self.as_dict(steps)) + "\n", encoding="utf-8")

    @classmethod
    def read(cls, path: str | Path, program: str) -> Recording:
        """Return a recording from a file, to be played again.

        Raises
        ------
        ValueError
            The file holds no recording, or one of another program.
        OSError
            The file cannot be read.
        """
        text = Path(path).read_text(encoding="utf-8")
        try:
            stored = json.loads(text)
            settings = {str(name): int(n) for name, n in stored.get("settings", {}).items()}
            recording = cls(str(stored["program"]), int(stored["seed"]), settings)
            recording.steps = int(stored["steps"])
            for step, kind, key, x, y in stored["inputs"]:
                if kind not in KINDS:
                    raise ValueError(f"there is no input {kind!r}")
                recording.note(int(step), Input(kind, str(key), (float(x), float(y))))
        except (ValueError, TypeError, KeyError, AttributeError) as error:
            raise ValueError(f"replay must be a recording, got {path} ({error})") from None
        if recording.program != program:
            raise ValueError(
                f"replay must be a recording of {program}, got one of {recording.program}"
            )
        recording.is_played = True
        return recording
