"""Every public name shows itself in an example that runs, in a folder with a recording of drops."""

import doctest
import inspect

import jax
import jax.numpy as jnp
import numpy as np
import pytest

import exoid
from exoid.recordings.declared.subject import Subject
from exoid.recordings.formats.own_table import write_table
from exoid.twin.motion import Movement
from fit_cases import recorded

SLOW = ("Contrast", "Diagnosis", "diagnose", "plan_between", "plot_diagnosis")  # a minute each
DROPS = (Movement(-0.35, 3.0), Movement(-0.87, 3.0))  # rad, s
PERSON = Subject(kind="leg", body_mass=77.0, height=1.8)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("examples")
    write_table(recorded(*DROPS, subject=PERSON), path / "drops.csv")
    return path


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.proof) if name in SLOW else name
        for name in exoid.__all__
    ],
)
def test_the_example_of_a_public_name_gives_what_it_shows(name, folder, monkeypatch):
    monkeypatch.chdir(folder)
    space = {"exoid": exoid, "jax": jax, "jnp": jnp, "np": np, "__name__": "example"}
    text = inspect.getdoc(inspect.unwrap(getattr(exoid, name)))
    example = doctest.DocTestParser().get_doctest(text or "", space, name, None, 0)
    assert example.examples, f"{name} shows no example"
    said: list[str] = []
    result = doctest.DocTestRunner(verbose=False).run(example, out=said.append)
    assert result.failed == 0, "".join(said)
