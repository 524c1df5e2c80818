"""A frozen dataclass comes back from its groups as it was, whatever its fields are."""

from dataclasses import dataclass
from typing import Annotated, Any, Literal

import numpy as np
import pytest
from jaxtyping import Bool, Float
from test_saved_result import ODD, check_same

from exoid.report.saved.groups import from_groups, to_groups


@dataclass(frozen=True)
class Place:
    angle: Annotated[float, "rad"]
    name: str = ""


@dataclass(frozen=True)
class Row:
    name: str
    words: list[str]
    place: Place
    count: int
    held: bool
    size: Annotated[float | None, "N m"] = None
    note: str | None = None


@dataclass(frozen=True, eq=False)
class Curve:
    time: Annotated[Float[np.ndarray, " sample"], "s"]
    seen: Bool[np.ndarray, "segment sample"]
    model: Annotated[Float[np.ndarray, " sample"] | None, "rad"]


@dataclass(frozen=True, eq=False)
class Whole:
    number: Annotated[float, "kg m^2"]
    absent: float | None
    verdict: Literal["none", "some"]
    held: bool
    count: int
    each: tuple[str, ...]
    known: dict[str, float]
    rows: list[Row]
    curves: tuple[Curve, ...]
    curve: Curve | None
    workings: Any = None


def curve(samples: int, model: bool) -> Curve:
    time = np.resize(ODD, samples)
    return Curve(time, np.resize([True, False, True], (2, samples)), time if model else None)


FULL = Whole(
    number=ODD[0],
    absent=None,
    verdict="some",
    held=True,
    count=-3,
    each=("ä", ""),
    known={"b": np.inf, "a": ODD[1]},
    rows=[
        Row("x", ["p", "q"], Place(ODD[3], "here"), 2**40, True, -0.0, "said"),
        Row("", [], Place(np.inf), 0, False),
    ],
    curves=(curve(7, True), curve(12, False)),
    curve=curve(1, True),
)
EMPTY = Whole(0.0, 5e-324, "none", False, 0, (), {}, [], (), None)


def through_a_file(groups, path):
    import xarray

    xarray.DataTree.from_dict(groups).to_netcdf(path, engine="h5netcdf")
    with xarray.open_datatree(path, engine="h5netcdf", decode_cf=False) as tree:
        each = {node.path.strip("/"): node.to_dataset(inherit=False) for node in tree.subtree}
        return {name: table.load() for name, table in each.items()}


@pytest.mark.parametrize("whole", [FULL, EMPTY], ids=["full", "empty"])
def test_it_comes_back_bit_for_bit(tmp_path, whole):
    groups = through_a_file(to_groups(whole, "a/b"), tmp_path / "x.nc")
    check_same(whole, from_groups(Whole, groups, "a/b", workings=None))


def test_what_is_left_out_is_given_again():
    groups = to_groups(FULL, "a", without=("curves", "curve"))
    assert not [path for path in groups if "curve" in path]
    back = from_groups(Whole, groups, "a", curves=FULL.curves, curve=None, workings=None)
    check_same(FULL.rows, back.rows)
    assert back.curves is FULL.curves


def test_numbers_have_their_units_and_arrays_their_dimensions():
    groups = to_groups(FULL, "a")
    assert groups["a"]["number"].attrs["units"] == "kg m^2"
    assert groups["a/rows"]["place.angle"].attrs["units"] == "rad"
    assert groups["a/rows"]["size"].attrs["units"] == "N m"
    assert groups["a/curves/1"]["seen"].dims == ("segment", "sample")
    assert groups["a/curves/1"]["time"].attrs["units"] == "s"
    assert groups["a"].attrs["verdict"] == "some"


def test_a_field_that_must_be_there_is_missed():
    groups = dict(to_groups(FULL, "a"))
    groups["a"] = groups["a"].drop_vars("number")
    with pytest.raises(KeyError, match="number"):
        from_groups(Whole, groups, "a", workings=None)
