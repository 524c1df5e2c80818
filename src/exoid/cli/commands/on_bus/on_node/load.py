"""exoid node load: the parameters by which a node commands a torque."""

from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.node import (
    BITRATE,
    INTERFACE,
    Bitrate,
    Channel,
    Interface,
    Who,
    talking_to,
)
from exoid.cli.inputs.terms import OwnTerms, loaded, model_in, own_terms
from exoid.cli.outputs.nodes import told_parameters
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently

Share = Annotated[
    float, typer.Option(min=0, max=1, help="Share of it that the motor takes off.", metavar="0..1")
]


def load(
    result: Annotated[
        Path, typer.Argument(help="What 'exoid fit' or 'exoid diagnose' saved (.nc, .json).")
    ],
    channel: Channel,
    interface: Interface = INTERFACE,
    bitrate: Bitrate = BITRATE,
    node: Who = None,
    gravity: Share = 0.5,
    stiffness: Share = 0.0,
    damping: Share = 0.0,
    friction: Share = 0.0,
    limit: Annotated[
        float, typer.Option(min=0, max=15.75, help="Of the torque [N m].", metavar="NM")
    ] = 5.0,
    rate_limit: Annotated[
        float, typer.Option(min=0, max=100, help="Of its change [N m/s].", metavar="NM/S")
    ] = 20.0,
    segment: Annotated[
        int | None,
        typer.Option(min=0, help="With the added mass of this segment of the fit's table."),
    ] = None,
    inertia: Annotated[
        float | None,
        typer.Option(min=1e-3, help="Of a leg of which ratios alone are known [kg m^2]."),
    ] = None,
    terms: OwnTerms = None,
) -> None:
    """Download a fitted leg, by which the node commands a torque.

    What acts on the leg and the node has nothing for is refused by name. The node takes the
    parameters over all at once, keeps them with a checksum, and commands no torque until it is
    armed: exoid node torque.

    Emulated and simulated only: no motor and no person was ever near it. It is no safety function.

    \b
    Examples:
      exoid node load leg.nc --channel /dev/ttyACM0 --gravity 0.8 --limit 3
      exoid node load leg.nc --interface socketcan --channel can0 --node 2 --friction 0.5
    """
    own = own_terms(terms)
    saved = patiently(lambda: loaded(result, own), f"reading {result}")
    model_in(saved, result)
    from exoid.interchange.for_node import Wanted, for_node
    from exoid.recordings.commissioning.download import download

    wanted = Wanted(gravity, stiffness, damping, friction, limit, rate_limit)
    try:
        found = for_node(saved.diagnosis or saved.result, wanted, segment=segment, inertia=inertia)
    except ValueError as fault:
        raise ValueError(f"{result}: {fault}") from fault
    with talking_to(node, channel, interface, bitrate) as (dialogue, asked):
        held = download(dialogue, asked, found.parameters)
    say(f"{asked} holds {result}:")
    for line in told_parameters(held):
        say(line)
    if found.left:
        say(f"Not in it, as it does not act on the leg: {', '.join(found.left)}.")
