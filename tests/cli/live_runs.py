"""What tests of `exoid live` share: frames of a session, the lines it wrote, and the truth."""

import json

import numpy as np
from sessions import EPOCH, RATIOS

from exoid.recordings.can.node.config_crc import config_crc
from node_frames import frames

FAST = 1000.0  # frames/s; the node itself sends 310
LIKELY = 4.5  # standard errors within which the truth lies, but for one draw in 100 000
BODY = ("--body-mass", 74, "--height", 1.78)
READY = 60.0  # s in which the estimator is compiled on a busy machine


def as_sent(recording, **options):
    """The frames of a session, as the node sends them."""
    given = {"epoch": EPOCH, "jitter": 0.0, "config_crc": config_crc(), **options}
    return list(frames(recording.segments[0], np.random.default_rng(3), **given))


def rows_of(path) -> list[dict]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def near_truth(ratios: dict) -> None:
    for name, truth in RATIOS.items():
        found = ratios[name]
        assert abs(found["value"] - truth) < LIKELY * found["standard_error"], name
