"""Times a warm fit against SciPy's methods, on the same recordings and from the same starts.

python benchmarks/speed.py [--quick] [--json FILE]
"""

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # faster for all: their matrices are small

import argparse
import json
import tempfile
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, field
from multiprocessing import get_context
from pathlib import Path

import jax
import numpy as np

from contest import Contestant, exoid_contestant, rival_contestants
from problem import cycle, starts, ten_segments

REPETITIONS = 5
PATIENCE = 30.0  # s that one contestant may take in all, once each had its turn
WARM_UP = 8  # starts
SEED = 0
HEADER = """\
Warm wall times of one process. Starts: m, J, l, d, c, tau uniform within the bounds of Eq. 13
(problem.starts, seed {seed}), the same for all. exoid: `fit`, that is conditioning, all starts,
prior, limits and errors; the others: their minimisation alone, from every start in turn.
at best: share of starts within 0.1 % of the method's own best cost, 0 where that cost lies more
than 1 % above the best of all. excess: the method's best cost over the best of all, by one
function on all samples.
times exoid: the method's median over exoid's, and its fastest run over exoid's fastest, which other
load on the machine disturbs less. Two processes gain only where both cores are idle.
Load before: {load:.2f} on {cores} cores.
"""


@dataclass(frozen=True)
class Case:
    """A recording and how many starts it is fitted from."""

    recording: str
    starts: int
    contestants: list[Contestant]


@dataclass
class Row:
    """What one contestant did in one case."""

    method: str
    recording: str
    starts: int
    seconds: list[float] = field(default_factory=list)
    cost: float = np.inf
    at_best: float = 0.0
    excess: float = 0.0

    @property
    def median(self) -> float:
        return float(np.median(self.seconds))


def cases(quick: bool, folder: Path, mapper: Callable) -> list[Case]:
    """64 starts, then many; without those that would take many minutes."""
    made = []
    for name, problem, many in (
        ("cycle", cycle(), [256] if quick else [1024, 4096]),
        ("ten segments", ten_segments(), [256] if quick else [1024]),
    ):
        exoid = exoid_contestant(problem, folder / f"{name.replace(' ', '_')}.csv")
        slow, numba, trf, trf_twice = rival_contestants(problem, mapper)
        every = [exoid, trf, trf_twice, numba]
        if name == "cycle" and not quick:
            every.append(slow)
        made.append(Case(name, 64, every))
        made += [Case(name, count, [exoid, trf, trf_twice]) for count in many]
    return made


def measure(case: Case) -> list[Row]:
    """Time everyone in turn, again and again; who is slow, once."""
    begin = starts(case.starts, SEED)
    rows = [Row(each.name, case.recording, case.starts) for each in case.contestants]
    for each in case.contestants:
        if each.warms_up:
            each.run(begin[:WARM_UP])
    for repetition in range(REPETITIONS):
        for each, row in zip(case.contestants, rows, strict=True):
            if repetition and sum(row.seconds) + row.seconds[0] > PATIENCE:
                continue
            started = time.perf_counter()
            found = each.run(begin)
            row.seconds.append(time.perf_counter() - started)
            row.cost, row.at_best = each.judge(found)
    best = min(row.cost for row in rows)
    for row in rows:
        row.excess = row.cost / best - 1
        row.at_best = row.at_best if row.excess < 1e-2 else 0.0
    return rows


def table(rows: list[Row]) -> str:
    """One line per contestant and case."""
    lines = [
        f"{'recording':13}{'starts':>7}  {'method':18}{'median s':>9}  {'(min - max) of n':24}"
        f"{'at best':>8}{'excess':>9}{'times exoid':>13}{'fastest':>9}"
    ]
    for row in rows:
        exoid = next(
            r for r in rows if (r.recording, r.starts) == (row.recording, row.starts)
        )  # it comes first
        spread = f"({min(row.seconds):.4f} - {max(row.seconds):.4f}) of {len(row.seconds)}"
        lines.append(
            f"{row.recording:13}{row.starts:7d}  {row.method:18}{row.median:9.4f}  {spread:24}"
            f"{row.at_best:8.1%}{row.excess:9.1e}{row.median / exoid.median:13.2f}"
            f"{min(row.seconds) / min(exoid.seconds):9.2f}"
        )
    return "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="at most 256 starts, no NumPy SLSQP")
    parser.add_argument("--json", type=Path, help="the rows, for machines")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    load, cores = os.getloadavg()[0], os.cpu_count()
    print(HEADER.format(seed=SEED, load=load, cores=cores), flush=True)
    with tempfile.TemporaryDirectory() as folder, get_context("spawn").Pool(2) as pool:
        rows = []
        for case in cases(options.quick, Path(folder), pool.map):
            rows += measure(case)
    print(table(rows))
    if options.json:
        options.json.write_text(json.dumps([asdict(row) for row in rows], indent=2) + "\n")


if __name__ == "__main__":
    main()
