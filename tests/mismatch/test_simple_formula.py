"""A formula that is a simple torque has its name, and what it leaves is the measure of all."""

from dataclasses import replace
from unittest.mock import Mock

import jax.numpy as jnp
import numpy as np
import pytest
from found_by_hand import explaining, found_of

from exoid.fitting.data.observation import Observation
from exoid.mismatch.conclude.formulated import by_what_is_left
from exoid.mismatch.evidence.measure import yardstick
from exoid.mismatch.novel.dictionary import dictionary
from exoid.mismatch.novel.formula import Formula
from exoid.mismatch.novel.nameless import NAMELESS
from exoid.physics.moment import Cycle, Moment, SegmentConstants
from exoid.physics.ratios import Ratios
from exoid.physics.term import name_of
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement

SIMPLE = {each.family: each for each in dictionary() if each.family.simple}
MOMENTS = np.array([[0.1, -1.2, 2.0], [0.8, -0.4, -3.0], [3.0, -2.1, 0.5]])  # s, rad, rad/s


@pytest.mark.parametrize("feature", SIMPLE.values(), ids=lambda each: each.family.simple)
def test_a_feature_with_the_name_of_a_simple_torque_is_that_torque(feature):
    """But for its sign, which a coefficient takes."""
    (term,) = (each for each in NAMELESS if name_of(each) == feature.family.simple)
    one = term(*map(jnp.asarray, (1.0, *feature.shape)))
    place = SegmentConstants(
        Ratios(*map(jnp.asarray, (27.0, 6.0, 0.8, 0.0))),
        jnp.asarray(0.4),
        Cycle(*map(jnp.asarray, (0.0, 1.0, 1.0, 0.0))),
        jnp.asarray(0.0),
    )
    for time, angle, velocity in MOMENTS:
        now = Moment(*map(jnp.asarray, (time, angle, velocity, 0.0)), place=place)
        there = float(one.torque(now, jnp.zeros(0)))
        assert abs(there) == pytest.approx(abs(feature.of(angle, velocity, time, np)))


def test_a_formula_of_several_features_is_no_simple_torque():
    features = tuple(SIMPLE.values())
    assert Formula(features[:1], np.ones(1), 1.0, 0.0).simple == features[0].family.simple
    assert Formula(features[:2], np.ones(2), 1.0, 0.0).simple == ""


def test_what_a_formula_refutes_is_no_rival_of_it():
    """Beside slow waves of 14 times the noise, which the library leaves, nothing is far behind."""
    time = np.arange(0.0, 10.0, 0.01)[None]
    noise = np.random.default_rng(0).normal(size=time.shape)
    wave = 20.0 * np.sin(0.4 * np.pi * time)
    ones, nothing = np.ones_like(time), np.zeros_like(time)
    seen = Mock(spec=Observation, time=time, angle=noise, angular_velocity=nothing)
    seen.angle_weight, seen.velocity_weight = ones, nothing
    still = np.stack([nothing, nothing], axis=-1)
    formula = replace(explaining(1000.0), motion=still)
    library = explaining(200_000.0, MaxwellElement)
    library = replace(library, motion=np.stack([wave, nothing], axis=-1))
    found = found_of([library])
    found.prepared.seen, found.prepared.samples = seen, time.size
    found = replace(found, yardstick=yardstick(found.prepared, library))
    apart = found.evidence(formula) - found.evidence(library)
    anew = by_what_is_left(found, formula)
    assert anew.yardstick.scale < 3
    assert anew.evidence(formula) - anew.evidence(library) > 1000 > 100 > apart
