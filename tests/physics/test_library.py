"""The library holds one term per module, under the names by which users and tables know them."""

from dataclasses import fields
from importlib import import_module
from pkgutil import walk_packages
from types import ModuleType, new_class
from typing import Any, ClassVar

import jax.numpy as jnp
import pytest

from exoid.physics.library import check_terms, library, terms_of
from exoid.physics.parameter import declarations, parameter
from exoid.physics.term import PhysicsTerm, SensorTerm, Term, name_of

KINDS = {"exoid.physics.terms": PhysicsTerm, "exoid.physics.sensing": SensorTerm}
MODULES = [
    (package, each.name)
    for package in KINDS
    for each in walk_packages(import_module(package).__path__, f"{package}.")
    if not each.ispkg
]
NAMES = {
    "coulomb_friction",
    "load_friction",
    "stribeck_friction",
    "power_drag",
    "quadratic_drag",
    "stiffness_rest_angle",
    "angle_offset",
    "end_range_stiffening",
    "hard_stop",
    "cubic_stiffness",
    "slack_cubic_stiffness",
    "cuff_compliance",
    "wobbling_mass",
    "maxwell_element",
    "hysteresis",
    "shaped_hysteresis",
    "backlash",
    "sticking_backlash",
    "moving_base",
    "polycentric_axis",
    "torque_harmonic",
    "torque_bias",
    "torque_asymmetry",
    "activation_lag",
    "stretch_reflex",
    "fatigue",
    "butterworth_filter",
    "first_order_filter",
    "encoder_eccentricity",
    "encoder_gain",
    "encoder_second_harmonic",
    "gyro_scale",
    "gyro_bias",
    "sensor_skew",
    "clock_rate",
    "zero_drift",
}

ODD = {  # what a user's class may do wrong, and what is said of it
    "return jnp.sqrt(self.size * now.angle)": "is not finite where it begins",
    "return self.size if now.angle > 0 else -self.size": "does not run: TracerBool",
    "return self.sice * now.angle": "does not run: AttributeError: .* Mend it",
    "return jnp.stack([self.size, self.size])": r"torque must return an array of shape \(\)",
    "self.size * now.angle": r"torque must return an array of shape \(\)",
}
modules = pytest.mark.parametrize(("package", "module"), MODULES)
every_term = pytest.mark.parametrize("term", library(), ids=name_of)


@modules
def test_a_module_defines_one_term_which_has_the_modules_name(package, module):
    (term,) = terms_of(import_module(module))
    assert name_of(term) == module.rpartition(".")[2]


@modules
def test_the_terms_push_and_the_sensing_only_shows(package, module):
    (term,) = terms_of(import_module(module))
    assert issubclass(term, KINDS[package])


def test_the_names_are_those_that_are_known():
    assert {name_of(term) for term in library()} == NAMES


def test_every_term_is_there_once_in_the_order_of_its_name():
    names = [name_of(term) for term in library()]
    assert names == sorted(set(names))


def test_a_term_that_a_module_only_imports_is_not_its_own():
    module = ModuleType("borrowed")
    module.Borrowed = library()[0]
    assert terms_of(module) == []


def test_a_name_is_the_class_in_lower_case_with_underscores():
    class OneTwoThree(Term): ...

    assert name_of(OneTwoThree) == "one_two_three"


@every_term
def test_every_field_of_a_term_is_a_declared_parameter(term):
    assert [entry.name for entry in fields(term)] == [name for name, _ in declarations(term)]


@every_term
def test_the_symbols_within_a_term_differ(term):
    symbols = [said.symbol for _, said in declarations(term)]
    assert len(set(symbols)) == len(symbols) > 0


@pytest.mark.parametrize(("body", "said"), ODD.items())
def test_a_term_that_cannot_run_is_refused_in_a_sentence(body, said):
    made = {}
    exec(f"def torque(self, now, memory):\n    {body}", {"jnp": jnp}, made)
    words = dict.fromkeys(("title", "reference", "explanation", "isolate"), "of one's own")
    size = parameter("a", "N m", -1.0, 1.0, "size", (0.05,))
    annotated = {**dict.fromkeys(words, ClassVar[str]), "size": Any}
    body = {**words, **made, "size": size, "__annotations__": annotated}
    own = new_class("Own", (PhysicsTerm,), {}, lambda namespace: namespace.update(body))
    with pytest.raises(ValueError, match=said):
        check_terms((own,))
