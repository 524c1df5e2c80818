"""What readers noticed of several files, without saying it again of each."""

from collections.abc import Iterable
from pathlib import Path


def once(noticed: Iterable[tuple[Path, str]], before: str = "") -> list[str]:
    """What is said of several files in the same words once, by the first and how many more.

    A line that is of a file begins with `before`, and the path of it or of its sidecar.
    """
    said: dict[str | int, list[tuple[str, str]]] = {}
    for number, (path, line) in enumerate(noticed):
        head = head_of(path, line, before)
        words = line.removeprefix(head)
        said.setdefault(words if head else number, []).append((head, words))
    return [counted(*each) for each in said.values()]


def head_of(path: Path, line: str, before: str) -> str:
    """What names the file at the beginning of a line; nothing where none is named."""
    heads = (f"{before}{each}" for each in (path, path.with_suffix(".toml")))
    return next((each for each in heads if line.startswith(f"{each}: ")), "")


def counted(first: tuple[str, str], *others: tuple[str, str]) -> str:
    """A line of the first of several files, and of how many more it is."""
    head, words = first
    return f"{head} and {len(others)} more{words}" if others else f"{head}{words}"
