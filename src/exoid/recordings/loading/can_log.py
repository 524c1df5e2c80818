"""From a CAN log file to a `Recording`: one continuous segment on one clock, and a report."""

from dataclasses import replace
from pathlib import Path

from exoid.recordings.can.clock_rate import CRYSTALLESS, ClockRate
from exoid.recordings.can.dbc import DbcError
from exoid.recordings.can.device_clock import PERIOD
from exoid.recordings.can.frames import CanLogError
from exoid.recordings.can.logs.log_files import read_log
from exoid.recordings.can.node.log import EXO_SENSORS, RAW_TURN, read_exo
from exoid.recordings.can.quality import LogQuality
from exoid.recordings.can.signals import read_signals
from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.declared.sensors import Sensors
from exoid.recordings.declared.subject import Subject
from exoid.recordings.recording import Recording


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
            sensors = sensors_of(sensors, quality)
            protocol = on_times(protocol, quality.clock_rate)
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


def sensors_of(said: Sensors | None, quality: LogQuality) -> Sensors:
    """The node's own where nothing is said of any, and how well its times are known."""
    rate = quality.clock_rate
    factor, uncertainty = (1.0, CRYSTALLESS) if rate is None else (rate.factor, rate.uncertainty)
    sensors = EXO_SENSORS if said in (None, Sensors()) else said
    if sensors is EXO_SENSORS:
        counts = float(quality.encoder_counts or RAW_TURN)
        sensors = replace(sensors, encoder_counts=counts, sample_rate=1 / (PERIOD * factor))
    own = sensors.clock_uncertainty
    return replace(
        sensors,
        clock_uncertainty=uncertainty if own is None else own,
        filter=quality.design if sensors.filter is None else sensors.filter,
        filter_step=PERIOD if sensors.filter_step is None else sensors.filter_step,
    )


def on_times(protocol: Protocol | None, rate: ClockRate | None) -> Protocol | None:
    """Marks were made by the node's seconds, as it runs; they move with the times."""
    if protocol is None or rate is None:
        return protocol

    def moved(marks: tuple[float, ...] | None) -> tuple[float, ...] | None:
        return None if marks is None else tuple(each * rate.factor for each in marks)

    starts, ends = moved(protocol.segment_start), moved(protocol.segment_end)
    return replace(protocol, segment_start=starts, segment_end=ends)
