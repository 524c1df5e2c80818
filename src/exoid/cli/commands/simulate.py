"""exoid simulate: from parameters to a recording."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.inputs.body import given_body
from exoid.cli.inputs.terms import OwnTerms, With, body_in, loaded, model_in, own_terms, terms_asked
from exoid.cli.outputs.destination import Force, check_absent, check_destination
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import patiently

LEG = {"mass": 4.5, "inertia": 0.44, "com_distance": 0.265, "damping": 0.35, "stiffness": 2.8}
ANKLE = 0.40  # m
TINY, HUGE = 1e-3, 1e3  # of a leg's parameters in SI units; beyond them the steps are too coarse
LOWEST, HIGHEST = -180.0, 20.0  # deg, of a start; a drop from there stays within a knee's reach
OVEREXTENDED = 10.0  # deg, beyond which a knee is hypermobile (Beighton's score)
STRONGEST = 250.0  # N m
LONGEST = 120.0  # s, of a movement


def simulate(
    output: Annotated[Path, typer.Argument(help="The table to write (.csv); a sidecar joins it.")],
    mass: Annotated[float | None, typer.Option(help="m [kg], by default 4.5")] = None,
    inertia: Annotated[
        float | None, typer.Option(help="J about the knee [kg m^2], by default 0.44")
    ] = None,
    com_distance: Annotated[
        float | None, typer.Option(help="l, knee to COM [m], by default 0.265")
    ] = None,
    damping: Annotated[float | None, typer.Option(help="d [N m s/rad], by default 0.35")] = None,
    stiffness: Annotated[float | None, typer.Option(help="c [N m/rad], by default 2.8")] = None,
    with_term: With = None,
    terms: OwnTerms = None,
    model: Annotated[
        Path | None,
        typer.Option(help="Leg and terms of a saved result (.nc, .json).", metavar="FILE"),
    ] = None,
    drop: Annotated[
        list[float] | None,
        typer.Option(help="A drop from this angle [deg]; repeat. Default: -10, -35, -55."),
    ] = None,
    cycle: Annotated[
        list[float] | None,
        typer.Option(help="A voluntary cycle from this angle [deg], Eq. 10; repeat."),
    ] = None,
    torque_amplitude: Annotated[float, typer.Option(help="tau of the cycles [N m]")] = -9.5,
    period: Annotated[float, typer.Option(min=0.2, max=LONGEST, help="T of the cycles [s]")] = 1.8,
    duration: Annotated[float, typer.Option(min=0.5, max=LONGEST, help="Of each drop [s]")] = 12.0,
    added_mass: Annotated[float, typer.Option(min=0.0, max=50.0, help="At the ankle [kg]")] = 0.0,
    thigh_angle: Annotated[
        float | None,
        typer.Option(min=-60.0, max=60.0, help="Knee above the hip [deg], by the seat."),
    ] = None,
    body_mass: Annotated[float | None, typer.Option(help="For the sidecar [kg]")] = None,
    height: Annotated[float | None, typer.Option(help="For the sidecar [m]")] = None,
    noise: Annotated[
        bool, typer.Option("--noise/--no-noise", help="Of AS5600 and LSM6DS3.")
    ] = True,
    seed: Annotated[int, typer.Option(min=0, max=2**32 - 1, help="Of the noise.")] = 0,
    force: Force = False,
) -> None:
    """Simulate drops and cycles of a leg, as a recording.

    \b
    Examples:
      exoid simulate leg.csv
      exoid simulate leg.csv --inertia 0.5 --drop -20 --drop -60 --no-noise
      exoid simulate worn.csv --with coulomb_friction=0.3 --with gyro_bias=0.01
      exoid simulate again.csv --model why.nc    the leg that a fit or a diagnosis found
      exoid simulate cycles.csv --cycle -3 --torque-amplitude -9.5 --period 2
    """
    check_destination(output, ("csv",))
    check_absent((output, output.with_suffix(".toml")), force)
    said = {
        "mass": mass,
        "inertia": inertia,
        "com_distance": com_distance,
        "damping": damping,
        "stiffness": stiffness,
    }
    said = {name: value for name, value in said.items() if value is not None}
    own = own_terms(terms)
    saved = None if model is None else loaded(model, own)
    known = None if model is None else model_in(saved, model)
    leg = LEG | ({} if known is None else numbers_of(known.leg)) | said
    check_leg(leg, LEG if known is None else said)
    having = terms_asked(with_term, own, () if known is None else known.terms, valued_all=True)
    check_starts(drop, cycle, torque_amplitude)
    body = given_body(body_mass=body_mass, height=height)
    body = body if saved is None else body_in(saved) | body
    import jax

    jax.config.update("jax_enable_x64", True)
    import jax.numpy as jnp
    import numpy as np

    from exoid.files.counted import counted
    from exoid.physics.leg import LegModel, LegParameters
    from exoid.physics.torque import NoTorque
    from exoid.recordings.declared.subject import Subject
    from exoid.recordings.formats.own_table import write_table
    from exoid.twin.motion import Movement
    from exoid.twin.protocols import record

    drops = [
        Movement(float(np.radians(angle)), duration, None, added_mass, ANKLE if added_mass else 0.0)
        for angle in (drop or ([] if cycle else [-10.0, -35.0, -55.0]))
    ]
    cycles = [Movement(float(np.radians(a)), period, torque_amplitude) for a in cycle or []]
    thigh = 0.0 if known is None else float(known.thigh_angle)
    thigh = thigh if thigh_angle is None else float(np.radians(thigh_angle))
    parameters = LegParameters(**{name: jnp.asarray(value) for name, value in leg.items()})
    recording = patiently(
        lambda: record(
            LegModel(parameters, NoTorque(), jnp.asarray(thigh), having),
            [*drops, *cycles],
            jax.random.key(seed),
            exact=not noise,
            subject=replace(Subject(kind="leg"), **body),
        ),
        "simulating",
    )
    write_table(recording, output)
    segments = counted(len(recording.segments), "segment")
    for line in overextended(drop, cycle):
        say(line, err=True)
    say(f"{output}: {segments}, and {output.with_suffix('.toml')}")


def numbers_of(leg) -> dict[str, float]:
    """The parameters by name."""
    return {name: float(getattr(leg, name)) for name in LEG}


def check_leg(leg: dict[str, float], said: Iterable[str]) -> None:
    """Refuse a body that cannot exist, by what was said of it."""
    for name in said:
        option, value = f"--{name.replace('_', '-')}", leg[name]
        lowest = 0.0 if name in ("damping", "stiffness") else TINY
        if not lowest <= value <= HUGE:
            raise ValueError(f"{option} is {value:g}; it must lie between {lowest:g} and {HUGE:g}.")
    least = leg["mass"] * leg["com_distance"] ** 2
    if leg["inertia"] < least and {*said} & {"mass", "inertia", "com_distance"}:
        raise ValueError(
            f"--inertia {leg['inertia']:g} is less than m l^2 = {least:.3g} kg m^2: "
            "no rigid body has that (Eq. 12)."
        )


def check_starts(
    drop: list[float] | None, cycle: list[float] | None, torque_amplitude: float
) -> None:
    """Refuse angles that no knee reaches, and a torque that no leg has."""
    for name, angles in (("drop", drop), ("cycle", cycle)):
        for angle in angles or []:
            if not LOWEST <= angle <= HIGHEST:
                raise ValueError(
                    f"--{name} is {angle:g} deg; it must lie between {LOWEST:g} and {HIGHEST:g}."
                )
    if not abs(torque_amplitude) <= STRONGEST:
        raise ValueError(
            f"--torque-amplitude is {torque_amplitude:g} N m; "
            f"it must lie between -{STRONGEST:g} and {STRONGEST:g}."
        )


def overextended(drop: list[float] | None, cycle: list[float] | None) -> list[str]:
    """What to say of starts that are more likely flexion with the wrong sign."""
    return [
        f"exoid: --{name} {angle:g} begins with the knee overextended by {angle:g} deg, which few "
        f"can: extension is positive. For {angle:g} deg of flexion say --{name} {-angle:g}."
        for name, angles in (("drop", drop), ("cycle", cycle))
        for angle in angles or []
        if angle > OVEREXTENDED
    ]
