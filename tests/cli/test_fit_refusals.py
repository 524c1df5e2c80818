"""`exoid fit` on bad input: one line that says what, where and what to do, and nothing written."""

import shutil
import sys

import can
import numpy as np
import pytest
from command_line import refusal
from sessions import DROP, session, write_log

TIME = np.arange(200) * 0.01
SWING = -1.5 + 1.2 * np.exp(-0.4 * TIME) * np.cos(5 * TIME)
CAN_CSV = "timestamp,arbitration_id,extended,remote,error,dlc,data\n"


def table(path, angle, column="raw_angle_rad", known=True):
    """A recording with one channel; its sidecar says whose it is, so that nothing is noted."""
    lines = [f"{time:.2f},{value}" for time, value in zip(TIME, angle, strict=False)]
    path.write_text("\n".join([f"time_s,{column}", *lines]) + "\n")
    if known:
        path.with_suffix(".toml").write_text('[protocol]\nkind = "passive"\n')
    return path


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("missing.csv", None, "Check the name"),
        ("missing.blf", None, "Check the name"),
        ("empty.csv", b"", "the file is empty"),
        ("empty.blf", b"", "is empty"),
        ("noise.csv", bytes(range(256)), "is not UTF-8 text"),
        ("noise.blf", bytes(range(256)), "is not a BLF file"),
        ("noise.asc", bytes(range(256)) * 9, "holds no CAN frame"),
        ("noise.trc", bytes(range(256)) * 9, "holds no CAN frame"),
        ("noise.log", bytes(range(256)) * 9, "holds no CAN frame"),
        ("noise.xyz", bytes(range(256)), "a recording is a table (.csv "),
        ("header.csv", b"time_s,raw_angle_rad\n", "holds a header but no samples"),
        ("one.csv", b"time_s,raw_angle_rad\n0.0,-0.1\n", "at least 2 are needed"),
        ("nan.csv", b"time_s,raw_angle_rad\n0.0,nan\n0.1,nan\n", "has no angle"),
        ("gap.csv", b"time_s,raw_angle_rad\n0.0,\n0.1,\n", "has no angle"),
        ("other.csv", b"number,angle\n0.0,1\n0.1,1\n", 'Name it: --column time_s="..."'),
        ("frames.csv", CAN_CSV.encode(), "holds no CAN frame"),
        ("side.toml", b"[subject]\n", "Name the table or log beside it"),
    ],
)
def test_a_file_that_holds_no_recording_is_refused(command, tmp_path, name, content, said):
    path = tmp_path / name
    if content is not None:
        path.write_bytes(content)
    line = refusal(command("fit", path))
    assert line.startswith(f"exoid: {path}")
    assert said in line


def test_a_directory_is_refused(command, tmp_path):
    assert "this is a directory" in refusal(command("fit", tmp_path))


@pytest.mark.parametrize(
    ("angle", "column", "said"),
    [
        (np.degrees(SWING), "raw_angle_rad", "line 2: raw_angle_rad in segment 0, sample 0"),
        (np.full(200, -1.5), "raw_angle_rad", "nothing moves: no movement goes farther than"),
        (SWING[:8], "raw_angle_rad", "in 8 samples; 10 are the least"),
    ],
)
def test_samples_that_cannot_be_fitted_are_refused(command, tmp_path, angle, column, said):
    path = table(tmp_path / "knee.csv", angle, column)
    line = refusal(command("fit", path))
    assert "knee.csv" in line
    assert said in line


def test_a_broken_sidecar_is_refused_by_its_name(command, recordings, tmp_path):
    shutil.copy(recordings / "drop.csv", tmp_path / "drop.csv")
    (tmp_path / "drop.toml").write_text("[subject\n")
    assert "drop.toml: is not valid TOML" in refusal(command("fit", tmp_path / "drop.csv"))


def test_of_two_recordings_the_bad_one_is_named(command, recordings, tmp_path):
    bad = table(tmp_path / "bad.csv", np.degrees(SWING))
    assert refusal(command("fit", recordings / "drop.csv", bad)).startswith(f"exoid: {bad}: ")


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--multistart", "0"], "'--multistart'"),
        (["--multistart", "many"], "'--multistart'"),
        (["--lambda", "-1"], "'--lambda'"),
        (["--lambda", "nan"], "'--lambda'"),
        (["--lambda", "inf"], "'--lambda'"),
        (["--seed", "-1"], "'--seed'"),
        (["--smooth", "0"], "'--smooth'"),
        (["--smooth", "60"], "Choose at most 50"),
        (["--body-mass", "7700"], "--body-mass is 7700 kg; it must lie between"),
        (["--height", "180"], "--height is 180 m; it must lie between"),
        (["--height", "nan"], "--height is nan m"),
        (["--prior", "guess"], "this is no table and no expectation"),
        (["--prior", "damping=3"], "this is not like --prior damping=3+-1"),
        (["--prior", "winter", "--prior", "dumas"], "takes one table, not winter and dumas"),
        (["--fix", "friction=1"], "no parameter of the leg has this name"),
        (["--fix", "coulomb_friction=1"], "of a term it is TERM.PARAMETER"),
        (["--fix", "mass=0"], "0 kg cannot be; it is positive"),
        (["--bound", "damping=5:2"], "5 to 2 leaves nothing"),
        (["--bound", "damping"], "this is not like --bound damping=0:20"),
        (["--bounds", "wide"], "is not one of 'body', 'paper'"),
        (["--method", "newton"], "is not one of 'lm', 'slsqp'"),
        (["--sed", "1"], "--seed"),
        (["--signal", "raw_angle=Knee.Angle"], "belong together"),
        (["--signal", "raw_angle", "--dbc", "knee.dbc"], "CHANNEL=MESSAGE.SIGNAL"),
        (["--dbc", "knee.dbc"], "belong together"),
        (["--plot", "figure.xyz"], "must end in .pdf or .svg or .png"),
        (["--plot", "nowhere/figure.png"], "the folder nowhere does not exist"),
        (["--json", "nowhere/fit.json"], "the folder nowhere does not exist"),
        (["--json", "."], "this is a directory"),
        (["--json", "same.png", "--plot", "same.png"], "written twice"),
    ],
)
def test_an_absurd_option_is_refused(command, recordings, tmp_path, options, said):
    line = refusal(command("fit", recordings / "drop.csv", *options, cwd=tmp_path))
    assert said in line
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("name", ["drop.csv", "drop.toml"])
def test_a_recording_is_never_written_over(command, recordings, name):
    before = (recordings / name).read_bytes()
    done = command("fit", recordings / "drop.csv", "--json", recordings / name)
    assert "this file is read here" in refusal(done)
    assert (recordings / name).read_bytes() == before


@pytest.mark.skipif(sys.platform != "linux", reason="needs a folder that not even root can write")
def test_a_folder_that_cannot_be_written_to_is_refused_before_the_fit(command, recordings):
    done = command("fit", recordings / "drop.csv", "--json", "/proc/fit.json")
    assert "the folder /proc cannot be written to" in refusal(done)


def test_a_failing_run_leaves_what_was_there(command, tmp_path):
    still = table(tmp_path / "still.csv", np.full(200, -1.5))
    kept = {tmp_path / "fit.json": b"old", tmp_path / "figure.png": b"older"}
    for path, content in kept.items():
        path.write_bytes(content)
    there = sorted(tmp_path.iterdir())
    figure, document = tmp_path / "figure.png", tmp_path / "fit.json"
    refusal(command("fit", still, "--json", document, "--plot", figure))
    assert {path: path.read_bytes() for path in kept} == kept
    assert sorted(tmp_path.iterdir()) == there


def test_a_strict_run_refuses_a_log_that_was_cut(command, tmp_path):
    log = write_log(session(DROP), tmp_path / "session.blf")
    log.write_bytes(log.read_bytes()[:-500])
    line = refusal(command("fit", log, "--strict"))
    assert "is not complete" in line
    assert "without strict" in line


def test_marks_beyond_the_end_of_a_log_are_refused_with_its_name(command, tmp_path):
    log = write_log(session(DROP), tmp_path / "session.asc")
    lines = log.read_text().splitlines(keepends=True)
    log.write_text("".join(lines[: len(lines) // 12]))
    done = command("fit", log)
    assert done.returncode == 2
    assert done.stderr.splitlines()[-1].startswith(f"exoid: {log}: segment 0 is marked from")


def test_a_table_and_a_log_of_the_same_suffix_are_told_apart(command, tmp_path):
    log = tmp_path / "foreign.csv"
    with can.CSVWriter(log) as writer:
        writer.on_message_received(can.Message(arbitration_id=1, data=b"\0", timestamp=1.0))
    assert "time_s" not in refusal_of(command("fit", log))
    assert "time_s" in refusal(command("fit", table(tmp_path / "t.csv", SWING, "time_s")))


def refusal_of(done) -> str:
    """The last line; a log without a sidecar is noted before it is refused."""
    assert done.returncode == 2
    return done.stderr.splitlines()[-1]
