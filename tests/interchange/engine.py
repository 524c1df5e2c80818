"""Plays an exported model of MuJoCo as its comment says."""

import mujoco
import numpy as np


def play(text: str, times: np.ndarray) -> np.ndarray:
    """Encoder, gyro, and angle and rate of the knee at `times`, from the keyframe on."""
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    time = torque = None
    if model.nnumeric:
        time, torque = (model.numeric(f"drive_{each}").data for each in ("time", "torque"))
    step, rows = model.opt.timestep, []
    seen = set(np.rint((times - times[0]) / step).astype(int).tolist())
    for number in range(max(seen) + 1):
        if number in seen:
            mujoco.mj_forward(model, data)
            shown = data.sensor("encoder").data[0], -data.sensor("gyro").data[1]
            rows.append([*shown, data.qpos[0], data.qvel[0]])
        if time is not None:
            data.ctrl[0] = np.interp(data.time + step / 2, time, torque)
        mujoco.mj_step(model, data)
    return np.array(rows)
