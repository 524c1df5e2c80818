"""A case as files: NAME.csv, NAME.toml and NAME.truth.json."""

import json
from pathlib import Path

import numpy as np

from .case import Case, draw_case, source_of
from .measure import Segment, measure
from .session import hold_session
from .truth import truth_of


def make(seed: int, number: int, folder: Path, together: int = 1) -> Path:
    """Draw a case and write it; the table's path. What is there already is kept."""
    case = draw_case(seed, number, together)
    table = folder / f"{case.name}.csv"
    told = table.with_suffix(".truth.json")
    if told.exists():
        return table
    session = hold_session(case.physics, case.protocol)
    segments = measure(case, session, source_of(seed, number, 1))
    folder.mkdir(parents=True, exist_ok=True)
    table.write_text(table_text(segments, case.errors.clock), encoding="utf-8")
    table.with_suffix(".toml").write_text(sidecar_text(case), encoding="utf-8")
    truth = truth_of(case, session, segments)
    told.write_text(json.dumps(truth, indent=1) + "\n", encoding="utf-8")
    return table


def table_text(segments: tuple[Segment, ...], clock: float) -> str:
    names = list(segments[0].columns)
    lines = [",".join(("time_s", "segment", *names))]
    for number, each in enumerate(segments):
        time = each.recorded(each.time, clock)
        rows = np.stack([each.columns[name] for name in names], axis=1)
        for t, row in zip(time, rows, strict=True):
            cells = ("" if np.isnan(x) else f"{x:.6f}" for x in row)
            lines.append(",".join((f"{t:.5f}", str(number), *cells)))
    return "\n".join(lines) + "\n"


def sidecar_text(case: Case) -> str:
    """What the people who recorded it wrote down."""
    person, device = case.person, case.device
    subject, sensors = {}, {}
    if person.body_mass is not None:
        subject = {"body_mass_kg": person.body_mass, "height_m": person.height}
    if device.declared:
        sensors["angle_noise_rad"] = float(f"{device.angle_noise:.3g}")
        if device.velocity_noise is not None:
            sensors["velocity_noise_rad_s"] = float(f"{device.velocity_noise:.3g}")
    if device.declared and device.counts:
        sensors["encoder_counts"] = device.counts
    lines = ["[subject]", 'kind = "leg"', *entries(subject), "", "[protocol]", 'kind = "passive"']
    return "\n".join([*lines, "", "[sensors]", *entries(sensors)]) + "\n"


def entries(table: dict[str, float | int]) -> list[str]:
    return [f"{key} = {value}" for key, value in table.items()]
