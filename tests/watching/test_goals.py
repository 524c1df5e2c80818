"""How well is well enough: goals as they are said, and when they are reached."""

import pytest

from exoid.online.model.trust import Phase, Trust
from exoid.physics.anatomy import expected_leg
from exoid.watching.beside.goals import goal_of, reached
from exoid.watching.estimate.expect import sizes_of
from exoid.watching.estimate.moment import Moment, Quantity

NAMES = ("gravity_over_inertia", "inertia")


def moment(error=0.2, trust=Trust.GOOD, phase=Phase.DONE, drops=1) -> Moment:
    known = (Quantity("gravity_over_inertia", 20.0, error, "1/s^2"),)
    return Moment(1.0, -1.0, 0.0, phase, trust, drops, known, known)


@pytest.mark.parametrize(
    ("said", "share"),
    [
        ("gravity_over_inertia=1%", 1.0),
        ("gravity_over_inertia = 2 %", 0.5),
        ("gravity_over_inertia=0.4", 0.5),
        ("gravity_over_inertia=0.1", 2.0),
    ],
)
def test_a_goal_is_a_share_of_the_value_or_an_error_in_its_unit(said, share):
    assert goal_of(said, NAMES).share(moment()) == pytest.approx(share)


@pytest.mark.parametrize(
    ("said", "named"),
    [
        ("weight=2%", "there is no 'weight'; it can be gravity_over_inertia, inertia"),
        ("inertia", "this is not like --until inertia=2%"),
        ("inertia=", "this is not like"),
        ("inertia=-2%", "this is not like"),
        ("inertia=nan", "this is not like"),
        ("inertia=0", "this is not like"),
        ("inertia=two%", "this is not like"),
    ],
)
def test_what_is_no_goal_is_refused(said, named):
    with pytest.raises(ValueError, match=named):
        goal_of(said, NAMES)


@pytest.mark.parametrize(
    "said", ["inertia=2", "inertia=0.5", "gravity_over_inertia=30", "inertia=120%"]
)
def test_an_error_as_large_as_the_quantity_is_no_goal(said):
    sizes = sizes_of(expected_leg(77.0, 1.80))
    with pytest.raises(ValueError, match=r"a standard error as large as .* itself is no goal"):
        goal_of(said, NAMES, sizes)
    assert str(goal_of("inertia=0.05", NAMES, sizes)) == "inertia=0.05"


def test_a_forgotten_percent_sign_is_shown():
    with pytest.raises(ValueError, match="Write inertia=2% for a share of it"):
        goal_of("inertia=2", NAMES, sizes_of(expected_leg(77.0, 1.80)))


def test_a_goal_is_reached_by_a_drop_that_has_ended():
    goals = [goal_of("gravity_over_inertia=1%", NAMES)]
    assert reached(goals, moment())
    assert not reached(goals, moment(error=0.21))
    assert not reached(goals, moment(phase=Phase.MOVING))
    assert not reached(goals, moment(drops=0))
    assert not reached([], moment())


@pytest.mark.parametrize("trust", [Trust.WAITING, Trust.UNEXPLAINED, Trust.CHANGED, Trust.FAULTY])
def test_no_goal_is_reached_where_nothing_can_be_believed(trust):
    assert not reached([goal_of("gravity_over_inertia=1%", NAMES)], moment(trust=trust))


def test_what_is_not_known_is_not_reached():
    assert goal_of("inertia=2%", NAMES).share(moment()) is None
    assert not reached([goal_of("inertia=2%", NAMES)], moment())
