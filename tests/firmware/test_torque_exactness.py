"""One command of a torque, four machines: NumPy float32, C++ here, on a Cortex-M0 and on an M7."""

import subprocess

import numpy as np
import pytest
from float32_torque import (
    ARM,
    ENABLE,
    ENABLED,
    FINE_STEP,
    FINE_TURN,
    GYRO_STEP,
    NAMES,
    Heard,
    TorqueNodes,
)

from exoid.recordings.commissioning.torque_parameters import TorqueParameters, bounds, fields

NODES, TICKS = 260, 4000
WILD = 40  # of the nodes: numbers that no leg shows
EMULATED = (0, 1, NODES - 1)
CYCLE = 300  # ticks from one arming to the next
TOLD = np.dtype([("torque", "<f4"), ("permit", "<u4"), ("doubts", "<u4")])
WILD_NUMBERS = np.array([np.nan, np.inf, -np.inf, 1e30, -1e9, 1e-44, 8.0, -8.0], np.float32)


def legs(rng: np.random.Generator) -> dict[str, np.ndarray]:
    """Of any parameters that a node takes."""
    spans = [bounds(each) for each in fields(TorqueParameters)]
    return {
        name: rng.uniform(*span, NODES).astype(np.float32)
        for name, span in zip(NAMES, spans, strict=True)
    }


def heard(rng: np.random.Generator) -> list[Heard]:
    """Legs that swing, sensors that fail, and hosts that arm, enable, and fall silent."""
    time = np.arange(TICKS)[:, None] * 0.01
    size, speed, phase = rng.uniform((0, 1, 0), (1.2, 8, 7), (NODES, 3)).T
    angle = size * np.sin(speed * time + phase) - 0.8
    velocity = size * speed * np.cos(speed * time + phase)
    bias = rng.normal(0, 0.1, NODES)
    shape = angle.shape
    measured = angle + (rng.random(shape) < 2e-4) * rng.uniform(-3, 3, shape)
    gyro = velocity + bias + rng.normal(0, 3e-3, shape)
    single = [each.astype(np.float32) for each in (angle, velocity, np.broadcast_to(bias, shape))]
    for each in single:
        wild = rng.random(shape) < 0.002 * (np.arange(NODES) >= NODES - WILD)
        each[wild] = rng.choice(WILD_NUMBERS, wild.sum())
    at = (np.arange(TICKS)[:, None] + rng.integers(0, CYCLE, NODES)) % CYCLE
    wish = np.where(at < 12, ARM, ENABLE)
    wish = np.where(rng.random(shape) < 1e-3, rng.integers(0, 3, shape), wish)
    hears = (rng.random(shape) < 0.5) & ~silent(rng, shape)
    columns = (
        (np.rint(measured / FINE_STEP).astype(int) + FINE_TURN // 2) % FINE_TURN,
        np.rint(gyro / GYRO_STEP).astype(int),
        *single,
        (rng.random(shape) < 1e-3) * rng.integers(1, 256, shape),
        hears,
        wish,
        np.cumsum(hears * (rng.random(shape) > 0.02), axis=0) % 16,
        rng.integers(0, 64, shape),
        rng.uniform(-3, 3, shape).astype(np.float32),
    )
    return [Heard(*each) for each in zip(*columns, strict=True)]


def silent(rng: np.random.Generator, shape) -> np.ndarray:
    """For up to 20 ticks at a time."""
    begins = rng.random(shape) < 1e-3
    lasting = np.ones(20, int)
    return np.stack([np.convolve(each, lasting)[: len(each)] for each in begins.T], axis=1) > 0


@pytest.fixture(scope="module")
def given():
    rng = np.random.default_rng(8)
    return legs(rng), heard(rng)


@pytest.fixture(scope="module")
def expected(given):
    """Of each node, tick after tick."""
    leg, ticks = given
    nodes = TorqueNodes(leg)
    found = np.zeros((TICKS, NODES), TOLD)
    for row, now in zip(found, ticks, strict=True):
        for name, each in zip(TOLD.names or (), nodes.tick(now), strict=True):
            row[name] = each
    return found.T


def written(given, nodes) -> bytes:
    """The file of these nodes."""
    leg, ticks = given
    columns = [np.stack([getattr(now, name) for now in ticks]) for name in vars(ticks[0])]
    words = [
        each.view("<u4") if each.dtype == np.float32 else each.astype("<i4").view("<u4")
        for each in columns
    ]
    table = np.stack(words, axis=2)
    return b"".join(
        np.array([leg[name][node] for name in NAMES], "<f4").tobytes()
        + np.uint32(TICKS).tobytes()
        + table[:, node].tobytes()
        for node in nodes
    )


def test_the_samples_are_a_million_and_every_doubt_is_met(expected):
    assert expected.size >= 1_000_000
    doubts = np.bitwise_or.reduce(expected["doubts"], axis=None)
    assert doubts == 0xFF | 1 << 8 | 1 << 10 | 1 << 11 | 1 << 12  # all but that of no parameters
    assert (expected["permit"] == ENABLED).mean() > 0.3  # else hardly a torque is compared
    assert np.unique(expected["torque"]).size > 100_000


def test_numpy_and_this_machine_agree_to_the_bit(build, given, expected, tmp_path):
    (tmp_path / "in.bin").write_bytes(written(given, range(NODES)))
    program = build("host_torque")
    subprocess.run([program, tmp_path / "in.bin", tmp_path / "out.bin"], check=True, timeout=60)
    found = np.frombuffer((tmp_path / "out.bin").read_bytes(), TOLD).reshape(expected.shape)
    for name in TOLD.names or ():
        np.testing.assert_array_equal(found[name], expected[name], err_msg=name)
    assert found.tobytes() == expected.tobytes()


@pytest.mark.parametrize("image", ["m0_torque.elf", "m7_torque.elf"])
def test_the_emulated_processors_agree_to_the_bit(emulate, given, expected, tmp_path, image):
    found = emulate(image, written(given, EMULATED), tmp_path)
    assert found == expected[list(EMULATED)].tobytes()
