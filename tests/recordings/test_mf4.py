"""The columns of an MF4 file hold what python-can's reader finds in it, one frame at a time."""

import struct

import can
import numpy as np
import pytest
from exo_node import EPOCH, Node, mf4_writer, write_log

from exoid.files.foreign import read_apart
from exoid.recordings.can.frames import CanLogError, Frames
from exoid.recordings.can.logs import mf4
from exoid.recordings.can.logs.log_files import frames_of, read_log, row_of
from exoid.recordings.can.logs.mf4 import read_frames

REAL = (
    "css_LOG_17BD1DB7_00000006_00000170.MF4",
    "css_LOG_2F6913DB_00000004_00000001.MF4",
    "css_LOG_94C49784_00000005_00000002.MF4",
    "css_LOG_FCBF0606_00003482_00000001-60B621D9.MF4",
)


def check_same(path):
    columns = read_frames(path)
    assert str(columns.pop("stopped")) == ""
    with can.LogReader(path) as reader:
        expected = frames_of([row_of(message) for message in reader])
    found = Frames(**columns)
    for name, each in vars(expected).items():
        np.testing.assert_array_equal(getattr(found, name), each, err_msg=name, strict=True)


@pytest.mark.parametrize("name", REAL)
def test_a_real_file_is_read_as_python_can_reads_it(name, shared):
    check_same(shared / "can-logs" / name)


@pytest.mark.parametrize("chunk", [7, 100_000])
def test_frames_of_all_kinds_are_merged_in_their_order(tmp_path, monkeypatch, chunk):
    """Data, FD, error and remote frames, the clock set back among them."""
    monkeypatch.setattr(mf4, "CHUNK", chunk)
    rng = np.random.default_rng(4)
    path = tmp_path / "leg.mf4"
    writer = mf4_writer(path)
    for number in range(60):
        kind = ("data", "fd", "error", "remote")[rng.integers(4)]
        size = int(rng.integers(9)) if kind != "fd" else 64
        writer.on_message_received(
            can.Message(
                timestamp=EPOCH + 0.01 * number - (0.2 if number > 40 else 0.0),
                arbitration_id=int(rng.integers(2**11)),
                is_extended_id=bool(rng.integers(2)),
                is_fd=kind == "fd",
                is_error_frame=kind == "error",
                is_remote_frame=kind == "remote",
                dlc=size,
                data=None if kind == "remote" else rng.bytes(size),
            )
        )
    writer.stop()
    check_same(path)


def test_a_file_that_asammdf_cannot_parse_says_why(tmp_path):
    path = tmp_path / "leg.mf4"
    path.write_bytes(b"MDF     4.10    " + bytes(200))
    columns = read_apart(read_frames, path, "")  # here asammdf fails once more as it is freed
    assert len(columns["time"]) == 0
    assert str(columns["stopped"]) != ""


def test_an_mf4_group_that_links_to_itself_is_ended_within_seconds(tmp_path):
    path = write_log(tmp_path / "leg.mf4", Node().messages(20))
    content = bytearray(path.read_bytes())
    at = content.index(b"##CG")
    struct.pack_into("<Q", content, at + 24, at)  # its first link: the next group
    path.write_bytes(content)
    # 3 s of the processor and 14 kB of the file, wherever else the machine spends its time
    with pytest.raises(CanLogError, match=r"leg\.mf4: reading it took longer than 3 s"):
        read_log(path)


def test_mf4_records_without_their_identifier_are_no_frames():
    samples = np.zeros(3, [("CAN_DataFrame.DataLength", "u1"), ("CAN_DataFrame.DataBytes", "8u1")])
    with pytest.raises(ValueError, match="its frames have no ID"):
        mf4.frames_of(np.zeros(3), "CAN_DataFrame", samples)


def test_a_channel_that_lies_outside_of_its_record_is_told(tmp_path):
    """asammdf gives for it whatever stands in the memory behind the records."""
    path = write_log(tmp_path / "leg.mf4", Node().messages(20))
    content = bytearray(path.read_bytes())
    at = content.index(b"##CN", content.index(b"##CN") + 4)  # the first is the time
    links = struct.unpack_from("<Q", content, at + 16)[0]
    struct.pack_into("<L", content, at + 24 + 8 * links + 4, 60_000)  # its place in a record
    path.write_bytes(content)
    assert "lies outside of its records" in str(read_frames(path)["stopped"])


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        (b"CAN_ErrorFrame\0", b"CAN_ErrorFrale\0", "has a channel without its name"),
        (b"CAN_DataFrame.IDE\0", bytes(18), "has a channel without its name"),
        (b"\6\0.\0", b"\0\0.\0", "is not marked as one"),  # flags of a group, and a path's "."
    ],
)
def test_a_group_of_frames_that_is_no_longer_known_as_one_is_told(tmp_path, old, new, why):
    path = tmp_path / "leg.mf4"
    odd = can.Message(timestamp=EPOCH + 9, is_error_frame=True)
    content = write_log(path, [*Node().messages(20), odd]).read_bytes()
    assert content.count(old) == (1 if old[0] == ord("C") else 3)
    path.write_bytes(content.replace(old, new))
    assert why in str(read_frames(path)["stopped"])


def test_frames_without_times_are_told(tmp_path):
    """asammdf numbers them instead."""
    path = write_log(tmp_path / "leg.mf4", Node().messages(20))
    content = bytearray(path.read_bytes())
    at = content.index(b"##CN")  # of the time
    links = struct.unpack_from("<Q", content, at + 16)[0]
    assert content[at + 24 + 8 * links] == 2  # its kind: a master
    content[at + 24 + 8 * links] = 0
    path.write_bytes(content)
    assert "has no times" in str(read_frames(path)["stopped"])


def test_an_identifier_that_is_no_integer_is_told(tmp_path):
    """asammdf makes a number of whatever its bytes are said to be."""
    path = write_log(tmp_path / "leg.mf4", Node().messages(20))
    content = bytearray(path.read_bytes())
    name = content.index(b"CAN_DataFrame.ID\0") - 24  # its block, to which its channel links
    at = content.index(struct.pack("<Q", name)) - 40  # the third of the channel's links
    links = struct.unpack_from("<Q", content, at + 16)[0]
    assert content[at : at + 4] == b"##CN"
    content[at + 24 + 8 * links + 2] = 13  # a date
    path.write_bytes(content)
    assert "is no integer" in str(read_frames(path)["stopped"])


def test_a_channel_that_begins_beyond_the_bits_of_its_byte_is_told(tmp_path):
    path = write_log(tmp_path / "leg.mf4", Node().messages(20))
    content = bytearray(path.read_bytes())
    name = content.index(b"CAN_DataFrame.ID\0") - 24
    at = content.index(struct.pack("<Q", name)) - 40
    links = struct.unpack_from("<Q", content, at + 16)[0]
    content[at + 24 + 8 * links + 3] = 13  # the bit of its first byte
    path.write_bytes(content)
    assert "lies outside" in str(read_frames(path)["stopped"])
