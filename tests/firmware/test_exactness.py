"""One filter, four machines: NumPy float32, C++ here, C++ on a Cortex-M0, and JAX."""

import subprocess

import float32_node
import jax.numpy as jnp
import numpy as np
import pytest
from motions import measured, with_losses

from exoid.recordings.filter import kalman

SAMPLES = 60_000
WILD = 2_000  # samples of any magnitude at the end: sums that cancel, subnormal products
INSTRUCTIONS_PER_COUNT = 62.5  # of SysTick at 16 MHz, with one instruction per nanosecond
BATCH = 10  # steps that m0_cost times together
BUDGET = 13_000  # instructions for a step, of the 480 000 cycles of a tick at 48 MHz
TICK_BUDGET = 48_000  # instructions for all that a tick does, 10 % of it


@pytest.fixture(scope="module")
def given():
    """Angle and rate: a motion with losses, then values that no sensor sends."""
    rng = np.random.default_rng(4)
    columns = []
    for seed, values in enumerate(measured(SAMPLES - WILD)):
        wild = (rng.choice([-1, 1], WILD) * 10 ** rng.uniform(-44, 15, WILD)).astype(np.float32)
        columns.append(np.concatenate([with_losses(values, 0.03, seed), wild]))
    return np.stack(columns, axis=1)


@pytest.fixture(scope="module")
def expected(given):
    return float32_node.run(*given.T)


def test_this_machine_computes_the_firmwares_filter_as_numpy_does(build, given, expected, tmp_path):
    (tmp_path / "in.bin").write_bytes(given.tobytes())
    subprocess.run(
        [build("host_filter"), tmp_path / "in.bin", tmp_path / "out.bin"], check=True, timeout=60
    )
    assert (tmp_path / "out.bin").read_bytes() == expected.tobytes()


def test_the_microcontroller_computes_it_to_the_same_bit(emulate, given, expected, tmp_path):
    assert emulate("m0_filter.elf", given.tobytes(), tmp_path) == expected.tobytes()


def test_a_processor_with_floating_point_computes_it_to_the_same_bit(
    emulate, given, expected, tmp_path
):
    """A Cortex-M7 could fuse each product with its sum; it is told not to."""
    assert emulate("m7_filter.elf", given.tobytes(), tmp_path) == expected.tobytes()


def test_a_sample_that_is_not_finite_never_reaches_the_filter(build, tmp_path):
    angle, rate = measured(500)
    angle[100], rate[100] = np.inf, -np.inf
    given = np.stack([angle, rate], axis=1)
    (tmp_path / "in.bin").write_bytes(given.tobytes())
    subprocess.run(
        [build("host_filter"), tmp_path / "in.bin", tmp_path / "out.bin"], check=True, timeout=60
    )
    found = np.frombuffer((tmp_path / "out.bin").read_bytes(), np.float32)
    angle[100] = rate[100] = np.nan
    np.testing.assert_array_equal(found.reshape(-1, 14), float32_node.run(angle, rate))


def test_jax_agrees_within_its_own_rounding():
    """XLA fuses and reorders, so not to the bit; several times the worst that was ever seen."""
    angle, rate = measured(SAMPLES)
    expected = float32_node.run(angle, rate)[:, :3]
    steps = np.full(SAMPLES - 1, np.float32(0.01))
    for dtype in (jnp.float32, jnp.float64):
        given = (jnp.asarray(column, dtype) for column in (angle, rate))
        state = np.asarray(kalman.filter(steps, *given).state)
        worst = np.abs(state - expected).max(axis=0)
        assert np.all(worst < (2e-6, 2e-5, 5e-4)), worst  # rad, rad/s, rad/s^2


def test_a_step_stays_within_its_budget_and_costs_the_same_each_time(emulate, tmp_path):
    given = np.stack(measured(2_000), axis=1).tobytes()
    options = ("-icount", "shift=0")
    first = emulate("m0_cost.elf", given, tmp_path, *options)
    assert first == emulate("m0_cost.elf", given, tmp_path, *options)
    counts = np.frombuffer(first, np.uint32)
    assert counts.size == 200
    cost = counts * INSTRUCTIONS_PER_COUNT / BATCH
    print(f"{cost.mean():.0f} instructions a step, at most {cost.max():.0f}")
    assert 5_000 < cost.mean() < cost.max() < BUDGET  # below: it did not filter at all


def test_a_whole_tick_stays_within_its_budget_on_can_and_with_a_host_on_usb_beside_it(
    emulate, tmp_path
):
    given = bytes([0] * 200 + [1] + [0] * 199)
    first = emulate("m0_tick.elf", given, tmp_path, "-icount", "shift=0")
    cost = np.frombuffer(first, np.uint32) * INSTRUCTIONS_PER_COUNT
    on_can, beside_usb = cost[50:200], cost[250:]  # all is set up, and the gyro has settled
    for name, some in (("CAN", on_can), ("CAN and USB", beside_usb)):
        print(f"{name}: {some.mean():.0f} instructions a tick, at most {some.max():.0f}")
    assert 8_000 < on_can.mean() < beside_usb.mean()  # it filtered, and sent more
    assert beside_usb.max() < TICK_BUDGET
