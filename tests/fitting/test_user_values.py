"""What a user fixes, bounds or expects: the words, and what a fit makes of them."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.apart.fit_each import fit_each
from exoid.fitting.errors.profile import profiles
from exoid.fitting.estimate import fit
from exoid.fitting.model.user_values import ByHand, from_sidecar
from exoid.physics.leg import GRAVITY
from exoid.recordings.declared.subject import Subject
from fit_cases import DROP, recorded

SPASTIC = {"mass": 4.5, "inertia": 0.44, "com_distance": 0.26, "damping": 3.0, "stiffness": 2.9}


def spastic():
    return recorded(DROP, **SPASTIC)


def test_a_symbol_is_the_name_of_its_parameter():
    assert ByHand({"c": 0.0}, {"d": (0.0, 20.0)}, {"J": (0.4, 0.1)}) == ByHand(
        {"stiffness": 0.0}, {"damping": (0.0, 20.0)}, {"inertia": (0.4, 0.1)}
    )


def test_what_was_said_first_holds_and_the_sidecar_adds_to_it():
    asked = ByHand(fix={"stiffness": 0.0})
    sidecar = from_sidecar(
        {"bound": {"stiffness": [0.0, 9.0], "d": [0, 20]}, "prior": {"m": [4.0, 0.2]}}
    )
    both = asked.over(sidecar)
    assert both.fix == {"stiffness": 0.0}
    assert both.bound == {"damping": (0.0, 20.0)}
    assert both.prior == {"mass": (4.0, 0.2)}


@pytest.mark.parametrize(
    ("said", "message"),
    [
        ({"fix": {"friction": 1.0}}, "no parameter of the leg has this name; it is mass"),
        ({"fix": {"mass": 0.0}}, "fix of mass: 0 kg cannot be; it is positive"),
        ({"fix": {"damping": -1.0}}, "fix of damping: -1 N m s/rad cannot be; it is 0 or more"),
        ({"fix": {"mass": float("nan")}}, "fix of mass: nan kg cannot be"),
        ({"bound": {"damping": (5.0, 2.0)}}, "5 to 2 leaves nothing"),
        ({"prior": {"damping": (3.0, 0.0)}}, "0 is no standard deviation"),
        ({"fix": {"d": 1.0}, "bound": {"d": (0.0, 2.0)}}, "takes no bound of its own"),
    ],
)
def test_what_no_leg_has_is_refused_in_one_sentence(said, message):
    with pytest.raises(ValueError, match=message) as refusal:
        ByHand(**said)
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize(
    ("document", "message"),
    [
        ({"fixed": {}}, "unknown fixed in"),
        ({"fix": {"damping": "none"}}, "it takes one number"),
        ({"bound": {"damping": 20}}, "it takes two numbers in brackets"),
        ({"prior": [3, 1]}, "prior in .fit. must be a table"),
    ],
)
def test_a_sidecar_that_says_it_otherwise_is_refused(document, message):
    with pytest.raises(ValueError, match=message):
        from_sidecar(document)


def test_a_fixed_parameter_is_exactly_there_and_has_no_error():
    result = fit(spastic(), multistart=4, fix={"inertia": 0.44})
    inertia = result.parameters["inertia"]
    assert inertia.value == 0.44
    assert inertia.standard_error == 0.0
    assert inertia.set_by == "fixed by you"
    damping = result.parameters["damping"]  # d / J is known to 0.1 %, and so is d now
    assert abs(damping.value - 3.0) < 3 * damping.standard_error < 0.06
    assert damping.determined_by == "data"


@pytest.mark.parametrize("starts", [8, 16])
def test_of_a_rig_the_ratio_tells_inertia_where_mass_and_distance_are_fixed(starts):
    """J = m l g / (m l g / J), whatever inertia a start begins at: no datum minds another."""
    bar = {"mass": 1.35, "inertia": 0.173, "com_distance": 0.31, "damping": 0.006, "stiffness": 0.0}
    drops = recorded(DROP, **bar)
    swung = replace(drops, subject=Subject(kind="rig", spring="none"))
    found = fit(swung, multistart=starts, fix={"mass": 1.35, "com_distance": 0.31})
    inertia, ratio = found.parameters["inertia"], found.ratios["gravity_over_inertia"]
    assert ratio.value * inertia.value == pytest.approx(1.35 * 0.31 * GRAVITY, rel=1e-5)
    assert inertia.value == pytest.approx(0.173, abs=4 * inertia.standard_error)
    assert not [each for each in found.notes if "could not all be met" in each]
    assert found.gravity_moment is not None
    assert found.gravity_moment.set_by == "fixed by you"


def test_without_the_spring_the_spring_ratio_is_zero():
    result = fit(recorded(DROP, stiffness=0.0), multistart=4, fix={"stiffness": 0.0})
    ratio = result.ratios["stiffness_over_inertia"]
    assert (ratio.value, ratio.standard_error, ratio.set_by) == (0.0, 0.0, "fixed by you")
    free = fit(recorded(DROP, stiffness=0.0), multistart=4)
    narrow, wide = (each.ratios["gravity_over_inertia"].standard_error for each in (result, free))
    assert narrow < wide  # what trades off against a spring is told better without one


def test_what_cannot_be_followed_may_be_due_to_what_was_fixed():
    result = fit(recorded(DROP), multistart=4, fix={"damping": 0.0})
    assert not result.follows
    assert any("and what you said of damping" in each for each in result.notes)


def test_a_bound_of_your_own_holds_and_says_so():
    result = fit(spastic(), multistart=4, bound={"damping": (0.0, 2.0)})
    damping = result.parameters["damping"]
    assert damping.value == 2.0
    assert damping.set_by == "your bound"
    assert damping.standard_error is None


def test_your_expectation_takes_the_place_of_the_tables():
    """d / J = 6.82 is known; with d = 3 +- 0.1 expected, J is 0.44 +- 0.015, whatever anatomy says
    of d: its own 12 % of J take a part of it.
    """
    result = fit(spastic(), multistart=4, expect={"damping": (3.0, 0.1)})
    damping, inertia = (result.parameters[name] for name in ("damping", "inertia"))
    assert (damping.expected, damping.expected_deviation) == (3.0, 0.1)
    assert damping.set_by == "your prior"
    assert damping.value == pytest.approx(3.0, abs=0.1)
    assert inertia.standard_error / inertia.value == pytest.approx(0.033, rel=0.1)


def test_the_sidecars_word_counts():
    said = replace(spastic(), extra_tables={"fit": {"fix": {"stiffness": 2.9}}})
    assert fit(said, multistart=4).parameters["stiffness"].set_by == "fixed by you"
    asked = fit(said, multistart=4, fix={"stiffness": 2.0})
    assert asked.parameters["stiffness"].value == 2.0


def test_what_is_fixed_has_no_profile_and_the_others_do():
    result = fit(spastic(), multistart=4, fix={"inertia": 0.44})
    found = profiles(result)
    assert "inertia" not in found
    damping = found["damping"]
    half = 1.96 * result.parameters["damping"].standard_error
    assert damping.upper - damping.lower == pytest.approx(2 * half, rel=0.1)  # nearly quadratic


def test_segment_by_segment_it_is_fixed_too():
    drops = recorded(DROP, replace(DROP, start_angle=np.radians(-25)))
    result = fit_each([("two", drops)], multistart=4, fix={"inertia": 0.42, "stiffness": 0.0})
    assert result.parameters["inertia"].value == pytest.approx(0.42)
    assert result.parameters["stiffness"].value == 0.0
    assert result.parameters["inertia"].set_by == "fixed by you"


@pytest.mark.proof
def test_slsqp_holds_it_as_well():
    fixed = {"stiffness": 2.9}
    one, other = (
        fit(spastic(), multistart=2, fix=fixed, method=method) for method in ("lm", "slsqp")
    )
    for name, each in one.parameters.items():
        assert other.parameters[name].value == pytest.approx(each.value, rel=1e-2)
