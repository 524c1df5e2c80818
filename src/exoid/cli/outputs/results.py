"""Results as the user gets them: tables, documents and files."""

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

from exoid.cli.outputs.origin import sha256_of
from exoid.cli.terminal.say import say

UNKNOWN_WIDTH = 80  # of a terminal that says 0, in which rich would show nothing at all


def show(table: Callable[[Any], None]) -> None:
    """What `table` prints on a console, on stdout."""
    from rich.console import Console

    with suppress(SystemExit):  # rich's answer to a closed pipe; files are still to be written
        console = Console()
        table(console if console.width > 0 else Console(width=UNKNOWN_WIDTH))


def introduce(named) -> None:
    """Who it is, over every table of a person."""
    from exoid.report.words.person import people

    if who := people(recording.subject for _, recording in named):
        say(who)


def traced(files) -> dict[str, Any]:
    """What a document says of its origin: pairs of a path and its (name, recording)."""
    from importlib.metadata import version

    return {
        "version": version("exoid"),
        "recordings": [describe(path, recording) for path, (_, recording) in files],
    }


def keep(result, recordings, settings: dict, path: Path, **found) -> None:
    """The fit, and what else was found, in a file that gives it back."""
    from exoid.report.saved.saved_result import save_result

    sources = [
        {
            **describe(source, recording),
            "sidecar_sha256": sidecar_hash(source),
            "body_mass_kg": recording.subject.body_mass,
            "height_m": recording.subject.height,
        }
        for source, (_, recording) in recordings
    ]
    save_result(result, path, recordings=sources, settings=settings, **found)


def sidecar_hash(recording: Path) -> str | None:
    """Of what stands beside a recording; a fit rests on it as well."""
    sidecar = recording.with_suffix(".toml")
    return sha256_of(sidecar) if sidecar.exists() else None


def describe(path: Path, recording) -> dict:
    """Which file it was, and of whom, so that the result can be traced to it."""
    from exoid.report.words.person import identity

    return {
        "path": str(path),
        "sha256": sha256_of(path),
        "segments": len(recording.segments),
        "subject": identity(recording.subject),
    }
