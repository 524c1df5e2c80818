"""Files that are put in place when they are whole."""

import os
import stat
from collections.abc import Iterable, Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from itertools import count
from pathlib import Path
from secrets import token_hex
from shutil import rmtree

FOR_ALL = 0o666  # less what the user's mask takes away


@contextmanager
def replacing(path: str | Path) -> Iterator[Path]:
    """A file to write beside `path`, moved into its place when the block has succeeded.

    What was there before survives any failure, and gives its mode to what takes its place; a link
    stays a link. A pipe or a device is written to directly.

    **Raises** `OSError` that names `path`, whatever the name of the file beside it.
    """
    path = Path(path)
    if path.is_dir():
        raise ValueError(f"{path}: this is a directory. Name the file to write in it.")
    target = behind_links(path)
    if not target.parent.is_dir():
        raise ValueError(f"{path}: the folder {target.parent} does not exist. Make it first.")
    if path.exists() and not path.is_file():
        with called(path):
            yield path
        return
    with called(path):
        part = begun(target)
    try:
        with called(path, part):
            yield part
            with part.open("rb+") as file:
                os.fsync(file.fileno())
            part.replace(target)
    finally:
        part.unlink(missing_ok=True)


@contextmanager
def replacing_folder(folder: Path) -> Iterator[Path]:
    """An empty folder to fill beside `folder`, moved into its place when the block has succeeded.

    A folder that was there is put aside as `NAME.before`, or with a number behind it, at the last
    moment: whatever fails, it is lost at no time.
    """
    target = behind_links(folder.absolute())
    with called(folder):
        part = target.with_name(f".{target.name[:100]}.{token_hex(8)}.part")
        part.mkdir()
    try:
        yield part
        with called(folder, part):
            put_aside(target)
            part.rename(target)
    finally:
        rmtree(part, ignore_errors=True)


def put_aside(folder: Path) -> None:
    """Give a folder another name; nothing is to be kept of an empty one."""
    aside = name_aside(folder)
    if aside is not None:
        folder.rename(aside)
    elif folder.exists():
        folder.rmdir()


def name_aside(folder: Path) -> Path | None:
    """Where `replacing_folder` puts what is there; None where nothing is."""
    if not folder.exists() or not any(folder.iterdir()):
        return None
    names = (folder.with_name(f"{folder.name}.before{number or ''}") for number in count())
    return next(each for each in names if not each.exists())


@contextmanager
def made(folder: Path) -> Iterator[None]:
    """A folder, with those above it, for a block; those that were missing go again if it fails."""
    missing = [each for each in (folder, *folder.parents) if not each.exists()]
    try:
        folder.mkdir(parents=True, exist_ok=True)
        yield
    except BaseException:
        for each in missing:
            with suppress(OSError):  # not made, or not empty: another wrote into it meanwhile
                each.rmdir()
        raise


def behind_links(path: Path) -> Path:
    """Where a file that is written comes to stand: where a link leads, else where it is named.

    **Raises** `ValueError` for links that lead back to each other.
    """
    if not path.is_symlink():
        return path
    try:
        return path.resolve()
    except (OSError, RuntimeError) as fault:  # which of them hangs on the version of Python
        raise ValueError(f"{path}: this link leads to itself. Name another file.") from fault


def replace_files(contents: Mapping[Path, Iterable[str] | bytes]) -> None:
    """Writes every file beside its target, and only when all are complete puts them in place."""
    with ExitStack() as whole:
        for path, content in contents.items():
            with whole.enter_context(replacing(path)).open("wb") as file:
                binary = isinstance(content, bytes)
                file.writelines([content] if binary else (each.encode() for each in content))


def begun(target: Path) -> Path:
    """A new file beside `target` whose name nobody foresees, as open to others as `target` is."""
    part = target.with_name(f".{target.name[:100]}.{token_hex(8)}.part")
    os.close(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, FOR_ALL))
    if target.exists():
        part.chmod(stat.S_IMODE(target.stat().st_mode))
    return part


@contextmanager
def called(path: Path, part: Path | None = None) -> Iterator[None]:
    """Errors of the operating system over `part` or no file by the name that the user gave."""
    try:
        yield
    except OSError as fault:
        if fault.filename not in (None, str(part)):
            raise
        raise OSError(fault.errno, fault.strerror or str(fault), str(path)) from fault
