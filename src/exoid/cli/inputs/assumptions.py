"""The table, the limits, and what is fixed, bounded or expected by hand, as several commands take
them.
"""

import re
from typing import Annotated, Any

import typer

from exoid.cli.inputs.choices import TABLES, Bounds

Prior = Annotated[
    list[str] | None,
    typer.Option(
        help=f"Anatomical table ({', '.join(TABLES)}), or what you expect of a parameter: "
        "damping=3+-1; repeat.",
        metavar="TABLE|NAME=VALUE+-SD",
    ),
]
BoundsOption = Annotated[
    Bounds,
    typer.Option(
        "--bounds", help="body: what a leg of this body can have. paper: Eq. 13 as printed."
    ),
]
Fix = Annotated[
    list[str] | None,
    typer.Option(help="Hold a parameter: stiffness=0; repeat.", metavar="NAME=VALUE"),
]
Bound = Annotated[
    list[str] | None,
    typer.Option(
        help="Your limits of a parameter: damping=0:20, or 0: or :20; repeat.",
        metavar="NAME=LOW:HIGH",
    ),
]
DEVIATION = re.compile(r"\+/-|\+-|±")


def assumed(
    prior: list[str] | None, bounds: Bounds, fix: list[str] | None, bound: list[str] | None
) -> dict[str, Any]:
    """The options of a fit, refused where no leg is like that.

    The names are checked here, before anything is computed.
    """
    from exoid.fitting.model.user_values import ByHand

    words = prior or []
    tables = [word for word in words if "=" not in word]
    if len(tables) > 1:
        raise ValueError(f"--prior takes one table, not {' and '.join(tables)}.")
    if tables and tables[0] not in TABLES:
        raise ValueError(
            f"--prior {tables[0]}: this is no table and no expectation. It can be "
            f"{', '.join(TABLES)}, or NAME=VALUE+-SD such as damping=3+-1."
        )
    said = ByHand(
        dict(named("--fix", word, value_of) for word in fix or []),
        dict(named("--bound", word, ends_of) for word in bound or []),
        dict(named("--prior", word, expectation_of) for word in words if "=" in word),
    )
    each = {"fix": said.fix, "bound": said.bound, "expect": said.prior}
    return {
        "prior": tables[0] if tables else TABLES[0],
        "bounds": bounds,
        **{name: dict(given) for name, given in each.items() if given},
    }


def named(option: str, word: str, read) -> tuple[str, Any]:
    """NAME=... as the name and what follows."""
    name, equals, rest = word.partition("=")
    try:
        if not equals:
            raise ValueError
        return name.strip(), read(rest)
    except ValueError:
        form = {"--fix": "stiffness=0", "--bound": "damping=0:20", "--prior": "damping=3+-1"}
        raise ValueError(f"{option} {word}: this is not like {option} {form[option]}.") from None


def value_of(text: str) -> float:
    return float(text)


def ends_of(text: str) -> tuple[float | None, float | None]:
    low, colon, high = text.partition(":")
    if not colon or not (low or high):
        raise ValueError
    return float(low) if low else None, float(high) if high else None


def expectation_of(text: str) -> tuple[float, float]:
    value, deviation = DEVIATION.split(text)
    return float(value), float(deviation)
