"""Docstrings as this project writes them, for autodoc: prose with `code`, **bold** and equations.

An indented block is an equation and stays as it is; fields are listed with their units, which the
source gives beside them.
"""

import re
from dataclasses import fields, is_dataclass
from inspect import getsource, isclass
from itertools import groupby

from sphinx.application import Sphinx

from exoid.physics.parameter import declarations

SPECIAL = re.compile(r"(?<!\*)\*(?!\*)|[|\\]|_(?=\W|$)")
FIELD = re.compile(r"^    (\w+): .*(?:\n     .*|\n    \).*)*", re.MULTILINE)


def rewrite(app, what: str, name: str, subject, options, lines: list[str]) -> None:
    """In place, as autodoc wants it."""
    paragraphs = re.split(r"\n\s*\n", "\n".join(lines).strip("\n"))
    found = [line for each in paragraphs for line in as_rest(each)]
    if isclass(subject) and is_dataclass(subject):
        found += field_list(subject)
    lines[:] = found


def as_rest(paragraph: str) -> list[str]:
    """Indented lines become a literal block; what stands around them stays text."""
    result: list[str] = []
    for indented, group in groupby(paragraph.splitlines(), lambda line: line.startswith("    ")):
        lines = list(group)
        result += ["::", "", *lines, ""] if indented else [*map(escaped, lines), ""]
    return result


def escaped(line: str) -> str:
    """Single backticks are code; bars, stars and underscores mean themselves."""
    parts = line.split("`")
    return "".join(
        f"``{part}``" if number % 2 else SPECIAL.sub(lambda found: "\\" + found[0], part)
        for number, part in enumerate(parts)
    )


def field_list(subject: type) -> list[str]:
    """The fields with what the source says beside them."""
    declared = dict(declarations(subject))
    written = {found[1]: found[0] for found in FIELD.finditer(getsource(subject))}
    rows = []
    for entry in fields(subject):
        beside = written.get(entry.name, "").partition("  # ")[2]
        said = meaning(entry.metadata, declared.get(entry.name)) or beside
        rows.append(f"- ``{entry.name}``" + (f": {escaped(said)}" if said else ""))
    return ["Fields:", "", *rows, ""] if rows else []


def meaning(metadata, declared) -> str:
    """What a field declares of itself: a parameter, a key of the sidecar, or a column."""
    if declared is not None:
        return f"{declared.title} [{declared.unit}]"
    name = metadata.get("column") or metadata.get("key")
    unit = f" [{metadata['unit']}]" if "unit" in metadata else ""
    return f"`{name}`{unit}" if name else ""


def without_fields(app, what: str, name: str, subject, options, signature, returns):
    """The fields of a class are listed with their units instead."""
    return ("", None) if what == "class" else None


def setup(app: Sphinx) -> dict[str, bool]:
    app.connect("autodoc-process-docstring", rewrite)
    app.connect("autodoc-process-signature", without_fields)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
