"""The notes of a fit that does not follow its recording agree that its numbers are none."""

from exoid.fitting.estimate import fit
from legs import drop, recording


def test_notes_do_not_say_how_to_use_numbers_that_are_not_to_be_used():
    """Of a long slow pendulum, J / (m l) 1.4 m, as a leg."""
    slow = recording(drop((7.0, 1.2, 0.6), -0.3, duration=2.4))
    result = fit(slow, multistart=4)
    assert not result.follows
    said = " ".join(result.notes)
    assert "Do not use these numbers" in said
    assert "ran into its limits" in said
    for each in ("use the ratios", "'if slack'", "takes for granted", "part of the variance"):
        assert each not in said, each
    assert all(each.if_slack is None for each in result.ratios.values())
