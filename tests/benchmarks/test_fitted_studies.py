"""The studies whose recordings are fitted: their motion, their sensors, and what is counted."""

from dataclasses import replace

import numpy as np
import pytest
from benchmarks.studies.fitted.answered import Told, fitted_of, kinds_of, told_of
from benchmarks.studies.fitted.exact import exact
from benchmarks.studies.fitted.replications import check_same
from benchmarks.studies.fitted.sensors import HELD, LATE, MOVED, NOISE, WORSE, ZERO, record
from benchmarks.studies.fitted.summary import of_quantity, truths
from benchmarks.studies.fitted.swing import STEP, Ratios, swing
from benchmarks.studies.fitted.world import DAMPING, FAULTS, World, draw_study
from benchmarks.studies.fitted.write import name_of, put_study
from scipy.integrate import cumulative_simpson, solve_ivp

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.dataset.recording_of import recording_of
from exoid.studies.statistics.reliability import DETECTABLE
from exoid.studies.statistics.tables.study import study_of

RUBBING = Ratios(*(np.array([each]) for each in (26.0, 6.0, 1.6, 0.8)))
START = np.array([-0.2])
WORLD = World().of(8)
QUESTIONS = ("difference of the groups", "ICC(C,1)", "ICC(A,1)", "minimal detectable change")


def test_the_motion_is_that_of_another_integrator():
    of = [float(each[0]) for each in vars(replace(RUBBING, friction=np.zeros(1))).values()]

    def slope(_, state):
        angle, rate = state
        return rate, -of[0] * np.cos(angle) - of[1] * angle - of[2] * rate

    angle, _ = swing(Ratios(*map(np.array, ([each] for each in of))), START, 800)
    time = STEP * np.arange(801)
    exact = solve_ivp(slope, (0, 2), (-0.2, 0.0), t_eval=time, rtol=1e-10, atol=1e-12).y[0]
    # Order four in steps of 2.5 ms at 5 rad/s: (5 * 0.0025)^4 is 2e-8.
    assert np.abs(angle[0] - exact).max() < 1e-7


def test_friction_stops_a_leg_beside_where_it_would_hang():
    angle, rate = swing(RUBBING, START, 1600)
    gravity, stiffness, _, friction = (float(each[0]) for each in vars(RUBBING).values())
    pull = gravity * np.cos(angle[0, -1]) + stiffness * angle[0, -1]
    assert rate[0, -1] == 0.0
    assert 0.05 * friction < abs(pull) < friction


def test_energy_is_lost_to_damping_and_friction_alone():
    angle, rate = swing(RUBBING, START, 400)
    gravity, stiffness, damping, friction = (float(each[0]) for each in vars(RUBBING).values())
    energy = rate**2 / 2 + gravity * np.sin(angle) + stiffness * angle**2 / 2
    lost = cumulative_simpson(damping * rate**2 + friction * np.abs(rate), dx=STEP, initial=0)
    # Simpson's rule takes |phi'| for smooth where the leg turns: 0.8 * 0.06 rad/s in 2.5 ms.
    assert np.abs(energy + lost - energy[:, :1]).max() < 2e-4


def faulty(fault):
    """A visit with this fault and a copy of it without, recorded with the same noise."""
    visit = replace(draw_study(WORLD, 0)[0], fault=fault)
    return tuple(
        record([replace(visit, fault=each)], np.random.default_rng(1))[0] for each in (fault, "")
    )


def test_bad_recordings_are_bad_in_the_way_that_they_say():
    noisy, _ = faulty("noise")
    held = noisy.angle[:, :HELD]
    # 200 samples about their means: the standard deviation of a standard deviation is 5 %.
    scatter = (held - held.mean(axis=1, keepdims=True)).std()
    assert scatter == pytest.approx(WORSE * NOISE[0], rel=0.2)
    late, sound = (each.rate[:, HELD:] for each in faulty("late gyro"))
    by = [np.abs(late[:, each:] - sound[:, : sound.shape[1] - each]).mean() for each in range(8)]
    assert LATE[0] <= int(np.argmin(by)) <= LATE[1]
    moved, _ = faulty("moved zero")
    motion = moved.angle[:, :HELD].mean(axis=1)
    rest = moved.angle[:, -20:].mean(axis=1)
    assert np.ptp(rest) > MOVED[0] - 3 * NOISE[0]  # the leg hangs where it hung; the encoder moved
    assert np.ptp(motion) < 0.3 + MOVED[1] + 3 * ZERO


def test_what_is_written_is_what_was_recorded(tmp_path):
    visits = draw_study(WORLD.of(1), 3)
    put_study(visits, 3, tmp_path)
    found = open_dataset(tmp_path)
    assert [each.name for each in found.entries] == sorted(name_of(each) for each in visits)
    assert len({each.path.stat().st_size for each in found.entries}) == 1
    one = recording_of(found.entries[0], found)
    (same,) = [each for each in visits if name_of(each) == found.entries[0].name]
    assert len(one.segments) == 5
    assert one.subject.body_mass == pytest.approx(same.person.body_mass, abs=0.05)
    assert one.sensors.encoder_counts == 4096


def test_a_seed_is_a_study():
    first, again, other = (draw_study(WORLD, seed) for seed in (1, 1, 2))
    assert [each.truth("damping_over_inertia") for each in first] == [
        each.truth("damping_over_inertia") for each in again
    ]
    assert first[0].person.height != other[0].person.height


def test_groups_and_levels_are_as_they_are_said():
    people = [draw_study(WORLD.of(300), 0)[at].person for at in range(0, 1200, 4)]
    mean = [np.mean([p.usual[DAMPING.quantity] for p in people if p.group == g]) for g in (0, 1)]
    # Of 150 people in either group: 0.25 sqrt(2 / 150) is 0.029.
    assert mean[1] - mean[0] == pytest.approx(DAMPING.effect, abs=0.09)
    rubbing = [each.group for each in people if each.friction]
    assert set(rubbing) == {1}
    assert len(rubbing) == pytest.approx(45, abs=17)  # three standard deviations of 5.6
    faults = [each.fault for each in draw_study(WORLD.of(300), 0)]
    assert {*faults} == {"", *FAULTS}


def told(visits, off, error=0.01, note=""):
    """Tables of fits that are off by so much."""
    sound = exact(visits, WORLD)
    by = dict(zip(map(name_of, visits), off, strict=True))
    rows = sound.quantities
    value = rows["value"] + rows["name"].map(by)
    return study_of(sound.recordings, rows.assign(value=value, standard_error=error, note=note))


def test_exact_fits_are_asked_as_the_others_are():
    visits = draw_study(WORLD.of(40), 0)
    damping, stiffness = told_of(exact(visits, WORLD), WORLD)
    assert (damping.quantity, stiffness.quantity) == tuple(t.quantity for t in WORLD.design.truths)
    by_group = [[v.truth(DAMPING.quantity) for v in visits if v.person.group == g] for g in (0, 1)]
    apart = np.mean(by_group[1]) - np.mean(by_group[0])
    # All people have as many values: the mixed model's means are the plain ones.
    assert damping.intervals["difference of the groups"][0] == pytest.approx(apart, rel=1e-6)


def test_values_are_held_against_their_own_truth():
    visits = draw_study(WORLD, 0)
    bias = [0.3 * (each.side == 0) for each in visits]
    study = told(visits, bias, note="the residual: the model misses something.")
    found = fitted_of(study, DAMPING.quantity, visits)
    assert (found.valued, found.held) == (len(visits), len(visits) // 2)
    assert found.off / found.valued == pytest.approx(0.15)
    assert sum(each.missed for each in kinds_of(study, WORLD, visits)) == len(visits)


def test_the_truth_of_test_and_retest_holds_what_passes():
    alike, unlike = (dict(truths(DAMPING, each)) for each in (WORLD, replace(WORLD, unlike=0.1)))
    day = DAMPING.day**2 + DAMPING.side_on_day**2
    change = "minimal detectable change"
    assert alike[change] == pytest.approx(DETECTABLE * day**0.5)
    # Five drops that differ by 0.16 1/s: their mean by 0.16 over the root of 5.
    assert unlike[change] == pytest.approx(DETECTABLE * (day + 0.16**2 / 5) ** 0.5)
    assert unlike["ICC(C,1)"] < alike["ICC(C,1)"]


def test_another_world_is_not_mixed_in(tmp_path):
    check_same(tmp_path / "asked.json", {"bad": 0.1})
    check_same(tmp_path / "asked.json", {"bad": 0.1})
    with pytest.raises(ValueError, match="other studies are kept there"):
        check_same(tmp_path / "asked.json", {"bad": 0.2})


def test_intervals_are_counted_as_they_hold():
    at = DAMPING.effect
    both = [
        Told("damping_over_inertia", dict.fromkeys(QUESTIONS, each), 0.01)
        for each in ((at, at - 0.1, at + 0.1), (at + 0.3, at + 0.2, at + 0.4))
    ]
    lines = list(of_quantity([(each, both[0]) for each in both], DAMPING, WORLD))
    assert "  1 of   2  0.1650  0.3150 ± 0.1500   0.1500 ± 0.1500" in lines[0]
    assert "  2 of   2" in lines[-1]  # both differ surely
