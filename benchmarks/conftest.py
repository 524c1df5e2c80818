"""Benchmarks run in float64, as the command line does."""

import jax

jax.config.update("jax_enable_x64", True)
