"""exoid example: the recording that comes with exoid, as a pattern for one's own."""

import shlex
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.reading import EXAMPLE
from exoid.cli.outputs.destination import check_absent
from exoid.cli.terminal.say import say
from exoid.files.replacing import made, replace_files

FILES = (EXAMPLE, EXAMPLE.with_suffix(".toml"))
NEXT = """
It is a simulated session: three drops, a fourth with 1 kg at the ankle, and six
voluntary cycles. Next:

  exoid fit {0} --plot fit.pdf       the leg's parameters, and a figure
  exoid drops {0}                    what clinicians read off a drop
  exoid diagnose {0}                 which physics the model lacks
  exoid plan {0} --goal inertia      what to record next

{1} says whose leg it is and how it moved; its comments explain every
line. Put such a file beside a recording of your own, with the same name."""


def example(
    folder: Annotated[
        Path, typer.Argument(help="Where to; made where it is missing. Without it, here.")
    ] = Path(),
    force: Annotated[
        bool, typer.Option("--force", help="Replace files of that name that are there.")
    ] = False,
) -> None:
    """Copy the recording that comes with exoid, and its sidecar.

    The comments of the sidecar explain every line.

    \b
    Examples:
      exoid example              to the current folder
      exoid example first_try    to a folder of its own
    """
    if folder.exists() and not folder.is_dir():
        raise ValueError(f"{folder}: this is a file. Name a folder.")
    targets = [folder / each.name for each in FILES]
    check_absent(targets, force)
    with made(folder):
        replace_files({to: each.read_bytes() for to, each in zip(targets, FILES, strict=True)})
    recording, sidecar = targets
    say(f"wrote {recording} and {sidecar}")
    say(*NEXT.format(shlex.quote(str(recording)), sidecar.name).splitlines())
