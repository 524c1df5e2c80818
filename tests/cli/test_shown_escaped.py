"""Whatever a file or an argument says, the terminal shows it and obeys none of it."""

import io
import re
import sys
from pathlib import Path

import pytest
from command_line import refusal
from rich.console import Console

import exoid.cli
from exoid.cli.inputs.reading import take_all
from exoid.cli.terminal.screen import Screen
from exoid.files.visible import visible
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.recordings.loading.named import named_recordings
from exoid.report.tables.table import Column, Table, print_table
from exoid.report.words.text import aligned, heading, note
from legs import drop, recording

STRANGE = "P\x1b[31m\x07\u202e\x9b2J"  # red, a bell, from right to left, and an empty screen
SHOWN = visible(STRANGE)
READERS = ("fit", "diagnose", "drops", "report", "plan", "convert", "compare")
ALONE = ("say.py", "app.py")  # one place that writes what a file says, and one that knows its words


def plain(text: str) -> bool:
    """Does it hold nothing but letters and line ends?"""
    return visible(text, "\n") == text


def given(command: str, path: Path) -> list[str]:
    """What a command needs beside a recording."""
    more = {"report": ["-o", "out.html"], "convert": ["-o", "out.csv"], "compare": [str(path)]}
    return [command, str(path), *more.get(command, [])]


@pytest.mark.parametrize("kind", [".csv", ".blf", ".nc"])
@pytest.mark.parametrize("name", READERS)
def test_every_command_shows_the_name_of_a_file_that_it_cannot_read(
    command, tmp_path, monkeypatch, name, kind
):
    monkeypatch.chdir(tmp_path)
    path = Path(f"{STRANGE}{kind}")
    said = refusal(command(*given(name, path)))
    assert plain(said)
    assert f"{SHOWN}{kind}" in said
    path.write_bytes(b"no such file\xff")
    said = refusal(command(*given(name, path)))
    assert plain(said)


@pytest.mark.parametrize("name", [each for each in READERS if each != "compare"])
def test_every_command_shows_the_columns_and_keys_of_a_file_that_it_refuses(
    command, tmp_path, monkeypatch, name
):
    monkeypatch.chdir(tmp_path)
    path = Path("leg.csv")
    path.write_text(f"angle_rad{STRANGE},x\n" + "0.1,0.2\n" * 9, encoding="utf-8")
    said = refusal(command(*given(name, path)))
    assert plain(said)
    assert SHOWN in said
    path.write_text("time_s,angle_rad\n0.0,0.0\n0.1,0.1\n")
    path.with_suffix(".toml").write_text('[subject]\n"a\\u001b[31m\\n" = 1\nkind = "\\u001b"\n')
    assert plain(refusal(command(*given(name, path))))


def test_who_it_is_and_what_is_unknown_is_shown_in_all_that_people_read(command, tmp_path):
    path, document = tmp_path / "leg.csv", tmp_path / "drops.json"
    who = Subject(kind="leg", id=STRANGE, notes=STRANGE)
    write_table(recording(drop(duration=4.0), subject=who), path)
    sidecar = path.with_suffix(".toml")
    sidecar.write_text(sidecar.read_text() + '["odd\\u001b[2J\\n"]\nkey = 1\n')
    done = command("drops", path, "--json", document)
    assert done.returncode == 0, done.stderr
    assert plain(done.stdout + done.stderr)
    assert done.stdout.startswith(SHOWN)
    assert r"odd\u001b[2J\n" in done.stderr
    assert plain(document.read_text(encoding="utf-8"))
    again = tmp_path / "again.csv"
    done = command("convert", path, "-o", again)
    assert plain(done.stdout + done.stderr)


def test_a_recording_has_a_name_that_figures_and_tables_can_show(tmp_path):
    path = tmp_path / f"{STRANGE}.csv"
    write_table(recording(drop(duration=4.0)), path)
    ((name, _),), _ = take_all([path], {})
    assert name == f"{SHOWN}.csv"
    assert named_recordings(path)[0][0] == name


def test_tables_titles_and_lists_of_a_terminal_are_plain():
    stream = io.StringIO()
    console = Console(file=stream, width=200)
    print_table(Table("", {STRANGE: [STRANGE], "b": Column([STRANGE])}, STRANGE), console)
    heading(console, STRANGE)
    note(console, [STRANGE])
    aligned(console, {STRANGE: STRANGE})
    assert plain(stream.getvalue())
    assert stream.getvalue().count(SHOWN) == 8


def test_what_is_told_while_recording_is_plain(capsys):
    with Screen() as screen:
        screen.tell(STRANGE)
    assert capsys.readouterr().err == f"exoid: {SHOWN}\n"


def test_one_place_writes_what_a_file_may_have_said():
    """A line that goes by another way would not be looked at."""
    home = Path(exoid.cli.__file__).parent
    by_another_way = [
        f"{path.relative_to(home)}: {line}"
        for path in home.rglob("*.py")
        for line in path.read_text(encoding="utf-8").split("\n")
        if re.search(r"typer\.(echo|secho)\(|(?<![\w.])print\(|sys\.std(out|err)\.write", line)
        and path.name not in ALONE
        and "visible(" not in line
    ]
    assert by_another_way == []


def test_text_for_rich_is_made_of_visible_words_alone():
    report = Path(sys.modules["exoid.report.words.text"].__file__ or "").parents[1]
    made = [
        line.strip()
        for path in report.rglob("*.py")
        for line in path.read_text(encoding="utf-8").split("\n")
        if re.search(r"\bText\(", line) and "Text(visible(" not in line
    ]
    assert made == []
