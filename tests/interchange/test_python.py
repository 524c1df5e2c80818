"""The exported script of Python has the fitted motion, digit by digit."""

import subprocess
import sys

import jax.numpy as jnp
import numpy as np
import pytest
from joints import TERMS, case, of_term, played, run, usual, with_sensing

from exoid.interchange.formats.python import python
from exoid.interchange.model.joint import Sensing
from exoid.physics.term import strikes

SAME = 1e-9  # rad and rad/s: what the order of additions makes of 200 steps is below it
BOUNCES = (3e-4, 2e-3)  # rad and rad/s: the script's steps are finer, and foresee no contact
LATE = ("sensor_skew",)  # whose delay of the gyro is told in words


@pytest.mark.parametrize("name", TERMS)
def test_the_script_moves_and_shows_as_the_model_does(name):
    made = of_term(name)
    script, motion = played(made.joint), made.motion()
    angle, rate = BOUNCES if strikes(TERMS[name]) else (SAME, SAME)
    assert np.abs(script[:, 1] - motion.angle).max() < angle
    assert np.abs(script[:, 2] - motion.angular_velocity).max() < rate
    assert np.abs(script[:, 3] - motion.shown_angle).max() < angle
    if name not in LATE:
        assert np.abs(script[:, 4] - motion.shown_velocity).max() < rate


def test_terms_act_together_and_what_changes_the_inertia_acts_on_them_all():
    names = ("coulomb_friction", "hysteresis", "polycentric_axis", "cubic_stiffness")
    made = case(*(usual(TERMS[name]) for name in names), driven=True)
    script, motion = played(made.joint), made.motion()
    assert np.abs(script[:, 1] - motion.angle).max() < SAME
    assert np.abs(script[:, 2] - motion.angular_velocity).max() < SAME


def test_the_mounting_of_the_recording_is_shown():
    made = with_sensing(case(), Sensing(zero=0.02, gyro_scale=0.01, gyro_bias=0.3))
    script, motion = played(made.joint), made.motion()
    assert np.abs(script[:, 3] - motion.angle - 0.02).max() < SAME
    assert np.abs(script[:, 4] - 1.01 * motion.angular_velocity - 0.3).max() < SAME


def test_the_script_runs_alone_and_prints_its_motion(tmp_path):
    made = case(usual(TERMS["coulomb_friction"]))
    path = tmp_path / "leg.py"
    path.write_text(python(made.joint).text, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-I", path], capture_output=True, text=True, check=True, cwd=tmp_path
    )
    first, *rows = done.stdout.splitlines()
    assert first == "time_s,angle_deg,rate_deg_s,shown_angle_deg,shown_rate_deg_s"
    table = np.array([[float(cell) for cell in row.split(",")] for row in rows])
    assert table.shape == (made.joint.times.size, 5)
    assert np.abs(table[:, 1] - np.degrees(made.motion().angle)).max() < 6e-5  # four decimals
    imports = [line for line in path.read_text().splitlines() if line.startswith("import")]
    assert imports == ["import numpy as np"]


def test_every_number_stands_with_its_error_unit_and_origin():
    made = case(usual(TERMS["hysteresis"]))
    text = python(made.joint).text
    assert "HYSTERESIS_LEVEL = 0.1  # F: ± 0.1 N m" in text
    assert run(text)["GRAVITY"] == pytest.approx(4.5 * 0.26 * 9.81, rel=1e-12)
    assert jnp.isfinite(played(made.joint)).all()
