"""A leg that is followed: what is told, when, and that it does not hang on how samples come."""

from dataclasses import replace
from math import nan

import numpy as np
import pytest
from bundled_session import LIKELY, LOADED, SUBJECT, TRUTH, WEIGHT, nan_equal, until

from exoid.online.model.trust import Phase, Trust
from exoid.online.model.unknowns import Unknowns
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.recordings.declared.subject import Subject
from exoid.watching.estimate.expect import expected_of, is_known
from exoid.watching.estimate.left_out import LeftOut
from exoid.watching.estimate.leg import Leg, LegDrop
from exoid.watching.estimate.load import Load, Mass, constant_load, expected_with
from exoid.watching.estimate.moment import Moment


def moments(told) -> list[Moment]:
    return [each for each in told if isinstance(each, Moment)]


def drops(told) -> list[LegDrop]:
    return [each for each in told if isinstance(each, LegDrop)]


def numbers(told) -> list[tuple]:
    """Everything of it that is a number, in order."""
    found = []
    for each in told:
        if isinstance(each, LeftOut):
            found.append((each.time, each.begun))
            continue
        moment = each if isinstance(each, Moment) else each.moment
        known = [
            value for one in (*moment.ratios, *moment.others) for value in (one.value, one.error)
        ]
        motion = (moment.time, moment.angle, moment.angular_velocity)
        found.append((*motion, moment.phase, moment.trust, moment.drops, sum(known)))
    return found


def test_there_is_one_moment_for_every_tenth_of_a_second(told):
    times = np.array([each.time for each in moments(told)])
    assert times[0] == 0.0
    np.testing.assert_allclose(np.diff(times), 0.1, atol=0.0101)  # a sample is every 10 ms
    assert times.size == 885


@pytest.mark.parametrize("size", [1, 7, 96, 1000])
def test_it_does_not_hang_on_how_many_samples_come_at_once(readings, leg, told, size):
    some = until(readings, 13.0)
    found = [news for at in range(0, len(some), size) for news in leg.take(some[at : at + size])]
    assert nan_equal(numbers(found), numbers(told)[: len(found)])
    assert len(drops(found)) == 1


def test_the_ratios_are_the_legs_within_their_errors_at_every_drop(told):
    assert [each.mass for each in drops(told)] == [Mass(), Mass(), Mass(), WEIGHT]
    for drop in drops(told):
        for each in drop.moment.ratios:
            assert abs(each.value - TRUTH[each.name]) < LIKELY * each.error, each


def test_errors_shrink_from_the_second_turn_on(told):
    """It is let go at 1.6 s and has turned twice at 2.7 s: until then it may be in a hand."""
    errors = {each.time: each.ratios[0].error for each in moments(told)}
    first, later, last = (errors[min(errors, key=lambda t: abs(t - at))] for at in (2.5, 2.7, 11.5))
    assert last < 0.5 * later < 0.1 * first


def test_friction_that_is_asked_for_and_not_there_leaves_the_ratios_as_they_are(readings, person):
    """In the loaded drop the leg turns round just as a part of a step begins."""
    model = replace(person.model, unknowns=Unknowns((CoulombFriction,)))
    load = Load((0.0, *LOADED), (Mass(), WEIGHT, Mass()))
    told = list(Leg(replace(person, model=model), load).take(until(readings, LOADED[1])))
    total = 0.42 + 1.0 * 0.4**2  # kg m^2
    truth = [(4.5 * 0.26 + 0.4) * 9.80665 / total, 2.6 / total, 0.33 / total]
    values = np.array([(each.value, each.error) for each in drops(told)[-1].moment.as_loaded]).T
    # Without friction they are within 0.2 errors of the truth, and it is not for friction to move.
    assert (np.abs(values[0] - truth) < values[1]).all()


def test_a_loaded_drop_tells_the_inertia_and_no_drop_before_it(told):
    before, after = drops(told)[2].moment, drops(told)[3].moment
    assert before.others == ()
    known = {each.name: each for each in after.others}
    assert known["inertia"].error < 0.02 * 0.42
    assert abs(known["inertia"].value - 0.42) < LIKELY * known["inertia"].error


def test_another_weight_is_no_fault_and_no_other_leg(told):
    trusts = {each.trust for each in moments(told) if 12.0 < each.time < 57.0}
    assert trusts <= {Trust.WAITING, Trust.LEARNING, Trust.GOOD, Trust.ENOUGH}


def test_what_a_weight_told_of_another_leg_is_forgotten(readings, leg):
    """The first drop again, a seventh slower: of a leg with three quarters of the ratios."""
    of_one = until(readings, 57.5)
    time, angle, rate = np.array([each[:3] for each in until(readings, 12.5)]).T
    slow = 1.15
    at = np.arange(time[0], time[-1], 0.01 / slow)
    columns = (58.0 + slow * at, np.interp(at, time, angle), np.interp(at, time, rate) / slow)
    of_another = [
        of_one[0]._replace(time=t, angle=a, angular_velocity=v)
        for t, a, v in zip(*(each.tolist() for each in columns), strict=True)
    ]
    assert moments(leg.take(of_one))[-1].quantities["inertia"].error < 0.02 * 0.42
    told = list(leg.take(of_another))
    assert Trust.CHANGED in {each.trust for each in moments(told)}
    last = moments(told)[-1]
    assert last.drops == 1
    assert [each.number for each in drops(told)] == [1]
    assert "inertia" not in last.quantities
    gravity = last.quantities["gravity_over_inertia"]
    assert abs(gravity.value - TRUTH[gravity.name] / slow**2) < LIKELY * gravity.error


def test_a_leg_that_never_moves_has_the_errors_of_anatomy(readings, leg):
    still = until(readings, 0.5)
    held = [still[at % 50]._replace(time=0.01 * at) for at in range(1000)]
    last = moments(leg.take(held))[-1]
    assert (last.trust, last.drops) == (Trust.WAITING, 0)
    assert last.ratios[0].error > 0.02 * last.ratios[0].value
    assert last.ratios[1].error > last.ratios[1].value


def test_a_stream_that_loses_much_tells_no_number(readings, leg):
    bad = [each for at, each in enumerate(until(readings, 8.0)) if each.time < 4.0 or not at % 7]
    last = moments(leg.take(bad))[-1]
    assert last.trust is Trust.FAULTY
    assert last.quantities == {}


def test_doubled_samples_change_nothing(readings, leg):
    some = until(readings, 8.0)
    plain = moments(Leg(leg.person, leg.load).take(some))
    rare = [each for at, each in enumerate(some) for _ in range(2 if at % 97 == 0 else 1)]
    doubled = moments(leg.take(rare))
    assert doubled[-1].ratios == plain[-1].ratios


def test_missing_values_are_no_values(readings, leg):
    blind = [each._replace(angle=nan, angular_velocity=nan) for each in until(readings, 3.0)]
    last = moments(leg.take(blind))[-1]
    assert last.drops == 0
    assert last.trust is Trust.FAULTY


def test_a_mass_from_the_beginning_makes_the_bare_leg_as_unsure_as_its_inertia(readings, person):
    shifted = [each for each in readings if 41.0 < each.time < 57.0]
    known = drops(Leg(person, Load(masses=(WEIGHT,))).take(shifted))[0].moment
    assert known.others == ()
    stiffness = known.ratios[1]
    assert stiffness.error > 0.1
    assert abs(stiffness.value - TRUTH["stiffness_over_inertia"]) < 3 * stiffness.error
    assert known.as_loaded[1].error < 0.1 * stiffness.error


def test_the_loaded_leg_is_expected_as_one_body(person):
    loaded = expected_with(person.expected, Mass(2.0, 0.3))
    bare = person.expected
    assert loaded.inertia.value == pytest.approx(bare.inertia.value + 2.0 * 0.3**2)
    moment = loaded.mass.value * loaded.com_distance.value
    assert moment == pytest.approx(bare.mass.value * bare.com_distance.value + 2.0 * 0.3)


def test_anybodys_leg_scatters_more_than_a_known_persons():
    known, anybody = expected_of(SUBJECT), expected_of(Subject())
    assert is_known(SUBJECT)
    assert not is_known(Subject())
    assert anybody.covariance[0][0] > 4 * known.covariance[0][0]


def test_a_mass_without_a_place_is_one_to_be_placed():
    load = constant_load(replace(SUBJECT, added_mass=1.5))
    assert load.at(3.0) == Mass(1.5, placed=False)
    assert constant_load(SUBJECT) == Load()
    assert Phase.DONE > Phase.MOVING  # what panels count on


def test_a_weight_that_is_said_and_not_there_tells_no_number(readings, person):
    """Two drops of the bare leg, the second one said to be loaded: no leg is like that."""
    leg = Leg(person, Load((0.0, 13.0), (Mass(), WEIGHT)))
    told = moments(leg.take(until(readings, 28.0)))
    assert told[-1].drops == 2
    assert told[-1].trust is Trust.UNEXPLAINED


def test_another_leg_is_not_known_by_the_weights_that_were_on_the_one_before(readings, person):
    """From 27 s on the leg is said to be bare; from 41 s on it has 1 kg at the ankle."""
    leg = Leg(person, Load((0.0, 27.0), (WEIGHT, Mass())))
    told = moments(leg.take(until(readings, LOADED[1])))
    assert Trust.CHANGED in {each.trust for each in told}
    assert set(leg.estimators) == {Mass()}
    assert (told[-1].drops, told[-1].believed) == (1, True)
    assert "inertia" not in told[-1].quantities


def test_a_drop_counts_that_still_swings_as_a_pause_comes_behind_which_another_weight_is_on(
    readings, person
):
    """The first one is cut at 4.5 s; behind a second without samples the leg hangs with 1 kg."""
    bare = until(readings, 4.5)
    first = next(each.time for each in readings if each.time > LOADED[0])
    loaded = [
        each._replace(time=each.time - first + 5.5)
        for each in readings
        if first <= each.time < first + 1.0
    ]
    told = list(Leg(person, Load((0.0, 5.5), (Mass(), WEIGHT))).take([*bare, *loaded]))
    (one,) = drops(told)
    assert (one.mass, one.number) == (Mass(), 1)
    assert 4.0 < one.until <= 4.5
    assert moments(told)[-1].drops == 1
    assert len({each.time for each in moments(told)}) == len(moments(told))
