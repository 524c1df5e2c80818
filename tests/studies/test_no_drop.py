"""A recording of which no drop could be read is not measured: by name and reason, everywhere."""

import numpy as np
import pandas as pd
import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.run_study import run_study
from exoid.studies.page.parts.opening import opening
from exoid.studies.page.parts.tables import failures
from exoid.studies.page.sections.summary import whole
from exoid.studies.statistics.ask import ask
from exoid.studies.statistics.asked import Asked
from exoid.studies.statistics.tables.study import open_study
from study_folders import study
from study_runs import DROPS

LOCKED = "P03_left.csv"
NAMES = ["P01_left.csv", "P02_left.csv", LOCKED]


def locked(folder, kind):
    """Two legs that swing, and a knee that stays where it is."""
    study(folder, NAMES)
    time = np.arange(0, 8, 0.01)
    angle = -41 + 0.05 * np.random.default_rng(1).standard_normal(time.size)
    told = pd.DataFrame({"time_s": time, "angle_deg": angle})
    told.to_csv(folder / LOCKED, index=False)
    if kind:
        (folder / LOCKED).with_suffix(".toml").write_text(f'[protocol]\nkind = "{kind}"\n')
    return open_dataset(folder)


@pytest.mark.parametrize("kind", ["passive", ""])
def test_a_knee_of_which_nothing_was_read_failed_and_stands_on_the_page(here, tmp_path, kind):
    made = run_study(locked(tmp_path / "study", kind), tmp_path / "results", DROPS)
    assert (made.ok, made.failed, made.partly) == (2, 1, 0)
    ((said, count),) = made.reasons.items()
    assert count == 1
    assert said.startswith(f"{LOCKED}: drops: ")
    assert "nevertheless" not in said
    answers = ask(open_study(tmp_path / "results"), Asked())
    assert opening(answers)[-1].startswith(f"1 of 3 recordings failed, {LOCKED}: drops: ")
    ((_, which, reason),) = failures(answers.study.recordings).rows
    assert which == LOCKED
    assert reason.startswith("drops: ")
    assert "Of 1 recording nothing was measured" in str(whole(answers).blocks[-1])


def test_what_is_declared_voluntary_has_no_drop_that_failed(here, tmp_path):
    made = run_study(locked(tmp_path / "study", "active"), tmp_path / "results", DROPS)
    assert (made.ok, made.failed) == (3, 0)
