"""Recordings of independent simulators on which a diagnosis once said something wrong."""

import pytest

from exoid.mismatch.missing_physics import diagnose
from exoid.recordings.loading.load import load

pytestmark = pytest.mark.proof

RIGHT = (
    "own_sim_raw",
    "kal_phase_1",
    "kal_phase_3",
    "und_R1_0",
    "R2_0",
    "poor_drop",
)
WRONG = {  # what is known to be wrong with it, and its exact twins
    "offset2deg_0": {"angle_offset"},
    "timebase0.5": {"gyro_scale", "clock_rate"},
    "s10b_ecc2x": {"encoder_second_harmonic"},
    "p1_coulomb_rest": {"coulomb_friction", "stiffness_rest_angle", "torque_bias"},
    "all_0": {"gyro_scale", "clock_rate", "sensor_skew", "angle_offset", "gyro_bias"},
}


def diagnosed(shared, name):
    path = shared / "audit" / f"{name}.csv"
    if not path.is_file():
        pytest.skip(f"{path} is absent")
    return diagnose(load(path).recording, multistart=8)


@pytest.mark.parametrize("name", RIGHT)
def test_nothing_is_said_of_what_lacks_nothing(name, shared):
    assert diagnosed(shared, name).verdict != "mismatch"


@pytest.mark.parametrize("name", WRONG)
def test_what_is_wrong_is_named_with_all_that_is_alike(name, shared):
    found = diagnosed(shared, name)
    assert found.verdict == "mismatch"
    alike = {term for each in found.equivalent for term in each.split(" + ")}
    named = {finding.name for finding in found.findings}
    assert named <= WRONG[name]
    assert named | alike >= WRONG[name]
