"""exoid live: a leg's parameters while it moves."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.analysis import prepare
from exoid.cli.inputs.body import (
    AddedMass,
    AddedMassDistance,
    AddedMassGyration,
    SubjectId,
    ask_body,
    given_body,
)
from exoid.cli.inputs.choices import FlipOption, Side, ZeroOption
from exoid.cli.inputs.node import BITRATE, INTERFACE, Bitrate, Duration, Interface, Marking, OneOf
from exoid.cli.inputs.reading import Columns, Dbc, Signals
from exoid.cli.inputs.terms import OwnTerms, With, own_terms, terms_asked
from exoid.cli.inputs.watching import (
    HOST,
    PORT,
    check_source,
    followed_terms,
    goals_asked,
    page_asked,
    speed_asked,
)
from exoid.cli.outputs.destination import Force
from exoid.cli.outputs.streamed import check_files
from exoid.cli.terminal.keys import check_keyboard

Number = float | None


def live(
    recording: Annotated[
        Path | None,
        typer.Argument(help="A log or table to follow instead of a bus.", show_default=False),
    ] = None,
    channel: Annotated[str | None, typer.Option(help="Such as /dev/ttyACM0, can0, COM3.")] = None,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: OneOf = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Keep it as exoid record does: .blf, .asc or .log."),
    ] = None,
    duration: Duration = None,
    segment: Marking = False,
    speed: Annotated[
        str, typer.Option(help="Of a file: 1 as it was, 2 twice as fast, or max.", metavar="TIMES")
    ] = "max",
    until: Annotated[
        list[str] | None,
        typer.Option(
            help="Stop where the standard error is so small: inertia=2% of it, or "
            "damping_over_inertia=0.01 in its unit; repeat.",
            metavar="NAME=ERROR",
        ),
    ] = None,
    with_term: With = None,
    terms: OwnTerms = None,
    body_mass: Annotated[
        Number, typer.Option(help="For what is expected [kg].", metavar="KG")
    ] = None,
    height: Annotated[Number, typer.Option(help="For what is expected [m].", metavar="M")] = None,
    added_mass: AddedMass = None,
    added_mass_distance: AddedMassDistance = None,
    added_mass_gyration: AddedMassGyration = None,
    subject_id: SubjectId = None,
    side: Annotated[Side | None, typer.Option(help="Which leg, for the sidecar.")] = None,
    json_lines: Annotated[
        Path | None,
        typer.Option(help="A line for every 0.1 s, as it comes; - is stdout.", metavar="FILE"),
    ] = None,
    refine: Annotated[
        bool | None,
        typer.Option(
            "--refine/--no-refine",
            help="Fit finished drops beside it, and say whether both agree: by default of a bus.",
            show_default=False,
        ),
    ] = None,
    serve: Annotated[
        bool,
        typer.Option("--serve", help="Show it on a page of this computer (needs the extra live)."),
    ] = False,
    port: Annotated[
        int | None,
        typer.Option(
            min=0,
            max=65535,
            help=f"Of that page, by default {PORT}; 0 is any that is free.",
            show_default=False,
        ),
    ] = None,
    host: Annotated[
        str | None,
        typer.Option(
            help=f"Of that page, by default {HOST}; any but this computer's own demands a token.",
            show_default=False,
        ),
    ] = None,
    column: Columns = None,
    dbc: Dbc = None,
    signal: Signals = None,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    force: Force = False,
) -> None:
    """Estimate a leg while it moves, and what to do next.

    From the first drop on the errors shrink while one watches; a mass that is known and changes
    tells kg m^2 as well. A bus is followed until Ctrl-C, a file to its end, either until a goal is
    reached (then exit code 0, else 1). The page of a file stays until Ctrl-C. A page (--serve)
    needs the extra live: in a clone of exoid, python3 -m pip install '.[live]'.

    \b
    Examples:
      exoid live --channel /dev/ttyACM0 -o session.blf --body-mass 77 --height 1.80
      exoid live --channel /dev/ttyACM0 --until gravity_over_inertia=1% --serve
      exoid live session.blf                       a recording, as fast as it goes
      exoid live session.blf --speed 1 --serve     as it was, on http://127.0.0.1:8710
      exoid live session.blf --json-lines - --with coulomb_friction
    """
    of_bus = {"-o": output, "--segment": segment, "--duration": duration, "--id": subject_id}
    of_file = {"--column": column, "--dbc": dbc, "--signal": signal, "--flip": flip, "--zero": zero}
    check_source(recording, channel, of_bus | {"--side": side}, of_file)
    pace, page = speed_asked(speed), page_asked(host, port, serve=serve)
    if serve:
        from exoid.cli.live.page.serve import check_server

        check_server()
    check_files(recording, output, json_lines, force=force)
    if segment:
        check_keyboard()
    body = given_body(
        body_mass=body_mass,
        height=height,
        added_mass=added_mass,
        added_mass_distance=added_mass_distance,
        added_mass_gyration=added_mass_gyration,
    )
    terms_wanted = followed_terms(terms_asked(with_term, own_terms(terms)))
    goals = goals_asked(until, terms_wanted)
    from exoid.cli.live.viewing import Views
    from exoid.cli.live.wanted import Wanted

    prepare()
    wanted = Wanted(terms_wanted, goals, Views(json_lines, serve, *page), refine)
    if recording is not None:
        from exoid.cli.live.follow_file import run_file
        from exoid.cli.live.opened import open_recording

        reading = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
        run_file(recording, open_recording(recording, body, node, **reading), wanted, pace)
    elif channel is not None:
        from exoid.cli.live.follow_bus import bus_of, run_bus
        from exoid.recordings.declared.subject import Subject

        subject = replace(Subject(kind="leg", id=subject_id, side=side), **ask_body(body))
        bus = bus_of((interface, channel, bitrate), output, subject, node, force=force)
        run_bus(bus, wanted, marked=segment, duration=duration)
