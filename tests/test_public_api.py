"""The public names: all there, and loaded only when they are used."""

import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

import exoid

DEFINED_AS = {"fit_leg": "fit", "diagnose_leg": "diagnose", "recording": "recording_of"}


@pytest.mark.parametrize("name", exoid.__all__)
def test_every_public_name_resolves_to_the_thing_of_that_name(name):
    found = getattr(exoid, name)
    assert found.__module__.startswith("exoid.")
    assert found.__name__ == DEFINED_AS.get(name, name)


def test_all_names_are_listed_in_order_and_have_a_home():
    assert sorted(exoid.__all__) == sorted(exoid._HOMES)
    assert len(set(exoid.__all__)) == len(exoid.__all__)


def test_an_unknown_name_is_an_attribute_error():
    with pytest.raises(AttributeError, match="module 'exoid' has no attribute 'guess'"):
        exoid.guess  # noqa: B018


def test_the_version_is_that_of_the_package():
    assert exoid.__version__ == version("exoid")


def test_names_show_up_in_dir_and_in_a_star_import():
    space: dict = {}
    exec("from exoid import *", space)
    assert set(exoid.__all__) <= space.keys()
    shown = {name for name in dir(exoid) if not name.startswith("_")}
    assert shown == set(exoid.__all__)


@pytest.mark.parametrize(
    ("name", "loads_jax"),
    [("__all__", False), ("load", False), ("recording", False), ("simulate", True)],
)
def test_a_name_loads_no_more_than_it_needs(name, loads_jax):
    code = f"import exoid, sys; exoid.{name}; print('jax' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == str(loads_jax)


def test_types_are_shipped():
    assert (Path(exoid.__file__).parent / "py.typed").is_file()
