"""A recording that could show nothing is answered without a search."""

from io import StringIO

from faulty_sensors import Faults, drops
from rich.console import Console

from exoid.mismatch.missing_physics import diagnose
from exoid.report.tables.diagnosis import print_diagnosis


def test_what_is_too_short_is_said_at_once_whatever_its_sensors_do():
    """The gyro's scale is sure of half a swing; no cause of the leg is asked for."""
    phases = []
    short = drops(Faults(scale=-0.05), starts=(-0.1,), before=0.2, lasting=0.8, rate=200.0)
    found = diagnose(short, multistart=2, told=phases.append)
    assert found.verdict == "cannot_tell"
    assert "too short" in found.reasons[0]
    assert found.singles == found.pairs == found.advice == []
    assert phases == ["fitting the baseline"]
    told = StringIO()
    print_diagnosis(found, Console(file=told, width=80))
    assert "Suspected" not in told.getvalue()
