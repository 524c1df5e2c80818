"""A log says how its node was commissioned, whether that changed, and which node it is of."""

import can
import numpy as np
import pytest
from exo_node import EPOCH, Node, knee_angle, write_log
from exo_node import message as framed

from exoid.recordings.can.frames import CanLogError
from exoid.recordings.can.node.config_crc import EARLIER, config_crc
from exoid.recordings.live.watch import Watch
from exoid.recordings.loading.can_log import read_can_log

TICKS = 450
OF_OLD = next(iter(EARLIER))  # ConfigCrc of a node that knew no settings


def read(tmp_path, messages, **options):
    recording, quality = read_can_log(write_log(tmp_path / "leg.blf", messages), **options)
    return recording.segments[0], quality


def by_time(*messages):
    return sorted((each for some in messages for each in some), key=lambda each: each.timestamp)


def watched(messages, node=None):
    said = []
    watch = Watch(said.append, config_crc(), node)
    for message in messages:
        if watch.is_wanted(message):
            watch.see(message)
    return watch, said


def test_a_log_says_zero_direction_and_firmware(tmp_path):
    node = Node(mountings={0: (1234, 1)})
    _, quality = read(tmp_path, node.messages(TICKS), strict=True)
    line = "node 0: zero 1234, the encoder's count falls in extension, firmware 1.2.3"
    assert quality.commissioned == (line,)
    assert line in quality.lines()
    assert quality.frames.foreign == 0


def test_a_node_that_nobody_commissioned_is_named(tmp_path):
    node = Node(mountings={0: (2048, 0)}, commissioned=0)
    (line,) = read(tmp_path, node.messages(TICKS))[1].commissioned
    assert line.endswith("firmware 1.2.3 (not commissioned: as it was built)")


@pytest.mark.parametrize(
    ("after", "what"),
    [
        ((1000, 0), "the zero from 1234 to 1000 was changed"),
        ((1234, 1), "the direction from rises to falls was changed"),
        ((1000, 1), "the zero from 1234 to 1000 and the direction from rises to falls was changed"),
    ],
)
def test_a_change_in_a_recording_is_one_line_with_its_time(tmp_path, after, what):
    messages = Node(mountings={0: (1234, 0), 250: after}).messages(TICKS)
    _, change = read(tmp_path, messages)[1].commissioned
    assert change.startswith(f"{what} in the recording, at 2.50 s: angles before and after")
    said = watched(messages)[1]
    assert len(said) == 1
    assert said[0].startswith(f"{what}: angles before and after it do not mean the same.")


def test_a_change_and_back_is_told_twice(tmp_path):
    messages = Node(mountings={0: (7, 0), 150: (8, 0), 330: (7, 0)}).messages(TICKS)
    assert len(read(tmp_path, messages)[1].commissioned) == 3
    assert len(watched(messages)[1]) == 2


def test_the_settings_of_two_nodes_of_one_id_are_no_change(tmp_path):
    one = Node(mountings={0: (7, 0)}, jitter=0.0).messages(TICKS)
    other = Node(mountings={0: (9, 0)}, serial=5, jitter=0.0).messages(200, begin=1.003)
    told = [each for each in other if each.arbitration_id == 0x104]
    messages = by_time(one, told)
    first, second = read(tmp_path, messages)[1].commissioned
    assert first.startswith("node 0: zero 7")
    assert second.startswith("2 nodes with the id 0 sent (serials 00000005, C0FFEE01)")
    assert watched(messages)[1] == []


def test_what_a_node_commands_is_no_frame_of_others(tmp_path):
    torque = {"Torque": 1.5, "Counter": 0, "Permit": 2, "Doubts": 0, "Crc": 7}
    told = [framed("EXO_TORQUE", torque, EPOCH + 1 + 0.01 * at) for at in range(100)]
    one = {"Place": 3, "Stored": 1, "Value": 0.25, "Crc": 7}
    told += [framed("EXO_PARAMETER", one, EPOCH + 1.002 + 0.05 * at) for at in range(20)]
    segment, quality = read(tmp_path, by_time(Node(jitter=0.0).messages(TICKS), told), strict=True)
    assert segment.time.size == TICKS
    assert quality.frames.foreign == 0
    assert not any("TORQUE" in line for line in quality.lines())


def test_a_log_of_a_node_of_old_is_read_and_frames_of_others_are_not_its_words(tmp_path):
    old = Node(config_crc=OF_OLD, jitter=0.0)
    others = [
        can.Message(
            timestamp=EPOCH + 1 + at,
            arbitration_id=identifier,
            is_extended_id=False,
            data=bytes([7, 7, 7, 7, at, at, at, at][:length]),  # as if the zero of one node moved
        )
        for at, (identifier, length) in enumerate(
            [(0x104, 8), (0x104, 8), (0x105, 3), (0x10F, 8), (0x200, 2)]
        )
    ]
    segment, quality = read(tmp_path, by_time(old.messages(TICKS), others), strict=True)
    assert segment.time.size == TICKS
    assert quality.design == EARLIER[OF_OLD]
    assert quality.commissioned == ()
    assert not any("WatchdogReset" in line for line in quality.lines())
    assert quality.frames.foreign == len(others)
    assert watched(by_time(old.messages(TICKS), others))[1] == []


@pytest.mark.parametrize("node", [1, 7, 15])
def test_a_node_of_any_id_is_read(tmp_path, node):
    messages = Node(node=node, mountings={0: (1234, 0)}).messages(TICKS)
    segment, quality = read(tmp_path, messages, strict=True)
    time = np.rint(segment.time / 0.01) * 0.01
    assert np.abs(segment.angle - knee_angle(time)).max() <= 2**-13  # half of the last bit
    assert quality.commissioned[0].startswith(f"node {node}: zero 1234")
    watch, said = watched(messages, node)
    assert said == []
    heartbeats = [each for each in messages if each.arbitration_id == 0x105 + 16 * node]
    assert watch.ours == watch.frames - len(heartbeats) == len(messages) - 5


def test_of_several_nodes_the_lowest_is_read_and_the_others_are_named(tmp_path):
    leg, other = Node(node=2, jitter=0.0), Node(node=5, first_counter=3, jitter=0.0)
    both = by_time(leg.messages(TICKS), other.messages(TICKS, begin=0.002))
    segment, quality = read(tmp_path, both)
    assert segment.time.size == TICKS
    assert "the log holds the nodes 2, 5: node 2 is read" in quality.notes[0]
    assert quality.frames.foreign == len(both) // 2


def test_one_of_several_nodes_is_recorded_alone(tmp_path):
    leg, other = Node(jitter=0.0), Node(node=5, jitter=0.0)
    both = by_time(leg.messages(TICKS), other.messages(TICKS, begin=0.002))
    watch, said = watched(both, node=5)
    assert watch.frames == len(both) // 2
    assert (said, watch.ticks.lost) == ([], 0)
    kept = [each for each in both if watch.is_wanted(each)]
    assert read(tmp_path, kept)[1].notes == ()


def test_a_device_that_only_uses_the_identifiers_of_another_node_is_none(tmp_path):
    foreign = Node(node=3, config_crc=0xBEEF, jitter=0.0)
    _, quality = read(tmp_path, by_time(Node(jitter=0.0).messages(TICKS), foreign.messages(TICKS)))
    assert quality.notes == ()
    with pytest.raises(CanLogError, match="no exoid frames"):
        read(tmp_path, foreign.messages(TICKS))
