"""Which starts go on as one, and which are lost."""

import equinox as eqx
import jax
import numpy as np
import pytest

from exoid.fitting.data.conditioning_chain import Raw
from exoid.fitting.model.prior_and_limits import believe
from exoid.fitting.movements import movements_of
from exoid.fitting.multistart.beginning.led_to_data import HOPELESS, basins
from exoid.fitting.multistart.beginning.starts import coordinates
from exoid.fitting.multistart.settle import stands_still
from exoid.fitting.solve import ask
from exoid.fitting.solve.pose import pose
from exoid.fitting.solve.program_values import solved_structure
from fit_cases import BODY, DROP, recorded

LEG = (4.5, 0.42, 0.26, 0.33, 2.6, 0.0)  # m, J, l, d, c, tau
HEAVIER = (9.0, 0.84, 0.26, 0.66, 5.2, 0.0)  # of the same motion
STIFFER = (4.5, 0.42, 0.26, 0.33, 9.0, 0.0)


def arrived(*legs, loss):
    """A problem, and tied starts that ended at these legs."""
    movements = movements_of([("drop", recorded(DROP))])
    problem = pose(movements, believe(BODY), "1/T", Raw())
    at = coordinates(np.array(legs), movements)
    like = solved_structure()
    nowhere = jax.tree.unflatten(like, [np.zeros(0)] * like.num_leaves)
    ended = at, np.array(loss, dtype=float)
    return problem, eqx.tree_at(lambda each: (each.coordinates, each.loss), nowhere, ended)


def test_legs_of_one_motion_go_on_as_the_best_of_them():
    rows, member, failures = basins(*arrived(LEG, STIFFER, HEAVIER, loss=[3.0, 9.0, 2.0]))
    assert sorted(rows) == [1, 2]
    assert [rows[each] for each in member] == [2, 1, 2]
    assert failures == {}


def test_starts_that_cannot_be_simulated_or_lead_nowhere_are_lost_and_told():
    losses = [1.0, np.nan, 2 * HOPELESS, 0.9 * HOPELESS]
    rows, member, failures = basins(*arrived(LEG, LEG, LEG, STIFFER, loss=losses))
    assert sorted(rows) == [0, 3]
    assert [*member[1:3]] == [-1, -1]
    assert [*failures.values()] == [1, 1]


def test_a_search_goes_on_only_where_it_misses_or_violates_less_than_before():
    lowest = np.array([9.0, 0.1])
    assert not stands_still(np.array([8.9, 0.2]), lowest)
    assert not stands_still(np.array([9.5, 0.09]), lowest)
    assert stands_still(lowest, lowest)
    assert stands_still(np.array([9.5, 0.2]), lowest)


class Asked(Exception):
    """So many lanes."""


@pytest.mark.parametrize(("long", "lanes"), [(ask.LONG, 16), (50, 2)])
def test_a_start_is_not_repeated_to_fill_a_batch_of_a_long_recording(monkeypatch, long, lanes):
    """Lanes take as long as they are many; a program of its own takes seconds, once."""
    problem, ended = arrived(LEG, loss=[1.0])
    monkeypatch.setattr(ask, "BATCH", 16)
    monkeypatch.setattr(ask, "LONG", long)
    monkeypatch.setattr(ask, "run", refusing)
    with pytest.raises(Asked, match=f"^{lanes}$"):
        ask.advance(problem, ended.coordinates, ask.task(problem, 0.0, problem.steps, 1.0))


def refusing(starts, *same):
    raise Asked(starts.log_mass.size)


def test_where_no_start_can_be_simulated_there_is_no_fit():
    with pytest.raises(ArithmeticError, match="no start could be simulated"):
        basins(*arrived(LEG, STIFFER, loss=[np.nan, np.nan]))
