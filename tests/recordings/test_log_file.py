"""What a bus sends is in the log, and on disk while the recording goes on."""

from pathlib import Path

import can
import pytest
from exo_node import Node

from exoid.recordings.can.frames import CanLogError
from exoid.recordings.can.logs.log_files import read_log
from exoid.recordings.can.node.config_crc import config_crc
from exoid.recordings.live.bus import LiveBus
from exoid.recordings.live.channel.address import BusAddress
from exoid.recordings.live.log_file import LogFile, check_kind
from exoid.recordings.live.record import record
from exoid.recordings.live.watch import Watch
from live_node import numbered


@pytest.mark.parametrize("suffix", [".blf", ".asc", ".log"])
def test_what_was_sent_is_in_the_log(tmp_path, suffix):
    said = []
    messages = Node().messages(200)
    sender = can.Bus(interface="virtual", channel=suffix)
    bus = LiveBus(BusAddress("virtual", suffix, 500_000), said.append)
    log, watch = LogFile(tmp_path / f"leg{suffix}"), Watch(said.append, config_crc())
    for message in messages:
        sender.send(message)
    record(bus, log, watch, lambda: watch.frames < len(messages))
    log.close()
    read = read_log(tmp_path / f"leg{suffix}")
    assert read.stopped is None
    assert read.announced == read.found
    assert [row.tobytes() for row in read.frames.data] == [bytes(m.data) for m in messages]
    assert said == []
    bus.close()
    sender.shutdown()


@pytest.mark.parametrize(
    ("name", "hint"), [("leg.db", "loses frames"), ("leg.csv", "ends in .blf")]
)
def test_a_format_that_is_not_recorded_is_refused(name, hint):
    with pytest.raises(CanLogError, match=hint):
        check_kind(Path(name))


def test_a_file_that_is_there_is_left_alone(tmp_path):
    path = tmp_path / "leg.blf"
    path.write_bytes(b"old")
    with pytest.raises(FileExistsError):
        LogFile(path).write(numbered(1)[0])
    assert path.read_bytes() == b"old"
    log = LogFile(path, replace=True)
    log.write(numbered(1)[0])
    log.close()
    assert len(read_log(path).frames) == 1


@pytest.mark.parametrize("suffix", [".blf", ".asc", ".log"])
def test_a_full_disk_ends_a_recording_in_one_sentence(tmp_path, suffix):
    path = tmp_path / f"leg{suffix}"
    path.symlink_to("/dev/full")
    log = LogFile(path, replace=True)
    log.write(numbered(1)[0])
    with pytest.raises(CanLogError, match=r"No space left on device after 1 frames\. .* Make room"):
        log.save()
    log.close()  # there is nothing left to complain about


@pytest.mark.parametrize("suffix", [".blf", ".asc", ".log"])
def test_what_is_saved_can_be_read_while_the_recording_goes_on(tmp_path, suffix):
    log = LogFile(tmp_path / f"leg{suffix}")
    for message in numbered(100):
        log.write(message)
    log.save()
    log.write(numbered(1)[0])
    assert len(read_log(tmp_path / f"leg{suffix}").frames) == 100
    log.close()
    assert len(read_log(tmp_path / f"leg{suffix}").frames) == 101
