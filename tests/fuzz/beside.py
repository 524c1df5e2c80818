"""What stands beside a recording or comes of it: DBC files, sidecars, saved results."""

from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from exoid.recordings.can.dbc import EXOID_DBC, DbcError, plan_message, read_dbc
from exoid.recordings.sidecar import read_columns, read_keys, sidecar_text

from .draw import text
from .hdf5 import values_by_pyfive
from .plans import plans_by_canmatrix, rows_of, said_by_tomlkit
from .reading import Format, Reading, Sample

DBC = """VERSION "1"

NS_ :

BS_:

BU_: Knee

BO_ 291 Knee: 8 Knee
 SG_ Angle : 7|16@0- (0.01,0) [-180|180] "deg" Vector__XXX
 SG_ Rate : 16|16@1- (1,0) [-2000|2000] "deg/s" Vector__XXX

BO_ 800 Load: 8 Knee
 SG_ Force : 32|32@1- (1,0) [0|0] "N" Vector__XXX

BO_ 2147484065 Torque: 4 Knee
 SG_ Mode M : 0|8@1+ (1,0) [0|3] "" Vector__XXX
 SG_ Torque m1 : 8|16@1- (0.1,-5) [0|0] "N m" Vector__XXX

CM_ SG_ 291 Angle "of the knee";
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 10000;
BA_DEF_DEF_ "GenMsgCycleTime" 10;
BA_ "GenMsgCycleTime" BO_ 291 20;
SIG_VALTYPE_ 800 Force : 1;
"""
SIDECAR = """title = "a \\u001b[31m \\u202e leg"
[subject]
kind = "leg"
id = "P01"
body_mass_kg = 74.0
notes = '''
two
lines'''
[protocol]
kind = "active"
cycle_period_s = [2.0, 2.5]
[sensors]
angle_noise_deg = 0.1
encoder_counts = 4096
[columns]
raw_angle_deg = "Knee Flexion"
[fit.prior]
damping = [0.1, 0.02]
[other]
deep = {a = [{b = 1979-05-27T07:32:00Z}, {c = inf}]}
"""


@dataclass(frozen=True)
class Kept:
    """A small result."""

    title: str
    values: np.ndarray
    count: int


KEPT = Kept("a fit", np.linspace(0.0, 1.0, 7), 3)


def read_plans(path: Path) -> Reading:
    """The decode plan of every message that can have one."""
    plans, refused = [], []
    for message in read_dbc(path):
        try:
            plans.append(plan_message(message))
        except DbcError as fault:
            refused.append(str(fault))
    return Reading(rows_of(plans), tuple(refused))


def read_beside(path: Path) -> Reading:
    """What a sidecar says; it must also be possible to write it again."""
    tables, extra, notes = read_keys(path)
    sidecar_text(tables["subject"], tables["protocol"], tables["sensors"], extra)
    said = [repr(tables), repr(extra), repr(read_columns(path))]
    return Reading({"said": np.array(said, str)}, notes)


def read_kept(path: Path) -> Reading:
    from exoid.report.saved.document import read

    kept = read(Kept, path)
    told = np.array(kept.title, str), np.array(kept.count)
    return Reading({"values": kept.values, "title": told[0], "count": told[1]}, ())


def kept_sample(suffix: str) -> Sample:
    from exoid.report.saved.document import write

    with TemporaryDirectory() as folder:
        path = Path(folder) / f"kept{suffix}"
        write(KEPT, path)
        return Sample(path.read_bytes())


def beside_formats() -> dict[str, Format]:
    dbc = (Sample(EXOID_DBC.read_bytes()), Sample(DBC.encode()))
    example = files("exoid").joinpath("example", "session.toml").read_bytes()
    sidecars = (Sample(example), Sample(SIDECAR.encode()))
    return {
        "dbc": Format(".dbc", dbc, read_plans, plans_by_canmatrix, drawn=text, stricter=True),
        "sidecar": Format(
            ".toml", sidecars, read_beside, said_by_tomlkit, drawn=text, stricter=True
        ),
    }


def saved_formats() -> dict[str, Format]:
    return {
        f"saved {suffix}": Format(
            f".{suffix}", (kept_sample(f".{suffix}"),), read_kept, oracle, checked=True
        )
        for suffix, oracle in (("nc", values_by_pyfive), ("json", None))
    }
