"""What a user meets first: help and version, at once and without the heavy libraries."""

import os
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest
from command_line import SCRIPT

from exoid.cli import commands
from exoid.cli.app import COMMANDS, load

HEAVY = ("jax", "equinox", "optimistix", "scipy", "matplotlib", "can", "cantools", "xarray")


def best_of_five(arguments: list[str], enough: float) -> float:
    """s of the processor, which count on a machine that is busy, too; the best tells what the
    program needs, the others what else went through the caches.

    One run that takes less than `enough` settles it.
    """
    taken = []
    for _ in range(5):
        begin = of_children()
        subprocess.run(arguments, check=True, capture_output=True)
        taken.append(of_children() - begin)
        if taken[-1] < enough:
            break
    return min(taken)


def of_children() -> float:
    """s that the processor has worked for programs which were started here and have ended."""
    now = os.times()
    return now.children_user + now.children_system


@pytest.mark.skipif(sys.platform == "win32", reason="nobody counts there for whom it worked")
def test_time_that_a_program_works_counts_and_time_that_it_waits_does_not():
    works = "import time\nwhile time.process_time() < 0.3: pass"
    assert best_of_five([sys.executable, "-c", works], 0.4) > 0.25
    assert best_of_five([sys.executable, "-c", "import time; time.sleep(0.3)"], 0.25) < 0.25


@pytest.mark.parametrize("option", ["--help", "--version"])
def test_help_and_version_answer_within_a_third_of_a_second(option):
    assert best_of_five([str(SCRIPT), option], 0.3) < 0.3


def test_importing_exoid_takes_less_than_a_second():
    assert best_of_five([sys.executable, "-c", "import exoid"], 1.0) < 1.0


@pytest.mark.parametrize(
    "arguments", [[str(SCRIPT), "--help"], [str(SCRIPT), "fit", "--help"], ["-c", "import exoid"]]
)
def test_neither_help_nor_import_loads_a_heavy_library(arguments):
    done = subprocess.run(
        [sys.executable, "-X", "importtime", *arguments], capture_output=True, text=True, check=True
    )
    loaded = {line.rpartition("|")[2].strip().partition(".")[0] for line in done.stderr.split("\n")}
    assert "exoid" in loaded
    assert loaded.isdisjoint(HEAVY)


def test_version_is_that_of_the_package(command):
    done = command("--version")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"exoid {version('exoid')}\n"


def test_the_module_is_the_command():
    module = [sys.executable, "-m", "exoid", "--version"]
    done = subprocess.run(module, capture_output=True, text=True, check=True)
    assert done.stdout == f"exoid {version('exoid')}\n"


@pytest.mark.parametrize(("arguments", "word"), [([], "simulate"), (["fit"], "--multistart")])
@pytest.mark.parametrize("option", ["-h", "--help"])
def test_help_goes_to_stdout_and_names_what_there_is(command, arguments, word, option):
    done = command(*arguments, option)
    assert (done.returncode, done.stderr) == (0, "")
    assert word in done.stdout
    assert max(map(len, done.stdout.split("\n"))) <= 100


@pytest.mark.parametrize("arguments", [[], ["node"]])
def test_help_cuts_no_command_short_on_a_usual_terminal(arguments):
    done = subprocess.run(
        [str(SCRIPT), *arguments, "--help"],
        env={**os.environ, "COLUMNS": "80"},
        capture_output=True,
        text=True,
        check=True,
    )
    listed = done.stdout.partition("Commands:\n")[2].splitlines()
    assert len(listed) == len(load("node").commands if arguments else COMMANDS)  # a line of each
    assert [line for line in listed if not line.endswith(".") or line.endswith("..")] == []


@pytest.mark.parametrize("name", COMMANDS)
def test_help_says_of_a_command_what_it_says_of_itself(name):
    said = load(name).help or ""
    assert " ".join(said.partition("\n\n")[0].split()) == COMMANDS[name]


def test_every_command_is_listed():
    room = Path(commands.__path__[0])
    files = {each.stem for inside in (room, room / "on_bus") for each in inside.glob("*.py")}
    groups = {each.stem for each in room.glob("*/*.py") if each.stem == each.parent.name}
    assert (files | groups) - {"__init__"} == COMMANDS.keys()


@pytest.mark.parametrize(
    ("arguments", "needed"),
    [(["--help"], set()), (["--version"], set()), (["drops", "--help"], {"drops"})],
)
def test_only_the_command_that_is_called_is_loaded(arguments, needed):
    code = "import sys; from exoid.cli.app import app; app(sys.argv[1:], standalone_mode=False); "
    done = subprocess.run(
        [sys.executable, "-c", code + "print(*sys.modules)", *arguments],
        capture_output=True,
        text=True,
        check=True,
    )
    begin = "exoid.cli.commands."
    loaded = done.stdout.splitlines()[-1].split()
    found = {each.removeprefix(begin) for each in loaded if each.startswith(begin)}
    assert "exoid.cli.app" in loaded
    assert found == needed


@pytest.mark.parametrize(
    ("typed", "offered"),
    [("exoid d", {"drops", "diagnose"}), ("exoid drops --pl", {"--plot"})],
)
def test_a_shell_completes_commands_and_their_options(typed, offered):
    words = {"COMP_WORDS": typed, "COMP_CWORD": str(len(typed.split()) - 1)}
    done = subprocess.run(
        [str(SCRIPT)],
        env={**os.environ, **words, "_EXOID_COMPLETE": "complete_bash"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert {*done.stdout.split()} == offered
