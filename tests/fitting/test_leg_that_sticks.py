"""A leg that dry friction holds is found from every start, as SciPy has it: no code of exoid."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import exoid
from exoid.physics.terms.device.coulomb_friction import CoulombFriction

GRAVITY, STIFFNESS, DAMPING, FRICTION = 25.6, 5.45, 1.09, 0.78  # over J
RATE, LASTING = 100.0, 6.0  # Hz, s: most of it the leg stands still
LIKELY = 3.5  # standard errors: of four numbers of a sound fit one in 500 is as far off


def pulled(angle: float) -> float:
    return -GRAVITY * np.cos(angle) - STIFFNESS * angle


def turning(_, state):
    return state[1]


turning.terminal = True


def dropped(begin: float) -> tuple[np.ndarray, np.ndarray]:
    """Angle and rate, from turn to turn; where friction holds the leg there, it stays."""
    time = np.arange(0.0, LASTING, 1 / RATE)
    now, angle = 0.0, begin
    shown = np.zeros((2, time.size))
    while True:
        ahead = time >= now
        shown[:, ahead] = [[angle], [0.0]]
        way = np.sign(pulled(angle))
        if abs(pulled(angle)) <= FRICTION:
            return shown[0], shown[1]

        def slope(_, state, way=way):
            return state[1], pulled(state[0]) - DAMPING * state[1] - way * FRICTION

        first = angle, way * 1e-9  # rad/s, already on its way
        turning.direction = -way
        end = solve_ivp(
            slope, (now, LASTING), first, events=turning, dense_output=True, rtol=1e-9, atol=1e-12
        )
        until = ahead & (time <= end.t[-1])
        shown[:, until] = end.sol(time[until])
        now, angle = end.t[-1], end.y[0, -1]
        if end.status == 0:
            return shown[0], shown[1]


@pytest.fixture(scope="module")
def drops():
    random = np.random.default_rng(11)
    each = [dropped(np.radians(begin)) for begin in (-12.0, -25.0, -40.0)]
    size = each[0][0].size
    return exoid.recording(
        time_s=np.tile(np.arange(size) / RATE, len(each)),
        segment=np.repeat(np.arange(len(each)), size),
        raw_angle_rad=np.concatenate([one for one, _ in each])
        + random.normal(0, 6e-4, size * len(each)),
        raw_velocity_rad_s=np.concatenate([two for _, two in each])
        + random.normal(0, 3e-3, size * len(each)),
        subject={"kind": "leg", "body_mass": 68.0, "height": 1.72},
        protocol={"kind": "passive"},
    )


@pytest.mark.parametrize("multistart", [1, 16])
def test_its_friction_is_found_down_to_the_noise(drops, multistart):
    found = exoid.fit(drops, terms=(CoulombFriction,), multistart=multistart)
    assert found.follows
    told = [*found.ratios.values(), found.terms["coulomb_friction"]["level_over_inertia"]]
    truth = [GRAVITY, STIFFNESS, DAMPING, FRICTION]
    off = [(one.value - true) / one.standard_error for one, true in zip(told, truth, strict=True)]
    assert np.abs(off).max() < LIKELY
    assert found.mountings[0].tilt is None
