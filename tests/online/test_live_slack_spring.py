"""How far the ratios are open for a spring that is slack elsewhere than at full extension."""

from math import hypot, radians

import pytest

from exoid import online
from exoid.cli.live.replay import of_recording
from exoid.online.model.unknowns import Unknowns
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.recordings.recording import Recording
from exoid.watching.estimate.expect import expected_of
from exoid.watching.estimate.leg import Leg, Person
from exoid.watching.estimate.load import Load
from exoid.watching.estimate.moment import Moment, Quantity
from legs import ADULT, BODY, drop

STARTS = (-0.2, -0.5)  # rad
NOISE = (2e-3, 3e-3)  # rad, rad/s
LIKELY = 3.0  # errors together, beyond which one draw in 400 lies


def ratios(slack: float, *, gyro: bool, terms: tuple = ()) -> tuple[Quantity, ...]:
    """By two drops of a leg whose spring is slack at an angle [deg]."""
    how = {"slack": radians(slack), "gyro": gyro, "noise": NOISE, "step": 0.02}
    drops = (drop(start=start, seed=at, **how) for at, start in enumerate(STARTS))
    recording = Recording(tuple(drops), BODY)
    model = online.Model(Unknowns(terms), online.node_of(recording))
    leg = Leg(Person(BODY, expected_of(BODY), model), Load())
    news = [each for part in of_recording(recording, 3000) for each in leg.take(part)]
    return [each for each in news if isinstance(each, Moment)][-1].ratios


@pytest.mark.parametrize(("slack", "gyro"), [(-10, False), (-20, False), (-40, True), (10, False)])
def test_what_is_open_for_a_slack_spring_holds_a_leg_that_has_one(slack, gyro):
    for found, true in zip(ratios(slack, gyro=gyro)[:2], ADULT, strict=False):
        assert found.if_slack is not None
        assert abs(found.value - true) < LIKELY * hypot(found.error, found.if_slack)


def test_the_errors_of_a_slack_leg_alone_do_not_hold_it():
    """Without a gyro nothing contradicts the numbers: what is open must be told."""
    gravity = ratios(-20, gyro=False)[0]
    assert abs(gravity.value - ADULT[0]) > LIKELY * gravity.error


def test_what_the_model_holds_by_a_constant_torque_of_its_own_is_not_open_again():
    assert {each.if_slack for each in ratios(-10, gyro=False, terms=(TorqueBias,))} == {None}
