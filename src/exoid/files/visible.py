"""Words of a file, such that a terminal or a page shows all of them and obeys none."""

import json
import re
from unicodedata import category

UNUSUAL = re.compile(r"[^ -~]")
SPACE = "Zs"  # Unicode's spaces of other widths, with which numbers are set


def visible(words: str, kept: str = "") -> str:
    r"""Control characters, line breaks, marks that turn the direction of writing, and halves of
    characters as JSON writes them (`\u001b`, `\n`); those that are `kept` stay.
    """
    return UNUSUAL.sub(lambda found: found[0] if shows(found[0], kept) else told(found[0]), words)


def shows(letter: str, kept: str) -> bool:
    return letter.isprintable() or letter in kept or category(letter) == SPACE


def told(letter: str) -> str:
    return json.dumps(letter)[1:-1]
