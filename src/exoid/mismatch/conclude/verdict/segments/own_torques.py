"""That a torque of its own in each drop explains what is missing, and what that may be."""

import numpy as np

from exoid.mismatch.evidence.location import Location

MOSTLY = 0.5  # share of what is missing that constants of the segments explain: 0.96 and more where
# tone, seat or zero differ between drops, 0.21 at most of what acts alike in all of them
WITHIN = 1.5  # deviations of noise that remain within a segment: 0.5 to 1.0 where nothing else acts
RELAXED = (
    "To tell a muscle's tone from a seat or an encoder that moved: EMG of quadriceps and "
    "hamstrings, a leg that is relaxed alike before every drop, and the angle of the hanging leg "
    "before and after each."
)


def own_torques(location: Location) -> dict[str, float]:
    """By segment, what is missing in all of it [N m]; none where that leaves more than noise."""
    left = np.concatenate([(one.torque - one.torque.mean()) / one.band for one in location.missing])
    alone = float(np.sqrt(np.mean(left**2))) < WITHIN
    if location.by_segment < MOSTLY or not alone:
        return {}
    return {one.segment: float(one.torque.mean()) for one in location.missing}


def of_own_torques(torques: dict[str, float], inertia: float, *, guessed: bool) -> str:
    """What it is, and what may be behind it; over J where that is a guess."""
    scale, unit = (1 / inertia, "1/s^2") if guessed else (1.0, "N m")
    each = ", ".join(
        f"{torque * scale:+.2g} {unit} in segment {name}" for name, torque in torques.items()
    )
    over = "" if guessed else f" (for J = {inertia:.3g} kg m^2)"
    return (
        "a torque that stays the same within each segment, and differs between them, explains it "
        f"down to the noise: {each}{over}, positive towards extension. A muscle that is not "
        "relaxed alike, a seat that is tilted or an encoder that slips between drops look like this"
    )
