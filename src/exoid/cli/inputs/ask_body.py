"""Questions on a terminal: what a sidecar should say and no option said."""

import sys

import typer

from exoid.cli.inputs.body import given_body

QUESTIONS = {
    "body_mass": "Body mass [kg]",
    "height": "Height [m]",
    "added_mass": "Mass added to the shank [kg]",
    "added_mass_distance": "Its distance from the knee [m]",
}


def ask_body(given: dict[str, float]) -> dict[str, float]:
    """What was given, and what is answered; an empty answer leaves it unknown.

    Without a terminal nothing is asked.
    """
    if not (sys.stdin.isatty() and sys.stderr.isatty()):
        return given
    known = dict(given)
    for name, question in QUESTIONS.items():
        needless = name == "added_mass_distance" and not known.get("added_mass")
        if name not in known and not needless:
            known |= answer(name, question)
    return known


def answer(name: str, question: str) -> dict[str, float]:
    while True:
        said = typer.prompt(
            f"{question}, empty if unknown", default="", show_default=False, err=True
        )
        if not said.strip():
            return {}
        try:
            return given_body(**{name: float(said)})
        except ValueError as fault:
            typer.echo(f"exoid: {fault}", err=True)
