"""What a look at a data set finds: what must be mended, and what should be known."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

Level = Literal["error", "warning"]


@dataclass(frozen=True)
class Finding:
    """One thing in one place. An error makes some answer of the study wrong or impossible."""

    level: Level
    kind: str  # such as `unreadable`: all of a kind are mended alike
    where: str
    says: str  # what is the matter and what to do, in one line


Findings = Iterator[Finding]


def error(kind: str, where: str, says: str) -> Finding:
    return Finding("error", kind, where, says)


def warning(kind: str, where: str, says: str) -> Finding:
    return Finding("warning", kind, where, says)
