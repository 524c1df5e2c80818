"""An entry of a recording's metadata: its key in the sidecar, its unit, and what it can be."""

from dataclasses import field, fields


def ranged(key: str, unit: str, lower: float, upper: float, default=None):
    """A number of the sidecar: its TOML key, its unit, and the range in which it can be true."""
    return field(
        default=default, metadata={"key": key, "unit": unit, "lower": lower, "upper": upper}
    )


def text(key: str, choices: tuple[str, ...] | None = None):
    """A word of the sidecar: its TOML key and, where only some words make sense, which."""
    return field(default=None, metadata={"key": key, "choices": choices})


def flag(key: str):
    """A true or false of the sidecar, and its TOML key."""
    return field(default=None, metadata={"key": key, "flag": True})


def extra():
    """What a file holds that this format does not know: kept, by name, as it was read."""
    return field(default_factory=dict, hash=False)


def known(table):
    """The fields that the format names: all but what is kept as extra."""
    return [entry for entry in fields(table) if entry.metadata]


def check_words(table) -> None:
    """Refuses a word that is none of those that a field can be."""
    for entry in known(table):
        value = getattr(table, entry.name)
        for each in value if isinstance(value, tuple) else (value,):
            check_word(entry.metadata, each)


def check_word(meta, value) -> None:
    choices = meta.get("choices")
    if choices and value is not None and value not in choices:
        raise ValueError(f"{meta['key']} is {value!r}; it can be {' or '.join(choices)}.")
