"""A diagnosis in words."""

from exoid.diagnose.diagnosis import Parameter
from exoid.report.diagnosis_words import parameter


def test_a_parameter_without_an_error_is_no_measurement():
    stop = Parameter("hard_stop.extension_angle", 1.2, "rad", None)
    assert parameter(stop) == "extension angle not determined (at 1.2 rad)"
    assert parameter(Parameter("coulomb_friction.level", 0.1, "N m", 0.002)) == (
        "level 0.1000 ± 0.0020 N m"
    )
