"""Does the angle of a leg count as exoid does? Told by where the leg swings, without a fit.

exoid's angle is 0 with the knee extended and the shank level, -pi/2 hanging, extension positive.
A knee does not extend far beyond 0, a drop goes well below it, and a leg swings about a place
between the plumb line and where its stiffness holds it.
"""

from dataclasses import dataclass, replace

import numpy as np

from exoid.recordings.conventions.balance import Balance, balance, swinging
from exoid.recordings.conventions.counting import answers, counting
from exoid.recordings.conventions.file_clock import measured
from exoid.recordings.conventions.gyro_agreement import agreement
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import SMOOTHING, classify
from exoid.recordings.signal.local_line import local_line

HIGHEST = 0.6  # rad; a knee overextends by 0.25, and a zero may be somewhat off
LOWEST = -0.4  # rad, that every drop passes
BEYOND = -2.3  # rad, beyond which no leg is in balance: the plumb line, a seat, a zero
STIFF = -0.8  # rad, above which it takes a spring that shows in how the leg swings
WEAKEST = 14.0  # 1/s^2; m l g / J of a leg is above 19 even with a mass at its foot
LEAST = 0.2  # rad; a leg that moves less is at rest
FEWEST = 4  # samples
SURE = 3.0  # standard errors
EXPLAINED = 0.6  # of the acceleration, from where on a balance is one
SHARP = 0.3  # rad, the error of a balance that tells something
TYPICAL = -1.3  # rad, where a leg is in balance
ALIKE = 0.2  # rad, within which two ways of counting make a leg of it equally well
ON_ITS_SIDE = (
    "Does the leg lie on its side, so that gravity does not turn it? Then read it as a rig without "
    'gravity: [subject] kind = "rig" and gravity = "none".'
)
WRAPS = (
    "An encoder that passes 0 or 360 deg needs angle_zero_deg below [sensors] in the sidecar: what "
    "it shows with the knee extended."
)
READINGS = (  # how a file may count: the sign, what is added to make it exoid's, its name
    (1.0, 0.0, "0 the extended knee and extension positive", "plain"),
    (-1.0, 0.0, "flexion positive", "flip"),
    (1.0, -np.pi / 2, "0 the hanging leg", "hanging"),
    (-1.0, -np.pi / 2, "0 the hanging leg and flexion positive", "both"),
    (1.0, -np.pi, "180 deg the straight knee", "straight"),
)


@dataclass(frozen=True)
class Swing:
    """Where the leg goes in one segment [rad]."""

    highest: float
    lowest: float
    passive: bool
    balance: Balance | None
    thigh: float  # the knee above the hip

    def counted(self, sign: float, shift: float) -> "Swing":
        """The same leg, if its angle is counted otherwise."""
        ends = sorted((sign * self.highest + shift, sign * self.lowest + shift))
        found = self.balance
        if found is not None:
            found = replace(found, angle=wrapped(sign * found.angle + shift))
        return Swing(ends[1], ends[0], self.passive, found, self.thigh)

    @property
    def likely(self) -> bool:
        """Can a leg move like this?"""
        if self.highest > HIGHEST or (self.passive and self.lowest > LOWEST):
            return False
        return self.balance is None or hangs(self.balance, self.thigh)

    @property
    def strange(self) -> float:
        """How far from where legs usually are in balance, or move [rad]."""
        middle = (self.highest + self.lowest) / 2 if self.balance is None else self.balance.angle
        return abs(middle - TYPICAL)


def hangs(found: Balance, thigh: float) -> bool:
    """Can gravity and a spring that is slack at 0 (Eq. 9) hold a leg there?

    Such a spring must be the stronger, the higher it holds a leg: g cos(angle) = -k angle, and then
    draws it by g (cos(angle) / -angle - sin(angle)), whence g, which is that of a leg or is not.
    """
    lowest = found.angle - SURE * found.angle_error
    if found.angle >= BEYOND and lowest < STIFF:
        return True
    if lowest >= 0 or found.angle + SURE * found.angle_error < BEYOND - abs(thigh):
        return False
    spring = max(np.cos(lowest + thigh) / -lowest, 0.0)
    share = spring - np.sin(lowest + thigh)
    return bool(found.pull + SURE * found.pull_error > WEAKEST * share)


def swing(recording: Recording, number: int, *, cut: bool) -> Swing | None:
    """Where the leg goes in a segment; None where it hardly moves."""
    segment = recording.segments[number]
    time, angle = measured(segment)
    if time.size < FEWEST:
        return None
    smooth = local_line(time, angle, 2 * SMOOTHING)[0]
    if np.ptp(smooth) < LEAST:
        return None
    passive = (recording.kind(number) or classify(segment)) in (None, "passive")
    found = balance(segment) if cut and passive else None
    told = found is not None and found.explained > EXPLAINED and found.angle_error < SHARP
    thigh = recording.thigh_angle(number)
    return Swing(float(smooth.max()), float(smooth.min()), passive, found if told else None, thigh)


def wrong_convention(recording: Recording, told: Sensors, *, cut: bool) -> str | None:
    """What to say of an angle that counts otherwise, and which option mends it.

    `told`: the sign and the zero by which the recording was turned. `cut`: the segments are single
    movements, without the hands between them.
    """
    if recording.subject.kind == "rig" or recording.sensors.zero is not None:
        return None  # of a rig anything goes; a zero that is declared is believed, or sought later
    each = {
        number: found
        for number in range(len(recording.segments))
        if (found := swing(recording, number, cut=cut)) is not None
    }
    hanging = [number for number, found in each.items() if found.likely and found.balance]
    judged = swinging(recording, list(each)) if hanging else each
    wrong = {number: each[number] for number in judged if not each[number].likely}
    if not wrong:
        return None
    first = min(wrong)
    where = "" if len(wrong) == len(each) else f"segment {first}: "
    rig = "" if recording.subject.kind else ' Of a rig, say [subject] kind = "rig".'
    sign, shift = counting(told)
    as_read = [one.counted(sign, -sign * shift) for one in wrong.values()]
    one_sense = same_sense(recording) != (told.flip in ("angle", "gyro"))
    mend = mended(as_read, one_sense, answers(told))
    right = "" if shift else ' If 0 is right, say zero="extended".'
    return f"{where}{described(wrong[first])}. {mend}{right}{rig}"


def described(found: Swing) -> str:
    """What the angle does, beside what it should do."""
    high, low = (np.degrees(each) for each in (found.highest, found.lowest))
    about = "" if found.balance is None else f" about {np.degrees(found.balance.angle):.0f} deg"
    return (
        f"the angle lies between {low:.0f} and {high:.0f} deg{about}: no leg hangs like that, "
        f"where 0 is the extended knee, -90 deg hanging, extension positive"
    )


def mended(wrong: list[Swing], same: bool, told: str) -> str:
    """The way of counting in which the leg is most like a leg, and how to tell of it in place of
    what was `told`; the swings are as the file counts.
    """
    flip = "all" if same else "angle"
    options = {
        "plain": f"leave out {told}",
        "flip": f'say flip="{flip}"',
        "hanging": 'say zero="hanging" if 0 is the upright shank, zero="unknown" if it is where '
        "this leg rests by itself",
        "both": f'say flip="{flip}" and zero="hanging"',
        "straight": "write angle_zero_deg = 180 below [sensors] in the sidecar, the .toml of the "
        "same name beside it (no option says it)",
    }
    found = {
        reading: [one.counted(*reading[:2]) for one in wrong]
        for reading in READINGS
        if all(one.counted(*reading[:2]).likely for one in wrong)
    }
    if not found:
        return (
            'Is its zero elsewhere? Then say zero="unknown", or angle_zero_deg in [sensors]. Is '
            f"the thigh not level? Then give thigh_angle_deg in [protocol]. {ON_ITS_SIDE}"
        )
    strange = {each: sum(one.strange for one in found[each]) / len(wrong) for each in found}
    best = [each for each in found if strange[each] < min(strange.values()) + ALIKE]
    names = ", or ".join(name for *_, name, _ in best)
    instead = f", instead of {told}" if told and best[0][3] != "plain" else ""
    mends = ", or ".join(options[each[3]] for each in best)
    wraps = f" {WRAPS}" if any(each[3] == "hanging" for each in best) else ""
    return f"Is {names} in this file? Then {mends}{instead}.{wraps}"


def same_sense(recording: Recording) -> bool:
    """Does a gyro turn the way the angle does?"""
    found = [one for each in recording.segments if (one := agreement(each)) is not None]
    return bool(found) and float(np.median([each.slope for each in found])) > 0


def wrapped(angle: float) -> float:
    """Between -pi and pi."""
    return float((angle + np.pi) % (2 * np.pi) - np.pi)
