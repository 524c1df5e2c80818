"""A continuous recording is cut into what a relaxed leg did, whoever recorded it."""

from dataclasses import replace

import numpy as np
import pytest

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.loading.load import load
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.splitting.piece import Piece
from exoid.recordings.splitting.split import SHOWN, cut_table, notes_of

DOWN = np.radians(-72)


def continuous(rate: float, noise: float, **said) -> Recording:
    """Drop, lift, drop, lift, and a leg that is shaken to either side."""

    def after(seconds):
        return np.arange(0, seconds, 1 / rate)

    def drop(start):
        time = after(7.0)
        swing = np.cos(5.7 * time) + 0.9 / 5.7 * np.sin(5.7 * time)
        return DOWN + (start - DOWN) * np.exp(-0.9 * time) * swing

    def lift(end):
        return DOWN + (end - DOWN) / 2 * (1 - np.cos(np.pi * after(1.0)))

    def hold(angle):
        return np.full(after(1.2).size, angle)

    shaken = -0.2 + 0.4 * np.sin(9 * after(2.0)) * np.sin(np.pi * after(2.0) / 2)
    parts = [hold(-0.3), drop(-0.3), hold(DOWN), lift(0.0), hold(0.0), drop(0.0), hold(DOWN)]
    parts += [lift(-0.2), hold(-0.2), shaken, hold(-0.2)]
    angle = np.concatenate(parts)
    angle = angle + noise * np.random.default_rng(0).normal(size=angle.size)
    segment = Segment(np.arange(angle.size) / rate, raw_angle=angle)
    return Recording((segment,), Subject(kind="leg"), Protocol(**said), Sensors(angle_noise=noise))


@pytest.mark.parametrize(("rate", "noise"), [(100, 1e-3), (30, 0.009), (120, 0.009)])
@pytest.mark.parametrize("said", [{}, {"kind": "passive"}, {"kind": ("passive",)}])
def test_a_continuous_table_is_cut_into_its_drops_and_says_what_it_left_out(rate, noise, said):
    found = cut_table(continuous(rate, noise, **said))
    assert set(found.recording.protocol.kind) in ({"passive"}, set("passive"))
    first, second = found.recording.segments
    for segment, start in ((first, -0.3), (second, 0.0)):
        assert segment.raw_angle[0] == pytest.approx(start, abs=4 * noise)
        assert segment.time[-1] > 5.0
    (note,) = found.notes
    assert note.startswith("left out, for a hand moved the leg: a lift from 9.")
    assert note.count("a lift") == 2
    assert "shaking from 2" in note


@pytest.mark.parametrize("first", range(0, 53, 4))
def test_a_logger_that_shows_nothing_now_and_then_as_zero_loses_no_drop(first):
    """Wherever such a sample falls, on an end of a drop, too; level is where the second begins."""
    log = continuous(100, 1e-3)
    (whole,) = log.segments
    angle = whole.raw_angle.copy()
    angle[first::53] = 0.5
    found = cut_table(replace(log, segments=(replace(whole, raw_angle=angle),)))
    assert found.recording.protocol.kind == ("passive", "passive")
    assert found.notes == cut_table(log).notes


def test_of_hundreds_of_lifts_the_first_are_named_and_the_rest_counted():
    log = Segment(np.arange(4000) * 0.1, raw_angle=np.zeros(4000))
    lifts = [Piece(10 * each, 10 * each + 5, None, "a lift") for each in range(300)]
    (note,) = notes_of(log, lifts)
    assert note.count("a lift") == SHOWN
    assert note.endswith(f"s, and {300 - SHOWN} more times")


@pytest.mark.parametrize("left", [0.5, 1.0, 2.0, 3.0])  # deg, by which it still swings
@pytest.mark.parametrize("seconds", [0.8, 1.5, 2.2])
def test_a_lift_of_a_leg_that_still_swings_is_told_and_left_out(left, seconds):
    damped = np.log(0.9 / np.radians(left)) / 9.0
    time = np.arange(0, 9, 0.01)
    swing = DOWN + 0.9 * np.exp(-damped * time) * np.cos(5.5 * time)
    share = np.arange(0, seconds, 0.01) / seconds
    lift = swing[-1] + (-0.36 - swing[-1]) / 2 * (1 - np.cos(np.pi * share))
    one = [np.full(150, DOWN + 0.9), swing, lift]
    angle = np.concatenate([*one, *one, np.full(150, lift[-1])])
    angle = angle + 1e-3 * np.random.default_rng(0).normal(size=angle.size)
    log = Segment(0.01 * np.arange(angle.size), raw_angle=angle)
    found = cut_table(Recording((log,), Subject(kind="leg")))
    assert found.recording.protocol.kind == ("passive", "passive")
    (note,) = found.notes
    said = [float(each.split()[0]) for each in note.split("a lift from ")[1:]]
    taken = [10.5, 21.0 + seconds]  # s; in its last half period before, nobody sees when
    assert said == pytest.approx(taken, abs=0.6)
    for segment, at in zip(found.recording.segments, taken, strict=True):
        assert at - 1.1 < segment.begins + segment.time[-1] < at + 0.1


def test_load_cuts_a_table_and_names_what_it_left_out(tmp_path):
    write_table(continuous(100, 1e-3), tmp_path / "long.csv")
    loaded = load(tmp_path / "long.csv")
    assert len(loaded.recording.segments) == 2
    assert "left out" in loaded.notes[-1]


def test_a_pause_ends_the_drop_before_it():
    log = continuous(100, 1e-3)
    (segment,) = log.segments
    at_rest = segment.time > 8.0  # the first drop hangs still from 7 s on
    paused = replace(segment, time=segment.time + 28_800.0 * at_rest)
    first, second = cut_table(replace(log, segments=(paused,))).recording.segments
    assert 6.5 < first.time[-1] <= 8.0  # counted from its own begin, which a rest precedes
    assert np.diff(first.time).max() < 0.02
    assert second.time[-1] > 5.0


def test_marks_beyond_a_cut_log_say_what_to_take_out():
    log = continuous(100, 1e-3, segment_start=(0.0, 99.0), segment_end=(9.0, 104.0))
    with pytest.raises(ValueError, match=r"segment 1 is marked from 99 .* Take this segment out"):
        cut_table(log)


@pytest.mark.parametrize("said", [{}, {"kind": "passive"}])
def test_a_rigs_table_is_cut_into_what_swings_in_it(said):
    log = continuous(100, 1e-3, **said)
    found = cut_table(replace(log, subject=Subject(kind="rig")))
    assert found.recording.protocol.kind == "passive"
    for cut, legs in zip(found.recording.segments, cut_table(log).recording.segments, strict=True):
        assert cut.begins == pytest.approx(legs.begins, abs=0.05)
        assert cut.time[-1] > 5.0
    assert found.notes[0].startswith("left out, for a hand moved the rig: a lift from 9.")


@pytest.mark.parametrize("kind", ["active", "measured"])
def test_a_rig_that_was_driven_stays_as_it_is(kind):
    log = replace(continuous(100, 1e-3, kind=kind), subject=Subject(kind="rig"))
    assert cut_table(log).recording is log


def to_and_fro(before: float, after: float, *, swing, **said) -> Recording:
    """Held at `before` [rad] for 1.5 s, moved by `swing`, held where that ends for 2 s, and brought
    to `after` in 1 s: three times.
    """
    held, ended, way = np.full(150, before), np.full(200, swing[-1]), np.linspace(0, np.pi, 100)
    back = swing[-1] + (after - swing[-1]) / 2 * (1 - np.cos(way))
    angle = np.concatenate([held, swing, ended, back] * 3)
    angle = angle + 6e-4 * np.random.default_rng(3).normal(size=angle.size)
    segment = Segment(np.arange(angle.size) / 100, raw_angle=angle)
    return Recording((segment,), Subject(kind="leg"), Protocol(**said))


def swung(lasting: float) -> np.ndarray:
    """A leg that is let go at -0.3 rad."""
    time = np.arange(0, lasting, 0.01)
    swing = np.cos(5.7 * time) + 0.4 / 5.7 * np.sin(5.7 * time)
    return DOWN + (-0.3 - DOWN) * np.exp(-0.4 * time) * swing


def test_drops_that_a_hand_caught_in_their_first_swing_are_drops_where_that_is_told():
    log = to_and_fro(-0.3, -0.3, swing=swung(1.1))
    found = cut_table(log)
    assert found.recording.protocol.kind == ("active",) * 3
    assert "caught in its first swing" in found.notes[-1]
    told = cut_table(replace(log, protocol=Protocol(kind="passive")))
    assert [each.begins for each in told.recording.segments] == pytest.approx(
        [each.begins for each in found.recording.segments], abs=0.05
    )
    assert not any("first swing" in note for note in told.notes)


def test_what_a_hand_brings_back_is_no_drop_even_among_drops():
    around = -0.3 - 0.6 * (1 - np.cos(np.linspace(0, 2 * np.pi, 120)))
    log = to_and_fro(-0.3, -0.3, swing=around, kind="passive")
    assert cut_table(log).recording.segments == log.segments


def test_a_rig_is_cut_where_a_hand_stops_it_and_not_where_one_lowers_it():
    lowered = -0.3 - 0.5 * (1 - np.cos(np.linspace(0, np.pi, 120)))
    log = replace(to_and_fro(-0.3, -0.3, swing=swung(4.0)), subject=Subject(kind="rig"))
    found = cut_table(log).recording.segments
    assert [each.begins for each in found] == pytest.approx([1.0, 9.5, 18.0], abs=0.1)
    assert [each.time[-1] for each in found] == pytest.approx([4.5] * 3, abs=0.2)
    by_hand = to_and_fro(-0.3, -0.3, swing=lowered)
    assert len(cut_table(by_hand).recording.segments) == 3  # of a leg, that falls
    by_hand = replace(by_hand, subject=Subject(kind="rig"))
    assert cut_table(by_hand).recording.segments == by_hand.segments


def test_no_rig_moves_voluntarily_unsaid():
    around = -0.3 - 0.6 * (1 - np.cos(np.linspace(0, 2 * np.pi, 120)))
    log = replace(to_and_fro(-0.3, -0.3, swing=around), subject=Subject(kind="rig"))
    (note,) = cut_table(log).notes
    assert "no rig makes one" in note
    assert cut_table(replace(log, protocol=Protocol(kind="active"))).notes == ()


def test_a_single_drop_stays_as_it_is():
    recording = continuous(100, 1e-3)
    (log,) = recording.segments
    single = Segment(log.time[:820], raw_angle=log.raw_angle[:820])
    said = Protocol(kind=("passive",))
    alone = replace(recording, segments=(single,), protocol=said)
    assert cut_table(alone).recording is alone
