"""Runs of a study in this process: quick, and their faults are seen."""

import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pyarrow.parquet as pq
import pytest

from exoid.studies.engine import run_study as module
from exoid.studies.engine.kept.parts import DONE, FOLDER, keys_of
from exoid.studies.engine.settings import Settings
from study_folders import study, table_of

DROPS = Settings(("drops",))
TABLES = ("recordings.parquet", "quantities.parquet")
NAMES = [f"P{n // 2:02d}_{'left' if n % 2 else 'right'}.csv" for n in range(40)]
COMPUTED = 41  # those, and an empty one


class Here:
    """A client whose one worker is this process."""

    def __enter__(self):
        return self

    def __exit__(self, *fault):
        return None

    def nthreads(self):
        return {"here": 1}

    def submit(self, task, *given, pure):
        return Done(task, given)


class Done:
    """A task that was run at once."""

    def __init__(self, task, given):
        try:
            task(*given)
            self.status = "finished"
        except Exception as fault:
            self.status, self.fault = "error", fault

    def exception(self):
        return self.fault


@contextmanager
def in_this_process() -> Iterator[None]:
    """Runs compute here, as long as this holds."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(module, "workers", lambda count, scheduler, needed: Here())
        patch.setattr("exoid.studies.engine.carry_out.ended", lambda client, running, _: running)
        patch.setattr("exoid.studies.engine.work.prepare", lambda: None)
        yield


def people(folder: Path) -> Path:
    """Twenty people, both legs; one more file is empty, another there twice."""
    study(folder, NAMES)
    (folder / "P90_left.csv").write_text("")
    (folder / "P91_left.csv").write_text(table_of(3))
    (folder / "participants.csv").write_text("id,body_mass_kg,group\nP00,70,a\nP01,,b\n")
    return folder


def parts(results: Path, step: str = "drops") -> list[Path]:
    """What was kept of a step."""
    return sorted((results / FOLDER).glob(f"{step}-*/{DONE}-*.parquet"))


def kept(results: Path, step: str = "drops") -> set[str]:
    """The keys of all recordings that a step was done with."""
    return {key for part in parts(results, step) for key in keys_of(part)}


def copied(folder: Path, there: Path) -> Path:
    subprocess.run(["cp", "-r", folder, there], check=True)
    return there


def rows(results: Path, name: str) -> list[dict]:
    return pq.read_table(results / name).to_pylist()


def contents(results: Path) -> list[bytes]:
    return [(results / name).read_bytes() for name in TABLES]
