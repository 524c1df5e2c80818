"""What a fit takes for granted beside the recording: a table, its weight, limits, and words."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, get_args

from exoid.fitting.model.user_values import TABLE, ByHand, from_sidecar
from exoid.recordings.recording import Recording

PriorName = Literal["auto", "de_leva", "winter", "dumas", "child", "heavy", "paper", "none"]
BoundsName = Literal["body", "paper"]
PRIORS: tuple[PriorName, ...] = get_args(PriorName)
BOUNDS: tuple[BoundsName, ...] = get_args(BoundsName)


@dataclass(frozen=True)
class Assumptions:
    """The prior's table and weight (lambda of Eq. 11), the limits, and what was said by hand.

    `raw` takes every standard deviation as 1 in the parameter's own unit, the paper's Eq. 11.
    """

    prior: PriorName = "auto"
    weight: float = 1.0
    raw: bool = False
    bounds: BoundsName = "body"
    by_hand: ByHand = field(default_factory=ByHand)

    def __post_init__(self):
        for name, value, known in (("prior", self.prior, PRIORS), ("bounds", self.bounds, BOUNDS)):
            if value not in known:
                raise ValueError(f"{name} is {value!r}; it can be {', '.join(known)}.")


def by_hand(
    named: Sequence[tuple[str, Recording]],
    fix: Mapping[str, Any] | None,
    bound: Mapping[str, Any] | None,
    expect: Mapping[str, Any] | None,
) -> ByHand:
    """What was asked for now, and what the sidecars say of other parameters, the first before
    the next.
    """
    said = ByHand(fix or {}, bound or {}, expect or {})
    for name, recording in named:
        if TABLE not in recording.extra_tables:
            continue
        try:
            said = said.over(from_sidecar(recording.extra_tables[TABLE]))
        except ValueError as fault:
            raise ValueError(
                f"sidecar of {name}: {fault}" if len(named) > 1 else str(fault)
            ) from fault
    return said
