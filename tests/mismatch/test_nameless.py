"""Torques without a name keep what has one from standing in for them; legs by SciPy."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from exoid.mismatch.conclude.asserted import same_cause
from exoid.mismatch.missing_physics import diagnose
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.physics.library import library
from hands import Device, Hand, Knee, dropped

POTENTIOMETER = Device(rate=100.0, noise=2.5e-3, gyro=None)
STARTS = (-0.1, -0.5)  # rad
MIDDLE = -1.4  # rad


@dataclass(frozen=True)
class Outward(Knee):
    """Damped more at the ends of its swings."""

    outward: float = 0.4  # 1/s/rad^2

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.outward * (angle - MIDDLE) ** 2 * rate


@dataclass(frozen=True)
class Saturating(Knee):
    """Damped by the root of the rate, which holds no leg."""

    saturating: float = 0.3  # (1/s^3/rad)^(1/2)

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.saturating * np.sign(rate) * np.sqrt(np.abs(rate))


def test_none_of_them_is_a_cause_of_the_library_or_a_form_of_one():
    assert not set(NAMELESS) & set(library())
    for one in NAMELESS:
        assert not any(same_cause(one, other) for other in (*library(), *NAMELESS) if other != one)


@pytest.mark.proof
@pytest.mark.parametrize("knee", [Outward(damping=0.8), Saturating()], ids=["outward", "root"])
def test_no_name_is_claimed_for_damping_that_has_none(knee):
    """Drag and dry friction explained these down to the noise, each by itself."""
    parts = [
        dropped(knee, Hand(start, fade=0.0), POTENTIOMETER, seed=seed, lasting=5.0)[0]
        for seed, start in enumerate(STARTS)
    ]
    session = replace(parts[0], segments=tuple(one.segments[0] for one in parts))
    found = diagnose(session, multistart=8)
    assert found.verdict != "mismatch", found.selected
