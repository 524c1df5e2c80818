"""What to say of a recording that misses nothing: what is off in it, and what may hide in it."""

import numpy as np

from exoid.fitting.result.fit_result import FitResult
from exoid.fitting.result.remarks.anatomy_remarks import at_rate, unlike_anatomy
from exoid.mismatch.conclude.numbers import CERTAIN
from exoid.mismatch.screen.prepared_recording import PreparedRecording


def of_zeros(result: FitResult, prepared: PreparedRecording) -> list[str]:
    """What to say of zeros of encoders that are certainly off, and no cause of anything."""
    usual = {each.source: each.systematics.zero for each in prepared.problem.movements}
    said = []
    for each in result.mountings:
        value, error = (each.zero.value, each.zero.standard_error) if each.zero else (None, None)
        if value is None or error is None or abs(value) < CERTAIN * error:
            continue
        whose = f" in {each.recording}" if len(result.mountings) > 1 else ""
        more = "more" if abs(value) > usual[each.recording] else "no more"
        said.append(
            f"the encoder's zero{whose} is off by {np.degrees(value):.2g} deg, {more} than is "
            "to be expected; the fit estimates it"
        )
    return said


def of_what_hides(result: FitResult) -> list[str]:
    """What a leg that is like no other may hide within the noise."""
    basis = result.basis
    assert basis is not None  # a joint fit has one
    belief = basis.problem.belief
    gravity = float(basis.ended.best.coordinates.shared.gravity[0])
    return [
        f"{each}: a spring with another rest angle, an encoder's zero, a mass that nobody declared "
        f"or {at_rate(belief, gravity)} would look like this, and hide in it"
        for each in unlike_anatomy(belief, gravity)
    ]
