"""Folders of small recordings, as studies have them."""

import subprocess
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from exoid.recordings.declared.entry import known
from exoid.recordings.recording import Recording

HANGING = -np.pi / 2  # rad
VISITS = [f"P0{p}/{when}/{side}_{k}.csv" for p in (1, 2) for when in ("pre", "post")
         for side in ("left", "right") for k in (1, 2)]  # fmt: skip
PEOPLE = "id,body_mass_kg,height_m,age_years,group\nP01,77,1.8,30,a\nP02,61,1.65,40,b\n"
SIDECAR = '[subject]\nnotes = "shoe on"\nadded_mass_kg = [0.5]\n[protocol]\nkind = "passive"\n'


def table_of(seed: float = 0.0, rate: float = 100.0, seconds: float = 3.0) -> str:
    """exoid's own table of one leg that swings down from 20 deg below the horizontal.

    Each seed swings a little differently, so that no two of them hold the same.
    """
    time = np.arange(round(seconds * rate)) / rate
    swing = HANGING + (1.1 + 0.3 * (0.618034 * seed % 1)) * np.exp(-0.4 * time) * np.cos(5 * time)
    rows = (f"{t:.4f},{angle:.6f}" for t, angle in zip(time, swing, strict=True))
    return "\n".join(["time_s,raw_angle_rad", *rows, ""])


def study(folder: Path, names: Iterable[str], sidecars: Mapping[str, str] | None = None) -> Path:
    """A folder with a recording under each name, and these sidecars."""
    for seed, name in enumerate(names):
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(table_of(seed), encoding="utf-8")
    for name, text in (sidecars or {}).items():
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def same(one: Recording, other: Recording) -> None:
    """Every sample, bit for bit, every known key, and what is kept of the unknown ones."""
    assert len(one.segments) == len(other.segments)
    for mine, theirs in zip(one.segments, other.segments, strict=True):
        assert mine.channels().keys() == theirs.channels().keys()
        for name, samples in mine.channels().items():
            np.testing.assert_array_equal(samples, theirs.channels()[name])
        assert mine.extra_columns == theirs.extra_columns
    for table in ("subject", "protocol", "sensors"):
        mine, theirs = getattr(one, table), getattr(other, table)
        for entry in known(mine):
            np.testing.assert_equal(getattr(mine, entry.name), getattr(theirs, entry.name))
        assert mine.extra_keys == theirs.extra_keys
    assert one.extra_tables == other.extra_tables


READ_ALL = """
from hashlib import sha256
from pathlib import Path
files = Path(sys.argv[1])
assert all(sha256(each.read_bytes()).digest() for each in sorted(files.rglob("*.csv")))
"""  # what is least to be done with every file: the measure of a machine


def processor_time(code: str, *arguments: object) -> float:
    """s that the last line of `code` takes in a process of its own, where no type is checked."""
    before, _, last = code.strip().rpartition("\n")
    timed = (
        "import sys, time\n"
        f"{before}\n"
        f"begun = time.process_time()\n{last}\n"
        "print(time.process_time() - begun)"
    )
    done = subprocess.run(
        [sys.executable, "-c", timed, *map(str, arguments)],
        capture_output=True,
        text=True,
        check=True,
    )
    return float(done.stdout.split()[-1])


def two_people(folder: Path) -> Path:
    """A sound study of two people, before and after, both sides twice, with a table of them and one
    sidecar.
    """
    sidecars = {"participants.csv": PEOPLE, "P01/pre/left_1.toml": SIDECAR}
    return study(folder, VISITS, sidecars)
