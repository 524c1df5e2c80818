"""Answers to blind cases are scored by the rules."""

import pytest
from benchmarks.blind.answer import Answer, ask, given
from benchmarks.blind.score import first_answer, mark, score, verdict_of


def truth(category, *effects, accepted=(), near=(), name="case"):
    return {
        "id": name,
        "effect": "+".join(effects) or "none",
        "effects": list(effects),
        "category": category,
        "also_acceptable": list(accepted),
        "near_equivalent": list(near),
        "strength": "clear" if effects else None,
        "protocol": "passive",
        "detectable": bool(effects),
    }


def found(*ranking, novel=False):
    return Answer("mismatch", ranking, novel=novel)


FRICTION = truth("single", "coulomb_friction", near=["stribeck_friction"])
BIAS = truth("single", "torque_bias", accepted=["stiffness_rest_angle"])
PAIR = truth("combo", "torque_bias", "backlash", accepted=["stiffness_rest_angle"])
NOVELTY = truth("novel", "kick_novel")


@pytest.mark.parametrize(
    ("case", "answer", "right"),
    [
        (FRICTION, found("coulomb_friction"), (True, True, True)),
        (FRICTION, found("hysteresis", "backlash", "coulomb_friction"), (True, False, True)),
        (FRICTION, found("a", "b", "c", "coulomb_friction"), (True, False, False)),
        (FRICTION, found("coulomb_friction", novel=True), (True, False, False)),
        (FRICTION, Answer("none", ("coulomb_friction",)), (False, False, False)),
        (FRICTION, Answer("cannot_tell", ("coulomb_friction",)), (False, False, False)),
        (FRICTION, None, (False, False, False)),
        (BIAS, found("stiffness_rest_angle"), (True, True, True)),
        (PAIR, found("backlash", "a", "torque_bias"), (True, True, True)),
        (PAIR, found("backlash", "stiffness_rest_angle", novel=True), (True, True, True)),
        (PAIR, found("a", "backlash", "torque_bias"), (True, False, True)),
        (PAIR, found("backlash", "a", "b"), (True, True, False)),
        (NOVELTY, found(novel=True), (True, True, True)),
        (NOVELTY, found("quadratic_drag"), (True, False, False)),
    ],
)
def test_an_answer_is_worth_what_the_rules_say(case, answer, right):
    given = mark(case, answer)
    assert (given.detected, given.first, given.three) == right


def test_a_rival_that_is_nearly_right_counts_leniently_only():
    answer = found("stribeck_friction")
    assert not mark(FRICTION, answer).first
    assert mark(FRICTION, answer, lenient=True).first


def test_a_finding_where_nothing_is_concealed_is_a_false_alarm():
    sound = [truth("null", name=name) for name in ("a", "b", "c")]
    answers = {"a": found("hysteresis"), "b": Answer("cannot_tell"), "c": Answer("none")}
    counted = score(sound, answers)
    assert counted.false_alarms["null"] == (["a"], 3)
    assert counted.all.count == 0
    assert [verdict_of(case, answers[case["id"]]) for case in sound] == ["no", "no", "yes"]


def test_every_answer_is_counted_under_its_truth():
    cases = [FRICTION | {"id": name} for name in "abcd"]
    answers = {"a": found("hysteresis"), "b": found(novel=True), "c": Answer("cannot_tell")}
    counted = score(cases, answers)
    assert counted.confusion == {
        "coulomb_friction": {"hysteresis": 1, "novel": 1, "cannot tell": 1, "failed": 1}
    }
    assert counted.called_novel == ["b"]
    assert (counted.all.detected, counted.all.count) == (2, 4)


def test_a_case_that_fails_is_an_answer():
    def load():
        raise ValueError("no such\nrecording")

    answer = ask("case", load, None, 0)
    assert (answer.verdict, answer.fault) == ("failed", "ValueError: no such recording")
    assert first_answer(answer) == "failed"


def test_what_was_selected_is_ranked_even_where_the_ranking_lacks_it():
    document = {
        "verdict": "mismatch",
        "selected": ["gyro_bias"],
        "ranking": ["backlash"],
        "equivalent": [],
        "weight": None,
        "novel": False,
        "novel_formula": None,
        "heldout_rmse_before": 0.02,
        "heldout_rmse_after": 0.01,
        "noise_floor": 0.001,
    }
    assert given(document, 1.0).ranking == ("gyro_bias", "backlash")
