"""The node's samples as frames come: those of the whole log, and none that cannot be believed."""

import numpy as np
import pytest
from exo_node import EPOCH, Node, write_log

from exoid.recordings.can.frames import EXTENDED, Frames, Log
from exoid.recordings.can.logs.log_files import read_log
from exoid.recordings.can.node.log import read_exo
from exoid.recordings.live.decoding.node_stream import OTHER_FIRMWARE, TWO_NODES, NodeStream
from exoid.recordings.live.decoding.reading import Reading
from exoid.recordings.live.decoding.stretch import take_all
from exoid.recordings.loading.can_log import read_can_log


def streamed(messages, node=0) -> NodeStream:
    """One by one, as from a bus."""
    stream = NodeStream(node)
    for each in messages:
        stream.take(each.arbitration_id, each.timestamp, bytes(each.data))
    return stream


def rows(stream) -> np.ndarray:
    return np.array(stream.ready).reshape(-1, len(Reading._fields))


def frames_of(messages) -> Frames:
    """The same as a log has them."""
    count = len(messages)
    return Frames(
        np.array([each.timestamp for each in messages]),
        np.array([each.arbitration_id for each in messages], dtype=np.uint32),
        np.zeros(count, dtype=np.uint8),
        np.full(count, 8, dtype=np.uint8),
        np.frombuffer(b"".join(bytes(each.data) for each in messages), np.uint8).reshape(-1, 8),
    )


def memory(stream: NodeStream) -> dict:
    """All that a stream remembers."""
    ticks, alternation = stream.ticks, stream.alternation
    open_tick = stream.open and (stream.open.number, stream.open.state, stream.open.raw)
    return {
        "tick": (ticks.tick, ticks.begin, ticks.heard, ticks.anchor, ticks.lost, ticks.restarts),
        "tracks": {name: (t.first, t.last, t.count) for name, t in ticks.tracks.items()},
        "alternation": (alternation.last, alternation.before, list(alternation.odd)),
        "open": open_tick,
        "stream": (stream.last, stream.heard, stream.unsure, stream.unheard, stream.spoiled),
        "expected": stream.counts.expected,
    }


def test_a_stream_gives_the_samples_of_the_bundled_log():
    from exoid.cli.inputs.reading import EXAMPLE

    log = read_log(EXAMPLE)
    segment, _ = read_exo(log)
    stream = NodeStream()
    take_all(stream, log.frames)
    found = rows(stream)
    # The log's times are sums of the device's microseconds: 1e-12 s is their rounding.
    np.testing.assert_allclose(found[:, 0], segment.time, atol=1e-11)
    np.testing.assert_array_equal(found[:, 1], segment.raw_angle)
    np.testing.assert_array_equal(found[:, 2], segment.raw_angular_velocity)


def damaged(seed: int, ticks: int = 900):
    """Frames of a node of which some are lost, doubled, late, or of another tick's clock."""
    rng = np.random.default_rng(seed)
    status = {int(t): {"EncoderFault": 1} for t in rng.integers(0, ticks, 5)}
    status |= {int(t): {"GyroSaturated": 1} for t in rng.integers(0, ticks, 5)}
    sent = Node(status=status, jitter=0.0).messages(ticks)
    kind = seed % 6
    if kind == 1:
        sent = [each for each in sent if rng.random() > 0.01]
    elif kind == 2:
        sent = [each for each in sent for _ in range(1 + int(rng.random() < 0.01))]
    elif kind == 3:
        first = int(rng.integers(500, 1500))
        sent = sent[:first] + sent[first + int(rng.integers(300, 900)) :]
    elif kind == 4:
        again = Node(device_start=0.3, first_counter=0, jitter=0.0).messages(300, begin=7.5)
        sent = sent[: int(rng.integers(1000, 2000))] + again
    elif kind == 5:
        at = int(rng.integers(0, len(sent) - 9))
        sent[at : at + 8] = sent[at : at + 8][::-1]
    return sent


@pytest.mark.parametrize("seed", range(24))
def test_many_frames_at_once_are_the_same_as_one_by_one_to_the_last_bit(seed):
    sent = damaged(seed)
    alone, together = streamed(sent), NodeStream()
    rng, begin = np.random.default_rng(seed), 0
    frames = frames_of(sent)
    while begin < len(sent):
        end = min(len(sent), begin + int(rng.integers(1, 1500)))
        take_all(together, frames.where(np.arange(begin, end)))
        begin = end
    np.testing.assert_array_equal(rows(together), rows(alone))
    assert memory(together) == memory(alone)


def test_most_of_a_sound_log_goes_many_at_once(monkeypatch):
    sent = Node(jitter=0.0).messages(3000)
    counted = []
    taken = NodeStream.take
    monkeypatch.setattr(
        NodeStream, "take", lambda self, *frame: counted.append(1) or taken(self, *frame)
    )
    take_all(NodeStream(), frames_of(sent))
    assert len(counted) < 0.1 * len(sent)


@pytest.mark.parametrize("seed", [1, 2, 3, 5])
def test_what_is_lost_or_doubled_is_missing_or_there_once(seed, tmp_path):
    sent = damaged(seed)
    segment, _ = read_exo(Log(tmp_path / "log.blf", frames_of(sent)))
    found = rows(streamed(sent))
    assert (np.diff(found[:, 0]) > 0).all()
    ticks = {round(t * 100): at for at, t in enumerate(segment.time)}
    there = [ticks[round(t * 100)] for t in found[:, 0]]
    both = np.isfinite(found[:, 1]) & np.isfinite(segment.raw_angle[there])
    np.testing.assert_array_equal(found[both, 1], segment.raw_angle[there][both])
    # A tick of which only an EXO_ACC came is no sample; none is invented, and hardly one is missed.
    assert both.sum() > 0.95 * np.isfinite(segment.raw_angle).sum()


def test_a_silence_of_seconds_is_as_long_as_the_nodes_clock_says():
    sent = Node(jitter=0.0).messages(1500)
    heard = [each for each in sent if not 4.0 < each.timestamp - EPOCH < 6.6]
    time = rows(streamed(heard))[:, 0]
    gap = np.diff(time).max()
    # 2.6 s are more than the 2.56 s of a counter; the samples until EXO_TIME comes are left out.
    assert 2.6 <= gap < 2.75
    assert time[-1] == pytest.approx(14.99, abs=1e-9)


def test_a_restarted_node_goes_on_by_the_hosts_clock():
    first = Node(first_counter=7, jitter=0.0).messages(700)
    second = Node(device_start=0.5, first_counter=0, jitter=0.0).messages(700, begin=9.0, seed=1)
    time = rows(streamed(first + second))[:, 0]
    assert time[-1] == pytest.approx(9.0 + 6.99, abs=0.0201)
    assert (np.diff(time) > 0).all()


def test_two_nodes_of_one_id_spoil_everything_and_no_sample_comes_any_more():
    one = Node(jitter=0.0).messages(400)
    other = Node(first_counter=100, device_start=99.0, jitter=0.0).messages(400, begin=0.002)
    stream = streamed(sorted(one + other, key=lambda each: each.timestamp))
    assert stream.spoiled == TWO_NODES
    assert rows(stream)[-1, 0] < 1.0


def test_firmware_that_means_something_else_spoils_everything():
    stream = streamed(Node(config_crc=0xBEEF, jitter=0.0).messages(300))
    assert stream.spoiled == OTHER_FIRMWARE
    assert len(stream.ready) <= 4  # EXO_TIME comes with the fourth tick


def test_without_raw_frames_the_filtered_motion_is_taken():
    sent = [each for each in Node(jitter=0.0).messages(300) if each.arbitration_id != 0x102]
    stream = streamed(sent)
    assert stream.filtered
    found = rows(stream)
    assert np.isnan(found[:49, 1]).all()
    true = -np.pi / 2 + 0.9 * np.cos(3.0 * found[60:, 0])
    np.testing.assert_allclose(found[60:, 1], true, atol=2**-13)  # half a count of EXO_STATE


def test_another_node_of_the_bus_is_none_of_this_one():
    sent = Node(node=2, jitter=0.0).messages(200)
    assert not streamed(sent).ready
    assert len(streamed(sent, node=2).ready) == 200


def test_a_clock_of_the_host_that_jumps_moves_no_sample():
    sent = Node(jitter=0.0).messages(600)
    for each in sent[900:]:
        each.timestamp += 3600.0
    time = rows(streamed(sent))[:, 0]
    # Until EXO_TIME tells that no tick was lost, ten at most are left out.
    assert np.diff(time).max() < 0.11
    assert time[-1] == pytest.approx(5.99, abs=1e-9)


def test_frames_of_another_kind_on_the_same_ids_are_passed_over():
    sent = Node(jitter=0.0).messages(100)
    frames = frames_of(sent)
    frames.flags[300:] = EXTENDED
    stream = NodeStream()
    take_all(stream, frames)
    np.testing.assert_array_equal(rows(stream), rows(streamed(sent[:300])))


def test_the_sample_of_a_file_is_that_of_the_log(tmp_path):
    path = write_log(tmp_path / "leg.blf", Node(jitter=0.0).messages(500))
    recording, _ = read_can_log(path)
    stream = NodeStream()
    take_all(stream, read_log(path).frames)
    np.testing.assert_array_equal(rows(stream)[:, 1], recording.segments[0].raw_angle)
