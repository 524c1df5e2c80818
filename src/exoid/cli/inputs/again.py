"""What a command was told, as another one is told the same."""

from shlex import quote


def again(**options: object) -> str:
    """The options that were given, each behind a space as a command line has it; one that repeats
    is a list.
    """
    said = []
    for name, value in options.items():
        each = value if isinstance(value, list) else [value]
        option = f"--{name.replace('_', '-')}"
        said += [f" {option} {quote(str(one))}" for one in each if one is not None]
    return "".join(said)
