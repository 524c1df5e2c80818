"""What the errors of measures in seconds hold, where a leg swings as none of its body does.

Gravity alone draws a leg back by m l g / J, and a spring, wherever it is slack, only harder. A drop
by an angle alone that is drawn back by clearly less has times that are too long, or is of another
body; one by far more has times that are too short, or is of a shorter leg.
"""

from math import sqrt

from exoid.pendulum.off_clock import by_clock
from exoid.physics.anatomy.expect import expected_leg
from exoid.recordings.can.units import GRAVITY
from exoid.recordings.conventions.balance import balance
from exoid.recordings.declared.subject import Subject
from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.drops import find_drop
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.sensor_scales import FARTHEST, SUSPECTED
from exoid.recordings.signal.condition import cut

SLOW, FAST = 0.85, 2.0  # times what gravity alone makes of this body's leg: no whole leg is beyond
SURE = 3.0  # standard errors
EXPLAINED = 0.98  # of the acceleration: else friction, a hand or a drift draws the leg, too
TOO_LONG = (
    "this drop is slower than any leg of this body swings: check the times (a sampling rate "
    "{times:.2g} times the one they have, or more, would explain it), body mass, height and age, "
    "and that every mass on the leg is declared. ± of times, velocities and accelerations allows "
    "for the clock: compare it with a true one and give clock_uncertainty"
)
TOO_SHORT = (
    "this drop is faster than any whole leg of this body swings: of a stump or a light prosthesis "
    "all is well, else check the times (a sampling rate {times:.2g} times the one they have would "
    "explain it), body mass, height and age. All in seconds holds if the times are right"
)


def with_doubted_times(
    measures: dict[str, Measure], recording: Recording, number: int
) -> tuple[dict[str, Measure], str | None]:
    """The measures, with errors that hold how far the times of a drop may be too long, and what to
    say of it; None where nothing shows it.
    """
    usual = pull_of_body(recording, number)
    found = None if usual is None else balance(free_part(recording, number))
    if usual is None or found is None or found.explained < EXPLAINED:
        return measures, None
    least, most = (found.pull + sign * SURE * found.pull_error for sign in (-1, 1))
    times = sqrt(usual / found.pull)
    if most < SLOW * usual:
        clock = SUSPECTED * min(times - 1, FARTHEST)
        held = {name: by_clock(each, clock) for name, each in measures.items()}
        return held, TOO_LONG.format(times=times)
    return measures, TOO_SHORT.format(times=times) if least > FAST * usual else None


def free_part(recording: Recording, number: int) -> Segment:
    """A drop without the hands before and behind it."""
    extent = find_drop(recording, number)
    return cut(recording.segments[number], slice(extent.free, extent.stop))


def pull_of_body(recording: Recording, number: int) -> float | None:
    """What gravity alone makes of a bare leg of this body [1/s^2]; None where that is not known,
    and where a gyro or the sidecar vouches for the times.
    """
    segment, told = recording.segments[number], recording.sensors.clock_uncertainty
    gyros = segment.raw_angular_velocity, segment.angular_velocity
    vouched = told is not None or any(each is not None for each in gyros)
    if recording.subject.kind == "rig" or vouched or recording.added_mass(number):
        return None
    return pull_of(recording.subject)


def pull_of(subject: Subject) -> float | None:
    """The same of anybody; None of a body that is not known, or that nobody has."""
    if subject.body_mass is None or subject.height is None:
        return None
    size, age, shank = (subject.body_mass, subject.height), subject.age, subject.shank_length
    try:
        leg = expected_leg(*size, age=age, shank_length=shank)
    except ValueError:
        return None
    return GRAVITY * leg.mass.value * leg.com_distance.value / leg.inertia.value
