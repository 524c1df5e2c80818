"""Recordings that hold the same as another are named, and whose they may be."""

import pandas as pd

from exoid.cli.outputs.study_run import doubted
from exoid.studies.page.parts.copies import copies
from study_checks import checked
from study_folders import study

ROWS = [
    {"name": "P08_R.csv", "participant": "P08", "status": "ok", "duplicate_of": ""},
    {"name": "P09_R.csv", "participant": "P09", "status": "duplicate", "duplicate_of": "P08_R.csv"},
    {"name": "P08_b.csv", "participant": "P08", "status": "duplicate", "duplicate_of": "P08_R.csv"},
]


def test_a_copy_is_named_and_of_two_people_nobody_knows_whose_it_is():
    other, own = copies(pd.DataFrame(ROWS))
    assert other.startswith("P09_R.csv holds the same as P08_R.csv")
    assert "which of two people it truly is, P08 or P09, nobody knows" in other
    assert own == "P08_b.csv holds the same as P08_R.csv, and counts once, as that one."
    assert copies(pd.DataFrame(ROWS[:1])) == []


def test_a_run_says_how_many_errors_check_finds_and_by_which_command(tmp_path):
    folder = study(tmp_path, ["P01_left.csv", "P02_left.csv"])
    assert [*doubted("archive", checked(folder, 0).errors)] == []
    (folder / "P02_left.csv").write_text((folder / "P01_left.csv").read_text())
    (said,) = doubted("archive", checked(folder, 0).errors)
    assert said.startswith("1 error in this data set")
    assert "exoid study check archive" in said
