"""How many recordings a second are fitted, by a study's batches and by other ways.

python -m benchmarks.studies [--recordings 1000] [--workers 2] [--skip joblib,shell]
python -m benchmarks.studies --steps drops --skip loop,batch,joblib,shell   # the engine's share

Drops of as many simulated people, 7 s at 100 Hz. All ways run in one call, one after the other, on
the same recordings; what takes long has fewer of them, and its time for one is the mean. Other work
on the machine disturbs the clock, and less the time of the processor.
"""

import argparse
import os
from pathlib import Path
from tempfile import TemporaryDirectory

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from exoid.studies.engine.settings import Settings
from exoid.studies.engine.work import prepare

from . import contestants
from .contestants import Taken
from .people import drops, write

FEW, FEWER = 40, 3  # recordings of a loop, and of the shell's


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.studies",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--recordings", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--skip", default="", help="of loop,batch,joblib,shell,bare,engine")
    parser.add_argument("--steps", default="fit", help="of the last two ways")
    options = parser.parse_args()
    settings = Settings(tuple(options.steps.split(",")))
    prepare()
    with TemporaryDirectory() as there:
        folder, count = Path(there) / "study", options.recordings
        write(drops(count), folder)
        paths = sorted(folder.glob("*.csv"))
        ways = {
            "loop": lambda: contestants.loop(paths[:FEW]),
            "batch": lambda: contestants.batch(paths),
            "joblib": lambda: contestants.by_joblib(paths[:FEW]),
            "shell": lambda: contestants.shell(paths[:FEWER]),
            "bare": lambda: contestants.bare(folder, count, settings),
            "engine": lambda: contestants.engine(
                folder, Path(there) / "results", count, (settings, options.workers)
            ),
        }
        skipped = options.skip.split(",")
        found = []
        for name, way in ways.items():
            if name not in skipped:
                found.append(way())
                print(row(found[-1], found[0]), flush=True)


def row(one: Taken, first: Taken) -> str:
    """One way beside the first."""
    said = f"{one.way:28} {one.recordings:6} recordings {one.each:9.1f} ms each"
    said += f" {first.each / one.each:7.2f} times as many a second as the first"
    if one.processor is None or first.processor is None:
        return said
    each, before = one.processor / one.recordings, first.processor / first.recordings
    return f"{said}; {1e3 * each:8.1f} ms of the processor each, {before / each:6.2f} times as many"


if __name__ == "__main__":
    main()
