"""Body mass and height, as both commands take them."""

from typing import Annotated

import typer

BodyMass = Annotated[float | None, typer.Option(help="kg; replaces the sidecar's.", metavar="KG")]
Height = Annotated[float | None, typer.Option(help="m; replaces the sidecar's.", metavar="M")]


def given_body(**options: float | None) -> dict[str, float]:
    """The options that were given, refused where no body is like that."""
    from exoid.recordings.recording import Subject, check_entry, known

    declared = {entry.name: entry.metadata for entry in known(Subject)}
    wanted = {name: value for name, value in options.items() if value is not None}
    for name, value in wanted.items():
        check_entry({**declared[name], "key": f"--{name.replace('_', '-')}"}, value, None)
    return wanted
