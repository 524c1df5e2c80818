"""Results that could not be kept."""


class NotKept(OSError):
    """What was computed could not be written."""
