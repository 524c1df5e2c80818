"""A table is said once: a terminal and a page show the same cells, each as it has room."""

import io
import re
from dataclasses import replace

import numpy as np
import pytest
from diagnosis_by_hand import found
from html_tree import parse, rows
from page_cases import made_up
from rich.console import Console
from test_fit_json import fitted

from exoid.fitting.misfit.uncertainty import Shares
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import FitResult
from exoid.mismatch.answer.diagnosis import Booked, Suspect
from exoid.report.page import build_page
from exoid.report.sections.parameters import parameters_of
from exoid.report.tables.compare import ComparedQuantity
from exoid.report.tables.comparison import quantities
from exoid.report.tables.leg import before_and_after, in_print, parameters, ratios, segments
from exoid.report.tables.mismatch.diagnosis import suspects
from exoid.report.tables.table import Column, Table, print_table
from exoid.report.words.text import with_error
from exoid.report.words.typeset import formula, tidy

ROOMY = 200  # letters


def printed(table, width=ROOMY):
    stream = io.StringIO()
    print_table(table, Console(file=stream, width=width))
    return stream.getvalue()


def leg():
    fit = fitted()
    return [parameters(parameters_of(fit)), ratios(fit), segments(fit.segments)]


@pytest.mark.parametrize("table", leg(), ids=["parameters", "ratios", "segments"])
def test_what_a_terminal_says_of_a_quantity_a_page_says_with_its_unit(table):
    text, page = printed(table), {" ".join(row) for row in table.rows}
    for column in table.columns.values():
        if isinstance(column, Column) and column.units:
            for cell, unit in zip(column.cells, column.units, strict=True):
                assert cell in text
                assert any(cell in row and (unit in row or "not det" in cell) for row in page)


def test_the_rows_of_a_table_are_those_of_the_html():
    page = parse(build_page(made_up()))
    shown = [table for name in ("parameters", "motion") for table in page.by_id(name).all("table")]
    for said in leg():
        (table,) = [each for each in shown if each.all("caption")[0].text == said.caption]
        plain = [tuple(tidy(re.sub("<[^>]*>", "", cell)) for cell in row) for row in said.rows]
        assert [tuple(row.values()) for row in rows(table)] == plain
        assert list(rows(table)[0]) == [re.sub("\\btau\\b", "τ", head) for head in said.heads]


def test_a_narrow_terminal_goes_without_what_is_spared_most_easily():
    long = ["x" * 20]
    table = Table("", {"a": long, "b": Column(long, spare=1), "c": Column(long, spare=2)})
    assert [head for head in "abc" if head in printed(table, 70)] == ["a", "b", "c"]
    assert [head for head in "abc" if head in printed(table, 50)] == ["a", "b"]
    assert [head for head in "abc" if head in printed(table, 30)] == ["a"]


def test_a_brief_cell_stands_in_where_the_whole_one_finds_no_room():
    table = Table("", {"a": Column(["inertia J"], spare=1, brief=["J"]), "b": ["y" * 20]})
    assert "inertia J" in printed(table, 40)
    narrow = printed(table, 25)
    assert "J" in narrow
    assert "inertia" not in narrow


def test_symbols_are_typeset_on_a_page_only():
    table = Table("", {"symbol": Column(["m l g / J"], symbols=True)})
    assert table.rows == [(formula("m l g / J"),)]
    assert "m l g / J" in printed(table)


def test_columns_that_hold_nothing_are_left_out_of_both():
    table = Table("", {"a": ["1"], "empty": [""], "units": Column([""], units=[""])})
    assert table.heads == ["a"]
    assert "empty" not in printed(table)
    assert "unit" not in printed(table)


def test_what_is_said_of_one_only_is_not_in_the_other():
    table = Table(
        "", {"a": ["1"], "p": Column(["2"], only="page"), "t": Column(["3"], only="terminal")}
    )
    assert table.rows == [("1", "2")]
    assert "2" not in printed(table)
    assert "3" in printed(table)


@pytest.mark.parametrize("unit", ["-", "1"])
def test_what_has_no_unit_has_a_blank_in_every_table(unit):
    """However a quantity declares it."""
    estimate = Estimate("k", "scale", unit, 0.013, 0.001)
    compared = ComparedQuantity("scale", "k", unit, estimate, estimate)
    suspected = replace(found(), suspected=[Suspect(["x"], [Booked("scale", 0.12, 0.25, unit)])])
    tables = [
        Table("", {"name": ["scale"], "value": Column(["0.013"], units=[unit])}),
        quantities([compared]),
        suspects(suspected),
    ]
    for table in tables:
        last = printed(table).rstrip().splitlines()[-1].split()
        assert unit not in last, table


def test_what_set_a_number_stands_in_80_letters_beside_what_was_found():
    """Else an error that a prior made would look measured."""
    by_prior = Shares(0.0, 1.0, 0.0)
    names = {
        "gravity_over_inertia": ("m l g / J", "1/s^2"),
        "coulomb_friction.level_over_inertia": ("F_c / J", "1/s^2"),
        "stribeck_friction.stribeck_velocity": ("v_s", "rad/s"),
    }
    each = {
        name: Estimate(symbol, name, unit, -27.3264, 0.0083, shares=by_prior)
        for name, (symbol, unit) in names.items()
    }
    made = object.__new__(FitResult)
    for name, value in (("parameters", each), ("ratios", {}), ("terms", {})):
        object.__setattr__(made, name, value)
    for room in (ROOMY, 80, 60):
        said = printed(before_and_after(made, made), room)
        assert "set by" in said
        assert said.count("prior") == len(names)
        assert "F_c / J" in said, room  # by which a wide terminal and a pipe are the same


def test_what_a_slack_angle_leaves_open_stands_beside_every_number_that_goes_with_it():
    inertia = Estimate("J", "inertia", "kg m^2", 0.23, 0.023, if_slack=0.097)
    angle = Estimate("phi_3", "angle", "rad", -0.6, 0.01, if_slack=np.radians(4.0))
    table = parameters({"inertia": inertia, "mass": replace(inertia, if_slack=None)})
    assert table.paged["if slack"] == ["± 0.097 kg m^2", ""]
    for table_of_it in (table, parameters({"angle": in_print(angle)})):
        assert "if slack" in printed(table_of_it)
    assert "± 4" in printed(parameters({"angle": in_print(angle)}))
    assert "if slack" not in printed(parameters({"mass": replace(inertia, if_slack=None)}))


def test_angles_and_rates_are_compared_in_degrees():
    bias = Estimate("b", "bias", "rad/s", 0.004, 0.00007)
    told = printed(quantities([ComparedQuantity("bias", "b", "rad/s", bias, bias)]))
    assert "0.2292 ± 0.0040" in told
    assert "deg/s" in told


def test_a_zero_has_no_sign():
    assert with_error(-0.001, 0.28) == "0.00 ± 0.28"
