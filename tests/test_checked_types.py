"""What the tests check of annotations is what jaxtyping does, in less time."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
import pytest
from jaxtyping import Float, TypeCheckError

from checked_types import checked
from exoid.recordings.measured.segment import Segment
from exoid.recordings.signal.local_line import local_line

Row = Float[np.ndarray, " time"]


@checked
def added(one: Row, other: Row) -> Row:
    return np.append(one, 0.0) if one.size > 2 else one + other


def test_a_word_in_shapes_is_one_size_of_all_arguments_and_of_the_answer():
    assert added(np.zeros(2), np.ones(2)).sum() == 2.0
    for wrong in ((np.zeros(2), np.zeros(1)), (np.zeros(2, int), np.zeros(2)), (0.0, np.zeros(2))):
        with pytest.raises(TypeCheckError):
            added(*wrong)
    with pytest.raises(TypeCheckError):
        added(np.zeros(3), np.zeros(3))  # the answer has four


def test_it_may_be_another_size_in_a_call_inside():
    @checked
    def outer(row: Row) -> Row:
        added(np.zeros(1), np.zeros(1))
        return row

    assert outer(np.zeros(2)).size == 2


def inner(given: int) -> Callable[..., int]:
    @checked
    def told(rate: float) -> int:
        return given

    return told


def test_a_function_inside_another_is_its_own_each_time_and_checked():
    one, other = inner(1), inner(2)
    assert (one(0.5), other(0.5)) == (1, 2)
    with pytest.raises(TypeCheckError):
        other(1)
    with pytest.raises(TypeCheckError):
        inner("two")(0.5)


@checked
@dataclass(frozen=True)
class Drop:
    begin: "float"
    end: "Unheard | None" = None  # noqa: F821  # as what type checkers alone import


@checked
@dataclass(frozen=True)
class Late(Drop):
    """With no field of its own."""


@pytest.mark.parametrize("kind", [Drop, Late])
def test_fields_are_checked_and_what_an_unknown_name_stands_for_may_be_anything(kind):
    assert kind(0.5, "late").begin == 0.5
    with pytest.raises(TypeCheckError):
        kind(1)


def test_a_generator_is_checked_as_it_is_called():
    @checked
    def each(row: Row) -> Iterator[float]:
        yield from row

    assert list(each(np.ones(2))) == [1.0, 1.0]
    with pytest.raises(TypeCheckError):
        each(1.0)


def test_functions_and_fields_of_exoid_are_checked():
    with pytest.raises(TypeCheckError):
        local_line(0.0, np.zeros(3), 1)
    with pytest.raises(TypeCheckError):
        Segment(time="now")
