"""`step` and `replay`: samples as they come, or a whole recording, by one and the same program.

Machine code that was compiled for one sample need not round as that for many does. So there is one
program, for a block of which any number of rows may be filled: a live stream and its replay give
the same to the last bit.
"""

from dataclasses import fields, replace
from functools import cache, partial
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
from jaxtyping import Float

from exoid.fitting.solve.compiled.kept_program import Known
from exoid.fitting.solve.compiled.machine_code import machine_code
from exoid.fitting.solve.program_cache import kept
from exoid.online.belief import DEFAULT, Belief, form
from exoid.online.filter.pack import Form
from exoid.online.model.model import Model, Node
from exoid.online.model.sample import Sample
from exoid.online.one_kernel import OPTIONS, one_kernel
from exoid.online.outlook import Outlook
from exoid.online.take_in import take_in

BLOCK = 32  # samples: calling a program costs as much as a few


def step(belief: Belief, sample: Sample, model: Model = DEFAULT) -> tuple[Belief, Outlook]:
    """The belief after one more sample, and what it says. `belief` itself stays as it is.

    The first call compiles, for some seconds.

    >>> belief = online.init(exoid.expected_leg(77.0, 1.80))
    >>> belief, outlook = online.step(belief, online.Sample(0.0, -0.35, 0.01))
    >>> outlook.said.words
    'waiting for a free movement'
    """
    rows = np.zeros((BLOCK, len(FIELDS)))
    rows[0] = [getattr(sample, name) for name in FIELDS]
    after, outlooks = run(model, belief, rows, 1)
    return after, row_of(outlooks, 0)


def replay(belief: Belief, samples: Sample, model: Model = DEFAULT) -> tuple[Belief, Outlook]:
    """`step` after `step`: `samples` has arrays, and so has the outlook.

    >>> time = np.arange(200) * 0.01  # s
    >>> held = online.Sample(time, np.full(200, -0.35), np.zeros(200))
    >>> belief, outlook = online.replay(online.init(exoid.expected_leg(77.0, 1.80)), held)
    >>> outlook.trust.shape
    (200,)
    """
    every = np.stack(np.broadcast_arrays(*(getattr(samples, name) for name in FIELDS)), axis=1)
    found = []
    for first in range(0, len(every), BLOCK):
        rows = np.zeros((BLOCK, len(FIELDS)))
        part = every[first : first + BLOCK]
        rows[: len(part)] = part
        belief, outlooks = run(model, belief, rows, len(part))
        found.append(outlooks[: len(part)])
    return belief, row_of(np.concatenate(found), slice(None))


FIELDS = [each.name for each in fields(Sample)]
SAID = [each.name for each in fields(Outlook)]
WIDTHS = {"ratios": 3, "errors": 3, "if_slack": 3}  # columns of an outlook; of the others 1
COUNTED = [np.asarray(count) for count in range(BLOCK + 1)]
RESULTS = 2  # the belief, and what was said
NO_TREE = jax.tree.structure(())  # of its arguments, which are bare arrays
COUNTS = ("trust", "phase", "drops", "rests", "late")


def run(
    model: Model, belief: Belief, rows: Float[np.ndarray, "row 6"], count: int
) -> tuple[Belief, Float[np.ndarray, "row column"]]:
    """The belief after the first `count` rows, and what it said after each."""
    with jax.enable_x64(True):
        after, outlooks = program(without_sensing(model))(belief.numbers, rows, COUNTED[count])
    return Belief(after), np.asarray(outlooks)


def without_sensing(model: Model) -> Model:
    """What a program is compiled for: how samples scatter, a belief says."""
    node, kept = model.node, ("tilt", "slant", "clock", "clock_declared", "gyro")
    return replace(model, node=Node(**{name: getattr(node, name) for name in kept}))


@cache
def program(model: Model):
    """The compiled program of a model, which takes a belief of any leg; kept between processes."""
    static = (model, *model.unknowns.terms)
    known = Known("exoid.online.program:block", NO_TREE, shapes_of(model), static, OPTIONS)
    return kept(known, RESULTS, partial(compiled, model))


def shapes_of(model: Model):
    """Of belief, rows and how many of them are filled."""
    size = sum(leaf.size for leaf in form(model).leaves)
    return ((size,), "float64"), ((BLOCK, len(FIELDS)), "float64"), ((), "int64")


def compiled(model: Model):
    """The program, traced and compiled anew."""
    with jax.enable_x64(True):
        return machine_code(one_kernel(partial(block, model)), shapes_of(model))


def block(model: Model, numbers: Any, rows: Any, count: Any):
    """The rows that are filled, one after the other."""
    inside = Form(form(model).unpacked((numbers,)))

    def one(index, state):
        now, said = inside.unpacked(state[:-1]), state[-1]
        after, outlook = take_in(model, now, rows[index])
        columns = [jnp.ravel(jnp.asarray(getattr(outlook, name), float)) for name in SAID]
        return *inside.packed(after), said.at[index].set(jnp.concatenate(columns))

    width = sum(WIDTHS.get(name, 1) for name in SAID)
    begun = inside.packed(form(model).unpacked((numbers,)))
    ended = jax.lax.fori_loop(0, count, one, (*begun, jnp.zeros((BLOCK, width))))
    return form(model).packed(inside.unpacked(ended[:-1]))[0], ended[-1]


def row_of(outlooks: Float[np.ndarray, "row column"], at: int | slice) -> Outlook:
    """The outlook of a row, or of several."""
    found, column = {}, 0
    for name in SAID:
        width = WIDTHS.get(name, 1)
        values = outlooks[at, column : column + width]
        values = values if name in WIDTHS else values[..., 0]
        found[name] = values.astype(int) if name in COUNTS else values
        column += width
    return Outlook(**found)
