"""The recordings of others are what their truth says."""

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from benchmarks.others.case import draw_case
from benchmarks.others.devices import Device, sample_times
from benchmarks.others.effects import TORQUES
from benchmarks.others.kalman import filtered
from benchmarks.others.leg import GRAVITY
from benchmarks.others.people import HARDEST
from benchmarks.others.troubles import TROUBLES, disturb
from benchmarks.others.write import make
from scipy.integrate import solve_ivp

import exoid
from exoid.recordings.filter import kalman
from exoid.recordings.filter.constants import UNBIASED
from exoid.recordings.signal.both_sensors.clean import clean

SEED, DRAWN = 7, 300
CASES = [draw_case(SEED, number) for number in range(DRAWN)]
PEOPLE = ("adult", "child", "obese", "spastic", "stiff")


def plain(number: int) -> bool:
    """Nothing but Eq. 9 and white noise, with a gyro, in segments that begin with a hold."""
    case = CASES[number]
    held = not case.protocol.table and not any(drop.skipped for drop in case.protocol.drops)
    quiet = case.trouble == case.effect.name == "none" and not case.systematic
    return held and quiet and case.device.velocity_noise is not None


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The first plain case: its truth and its table."""
    number = next(filter(plain, range(DRAWN)))
    return read(make(SEED, number, tmp_path_factory.mktemp("others")))


def read(path: Path):
    truth = json.loads(path.with_suffix(".truth.json").read_text())
    return truth, np.genfromtxt(path, delimiter=",", names=True)


def test_several_effects_are_as_many_as_wanted_and_at_most_one_is_of_a_sensor():
    drawn = [draw_case(SEED, number, together=3).effect for number in range(60)]
    several = [each for each in drawn if each.name != "none"]
    assert len(several) > 20
    for each in several:
        names = set(each.name.split("+"))
        assert len(names) == 3
        assert len(names - TORQUES.keys()) <= 1
    assert [draw_case(SEED, number).effect for number in range(60)] == [
        case.effect for case in CASES[:60]
    ]


def test_nothing_of_exoid_makes_them():
    code = (
        "import sys, benchmarks.others.write, benchmarks.others.score, benchmarks.others.release\n"
        "sys.exit(any(name.split('.')[0] in ('exoid', 'jax') for name in sys.modules))"
    )
    root = Path(__file__).parents[2]
    assert subprocess.run([sys.executable, "-c", code], cwd=root, check=False).returncode == 0


def test_a_seed_makes_the_same_files_again(tmp_path):
    number = next(filter(plain, range(DRAWN)))
    first, again = (make(SEED, number, tmp_path / each) for each in ("a", "b"))
    for suffix in (".csv", ".toml", ".truth.json"):
        assert first.with_suffix(suffix).read_bytes() == again.with_suffix(suffix).read_bytes()
    assert draw_case(SEED + 1, number).person != draw_case(SEED, number).person


def test_the_rows_are_eq_9_and_white_noise(made):
    truth, table = made
    gravity, stiffness, damping = truth["ratios"].values()

    def slope(_, y):
        return y[1], -gravity * np.cos(y[0]) - stiffness * y[0] - damping * y[1]

    drop = next(each for each in truth["drops"] if each["end_s"] - each["harmless_s"] > 1.0)
    free = (table["segment"] == drop["segment"]) & (table["time_s"] >= drop["harmless_s"])
    rows = table[free & (table["time_s"] < drop["end_s"])]
    time = rows["time_s"] - rows["time_s"][0]

    def left(start):
        y = solve_ivp(slope, (0, time[-1]), start, "DOP853", t_eval=time, rtol=1e-10).y
        angle = (rows["raw_angle_rad"] - y[0]) / truth["angle_noise_rad"]
        bias = truth["errors"]["bias"]
        rate = (rows["raw_velocity_rad_s"] - bias - y[1]) / truth["velocity_noise_rad_s"]
        return np.concatenate([angle, rate])

    start = np.array([rows["raw_angle_rad"][0], rows["raw_velocity_rad_s"][0]])
    for _ in range(4):  # Gauss and Newton: the motion is nearly linear in its start
        columns = [(left(start + e) - left(start - e)) / 2e-4 for e in 1e-4 * np.eye(2)]
        start = start - np.linalg.lstsq(np.stack(columns, 1), left(start), rcond=None)[0]
    # the mean square of n normal numbers is 1 within 5 times the root of 2 / n
    rest = left(start)
    assert np.mean(rest**2) == pytest.approx(1.0, abs=5 * np.sqrt(2 / rest.size))


def test_a_hand_still_matters_before_the_instant_that_the_truth_calls_harmless(made):
    truth, table = made
    for drop in truth["drops"]:
        assert drop["release_begins_s"] < drop["harmless_s"] <= drop["release_ends_s"]
        assert 0.02 - 1e-3 <= drop["release_ends_s"] - drop["release_begins_s"] <= 0.1 + 1e-3
        segment = table["segment"] == drop["segment"]
        held = segment & (table["time_s"] < drop["release_begins_s"])
        # at most the tremor of 0.3 deg at 12 Hz beside the gyro's noise
        shake = np.radians(0.3) * 2**0.5 * 2 * np.pi * 12
        most = shake + 6 * truth["velocity_noise_rad_s"]
        assert np.all(np.abs(table["raw_velocity_rad_s"][held]) < most)
        assert drop["end_s"] > drop["release_ends_s"]


def test_people_are_people():
    assert {case.person.kind for case in CASES} == set(PEOPLE)
    for case in CASES:
        leg = case.person.leg
        assert leg.mass * leg.com_distance**2 < leg.inertia  # Eq. 12
        # the equal pendulum is 0.33 to 0.42 m long at 1.8 m: the tables and three of their scatter
        length = leg.inertia / leg.mass / leg.com_distance
        assert 0.20 < length < 0.48
        assert leg.stiffness <= HARDEST
        assert leg.damping < 2 * np.sqrt(leg.weight * leg.inertia)
        assert leg.weight == leg.mass * leg.com_distance * GRAVITY
    spastic = [case.person.leg.damping for case in CASES if case.person.kind == "spastic"]
    healthy = [case.person.leg.damping for case in CASES if case.person.kind == "adult"]
    assert max(spastic) > 2.0
    assert max(healthy) < 1.0


def test_half_of_the_legs_obey_eq_9():
    share = np.mean([case.effect.name == "none" for case in CASES])
    assert share == pytest.approx(0.5, abs=3 * 0.5 / DRAWN**0.5)
    names = {case.effect.name for case in CASES}
    assert len(names) == 12  # seven torques, four sensors' errors, nothing
    assert {case.trouble for case in CASES} == set(TROUBLES)


def test_the_node_s_filter_is_the_one_that_exoid_knows():
    rng = np.random.default_rng(0)
    time = np.cumsum(rng.choice([0.01, 0.011], 400))
    angle, rate = np.cos(5 * time) - 1, -5 * np.sin(5 * time)
    seen = angle + rng.normal(0, 1e-3, 400), rate + rng.normal(0, 7e-3, 400)
    single = [np.asarray(each, np.float32) for each in (np.diff(time), *seen)]
    theirs = np.asarray(kalman.filter(*single, UNBIASED).state)
    # single precision, summed in another order: some of its 6e-8 of 25 rad/s^2 and its feedback
    np.testing.assert_allclose(filtered(time, *seen), theirs, atol=2e-4)


def test_a_filter_with_no_noise_follows_a_motion_of_constant_acceleration():
    time = 0.01 * np.arange(300)
    state = filtered(time, 0.5 * time**2, time)
    # from no knowledge of the acceleration it takes some tens of samples
    np.testing.assert_allclose(state[100:, 2], 1.0, atol=1e-3)
    np.testing.assert_allclose(state[100:, 0], 0.5 * time[100:] ** 2, rtol=1e-4)


@pytest.mark.parametrize("trouble", TROUBLES)
def test_troubles_are_on_top_of_noise_of_the_told_size(trouble):
    device = Device("encoder_gyro", 100.0, 1e-3, 7e-3, 4096, 0.0, True)
    time = sample_times(device, 0.0, 200.0, np.random.default_rng(1))
    noise = disturb(trouble, device, time, np.random.default_rng(2))
    spread = np.diff(np.percentile(noise.angle, [15.87, 84.13]))[0] / 2
    # t(3) of unit variance has a narrower middle, hum a wider one by up to the root of 5
    least, most = {"heavy_tails": (0.6, 0.8), "hum": (1.1, 2.4)}.get(trouble, (0.95, 1.05))
    assert least < spread / device.angle_noise < most
    assert np.all(np.diff(time) > 0)
    lost = 1 - np.mean(noise.kept)
    assert lost == pytest.approx(0.03 * (trouble == "lost"), abs=0.006)
    assert (np.abs(noise.angle).max() > 9e-3) == (trouble in ("spikes", "heavy_tails"))


def test_a_leg_that_is_let_go_and_caught_has_no_tone(tmp_path):
    """Its kinks make lines, but nowhere else the phase of a tone."""
    recording = exoid.load(make(0, 172, tmp_path)).recording
    assert clean(recording).velocity.tone is None
