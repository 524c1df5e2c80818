"""Recordings as the commands read them, with what their readers noticed."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.choices import Flip, Zero
from exoid.cli.terminal.waiting import patiently

Dbc = Annotated[Path | None, typer.Option(help="Your own DBC, with --signal.")]
Signals = Annotated[
    list[str] | None,
    typer.Option(
        help="CHANNEL=MESSAGE.SIGNAL, such as raw_angle=Knee.Angle; repeat.", metavar="MAP"
    ),
]
Strict = Annotated[bool, typer.Option("--strict", help="Any loss in a log is an error.")]
EXAMPLE = Path(__file__).parents[2] / "example" / "session.blf"
Columns = Annotated[
    list[str] | None,
    typer.Option(
        "--column",
        help='What a table in other words calls a column: raw_angle_deg="Knee Flexion"; repeat.',
        metavar="MAP",
    ),
]


def read(
    path: Path,
    dbc: Path | None = None,
    signal: list[str] | None = None,
    strict: bool = False,
    *,
    whole: bool = False,
    flip: Flip | None = None,
    zero: Zero | None = None,
    column: list[str] | None = None,
):
    """One recording; what its reader noticed is said on stderr."""
    told = {"flip": flip, "zero": zero, "column": column}
    return take(path, dbc, signal, strict, whole=whole, **told).recording


def take_all(paths: list[Path], body: dict, protocol: dict | None = None, **options):
    """Recordings of one leg by their files' names, with what was said of its body and its protocol;
    and what their readers noticed. `options` are those of `take`.
    """
    taken = [take(path, **options) for path in paths]
    recordings = [each.recording for each in taken]
    named = [
        (
            path.name,
            replace(
                each,
                subject=replace(each.subject, **body),
                protocol=replace(each.protocol, **(protocol or {})),
            ),
        )
        for path, each in zip(paths, recordings, strict=True)
    ]
    return named, taken


def take(
    path: Path,
    dbc: Path | None = None,
    signal: list[str] | None = None,
    strict: bool = False,
    *,
    whole: bool = False,
    flip: Flip | None = None,
    zero: Zero | None = None,
    column: list[str] | None = None,
):
    """The same, with what its reader noticed."""
    from exoid.recordings.loading.load import load

    signals = signal_map(signal)
    told = {"flip": flip and flip.value, "zero": zero and zero.value}
    told |= {"columns": column_map(column)}
    loaded = patiently(
        lambda: load(path, dbc=dbc, signals=signals, strict=strict, whole=whole, **told),
        f"reading {path.name}",
    )
    for note in loaded.notes:
        typer.echo(f"exoid: {note}", err=True)
    if loaded.quality is not None:
        for line in loaded.quality.lines():
            typer.echo(line, err=True)
    return loaded


def as_told(flip: Flip | None, zero: Zero | None) -> dict[str, str]:
    """Sign and zero, where options told of them, as settings keep them."""
    each = {"flip": flip, "zero": zero}
    return {name: said.value for name, said in each.items() if said is not None}


def signal_map(signal: list[str] | None) -> dict[str, str] | None:
    """CHANNEL=MESSAGE.SIGNAL pairs as a map."""
    return pairs("--signal", signal, "CHANNEL=MESSAGE.SIGNAL")


def column_map(column: list[str] | None) -> dict[str, str] | None:
    """COLUMN="name in the file" pairs as a map."""
    return pairs("--column", column, 'COLUMN="NAME IN THE FILE"')


def pairs(option: str, entries: list[str] | None, form: str) -> dict[str, str] | None:
    if not entries:
        return None
    parts = [entry.partition("=") for entry in entries]
    for (name, equals, target), entry in zip(parts, entries, strict=True):
        if not (name and equals and target):
            raise ValueError(f"{option} {entry}: write it as {form}")
    return {name: target for name, _, target in parts}
