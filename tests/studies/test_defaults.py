"""`defaults.toml`: what holds for all recordings at or below a folder is told once."""

import numpy as np
import pytest

from exoid.recordings.recording import Recording
from exoid.studies.dataset.open_dataset import open_dataset
from exoid.studies.dataset.recording_of import recording_of
from exoid.studies.engine.run_study import run_study
from study_checks import checked, found
from study_folders import study
from study_runs import DROPS

FLIP = '[sensors]\nflip = "angle"\n'
NAMES = [f"P{n // 2:02d}/{'left' if n % 2 else 'right'}.csv" for n in range(12)]


@pytest.fixture
def flexion_positive(tmp_path):
    """Twelve recordings of a camera that counts flexion positive."""
    folder = study(tmp_path / "study", NAMES)
    for name in NAMES:
        (folder / name).write_text((folder / name).read_text().replace(",-", ","))
    return folder


def read(folder) -> dict[str, Recording]:
    dataset = open_dataset(folder)
    return {each.name: recording_of(each, dataset) for each in dataset.entries}


def test_a_sign_is_told_once_for_a_whole_study(flexion_positive, tmp_path):
    assert checked(flexion_positive).readable == 0
    (flexion_positive / "defaults.toml").write_text(FLIP)
    assert checked(flexion_positive).readable == len(NAMES)
    sound = read(study(tmp_path / "sound", NAMES))
    for name, mended in read(flexion_positive).items():
        wanted = sound[name].segments[0].raw_angle
        np.testing.assert_array_equal(mended.segments[0].raw_angle, wanted)


def test_a_nearer_file_and_the_own_sidecar_win_key_by_key(tmp_path):
    told = {"defaults.toml": "[subject]\nbody_mass_kg = 50\nheight_m = 1.5\nage_years = 20\n"}
    folder = study(tmp_path, ["P01/left.csv", "P02/left.csv"], told)
    (folder / "P01/defaults.toml").write_text("[subject]\nheight_m = 1.6\nage_years = 30\n")
    (folder / "P01/left.toml").write_text("[subject]\nage_years = 40\n")
    sizes = {
        name: (each.subject.body_mass, each.subject.height, each.subject.age)
        for name, each in read(folder).items()
    }
    assert sizes == {"P01/left.csv": (50, 1.6, 40), "P02/left.csv": (50, 1.5, 20)}


def test_an_own_zero_takes_the_place_of_the_zero_of_all(tmp_path):
    """Both at once are two answers to one question, which is refused."""
    told = {"defaults.toml": '[sensors]\nzero = "hanging"\n'}
    folder = study(tmp_path / "study", ["P01_left.csv"], told)
    (folder / "P01_left.toml").write_text("[sensors]\nangle_zero_deg = 1.0\n")
    alone = study(tmp_path / "alone", ["P01_left.csv"])
    shifted = read(folder)["P01_left.csv"].segments[0].raw_angle
    asis = read(alone)["P01_left.csv"].segments[0].raw_angle
    assert shifted is not None
    assert asis is not None
    np.testing.assert_allclose(shifted, asis - np.radians(1.0), atol=1e-12)  # rounding


def test_columns_of_all_are_named_once(tmp_path):
    told = {"defaults.toml": '[columns]\nraw_angle_rad = "bend"\n'}
    folder = study(tmp_path, ["P01_left.csv"], told)
    path = folder / "P01_left.csv"
    path.write_text(path.read_text().replace("raw_angle_rad", "bend"))
    assert [*read(folder)] == ["P01_left.csv"]


def test_what_was_computed_is_computed_anew_where_the_file_above_changes(here, tmp_path):
    folder = study(tmp_path / "study", NAMES[:4])

    def computed() -> int:
        return run_study(open_dataset(folder), tmp_path / "results", DROPS).computed

    assert (computed(), computed()) == (4, 0)
    (folder / "P00/defaults.toml").write_text("[subject]\nage_years = 30\n")
    assert (computed(), computed()) == (2, 0)


def test_a_key_that_nothing_heeds_is_told_once(tmp_path):
    told = {"defaults.toml": '[sensors]\nflipp = "angle"\n'}
    ((level, where, says),) = found(study(tmp_path, NAMES[:1], told), "unknown key")
    assert (level, where) == ("warning", "defaults.toml")
    assert says.startswith("unknown flipp in [sensors] is kept, but not used.")


def test_one_cause_of_many_is_said_once_and_drowns_nothing(command, flexion_positive):
    (flexion_positive / "P09_left.csv").write_text("")
    done = command("study", "check", flexion_positive)
    said = done.stdout
    assert "unreadable: 13" in said
    assert "12 alike, such as P00/left.csv: the angle lies between" in said
    assert (
        'write flip = "angle" in [sensors] of its sidecar, or, where all are like this, of' in said
    )
    assert "defaults.toml at the top of the data set" in said
    assert "flip=" not in said
    assert "P09_left.csv: the file is empty" in said


def test_convert_of_a_folder_says_where_a_sign_is_told(command, flexion_positive, tmp_path):
    out = tmp_path / "out"
    done = command("convert", flexion_positive, "-o", out, "--flip", "angle")
    assert "defaults.toml, for all recordings" in " ".join(done.stderr.split())
    (flexion_positive / "defaults.toml").write_text(FLIP)
    done = command("convert", flexion_positive, "-o", out, "--as", "plain")
    assert done.returncode == 0, done.stderr
    assert "left behind" not in done.stderr
    assert checked(out).readable == len(NAMES)
