"""Files that a command writes: none replaced unasked, none lost with another."""

import os
import re
import stat
import subprocess
from errno import ENOSPC
from pathlib import Path
from threading import Event, Thread

import pytest

from cli.command_line import refusal
from exoid.files import replacing as whole
from exoid.files.replacing import replace_files, replacing, replacing_folder

FULL = Path("/dev/full")
needs_full = pytest.mark.skipif(not FULL.exists(), reason=f"{FULL} is absent: no disk that is full")


@pytest.mark.parametrize(
    "words",
    [
        ["fit", "--json"],
        ["fit", "--save"],
        ["fit", "--plot"],
        ["fit", "--report"],
        ["fit", "--posterior"],
        ["diagnose", "--json"],
        ["diagnose", "--save"],
        ["diagnose", "--plot"],
        ["diagnose", "--report"],
        ["report", "--output"],
        ["drops", "--json"],
        ["drops", "--plot"],
        ["plan", "--json"],
        ["compare", "a.nc", "b.nc", "--json"],
        ["simulate"],
    ],
    ids=" ".join,
)
def test_no_command_replaces_a_file_unasked(words, command, tmp_path):
    kind = {"--save": "nc", "--posterior": "nc", "--plot": "png", "--report": "html"}
    name = (
        f"there.{kind.get(words[-1], {'report': 'html', 'simulate': 'csv'}.get(words[0], 'json'))}"
    )
    (tmp_path / name).write_text("a result")
    said = refusal(command(*words, name, cwd=tmp_path))
    assert said == f"exoid: {name} exists. Name another file, or replace it with --force."
    assert (tmp_path / name).read_text() == "a result"


def test_with_force_it_is_replaced(command, tmp_path):
    there = tmp_path / "drops.json"
    there.write_text("a result")
    assert command("drops", "--json", there, "--force").returncode == 0
    assert there.read_text().startswith("{")


@needs_full
def test_what_cannot_be_written_does_not_take_the_rest_with_it(command, tmp_path):
    figure = tmp_path / "drops.png"
    done = command("drops", "--json", FULL, "--plot", figure)
    assert done.returncode == 1
    said = done.stderr.splitlines()
    room = "Make room there, or name another disk."
    assert said[-2:] == [f"exoid: {FULL}: {os.strerror(ENOSPC)}. {room}", f"wrote {figure}"]
    assert figure.stat().st_size > 10_000
    assert "first flexion amplitude" in done.stdout


def test_what_is_written_beside_cannot_be_foreseen_nor_led_elsewhere(tmp_path, monkeypatch):
    victim, target = tmp_path / "victim", tmp_path / "fit.json"
    victim.write_text("untouched")
    monkeypatch.setattr(whole, "token_hex", lambda size: "guessed")
    (tmp_path / ".fit.json.guessed.part").symlink_to(victim)
    with pytest.raises(FileExistsError, match=r"fit\.json"), replacing(target) as part:
        part.write_text("new")
    assert victim.read_text() == "untouched"
    monkeypatch.undo()
    with replacing(target) as one, replacing(target) as other:
        assert one != other


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o664])
def test_what_is_replaced_keeps_its_mode(mode, tmp_path):
    there = tmp_path / "fit.json"
    there.write_text("old")
    there.chmod(mode)
    replace_files({there: b"new"})
    assert (there.read_bytes(), stat.S_IMODE(there.stat().st_mode)) == (b"new", mode)


def test_a_new_file_is_as_open_as_the_users_mask_says(tmp_path):
    before = os.umask(0o027)
    try:
        replace_files({tmp_path / "new": b"new"})
    finally:
        os.umask(before)
    assert stat.S_IMODE((tmp_path / "new").stat().st_mode) == 0o640


def test_a_link_stays_a_link_and_a_pipe_a_pipe(tmp_path):
    target, link = tmp_path / "real.json", tmp_path / "link.json"
    link.symlink_to(target)
    replace_files({link: b"new"})
    assert (link.is_symlink(), target.read_bytes()) == (True, b"new")
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    try:
        replace_files({pipe: b"through"})
        assert os.read(reader, 100) == b"through"
    finally:
        os.close(reader)
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_one_that_fails_leaves_all_as_they_were(tmp_path):
    first, second = tmp_path / "one.toml", tmp_path / "two.csv"
    first.write_text("old")

    def broken():
        yield "a"
        raise OSError(ENOSPC, os.strerror(ENOSPC))

    with pytest.raises(OSError, match=r"two\.csv"):
        replace_files({first: b"new", second: broken()})
    assert first.read_text() == "old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["one.toml"]


def test_a_link_that_leads_nowhere_is_refused_before_anything_is_computed(command, tmp_path):
    lost, loop = tmp_path / "lost.json", tmp_path / "loop.json"
    lost.symlink_to("nowhere/drops.json")
    loop.symlink_to("loop.json")
    nowhere = tmp_path.resolve() / "nowhere"
    for link, reason in (
        (lost, f"the folder {nowhere} does not exist. Make it first."),
        (loop, "this link leads to itself. Name another file."),
    ):
        assert refusal(command("drops", "--json", link)) == f"exoid: {link}: {reason}"
        with pytest.raises(ValueError, match=re.escape(f"{link}: {reason}")):
            replace_files({link: b"new"})


def test_a_figure_goes_through_a_pipe(command, recordings, tmp_path):
    pipe = tmp_path / "drops.pdf"
    os.mkfifo(pipe)
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE) as other:
        try:
            done = command("drops", recordings / "drop.csv", "--plot", pipe)
            assert done.returncode == 0, done.stderr
            assert other.communicate(timeout=10)[0].startswith(b"%PDF")
        finally:
            other.kill()


def test_a_folder_is_put_in_its_place_when_it_is_whole(tmp_path):
    with replacing_folder(tmp_path / "out") as part:
        (part / "in").mkdir()
        assert not (tmp_path / "out").exists()
    assert [each.name for each in tmp_path.rglob("*")] == ["out", "in"]


def test_of_a_folder_that_fails_nothing_stays_though_another_thread_still_fills_it(tmp_path):
    stopped, failed, filling = Event(), [], []

    def fill(part: Path) -> None:
        number = 0
        while not stopped.is_set():
            try:
                (part / f"{(number := number + 1)}").write_text("")
            except OSError as fault:
                failed.append(fault)
                return

    def interrupted() -> None:
        with replacing_folder(tmp_path / "out") as part:
            filling.append(Thread(target=fill, args=(part,)))
            filling[0].start()
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    filling[0].join(10)
    stopped.set()
    assert failed
    assert [*tmp_path.iterdir()] == []
