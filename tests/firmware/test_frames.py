"""The generated headers: what their sources make now, and bit for bit what cantools packs."""

import importlib.util
import struct
import subprocess
from functools import partial

import cantools
import numpy as np
import pytest
from firmware_tools import FIRMWARE

from exoid.recordings.can.dbc import EXOID_DBC, exoid_messages

RECORDS = 20_000  # of each message
WORDS = 16
LOWEST, HIGHEST = -32768, 32767


@pytest.fixture(scope="module")
def database():
    return cantools.database.load_file(EXOID_DBC)


@pytest.fixture
def pack(build, tmp_path):
    return partial(packed, build("host_frames"), tmp_path)


def packed(program, folder, records):
    """Identifier and data of each record's frame, by the firmware."""
    words = np.zeros((len(records), WORDS), np.uint32)
    words[:, : records.shape[1]] = records
    (folder / "in.bin").write_bytes(words.tobytes())
    subprocess.run([program, folder / "in.bin", folder / "out.bin"], check=True, timeout=60)
    return list(struct.iter_unpack("<H8s", (folder / "out.bin").read_bytes()))


def float_words(values):
    return np.asarray(values, np.float32).view(np.uint32)


def nearest_counts(values, scale):
    """Half away from zero, limited; NaN is the lower limit. Exact: the scales are powers of two."""
    counts = np.asarray(values, float) / scale
    counts = np.clip(np.where(np.isnan(counts), LOWEST, counts), LOWEST, HIGHEST)
    whole = np.trunc(counts)
    return (whole + np.sign(counts) * (np.abs(counts - whole) >= 0.5)).astype(int)


def test_the_headers_are_what_their_sources_make(monkeypatch):
    monkeypatch.syspath_prepend(str(FIRMWARE))
    specification = importlib.util.spec_from_file_location("generate", FIRMWARE / "generate.py")
    generate = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(generate)
    for path, text in generate.headers().items():
        assert path.read_text(encoding="utf-8") == text, f"run python firmware/generate.py: {path}"


def test_state_is_packed_as_cantools_packs_it(pack, database):
    rng = np.random.default_rng(0)
    message = database.get_message_by_name("EXO_STATE")
    names = [signal.name for signal in message.signals]
    spans = (8.0, 32.0, 1024.0)
    values = np.stack([rng.uniform(-1.2 * span, 1.2 * span, RECORDS) for span in spans], axis=1)
    values[:1000] = np.round(values[:1000] * 4096) / 4096 + 0.5 / 4096  # ties of the angle
    edges = [0.49999997, -0.5, 32767.49, 32767.5, -32768.5, -32768.6, np.inf, -np.inf, np.nan]
    values[1000 : 1000 + len(edges), 0] = np.array(edges) / 4096
    values = values.astype(np.float32)
    flags = rng.integers(0, 2, (RECORDS, 8), dtype=np.uint32)
    counter = rng.integers(0, 256, (RECORDS, 1), dtype=np.uint32)
    frames = pack(np.hstack([np.full((RECORDS, 1), 0x101), float_words(values), counter, flags]))

    scales = [message.get_signal_by_name(name).scale for name in names[:3]]
    counts = np.stack([nearest_counts(v, s) for v, s in zip(values.T, scales, strict=True)], axis=1)
    exact = values.astype(float) / scales
    inside = (exact > LOWEST - 0.5) & (exact < HIGHEST + 0.5)
    flags[:, names.index("StateSaturated") - 4] = ~inside.all(axis=1)
    for (identifier, data), row in zip(frames, np.hstack([counts, counter, flags]), strict=True):
        given = dict(zip(names, row.tolist(), strict=True))
        assert identifier == message.frame_id
        assert data == message.encode(given, scaling=False), given


@pytest.mark.parametrize("name", ["EXO_RATIOS", "EXO_RATIO_ERRORS", "EXO_FRICTION"])
def test_ratios_and_errors_are_packed_as_cantools_packs_them(pack, database, name):
    """What is beyond its signal is sent as the limit."""
    rng = np.random.default_rng(3)
    message = database.get_message_by_name(name)
    scales = np.array([signal.scale for signal in message.signals])
    values = (rng.uniform(-1.2, 1.2, (RECORDS, scales.size)) * scales * 2**15).astype(np.float32)
    frames = pack(np.hstack([np.full((RECORDS, 1), message.frame_id), float_words(values)]))
    names = [signal.name for signal in message.signals]
    for (identifier, data), row in zip(frames, nearest_counts(values, scales), strict=True):
        assert identifier == message.frame_id
        assert data == message.encode(dict(zip(names, row.tolist(), strict=True)), scaling=False)


def test_a_torque_is_packed_as_cantools_packs_it(pack, database):
    """NaN would be the lower limit: the firmware sends none."""
    rng = np.random.default_rng(5)
    message = database.get_message_by_name("EXO_TORQUE")
    torque = rng.uniform(-40, 40, RECORDS).astype(np.float32)
    most = (256, 4, 65536, 65536)
    counts = np.stack([rng.integers(0, each, RECORDS) for each in most], axis=1)
    identifiers = np.full((RECORDS, 1), message.frame_id)
    frames = pack(np.hstack([identifiers, float_words(torque)[:, None], counts]))
    names = [signal.name for signal in message.signals]
    given = np.column_stack([nearest_counts(torque, message.signals[0].scale), counts])
    for (identifier, data), row in zip(frames, given, strict=True):
        assert identifier == message.frame_id
        assert data == message.encode(dict(zip(names, row.tolist(), strict=True)), scaling=False)


def test_a_parameter_is_packed_as_cantools_packs_it_and_read_back_to_the_bit(pack, database):
    rng = np.random.default_rng(6)
    message = database.get_message_by_name("EXO_PARAMETER")
    value = (10 ** rng.uniform(-9, 3, RECORDS)).astype(np.float32)
    place, stored, crc = (rng.integers(0, most, RECORDS) for most in (256, 2, 65536))
    identifiers = np.full(RECORDS, message.frame_id)
    frames = pack(np.column_stack([identifiers, place, stored, float_words(value), crc]))
    plan = exoid_messages()["EXO_PARAMETER"]
    raw = np.frombuffer(b"".join(data for _, data in frames), np.uint8).reshape(-1, 8)
    np.testing.assert_array_equal(plan.values(raw, "Value").astype(np.float32), value)
    for (_, data), *row in zip(frames, place, stored, value, crc, strict=True):
        names = ("Place", "Stored", "Value", "Crc")
        given = {name: each.item() for name, each in zip(names, row, strict=True)}
        assert data == message.encode(given)


@pytest.mark.parametrize(
    "name",
    [
        *("EXO_TIME", "EXO_RAW", "EXO_FINE", "EXO_ACC"),
        *("EXO_SETTINGS", "EXO_HEARTBEAT", "EXO_REPLY", "EXO_HEALTH", "EXO_LEARNING"),
    ],
)
def test_counts_are_packed_as_cantools_packs_them(pack, database, name):
    """A count beyond its signal's range is sent as the limit."""
    rng = np.random.default_rng(1)
    message = database.get_message_by_name(name)
    columns, limits = [], []
    for signal in message.signals:
        lower = -(2 ** (signal.length - 1)) if signal.is_signed else 0
        upper = lower + 2**signal.length - 1
        reach = upper - lower if signal.length < 32 else 0
        first = lower - reach // 4 if signal.is_signed else 0
        columns.append(rng.integers(first, upper + reach // 4, RECORDS, endpoint=True))
        limits.append((lower, upper))
    given = np.stack(columns, axis=1)
    identifiers = np.full((RECORDS, 1), message.frame_id)
    frames = pack(np.hstack([identifiers, given]).astype(np.int64).astype(np.uint32))
    kept = np.clip(given, *np.array(limits).T)
    names = [signal.name for signal in message.signals]
    for (identifier, data), row in zip(frames, kept, strict=True):
        assert identifier == message.frame_id
        assert data == message.encode(dict(zip(names, row.tolist(), strict=True)), scaling=False)


def test_a_packed_value_reads_back_to_within_half_a_count(pack, database):
    rng = np.random.default_rng(2)
    values = rng.uniform((-7.9, -31.9, -1023), (7.9, 31.9, 1023), (1000, 3)).astype(np.float32)
    frames = pack(np.hstack([np.full((1000, 1), 0x101), float_words(values)]))
    for (identifier, data), (angle, velocity, acceleration) in zip(frames, values, strict=True):
        read = database.decode_message(identifier, data)
        assert abs(read["Angle"] - angle) <= 0.5 / 4096
        assert abs(read["AngularVelocity"] - velocity) <= 0.5 / 1024
        assert abs(read["AngularAcceleration"] - acceleration) <= 0.5 / 32
