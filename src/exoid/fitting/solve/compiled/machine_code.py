"""Machine code of a function, by XLA."""

import gc
import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from importlib import import_module
from secrets import token_hex
from typing import Any

import jax
import numpy as np

from exoid.fitting.solve.compiled.memory import give_back

# How far XLA optimises: as fast machine code as by default, and half as long to wait for it. In one
# piece it takes the least work, and other programs are compiled beside it anyhow.
LEAN = {
    "xla_backend_optimization_level": 1,
    "xla_cpu_use_fusion_emitters": False,
    "xla_cpu_parallel_codegen_split_count": 1,
}
BRIEF = LEAN | {"xla_backend_optimization_level": 0}  # compiled twice as soon, for what hardly runs
LEAST = "jax_persistent_cache_min_compile_time_secs"
NEVER = 1e9  # s


def compiled(name: str, structure, shapes, static, *, brief: bool) -> jax.stages.Compiled:
    """The function `module:name` traced and compiled for these shapes; what that took of memory
    goes back to the system.
    """
    function = traceable(name, structure, static)
    return machine_code(jax.jit(function, compiler_options=understood(brief=brief)), shapes)


@cache
def processor() -> Any:
    """What every program runs on: a graphics card that JAX also finds begins the many small steps
    of a recording later than a processor ends them. Where JAX is told of no processor, its first
    device.
    """
    try:
        return jax.devices("cpu")[0]
    except RuntimeError:
        return jax.devices()[0]


def machine_code(function: Any, shapes) -> jax.stages.Compiled:
    """What `jax.jit` gave, compiled for these shapes and the processor."""
    with jax.default_device(processor()):
        with uncollected():
            lowered = function.lower(*(jax.ShapeDtypeStruct(*shape) for shape in shapes))
        with apart():
            code = lowered.compile()
    give_back()
    return code


@contextmanager
def uncollected() -> Iterator[None]:
    """Tracing makes millions of objects that stay, and to look for garbage among them takes half as
    long as to make them. Who turned that off turns it on.
    """
    on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if on:
            gc.enable()


@contextmanager
def apart() -> Iterator[None]:
    """What is compiled here does not go into XLA's own cache of programs, too. Where another thread
    leaves sooner, it may: a file that nobody reads.
    """
    before = getattr(jax.config, LEAST)
    jax.config.update(LEAST, NEVER)
    try:
        yield
    finally:
        jax.config.update(LEAST, before)


def traceable(name: str, structure, static):
    """The function on bare arrays. Its module is imported here, only where it must be traced."""
    module, _, attribute = name.partition(":")
    function = getattr(import_module(module), attribute)

    def flat(*leaves):
        return jax.tree.leaves(function(*jax.tree.unflatten(structure, leaves), static))

    return unheard_of(flat, attribute)


def unheard_of(function, name: str):
    """The function under a name that no program had before: XLA would find that one in its cache of
    programs, and what it loads from there cannot be kept once more.
    """
    function.__name__ = f"{name}_{token_hex(8)}"
    return function


def options(*, brief: bool) -> dict[str, Any]:
    """How far to optimise: what the user asks of XLA by XLA_FLAGS holds here, too."""
    asked = os.environ.get("XLA_FLAGS", "")
    wanted = BRIEF if brief else LEAN
    return {name: value for name, value in wanted.items() if f"--{name}=" not in asked}


@cache
def understood(*, brief: bool) -> dict[str, Any]:
    """The options, where they are for this machine and this version of XLA knows them."""
    wanted = options(brief=brief)
    try:
        with jax.default_device(processor()):
            jax.jit(lambda: np.zeros(()), compiler_options=wanted).lower().compile()
    except jax.errors.JaxRuntimeError:
        return {}
    return wanted
