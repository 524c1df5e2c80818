"""Recordings as the commands read them, with what their readers noticed."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.body import doubted
from exoid.cli.inputs.choices import Flip, Zero
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently
from exoid.files.visible import visible
from exoid.recordings.loading.once import once

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


def take_all(paths: list[Path], body: dict, protocol: dict | None = None, **options):
    """Recordings of one leg by their files' names, with what was said of its body and its protocol;
    and what their readers noticed. `options` are those of `take`.
    """
    named, taken, noticed = [], [], []
    try:
        for path in paths:
            loaded = read(path, **options)
            subject = replace(loaded.recording.subject, **body)
            protocol_told = replace(loaded.recording.protocol, **(protocol or {}))
            recording = replace(loaded.recording, subject=subject, protocol=protocol_told)
            notes = [f"{visible(path.name)}: {says}" for says in doubted(vars(subject))]
            noticed += [(path, line) for line in lines_of(loaded)]
            noticed += [(path, f"exoid: {note}") for note in notes]
            named.append((visible(path.name), recording))
            taken.append(replace(loaded, notes=(*loaded.notes, *notes)))
    finally:  # also of those before one that cannot be read
        for line in once(noticed, before="exoid: "):
            say(line, err=True)
    return named, taken


def kinds_in(named) -> list[str | None]:
    """Of what kind every segment of the recordings is said to be."""
    return [each.kind(number) for _, each in named for number in range(len(each.segments))]


def take(path: Path, **options):
    """A recording, with what its reader noticed, which is said on stderr; options as of `read`."""
    loaded = read(path, **options)
    for line in lines_of(loaded):
        say(line, err=True)
    return loaded


def lines_of(loaded) -> list[str]:
    """What its reader noticed, as it is said."""
    quality = loaded.quality.lines() if loaded.quality is not None else []
    return [*(f"exoid: {note}" for note in loaded.notes), *quality]


def read(
    path: Path,
    *,
    signal: list[str] | None = None,
    column: list[str] | None = None,
    **options,
):
    """A recording, with what its reader noticed; `options` are those of `load`."""
    from exoid.recordings.loading.load import load

    options["signals"] = pairs("--signal", signal, "CHANNEL=MESSAGE.SIGNAL")
    options["columns"] = pairs("--column", column, 'COLUMN="NAME IN THE FILE"')
    return patiently(lambda: load(path, **options), f"reading {path.name}")


def tell(notes: Iterable[str]) -> None:
    """What the owner of a recording should know, on stderr."""
    for note in notes:
        say(f"exoid: {note}", err=True)


def as_told(flip: Flip | None, zero: Zero | None) -> dict[str, str]:
    """Sign and zero, where options told of them, as settings keep them."""
    return {name: said for name, said in (("flip", flip), ("zero", zero)) if said is not None}


def pairs(option: str, entries: list[str] | None, form: str) -> dict[str, str] | None:
    """What stands before and after the `=` of every entry, as a map."""
    if not entries:
        return None
    parts = [entry.partition("=") for entry in entries]
    for (name, equals, target), entry in zip(parts, entries, strict=True):
        if not (name and equals and target):
            raise ValueError(f"{option} {entry}: write it as {form}")
    return {name: target for name, _, target in parts}
