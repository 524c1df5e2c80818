"""The groups of a netCDF file, in memory; HDF5 parses it where a damaged file cannot hold us up."""

import json
from pathlib import Path
from typing import Any

import numpy as np

from exoid.files.foreign import Arrays, read_apart

LAYOUT = "layout"  # of the groups, as JSON, beside their arrays


def read_groups(path: Path) -> dict[str, Any]:
    """A Dataset for every group by its path; nothing is scaled, masked or turned into dates.

    **Raises** `ForeignError` where the file is no whole netCDF file.
    """
    import xarray

    arrays = read_apart(unpacked, path, "Save it again.")
    return {
        group: xarray.Dataset(
            {name: (dims, arrays[f"{group}/{name}"]) for name, dims in each["dims"].items()},
            attrs=each["attrs"],
        )
        for group, each in json.loads(str(arrays[LAYOUT])).items()
    }


def unpacked(path: Path) -> Arrays:
    """The arrays of all groups by their paths, and the layout."""
    import h5netcdf

    arrays: Arrays = {}
    layout: dict[str, Any] = {}

    def visit(group: Any) -> None:
        where = group.name.strip("/") or "/"
        dims = {}
        for name, variable in group.variables.items():
            values = np.asarray(variable[...])
            arrays[f"{where}/{name}"] = values.astype(str) if values.dtype == object else values
            dims[name] = variable.dimensions
        layout[where] = {"dims": dims, "attrs": dict(group.attrs)}
        for each in group.groups.values():
            visit(each)

    with h5netcdf.File(path, "r", decode_vlen_strings=True) as file:
        visit(file)
    told = json.dumps(layout, default=lambda number: number.tolist())
    return arrays | {LAYOUT: np.array(told)}
