"""What a sensor that drifts, or a leg that sinks, does to the measures of a drop."""

import numpy as np
import pytest

from exoid.pendulum.drift import moving, read_off
from exoid.pendulum.drops import measure_drops
from exoid.pendulum.slope import Slope
from exoid.recordings.landmarks.find_landmarks import find_landmarks
from exoid.recordings.landmarks.track import track_of
from swings import HOLD, Oscillator, recorded

LEG = Oscillator()
LASTING, STEP, NOISE = 13.0, 0.01, 0.0009  # s, s, rad
FIRST = LEG.amplitude * (1 + np.exp(-LEG.decrement / 2))  # rad, from the start to the first flexion
INDEX = FIRST / LEG.amplitude
TIME = np.arange(0, HOLD + LASTING, STEP)


def read(seed, leg=LEG, **moves):
    """One drop of an angle [rad] that also does what the functions of time say."""
    angle = leg.angle(TIME - HOLD) + sum(each(TIME) for each in moves.values())
    angle = angle + NOISE * np.random.default_rng(seed).normal(size=TIME.size)
    (found,) = measure_drops(recorded(angle, TIME)).drops
    return found


def drifting(rate_deg):
    return lambda time: np.radians(rate_deg) * time


def sinking(rate_deg, since=8.0):
    return lambda time: np.radians(rate_deg) * np.maximum(time - since, 0.0)


@pytest.mark.parametrize("rate", [-0.4, -0.1, 0.05, 0.1, 0.4])
def test_an_angle_that_drifts_is_read_less_its_drift(rate):
    found = read(1, drift=drifting(rate))
    index, plateau = (found.measures[name] for name in ("relaxation_index", "plateau_angle"))
    assert found.note is not None
    assert "as where the angle's sensor drifts" in found.note
    # three errors of the slope, of 0.01 deg/s, over the 13 s to the middle of the rest
    assert plateau.value == pytest.approx(LEG.rest, abs=np.radians(0.4))
    assert index.value == pytest.approx(INDEX, abs=0.01)


@pytest.mark.parametrize("rate", [-0.4, 0.1])
def test_errors_hold_that_the_leg_itself_may_move_so(rate):
    found = read(2, drift=drifting(rate)).measures["plateau_angle"]
    assert found.value is not None
    assert found.standard_error is not None
    recorded_as = LEG.rest + np.radians(rate) * 13.0  # in the middle of what it rests, about
    assert abs(recorded_as - found.value) < 2 * found.standard_error


def test_what_is_taken_off_an_angle_leaves_its_hold_as_still_as_it_was():
    """Less a line from the first sample on, a hold that is still would move, as if let go early."""
    angle = LEG.angle(TIME - HOLD) + drifting(-0.7)(np.maximum(TIME - HOLD, 0.0))
    angle = angle + NOISE * np.random.default_rng(1).normal(size=TIME.size)
    track, read = track_of(recorded(angle, TIME).segments[0], NOISE), []

    def find(each):
        read.append(each)
        return find_landmarks(each)

    assert read_off(track, find).drift == pytest.approx(np.radians(-0.7), abs=np.radians(0.05))
    taken = track.angle - read[1].angle
    assert np.ptp(taken[track.time < HOLD - 0.05]) < 1e-12
    assert taken[-1] - taken[0] == pytest.approx(np.radians(-0.7) * LASTING, rel=0.1)


def test_a_leg_that_sinks_as_it_hangs_is_read_as_it_is_with_errors_that_hold_a_drift():
    found = read(3, Oscillator(decay=0.9), sinks=sinking(-0.3))
    plateau = found.measures["plateau_angle"]
    assert found.note is not None
    assert "at which it hangs moves by -0.3" in found.note
    assert plateau.value is not None
    assert plateau.standard_error is not None
    assert plateau.value < LEG.rest - np.radians(0.5)  # 5 s of it, less what the average takes
    assert abs(plateau.value - LEG.rest) < 2 * plateau.standard_error


@pytest.mark.parametrize("leg", [LEG, Oscillator(decay=0.9), Oscillator(decay=0.3)])
@pytest.mark.parametrize("seed", range(3))
def test_nothing_is_said_of_an_angle_that_stays(leg, seed):
    found = read(seed, leg)
    assert found.note is None
    assert found.measures["plateau_angle"].standard_error < np.radians(0.1)


def test_an_encoder_that_hangs_between_two_counts_does_not_drift():
    count = 2 * np.pi / 4096
    angle = LEG.angle(TIME - HOLD)
    angle[TIME > 13.3] += count  # the last of its rest, once
    (found,) = measure_drops(recorded(count * np.round(angle / count), TIME)).drops
    assert found.note is None


def test_a_slope_of_the_swings_that_the_hanging_leg_does_not_share_is_no_drift():
    steep, flat, like = (
        Slope(*np.radians(each)) for each in ((0.1, 0.01), (0, 0.01), (0.09, 0.01))
    )
    assert moving(None, None) is None
    assert moving(flat, flat) is None
    evenly = moving(steep, like)
    assert evenly is not None
    assert evenly.evenly
    assert evenly.slope.value == pytest.approx(np.radians(0.095))
    apart = moving(steep, flat)
    assert apart is not None
    assert not apart.evenly
