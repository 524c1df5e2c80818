"""Torques without a name keep what has one from standing in for them; legs by SciPy."""

from dataclasses import dataclass, replace
from types import SimpleNamespace

import jax
import numpy as np
import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.cli.inputs.terms import rivals_in
from exoid.mismatch import stand_in
from exoid.mismatch.answer.diagnosis import Suspect
from exoid.mismatch.conclude.asserted import certain_of, same_cause
from exoid.mismatch.conclude.verdict.undecided import undecided
from exoid.mismatch.missing_physics import diagnose
from exoid.mismatch.novel.nameless import NAMELESS, FadingTorque, SaturatingDamping
from exoid.mismatch.stand_in import leading, with_nameless
from exoid.physics.library import library
from exoid.physics.parameter import parameter
from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.term import PhysicsTerm, name_of
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement
from hands import Device, Hand, Knee, dropped

POTENTIOMETER = Device(rate=100.0, noise=2.5e-3, gyro=None)
STARTS = (-0.1, -0.5)  # rad
MIDDLE = -1.4  # rad


@dataclass(frozen=True)
class Outward(Knee):
    """Damped more at the ends of its swings."""

    outward: float = 0.4  # 1/s/rad^2

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.outward * (angle - MIDDLE) ** 2 * rate


@dataclass(frozen=True)
class Saturating(Knee):
    """Damped by the root of the rate, which holds no leg."""

    saturating: float = 0.3  # (1/s^3/rad)^(1/2)

    def pull(self, angle, rate):
        return super().pull(angle, rate) - self.saturating * np.sign(rate) * np.sqrt(np.abs(rate))


def test_none_of_them_is_a_cause_of_the_library_or_a_form_of_one():
    assert not set(NAMELESS) & set(library())
    for one in NAMELESS:
        assert not any(same_cause(one, other) for other in (*library(), *NAMELESS) if other != one)


class Brake(PhysicsTerm):
    """A user's own, which is one of them by another name."""

    title = reference = explanation = isolate = "an eddy brake"
    torque = SaturatingDamping.torque

    saturating: jax.Array = parameter("k", "N m", 0.0, 5.0, "torque at 1 rad/s", (0.1,))


@pytest.mark.parametrize("term", [Brake, GyroScale])
def test_they_take_no_place_of_a_users_own_term_or_of_a_sensors_error(term):
    best = explaining(1000.0, term)
    found = found_of([best])
    assert with_nameless(found, best) is found


def test_a_plan_is_asked_to_tell_named_causes_apart():
    suspected = [Suspect([name], []) for name in ("coulomb_friction", "saturating_damping")]
    assert rivals_in(SimpleNamespace(suspected=suspected)) == ["coulomb_friction"]


def test_where_one_explains_as_much_the_reason_says_that_it_has_no_name():
    best, rival = (explaining(1000.0, term) for term in (CoulombFriction, SaturatingDamping))
    found = found_of([best, rival])
    assert certain_of(found, best) == ()
    (why,) = undecided(found, [best, rival])
    assert why.startswith("saturating damping, a simple torque that the library does not name")


def test_the_numbers_are_those_of_the_set_that_refutes_another_though_a_part_has_no_name():
    named = explaining(2.3 * SAMPLES, CoulombFriction, MaxwellElement)
    better = explaining(1.4 * SAMPLES, CoulombFriction, FadingTorque)
    found = found_of([], [named, better])
    assert leading(found, named) is better
    assert certain_of(found, better) == (CoulombFriction,)


def test_what_has_a_name_stays_where_it_is_as_good_or_all_that_has_one():
    """What both leave over the noise may tell 0.1 of it apart; beside nothing certain a torque
    without a name says nothing of the leg.
    """
    named = explaining(1.5 * SAMPLES, CoulombFriction, MaxwellElement)
    alike = explaining(1.4 * SAMPLES, CoulombFriction, FadingTorque)
    assert leading(found_of([], [named, alike]), named) is named
    lone, other = explaining(2.3 * SAMPLES, CoulombFriction), explaining(SAMPLES, FadingTorque)
    assert leading(found_of([lone, other]), lone) is lone


def test_all_of_them_are_tried_where_more_than_noise_is_left(monkeypatch):
    """To first order nobody sees how fast friction fades: from the start that is far off."""
    far = [(1e6, explaining(1e6, term).candidate) for term in sorted(NAMELESS, key=name_of)]
    monkeypatch.setattr(stand_in, "beside_free", lambda *_: far)
    worse, noise = (explaining(left, CoulombFriction) for left in (4.0 * SAMPLES, 1.0 * SAMPLES))
    found = found_of([worse, noise])
    monkeypatch.setattr(found.prepared, "samples", SAMPLES)
    assert len(stand_in.near(found, worse, worse)) == len(NAMELESS)
    assert stand_in.near(found, noise, noise) == []


@pytest.mark.proof
@pytest.mark.parametrize("knee", [Outward(damping=0.8), Saturating()], ids=["outward", "root"])
def test_no_name_is_claimed_for_damping_that_has_none(knee):
    """Drag and dry friction explained these down to the noise, each by itself."""
    parts = [
        dropped(knee, Hand(start, fade=0.0), POTENTIOMETER, seed=seed, lasting=5.0)[0]
        for seed, start in enumerate(STARTS)
    ]
    session = replace(parts[0], segments=tuple(one.segments[0] for one in parts))
    found = diagnose(session, multistart=8)
    assert found.verdict != "mismatch", found.selected
