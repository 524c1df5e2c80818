"""The whole run of a SciPy user: read a recording, fit it from many starts, print the parameters.

python benchmarks/rival_process.py trf_numba RECORDING.csv --multistart 64 --seed 0
"""

import argparse
import tomllib
from multiprocessing import Pool
from pathlib import Path

import numpy as np

from problem import Problem, Segment, starts
from rivals import Fits, slsqp_numba, success_rate, trf_numba

METHODS = {method.__name__: method for method in (slsqp_numba, trf_numba)}
COLUMNS = ("time_s", "segment", "raw_angle_rad", "raw_velocity_rad_s")


def read(path: Path) -> Problem:
    """A recording of format version 1 with the raw channels, kinds and periods that are needed."""
    header = path.open().readline().strip().split(",")
    order = [header.index(column) for column in COLUMNS]
    time, number, angle, velocity = np.loadtxt(path, delimiter=",", skiprows=1, usecols=order).T
    protocol = tomllib.loads(path.with_suffix(".toml").read_text())["protocol"]
    segments = []
    for k, (kind, period) in enumerate(
        zip(protocol["kind"], protocol["cycle_period_s"], strict=True)
    ):
        rows = number == k
        frequency = 1 / period if kind == "active" else 0.0
        segments.append(Segment(time[rows], angle[rows], velocity[rows], period, frequency))
    return tuple(segments)


def table(fits: Fits) -> str:
    """The best start's parameters, one per line."""
    best = int(np.argmin(fits.cost))
    ratios = fits.ratios[best]
    names = ["m l g / J", "c / J", "d / J"]
    names += [f"tau / J, cycle {cycle + 1}" for cycle in range(ratios.size - 3)]
    units = ["1/s^2", "1/s^2", "1/s", *["rad/s^2"] * (ratios.size - 3)]
    lines = [
        f"{name:18} {value:12.5f} {unit}"
        for name, value, unit in zip(names, ratios, units, strict=True)
    ]
    reached = success_rate(fits, fits.cost[best])
    return "\n".join([*lines, f"cost {fits.cost[best]:.6f}, reached by {reached:.1%} of starts"])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("method", choices=METHODS)
    parser.add_argument("recording", type=Path)
    parser.add_argument("--multistart", type=int, default=64)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--processes", type=int, default=1)
    options = parser.parse_args()
    method, problem = METHODS[options.method], read(options.recording)
    points = starts(options.multistart, options.seed)
    if options.processes == 1:
        fits = method(problem, points)
    else:
        with Pool(options.processes) as pool:
            fits = method(problem, points, pool.map)
    print(table(fits))


if __name__ == "__main__":
    main()
