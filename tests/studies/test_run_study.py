"""A study from its folder to its two tables."""

import os
import re
from errno import ENOSPC

import numpy as np
import pyarrow.parquet as pq
import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine import run_study as module
from exoid.studies.engine.kept.parts import folder_of
from exoid.studies.engine.plan import Batch
from exoid.studies.engine.run_study import run_study
from exoid.studies.engine.work import work
from study_runs import COMPUTED, DROPS, NAMES, contents, copied, parts, rows


def test_every_recording_is_one_row_and_every_quantity_another(expected):
    recordings = rows(expected, "recordings.parquet")
    assert [row["name"] for row in recordings] == sorted([*NAMES, "P90_left.csv", "P91_left.csv"])
    first = recordings[0]
    assert (first["participant"], first["side"], first["status"]) == ("P00", "left", "ok")
    assert (first["segments"], first["samples"], first["body_mass_kg"]) == (1, 300, 70.0)
    assert first["rate_hz"] == pytest.approx(100.0)
    assert (first["participant_group"], recordings[3]["participant_group"]) == ("a", "b")
    quantities = rows(expected, "quantities.parquet")
    periods = [row for row in quantities if row["quantity"] == "period"]
    own = [row for row in periods if row["name"] == "P00_left.csv"]
    assert [row["segment"] for row in own] == [0, -1]  # the drop, and the mean over drops
    assert (own[0]["unit"], own[0]["determined_by"]) == ("s", "recording")
    # Of cos(5 t); between its samples a turning point is found to some millionths of a second.
    assert own[0]["value"] == pytest.approx(2 * np.pi / 5, abs=1e-4)
    refused = next(row for row in quantities if row["quantity"] == "start_angle")
    assert refused["value"] is None
    assert refused["note"].startswith("begins in motion")


def test_what_fails_is_a_row_with_one_sentence_and_what_is_there_twice_says_so(expected):
    by_name = {row["name"]: row for row in rows(expected, "recordings.parquet")}
    failed = by_name["P90_left.csv"]
    assert failed["status"] == "failed"
    assert failed["segments"] is None
    assert re.fullmatch(r"[^/\n]+\.", failed["reason"])  # no path, no traceback
    again = by_name["P91_left.csv"]
    assert (again["status"], again["duplicate_of"]) == ("duplicate", NAMES[3])
    assert again["recording"] == by_name[NAMES[3]]["recording"]
    assert not [r for r in rows(expected, "quantities.parquet") if r["name"] == "P91_left.csv"]


def test_a_second_run_computes_nothing_and_a_changed_sidecar_only_its_own(here, folder, tmp_path):
    there = copied(folder, tmp_path / "study")
    results = tmp_path / "results"
    assert run_study(open_dataset(there), results, DROPS).computed == COMPUTED
    before = contents(results)
    assert run_study(open_dataset(there), results, DROPS).computed == 0
    assert contents(results) == before
    (there / "P00_left.toml").write_text("[subject]\nbody_mass_kg = 82.0\n")
    assert run_study(open_dataset(there), results, DROPS).computed == 1
    changed = rows(results, "recordings.parquet")
    assert changed[0]["body_mass_kg"] == 82.0  # the sidecar before the table of participants
    (there / "P01_left.csv").rename(there / "P01_left_.csv")
    assert run_study(open_dataset(there), results, DROPS).computed == 0  # known by its content
    assert "P01_left_.csv" in {row["name"] for row in rows(results, "quantities.parquet")}


def test_the_tables_are_the_same_whatever_the_batches_and_their_order(
    here, folder, expected, tmp_path, monkeypatch
):
    for count, backwards in ((1, False), (7, True)):
        monkeypatch.setattr(
            module, "plan", lambda items, _, c=count, b=backwards: in_batches(items, c, b)
        )
        results = tmp_path / str(count)
        run_study(open_dataset(folder), results, DROPS)
        assert contents(results) == contents(expected)


def in_batches(items, count: int, backwards: bool):
    each = [Batch(tuple(items[at : at + count])) for at in range(0, len(items), count)]
    return each[::-1] if backwards else each


def test_a_disk_that_fills_up_ends_the_run_which_then_goes_on(
    here, folder, expected, tmp_path, monkeypatch
):
    written = [0]
    usual = pq.write_table

    def filling(table, where, **options):
        written[0] += 1
        if written[0] > 3:
            raise OSError(ENOSPC, os.strerror(ENOSPC))
        usual(table, where, **options)

    monkeypatch.setattr(pq, "write_table", filling)
    with pytest.raises(OSError, match="No space left") as told:
        run_study(open_dataset(folder), tmp_path, DROPS)
    where = folder_of(tmp_path, "drops", DROPS.digest("drops"))
    assert told.value.filename == str(where)
    assert len(parts(tmp_path)) == 1  # the second batch has quantities, and is not taken for done
    assert not list(where.glob(".*"))
    monkeypatch.setattr(pq, "write_table", usual)
    run_study(open_dataset(folder), tmp_path, DROPS)
    assert contents(tmp_path) == contents(expected)


def test_a_recording_that_takes_its_worker_down_is_a_row_and_is_tried_again(
    here, folder, tmp_path, monkeypatch
):
    def fatal(batch, *rest):
        if any(item.entry.name == "P05_left.csv" for item in batch.items):
            raise RuntimeError("the worker was killed")
        return work(batch, *rest)

    monkeypatch.setattr(module, "work", fatal)
    assert run_study(open_dataset(folder), tmp_path, DROPS).failed == 2
    row = next(r for r in rows(tmp_path, "recordings.parquet") if r["name"] == "P05_left.csv")
    assert row["reason"].startswith("it took the process that computed it down")
    monkeypatch.setattr(module, "work", work)
    made = run_study(open_dataset(folder), tmp_path, DROPS)
    assert (made.computed, made.failed) == (1, 1)


def test_a_batch_whose_worker_was_killed_after_it_was_kept_is_not_computed_again(
    here, folder, tmp_path, monkeypatch
):
    run_study(open_dataset(folder), tmp_path, DROPS)
    before = {part: part.stat().st_mtime_ns for part in parts(tmp_path)}
    monkeypatch.setattr("exoid.studies.engine.kept.parts.kept", lambda folder: {})
    run_study(open_dataset(folder), tmp_path, DROPS)
    assert {part: part.stat().st_mtime_ns for part in parts(tmp_path)} == before
