"""A leg that is pushed as it falls is told from what an angle sensor or a spring does."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.fitting.hands.first_swing import bottom, fastest
from exoid.fitting.hands.thrust import pushed_by, thrust
from exoid.fitting.movements import movements_of
from exoid.mismatch.conclude.verdict.begins_and_ends import begins_and_ends, what_next
from exoid.physics.ratios import Ratios
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from legs import BODY

GRAVITY, STIFFNESS, DAMPING = 26.4, 2.4, 0.7
LEG = Ratios(np.array(GRAVITY), np.array(STIFFNESS), np.array(DAMPING))
STARTS = (-0.25, -0.45, -0.6, -0.35)  # rad
HELD = 0.3  # s


def pushed(time, angle):
    """14 rad/s^2 about 0.25 s after the release."""
    return -14.0 * np.exp(-(((time - 0.25) / 0.06) ** 2))


def stiffer(time, angle):
    """A spring that draws the leg near extension alone."""
    return -9.0 * np.exp((angle + 0.25) / 0.1)


def nothing(time, angle):
    return 0.0


def drop(start, missing=nothing, *, gyro=True, sensor=lambda angle: angle, seed=0):
    """Let go after `HELD`, by SciPy."""
    random, step, held = np.random.default_rng(seed), 0.01, round(HELD * 100)

    def slope(t, y):
        pull = GRAVITY * np.cos(y[0]) + STIFFNESS * y[0] + DAMPING * y[1]
        return y[1], missing(t, y[0]) - pull

    since = np.arange(0.0, 5.0, step)
    swung = solve_ivp(
        slope, (0, 5), (start, 0.0), t_eval=since, rtol=1e-9, atol=1e-9, max_step=0.02
    )
    angle = np.concatenate([np.full(held, start), swung.y[0]])
    rate = np.concatenate([np.zeros(held), swung.y[1]])
    return Segment(
        step * np.arange(angle.size),
        raw_angle=sensor(angle) + 8e-4 * random.standard_normal(angle.size),
        raw_angular_velocity=rate + 3e-3 * random.standard_normal(angle.size) if gyro else None,
    )


def recorded(which, missing, **how) -> Recording:
    """Drops of which some have something that others have not."""
    drops = [
        drop(start, missing if number in which else nothing, seed=number, **how)
        for number, start in enumerate(STARTS)
    ]
    return Recording(tuple(drops), BODY, Protocol(kind="passive"))


def told(recording, since):
    movements = movements_of([("leg", recording)])
    return pushed_by([thrust(each, LEG, 0.0, since(each)) for each in movements])


@pytest.mark.parametrize("since", [fastest, bottom])
@pytest.mark.parametrize("gyro", [True, False])
@pytest.mark.parametrize("which", [(1, 3), (2,), (0, 1, 2, 3)])
def test_a_push_is_no_sensor_and_no_spring_and_stands_in_the_drops_that_have_it(which, gyro, since):
    by = told(recorded(which, pushed, gyro=gyro), since)
    assert by == ["thrust" if number in which else "alike" for number in range(4)]


@pytest.mark.parametrize("gyro", [True, False])
def test_a_spring_that_only_the_largest_swing_meets_is_not_excluded(gyro):
    by = told(recorded((0, 1, 2, 3), stiffer, gyro=gyro), fastest)
    assert by[0] == ("thrust or spring" if gyro else "neither")
    assert "thrust" not in by


def test_a_sensor_that_is_not_linear_is_not_excluded():
    """0.05 (phi + 1.4)^3: 2.3 deg at the greatest start. A gyro departs from it."""
    for gyro in (True, False):
        bent = recorded(
            (), nothing, gyro=gyro, sensor=lambda angle: angle + 0.05 * (angle + 1.4) ** 3
        )
        assert set(told(bent, fastest)) == {"neither"}


def test_of_drops_as_they_are_nothing_is_clear():
    for gyro, may in ((True, "thrust or spring"), (False, "neither")):
        assert set(told(recorded((), nothing, gyro=gyro), fastest)) == {may}


def test_a_fit_names_the_drops_that_were_pushed_and_no_sensor():
    result = fit(recorded((1,), pushed), multistart=4)
    assert result.follows
    (note,) = (note for note in result.notes if "were left out" in note)
    assert "in the first swing of segment 1 the leg" in note
    assert "as where it is pushed" in note
    assert "by no angle sensor and no spring" in note
    assert "known angles" not in note
    each = result.ratios["gravity_over_inertia"]
    assert abs(each.value - GRAVITY) < 3 * each.standard_error
    assert result.basis is not None
    movements = result.basis.problem.movements
    (why,) = begins_and_ends(movements)
    assert "behind the release of segment 1: there the leg" in why
    assert what_next(movements) == ["Let go at once, and touch nothing until the leg hangs still."]
