"""Any recording file: a table or a CAN log, with the sidecar beside it, cut into its movements."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from exoid.files.text_file import naming
from exoid.recordings.conventions.apply import understand
from exoid.recordings.defaults import DEFAULTS, keys_told
from exoid.recordings.formats.own_table import read_table
from exoid.recordings.formats.sheets import is_table
from exoid.recordings.loading.loaded import Loaded
from exoid.recordings.splitting.split import cut_apart, cut_table

LOG_HEADER = b"timestamp,arbitration_id,"  # of python-can's own .csv


def load(
    path: str | Path,
    *,
    dbc: str | Path | None = None,
    signals: dict[str, str] | None = None,
    strict: bool = False,
    whole: bool = False,
    flip: str | None = None,
    zero: str | None = None,
    columns: Mapping[str, str] | None = None,
    defaults: Sequence[str | Path] = (),
) -> Loaded:
    """Read a recording of either kind; a continuous log is cut into its drops and cycles.

    With `whole` it stays one segment, and what the sidecar marks stays marked. `flip` ("angle",
    "gyro", "all") names the channels of the other sign, `zero` ("hanging", "unknown", "extended")
    what the file calls 0; both replace what the sidecar says. `columns` says what a table in other
    words calls exoid's columns: `{"raw_angle_deg": "Knee Flexion"}`. `defaults` are sidecars that
    hold for many recordings, the most general first: they tell what its own does not.

    **Raises** `ValueError` (one line: what, where, what to do) and `OSError`; with `strict` also
    for anything that a CAN log lost.

    >>> loaded = exoid.load("drops.csv")
    >>> len(loaded.recording.segments), loaded.notes
    (2, ())
    """
    path, above = Path(path), [Path(each) for each in defaults]
    check_request(path, dbc, signals)
    if is_table(path) and dbc is None and not is_log(path):
        recording, notes = read_table(path, columns, defaults=above)
        with naming(path):
            recording, more = understand(recording, cut_table, whole=whole, flip=flip, zero=zero)
        return Loaded(
            recording,
            (*notes, *not_asked(path, above), *(f"{path}: {note}" for note in more)),
            None,
        )
    if columns:
        raise ValueError(
            f"{path}: a CAN log has no columns to name. Give a DBC and a signal map (dbc and "
            "signals)."
        )
    from exoid.recordings.loading.can_log import read_can_log

    sidecar = path.with_suffix(".toml")
    tables, extra, notes = keys_told(
        sidecar, f"{sidecar}: there is none: subject and protocol are unknown", above
    )
    recording, quality = read_can_log(path, dbc=dbc, signals=signals, strict=strict, **tables)
    recording = replace(recording, extra_tables=extra)
    with naming(path):
        recording, more = understand(recording, cut_apart, whole=whole, flip=flip, zero=zero)
    return Loaded(recording, (*notes, *not_asked(path, above), *more), quality)


def not_asked(path: Path, defaults: Sequence[Path]) -> list[str]:
    """That what holds for a study is not taken for a recording by itself."""
    beside = path.with_name(DEFAULTS)
    if defaults or not beside.is_file():
        return []
    return [
        f"{beside} is read by 'exoid study' alone. What {path.name} needs of it belongs into "
        f"{path.with_suffix('.toml').name}."
    ]


def check_request(path: Path, dbc: str | Path | None, signals: dict[str, str] | None) -> None:
    """Refuse what is no recording, and half of what a log of another device needs."""
    if path.is_dir():
        raise ValueError(f"{path}: this is a directory. Name the file in it.")
    if path.suffix.lower() == ".toml":
        raise ValueError(f"{path}: this is a sidecar. Name the table or log beside it.")
    if (dbc is None) != (signals is None):
        raise ValueError(
            f"{path}: a DBC and a signal map belong together. Give both (dbc and signals), or "
            "none for a table or a log of the exoskeleton's own node."
        )


def is_log(path: Path) -> bool:
    """Is this .csv one that python-can wrote?"""
    with path.open("rb") as file:
        return file.read(len(LOG_HEADER)) == LOG_HEADER
