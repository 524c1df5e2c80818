"""What a coarse encoder rounds off at rest is one error: legs by SciPy, not by exoid."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.fitting.data.observe import STANDS, standing

GRAVITY, STIFFNESS = 24.0, 5.0  # over J
RATE, LASTING, HELD = 100.0, 8.0, 1.0  # Hz, s, s before each release
STEP, NOISE = np.radians(0.5), np.radians(0.01)
LIKELY = 3.5  # standard errors: of three numbers of a sound fit one in 700 is as far off


def drops(damping, seed, *, gyro=True):
    random = np.random.default_rng(seed)
    time, each = np.arange(-HELD, LASTING, 1 / RATE), []
    for begin in np.radians([-15.3, -28.7, -41.2]):
        moved = solve_ivp(
            lambda _, s: (s[1], -GRAVITY * np.cos(s[0]) - STIFFNESS * s[0] - damping * s[1]),
            (0.0, LASTING),
            (begin, 0.0),
            dense_output=True,
            rtol=1e-9,
            atol=1e-11,
        ).sol(np.maximum(time, 0.0))
        noisy = moved + random.normal(0, [[NOISE], [3e-3]], moved.shape)
        each.append((STEP * np.round(noisy[0] / STEP), noisy[1]))
    angle, rate = map(np.concatenate, zip(*each, strict=True))
    return exoid.recording(
        time_s=np.tile(time + HELD, len(each)),
        segment=np.repeat(np.arange(len(each)), time.size),
        raw_angle_rad=angle,
        **({"raw_velocity_rad_s": rate} if gyro else {}),
        subject={"kind": "leg", "body_mass": 72.0, "height": 1.76},
        protocol={"kind": "passive"},
    )


@pytest.mark.parametrize(
    ("damping", "seed", "gyro"),
    [(1.0, 0, True), (5.0, 6, True), (8.0, 3, True), (8.0, 2, False), (8.0, 5, False)],
)
def test_ratios_of_legs_that_rest_long_hold(damping, seed, gyro):
    found = exoid.fit(drops(damping, seed, gyro=gyro), multistart=4)
    assert found.follows
    assert not any("counts only up to" in note for note in found.notes)  # no hand held it
    truth = [GRAVITY, STIFFNESS, damping]
    told = found.ratios.values()
    off = [(one.value - true) / one.standard_error for one, true in zip(told, truth, strict=True)]
    assert np.abs(off).max() < LIKELY


def test_of_a_long_stand_the_middle_counts():
    samples = np.concatenate([np.arange(5.0), np.full(STANDS, 7.0), [8.0, 8.0, 9.0]])
    left = standing(samples)
    assert left.sum() == STANDS - 1
    assert not left[5 + (STANDS - 1) // 2]
    assert not standing(samples[6:]).any()
