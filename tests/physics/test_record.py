"""Records are trees to JAX, and plain frozen values to everybody else."""

from dataclasses import FrozenInstanceError, field, replace

import jax
import numpy as np
import pytest

from exoid.physics.record import record


@record
class Pair:
    """Two branches and a word that is part of the structure."""

    first: object
    second: object = None
    word: str = field(default="a", metadata={"static": True})


def test_branches_are_changed_and_what_is_static_stays():
    doubled = jax.tree.map(lambda leaf: 2 * leaf, Pair(np.ones(2), Pair(3.0, 4.0), "b"))
    assert (doubled.first == 2.0).all()
    assert (doubled.second.first, doubled.second.second, doubled.word) == (6.0, 8.0, "b")
    assert jax.tree.structure(Pair(1.0, 2.0)) != jax.tree.structure(Pair(1.0, 2.0, "b"))


def test_a_program_takes_and_gives_them():
    found = jax.jit(lambda pair: replace(pair, first=pair.first + pair.second))(Pair(1.0, 2.0))
    assert (float(found.first), float(found.second)) == (3.0, 2.0)


def test_a_leaf_is_found_by_its_name():
    ((path, _),) = jax.tree_util.tree_flatten_with_path(Pair(1.0))[0]
    assert jax.tree_util.keystr(path) == ".first"


def test_nobody_changes_one():
    with pytest.raises(FrozenInstanceError):
        Pair(1.0).first = 2.0  # type: ignore[misc]
