"""What the gyro shows of strikes without any model, and what cannot be claimed beside them."""

from dataclasses import replace
from types import SimpleNamespace
from unittest.mock import Mock

import numpy as np
import pytest
from found_by_hand import explaining, found_of, leaving

from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.conclude.false_alarm import Chance
from exoid.mismatch.conclude.verdict import judge as judging
from exoid.mismatch.conclude.verdict.struck import OFTEN, struck
from exoid.mismatch.evidence.location import Location
from exoid.mismatch.evidence.prediction import Proof
from exoid.mismatch.screen.prepared_recording import PreparedRecording
from exoid.mismatch.sensors.strikes import times_of_strikes
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag

STEP, PER_SAMPLE = 2e-4, 50  # s, and 100 Hz
NOISE = 3e-3  # rad/s
STOP, BACK = -1.5, 0.5  # rad, and the share of its rate with which a leg comes back


def fallen(friction=0.0, stop=-np.inf, seed=0):
    """Time, rate and weight of a leg that falls from 35 deg below level, of 28 and 4 1/s^2, 0.5 1/s
    and dry friction [rad/s^2], and how often it ran into a stop [rad].
    """
    angle, rate, rates, hits = -0.6, 0.0, [], 0
    for _ in range(400):
        rates.append(rate)
        for _ in range(PER_SAMPLE):
            rate -= STEP * (28 * np.cos(angle) + 4 * angle + 0.5 * rate)
            rate -= np.clip(rate, -STEP * friction, STEP * friction)
            angle += STEP * rate
            if angle < stop and rate < 0:
                rate, hits = -BACK * rate, hits + 1
    noise = np.random.default_rng(seed).normal(0, NOISE, len(rates))
    time = 0.01 * np.arange(len(rates))
    return time, np.array(rates) + noise, np.full(time.size, 1 / NOISE), hits


@pytest.mark.parametrize("friction", [0.0, 0.5, 2.0, 8.0])
def test_friction_that_turns_strikes_nothing(friction):
    """At a turn its torque jumps, and with it the slope of the rate; the rate does not."""
    for seed in range(3):
        assert times_of_strikes(*fallen(friction, seed=seed)[:3]).size == 0


def test_a_sensor_that_errs_strikes_nothing():
    """A gyro read twice as often as it measures, times that are off, single samples that are: on a
    leg that soon rests, where all of it looks unusual beside the rest.
    """
    time, rate, weight, _ = fallen(friction=3.0)
    random = np.random.default_rng(1)
    late = np.interp(time + random.normal(0, 1e-3, time.size), time, rate)
    off = rate + 20 * NOISE * (random.uniform(size=time.size) < 0.01)
    for shown in (np.repeat(rate[::2], 2), late, off):
        assert times_of_strikes(time, shown, weight).size < OFTEN


def test_every_run_into_a_stop_that_lies_apart_from_others_is_seen():
    time, rate, weight, hits = fallen(stop=STOP)
    assert 3 <= times_of_strikes(time, rate, weight).size <= hits
    assert not times_of_strikes(time[:20], rate[:20], weight[:20]).size  # a hand may still be there
    assert not times_of_strikes(time, rate, 0 * weight).size  # no gyro


def shown(*terms, left=50_000.0, stop=STOP):
    """A search that ended with these causes on a leg, and its best."""
    best = explaining(left, *terms) if terms else leaving(left)
    found = found_of([best])
    rows = [row[None] for row in fallen(stop=stop)[:3]]
    names = ("time", "angular_velocity", "velocity_weight")
    seen = SimpleNamespace(**dict(zip(names, rows, strict=True)))
    every = (HardStop, QuadraticDrag, Backlash)
    prepared = Mock(spec=PreparedRecording, seen=seen, library=every, moved="leg")
    return replace(found, prepared=prepared), best


def test_nothing_that_does_not_strike_is_claimed_where_something_does(monkeypatch):
    reasons, then = struck(*shown(QuadraticDrag))
    assert "something strikes" in reasons[0]
    assert [term.title in " ".join(then) for term in (HardStop, Backlash)] == [True, True]
    assert struck(*shown(HardStop)) == struck(*shown(QuadraticDrag, Backlash)) == ([], [])
    assert struck(*shown(QuadraticDrag, left=1_050.0)) == ([], [])  # noise alone
    assert struck(*shown(QuadraticDrag, stop=-np.inf)) == ([], [])
    found, best = shown(QuadraticDrag)
    monkeypatch.setattr(judging, "moved_by_tone", lambda result: [])
    monkeypatch.setattr(judging, "apart_in_time", lambda found, best: ([], []))
    fit, place, proof, luck = (Mock(spec=each) for each in (FitResult, Location, Proof, Chance))
    case = judging.Case(fit, found, best, None, (QuadraticDrag,), [best], False, place)
    answer = judging.judge(case, proof, None, luck)
    assert (answer.verdict, answer.reasons, answer.then) == ("cannot_tell", reasons, then)
