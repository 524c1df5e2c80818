"""What is left of data beside columns that are free, for many sets of columns at once."""

import numpy as np
from numpy.typing import NDArray

Table = NDArray[np.float64]


def orthonormal(columns: Table) -> Table:
    """Of every set (first axis) its columns (second, rows last), each without those before it and
    of length 1, by Gram and Schmidt and in place; one of which nothing is left is 0.
    """
    for number in range(columns.shape[1]):
        one = columns[:, number]
        size = np.sqrt(np.einsum("kr,kr->k", one, one))[:, None]
        one /= np.where(size > 0, size, 1.0)
        later = columns[:, number + 1 :]
        later -= np.einsum("kcr,kr->kc", later, one)[..., None] * one[:, None]
    return columns


def beside(columns: Table, shared: Table) -> Table:
    """The columns (set, column, row) without what is along an orthonormal basis (one, row) that all
    sets share, in place.
    """
    flat = columns.reshape(-1, columns.shape[-1])
    flat -= (flat @ shared.T) @ shared
    return columns


def left_beside(basis: Table, shared: Table, fall: Table, data: Table) -> Table:
    """The sum of squares that every `basis` (set, column, row) and the rows that all sets have
    `shared` leave of the data (row), beside one further column, each of several in turn (set, row,
    one): (set, one). All but the further columns are beside what is shared already.
    """
    along = (basis.reshape(-1, data.size) @ data).reshape(basis.shape[:2])
    fallen, told = basis @ fall, data @ fall
    size = np.einsum("krl,krl->kl", fall, fall)
    beyond = size - np.einsum("kcl,kcl->kl", fallen, fallen)
    for each in shared:
        beyond -= (each @ fall) ** 2
    gained = (told - np.einsum("kc,kcl->kl", along, fallen)) ** 2
    tells = beyond > 1e-10 * size  # an instant after the last sample tells nothing
    gained = np.where(tells, gained / np.where(tells, beyond, 1.0), 0.0)
    return (data @ data - np.einsum("kc,kc->k", along, along))[:, None] - gained
