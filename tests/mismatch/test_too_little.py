"""A recording that could show nothing is answered without a search."""

from io import StringIO

import numpy as np
from faulty_sensors import Faults, drops
from rich.console import Console
from scipy.integrate import solve_ivp

import exoid
from exoid.mismatch.missing_physics import diagnose
from exoid.report.tables.mismatch.diagnosis import print_diagnosis


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


def benched(start: float) -> exoid.Segment:
    """A leg that is let go from `start` [rad] after 0.4 s and comes to rest on a bench."""
    bench = -1.15

    def pull(_, state):
        angle, rate = state
        free = -27.0 * np.cos(angle) - 2.0 * angle - 0.5 * rate
        return [
            rate,
            free + (max(4000.0 * (bench - angle) - 60.0 * rate, 0.0) if angle < bench else 0.0),
        ]

    time = np.linspace(0.0, 5.0, 501)
    leg = solve_ivp(
        pull, (0.0, 5.0), [start, 0.0], t_eval=np.maximum(time - 0.4, 0.0)[40:], max_step=1e-3
    )
    random = np.random.default_rng(0)
    seen = np.concatenate([np.full(40, start), leg.y[0]]) + 5e-4 * random.normal(size=time.size)
    return exoid.Segment(time, raw_angle=seen)


def test_drops_that_end_on_a_bench_are_said_to():
    """The fit says it first of all."""
    drops_on_it = exoid.Recording(tuple(map(benched, (-0.2, -0.35, -0.5))))
    found = diagnose(drops_on_it, multistart=2)
    assert found.verdict == "cannot_tell"
    assert found.reasons[0].startswith("every drop is stopped within 0.3")
    assert found.before.notes[0].startswith("every drop is stopped")
    for cause in ("hand", "bench", "friction"):  # nobody told which
        assert cause in found.reasons[0]
