"""The polynomial cosine against the library's."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from exoid.physics.waves import cos

# The series is good to 1e-15. Where the compiler does not fuse, k pi is rounded: by up to half the
# spacing of float64 at 64 to 100, 7.1e-15.
TOLERANCE = 1e-14

ANGLE = np.concatenate(
    [
        np.random.default_rng(0).uniform(-100, 100, 100_000),
        np.arange(-63, 64) * np.pi / 2,  # the seams of the half turns, and their middles
        np.nextafter(np.arange(-63, 64) * np.pi / 2, np.inf),
        np.nextafter(np.arange(-63, 64) * np.pi / 2, -np.inf),
    ]
)


def slope(function):
    """The derivative of a function that acts on each element, in forward mode."""
    return lambda angle: jax.jvp(function, (angle,), (jnp.ones_like(angle),))[1]


def pulled_back(function):
    """The same in reverse mode."""
    return lambda angle: jax.vjp(function, angle)[1](jnp.ones_like(angle))[0]


DERIVATIVES = {
    "value": (cos, np.cos),
    "first, forward": (slope(cos), lambda angle: -np.sin(angle)),
    "first, reverse": (pulled_back(cos), lambda angle: -np.sin(angle)),
    "second, forward twice": (slope(slope(cos)), lambda angle: -np.cos(angle)),
    "second, forward over reverse": (slope(pulled_back(cos)), lambda angle: -np.cos(angle)),
    "second, reverse twice": (pulled_back(pulled_back(cos)), lambda angle: -np.cos(angle)),
}


@pytest.mark.parametrize("transform", [lambda f: f, jax.jit, jax.vmap], ids=["op", "jit", "vmap"])
@pytest.mark.parametrize("derivative", DERIVATIVES)
def test_it_is_the_cosine_within_a_hundred_radians(derivative, transform):
    ours, exact = DERIVATIVES[derivative]
    found = transform(ours)(jnp.array(ANGLE))
    np.testing.assert_allclose(found, exact(ANGLE), rtol=0, atol=TOLERANCE)


@given(st.floats(-np.pi / 2, np.pi / 2))
def test_where_a_leg_swings_it_is_right_to_a_few_bits(angle):
    # rounding of ten additions near 1, each 1.1e-16
    assert abs(float(cos(jnp.array(angle))) - np.cos(angle)) < 5e-16


@given(st.floats(-100, 100))
def test_it_is_even_to_the_last_bit(angle):
    assert cos(jnp.array(angle)) == cos(jnp.array(-angle))


def test_it_keeps_the_shape_and_broadcasts_nothing():
    grid = jnp.linspace(-3, 3, 12).reshape(3, 4)
    np.testing.assert_array_equal(cos(grid), cos(grid.ravel()).reshape(3, 4))


def test_what_is_not_finite_stays_so():
    assert jnp.isnan(cos(jnp.array([jnp.nan, jnp.inf, -jnp.inf]))).all()
