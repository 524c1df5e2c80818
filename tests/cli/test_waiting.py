"""What takes long says so on a terminal alone."""

import time

from exoid.cli.terminal import waiting

STEP = 0.2  # s, longer than a spinner stands still


def work(told):
    for phase in ("fitting", "testing 26 candidates"):
        told(phase)
        time.sleep(STEP)
    return "found"


def test_without_a_terminal_nothing_is_said(capsys, monkeypatch):
    monkeypatch.setattr(waiting, "SLOW", 0.0)
    assert waiting.in_phases(work) == "found"
    assert capsys.readouterr().err == ""


def test_on_a_terminal_the_phase_and_its_time_are_shown(capsys, monkeypatch):
    monkeypatch.setattr(waiting, "SLOW", 0.0)
    monkeypatch.setattr(waiting, "TICK", STEP / 5)
    monkeypatch.setattr(waiting.sys.stderr, "isatty", lambda: True)
    monkeypatch.setenv("TERM", "xterm")
    assert waiting.in_phases(work) == "found"
    assert "(0 s)" in capsys.readouterr().err
