"""Fits side by side give what each gives alone, whatever is the matter with it."""

import sys
from dataclasses import replace

import jax
import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.physics.leg import LegModel
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.torque import NoTorque
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.studies.batch.fit_many import fit_many
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, CYCLE, DROP, LOADED, leg, recorded

RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
# Of a standard error. A search ends where a step would change no residual by a hundredth of the
# noise; from other starts it ends elsewhere within that.
CLOSE = 1e-2


def with_friction() -> Recording:
    model = LegModel(leg(), NoTorque(), terms=(CoulombFriction(np.asarray(0.25)),))
    return record(model, [DROP], jax.random.key(5), subject=BODY)


def changed(made: Recording, change) -> Recording:
    return replace(made, segments=tuple(map(change, made.segments)))


def upside_down(made: Recording) -> Recording:
    def turned(each):
        return replace(
            each,
            angle=-each.angle,
            raw_angle=-each.raw_angle,
            angular_velocity=-each.angular_velocity,
            raw_angular_velocity=-each.raw_angular_velocity,
        )

    return changed(made, turned)


def still(made: Recording) -> Recording:
    def held(each):
        nothing = 0.0 * each.angle
        return replace(
            each,
            angle=nothing - 1.0,
            raw_angle=nothing - 1.0,
            angular_velocity=nothing,
            raw_angular_velocity=nothing,
        )

    return changed(made, held)


@pytest.mark.parametrize("count", [0, 1, 7, 8])
def test_of_several_meetings_everybody_has_its_own(count, monkeypatch):
    module = sys.modules[fit_many.__module__]
    monkeypatch.setattr(module, "LANES", 2)
    monkeypatch.setattr(module, "MOST", 3)
    monkeypatch.setattr(module, "frugal_fit", lambda one, options: ValueError(one))
    names = [f"{number}.csv" for number in range(count)]
    assert [str(each) for each in fit_many(names)] == names


@pytest.fixture(scope="module")
def recordings():
    """Plain ones, and what warns or fails."""
    plain = [recorded(DROP, seed=seed, damping=0.2 + 0.1 * seed) for seed in range(3)]
    steep = recorded(Movement(np.radians(-25), 2.3), seed=7, inertia=0.5, stiffness=1.0)
    nobody = recorded(DROP, seed=8, subject=Subject(kind="leg"))
    return {
        **{f"drop {number}": each for number, each in enumerate(plain)},
        "steep": steep,
        "of nobody": nobody,
        "loaded": recorded(DROP, LOADED),
        "cycle": recorded(CYCLE),
        "friction": with_friction(),
        "still": still(plain[0]),
        "upside down": upside_down(plain[0]),
    }


@pytest.fixture(scope="module")
def together(recordings):
    return dict(zip(recordings, fit_many(list(recordings.values())), strict=True))


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        *("drop 0", "drop 1", "drop 2", "steep", "of nobody"),
        *("loaded", "cycle", "friction"),
    ],
)
def test_a_fit_among_others_is_the_fit_alone(recordings, together, name):
    alone, among = fit(recordings[name]), together[name]
    assert among.notes == alone.notes
    assert among.astray == alone.astray
    assert among.disturbance.cause == alone.disturbance.cause
    assert among.noise_scale == pytest.approx(alone.noise_scale, rel=CLOSE)
    for one, other in ((among.ratios, alone.ratios), (among.parameters, alone.parameters)):
        assert one.keys() == other.keys()
        for quantity, each in other.items():
            assert_close(one[quantity], each)


def assert_close(one, other) -> None:
    assert (one.value is None) == (other.value is None)
    assert (one.standard_error is None) == (other.standard_error is None)
    assert one.determined_by == other.determined_by
    if other.value is not None and other.standard_error:
        assert abs(one.value - other.value) < CLOSE * other.standard_error
        assert one.standard_error == pytest.approx(other.standard_error, rel=CLOSE)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "why"), [("still", "."), ("upside down", "gravity comes out upwards")]
)
def test_what_cannot_be_fitted_says_so_in_the_same_words(recordings, together, name, why):
    with pytest.raises(ValueError, match=why) as alone:
        fit(recordings[name])
    assert isinstance(together[name], ValueError)
    assert str(together[name]) == str(alone.value)


@pytest.mark.slow
def test_the_others_of_a_batch_change_no_digit_of_a_fit(recordings, together):
    """A run that was killed goes on in other batches, and must give the same table."""
    fewer = fit_many([recordings[name] for name in ("friction", "drop 2")])
    for name, one in zip(("friction", "drop 2"), fewer, strict=True):
        for quantity, each in together[name].ratios.items():
            assert one.ratios[quantity].value == each.value
            assert one.ratios[quantity].standard_error == each.standard_error
