"""A frozen dataclass comes back from JSON and from netCDF as it was, whatever its fields are."""

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields, is_dataclass, make_dataclass, replace
from enum import Enum
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal

import equinox as eqx
import hypothesis.strategies as st
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from diagnosis_by_hand import found
from hypothesis import given, settings
from jaxtyping import Array, Bool, Float, Int
from test_fit_json import fitted
from test_saved_result import ODD, check_same, plainly, rich, told

from exoid.fitting.errors.posterior import Posterior
from exoid.fitting.result.fit_result import FitResult
from exoid.pendulum.drop import Average
from exoid.physics.library import library
from exoid.physics.parameter import declarations, parameter
from exoid.physics.term import PhysicsTerm, SensorTerm, Term
from exoid.recordings.landmarks.measure import Mark, Measure
from exoid.report.saved.document import from_json, read, to_json, write
from exoid.report.saved.node import DocumentError
from exoid.report.saved.saved_result import SavedResult


class Side(Enum):
    left = -1
    right = 1


@dataclass(frozen=True)
class Place:
    angle: Annotated[float, "rad"]
    name: str = ""


@dataclass(frozen=True)
class Row:
    words: list[str]
    place: Place | None
    count: int
    held: bool
    size: Annotated[float | None, "N m"] = None
    note: str | None = None


@dataclass(frozen=True, eq=False)
class Curve:
    time: Annotated[Float[np.ndarray, " time"], "s"]
    seen: Bool[np.ndarray, "segment time"]
    square: Float[np.ndarray, "time time"] | None
    ticks: Int[np.ndarray, " tick"] = field(default_factory=lambda: np.zeros(0, np.uint16))


@dataclass(frozen=True, eq=False)
class Whole:
    number: Annotated[float, "kg m^2"]
    absent: float | None
    verdict: Literal["none", "some"]
    side: Side | None
    held: bool
    count: int
    path: Path
    each: tuple[str, ...]
    pair: tuple[float, str | None]
    either: float | str | list[int] | Place | Curve | None
    known: dict[str, float]
    ranges: Mapping[str, tuple[float, float]]
    settings: Mapping[str, Any]
    rows: list[Row]
    by_name: dict[str, Row]
    within: dict[str, dict[str, Row]]
    arrays: dict[str, Float[np.ndarray, "..."] | None]
    curves: tuple[Curve, ...]
    curve: Curve | None
    workings: Any = field(default=None, metadata={"saved": False})


words = st.text(st.characters(exclude_categories=()), max_size=8)
plain = st.text(st.characters(categories=("L", "N")), max_size=8)
numbers = st.floats(allow_nan=True, allow_infinity=True, width=64)
whole_numbers = st.integers() | st.sampled_from([2**63 - 1, 2**63, -(2**63)])
places = st.builds(Place, numbers, words)
rows = st.builds(
    Row,
    st.lists(words, max_size=2),
    st.none() | places,
    whole_numbers,
    st.booleans(),
    st.none() | numbers,
    st.none() | words,
)
anything = st.recursive(
    st.none() | st.booleans() | whole_numbers | numbers | words,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(words, inner, max_size=3),
    max_leaves=6,
)


@st.composite
def curves(draw):
    size = draw(st.integers(0, 4))
    time = np.resize(np.array(draw(st.lists(numbers, min_size=1, max_size=5))), size)
    seen = np.resize([True, False, True], (draw(st.integers(0, 2)), size))
    square = draw(st.none() | st.just(np.resize(time, (size, size)) if size else np.zeros((0, 0))))
    return Curve(time, seen, square, draw(st.just(np.arange(size, dtype=np.uint16))))


arrays = st.none() | st.builds(
    lambda shape, dtype: np.resize(np.array(ODD, dtype), shape),
    st.lists(st.integers(0, 3), max_size=3).map(tuple),
    st.sampled_from(["f4", "f8"]),
)
wholes = st.builds(
    Whole,
    number=numbers,
    absent=st.none() | numbers,
    verdict=st.sampled_from(["none", "some"]),
    side=st.none() | st.sampled_from(Side),
    held=st.booleans(),
    count=whole_numbers,
    path=plain.map(Path),
    each=st.lists(words, max_size=2).map(tuple),
    pair=st.tuples(numbers, st.none() | words),
    either=st.none() | numbers | words | st.lists(whole_numbers) | places | curves(),
    known=st.dictionaries(words, numbers, max_size=3),
    ranges=st.dictionaries(words, st.tuples(numbers, numbers), max_size=2),
    settings=st.dictionaries(words, anything, max_size=3),
    rows=st.lists(rows, max_size=3),
    by_name=st.dictionaries(words, rows, max_size=3),
    within=st.dictionaries(words, st.dictionaries(words, rows, max_size=2), max_size=2),
    arrays=st.dictionaries(words | st.sampled_from(["in", "NAME", "..", "_x"]), arrays, max_size=3),
    curves=st.lists(curves(), max_size=3).map(tuple),
    curve=st.none() | curves(),
)


def same(one, other, where="document"):
    """Bit for bit; a number that is none has no other bits in JSON."""
    if isinstance(one, float) and one != one:
        assert isinstance(other, float), where
        assert other != other, where
    elif isinstance(one, dict) and isinstance(other, dict):
        assert list(one) == list(other), where
        for name, each in one.items():
            same(each, other[name], f"{where}.{name}")
    elif isinstance(one, list | tuple):
        assert (type(one), len(one)) == (type(other), len(other)), where
        for number, pair in enumerate(zip(one, other, strict=True)):
            same(*pair, f"{where}[{number}]")
    elif isinstance(one, np.ndarray):
        assert (one.dtype, one.shape) == (other.dtype, other.shape), where
        np.testing.assert_array_equal(one, other)
        number = one == one  # JSON keeps no sign of what is no number
        signs = np.array_equal(np.signbit(one[number]), np.signbit(other[number]))
        assert signs or one.dtype.kind != "f", where
    elif is_dataclass(one) and not isinstance(one, type):
        assert type(one) is type(other), where
        for each in fields(one):
            same(getattr(one, each.name), getattr(other, each.name), f"{where}.{each.name}")
    else:
        assert type(one) is type(other), where
        assert repr(one) == repr(other), where


def by_netcdf(one, path, **how):
    write(one, path / "one.nc")
    return read(type(one), path / "one.nc", **how)


def by_json(one, **how):
    text = to_json(one)
    json.loads(text, parse_constant=lambda word: pytest.fail(f"{word} is no JSON"))
    return from_json(type(one), text, **how)


@settings(max_examples=60)
@given(one=wholes)
def test_whatever_the_fields_hold_comes_back(tmp_path_factory, one):
    same(one, by_netcdf(one, tmp_path_factory.mktemp("any")))
    same(one, by_json(one))


def test_what_is_not_saved_takes_its_default(tmp_path):
    made = Curve(np.array([1.0]), np.ones((1, 1), bool), None)
    one = make_dataclass("One", [("curve", Curve), ("workings", Any, WORKINGS)], frozen=True)
    assert by_netcdf(one(made, object()), tmp_path).workings is None


WORKINGS = field(default=None, metadata={"saved": False})


@dataclass(frozen=True, eq=False)
class Twice:
    first: Curve
    again: Curve
    fits: dict[str, FitResult]


def test_what_is_one_stays_one(tmp_path):
    curve, fit = Curve(np.array(ODD), np.ones((2, 6), bool), None), plainly(fitted())
    one = Twice(curve, curve, {"before": fit, "after": fit})
    alone = to_json(replace(one, fits={}))
    assert len(to_json(one)) < len(alone) + 1.1 * len(to_json(fit))
    for back in (by_netcdf(one, tmp_path), by_json(one)):
        assert back.first is back.again
        assert back.fits["before"] is back.fits["after"]
        check_same(one, back)


@dataclass(frozen=True)
class Model:
    terms: tuple[PhysicsTerm | SensorTerm, ...]
    best: Term | None = None


def values(of) -> Any:
    """A term whose parameters are odd: NumPy's and JAX's."""
    each = [np.float64(ODD[0]), jnp.asarray(ODD[3]), np.asarray(ODD[2])]
    return of(*np.resize(np.array(each, dtype=object), len(list(declarations(of)))))


def test_every_term_of_the_library_comes_back(tmp_path):
    one = Model(tuple(values(each) for each in library()))
    for back in (by_netcdf(one, tmp_path), by_json(one)):
        assert [type(each) for each in back.terms] == list(library())
        assert eqx.tree_equal(one.terms, back.terms)


class Gravel(PhysicsTerm):
    """A user's own: tau = -level."""

    title: ClassVar[str] = "gravel"
    reference: ClassVar[str] = "none"
    explanation: ClassVar[str] = "There is gravel."
    isolate: ClassVar[str] = "look"

    level: Float[Array, ""] = parameter("g", "N m", 0.0, 1.0, "level", (0.1,))

    def torque(self, now, memory):
        return -self.level


def test_a_term_of_ones_own_comes_back_by_its_class_alone(tmp_path):
    one = Model((Gravel(jnp.asarray(ODD[0])),), Gravel(jnp.asarray(ODD[3])))
    for back in (by_netcdf(one, tmp_path, own=(Gravel,)), by_json(one, own=(Gravel,))):
        assert type(back.best) is Gravel
        assert isinstance(back.best.level, jax.Array)
        assert eqx.tree_equal(one, back)
    with pytest.raises(DocumentError, match=r"class Gravel, which exoid does not have.*--terms"):
        by_json(one)


@dataclass(frozen=True, eq=False)
class Richer:
    """A result of later days: with fits inside a diagnosis, and terms."""

    saved: SavedResult
    before: FitResult
    after: FitResult
    terms: tuple[PhysicsTerm | SensorTerm, ...] = ()
    found: dict[str, Measure] = field(default_factory=dict)


def test_a_new_field_needs_no_new_line(tmp_path):
    fit = plainly(rich())
    whole = SavedResult(
        fit, told(), "0", [], {"seed": 1}, diagnosis=replace(found(), before=fit, advice=[])
    )
    one = Richer(whole, fit, plainly(fitted()), (values(library()[0]), values(library()[-1])))
    for back in (by_netcdf(one, tmp_path), by_json(one)):
        check_same(replace(one, terms=()), replace(back, terms=()))
        assert back.before is back.saved.result
        assert back.saved.diagnosis is not None
        assert back.before is back.saved.diagnosis.fit
        assert eqx.tree_equal(one.terms, back.terms)


def test_draws_and_measures_come_back(tmp_path):
    draws = np.resize(ODD, (2, 5))
    one = Posterior({"J": draws, "a[0]": -draws}, {"J": "kg m^2"}, draws > 1, draws)
    check_same(one, by_netcdf(one, tmp_path))
    check_same(one, by_json(one))
    marks = (Mark(3, ODD[0], -0.0), Mark(4, 1.0, np.inf))
    measures = Measures(
        {"a": Measure("a", "A", "a_1", "rad", ODD[0], None, marks), "b": Measure("b", "", "", "")},
        [Average("a", "A", "a_1", "rad", ODD[0], None, ("0", "1"))],
    )
    check_same(measures, by_netcdf(measures, tmp_path))
    check_same(measures, by_json(measures))


@dataclass(frozen=True)
class Measures:
    each: dict[str, Measure]
    average: Sequence[Average]


def test_a_person_finds_numbers_units_and_axes(tmp_path):
    import xarray

    curve = Curve(np.array(ODD), np.ones((2, 6), bool), np.ones((6, 6)))
    one = make_dataclass("One", [("rows", list[Row]), ("curves", dict[str, Curve])], frozen=True)
    row = Row(["p"], Place(0.5, "here"), 3, True, None, "said")
    write(one([row, replace(row, place=None)], {"bare": curve}), tmp_path / "one.nc")
    with xarray.open_datatree(tmp_path / "one.nc") as tree:
        table, shown = tree["rows"].to_dataset(), tree["curves/bare"].to_dataset()
        assert table["place.angle"].attrs["units"] == "rad"
        assert table["place"].values.tolist() == [True, False]
        assert table["note"].values.tolist() == ["said", "said"]
        assert np.isnan(table["size"]).all()
        assert shown["time"].attrs["units"] == "s"
        assert shown["seen"].dims == ("segment", "time")
        assert shown["square"].dims == ("time", "other_time")


def test_documents_of_other_fields_and_damaged_ones_are_refused():
    one, other = (make_dataclass("One", [(name, float)], frozen=True) for name in ("old", "new"))
    with pytest.raises(DocumentError, match=r"saved by exoid \S+, with other fields .*: /new\."):
        from_json(other, to_json(one(1.0)))
    later = make_dataclass("One", [("old", float), ("new", float, 2.0)], frozen=True)
    assert from_json(later, to_json(one(1.0))).new == 2.0
    with pytest.raises(DocumentError, match="damaged, or was changed"):
        from_json(one, to_json(one(1.5)).replace("1.5", "1.25"))
    with pytest.raises(DocumentError, match="this is no result that was saved"):
        from_json(one, "[]")


def test_a_byte_that_is_another_in_json_is_refused_or_says_the_same():
    """Only the case of a letter within a number says nothing."""
    one, generator, refusals = plainly(fitted()), np.random.default_rng(6), []
    content = to_json(one).encode()
    for place in generator.integers(0, len(content), 200):
        damaged = bytearray(content)
        damaged[place] ^= 1 << int(generator.integers(0, 8))
        try:
            back = from_json(FitResult, bytes(damaged))
        except DocumentError as fault:
            refusals.append(str(fault))
        else:
            check_same(one, back)
    assert len(refusals) > 190
    assert not [each for each in refusals if "\n" in each]


def test_what_no_file_keeps_is_named():
    for hint, value in ((Any, object()), (np.ndarray, np.array([1j])), (dict[int, str], {1: "a"})):
        one = make_dataclass("One", [("field", hint)], frozen=True)
        with pytest.raises(DocumentError, match=r"^/field: "):
            to_json(one(value))
