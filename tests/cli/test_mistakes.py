"""What a user got wrong is refused in every command alike, with what mends it; the commands run in
this process: only reading happens before they refuse.
"""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from command_line import refusal

from exoid.cli.commands.convert import convert
from exoid.cli.commands.diagnose import diagnose
from exoid.cli.commands.drops import drops
from exoid.cli.commands.fit import fit
from exoid.cli.commands.plan import plan
from exoid.cli.commands.report import report
from exoid.cli.terminal.options import as_options
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.loading.load import load
from exoid.recordings.measured.segment import Segment
from legs import CHILD, drop, recording

RIGHT = drop(duration=4.0)
OUT = Path("out.csv")
COMMANDS = {
    "fit": lambda path: fit([path]),
    "diagnose": lambda path: diagnose([path]),
    "drops": lambda path: drops([path]),
    "report": lambda path: report([path], OUT.with_suffix(".html")),
    "plan": lambda path: plan([path]),
    "convert": lambda path: convert(path, OUT),
}
MISTAKES = {
    "milliseconds": ({"time": RIGHT.time * 1e3}, "in milliseconds? Then name the column time_ms"),
    "microseconds": ({"time": RIGHT.time * 1e6}, "in microseconds? Then name the column time_us"),
    "flexion": (
        {"raw_angle": -RIGHT.raw_angle, "raw_angular_velocity": -RIGHT.raw_angular_velocity},
        "Is flexion positive in this file? Then say --flip all",
    ),
    "flexion of the encoder": ({"raw_angle": -RIGHT.raw_angle}, "Then say --flip angle"),
    "hanging": ({"raw_angle": RIGHT.raw_angle + np.pi / 2}, "Then say --zero hanging"),
    "straight": ({"raw_angle": RIGHT.raw_angle + np.pi}, "angle_zero_deg = 180"),
    "degrees": (
        {"raw_angle": np.degrees(RIGHT.raw_angle)},
        "Is it in degrees? Then name the column raw_angle_deg",
    ),
    "radians as degrees": ({"raw_angle": np.radians(RIGHT.raw_angle)}, "Is it in radians?"),
    "gyro in degrees": (
        {"raw_angular_velocity": np.degrees(RIGHT.raw_angular_velocity) / 4},
        "Is raw_velocity_rad_s in degrees? Then name the column raw_velocity_deg_s",
    ),
    "gyro of the other sign": (
        {"raw_angular_velocity": -RIGHT.raw_angular_velocity},
        "say --flip gyro",
    ),
}


def written(path, mistake):
    """A table with a mistake, as it stands on disk: read back before anything is checked."""
    wrong, _ = MISTAKES[mistake]
    columns = {**RIGHT.channels(), **wrong}
    if mistake == "gyro in degrees":  # a slow drop; a fast one is beyond what a gyro can say
        slow = drop(start=-1.1, duration=4.0)
        columns = {**slow.channels(), "raw_angular_velocity": np.degrees(slow.raw_angular_velocity)}
    names = ("time", "raw_angle", "raw_angular_velocity")
    lines = [
        ",".join(map(repr, row)) for row in zip(*(columns[n].tolist() for n in names), strict=True)
    ]
    header = "time_s,raw_angle_rad,raw_velocity_rad_s"
    path.write_text("\n".join([header, *lines]) + "\n")
    path.with_suffix(".toml").write_text('[subject]\nkind = "leg"\n[protocol]\nkind = "passive"\n')
    return path


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize("mistake", MISTAKES)
def test_every_command_says_what_is_wrong_and_what_mends_it(
    tmp_path, monkeypatch, mistake, command
):
    monkeypatch.chdir(tmp_path)
    path = written(tmp_path / "knee.csv", mistake)
    with pytest.raises(ValueError, match=r"knee\.csv: ") as caught:
        COMMANDS[command](path)
    assert MISTAKES[mistake][1] in as_options(str(caught.value))
    assert sorted(each.name for each in tmp_path.iterdir()) == ["knee.csv", "knee.toml"]


def test_it_is_one_line_and_exit_code_2(command, tmp_path):
    line = refusal(command("drops", written(tmp_path / "knee.csv", "flexion")))
    assert line.endswith("say --flip all. If 0 is right, say --zero extended.")


@pytest.mark.parametrize(
    ("mistake", "options"),
    [
        ("flexion", {"flip": "all"}),
        ("flexion of the encoder", {"flip": "angle"}),
        ("gyro of the other sign", {"flip": "gyro"}),
        ("hanging", {"zero": "hanging"}),
    ],
)
def test_the_option_that_is_named_mends_the_file_for_good(tmp_path, mistake, options):
    path = written(tmp_path / "knee.csv", mistake)
    convert(path, tmp_path / "mended.csv", **options)
    (found,) = load(tmp_path / "mended.csv").recording.segments
    np.testing.assert_allclose(found.raw_angle, RIGHT.raw_angle, atol=1e-12)
    np.testing.assert_array_equal(found.raw_angular_velocity, RIGHT.raw_angular_velocity)


def test_a_drop_of_another_leg_is_named_in_the_same_words(tmp_path, capsys):
    mixed = recording(RIGHT, drop(start=-0.5), drop(CHILD, -0.3))
    write_table(mixed, tmp_path / "knee.csv")
    drops([tmp_path / "knee.csv"])
    assert "segment 2 is drawn to rest by" in capsys.readouterr().err


@pytest.mark.parametrize(("mass", "doubted"), [(150.0, True), (68.0, False)])
def test_a_body_in_pounds_is_asked_for_and_still_analysed(tmp_path, capsys, mass, doubted):
    who = Subject(kind="leg", body_mass=mass, height=1.72)
    write_table(recording(RIGHT, subject=who), tmp_path / "knee.csv")
    drops([tmp_path / "knee.csv"])
    found = capsys.readouterr()
    assert ("knee.csv: the person weighs 150 kg at 1.72 m" in found.err) == doubted
    assert ("It would be 68 kg if it is in lb." in found.err) == doubted
    assert "start angle" in found.out


# Who it is, and which leg


def named(path, **who) -> None:
    right = recording(RIGHT, subject=Subject(kind="leg", **who))
    write_table(replace(right, segments=(Segment(**RIGHT.channels()),)), path)


def test_drops_say_who_it_is(tmp_path, capsys):
    named(tmp_path / "knee.csv", id="P07", side="left", session="March")
    document = tmp_path / "drops.json"
    drops([tmp_path / "knee.csv"], json=document)
    assert capsys.readouterr().out.startswith("P07, left leg, session March\n")
    (source,) = json.loads(document.read_text())["recordings"]
    assert source["subject"] == {"id": "P07", "side": "left", "session": "March"}


@pytest.mark.parametrize("key", ["id", "side"])
def test_two_people_or_two_sides_are_not_fitted_together(tmp_path, key):
    paths = [tmp_path / "a.csv", tmp_path / "b.csv"]
    for path, value in zip(paths, ("left", "right"), strict=True):
        named(path, **{key: value})
    with pytest.raises(ValueError, match=rf"a\.csv is of {key} left, b\.csv of {key} right"):
        fit(paths)


@pytest.mark.parametrize(
    ("given", "takes"),
    [
        (
            ("compare", "a.nc", "b.nc", "c.nc"),
            "exoid compare takes FIRST and SECOND only: give c.nc",
        ),
        (("live", "a.csv", "b.csv"), "exoid live takes RECORDING only: give b.csv"),
    ],
)
def test_a_file_more_than_a_command_takes_is_refused_with_what_it_takes(command, given, takes):
    assert f"{takes} a command of its own. Try 'exoid" in refusal(command(*given))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ("identify", "it is a function of the library: exoid.identify in Python. Try"),
        ("plot-fit", "exoid.plot_fit in Python. Try"),
        ("dropz", "No such command 'dropz'. Did you mean 'drops'? Try"),
        ("frobnicate", "No such command 'frobnicate'. Try"),
    ],
)
def test_a_function_of_the_library_that_is_no_command_is_said_to_be_one(command, given, said):
    assert said in refusal(command(given))


@pytest.mark.parametrize(
    ("given", "said"),
    [
        (("--body-mass", "159lb"), "this is no plain number; give it in kg, as --body-mass 72"),
        (("--height", "176cm"), "this is no plain number; give it in m, as --height 1.76"),
        (("--zero", "180"), "write angle_zero_deg = 180 below [sensors] of the sidecar"),
        (("--multistart", "2.5"), "this is no plain integer"),
    ],
)
def test_a_value_that_an_option_does_not_take_is_answered_with_what_would_do(command, given, said):
    assert said in refusal(command("fit", "a.csv", *given))
