"""Plain frames that a logger heard on a channel that knows FD: in objects of other kinds."""

import can
import numpy as np
import pytest
from can.io.blf import CAN_FD_MSG_64_STRUCT, CAN_FD_MSG_STRUCT
from exo_node import EPOCH, Node, write_log

from exoid.recordings.can.logs.blf import read_blf
from exoid.recordings.can.logs.log_files import frames_of, row_of
from exoid.recordings.loading.can_log import read_can_log

TICKS = 50


def in_fd_message(message: can.Message) -> tuple[int, bytes]:
    """What CAN_FD_MESSAGE holds."""
    flags, data = 0x80 * message.is_remote_frame, bytes(message.data)
    fd = int(message.is_fd)
    said = (1, flags, message.dlc, name_of(message), 0, 0, fd, len(data), data)
    return 100, CAN_FD_MSG_STRUCT.pack(*said)


def in_fd_message_64(message: can.Message) -> tuple[int, bytes]:
    """What CAN_FD_MESSAGE_64 holds, which ends with its data."""
    data = bytes(message.data)
    flags = 0x10 * message.is_remote_frame | 0x1000 * message.is_fd
    said = (1, message.dlc, len(data), 0, name_of(message), 0, flags)
    return 101, CAN_FD_MSG_64_STRUCT.pack(*said, *[0] * 8) + data


def name_of(message: can.Message) -> int:
    return message.arbitration_id | 0x80000000 * message.is_extended_id


def write_on_fd_channel(path, messages, layout):
    with can.BLFWriter(path) as writer:
        for each in messages:
            kind, content = layout(each)
            writer._add_object(kind, content, each.timestamp)
    return path


@pytest.fixture(params=[in_fd_message, in_fd_message_64], ids=["100", "101"])
def layout(request):
    return request.param


def test_a_session_on_an_fd_channel_is_the_session_on_a_plain_one(tmp_path, layout):
    messages = Node().messages(TICKS)
    plain, _ = read_can_log(write_log(tmp_path / "plain.blf", messages))
    heard, quality = read_can_log(write_on_fd_channel(tmp_path / "fd.blf", messages, layout))
    assert quality.frames.used == len(messages)
    np.testing.assert_array_equal(heard.segments[0].raw_angle, plain.segments[0].raw_angle)
    np.testing.assert_array_equal(heard.segments[0].time, plain.segments[0].time)


def test_its_frames_are_those_that_python_can_reads(tmp_path, layout):
    odd = [
        can.Message(timestamp=EPOCH + 1, arbitration_id=7, is_remote_frame=True),
        can.Message(timestamp=EPOCH + 1, arbitration_id=7, is_fd=True, data=bytes(8)),
        can.Message(timestamp=EPOCH + 1, arbitration_id=0x101, is_extended_id=False, data=b"abc"),
        can.Message(timestamp=EPOCH + 1, arbitration_id=9, data=b"LOBJLOBJ"),
    ]
    path = write_on_fd_channel(tmp_path / "fd.blf", [*odd, *Node().messages(TICKS)], layout)
    ours = read_blf(path).frames
    with can.BLFReader(path) as reader:
        theirs = frames_of([row_of(each) for each in reader])
    for name in ("time", "identifier", "flags", "data"):
        np.testing.assert_array_equal(getattr(ours, name), getattr(theirs, name))


def test_data_that_an_object_cuts_short_are_zeros(tmp_path):
    messages = Node().messages(2)

    def cut(message):
        kind, content = in_fd_message_64(message)
        return kind, content[:-4]

    path = write_on_fd_channel(tmp_path / "fd.blf", messages, cut)
    with can.BLFReader(path) as reader:
        theirs = frames_of([row_of(each) for each in reader])
    ours = read_blf(path).frames
    np.testing.assert_array_equal(ours.data, theirs.data)
    assert not ours.data[:, 4:].any()
