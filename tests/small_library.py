"""A library of effects that compiles quickly: every test with the same one compiles it once."""

from exoid.physics.sensing.gyro_scale import GyroScale
from exoid.physics.terms.device.coulomb_friction import CoulombFriction
from exoid.physics.terms.tissue.maxwell_element import MaxwellElement
from exoid.physics.terms.tissue.quadratic_drag import QuadraticDrag

SMALL = (CoulombFriction, GyroScale, MaxwellElement, QuadraticDrag)
