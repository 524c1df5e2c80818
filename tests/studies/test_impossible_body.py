"""A body that nobody has stops no fit: ratios need none."""

import pytest

from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.engine import measure as module
from exoid.studies.engine.measure import measure
from exoid.studies.engine.plan import Batch
from exoid.studies.engine.read_contents import read_contents
from exoid.studies.engine.settings import Settings
from study_folders import study

NAMES = ["P01_left.csv", "P02_left.csv"]
PEOPLE = "id,body_mass_kg,height_m\nP01,77,1.80\nP02,7.7,1.80\n"


@pytest.fixture
def fitted(tmp_path, monkeypatch):
    """Two recordings as a fit has them, and what a run says of both."""
    asked = []

    def fits(recordings, **_):
        asked.extend(recordings)
        return [ValueError("enough was seen")] * len(recordings)

    monkeypatch.setattr(module, "fit_many", fits)
    dataset = open_dataset(study(tmp_path, NAMES, {"participants.csv": PEOPLE}))
    items = tuple(read_contents(dataset))
    return asked, measure(Batch(items), dataset, "fit", Settings(("fit",)))


def test_a_body_that_nobody_has_is_unknown_to_a_fit_and_others_are_known(fitted):
    (one, other), _ = fitted
    assert (one.subject.body_mass, one.subject.height) == (77.0, 1.80)
    assert (other.subject.body_mass, other.subject.height) == (None, None)


def test_that_it_is_taken_for_unknown_is_said_and_the_table_keeps_what_was_told(fitted):
    _, (one, other) = fitted
    assert one.rows == []
    (note,) = other.rows
    assert note.note.startswith("the person weighs 7.7 kg at 1.8 m, as nobody does.")
    assert note.note.endswith("ratios alone count.")
    assert other.recording.subject.body_mass == 7.7
