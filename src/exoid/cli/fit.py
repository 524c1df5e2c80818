"""exoid fit: from recordings to the leg's parameters."""

import hashlib
import sys
from contextlib import contextmanager
from dataclasses import replace
from enum import Enum
from pathlib import Path
from typing import Annotated

import typer

EXAMPLE = Path(__file__).parents[1] / "example" / "session.blf"
SLOW = 2.0  # s, after which a person wants to see that something happens


class Prior(str, Enum):
    """Where the expected parameters come from."""

    de_leva = "de_leva"
    winter = "winter"
    dumas = "dumas"
    paper = "paper"
    none = "none"


class Method(str, Enum):
    """How the misfit is minimised."""

    lm = "lm"
    slsqp = "slsqp"


class Reading(str, Enum):
    """The two readings of Eq. 4."""

    one = "1/T"
    two = "2/T"


class Misfit(str, Enum):
    """What Eq. 11 compares."""

    weighted = "weighted"
    paper = "paper"


def fit(
    recordings: Annotated[
        list[Path] | None,
        typer.Argument(
            help="Tables (.csv) or CAN logs (.blf .asc .log .trc .csv .mf4) of one leg, fitted "
            "together. Without one, the example that comes with exoid."
        ),
    ] = None,
    multistart: Annotated[int, typer.Option(min=1, max=100_000, help="Number of starts.")] = 64,
    seed: Annotated[int, typer.Option(min=0, help="Of the starts; same seed, same result.")] = 0,
    prior: Annotated[Prior, typer.Option(help="Anatomical table.")] = Prior.de_leva,
    weight: Annotated[
        float, typer.Option("--lambda", min=0.0, help="Weight of the prior, Eq. 11.")
    ] = 1.0,
    body_mass: Annotated[
        float | None, typer.Option(help="kg; replaces the sidecar's.", metavar="KG")
    ] = None,
    height: Annotated[
        float | None, typer.Option(help="m; replaces the sidecar's.", metavar="M")
    ] = None,
    each: Annotated[
        bool, typer.Option("--each", help="Fit every segment alone, then average the ratios.")
    ] = False,
    method: Annotated[
        Method, typer.Option(help="lm: all starts at once. slsqp: SciPy's, as a reference.")
    ] = Method.lm,
    smooth: Annotated[
        int,
        typer.Option(min=1, help="Samples of the moving average, Eq. 3, on data and simulation."),
    ] = 1,
    torque_frequency: Annotated[
        Reading | None, typer.Option(help="Reading of Eq. 4; without it both are tried.")
    ] = None,
    misfit: Annotated[
        Misfit, typer.Option(help="paper: Eq. 11 as printed, angle only, prior unscaled.")
    ] = Misfit.weighted,
    dbc: Annotated[Path | None, typer.Option(help="Your own DBC, with --signal.")] = None,
    signal: Annotated[
        list[str] | None,
        typer.Option(
            help="CHANNEL=MESSAGE.SIGNAL, such as raw_angle=Knee.Angle; repeat.", metavar="MAP"
        ),
    ] = None,
    strict: Annotated[bool, typer.Option("--strict", help="Any loss in a log is an error.")] = False,
    plot: Annotated[
        Path | None, typer.Option(help="Figure: measured, simulated, starts.", metavar="FILE")
    ] = None,
    json: Annotated[Path | None, typer.Option(help="Everything for machines.", metavar="FILE")] = None,
) -> None:
    """Find mass, inertia, COM distance, damping, stiffness and torque of a leg.

    \b
    Examples:
      exoid fit                                   the example that comes with exoid
      exoid fit drop.csv --multistart 64          one recording
      exoid fit bare.blf loaded.blf --plot a.pdf  two recordings of one leg, with a figure
      exoid fit log.asc --dbc my.dbc --signal raw_angle=Knee.Angle --body-mass 77 --height 1.8
    """
    paths = recordings or [EXAMPLE]
    if not recordings:
        typer.echo("No recording given: this is the example that comes with exoid, a simulated leg.")
    named = []
    for path in paths:
        loaded = read(path, dbc, signal, strict)
        subject = replace(loaded.subject, **given(body_mass=body_mass, height=height))
        protocol = loaded.protocol
        if torque_frequency is not None:
            protocol = replace(protocol, torque_frequency=torque_frequency.value)
        named.append((path.name, replace(loaded, subject=subject, protocol=protocol)))
    settings = {
        "multistart": multistart,
        "seed": seed,
        "prior": prior.value,
        "lambda": weight,
        "method": method.value,
        "smooth": smooth,
        "misfit": misfit.value,
        "each": each,
    }
    result = compute(named, settings)
    show(result)
    if plot is not None:
        from exoid.report.plots import plot_fit, save_figure

        save_figure(plot_fit(result), plot)
    if json is not None:
        from importlib.metadata import version

        from exoid.report.fit_json import fit_document, write_json

        described = [describe(path, recording) for path, (_, recording) in zip(paths, named, strict=True)]
        write_json(
            fit_document(result, version=version("exoid"), recordings=described, settings=settings),
            json,
        )


def given(**options: float | None) -> dict[str, float]:
    """The options that were given."""
    return {name: value for name, value in options.items() if value is not None}


def read(path: Path, dbc: Path | None, signal: list[str] | None, strict: bool):
    """Load one recording and say what its reader noticed, on stderr."""
    from exoid.recording.load import load

    loaded = load(path, dbc=dbc, signals=signal_map(signal), strict=strict)
    for note in loaded.notes:
        typer.echo(f"exoid: {note}", err=True)
    if loaded.quality is not None:
        for line in loaded.quality.lines():
            typer.echo(line, err=True)
    return loaded.recording


def signal_map(signal: list[str] | None) -> dict[str, str] | None:
    """CHANNEL=MESSAGE.SIGNAL pairs as a map."""
    if not signal:
        return None
    pairs = [entry.partition("=") for entry in signal]
    for (name, equals, target), entry in zip(pairs, signal, strict=True):
        if not (name and equals and target):
            raise ValueError(f"--signal {entry}: write it as CHANNEL=MESSAGE.SIGNAL")
    return {name: target for name, _, target in pairs}


def compute(named, settings: dict):
    """The fit, with programs kept in the user's cache folder and a sign of life on a terminal."""
    from platformdirs import user_cache_path

    with waiting("fitting; the first run of a new shape compiles for some seconds"):
        from exoid.fit.estimate import fit
        from exoid.fit.program import keep_programs_in

        keep_programs_in(user_cache_path("exoid") / "programs")
        options = {
            "multistart": settings["multistart"],
            "seed": settings["seed"],
            "prior": settings["prior"],
            "weight": settings["lambda"],
            "method": settings["method"],
            "smooth": settings["smooth"],
            "misfit": settings["misfit"],
        }
        if settings["each"]:
            from exoid.fit.each import fit_each

            return fit_each(named, **options)
        return fit(named, **options)


@contextmanager
def waiting(what: str):
    """A spinner on stderr while something long runs, only on a terminal."""
    if not sys.stderr.isatty():
        yield
        return
    from rich.console import Console

    with Console(stderr=True).status(what):
        yield


def show(result) -> None:
    """The tables, on stdout."""
    from rich.console import Console

    from exoid.report.fit_table import print_fit

    print_fit(result, Console())


def describe(path: Path, recording) -> dict:
    """Which file it was, so that the result can be traced to it."""
    return {
        "path": str(path),
        "sha256": hashlib.sha256(path.read_bytes()).hexdigest(),
        "segments": len(recording.segments),
    }
