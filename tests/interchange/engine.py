"""Plays an exported model of MuJoCo as its comment says."""

import mujoco
import numpy as np
from scipy.interpolate import CubicHermiteSpline, CubicSpline


def play(text: str, times: np.ndarray) -> np.ndarray:
    """Encoder, gyro, and angle and rate of the knee at `times`, from the keyframe on.

    Samples that were not even fall between steps: there a cubic goes through these.
    """
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    time = torque = None
    if model.nnumeric:
        time, torque = (model.numeric(f"drive_{each}").data for each in ("time", "torque"))
    rows = []
    for _ in range(round((times[-1] - times[0]) / model.opt.timestep) + 2):
        mujoco.mj_forward(model, data)
        shown = data.sensor("encoder").data[0], -data.sensor("gyro").data[1]
        rows.append([data.time, *shown, data.qpos[0], data.qvel[0]])
        if time is not None:
            data.ctrl[0] = np.interp(data.time + model.opt.timestep / 2, time, torque)
        mujoco.mj_step(model, data)
    at, encoder, gyro, angle, rate = np.array(rows).T
    return np.stack(
        [
            CubicSpline(at, encoder)(times),
            CubicSpline(at, gyro)(times),
            CubicHermiteSpline(at, angle, rate)(times),
            CubicSpline(at, rate)(times),
        ],
        axis=1,
    )
