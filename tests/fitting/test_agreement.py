"""When a fit follows: by what it misses beyond the noise, beside how far the leg moves."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.fitting.misfit.missed import Disturbance, Missed
from exoid.fitting.result.agreement import astray, of_the_rest, of_unlike
from exoid.fitting.result.refused.notes import of_causes
from exoid.fitting.result.remarks.rig_words import of_rig
from exoid.fitting.result.segment_fit import SegmentFit

TIME = np.arange(300) * 0.01
SWING = -1.3 + 1.0 * np.exp(-0.5 * TIME) * np.cos(5.4 * TIME)  # moves by 25 deg


def segment(missed: float, noise: float = 8e-4, size: float = 1.0, name: str = "0") -> SegmentFit:
    """A fit that misses a swing by `missed` [rad]."""
    angle = size * SWING
    return SegmentFit(
        name=name,
        kind="passive",
        period=None,
        torque_amplitude=None,
        added_mass=0.0,
        angle_rmse=missed,
        velocity_rmse=None,
        angle_noise=noise,
        velocity_noise=None,
        time=TIME,
        angle=angle,
        angular_velocity=None,
        simulated_angle=angle + missed,
        simulated_velocity=np.zeros_like(angle),
    )


MOVED = float(np.std(SWING))


def test_what_follows_within_the_noise_follows():
    assert astray([segment(8e-4)]) is None
    assert astray([segment(0.05, noise=0.05)]) is None  # a camera's noise is not missed


def test_missing_physics_is_no_reason_to_refuse_a_fit():
    assert astray([segment(0.08 * MOVED)]) is None  # of a real leg's tone and friction: 0.06


@pytest.mark.parametrize("share", [0.15, 0.5, 1.0])
def test_another_motion_is_named_with_both_sizes(share):
    why = astray([segment(share * MOVED)])
    assert f"misses the angle by {np.degrees(share * MOVED):.3g} deg" in why
    assert f"the leg moves by {np.degrees(MOVED):.3g} deg" in why


def test_a_simulation_that_runs_away_is_not_told_as_a_miss_of_so_many_degrees():
    """Of a spastic leg that moves by 11 deg, one that went round missed "215 deg"."""
    why = astray([segment(19 * MOVED)])
    assert "runs away" in why
    assert "misses" not in why
    assert f"{np.degrees(MOVED):.3g} deg" in why


def test_a_leg_that_is_not_followed_may_answer_its_stretch_but_no_rig_does():
    assert "stretch_reflex" in of_causes({"passive"}, rig=False)
    assert "stretch" not in of_causes({"passive"}, rig=True)


def test_a_rig_is_not_called_a_leg():
    said = "the recording begins as the leg is let go, as a leg is. Legs and my leg.csv stay."
    of = "the recording begins as the rig is let go, as a rig is. Legs and my leg.csv stay."
    assert of_rig(said) == of


def test_noise_does_not_excuse_another_motion():
    assert astray([segment(0.5 * MOVED, noise=0.1 * MOVED)]) is not None


def test_one_segment_among_many_that_is_not_followed_is_named():
    good = [segment(8e-4, name=str(number)) for number in range(20)]
    lost = segment(0.35 * MOVED, name="of another leg")
    assert astray([*good, lost]).startswith("in segment of another leg it misses")


def test_on_a_limit_less_is_enough_for_then_it_is_not_the_physics():
    few = segment(0.05 * MOVED)
    assert astray([few]) is None
    assert astray([few], ["the limit that J is so"]).endswith("held by the limit that J is so")
    assert astray([segment(0.05 * MOVED, noise=0.01 * MOVED)], ["m"]) is None  # 5 times the noise


def test_a_leg_that_hardly_moves_is_followed_by_its_noise():
    assert astray([segment(8e-4, size=1e-6)]) is None


def weighed(alone: float = 1.9) -> Disturbance:
    """Passive segments count, measured ones a hundredth of them, which alone are explained."""
    none = Missed(None, 0.1, 0.0, 1.0, 0.0)
    both = ("passive", "measured")
    scales = {"passive": 1.0, "measured": 100.0}
    left = {"passive": 1.0, "measured": alone}
    return Disturbance(dict.fromkeys(both, none), scales, np.eye(1), np.ones(1), left)


def test_kinds_that_a_leg_of_their_own_explains_are_told_where_one_leg_does_not():
    """A torque zero that is off made a miss of 46 times the noise, and notes of none."""
    good, found = segment(8e-4), weighed()
    assert of_unlike([good, replace(segment(8e-4 * 2), kind="measured")], found) == []
    (said,) = of_unlike([good, replace(segment(8e-4 * 46), kind="measured")], found)
    assert "the measured ones are missed by 2.1 deg, 46 times the noise" in said
    # what it would miss alone, too, is physics that a model lacks
    assert of_unlike([good, replace(segment(8e-4 * 46), kind="measured")], weighed(40.0)) == []


def test_what_is_believed_is_only_said_to_be_explained_where_it_is():
    far, near = (replace(segment(missed), kind="passive") for missed in (8e-3, 8e-4))
    away = replace(segment(0.2), kind="measured")
    assert "because the others are explained." in of_the_rest([near, away], weighed())[0]
    (said,) = of_the_rest([far, away], weighed())
    assert "missed by less, 0.46 deg, which is still 10 times the noise" in said


@pytest.mark.parametrize(
    ("of_a_leg", "own"),
    [
        ("the seat's tilt, or a foot before the leg's line, limits J", "the base's tilt limits J"),
        ("tilts the thigh: give thigh_angle_deg", "tilts the base: give thigh_angle_deg"),
        ("from the axis of the knee, 0.2 m from the knee", "from the axis, 0.2 m from the axis"),
    ],
)
def test_a_rig_has_neither_seat_nor_thigh_nor_knee(of_a_leg, own):
    assert of_rig(of_a_leg) == own
