"""Recordings that others made, of legs that obey Eq. 9: people and devices unlike ours."""

import json
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.signal import butter, filtfilt

import exoid
from exoid.fitting.estimate import fit
from exoid.fitting.model.systematics import TILT
from exoid.recordings.loading.load import load

# One of each: spastic, child, obese; camera, angle of an inertial sensor, encoder with a gyro; hum,
# lost samples. All were held by a hand before they were let go.
NAMES = ("o152eb", "o56a76", "o6a9cd", "o78bb6", "o7eea6", "odafb3")
NEAR = {"gravity_over_inertia": 0.02, "stiffness_over_inertia": 0.15, "damping_over_inertia": 0.15}
SURE = 2.576  # standard errors, 99 %


@pytest.fixture(scope="module")
def truths(shared):
    path = shared / "others" / "truth.json"
    if not path.is_file():
        pytest.skip(f"{path} is absent")
    return {each["id"]: each for each in json.loads(path.read_text(encoding="utf-8"))}


@pytest.mark.proof
@pytest.mark.parametrize("name", NAMES)
def test_their_ratios_are_right_and_so_are_the_errors(name, truths, shared):
    """`bound` is the least standard error that such data allow, with a zero known to 1 degree, of a
    leg without a foot.
    """
    truth, seen = truths[name], load(shared / "others" / f"{name}.csv").recording
    level = replace(seen.protocol, thigh_angle_uncertainty=float(TILT))
    result = fit(replace(seen, protocol=level), multistart=8)
    assert result.follows
    for ratio, value in truth["ratios"].items():
        found, bound = result.ratios[ratio], truth["bound"][ratio]
        away = abs(found.value - value)
        assert away < max(NEAR[ratio] * value, 3 * bound), ratio
        assert away < SURE * found.standard_error, ratio
        if truth["trouble"] == "none":
            assert found.standard_error < 1.5 * bound, ratio


@pytest.mark.parametrize("cutoff", [pytest.param(6, marks=pytest.mark.proof), 10])
@pytest.mark.parametrize("damping", [pytest.param(0.8, marks=pytest.mark.proof), 6.0])
def test_an_angle_that_was_smoothed_gives_right_ratios(cutoff, damping):
    """As motion capture is exported: white noise of 0.3 deg, Butterworth forwards and backwards."""
    truth = {"gravity": 27.0, "stiffness": 8.0, "damping": damping}
    time, hold = np.arange(0, 10, 0.01), 1.0
    motion = solve_ivp(
        lambda t, y: [y[1], -27.0 * np.cos(y[0]) - 8.0 * y[0] - damping * y[1]],
        (0, 10),
        [-0.2, 0.0],
        rtol=1e-10,
        atol=1e-12,
        dense_output=True,
    ).sol
    angle = np.where(time < hold, -0.2, motion(np.maximum(time - hold, 0))[0])
    noise = np.random.default_rng(1).normal(scale=np.radians(0.3), size=time.size)
    smooth = filtfilt(*butter(2, cutoff / 50), angle + noise)
    result = exoid.fit(exoid.recording(time_s=time, raw_angle_rad=smooth), multistart=8)
    assert result.follows
    for name, value in truth.items():
        found = result.ratios[f"{name}_over_inertia"]
        assert abs(found.value - value) < 3 * found.standard_error
    assert any(
        "was smoothed or interpolated, before it came here or from CAN frames of its own" in each
        for each in result.notes
    )
