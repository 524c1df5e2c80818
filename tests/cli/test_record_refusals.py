"""`exoid record` on bad input: one line that says what and where, and nothing written."""

import pytest
from command_line import refusal


@pytest.mark.parametrize("there", ["leg.blf", "leg.toml"])
def test_what_is_there_is_not_replaced(command, tmp_path, there):
    (tmp_path / there).write_text("old")
    done = command("record", "--channel", "none", "-o", tmp_path / "leg.blf")
    assert refusal(done) == (
        f"exoid: {tmp_path / there} exists. Name another file, or replace it with --force."
    )
    assert (tmp_path / there).read_text() == "old"


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["-o", "leg.db"], "loses frames"),
        (["-o", "leg.csv"], "a recording ends in .blf"),
        (["-o", "nowhere/leg.blf"], "the folder nowhere does not exist"),
        (["-o", "leg.blf", "--segment"], "the standard input is no terminal"),
        (["-o", "leg.blf", "--body-mass", "7700"], "--body-mass is 7700 kg"),
        (["-o", "leg.blf", "--added-mass-distance", "0.4"], "without --added-mass"),
        (["-o", "leg.blf", "--bitrate", "0"], "'--bitrate'"),
        (["-o", "leg.blf", "--duration", "0"], "'--duration'"),
        (["-o", "leg.blf", "--interface", "slkan"], "The interface can be"),
        (["-o", "leg.blf"], "slcan no-port cannot be opened"),
        ([], "'--output'"),
    ],
)
def test_an_absurd_option_is_refused(command, tmp_path, options, said):
    done = command("record", "--channel", "no-port", *options, cwd=tmp_path)
    assert said in refusal(done)
    assert not list(tmp_path.iterdir())
