"""Recordings that others made, of legs that obey Eq. 9: people and devices unlike ours."""

import json

import pytest

from exoid.fit.estimate import fit
from exoid.recording.load import load

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
    """`bound` is the least standard error that such data allow, with a zero known to 1 degree."""
    truth = truths[name]
    result = fit(load(shared / "others" / f"{name}.csv").recording, multistart=8)
    assert result.follows
    for ratio, value in truth["ratios"].items():
        found, bound = result.ratios[ratio], truth["bound"][ratio]
        away = abs(found.value - value)
        assert away < max(NEAR[ratio] * value, 3 * bound), ratio
        assert away < SURE * found.standard_error, ratio
        if truth["trouble"] == "none":
            assert found.standard_error < 1.5 * bound, ratio
