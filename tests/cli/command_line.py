"""Runs commands: in this process, or as the real console script in one of its own."""

import json
import os
import subprocess
import sys
from contextlib import ExitStack, chdir, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from unittest.mock import patch

SCRIPT = Path(sys.executable).with_name("exoid")
# A job that a shell runs in the background ignores Ctrl-C, and so would what it starts.
HEEDING = (
    "import os, signal, sys; signal.signal(signal.SIGINT, signal.SIG_DFL); "
    "os.execv(sys.argv[1], sys.argv[1:])"
)
LIMIT = 120  # s; a first compilation on a busy machine takes a quarter of it


class Command:
    """`exoid`; a process of its own has the cache folder of the tests."""

    def __init__(self, cache: Path):
        self.environment = {
            **{name: value for name, value in os.environ.items() if name != "COLUMNS"},
            "XDG_CACHE_HOME": str(cache),
            "PYTHONWARNINGS": "default",
        }

    def __call__(self, *arguments, cwd=".") -> subprocess.CompletedProcess[str]:
        """Run a command in this process, where all is loaded."""
        from exoid.cli.app import app
        from exoid.cli.terminal.faults import explain

        given = list(map(str, arguments))
        out, err = StringIO(), StringIO()
        with ExitStack() as inside:
            inside.enter_context(patch.object(sys, "argv", ["exoid", *given]))
            for each in (chdir(cwd), redirect_stdout(out), redirect_stderr(err)):
                inside.enter_context(each)
            try:
                code = app(given, standalone_mode=False) or 0
            except (Exception, SystemExit) as fault:
                code = explain(fault)
        return subprocess.CompletedProcess(given, code, out.getvalue(), err.getvalue())

    def alone(self, *arguments, **options) -> subprocess.CompletedProcess[str]:
        """The console script itself, with every warning shown: for fits that take a while."""
        return subprocess.run(
            [SCRIPT, *map(str, arguments)],
            **{"env": self.environment, "timeout": LIMIT, **options},
            capture_output=True,
            text=True,
            stdin=subprocess.DEVNULL,
        )

    def start(self, *arguments) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-c", HEEDING, str(SCRIPT), *map(str, arguments)],
            env=self.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def document(self, *arguments, folder: Path) -> dict:
        """What `exoid fit ... --json` writes."""
        path = folder / "fit.json"
        done = self("fit", *arguments, "--json", path)
        assert done.returncode == 0, done.stderr
        return json.loads(path.read_text(encoding="utf-8"))


def refusal(done: subprocess.CompletedProcess[str], code: int = 2) -> str:
    """The one line with which a command refused; nothing else may be said, least on stdout."""
    lines = done.stderr.splitlines()
    assert done.returncode == code, done.stderr
    assert done.stdout == ""
    assert len(lines) == 1, done.stderr
    assert lines[0].startswith("exoid: ")
    return lines[0]


def apart(one: dict, other: dict) -> dict[str, float]:
    """The distance of each of two fits' estimates, in standard errors."""
    return {
        name: abs(each["value"] - other[name]["value"]) / each["standard_error"]
        for name, each in one.items()
        if each["standard_error"]
    }
