"""What is said of a leg's numbers that lean on where its knee's spring is slack."""

import numpy as np

from exoid.fitting.result.remarks.zero.leaning import BENT, LEANING, Leaning

# Of the squares `beyond_noise`, what the torque of a slack spring takes away to first order:
# 0.88 to 1.02 of it where one is, up to 1.01 beside a cubic spring, 0.71 at most beside a
# stiffening end, 0.18 beside friction, drag, a reflex or a drift.
SLACK = (0.8, 1.2)


def slack_angle_remarks(found: Leaning | None) -> list[str]:
    """What of a leg's numbers is `left_open`."""
    if found is None:
        return []
    if found.pushed:
        return [pushed(found)]
    where = seen(found) if found.shown else bent(found)
    return [
        "m l g / J and c / J, what goes with them, and what the encoder shows with the knee "
        "extended hold for a spring that is slack at full extension (Eq. 9), and 'if slack' beside "
        f"± tells how well for others: {where}. 'exoid diagnose' asks where it is slack; the "
        "hanging angle without and with a known mass tells best."
    ]


def of_missed(found: Leaning | None) -> list[str]:
    """That what a fit misses which does not follow its recording is as of a slack spring."""
    if found is None or not SLACK[0] < found.share < SLACK[1]:
        return []
    angle = np.degrees(found.rest_angle[0])
    return [
        "what it misses, or makes up for by zero and tilt, is as of a spring that is slack at "
        f"about phi_r = {angle:.2g} deg (extension is positive), not at 0, as Eq. 9 has it, or "
        "that grows stiffer: 'exoid fit --with stiffness_rest_angle' asks for the one, 'exoid "
        "diagnose' for both."
    ]


def bent(found: Leaning) -> str:
    """How far off both ratios of a leg are whose spring is slack at BENT."""
    first, second = (
        f"{abs(one):.2g} 1/s^2 {'higher' if one > 0 else 'lower'}"
        for one in found.of_ratios.tolist()
    )
    where = f"phi_r = {-np.degrees(BENT):.0f} deg, in flexion,"
    return f"of a leg whose spring is slack at {where} m l g / J is {first}, c / J {second}"


def pushed(found: Leaning) -> str:
    """That a constant torque may act, and how far off the ratios are then."""
    way = "flexion" if found.push < 0 else "extension"
    gravity, stiffness = (found.spread[name] for name in LEANING)
    return (
        "m l g / J and c / J, and what goes with them, hold for a leg on which no constant torque "
        f"acts: a part of what the model misses looks like one of {abs(found.push):.0%} of m l g "
        f"towards {way}, as of a muscle that pulls all the time, a spring that is slack in another "
        "position, or an encoder's zero beside a tilted seat. No drop tells these apart, and the "
        "fit takes a spring and a zero of its own for them: 'if slack' beside ± holds that, which "
        f"leaves m l g / J open by ± {gravity:.2g} 1/s^2, c / J by ± {stiffness:.2g} 1/s^2. The "
        "hanging angle without and with a known mass tells such a torque best."
    )


def seen(found: Leaning) -> str:
    """Where the recording shows it slack, and how far off the ratios may be for that."""
    angle, error = np.degrees(found.rest_angle)
    gravity, stiffness = (found.spread[name] for name in LEANING)
    return (
        f"by this recording it is slack at phi_r = {angle:.2g} ± {error:.2g} deg (extension is "
        f"positive), which leaves m l g / J open by ± {gravity:.2g} 1/s^2, c / J by "
        f"± {stiffness:.2g} 1/s^2"
    )
