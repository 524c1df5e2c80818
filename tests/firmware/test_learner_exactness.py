"""One learner of legs, three machines: NumPy float32, C++ here, and C++ on a Cortex-M0."""

import subprocess

import numpy as np
import pytest
from learner_runs import EVERY, TOLD, Ticks, told_by_numpy
from simulated_legs import Legs, Motion, held, joined, moved, session

from exoid.recordings.filter.learning import LEARNING

SOUND, CHANGED, LOSSY, HANDS, WILD = 260, 20, 60, 30, 30  # nodes
NODES = SOUND + CHANGED + LOSSY + HANDS + WILD
DROPS = 4
FIRST_DROP = 700  # ticks, after which another leg is in the exoskeletons of CHANGED
EMULATED = (0, SOUND, SOUND + CHANGED, SOUND + CHANGED + LOSSY, NODES - 1)  # one of each
BLIND = 20  # ticks at the end, in which the lossy nodes have no gyro
LOSS = 0.004  # share of the angles, and of the rates, that are lost
INSTRUCTIONS_PER_COUNT = 62.5  # of SysTick at 16 MHz, with one instruction per nanosecond
BUDGET = 86_000  # instructions of a tick's work, of the 480 000 cycles of a tick at 48 MHz
PIECE_BUDGET = 36_000  # for which frames and commands wait
MOVING = 3


def everything(rng: np.random.Generator) -> Ticks:
    """Drops, of two legs, with losses; hands; and counts that no leg shows."""
    legs = Legs.drawn(NODES, rng)
    motion = session(legs, rng, DROPS)
    for column, hand in zip(motion, hands(len(motion[0]), rng), strict=True):
        column[:, -HANDS - WILD : -WILD] = hand
    count, gyro = legs.sensed(motion, rng)
    others = slice(SOUND, SOUND + CHANGED)
    for mine, other in zip((count, gyro), legs.sensed(motion, rng), strict=True):
        mine[FIRST_DROP:, others] = other[FIRST_DROP:, :CHANGED]
    wild = count[:, -WILD:].shape
    count[:, -WILD:] += np.where(rng.random(wild) < 0.02, rng.integers(-40000, 40000, wild), 0)
    gyro[:, -WILD:] += np.where(rng.random(wild) < 0.02, rng.integers(-65000, 65000, wild), 0)
    ticks = Ticks.sound(count % 65536, gyro.clip(-32768, 32767))
    lossy = (slice(None), slice(SOUND + CHANGED, SOUND + CHANGED + LOSSY))
    shape = ticks.count[lossy].shape
    ticks.sees_angle[lossy] = rng.random(shape) > LOSS
    ticks.sees_rate[lossy] = rng.random(shape) > LOSS
    ticks.sees_rate[-BLIND:, lossy[1]] = False
    ticks.missed[lossy] = (rng.random(shape) < LOSS / 10) * rng.integers(1, 5, shape)
    return ticks


def hands(size: int, rng: np.random.Generator) -> Motion:
    """Legs that hands lower and lift, slower and faster."""
    parts, place = [], rng.uniform(-0.5, 0.1, HANDS)
    while sum(len(part[0]) for part in parts) < size:
        there = rng.uniform(-1.8, 0.1, HANDS)
        parts += [held(place, 0.8), moved(place, there, rng.uniform(0.4, 3.0))]
        place = there
    return [each[:size] for each in joined(*parts)]


@pytest.fixture(scope="module")
def given():
    return everything(np.random.default_rng(6))


@pytest.fixture(scope="module")
def expected(given):
    return told_by_numpy(given)


def assert_same(found: bytes, expected: np.ndarray) -> None:
    """Told by the firmware node after node, and by NumPy time after time."""
    told = np.frombuffer(found, TOLD).reshape(expected.T.shape).T
    for name in TOLD.names or ():
        np.testing.assert_array_equal(told[name], expected[name], err_msg=name)
    assert found == expected.T.tobytes()


def test_the_samples_are_a_million_and_every_phase_and_word_of_trust_is_told(given, expected):
    assert given.count.size >= 1_000_000
    assert set(np.unique(expected["phase"])) == {0, 1, 2, 3, 4}
    assert set(np.unique(expected["trust"])) == {*range(7)}
    assert (expected["phase"][:, :SOUND] == MOVING).mean() > 0.4  # then the filter works


def test_this_machine_learns_as_numpy_does_to_the_last_bit(build, given, expected, tmp_path):
    (tmp_path / "in.bin").write_bytes(given.records())
    subprocess.run(
        [build("host_learner"), tmp_path / "in.bin", tmp_path / "out.bin"], check=True, timeout=100
    )
    assert_same((tmp_path / "out.bin").read_bytes(), expected)


def test_it_is_told_ten_times_a_second_also_where_the_count_of_ticks_wraps(build):
    subprocess.run([build("host_teller")], check=True, timeout=10)


def some_of(given: Ticks, nodes) -> Ticks:
    return Ticks(*(each[:, list(nodes)] for each in vars(given).values()))


def test_the_microcontroller_learns_to_the_same_bit(emulate, given, expected, tmp_path):
    found = emulate("m0_learner.elf", some_of(given, EMULATED).records(), tmp_path)
    assert_same(found, expected[:, list(EMULATED)])


def test_a_processor_with_floating_point_learns_to_the_same_bit(emulate, given, expected, tmp_path):
    """A Cortex-M7 could fuse each product with its sum; it is told not to."""
    found = emulate("m7_learner.elf", some_of(given, EMULATED).records(), tmp_path)
    assert_same(found, expected[:, list(EMULATED)])


def test_no_variance_is_lost_to_rounding(expected):
    """What float32 cannot hold, or what is hardly more than nothing, would soon be an infinity."""
    moved = expected[expected["counted"] > 0]
    assert np.all(moved["variance"] > 1e-12)
    for name in ("mean", "variance", "upper", "ratio", "error"):
        values = np.abs(expected[name])
        assert np.all(np.isfinite(values)), name
        assert values.max() < 1e6
        assert not np.any((values > 0) & (values < np.finfo(np.float32).tiny)), name
    assert np.all(expected["error"] >= np.array(LEARNING.least_error, np.float32))


def test_a_tick_stays_within_its_budget_and_costs_the_same_each_time(emulate, given, tmp_path):
    records = some_of(given, (0,)).records()
    first = emulate("m0_learner_cost.elf", records, tmp_path, "-icount", "shift=0")
    assert first == emulate("m0_learner_cost.elf", records, tmp_path, "-icount", "shift=0")
    whole, piece, telling = (
        np.frombuffer(first, np.uint32).reshape(-1, 3) * INSTRUCTIONS_PER_COUNT
    ).T
    moves = whole > BUDGET / 3
    print(
        f"{whole[moves].mean():.0f} instructions a tick of a movement, at most {whole.max():.0f}, "
        f"{np.median(whole[~moves]):.0f} at rest; {piece.max():.0f} a piece; telling "
        f"{telling.max():.0f} every {EVERY} ticks"
    )
    assert 0.4 < moves.mean() < 0.9
    assert whole.max() < BUDGET
    assert max(piece.max(), telling.max()) < PIECE_BUDGET
