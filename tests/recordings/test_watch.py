"""While a bus is recorded, a person is told what is lost, what is wrong, and what time it is."""

from itertools import count

import can
import numpy as np
import pytest
from exo_node import EPOCH, Node, health

from exoid.recordings.can.node.config_crc import config_crc
from exoid.recordings.live import watch as watch_module
from exoid.recordings.live.watch import Watch
from exoid.recordings.loading.can_log import read_can_log
from live_node import numbered


@pytest.fixture
def said():
    return []


def watched(messages, said) -> Watch:
    watch = Watch(said.append, config_crc())
    for message in messages:
        watch.see(message)
    return watch


def by_tick(node, ticks):
    """Every frame of a node with the tick it belongs to."""
    messages = iter(node.messages(ticks))
    for tick in range(ticks):
        for _ in node.frames(tick):
            yield tick, next(messages)


@pytest.mark.parametrize(
    "where", [[], [0], [57], [9, 10, 11], [100, 120, 599], list(range(99, 290))]
)
def test_lost_ticks_are_counted_by_every_frame_that_carries_them(said, where):
    kept = [m for tick, m in by_tick(Node(), 600) if tick not in where or m.arbitration_id == 0x100]
    inside = [tick for tick in where if 0 < tick < 599]
    assert watched(kept, said).ticks.lost == 3 * len(inside)
    assert said == []


@pytest.mark.parametrize("silence", [0.0, 0.8, 30.0, 700.0])
def test_the_live_clock_is_the_nodes_as_the_log_has_it(tmp_path, said, silence):
    node = Node(skew=1.02, jitter=0.0)
    sent = node.messages(round(300 + 100 * silence))
    heard = [m for m in sent if not 0 <= m.timestamp - EPOCH - 1.5 < silence / 1.02]
    watch = watched(heard, said)
    path = tmp_path / "leg.blf"
    with can.BLFWriter(path) as writer:
        for message in heard:
            writer.on_message_received(message)
    recording, quality = read_can_log(path)
    nodes = recording.segments[0].time[-1] / quality.clock_rate.factor
    assert watch.seconds == pytest.approx(nodes, abs=1e-6)


def test_the_clock_runs_on_over_a_restart_of_the_node(said):
    first = Node(first_counter=7).messages(700)
    second = Node(device_start=0.5, first_counter=0).messages(700, begin=9.0, seed=1)
    watch = watched(first + second, said)
    # Host time, with 1.5 ms of jitter, says how long the restart took: to the nearest tick.
    assert watch.seconds == pytest.approx(9.0 + 6.99, abs=0.0101)
    assert (watch.ticks.restarts, watch.ticks.lost) == (1, 0)


def test_faults_are_counted_and_the_last_motion_is_shown(said):
    status = {tick: {"MagnetMissing": 1} for tick in (5, 6, 7)}
    now = watched(Node(status=status).messages(60), said).status(bad=4)
    assert now.faults == (("MagnetMissing", 3),)
    assert now.bad == 4
    assert now.angle == pytest.approx(-np.pi / 2 + 0.9 * np.cos(3.0 * 0.59), abs=2**-13)
    assert now.angular_velocity == pytest.approx(-2.7 * np.sin(3.0 * 0.59), abs=2**-11)


def test_firmware_of_before_whose_frames_mean_the_same_is_no_other(said):
    watched(Node(config_crc=0x99CA).messages(100), said)
    assert said == []


def test_another_configuration_is_named_once_and_the_frames_count(said):
    watch = watched(Node(config_crc=0xBEEF).messages(100), said)
    (sentence,) = said
    assert f"ConfigCrc 0xBEEF, here 0x{config_crc():04X}" in sentence
    assert watch.ours == watch.frames


@pytest.mark.parametrize("counter", [250, 251, 249, 100])
def test_a_second_node_on_the_same_ids_is_named_once(said, counter):
    one = Node(jitter=0.0).messages(100)
    other = Node(first_counter=counter, device_start=99.0, jitter=0.0).messages(100, begin=0.002)
    for number, message in enumerate(m for m in other if m.arbitration_id == 0x101):
        message.data[0] = number % 256  # it hangs on another leg
    watched(sorted(one + other, key=lambda m: m.timestamp), said)
    assert len(said) == 1
    assert "two nodes send with the same ids" in said[0]


def test_one_node_whose_frames_are_lost_or_doubled_is_not_taken_for_two(said):
    chosen = np.random.default_rng(0).random(3100) < 0.5
    sent = [m for m, keep in zip(Node().messages(1000), chosen, strict=True) if keep]
    watched([m for m in sent for _ in range(2)], said)
    assert said == []


@pytest.mark.parametrize(
    ("before", "bad", "cause"),
    [
        ([], 0, "nothing comes. Is this the node's port"),
        ([], 3, "3 lines came, no frames: something else speaks there"),
        (numbered(1), 0, "none of 0x100"),
        (Node().messages(10), 0, "it has fallen silent"),
    ],
)
def test_silence_is_named_with_its_likely_cause(said, monkeypatch, before, bad, cause):
    clock = count(0.0, 0.01)
    monkeypatch.setattr(watch_module.time, "monotonic", lambda: next(clock))
    watch = watched(before, said)
    for _ in range(round(3 * watch_module.SILENCE / 0.01)):
        watch.check_silence(bad)
    assert len(said) == 1
    assert cause in said[0]


def test_errors_on_the_bus_are_named(said):
    watch = watched([can.Message(is_error_frame=True)] * 3, said)
    assert watch.errors == 3
    assert len(said) == 1
    assert "Check the bit rate" in said[0]


def test_what_the_node_says_of_its_health_is_told_once_and_is_no_loss(said):
    sent = Node().messages(300)
    for at in (250, 500, 750):
        sent.insert(at, health(sent[at].timestamp, WatchdogReset=1, CanStarts=5))
    assert watched(sent, said).ticks.lost == 0
    assert len(said) == 1
    assert "watchdog has reset it" in said[0]
