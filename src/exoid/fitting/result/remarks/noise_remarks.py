"""What the user should know of the noise of what was recorded, in sentences."""

from collections.abc import Mapping, Sequence
from math import degrees, hypot, pi
from typing import Any

from exoid.fitting.data.movement import Movement
from exoid.fitting.model.systematics import by_recording
from exoid.recordings.signal.both_sensors.leg_tone import LegTone, leg_tone, swing_of
from exoid.recordings.signal.noise import Noise, Play


def noise_remarks(movements: list[Movement]) -> list[str]:
    """Of every recording what its sensors did beside measuring."""
    said, recordings = [], by_recording(movements)
    for each, *_ in recordings:
        where = f" of {each.source}" if len(recordings) > 1 else ""
        said += of_channel(each.noise, f"angle{where}", "deg")
        if each.gyro_noise is not None:
            said += of_channel(each.gyro_noise, f"gyro{where}", "deg/s")
        said += of_times(each, where)
    return said


def of_times(movement: Movement, where: str) -> list[str]:
    """That its times are off, by what scatters more where it changes faster."""
    if not (off := times_off(movement)):
        return []
    return [
        f"the times{where} are off by {off} (one standard deviation): noise grows with how fast "
        "the leg moves, and faster samples count less. Record times by the sensor's own clock; "
        "images that blur look the same."
    ]


def times_off(movement: Movement) -> str:
    """By how much, as each channel tells; nothing where noise does not grow with speed."""
    channels = {"angle": movement.angle_jitter, "gyro": movement.gyro_jitter}
    each = [(name, one.jitter) for name, one in channels.items() if one is not None]
    return " and ".join(f"{1e3 * jitter:.2g} ms by the {name}" for name, jitter in each)


def tone_of(segments: Sequence[Any]) -> LegTone | None:
    """The tone that moves a leg that was let go, beside what the simulation of fitted `segments`
    does; None without a gyro.
    """
    let_go = [one for one in segments if one.kind == "passive" and one.angular_velocity is not None]
    left = [
        (one.time, one.angle - one.simulated_angle, one.angular_velocity - one.simulated_velocity)
        for one in let_go
    ]
    return leg_tone(left, swing_of([(one.time, one.simulated_velocity) for one in let_go]))


def of_leg_tone(tone: LegTone, ratios: Mapping[str, Any], inertia: float | None) -> str:
    """How fast and how far it moves the leg, and the torque that does."""
    turns = 2 * pi * tone.frequency
    spring, drag = (
        sum(ratios[name].value or 0.0 for name in names)
        for names in (("gravity_over_inertia", "stiffness_over_inertia"), ("damping_over_inertia",))
    )
    torque = tone.amplitude * hypot(spring - turns**2, turns * drag)
    for_leg = "" if inertia is None else f" ({torque * inertia:.2g} N m for J = {inertia:.2g})"
    return (
        f"a tone of {tone.frequency:.2g} Hz moves the leg, by {degrees(tone.amplitude):.2g} ± "
        f"{degrees(tone.standard_error):.1g} deg and {degrees(tone.rate):.2g} deg/s either way, as "
        f"encoder and gyro show alike: a torque of about {torque:.2g} 1/s^2 times J{for_leg} would "
        "do that. A tremor, clonus, a motor, or a frame that shakes looks like this; the model has "
        "none of them"
    )


def of_play(play: Play) -> str:
    """How much there is between a leg and its encoder."""
    return (
        f"the encoder stands still over {degrees(play.width):.2f} ± "
        f"{degrees(play.standard_error):.2g} deg where the leg turns back: play between the two. "
        "The gyro tells, and it was taken out."
    )


def of_channel(noise: Noise, channel: str, unit: str) -> list[str]:
    """Wild samples, tones, smoothing, tails, and a declaration that the samples contradict."""
    said = []
    if noise.spikes:
        said.append(
            f"{noise.spikes} of {noise.samples + noise.spikes} samples of the {channel} stand "
            "apart from those around and were left out (noise throws one in half a million as far)."
        )
    if noise.tone is not None:
        said.append(
            f"a steady tone of {noise.tone.frequency:.3g} Hz, {degrees(noise.tone.amplitude):.2g} "
            f"{unit}, was taken out of the {channel}: hum of the mains, as it is or aliased?"
        )
    if noise.drift is not None:
        said.append(
            f"the zero of the {channel} wanders by {degrees(noise.drift):.2g} {unit} (root mean "
            "square); the encoder tells, and it was taken out."
        )
    if noise.play is not None:
        said.append(f"{of_play(noise.play)} Tighten what couples the two.")
    if noise.alike_over:
        said.append(
            f"the errors of the {channel} are alike over about {noise.alike_over:.2g} s, and it "
            f"counts as {degrees(noise.level):.2g} {unit} of noise: it was smoothed or "
            "interpolated, before it came here or from CAN frames of its own to the angle's times. "
            "Smoothing blurs a release; give what was measured, if you have it."
        )
    if noise.heavy:
        said.append(
            f"the noise of the {channel} has heavy tails: standard errors go by its root mean "
            "square."
        )
    if noise.contradicted and noise.declared is not None and noise.measured is not None:
        taken = "theirs counts" if noise.level == noise.measured else "the sidecar's counts"
        said.append(
            f"the sidecar says that the {channel} scatters by {degrees(noise.declared):.2g} "
            f"{unit}, its samples scatter by {degrees(noise.measured):.2g} {unit}: {taken}."
        )
    return said
