"""How well what a recording declares is known: sensors, seat, clock, torque and added mass."""

from collections.abc import Sequence
from dataclasses import dataclass, fields
from math import radians, sqrt
from typing import Annotated

import numpy as np

from exoid.fitting.model.mounting import Mounting
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.recordings.remembered import remembered
from exoid.recordings.signal.both_sensors.sensor_scales import GYRO_SCALE

OWNED = tuple(each.name for each in fields(Mounting))
OF_THE_GYRO = ("gyro_scale", "gyro_bias")
OF_THE_MASS = ("log_distance", "log_added", "extent")
OF_MASSES = {"distance_apart": "log_distance", "extent_apart": "extent"}  # of several, by one's
OF_THE_LOAD = ("damping_under_load", "stiffness_under_load")  # of a leg that bears more
OF_THE_REST = ("zero", "tilt")  # they decide where a leg comes to rest
OF_THE_TORQUE = ("torque_zero", "torque_gain")
OF_SENSORS = {  # and by what a sidecar tells those of another recording apart
    "zero": ("device", "encoder_counts"),
    "gyro_scale": ("device", "gyro_range"),
    "clock": ("device",),
    "torque_zero": ("device",),
    "torque_gain": ("device",),
}
SOMEWHERE = 0.35  # m, of a mass on the shank of which no more is known
ANYWHERE = 0.5  # of its logarithm

# Where nothing is declared, one standard deviation:
ZERO = radians(1.2)  # a sensor aligned along a leg by eye or by goniometer
ZERO_OF_RIG = radians(5.0)
TILT = radians(0.2)  # a seat that looks level; one that is not is followed (`tilted_seats.py`)
SLANT = radians(2.5)  # the same of a leg whose centre of mass a foot puts beside its line
FOOT = 0.5  # of all legs are taken for such
GYRO_BIAS = radians(5.0)  # rad/s; LSM6DS3: +-10 deg/s at zero rate
CLOCK = 1e-4  # a quartz, cheap and warm; where encoder and gyro disagree, it may be the clock
LOOSE_CLOCK = 5e-3  # of phones, cameras and computers, unless somebody looked: seldom more
WEIGHED = 5e-3  # of the added mass: a kitchen scale
PLACED = 5e-3  # m, its distance, by tape
MISREAD = 0.04  # m, the same where the tape was read wrong, or held to another place,
SELDOM = 0.1  # of all distances
GYRATION = 0.05  # m, half-normal radius of gyration of weights and cuffs about their own centre
# Of the greatest torque of a recording: 1 % of a range that is five times what is used of it, and
# the weight of a lever that nobody took off.
ZERO_OF_TORQUE = 0.05
# Of the reading: 0.55 % of the same range at most, of a sensor and its indicator (Mark-10, R50 with
# 3i), is 2.8 % of a reading of a fifth of it.
GAIN_OF_TORQUE = 0.015
# Of a leg that bears more, the share by which d and c differ. 2 kg load cartilage (a coefficient of
# friction of 0.025, Bonnevie et al., Tribol Lett 41, 2011, by a radius of 3 cm) and a dry hinge
# (0.2 by 4 mm) by 20 N: 0.015 N m each, together as 5 % of a relaxed knee's damping in its first
# swings, 15 % in its last. No spring rubs; yet 0.55 % of the variance of stiffness over people is
# within them, 8.9 % of that of damping (29 older adults, modified pendulum test, Nursing Research):
# 2.5 % and 10 % of what scatters by a third between people.
DAMPING_UNDER_LOAD = 0.1
STIFFNESS_UNDER_LOAD = 0.02
MEASURED_GYRATION = 0.1  # of a declared radius of gyration
# Of the variance, what recordings of one session have in common: their sensors, seat and weights
# are the same. The rest is a cuff that slips, a weight that is strapped on anew.
ALIKE = 0.95
# The same of the weights of several masses: all but what a scale's reading scatters, 2 g of the 5 g
# to which a kilogram is weighed, is its gain, the same for all that is weighed on it.
ONE_SCALE = 0.8


@dataclass(frozen=True)
class Systematics:
    """One standard deviation of everything that a recording owns; 0 is exact."""

    zero: Annotated[float, "rad"] = ZERO
    tilt: Annotated[float, "rad"] = TILT
    gyro_scale: float = GYRO_SCALE
    gyro_bias: Annotated[float, "rad/s"] = GYRO_BIAS
    clock: float = CLOCK
    torque_zero: float = ZERO_OF_TORQUE  # of the greatest torque
    torque_gain: float = GAIN_OF_TORQUE
    torque_reach: Annotated[float, "N m"] = 0.0  # that greatest torque, of the whole recording
    damping_under_load: float = DAMPING_UNDER_LOAD
    stiffness_under_load: float = STIFFNESS_UNDER_LOAD
    log_added: float = WEIGHED
    distance: Annotated[float, "m"] = PLACED
    expected_extent: Annotated[float, "m^2"] = GYRATION**2
    extent: Annotated[float, "m^2"] = sqrt(2) * GYRATION**2
    declared: frozenset[str] = frozenset()  # which of them the sidecar says


DECLARED_NOTHING = Systematics()
NONE = np.zeros((0, 0))


def systematics(recording: Recording, number: int) -> Systematics:
    """Of one segment of a recording: what its sidecar says, else what data sheets do."""
    subject, protocol, sensors = recording.subject, recording.protocol, recording.sensors
    mass, said = recording.added_mass(number), subject.added_mass_uncertainty
    gyration = subject.added_mass_gyration
    extents = {} if gyration is None else extent_of(gyration)
    rig = {"zero": ZERO_OF_RIG, "stiffness_under_load": 0.0} if subject.kind == "rig" else {}
    zero, reach = sensors.torque_zero_uncertainty, greatest_torque(recording)
    told = {
        "zero": sensors.angle_zero_uncertainty,
        "tilt": protocol.thigh_angle_uncertainty,
        "gyro_scale": sensors.gyro_scale_uncertainty,
        "clock": sensors.clock_uncertainty,
        "torque_zero": None if zero is None or not reach else zero / reach,
        "torque_gain": sensors.torque_gain_uncertainty,
        "log_added": said / mass if said is not None and mass > 0 else None,
        "distance": subject.added_mass_distance_uncertainty,
        **under_load(subject),
        **extents,
    }
    told = {name: value for name, value in told.items() if value is not None}
    return Systematics(**(rig | told), torque_reach=reach, declared=frozenset(told))


def under_load(subject: Subject) -> dict[str, float | None]:
    """How well damping and stiffness are said to stay the same beside an added mass."""
    return {name: getattr(subject, f"{name}_uncertainty") for name in OF_THE_LOAD}


def extent_of(gyration: float) -> dict[str, float]:
    """k^2 and its standard deviation, of a declared radius of gyration [m]."""
    return {
        "expected_extent": gyration**2,
        "extent": 2 * MEASURED_GYRATION * gyration**2,
    }


def deviations(each: Sequence, owned: Sequence[str] = OWNED) -> Mounting:
    """Of every recording among these movements; no entries for what no unknown is."""
    rows = [own_deviations(own) for own in by_recording(each)]
    return Mounting(
        **{
            name: np.array([row[name] for row in rows]) if name in owned else np.zeros(0)
            for name in OWNED
        }
    )


def by_recording(movements: Sequence) -> list[list]:
    """The movements of every recording."""
    numbers = sorted({one.recording for one in movements})
    return [[one for one in movements if one.recording == number] for number in numbers]


def own_deviations(movements: Sequence) -> dict[str, float]:
    """Of one recording. What is exact counts as 1: it is no unknown."""
    first = movements[0].systematics
    loaded = [one for one in movements if one.added_mass > 0]
    each = {*OWNED} - {"log_distance", *OF_MASSES}
    found = {name: getattr(first, name) for name in each}
    if loaded:
        of_mass = loaded[0].systematics
        found |= {name: getattr(of_mass, name) for name in ("log_added", "extent", *OF_THE_LOAD)}
    placed = [one.added_mass_distance for one in loaded if not one.unplaced]
    if any(one.unplaced for one in loaded):
        found["log_distance"] = ANYWHERE
    else:
        found["log_distance"] = first.distance / np.mean(placed) if placed and min(placed) else 1.0
    found |= {name: sqrt(2) * found[of_one] for name, of_one in OF_MASSES.items()}
    return {name: value or 1.0 for name, value in found.items()}


def in_common(each: Sequence, owned: Sequence[str] = OWNED) -> Mounting:
    """W of everything that recordings own, with W'W the inverse of its correlation among them."""
    recordings = by_recording(each)

    def whitening(name: str) -> np.ndarray:
        known, what = [known_as(own, name) for own in recordings], which(recordings, name)
        both = [None if one is None else (one, of) for one, of in zip(known, what, strict=True)]
        shared = ALIKE * equal(both)
        if name == "log_added":
            shared = np.maximum(shared, ONE_SCALE * equal(known))
        return np.linalg.inv(np.linalg.cholesky(np.where(np.eye(len(both)), 1.0, shared)))

    return Mounting(**{name: whitening(name) if name in owned else NONE for name in OWNED})


def equal(each: Sequence) -> np.ndarray:
    """Which of them are equal; None is to nothing."""
    return np.array([[one is not None and one == other for other in each] for one in each])


def known_as(movements: Sequence, name: str) -> tuple | None:
    """In which session, and how well, a recording knows this; None of what is exact, or is each
    recording's own: a gyro's bias drifts.
    """
    first = first_unknown(movements, name)
    if name == "gyro_bias" or first is None:
        return None
    return first.session, own_deviations(movements)[name], name in first.systematics.declared


def which(recordings: Sequence[Sequence], name: str) -> list:
    """By recording, of which sensors, mass or seat this is."""
    if name in OF_SENSORS:
        return sensors_of(recordings, OF_SENSORS[name])
    first = [first_unknown(own, name) or own[0] for own in recordings]
    if name == "tilt":
        return [one.thigh_angle for one in first]
    return [one.added_mass if name == "log_added" else one.load for one in first]


def sensors_of(recordings: Sequence[Sequence], names: Sequence[str]) -> list[tuple]:
    """By recording, what tells its sensors from others: where recordings name but one, it is that
    of those, too, that name none.
    """
    said = [[getattr(own[0].sensors, name) for name in names] for own in recordings]
    several = [len({*column} - {None}) > 1 for column in zip(*said, strict=True)]
    return [tuple(value for value, more in zip(one, several, strict=True) if more) for one in said]


def first_unknown(movements: Sequence, name: str):
    """The first movement of a recording that does not have this exact; None where all have."""
    return next((one for one in movements if not is_exact(one, name, movements)), None)


def sharing(whitening: np.ndarray) -> list[list[int]]:
    """The recordings in groups, each of those that have this in common."""
    alike = {tuple(np.flatnonzero(row).tolist()) for row in whitening.T @ whitening}
    return sorted(map(list, alike))


def owned_by(movements: Sequence, owned: Sequence[str] = OWNED) -> tuple[str, ...]:
    """What of `owned` is an unknown of a fit to these movements: nothing of a torque that none
    measures, no gain of one whose unit is any, and no zero where a torque drove all of them; nor
    how several masses differ where no recording has several.

    Then nothing tells it from a seat's tilt, an encoder's zero or a spring, and a model that misses
    much would take it for an excuse: errors hold it instead (`estimates/moved.py`).
    """
    driven = [one for one in movements if one.kind == "measured"]
    mixed = 0 < len(driven) < len(movements)
    has = {"torque_zero": mixed, "torque_gain": any(one.gain_known for one in driven)}
    has |= dict.fromkeys(OF_MASSES, any(apart(one, movements) for one in movements))
    return tuple(name for name in owned if has.get(name, True))


def zero_of_torque(movements: Sequence) -> float:
    """One standard deviation of that of a recording [N m]; 0 where no torque is measured."""
    driven = [one.systematics for one in movements if one.kind == "measured"]
    return max((known.torque_zero * known.torque_reach for known in driven), default=0.0)


@remembered  # for every of its segments
def greatest_torque(recording: Recording) -> float:
    """That was measured in any segment of a recording [N m]; 0 where none was."""
    each = [one.applied_torque for one in recording.segments if one.applied_torque is not None]
    return max((float(np.nanmax(np.abs(one), initial=0.0)) for one in each), default=0.0)


def is_exact(one, name: str, movements: Sequence) -> bool:
    if name in OF_THE_GYRO and one.angular_velocity is None:
        return True
    if name in OF_THE_MASS and one.added_mass == 0:
        return True
    if name in OF_MASSES:
        return not apart(one, movements) or is_exact(one, OF_MASSES[name], movements)
    if name in OF_THE_LOAD and one.borne == 0:
        return True
    if name in OF_THE_TORQUE and one.kind != "measured":
        return True
    if name == "torque_gain" and not one.gain_known:
        return True
    if name == "log_distance":
        if one.unplaced:
            return False
        return beside_unplaced(one, movements) or one.systematics.distance == 0
    return getattr(one.systematics, name) == 0


def beside_unplaced(one, movements: Sequence) -> bool:
    """Does its recording also have masses of unknown distance, which its own says nothing of?"""
    return any(each.unplaced for each in movements if each.recording == one.recording)


def apart(one, movements: Sequence) -> float:
    """Of the added mass of a movement, where it stands among several of its recording: from -1/2,
    the lightest, to 1/2; 0 of the only one, and of none.
    """
    own = (each for each in movements if each.recording == one.recording and each.added_mass > 0)
    loads = sorted({(each.added_mass, each.load[1] or 0.0) for each in own})
    if one.added_mass == 0 or len(loads) < 2:
        return 0.0
    return loads.index((one.added_mass, one.load[1] or 0.0)) / (len(loads) - 1) - 0.5
