"""The expected leg against published tables, independent integration and simple laws."""

from math import pi

import numpy as np
import pytest
from scipy.integrate import quad

from exoid.physics.anatomy import (
    PAPER,
    capsule_inertia,
    expected_leg,
    paper_prior,
    reach,
    two_segment_inertia,
)
from exoid.physics.anatomy.body.doubt import doubts

SUBJECT = (77.0, 1.80)  # the paper's: kg, m


def values(leg):
    return leg.mass.value, leg.com_distance.value, leg.inertia.value


def integrated_capsule(mass, length, radius):
    """Slices along the axis: int (pi s^4/4 + pi s^2 z^2) dz over the half-length, times density."""
    half = length / 2 - radius

    def radius_squared(z):
        return radius**2 - max(0.0, z - half) ** 2

    def integrate(f):
        parts = (quad(f, a, b, epsabs=0, epsrel=1e-12)[0] for a, b in edges)
        return 2 * sum(parts)

    edges = [(0.0, half), (half, half + radius)]
    volume = integrate(lambda z: pi * radius_squared(z))
    moment = integrate(lambda z: pi * radius_squared(z) ** 2 / 4 + pi * radius_squared(z) * z**2)
    return mass * moment / volume


@pytest.mark.parametrize(
    ("length", "radius"), [(0.443, 0.05), (0.30, 0.03), (0.6, 0.2), (0.2, 0.1)]
)
def test_capsule_inertia_is_what_integration_gives(length, radius):
    exact = integrated_capsule(3.85, length, radius)
    assert capsule_inertia(3.85, length, radius) == pytest.approx(exact, rel=1e-10)


@pytest.mark.parametrize(("length", "radius"), [(0.443, 0.05), (0.40, 0.05), (0.443, 0.055)])
def test_the_printed_capsule_is_a_third_too_large_for_a_shin(length, radius):
    printed = capsule_inertia(3.85, length, radius, as_printed=True)
    assert 1.32 <= printed / capsule_inertia(3.85, length, radius) <= 1.36


def test_a_capsule_without_a_cylinder_is_a_ball():
    assert capsule_inertia(2.0, 0.2, 0.1) == pytest.approx(0.4 * 2.0 * 0.1**2)
    assert capsule_inertia(2.0, 0.2, 0.1, as_printed=True) == pytest.approx(0.4 * 2.0 * 0.1**2)


@pytest.mark.parametrize(
    ("table", "mass", "com", "inertia"),
    [
        ("de_leva", 4.39, (0.271, 0.275), (0.448, 0.460)),
        ("winter", 4.70, (0.260, 0.260), (0.457, 0.457)),
        ("dumas", 4.62, (0.243, 0.243), (0.406, 0.406)),
    ],
)
def test_each_table_gives_the_leg_that_others_computed_from_it(table, mass, com, inertia):
    # Tolerances: rounding of the masses; a foot 1 cm elsewhere, which moves l by 2 mm, J by 2 %.
    got_mass, got_com, got_inertia = values(expected_leg(*SUBJECT, table=table, sex="male"))
    assert got_mass == pytest.approx(mass, abs=0.005)
    assert com[0] - 0.002 <= got_com <= com[1] + 0.002
    assert inertia[0] * 0.98 <= got_inertia <= inertia[1] * 1.02


def test_five_and_two_percent_give_the_papers_mass_and_leave_out_the_feet_inertia():
    mass, com, inertia = values(expected_leg(*SUBJECT, table="paper", shank_radius=0.05))
    both_segments = two_segment_inertia(PAPER, *SUBJECT, PAPER.shank_length * 1.80)
    assert mass == pytest.approx(5.39)
    assert com == pytest.approx(0.274, abs=0.002)
    assert both_segments == pytest.approx(0.571, rel=0.02)
    assert 0.81 < inertia / both_segments < 0.86


def test_eq_14_does_not_follow_from_eq_5_to_8():
    mass, com, inertia = values(expected_leg(*SUBJECT, table="paper", shank_radius=0.05))
    prior = values(paper_prior(*SUBJECT))
    assert prior == pytest.approx((5.39, 0.2461, 0.35))
    assert mass == pytest.approx(prior[0])
    assert 1.10 < com / prior[1] < 1.13
    assert 1.36 < inertia / prior[2] < 1.40
    theta = prior[2] - prior[0] * prior[1] ** 2
    shorter, longer = (
        capsule_inertia(0.05 * 77, length, 0.05, as_printed=True) for length in (0.24, 0.26)
    )
    assert shorter < theta < longer


def test_the_papers_prior_weighs_every_parameter_alike():
    prior = paper_prior(80.0, 1.75)
    parts = (prior.mass, prior.inertia, prior.com_distance, prior.damping, prior.stiffness)
    assert [part.standard_deviation for part in parts] == [1.0] * 5
    assert prior.mass.value == pytest.approx(5.6)
    assert (prior.damping.value, prior.stiffness.value) == (30.0, 2.0)


@pytest.mark.parametrize("table", ["de_leva", "winter", "dumas", "paper"])
@pytest.mark.parametrize("sex", [None, "female", "male"])
def test_every_expected_leg_is_a_possible_body(table, sex):
    """m l^2 <= J <= reach m l: Eq. 12 and the bound that it lacks."""
    for body_mass, height in [(45.0, 1.50), SUBJECT, (120.0, 1.95)]:
        mass, com, inertia = values(expected_leg(body_mass, height, table=table, sex=sex))
        assert mass * com**2 < inertia < reach(height) * mass * com


def test_mass_grows_with_body_mass_and_inertia_with_height_squared():
    mass, com, inertia = values(expected_leg(60.0, 1.60))
    heavier = values(expected_leg(69.0, 1.60))
    taller = values(expected_leg(60.0, 1.76))
    assert heavier == pytest.approx((1.15 * mass, com, 1.15 * inertia))
    assert taller == pytest.approx((mass, 1.1 * com, 1.21 * inertia))


def test_all_tables_of_adults_agree_about_inertia_over_moment():
    """J / (m l) at 1.80 m is 0.36-0.38 m: the combination that a drop tells by itself."""
    for table in ("de_leva", "winter", "dumas"):
        mass, com, inertia = values(expected_leg(*SUBJECT, table=table))
        assert 0.36 <= inertia / (mass * com) <= 0.38


@pytest.mark.parametrize(
    ("body_mass", "height", "age", "spoken"),
    [
        (77.0, 1.80, None, "tables de_leva, winter and dumas"),
        (20.0, 1.12, None, "table child"),
        (35.0, 1.40, None, "tables child, de_leva, winter and dumas"),  # a child, or a small adult
        (35.0, 1.40, 11.0, "table child"),
        (45.0, 1.40, 40.0, "tables de_leva, winter and dumas"),
        (95.0, 1.75, None, "tables heavy, de_leva, winter and dumas"),
        (140.0, 1.75, None, "table heavy"),
    ],
)
def test_the_body_chooses_its_table(body_mass, height, age, spoken):
    assert expected_leg(body_mass, height, age=age).source == f"anatomy, {spoken}"


def test_tables_hand_over_without_a_step():
    """Over 1 % of body mass or height an expectation moves by a few percent, never more."""
    for height in np.arange(0.9, 1.9, 0.015):
        near = [values(expected_leg(21.0 * h**2, h)) for h in (height, 1.01 * height)]
        assert np.all(np.abs(np.log(near[1]) - np.log(near[0])) < 0.09)  # J ~ H^5
    for mass in np.arange(60.0, 200.0, 3.0):
        near = [values(expected_leg(m, 1.75)) for m in (mass, 1.01 * mass)]
        assert np.all(np.abs(np.log(near[1]) - np.log(near[0])) < 0.02)


def test_what_two_tables_disagree_about_is_scatter():
    small, grown = (expected_leg(35.0, 1.40, age=age).mass for age in (11.0, 40.0))
    unknown = expected_leg(35.0, 1.40).mass
    assert small.value > grown.value
    assert min(small.value, grown.value) < unknown.value < max(small.value, grown.value)
    assert unknown.standard_deviation / unknown.value > (
        min(one.standard_deviation / one.value for one in (small, grown))
    )


@pytest.mark.parametrize("height", [1.10, 1.30, 1.50])
def test_a_childs_inertia_goes_with_about_the_fifth_power_of_height(height):
    """Lebiedowska & Polisiakiewicz 1997, 5-18 years; legs grow more than the rest: up to H^0.8
    at the smallest (sitting heights).
    """
    low, high = (
        expected_leg(16.5 * h**3 / 1.3, h, age=10.0).inertia.value for h in (height, 1.05 * height)
    )
    assert 4.95 < np.log(high / low) / np.log(1.05) < 5.8


def test_of_a_heavy_body_a_smaller_share_hangs_below_the_knee():
    shares = [expected_leg(m, 1.75).mass.value / m for m in (75.0, 110.0, 150.0)]
    assert shares[0] > shares[1] > shares[2]


def test_the_scatter_of_m_l_and_j_goes_together():
    leg = expected_leg(*SUBJECT)
    covariance = np.array(leg.covariance)
    assert np.linalg.eigvalsh(covariance).min() > 0
    by_parts = np.sqrt(covariance.sum())  # log J = log m + log l + log J / (m l)
    assert leg.inertia.standard_deviation / leg.inertia.value == pytest.approx(by_parts)


def test_a_leg_of_unknown_sex_has_the_mean_mass():
    female, male, unknown = (
        expected_leg(*SUBJECT, table="de_leva", sex=sex) for sex in ("female", "male", None)
    )
    assert unknown.mass.value == pytest.approx((female.mass.value + male.mass.value) / 2)
    assert female.mass.value > male.mass.value


def test_a_longer_measured_shank_means_a_longer_leg():
    com, measured = (
        expected_leg(*SUBJECT, shank_length=length).com_distance.value for length in (None, 0.48)
    )
    assert measured > com


def test_scatter_is_at_least_the_disagreement_of_the_tables():
    tables = np.array(
        [
            values(expected_leg(*SUBJECT, table=t, sex="male"))
            for t in ("de_leva", "winter", "dumas")
        ]
    )
    spread = tables.std(axis=0, ddof=1) / tables.mean(axis=0)
    leg = expected_leg(*SUBJECT, table="de_leva", sex="male")
    each = (leg.mass, leg.com_distance, leg.inertia)
    assert (spread <= [one.standard_deviation / one.value for one in each]).all()


def test_a_relaxed_knee_is_that_of_the_healthy_pendulum_test():
    leg = expected_leg(*SUBJECT)
    assert 2.6 <= leg.stiffness.value <= 3.2
    assert 0.31 <= leg.damping.value <= 0.41


def test_reach_is_knee_to_toe_and_grows_with_height():
    assert reach(1.80) == pytest.approx(0.55, abs=0.01)
    assert reach(0.9) == pytest.approx(reach(1.80) / 2)


@pytest.mark.parametrize(
    ("body_mass", "height", "message"),
    [
        (77.0, 180.0, "is it in cm"),
        (77.0, 1800.0, "is it in cm"),
        (77.0, float("nan"), "height nan m"),
        (77000.0, 1.80, "grams or pounds"),
        (0.0, 1.80, "grams or pounds"),
        (float("nan"), 1.80, "body_mass nan"),
        (20.0, 1.80, "body mass index of 6.17"),
        (300.0, 1.60, "body mass index of 117"),
    ],
)
@pytest.mark.parametrize("make", [expected_leg, paper_prior])
def test_a_body_that_cannot_be_is_refused(make, body_mass, height, message):
    with pytest.raises(ValueError, match=message):
        make(body_mass, height)


def test_a_shank_in_centimetres_is_refused():
    with pytest.raises(ValueError, match="shank_length 44 m does not fit"):
        expected_leg(*SUBJECT, shank_length=44.0)


def test_a_capsule_shorter_than_its_ends_is_refused():
    with pytest.raises(ValueError, match="the length includes both round ends"):
        capsule_inertia(3.85, 0.08, 0.05)


@pytest.mark.parametrize(
    ("body", "said", "impossible"),
    [
        (
            (150.0, 1.72, None),
            "as hardly anybody does (51 kg/m2). Is that right? It would be 68",
            0,
        ),
        ((11.0, 1.72, None), "as nobody does. Which of them is wrong? It would be 69.9 kg if", 1),
        ((31.0, 1.65, 40.0), "(11 kg/m2). Is that right?", 0),
        ((7.7, None, 40.0), "weighs 7.7 kg at 40 years. Is a digit missing?", 1),
    ],
)
def test_a_body_that_hardly_anybody_has_is_doubted_with_the_unit_that_would_mend_it(
    body, said, impossible
):
    (doubt,) = doubts(*body)
    assert said in doubt.says
    assert doubt.impossible == bool(impossible)


@pytest.mark.parametrize(
    "body", [(68.0, 1.72, None), (133.0, 1.72, None), (12.1, 1.0, 3.0), (150.0, None, None)]
)
def test_a_body_that_some_have_is_not_doubted(body):
    assert doubts(*body) == ()
