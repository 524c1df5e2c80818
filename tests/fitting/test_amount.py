"""Recordings that are more than one fit takes: what is fitted of them, and what is said."""

from dataclasses import replace

import numpy as np
import pytest

import exoid
from exoid.fitting.amount.manageable import DIAGNOSED, Amount, manageable
from exoid.fitting.amount.part import parts_of
from exoid.fitting.movements import movements_in
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.measured.segment import Segment
from legs import ADULT, BODY, drop, recording

FAST = 1e-3  # s
RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


def at_most(steps: int) -> Amount:
    return Amount(steps=steps, aim=steps)


def still(before: float, segment: Segment, after: float) -> Segment:
    """The same with rests of so many seconds in front and behind."""
    step = float(np.median(np.diff(segment.time)))
    pads = round(before / step), round(after / step)

    def held(samples, scatter, still):
        random = np.random.default_rng(1)
        first, last = (np.full(n, s) for n, s in zip(pads, still, strict=True))
        rests = [each + scatter * random.standard_normal(each.size) for each in (first, last)]
        return np.concatenate([rests[0], samples, rests[1]])

    angle = np.asarray(segment.raw_angle)
    size = angle.size + sum(pads)
    return Segment(
        np.asarray(np.arange(size) * step, dtype=np.float64),
        raw_angle=held(angle, 8e-4, (angle[0], angle[-50:].mean())),
        raw_angular_velocity=held(np.asarray(segment.raw_angular_velocity), 3e-3, (0.0, 0.0)),
    )


def test_a_recording_of_ordinary_size_is_left_as_it_is():
    whole = recording(*[drop(duration=60.0, step=0.005)] * 10)
    found = manageable([("r", whole)])
    assert found.notes == []
    assert all(part.recording is whole for part in found.parts)


def test_a_diagnosis_takes_less_than_a_fit():
    """It weighs every cause beside the leg: in the memory of a usual computer, and in minutes."""
    usual = recording(*[drop(duration=20.0)] * 8)
    assert manageable([("r", usual)], DIAGNOSED).notes == []
    found = manageable([("r", recording(*[drop(duration=60.0, step=0.005)] * 10))], DIAGNOSED)
    assert sum(part.steps for part in found.parts) <= DIAGNOSED.aim
    assert len(found.parts) == 10  # of all of them, their rests cut off


def test_of_a_thousand_drops_some_are_taken_evenly_and_that_is_said():
    many = recording(*[drop(duration=3.0, seed=seed) for seed in range(10)] * 100)
    found = manageable([("r", many)])
    numbers = [int(part.name) for part in found.parts]
    assert len(numbers) == 128
    # 1000 / 128 is 7.8: neighbours are 7 or 8 apart, and both ends are as near.
    assert set(np.diff(numbers)) == {7, 8}
    assert numbers[0] < 8
    assert numbers[-1] > 991
    assert "of 1000 segments 128 are fitted, taken evenly" in found.notes[0]
    assert "--each" in found.notes[0]
    for part in found.parts[:3]:
        assert part.segment.raw_angle is many.segments[int(part.name)].raw_angle


def test_the_few_drops_with_a_mass_are_all_taken():
    masses = tuple(2.0 if number in (500, 501) else 0.0 for number in range(1000))
    distances = tuple(0.3 if mass else float("nan") for mass in masses)
    subject = replace(BODY, added_mass=masses, added_mass_distance=distances)
    found = manageable([("r", recording(*[drop(duration=3.0)] * 1000, subject=subject))])
    loaded = [part.name for part in found.parts if part.recording.added_mass(part.number) == 2.0]
    assert loaded == ["500", "501"]
    assert len(found.parts) == 128


def test_of_a_long_recording_the_movement_is_found_where_it_is():
    long = recording(still(400.0, drop(duration=10.0), 1500.0))
    found = manageable([("r", long)])
    (part,) = found.parts
    # Half a second of rest before the drop of 10 s, 3.5 s behind, and 0.2 s of smoothing.
    assert 399.0 < part.segment.begins < 400.0
    assert 13.0 < part.segment.time[-1] < 14.2
    (movement,) = movements_in(found.parts)
    assert movement.extent is not None
    assert movement.extent.ended == "at rest"


def test_samples_that_come_too_fast_are_averaged_and_their_noise_falls_as_the_root():
    fast = recording(*[drop(duration=6.0, step=FAST, seed=seed) for seed in range(3)])
    found = manageable([("r", fast)], at_most(3 * 800))
    assert "means over 8 samples" in found.notes[0]
    sensors = found.parts[0].recording.sensors
    # 18 000 samples tell white noise to 0.5 %.
    assert sensors.angle_noise == pytest.approx(8e-4 / np.sqrt(8), rel=0.02)
    assert sensors.velocity_noise == pytest.approx(3e-3 / np.sqrt(8), rel=0.02)
    movement = movements_in(found.parts)[0]
    assert movement.angle_noise == pytest.approx(8e-4 / np.sqrt(8), rel=0.05)


def test_noise_that_is_declared_beyond_what_is_white_is_not_averaged_away():
    sensors = Sensors(angle_noise=5e-3, velocity_noise=3e-3)
    fast = recording(drop(duration=6.0, step=FAST), sensors=sensors)
    found = manageable([("r", fast)], at_most(800))
    shared = np.sqrt(5e-3**2 - 8e-4**2)
    assert found.parts[0].recording.sensors.angle_noise == pytest.approx(
        np.hypot(shared, 8e-4 / np.sqrt(8)), rel=1e-3
    )


def test_what_went_through_the_nodes_filter_is_not_averaged():
    raw = drop(duration=6.0, step=FAST)
    filtered = Segment(raw.time, angle=raw.raw_angle, angular_velocity=raw.raw_angular_velocity)
    found = manageable([("r", recording(filtered))], at_most(800))
    assert np.diff(found.parts[0].segment.time) == pytest.approx(FAST)
    assert found.notes == [
        "fitted are the first 0.799 s of segment 0: all of it is more than one fit takes"
    ]


def test_a_spike_is_not_hidden_in_a_mean():
    one = drop(duration=6.0, step=FAST)
    angle = np.array(one.raw_angle)
    angle[2003] += 0.5
    wild = recording(replace(one, raw_angle=angle))
    tame = recording(one)
    made, same = (
        manageable([("r", each)], at_most(800)).parts[0].segment.best_angle for each in (wild, tame)
    )
    # Its mean is that of the seven others: the noise of one sample over eight, three times.
    assert np.abs(made - same).max() < 3 * 8e-4 / 8


def test_a_torque_that_drives_for_hours_is_fitted_in_windows_over_all_of_them():
    time = np.arange(0, 10_000.0, 0.01)
    driven = Segment(time, raw_angle=0.3 * np.sin(3 * time), applied_torque=np.sin(3 * time))
    rig = recording(driven, subject=Subject(kind="rig"), protocol=Protocol(kind="measured"))
    found = manageable([("r", rig)])
    begins = [part.segment.begins for part in found.parts]
    assert len(begins) == 8
    assert np.diff(begins) == pytest.approx(np.diff(begins)[0], rel=1e-3)
    assert begins[-1] + found.parts[-1].segment.time[-1] == pytest.approx(10_000, rel=1e-3)
    assert found.parts[1].name == f"0@{begins[1]:.0f}s"
    assert "8 windows of 164 s of segment 0" in found.notes[0]


def test_a_voluntary_movement_that_never_rests_is_refused_with_what_to_do():
    time = np.arange(0, 10_000.0, 0.01)
    moved = Segment(time, raw_angle=-0.5 + 0.5 * np.cos(2 * np.pi * time / 2.0))
    with pytest.raises(ValueError, match=r"one voluntary movement of .* cycle_period_s"):
        exoid.fit(recording(moved, protocol=Protocol(kind="active")))


def test_a_gap_of_a_week_within_a_segment_is_not_simulated():
    one = drop(duration=6.0)
    time = np.concatenate([one.time, one.time + 7 * 86400.0])
    angle = np.asarray(one.raw_angle)
    twice = Segment(time, raw_angle=np.concatenate([angle, angle]))
    found = manageable([("r", recording(twice))])
    assert found.parts[0].steps <= 131_072


def test_a_segment_that_lacks_the_gyro_of_the_others_is_left_out_by_name():
    bare = drop(duration=6.0, gyro=False)
    mixed = recording(drop(duration=6.0), bare, drop(duration=6.0, seed=2))
    fit = exoid.fit(mixed, multistart=2)
    assert [each.name for each in fit.segments] == ["0", "2"]
    assert fit.set_aside == ["segment 1 was left out: not of the same channels as the others"]
    test = exoid.measure_drops(mixed)
    assert [each.reason is None for each in test.drops] == [True, False, True]


@pytest.mark.slow
def test_the_reduced_fit_is_the_fit_of_all_within_a_part_of_its_error():
    drops = [drop(duration=6.0, step=FAST, seed=seed) for seed in range(3)]
    whole = exoid.fit(recording(*drops), multistart=4)
    less = exoid.fit(recording(*drops), multistart=4, most=at_most(3 * 800))
    assert less.samples < whole.samples / 7
    for name in RATIOS:
        both = whole.ratios[name], less.ratios[name]
        # Of 20 draws of such drops none was 0.1 errors apart; with bare means all were 0.5.
        values = np.array([each.value for each in both], dtype=float)
        apart = np.diff(values) / float(both[0].standard_error or 0.0)
        assert abs(apart) < 0.2
        assert both[1].standard_error == pytest.approx(both[0].standard_error, rel=0.1)
    assert whole.ratios[RATIOS[0]].value == pytest.approx(ADULT[0], rel=2e-3)


def test_a_mean_is_that_of_the_motion_in_its_middle():
    time = np.arange(0, 4.0, FAST)
    swing = Segment(time, raw_angle=-0.8 + 0.5 * np.cos(6 * time))
    part = manageable([("r", recording(swing))], at_most(500)).parts[0]
    exact = -0.8 + 0.5 * np.cos(6 * part.segment.time)
    # A bare mean over 8 ms is 0.5 (6 * 0.008)^2 / 24 = 5e-5 rad off; what is left has the fourth
    # power of 6 * 3 * 0.008 over 288. At the ends the curvature is that of three samples farther.
    assert np.abs(part.segment.best_angle - exact)[3:-3].max() < 2e-6


def test_parts_bear_the_names_of_the_segments():
    named = [("a", recording(drop(), drop(seed=1))), ("b", recording(drop(seed=2)))]
    assert [part.name for part in parts_of(named)] == ["a 0", "a 1", "b 0"]
