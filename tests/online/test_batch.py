"""Finished drops and the batch fit."""

from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from multiprocessing import get_context

import numpy as np
import pytest

import exoid
from exoid import online
from exoid.recordings.declared.subject import Subject

SUBJECT = Subject(kind="leg", body_mass=77.0, height=1.80)
RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")


@pytest.fixture(scope="module")
def fitted(three):
    """Three drops, and their batch fit in a process of its own while the stream goes on here."""
    samples, _, _, belief, said = three
    drops = online.drops_of(samples, said)
    with ProcessPoolExecutor(1, get_context("spawn")) as beside:
        waiting = beside.submit(online.refine, drops, SUBJECT)
        now = belief
        for number in range(200):
            held = online.Sample(samples.time[-1] + 0.01 * (number + 1), -1.0, 0.01 * number)
            now, _ = online.step(now, held)
        return drops, waiting.result(timeout=600)


@pytest.fixture(scope="module")
def by_angle(play):
    """The drop of a leg whose rate no gyro shows, and the model of such sensors."""
    samples, leg, _ = play(4)
    seen = replace(samples, angular_velocity=np.full_like(samples.time, np.nan))
    model = online.Model(node=online.Node(gyro=False))
    belief, said = online.replay(online.init(exoid.expected_leg(77.0, 1.80), model), seen, model)
    return online.drops_of(seen, said), belief, model, leg


def test_drops_by_an_angle_alone_have_no_column_of_rates(by_angle):
    (drop,) = by_angle[0]
    assert "raw_velocity_rad_s" not in drop.channels()


@pytest.mark.slow
def test_drops_by_an_angle_alone_are_fitted_too(by_angle):
    drops, belief, model, leg = by_angle
    found = online.refine(drops, SUBJECT, model)
    assert online.agreement(belief, found, model).holds
    one = found.ratios["gravity_over_inertia"]
    assert abs(one.value - leg.gravity) < 4 * one.standard_error


@pytest.mark.slow
def test_the_kept_drops_begin_with_a_rest_and_end_free(three, fitted):
    drops, _ = fitted
    _, _, free, _, _ = three
    assert len(drops) == 3
    for drop, (begun, end) in zip(drops, free, strict=True):
        assert drop.begins < begun - 0.5
        assert drop.begins + drop.time[-1] < end + 0.1  # s: no hand is in it


@pytest.mark.slow
def test_live_and_batch_agree_and_the_live_errors_are_hardly_larger(three, fitted):
    _, leg, _, belief, said = three
    _, found = fitted
    assert online.agreement(belief, found).holds
    errors = [found.ratios[name].standard_error for name in RATIOS]
    assert (said.errors[-1] < 1.2 * np.array(errors)).all()
    truth = (leg.gravity, leg.stiffness, leg.damping)
    for name, value in zip(RATIOS, truth, strict=True):
        assert abs(found.ratios[name].value - value) < 4 * found.ratios[name].standard_error


@pytest.mark.slow
def test_the_filter_goes_on_from_what_the_batch_found(three, fitted, start):
    belief, found = three[3], fitted[1]
    after = online.estimates(online.refined(belief, found))
    for name in RATIOS:
        assert after[name].value == pytest.approx(found.ratios[name].value, rel=1e-3)
        error = found.ratios[name].standard_error  # each weighs anew whether a foot is on the leg
        assert 0.9 * error < after[name].error < 1.1 * error
    before = online.estimates(belief)
    assert after["gyro_bias"].value == pytest.approx(before["gyro_bias"].value, abs=0.002)


@pytest.mark.slow
def test_a_fit_of_another_leg_disagrees(three, fitted):
    belief, found = three[3], fitted[1]
    one = found.ratios["damping_over_inertia"]
    other = replace(one, value=one.value + 6 * one.standard_error)
    wrong = replace(found, ratios=found.ratios | {"damping_over_inertia": other})
    assert not online.agreement(belief, wrong).holds


@pytest.mark.slow
def test_a_moving_leg_is_not_refined(three, fitted, start):
    samples, _, free, _, _ = three
    inside = samples.time < free[0][0] + 2.0
    moving, _ = online.replay(
        start,
        online.Sample(
            samples.time[inside], samples.angle[inside], samples.angular_velocity[inside]
        ),
    )
    with pytest.raises(ValueError, match="the leg moves"):
        online.refined(moving, fitted[1])
