"""The rate of a recording, from times as files have them."""

import json

import numpy as np
import pytest

from exoid.recordings.measured.segment import Segment
from exoid.recordings.rate import rate_of
from exoid.studies.dataset.motion_bids.labels import beside
from exoid.studies.dataset.motion_bids.write_motion import write_motion
from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.dataset.recording_of import recording_of
from study_checks import checked
from study_folders import study, table_of

ROUNDED = 1e-4  # s, the last decimal of a time
CLOSE = 60 * ROUNDED / 3.0  # Hz; both ends of 3 s rounded by half of that


def test_sixty_hertz_in_times_of_four_decimals_are_sixty(tmp_path):
    (study(tmp_path, ["P01_left.csv"]) / "P01_left.csv").write_text(table_of(1, rate=60.0))
    assert checked(tmp_path).devices == {"raw angle, 60 Hz": 1}
    dataset = open_dataset(tmp_path)
    recording = recording_of(dataset.entries[0], dataset)
    path = tmp_path / "sub-01_task-knee_motion.tsv"
    write_motion(recording, path, "knee")
    told = json.loads(beside(path, "_motion.json").read_text())
    for key in ("SamplingFrequency", "SamplingFrequencyEffective"):
        assert told[key] == pytest.approx(60.0, abs=CLOSE)


def test_what_is_missing_does_not_slow_the_rate():
    time = np.delete(np.arange(300) / 100, slice(50, 150))
    assert rate_of([Segment(time, raw_angle=np.zeros(200))]) == pytest.approx(100.0, rel=1e-9)
