"""The body, as options and answers on a terminal say it."""

import sys
from collections.abc import Mapping
from typing import Annotated

import typer

from exoid.cli.terminal.say import say

BodyMass = Annotated[float | None, typer.Option(help="kg; replaces the sidecar's.", metavar="KG")]
Height = Annotated[float | None, typer.Option(help="m; replaces the sidecar's.", metavar="M")]
AddedMass = Annotated[float | None, typer.Option(help="On the shank, weighed [kg].", metavar="KG")]
AddedMassDistance = Annotated[
    float | None, typer.Option(help="Of that mass from the knee [m].", metavar="M")
]
AddedMassGyration = Annotated[
    float | None,
    typer.Option(help="Its radius of gyration about its own middle [m].", metavar="M"),
]
SubjectId = Annotated[
    str | None, typer.Option("--id", help="Who it is, for the sidecar.", metavar="TEXT")
]

QUESTIONS = {
    "body_mass": "Body mass [kg]",
    "height": "Height [m]",
    "added_mass": "Mass added to the shank [kg]",
    "added_mass_distance": "Its distance from the knee [m]",
}


def given_body(**options: float | None) -> dict[str, float]:
    """The options that were given, refused where no body is like that, or no mass is on it."""
    from exoid.recordings.declared.check_entries import check_entry
    from exoid.recordings.declared.entry import known
    from exoid.recordings.declared.subject import Subject

    declared = {entry.name: entry.metadata for entry in known(Subject)}
    wanted = {name: value for name, value in options.items() if value is not None}
    for name, value in wanted.items():
        check_entry({**declared[name], "key": f"--{name.replace('_', '-')}"}, value, None)
    of_mass = [name for name in wanted if name.startswith("added_mass_")]
    if of_mass and "added_mass" not in wanted:
        raise ValueError(
            f"--{of_mass[0].replace('_', '-')} is given without --added-mass. Give both."
        )
    return wanted


def doubted(body: Mapping[str, float | None]) -> list[str]:
    """What to ask of a body that hardly anybody has."""
    from exoid.physics.anatomy.body.doubt import doubts

    each = doubts(body.get("body_mass"), body.get("height"), body.get("age"))
    return [f"the person {one.says}" for one in each]


def ask_body(given: dict[str, float]) -> dict[str, float]:
    """What was given, and what is answered; an empty answer leaves it unknown.

    Without a terminal nothing is asked.
    """
    known = dict(given)
    for name, question in QUESTIONS.items() if at_terminal() else ():
        needless = name == "added_mass_distance" and not known.get("added_mass")
        if name not in known and not needless:
            known |= answer(known, name, question)
    for says in doubted(known):
        say(f"exoid: {says}", err=True)
    return known


def at_terminal() -> bool:
    """Is there somebody who can be asked?"""
    return sys.stdin.isatty() and sys.stderr.isatty()


def answer(known: dict[str, float], name: str, question: str) -> dict[str, float]:
    while True:
        said = typer.prompt(
            f"{question}, empty if unknown", default="", show_default=False, err=True
        )
        if not said.strip():
            return {}
        try:
            return given_body(**known, **{name: float(said)})
        except ValueError as fault:
            say(f"exoid: {fault}", err=True)
