"""Kinds of segments weighed by what each misses, over motions that SciPy integrates."""

from functools import cache

import jax
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from exoid.fitting.estimate import fit
from exoid.fitting.result.agreement import of_the_rest
from exoid.fitting.solve.program_cache import run
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.trust.identify import identify

BODY = Subject(kind="leg", body_mass=74.0, height=1.78)
GRAVITY, STIFFNESS, DAMPING = 26.5, 7.0, 0.9  # 1/s^2, 1/s^2, 1/s: over the inertia
TRUE = {
    "gravity_over_inertia": GRAVITY,
    "stiffness_over_inertia": STIFFNESS,
    "damping_over_inertia": DAMPING,
}
NOISE = Sensors(angle_noise=8.7e-4, velocity_noise=1.8e-3)
CAMERA = Sensors(angle_noise=np.radians(0.5))
PERIODS = (1.3, 1.7)
EFFORTS = (-14.0, -11.0)  # tau / J, 1/s^2
SEGMENTS = ((-0.3, np.nan), (-0.1, PERIODS[0]), (-0.1, PERIODS[1]))


def rehearsed(time, angle, period, effort):
    """Eq. 10 with f = 1/T."""
    sine = np.sin(2 * np.pi * time / period)
    return effort * np.where(time <= period / 2, -sine, sine)


def own_way(time, angle, period, effort):
    """As nobody is told to: with a third harmonic, and a push at the start."""
    third = 0.35 * np.sin(6 * np.pi * time / period + 0.8)
    return rehearsed(time, angle, period, effort) + effort * (third + 0.3 * np.exp(-time / 0.1))


def stiffened(time, angle, period, effort):
    """By muscles that are at work: such cycles alone are those of another leg, to the noise."""
    return rehearsed(time, angle, period, effort) - 0.3 * STIFFNESS * angle


def kicked(time, angle, period, effort):
    """Up at once, and down again: no cosine is like it."""
    return 0.4 * effort * np.sign(np.sin(4 * np.pi * time / period))


def calm(time, angle, velocity):
    return 0.0


def twitching(time, angle, velocity):
    """What no passive leg does: a reflex, tens of milliseconds after the release, and friction."""
    return 4.0 * np.exp(-(((time - 0.35) / 0.06) ** 2)) - 0.3 * np.tanh(velocity / 0.05)


def swing(start, period, torque, reflex, tilt):
    """Angle [rad] and angular velocity at 100 Hz."""
    number = PERIODS.index(period) if period in PERIODS else 0

    def change(time, state):
        angle, velocity = state
        push = reflex(time, angle, velocity)
        if not np.isnan(period):
            push = torque(time, angle, period, EFFORTS[number])
        return velocity, push - GRAVITY * np.cos(
            angle + tilt
        ) - STIFFNESS * angle - DAMPING * velocity

    time = np.arange(0.0, 2.4 if np.isnan(period) else period, 0.01)
    span = (0.0, time[-1] + 1e-9)
    solved = solve_ivp(change, span, (start, 0.0), "DOP853", time, rtol=1e-10, atol=1e-10)
    return time, solved.y


@cache
def recorded(
    torque=rehearsed,
    reflex=calm,
    sensors=NOISE,
    seed=0,
    kinds=("passive", "active"),
    tilt=0.0,
    drops=1,
):
    """Drops and two cycles, or only those of these kinds."""
    rng = np.random.default_rng(seed)
    segments, said = [], []
    for start, period in [*SEGMENTS[:1] * (drops - 1), *SEGMENTS]:
        time, (angle, velocity) = swing(start, period, torque, reflex, tilt)
        angle = angle + sensors.angle_noise * rng.normal(size=time.size)
        gyro = None
        if sensors.velocity_noise:
            gyro = velocity + sensors.velocity_noise * rng.normal(size=time.size)
        kind = "passive" if np.isnan(period) else "active"
        if kind in kinds:
            segments.append(Segment(time, raw_angle=angle, raw_angular_velocity=gyro))
            said.append((kind, period))
    protocol = Protocol(
        kind=tuple(kind for kind, _ in said),
        cycle_period=tuple(period for _, period in said),
        torque_frequency="1/T",
    )
    return Recording(tuple(segments), BODY, protocol, sensors)


def fitted(*arguments, **options):
    return fit(recorded(*arguments, **options), multistart=6)


@pytest.mark.parametrize("sensors", [NOISE, CAMERA], ids=["exoskeleton", "camera"])
@pytest.mark.parametrize("torque", [own_way, stiffened])
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.proof)])
def test_bad_cycles_neither_move_nor_widen_what_a_good_drop_tells(torque, sensors, seed):
    both = fitted(torque, sensors=sensors, seed=seed)
    drop = fitted(torque, sensors=sensors, seed=seed, kinds=("passive",))
    for name, truth in TRUE.items():
        found, alone = both.ratios[name], drop.ratios[name]
        assert abs(found.value - alone.value) < alone.standard_error, name
        assert found.standard_error < 1.2 * alone.standard_error, name
        # Three standard errors: once in 370, and nothing here is drawn anew.
        assert abs(found.value - truth) < 3 * found.standard_error, name
        assert found.shares.kind == "passive"
    # Of tau / J cycles tell most; where a camera leaves the zero open, a drop tells the fifth of it
    # that goes with c / J, and no one kind is named.
    named = ("active",) if sensors is NOISE else ("active", None)
    torque = both.ratios["torque_over_inertia"]
    followed = not of_the_rest(both.segments, both.disturbance)  # else nothing tells it
    assert torque.shares.kind in named if followed else torque.shares is None
    assert both.disturbance.kinds["passive"].cause is None
    assert both.disturbance.kinds["active"].cause is not None
    assert any("divided by" in note and "active" in note for note in both.notes)


@pytest.mark.parametrize("sensors", [NOISE, CAMERA], ids=["exoskeleton", "camera"])
def test_what_cycles_tell_that_are_not_followed_is_not_told(sensors):
    """With a camera the drop tells a part of tau / J, too, by the zero of both."""
    both = fitted(kicked, sensors=sensors)
    assert both.follows
    drop, *cycles = both.segments
    assert min(each.angle_rmse for each in cycles) > np.radians(4)
    assert drop.torque_amplitude is None
    each = [both.ratios["torque_over_inertia"], both.torque_amplitude]
    for torque in (*each, *(one.torque_amplitude for one in cycles)):
        assert (torque.value, torque.standard_error, torque.determined_by) == (None, None, None)
        assert torque.reason.startswith("the simulation does not follow the active segments")
    for name, truth in TRUE.items():
        assert abs(both.ratios[name].value - truth) < 3 * both.ratios[name].standard_error
    assert list(identify(both).combinations) == list(TRUE)


@pytest.mark.parametrize("tilt", np.radians([-4.0, 4.0]))
def test_drops_tell_of_a_tilted_seat_beside_cycles_that_nobody_follows(tilt):
    both = fitted(kicked, tilt=tilt, drops=2)
    assert both.follows
    assert both.mountings[0].tilt.value == pytest.approx(tilt, abs=np.radians(1.5))
    for name, truth in TRUE.items():
        found = both.ratios[name]
        assert abs(found.value - truth) < 3 * found.standard_error, name
        assert found.standard_error < 0.1 * truth, name
    assert all(each.angle_rmse < 1.2 * each.angle_noise for each in both.segments[:2])


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.proof)])
def test_a_bad_drop_neither_moves_nor_widens_what_good_cycles_tell(seed):
    both = fitted(reflex=twitching, seed=seed)
    cycles = fitted(reflex=twitching, seed=seed, kinds=("active",))
    for name, truth in TRUE.items():
        found, alone = both.ratios[name], cycles.ratios[name]
        assert abs(found.value - alone.value) < alone.standard_error, name
        assert found.standard_error < 1.2 * alone.standard_error, name
        assert abs(found.value - truth) < 3 * found.standard_error, name
        assert found.shares.kind == "active"


@pytest.mark.parametrize(
    "seed", [0, *(pytest.param(each, marks=pytest.mark.proof) for each in (1, 2, 3))]
)
def test_where_nothing_is_missed_all_count_alike(seed):
    found = fitted(seed=seed)
    assert found.disturbance.cause is None
    assert not found.disturbance.apart
    for name, truth in TRUE.items():
        assert abs(found.ratios[name].value - truth) < 3 * found.ratios[name].standard_error


def content(arrays):
    return b"".join(np.asarray(each).tobytes() for each in arrays)


def test_nothing_is_solved_twice(monkeypatch):
    """Where a kind of segments ends by itself is known from when all kinds were compared."""
    asked = []

    def noting(starts, request, *same):
        lanes = zip(*(np.asarray(leaf) for leaf in jax.tree.leaves((starts, request))), strict=True)
        given = content(jax.tree.leaves(same))
        asked.extend({content(lane) + given for lane in lanes})
        return run(starts, request, *same)

    monkeypatch.setattr("exoid.fitting.solve.ask.run", noting)
    both = fitted(own_way)
    assert both.disturbance.apart
    assert len(asked) == len(set(asked))
