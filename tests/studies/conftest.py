"""Studies: their folders, their tables as a run makes them that nothing disturbs, and commands.

Some are simulated by the benchmark, which is imported from the repository; what reads pages and
runs commands is that of the tests of the report and of the command line.
"""

import sys
from pathlib import Path

import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.run_study import run_study
from study_checks import NAMES, PEOPLE
from study_folders import study
from study_runs import DROPS, in_this_process, people

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


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    """Twenty people, both legs."""
    return people(tmp_path_factory.mktemp("study"))


@pytest.fixture(scope="session")
def expected(folder, tmp_path_factory):
    """The results of its drops."""
    results = tmp_path_factory.mktemp("expected")
    with in_this_process():
        run_study(open_dataset(folder), results, DROPS)
    return results


@pytest.fixture
def here():
    """Workers in this process."""
    with in_this_process():
        yield
