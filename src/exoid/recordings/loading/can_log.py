"""From a CAN log file to a `Recording`: one continuous segment on one clock, and a report."""

from dataclasses import replace
from pathlib import Path

from exoid.recordings.can.dbc import DbcError
from exoid.recordings.can.frames import CanLogError
from exoid.recordings.can.log_files import read_log
from exoid.recordings.can.node.log import EXO_SENSORS, RAW_TURN, read_exo
from exoid.recordings.can.quality import LogQuality
from exoid.recordings.can.signals import read_signals
from exoid.recordings.recording import Protocol, Recording, Sensors, Subject


def read_can_log(
    path: str | Path,
    *,
    dbc: str | Path | None = None,
    signals: dict[str, str] | None = None,
    strict: bool = False,
    subject: Subject | None = None,
    protocol: Protocol | None = None,
    sensors: Sensors | None = None,
) -> tuple[Recording, LogQuality]:
    """Read a log (.blf .asc .log .trc .csv, and .mf4 with asammdf) and say how good it is.

    Without `dbc` the log is one of the exoskeleton's own node (exoid.dbc). With it, `signals` maps
    channels of `Segment` to "MESSAGE.SIGNAL" or "SIGNAL", with "[unit]" behind it where the DBC
    names none: `{"angle": "Knee.Angle", "angular_velocity": "Gyro.Y [deg/s]"}`.

    What a damaged log still holds is read, and the report names what is missing; with `strict`
    anything missing is an error.

    **Raises** `CanLogError` (one line: what, where, what to do) when nothing can be read, when a
    map does not fit, or when what was read cannot be a knee; `OSError` when a file cannot be
    opened.
    """
    if (dbc is None) != (signals is None):
        raise CanLogError(
            "A DBC and a signal map belong together: give both, or none for a log of the "
            "exoskeleton's own node."
        )
    log = read_log(Path(path))
    try:
        if dbc is not None and signals is not None:
            segment, quality = read_signals(log, Path(dbc), signals)
        else:
            segment, quality = read_exo(log)
            told = replace(EXO_SENSORS, encoder_counts=float(quality.encoder_counts or RAW_TURN))
            sensors = told if sensors in (None, Sensors()) else sensors
        if strict:
            quality.require_complete()
        recording = Recording(
            (segment,), subject or Subject(), protocol or Protocol(), sensors or Sensors()
        )
    except CanLogError:
        raise
    except DbcError as fault:
        raise CanLogError(str(fault)) from fault
    except ValueError as fault:
        raise CanLogError(f"{path}: {fault}") from fault
    return recording, quality
