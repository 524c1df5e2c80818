"""What a user meets first: help and version, at once and without the heavy libraries."""

import subprocess
import sys
import time
from importlib.metadata import version

import pytest
from command_line import SCRIPT

HEAVY = ("jax", "equinox", "optimistix", "scipy", "matplotlib", "can", "cantools", "xarray")


def best_of_five(arguments: list[str], enough: float) -> float:
    """s; the best tells what the program needs, the others what else the machine was doing.

    One run that takes less than `enough` settles it.
    """
    taken = []
    for _ in range(5):
        begin = time.perf_counter()
        subprocess.run(arguments, check=True, capture_output=True)
        taken.append(time.perf_counter() - begin)
        if taken[-1] < enough:
            break
    return min(taken)


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
