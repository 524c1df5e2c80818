"""Diagnoses of legs that obey Eq. 9 or rub, as faulty sensors show them; made by SciPy."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from faulty_sensors import Faults, cycles, drops

from exoid.mismatch.missing_physics import diagnose
from hands import ADULT, Knee

pytestmark = pytest.mark.proof

SECOND = (0.0105, 0.007)  # rad
FIVE = Faults(zero=0.026, scale=-0.012, bias=0.03, delay=7e-3, clock=5e-3)
ALIKE = {"gyro_scale", "clock_rate", "encoder_gain"}  # of whom motion shows one ratio
CASES = {
    "a delay of drops from rest": (lambda: drops(Faults(delay=0.01), before=0.0), {"sensor_skew"}),
    "a delay of cycles": (lambda: cycles(Faults(delay=7e-4)), {"sensor_skew"}),
    "a clock": (lambda: drops(Faults(clock=5e-3)), {"gyro_scale"}),
    "a wrong rate": (lambda: drops(Faults(clock=0.03)), {"gyro_scale"}),
    "twice per turn": (lambda: drops(Faults(second=SECOND)), {"encoder_second_harmonic"}),
    "a strap that creeps": (lambda: drops(Faults(zero_drift=7e-3)), {"zero_drift"}),
    "a gyro behind a filter": (lambda: drops(Faults(smoothed=0.03)), {"first_order_filter"}),
    "an encoder behind a filter": (lambda: drops(Faults(held_back=0.04)), {"sensor_skew"}),
    "five at once": (
        lambda: drops(FIVE),
        {"gyro_scale", "sensor_skew", "angle_offset", "gyro_bias"},
    ),
}


@dataclass(frozen=True)
class Rubbing(Knee):
    """Dry friction that passes through zero within 5 mrad/s."""

    friction: float = 0.5  # 1/s^2

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.friction * np.tanh(rate / 5e-3)


@dataclass(frozen=True)
class Dragged(Knee):
    """A torque that grows with the square of the rate."""

    drag: float = 0.03

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.drag * rate * abs(rate)


def right(found, knee=ADULT):
    """The leg within three of its stated errors."""
    for name in ("gravity", "stiffness", "damping"):
        one = found.fit.ratios[f"{name}_over_inertia"]
        assert abs(one.value - getattr(knee, name)) < 3 * one.standard_error, name


@pytest.mark.parametrize("name", CASES)
def test_sensors_are_blamed_for_what_they_did_and_no_torque_is(name):
    make, expected = CASES[name]
    found = diagnose(make(), multistart=8)
    assert found.verdict == "mismatch"
    assert set(found.selected) == expected
    assert not found.novel
    right(found)
    if "gyro_scale" in expected:
        assert any("clock_rate" in each for each in found.equivalent)
        assert any("gyro_scale" in each for each in found.equivalent)


@pytest.mark.parametrize(
    ("faults", "named"),
    [
        (Faults(scale=-0.02, bias=0.02, delay=4e-3), {"gyro_scale", "sensor_skew", "gyro_bias"}),
        (FIVE, {"gyro_scale", "sensor_skew", "angle_offset", "gyro_bias"}),
    ],
)
def test_friction_is_found_behind_faulty_sensors(faults, named):
    found = diagnose(drops(faults, Rubbing()), multistart=8)
    assert found.verdict == "mismatch"
    asserted = set(found.selected) - {"stribeck_friction", "coulomb_friction"}
    # A stiffness that grows bends a drop about as an encoder's zero does.
    assert named - {"angle_offset"} <= asserted <= named
    assert any(named - {"gyro_bias"} <= set(each.split(" + ")) for each in found.equivalent)
    assert len(set(found.selected) - named) == 1
    right(found, Rubbing())


@pytest.mark.parametrize(
    "faults", [Faults(gain=0.02), Faults(first=(0.017, 0.012)), Faults(second=SECOND)]
)
def test_without_a_gyro_an_encoder_is_named_beside_what_looks_the_same(faults):
    found = diagnose(drops(faults, gyro=False), multistart=8)
    said = {term for each in found.equivalent for term in each.split(" + ")}
    assert found.verdict == "cannot_tell" or any(each.startswith("encoder") for each in said)


@pytest.mark.parametrize("gain", [-0.0145, 0.02])
def test_a_gain_of_the_encoder_makes_no_torque_beside_the_drag_of_a_leg(gain):
    found = diagnose(drops(Faults(gain=gain), Dragged()), multistart=8)
    assert found.verdict == "mismatch"
    # The gyro's scale is another gain, and none of both is sure.
    assert {"quadratic_drag"} <= set(found.selected) <= {"quadratic_drag", "encoder_gain"}
    assert "encoder_gain + quadratic_drag" in {
        " + ".join(sorted(each.split(" + "))) for each in found.equivalent
    }


def test_nothing_is_claimed_of_a_leg_whose_gyro_has_another_delay_in_each_drop():
    each = [drops(Faults(delay=by)) for by in (0.004, -0.009, 0.015)]
    segments = tuple(one.segments[number] for number, one in enumerate(each))
    found = diagnose(replace(each[0], segments=segments), multistart=4)
    assert found.verdict == "cannot_tell"
    assert "the gyro late by -9 to 15 ms" in " ".join(found.reasons)
    (skew,) = (one for one in found.sensors if one.name == "sensor_skew")
    assert [one.value for one in skew.own] == pytest.approx([0.004, -0.009, 0.015], abs=5e-4)
    assert any("one clock" in each for each in found.advice)
