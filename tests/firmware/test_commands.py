"""Commands as the host sends them, read by the firmware as cantools reads them."""

import struct
import subprocess
from binascii import crc_hqx

import cantools
import numpy as np
import pytest

from exoid.recordings.can.dbc import EXOID_DBC, exoid_messages
from exoid.recordings.can.node.config_crc import SEED
from exoid.recordings.commissioning.commands import COMMANDS, command

FRAMES = 5_000  # of each command
SEVERAL = "the bytes behind the serial"
VALUES = {
    "EXO_TELL": None,
    "EXO_SET_ZERO": "Angle",
    "EXO_SET_DIRECTION": "Reversed",
    "EXO_SET_NODE_ID": "NodeId",
    "EXO_SET_BIT_RATE": "BitRate",
    "EXO_IDENTIFY": "Duration",
    "EXO_LOAD": SEVERAL,
    "EXO_ALLOW": SEVERAL,
}


@pytest.fixture
def take(build, tmp_path):
    """Whether each frame is a command, whether it is in range, its serial and its value."""

    def taken(frames: list[tuple[int, bytes]]) -> list[tuple[int, int, int, int]]:
        (tmp_path / "in.bin").write_bytes(b"".join(struct.pack("<H8s", *each) for each in frames))
        program = build("host_commands")
        subprocess.run([program, tmp_path / "in.bin", tmp_path / "out.bin"], check=True, timeout=60)
        return list(struct.iter_unpack("<IIIi", (tmp_path / "out.bin").read_bytes()))

    return taken


def with_check(data: bytes) -> bytes:
    return data[:7] + bytes([crc_hqx(data[:7], SEED) & 0xFF])


def test_every_command_is_known_here():
    assert {*COMMANDS} == {*VALUES}


@pytest.mark.parametrize("name", VALUES)
def test_any_frame_is_read_as_cantools_reads_it(take, name):
    message = cantools.database.load_file(EXOID_DBC).get_message_by_name(name)
    drawn = np.random.default_rng(4).integers(0, 256, (FRAMES, 8), dtype=np.uint8)
    frames = [with_check(row.tobytes()) if row[0] % 2 else row.tobytes() for row in drawn]
    said = VALUES[name]
    signal = message.get_signal_by_name(said) if said and said is not SEVERAL else None
    found = take([(message.frame_id, data) for data in frames])
    for data, (is_command, is_valid, serial, value) in zip(frames, found, strict=True):
        read = message.decode(data, decode_choices=False, scaling=False)
        assert is_command == (data == with_check(data))
        assert serial == read["Serial"]
        if signal:
            assert value == read[signal.name]
            physical = value * signal.scale + signal.offset
            within = signal.minimum - 1e-9 <= physical <= signal.maximum + 1e-9  # of its printing
            assert is_valid == within
        elif said is SEVERAL:
            assert value == int.from_bytes(data[4:7], "little")
            assert is_valid == (read.get("Place", 0) <= 24 and read.get("Wish", 0) <= 2)


@pytest.mark.parametrize(
    ("name", "value", "count"),
    [
        ("EXO_TELL", None, 0),
        ("EXO_SET_ZERO", -np.pi / 2, -1024),
        ("EXO_SET_DIRECTION", 1, 1),
        ("EXO_SET_NODE_ID", 15, 15),
        ("EXO_SET_BIT_RATE", 250_000, 2),
        ("EXO_IDENTIFY", 10, 10),
        ("EXO_LOAD", {"Place": 24, "Data": 0xBEEF}, 0xBEEF18),
        (
            "EXO_ALLOW",
            {"Wish": 2, "Number": 5, "Limit": 2.5, "Acceleration": -1.5},
            2 | 5 << 2 | 10 << 6 | (4096 - 24) << 12,
        ),
    ],
)
def test_what_the_host_sends_is_understood(take, name, value, count):
    values = value if isinstance(value, dict) else {} if value is None else {VALUES[name]: value}
    message = command(name, 0xC0FFEE01, **values)
    assert message.arbitration_id == exoid_messages()[name].identifier
    assert not message.is_extended_id
    assert take([(message.arbitration_id, bytes(message.data))]) == [(1, 1, 0xC0FFEE01, count)]
