"""Mechanical parameters of the lower leg from exoskeleton recordings.

The public names are those of `__init__.pyi`. They load when they are first used: JAX alone takes
longer to import than most commands take to answer.
"""

from lazy_loader import attach_stub

_load, __dir__, __all__ = attach_stub(__name__, __file__)
_RENAMED = {"fit_leg": "fit", "diagnose_leg": "diagnose"}


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version

        return version("exoid")
    if name in _RENAMED:
        from warnings import warn

        warn(f"exoid.{name} is named exoid.{_RENAMED[name]}", DeprecationWarning, stacklevel=2)
        name = _RENAMED[name]
    if name not in __all__:
        raise AttributeError(f"module 'exoid' has no attribute {name!r}")
    return _load(name)
