"""Where simulation and recording part: the torque that the baseline lacks, in time and in words."""

from math import degrees

import jax
import jax.numpy as jnp
import numpy as np
from scipy.interpolate import make_interp_spline

from exoid.fitting.data.observation import Observation
from exoid.fitting.misfit.equation import equation
from exoid.fitting.model.coordinates import Unknowns, of_owner
from exoid.fitting.solve.program_cache import called
from exoid.mismatch.evidence.location import (
    OPEN,
    Location,
    Missing,
    Region,
    Samples,
    described,
)
from exoid.mismatch.screen.hypothesis import Hypothesis, Optimum
from exoid.mismatch.screen.measured_motion import FREE, drive_of
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.physics.leg import angular_acceleration
from exoid.physics.state import LegState
from exoid.physics.term import SensorTerm

WIDTH = 0.1  # s, over which the missing torque is averaged
CLEAR = 3.0  # standard deviations beyond which it is not noise
STRONG = 0.5  # of its largest: what is named
LARGEST = 0.98  # quantile: friction that sticks and slips has spikes
SHORTEST = 0.03  # s
MOST = 6  # places that are named
TURNING = np.radians(30.0)  # rad/s, below which a leg is at a reversal
FEW = 12  # bins of angle or speed with as many samples each, and as many of equal width
SPLINE = 5  # degree, of which a simulated motion loses nothing between two samples
BY_EQUATION = "exoid.mismatch.evidence.locate:by_equation"
EXPECTED = jax.tree.structure((np.zeros(1), np.zeros(())))


def locate(prepared: PreparedRecording, base: Hypothesis, best: Optimum) -> Location:
    """The torque that would make the baseline move as the sensors show, and as `best` does.

    Where only sensors err, none is missing that `best` would have.
    """
    acts = any(not issubclass(term, SensorTerm) for term in best.candidate.terms)
    shown = np.asarray(best.motion) if acts else None
    missing = [
        lacking(prepared, base, number, None if shown is None else shown[number])
        for number in range(prepared.segments)
    ]
    regions = [region for each in missing for region in regions_of(each)]
    regions.sort(key=lambda each: abs(each.torque) * (each.end - each.begin), reverse=True)
    rows = [(each.angle, each.angular_velocity, each.torque) for each in missing]
    angle, speed, torque = map(np.concatenate, zip(*rows, strict=True))
    inertia = float(np.exp(prepared.coordinates(base).shared.log_inertia))
    shares = explained(angle, torque), explained(speed, torque)
    return Location(missing, regions[:MOST], *shares, inertia, between(missing), prepared.rig)


def lacking(
    prepared: PreparedRecording, base: Hypothesis, number: int, shown: np.ndarray | None = None
) -> Missing:
    """J (phi'' - Eq. 9) along the measured motion and along the simulated one that is `shown`,
    (time, channel), averaged over a few samples. The encoder's zero is the baseline's. Where the
    leg is let go, and at the end, the sensors do not tell the acceleration: nothing is said there.
    Both motions are as the encoder has them: the reference is without the errors of the gyro.
    """
    coordinates, seen = prepared.coordinates(base), prepared.seen
    reference = prepared.sensors.references[number]
    size = reference.angle.size

    def own(tree):
        return jax.tree.map(lambda leaf: np.asarray(leaf)[number], tree)

    observation = own(seen)
    mounting = of_owner(coordinates.mounting, observation.owner)
    unknowns = Unknowns(coordinates.shared, mounting, own(coordinates.own))
    time = observation.time[:size]
    beyond = observation.time.size - size
    zero = base.zero[1]

    def excess(angle, velocity, acceleration):
        moved = (np.pad(each, (0, beyond), mode="edge") for each in (angle - zero, velocity))
        given = (unknowns, observation, *moved)
        expected, inertia = called(BY_EQUATION, given, None, EXPECTED, brief=True)
        return averaged((acceleration - expected[:size]) * inertia, width)[free], float(inertia)

    width = max(1, round(WIDTH / float(np.median(np.diff(time)))))
    weighs = observation.angle_weight + observation.velocity_weight > 0
    unsure = reference.smoother.unsure(width)
    let_go = int(np.argmax(weighs))  # before it a hand was on the leg
    free = slice(let_go + unsure + width // 2, size - unsure - (width - 1 - width // 2))
    if free.stop - free.start < width:  # of a short segment all that there is
        free = slice(let_go, size)
    modelled = None
    if shown is not None:
        motion = make_interp_spline(time, shown[:size, 0], k=SPLINE)
        modelled, _ = excess(*(motion(time, order) for order in range(3)))
    angle, velocity = reference.angle, reference.angular_velocity
    torque, inertia = excess(angle, velocity, reference.angular_acceleration)
    band = reference.smoother.spread(width) * inertia
    name = prepared.problem.movements[number].name
    along = (time[free], angle[free], velocity[free])
    return Missing(name, *along, torque, band, modelled, width, inertia)


def by_equation(unknowns: Unknowns, observation: Observation, angle, velocity, _: None):
    """phi'' of Eq. 9 at every sample [rad/s^2], and the inertia that moves [kg m^2]."""
    eq = equation(unknowns, observation, FREE)
    known = drive_of(eq, observation)
    drive = jnp.append(known.begin, known.end[-1])
    return angular_acceleration(eq.ratios, LegState(angle, velocity), drive), 1 / eq.torque


def averaged(torque: np.ndarray, width: int) -> np.ndarray:
    """The mean over `width` samples around each."""
    around = np.pad(torque, (width // 2, width - 1 - width // 2), mode="edge")
    return np.convolve(around, np.ones(width) / width, "valid")


def explained(cause: Samples, torque: Samples) -> float:
    """The share of the torque's variance between bins of a cause.

    Most samples are of small swings, and most of the torque of the few large ones: bins of as many
    samples each are wide there, and those of equal width are few elsewhere. Both cut.
    """
    inner = np.linspace(0, 1, FEW + 1)[1:-1]
    low, high = cause.min(), cause.max()
    edges = np.sort([*np.quantile(cause, inner), *(low + (high - low) * inner)])
    bins = np.searchsorted(edges, cause)
    count = np.maximum(np.bincount(bins), 1)
    means = np.bincount(bins, torque) / count
    return float(np.var(means[bins]) / (np.var(torque) or 1.0))


def between(missing: list[Missing]) -> float:
    """The share of the torque's variance that a constant of each segment explains."""
    means = np.concatenate([np.full(each.torque.size, each.torque.mean()) for each in missing])
    whole = float(np.var(np.concatenate([each.torque for each in missing]))) or 1.0
    return float(np.var(means) / whole)


def regions_of(each: Missing) -> list[Region]:
    """The stretches where the torque is strong, and beyond what the sensors leave open."""
    torque = each.torque if each.modelled is None else each.modelled
    beyond = CLEAR if each.modelled is None else OPEN
    least = max(beyond * each.band, STRONG * float(np.quantile(np.abs(torque), LARGEST)))
    sign = np.where(np.abs(torque) > least, np.sign(torque), 0.0)
    edges = np.flatnonzero(np.diff(sign)) + 1
    found = []
    for part in np.split(np.arange(sign.size), edges):
        lasting = each.time[part[-1]] - each.time[part[0]] >= SHORTEST
        if lasting and sign[part[0]] * each.torque[part].mean() > 0:
            found.append(region_of(each, part, float(torque[part].mean())))
    return found


def region_of(each: Missing, part: np.ndarray, torque: float) -> Region:
    angle, speed = each.angle[part], each.angular_velocity[part]
    low, high = degrees(angle.min()), degrees(angle.max())
    fastest = float(np.max(np.abs(speed)))
    if fastest < TURNING:
        manner = "at rest or turning"
    elif (speed > 0).all():
        manner = f"extending at up to {degrees(fastest):.0f} deg/s"
    elif (speed < 0).all():
        manner = f"flexing at up to {degrees(fastest):.0f} deg/s"
    else:
        manner = "through a reversal"
    place = f"{low:.0f} deg" if f"{low:.0f}" == f"{high:.0f}" else f"{low:.0f} to {high:.0f} deg"
    region = f"{place}, {manner}"
    begin, end = float(each.time[part[0]]), float(each.time[part[-1]])
    return Region(
        segment=each.segment,
        begin=begin,
        end=end,
        region=region,
        description=described(torque, region),
        torque=torque,
    )
