"""The public names: all there, and loaded only when they are used."""

import ast
import os
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import pytest

import exoid

STUB = Path(exoid.__file__).with_suffix(".pyi")


@pytest.mark.parametrize("name", exoid.__all__)
def test_every_public_name_resolves_to_the_thing_of_that_name(name):
    found = getattr(exoid, name)
    assert found.__module__.startswith("exoid.")
    assert found.__name__ == name


def test_every_name_has_one_home_and_checkers_see_those_that_there_are():
    tree = ast.parse(STUB.read_text(encoding="utf-8"))
    homes = [each for each in tree.body if isinstance(each, ast.ImportFrom)]
    imported = [alias.name for each in homes for alias in each.names]
    (public,) = (each.value for each in tree.body if isinstance(each, ast.Assign))
    assert sorted(imported) == ast.literal_eval(public) == exoid.__all__
    assert len(set(imported)) == len(imported)


@pytest.mark.parametrize(("old", "new"), [("fit_leg", "fit"), ("diagnose_leg", "diagnose")])
def test_a_name_of_old_warns_of_the_new_one(old, new):
    with pytest.warns(DeprecationWarning, match=f"exoid.{old} is named exoid.{new}$") as noted:
        assert getattr(exoid, old) is getattr(exoid, new)
    assert noted[0].filename == __file__
    assert old not in dir(exoid)


def test_all_names_load_at_once_where_that_is_asked_for():
    code = "import exoid; print(set(exoid.__all__) <= vars(exoid).keys())"
    done = subprocess.run(
        [sys.executable, "-c", code],
        env={**os.environ, "EAGER_IMPORT": "1"},
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == "True"


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
    assert STUB.is_file()


@pytest.mark.parametrize(
    ("terms", "said"),
    [
        ("exoid.PhysicsTerm", 'ValueError: terms are several: terms=("coulomb_friction",), with'),
        ("('coulomb',)", "ValueError: there is no term 'coulomb': did you mean coulomb_friction?"),
    ],
)
def test_terms_that_are_none_are_refused_in_one_sentence(terms, said, tmp_path):
    """In a process of its own: here, types are checked before the function is called."""
    code = (
        "import numpy as np, exoid\n"
        "time = np.arange(0, 3, 0.01)\n"
        "swing = exoid.recording({'time_s': time, 'raw_angle_deg': -90 + 40 * np.cos(5 * time)})\n"
        f"exoid.fit(swing, terms={terms})"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert said in done.stderr
