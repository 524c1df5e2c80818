"""A study, and its tables as a run makes them that nothing disturbs."""

import pytest
from study_runs import DROPS, in_this_process, people

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.run_study import run_study


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
