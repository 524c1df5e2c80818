"""Where output goes: checked before anything is computed."""

from collections.abc import Iterable
from pathlib import Path
from tempfile import TemporaryFile
from typing import Annotated

import typer

from exoid.files.replacing import behind_links

FIGURES, PAGES = ("pdf", "svg", "png"), ("html", "htm")
SAVED, DRAWS = ("nc", "json"), ("nc",)
Json = Annotated[Path | None, typer.Option(help="Everything for machines.", metavar="FILE")]
Report = Annotated[
    Path | None, typer.Option(help="Page (.html) to look at and print.", metavar="FILE")
]
Force = Annotated[bool, typer.Option("--force", help="Replace what is there.")]


def check_outputs(
    *wanted: tuple[Path | None, tuple[str, ...]], force: bool, inputs: Iterable[Path] = ()
) -> None:
    """Refuse outputs, each with the kinds that it can be of, that cannot be written, or that would
    write over an input or each other, or over a file that is there and not to be replaced."""
    for path, kinds in wanted:
        check_destination(path, kinds)
    check_apart([path for path, _ in wanted], inputs)
    check_absent([path for path, _ in wanted if path is not None], force)


def check_destination(path: Path | None, kinds: tuple[str, ...] = ()) -> None:
    """Refuse a file that cannot be written, or whose name ends in none of `kinds`."""
    if path is None:
        return
    if kinds and path.suffix.lower().lstrip(".") not in kinds:
        raise ValueError(
            f"{path}: the name must end in {' or '.join(f'.{kind}' for kind in kinds)}."
        )
    if str(path) == "-":
        raise ValueError("-: name a file; nothing but the table goes to the terminal.")
    if path.is_dir():
        raise ValueError(f"{path}: this is a directory. Name the file to write in it.")
    if path.exists() and not path.is_file():  # a pipe or a device
        return
    folder = behind_links(path).parent
    if not folder.is_dir():
        raise ValueError(f"{path}: the folder {folder} does not exist. Make it first.")
    try:
        with TemporaryFile(dir=folder):
            pass
    except OSError as fault:
        raise ValueError(
            f"{path}: the folder {folder} cannot be written to ({fault.strerror}). Name another."
        ) from fault


def check_absent(paths: Iterable[Path], force: bool) -> None:
    """Refuse to replace a file that is there, unless the user said so; a pipe or device is none."""
    for path in paths:
        if path.is_file() and not force:
            raise ValueError(f"{path} exists. Name another file, or replace it with --force.")


def check_apart(outputs: Iterable[Path | None], inputs: Iterable[Path]) -> None:
    """Refuse to write over a recording or its sidecar, or two outputs to one file."""
    named = [path for path in inputs if path.name]  # "." has none, and is refused when it is read
    taken = {name.resolve() for path in named for name in (path, path.with_suffix(".toml"))}
    for path in outputs:
        if path is None or (path.exists() and not path.is_file()):
            continue
        if path.resolve() in taken:
            raise ValueError(f"{path}: this file is read here, or written twice. Name another.")
        taken.add(path.resolve())


def check_folder(path: Path, force: bool, inputs: Iterable[Path]) -> None:
    """Refuse a folder that cannot be made, that holds an input or lies in it, or that holds
    something and is not to be replaced."""
    if path.exists() and not path.is_dir():
        raise ValueError(f"{path}: this is a file. Name a folder.")
    folder = behind_links(path.absolute())
    for each in (one.resolve() for one in inputs):
        if folder.is_relative_to(each) or each.is_relative_to(folder):
            raise ValueError(f"{path}: this folder is read here. Name one apart from it.")
    check_destination(folder.with_name(f"{folder.name}.part"))
    if path.exists() and any(path.iterdir()) and not force:
        raise ValueError(f"{path} exists. Name another folder, or replace it with --force.")
