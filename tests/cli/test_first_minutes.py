"""The first ten minutes: what to do next, an example to take apart, two results side by side."""

import os
import subprocess
import sys
from hashlib import sha256
from importlib.metadata import version
from shutil import copy

import pytest
from command_line import SCRIPT, refusal
from sessions import RATIOS

from exoid.recordings.declared.entry import known
from exoid.recordings.loading.load import load
from exoid.recordings.sidecar import TABLES, read_sidecar
from exoid.report.saved.saved_result import load_result

LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000
COMMANDS = ("fit", "diagnose", "plan", "drops", "example", "compare")


def test_without_a_command_it_says_what_to_do_next(command):
    done = command()
    assert (done.returncode, done.stderr) == (0, "")
    assert len(done.stdout.splitlines()) <= 14
    for each in ("exoid fit", "exoid example", "exoid drops", "exoid --help"):
        assert each in done.stdout


def test_every_command_of_the_welcome_exists(command):
    named = {
        line.split()[1] for line in command().stdout.splitlines() if line.startswith("  exoid")
    }
    assert named
    listed = command("--help").stdout
    assert all(f"\n  {name} " in listed for name in named)


@pytest.mark.parametrize("name", COMMANDS)
def test_help_shows_examples_of_the_command(command, name):
    done = command(name, "--help")
    assert (done.returncode, done.stderr) == (0, "")
    examples = done.stdout.partition("Examples:")[2]
    assert examples.count(f"exoid {name}") >= 1
    assert max(map(len, examples.partition("Arguments")[0].split("\n"))) <= 100


@pytest.fixture(scope="module")
def copied(command, tmp_path_factory):
    folder = tmp_path_factory.mktemp("first")
    done = command("example", cwd=folder)
    assert done.returncode == 0, done.stderr
    return folder, done.stdout


def test_the_example_is_copied_with_its_sidecar_and_the_next_commands(copied):
    folder, said = copied
    assert sorted(each.name for each in folder.iterdir()) == ["session.blf", "session.toml"]
    assert said.startswith("wrote session.blf and session.toml\n")
    for each in ("exoid fit session.blf", "exoid drops session.blf", "exoid diagnose session.blf"):
        assert each in said
    assert max(map(len, said.split("\n"))) <= 80
    loaded = load(folder / "session.blf")
    assert len(loaded.recording.segments) == 10
    assert not loaded.notes


def test_its_sidecar_explains_every_key_that_there_is(copied):
    folder, _ = copied
    text = (folder / "session.toml").read_text(encoding="utf-8")
    assert read_sidecar(folder / "session.toml")[3] == ()
    for table in TABLES.values():
        for entry in known(table):
            assert f"\n{entry.metadata['key']} = " in text.replace("# ", ""), entry.name
    assert text.count("#") > 20


def test_an_example_that_is_there_is_kept_unless_forced(command, copied, tmp_path):
    folder, _ = copied
    sidecar = tmp_path / "session.toml"
    sidecar.write_text("precious")
    line = refusal(command("example", tmp_path))
    assert "session.toml exists" in line
    assert "--force" in line
    assert [each.name for each in tmp_path.iterdir()] == ["session.toml"]
    assert command("example", tmp_path, "--force").returncode == 0
    assert sidecar.read_bytes() == (folder / "session.toml").read_bytes()
    assert len(list(tmp_path.iterdir())) == 2


def test_a_folder_is_made_and_its_name_is_quoted(command, tmp_path):
    done = command("example", tmp_path / "a b")
    assert done.returncode == 0
    assert f"exoid fit '{tmp_path}/a b/session.blf'" in done.stdout
    (tmp_path / "file").write_text("")
    assert "this is a file" in refusal(command("example", tmp_path / "file"))


@pytest.fixture(scope="module")
def saved(command, recordings, tmp_path_factory):
    """a.nc and b.nc: the same drop, by another seed and another prior."""
    folder = tmp_path_factory.mktemp("saved")
    for name, options in (("a.nc", ()), ("b.nc", ("--seed", 1, "--prior", "winter"))):
        done = command("fit", recordings / "drop.csv", *options, "--save", folder / name)
        assert (done.returncode, done.stderr) == (0, f"wrote {folder / name}\n")
    return folder


def test_a_saved_fit_gives_back_the_leg_and_what_it_rests_on(saved, recordings):
    back = load_result(saved / "a.nc")
    for name, value in RATIOS.items():
        found = back.result.ratios[name]
        assert abs(found.value - value) < LIKELY * found.standard_error
    assert back.told.sentences
    assert back.version == version("exoid")
    assert back.settings.items() >= {"seed": 0, "multistart": 64, "prior": "auto"}.items()
    (source,) = back.recordings
    drop = recordings / "drop.csv"
    assert source["sha256"] == sha256(drop.read_bytes()).hexdigest()
    assert source["sidecar_sha256"] == sha256(drop.with_suffix(".toml").read_bytes()).hexdigest()


def test_two_saved_fits_are_shown_side_by_side(command, saved, tmp_path):
    path = tmp_path / "compared.json"
    done = command("compare", saved / "a.nc", saved / "b.nc", "--json", path)
    assert (done.returncode, done.stderr) == (0, f"wrote {path}\n")
    said = " ".join(done.stdout.split())
    for each in (
        "m l g / J",
        "kg m^2",
        "seed 0 -> 1",
        "prior auto -> winter",
        "same recordings",
    ):
        assert each in said
    assert "misfit" not in said  # it did not change
    told = refusal(command("compare", saved / "a.nc", saved / "b.nc", "--terms", "absent.py"))
    assert "absent.py: there is no such file" in told
    assert max(map(len, done.stdout.split("\n"))) <= 80


def test_what_is_no_saved_fit_is_refused_in_one_line(command, saved, recordings, tmp_path):
    whole = saved / "a.nc"
    cut = tmp_path / "cut.nc"
    cut.write_bytes(whole.read_bytes()[:20_000])
    assert "cut.nc: this is no result of" in refusal(command("compare", whole, cut))
    assert "Check the name" in refusal(command("compare", whole, tmp_path / "none.nc"))
    assert "directory" in refusal(command("compare", ".", whole))
    wrong = refusal(command("fit", recordings / "drop.csv", "--save", tmp_path / "a.mat"))
    assert wrong.endswith("a.mat: the name must end in .nc or .json.")


def test_the_page_of_a_saved_fit_is_written_without_computing(command, saved, recordings, tmp_path):
    path = tmp_path / "a.html"
    done = command("report", saved / "a.nc", "-o", path)
    assert done.returncode == 0, done.stderr
    assert done.stderr.splitlines()[-1] == f"wrote {path}"
    page = path.read_text(encoding="utf-8")
    assert f"exoid fit {recordings / 'drop.csv'} --save" in page
    for section in ("quality", "drops", "parameters", "told"):
        assert f'<section id="{section}"' in page


def test_a_fit_saved_as_json_is_told_again_and_a_document_is_not(
    command, saved, recordings, tmp_path
):
    kept, document, page = (tmp_path / name for name in ("a.json", "document.json", "a.html"))
    done = command("fit", recordings / "drop.csv", "--save", kept, "--json", document)
    assert done.returncode == 0, done.stderr
    for words in (
        ("report", kept, "-o", page),
        ("compare", kept, saved / "a.nc"),
        ("export", kept, "--as", "python", "-o", tmp_path / "leg.py"),
        ("simulate", tmp_path / "again.csv", "--model", kept, "--drop", -30),
    ):
        done = command(*words)
        assert done.returncode == 0, done.stderr
    assert '<section id="parameters"' in page.read_text(encoding="utf-8")
    told = refusal(command("report", document, "-o", page, "--force"))
    assert "Name what --save wrote (.nc, .json)" in told


@pytest.mark.parametrize("name", ["a.nc", "a.json"])
def test_a_saved_result_is_no_recording_and_it_is_said_what_takes_it(command, tmp_path, name):
    (tmp_path / name).write_text("{}")
    for words in ("fit", "diagnose", "drops", "plan"):
        assert "is for 'exoid report'" in refusal(command(words, tmp_path / name))


def test_what_only_the_recordings_show_is_left_out_without_them(command, recordings, tmp_path):
    drop, path = tmp_path / "drop.csv", tmp_path / "a.html"
    copy(recordings / "drop.csv", drop)
    copy(recordings / "drop.toml", drop.with_suffix(".toml"))
    assert command("fit", drop, "--save", tmp_path / "a.nc").returncode == 0
    with drop.open("a") as file:
        file.write("\n")
    done = command("report", tmp_path / "a.nc", "-o", path)
    assert done.returncode == 0, done.stderr
    why, wrote = done.stderr.splitlines()
    assert why.endswith(f"only the recordings show: {drop} is not there, or has changed.")
    assert wrote == f"wrote {path}"
    page = path.read_text(encoding="utf-8")
    assert "Report on drop.csv" in page
    assert '<section id="quality"' not in page
    assert '<section id="parameters"' in page


def test_a_saved_result_is_not_computed_again(command, saved, recordings, tmp_path):
    path, fit = tmp_path / "a.html", saved / "a.nc"
    asked = refusal(command("report", fit, "--seed", 3, "--no-diagnosis", "-o", path))
    assert "Leave out --seed, --no-diagnosis" in asked
    assert "no other file" in refusal(command("report", fit, recordings / "drop.csv", "-o", path))
    cut = tmp_path / "cut.nc"
    cut.write_bytes(fit.read_bytes()[:20_000])
    assert "cut.nc: this is no result of" in refusal(command("report", cut, "-o", path))
    flipped, content = tmp_path / "flipped.nc", bytearray(fit.read_bytes())
    content[-1000] ^= 1
    flipped.write_bytes(content)
    assert "flipped.nc: it is damaged" in refusal(command("report", flipped, "-o", path))
    assert "flipped.nc: it is damaged" in refusal(command("compare", fit, flipped))
    assert not path.exists()


def test_neither_fit_nor_its_tables_load_what_only_saving_needs():
    code = (
        "import exoid.cli.commands.fit, exoid.report.saved.saved_result, exoid.report.tables.fit; "
        "import sys; print({'xarray', 'pandas', 'h5netcdf'} & set(sys.modules))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


@pytest.mark.parametrize(
    ("typed", "offered"),
    [("exoid dro", "drops"), ("exoid fit --sa", "--save"), ("exoid ", "compare")],
)
def test_the_tab_key_completes_commands_and_options(typed, offered):
    environment = {
        **os.environ,
        "_EXOID_COMPLETE": "complete_bash",
        "COMP_WORDS": typed,
        "COMP_CWORD": str(len(typed.split(" ")) - 1),
    }
    done = subprocess.run([SCRIPT], env=environment, capture_output=True, text=True, check=True)
    assert offered in done.stdout.split()
