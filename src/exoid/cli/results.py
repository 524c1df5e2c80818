"""A fit as the user gets it: tables, figure, document and file."""

import hashlib
from contextlib import suppress
from pathlib import Path


def show(result, told=None) -> None:
    """The tables, on stdout; with what the recording told, where that was asked."""
    from rich.console import Console

    from exoid.report.fit_table import print_fit

    with suppress(SystemExit):  # rich's answer to a closed pipe; files are still to be written
        print_fit(result, Console(), told)


def draw(result, profiles, path: Path) -> None:
    """The figure."""
    from exoid.report.plots import plot_fit, save_figure

    save_figure(plot_fit(result, profiles), path)


def write_document(result, told, profiles, recordings, settings: dict, path: Path) -> None:
    """The document for machines."""
    from importlib.metadata import version

    from exoid.report.fit_json import fit_document, write_json

    document = fit_document(
        result,
        version=version("exoid"),
        recordings=described(recordings),
        settings=settings,
        told=told,
        profiles=profiles,
    )
    write_json(document, path)


def keep(result, told, recordings, settings: dict, path: Path) -> None:
    """The fit in a file that gives it back."""
    from exoid.report.save_result import save_result

    sources = [
        {**describe(source, recording), "sidecar_sha256": sidecar_hash(source)}
        for source, (_, recording) in recordings
    ]
    save_result(result, path, told=told, recordings=sources, settings=settings)


def sidecar_hash(recording: Path) -> str | None:
    """Of what stands beside a recording; a fit rests on it as well."""
    sidecar = recording.with_suffix(".toml")
    return hashlib.sha256(sidecar.read_bytes()).hexdigest() if sidecar.exists() else None


def described(recordings) -> list[dict]:
    """Which files they were: pairs of a path and its (name, recording)."""
    return [describe(source, recording) for source, (_, recording) in recordings]


def describe(path: Path, recording) -> dict:
    """Which file it was, so that the result can be traced to it."""
    return {
        "path": str(path),
        "sha256": hashlib.sha256(path.read_bytes()).hexdigest(),
        "segments": len(recording.segments),
    }
