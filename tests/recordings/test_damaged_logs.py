"""Damage that a reader could take for frames is found: it costs what it touched, and is told."""

import struct
import zlib

import numpy as np
import pytest
from exo_node import Node, write_log

from exoid.recordings.can.logs.blf import read_blf
from exoid.recordings.can.logs.blf_blocks import MOST_UNPACKED
from exoid.recordings.can.logs.log_files import read_log

HEADER, BLOCK = 144, 32  # bytes of a BLF's own head and of a block's
SIZE, DECLARED = HEADER + 8, HEADER + 24  # where a block says how long it is, packed and not
OBJECT = 48  # bytes of a frame in a block


@pytest.fixture(scope="module")
def messages():
    return Node().messages(20)


@pytest.fixture
def blf(tmp_path, messages):
    """A log of one block."""
    return write_log(tmp_path / "leg.blf", messages)


def repacked(content: bytes, change) -> bytes:
    """The log with other objects in its block, and all checksums right."""
    end = HEADER + struct.unpack_from("<L", content, SIZE)[0]
    objects = change(bytearray(zlib.decompress(content[HEADER + BLOCK : end])))
    packed, head = zlib.compress(objects), bytearray(content[: HEADER + BLOCK])
    struct.pack_into("<L", head, SIZE, BLOCK + len(packed))
    struct.pack_into("<L", head, DECLARED, len(objects))
    return bytes(head + packed)


def test_a_byte_that_pushes_a_blocks_checksum_out_is_noticed(blf):
    """All of its rows unpack, some of them to other numbers."""
    content = blf.read_bytes()
    for at in range(HEADER + BLOCK + 2, HEADER + BLOCK + 200, 7):
        blf.write_bytes(content[:at] + b"\x55" + content[at:])
        log = read_blf(blf)
        assert len(log.frames) == 0
        assert f"the block at byte {HEADER} is damaged and left out" in str(log.stopped)


@pytest.mark.parametrize("change", [-OBJECT, -1, 1, OBJECT])
def test_a_block_that_declares_another_length_is_left_out(blf, change):
    content = bytearray(blf.read_bytes())
    (declared,) = struct.unpack_from("<L", content, DECLARED)
    struct.pack_into("<L", content, DECLARED, declared + change)
    blf.write_bytes(content)
    assert "bytes and holds others" in str(read_blf(blf).stopped)


def test_a_block_that_is_packed_in_an_unknown_way_is_left_out(blf):
    content = bytearray(blf.read_bytes())
    content[HEADER + 16] = 9
    blf.write_bytes(content)
    assert "packed in a way 9 that nobody knows" in str(read_blf(blf).stopped)


def bomb(blf, declared: int, unpacked: int) -> None:
    """A block of zeros that a thousand times as few bytes hold."""
    head = bytearray(blf.read_bytes()[: HEADER + BLOCK])
    packer = zlib.compressobj(9)
    packed = b"".join(packer.compress(bytes(1 << 20)) for _ in range(unpacked >> 20))
    packed += packer.flush()
    struct.pack_into("<L", head, SIZE, BLOCK + len(packed))
    struct.pack_into("<L", head, DECLARED, declared)
    blf.write_bytes(head + packed)


@pytest.mark.parametrize("declared", [4096, 8 * MOST_UNPACKED])
def test_a_block_takes_no_more_memory_than_a_log_can(blf, declared):
    """0.5 MB that would be 512 MB, declared or not: Python's own count stays below 20 MB."""
    import tracemalloc

    bomb(blf, declared, 8 * MOST_UNPACKED)
    tracemalloc.start()
    try:
        log = read_blf(blf)
        most = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert f"it declares {declared} bytes" in str(log.stopped)
    assert most < 20e6


def cut_short(objects):
    struct.pack_into("<L", objects, 3 * OBJECT + 8, 16)
    return objects


def of_version_9(objects):
    objects[3 * OBJECT + 6] = 9
    return objects


def without_signature(objects):
    objects[3 * OBJECT] ^= 1
    return objects


@pytest.mark.parametrize("change", [cut_short, of_version_9, without_signature])
def test_a_damaged_object_is_told_though_every_checksum_is_right(blf, change):
    whole = read_blf(blf)
    blf.write_bytes(repacked(blf.read_bytes(), change))
    log = read_blf(blf)
    assert "1 damaged object in the blocks" in str(log.stopped)
    assert len(log.frames) >= len(whole.frames) - 1
    assert np.isin(log.frames.time, whole.frames.time).all()


# One frame of the 40th line, as each format writes it, and ways in which it is no frame any more.
DAMAGE = {
    ".asc": [("d 8 ", "d 7 "), (" 00 ", " 0 "), (" 00 ", " 00 00 "),
             (" Rx ", " Rq "), ("  10", "  810"), (" 1  1", " 1  +1")],
    ".log": [("#", "#0"), ("#", "#00"), (") ", ")"), ("#", "##"), (" R\n", " Q\n"),
             ("vcan0 1", "vcan0 8")],
    ".trc": [(" 8   ", " 7   "), (" 00 ", " 0 "), (" 00 ", " 00 00 "), ("DT", "DX"), ("Rx", "Ry"),
             (" 01", " 91")],
    ".csv": [(",8,", ",7,"), (",0,0,", ",0,2,"), ("0x1", "0x91"), ("=\n", "\n"), ("0x", "0x1_"),
             ("=\n", "==\n")],
}  # fmt: skip


@pytest.mark.parametrize(
    ("suffix", "good", "bad"), [(suffix, *each) for suffix in DAMAGE for each in DAMAGE[suffix]]
)
def test_a_line_that_is_not_written_as_a_frame_is_counted_and_left_out(
    tmp_path, messages, suffix, good, bad
):
    path = write_log(tmp_path / f"leg{suffix}", messages)
    whole = read_log(path)
    assert whole.stopped is None
    lines = path.read_text().splitlines(keepends=True)
    number = next(n for n in range(39, len(lines)) if good in lines[n])
    lines[number] = lines[number].replace(good, bad, 1)
    path.write_text("".join(lines))
    log = read_log(path)
    assert f"1 damaged line left out, first line {number + 1} " in str(log.stopped)
    assert len(log.frames) == len(whole.frames) - 1
    assert np.isin(log.frames.data.view("u8"), whole.frames.data.view("u8")).all()


def test_what_is_no_frame_is_not_called_damaged(tmp_path, messages):
    """Remarks, errors, statistics and frames with what a tool writes behind them."""
    path = write_log(tmp_path / "leg.asc", messages)
    others = (
        "   0.015991 CAN 1 Status:chip status error passive - TxErr: 132 RxErr: 0",
        "   1.015991 1  Statistic: D 0 R 0 XD 0 XR 0 E 0 O 0 B 0.00%",
        "   2.501010 1 ErrorFrame ECC: 10100010",
        "   2.510001 2 100 Tx r",
        "   3.297743 1  J1939TP FEE3p        6    0  0   -   Rx   d 23 A0 0F A6 60",
        "   3.09 1  18EBFF00x   Rx d 8 01 A0 0F A6 60 3B D1 40    Length = 273910 ID = 418119424x",
    )
    content = path.read_text().replace("End TriggerBlock", "\n".join([*others, "// end"]))
    path.write_text(content)
    log = read_log(path)
    assert log.stopped is None
    assert len(log.frames) == len(messages) + 3


@pytest.mark.parametrize("header", ["", "date Sam Sep 30 15:06:13.191 2017\n"])
def test_the_first_frame_below_a_short_header_is_kept(tmp_path, header):
    path = tmp_path / "leg.asc"
    frames = "".join(f"   0.{n}19968 1  64   Rx   d 2 64 0{n}\n" for n in range(4))
    path.write_text(header + frames)
    assert read_log(path).frames.data[:, 1].tolist() == [0, 1, 2, 3]


def test_decimal_bytes_stay_decimal_where_the_header_was_damaged(tmp_path):
    """python-can's reader has forgotten the base by then."""
    path = tmp_path / "leg.asc"
    frames = "".join(f"   0.{n}19968 1  100   Rx   d 2 10 {n}\n" for n in range(4))
    path.write_text("daze Sam\nbase dec  timestamps absolute\n" + frames)
    log = read_log(path)
    assert log.frames.data[:, :2].tolist() == [[10, n] for n in range(4)]
    assert log.frames.identifier.tolist() == [100] * 4
