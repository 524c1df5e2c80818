"""What to say of movements that are taken for voluntary ones by their shape alone."""

from exoid.recordings.declared.protocol import Protocol
from exoid.recordings.measured.segment import Segment
from exoid.recordings.recording import Recording
from exoid.recordings.signal.condition import classify

LEG = (
    "{} there and back: taken for voluntary movements. A leg that is let go, and caught in its "
    'first swing, moves like that, too: say kind = "passive" in [protocol] if it was.'
)
RIG = (
    "{} there and back, as a voluntary movement does, and no rig makes one. Say what it is in "
    '[protocol]: kind = "passive" of free swings, and segment_start_s and segment_end_s of each.'
)


def of_unsaid(told: Protocol, found: Recording) -> tuple[str, ...]:
    """Nothing where a kind was `told`, or none of the movements that were `found` is like that."""
    alike = [
        n for n, each in enumerate(found.segments) if told.kind is None and there_and_back(each)
    ]
    if not alike:
        return ()
    names = ", ".join(map(str, alike))
    where = f"segment {names} goes" if len(alike) == 1 else f"segments {names} go"
    return ((RIG if found.subject.kind == "rig" else LEG).format(where),)


def there_and_back(segment: Segment) -> bool:
    return segment.applied_torque is None and classify(segment) == "active"
