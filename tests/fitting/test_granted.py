"""What ± takes for granted, beside what a sidecar declares."""

from exoid.fitting.data.segment import movement
from exoid.fitting.result.systematics.granted import of_a_camera
from legs import drop, recording


def test_of_a_camera_it_says_what_one_that_looks_askew_makes_of_the_ratios():
    seen, turned = (movement(recording(drop(gyro=gyro)), 0, "drop") for gyro in (False, True))
    assert "10 deg off square" in of_a_camera([seen, seen])
    assert of_a_camera([seen, turned]) == ""
