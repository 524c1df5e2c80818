"""The words that options can take."""

from enum import StrEnum


class Table(StrEnum):
    """Where the expected parameters come from."""

    auto = "auto"
    de_leva = "de_leva"
    winter = "winter"
    dumas = "dumas"
    child = "child"
    heavy = "heavy"
    paper = "paper"
    none = "none"


class Bounds(StrEnum):
    """Between which limits a fit searches."""

    body = "body"
    paper = "paper"


class Method(StrEnum):
    """How the misfit is minimised."""

    lm = "lm"
    slsqp = "slsqp"


class Reading(StrEnum):
    """The two readings of Eq. 4."""

    one = "1/T"
    two = "2/T"


class Misfit(StrEnum):
    """What Eq. 11 compares."""

    weighted = "weighted"
    paper = "paper"
