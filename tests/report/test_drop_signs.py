"""What the table of drops says of signs is true of the numbers above it."""

import io

from rich.console import Console

from exoid.pendulum.drops import measure_drops
from exoid.report.tables.drops import print_drops
from swings import drop

SIZES = ("first_flexion_amplitude", "plateau_amplitude", "peak_flexion_velocity")


def test_angles_have_a_sign_and_sizes_have_none():
    test = measure_drops(drop(noise=1e-3))
    said = io.StringIO()
    print_drops(test, Console(file=said, width=400))
    assert "peak velocities and accelerations are sizes" in said.getvalue()
    assert "Start angle and plateau hold what the sensor's zero is off" in said.getvalue()
    values = test.drops[0].measures
    for name in (*SIZES, "peak_flexion_acceleration", "peak_extension_velocity"):
        value = values[name].value
        assert value is not None
        assert value > 0
    assert (values["plateau_angle"].value or 0.0) < 0
