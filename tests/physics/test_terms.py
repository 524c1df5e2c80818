"""Every term of the library against the laws of mechanics, and the time loop that carries them."""

from functools import cache, partial
from itertools import product

import diffrax
import jax
import jax.numpy as jnp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from jaxtyping import TypeCheckError
from scipy.integrate import trapezoid
from scipy.optimize import brentq

from exoid.physics.leg import GRAVITY, LegModel, LegParameters
from exoid.physics.library import library
from exoid.physics.moment import Cycle, Moment, SegmentConstants
from exoid.physics.motion.after_release import after_release
from exoid.physics.motion.extended_step import extended_step
from exoid.physics.motion.simulate import simulate
from exoid.physics.motion.step import Drive
from exoid.physics.motion.with_terms import at_rest, delayed, missing
from exoid.physics.parameter import declarations
from exoid.physics.state import LegState
from exoid.physics.term import SensorTerm, Term, name_of
from exoid.physics.torque import CycleTorque, NoTorque

LEG = {"mass": 4.4, "inertia": 0.45, "com_distance": 0.27, "damping": 0.35, "stiffness": 2.9}
WEIGHT = LEG["mass"] * LEG["com_distance"] * GRAVITY  # N m
PERIOD = 0.8  # s, so that the cycle's kink at 0.4 s meets a sample at any rate used here
AMPLITUDE = -5.39  # N m
THIGH = 0.1  # rad
COARSE, FINE = 100, 1600  # Hz
PER = FINE // COARSE
STEPS = FINE  # 1 s of the fine grid, 16 s of the coarse one
ROWS = 12  # of parameter values, in one program
LOWEST, HIGHEST = -1.55, -0.26  # rad, of a drop from -15 deg

# Compiling takes nearly all the time of this file; its machine code need not be fast.
QUICK = {"xla_backend_optimization_level": 0, "xla_cpu_use_fusion_emitters": False}

TERMS = {name_of(term): term for term in library()}
FIELDS = {name: [field for field, _ in declarations(term)] for name, term in TERMS.items()}
every_term = pytest.mark.parametrize("name", TERMS)


def names(chosen, faults):
    """These terms; of some of them it is known why they fail."""
    return pytest.mark.parametrize(
        "name",
        [
            pytest.param(
                name,
                marks=pytest.mark.xfail(
                    reason=faults[name], raises=(AssertionError, TypeCheckError)
                ),
            )
            if name in faults
            else name
            for name in chosen
        ],
    )


UNSTABLE = {
    name: "a leg that softens as much as k_3 = -3 truly runs away to infinity"
    for name in ("cubic_stiffness", "slack_cubic_stiffness")
}
DRY = ("coulomb_friction", "stribeck_friction")


def leg(**changes):
    return LegParameters(**{name: jnp.array(float(x)) for name, x in (LEG | changes).items()})


def state(angle=-0.26, velocity=0.5):
    return LegState(jnp.array(angle), jnp.array(float(velocity)))


@cache
def program(name):
    """The motion and its derivative along a change of the parameters, for many values at once.

    One program per term serves every test.
    """

    def one(values, leg, thigh, start, amplitude, time):
        drive = CycleTorque(amplitude, jnp.array(PERIOD), jnp.array(1 / PERIOD), jnp.array(0.0))
        terms = (TERMS[name](*values),) if name else ()
        return simulate(LegModel(leg, drive, thigh, terms), start, time)

    def changed(values, change, *rest):
        return jax.jvp(lambda at: one(at, *rest), (values,), (change,))

    many = jax.vmap(changed, in_axes=(0, 0, None, None, None, None, None))
    return jax.jit(many, compiler_options=QUICK)


def run(name, rows, changes=None, rate=COARSE, start=None, amplitude=AMPLITUDE, **body):
    """The trajectories at these rows of parameter values, and how they change with `changes`."""
    rows = np.asarray(rows, float)
    changes = np.zeros_like(rows) if changes is None else np.asarray(changes, float)
    if len(rows) > ROWS:
        parts = [slice(at, at + ROWS) for at in range(0, len(rows), ROWS)]
        found = [run(name, rows[x], changes[x], rate, start, amplitude, **body) for x in parts]
        return jax.tree.map(lambda *each: np.concatenate(each), *found)

    def filled(values):
        return jnp.array(np.concatenate([values, np.repeat(values[-1:], ROWS - len(rows), axis=0)]))

    both = program(name)(
        filled(rows),
        filled(changes),
        leg(**body),
        jnp.array(THIGH),
        start or state(),
        jnp.array(float(amplitude)),
        jnp.arange(STEPS + 1) / rate,
    )
    return jax.tree.map(lambda x: np.asarray(x)[: len(rows)], both)


def motion(name, rows, **how):
    return run(name, rows, **how)[0]


def plain(start=None, **how):
    """The leg without any term."""
    return usual(**how) if start is None else usual.__wrapped__(start=start, **how)


@cache
def usual(**how):
    """The same from the usual start, for which every term asks again."""
    return jax.tree.map(lambda x: x[0], motion(None, np.zeros((1, 0)), **how))


def starts(name):
    """Where searches begin: the first place of every parameter, the second of every one, ..."""
    places = [
        said.starts(LOWEST, HIGHEST) if callable(said.starts) else said.starts
        for _, said in declarations(TERMS[name])
    ]
    most = max(len(each) for each in places)
    return np.array([[each[min(row, len(each) - 1)] for each in places] for row in range(most)])


def with_values(name, **values):
    """The starts with some parameters at other values."""
    rows = starts(name)
    for field, value in values.items():
        if field in FIELDS[name]:
            rows[:, FIELDS[name].index(field)] = value
    return rows


def overridden(name, method):
    return getattr(TERMS[name], method) is not getattr(Term, method)


# ---------------------------------------------------------------------------- what a term declares


@every_term
@pytest.mark.parametrize("words", ["title", "reference", "explanation", "isolate"])
def test_a_term_says_what_it_is_who_described_it_and_what_would_show_it(name, words):
    said = getattr(TERMS[name], words)
    assert said == said.strip() != ""


@every_term
def test_an_explanation_is_a_sentence(name):
    said = TERMS[name].explanation
    assert said[0].isupper()
    assert said.endswith(".")


@every_term
def test_every_parameter_has_a_unit_a_title_and_a_finite_range(name):
    for _, said in declarations(TERMS[name]):
        assert said.symbol.strip()
        assert said.unit.strip()
        assert said.title.strip()
        assert np.isfinite([said.lower, said.upper]).all()
        assert said.lower < said.upper


# Released from rest, a leg falls: the lowest angle is below, the highest at or above it.
RANGES = [(-1.55, -0.26), (-2.3, -0.8), (-2.9, 0.4), (-1.2, -1.1)]


@every_term
@pytest.mark.parametrize("ends", RANGES)
def test_every_search_begins_somewhere_inside_the_range(name, ends):
    for _, said in declarations(TERMS[name]):
        places = said.starts(*ends) if callable(said.starts) else said.starts
        assert len(places) > 0
        assert all(said.lower <= place <= said.upper for place in places)


@pytest.mark.parametrize("ends", RANGES)
def test_a_stop_is_sought_where_a_leg_in_the_middle_of_its_range_does_not_touch_it(ends):
    said = dict(declarations(TERMS["hard_stop"]))
    angles = product(said["extension_angle"].starts(*ends), said["flexion_angle"].starts(*ends))
    for extension, flexion in angles:
        term = TERMS["hard_stop"](*map(jnp.array, (0.1, extension, flexion, 0.3)))
        now = instant(jnp.array(0.0), jnp.array(np.mean(ends)), jnp.array(0.0))
        assert term.torque(now, jnp.zeros(0)) == 0


# Where absence is not the first parameter at zero.
ABSENT = {
    "encoder_eccentricity": {"sine": 0.0, "cosine": 0.0},
    "encoder_second_harmonic": {"sine": 0.0, "cosine": 0.0},
    "end_range_stiffening": {"extension": 0.0, "flexion": 0.0},
    "fatigue": {"damping_drift": 0.0, "fade": 0.0},
    "hard_stop": {"contact_time": np.inf},  # the longer a bounce, the softer the stop
    "load_friction": {"share": 0.0, "level": 0.0},
    "stribeck_friction": {"excess": 0.0, "level": 0.0},
}
LIMITS = {
    "activation_lag",
    "backlash",
    "cuff_compliance",
}  # absent at no value: their limits are tested


def absent(name):
    return with_values(name, **ABSENT.get(name, {FIELDS[name][0]: 0.0}))


@pytest.mark.parametrize("name", sorted(TERMS.keys() - LIMITS))
def test_a_term_of_size_zero_changes_nothing(name):
    found, bare = motion(name, absent(name), rate=FINE), plain(rate=FINE)
    for each in ("angle", "angular_velocity", "angular_acceleration"):
        # a term may cut steps in parts: of 2e-7 rad at 100 Hz (1/16)^4 are left, 3e-12, times 5 / s
        # for each derivative
        same(getattr(found, each), getattr(bare, each), 1e-10)
    same(found.shown_angle, found.angle, 0)
    same(found.shown_velocity, found.angular_velocity, 1e-13)  # rounding of an interpolation


def same(found, expected, within):
    np.testing.assert_allclose(found, np.broadcast_to(expected, found.shape), rtol=0, atol=within)


def test_what_a_lag_changes_shrinks_in_proportion_to_it():
    found = motion("activation_lag", [[0.002], [0.001]], rate=FINE)
    change = np.abs(found.angle - plain(rate=FINE).angle).max(axis=1)
    assert change[0] < 0.02  # of 1.5 rad
    # the rest is the square of the lag, 0.002 s of 0.4 s
    assert change[0] / change[1] == pytest.approx(2, rel=0.02)


def test_the_stiffer_the_cuffs_the_more_leg_and_frame_are_one_body():
    frame = {"frame_inertia": 0.02, "frame_gravity": 0.8, "hinge_damping": 0.1}
    rows = [
        with_values("cuff_compliance", compliance=x, damping_ratio=0.3, **frame)[0]
        for x in (0.002, 0.001)
    ]
    found = motion("cuff_compliance", rows, rate=FINE)
    one_body = plain(
        rate=FINE,
        inertia=LEG["inertia"] + frame["frame_inertia"],
        mass=LEG["mass"] + frame["frame_gravity"] / (LEG["com_distance"] * GRAVITY),
        damping=LEG["damping"] + frame["hinge_damping"],
    )
    for each in (found.angle, found.shown_angle):
        change = np.abs(each - one_body.angle).max(axis=1)
        assert change[0] < 0.002  # the frame sags by 0.8 N m times the compliance
        assert change[0] / change[1] == pytest.approx(2, rel=0.02)


VOLUNTARY = [name for name, term in TERMS.items() if term.voluntary]


@pytest.mark.parametrize("name", VOLUNTARY)
def test_a_voluntary_term_changes_nothing_where_nothing_is_voluntary(name):
    found = motion(name, starts(name), rate=FINE, amplitude=0)
    same(found.angle, plain(rate=FINE, amplitude=0).angle, 1e-11)  # steps in parts


# ------------------------------------------------------------------------------ finite everywhere


def instant(time, angle, velocity, amplitude=AMPLITUDE, number=0.0, **body):
    """A moment of the leg and the cycle of `program`, with Eq. 9 written out once more."""
    moving = leg(**body)
    cycle = Cycle(*(jnp.asarray(x) for x in (amplitude, PERIOD, 1 / PERIOD, 0.0)))
    sine = jnp.sin(2 * jnp.pi * time / PERIOD)
    torque = jnp.where(time <= PERIOD / 2, -amplitude, amplitude) * sine
    weight = moving.mass * moving.com_distance * GRAVITY * jnp.cos(angle + THIGH)
    passive = moving.stiffness * angle + moving.damping * velocity
    ratios = LegModel(moving, NoTorque(), jnp.array(THIGH)).ratios()
    return Moment(
        time,
        angle,
        velocity,
        (torque - weight - passive) / moving.inertia,
        SegmentConstants(ratios, moving.inertia, cycle, jnp.asarray(number)),
    )


@every_term
def test_all_that_a_term_says_is_finite_wherever_a_leg_may_be(name):
    def everything(values, angle, velocity):
        term, now = TERMS[name](*values), instant(jnp.array(0.5), angle, velocity, number=2.0)
        memory = term.memory_at_rest(now)
        said = (
            term.torque(now, memory),
            term.dry_friction(now),
            term.memory_rate(now, memory),
            term.memory_within(now, memory),
            term.shown(now, memory),
        )
        return sum(jnp.sum(leaf) for leaf in jax.tree.leaves(said))

    each = jax.vmap(jax.value_and_grad(everything, argnums=(0, 1, 2)), in_axes=(None, 0, 0))
    places = jnp.meshgrid(jnp.linspace(-2.5, 0.5, 13), jnp.linspace(-10, 10, 9))
    found = jax.jit(jax.vmap(each, in_axes=(0, None, None)), compiler_options=QUICK)(
        jnp.array(starts(name)), *(x.ravel() for x in places)
    )
    assert all(np.isfinite(leaf).all() for leaf in jax.tree.leaves(found))


@pytest.mark.proof
@every_term
def test_the_motion_is_finite_wherever_a_search_begins(name):
    found = motion(name, starts(name))
    assert all(np.isfinite(leaf).all() for leaf in jax.tree.leaves(found))


@pytest.mark.proof
@every_term
def test_the_gradient_of_what_is_shown_is_finite_where_a_search_begins(name):
    rows, changes = along_every_parameter(starts(name))
    _, slope = run(name, rows, changes)
    assert np.isfinite(slope.shown_angle).all()
    assert np.isfinite(slope.shown_velocity).all()


@pytest.mark.parametrize("name", sorted(TERMS.keys() - LIMITS))
def test_the_gradient_is_finite_where_a_term_is_absent(name):
    rows, changes = along_every_parameter(absent(name))
    _, slope = run(name, rows, changes)
    assert np.isfinite(slope.shown_angle).all()
    assert np.isfinite(slope.shown_velocity).all()


@every_term
def test_the_gradient_is_that_of_central_differences(name):
    rows, changes = along_every_parameter(starts(name)[:1])
    steps = changes * [1e-6 * (said.upper - said.lower) for _, said in declarations(TERMS[name])]
    above, below = (motion(name, rows + move) for move in (steps, -steps))
    _, slope = run(name, rows, changes)
    for each in ("shown_angle", "shown_velocity"):
        change = getattr(above, each) - getattr(below, each)
        expected = change / (2 * steps.sum(axis=1, keepdims=True))
        found = getattr(slope, each)
        second = slice(0, COARSE + 1)
        # 1e-15 of rounding by steps of 1e-6 and less, and the third derivative
        same(found[:, second], expected[:, second], 1e-7 * (1 + np.abs(found[:, second]).max()))


def along_every_parameter(rows):
    """Every row as often as it has parameters, and the change of one parameter each."""
    count = rows.shape[1]
    return np.repeat(rows, count, axis=0), np.tile(np.eye(count), (len(rows), 1))


def corners(name):
    """The ends of all ranges, and these with the first parameter where a search begins."""
    ends = [(said.lower, said.upper) for _, said in declarations(TERMS[name])]
    return np.array(list(product((*ends[0], starts(name)[0, 0]), *ends[1:])))


@names(TERMS, UNSTABLE)
def test_at_100_hz_three_seconds_are_finite_at_the_ends_of_all_ranges(name):
    found = motion(name, corners(name), start=state(velocity=3))
    assert np.isfinite(found.shown_angle[:, : 3 * COARSE]).all()
    assert np.isfinite(found.shown_velocity[:, : 3 * COARSE]).all()


# --------------------------------------------------------------- the time loop against other loops

# Terms with a jump, or with a memory that is brought back after every step.
KINKED = sorted(
    name
    for name in TERMS
    if overridden(name, "dry_friction") or overridden(name, "memory_within") or name == "hard_stop"
)
SMOOTH = sorted(TERMS.keys() - set(KINKED))


@pytest.fixture(scope="module")
def exact():
    """The first second of every smooth term, all in one adaptive integration of order eight."""
    rows = {name: jnp.array(starts(name)) for name in SMOOTH}
    ticks = jnp.arange(COARSE + 1) / COARSE

    def begin(name, values):
        now = instant(jnp.array(0.0), state().angle, state().angular_velocity)
        leg_now = jnp.stack([now.angle, now.angular_velocity])
        return jnp.concatenate([leg_now, TERMS[name](*values).memory_at_rest(now)])

    def rate(name, values, time, phase):
        term, now, memory = TERMS[name](*values), instant(time, phase[0], phase[1]), phase[2:]
        acceleration = now.angular_acceleration + term.torque(now, memory) / now.inertia
        changes = jnp.stack([now.angular_velocity, acceleration])
        return jnp.concatenate([changes, term.memory_rate(now, memory)])

    def shown(name, values, time, phase):
        error = TERMS[name](*values).shown(instant(time, phase[0], phase[1]), phase[2:])
        return jnp.stack([*phase[:2], phase[0] + error.angle])

    def each(what, phases, time=None):
        return {
            name: jax.vmap(lambda values, phase, name=name: what(name, values, time, phase))(
                rows[name], phases[name]
            )
            for name in SMOOTH
        }

    def solve():
        steps = diffrax.PIDController(rtol=1e-10, atol=1e-10)
        solution = diffrax.diffeqsolve(
            diffrax.ODETerm(lambda time, phases, _: each(rate, phases, time)),
            diffrax.Dopri8(),
            0.0,
            1.0,
            1e-3,
            {name: jax.vmap(lambda x, name=name: begin(name, x))(rows[name]) for name in SMOOTH},
            saveat=diffrax.SaveAt(ts=ticks),
            stepsize_controller=diffrax.ClipStepSizeController(
                steps, jump_ts=jnp.array([PERIOD / 2])
            ),
            max_steps=10_000,
        )
        return jax.vmap(lambda time, phases: each(shown, phases, time))(ticks, solution.ys)

    found = jax.jit(solve, compiler_options=QUICK)()
    return {name: np.moveaxis(np.asarray(seen), 0, -1) for name, seen in found.items()}


@pytest.mark.parametrize("name", SMOOTH)
def test_the_steps_agree_with_an_adaptive_method_of_order_eight(name, exact):
    coarse = motion(name, starts(name))
    fine = motion(name, starts(name), rate=FINE)
    angle, velocity, shown = np.moveaxis(exact[name], 1, 0)
    # 100 Hz: 2e-7 rad of the leg alone; a lag of half a step 5e-6, a reflex's threshold 2e-6
    same(coarse.angle[:, : COARSE + 1], angle, 1e-5)
    same(coarse.shown_angle[:, : COARSE + 1], shown, 1e-5)
    # 1600 Hz: where a rate has a kink (|phi'|, a threshold), it costs about 5e-9
    same(fine.angle[:, ::PER], angle, 1e-8)
    same(fine.angular_velocity[:, ::PER], velocity, 1e-7)
    same(fine.shown_angle[:, ::PER], shown, 1e-8)


# In the step in which a jump falls, what jumps acts up to a whole step too long or too short.
JUMPS = {
    "backlash": 1e-4,  # a contact of 12 ms in parts of 0.6 ms, friction of the frame 0.1 mrad
    "coulomb_friction": 1e-3,  # F h / J = 0.05 * 0.01 / 0.45 rad/s, for 1 s
    "hard_stop": 1e-3,  # (h / 8) of the contact's 0.02 s, on the way of a bounce
    "hysteresis": 1e-5,  # a kink, no jump
    "load_friction": 5e-3,  # as Coulomb's, with 5 N m
    "shaped_hysteresis": 1e-5,  # as hysteresis
    "sticking_backlash": 4e-5,  # the frame stops after the turn: phi'' (h / 4)^2 / 8
    "stribeck_friction": 1e-3,  # as Coulomb's, with 0.08 N m
}


@pytest.mark.parametrize("name", KINKED)
def test_steps_of_100_hz_agree_with_16_times_finer_ones(name):
    coarse, fine = (motion(name, starts(name), rate=rate) for rate in (COARSE, FINE))
    for each in ("angle", "shown_angle"):
        found = getattr(coarse, each)[:, : COARSE + 1]
        same(found, getattr(fine, each)[:, ::PER], JUMPS[name])


# ------------------------------------------------------------------------------------------ energy


def free(name, rows, rate=FINE):
    """A leg without damping and torque, for 1 s of the fine grid."""
    return motion(name, rows, rate=rate, amplitude=0, damping=0, start=state(velocity=3))


def leg_energy(angle, velocity):
    """Kinetic, gravity and spring [J]."""
    kinetic = LEG["inertia"] * velocity**2 / 2
    return kinetic + WEIGHT * np.sin(angle + THIGH) + LEG["stiffness"] * angle**2 / 2


def end_range_energy(term, angle, velocity):
    extension = term.extension * term.extension_width * np.exp(angle / term.extension_width)
    bent = np.exp(-(angle + 2.1) / term.flexion_width)
    return extension + term.flexion * term.flexion_width * bent


def stop_energy(term, angle, velocity):
    above = np.maximum(angle - term.extension_angle, 0)
    below = np.maximum(term.flexion_angle - angle, 0)
    return LEG["inertia"] * (np.pi / term.contact_time) ** 2 * (above**2 + below**2) / 2


def axis_energy(term, angle, velocity):
    """(J(phi) - J) phi'^2 / 2, and the integral of (m l(phi) - m l) g cos(phi + thigh) dphi."""
    slope = -term.change / (np.pi / 2)
    tilted = angle + THIGH
    lifted = WEIGHT * slope * (angle * np.sin(tilted) + np.cos(tilted))
    return LEG["inertia"] * 1.6 * slope * angle * velocity**2 / 2 + lifted


# What a term adds to the energy of the leg.
STORED = {
    "torque_bias": lambda term, angle, velocity: -term.bias * angle,
    "stiffness_rest_angle": lambda term, angle, velocity: (
        -LEG["stiffness"] * term.rest_angle * angle
    ),
    "cubic_stiffness": lambda term, angle, velocity: term.coefficient * angle**4 / 4,
    "slack_cubic_stiffness": lambda term, angle, velocity: (
        term.coefficient * (angle - term.slack_angle) ** 4 / 4
    ),
    "end_range_stiffening": end_range_energy,
    "hard_stop": stop_energy,
    "polycentric_axis": axis_energy,
}


def with_term(name, rows, found):
    """The energy of leg and term, a row for each row of parameters."""
    return np.array(
        [
            leg_energy(angle, velocity) + STORED[name](TERMS[name](*row), angle, velocity)
            for row, angle, velocity in zip(rows, found.angle, found.angular_velocity, strict=True)
        ]
    )


def constant(energy, within):
    return np.abs(energy - energy[:, :1]).max() < within


def falling(energy, rounding=1e-13):
    return np.diff(energy, axis=1).max() < rounding


@pytest.mark.parametrize("name", STORED)
def test_a_conservative_term_keeps_the_energy_of_leg_and_term(name):
    rows = with_values(name, damping_ratio=0)
    energy = with_term(name, rows, free(name, rows))
    # Runge-Kutta loses (5 / 1600)^4 / 144 and less; where a stop's spring begins it has a kink
    assert constant(energy, 1e-4 if name == "hard_stop" else 1e-11)


def stribeck_level(term, _, speed):
    return term.level + term.excess * np.exp(-((speed / term.speed) ** 2))


def load_level(term, angle, _):
    carried = WEIGHT * np.cos(angle + THIGH) + LEG["stiffness"] * angle
    return term.level + term.share * np.abs(carried)


# The torque that brakes [N m], and a size that is large.
BRAKES = {
    "coulomb_friction": (lambda term, *_: term.level, {"level": 2.0}),
    "load_friction": (load_level, {"share": 0.5}),
    "stribeck_friction": (stribeck_level, {"excess": 2.0}),
    "quadratic_drag": (lambda term, _, speed: term.coefficient * speed**2, {"coefficient": 1.0}),
    "power_drag": (
        lambda term, _, speed: term.coefficient * speed**term.power,
        {"coefficient": 1.0, "power": 1.5},
    ),
}
brakes = pytest.mark.parametrize("name", BRAKES)
sizes = pytest.mark.parametrize("size", ["where a search begins", "large"])


def braked(name, size):
    return with_values(name, **BRAKES[name][1]) if size == "large" else starts(name)


@brakes
@sizes
@pytest.mark.parametrize("rate", [COARSE, FINE])
def test_a_term_that_brakes_never_raises_the_energy_of_a_free_leg(name, size, rate):
    found = free(name, braked(name, size), rate)
    energy = leg_energy(found.angle, found.angular_velocity)[:, : rate + 1]
    assert falling(energy)


@brakes
@sizes
def test_a_term_that_brakes_takes_its_torque_times_the_way_from_the_energy(name, size):
    rows = braked(name, size)
    found = free(name, rows)
    energy = leg_energy(found.angle, found.angular_velocity)
    moved = zip(rows, found.angle, np.abs(found.angular_velocity), energy, strict=True)
    for row, angle, speed, left in moved:
        power = speed * BRAKES[name][0](TERMS[name](*row), angle, speed)
        lost = trapezoid(power, dx=1 / FINE)
        # trapezoids: h^2; in the step of a turn or a stop, F v h
        assert left[0] - left[-1] == pytest.approx(lost, rel=2e-3)


def test_a_stop_gives_back_no_more_than_it_took():
    rows = starts("hard_stop")
    assert falling(with_term("hard_stop", rows, free("hard_stop", rows)), 1e-11)


def remembered(name, rows):
    """The free leg and the term's own state: (row, time) and (row, time, memory)."""
    none = jnp.zeros(())

    def one(values):
        body = leg(damping=0)
        still = Cycle(none, jnp.ones(()), none, none)
        place = SegmentConstants(
            LegModel(body, NoTorque(), jnp.array(THIGH)).ratios(), body.inertia, still, none
        )
        terms, drive = (TERMS[name](*values),), Drive(none, none, none)

        def advance(at, number):
            after = extended_step(place, terms, at, number / FINE, jnp.array(1 / FINE), drive)
            return after, at

        begin = at_rest(place, terms, state(velocity=3), none, none)
        return jax.lax.scan(advance, begin, jnp.arange(FINE))[1]

    found = jax.jit(jax.vmap(one), compiler_options=QUICK)(jnp.array(rows))
    return jax.tree.map(np.asarray, (found.leg, found.memory[0]))


def relaxing_energy(term, angle, velocity, stretch):
    return term.stiffness * stretch**2 / 2


def yielding_energy(term, angle, velocity, yielded):
    return term.level * term.yield_angle * yielded**2 / 2


def frame_energy(term, angle, velocity, slip, speed):
    lifted = term.frame_gravity * np.sin(angle + slip + THIGH)
    return slip**2 / term.compliance / 2 + term.frame_inertia * speed**2 / 2 + lifted


def soft_energy(term, angle, velocity, across, along, across_rate, along_rate):
    """A part of the leg's mass is not fixed at its radius, but x across and y along from there."""
    mass = term.share * LEG["mass"] * LEG["com_distance"] / term.radius
    away, tilted = term.radius + along, angle + THIGH
    speed = (along_rate - across * velocity) ** 2 + (across_rate + away * velocity) ** 2
    spring = (2 * np.pi * term.frequency) ** 2 * (across**2 + along**2)
    lifted = along * np.sin(tilted) + across * np.cos(tilted)
    return mass * ((speed - (term.radius * velocity) ** 2 + spring) / 2 + GRAVITY * lifted)


def thigh_energy(term, angle, velocity, pitch, speed):
    """The thigh's own, the leg's on a knee that moves, and the spring that feels the difference."""
    rate = 2 * np.pi * term.frequency
    coupling = term.thigh_length * LEG["mass"] * LEG["com_distance"]
    inertia = 1 / (term.compliance * rate**2) + coupling**2 / LEG["inertia"]
    own = (inertia * speed**2 + pitch**2 / term.compliance) / 2
    carried = coupling * speed * velocity * np.cos(angle)
    felt = angle - pitch - term.sag
    return own + carried + LEG["stiffness"] * (felt**2 - angle**2) / 2


# What it adds to the energy, and what makes it conservative (hysteresis always dissipates).
REMEMBERED = {
    "maxwell_element": (relaxing_energy, {"relaxation_time": np.inf}),
    "hysteresis": (yielding_energy, {"level": 0.0}),
    "cuff_compliance": (frame_energy, {"hinge_damping": 0.0, "damping_ratio": 0.0}),
    "wobbling_mass": (soft_energy, {"damping_ratio": 0.0}),
    "moving_base": (thigh_energy, {"damping_ratio": 0.0, "sag": 0.05}),
}


@pytest.mark.parametrize("name", REMEMBERED)
def test_what_a_term_remembers_accounts_for_its_energy(name):
    stored, conservative = REMEMBERED[name]
    kinds = (with_values(name, **conservative), starts(name))
    legs, memory = remembered(name, np.concatenate(kinds))
    energy = leg_energy(legs.angle, legs.angular_velocity) + np.array(
        [
            stored(TERMS[name](*row), angle, velocity, *own.T)
            for row, angle, velocity, own in zip(
                np.concatenate(kinds), legs.angle, legs.angular_velocity, memory, strict=True
            )
        ]
    )
    kept, lost = energy[: len(kinds[0])], energy[len(kinds[0]) :]
    assert constant(kept, 1e-9)  # of 10 J: ten times what 10 Hz lose in steps of 1600 Hz
    assert falling(lost)
    assert (lost[:, -1] < lost[:, 0] - 1e-3).all()


@pytest.mark.proof
@pytest.mark.parametrize("name", [name for name, term in TERMS.items() if term.memory_size])
def test_where_a_fall_from_rest_has_led_tells_what_it_left_in_memory(name):
    """To 1 %, 0.03 s after the release and from the leg's state alone."""
    none, fallen = jnp.zeros(()), round(0.03 * FINE)

    def one(values):
        still = Cycle(none, jnp.ones(()), none, none)
        ratios = LegModel(leg(), NoTorque(), jnp.array(THIGH)).ratios()
        place = SegmentConstants(ratios, jnp.array(LEG["inertia"]), still, none)
        terms, drive = (TERMS[name](*values),), Drive(none, none, none)

        def advance(number, at):
            return extended_step(place, terms, at, number / FINE, jnp.array(1 / FINE), drive)

        held = at_rest(place, terms, state(velocity=0), none, none)
        true = jax.lax.fori_loop(0, fallen, advance, held)
        rising = state(velocity=2.0)  # no fall leads there: it began in motion
        begun = after_release(place, terms, rising, none, none).memory[0]
        stood = at_rest(place, terms, rising, none, none).memory[0]
        told = after_release(place, terms, true.leg, none, none).memory[0]
        return true.memory[0], told, held.memory[0], begun, stood

    found = jax.jit(jax.vmap(one), compiler_options=QUICK)(jnp.array(starts(name)))
    true, told, held, begun, stood = map(np.asarray, found)
    assert np.array_equal(begun, stood)
    assert np.abs(true - held).max() > 1e-4 or name == "activation_lag"  # which no cycle drives
    assert np.abs(told - true).max() < 1e-2 * np.abs(true - held).max() + 1e-12


# ------------------------------------------------------------------------------------ dry friction

dry = pytest.mark.parametrize("name", DRY)


def pull(angle):
    """The torque of gravity and spring [N m]."""
    return -WEIGHT * np.cos(angle + THIGH) - LEG["stiffness"] * angle


def pulled_by(torque):
    """The angle near rest at which gravity and spring pull with a torque."""
    return brentq(lambda angle: pull(angle) - torque, -2.0, -0.5, xtol=1e-15)


def friction_of(name, row):
    """What it takes to start the leg [N m]."""
    return row.sum() if name == "coulomb_friction" else row[0] + row[1]


def large(name):
    return starts(name) if name == "coulomb_friction" else with_values(name, excess=0.5, level=0.5)


@names(DRY, {})
@pytest.mark.parametrize("share", [-0.95, -0.3, 0.45, 0.95])
def test_a_leg_at_rest_stays_where_friction_holds_it(name, share):
    row = large(name)[0]
    angle = pulled_by(share * friction_of(name, row))
    found = motion(name, [row], start=state(angle, 0), amplitude=0)
    assert (found.angular_velocity == 0).all()
    same(found.angle, angle, 1e-14)


@names(DRY, {})
def test_a_leg_that_sticks_does_not_accelerate(name):
    row = large(name)[0]
    angle = pulled_by(0.3 * friction_of(name, row))
    found = motion(name, [row], start=state(angle, 0), amplitude=0)
    assert found.angular_acceleration[0, 0] == 0


@dry
@pytest.mark.parametrize("share", [-1.2, 1.2])
def test_a_leg_that_is_pulled_harder_than_friction_holds_starts_to_move(name, share):
    row = large(name)[0]
    angle = pulled_by(share * friction_of(name, row))
    found = motion(name, [row], start=state(angle, 0), amplitude=0)
    assert np.sign(found.angular_velocity[0, 1]) == np.sign(share)


@dry
def test_a_leg_comes_to_rest_where_friction_can_hold_it(name):
    rows = large(name)
    found = motion(name, rows, amplitude=0)
    held = [friction_of(name, row) for row in rows]
    assert (np.abs(pull(found.angle[:, -1])) <= held).all()
    assert (found.angular_velocity[:, -COARSE:] == 0).all()


@names(DRY, {})
def test_a_leg_that_came_to_rest_stays_there_for_good(name):
    rows = large(name)
    found = motion(name, rows, amplitude=0)
    for row, angle, velocity in zip(rows, found.angle, found.angular_velocity, strict=True):
        held = np.abs(pull(angle)) <= friction_of(name, row)
        stopped = np.flatnonzero(held & (velocity == 0))[0]
        assert (velocity[stopped:] == 0).all()
        assert (angle[stopped:] == angle[stopped]).all()


def test_friction_without_excess_is_coulombs():
    rows = with_values("stribeck_friction", excess=0.0, level=0.3)[:1]
    found, expected = motion("stribeck_friction", rows), motion("coulomb_friction", [[0.3]])
    same(found.angle, expected.angle, 1e-5)  # of half as many parts, each with its turns: 3e-6


# -------------------------------------------------------------------- what single terms stand for


def test_tissue_that_never_relaxes_is_a_spring_that_was_slack_at_the_start():
    stiffness = 1.5
    found = motion("maxwell_element", [[stiffness, np.inf]])
    spring = motion(
        "torque_bias",
        [[stiffness * float(state().angle)]],
        stiffness=LEG["stiffness"] + stiffness,
    )
    same(found.angle, spring.angle, 1e-6)  # RK4 sees the same motion in other coordinates


def test_a_rest_angle_of_the_spring_is_a_constant_torque():
    found = motion("stiffness_rest_angle", starts("stiffness_rest_angle"))
    expected = motion("torque_bias", LEG["stiffness"] * starts("stiffness_rest_angle"))
    same(found.angle, expected.angle, 1e-12)


@pytest.mark.parametrize("angles", [(0.5, -3.0), (1.0, -2.9)])
def test_a_stop_that_the_leg_does_not_reach_changes_nothing(angles):
    values = dict(zip(("extension_angle", "flexion_angle"), angles, strict=True))
    found = motion("hard_stop", with_values("hard_stop", **values), rate=FINE)
    same(found.angle, plain(rate=FINE).angle, 1e-11)  # steps in parts, as above


@pytest.mark.parametrize("contact", [0.02, 0.1])
@pytest.mark.parametrize(("angle", "way"), [(-1.0, 1), (-2.2, -1)])
def test_a_bounce_lasts_the_contact_time_and_gives_the_speed_back(contact, angle, way):
    row = [contact, angle if way > 0 else 1.2, angle if way < 0 else -3.2, 0.0]
    begin = state(angle - way * 0.01, way * 9)
    # no weight to speak of: it would pull the leg out of, or into, the stop
    light = {"mass": 1e-6, "stiffness": 0.0, "damping": 0.0}
    found = motion("hard_stop", [row], rate=FINE, start=begin, amplitude=0, **light)
    inside = np.flatnonzero(way * (found.angle[0] - angle) > 0)
    once = inside[
        : 1 + np.argmax(np.append(np.diff(inside) > 1, True))
    ]  # the far stop sends it back
    assert once.size / FINE == pytest.approx(contact, abs=2 / FINE)
    # (h / 8) of the contact's time may act too long: twice the speed times that share
    back = once[-1] + 2
    assert found.angular_velocity[0, back] == pytest.approx(-way * 9, rel=1e-2)


def test_the_frame_follows_a_leg_with_play_and_rests_while_it_turns():
    (row,) = with_values("sticking_backlash", half_play=0.05)[:1]
    found = motion("sticking_backlash", [row], rate=FINE)
    error = found.shown_angle[0] - found.angle[0]
    inside = np.abs(error) < row[0] * (1 - 1e-5)
    assert np.abs(error).max() <= row[0] + 1e-12
    rests = inside[1:] & inside[:-1]
    assert 0.05 < rests.mean() < 0.95
    assert np.abs(np.diff(found.shown_angle[0])[rests]).max() < 1e-12
    assert np.abs(found.shown_velocity[0, inside]).max() < 1e-12
    same(found.shown_velocity[0, ~inside], found.angular_velocity[0, ~inside], 1e-12)


def test_the_gyro_on_the_frame_shows_the_rate_of_the_angle_that_the_encoder_shows():
    found = motion("cuff_compliance", starts("cuff_compliance"), rate=FINE)
    slope = np.gradient(found.shown_angle, 1 / FINE, axis=1, edge_order=2)
    # h^2 / 6 of the third derivative of the angle: 30 rad/s^3, and a frame ringing at 10 Hz
    same(found.shown_velocity[:, 1:-1], slope[:, 1:-1], 1e-3)


def test_a_leg_that_flexes_slower_than_the_threshold_has_no_reflex():
    row = with_values("stretch_reflex", threshold=4.0, gain=10.0)[:1]
    found, bare = motion("stretch_reflex", row), plain()
    assert np.abs(bare.angular_velocity).max() < 4
    same(found.angle, bare.angle, 1e-6)  # whose steps are longer


def test_a_reflex_waits_until_the_leg_flexes_faster_than_the_threshold():
    begin, row = state(-1.9, 5), with_values("stretch_reflex", threshold=2.0, gain=1.0)[:1]
    found, bare = motion("stretch_reflex", row, start=begin), plain(start=begin)
    assert bare.angular_velocity[0] > 2  # extending counts for nothing
    first = np.flatnonzero(bare.angular_velocity < -2)[0]
    same(found.angle[0, : first + 1], bare.angle[: first + 1], 1e-6)  # whose steps are longer
    assert np.abs(found.angle[0, first : first + 30] - bare.angle[first : first + 30]).max() > 1e-3


def test_a_reflex_only_extends():
    found = motion("stretch_reflex", with_values("stretch_reflex", threshold=0.5, gain=1.0)[:1])
    torque = LEG["inertia"] * (found.angular_acceleration - eq_9(found))
    assert torque.min() > -1e-12
    assert torque.max() > 0.1


def test_a_reflex_sees_a_speed_that_changes_steadily_as_it_was_one_delay_before():
    slope, delay, speed = -8.0, 0.06, -1.0
    term = TERMS["stretch_reflex"](*map(jnp.array, (1.0, 0.5, delay, 0.03)))
    lags = np.arange(1, term.memory_size) / (term.memory_size - 1)  # the last memory is the muscle
    memory = jnp.array([*(speed - slope * delay * lags), 0.0])
    rate = term.memory_rate(instant(jnp.array(0.0), jnp.array(-0.5), jnp.array(speed)), memory)
    same(rate[:-1], slope, 1e-12)


def test_the_encoder_on_a_thigh_that_gave_way_shows_the_angle_that_the_spring_feels():
    (row,) = with_values("moving_base", compliance=0.0, sag=0.07)[:1]
    term, now = TERMS["moving_base"](*row), instant(jnp.array(0.0), jnp.array(-0.5), jnp.array(0.0))
    memory = term.memory_at_rest(now)
    assert term.shown(now, memory).angle == pytest.approx(-0.07)
    assert term.torque(now, memory) == pytest.approx(LEG["stiffness"] * 0.07)


def eq_9(found):
    """phi'' without any term."""

    def one(time, angle, velocity):
        return instant(time, angle, velocity).angular_acceleration

    each = (found.time[0], found.angle[0], found.angular_velocity[0])
    return np.asarray(jax.vmap(one)(*(jnp.array(x) for x in each)))


def test_fatigue_drifts_from_segment_to_segment_of_a_simulation():
    tired = LegModel(leg(), NoTorque(), jnp.array(THIGH), (torque_of_fatigue(),))
    stiff = LegModel(leg(damping=1.3 * LEG["damping"]), NoTorque(), jnp.array(THIGH))
    time = jnp.arange(COARSE + 1) / COARSE
    third = simulate(tired, state(), time, jnp.array(3.0))
    # exactly Eq. 9 with 1.3 d
    np.testing.assert_allclose(third.angle, simulate(stiff, state(), time).angle, atol=1e-12)


def torque_of_fatigue():
    return TERMS["fatigue"](jnp.array(0.1), jnp.array(0.0))


@pytest.mark.parametrize("number", [0.0, 3.0])
def test_damping_drifts_with_the_number_of_the_segment(number):
    now = instant(jnp.array(0.0), jnp.array(-0.5), jnp.array(2.0), number=number)
    term = TERMS["fatigue"](jnp.array(0.1), jnp.array(0.0))
    assert term.torque(now, jnp.zeros(0)) == pytest.approx(-0.1 * number * LEG["damping"] * 2)


@pytest.mark.parametrize("share", [0.1, 0.4, 0.6, 0.9])
def test_a_voluntary_torque_is_asymmetric_fades_and_has_harmonics_as_said(share):
    now = instant(jnp.array(share * PERIOD), jnp.array(-0.5), jnp.array(2.0))
    turn = 2 * np.pi * share
    half = AMPLITUDE if share > 0.5 else -AMPLITUDE  # the sine of Eq. 10 turns its sign

    def torque(name, **values):
        row = with_values(name, **dict.fromkeys(FIELDS[name], 0.0) | values)[0]
        return float(TERMS[name](*row).torque(now, jnp.zeros(0)))

    voluntary = half * np.sin(turn)
    for found, expected in [
        (torque("torque_asymmetry", asymmetry=0.5), 0.5 * voluntary * (share > 0.5)),
        (torque("fatigue", fade=0.2), -0.2 * voluntary * share),
        (torque("torque_harmonic", sine_2=1.0), half * np.sin(2 * turn)),
        (torque("torque_harmonic", sine_3=1.0), half * np.sin(3 * turn)),
        (torque("torque_harmonic", cosine_2=1.0), half * (np.cos(2 * turn) - 1)),
        (torque("torque_harmonic", cosine_3=1.0), half * (np.cos(3 * turn) - 1)),
    ]:
        assert found == pytest.approx(expected, abs=1e-12)


# ----------------------------------------------------------------------------------------- sensors

SENSORS = [name for name, term in TERMS.items() if issubclass(term, SensorTerm)]


@pytest.mark.parametrize("name", [name for name in SENSORS if name != "clock_rate"])
def test_an_error_of_a_sensor_leaves_the_motion_alone(name):
    found, bare = motion(name, starts(name)), plain()
    for each in ("angle", "angular_velocity", "angular_acceleration"):
        same(getattr(found, each), getattr(bare, each), 1e-13)  # another program: rounding


def eccentric(term, angle, velocity):
    return angle + term.sine * np.sin(angle) + term.cosine * np.cos(angle), velocity


def elliptic(term, angle, velocity):
    return angle + term.sine * np.sin(2 * angle) + term.cosine * np.cos(2 * angle), velocity


# What encoder and gyro show.
SHOWN = {
    "angle_offset": lambda term, angle, velocity: (angle + term.offset, velocity),
    "encoder_eccentricity": eccentric,
    "encoder_gain": lambda term, angle, velocity: ((1 + term.gain) * angle, velocity),
    "encoder_second_harmonic": elliptic,
    "gyro_bias": lambda term, angle, velocity: (angle, velocity + term.bias),
    "gyro_scale": lambda term, angle, velocity: (angle, (1 + term.scale) * velocity),
    "clock_rate": lambda term, angle, velocity: (angle, velocity / (1 + term.rate)),
}


def test_by_a_wrong_clock_a_leg_moves_as_by_the_right_one_at_other_times():
    """A recorded second that is 1.02 s long: the gyro, which has no clock, shows true rates."""
    rate = 0.02
    found = motion("clock_rate", [[rate]], rate=FINE, amplitude=0.0)
    true = plain(state(velocity=0.5 / (1 + rate)), rate=FINE, amplitude=0.0)
    ticks = np.arange(found.angle.shape[1]) / FINE
    inside = (1 + rate) * ticks < ticks[-1]
    later = (1 + rate) * ticks[inside]
    # A line between samples errs by an eighth of h^2 times 30 rad/s^2, and 400 rad/s^3.
    angle, velocity = (
        np.interp(later, ticks, each) for each in (true.angle, true.angular_velocity)
    )
    same(found.angle[0, inside], angle, 2e-6)
    same(found.shown_velocity[0, inside], velocity, 2e-5)


@pytest.mark.parametrize("number", [0.0, 3.0])
def test_the_zero_drifts_with_time_and_from_segment_to_segment(number):
    term = TERMS["zero_drift"](jnp.array(0.01), jnp.array(0.002))
    now = instant(jnp.array(0.5), jnp.array(-1.0), jnp.array(0.3), number=number)
    assert float(term.shown(now, jnp.zeros(0)).angle) == pytest.approx(0.005 + 0.002 * number)


@pytest.mark.parametrize("samples", [0.5, 1.7])
def test_before_a_leg_was_let_go_a_late_gyro_shows_rest(samples):
    found = late(
        TICKS, -25 * TICKS, jnp.full(TICKS.shape, -25.0), samples * (1 + 0 * TICKS) / COARSE
    )
    same(found, -25 * np.maximum(TICKS - samples / COARSE, 0), 1e-13)


@pytest.mark.parametrize("name", sorted(SHOWN))
def test_a_sensor_shows_what_its_formula_says(name):
    rows = starts(name)
    found = motion(name, rows)
    for number, row in enumerate(rows):
        expected = SHOWN[name](
            TERMS[name](*row), found.angle[number], found.angular_velocity[number]
        )
        same(found.shown_angle[number], expected[0], 1e-14)
        same(found.shown_velocity[number], expected[1], 1e-13)  # rounding of an interpolation


@pytest.mark.parametrize("samples", [-3, 2])
def test_a_gyro_read_late_by_whole_samples_shows_earlier_samples(samples):
    found = motion("sensor_skew", [[samples / COARSE]])
    moved = np.roll(found.angular_velocity[0], samples)
    inner = slice(5, -5)
    same(found.shown_velocity[0, inner], moved[inner], 1e-12)


def sine(time):
    """A signal of 2 Hz and its slope."""
    return jnp.sin(4 * jnp.pi * time), 4 * jnp.pi * jnp.cos(4 * jnp.pi * time)


TICKS = jnp.arange(201) / COARSE
late = jax.jit(delayed)


@given(st.floats(-0.06, 0.06))
def test_a_delayed_sine_is_the_sine_of_an_earlier_time(delay):
    found = late(TICKS, *sine(TICKS), jnp.full(TICKS.shape, delay))
    inner = slice(7, -7)
    # cubic Hermite: h^4 / 384 of the fourth derivative
    within = 1e-8 / 384 * (4 * np.pi) ** 4 * 1.001 + 1e-14
    same(found[inner], sine(TICKS - delay)[0][inner], within)


def test_the_delay_may_differ_from_sample_to_sample_and_the_samples_lie_unevenly():
    steps = np.random.default_rng(0).uniform(0.002, 0.01, 300)
    time = jnp.array(np.cumsum(steps))
    delay = 0.03 * jnp.sin(7 * time)
    found = late(time, *sine(time), delay)
    inner = slice(20, -20)
    same(found[inner], sine(time - delay)[0][inner], 1e-8 / 384 * (4 * np.pi) ** 4 * 1.001)


@pytest.mark.parametrize("delay", [-0.5, 0.0, 0.013, 0.5])
def test_a_straight_line_goes_on_beyond_its_ends(delay):
    found = late(TICKS, 3 * TICKS - 1, jnp.full(TICKS.shape, 3.0), jnp.full(TICKS.shape, delay))
    same(found, 3 * (TICKS - delay) - 1, 1e-13)


@pytest.mark.parametrize("delay", [0.0, 0.01, 0.0137, -0.02])
def test_the_derivative_with_respect_to_the_delay_is_the_slope_a_moment_before(delay):
    def shown(delay):
        return late(TICKS, *sine(TICKS), jnp.full(TICKS.shape, delay))

    slope = jax.jit(jax.jacfwd(shown))(jnp.array(delay))
    inner = slice(3, -3)
    # the slope of cubic Hermite: sqrt(3) / 216 h^3 of the fourth derivative
    same(slope[inner], -sine(TICKS - delay)[1][inner], 1e-6 * np.sqrt(3) / 216 * (4 * np.pi) ** 4)


# ----------------------------------------------------------------------------------- several terms


@names(("polycentric_axis", "wobbling_mass"), {})
def test_a_torque_turns_the_inertia_that_another_term_leaves(name):
    angle, push = -1.2, 5.0
    term = TERMS[name](*jnp.array(starts(name)[0]))
    now = instant(jnp.array(0.1), jnp.array(angle), jnp.array(1.0))
    own, none = term.memory_at_rest(now), jnp.zeros(0)
    added = missing((term, TERMS["torque_bias"](jnp.array(push))), now, (own, none))
    if name == "polycentric_axis":
        inertia = LEG["inertia"] * (1 - 1.6 * float(term.change) * angle / (np.pi / 2))
    else:
        mass = float(term.share) * LEG["mass"] * LEG["com_distance"] / float(term.radius)
        inertia = LEG["inertia"] - mass * float(term.radius) ** 2
    assert added - missing((term,), now, (own,)) == pytest.approx(push / inertia)


def test_terms_with_memories_of_different_sizes_act_together_in_any_order():
    tissue = TERMS["maxwell_element"](jnp.array(0.5), jnp.array(0.4))
    tone = TERMS["torque_bias"](jnp.array(0.3))

    @partial(jax.jit, compiler_options=QUICK)
    def angle(terms):
        time = jnp.arange(COARSE + 1) / COARSE
        return simulate(LegModel(leg(), NoTorque(), jnp.array(THIGH), terms), state(), time).angle

    same(angle((tissue, tone)), angle((tone, tissue)), 1e-13)
