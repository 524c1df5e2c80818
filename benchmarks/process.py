"""Times whole processes, from the shell's point of view: exoid and what a SciPy user would run.

python benchmarks/process.py [--runs 7]
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from problem import cycle, ten_segments, write

EXOID = str(Path(sys.executable).with_name("exoid"))
RIVAL = [sys.executable, str(Path(__file__).with_name("rival_process.py"))]
PATIENCE = 30.0  # s, after which a command is not run again
Commands = dict[str, list[str]]


def fits(table: Path, starts: int) -> Commands:
    """What reads a table, fits it and prints the parameters."""
    end = [str(table), "--multistart", str(starts)]
    return {
        "exoid fit": [EXOID, "fit", *end],
        "SLSQP, numba": [*RIVAL, "slsqp_numba", *end],
        "TRF, numba": [*RIVAL, "trf_numba", *end],
        "TRF, 2 processes": [*RIVAL, "trf_numba", *end, "--processes", "2"],
    }


def small() -> Commands:
    """What should answer at once."""
    return {
        "python -c pass": [sys.executable, "-c", "pass"],
        "import exoid": [sys.executable, "-c", "import exoid"],
        "exoid --version": [EXOID, "--version"],
        "exoid --help": [EXOID, "--help"],
    }


def seconds(command: list[str], cache: Path) -> float:
    """Wall time of one process, with `cache` as the user's cache folder.

    One thread for linear algebra: exoid asks for that itself, and the rivals are faster with it.
    """
    environment = os.environ | {"XDG_CACHE_HOME": str(cache), "OPENBLAS_NUM_THREADS": "1"}
    started = time.perf_counter()
    subprocess.run(command, env=environment, check=True, stdout=subprocess.DEVNULL)
    return time.perf_counter() - started


def interleaved(commands: Commands, runs: int, cache: Path) -> dict[str, list[float]]:
    """Times of every command, each in its turn; who is slow, less often. All have run before."""
    times: dict[str, list[float]] = {name: [] for name in commands}
    for _ in range(runs):
        for name, command in commands.items():
            if sum(times[name]) < PATIENCE:
                times[name].append(seconds(command, cache))
    return times


def table(times: dict[str, list[float]]) -> str:
    """Medians, and how often the first command's median goes into each."""
    unit = float(np.median(next(iter(times.values()))))
    return "\n".join(
        f"  {name:18}{np.median(each):8.3f} s  ({min(each):.3f} - {max(each):.3f})"
        f" of {len(each)}{np.median(each) / unit:9.2f}"
        for name, each in times.items()
    )


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=7)
    runs = parser.parse_args().runs
    print("Wall time of whole processes: median (min - max) of n, ratio to the first.")
    print(f"Load before: {os.getloadavg()[0]:.2f} on {os.cpu_count()} cores.", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        for name, problem in (("cycle", cycle()), ("ten_segments", ten_segments())):
            recording, cache = Path(folder) / f"{name}.csv", Path(folder) / f"{name} cache"
            write(problem, recording)
            commands = fits(recording, 64)
            first = seconds(commands["exoid fit"], cache)
            for warming_up in fits(recording, 1).values():
                seconds(warming_up, cache)
            times = interleaved(commands, runs, cache)
            extra = first - float(np.median(times["exoid fit"]))
            print(f"\n{name}, 64 starts\n{table(times)}")
            print(f"  exoid's first run, empty cache: {first:.3f} s, {extra:.3f} s more")
        interleaved(small(), 1, Path(folder))
        print(f"\nstart-up\n{table(interleaved(small(), runs, Path(folder)))}")


if __name__ == "__main__":
    main()
