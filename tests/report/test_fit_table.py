"""The printed fit: every number with its unit and no more digits than its error allows."""

import io
import re
from dataclasses import replace
from decimal import Decimal

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rich.console import Console
from test_fit_json import fitted

from exoid.files.counted import counted
from exoid.fitting.misfit.uncertainty import Shares
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.fit_result import MountingFit
from exoid.fitting.result.remarks.anatomy_remarks import RARE
from exoid.physics.leg import LegParameters
from exoid.report.tables.fit import print_fit
from exoid.report.words.text import MOST_DIGITS, exponent, in_degrees, shortened, with_error


def printed(result, width=80):
    stream = io.StringIO()
    print_fit(result, Console(file=stream, width=width))
    return stream.getvalue()


def line_of(start, text):
    return next(line for line in text.splitlines() if line.startswith(start))


def test_every_parameter_has_value_error_unit_expectation_bounds_and_source():
    line = line_of("inertia J", printed(fitted()))
    assert re.search(r"0\.451 ± 0\.041 +kg m\^2 +0\.446 ± 0\.067 +▒▒▒▒▒ prior", line)


def test_what_nothing_determines_says_so_and_why_once():
    text = printed(fitted())
    assert "not determined" in line_of("mass m", text)
    assert text.count("motion shows only m l") == 1


def test_value_that_a_bound_set_is_printed_as_the_bound_without_error():
    assert re.search(r"stiffness c +4 +N m/rad .* bound", printed(fitted()))


def test_samples_without_an_angle_and_holes_are_told():
    result = fitted()
    first, *others = result.segments
    angle = np.array(first.angle)
    angle[50:60] = np.nan
    holed = replace(result, segments=[replace(first, angle=angle), *others])
    hole = float(first.time[60] - first.time[49])
    said = f"402 in 2 segments, 392 with an angle; 1 hole of {hole:.2g} s at most"
    assert said in line_of("samples", printed(holed))
    assert "angle" not in line_of("samples", printed(result))


@pytest.mark.parametrize(
    "expected",
    [
        r"gravity_over_inertia +m l g / J +26\.1880 ± 0\.0023 +1/s\^2",
        r"damping_over_inertia +d / J +0\.77780 ± 0\.00035 +1/s",
        r"leg 1 +active +0\.00 +2 +-9\.50 ± 0\.86 +0\.0573 +0\.0458",
        r"T \[s\] +tau \[N m\]",
        r"angle RMSE +0\.0573 deg, 1\.25 times the noise floor of 0\.0458 deg",
        r"velocity RMSE +0\.172 deg/s",
        r"samples +402 in 2 segments",
        r"f = 1/T \(Eq\. 4\); 2/T gives 4\.30 deg, 75 times as much",
        r"starts +5: 4 succeeded, 3 at the best cost; 2 distinct minima",
        r"failed +1 start: its motion could not be simulated",
        r"stiffness +1\.8 to 4 N m/rad",
        r"Prior: anatomy, table de_leva, 77 kg and 1\.8 m",
        r"- the fit lies on the limit m l\^2 <= J of a rigid leg\.",
    ],
)
def test_report_says(expected):
    assert re.search(expected, printed(fitted()))


@pytest.mark.parametrize("width", [80, 100, 140])
def test_no_line_is_wider_than_the_terminal_and_nothing_is_cut(width):
    result = fitted()
    long = "2024-11-02_left_leg_with_exoskeleton_and_added_mass"
    named = [
        replace(each, name=f"{long} {number}", added_mass=1.25)
        for number, each in enumerate(result.segments)
    ]
    text = printed(replace(result, segments=named), width)
    assert max(map(len, text.splitlines())) <= width
    assert "mass 1  active" in text
    assert text.count("…") == (2 if width < 140 else 0)  # names only


def test_a_drop_that_a_hand_ended_says_up_to_when_it_is_fitted():
    result = fitted()
    first, *others = result.segments
    text = printed(replace(result, segments=[replace(first, caught=2.07), *others]))
    assert line_of("leg 0", text).split()[:5] == ["leg", "0", "passive", "0.00", "2.07"]
    said = "segment leg 0 from where a hand, muscle or lost samples end it"
    assert line_of("left out", text).split(maxsplit=2)[2].strip() == said
    assert not re.search("left out|^ +from +to ", printed(result), re.MULTILINE)


def test_what_hardly_any_leg_of_this_body_does_stands_before_its_numbers():
    strange = f"by its motion this leg has J / (m l) = 0.561 m: {RARE}."
    text = printed(replace(fitted(), notes=[strange]))
    assert text.count("By its motion this leg") == 1
    assert "by its motion" not in text
    assert text.index("Check this before you use a number") < text.index("Parameters")


def test_piped_output_is_plain():
    text = printed(fitted())
    assert "\x1b" not in text
    assert not set("│┃╭╰|") & set(text)


def test_names_with_brackets_and_colons_are_printed_as_they_are():
    result = fitted()
    odd = replace(result.segments[0], name="[red]leg[/] :leg:")
    assert "[red]leg[/] :leg:" in printed(replace(result, segments=[odd]))


def test_rig_without_torque_gyro_or_anatomy_has_no_empty_columns():
    result = fitted()
    rig = {
        name: replace(each, value=None, standard_error=None, expected=None, shares=None)
        for name, each in result.parameters.items()
    }
    bare = replace(result.segments[0], angular_velocity=None, velocity_rmse=None)
    start = replace(result.multistart, family={}, members={})
    text = printed(
        replace(result, parameters=rig, segments=[bare], multistart=start, torque_frequency=None)
    )
    for absent in ("expected", "tau [N m]", "velocity RMSE", "torque frequency", "equally well"):
        assert absent not in text


def test_family_says_where_all_sets_agree():
    result = fitted()
    start = replace(result.multistart, family={"inertia": (0.45, 0.45)})
    assert "0.45 kg m^2, the same in all" in printed(replace(result, multistart=start))


def owned(*names):
    zero = Estimate("zero", "encoder zero", "rad", 0.01, 0.002, reason=None)
    return replace(fitted(), mountings=[MountingFit(name, zero=zero) for name in names])


def together(*names):
    return replace(owned(*names), leg=LegParameters(*map(np.asarray, (4.5, 0.4, 0.25, 0.3, 2.6))))


def test_mounting_of_one_recording_has_no_column_of_its_name():
    text = printed(together("recording"))
    assert re.search(r"^Mounting\n +value +unit", text, re.MULTILINE)
    assert line_of("encoder zero", text).split() == ["encoder", "zero", "0.57", "±", "0.11", "deg"]


def test_what_a_spring_slack_elsewhere_makes_of_an_encoder_stands_beside_it():
    found = together("recording")
    zero = replace(found.mountings[0].zero, if_slack=np.radians(1.3))
    text = printed(replace(found, mountings=[MountingFit("recording", zero=zero)]))
    assert line_of("encoder zero", text).split()[-4:] == ["0.11", "deg", "±", "1.3"]


def test_mountings_of_several_are_named_by_recording_or_by_segment_fitted_alone():
    text = printed(together("bare.csv", "loaded.csv"))
    assert re.search(r"^Mounting, of each recording\nrecording +value", text, re.MULTILINE)
    assert "encoder zero" in line_of("loaded.csv", text)
    text = printed(owned("0", "1"))
    assert re.search(r"^Mounting, of each segment\nsegment +value", text, re.MULTILINE)


def last_place(number):
    return Decimal(number).as_tuple().exponent


values = st.floats(-1e4, 1e4)
errors = st.floats(1e-7, 1e4)


@given(value=values, error=errors)
def test_error_has_two_digits_and_the_value_ends_at_the_same_decimal(value, error):
    text = with_error(value, error)
    power = re.fullmatch(r"\((.*) ± (.*)\)e([+-]\d+)", text)
    shown, spread = power.groups()[:2] if power else text.split(" ± ")
    scale = Decimal(10) ** int(power[3]) if power else Decimal(1)
    assert abs(Decimal(spread) * scale - Decimal(error)) <= Decimal(error) * Decimal("0.051")
    digits = len(Decimal(shown).as_tuple().digits)
    assert digits <= MOST_DIGITS + 1
    if max(exponent(value), exponent(error)) - exponent(error) + 1 < MOST_DIGITS:
        assert last_place(shown) == last_place(spread)
        assert len(Decimal(spread).as_tuple().digits) == 2
        assert abs(Decimal(shown) * scale - Decimal(value)) <= Decimal(error) * Decimal("0.06")


@pytest.mark.parametrize(
    ("value", "error", "text"),
    [
        (4.5276, 0.37974, "4.53 ± 0.38"),
        (0.35, 0.0996, "0.35 ± 0.10"),
        (9.96, 0.996, "10.0 ± 1.0"),
        (123.4, 56.0, "123 ± 56"),
        (-0.00003299, 2.7e-7, "(-3.299 ± 0.027)e-5"),
        (1234.0, 560.0, "(1.23 ± 0.56)e+3"),
        (0.0, 0.25, "0.00 ± 0.25"),
        (np.pi, 1e-12, "3.141593 ± 1.0e-12"),
    ],
)
def test_digits_follow_the_error(value, error, text):
    assert with_error(value, error) == text


@given(st.floats(1e-9, 3.0))
def test_degrees_have_three_digits_and_no_power_of_ten(angle):
    text = in_degrees(angle)
    assert re.fullmatch(r"\d+(\.\d+)?", text)
    assert float(text) == pytest.approx(np.degrees(angle), rel=0.006)


def test_degrees_of_nothing_are_nothing():
    assert in_degrees(0.0) == "0.000"


@given(st.text(min_size=1, max_size=60), st.integers(5, 40))
def test_shortened_name_fits_and_keeps_its_end(name, widest):
    short = shortened(name, widest)
    assert len(short) <= max(widest, 0)
    assert name.endswith(short.rpartition("…")[2]) or short == name


def test_counts_agree_with_their_nouns():
    assert counted(1, "start") == "1 start"
    assert counted(2, "start") == "2 starts"
    assert counted(2, "distinct minimum", "distinct minima") == "2 distinct minima"


def test_masses_that_no_such_body_has_are_told_before_any_number():
    result = fitted()
    told = {"value": 2.2, "standard_error": 0.01, "expected": 0.4, "expected_deviation": 0.05}
    inertia = replace(result.parameters["inertia"], **told, shares=Shares(1.0, 0.0, 0.0))
    text = printed(replace(result, parameters={**result.parameters, "inertia": inertia}))
    assert text.index("Check this before") < text.index("Parameters")
    assert " ".join(text.split()).count("5.5 times what anatomy expects") == 1
    assert "Check this before" not in printed(result)
