"""The task of a worker: a step of a batch, which is kept."""

import gc
import os
from functools import cache
from pathlib import Path

from exoid.studies.dataset.entry import Dataset
from exoid.studies.engine.plan import Batch
from exoid.studies.engine.settings import Settings

OBJECTS = 100_000  # between looks for cycles of them, which take a twentieth of a fit else


def work(batch: Batch, dataset: Dataset, step: str, settings: Settings, folder: Path) -> int:
    """How many recordings went through a step, once their rows are kept in its folder."""
    from exoid.studies.engine.kept.parts import is_kept, keep

    if is_kept(folder, batch.name):
        return len(batch.items)
    prepare()
    from exoid.studies.engine.kept.tables import quantities_table, recordings_table
    from exoid.studies.engine.measure import measure

    found = measure(batch, dataset, step, settings)
    keep(folder, batch.name, recordings_table(found), quantities_table(found))
    return len(found)


@cache
def prepare() -> None:
    """Compute in float64, on one core, with programs that all workers share."""
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    gc.set_threshold(OBJECTS)
    import jax

    from exoid.fitting.solve.program_cache import keep_programs_in

    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
