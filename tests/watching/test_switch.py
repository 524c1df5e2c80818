"""A weight that comes and goes while the leg is followed, as nobody knows beforehand."""

from bundled_session import LIKELY, LOADED, TRUTH, WEIGHT

from exoid.watching.estimate.leg import Leg, LegDrop
from exoid.watching.estimate.load import Load, Mass
from exoid.watching.estimate.moment import Moment
from exoid.watching.estimate.switch import Switch


def test_a_weight_that_is_switched_tells_what_one_of_a_file_does(readings, person):
    """It is declared on, off before the first sample, on for the last drop, and off again."""
    switch = Switch(WEIGHT)
    leg, told = Leg(person, switch), []
    switch.turn(float("-inf"))
    for begin, end in ((-1.0, LOADED[0]), LOADED, (LOADED[1], 1e9)):
        told += leg.take([each for each in readings if begin < each.time <= end])
        switch.turn(end)
    drops = [each for each in told if isinstance(each, LegDrop)]
    assert [each.mass for each in drops] == [Mass(), Mass(), Mass(), WEIGHT]
    inertia = drops[-1].moment.quantities["inertia"]
    assert abs(inertia.value - TRUTH["inertia"]) < LIKELY * inertia.error < 0.02


def test_a_pause_between_segments_is_no_fault_and_a_gap_in_them_is(readings, person):
    """The stream stops for 2 s at 27 s, between two drops."""
    from exoid.online.model.trust import Trust

    torn = [each for each in readings if each.time < 27.0 or each.time > 29.0]
    torn = [each for each in torn if each.time < 35.0]
    said = {}
    for name, load in (("gap", Load()), ("pause", Load(pauses=(29.0,)))):
        told = Leg(person, load).take(torn)
        said[name] = {each.trust for each in told if isinstance(each, Moment)}
    assert Trust.FAULTY in said["gap"]
    assert Trust.FAULTY not in said["pause"]
    assert said["pause"] | {Trust.FAULTY} == said["gap"]
