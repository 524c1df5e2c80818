"""Terms of a user's own: names that a file has already, and what few formulas compute."""

from collections.abc import Mapping
from typing import Any

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from engine import play
from joints import case, played
from test_c import compiled
from test_osim import swung

import exoid
from exoid.interchange.formats.c import c
from exoid.interchange.formats.mjcf import mjcf
from exoid.interchange.formats.osim import osim

SAME = 1e-9  # rad: what the order of additions makes of 200 steps is below it
CLOSE = 1e-5  # rad: a hundredth of an encoder's step
SIZE = 0.3  # N m
NOTHING: dict[str, object] = {}


def own(name: str, torque, field: str = "size", more: Mapping[str, object] = NOTHING):
    """A leg with a term of this name, whose one parameter is `field`."""
    told = {
        **dict.fromkeys(("title", "reference", "explanation", "isolate"), "tests"),
        "__module__": __name__,
        "__annotations__": {field: jax.Array},
        field: exoid.parameter("S", "N m", 0.0, 5.0, "size", (SIZE,)),
        "torque": lambda self, now, memory: torque(getattr(self, field), now),
        **more,
    }
    made: Any = type(name, (exoid.PhysicsTerm,), told)
    return case(made(jnp.asarray(SIZE)))


def steep(size, now):
    return -size * jnp.exp(now.angle) * jnp.abs(now.angle)


NAMES = ("Gravity", "Friction", "Limited", "Abs", "Exp", "Drive")
NUMBERS = {"Thigh": "angle", "Gyro": "scale", "Com": "distance", "Torque": "limit"}


@pytest.mark.parametrize("name", [*NAMES, *NUMBERS])
def test_a_name_that_a_file_has_already_makes_no_other_model(name, tmp_path):
    made = own(name, steep, NUMBERS.get(name, "size"))
    motion = made.motion()
    assert np.abs(played(made.joint)[:, 3] - motion.shown_angle).max() < SAME
    found = play(mjcf(made.joint).text, made.joint.times)
    assert np.abs(found[:, 2] - motion.angle).max() < CLOSE
    compiled(made.joint, tmp_path, ["exoid_leg_passive(angle, rate)"])


def test_what_a_word_of_c_is_called_can_remember(tmp_path):
    def torque(self, now, memory):
        return -self.size * memory[0]

    def rate(self, now, memory):
        return jnp.stack([now.angular_velocity - memory[0]])

    remembering = {"torque": torque, "memory_rate": rate, "memory_size": 1}
    made = own("Float", None, more=remembering)
    compiled(made.joint, tmp_path, ["exoid_leg_passive(angle, rate, memory)"])
    assert "float float_term[1];" in c(made.joint).text


FORMULAS = {
    "Both": lambda size, now: jnp.where(
        (now.angle > -1.2) & ~(now.angular_velocity > 0), -size, size
    ),
    "Either": lambda size, now: jnp.where((now.angle > -1) | (now.angle < -1.5), -size, size),
    "Rounded": lambda size, now: size * jnp.round(5 * now.angle),
    "Rooted": lambda size, now: jnp.where(
        now.angle > -0.7, size * jnp.sqrt(now.angle + 0.7) * (1 + jnp.sqrt(now.angle + 0.7)), 0.0
    ),
    "Vast": lambda size, now: jnp.where(now.angle > 0, -size, size * jnp.exp(1e3 * now.angle)),
}


@pytest.mark.parametrize("name", FORMULAS)
@pytest.mark.filterwarnings("ignore:(invalid value|overflow) encountered")  # where it is not chosen
def test_the_script_computes_all_that_formulas_are_made_of(name):
    made = own(name, FORMULAS[name])
    assert np.abs(played(made.joint)[:, 1] - made.motion().angle).max() < SAME


@pytest.mark.parametrize("more", [jnp.zeros_like, lambda angle: 0.2 - angle, jnp.exp])
def test_a_torque_over_time_counts_once_in_mujoco(more):
    """At the time 0 it is not 0, and beside it stands one that hangs on the angle."""
    made = own("Beat", lambda size, now: size * jnp.cos(7 * now.time) + more(now.angle))
    found = play(mjcf(made.joint).text, made.joint.times)
    assert np.abs(found[:, 2] - made.motion().angle).max() < CLOSE


@pytest.mark.parametrize("name", ["Rounded", "Vast"])
def test_mujoco_gets_no_torque_that_springs_cannot_be(name):
    with pytest.raises(ValueError, match=f"MuJoCo's XML has nothing for {name.lower()} .*Export"):
        mjcf(own(name, FORMULAS[name]).joint)


def test_a_torque_with_a_corner_is_followed_closely():
    made = own("Corner", lambda size, now: -20 * size * jnp.maximum(now.angle + 0.8, 0.0))
    found = play(mjcf(made.joint).text, made.joint.times)
    assert np.abs(found[:, 2] - made.motion(16).angle).max() < CLOSE
    assert mjcf(made.joint).text.count("<fixed ") < 100


def test_opensim_gets_equality_and_no_formula_that_its_parser_lacks():
    def level(size, now):
        return jnp.where(now.angle == -1.0, 50.0, -size * now.angle)

    made = own("Level", level)
    found = swung(osim(made.joint).text, made.joint.times)
    assert np.abs(found - made.motion().angle).max() < CLOSE
    with pytest.raises(ValueError, match=r"nothing of rounded .*it computes round\. Export"):
        osim(own("Rounded", FORMULAS["Rounded"]).joint)
    for name in ("Rooted", "Vast"):
        with pytest.raises(ValueError, match=r"one of them is no number\. Export"):
            osim(own(name, FORMULAS[name]).joint)
