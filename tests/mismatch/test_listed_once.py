"""A set of causes is one candidate, whichever way a search came to it."""

import re
from types import SimpleNamespace

import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.cli.inputs.terms import rivals_in
from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.mismatch import prepare
from exoid.mismatch.answer.diagnosis import Suspect
from exoid.mismatch.conclude.asserted import equivalents
from exoid.mismatch.conclude.rivals import advice
from exoid.mismatch.conclude.verdict.undecided import undecided
from exoid.mismatch.evidence.yardstick import Yardstick
from exoid.mismatch.novel.nameless import NAMELESS, DampingByDirection
from exoid.mismatch.search import search
from exoid.mismatch.search.found import best_of
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.device.hard_stop import HardStop
from exoid.physics.terms.device.shaped_hysteresis import ShapedHysteresis
from exoid.physics.terms.device.torque_bias import TorqueBias
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.physics.terms.tissue.stiffness_rest_angle import StiffnessRestAngle
from exoid.planning.plan_between import of_helpless


def test_the_order_of_causes_makes_no_other_set():
    first, better = (
        explaining(left, *terms)
        for left, terms in (
            (1200.0, (HardStop, EndRangeStiffening)),
            (1100.0, (EndRangeStiffening, HardStop)),
        )
    )
    assert best_of([first, better]) == best_of([better, first]) == [better]


@pytest.fixture
def with_sets(monkeypatch):
    """A search for sets, where one cause leaves so much and a pair is far from noise."""
    for step in ("nested", "plainer_sets", "simulated", "reduced", "twins"):
        monkeypatch.setattr(search, step, lambda *_: [])
    monkeypatch.setattr(search, "yardstick", lambda *_: Yardstick(SAMPLES, scale=1.0))
    monkeypatch.setattr(search, "hopped", lambda prepared, one: one)

    def searched(left, *sets):
        monkeypatch.setattr(search, "several", lambda *_: [*sets])
        alone = explaining(left, EndRangeStiffening)
        found = found_of([alone], [explaining(1400.0, EndRangeStiffening, CubicStiffness)])
        found.prepared.common, found.prepared.samples = (), SAMPLES
        return search.with_sets(found, [], lambda _: None)

    return searched


def test_what_remains_of_a_set_is_no_second_candidate(with_sets):
    """A set lost all causes but one, which had run free by itself, too."""
    searched = with_sets(1100.0, explaining(1100.1, EndRangeStiffening))
    assert [one.candidate.terms for one in searched.singles] == [(EndRangeStiffening,)]
    assert all(len(one.candidate.terms) == 2 for one in searched.pairs)
    assert equivalents(searched, searched.singles[0]) == searched.singles


def test_where_one_cause_leaves_only_noise_no_set_of_three_is_sought(with_sets):
    three = explaining(1000.0, EndRangeStiffening, CubicStiffness, HardStop)
    assert with_sets(1000.0, three).pairs[0].candidate.terms == three.candidate.terms[:2]
    assert with_sets(1100.0, three).pairs[0].candidate.terms == three.candidate.terms


def test_nothing_is_told_apart_from_itself():
    suspected = [Suspect(["hard_stop"], [])] * 2
    assert rivals_in(SimpleNamespace(suspected=suspected)) == ["hard_stop"]


def test_no_plan_is_asked_to_tell_what_pushes_alike_from_each_other():
    """The torque of a spring that is slack elsewhere is a constant one."""
    names = ("stiffness_rest_angle", "torque_bias", "cubic_stiffness")
    suspected = [Suspect([name], []) for name in names]
    assert rivals_in(SimpleNamespace(suspected=suspected[:2])) == ["stiffness_rest_angle"]
    assert rivals_in(SimpleNamespace(suspected=suspected)) == [names[0], names[2]]


def test_sets_compete_with_single_causes_each_once_however_they_push_alike():
    each = (["cubic_stiffness"], ["torque_bias", "hysteresis"], ["saturating_damping", "backlash"])
    again = ["hysteresis", "stiffness_rest_angle"]
    suspected = [Suspect(names, []) for names in (*each, again)]
    asked = rivals_in(SimpleNamespace(suspected=suspected))
    assert asked == ["cubic_stiffness", "torque_bias+hysteresis"]


def test_nothing_is_to_be_recorded_to_tell_what_pushes_alike_from_each_other():
    each = [explaining(1000.0, term) for term in (StiffnessRestAngle, TorqueBias, CubicStiffness)]
    (said,) = advice(each[:2], "mismatch", None, segments=1)
    assert "no recording of the motion tells them apart" in said
    twins, other = advice(each, "cannot_tell", None, segments=1)
    assert (twins, other) == (
        said,
        f"To tell {CubicStiffness.title} apart: {CubicStiffness.isolate}.",
    )
    (alone,) = advice([each[1]], "cannot_tell", None, segments=1)
    assert TorqueBias.isolate in alone


def test_an_axis_whose_torque_is_known_is_asked_for_no_drop():
    """What frees or relaxes a leg does nothing to a motor's axis."""
    each = [explaining(1000.0, term) for term in (CoulombFriction, QuadraticDrag, ShapedHysteresis)]
    said = advice(each, "cannot_tell", None, segments=3, moved="motor")
    assert said[0].endswith(f"{CoulombFriction.isolate_driven}.")
    assert said[2].endswith(f"{ShapedHysteresis.isolate}.")  # slow reversals are the same of both
    for term in (*prepare.tested(rig=True), *NAMELESS):
        if not (term.living or term.voluntary):
            asked = term.isolate_driven or term.isolate
            assert not re.search("drop|thigh|EMG|relax|shin|muscle", asked), term
    assert advice(each[:1], "cannot_tell", None, segments=3)[0].endswith(
        f"{CoulombFriction.isolate}."
    )


def test_a_rig_is_asked_for_nothing_that_a_person_does():
    """It was told to have EMG taken and to relax, and electrodes on its muscles."""
    each = [explaining(1000.0, term) for term in (StiffnessRestAngle, DampingByDirection, Backlash)]
    said = advice(each, "cannot_tell", None, segments=3, moved="rig")
    assert said[1].endswith(f"{DampingByDirection.isolate_rig}.")
    for term in (*prepare.tested(rig=True), *NAMELESS):
        if not (term.living or term.voluntary):
            asked = of_rig(term.isolated_by("rig"))
            assert not re.search("thigh|EMG|relax|shin|muscle|announced|leg", asked), term
    assert advice([each[1]], "cannot_tell", None, segments=3)[0].endswith(
        f"{DampingByDirection.isolate}."
    )


def test_what_pushes_alike_has_something_in_common():
    """They stood side by side among explanations that have nothing in common."""
    each = [explaining(1000.0, term) for term in (TorqueBias, StiffnessRestAngle, CubicStiffness)]
    (said,) = undecided(found_of(each), each)
    assert said.endswith("torque bias or stiffness rest angle (100%), cubic stiffness (100%)")


def test_a_plan_between_what_pushes_alike_says_that_nothing_tells_it():
    (said,) = of_helpless([StiffnessRestAngle, TorqueBias])
    assert "nothing of the leg but the name" in said
    several = of_helpless([StiffnessRestAngle, TorqueBias, CubicStiffness])
    assert several[0] == said
    assert several[-1] == f"cubic_stiffness shows in {CubicStiffness.isolate}."
