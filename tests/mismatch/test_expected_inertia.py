"""The inertia for which torques are told where the motion tells only ratios to it."""

from dataclasses import replace

import numpy as np
import pytest
from diagnosis_cases import session

from exoid.fitting.estimate import fit
from exoid.fitting.solve.ask import take
from exoid.mismatch.prepare import as_expected


def test_it_is_this_bodys_where_the_recording_refuses_the_ratios():
    result = fit(session(), multistart=8)
    best = take(result.basis.ended.best, 0).coordinates
    other = replace(best, shared=replace(best.shared, log_inertia=np.log(0.1)))
    inertia = result.parameters["inertia"]
    assert inertia.determined_by in ("prior", "both")
    assert as_expected(other, result) is other
    lost = replace(result, astray="it misses the angle by 2 deg")
    kept = as_expected(other, lost).shared
    assert np.exp(kept.log_inertia) == pytest.approx(inertia.expected)
    assert kept.gravity == other.shared.gravity
    fixed = {**lost.parameters, "inertia": replace(inertia, by_hand="fix")}
    assert as_expected(other, replace(lost, parameters=fixed)) is other
