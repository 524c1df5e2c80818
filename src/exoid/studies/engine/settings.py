"""What is asked of every recording, and the numbers by which that is computed."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib.metadata import version
from pathlib import Path
from types import MappingProxyType
from typing import Any

import exoid
from exoid.fitting.solve.compiled.kept_program import code_of
from exoid.studies.engine.plan import LARGEST

STEPS = ("drops", "fit", "diagnose")
# Recordings of a batch, at most. A diagnosis takes as long alone as beside others: each is kept,
# and told of, when it is done.
TOGETHER = {"drops": LARGEST, "fit": LARGEST, "diagnose": 1}
# bytes of a worker, with its libraries: of recordings of minutes it takes some two thirds of that
NEEDED = {"drops": 2**29, "fit": 2**31, "diagnose": 2**31}
NUMBERS = ("exoid", "jax", "jaxlib", "numpy", "scipy")  # packages that numbers hang on


@dataclass(frozen=True)
class Settings:
    """The steps, what takes long last, and the options of `fit` and `diagnose`."""

    steps: tuple[str, ...] = ("drops", "fit")
    fit: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    diagnose: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))

    def __post_init__(self):
        for step in self.steps:
            if step not in STEPS:
                raise ValueError(f"{step!r} is no step; they are {', '.join(STEPS)}.")
        if not self.steps or len(set(self.steps)) < len(self.steps):
            raise ValueError(f"name each step once, of {', '.join(STEPS)}.")
        object.__setattr__(self, "steps", tuple(sorted(self.steps, key=STEPS.index)))

    def __reduce__(self):  # a mapping proxy does not go to another process
        return Settings, (self.steps, dict(self.fit), dict(self.diagnose))

    @property
    def memory(self) -> int:
        """What a worker needs [bytes]."""
        return max(NEEDED[step] for step in self.steps)

    def digest(self, step: str) -> str:
        """A hash of what a step hangs on: its options, exoid's code, and the libraries that
        compute.
        """
        options = {"fit": self.fit, "diagnose": self.diagnose}.get(step, {})
        home = Path(exoid.__file__).parent
        code = code_of(home).hex(), code_of(home / "studies").hex()
        words = repr((step, sorted(options.items()), code, *map(version, NUMBERS)))
        return hashlib.sha256(words.encode()).hexdigest()[:32]
