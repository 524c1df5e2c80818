"""A leg's parameters while it moves: `init` what is believed before, then `step` by sample.

belief = online.init(exoid.expected_leg(77.0, 1.80))
for sample in samples:
    belief, outlook = online.step(belief, sample)

The names are those of `__init__.pyi`, and load when they are first used: what a movement is called
needs no JAX.
"""

from lazy_loader import attach_stub

__getattr__, __dir__, __all__ = attach_stub(__name__, __file__)
