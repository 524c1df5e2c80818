"""How sure an answer was, and whether it is true, are counted as they are."""

import json

import pytest
from benchmarks.reliability.curve import asserted_rows, interval, parts
from benchmarks.reliability.kept import keep, kept
from benchmarks.reliability.outcomes import of_blind, of_others, outcome

FRICTION = [{"coulomb_friction", "stribeck_friction"}]
BOTH = [*FRICTION, {"quadratic_drag"}]


def answer(*selected, verdict="mismatch", equivalent=(), weight=0.99, novel=False):
    return {
        "verdict": verdict,
        "selected": list(selected),
        "equivalent": list(equivalent),
        "weight": weight,
        "novel": novel,
    }


@pytest.mark.parametrize(
    ("effects", "given", "right", "whole"),
    [
        (FRICTION, answer("stribeck_friction"), True, True),
        (FRICTION, answer("stribeck_friction", "gyro_bias"), True, True),
        (FRICTION, answer("hysteresis"), False, False),
        (BOTH, answer("coulomb_friction"), True, False),
        (BOTH, answer("coulomb_friction", "hard_stop"), False, False),
        ([], answer("quadratic_drag"), False, False),
        ([], answer(verdict="none", weight=None), None, False),
        (FRICTION, answer(verdict="cannot_tell", equivalent=["hysteresis"]), False, False),
        (BOTH, answer(verdict="cannot_tell", equivalent=["quadratic_drag + coulomb_friction"]),
         True, True),
        (FRICTION, answer(novel=True, weight=None), False, False),
    ],
)  # fmt: skip
def test_an_answer_is_right_where_all_that_it_names_acts(effects, given, right, whole):
    found = outcome("case", "own", "single", effects, frozenset({"gyro_bias"}), given)
    assert (found.right, found.whole) == (right, whole)


def test_of_two_that_no_drop_tells_apart_either_is_right(tmp_path):
    truth = {"id": "a", "category": "single", "effects": ["torque_bias"],
             "also_acceptable": ["stiffness_rest_angle"], "near_equivalent": []}  # fmt: skip
    (tmp_path / "own-truth.json").write_text(json.dumps([truth]))
    for named, right in (("stiffness_rest_angle", True), ("hysteresis", False)):
        (tmp_path / "own-answers.json").write_text(json.dumps({"a": answer(named)}))
        assert [each.right for each in of_blind(tmp_path)] == [right]


def test_answers_of_both_benchmarks_are_read(tmp_path):
    truth = {"id": "a", "category": "single", "effects": ["coulomb_friction"],
             "also_acceptable": [], "near_equivalent": ["stribeck_friction"]}  # fmt: skip
    (tmp_path / "own-truth.json").write_text(json.dumps([truth]))
    (tmp_path / "own-answers.json").write_text(json.dumps({"a": answer("stribeck_friction")}))
    (own,) = of_blind(tmp_path)
    assert (own.kind, own.right, own.weight) == ("single", True, 0.99)
    truth = {"effect": "none", "velocity_noise_rad_s": None, "systematic": False, "trouble": None}
    (tmp_path / "b.truth.json").write_text(json.dumps(truth))
    (tmp_path / "answers").mkdir()
    told = tmp_path / "answers" / "b.diagnose.json"
    told.write_text(json.dumps(answer("hysteresis")))
    (other,) = of_others(tmp_path)
    assert (other.world, other.kind, other.right) == ("others", "null", False)
    assert asserted_rows([own, other])[-1][2:6] == ("2", "2", "1", "1")


def test_bins_hold_what_lies_in_them_and_intervals_what_may_be_true():
    found = [
        outcome("case", "own", "single", FRICTION, frozenset(), answer(name, weight=weight))
        for name, weight in [("coulomb_friction", 1.0), ("hysteresis", 0.96), ("hysteresis", 0.2)]
    ]
    assert [each[2:] for each in parts(found, (0.0, 0.5, 1.0))] == [
        (1, 0.2, 0),
        (2, pytest.approx(0.98), 1),
    ]
    assert interval(0, 59) == (0.0, pytest.approx(1 - 0.025 ** (1 / 59)))


def test_who_was_asked_stays_as_it_was_first_answered(tmp_path):
    def outcome_of(name, answered, weight):
        said = answer(*answered, weight=weight)
        return outcome(name, "own", "single", FRICTION, frozenset(), said)

    first = outcome_of("a", ["hysteresis"], 0.96)
    quiet = outcome("b", "own", "null", [], frozenset(), answer(verdict="none", weight=None))
    assert keep(tmp_path / "asked.csv", [first, quiet]) == [first, quiet]
    mended, new = outcome_of("a", ["coulomb_friction"], 1.0), outcome_of("c", [], None)
    assert keep(tmp_path / "asked.csv", [mended, new]) == [first, quiet, new]
    assert kept(tmp_path / "asked.csv") == [first, quiet, new]
