"""How a result came about."""

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Origin:
    """How a result came about, so that it can be made again."""

    command: str
    made: str  # date and time with their zone
    settings: Mapping[str, str]
    versions: Mapping[str, str]  # of exoid and of what it computed with
    files: Mapping[str, str]  # path: SHA-256
