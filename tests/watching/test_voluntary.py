"""Movements that no leg makes by itself: they tell nothing, whatever terms are asked for."""

from dataclasses import replace

import pytest
from bundled_session import LIKELY, LOADED, TRUTH, WEIGHT

from exoid.online.model.model import Model
from exoid.online.model.unknowns import Unknowns
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.watching.estimate.leg import Leg, LegDrop
from exoid.watching.estimate.load import Load, Mass
from exoid.watching.estimate.moment import Moment

FROM = 57.0  # s, from when on the leg of the session is moved by its muscles
TERMS = [(), (CoulombFriction,), (QuadraticDrag,)]


def followed(person, terms, load, readings):
    """All that is told of the readings, and the drops of it."""
    leg = Leg(replace(person, model=Model(Unknowns(terms))), load)
    told = list(leg.take(readings))
    return [each for each in told if isinstance(each, Moment)], [
        each for each in told if isinstance(each, LegDrop)
    ]


@pytest.mark.parametrize("terms", TERMS, ids=str)
def test_voluntary_cycles_after_drops_change_no_number(person, readings, terms):
    load = Load((0.0, *LOADED), (Mass(), WEIGHT, Mass()))
    moments, drops = followed(person, terms, load, readings)
    assert [each.mass for each in drops] == [Mass(), Mass(), Mass(), WEIGHT]
    assert moments[-1].drops == 4
    assert "inertia" in moments[-1].quantities
    for moment in moments:
        for each in moment.quantities.values() if moment.time > FROM else ():
            if each.name in TRUTH:
                assert abs(each.value - TRUTH[each.name]) < LIKELY * each.error, moment.time


@pytest.mark.parametrize("terms", TERMS, ids=str)
def test_voluntary_cycles_alone_tell_nothing(person, readings, terms):
    cycles = [each for each in readings if each.time > FROM]
    moments, drops = followed(person, terms, Load(), cycles)
    assert drops == []
    expected = [each.error for each in moments[0].ratios]
    for moment in moments:
        if moment.believed:
            assert [each.error for each in moment.ratios] == pytest.approx(expected), moment.time
