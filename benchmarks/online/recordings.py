"""Recordings that others made, followed live and fitted: do both say the same, and as surely?

python -m benchmarks.online.recordings [FOLDER]
"""

import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import exoid
from exoid import online
from exoid.recordings.recording import Recording
from exoid.watching.estimate.expect import expected_of

RATIOS = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
FOLDER = Path(__file__).parents[3] / "shared" / "data"
ANY_RIG = (1.5, 1.5, 1.5)  # of log m, log l and log J / (m l)


@dataclass(frozen=True)
class Said:
    """The ratios and their standard errors, NaN where none is told, and in words how sure it is."""

    values: np.ndarray
    errors: np.ndarray
    words: str


def live(recording: Recording) -> Said:
    """By one sample after the other."""
    model = online.Model(
        online.Unknowns((), recording.protocol.thigh_angle or 0.0), online.node_of(recording)
    )
    expected = expected_of(recording.subject)
    if recording.subject.kind == "rig":
        expected = replace(expected, covariance=tuple(map(tuple, np.diag(np.square(ANY_RIG)))))
    _, said = online.replay(online.init(expected, model), online.samples_of(recording), model)
    told = said.trust[-1] not in (online.Trust.UNEXPLAINED, online.Trust.FAULTY)
    sure = told and said.drops[-1] > 0
    values, errors = (
        each[-1] if sure else np.full(3, np.nan) for each in (said.ratios, said.errors)
    )
    trust = online.Trust(said.trust[-1]).name.lower()
    return Said(values, errors, f"{said.drops[-1]} drops, {trust}")


def batch(recording: Recording) -> Said:
    """By all samples together."""
    found = exoid.fit(recording)
    each = [found.ratios[name] for name in RATIOS]
    values, errors = (
        np.array([getattr(one, what) or np.nan for one in each], float)
        for what in ("value", "standard_error")
    )
    return Said(values, errors, "follows" if found.follows else "does not follow")


def line(name: str, one: Said, other: Said) -> str:
    if np.isnan(one.values).any():
        return f"{name:24} | {one.words:22} | {'none':44} | {other.words}"
    apart = (one.values - other.values) / np.hypot(one.errors, other.errors)
    wider = one.errors / other.errors
    each = zip(one.values, one.errors, strict=True)
    told = "; ".join(f"{value:.2f} ± {error:.2f}" for value, error in each)
    row = [" ".join(f"{one:+.1f}" for one in apart), " ".join(f"{one:.1f}" for one in wider)]
    return f"{name:24} | {one.words:22} | {told:44} | {other.words:15} | {row[0]} | {row[1]}"


def main() -> None:
    folder = Path(sys.argv[1]) if len(sys.argv) > 1 else FOLDER / "real"
    print("recording | live | G, c, d over J | batch | apart, in errors of both | errors over its")
    for path in sorted(folder.glob("*.csv")):
        recording = exoid.load(path, whole=True).recording
        print(line(path.stem, live(recording), batch(recording)), flush=True)


if __name__ == "__main__":
    main()
