"""exoid record: from the live bus to a log file with its sidecar."""

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.body import (
    AddedMass,
    AddedMassDistance,
    AddedMassGyration,
    SubjectId,
    ask_body,
    given_body,
)
from exoid.cli.inputs.choices import Side
from exoid.cli.inputs.node import BITRATE, INTERFACE, Bitrate, Duration, Interface, Marking, OneOf
from exoid.cli.outputs.destination import Force, check_absent, check_destination
from exoid.cli.terminal.keys import check_keyboard, keyboard
from exoid.cli.terminal.screen import Screen
from exoid.cli.terminal.stopping import stoppable

Number = float | None


def record(
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Log to write: .blf, .asc or .log (candump).")
    ],
    channel: Annotated[str, typer.Option(help="Such as /dev/ttyACM0, can0, COM3.")],
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: OneOf = None,
    duration: Duration = None,
    segment: Marking = False,
    body_mass: Annotated[Number, typer.Option(help="For the sidecar [kg].", metavar="KG")] = None,
    height: Annotated[Number, typer.Option(help="For the sidecar [m].", metavar="M")] = None,
    added_mass: AddedMass = None,
    added_mass_distance: AddedMassDistance = None,
    added_mass_gyration: AddedMassGyration = None,
    subject_id: SubjectId = None,
    side: Annotated[Side | None, typer.Option(help="Which leg, for the sidecar.")] = None,
    visit: Annotated[
        str | None, typer.Option("--session", help="For the sidecar.", metavar="TEXT")
    ] = None,
    note: Annotated[str | None, typer.Option(help="For the sidecar.", metavar="TEXT")] = None,
    force: Force = False,
) -> None:
    """Record the node's frames until Ctrl-C.

    What is known of the leg goes to the sidecar, and what no option says of it is asked for where a
    person sits before the terminal. Everything but the last second is on disk at any time. A bus
    that goes is waited for.

    \b
    Examples:
      exoid record --channel /dev/ttyACM0 -o session.blf --segment
      exoid record --channel /dev/ttyACM0 -o drop.blf --body-mass 77 --height 1.80 --duration 60
      exoid record --interface socketcan --channel can0 --bitrate 500000 -o session.blf
    """
    sidecar = output.with_suffix(".toml")
    from exoid.recordings.live.log_file import LogFile, check_kind

    check_destination(output)
    check_kind(output)
    check_absent((output, sidecar), force)
    if segment:
        check_keyboard()
    from exoid.recordings.declared.subject import Subject
    from exoid.recordings.live.channel.address import BusAddress

    log = LogFile(output, replace=force)
    body = given_body(
        body_mass=body_mass,
        height=height,
        added_mass=added_mass,
        added_mass_distance=added_mass_distance,
        added_mass_gyration=added_mass_gyration,
    )
    subject = Subject(id=subject_id, side=side, session=visit, notes=note)
    subject = replace(subject, **ask_body(body))
    from exoid.cli.live.ending import conclude
    from exoid.cli.live.session import Session

    with stoppable() as stopped, Screen() as screen, keyboard(segment) as pressed:
        session = Session(log, subject, screen, pressed if segment else None, node)
        session.run(BusAddress(interface, channel, bitrate), stopped, duration)
    conclude(session)
