"""Studies one after the other, whose tables are kept as soon as they are there: a killed run goes
on, and what is asked of tables can be asked anew.
"""

import json
import time
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from tempfile import TemporaryDirectory

from exoid.files.replacing import replacing
from exoid.studies.engine.settings import Settings
from exoid.studies.statistics.tables.study import Study, open_study

from .answered import Answered, kinds_of, told_of
from .compute import compute
from .exact import exact
from .world import Visit, World, draw_study
from .write import put_study

DONE = "recordings.parquet"  # which is written last


def replications(
    world: World, settings: Settings, seeds: Iterable[int], folder: Path
) -> Iterator[Answered]:
    """Those whose tables are in `folder` are not fitted again; of one world and settings in one
    folder.

    **Raises** `ValueError` where another world has been there.
    """
    folder.mkdir(parents=True, exist_ok=True)
    asked = {"world": asdict(world), "fit": repr(dict(settings.fit))}
    check_same(folder / "asked.json", json.loads(json.dumps(asked)))
    for seed in seeds:
        visits = draw_study(world, seed)
        study = tables(visits, settings, seed, folder / f"study-{seed:04d}")
        without = told_of(exact(visits, world), world)
        yield Answered(seed, told_of(study, world), without, kinds_of(study, world, visits))


def tables(visits: list[Visit], settings: Settings, seed: int, place: Path) -> Study:
    """What a run leaves, with the time of the processor that it took."""
    if not (place / DONE).is_file():
        before = time.process_time()
        with TemporaryDirectory() as there:
            put_study(visits, seed, Path(there))
            compute(Path(there), place, settings)
        print(f"study {seed}: {time.process_time() - before:.0f} s of the processor", flush=True)
    return open_study(place)


def check_same(path: Path, asked: dict) -> None:
    """What was asked before in this folder is asked again."""
    if not path.is_file():
        with replacing(path) as part:
            part.write_text(json.dumps(asked, indent=1), encoding="utf-8")
    elif json.loads(path.read_text(encoding="utf-8")) != asked:
        raise ValueError(f"{path.parent}: other studies are kept there. Name another folder.")
