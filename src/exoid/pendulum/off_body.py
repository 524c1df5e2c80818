"""What the errors of measures in seconds hold, where a leg swings as none of its body does.

Gravity alone draws a leg back by m l g / J, and a spring, wherever it is slack, only harder. A drop
by an angle alone that is drawn back by clearly less has times that are too long, or is of another
body; one by far more has times that are too short, or is of a shorter leg.
"""

from math import sqrt

from exoid.pendulum.off_clock import by_clock
from exoid.physics.anatomy.expect import expected_leg
from exoid.physics.anatomy.expected import ExpectedLeg
from exoid.physics.anatomy.likeness import off_rate, pendulum_length, rate_of
from exoid.physics.gravity import GRAVITY
from exoid.recordings.conventions.balance import balance
from exoid.recordings.declared.subject import Subject
from exoid.recordings.landmarks.measure import Measure
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.drops import find_drop
from exoid.recordings.recording import Recording
from exoid.recordings.signal.both_sensors.sensor_scales import suspected
from exoid.recordings.signal.condition import cut

FAST = 2.0  # times what gravity alone makes of this body's leg, which no spring of a whole leg adds
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
    leg = leg_by_times(recording, number)
    found = None if leg is None else balance(free_part(recording, number))
    if leg is None or found is None or found.explained < EXPLAINED:
        return measures, None
    times, usual = rate_of(leg, found.pull).value, GRAVITY / pendulum_length(leg).value
    if off_rate(leg, found.pull, found.pull_error) > 0:
        spring = leg.stiffness.value / leg.inertia.value
        clock = suspected(sqrt((usual + spring) / found.pull) - 1)
        held = {name: by_clock(each, clock) for name, each in measures.items()}
        return held, TOO_LONG.format(times=times)
    fast = found.pull - SURE * found.pull_error > FAST * usual
    return measures, TOO_SHORT.format(times=times) if fast else None


def free_part(recording: Recording, number: int) -> Segment:
    """A drop without the hands before and behind it."""
    extent = find_drop(recording, number)
    return cut(recording.segments[number], slice(extent.free, extent.stop))


def leg_by_times(recording: Recording, number: int) -> ExpectedLeg | None:
    """The bare leg that swings as its times have it; None where nobody knows what body it is of,
    and where a gyro or the sidecar vouches for the times.
    """
    segment, told = recording.segments[number], recording.sensors.clock_uncertainty
    gyros = segment.raw_angular_velocity, segment.angular_velocity
    vouched = told is not None or any(each is not None for each in gyros)
    if recording.subject.kind == "rig" or vouched or recording.added_mass(number):
        return None
    return leg_of(recording.subject)


def leg_of(subject: Subject) -> ExpectedLeg | None:
    """What is expected of anybody; None of a body that is not known, or that nobody has."""
    if subject.body_mass is None or subject.height is None:
        return None
    size, age, shank = (subject.body_mass, subject.height), subject.age, subject.shank_length
    try:
        return expected_leg(*size, age=age, shank_length=shank)
    except ValueError:
        return None
