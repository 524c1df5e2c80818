"""Where a segment begins, as its sensors show it."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.amount.part import parts_of
from exoid.fitting.data.segment import movement
from exoid.fitting.movements import left_out, movements_of
from exoid.physics.leg import LegModel
from exoid.physics.motion.simulate import simulate
from exoid.physics.term import Term
from exoid.physics.terms.device.cuff_compliance import CuffCompliance
from exoid.physics.terms.device.sticking_backlash import StickingBacklash
from exoid.physics.torque import NoTorque
from exoid.recordings.measured.segment import Segment
from fit_cases import leg, one, state
from hands import Device, Hand, dropped

TICK = 0.01  # s
PLAY = StickingBacklash(jnp.asarray(0.02))
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
    """How much a fit leaves away in front [s]."""
    return TICK * (segment.time.size - movement(one(segment), 0, "0").segment.time.size)


@pytest.mark.parametrize("terms", [(), (PLAY,), (SOFT,)])
@pytest.mark.parametrize("start", [-0.1, -0.4, -0.9])
def test_nothing_is_lost_of_a_drop_that_was_marked_at_its_release(terms, start):
    found = movement(one(let_go(0.0, *terms, start=start)), 0, "0")
    assert found.segment.time.size == 200
    assert not np.isnan(found.angle).any()


@pytest.mark.parametrize("start", [-0.1, -0.4, -0.9])
def test_a_rest_in_front_of_a_drop_is_left_away_up_to_its_last_sample(start):
    assert cut_off(let_go(0.5, start=start)) == pytest.approx(0.5, abs=1.1 * TICK)


@pytest.mark.parametrize("start", [-0.1, -0.4, -0.9])
def test_where_play_hides_the_release_a_drop_begins_when_the_sensors_follow(start):
    # They wait for 40 to 60 ms, as under a hand that lets go slowly: the two cannot be told apart.
    assert 0.48 <= cut_off(let_go(0.5, PLAY, start=start)) <= 0.57


def test_what_a_hand_does_while_it_lets_go_weighs_nothing():
    recording, release = dropped(hand=Hand(fade=0.08))
    found = movement(recording, 0, "0")
    time = recording.segments[0].time
    weighs = time[time.size - found.segment.time.size :][~np.isnan(found.angle)]
    assert release + 0.06 < weighs[0] < release + 0.13  # the last of a cosine is no longer felt
    np.testing.assert_array_equal(np.isnan(found.angle), np.isnan(found.angular_velocity))


def test_the_published_clipping_keeps_what_is_faster_than_20_degrees_per_second():
    recording, _ = dropped(device=Device(gyro=1e-4))
    kept = movement(recording, 0, "0", clip="paper")
    speed = np.abs(kept.segment.raw_angular_velocity[[0, -1]])
    assert (speed > np.radians(15)).all()  # it is found on the mean over 50 ms
    assert not np.isnan(kept.angle).any()


def test_a_motionless_segment_is_left_out_by_name():
    recording, _ = dropped(lasting=3.0)
    still = Segment(np.arange(0, 2, 0.01), raw_angle=np.full(200, -0.3))
    still = replace(still, raw_angular_velocity=np.zeros(200))
    both = replace(recording, segments=(still, recording.segments[0]))
    found = movements_of([("r", both)])
    assert [each.name for each in found] == ["1"]
    assert left_out(parts_of([("r", both)]), found) == [
        "segment 0 was left out: nothing moves freely in there, or hardly ever"
    ]


def test_a_recording_in_which_nothing_moves_is_refused():
    still = Segment(np.arange(0, 2, 0.01), raw_angle=np.full(200, -0.3))
    with pytest.raises(ValueError, match=r"segment 0: nothing moves: no movement goes farther"):
        movements_of([("r", one(still))])


def test_a_gyro_that_turns_the_other_way_is_refused():
    drop = let_go(0.0)
    turned = replace(drop, raw_angular_velocity=-np.asarray(drop.raw_angular_velocity))
    with pytest.raises(ValueError, match="segment 0: the angular velocity is the angle's with"):
        movement(one(turned), 0, "0")


@pytest.mark.parametrize(("cycles", "refused"), [(1, False), (2, False), (20, True)])
def test_many_voluntary_cycles_in_one_segment_are_refused_before_anything_is_computed(
    cycles, refused
):
    time = TICK * np.arange(round(2.0 * cycles / TICK) + 1)
    angle = -0.8 - 0.6 * np.cos(np.pi * time)
    moved = one(Segment(time, raw_angle=angle), kind="active")
    if not refused:
        assert movement(moved, 0, "0").voluntary
        return
    back = r"Times \[s\] at which it is back: 2\.0, 4\.0, .* 16\.0 and 11 more\."
    with pytest.raises(ValueError, match=f"goes to and fro 20 times.*a column called .*{back}"):
        movement(moved, 0, "0")
