"""Is one of the drops of another leg? Told by how hard gravity and stiffness draw it."""

import numpy as np

from exoid.files.text_file import Notes
from exoid.recordings.conventions.balance import Balance, balance, middle, swinging
from exoid.recordings.recording import Recording

APART = 1.3  # factor between the pulls of an adult and a child; effort and noise make 1.2
SURE = 4.0  # standard errors
EXPLAINED = 0.9  # of the acceleration, from where on two pulls can be compared


def another_leg(recording: Recording) -> Notes:
    """The drops that swing so much slower or faster than the others that they are doubtful."""
    if recording.subject.kind == "rig":
        return ()
    pulls: dict[float, dict[int, Balance]] = {}
    passive = [n for n in range(len(recording.segments)) if recording.kind(n) == "passive"]
    for number in swinging(recording, passive):
        found = balance(recording.segments[number])
        if found is not None and found.explained > EXPLAINED:
            pulls.setdefault(recording.added_mass(number), {})[number] = found
    return tuple(
        f"segment {number} is drawn to rest by {each.pull:.3g} 1/s^2, the others by "
        f"{usual.pull:.3g}: is it of another leg, with a mass that is not told, or on another "
        "clock? Leave it out, or fit it apart."
        for alike in pulls.values()
        for usual in [middle(list(alike.values()))]
        for number, each in alike.items()
        if apart(each, usual)
    )


def apart(one: Balance, other: Balance) -> bool:
    """Do two pulls differ by more than a leg's own swings do, for sure?"""
    error = np.hypot(one.pull_error / one.pull, other.pull_error / other.pull)
    return bool(abs(np.log(one.pull / other.pull)) > max(np.log(APART), SURE * error))
