"""Legs that a hand brings to rest softly, beside ones that come to rest by themselves, by SciPy."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.pendulum.drops import measure_drops
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.measured.segment import Segment
from exoid.recordings.motion.find_free import find_free
from exoid.recordings.motion.signal import signal_of
from legs import balance_of, recording

LEG = (27.5, 3.2, 0.8)  # m l g / J and c / J [1/s^2], d / J [1/s]
STIFF_END = (0.7, 7.5, np.radians(-95.0))  # rad/s^2 at an angle beyond which it grows e-fold a rad
HELD = 0.3  # s


def dropped(hand=None, end=(0.0, 0.0, 0.0), friction=0.0, lasting=9.0, flow=(0.0, 1.0)):
    """A drop by an encoder; `hand` takes it after so long [s] over so long, with a spring
    [1/s^2] to an angle and a damper [1/s]. Tissue may `flow`: a spring behind which a damper gives
    way in a time [s].
    """
    gravity, stiffness, damping = LEG

    def slope(time, state):
        angle, speed, stretched = state
        pull = gravity * np.cos(angle) + stiffness * angle + damping * speed
        pull -= end[0] * np.expm1(max(end[1] * (end[2] - angle), 0.0))
        pull += friction * np.tanh(speed / 0.01) + flow[0] * stretched
        if hand is not None and time > hand[0]:
            after, over, spring, place, damper = hand
            grip = min((time - after) / over, 1.0)
            pull += grip * (spring * (angle - place) + damper * speed)
        return speed, -pull, speed - stretched / flow[1]

    start, state = -0.35, (-0.35, 0.0, 0.0)
    time = np.arange(0.0, lasting, 0.01)
    seen = time[time > HELD] - HELD
    told = solve_ivp(slope, (0.0, lasting), state, t_eval=seen, max_step=0.01, rtol=1e-7)
    angle = np.concatenate([np.full(time.size - seen.size, start), told.y[0]])
    noisy = angle + 5e-4 * np.random.default_rng(1).standard_normal(time.size)
    return recording(Segment(time, raw_angle=noisy), sensors=Sensors(angle_noise=5e-4))


def end_of(made):
    return find_free(signal_of(made.segments[0], made.sensors))


# s, s, 1/s^2, rad, 1/s: before the third turn and after it, on its way and in the middle
HANDS = [
    (1.9, 0.1, 60.0, -1.2, 6.0),
    (2.2, 0.3, 100.0, -1.6, 10.0),
    (2.45, 0.4, 40.0, -1.42, 16.0),
    (2.9, 0.2, 90.0, -1.3, 5.0),
]
# The same of hands that are laid on the leg and go along, so that it rests where it would anyway
DAMPERS = [(2.2, 0.4, 0.0, 0.0, 3.0), (2.4, 0.5, 0.0, 0.0, 5.0), (2.0, 0.3, 0.0, 0.0, 4.0)]


@pytest.mark.parametrize("hand", HANDS)
@pytest.mark.parametrize("end", [(0.0, 0.0, 0.0), STIFF_END])
def test_a_leg_that_a_yielding_hand_brings_to_rest_is_told(hand, end):
    """Where it stands still at the end is no rest of its own."""
    made = dropped(hand, end, lasting=HELD + hand[0] + 2.5)
    found = end_of(made)
    assert found.ended == "caught"
    assert made.segments[0].time[found.stop - 1] < HELD + hand[0] + hand[1]
    (drop,) = measure_drops(made).drops
    assert drop.measures["relaxation_index"].value is None
    index = drop.measures["expected_relaxation_index"]
    if index.value is not None:
        free = measure_drops(dropped(end=end, lasting=14.0)).drops[0].measures["relaxation_index"]
        assert abs(index.value - free.value) < 3 * index.standard_error


@pytest.mark.parametrize("hand", DAMPERS)
@pytest.mark.parametrize("end", [(0.0, 0.0, 0.0), STIFF_END])
def test_a_leg_that_a_hand_damps_within_a_swing_is_told(hand, end):
    """It rests where it would by itself, but sooner: its swings shrink as none did before."""
    made = dropped(hand, end, lasting=HELD + hand[0] + 5.0)
    found = end_of(made)
    assert found.ended == "caught"
    assert made.segments[0].time[found.stop - 1] < HELD + hand[0] + 0.7  # a swing later
    (drop,) = measure_drops(made).drops
    assert drop.measures["time_to_rest"].value is None
    assert drop.measures["number_of_oscillations"].value is None


@pytest.mark.parametrize("flow", [(6.0, 0.2), (12.0, 0.5), (20.0, 1.0)])
def test_a_leg_whose_tissue_flows_comes_to_rest_by_itself(flow):
    """The angle about which it swings sinks, so that every second swing shrinks more."""
    made = dropped(flow=flow, lasting=14.0)
    assert end_of(made).ended == "at rest"


@pytest.mark.parametrize("friction", [0.0, 0.1, 0.35, 1.0])
@pytest.mark.parametrize("end", [(0.0, 0.0, 0.0), STIFF_END])
def test_a_leg_that_nobody_touches_comes_to_rest_by_itself(friction, end):
    """Friction stops it in a swing, far sooner than damping does."""
    made = dropped(end=end, friction=friction, lasting=12.0)
    assert end_of(made).ended == "at rest"
    (drop,) = measure_drops(made).drops
    assert drop.measures["plateau_angle"].value == pytest.approx(
        balance_of(LEG), abs=0.01 + friction / 25.0
    )
