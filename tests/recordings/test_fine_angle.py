"""EXO_FINE gives the angle of a fine encoder in full, and changes no log of a node without it."""

from dataclasses import fields
from unittest.mock import patch

import numpy as np
import pytest
from exo_node import EPOCH, Node, knee_angle, message, write_log

from exoid.recordings.can.dbc import EXOID_DBC
from exoid.recordings.can.node import config_crc as crc
from exoid.recordings.live.watch import Watch
from exoid.recordings.loading.can_log import read_can_log

TICKS = 300
BITS = 14
STEP = np.pi / 2**BITS  # rad; half a count of the encoder
COARSE_STEP = np.pi / 2**12  # rad; half a count of EXO_RAW
FIRST = 250  # counter of the first tick


def fine_count(tick):
    """Of 2^16 a turn, as an encoder of 14 bits has it."""
    turned = round(float(knee_angle(tick * 0.01)) / (2 * np.pi) * 2**BITS)
    return (turned * 4 + 2**15) % 2**16


def raw_of(tick):
    count = (fine_count(tick) + 8) // 16 % 4096
    angle = count * 2 * np.pi / 4096 - np.pi
    return dict(Angle=angle, GyroX=0, GyroY=0, GyroZ=0, Counter=(FIRST + tick) % 16)


def fine_of(tick, host):
    angle = fine_count(tick) * 2 * np.pi / 65536 - np.pi
    values = dict(Angle=angle, Counter=(FIRST + tick) % 256, EncoderBits=BITS)
    return message("EXO_FINE", values, host)


def session(fine=fine_of):
    """The frames of a node with a fine encoder; `fine` gives the last frame of a tick, or none."""
    found = []
    for each in Node(first_counter=FIRST, jitter=0.0).messages(TICKS):
        tick = round((each.timestamp - EPOCH) / 0.01 - 0.05)
        if each.arbitration_id == 0x102:
            each = message("EXO_RAW", raw_of(tick), each.timestamp)
        found.append(each)
        if each.arbitration_id == 0x103 and (extra := fine(tick, each.timestamp + 0.00027)):
            found.append(extra)
    return sorted(found, key=lambda each: each.timestamp)


def read(tmp_path, messages, **options):
    recording, quality = read_can_log(write_log(tmp_path / "leg.blf", messages), **options)
    return recording, recording.segments[0], quality


def test_the_raw_angle_has_the_encoders_own_resolution(tmp_path):
    recording, segment, quality = read(tmp_path, session(), strict=True)
    assert np.abs(segment.raw_angle - knee_angle(segment.time)).max() <= STEP
    assert recording.sensors.encoder_counts == 2**BITS
    assert {count.name: count.used for count in quality.messages}["EXO_FINE"] == TICKS


def test_a_tick_whose_fine_angle_is_lost_has_the_coarse_one(tmp_path):
    lost = range(100, 110)
    messages = session(lambda tick, host: None if tick in lost else fine_of(tick, host))
    _, segment, quality = read(tmp_path, messages)
    off = np.abs(segment.raw_angle - knee_angle(segment.time))
    assert STEP < off[lost].max() <= COARSE_STEP + STEP  # rounded to 14 bits, then to 12
    assert np.delete(off, lost).max() <= STEP
    assert any("EXO_FINE: 10 of 300" in line for line in quality.losses())


def test_who_watches_a_bus_is_told_nothing_of_it():
    said = []
    watch = Watch(said.append, crc.config_crc())
    for each in session():
        watch.see(each)
    assert said == []
    assert watch.ticks.lost == 0


@pytest.mark.parametrize("counter", [0, 1])
def test_a_foreign_frame_of_its_identifier_changes_nothing(tmp_path, counter):
    """Other devices may send with any identifier: their bits are not this node's angle."""

    def foreign(tick, host):
        values = dict(Angle=0.1 * (tick % 7), Counter=tick * counter % 256, EncoderBits=3)
        return message("EXO_FINE", values, host)

    without, plain, _ = read(tmp_path, session(lambda tick, host: None))
    with_it, beside, quality = read(tmp_path, session(foreign))
    assert with_it.sensors == without.sensors
    for each in fields(plain):
        np.testing.assert_array_equal(getattr(beside, each.name), getattr(plain, each.name))
    assert [count.name for count in quality.messages].count("EXO_FINE") == 0


def test_a_node_without_a_fine_encoder_tells_the_crc_of_a_dbc_without_the_message(tmp_path):
    """So that the logs of the nodes that are on legs go on being read."""
    lines = EXOID_DBC.read_text(encoding="utf-8").splitlines(keepends=True)
    begin = lines.index("BO_ 263 EXO_FINE: 8 EXO\n")
    end = lines.index("\n", begin)
    del lines[begin : end + 1]
    before = tmp_path / "before.dbc"
    before.write_text("".join(line for line in lines if " 263 " not in line), encoding="utf-8")
    assert "FINE" not in before.read_text(encoding="utf-8")
    with patch.object(crc, "EXOID_DBC", before):
        expected = crc.config_crc()
    assert crc.config_crc() == expected
