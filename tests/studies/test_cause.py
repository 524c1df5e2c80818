"""What reasons have in common, and what mends them for a whole data set."""

import pytest

from exoid.studies.dataset.cause import cause, for_all

SAID = 'Then say flip="angle" and zero="hanging", or zero="unknown" (flip="all" with a gyro).'
KEYS = 'flip = "angle" and zero = "hanging"'
REST = 'zero = "unknown" (flip = "all" with a gyro).'


@pytest.mark.parametrize(
    ("name", "where"),
    [
        ("P01_left.csv", ("[sensors] of its sidecar", "defaults.toml")),
        (
            "sub-01_task-knee_motion.tsv",
            ("sensors of exoid in its _motion.json", "task-NAME_motion.json"),
        ),
    ],
)
def test_options_of_one_command_are_said_as_keys_for_all(name, where):
    own, all_of = where
    every = f"or, where all are like this, of {all_of} at the top of the data set"
    assert for_all(SAID, name) == f"Then write {KEYS} in {own}, {every}, or {REST}"


def test_reasons_are_alike_where_numbers_alone_differ():
    one = "line 12: between -20.5 and 1e-3 deg, in 1,000 places"
    assert cause(one) == cause("line 7: between 3 and +0.25 deg, in 2 places")
    assert cause(one) != cause("line 12: between -20.5 and 1e-3 rad, in 1,000 places")
