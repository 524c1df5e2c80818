"""What takes long shows that it lives: on a terminal, and in the lines of a log."""

import time

from exoid.cli.terminal import progress as module
from exoid.cli.terminal.waiting import in_long_phases, in_phases

STEP = 0.01  # s, shorter than anybody would wait


def work(told):
    for phase in ("fitting", "testing 26 candidates"):
        told(phase)
        time.sleep(STEP)
    return "found"


def test_phases_of_a_long_work_are_lines_of_a_log(capsys, monkeypatch):
    monkeypatch.setattr(module, "SHORT", 0.0)
    assert in_long_phases(work) == "found"
    said = capsys.readouterr().err.splitlines()
    assert [line for line in said if "starting" not in line][-1] == "exoid: testing 26 candidates"
    assert "exoid: fitting" in said


def test_what_is_soon_done_says_nothing(capsys):
    assert (in_long_phases(work), in_phases(work)) == ("found", "found")
    assert capsys.readouterr().err == ""
