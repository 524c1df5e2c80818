"""Text files: read with a reason where they cannot be."""

import csv
from collections.abc import Iterable
from contextlib import contextmanager
from pathlib import Path

from exoid.files.system_errors import told
from exoid.files.visible import visible

Notes = tuple[str, ...]
MEANT = {"weight": "body_mass"}  # what a key is called otherwise


@contextmanager
def naming(path: Path):
    """Puts the name of the file before what is wrong in it."""
    try:
        yield
    except ValueError as error:
        raise ValueError(visible(f"{path}: {error}")) from error


def read_text(path: Path) -> str:
    """The text of a file, with plain line ends and without a byte order mark."""
    content = content_of(path)
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ValueError(
            f"is not UTF-8 text (byte {content[error.start]:#04x} at {error.start}). "
            "Export it as CSV in UTF-8."
        ) from error
    return plain_lines(text)


def content_of(path: Path) -> bytes:
    if path.is_dir():
        raise ValueError("this is a directory. Name the file in it.")
    try:
        return path.read_bytes()
    except OSError as error:
        raise ValueError(f"cannot be read: {told(error)}") from error


def plain_lines(text: str) -> str:
    """With plain line ends. **Raises** `ValueError` where it is no text after all."""
    if "\0" in text:
        raise ValueError("holds binary data, not text. Export it as CSV in UTF-8.")
    return text.replace("\r\n", "\n").replace("\r", "\n")


def misquoted(fault: csv.Error) -> str:
    """What is wrong with the quotes of a table, as Python's reader of CSV found it."""
    if "limit" in str(fault):
        longest = f"{csv.field_size_limit()} characters"
        return f"a cell is longer than {longest}. Is a quote not closed? Else leave its column out."
    return "a quote that opens a cell does not close at its end. Check the quotes."


def near(name: str, names: Iterable[str], likeness: float = 0.6) -> str:
    """The known name that an unknown one resembles, or means, as a question."""
    import difflib  # only a file with a typo pays for it

    known, said = sorted(names), name.lower()
    meant = MEANT.get(said.partition("_")[0])
    alike = [each for each in known if meant and each.startswith(meant)]
    alike = alike or difflib.get_close_matches(said, known, 1, likeness)
    return f" Did you mean {alike[0]}?" if alike else ""
