"""A sample that cannot be true, as an error that knows where it is."""


class BadSample(ValueError):
    """A sample that cannot be true, and which it is: a reader adds the line of its file."""

    segment: int
    sample: int


def bad_sample(segment: int, sample: int, message: str) -> BadSample:
    error = BadSample(message)
    error.segment, error.sample = segment, sample
    return error
