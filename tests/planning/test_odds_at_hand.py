"""What the recordings at hand say of rivals: who has more parameters pays for them."""

from dataclasses import replace

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from exoid.fitting.estimate import fit
from exoid.physics.leg import LegModel
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag
from exoid.physics.torque import NoTorque
from exoid.planning.expected_odds import DECISIVE
from exoid.planning.odds_at_hand import measure_of, odds_at_hand, told_already
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, leg

MORE = (CoulombFriction, CubicStiffness, QuadraticDrag)


@pytest.fixture(scope="module")
def fits():
    """Of a leg with dry friction: with that, and with two more causes that it does not have."""
    model = LegModel(leg(), NoTorque(), np.asarray(0.0), (CoulombFriction(jnp.asarray(0.1)),))
    made = record(model, [Movement(np.radians(-20), 5.0)], jax.random.key(1), subject=BODY)
    return [fit(made, terms=terms, multistart=1) for terms in (MORE[:1], MORE)]


def test_what_only_has_more_parameters_is_behind(fits):
    plain, more = odds_at_hand(fits)
    # of samples of one channel, or of two: each of the two further parameters pays half their log
    price = np.log(measure_of(fits).samples)
    assert plain == 0.0
    assert more == pytest.approx(fits[0].loss - fits[1].loss - price, rel=0.05)
    assert -price <= more < 0.5 - price / 2  # noise gives two parameters a log odds of 1 back


def test_a_price_alone_tells_nothing(fits):
    assert odds_at_hand(fits)[1] < -DECISIVE
    assert not told_already(fits)


def test_a_loss_far_larger_tells_whoever_has_the_parameters(fits):
    plain, more = fits
    lost = replace(more, loss=plain.loss + 100.0), replace(plain, loss=more.loss + 100.0)
    assert told_already([plain, lost[0]])
    assert told_already([lost[1], more])
    assert odds_at_hand([lost[1], more])[1] == 0.0
