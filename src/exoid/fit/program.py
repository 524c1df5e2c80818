"""Runs the compiled program, and keeps it between processes.

Tracing the solver takes longer than solving. Where a folder is set, the traced program is kept
there (StableHLO, by jax.export) beside XLA's own compilation cache, and the next process loads
both without importing the solver.
"""

import hashlib
import os
import platform
from functools import cache
from pathlib import Path

import jax
import jax.export
import numpy as np

from exoid.fit.chain import Chain
from exoid.fit.task import Solved, solved_structure

SOURCES = ("fit", "physics")  # folders whose code is in the program
_folder: list[Path] = []  # where programs are kept; empty: nowhere


def keep_programs_in(folder: Path) -> None:
    """Keep traced and compiled programs in `folder` from now on. Others must not write there."""
    folder.mkdir(parents=True, exist_ok=True)
    jax.config.update("jax_compilation_cache_dir", str(folder))
    jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.0)
    jax.config.update("jax_persistent_cache_min_entry_size_bytes", -1)
    _folder[:] = [folder]


def run(starts, observation, known, prior, limits, task, chain: Chain) -> Solved:
    """`solve`, with NumPy arrays in and out, in float64 whatever JAX's default."""
    arguments = (starts, observation, known, prior, limits, task)
    leaves, structure = jax.tree.flatten(arguments)
    shapes = tuple(jax.ShapeDtypeStruct(np.shape(leaf), np.result_type(leaf)) for leaf in leaves)
    with jax.enable_x64(True):  # a fit in float32 would stop short of its optimum
        results = program(structure, shapes, chain)(*leaves)
    return jax.tree.unflatten(solved_structure(), [np.asarray(result) for result in results])


@cache
def program(structure, shapes, chain: Chain):
    """The compiled program for these shapes: loaded, or traced and kept."""
    if not _folder:
        return jax.jit(traceable(structure, chain))
    path = _folder[0] / f"{fingerprint(shapes, chain)}.stablehlo"
    exported = load(path)
    if exported is None:
        exported = jax.export.export(jax.jit(traceable(structure, chain)))(*shapes)
        store(path, exported.serialize())
    return jax.jit(exported.call)


def traceable(structure, chain: Chain):
    """`solve` on bare arrays. The solver is imported here, only where it must be traced."""
    from exoid.fit.solve import solve

    def flat(*leaves):
        return jax.tree.leaves(solve(*jax.tree.unflatten(structure, leaves), chain))

    return flat


def fingerprint(shapes, chain: Chain) -> str:
    """What a kept program depends on: its code, its shapes, its library and its platform."""
    digest = hashlib.sha256()
    for folder in SOURCES:
        for path in sorted((Path(__file__).parents[1] / folder).glob("**/*.py")):
            digest.update(path.read_bytes())
    words = (jax.__version__, platform.machine(), jax.default_backend(), shapes, chain)
    digest.update(repr(words).encode())
    return digest.hexdigest()[:32]


def load(path: Path):
    """The kept program, or None where there is none that can be read."""
    try:
        return jax.export.deserialize(bytearray(path.read_bytes()))
    except FileNotFoundError:
        return None
    except (ValueError, OSError, AttributeError, IndexError):  # cut short, or another version's
        return None


def store(path: Path, content: bytes) -> None:
    """Write in one piece, so that two processes at once do not disturb each other."""
    part = path.with_suffix(f".{os.getpid()}.part")
    part.write_bytes(content)
    part.replace(path)
