"""One filter, four machines: NumPy float32, C++ here, C++ on a Cortex-M0, and JAX."""

import subprocess

import float32_node
import jax.numpy as jnp
import numpy as np
import pytest
from motions import measured, with_losses
from simulated_legs import FINER, Legs, held, joined

from exoid.recordings.filter import kalman

SAMPLES = 60_000
WILD = 2_000  # samples of any magnitude at the end: sums that cancel, subnormal products
INSTRUCTIONS_PER_COUNT = 62.5  # of SysTick at 16 MHz, with one instruction per nanosecond
BATCH = 10  # steps that m0_cost times together
BUDGET = 13_000  # instructions for a step, of the 480 000 cycles of a tick at 48 MHz
TICK_BUDGET = 120_000  # instructions for all that a tick does, 25 % of it
TORQUE_BUDGET = 6_000  # the same for the command of a torque, and a host that lets it
ARMS = 2  # what a host wishes, and 1
STILL_BUDGET = 48_000  # the same where nothing is learned, as the leg does not move freely


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


@pytest.mark.parametrize("commands", [False, True])
def test_a_whole_tick_stays_within_its_budget_on_can_and_with_a_host_on_usb_beside_it(
    emulate, tmp_path, commands
):
    """Without a torque's parameters, and with a host on CAN that arms it: then it has the most to
    do, as it does not learn what a motor drives."""
    count, rate = let_go_twice()
    given = np.zeros((count.size, 4), "<i2")
    given[:, 1], given[:, 2] = count, rate
    given[count.size // 2, 0] = 1  # the host opens the channel
    given[::2, 3] = commands * ARMS
    head = np.uint16(commands).tobytes()
    first = emulate("m0_tick.elf", head + given.tobytes(), tmp_path, "-icount", "shift=0")
    cost = np.frombuffer(first, np.uint32) * INSTRUCTIONS_PER_COUNT
    assert cost.size == count.size
    for name, some in (("CAN", cost[: cost.size // 2]), ("CAN and USB", cost[cost.size // 2 :])):
        still, moving = some[50:130], some[200:]  # all is set up, and the gyro has settled
        for what, each in (("a leg at rest", still), ("one that is learned", moving)):
            print(f"{name}, {what}: {each.mean():.0f} instructions, at most {each.max():.0f}")
        assert 8_000 < still.mean() < still.max() < STILL_BUDGET  # it filtered
        most = TICK_BUDGET + commands * TORQUE_BUDGET
        assert 90_000 < moving.mean() < moving.max() < most  # it learned


def let_go_twice() -> tuple[np.ndarray, np.ndarray]:
    """Counts of encoder and gyro: held, and then a free leg; and so once more."""
    rng = np.random.default_rng(0)
    legs = Legs.drawn(1, rng)
    start = np.array([-0.2])
    drop = legs.drop(start, 2.5)
    held_again = held(start, 1.5)
    count, gyro = legs.sensed(joined(held_again, drop, held_again, drop), rng)
    return count[:, 0] // FINER, gyro[:, 0]
