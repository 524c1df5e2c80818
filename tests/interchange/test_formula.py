"""Formulas that are read off terms, and their value in single precision."""

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from joints import SEGMENT, TERMS, THIGH, case, of_term, usual

import exoid
from exoid.interchange.formula.expression import evaluate, make, number, symbol
from exoid.interchange.formula.single import functions, single
from exoid.interchange.formula.spell import Language, lines, spell
from exoid.physics.moment import Moment, SegmentConstants
from exoid.physics.motion.simulate import cycle_of

ROUNDING = 1e-12  # relative: the same operations, here and there in another order
ULP = float(np.finfo(np.float32).eps)


@pytest.mark.parametrize("name", TERMS)
def test_the_formulas_of_a_term_are_what_it_computes(name):
    made = of_term(name)
    (part,), (term,) = made.joint.parts, made.model.terms
    random = np.random.default_rng(1)
    place = SegmentConstants(
        made.model.ratios(),
        jnp.asarray(made.model.leg.inertia),
        cycle_of(made.model.torque),
        jnp.asarray(float(SEGMENT)),
    )
    for _ in range(20):
        time, angle, rate, pull = random.uniform([0, -2, -6, -30], [2, 0.1, 6, 30])
        memory = random.normal(size=part.begun.size) * 0.02
        now = Moment(*map(jnp.asarray, (time, angle, rate, pull)), place)
        state = {"time": time, "angle": angle, "rate": rate, "acceleration": pull}
        own = {f"{name}_memory_{at}": value for at, value in enumerate(memory)}
        values = made.joint.constants | state | own
        shown = term.shown(now, jnp.asarray(memory))
        pairs = [
            (part.torque, term.torque(now, jnp.asarray(memory))),
            (part.friction, term.dry_friction(now)),
            (part.shown_angle, shown.angle),
            (part.shown_rate, shown.angular_velocity),
            (part.delay, shown.delay),
            *zip(part.rates, term.memory_rate(now, jnp.asarray(memory)), strict=True),
            *zip(part.within, term.memory_within(now, jnp.asarray(memory)), strict=True),
        ]
        for formula, wanted in pairs:
            found = evaluate(formula, values)
            assert abs(found - wanted) <= ROUNDING * max(1.0, abs(float(wanted)))


class Detent(exoid.PhysicsTerm):
    """tau = -D tanh(phi / w) max(0, 1 - phi^2): no term of the library."""

    title = "a detent"
    reference = explanation = isolate = "tests"
    depth: jax.Array = exoid.parameter("D", "N m", 0.0, 5.0, "depth", (0.4,))

    def torque(self, now, memory):
        open_ = jnp.where(now.angle**2 < 1, 1 - now.angle**2, 0.0)
        return -self.depth * jnp.tanh(now.angle / 0.2) * open_


class Special(exoid.PhysicsTerm):
    """A torque that takes a function which no other tool has."""

    title = "special"
    reference = explanation = isolate = "tests"
    size: jax.Array = exoid.parameter("S", "N m", 0.0, 5.0, "size", (0.4,))

    def torque(self, now, memory):
        return -self.size * jax.scipy.special.erf(now.angle)


def test_a_term_of_a_users_own_has_formulas_too():
    made = case(Detent(jnp.asarray(0.4)))
    (part,) = made.joint.parts
    assert part.hangs_on == {"angle"}
    for angle in (-1.3, -0.4, 0.2):
        wanted = -0.4 * np.tanh(angle / 0.2) * max(0.0, 1 - angle**2)
        found = evaluate(part.torque, made.joint.constants | {"angle": angle})
        assert abs(found - wanted) < ROUNDING


def test_what_no_tool_has_a_form_for_is_refused_by_its_name():
    with pytest.raises(ValueError, match=r"^special computes with jax\.lax\.erf, for which"):
        case(Special(jnp.asarray(0.4)))


@given(st.floats(-40.0, 40.0))
def test_the_single_cosine_is_right_to_its_last_bits(angle):
    """Three units of 1 and one of the angle, off which half turns are taken in rounded steps."""
    angle = float(np.float32(angle))
    found = single(functions()["cos"], {"x": angle})
    assert abs(found - np.cos(angle)) < (3 + abs(angle)) * ULP


@given(st.floats(-80.0, 80.0))
def test_the_single_exponential_is_right_to_its_last_bits(power):
    """Three units: its argument is rounded, then the series, then their product."""
    power = float(np.float32(power))
    found = single(functions()["exp"], {"x": power})
    assert abs(found / np.exp(power) - 1) < 3 * ULP


@given(st.floats(-30.0, 30.0))
def test_the_single_tanh_and_sine_are_right_to_their_last_bits(value):
    value = float(np.float32(value))
    assert abs(single(functions()["tanh"], {"x": value}) - np.tanh(value)) < 4 * ULP
    sine = single(functions()["sin"], {"x": value})
    assert abs(sine - np.sin(value)) < (6 + abs(value)) * ULP


def test_what_is_used_twice_is_computed_once_and_brackets_keep_the_order():
    x, y = symbol("x"), symbol("y")
    shared = make("add", x, y)
    both = make("sub", make("mul", shared, shared), make("sub", x, make("sub", y, x)))
    said = lines({"found": both}, Language())
    assert said == ["part_1 = x + y", "found = part_1 * part_1 - (x - (y - x))"]
    names = {"x": 3.0, "y": 5.0}
    exec("\n".join(said), names)
    assert names["found"] == evaluate(both, names) == 63.0
    assert spell(make("div", x, make("neg", number(2.0))), Language()) == "x / (-2.0)"


def test_every_term_has_its_seat_among_its_constants():
    made = case(usual(TERMS["cubic_stiffness"]))
    assert made.joint.constants["thigh_angle"] == THIGH
    assert made.joint.constants["gravity"] == pytest.approx(4.5 * 0.26 * 9.81, rel=1e-12)
