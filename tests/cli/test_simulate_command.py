"""`exoid simulate`: what it writes is what `exoid fit` reads."""

import pytest
from command_line import refusal

from exoid.recordings.formats.own_table import read_table

LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000


def test_the_fit_of_a_simulated_drop_gives_back_its_ratios(command, tmp_path):
    path = tmp_path / "leg.csv"
    options = ("--inertia", 0.5, "--damping", 0.3, "--drop", -20, "--duration", 2)
    done = command("simulate", path, *options, "--body-mass", 74, "--height", 1.78)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == f"{path}: 1 segment, and {tmp_path / 'leg.toml'}\n"
    ratios = command.document(path, folder=tmp_path)["ratios"]
    truth = {
        "gravity_over_inertia": 4.5 * 0.265 * 9.81 / 0.5,
        "stiffness_over_inertia": 2.8 / 0.5,
        "damping_over_inertia": 0.3 / 0.5,
    }
    for name, value in truth.items():
        assert abs(ratios[name]["value"] - value) < LIKELY * ratios[name]["standard_error"]


def test_the_same_seed_gives_the_same_file_and_another_does_not(command, tmp_path):
    written = []
    for name, seed in (("a.csv", 1), ("b.csv", 1), ("c.csv", 2)):
        command("simulate", tmp_path / name, "--drop", -20, "--duration", 1, "--seed", seed)
        written.append((tmp_path / name).read_bytes())
    assert written[0] == written[1] != written[2]


def test_drops_and_cycles_become_segments_of_their_kind(command, tmp_path):
    path = tmp_path / "mixed.csv"
    options = ("--drop", -20, "--cycle", -3, "--period", 1.2, "--torque-amplitude", -4)
    done = command("simulate", path, *options, "--duration", 2, "--height", 1.7, "--no-noise")
    assert (done.returncode, done.stderr) == (0, "")
    recording, notes = read_table(path)
    assert notes == ()
    assert [recording.kind(number) for number in (0, 1)] == ["passive", "active"]
    assert recording.cycle_period(1) == 1.2
    assert recording.subject.height == 1.7


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--mass", "0"], "--mass is 0"),
        (["--mass", "nan"], "--mass is nan"),
        (["--damping", "-1"], "--damping is -1"),
        (["--stiffness", "inf"], "--stiffness is inf"),
        (["--com-distance", "-0.2"], "--com-distance is -0.2"),
        (["--inertia", "0.01"], "less than m l^2"),
        (["--drop", "500"], "--drop is 500 deg"),
        (["--cycle", "nan"], "--cycle is nan deg"),
        (["--torque-amplitude", "nan", "--cycle", "-3"], "--torque-amplitude is nan"),
        (["--duration", "1e9"], "'--duration'"),
        (["--period", "0"], "'--period'"),
        (["--added-mass", "1000"], "'--added-mass'"),
        (["--body-mass", "7700"], "--body-mass is 7700 kg"),
        (["--height", "180"], "--height is 180 m"),
        (["--seed", "-1"], "'--seed'"),
    ],
)
def test_a_leg_that_cannot_be_is_refused(command, tmp_path, options, said):
    assert said in refusal(command("simulate", "leg.csv", *options, cwd=tmp_path))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("leg.txt", "must end in .csv"),
        ("leg", "must end in .csv"),
        ("nowhere/leg.csv", "the folder nowhere does not exist"),
    ],
)
def test_a_name_that_cannot_be_written_is_refused(command, tmp_path, name, said):
    assert said in refusal(command("simulate", name, cwd=tmp_path))
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(("angle", "unlikely"), [(20, True), (10, False), (-20, False)])
def test_a_drop_from_an_overextended_knee_is_asked_for_its_sign(command, tmp_path, angle, unlikely):
    done = command("simulate", tmp_path / "leg.csv", "--drop", angle, "--duration", 2)
    assert done.returncode == 0
    assert ("For 20 deg of flexion say --drop -20." in done.stderr) == unlikely
    assert bool(done.stderr) == unlikely


def test_a_failing_run_leaves_the_recording_that_was_there(command, tmp_path):
    for name in ("leg.csv", "leg.toml"):
        (tmp_path / name).write_text("old")
    refusal(command("simulate", tmp_path / "leg.csv", "--height", 180))
    assert {path.read_text() for path in tmp_path.iterdir()} == {"old"}


def test_a_recording_that_is_there_is_not_simulated_over(command, tmp_path):
    kept = tmp_path / "drop.csv"
    kept.write_text("kept", encoding="utf-8")
    assert "--force" in refusal(command("simulate", kept))
    assert kept.read_text(encoding="utf-8") == "kept"
