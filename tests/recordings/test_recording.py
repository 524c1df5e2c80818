"""What a Recording refuses, and what it answers about its segments."""

import re
import subprocess
import sys

import numpy as np
import pytest

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.declared.unit_hint import unit_hint
from exoid.recordings.measured.bad_sample import BadSample
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording


def swing(count=5, **channels):
    return Segment(np.arange(count) * 0.01, angle=np.linspace(-0.1, -1.5, count), **channels)


def changed(samples, at, value):
    samples = samples.copy()
    samples[at] = value
    return samples


def test_a_segment_lists_what_was_measured_time_first():
    segment = swing(raw_angle=np.zeros(5), extra_columns={"marker": ("a",) * 5})
    assert list(segment.channels()) == ["time", "angle", "raw_angle"]


def test_metadata_holds_for_all_segments_or_for_each():
    recording = Recording(
        (swing(), swing()),
        Subject(added_mass=(0.0, 1.0), added_mass_distance=0.4),
        Protocol(kind=("passive", "active"), cycle_period=2.5),
    )
    assert [recording.kind(n) for n in (0, 1)] == ["passive", "active"]
    assert [recording.cycle_period(n) for n in (0, 1)] == [2.5, 2.5]
    assert [recording.added_mass(n) for n in (0, 1)] == [0.0, 1.0]
    assert recording.added_mass_distance(1) == 0.4


def test_unknown_metadata_stays_unknown():
    recording = Recording((swing(),))
    assert recording.kind(0) is None
    assert recording.cycle_period(0) is None
    assert recording.added_mass_distance(0) is None
    assert recording.added_mass(0) == 0.0


def test_a_recording_without_segments_is_refused():
    with pytest.raises(ValueError, match="at least one segment"):
        Recording(())


@pytest.mark.parametrize(
    ("segment", "message"),
    [
        (Segment(np.zeros(1), angle=np.zeros(1)), r"segment 0 has 1 sample;"),
        (Segment(np.arange(3.0)), "segment 0 has no angle"),
        (Segment(np.arange(3.0), angle=np.zeros(2)), r"has shape \(2,\), but time_s has 3"),
        (swing(extra_columns={"marker": ("a",)}), "marker in segment 0 has 1 cells, but time_s 5"),
        (swing(angular_velocity=np.full(5, np.nan)), "velocity_rad_s in segment 0 holds no number"),
    ],
)
def test_a_segment_that_cannot_be_used_is_refused(segment, message):
    with pytest.raises(ValueError, match=message):
        Recording((segment,))


TIME = np.arange(5) * 0.01
ANGLE = np.linspace(-0.1, -1.5, 5)


@pytest.mark.parametrize(
    ("segment", "sample", "message"),
    [
        (Segment(changed(TIME, 3, 0.02), angle=ANGLE), 3, "time_s must increase"),
        (Segment(changed(TIME, 3, 0.001), angle=ANGLE), 3, "Did the clock wrap"),
        (Segment(changed(TIME, 3, 0.0), angle=ANGLE), 3, "give each a file of its own"),
        (Segment(changed(TIME, 2, np.nan), angle=ANGLE), 2, "time_s is missing"),
        (Segment(TIME, angle=changed(ANGLE, 4, np.inf)), 4, r"is inf rad, beyond \+-14"),
        (Segment(TIME, angle=changed(ANGLE, 1, -90.0)), 1, "Is it in degrees"),
        (Segment(TIME, angle=changed(ANGLE, 1, 3.7)), 1, "which no knee reaches"),
        (Segment(TIME, angle=ANGLE, angular_velocity=2e3 * ANGLE), 0, "velocity_deg_s"),
        (Segment(TIME, angle=ANGLE, applied_torque=np.full(5, 2e3)), 0, "torque_nm"),
    ],
)
def test_a_sample_that_cannot_be_true_is_named(segment, sample, message):
    with pytest.raises(BadSample, match=message) as caught:
        Recording((swing(), segment))
    assert caught.value.segment == 1
    assert sample == caught.value.sample
    assert "\n" not in str(caught.value)


def test_missing_samples_are_allowed():
    segment = Segment(TIME, angle=changed(ANGLE, 2, np.nan))
    assert Recording((segment,)).segments[0] is segment


def test_a_rig_may_turn_further_than_a_knee():
    over_the_top = Segment(TIME, angle=ANGLE * 4)
    assert Recording((over_the_top,), Subject(kind="rig")).segments == (over_the_top,)
    with pytest.raises(ValueError, match='kind = "rig"'):
        Recording((over_the_top,), Subject(kind="leg"))
    elsewhere = Segment(TIME, angle=ANGLE - 3.0)  # an encoder counts from where it was glued
    assert Recording((elsewhere,), Subject(kind="leg")).segments == (elsewhere,)


@pytest.mark.parametrize(
    ("made", "words", "message"),
    [
        (Subject, {"side": "both"}, "side is 'both'; it can be left or right."),
        (Protocol, {"torque_frequency": "3/T"}, "torque_frequency is '3/T'; it can be 1/T or 2/T."),
        (Sensors, {"flip": "both"}, "flip is 'both'; it can be angle or gyro or all."),
        (Sensors, {"zero": "0"}, "zero is '0'; it can be extended or hanging or unknown."),
    ],
)
def test_a_word_that_a_field_cannot_be_is_refused_where_it_is_said(made, words, message):
    with pytest.raises(ValueError, match=f"^{re.escape(message)}$"):
        made(**words)


def test_a_kind_that_there_is_none_of_is_refused_where_no_types_are_checked():
    code = "import exoid; exoid.{}"
    for made, said in (
        ("Subject(kind='dog')", "kind is 'dog'; it can be leg or rig."),
        ("Protocol(kind=('passive', 'rest'))", "kind is 'rest'; it can be passive or active or"),
    ):
        done = subprocess.run(
            [sys.executable, "-c", code.format(made)], capture_output=True, text=True, check=False
        )
        assert done.stderr.splitlines()[-1].startswith(f"ValueError: {said}")


@pytest.mark.parametrize(
    ("metadata", "message"),
    [
        ({"subject": Subject(height=180.0)}, "height_m is 180 m; it must lie between 0.4 and 2.6"),
        ({"subject": Subject(body_mass=float("nan"))}, "body_mass_kg is nan"),
        ({"subject": Subject(added_mass_distance=0.4)}, "without added_mass_kg"),
        ({"protocol": Protocol(cycle_period=(2.0, 2.0))}, r"lists 2 values for 1 segment"),
        ({"sensors": Sensors(encoder_counts=12.0)}, "encoder_counts is 12 counts per turn"),
    ],
)
def test_metadata_that_cannot_be_true_is_refused(metadata, message):
    with pytest.raises(ValueError, match=message):
        Recording((swing(),), **metadata)


@pytest.mark.parametrize(
    ("key", "unit", "value", "told"),
    [
        ("--height", "m", 18.4, " It would be 1.84 m if its decimal point slipped."),
        ("height_m", "m", 0.165, " It would be 1.65 m if its decimal point slipped."),
        ("--height", "m", 184.0, " It would be 1.84 m if it is in cm."),
        ("--body-mass", "kg", 620.0, " It would be 62 kg if its decimal point slipped or 63.2 kg "
         "if it is in newtons."),
    ],
)  # fmt: skip
def test_a_body_that_cannot_be_is_asked_for_a_slip_or_a_unit(key, unit, value, told):
    assert unit_hint(key, unit, value, (0.4, 400.0)) == told


@pytest.mark.parametrize(
    ("degrees", "spring", "taken"),
    [(1.0, "none", True), (57.3, "none", False), (1.0, "own", False)],
)
def test_a_rig_without_a_spring_goes_round_both_ways_and_degrees_are_told(degrees, spring, taken):
    """There and back by four turns in 6 s, or what looks like it where degrees are called rad."""
    time = np.arange(0.0, 6.0, 0.01)
    angle = degrees * 4 * np.pi * np.sin(np.pi * time / 3) - 4.0
    segment = Segment(time, raw_angle=angle, applied_torque=np.sin(time))
    rig, own = Subject(kind="rig", spring="none"), Subject(kind="rig")
    given = (segment,), rig if spring == "none" else own, Protocol(kind="measured")
    if taken:
        assert Recording(*given).segments[0].raw_angle is angle
    else:
        with pytest.raises(BadSample, match="beyond"):
            Recording(*given)
