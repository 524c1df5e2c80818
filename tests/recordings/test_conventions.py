"""What a user got wrong is told with what mends it; what is right is never doubted."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.recordings.conventions.apply import understand
from exoid.recordings.conventions.mounting import REST_SPREAD, RESTS
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.loading.load import load
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.split import Split, cut_apart
from legs import ADULT, BODY, CHILD, SPASTIC, balance_of, drop, recording

ANGLES = ("raw_angle", "angle")
RATES = ("raw_angular_velocity", "angular_velocity")


def understood(wrong: Recording, **options):
    return understand(wrong, lambda log: Split(log, ()), **options)


def changed(right: Recording, change) -> Recording:
    return replace(right, segments=tuple(replace(each, **change(each)) for each in right.segments))


def scaled(names, factor, shift=0.0):
    def change(segment):
        return {n: factor * s + shift for n, s in segment.channels().items() if n in names}

    return change


def timed(factor, shift=0.0):
    return lambda segment: {"time": factor * segment.time + shift}


def legs():
    """One drop, several, of an adult, a child and a stiff leg, with and without a gyro."""
    return {
        "adult": recording(drop(), drop(start=-0.7)),
        "child": recording(drop(CHILD, -0.1), drop(CHILD, -0.4)),
        "camera": recording(
            drop(gyro=False, step=1 / 30, noise=(0.0175, 0.0)),
            sensors=Sensors(),
        ),
    }


MISTAKES = {  # name: what was done, and what the user is told, with and without a gyro
    "milliseconds": (timed(1e3), "name the column time_ms"),
    "microseconds": (timed(1e6), "name the column time_us"),
    "milliseconds since 1970": (timed(1e3, 1.7e12), "name the column time_ms"),
    "minutes": (timed(1 / 60), r"minutes\? Multiply it by 60"),
    "days": (timed(1 / 86400), r"days\? Multiply it by 86400"),
    "flexion positive": (scaled(ANGLES + RATES, -1.0), 'flip="(all|angle)"'),
    "flexion of the angle positive": (scaled(ANGLES, -1.0), 'flip="angle"'),
    "hanging called 0": (scaled(ANGLES, 1.0, np.pi / 2), 'zero="hanging"'),
    "its own rest called 0": (scaled(ANGLES, 1.0, 1.3), 'zero="unknown"'),
    "hanging 0, flexion positive": (
        scaled(ANGLES, -1.0, -np.pi / 2),
        'flip="angle"',  # a child's is found in two steps: its gyro first
    ),
    "zero of an absolute encoder": (
        scaled(ANGLES, 1.0, np.radians(85)),
        'Then say zero="hanging" if 0 is the upright shank, zero="unknown" if it is where this leg '
        "rests by itself.* An encoder that passes 0 or 360 deg needs angle_zero_deg below",
    ),
    "where no leg hangs": (scaled(ANGLES, 1.0, -1.2), 'thigh_angle_deg.* gravity = "none"'),
    "straight called 180 deg": (scaled(ANGLES, 1.0, np.pi), "angle_zero_deg = 180"),
    "radians called degrees": (scaled(ANGLES, np.pi / 180), "_rad in place of _deg"),
}
GYROS = {
    "in deg/s": (scaled(RATES, np.degrees(1.0)), "raw_velocity_deg_s"),
    "rad/s called deg/s": (scaled(RATES, np.radians(1.0)), r"rad/s.*raw_velocity_rad_s\."),
    "other sign": (scaled(RATES, -1.0), 'flip="gyro"'),
    "dead": (scaled(RATES, 0.0), "stays at 0 all along"),
    "stuck": (scaled(RATES, 0.0, 0.2), "stays at 0.2 all along"),
}


@pytest.mark.parametrize("leg", legs())
@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_mistake_is_named_with_what_mends_it(leg, mistake):
    change, said = MISTAKES[mistake]
    with pytest.raises(ValueError, match=said) as caught:
        understood(changed(legs()[leg], change))
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("mistake", GYROS)
def test_a_gyro_of_another_unit_or_sign_is_named(mistake):
    change, said = GYROS[mistake]
    wrong = changed(recording(drop(start=-1.1)), change)
    with pytest.raises(ValueError, match=said):
        understood(wrong)


@pytest.mark.parametrize(("one", "sign", "right"), [("angle", -1.0, "all"), ("gyro", 1.0, None)])
def test_one_sensor_turned_alone_where_both_have_one_sign_is_told(one, sign, right):
    both = changed(recording(drop(start=-1.1)), scaled(ANGLES + RATES, sign))
    with pytest.raises(ValueError, match=f'once flip="{one}" is done.*flip="all".*nothing'):
        understood(both, flip=one)
    understood(both, flip=right)


@pytest.mark.parametrize("name", legs())
def test_what_is_right_is_not_doubted(name):
    right = legs()[name]
    same, notes = understood(right)
    assert notes == ()
    assert same is right


@pytest.mark.parametrize("thigh", [-0.3, 0.0, 0.4])
@pytest.mark.parametrize("leg", [ADULT, CHILD, SPASTIC, (24.0, 45.0, 3.0), (30.0, 0.0, 0.1)])
def test_no_leg_is_doubted_for_being_stiff_or_slack_or_on_a_tilted_seat(leg, thigh):
    told = Protocol(kind="passive", thigh_angle=thigh)
    for start in (-0.05, -0.4, -0.9):
        for seed, noise in enumerate(((8e-4, 3e-3), (0.0175, 0.1))):
            each = drop(leg, start - thigh, thigh=thigh, seed=seed, noise=noise)
            assert understood(recording(each, protocol=told))[1] == ()


def test_what_was_told_in_vain_is_not_advised_again():
    straight = changed(legs()["adult"], scaled(ANGLES, 1.0, np.pi))
    said = 'angle_zero_deg = 180 below .* instead of zero="hanging"\\.'
    with pytest.raises(ValueError, match=said) as caught:
        understood(straight, zero="hanging")
    assert 'zero="extended"' not in str(caught.value)  # it would undo what was told
    with pytest.raises(ValueError, match=r"angle_zero_deg = 180 .* instead of flip=\"all\" and"):
        understood(straight, zero="hanging", flip="all")


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"zero": "hanging"}, 'zero="hanging"'),
        ({"flip": "all"}, 'flip="all"'),
        ({"flip": "angle"}, 'flip="angle"'),
    ],
)
def test_what_was_told_of_a_file_that_counts_as_exoid_does_is_to_be_left_out(options, told):
    with pytest.raises(ValueError, match=f"Then leave out {told}\\."):
        understood(legs()["adult"], **options)


def test_a_rig_may_count_as_it_likes():
    rig = Subject(kind="rig")
    for change, _ in (MISTAKES["flexion positive"], MISTAKES["hanging called 0"]):
        understood(changed(recording(drop(), subject=rig), change))
    with pytest.raises(ValueError, match='flip="gyro"'):  # but its sensors must agree
        understood(changed(recording(drop(), subject=rig), scaled(RATES, -1.0)))


def test_that_the_zero_is_right_can_be_insisted_on():
    odd = changed(legs()["adult"], scaled(ANGLES, 1.0, 0.9))
    with pytest.raises(ValueError, match='say zero="extended"'):
        understood(odd)
    assert understood(odd, zero="extended")[1] == ()


def test_one_drop_that_was_turned_is_named_by_its_number():
    first, second = legs()["adult"].segments
    turned = replace(second, raw_angle=-second.raw_angle)
    with pytest.raises(ValueError, match="segment 1: the angle"):
        understood(recording(first, turned))


def test_a_drop_of_another_leg_is_named():
    mixed = recording(drop(start=-0.2), drop(start=-0.5), drop(CHILD, -0.3))
    (note,) = understood(mixed)[1]
    assert note.startswith("segment 2 is drawn to rest by ")
    assert "of another leg" in note
    told = replace(BODY, added_mass=(0.0, 0.0, 1.0))  # with another mass it may well be
    assert understood(replace(mixed, subject=told))[1] == ()


# What is told is mended


def agree(one: Recording, other: Recording) -> None:
    """The same samples, but for the rounding of adding and taking away a shift."""
    for mine, theirs in zip(one.segments, other.segments, strict=True):
        assert mine.channels().keys() == theirs.channels().keys()
        for name, samples in mine.channels().items():
            np.testing.assert_allclose(samples, theirs.channels()[name], atol=1e-12)


@pytest.mark.parametrize(
    ("mistake", "options", "told"),
    [
        ("flexion positive", {"flip": "all"}, Sensors(flip="all")),
        ("flexion of the angle positive", {"flip": "angle"}, Sensors(flip="angle")),
        ("hanging called 0", {"zero": "hanging"}, Sensors(zero="hanging")),
        ("straight called 180 deg", None, Sensors(angle_zero=np.pi)),
    ],
)
def test_an_option_or_the_sidecar_mends_it(mistake, options, told):
    right = recording(drop(), sensors=Sensors())
    wrong = changed(right, MISTAKES[mistake][0])
    for mended in (
        *([understood(wrong, **options)] if options else []),
        understood(replace(wrong, sensors=told)),
    ):
        agree(mended[0], right)
        assert mended[0].sensors == Sensors()  # nothing is left to be mended twice
        assert len(mended[1]) == 1


def test_a_flipped_angle_is_flipped_about_its_zero():
    right = recording(drop(), sensors=Sensors())
    told = Sensors(flip="all", angle_zero=0.3)
    wrong = changed(changed(right, scaled(ANGLES + RATES, -1.0)), scaled(ANGLES, 1.0, 0.3))
    agree(understood(replace(wrong, sensors=told))[0], right)


def test_two_answers_for_one_zero_are_refused():
    told = Sensors(zero="hanging", angle_zero=0.1)
    with pytest.raises(ValueError, match="two answers to one question"):
        understood(recording(drop(), sensors=told))


@pytest.mark.parametrize("shift", [-2.0, 0.0, 1.3, 4.0])
def test_an_unknown_zero_is_taken_from_where_the_leg_hangs(shift):
    right = recording(drop(duration=12.0), drop(start=-0.6, duration=12.0), sensors=Sensors())
    moved = changed(right, scaled(ANGLES, 1.0, shift))
    found, (note,) = understood(moved, zero="unknown")
    spread = found.sensors.angle_zero_uncertainty
    assert spread == pytest.approx(REST_SPREAD, rel=0.05)  # the drops agree
    off = found.segments[0].raw_angle - right.segments[0].raw_angle
    np.testing.assert_allclose(off, RESTS - balance_of(ADULT), atol=2e-3)  # the rest's own error
    assert abs(off[0]) < 2 * spread  # an adult is within what is believed of people
    assert "is unknown: the leg hangs at" in note


def test_of_drops_that_were_caught_the_swings_tell_the_zero():
    caught = recording(drop(duration=2.2), sensors=Sensors(zero="unknown"))
    rest = understood(caught)[0].segments[0].raw_angle - caught.segments[0].raw_angle
    np.testing.assert_allclose(rest, RESTS - balance_of(ADULT), atol=0.06)  # 3 deg, of 11


def test_a_declared_uncertainty_is_kept_and_a_zero_nobody_can_tell_is_refused():
    told = Sensors(zero="unknown", angle_zero_uncertainty=0.05)
    found, _ = understood(recording(drop(duration=12.0), sensors=told))
    assert found.sensors.angle_zero_uncertainty == 0.05
    short = recording(drop(duration=0.6), sensors=told)
    with pytest.raises(ValueError, match="no drop shows where the leg hangs"):
        understood(short)


# Files


def test_a_clock_that_counts_from_a_date_begins_at_zero_without_a_word(tmp_path):
    right = recording(drop(), drop(start=-0.5))
    write_table(changed(right, timed(1.0, 1.75e9)), tmp_path / "knee.csv")
    loaded = load(tmp_path / "knee.csv")
    assert loaded.notes == ()
    assert loaded.recording.protocol.time_origin == 1.75e9
    for mine, theirs in zip(loaded.recording.segments, right.segments, strict=True):
        np.testing.assert_allclose(mine.time, theirs.time, atol=1e-6)  # a float64 of 1970
    write_table(loaded.recording, tmp_path / "copy.csv")
    assert load(tmp_path / "copy.csv").recording.protocol.time_origin == 1.75e9


@pytest.mark.parametrize(("rate", "said"), [(100.0, False), (97.0, False), (200.0, True)])
def test_a_rate_that_is_not_that_of_the_samples_is_told(rate, said):
    _, notes = understood(recording(drop(step=0.01), sensors=Sensors(sample_rate=rate)))
    told = "sample_rate_hz says 200, but by time_s there are 100 samples a second"
    assert any(told in note for note in notes) == said


def test_degrees_are_taken_wherever_the_sidecar_has_radians(tmp_path):
    write_table(recording(drop()), tmp_path / "knee.csv")
    sidecar = tmp_path / "knee.toml"
    sidecar.write_text(
        "[protocol]\nkind = 'passive'\nthigh_angle_deg = [2]\nthigh_angle_uncertainty_deg = 1\n"
        "[sensors]\nangle_zero_deg = 1.5\nangle_zero_uncertainty_deg = 0.5\n"
    )
    found = load(tmp_path / "knee.csv").recording
    assert found.protocol.thigh_angle == (np.radians(2),)
    assert found.protocol.thigh_angle_uncertainty == np.radians(1)
    assert found.sensors.angle_zero_uncertainty == np.radians(0.5)
    shift = found.segments[0].raw_angle - recording(drop()).segments[0].raw_angle
    np.testing.assert_allclose(shift, -np.radians(1.5), atol=1e-12)
    sidecar.write_text("[protocol]\nthigh_angle_deg = 2\nthigh_angle_rad = 0.1\n")
    with pytest.raises(ValueError, match=r"thigh_angle_deg and thigh_angle_rad .* are the same"):
        load(tmp_path / "knee.csv")
    sidecar.write_text("[protocol]\nthigh_angle_deg = '2'\n")
    with pytest.raises(ValueError, match="must be a number, without quotes"):
        load(tmp_path / "knee.csv")


def test_a_continuous_log_of_flexion_is_named_though_no_drop_is_found_in_it(tmp_path):
    time, still = np.arange(1200) * 0.01, np.full(300, -0.2)
    swing = drop(gyro=False, noise=(0.0, 0.0)).raw_angle
    angle = -np.concatenate([still, swing, np.full(300, swing[-1])])
    log = recording(Segment(time, raw_angle=angle), protocol=Protocol())
    with pytest.raises(ValueError, match='flip="angle"'):
        understand(log, cut_apart)


@pytest.mark.proof
@pytest.mark.parametrize("folder", ["real", "audit", "others", "concealed"])
def test_no_recording_of_others_is_doubted(shared, folder):
    """Rigs, people, cameras, spastic legs, caught drops, heavy tails, hum: none is a mistake."""
    for path in sorted((shared / folder).glob("*.csv")):
        assert load(path).notes == (), path
