"""A frame on soft cuffs that SciPy moved: the leg comes back through sensors that ride on it."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.physics.terms.device.cuff_compliance import CuffCompliance
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording

pytestmark = pytest.mark.proof

INERTIA = 0.4  # kg m^2
LEG = {"gravity_over_inertia": 27.0, "stiffness_over_inertia": 8.0, "damping_over_inertia": 0.9}
CUFFS = {"compliance": 0.03, "frame_inertia": 0.04, "frame_gravity": 1.0, "hinge_damping": 0.12}
DAMPING_RATIO = 0.3
STARTS = (-0.2, -0.5, -0.9)  # rad
HOLD, LASTING, STEP = 0.8, 5.0, 0.01  # s
NOISE, GYRO = 1e-3, 5e-3  # rad, rad/s
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000


def slope(time, state, hand):
    """Of leg and frame; `hand(time)` [N m] holds the leg."""
    leg, leg_rate, frame, frame_rate = state
    stiffness = 1 / CUFFS["compliance"]
    damper = 2 * DAMPING_RATIO * np.sqrt(stiffness * CUFFS["frame_inertia"])
    carried = stiffness * (leg - frame) + damper * (leg_rate - frame_rate)
    gravity, spring, damping = LEG.values()
    own = gravity * np.cos(leg) + spring * leg + damping * leg_rate
    hung = CUFFS["frame_gravity"] * np.cos(frame) + CUFFS["hinge_damping"] * frame_rate
    return [
        leg_rate,
        (hand(time) - carried) / INERTIA - own,
        frame_rate,
        (carried - hung) / CUFFS["frame_inertia"],
    ]


def drop(start, fade, rng):
    """Held at `start`, let go within `fade` s between two samples."""
    gravity, spring, _ = LEG.values()
    sag = -CUFFS["compliance"] * CUFFS["frame_gravity"] * np.cos(start)
    for _ in range(20):  # the frame hangs in its cuffs
        sag = -CUFFS["compliance"] * CUFFS["frame_gravity"] * np.cos(start + sag)
    held = INERTIA * (gravity * np.cos(start) + spring * start) - sag / CUFFS["compliance"]
    release = HOLD + STEP * rng.random()

    def hand(time):
        part = np.clip((time - release) / fade, 0, 1) if fade else 1.0
        return held * (1 + np.cos(np.pi * part)) / 2

    time = np.arange(0, HOLD + LASTING, STEP)
    after = time > release
    at_rest = [start, 0.0, start + sag, 0.0]
    moved = solve_ivp(
        slope, (release, time[-1]), at_rest, t_eval=time[after], args=(hand,), rtol=1e-9, atol=1e-11
    )
    shown = np.concatenate([np.tile(at_rest[2:], (np.sum(~after), 1)).T, moved.y[2:]], axis=1)
    angle, gyro = shown + np.array([[NOISE], [GYRO]]) * rng.standard_normal(shown.shape)
    return Segment(time, raw_angle=angle, raw_angular_velocity=gyro)


@pytest.mark.parametrize("fade", [0.0, 0.04])
@pytest.mark.parametrize("seed", range(2))
def test_the_leg_comes_back_within_its_errors(seed, fade):
    rng = np.random.default_rng(seed)
    recording = Recording(
        tuple(drop(start, fade, rng) for start in STARTS),
        Subject(kind="leg", body_mass=74.0, height=1.78),
        Protocol(kind="passive"),
        Sensors(angle_noise=NOISE, velocity_noise=GYRO),
    )
    found = fit(recording, multistart=4, terms=(CuffCompliance,))
    away = {
        name: (found.ratios[name].value - truth) / found.ratios[name].standard_error
        for name, truth in LEG.items()
    }
    own = found.terms["cuff_compliance"]
    truth = {name: value / INERTIA for name, value in CUFFS.items()}
    truth["compliance"] = CUFFS["compliance"] * INERTIA
    for name, value in truth.items():
        each = own.get(f"{name}_over_inertia") or own[f"{name}_times_inertia"]
        away[name] = (each.value - value) / each.standard_error
    assert found.follows
    assert max(map(abs, away.values())) < LIKELY, away
