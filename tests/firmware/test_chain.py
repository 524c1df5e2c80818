"""From a simulated leg through the emulated node to its parameters, as a user would do it."""

import json
import os
import subprocess
import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
import pytest
from emulated_node import emulated_node, samples_of

from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.torque import NoTorque
from exoid.recordings.loading.can_log import read_can_log
from exoid.twin.motion import Movement
from exoid.twin.protocols import session

LEG = {"mass": 4.5, "inertia": 0.42, "com_distance": 0.26, "damping": 0.33, "stiffness": 2.6}
RATIOS = {
    "gravity_over_inertia": 4.5 * 0.26 * 9.81 / 0.42,
    "stiffness_over_inertia": 2.6 / 0.42,
    "damping_over_inertia": 0.33 / 0.42,
}
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000
LIMIT = 120  # s
SCRIPT = Path(sys.executable).with_name("exoid")


@pytest.mark.slow
def test_what_the_emulated_node_sends_is_recorded_and_fitted(tmp_path):
    drop = Movement(float(np.radians(-12)), 3.0)
    leg = LegModel(LegParameters(**{k: jnp.asarray(v) for k, v in LEG.items()}), NoTorque())
    log = session(leg, [drop], jax.random.key(3)).segments[0]
    lasting = f"{log.time[-1]:.1f}"
    environment = os.environ | {
        "XDG_CACHE_HOME": str(tmp_path),
        "CAN_CONFIG": '{"sleep_after_open": 0}',  # an emulator needs no time to start
    }

    def exoid(*arguments):
        done = subprocess.run(
            [SCRIPT, *map(str, arguments)],
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=LIMIT,
        )
        assert done.returncode == 0, done.stderr

    path, told = tmp_path / "leg.blf", tmp_path / "fit.json"
    body = ("--body-mass", 74, "--height", 1.78)
    with emulated_node(samples_of(log)) as channel:
        exoid("record", "--channel", channel, "-o", path, "--duration", lasting, *body)
    recording, quality = read_can_log(path)
    assert quality.gaps == ()
    assert recording.segments[0].time[-1] == pytest.approx(log.time[-1], abs=1.5)
    exoid("fit", path, "--json", told)
    for name, found in json.loads(told.read_text())["ratios"].items():
        if name in RATIOS:
            assert abs(found["value"] - RATIOS[name]) < LIKELY * found["standard_error"]
