"""exoid convert: from any recording to exoid's table."""

from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.choices import FlipOption, ZeroOption
from exoid.cli.inputs.reading import Columns, Dbc, Signals, Strict, take
from exoid.cli.outputs.destination import Force, check_outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently


def convert(
    recording: Annotated[
        Path,
        typer.Argument(
            help="A CAN log or a table (.csv .txt .xlsx .parquet .mat .npz .mot .sto .c3d)."
        ),
    ],
    output: Annotated[
        Path,
        typer.Option(
            "--output", "-o", help="Table to write (.csv or .parquet); a sidecar joins it."
        ),
    ],
    whole: Annotated[
        bool, typer.Option("--whole", help="One continuous segment, nothing between left out.")
    ] = False,
    column: Columns = None,
    dbc: Dbc = None,
    signal: Signals = None,
    flip: FlipOption = None,
    zero: ZeroOption = None,
    strict: Strict = False,
    force: Force = False,
) -> None:
    """Write a recording as exoid's table, with its sidecar.

    The table is .csv or .parquet, the sidecar .toml. Signs and zero that --flip and --zero mend are
    written as exoid counts them.
    The segments are those that `exoid fit` would see: drops and cycles, without what lies between.

    \b
    Examples:
      exoid convert session.blf -o drops.csv
      exoid convert session.blf -o all.csv --whole
      exoid convert trial.c3d -o knee.parquet --column raw_angle_deg=LKneeAngles.X
      exoid convert log.asc -o knee.csv --dbc my.dbc --signal raw_angle=Knee.Angle
    """
    sidecar = output.with_suffix(".toml")
    check_outputs((output, ("csv", "parquet")), (sidecar, ()), force=force, inputs=[recording])
    told = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
    loaded = take(recording, strict=strict, whole=whole, **told).recording
    from exoid.recordings.formats.own_table import write_table
    from exoid.report.words.text import counted

    patiently(lambda: write_table(loaded, output), f"writing {output.name}")
    say(f"{output}: {counted(len(loaded.segments), 'segment')}, and {sidecar}")
