"""Nodes as a person reads them, and as a machine does."""

from collections.abc import Iterable, Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

from exoid.files.counted import counted

if TYPE_CHECKING:
    from exoid.recordings.commissioning.node_state import NodeState
    from exoid.recordings.commissioning.told_parameters import HeldParameters

HEADS = ("id", "serial", "firmware", "zero", "count", "bit rate", "supply", "state")


def table(nodes: Iterable["NodeState"]) -> list[str]:
    """A line for each node, under a line of heads."""
    rows = [HEADS, *map(cells, nodes)]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]


def cells(state: "NodeState") -> tuple[str, ...]:
    """What is shown of a node."""
    from exoid.recordings.can.node.commissioned import direction

    health = state.health
    return (
        str(state.node),
        f"{state.serial:08X}",
        health.version if health else "?",
        str(state.mounting.zero),
        direction(state.mounting.reversed),
        f"{state.bit_rate / 1000:g} kbit/s",
        f"{health.supply:.2f} V" if health and health.supply else "?",
        ", ".join(troubles(state)) or "well",
    )


def troubles(state: "NodeState") -> list[str]:
    """What a person should know of a node."""
    found = [] if state.commissioned else ["not commissioned"]
    return found + (state.health.troubles() if state.health else ["no heartbeat"])


def told(state: "NodeState") -> list[str]:
    """All of one node, a line each."""
    health = state.health
    errors = (
        f"transmit {health.transmit_errors}, receive {health.receive_errors}, "
        f"frames lost {health.lost_frames}"
        if health
        else "?"
    )
    named = dict(zip(HEADS, cells(state), strict=True))
    return [
        f"node {named['id']}, serial {named['serial']}, firmware {named['firmware']}",
        f"{state.mounting}",
        f"CAN bus at {named['bit rate']}",
        f"supply {named['supply']}; errors: {errors}; settings stored "
        f"{counted(state.changes, 'time')}",
        f"state: {named['state']}",
        *(told_parameters(state.parameters) if state.parameters else ()),
    ]


def told_parameters(held: "HeldParameters") -> list[str]:
    """The parameters by which a node commands a torque."""
    kept = "kept in flash" if held.stored else "kept until the power goes"
    own = "" if held.whole else "; they are laid out otherwise than this exoid has them"
    said = ", ".join(held.lines()) if held.whole else "not readable here"
    return [f"torque: {said}", f"their CRC is {held.crc:04X}; {kept}{own}"]


def document(nodes: Iterable["NodeState"]) -> Mapping[str, Any]:
    """The nodes for machines, units in the names."""
    return {"nodes": [entry(each) for each in nodes]}


def entry(state: "NodeState") -> dict[str, Any]:
    health = state.health
    told = {
        "id": state.node,
        "serial": f"{state.serial:08X}",
        "zero_counts": state.mounting.zero,
        "reversed": state.mounting.reversed,
        "commissioned": state.commissioned,
        "bit_rate": state.bit_rate,
        "changes": state.changes,
    }
    if state.parameters:
        told |= {"torque_parameters": torque_entry(state.parameters)}
    if health is None:
        return told | {"health": None}
    return told | {
        "health": {
            "firmware": health.version,
            "supply_v": health.supply or None,
            "transmit_errors": health.transmit_errors,
            "receive_errors": health.receive_errors,
            "lost_frames": health.lost_frames,
            "sensor_fault": health.sensor_fault,
            "can_off": health.can_off,
            "on_can": health.on_can,
        }
    }


def torque_entry(held: "HeldParameters") -> dict[str, Any]:
    """In the units of `TorqueParameters`."""
    return {**asdict(held.values), "crc": f"{held.crc:04X}", "stored": held.stored}
