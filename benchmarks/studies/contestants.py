"""Ways to fit many recordings, each with the time of a clock and of the processor that it took."""

import os
import resource
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from exoid.fitting.estimate import fit
from exoid.recordings.loading.load import load
from exoid.studies.batch.fit_many import fit_many
from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.plan import LARGEST
from exoid.studies.engine.run_study import run_study
from exoid.studies.engine.settings import Settings

SCRIPT = Path(sys.executable).with_name("exoid")


@dataclass(frozen=True)
class Taken:
    """What a way took for so many recordings."""

    way: str
    recordings: int
    seconds: float
    processor: float | None  # s, of all its processes, where they tell

    @property
    def each(self) -> float:
        """ms of the clock for one."""
        return 1e3 * self.seconds / self.recordings


def timed(way: str, count: int, work: Callable[[], object]) -> Taken:
    began, before = time.perf_counter(), processor()
    work()
    return Taken(way, count, time.perf_counter() - began, processor() - before)


def processor() -> float:
    """s that this process and those that it started have computed so far."""
    who = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(each.ru_utime + each.ru_stime for each in map(resource.getrusage, who))


def loop(paths: Sequence[Path]) -> Taken:
    """`exoid.fit` one after the other, in this process, which is warm."""
    each = [load(path).recording for path in paths]
    fit(each[0])
    return timed("a loop over exoid.fit", len(each), lambda: [fit(one) for one in each])


def batch(paths: Sequence[Path]) -> Taken:
    """`fit_many`, in this process, which is warm."""
    each = [load(path).recording for path in paths]
    fit_many(each[:8])

    def work() -> None:
        for at in range(0, len(each), LARGEST):
            fit_many(each[at : at + LARGEST])

    return timed("fit_many", len(each), work)


def by_joblib(paths: Sequence[Path]) -> Taken:
    """`exoid.fit` in as many processes as there are cores, each warmed by one recording."""
    from joblib import Parallel, delayed

    cores = os.cpu_count() or 1
    with Parallel(n_jobs=cores) as pool:
        pool(delayed(warmed)(path) for path in list(paths)[:cores])
        count = len(paths)
        taken = timed("joblib", count, lambda: pool(delayed(warmed)(path) for path in paths))
    return replace(taken, processor=None)  # its processes live on


def warmed(path: Path) -> float:
    """A fit in a process of a pool."""
    from exoid.studies.engine.work import prepare

    prepare()
    return fit(load(path).recording).loss


def shell(paths: Sequence[Path]) -> Taken:
    """`exoid fit FILE --json ...`, a process each; the programs are compiled already."""

    def work() -> None:
        for path in paths:
            subprocess.run([SCRIPT, "fit", path], check=True, stdout=subprocess.DEVNULL)

    work_one = [SCRIPT, "fit", paths[0]]
    subprocess.run(work_one, check=True, stdout=subprocess.DEVNULL)
    return timed("a shell loop", len(paths), work)


def engine(folder: Path, results: Path, count: int, how: tuple[Settings, int]) -> Taken:
    """`exoid study run`: reading, steps, tables, the start of the workers, and their compiling."""
    found, (settings, workers) = open_dataset(folder), how
    return timed(
        f"the engine, {workers} worker{'s' if workers > 1 else ''}",
        count,
        lambda: run_study(found, results, settings, count=workers),
    )


def bare(folder: Path, count: int, settings: Settings) -> Taken:
    """What a worker does, in this process: `work` of all batches, and no engine around it."""
    from tempfile import TemporaryDirectory

    from exoid.studies.engine.kept.item import Item
    from exoid.studies.engine.plan import plan
    from exoid.studies.engine.read_contents import read_contents
    from exoid.studies.engine.settings import TOGETHER
    from exoid.studies.engine.work import work

    found = open_dataset(folder)
    items = [each for each in read_contents(found) if isinstance(each, Item)]
    batches = {step: plan(items, 1, TOGETHER[step]) for step in settings.steps}
    with TemporaryDirectory() as there:
        for step, each in batches.items():
            work(each[-1], found, step, settings, Path(there) / step)

        def all_of_them() -> None:
            for step, each in batches.items():
                for batch in each:
                    work(batch, found, step, settings, Path(there) / step)

        return timed("batches without the engine", count, all_of_them)
