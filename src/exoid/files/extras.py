"""Packages that only some files or results need: one that is missing is named, with its extra."""

import sys
from importlib.util import find_spec

EXTRAS = {
    "ezc3d": "c3d",
    "openpyxl": "excel",
    "pyarrow": "parquet",
    "pandas": "pandas",
    "numpyro": "bayes",
    "starlette": "live",
    "uvicorn": "live",
    "distributed": "study",
}


def require(package: str, what: str, extra: str = "") -> None:
    """**Raises** `ValueError` where a package is missing, that says which extra to install: that
    of `EXTRAS` unless another, which has more of what is needed, is named.
    """
    if find_spec(package) is None:
        extra = extra or EXTRAS[package]
        raise ValueError(f"{what} by {package}, which is missing: {installing(extra)}")


def installing(extra: str) -> str:
    """How to install an extra beside this exoid, whether its environment has pip or not."""
    return f"in a clone of exoid, python3 -m pip --python {sys.executable} install '.[{extra}]'"
