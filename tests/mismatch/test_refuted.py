"""What leaves very much more than the best is refuted; what all others have is sure."""

import pytest
from found_by_hand import SAMPLES, explaining, found_of

from exoid.mismatch.conclude.rivals import likely
from exoid.mismatch.conclude.verdict import in_all as asking
from exoid.physics.terms.muscle.stretch_reflex import StretchReflex
from exoid.physics.terms.tissue.cubic_stiffness import CubicStiffness
from exoid.physics.terms.tissue.end_range_stiffening import EndRangeStiffening
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag


@pytest.mark.parametrize(
    ("best", "drag", "kept"),
    [(1.0, 26.0, False), (1.0, 8.0, True), (5.0, 26.0, True), (1.0, 60.0, False)],
)
def test_a_cause_that_a_better_one_refutes_is_not_suspected(best, drag, kept):
    """Drag explains more than half of a mismatch of 101 times the noise, up to a rest of 50."""
    reflex, drag = explaining(1.15 * best * SAMPLES, StretchReflex), drag * SAMPLES
    other = explaining(drag, QuadraticDrag)
    both = explaining(best * SAMPLES, StretchReflex, EndRangeStiffening)
    assert likely(found_of([reflex, other], [both])) == [reflex, *([other] if kept else [])]


@pytest.mark.parametrize(
    ("others", "again", "shared"),
    [
        ({QuadraticDrag: 7000.0}, 1.0, [StretchReflex]),
        ({QuadraticDrag: 7000.0}, 0.5, []),  # other segments would ask for something else
        ({QuadraticDrag: 5.0}, 1.0, []),  # it may be that
    ],
)
def test_a_cause_that_all_have_which_explain_it_is_told(others, again, shared, monkeypatch):
    """Resampled segments ask for the same reflex with this or that beside it."""
    best = explaining(SAMPLES, StretchReflex, EndRangeStiffening)
    more = explaining(1.01 * SAMPLES, StretchReflex, CubicStiffness)
    alone = [explaining(left * SAMPLES, term) for term, left in others.items()]
    found = found_of([explaining(1.15 * SAMPLES, StretchReflex), *alone], [best, more])
    found.prepared.common = ()
    monkeypatch.setattr(asking, "inclusion", lambda *_: again)
    assert asking.in_all(found, best, 0) == shared
    assert asking.in_all(found, explaining(2.0 * SAMPLES, StretchReflex), 0) == []  # unexplained
