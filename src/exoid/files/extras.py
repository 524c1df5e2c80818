"""Packages that only some files or results need: one that is missing is named, with its extra."""

from importlib.util import find_spec

EXTRAS = {
    "ezc3d": "c3d",
    "openpyxl": "excel",
    "pyarrow": "parquet",
    "pandas": "pandas",
    "statsmodels": "study",
    "numpyro": "bayes",
    "starlette": "live",
    "uvicorn": "live",
    "distributed": "study",
}


def require(package: str, what: str) -> None:
    """**Raises** `ValueError` that says which extra to install, where a package is missing."""
    if find_spec(package) is None:
        extra = EXTRAS[package]
        raise ValueError(f'{what} by {package}, which is missing: pip install "exoid[{extra}]"')
