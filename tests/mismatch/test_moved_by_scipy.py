"""Legs that SciPy moved, each with one thing that Eq. 9 leaves out."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.mismatch.missing_physics import diagnose
from hands import Device, Hand, Knee, dropped

pytestmark = pytest.mark.proof

ENCODER = Device(rate=200.0, noise=1e-3, gyro=5e-3)
STARTS = (-0.05, -0.3, -0.5)  # rad
FRICTION = {"coulomb_friction", "stribeck_friction"}
CONSTANT = {"torque_bias", "stiffness_rest_angle"}  # the same torque
CONTACT, RATIO = 0.03, 0.5  # s that the stop's spring holds the leg, and its damping ratio


@dataclass(frozen=True)
class Stopped(Knee):
    """A spring and damper push the leg back from an angle on; they never pull."""

    angle: float = -1.0  # rad

    def pull(self, angle, rate):
        stiff = np.pi / CONTACT
        push = stiff**2 * (self.angle - angle) - 2 * RATIO * stiff * rate
        return super().pull(angle, rate) + np.where(angle < self.angle, np.maximum(push, 0.0), 0.0)


@dataclass(frozen=True)
class Rubbing(Knee):
    """Dry friction that passes through zero near rest, so that the leg creeps."""

    friction: float = 0.8  # 1/s^2
    creep: float = 5e-3  # rad/s

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.friction * np.tanh(rate / self.creep)


@dataclass(frozen=True)
class Manifold(Rubbing):
    """Dry friction, drag, and a spring that rests at another angle than 0, all at once."""

    friction: float = 0.7  # 1/s^2
    drag: float = 0.15
    rest: float = -0.5  # rad

    def pull(self, angle, rate):
        pushed = self.stiffness * self.rest - self.drag * rate * np.abs(rate)
        return super().pull(angle, rate) + pushed


def check_leg(found, knee: Knee) -> None:
    """Its ratios are right within their errors."""
    for name in ("gravity", "stiffness", "damping"):
        one = found.fit.ratios[f"{name}_over_inertia"]
        assert abs(one.value - getattr(knee, name)) < 3 * one.standard_error


def test_three_causes_at_once_are_named_and_the_leg_is_right():
    """Where a leg creeps so little that noise hides it, nothing but noise is left."""
    knee = Manifold(creep=1e-3)
    found = diagnose(session(knee), multistart=8)
    assert found.verdict == "mismatch"
    assert "quadratic_drag" in found.selected
    assert set(found.selected) & FRICTION
    assert set(found.selected) & CONSTANT  # a spring's rest is the same torque as a constant one
    assert set(found.selected) <= FRICTION | CONSTANT | {"quadratic_drag"}
    assert found.proof.after.total < found.proof.before.total / 5
    check_leg(found, knee)


def test_of_three_causes_none_is_named_for_another_where_the_leg_creeps():
    """A third of the noise is left, which no third cause need explain: errors hold it."""
    knee = Manifold()
    found = diagnose(session(knee), multistart=8)
    assert found.verdict == "mismatch"
    assert set(found.selected) <= FRICTION | CONSTANT | {"quadratic_drag"}
    assert set(found.selected) & FRICTION
    check_leg(found, knee)


@dataclass(frozen=True)
class Tilted(Knee):
    """On a seat whose front is higher."""

    tilt: float = np.radians(8.0)

    def pull(self, angle, rate):
        level = self.gravity * (np.cos(angle + self.tilt) - np.cos(angle))
        return super().pull(angle, rate) - level


def session(knee: Knee, seed: int = 0, fade: float = Hand.fade):
    """Three drops of it."""
    each = [
        dropped(knee, Hand(start, hold=0.6, fade=fade), ENCODER, lasting=6.0, seed=seed + number)[0]
        for number, start in enumerate(STARTS)
    ]
    return replace(each[0], segments=tuple(one.segments[0] for one in each))


@pytest.mark.parametrize("angle", [-85.0, -100.0])
def test_a_stop_is_no_reflex(angle):
    """The leg hangs at -76 deg; swinging beyond, it touches the stop for some 30 ms.

    At -85 deg it bounces in every swing, and Eq. 9 moves otherwise altogether. No leg comes to the
    stop of extension: where that lies is not said.
    """
    found = diagnose(session(Stopped(angle=np.radians(angle))), multistart=8)
    assert (found.verdict, found.selected) == ("mismatch", ["hard_stop"])
    stop = {each.name.partition(".")[2]: each for each in found.parameters}
    flexion, contact = stop["flexion_angle"], stop["contact_time"]
    assert abs(flexion.value - np.radians(angle)) < 4 * flexion.standard_error
    assert abs(contact.value - CONTACT) < 4 * contact.standard_error + 1e-4
    assert stop["extension_angle"].standard_error is None


def test_friction_is_as_finely_simulated_as_its_pairs():
    """A pair would win by its finer steps alone, with a second cause of no size."""
    found = diagnose(session(Rubbing()), multistart=8)
    assert found.verdict == "mismatch"
    assert found.selected in (["coulomb_friction"], ["stribeck_friction"])
    assert not any("+" in each for each in found.equivalent)


def test_a_tilted_thigh_is_one_cause_and_not_two():
    """By itself it is an offset and a rest angle that are opposite."""
    found = diagnose(session(Tilted()), multistart=8)
    assert (found.verdict, found.selected) == ("mismatch", ["angle_offset"])
    offset = {each.name: each for each in found.parameters}["angle_offset.offset"]
    assert abs(abs(offset.value) - np.radians(8.0)) < 3 * offset.standard_error


@dataclass(frozen=True)
class Sprung(Knee):
    """Its spring rests at another angle than 0."""

    rest: float = -0.5  # rad

    def pull(self, angle, rate):
        return super().pull(angle, rate) + self.stiffness * self.rest


@pytest.mark.parametrize(("damping", "verdict"), [(3.0, "cannot_tell"), (7.0, "none")])
def test_a_leg_that_a_hidden_cause_would_change_is_not_called_certain(damping, verdict):
    """Damped so strongly, a leg hardly tells a spring that rests elsewhere from another gravity."""
    knee = Sprung(28.0, 1.5, damping)
    recording = session(knee)
    found, alone = diagnose(recording, multistart=8), fit(recording, multistart=8)
    assert found.verdict == verdict
    assert "stiffness rest angle" in " ".join(found.reasons)
    for name in ("gravity", "stiffness", "damping"):
        one = found.fit.ratios[f"{name}_over_inertia"]
        assert abs(one.value - getattr(knee, name)) < 3 * one.standard_error
    gravity = alone.ratios["gravity_over_inertia"]
    assert abs(gravity.value - knee.gravity) > 10 * gravity.standard_error
