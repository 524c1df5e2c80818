"""Drag of another power than the square is told by its power; legs by SciPy."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from exoid.mismatch.missing_physics import diagnose
from hands import Device, Hand, Knee, dropped

ENCODER = Device(rate=100.0, noise=1e-3, gyro=None)
STARTS = (-0.15, -0.4, -0.7)  # rad
WITHIN = 3.0  # standard errors


@dataclass(frozen=True)
class Dragged(Knee):
    """Braked by a power of its rate."""

    drag: float = 0.2  # 1/s^2 at 1 rad/s
    power: float = 1.5

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.drag * rate * np.abs(rate) ** (self.power - 1)


@pytest.mark.proof
@pytest.mark.parametrize(
    ("power", "name"), [(1.5, "power_drag"), (2.0, "quadratic_drag"), (2.5, "power_drag")]
)
def test_the_power_of_drag_is_found_and_the_damping_beside_it(power, name):
    """As a square, a power of 1.5 left damping 36 standard errors off."""
    knee = Dragged(power=power)
    parts = [
        dropped(knee, Hand(start, fade=0.0), ENCODER, seed=seed, lasting=5.0)[0]
        for seed, start in enumerate(STARTS)
    ]
    session = replace(parts[0], segments=tuple(one.segments[0] for one in parts))
    found = diagnose(session, multistart=8)
    assert found.selected == [name]
    damping = found.fit.ratios["damping_over_inertia"]
    told = {each.name: each for each in found.parameters}
    pairs = [(damping, knee.damping), (told.get("power_drag.power"), power)]
    for each, true in pairs:
        if each is not None:
            assert abs(each.value - true) < WITHIN * each.standard_error
