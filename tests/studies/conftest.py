"""A study in which all is told and agrees."""

import pytest

from study_checks import NAMES, PEOPLE
from study_folders import study


@pytest.fixture
def sound(tmp_path):
    """A study in which all is told and agrees."""
    return study(tmp_path, NAMES, {"participants.csv": PEOPLE})
