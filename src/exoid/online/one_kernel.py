"""A function compiled whole."""

from collections.abc import Callable
from typing import Any

import jax
from jax.experimental.xla_metadata import set_xla_metadata

from exoid.fitting.solve.compiled.machine_code import unheard_of

WHOLE = {"xla_cpu_small_call": "true", "inlineable": "false"}
# No part of another library fits into a kernel; what is fused further is computed several times.
OPTIONS = {"xla_cpu_use_fusion_emitters": False, "xla_cpu_experimental_ynn_fusion_type": ""}


def one_kernel(function: Callable[..., Any]):
    """`jax.jit` of a function of small arrays as one kernel of a processor: starting one for each
    of some hundred operations takes longer than what they do.
    """
    inside = jax.jit(function)

    def whole(*given: Any):
        return set_xla_metadata(inside(*given), **WHOLE)

    return jax.jit(unheard_of(whole, "whole"), compiler_options=OPTIONS)
