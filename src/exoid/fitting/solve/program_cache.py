"""Runs the compiled program, and keeps it between processes.

Tracing the solver takes longer than solving. Where a folder is set, the traced program is kept
there (StableHLO, by jax.export) beside XLA's own compilation cache, and the next process loads
both without importing the solver.
"""

import hashlib
import inspect
import logging
import platform
import time
import warnings
from collections.abc import Callable
from contextlib import suppress
from functools import cache, lru_cache
from importlib import import_module
from importlib.metadata import version
from pathlib import Path
from threading import Lock
from typing import Any, TypeVar

import equinox as eqx
import jax
import jax.export
import numpy as np
from platformdirs import user_cache_path

from exoid.files.replacing import begun
from exoid.fitting.data.conditioning_chain import Chain
from exoid.fitting.misfit.condensed import Sensed
from exoid.fitting.solve.meeting import ASKED_TOGETHER, MEETING
from exoid.fitting.solve.memory import give_back
from exoid.fitting.solve.program_values import SENSED, Solved, solved_structure

SHOWING = ("cli", "studies", "report", "watching")  # rooms above every program: none imports them
LIBRARIES = ("jax", "jaxlib", "equinox", "lineax", "optimistix")  # whose code is in a program
# How far XLA optimises: as fast machine code as by default, and half as long to wait for it.
LEAN = {"xla_backend_optimization_level": 1, "xla_cpu_use_fusion_emitters": False}
BRIEF = LEAN | {"xla_backend_optimization_level": 0}  # compiled twice as soon, for what hardly runs
MOST = 64  # programs in memory, 10 to 20 MB each: of the 50 to 90 of a diagnosis many run once
ABANDONED = 3600.0  # s after which nobody writes a part any more
DIGEST = 32  # bytes of the checksum before a kept program
UNREADABLE = "Error reading persistent compilation cache"  # what XLA's Python side says of it
Result = TypeVar("Result")
LOG = logging.getLogger("exoid")
_folder: list[Path] = []  # where programs are kept; empty: nowhere
_locks: dict[tuple, Lock] = {}  # one for every program: others may be compiled meanwhile


def keep_programs_in(folder: Path | None = None) -> None:
    """Keep traced and compiled programs in `folder` from now on, by default in the user's cache.

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
        "exoid.fitting.solve.program:solve",
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


def called(name: str, arguments: tuple, static, structure, *, brief: bool = False):
    """The function `module:name`, in float64 whatever JAX's default.

    `static` is its last argument, hashable and part of the program. What is `brief` is worth less
    optimising than it takes.
    """
    if (meeting := MEETING.get()) is not None and name in ASKED_TOGETHER:
        return meeting.ask(name, arguments, static, structure)
    leaves, given = jax.tree.flatten(arguments)
    shapes = tuple(jax.ShapeDtypeStruct(np.shape(leaf), np.result_type(leaf)) for leaf in leaves)
    wanted = (name, given, shapes, static, brief)
    with jax.enable_x64(True):  # a fit in float32 would stop short of its optimum
        with _locks.setdefault(wanted, Lock()):  # of two threads that want it, one compiles it
            code = program(*wanted)
        results = code(*map(np.asarray, leaves))
    return jax.tree.unflatten(structure, [np.asarray(result) for result in results])


@lru_cache(MOST)
def program(name: str, structure, shapes, static, brief: bool = False):
    """The compiled program for these shapes: loaded, or traced and kept.

    A class typed into a notebook has no file by which a later program could know it again.
    """
    options = understood(brief=brief)
    if not _folder or None in own_sources((static, *classes(structure))):
        found = jax.jit(traceable(name, structure, static), compiler_options=options)
        return compiled(found, shapes)
    path = _folder[0] / f"{fingerprint(name, structure, shapes, static)}.stablehlo"
    exported = load(path)
    if exported is None:
        exported = jax.export.export(jax.jit(traceable(name, structure, static)))(*shapes)
        store(path, exported.serialize())
    return compiled(jax.jit(exported.call, compiler_options=options), shapes)


def compiled(found, shapes):
    """The machine code; what compiling took of memory goes back to the system."""
    code = found.lower(*shapes).compile()
    give_back()
    return code


@cache
def understood(*, brief: bool) -> dict[str, Any]:
    """The options, where they are for this machine and this version of XLA knows them."""
    if jax.default_backend() != "cpu":
        return {}
    options = BRIEF if brief else LEAN
    try:
        jax.jit(lambda: np.zeros(()), compiler_options=options).lower().compile()
    except jax.errors.JaxRuntimeError:
        return {}
    return options


def traceable(name: str, structure, static):
    """The function on bare arrays. Its module is imported here, only where it must be traced."""
    module, _, attribute = name.partition(":")
    function = getattr(import_module(module), attribute)

    def flat(*leaves):
        return jax.tree.leaves(function(*jax.tree.unflatten(structure, leaves), static))

    return flat


def fingerprint(name: str, structure, shapes, static) -> str:
    """What a kept program depends on: its code, its shapes, its libraries and its platform."""
    digest = hashlib.sha256(code_of(Path(__file__).parents[2]))
    for path in sorted(path for path in own_sources((static, *classes(structure))) if path):
        digest.update(path.read_bytes())
    words = (name, platform.machine(), jax.default_backend(), str(structure), shapes, static)
    digest.update(repr((*map(version, LIBRARIES), *words)).encode())
    return digest.hexdigest()[:32]


def classes(structure) -> set[type]:
    """The models in a tree: a user's own terms are in the program."""
    data = structure.node_data()
    own = {data[0]} if data and issubclass(data[0], eqx.Module) else set()
    return own.union(*(classes(child) for child in structure.children()))


@cache
def code_of(home: Path) -> bytes:
    """The checksum of the code in the folder `home` on which a program's numbers can depend."""
    return hashlib.sha256(b"".join(path.read_bytes() for path in sources(home))).digest()


def sources(home: Path) -> list[Path]:
    """All of exoid's files but those that show what was computed."""
    found = home.rglob("*.py")
    return sorted(path for path in found if path.relative_to(home).parts[0] not in SHOWING)


def own_sources(static) -> set[Path | None]:
    """The files of classes in `static` that do not come with exoid: they are in the program.

    None stands for a class that has no file.
    """
    if isinstance(static, tuple):
        return {path for part in static for path in own_sources(part)}
    if not isinstance(static, type) or static.__module__.partition(".")[0] == "exoid":
        return set()
    try:
        return {Path(inspect.getfile(static))}
    except (OSError, TypeError):
        return {None}


def load(path: Path) -> jax.export.Exported | None:
    """The kept program, or None where there is none, or one that is not whole."""
    try:
        content = path.read_bytes()
    except OSError:
        return None
    if hashlib.sha256(content[DIGEST:]).digest() != content[:DIGEST]:
        return None
    return jax.export.deserialize(bytearray(content[DIGEST:]))


def store(path: Path, content: bytes | bytearray) -> None:
    """Write in one piece, so that two processes at once do not disturb each other."""
    try:
        part = begun(path)
        try:
            part.write_bytes(hashlib.sha256(content).digest() + content)
            part.replace(path)
        finally:
            part.unlink(missing_ok=True)
    except OSError as fault:  # a full disk: the next process traces anew
        LOG.warning("a program is not kept: %s", fault)
