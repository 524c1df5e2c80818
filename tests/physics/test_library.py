"""The library holds one term per module, under the names by which users and tables know them."""

from dataclasses import fields
from importlib import import_module
from pkgutil import walk_packages
from types import ModuleType

import pytest

from exoid.physics.library import library, terms_of
from exoid.physics.parameter import declarations
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
    "stribeck_friction",
    "quadratic_drag",
    "stiffness_rest_angle",
    "angle_offset",
    "end_range_stiffening",
    "hard_stop",
    "cubic_stiffness",
    "cuff_compliance",
    "wobbling_mass",
    "maxwell_element",
    "hysteresis",
    "backlash",
    "moving_base",
    "polycentric_axis",
    "torque_harmonic",
    "torque_bias",
    "torque_asymmetry",
    "activation_lag",
    "stretch_reflex",
    "fatigue",
    "encoder_eccentricity",
    "encoder_gain",
    "encoder_second_harmonic",
    "gyro_scale",
    "gyro_bias",
    "sensor_skew",
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
