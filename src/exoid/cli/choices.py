"""The words that options of `exoid fit` can take."""

from enum import StrEnum


class Prior(StrEnum):
    """Where the expected parameters come from."""

    de_leva = "de_leva"
    winter = "winter"
    dumas = "dumas"
    paper = "paper"
    none = "none"


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


class Clip(StrEnum):
    """Which samples of a segment are fitted."""

    free = "free"
    paper = "paper"
