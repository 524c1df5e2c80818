"""The firmware's sine, cosine and square root once more, in NumPy float32."""

import numpy as np

F = np.float32
ONE, ZERO = F(1), F(0)


def turned(angle):
    """Sine and cosine."""
    quarters = angle * F(0.63661977)
    whole = np.trunc(quarters + np.where(quarters < 0, F(-0.5), F(0.5))).astype(np.int32)
    nearest = whole.astype(F)
    r = (angle - nearest * F(1.5703125)) - nearest * F(4.8382679e-04)
    z = r * r
    sine = ((F(-1.9515296e-04) * z + F(8.332161e-03)) * z + F(-1.6666655e-01)) * z * r + r
    even = (F(2.4433157e-05) * z + F(-1.3887316e-03)) * z + F(4.1666646e-02)
    cosine = even * z * z - F(0.5) * z + ONE
    at = whole & 3
    cases = [at == 0, at == 1, at == 2]
    return (
        np.select(cases, [sine, cosine, -sine], -cosine),
        np.select(cases, [cosine, -sine, -cosine], sine),
    )


def root(square):
    """The square root, 0 of what is not positive."""
    bits = np.uint32(0x1FBD1DF5) + (square.view(np.uint32) >> np.uint32(1))
    found = bits.view(F)
    for _ in range(2):
        found = F(0.5) * (found + square / found)
    return np.where(square > 0, found, ZERO)
