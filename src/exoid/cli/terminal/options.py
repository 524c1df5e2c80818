"""Keywords of the library, as the options of a command are called."""

import re

from exoid.files.column_asked import COLUMN

CALLED = (
    (COLUMN, r"--column \1=\2"),
    (re.compile(r'\b(flip|zero)="(\w+)"'), r"--\1 \2"),
    (re.compile(r"\(dbc and signals\)"), "(--dbc and --signal)"),
)


def as_options(said: str) -> str:
    """What a fault or a note of the library advises, to be typed.

    >>> as_options('Then say flip="all".')
    'Then say --flip all.'
    """
    for keyword, option in CALLED:
        said = keyword.sub(option, said)
    return said
