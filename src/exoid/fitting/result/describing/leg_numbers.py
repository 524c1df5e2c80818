"""The leg's numbers with their errors."""

from dataclasses import dataclass

from exoid.fitting.result.estimates.estimate import Estimate

DISTANCE = "added_mass_distance"  # as it is called outside


@dataclass(frozen=True)
class LegNumbers:
    """The leg's numbers, and the errors of m l g beside those of its factors."""

    ratios: dict[str, Estimate]
    parameters: dict[str, Estimate]
    moment_grown: float  # N m, with the error of m l g / J
    moment_by_distance: float  # N m, for an added mass that hangs elsewhere
