"""Estimates as a table of one row each, for a file: NaN and an empty text stand for None."""

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from exoid.fitting.misfit.uncertainty import Shares
from exoid.fitting.result.fit_result import Estimate

Table = Any  # an xarray.Dataset; to import xarray here would slow the start of every fit
Groups = Mapping[str, Table]

TEXTS = ("symbol", "title", "unit", "reason", "by_hand")
NUMBERS = ("value", "standard_error", "expected", "expected_deviation", "lower", "upper")
SHARES = ("data", "prior", "bound")


def to_table(estimates: Mapping[str, Estimate]) -> Table:
    """Rows by name."""
    import xarray

    each = list(estimates.values())
    columns = {name: texts([getattr(one, name) for one in each]) for name in TEXTS}
    columns |= {name: numbers([getattr(one, name) for one in each]) for name in NUMBERS}
    columns |= {
        f"share_{name}": numbers([one.shares and getattr(one.shares, name) for one in each])
        for name in SHARES
    }
    limits = [one.limited_by for one in each]
    columns["limited_by"] = texts([None if one is None else json.dumps(one) for one in limits])
    columns["told_by"] = texts([one.shares and one.shares.kind for one in each])
    return xarray.Dataset(
        {name: ("name", column) for name, column in columns.items()},
        coords={"name": texts(list(estimates))},
    )


def from_table(table: Table) -> dict[str, Estimate]:
    """What `to_table` was given."""
    columns = {str(name): table[name].values.tolist() for name in table.variables}
    found = {}
    for row, name in enumerate(columns["name"]):
        shares = [columns[f"share_{part}"][row] for part in SHARES]
        values: dict[str, Any] = {key: known(columns[key][row]) for key in NUMBERS}
        values |= {key: columns[key][row] for key in TEXTS if key in columns}
        values["shares"] = (
            None if np.isnan(shares[0]) else Shares(*shares, kind=columns["told_by"][row] or None)
        )
        values["limited_by"] = json.loads(columns["limited_by"][row] or "null")
        values |= {key: values.get(key) or None for key in ("reason", "by_hand")}
        found[name] = Estimate(**values)
    return found


def numbers(values) -> np.ndarray:
    """None as NaN."""
    return np.array([np.nan if value is None else value for value in values], dtype=float)


def texts(values) -> np.ndarray:
    """None as an empty text."""
    return np.array(["" if value is None else value for value in values], dtype=object)


def known(value: float) -> float | None:
    """NaN as None."""
    return None if np.isnan(value) else value
