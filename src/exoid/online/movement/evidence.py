"""Which leg foresaw a movement better: the one that all drops before told, or anybody's?"""

from jaxtyping import Array, Float

from exoid.online.movement.knowledge import Course

EVIDENCE = 12.0  # of the logarithm: one in 160 000 if both were as likely


def evidence(course: Course) -> Float[Array, ""]:
    """Log odds of another leg: both filters foresee every sample, one knows the drops before, the
    other only what anatomy expects.
    """
    return course.likelihood[1] - course.likelihood[0]
