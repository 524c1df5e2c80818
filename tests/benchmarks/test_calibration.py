"""Do 95 % intervals cover the legs of people whom no table was made of?"""

import numpy as np
import pytest
from benchmarks.calibration import NAMES, covered, scores
from scipy.stats import binom

PEOPLE = 80


@pytest.mark.proof
def test_intervals_cover_m_l_j_d_and_c_of_all_kinds_of_people():
    """Three in a thousand such studies would find fewer than this by chance."""
    z = np.concatenate(list(scores(PEOPLE, 3, drops=(2,)).values()))
    least = binom.ppf(0.003, PEOPLE, 0.95) / PEOPLE
    assert (covered(z) >= least).all(), dict(zip(NAMES, covered(z), strict=True))
