"""Recordings as the commands read them, with what their readers noticed."""

from pathlib import Path

import typer

from exoid.cli.choices import Flip, Zero
from exoid.cli.waiting import patiently


def read(
    path: Path,
    dbc: Path | None,
    signal: list[str] | None,
    strict: bool,
    *,
    whole: bool = False,
    flip: Flip | None = None,
    zero: Zero | None = None,
):
    """One recording; what its reader noticed is said on stderr."""
    return take(path, dbc, signal, strict, whole=whole, flip=flip, zero=zero).recording


def take(
    path: Path,
    dbc: Path | None,
    signal: list[str] | None,
    strict: bool,
    *,
    whole: bool = False,
    flip: Flip | None = None,
    zero: Zero | None = None,
):
    """The same, with what its reader noticed."""
    from exoid.recording.load import load

    signals = signal_map(signal)
    told = {"flip": flip and flip.value, "zero": zero and zero.value}
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
    if not signal:
        return None
    pairs = [entry.partition("=") for entry in signal]
    for (name, equals, target), entry in zip(pairs, signal, strict=True):
        if not (name and equals and target):
            raise ValueError(f"--signal {entry}: write it as CHANNEL=MESSAGE.SIGNAL")
    return {name: target for name, _, target in pairs}
