"""The times that should not grow unnoticed: `pytest benchmarks -n 0`, with `exoid[bench]`."""

import subprocess
import sys
from pathlib import Path
from tempfile import mkdtemp

import jax
import numpy as np
import pytest

from exoid.fitting.errors.profile import profiles
from exoid.fitting.estimate import fit
from exoid.fitting.multistart.weight_by_kind import explained
from exoid.fitting.solve.ask import around
from exoid.recordings.can.dbc import exoid_messages
from exoid.recordings.filter.kalman import filter
from exoid.recordings.loading.load import load
from exoid.trust.identify import identify
from problem import TIME_STEP, cycle, starts, ten_segments, write

FRAMES = 1_000_000
SAMPLES = 60_000  # ten minutes


def written(problem):
    """The recording of a problem, as a file."""
    path = Path(mkdtemp()) / "recording.csv"
    write(problem(), path)
    return path


@pytest.mark.parametrize("problem", [cycle, ten_segments])
def test_warm_fit_from_64_starts(benchmark, problem):
    recording = load(written(problem)).recording
    begin = starts(64, 0)
    result = benchmark.pedantic(
        fit, (recording,), {"starts": begin}, rounds=5, iterations=1, warmup_rounds=1
    )
    assert result.multistart.at_best > 57  # nine starts in ten


@pytest.fixture(scope="module")
def ten_fitted():
    return fit(load(written(ten_segments)).recording, multistart=8)


def test_asking_what_ten_segments_tell(benchmark, ten_fitted):
    """Errors that allow for what the model misses, and what they say of identifiability."""
    problem, ended = ten_fitted.basis.problem, ten_fitted.basis.ended

    def ask():
        around(problem, ended.best, explained(problem, ended.best))
        return identify(ten_fitted)

    told = benchmark.pedantic(ask, rounds=7, warmup_rounds=1)
    assert benchmark.stats["median"] < 0.3  # s
    assert told.null_directions


def test_profiling_ten_segments(benchmark, ten_fitted):
    found = benchmark.pedantic(profiles, (ten_fitted,), rounds=5, warmup_rounds=1)
    assert benchmark.stats["median"] < 5.0  # s
    assert found["gravity_over_inertia"].shape == "two-sided"


def test_decoding_can_frames(benchmark):
    data = np.random.default_rng(0).integers(0, 256, (FRAMES, 8), dtype=np.uint8)
    plan = exoid_messages()["EXO_RAW"]
    values = benchmark(plan.decode, data)
    benchmark.extra_info["million_frames_per_second"] = FRAMES / benchmark.stats["median"] / 1e6
    assert all(np.isfinite(each).all() for each in values.values())


def test_filtering_ten_minutes(benchmark):
    rng = np.random.default_rng(0)
    time = TIME_STEP * np.arange(SAMPLES)
    angle = np.cos(time) + 1e-3 * rng.standard_normal(SAMPLES)
    velocity = -np.sin(time) + 3e-3 * rng.standard_normal(SAMPLES)
    given = np.full(SAMPLES - 1, TIME_STEP), angle, velocity
    found = benchmark.pedantic(
        lambda: jax.block_until_ready(filter(*given)), rounds=10, warmup_rounds=1
    )
    assert np.abs(found.state[100:, 0] - np.cos(time[100:])).max() < 5e-3


def test_importing_exoid(benchmark):
    command = [sys.executable, "-c", "import exoid"]
    finished = benchmark.pedantic(subprocess.run, (command,), {"check": True}, rounds=7)
    assert finished.returncode == 0
