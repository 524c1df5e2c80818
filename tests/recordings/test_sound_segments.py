"""A file of which some segments hold nothing: the others are read, and those are named."""

import numpy as np
import pytest

import exoid

HEAD = "segment,time_s,raw_angle_rad\n"
LISTS = """[subject]
kind = "leg"
added_mass_kg = [0.0, 1.0, 2.0]
added_mass_distance_m = [0.0, 0.1, 0.3]
[protocol]
kind = ["passive", "passive", "active"]
"""


def rows(number: int, count: int = 100, first: float = -0.1) -> str:
    return "".join(f"{number},{at * 0.01:.2f},{first - at * 0.01:.4f}\n" for at in range(count))


def written(folder, text: str, sidecar: str = '[subject]\nkind = "leg"\n'):
    path = folder / "drops.csv"
    path.write_text(HEAD + text)
    path.with_suffix(".toml").write_text(sidecar)
    return path


@pytest.mark.parametrize(
    ("nothing", "why"),
    [
        ("1,,\n", "has 1 sample"),
        ("1,0.0,-0.2\n", "has 1 sample"),
        ("1,,\n1,,\n", "holds no angle"),
        ("1,0.0,\n1,0.01,\n1,0.02,\n", "holds no angle"),
    ],
)
def test_an_empty_segment_is_left_out_by_name_and_the_rest_is_read(tmp_path, nothing, why):
    path = written(tmp_path, rows(0) + nothing + rows(2, first=-0.3))
    loaded = exoid.load(path, whole=True)
    first = [float(each.best_angle[0]) for each in loaded.recording.segments]
    assert first == [-0.1, -0.3]
    assert f"{path}: segment 1 {why}: it is left out." in loaded.notes
    assert any("2 of the file is 1 now" in note for note in loaded.notes)


def test_what_is_said_of_each_segment_stays_with_it(tmp_path):
    path = written(tmp_path, rows(0) + "1,,\n" + rows(2), LISTS)
    recording = exoid.load(path, whole=True).recording
    assert [recording.added_mass(number) for number in (0, 1)] == [0.0, 2.0]
    assert [recording.kind(number) for number in (0, 1)] == ["passive", "active"]


def test_a_bad_sample_behind_an_empty_segment_is_named_by_its_line(tmp_path):
    path = written(tmp_path, rows(0, 5) + "1,,\n" + "2,0.0,-0.1\n2,0.01,99\n")
    with pytest.raises(ValueError, match="line 9"):
        exoid.load(path)


@pytest.mark.parametrize("text", ["0,,\n1,,\n", "0,0.0,-0.1\n"])
def test_a_file_of_which_nothing_is_left_is_refused(tmp_path, text):
    with pytest.raises(ValueError, match="segment 0 has 1 sample"):
        exoid.load(written(tmp_path, text))


def test_the_same_holds_for_data_in_memory():
    time = np.concatenate([np.arange(50) * 0.01, [0.0], np.arange(50) * 0.01])
    number = np.repeat([0, 1, 2], [50, 1, 50])
    with pytest.warns(UserWarning, match=r"left out|count on") as said:
        made = exoid.recording(
            time_s=time, segment=number, raw_angle=-0.1 - time, subject={"kind": "leg"}
        )
    assert len(made.segments) == 2
    assert "segment 1 has 1 sample" in str(said[0].message)
