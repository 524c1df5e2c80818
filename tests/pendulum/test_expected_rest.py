"""Where a leg would have come to rest whose record was cut before, with an error that holds it."""

import numpy as np
import pytest
from scipy.optimize import brentq

from exoid.pendulum.drops import measure_drops
from exoid.recordings.landmarks.expected_rest import expected_rest
from exoid.recordings.landmarks.measure import NotAllowed
from exoid.recordings.landmarks.track import Peak
from hands import Device, Hand, Knee, dropped
from swings import Oscillator, drop, recorded


def turned(*angles: float) -> list[Peak]:
    return [Peak(at, float(at), 0.0, angle, 0.0) for at, angle in enumerate(angles)]


@pytest.mark.parametrize("lasting", [2.2, 3.0, 4.0])
@pytest.mark.parametrize("decay", [0.2, 0.4, 0.6])
def test_the_index_of_a_viscous_leg_is_kept_where_its_record_is_cut(decay, lasting):
    leg = Oscillator(decay=decay)
    (found,) = measure_drops(drop(leg, lasting=lasting)).drops
    assert found.measures["relaxation_index"].value is None
    kept = found.measures["expected_relaxation_index"]
    # Turns are found to some 1e-4 of the amplitude.
    assert kept.value == pytest.approx(1 + np.exp(-leg.decrement / 2), abs=2e-3)
    assert kept.standard_error is not None
    assert 0.0 < kept.standard_error < 0.2


def test_a_leg_that_a_hand_lifted_has_the_index_that_its_free_swings_tell():
    camera = Device(gyro=None)
    free, lifted = (dropped(hand=Hand(lift=at), device=camera)[0] for at in (np.inf, 4.0))
    whole, caught = (measure_drops(each).drops[0].measures for each in (free, lifted))
    assert "stopped or moved" in str(caught["relaxation_index"].reason)
    kept, cut = caught["expected_relaxation_index"], cut_at(free, 0.7 + 4.0)
    assert abs(kept.value - whole["expected_relaxation_index"].value) < 2 * kept.standard_error
    # The same swings of a record that stops there tell nearly the same.
    assert kept.value == pytest.approx(cut.value, abs=0.01)
    assert kept.standard_error == pytest.approx(cut.standard_error, rel=0.1)


def test_a_leg_that_hung_still_before_a_hand_lifted_it_has_its_rest():
    knee, lifts = Knee(damping=0.8), (10.0, 4.0)  # s; it swings by 1.3 deg, and by 15
    each = [dropped(knee, Hand(lift=at), Device(gyro=None), lasting=14.0)[0] for at in lifts]
    rest = brentq(lambda phi: knee.pull(phi, 0.0), -1.57, -0.5)
    (read,), (caught,) = (measure_drops(one).drops for one in each)
    found = read.measures["plateau_angle"]
    assert abs(found.value - rest) < 3 * found.standard_error < np.radians(0.5)
    assert read.measures["relaxation_index"].value is not None
    assert "while it still swung" in caught.measures["plateau_angle"].reason


def cut_at(recording, end):
    """The expected index of the same drop, recorded until then [s]."""
    (segment,) = recording.segments
    seen = segment.time < end
    short = recorded(segment.raw_angle[seen], segment.time[seen])
    return measure_drops(short).drops[0].measures["expected_relaxation_index"]


def test_a_record_that_shows_the_rest_has_the_index_itself():
    (found,) = measure_drops(drop()).drops
    kept, index = (found.measures[f"{name}relaxation_index"] for name in ("expected_", ""))
    assert (kept.value, kept.standard_error) == (index.value, index.standard_error)


@pytest.mark.parametrize("rest", [-1.4, -0.9])
def test_where_friction_holds_a_leg_the_error_holds_the_angle(rest):
    """Swings that shrink by equal steps; the leg stays at the first turn within the band."""
    band, seen = 0.03, []
    for start in np.linspace(0.5, 0.62, 25):
        sizes = [start]
        while sizes[-1] > band:
            sizes.append(sizes[-1] - 2 * band)
        angles = [rest + (-1) ** at * each for at, each in enumerate(sizes)]
        for cut in (3, 4, 5):
            found = expected_rest(turned(*angles[1 : cut + 1]))
            seen.append((found.value - angles[-1]) / found.error)
    # As often as a uniform distribution is within one and two of its standard deviations.
    assert np.mean(np.abs(seen) < 1) == pytest.approx(0.58, abs=0.15)
    assert max(np.abs(seen)) < 2.0


def test_swings_that_do_not_shrink_tell_no_rest():
    with pytest.raises(NotAllowed, match="do not shrink"):
        expected_rest(turned(-1.8, -1.0, -1.9))
    with pytest.raises(NotAllowed, match="of 3 turns there are 2"):
        expected_rest(turned(-1.8, -1.0))


def test_a_leg_that_a_hand_held_softly_before_its_rest_has_an_error_that_holds_the_rest():
    leg, left = Oscillator(), np.radians(1.0)
    whole = drop(leg, noise=1e-4)
    (segment,) = whole.segments
    alone, held = segment.raw_angle, segment.raw_angle.copy()
    stopped = int(np.flatnonzero(np.abs(alone - leg.rest) > left)[-1])
    noise = 1e-4 * np.random.default_rng(1).normal(size=held.size - stopped)
    held[stopped:] = alone[stopped] + noise
    (softly,) = measure_drops(recorded(held, segment.time, noise=1e-4)).drops
    (freely,) = measure_drops(whole).drops
    each = [one.measures["plateau_angle"] for one in (softly, freely)]
    assert abs(each[0].value - leg.rest) == pytest.approx(left, rel=0.2)
    assert all(abs(one.value - leg.rest) < 2 * one.standard_error for one in each)
    assert each[1].standard_error < 0.1 * each[0].standard_error


@pytest.mark.parametrize("tone", [-4.0, 3.0])
def test_where_a_muscle_shifts_the_middle_of_the_swings_the_error_holds_the_passive_rest(tone):
    """Swings about -1.4 rad, of which a muscle [1/s^2] sets in after one and a half."""
    pull, damping, step, hold = 30.0, 0.8, 0.002, 1.0
    time = np.arange(0.0, 2.6, step)
    angle, speed = np.empty((2, time.size))
    angle[0], speed[0] = -0.4, 0.0
    for at, now in enumerate(time[:-1]):
        rate = -pull * (angle[at] + 1.4) - damping * speed[at] + tone * (now > 0.9)
        speed[at + 1] = speed[at] + step * rate
        angle[at + 1] = angle[at] + step * speed[at + 1]
    every = 5
    whole = np.concatenate([np.full(int(hold / step / every), angle[0]), angle[::every]])
    noisy = whole + 5e-4 * np.random.default_rng(0).standard_normal(whole.size)
    (found,) = measure_drops(recorded(noisy, step * every * np.arange(whole.size))).drops
    kept = found.measures["expected_relaxation_index"]
    passive = 1 + np.exp(-damping / 2 * np.pi / np.sqrt(pull - damping**2 / 4))
    assert abs(kept.value - passive) > 0.05
    assert abs(kept.value - passive) < 3 * kept.standard_error
