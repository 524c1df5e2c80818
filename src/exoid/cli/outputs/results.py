"""A fit as the user gets it: tables, figure, document and file."""

from contextlib import suppress
from pathlib import Path

import typer

from exoid.cli.outputs.origin import sha256_of


def show(result, told=None) -> None:
    """The tables, on stdout; with what the recording told, where that was asked."""
    from rich.console import Console

    from exoid.report.tables.fit import print_fit

    with suppress(SystemExit):  # rich's answer to a closed pipe; files are still to be written
        print_fit(result, Console(), told)


def introduce(named) -> None:
    """Who it is, over every table of a person."""
    from exoid.report.words.person import people

    if who := people(recording.subject for _, recording in named):
        typer.echo(who)


def draw(result, profiles, path: Path) -> None:
    """The figure."""
    from exoid.report.plots.fit import plot_fit, save_figure

    save_figure(plot_fit(result, profiles), path)


def write_document(result, told, profiles, recordings, settings: dict, path: Path) -> None:
    """The document for machines."""
    from importlib.metadata import version

    from exoid.report.document.fit_json import fit_document
    from exoid.report.document.plain_json import write_json

    document = fit_document(
        result,
        version=version("exoid"),
        recordings=described(recordings),
        settings=settings,
        told=told,
        profiles=profiles,
    )
    write_json(document, path)


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


def described(recordings) -> list[dict]:
    """Which files they were: pairs of a path and its (name, recording)."""
    return [describe(source, recording) for source, (_, recording) in recordings]


def describe(path: Path, recording) -> dict:
    """Which file it was, and of whom, so that the result can be traced to it."""
    from exoid.report.words.person import identity

    return {
        "path": str(path),
        "sha256": sha256_of(path),
        "segments": len(recording.segments),
        "subject": identity(recording.subject),
    }


def end(follows: bool) -> None:
    """Leave with exit code 1 where no simulation follows the recording; all files are written."""
    if not follows:
        raise typer.Exit(1)
