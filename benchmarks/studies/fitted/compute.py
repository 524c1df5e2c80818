"""A data set through the steps of `exoid study run`, in this process."""

from pathlib import Path

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine.kept.assemble import assemble
from exoid.studies.engine.kept.item import Item
from exoid.studies.engine.plan import plan
from exoid.studies.engine.read_contents import read_contents
from exoid.studies.engine.settings import TOGETHER, Settings
from exoid.studies.engine.work import work
from exoid.studies.statistics.tables.study import Study, open_study


def compute(folder: Path, results: Path, settings: Settings) -> Study:
    """The tables that a run leaves in `results`: the same batches, one after the other."""
    found = open_dataset(folder)
    items = [each for each in read_contents(found) if isinstance(each, Item)]
    folders = {step: results / step for step in settings.steps}
    results.mkdir(parents=True, exist_ok=True)
    for step in settings.steps:
        for batch in plan(items, 1, TOGETHER[step]):
            work(batch, found, step, settings, folders[step])
    names = {item.key: item.entry.name for item in items}
    assemble(results, folders, names, found, {"": ()})
    return open_study(results)
