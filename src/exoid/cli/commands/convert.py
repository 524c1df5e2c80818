"""exoid convert: from any recording to exoid's table, from any data set to another layout."""

from pathlib import Path
from typing import Annotated, Literal

import typer

from exoid.cli.inputs.choices import FlipOption, ZeroOption
from exoid.cli.inputs.reading import Columns, Dbc, Signals, Strict, take
from exoid.cli.outputs.destination import Force, check_folder, check_outputs
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import in_phases, patiently

Layout = Literal["bids", "plain"]
SHOWN = 5  # of the files that do not come along
WORDS = {"bids": "Motion-BIDS", "plain": "exoid's tables"}


def convert(
    recording: Annotated[
        Path,
        typer.Argument(
            help="A CAN log or a table (.csv .txt .xlsx .parquet .mat .npz .mot .sto .c3d), or the "
            "folder of a data set."
        ),
    ],
    output: Annotated[
        Path,
        typer.Option(
            "--output",
            "-o",
            help="Table to write (.csv or .parquet); a sidecar joins it. Of a data set: a folder.",
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
    layout: Annotated[
        Layout | None,
        typer.Option("--as", help="Of a data set: Motion-BIDS, or exoid's own tables."),
    ] = None,
    force: Force = False,
) -> None:
    """Write a recording as exoid's table, with its sidecar.

    The table is .csv or .parquet, the sidecar .toml. Signs and zero that --flip and --zero mend are
    written as exoid counts them.
    The segments are those that `exoid fit` would see: drops and cycles, without what lies between.
    A folder is written as another one, all of it or nothing: a data set as Motion-BIDS, or back.

    \b
    Examples:
      exoid convert session.blf -o drops.csv
      exoid convert session.blf -o all.csv --whole
      exoid convert trial.c3d -o knee.parquet --column raw_angle_deg=LKneeAngles.X
      exoid convert log.asc -o knee.csv --dbc my.dbc --signal raw_angle=Knee.Angle
      exoid convert study -o shared --as bids
    """
    if recording.is_dir():
        for_all = f"Write it into {recording / 'defaults.toml'}, for all recordings."
        keys = {"--column": column, "--flip": flip, "--zero": zero}
        refuse_given(keys, "a recording", recording, for_all)
        alone = {"--dbc": dbc, "--signal": signal, "--strict": strict}
        refuse_given(alone, "a recording", recording)
        convert_folder(recording, output, layout, whole=whole, force=force)
        return
    refuse_given({"--as": layout}, "a data set", recording)
    sidecar = output.with_suffix(".toml")
    check_outputs((output, ("csv", "parquet")), (sidecar, ()), force=force, inputs=[recording])
    told = {"column": column, "dbc": dbc, "signal": signal, "flip": flip, "zero": zero}
    loaded = take(recording, strict=strict, whole=whole, **told).recording
    from exoid.files.counted import counted
    from exoid.recordings.formats.own_table import write_table

    patiently(lambda: write_table(loaded, output), f"writing {output.name}")
    say(f"{output}: {counted(len(loaded.segments), 'segment')}, and {sidecar}")


def refuse_given(
    options: dict[str, object], of: str, given: Path, mend: str = "Leave it out."
) -> None:
    """Refuse options that say nothing of what was given."""
    for name, value in options.items():
        if value:
            raise ValueError(f"{given}: {name} is for {of}, which this is not. {mend}")


def convert_folder(
    folder: Path, output: Path, layout: Layout | None, *, whole: bool, force: bool
) -> None:
    """A data set as the layout that it has not, unless one is named."""
    check_folder(output, force, [folder])
    from exoid.files.counted import counted
    from exoid.files.replacing import name_aside, replacing_folder
    from exoid.recordings.tables.sheet import listed
    from exoid.studies.dataset.open_dataset import open_dataset
    from exoid.studies.dataset.writing.convert_dataset import convert_dataset

    dataset = patiently(lambda: open_dataset(folder), f"reading {folder.name}")
    for each in dataset.problems:
        raise ValueError(f"{folder}: {each}")
    chosen, aside = layout or ("plain" if dataset.bids else "bids"), name_aside(output)
    with replacing_folder(output) as part:
        done = in_phases(
            lambda said: convert_dataset(dataset, part, chosen, whole=whole, say=said),
            f"writing {output.name}",
        )
    say(f"{output}: {counted(done.recordings, 'recording')} as {WORDS[chosen]}")
    if done.others:
        count = counted(len(done.others), "other file")
        say(f"exoid: {count} left behind: {listed([*done.others], SHOWN)}", err=True)
    if aside is not None:
        say(f"what was there is {aside}")
