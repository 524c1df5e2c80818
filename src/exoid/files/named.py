"""What a result has by name, which answers a name that it has not with those that it has."""

from typing import TypeVar

from exoid.files.text_file import near

Value = TypeVar("Value")


class Named(dict[str, Value]):
    """Values by name.

    **Raises** `KeyError` with the name that a misspelt one resembles, and all others.
    """

    def __missing__(self, name: str) -> Value:
        raise KeyError(f"{name!r} is none of {', '.join(self)}.{near(str(name), self)}")
