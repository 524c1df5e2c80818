"""That drops of one leg are missed by far more than others."""

import numpy as np
import pytest

from exoid.fitting.result.remarks.residual_remarks import of_unlike_drops
from exoid.fitting.result.segment_fit import SegmentFit


def missed(degrees: float, name: int, kind: str = "passive") -> SegmentFit:
    """A segment that is missed by so much, beside a noise of 0.05 deg."""
    still = np.zeros(4)
    return SegmentFit(
        name=str(name),
        kind=kind,
        period=None,
        torque_amplitude=None,
        added_mass=0.0,
        angle_rmse=float(np.radians(degrees)),
        velocity_rmse=None,
        angle_noise=float(np.radians(0.05)),
        velocity_noise=None,
        time=np.arange(4.0),
        angle=still,
        angular_velocity=None,
        simulated_angle=still,
        simulated_velocity=still,
    )


def test_a_leg_that_changes_from_drop_to_drop_is_said_to_and_how_to_ask_that():
    """Twelve drops whose damping falls by 2 % each: the middle ones fit the mean."""
    each = [1.03, 0.8, 0.6, 0.4, 0.2, 0.06, 0.2, 0.4, 0.6, 0.8, 0.9, 1.05]
    (said,) = of_unlike_drops([missed(one, number) for number, one in enumerate(each)])
    assert "segment 11 is missed by 1.1 deg, segment 5 by 0.06 deg" in said
    assert "'exoid fit --each'" in said


@pytest.mark.parametrize(
    "each",
    [(0.05, 0.05, 0.1), (0.75, 1.1, 2.6), (0.05, 1.0), ()],
    ids=["noise", "the same lacks in all", "two", "none"],
)
def test_drops_that_one_leg_explains_alike_are_not_said_to_differ(each):
    assert of_unlike_drops([missed(one, number) for number, one in enumerate(each)]) == []


def test_cycles_are_no_drops():
    each = [missed(one, number, "active") for number, one in enumerate((0.05, 1.0, 2.0))]
    assert of_unlike_drops(each) == []
