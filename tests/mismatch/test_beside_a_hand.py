"""What the first instants of drops may be beside a hand, and the leg's numbers beside that."""

from dataclasses import replace

import jax
import numpy as np
import pytest

from exoid.fitting.estimate import fit as fitted
from exoid.mismatch.answer.diagnosis import Booked, Parameter, Suspect
from exoid.mismatch.beside_a_hand import beside, holding
from exoid.physics.leg import LegModel
from exoid.physics.torque import NoTorque
from exoid.twin.motion import Movement
from exoid.twin.protocols import record
from fit_cases import BODY, leg

DAMPING, DRIFT = "damping_over_inertia", 0.03  # 1/s, by which a reflex would have the leg damped


@pytest.fixture(scope="module")
def fit():
    model = LegModel(leg(), NoTorque(), np.asarray(0.0))
    made = record(model, [Movement(np.radians(-10.0), 6.0)], jax.random.key(3), subject=BODY)
    return fitted(made, multistart=1)


def suspected(fit):
    """A reflex, found in all of a recording, in which Eq. 9 alone saw another damping and J."""
    inertia, damping = fit.parameters["inertia"].value, fit.ratios[DAMPING].value
    numbers = [
        Booked("inertia", 2 * inertia, 2 * inertia, "kg m^2"),
        Booked(DAMPING, damping + 0.5, damping + DRIFT, "1/s"),
        Booked("damping", 1.0, 2 * inertia * (damping + DRIFT), "N m s/rad"),
    ]
    return Suspect(["stretch_reflex"], numbers, [Parameter("stretch_reflex.gain", 1.0, "", None)])


def test_a_suspect_stands_beside_the_numbers_that_are_shown(fit):
    known = {one.name: one for one in beside(suspected(fit), fit).numbers}
    damping, inertia = fit.ratios[DAMPING].value, fit.parameters["inertia"].value
    assert known[DAMPING].before == damping
    assert known[DAMPING].after == pytest.approx(damping + DRIFT)
    assert known["inertia"].before == known["inertia"].after == inertia
    assert known["damping"].after == pytest.approx(inertia * (damping + DRIFT))


def test_the_errors_hold_how_far_the_suspect_is(fit):
    sure = replace(fit.ratios[DAMPING], standard_error=1e-4)
    fit = replace(fit, ratios=fit.ratios | {DAMPING: sure})
    found = holding(fit, beside(suspected(fit), fit)).ratios[DAMPING]
    assert found.value == sure.value
    # a hand and a reflex at even odds: half of the squares
    assert found.standard_error == pytest.approx(DRIFT / 2**0.5, rel=1e-4)
    assert abs(found.value - (sure.value + DRIFT)) < 1.5 * found.standard_error
