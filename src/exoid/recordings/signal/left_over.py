"""What is left of data beside columns that are free, for many sets of columns at once."""

import numpy as np
from numpy.typing import NDArray

Table = NDArray[np.float64]


def orthonormal(columns: Table) -> Table:
    """Of every set (first axis) its columns (second, rows last), each without those before it and
    of length 1, by Gram and Schmidt; one of which nothing is left is 0.
    """
    found = np.array(columns)
    for number in range(found.shape[1]):
        one = found[:, number]
        size = np.sqrt(np.einsum("kr,kr->k", one, one))[:, None]
        one /= np.where(size > 0, size, 1.0)
        later = found[:, number + 1 :]
        later -= np.einsum("kcr,kr->kc", later, one)[..., None] * one[:, None]
    return found


def left_over(basis: Table, data: Table) -> Table:
    """The sum of squares that every `basis` (set, column, row) leaves of the data (row)."""
    along = basis @ data
    return data @ data - np.einsum("kc,kc->k", along, along)


def left_beside(basis: Table, fall: Table, data: Table) -> Table:
    """The same beside one further column, each of several in turn: (set, one)."""
    along, fallen = basis @ data, basis @ fall
    size, told = np.einsum("krl,krl->kl", fall, fall), data @ fall
    beyond = size - np.einsum("kcl,kcl->kl", fallen, fallen)
    gained = (told - np.einsum("kc,kcl->kl", along, fallen)) ** 2
    tells = beyond > 1e-10 * size  # an instant after the last sample tells nothing
    gained = np.where(tells, gained / np.where(tells, beyond, 1.0), 0.0)
    return left_over(basis, data)[:, None] - gained
