"""Drops and cycles that a person marks while recording, as the sidecar says them."""

from exoid.recordings.declared.protocol import Kind, Protocol

SHORTEST = 0.2  # s; a shorter segment was a key pressed by mistake


class Marks:
    """Segments on the recording's clock [s]; one may be open."""

    def __init__(self):
        self.closed: list[tuple[Kind, float, float]] = []
        self.open: tuple[Kind, float] | None = None

    def begin(self, kind: Kind, seconds: float) -> None:
        """A segment begins, and the one before it ends."""
        self.end(seconds)
        self.open = (kind, seconds)

    def end(self, seconds: float) -> None:
        """The open segment ends, if one is open and it has lasted."""
        if self.open is not None and seconds - self.open[1] >= SHORTEST:
            self.closed.append((*self.open, seconds))
        self.open = None

    def protocol(self) -> Protocol:
        """What the sidecar says of the closed segments; nothing where there are none."""
        if not self.closed:
            return Protocol()
        kinds, starts, ends = zip(*self.closed, strict=True)
        return Protocol(kind=kinds, segment_start=starts, segment_end=ends)
