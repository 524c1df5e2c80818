"""A compiled program in a file: what it is known by, and how it is written and read."""

import hashlib
import inspect
import logging
import os
import platform
import sys
import zlib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import cache
from importlib.metadata import version
from operator import attrgetter
from pathlib import Path
from typing import Any, NamedTuple

import equinox as eqx
import jax
import numpy as np
from filelock import FileLock
from jax.experimental import serialize_executable
from jaxlib.xla_client import get_topology_for_devices

from exoid.files.replacing import begun
from exoid.fitting.solve.compiled.machine_code import processor

SHOWING = ("cli", "studies", "report", "watching")  # rooms above every program: none imports them
LIBRARIES = ("jax", "jaxlib", "equinox", "lineax", "optimistix")  # whose code is in a program
KEPT = ".program"  # how its file ends
PATIENCE = 120.0  # s, longer than a busy machine takes for a program
DIGEST = 32  # bytes of the checksum before a kept program
QUICKLY = 1  # how far machine code is packed: to a third, in no time
LOG = logging.getLogger("exoid")


class Known(NamedTuple):
    """What tells a program from others: `static` is what it is made for besides its arguments."""

    name: str
    structure: Any  # of its arguments
    shapes: tuple
    static: Any
    options: Mapping[str, Any]  # of the compiler


def fingerprint(known: Known) -> str:
    """What a kept program depends on: its code, its shapes, its libraries, the machine and the
    compiler's options.
    """
    name, structure, shapes, static, options = known
    digest = hashlib.sha256(code_of(Path(__file__).parents[3]))
    for path in sorted(path for path in own_sources((static, *classes(structure))) if path):
        digest.update(path.read_bytes())
    words = (name, str(structure), shapes, static, sorted(options.items()))
    digest.update(repr((machine(), libraries(), *words)).encode())
    return digest.hexdigest()[:32]


def nameless(structure, static) -> bool:
    """Is a class in it that no later process could know again, as one typed into a notebook?"""
    return None in own_sources((static, *classes(structure)))


@cache
def libraries() -> tuple[str, ...]:
    """Their versions."""
    return tuple(map(version, LIBRARIES))


@cache
def machine() -> tuple[str, ...]:
    """What of this machine is in machine code: its kind, what its processor can, and what XLA was
    told.
    """
    devices = processor().client.devices()
    try:
        own = str(get_topology_for_devices(devices).fingerprint())
    except jax.errors.JaxRuntimeError:  # of a kind of device that XLA cannot describe
        own = devices[0].device_kind
    return platform.machine(), devices[0].platform, own, os.environ.get("XLA_FLAGS", "")


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

    None stands for a class that has no file, or that its module has not by its name: one made while
    a program runs, as a formula is, of which the next may be another.
    """
    if isinstance(static, tuple):
        return {path for part in static for path in own_sources(part)}
    if not isinstance(static, type):
        return set()
    if not known_again(static):
        return {None}
    if static.__module__.partition(".")[0] == "exoid":
        return set()
    try:
        return {Path(inspect.getfile(static))}
    except (OSError, TypeError):
        return {None}


def known_again(static: type) -> bool:
    """Has its module the class by its name?"""
    try:
        return attrgetter(static.__qualname__)(sys.modules[static.__module__]) is static
    except (AttributeError, KeyError):
        return False


def load(path: Path, arguments: int, results: int) -> jax.stages.Compiled | None:
    """The kept program of so many arrays, or None where there is none, or one that is not whole, or
    that XLA cannot read.
    """
    try:
        content = path.read_bytes()
    except OSError:
        return None
    if hashlib.sha256(content[DIGEST:]).digest() != content[:DIGEST]:
        return None
    given, made = jax.tree.structure(((0,) * arguments, {})), jax.tree.structure([0] * results)
    with_linear_algebra()
    try:
        code = zlib.decompress(content[DIGEST:])
        device = processor()
        return serialize_executable.deserialize_and_load(code, given, made, device.client, [device])
    except jax.errors.JaxRuntimeError:
        return None


@cache
def with_linear_algebra() -> None:
    """Have JAX find LAPACK, which it does where it lowers a call of it: machine code that is loaded
    calls it as well.
    """
    with jax.default_device(processor()):
        jax.jit(jax.lax.linalg.cholesky).lower(jax.ShapeDtypeStruct((1, 1), np.float32))


@contextmanager
def alone_at(path: Path) -> Iterator[None]:
    """No other process makes the program at `path` meanwhile. In a folder that cannot be locked, or
    where another one stands still, one may: then it is made twice.
    """
    lock = FileLock(path.with_suffix(".lock"))
    with suppress(OSError, NotImplementedError):  # a time-out is the first of them, too
        lock.acquire(timeout=PATIENCE)
    try:
        yield
    finally:
        lock.release()
        with suppress(OSError):
            path.with_suffix(".lock").unlink()


def store(path: Path, code: jax.stages.Compiled) -> None:
    """Write in one piece, so that two processes at once do not disturb each other."""
    content = zlib.compress(serialize_executable.serialize(code)[0], QUICKLY)
    try:
        part = begun(path)
        try:
            part.write_bytes(hashlib.sha256(content).digest() + content)
            part.replace(path)
        finally:
            part.unlink(missing_ok=True)
    except OSError as fault:  # a full disk: the next process traces anew
        LOG.warning("a program is not kept: %s", fault)
