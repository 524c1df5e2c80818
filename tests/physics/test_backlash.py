"""Play against two bodies that SciPy moves, and against what must hold for any two bodies."""

from dataclasses import replace
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from jax.flatten_util import ravel_pytree

import two_bodies
from exoid.physics.leg import GRAVITY, LegModel, LegParameters
from exoid.physics.moment import Cycle, Moment, SegmentConstants
from exoid.physics.motion.simulate import simulate
from exoid.physics.ratios import Ratios
from exoid.physics.state import LegState
from exoid.physics.terms.device.backlash import Backlash
from exoid.physics.torque import NoTorque

LEG = two_bodies.Leg()
FRAMES = {
    "usual": two_bodies.Frame(),
    "heavy": two_bodies.Frame(0.0262, 0.02, 1.0, 0.1, 0.05, 1200.0, 0.8),
    "light": two_bodies.Frame(0.0087, 0.006, 0.25, 0.02, 0.01, 500.0, 0.5),
    "sticking": two_bodies.Frame(0.0175, 0.010, 0.3, 0.15, 0.03, 400.0, 0.7),
    "smooth": two_bodies.Frame(0.02, 0.015, 0.8, 0.0, 0.04, 800.0, 0.5),
}
START, LASTING = -0.4, 3.0


def term(frame: two_bodies.Frame) -> Backlash:
    contact = np.pi * np.sqrt(frame.inertia / frame.stiffness)
    own = (frame.half_play, frame.inertia, frame.gravity, frame.friction, frame.damping)
    made: Any = Backlash  # whose parameters are its own
    return made(*map(jnp.asarray, (*own, contact, frame.damping_ratio)))


@jax.jit
def moved(own: Backlash, time, start=START):
    away = 0.25  # m
    body = (LEG.gravity / (away * GRAVITY), LEG.inertia, away, LEG.damping, LEG.stiffness)
    leg = LegParameters(*map(jnp.asarray, body))
    begin = LegState(jnp.asarray(start), jnp.asarray(0.0))
    return simulate(LegModel(leg, NoTorque(), terms=(own,)), begin, time)


def both(monkeypatch, name: str, rate: int):
    """The frame's angle by SciPy and by the term; the first sticks within 0.05 mrad/s."""
    monkeypatch.setattr(two_bodies, "DEEP", 1e-7)
    monkeypatch.setattr(two_bodies, "CREEP", 5e-5)
    time = np.arange(round(LASTING * rate) + 1) / rate
    truth = two_bodies.motion(LEG, FRAMES[name], START, time)
    return truth, moved(term(FRAMES[name]), jnp.asarray(time))


@pytest.mark.parametrize("name", FRAMES)
@pytest.mark.parametrize("rate", [50, 100])
def test_leg_and_frame_move_as_two_bodies(monkeypatch, name, rate):
    truth, found = both(monkeypatch, name, rate)
    slip = np.abs(truth[2] - truth[0])
    assert (slip < 0.9 * FRAMES[name].half_play).sum() > 0.1 * rate  # they part
    missed = np.asarray(found.shown_angle) - truth[2]
    # A tenth of an encoder's step, at 50 Hz a fifth, where parts are 3 ms of a contact of 10. At
    # its worst after impacts of a heavy frame.
    within = 3e-4 if rate == 50 else 1.5e-4
    assert np.sqrt(np.mean(missed**2)) < within
    assert np.abs(missed).max() < 7 * within


def test_without_friction_the_error_falls_with_the_cube_of_the_step(monkeypatch):
    """At worst: a contact begins where it is foreseen, and ends within a part of a step."""
    missed = []
    for rate in (50, 100):
        truth, found = both(monkeypatch, "smooth", rate)
        missed.append(np.abs(np.asarray(found.shown_angle) - truth[2]).max())
    assert missed[0] < 1e-4
    assert missed[1] < missed[0] / 8


@pytest.mark.parametrize("name", FRAMES)
def test_derivatives_are_finite_and_those_of_differences(name):
    """For half a second, within which leg and frame part and meet again."""
    time, own = jnp.arange(51) / 100, term(FRAMES[name])
    values, back = ravel_pytree(own)

    def shown(values):
        return moved(back(values), time).shown_angle

    slope = np.asarray(jax.jacfwd(shown)(values))
    assert np.isfinite(slope).all()
    for number, value in enumerate(values):
        step = 1e-6 * max(float(value), 1e-3)
        away = jnp.zeros_like(values).at[number].set(step)
        expected = np.asarray(shown(values + away) - shown(values - away)) / (2 * step)
        size = np.abs(expected).max()
        if number != 3 or FRAMES[name].friction > 0:  # from no friction it goes one way only
            # A part of a step in which a kink lies counts on one side of it.
            np.testing.assert_allclose(slope[:, number], expected, rtol=0, atol=0.02 * size + 1e-6)


def test_a_frame_that_nothing_moves_stays_in_its_play():
    """Dry friction of 0.5 N m holds 0.3 N m, for a second."""
    own = term(replace(FRAMES["sticking"], half_play=0.09, friction=0.5))
    now, step = standing(-0.4), 5e-4

    def part(_, memory):
        return own.memory_within(now, memory + step * own.memory_rate(now, memory))

    slip, speed, _ = jax.jit(lambda: jax.lax.fori_loop(0, 2000, part, jnp.zeros(3)))()
    assert abs(slip) < 5e-5  # rad, by which what holds gives way
    assert abs(speed) < 1e-9


def standing(angle: float) -> Moment:
    """A leg that is held still."""
    ratios = Ratios(*map(jnp.asarray, (27.0, 6.0, 0.8, 0.0)))
    cycle = Cycle(*map(jnp.asarray, (0.0, 1.0, 1.0, 0.0)))
    place = SegmentConstants(ratios, jnp.asarray(LEG.inertia), cycle, jnp.asarray(0.0))
    return Moment(*map(jnp.asarray, (0.0, angle, 0.0, 0.0)), place=place)
