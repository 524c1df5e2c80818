"""Every step of a study is kept by itself: what is asked or killed later costs it nothing."""

import json
import os
import signal
import sys
import time
from collections import Counter

import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine import measure as module
from exoid.studies.engine import run_study as running
from exoid.studies.engine.kept.parts import DONE, FOLDER
from exoid.studies.engine.kept.quantities import Row
from exoid.studies.engine.run_study import run_study
from exoid.studies.engine.settings import Settings
from exoid.studies.engine.work import work
from killed_runs import started, until
from study_folders import study
from study_runs import contents, kept, rows

NAMES = ["P01_left.csv", "P01_right.csv", "P02_left.csv"]
ALL = Settings(("drops", "fit", "diagnose"))
REFUSED = "P01_right.csv"
INSIDE = 3.0  # s after the fits are told, of the minute that a first diagnosis takes


@pytest.fixture
def folder(tmp_path):
    """Three recordings, and one that is empty."""
    made = study(tmp_path / "study", NAMES)
    (made / "P03_left.csv").write_text("")
    return made


@pytest.fixture
def computed(here, monkeypatch):
    """How many recordings went through each step; a fit of one fails, and both steps are quick."""
    count: Counter[str] = Counter()
    usual, of_step = module.measure, module.of_step

    def counting(batch, dataset, step, settings):
        found = usual(batch, dataset, step, settings)
        count[step] += len(found)
        return found

    def fitted(each, options):
        for one in each:
            one.rows.append(Row(-1, "fit", "noise_scale", 1.0))
            one.fault = "no." if one.item.entry.name == REFUSED else None

    def quick(step, recording, settings):
        told = [Row(-1, "diagnose", "missing_physics", note="none")]
        return told if step == "diagnose" else of_step(step, recording, settings)

    monkeypatch.setattr(module, "measure", counting)
    monkeypatch.setattr(module, "fitted", fitted)
    monkeypatch.setattr(module, "of_step", quick)
    return count


def test_one_more_step_computes_no_other_again(computed, folder, tmp_path):
    whole, bit_by_bit = tmp_path / "whole", tmp_path / "bit_by_bit"
    run_study(open_dataset(folder), whole, ALL)
    once = dict.fromkeys(ALL.steps, 4)
    assert computed == once
    computed.clear()
    for steps in (("drops",), ("drops", "fit"), ("diagnose", "drops", "fit"), ("fit",)):
        run_study(open_dataset(folder), bit_by_bit, Settings(steps))
    assert computed == once
    assert run_study(open_dataset(folder), bit_by_bit, ALL).computed == 0
    assert contents(bit_by_bit) == contents(whole)


def test_other_options_of_a_step_compute_that_step_alone(computed, folder, tmp_path):
    run_study(open_dataset(folder), tmp_path / "results", ALL)
    computed.clear()
    run_study(open_dataset(folder), tmp_path / "results", Settings(ALL.steps, diagnose={"seed": 1}))
    assert computed == {"diagnose": 4}


def test_what_an_older_version_kept_is_not_read_and_computed_again(computed, folder, tmp_path):
    older = tmp_path / "results" / FOLDER / f"{DONE}-0.parquet"
    older.parent.mkdir(parents=True)
    older.write_text("")
    assert run_study(open_dataset(folder), tmp_path / "results", ALL).computed == 4


def test_a_run_that_ends_inside_a_diagnosis_has_told_drops_and_fits_and_goes_on(
    computed, folder, tmp_path, monkeypatch
):
    whole, results = tmp_path / "whole", tmp_path / "results"
    run_study(open_dataset(folder), whole, ALL)
    computed.clear()
    quick = module.of_step

    def ending(step, recording, settings):
        if step == "diagnose" and computed["diagnose"] == 1:
            raise KeyboardInterrupt
        return quick(step, recording, settings)

    monkeypatch.setattr(module, "of_step", ending)
    with pytest.raises(KeyboardInterrupt):
        run_study(open_dataset(folder), results, ALL)
    assert steps_told(results) == {"drops", "fit"}
    assert len(rows(results, "recordings.parquet")) == 4
    monkeypatch.setattr(module, "of_step", quick)
    made = run_study(open_dataset(folder), results, ALL)
    assert made.computed == 3  # one diagnosis was kept
    assert computed == dict.fromkeys(ALL.steps, 4)
    assert contents(results) == contents(whole)


def test_what_fails_in_one_step_is_told_with_it_and_has_the_results_of_the_others(
    computed, folder, tmp_path, monkeypatch
):
    def fatal(batch, dataset, step, *rest):
        if step == "diagnose" and batch.items[0].entry.name in (REFUSED, NAMES[2]):
            raise RuntimeError("the worker was killed")
        return work(batch, dataset, step, *rest)

    monkeypatch.setattr(running, "work", fatal)
    made = run_study(open_dataset(folder), tmp_path / "results", ALL)
    assert (made.ok, made.failed, made.partly) == (1, 3, 2)
    told = {row["name"]: row for row in rows(tmp_path / "results", "recordings.parquet")}
    assert told[NAMES[0]]["status"] == "ok"
    assert told[REFUSED]["reason"].startswith("fit: no. diagnose: it took the process")
    assert told[NAMES[2]]["reason"].startswith("diagnose: it took the process")
    unread = told["P03_left.csv"]["reason"]
    assert unread.startswith("the file is empty.")  # of no step
    assert unread.count("the file is empty") == 1
    quantities = rows(tmp_path / "results", "quantities.parquet")
    steps = {row["step"] for row in quantities if row["name"] == NAMES[2]}
    assert steps == {"drops", "fit"}


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_kill_inside_a_diagnosis_costs_no_drop_and_no_fit(folder, programs, tmp_path):
    results, told = tmp_path / "results", tmp_path / "told.json"
    running = started(folder, results, programs, "--workers", "1", steps="drops,fit,diagnose")
    until(lambda: steps_told(results) == {"drops", "fit"})
    time.sleep(INSIDE)
    os.killpg(running.pid, signal.SIGKILL)
    running.communicate()
    assert (len(kept(results, "fit")), len(kept(results, "diagnose"))) == (4, 0)
    again = started(folder, results, programs, "--json", str(told), steps="drops,fit")
    again.communicate(timeout=600)
    assert json.loads(told.read_text())["computed"] == 0


def steps_told(results) -> set[str]:
    """Of the table, where there is one."""
    there = (results / "quantities.parquet").is_file()
    return {row["step"] for row in rows(results, "quantities.parquet")} if there else set()
