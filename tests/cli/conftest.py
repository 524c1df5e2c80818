"""Recordings and a cache of programs that all tests of the command line share: one compilation."""

import pytest
from command_line import Command
from sessions import DROP, TWO_DROPS, session, write_log

from exoid.recordings.formats.own_table import write_table
from exoid.recordings.splitting.split import split


@pytest.fixture(scope="session")
def command(programs):
    """The console script, with its cache in a folder of this run."""
    return Command(programs)


@pytest.fixture(scope="session")
def recordings(tmp_path_factory):
    """drop.csv and two.csv (one drop, two drops) and session.blf (the log of the one drop)."""
    folder = tmp_path_factory.mktemp("recordings")
    write_table(split(session(DROP)), folder / "drop.csv")
    write_table(split(session(*TWO_DROPS)), folder / "two.csv")
    write_log(session(DROP), folder / "session.blf")
    return folder


@pytest.fixture(scope="session")
def fitted(command, recordings, tmp_path_factory):
    """The document of `exoid fit drop.csv`."""
    return command.document(recordings / "drop.csv", folder=tmp_path_factory.mktemp("fitted"))
