"""Studies are simulated by the benchmark, which is imported from the repository; what reads pages
and runs commands is that of the tests of the report and of the command line.
"""

import sys
from pathlib import Path

import pytest

from study_checks import NAMES, PEOPLE
from study_folders import study

TESTS = Path(__file__).parents[1]
sys.path += [str(TESTS.parent), str(TESTS / "report"), str(TESTS / "cli")]


@pytest.fixture(scope="session")
def command(common):
    """`exoid` in this process."""
    from command_line import Command

    return Command(common)


@pytest.fixture
def sound(tmp_path):
    """A study in which all is told and agrees."""
    return study(tmp_path, NAMES, {"participants.csv": PEOPLE})
