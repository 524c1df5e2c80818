"""Answers about the recordings of others get the marks that they deserve."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from benchmarks.others import release
from benchmarks.others.__main__ import span
from benchmarks.others.ask import Answer, answer_of, ask_all
from benchmarks.others.score import FitMark, mark_diagnosis, mark_fit
from benchmarks.others.summary import HEAD, Marked, aligned, line, page, rows
from benchmarks.others.write import make

NAMES = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
TRUTH = {
    "id": "s0-0000",
    "person": "adult",
    "device": {"kind": "camera", "rate": 60.0},
    "angle_noise_rad": 0.005,
    "velocity_noise_rad_s": None,
    "trouble": "none",
    "effect": "none",
    "systematic": False,
    "table": False,
    "visible": None,
    "errors": {"bias": 0.0},
    "leg": {"mass": 4.8, "inertia": 0.45, "damping": 0.35},
    "ratios": dict(zip(NAMES, (26.0, 6.0, 0.8), strict=True)),
    "bound": dict(zip(NAMES, (0.01, 0.02, 0.001), strict=True)),
}


def fit(values=(26.0, 6.0, 0.8), errors=(0.01, 0.02, 0.001), code=0):
    pairs = zip(NAMES, values, errors, strict=True)
    ratios = {name: {"value": v, "standard_error": e} for name, v, e in pairs}
    leg = {"mass": {"value": 4.5, "standard_error": 0.3}, "torque_amplitude": {"value": None}}
    leg |= {"inertia": {"value": 0.5, "standard_error": 0.02}, "damping": {"value": None}}
    return Answer(code, "", 1.0, {"ratios": ratios, "parameters": leg})


def diagnosis(verdict, *selected, novel=False, alike=()):
    found = {"verdict": verdict, "selected": list(selected), "novel": novel}
    found["equivalent"] = [*selected, *alike]
    return Answer(0, "", 1.0, found)


def lacking(effect, visible=50.0, **more):
    return TRUTH | {"effect": effect, "visible": visible} | more


def test_a_ratio_is_right_within_its_share_or_three_smallest_errors():
    assert mark_fit(TRUTH, fit((26.5, 6.8, 0.9))).right
    assert not mark_fit(TRUTH, fit((26.6, 6.0, 0.8))).right
    assert not mark_fit(TRUTH, fit((26.0, 7.0, 0.8))).right
    vague = TRUTH | {"bound": TRUTH["bound"] | {"gravity_over_inertia": 0.5}}
    assert mark_fit(vague, fit((27.4, 6.0, 0.8))).right


def test_intervals_and_errors_are_counted_for_each_ratio():
    mark = mark_fit(TRUTH, fit((26.02, 6.06, 0.8), (0.02, 0.02, 0.001)))
    assert mark.covered == (True, False, True)
    assert mark.error_over_bound == pytest.approx((2.0, 1.0, 1.0))
    assert mark.away == pytest.approx((1.0, 3.0, 0.0))


def test_a_value_without_an_error_is_not_covered():
    mark = mark_fit(TRUTH, fit(errors=(0.01, None, 0.001)))
    assert mark.covered == (True, False, True)
    assert mark.away == (0.0, 0.0)
    assert mark.right


def test_intervals_of_the_leg_are_counted_where_they_are_told():
    assert mark_fit(TRUTH, fit()).leg_covered == (True, False)


def test_what_is_not_determined_is_not_right_and_not_covered():
    mark = mark_fit(TRUTH, fit((26.0, None, 0.8), (0.01, None, 0.001)))
    assert not mark.right
    assert mark.undetermined == ("stiffness_over_inertia",)
    assert len(mark.covered) == 2


def test_a_fit_may_be_refused_or_say_itself_that_it_failed():
    assert mark_fit(TRUTH, Answer(2, "exoid: no.", 1.0, None)) == FitMark("exoid: no.")
    assert mark_fit(TRUTH, fit(code=1)).warned


@pytest.mark.parametrize(
    ("truth", "answer", "word"),
    [
        (TRUTH, diagnosis("none"), "quiet"),
        (TRUTH, diagnosis("cannot_tell"), "quiet"),
        (TRUTH, diagnosis("mismatch", "cuff_compliance"), "alarm"),
        (TRUTH, diagnosis("mismatch", novel=True), "alarm"),
        (TRUTH, diagnosis("mismatch", "angle_offset"), "alarm"),
        (TRUTH | {"systematic": True}, diagnosis("mismatch", "angle_offset"), "sensor"),
        (TRUTH | {"trouble": "drift"}, diagnosis("mismatch", "gyro_bias"), "sensor"),
        (lacking("coulomb_friction"), diagnosis("mismatch", "coulomb_friction"), "named"),
        (lacking("stiffness_rest_angle"), diagnosis("mismatch", "torque_bias"), "named"),
        (lacking("hard_stop"), diagnosis("mismatch", "hard_stop", "backlash"), "wrong"),
        (lacking("quadratic_drag"), diagnosis("cannot_tell"), "unsure"),
        (lacking("quadratic_drag"), diagnosis("none"), "missed"),
        (lacking("quadratic_drag", 2.0), diagnosis("none"), "unseen"),
        (lacking("quadratic_drag", 2.0), diagnosis("mismatch", "backlash"), "wrong"),
        (lacking("quadratic_drag"), diagnosis("mismatch", novel=True), "wrong"),
        (lacking("hard_stop"), diagnosis("mismatch", "backlash", alike=["hard_stop"]), "unsure"),
        (lacking("backlash", systematic=True), diagnosis("mismatch", "gyro_scale"), "missed"),
        (lacking("hard_stop+quadratic_drag"), diagnosis("mismatch", "hard_stop"), "part"),
        (
            lacking("hard_stop+quadratic_drag"),
            diagnosis("mismatch", "quadratic_drag", "hard_stop"),
            "named",
        ),
        (
            lacking("hard_stop+quadratic_drag"),
            diagnosis("mismatch", "hard_stop", "backlash"),
            "wrong",
        ),
        (TRUTH, Answer(2, "exoid: no.", 1.0, None), "refused"),
    ],
)
def test_a_diagnosis_gets_the_word_it_deserves(truth, answer, word):
    assert mark_diagnosis(truth, answer).word == word


def test_the_table_counts_every_case_in_its_groups():
    good = Marked(TRUTH, mark_fit(TRUTH, fit()), mark_diagnosis(TRUTH, diagnosis("none")))
    other = lacking("quadratic_drag")
    missed = Marked(other, None, mark_diagnosis(other, diagnosis("none")))
    refused = Marked(TRUTH, FitMark("no"), None)
    body = {each[0]: dict(zip(HEAD, each, strict=True)) for each in rows([good, missed, refused])}
    assert body["all"]["cases"] == "3"
    assert body["all"]["right"] == "1"
    assert body["all"]["refused"] == "1"
    assert body["all"]["cover 99 %"] == "100.0"
    assert body["effect quadratic_drag"]["missed"] == "1"
    assert body["person adult"]["nulls"] == "1"
    table = list(rows([good, missed, refused]))
    assert len({len(row) for row in table}) == 1
    assert len(aligned(HEAD, table).splitlines()) == 1 + len(table)
    told = page([good, missed, refused]).splitlines()
    assert sum(each.startswith("|") for each in told) == 2 + len(table)
    assert [each for each in told if each.startswith("-")] == [
        f"- {line(missed)}",
        f"- {line(refused)}",
    ]
    assert page([good]).rstrip().endswith("none")
    assert "NOT RIGHT" not in line(good)
    assert "missed" in line(missed)


def test_cases_are_counted_or_named_by_their_ends():
    assert span("500") == (0, 500)
    assert span("20:60") == (20, 60)


def perfect(table: Path):
    """A detector that read the truth."""
    truth = json.loads(table.with_suffix(".truth.json").read_text())
    pieces = [[] for _ in range(1 + max(each["segment"] for each in truth["drops"]))]
    for each in truth["drops"]:
        pieces[each["segment"]].append((each["harmless_s"], each["end_s"]))
    return pieces


def test_a_detector_that_knows_the_truth_is_never_early(tmp_path):
    tables = [make(3, number, tmp_path) for number in range(2)]
    said = release.report(tables, perfect)
    assert " 0 missed, 0 pieces that are none" in said
    assert "harmless 0.0%" in said
    assert "ends after a hand is back 0.0%" in said
    late = release.report(
        tables, lambda table: [[(b - 0.5, e) for b, e in s] for s in perfect(table)]
    )
    assert "harmless 100.0%" in late


def test_a_detector_is_named_by_module_and_function():
    assert release.detector("json:loads") is json.loads


@pytest.mark.proof
def test_answers_are_those_of_the_command_line(tmp_path):
    tables = [make(3, 0, tmp_path), tmp_path / "absent.csv"]
    # in a worker of its own: the tests' checks of types do not know the command line's
    assert set(ask_all({each: ["drops"] for each in tables}, tmp_path, 1)) == set(tables)
    for table in tables:
        here = answer_of(tmp_path, table.stem, "drops")
        file = tmp_path / f"{table.stem}.there.json"
        command = [sys.executable, "-c", "from exoid.cli import main; main()", "drops", str(table)]
        there = subprocess.run([*command, "--json", str(file)], capture_output=True, check=False)
        assert here.code == there.returncode
        assert here.document == (json.loads(file.read_text()) if file.exists() else None)
        assert bool(here.said) == (here.code != 0)
    assert here.code == 2
    assert "absent.csv" in here.said


@pytest.mark.parametrize(("rate", "mark"), [(50.0, "sensor"), (60.0, "sensor"), (100.0, "alarm")])
def test_a_hum_sampled_at_its_own_rate_is_a_zero_that_wanders(rate, mark):
    truth = TRUTH | {"trouble": "hum", "device": {"kind": "imu_angle", "rate": rate}}
    assert mark_diagnosis(truth, diagnosis("mismatch", "zero_drift")).word == mark
