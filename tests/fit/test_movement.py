"""Where a segment begins, as its sensors show it."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fit.movement import movement
from exoid.physics.leg import LegModel
from exoid.physics.simulate import simulate
from exoid.physics.term import Term
from exoid.physics.terms.backlash import Backlash
from exoid.physics.terms.cuff_compliance import CuffCompliance
from exoid.physics.torque import NoTorque
from exoid.recording.recording import Segment
from fit_cases import leg, one, state

TICK = 0.01  # s
PLAY = Backlash(jnp.asarray(0.02))
SOFT = CuffCompliance(*map(jnp.asarray, (0.2, 0.02, 1.2, 0.1, 0.4)))


@jax.jit
def shown(terms: tuple[Term, ...], start):
    model = LegModel(leg(), NoTorque(), terms=terms)
    seen = simulate(model, state(start), TICK * jnp.arange(200))
    return seen.shown_angle, seen.shown_velocity


def let_go(after: float, *terms: Term, start: float = -0.4) -> Segment:
    """A drop that a hand holds for a while before."""
    angle, velocity = map(np.asarray, shown(terms, start))
    held = round(after / TICK)
    angle = np.concatenate([np.full(held, angle[0]), angle])
    velocity = np.concatenate([np.zeros(held), velocity])
    return Segment(TICK * np.arange(angle.size), raw_angle=angle, raw_angular_velocity=velocity)


def cut_off(segment: Segment) -> float:
    """How much a diagnosis leaves away in front [s]."""
    whole = movement(one(segment), 0, "0", whole=True)
    return TICK * (segment.time.size - whole.segment.time.size)


@pytest.mark.parametrize("terms", [(), (PLAY,), (SOFT,)])
@pytest.mark.parametrize("start", [-0.1, -0.4, -0.9])
def test_nothing_is_lost_of_a_drop_that_was_marked_at_its_release(terms, start):
    assert cut_off(let_go(0.0, *terms, start=start)) == 0.0


@pytest.mark.parametrize("start", [-0.1, -0.4, -0.9])
def test_a_rest_in_front_of_a_drop_is_left_away_up_to_its_last_sample(start):
    # The gyro's mean over 50 ms sees the fall two samples early.
    assert cut_off(let_go(0.5, start=start)) == pytest.approx(0.5, abs=2.1 * TICK)


@pytest.mark.parametrize("start", [-0.1, -0.4, -0.9])
def test_a_leg_falls_before_its_play_is_used_up(start):
    # The sensors wait for 40 to 60 ms; a speed that grows less and less is followed back too far.
    assert cut_off(let_go(0.5, PLAY, start=start)) == pytest.approx(0.5, abs=2.1 * TICK)


def test_a_gyro_that_turns_the_other_way_is_refused():
    drop = let_go(0.0)
    turned = replace(drop, raw_angular_velocity=-np.asarray(drop.raw_angular_velocity))
    with pytest.raises(ValueError, match="segment 0: the angular velocity is the angle's with"):
        movement(one(turned), 0, "0")
