"""Runs the compiled program, and keeps it between processes.

Tracing and compiling take longer than solving. Where a folder is set, the machine code is kept
there, and the next process loads it without importing the solver.
"""

import logging
import os
import signal
import time
import warnings
from collections.abc import Callable
from contextlib import suppress
from functools import lru_cache
from pathlib import Path
from threading import Lock
from typing import TypeVar

import jax
import numpy as np
from jax.stages import Compiled
from platformdirs import user_cache_path

from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.misfit.condensed import Sensed, Triangles
from exoid.fitting.solve.compiled.kept_program import (
    KEPT,
    Known,
    alone_at,
    fingerprint,
    load,
    nameless,
    store,
)
from exoid.fitting.solve.compiled.machine_code import compiled, options
from exoid.fitting.solve.compiled.memory import give_back
from exoid.fitting.solve.cores.ahead import is_missing
from exoid.fitting.solve.meeting import MEETING, SOLVE
from exoid.fitting.solve.program_values import SENSED, TRIANGLES, Solved, solved_structure

MOST = 64  # programs in memory, 10 to 20 MB each: of the 50 to 90 of a diagnosis many run once
ABANDONED = 3600.0  # s after which nobody writes a part any more
UNREADABLE = "Error reading persistent compilation cache"  # what XLA's Python side says of it
Result = TypeVar("Result")
LOG = logging.getLogger("exoid")
_folder: list[Path] = []  # where programs are kept; empty: nowhere
_locks: dict[tuple, Lock] = {}  # one for every program: others may be compiled meanwhile


def keep_programs_in(folder: Path | None = None) -> None:
    """Keep compiled programs in `folder` from now on, by default in the user's cache.

    Whoever can write there can run code as this user. Where it cannot be made, nothing is kept, and
    every process compiles anew.

    >>> exoid.keep_programs_in()
    """
    folder = user_cache_path("exoid") / "programs" if folder is None else folder
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as fault:
        LOG.warning("programs are not kept: %s", fault)
        return
    jax.config.update("jax_compilation_cache_dir", str(folder))
    jax.config.update("jax_persistent_cache_min_compile_time_secs", 0.0)
    jax.config.update("jax_persistent_cache_min_entry_size_bytes", -1)
    _folder[:] = [folder]
    for part in folder.glob(".*.part"):  # of a process that was killed while it wrote
        with suppress(OSError):
            if part.stat().st_mtime < time.time() - ABANDONED:
                part.unlink()


def with_sound_programs(task: Callable[[], Result]) -> Result:
    """What `task` returns; where XLA cannot read what it kept, that is forgotten and it runs again.

    XLA itself would compile the same program in every process, and never replace the file.
    """
    try:
        with warnings.catch_warnings():
            warnings.filterwarnings("error", UNREADABLE)
            return task()
    except UserWarning as fault:
        if not (_folder and str(fault).startswith(UNREADABLE)):
            raise
        for kept in _folder[0].glob("*-cache"):
            kept.unlink(missing_ok=True)
        return task()


def run(starts, request, observation, known, prior, limits, task, chain: Chain) -> Solved:
    """`solve`, with NumPy arrays in and out."""
    return called(
        SOLVE,
        (starts, request, observation, known, prior, limits, task),
        chain,
        solved_structure(tuple(map(type, starts.terms))),
    )


def run_sense(point, observation, known, pushes, stage, chain: Chain) -> Sensed:
    """`sense_all`, with NumPy arrays in and out."""
    return called(
        "exoid.fitting.solve.program:sense_all",
        (point, observation, known, pushes, stage),
        chain,
        SENSED,
    )


def run_triangles(point, observation, known, nodes, stage, chain: Chain) -> Triangles:
    """`triangles_all`, with NumPy arrays in and out."""
    return called(
        "exoid.fitting.solve.program:triangles_all",
        (point, observation, known, nodes, stage),
        chain,
        TRIANGLES,
    )


def called(name: str, arguments: tuple, static, structure, *, brief: bool = False):
    """The function `module:name`, in float64 whatever JAX's default.

    `static` is its last argument, hashable and part of the program. What is `brief` is worth less
    optimising than it takes.
    """
    if (meeting := MEETING.get()) is not None and name == SOLVE:
        return meeting.ask(arguments, static, structure)
    leaves, given = jax.tree.flatten(arguments)
    leaves = [np.asarray(leaf) for leaf in leaves]
    shapes = tuple((leaf.shape, leaf.dtype.str) for leaf in leaves)
    wanted = (name, given, shapes, static, structure.num_leaves, brief)
    with jax.enable_x64(True):  # a fit in float32 would stop short of its optimum
        with _locks.setdefault(wanted, Lock()):  # of two threads that want it, one compiles it
            code = program(*wanted)
        results = code(*leaves)
    return jax.tree.unflatten(structure, [np.asarray(result) for result in results])


@lru_cache(MOST)
def program(name: str, structure, shapes, static, results: int, brief: bool = False):
    """The compiled program for these shapes: loaded, or traced, compiled and kept."""
    known = Known(name, structure, shapes, static, options(brief=brief))
    return kept(known, results, lambda: compiled(name, structure, shapes, static, brief=brief))


def leave(task: Callable[..., object], *arguments: object) -> None:
    """Do the task for the programs alone that it leaves in the folder: none stays in memory."""
    task(*arguments)
    program.cache_clear()
    give_back()


def kept(known: Known, results: int, make: Callable[[], Compiled]) -> Compiled:
    """The program that is `known` so and gives so many arrays: loaded, or made and kept.

    What it makes must have a name that no program had before (`machine_code.unheard_of`).
    """
    if not _folder or nameless(known.structure, known.static):
        return make()
    path = _folder[0] / f"{fingerprint(known)}{KEPT}"
    code = load(path, len(known.shapes), results)
    if code is not None:
        return code
    is_missing(make_more, _folder[0])
    with alone_at(path):
        code = load(path, len(known.shapes), results)
        if code is None:
            code = make()
            store(path, code)
    return code


def make_more(folder: Path) -> None:
    """Prepare a second process that makes programs: Ctrl-C is left to the one that started it, and
    what goes wrong is not said, for it will go wrong there.
    """
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    jax.config.update("jax_enable_x64", True)
    keep_programs_in(folder)
