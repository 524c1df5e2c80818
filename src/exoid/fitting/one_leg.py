"""Whether recordings that are fitted together are of one leg."""

import numpy as np

from exoid.recordings.recording import Recording

APART = (("body_mass", "kg", 6.0), ("height", "m", 0.03))  # by which one person's sidecars differ


def check_one_leg(named: list[tuple[str, Recording]]) -> None:
    """Refuse recordings whose sidecars speak of different people, sides or bodies."""
    for key, unit, most in APART:
        known = {
            name: value
            for name, recording in named
            if (value := getattr(recording.subject, key)) is not None
        }
        if not known:
            continue
        low, high = min(known, key=known.__getitem__), max(known, key=known.__getitem__)
        if known[high] - known[low] > most:
            raise ValueError(
                f"{low} says {key} {known[low]:g} {unit}, {high} says {known[high]:g} {unit}: "
                "recordings that are fitted together are of one leg. Fit them apart, or mend "
                "the sidecars."
            )
    for key in ("id", "side"):
        known = {
            value: name
            for name, recording in named
            if (value := getattr(recording.subject, key)) is not None
        }
        if len(known) > 1:
            (one, first), (other, second) = list(known.items())[:2]
            raise ValueError(
                f"{first} is of {key} {one}, {second} of {key} {other}: recordings that are fitted "
                "together are of one leg. Fit them apart, or mend the sidecars."
            )
    if len({recording.subject.kind == "rig" for _, recording in named}) > 1:
        raise ValueError("some recordings are of a rig, others of a leg: fit them apart.")
    for at, (name, recording) in enumerate(named):
        for other, again in named[at + 1 :]:
            if same_samples(recording, again):
                raise ValueError(f"{name} and {other} hold the same samples: give each only once.")


def same_samples(one: Recording, other: Recording) -> bool:
    """Is it the same recording twice?"""
    first, again = one.segments[0].channels(), other.segments[0].channels()
    return first.keys() == again.keys() and all(
        np.array_equal(samples, again[name], equal_nan=True) for name, samples in first.items()
    )
