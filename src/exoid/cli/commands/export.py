"""exoid export: a fitted leg for other tools."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from exoid.cli.inputs.terms import OwnTerms, loaded, model_in, own_terms, undecided_in
from exoid.cli.outputs.destination import Force, check_outputs
from exoid.cli.outputs.results import show
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently

ENDINGS = {
    "mjcf": ("xml", "mjcf"),
    "urdf": ("urdf", "xml"),
    "osim": ("osim",),
    "c": ("h", "hpp"),
    "python": ("py",),
}  # of a file's name; the first where none is named
Form = Literal["mjcf", "urdf", "osim", "opensim", "c", "python"]
ALSO: dict[str, Form] = {"opensim": "osim"}  # called so, too


def export(
    result: Annotated[
        Path, typer.Argument(help="What 'exoid fit' or 'exoid diagnose' saved (.nc, .json).")
    ],
    form: Annotated[
        Form,
        typer.Option(
            "--as",
            help="mjcf: MuJoCo. urdf: robot description. osim, opensim: OpenSim. c: a header for "
            "firmware. python: a script that needs NumPy alone.",
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", help="File to write; else leg.xml, .urdf, .osim, .h or .py."
        ),
    ] = None,
    segment: Annotated[
        int | None,
        typer.Option(
            min=0,
            help="As this segment of the fit's table had it: with its added mass, its torque and "
            "its first state. Else bare and free, begun as segment 0.",
        ),
    ] = None,
    terms: OwnTerms = None,
    force: Force = False,
) -> None:
    """Hand a fitted leg on to MuJoCo, URDF, OpenSim, C or Python.

    Its terms go with it, and the error of every number. Of a saved diagnosis it is the leg with
    what was found. What the other tool has nothing for is refused by name, approximated with its
    error said, or said in the file's comments.

    \b
    Examples:
      exoid fit drops.csv --with coulomb_friction --save leg.nc
      exoid export leg.nc --as mjcf                   leg.xml, for MuJoCo
      exoid export leg.nc --as c -o exoid_leg.h       feed-forward for firmware
      exoid export why.nc --as osim --segment 1       as that segment of a diagnosis had it
    """
    form = ALSO.get(form, form)
    path = output or Path(f"leg.{ENDINGS[form][0]}")
    check_outputs((path, ENDINGS[form]), force=force, inputs=[result])
    own = own_terms(terms)
    saved = patiently(lambda: loaded(result, own), f"reading {result}")
    model_in(saved, result)
    from exoid.files.replacing import replace_files
    from exoid.interchange.export import export as exported
    from exoid.report.tables.exported import print_exported

    try:
        found = exported(saved.diagnosis or saved.result, form, segment=segment)
    except ValueError as fault:
        raise ValueError(f"{result}: {fault}") from fault
    show(lambda console: print_exported(found, console))
    unsure = undecided_in(saved, result)
    for each in (*found.warnings, *([unsure] if unsure else [])):
        say(f"exoid: {each}", err=True)
    files = Outputs()
    files.put(path, lambda path: replace_files({path: [found.text]}))
    files.end(saved.result.follows)
