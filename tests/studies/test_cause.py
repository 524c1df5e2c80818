"""What reasons have in common, and what mends them for a whole data set."""

import pytest

from exoid.studies.dataset.cause import cause, for_all

SAID = "Then say --flip angle --zero hanging, or --zero unknown (--flip all with a gyro)."
KEYS = 'flip = "angle" and zero = "hanging"'
REST = 'zero = "unknown" (flip = "all" with a gyro).'


@pytest.mark.parametrize(
    ("name", "where"),
    [
        ("P01_left.csv", "[sensors] of defaults.toml"),
        ("sub-01_task-knee_motion.tsv", "sensors of exoid in task-NAME_motion.json"),
    ],
)
def test_options_of_one_command_are_said_as_keys_for_all(name, where):
    wanted = f"Then write {KEYS} in {where} at the top of the data set, or {REST}"
    assert for_all(SAID, name) == wanted


def test_reasons_are_alike_where_numbers_alone_differ():
    one = "line 12: between -20.5 and 1e-3 deg, in 1,000 places"
    assert cause(one) == cause("line 7: between 3 and +0.25 deg, in 2 places")
    assert cause(one) != cause("line 12: between -20.5 and 1e-3 rad, in 1,000 places")
