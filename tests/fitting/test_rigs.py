"""What a rig is said not to have, and a torque of which only the form is known."""

from dataclasses import replace

import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.errors.profile import profiles
from exoid.fitting.estimate import fit
from exoid.fitting.multistart.search_result import scale_told
from exoid.physics.leg import GRAVITY, LegModel
from exoid.physics.torque import MeasuredTorque, NoTorque
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording
from exoid.trust.identify import identify
from fit_cases import NOISE, exact, leg, state

TIME = np.arange(600) * 0.01
AXIS = Subject(kind="rig", gravity="none", spring="none")
INERTIA, DAMPING = 2.0, 3.0  # kg m^2, N m s/rad
ALIKE = 0.01  # of 1: 600 samples of 0.9 mrad beside 0.3 rad tell both to 0.2 %


@pytest.fixture(scope="module")
def axis():
    """A vertical axis that a known torque turns to and fro."""
    torque = 6.0 * np.sin(2 * np.pi * 0.7 * TIME) + 4.0 * np.cos(2 * np.pi * 1.1 * TIME)
    driven = MeasuredTorque(jnp.asarray(TIME), jnp.asarray(torque))
    model = LegModel(leg(1.0, INERTIA, 0.0, DAMPING, 0.0), driven)
    segment = exact(model, state(0.1, -0.2), TIME, applied_torque=torque)
    noise = np.random.default_rng(0).normal(size=(2, TIME.size))
    segment = replace(
        segment,
        raw_angle=segment.raw_angle + NOISE.angle_noise * noise[0],
        raw_angular_velocity=segment.raw_angular_velocity + NOISE.velocity_noise * noise[1],
    )
    return Recording((segment,), AXIS, Protocol(kind="measured"), NOISE)


def test_an_axis_without_gravity_and_spring_has_neither(axis):
    found = fit(axis, multistart=4)
    assert found.parameters["inertia"].value == pytest.approx(INERTIA, rel=ALIKE)
    assert found.parameters["damping"].value == pytest.approx(DAMPING, rel=ALIKE)
    for each in (found.ratios["gravity_over_inertia"], found.ratios["stiffness_over_inertia"]):
        assert each.value == 0.0
        assert each.standard_error == 0.0
        assert each.reason == "the sidecar says that there is none"
    assert found.parameters["stiffness"].value == 0.0
    assert found.leg is not None  # of one fit
    assert found.leg.stiffness == 0.0


def test_of_a_torque_of_unknown_gain_only_what_is_over_the_inertia_is_told(axis):
    """A current of 8 A for every N m: ratios stay, and nothing is said in N m or kg m^2."""
    segment = axis.segments[0]
    current = replace(segment, applied_torque=segment.applied_torque * 8)
    protocol = replace(axis.protocol, torque_known=False)
    found = fit(replace(axis, segments=(current,), protocol=protocol), multistart=4)
    ratio = found.ratios["damping_over_inertia"].value
    assert ratio == pytest.approx(DAMPING / INERTIA, rel=ALIKE)
    for name in ("mass", "inertia", "com_distance", "damping"):
        assert found.parameters[name].value is None
        assert "gain is unknown (torque_known = false)" in (found.parameters[name].reason or "")
    assert "damping_over_inertia" in profiles(found)
    assert not {"mass", "inertia", "damping"} & profiles(found).keys()
    told = identify(found)
    assert "inertia" not in told.combinations
    assert any("unknown gain fixes no scale" in each for each in told.sentences)
    assert not any("varied too little" in each for each in told.sentences)
    assert not any(number in each for each in found.notes for number in (" N m", "kg m^2"))


def test_the_error_of_a_ratio_is_the_same_where_the_gain_is_unknown_and_nothing_tells_the_inertia(
    axis,
):
    protocol = replace(axis.protocol, torque_known=False)
    known, unknown = (fit(each, multistart=4) for each in (axis, replace(axis, protocol=protocol)))
    one, other = (each.ratios["damping_over_inertia"] for each in (known, unknown))
    assert other.value == pytest.approx(one.value, rel=1e-3)
    assert other.standard_error == pytest.approx(one.standard_error, rel=0.05)
    assert unknown.basis is not None
    assert not scale_told(unknown.basis.ended.local.data)


def test_a_torque_that_varies_is_never_said_to_vary_too_little(axis):
    """Here the leg's inertia was fixed by hand: that it is no finding is no fault of the torque."""
    told = identify(fit(axis, multistart=4, fix={"inertia": INERTIA}))
    assert not any("varied too little" in each for each in told.sentences)


def test_a_robots_joint_whose_first_second_tells_nothing_is_followed(shared):
    """It hardly moves at first: a fit to that alone runs away in what its motor does later."""
    path = shared / "real" / "ur10e-joint1.csv"
    if not path.is_file():
        pytest.skip(f"{path} is absent")
    assert fit(path, multistart=2).follows


def test_without_a_mass_no_distance_is_told_however_near_the_axis_it_is():
    """A bar that is balanced but for a known mass: its m l is none, and l is none over any m."""
    arm, masses, inertia = 0.1, (0.5, 1.2), 0.03  # m, kg, kg m^2

    def drop(mass: float):
        loaded = LegModel(leg(mass, inertia + mass * arm**2, arm, 0.02, 0.0), NoTorque())
        return exact(loaded, state(-0.3, 0.0), TIME[:300])

    subject = Subject(
        kind="rig",
        spring="none",
        added_mass=masses,
        added_mass_distance=(arm, arm),
        added_mass_gyration=0.0,
    )
    segments = tuple(map(drop, masses))
    found = fit(Recording(segments, subject, Protocol(kind="passive"), NOISE), multistart=4)
    assert found.parameters["inertia"].value == pytest.approx(inertia, rel=ALIKE)
    for name in ("mass", "com_distance"):
        assert found.parameters[name].value is None
        assert "only the product m l" in (found.parameters[name].reason or "")


def test_with_the_same_mass_always_on_it_no_ratio_of_the_bare_rig_is_told():
    """Motion shows the two together: of the bare one it was told what the search began with."""
    loaded = leg(1.7, 0.158, 0.265, 0.02, 0.0).with_added_mass(*map(jnp.asarray, (0.5, 0.38)))
    drops = tuple(
        exact(LegModel(loaded, NoTorque()), state(start), TIME[:400]) for start in (-0.2, -0.5)
    )
    subject = Subject(kind="rig", spring="none", added_mass=0.5, added_mass_distance=0.38)
    found = fit(Recording(drops, subject, Protocol(kind="passive"), NOISE), multistart=2)
    for name in ("gravity_over_inertia", "damping_over_inertia"):
        assert found.ratios[name].value is None
        assert "a drop without it" in (found.ratios[name].reason or "")
    assert found.ratios["stiffness_over_inertia"].value == 0.0
    alone = replace(subject, added_mass=None, added_mass_distance=None)
    both = fit(Recording(drops, alone, Protocol(kind="passive"), NOISE), multistart=2)
    gravity = GRAVITY * float(loaded.mass * loaded.com_distance / loaded.inertia)
    assert both.ratios["gravity_over_inertia"].value == pytest.approx(gravity, rel=ALIKE)


@pytest.mark.slow
@pytest.mark.parametrize("zero_deg", [0.0, -4.0])
def test_a_known_mass_tells_the_inertia_of_a_pendulum_that_hardly_loses_energy(zero_deg):
    """With a wrong inertia its loaded drop is out of step after seconds, and no step leads back."""
    bare, loads, time = leg(1.7, 0.158, 0.265, 0.02, 0.0), (0.0, 0.0, 0.5), np.arange(1200) * 0.01
    noise = np.random.default_rng(3).normal(size=(len(loads), time.size))
    drops = [
        exact(
            LegModel(bare.with_added_mass(*map(jnp.asarray, (load, 0.38))), NoTorque()),
            state(-0.2),
            time,
        )
        for load in loads
    ]
    seen = tuple(
        replace(
            drop,
            raw_angle=drop.raw_angle + np.radians(zero_deg) + NOISE.angle_noise * own,
            raw_angular_velocity=None,
        )
        for drop, own in zip(drops, noise, strict=True)
    )
    subject = Subject(
        kind="rig",
        spring="none",
        added_mass=loads,
        added_mass_distance=0.38,
        added_mass_gyration=0.0,
    )
    found = fit(Recording(seen, subject, Protocol(kind="passive"), NOISE), multistart=4)
    inertia, gravity = found.parameters["inertia"], found.ratios["gravity_over_inertia"]
    assert found.follows
    assert inertia.value == pytest.approx(0.158, rel=0.015)  # a mass is known to 0.5 %
    assert gravity.value == pytest.approx(1.7 * 0.265 * GRAVITY / 0.158, rel=1e-3)  # clock: 0.02 %
