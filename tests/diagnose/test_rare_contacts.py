"""What acts for few samples, or along a motion with noise: SciPy moved these legs."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from exoid.diagnose.missing_physics import diagnose
from hands import Device, Hand, Knee, dropped

pytestmark = pytest.mark.proof

ENCODER = Device(rate=200.0, noise=1e-3, gyro=5e-3)
STARTS = (-0.05, -0.3, -0.5)  # rad
CONTACT, RATIO = 0.03, 0.5  # s that the stop's spring holds the leg, and its damping ratio


@dataclass(frozen=True)
class Stopped(Knee):
    """A spring and damper push the leg back from an angle on; they never pull."""

    angle: float = -1.0  # rad

    def pull(self, angle, rate):
        stiff = np.pi / CONTACT
        push = stiff**2 * (self.angle - angle) - 2 * RATIO * stiff * rate
        return super().pull(angle, rate) + np.where(angle < self.angle, np.maximum(push, 0.0), 0.0)


@dataclass(frozen=True)
class Rubbing(Knee):
    """Dry friction that passes through zero within 5 mrad/s."""

    friction: float = 0.8  # 1/s^2

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.friction * np.tanh(rate / 5e-3)


def session(knee: Knee, seed: int = 0):
    """Three drops of it."""
    each = [
        dropped(knee, Hand(start, hold=0.6), ENCODER, lasting=6.0, seed=seed + number)[0]
        for number, start in enumerate(STARTS)
    ]
    return replace(each[0], segments=tuple(one.segments[0] for one in each))


@pytest.mark.parametrize("angle", [-85.0, -100.0])
def test_a_stop_is_no_reflex(angle):
    """The leg hangs at -76 deg; swinging beyond, it touches the stop for some 30 ms."""
    found = diagnose(session(Stopped(angle=np.radians(angle))), multistart=8)
    assert (found.verdict, found.selected) == ("mismatch", ["hard_stop"])
    stop = {each.name: each for each in found.parameters}["hard_stop.flexion_angle"]
    blurred = np.radians(2)  # by steps of 0.6 ms
    assert abs(stop.value - np.radians(angle)) < 3 * stop.standard_error + blurred


def test_friction_is_as_finely_simulated_as_its_pairs():
    """A pair would win by its finer steps alone, with a second cause of no size."""
    found = diagnose(session(Rubbing()), multistart=8)
    assert found.verdict == "mismatch"
    assert found.selected in (["coulomb_friction"], ["stribeck_friction"])
    assert not any("+" in each for each in found.equivalent)
