"""What the names of files and folders say of a recording."""

from pathlib import Path

import pytest

from exoid.studies.dataset.layout import entry_of


def told(name: str, *ids: str) -> tuple[str, ...]:
    entry = entry_of(Path("study"), name, frozenset(ids))
    return entry.participant, entry.session, entry.side, entry.run


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("P01_left_day1.csv", ("P01", "day1", "left", "")),
        ("sub-01/ses-2/right_3.csv", ("01", "2", "right", "3")),
        ("P01/post/left/trial2.blf", ("P01", "post", "left", "2")),
        ("P01/Day 1/L_drop_3.csv", ("P01", "day1", "left", "3")),
        ("P01-right-day2.csv", ("P01", "day2", "right", "")),
        ("12_left_1.csv", ("12", "", "left", "1")),
        ("001/left/1.csv", ("001", "", "left", "1")),
        ("2024-03-01_P07_R_2.csv", ("P07", "2024-03-01", "right", "2")),
        ("session 2/S12 l.csv", ("S12", "2", "left", "")),
        ("P01/P01_left_1.csv", ("P01", "", "left", "1")),
        ("study2024/group1/T2_P01_left.csv", ("P01", "t2", "left", "")),
        ("P01_V2_L.csv", ("P01", "2", "left", "")),
        ("P01_visit1_L_v2.csv", ("P01", "1", "left", "")),  # of a format
        ("P01_links_12.03.2026.csv", ("P01", "2026-03-12", "left", "")),
        ("P01_re-test_rechts_2.csv", ("P01", "re-test", "right", "2")),
    ],
)
def test_a_name_tells_person_session_side_and_run(name, says):
    assert told(name) == says


@pytest.mark.parametrize("name", ["session.blf", "drop_left.csv", "anna/left.csv", "knee2.csv"])
def test_a_word_that_could_be_anything_is_nobody(name):
    assert told(name)[0] == ""


def test_the_table_of_participants_makes_a_word_a_person():
    assert told("anna/left.csv", "anna") == ("anna", "", "left", "")
    assert told("controls_P-01_left.csv", "P-01", "P") == ("P-01", "", "left", "")


def test_a_number_counts_trials_once_the_person_is_told():
    for name in ("1/left_2.csv", "1_left_2.csv"):
        assert told(name, "1", "2") == ("1", "", "left", "2")


def test_a_name_of_bids_tells_the_side_by_its_acquisition():
    name = "sub-01/ses-1/motion/sub-01_ses-1_task-drop_tracksys-knee_acq-left_run-2_motion.tsv"
    assert told(name) == ("01", "1", "left", "2")
    assert entry_of(Path("study"), name, frozenset()).task == "drop"


def test_letters_that_steer_a_terminal_are_escaped_and_the_file_is_still_found():
    entry = entry_of(Path("study"), "P01_\x1b[31m_left.csv", frozenset())
    assert entry.name == r"P01_\u001b[31m_left.csv"
    assert entry.path == Path("study/P01_\x1b[31m_left.csv")


def test_a_line_break_in_a_name_parts_its_words_and_is_shown_escaped():
    entry = entry_of(Path("study"), "P01\n_left.csv", frozenset())
    assert (entry.participant, entry.side, entry.name) == ("P01", "left", r"P01\n_left.csv")
