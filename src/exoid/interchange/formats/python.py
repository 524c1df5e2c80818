"""A script of Python that needs nothing of exoid: the equation, its integrator, its numbers."""

from collections.abc import Iterable, Mapping

import numpy as np

from exoid.interchange.formats.python_frame import FRAME
from exoid.interchange.formula.expression import Expression, known, make, number, symbol
from exoid.interchange.formula.spell import FORMULA, Language, lines
from exoid.interchange.model.described import in_docstring
from exoid.interchange.model.formulas import acceleration, eq9, friction, torque_over_time
from exoid.interchange.model.joint import STILL, Exported, Joint, Kept, Number, Part
from exoid.physics.motion.parts_of_a_step import parts_to_follow
from exoid.physics.term import strikes
from exoid.physics.torque import MeasuredTorque

MOVING = ("time", "angle", "rate", "push")
BUILT_IN = ("max", "min", "abs", "sign")
FORMS = FORMULA | {"and": "({0} and {1})", "or": "({0} or {1})"}
BREAK = "\n    "
UNFORESEEN = 4  # times finer are steps that do not end where something meets
INTERPOLATED = "return float(np.interp(time, measured_at, torque))"


def in_python(name: str) -> str:
    """A constant in capitals; what moves as it is."""
    stem, _, at = name.rpartition("_memory_")
    if stem:
        return f"{stem}_memory[{at}]"
    return name if name in MOVING else name.upper()


def function(name: str) -> str:
    """Of NumPy, whose functions give no number where there is none, and end no script."""
    return name if name in BUILT_IN else f"np.{name}"


WORDS = Language(name=in_python, function=function, forms=FORMS)


def python(joint: Joint) -> Exported:
    """The script."""
    drive = torque_over_time(joint.drive)
    added = "".join(f" + {each.name}" for each in joint.parts if each.pushes)
    return Exported(
        FRAME.format(
            title=in_docstring("\n".join(joint.title)),
            more=in_docstring(f"{added}{''.join(map(explained, joint.parts))}"),
            constants="\n".join(constants(joint)),
            times=f"{float(joint.times[0])!r}, {float(joint.times[-1])!r}, {interval(joint)!r}",
            longest=repr(joint.longest_step),
            pieces=pieces(joint),
            begun=f"{joint.angle!r}, {joint.rate!r}",
            memory=remembered(joint.parts),
            drive=measured(joint.drive)
            if isinstance(joint.drive, MeasuredTorque)
            else body({"torque": drive}),
            acceleration=body({"found": acceleration(joint.parts, symbol("push"))}, joint.parts),
            friction=body({"level": friction(joint.parts)}, joint.parts),
            memory_rate=body(rates(joint.parts), joint.parts, "[{0}]"),
            memory_within=body(within(joint.parts), joint.parts, "[{0}]"),
            shown=body(shown(joint), joint.parts, "({0})"),
        ),
        tuple(kept(joint)),
    )


def interval(joint: Joint) -> float:
    """Between two samples of the recording [s]."""
    return float(np.median(np.diff(joint.times)))


def pieces(joint: Joint) -> int:
    """Pieces of a step: as many as the fastest term asks for, and more for contacts."""
    terms = [type(each.term) for each in joint.parts]
    finer = UNFORESEEN if any(map(strikes, terms)) else 1
    return finer * max(joint.finer, parts_to_follow(terms, interval(joint)))


def remembered(parts: Iterable[Part]) -> list[float]:
    return [float(value) for each in parts for value in each.begun]


def explained(part: Part) -> str:
    """What a term adds, as its class says it."""
    return f"\n\n{part.name}: {part.title}\n    " + "\n    ".join(part.formula.splitlines())


def constants(joint: Joint) -> Iterable[str]:
    """Every number with its error and origin."""
    yield from map(assigned, joint.numbers)
    yield f"GRAVITY = MASS * COM_DISTANCE * 9.81  # m l g: {joint.gravity.origin}"
    for each in ("GRAVITY", "STIFFNESS", "DAMPING"):
        yield f"{each}_OVER_INERTIA = {each} / INERTIA"
    yield f"THIGH_ANGLE = {joint.thigh_angle!r}  # rad, the knee above the hip"
    yield f"NUMBER = {float(joint.number)!r}  # of the segment in its session, from 0"
    yield from map(assigned, joint.drive_numbers or NOBODY)
    for part in joint.parts:
        yield from map(assigned, part.numbers)
    sensing = joint.sensing
    yield f"ZERO = {sensing.zero!r}  # rad, what the encoder shows with the knee extended"
    yield f"GYRO_SCALE = {sensing.gyro_scale!r}  # relative, less 1"
    yield f"GYRO_BIAS = {sensing.gyro_bias!r}  # rad/s"
    yield f"CLOCK = {joint.clock!r}  # true seconds in a recorded one"


NOBODY = tuple(
    Number(name, "", "", "no voluntary torque acts", value) for name, value in STILL.items()
)


def assigned(each: Number) -> str:
    said = f"{each.symbol}: {each.origin}" if each.symbol else each.unit
    return f"{in_python(each.name)} = {each.value!r}  # {said}"


def body(formulas: Mapping[str, Expression], parts: Iterable[Part] = (), form: str = "{0}") -> str:
    """The lines of a function that returns the formulas, the terms' memories unpacked before."""
    said, at = [], 0
    needed = {name for each in formulas.values() for name in each.symbols}
    for part in parts:
        if part.begun.size and any(name.startswith(f"{part.name}_memory") for name in needed):
            said.append(f"{part.name}_memory = memory[{at} : {at + part.begun.size}]")
        at += part.begun.size
    spelled = lines(formulas, WORDS)
    if len(formulas) == 1:
        *spelled, last = spelled
        result = last.partition(" = ")[2]
    else:
        result = ", ".join(formulas)
    return BREAK.join([*said, *spelled, f"return {form.format(result)}"])


def measured(drive: MeasuredTorque) -> str:
    """A torque that was measured, linear between its samples."""
    time, torque = (
        f"[{', '.join(f'{value:.12g}' for value in np.asarray(each))}]"
        for each in (drive.time, drive.torque)
    )
    return BREAK.join((f"measured_at = {time}  # s", f"torque = {torque}  # N m", INTERPOLATED))


def rates(parts: tuple[Part, ...]) -> dict[str, Expression]:
    """How fast the memories change, by what the leg would do without any term."""
    plain = {"acceleration": eq9(symbol("push"))}
    return {
        f"{each.name}_rate_{at}": known(rate, plain)
        for each in parts
        for at, rate in enumerate(each.rates)
    }


def within(parts: Iterable[Part]) -> dict[str, Expression]:
    return {
        f"{each.name}_within_{at}": kept for each in parts for at, kept in enumerate(each.within)
    }


def shown(joint: Joint) -> dict[str, Expression]:
    """Angle and rate with what terms and mounting make of them; the gyro's delay is left to you."""
    angle, rate = symbol("angle"), symbol("rate")
    for each in joint.parts:
        angle = make("add", angle, each.shown_angle)
        rate = make("add", rate, each.shown_rate)
    scale = make("add", number(1.0), symbol("gyro_scale"))
    seen = make("add", make("mul", scale, rate), symbol("gyro_bias"))
    return {"seen_angle": make("add", angle, symbol("zero")), "seen_rate": seen}


def kept(joint: Joint) -> Iterable[Kept]:
    """What became of each thing."""
    yield Kept("leg", "exact", "acceleration(): Eq. 9")
    if joint.driven:
        yield Kept("drive", "exact", "drive()")
    for each in joint.parts:
        if each.pushes:
            where = "acceleration()" if each.friction.value == 0.0 else "friction()"
            yield Kept(each.name, "exact", where)
        if each.delay.value != 0.0:
            yield Kept(each.name, "in words", "a constant: the gyro shows the rate so much later")
        elif each.shows:
            yield Kept(each.name, "exact", "shown()")
    yield Kept("encoder and gyro", "exact", "shown()")
