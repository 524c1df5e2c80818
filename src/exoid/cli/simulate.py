"""exoid simulate: from parameters to a recording."""

from pathlib import Path
from typing import Annotated

import typer

ANKLE = 0.40  # m


def simulate(
    output: Annotated[Path, typer.Argument(help="The table to write (.csv); a sidecar joins it.")],
    mass: Annotated[float, typer.Option(help="m [kg]")] = 4.5,
    inertia: Annotated[float, typer.Option(help="J about the knee [kg m^2]")] = 0.44,
    com_distance: Annotated[float, typer.Option(help="l, knee to COM [m]")] = 0.265,
    damping: Annotated[float, typer.Option(help="d [N m s/rad]")] = 0.35,
    stiffness: Annotated[float, typer.Option(help="c [N m/rad]")] = 2.8,
    drop: Annotated[
        list[float] | None,
        typer.Option(help="A drop from this angle [deg]; repeat. Default: -10, -35, -55."),
    ] = None,
    cycle: Annotated[
        list[float] | None,
        typer.Option(help="A voluntary cycle from this angle [deg], Eq. 10; repeat."),
    ] = None,
    torque_amplitude: Annotated[float, typer.Option(help="tau of the cycles [N m]")] = -9.5,
    period: Annotated[float, typer.Option(min=0.2, help="T of the cycles [s]")] = 1.8,
    duration: Annotated[float, typer.Option(min=0.5, help="Of each drop [s]")] = 6.0,
    added_mass: Annotated[float, typer.Option(min=0.0, help="At the ankle [kg]")] = 0.0,
    body_mass: Annotated[float | None, typer.Option(help="For the sidecar [kg]")] = None,
    height: Annotated[float | None, typer.Option(help="For the sidecar [m]")] = None,
    noise: Annotated[
        bool, typer.Option("--noise/--no-noise", help="Of AS5600 and LSM6DS3.")
    ] = True,
    seed: Annotated[int, typer.Option(min=0, help="Of the noise.")] = 0,
) -> None:
    """Simulate drops and cycles of a leg and write them as a recording.

    \b
    Examples:
      exoid simulate leg.csv
      exoid simulate leg.csv --inertia 0.5 --drop -20 --drop -60 --no-noise
      exoid simulate cycles.csv --cycle -3 --torque-amplitude -9.5 --period 2
    """
    if output.suffix != ".csv":
        raise ValueError(f"{output}: the table's name must end in .csv")
    import jax

    jax.config.update("jax_enable_x64", True)
    import jax.numpy as jnp
    import numpy as np

    from exoid.physics.leg import LegModel, LegParameters
    from exoid.physics.torque import NoTorque
    from exoid.recording.recording import Subject
    from exoid.recording.table import write_table
    from exoid.twin.motion import Movement
    from exoid.twin.protocols import record

    leg = LegParameters(*map(jnp.asarray, (mass, inertia, com_distance, damping, stiffness)))
    check_leg(mass, inertia, com_distance, damping, stiffness)
    drops = [
        Movement(float(np.radians(angle)), duration, None, added_mass, ANKLE if added_mass else 0.0)
        for angle in (drop or ([] if cycle else [-10.0, -35.0, -55.0]))
    ]
    cycles = [Movement(float(np.radians(a)), period, torque_amplitude) for a in cycle or []]
    recording = record(
        LegModel(leg, NoTorque()),
        [*drops, *cycles],
        jax.random.key(seed),
        exact=not noise,
        subject=Subject(kind="leg", body_mass=body_mass, height=height),
    )
    write_table(recording, output)
    typer.echo(f"{output}: {len(recording.segments)} segments, and {output.with_suffix('.toml')}")


def check_leg(
    mass: float, inertia: float, com_distance: float, damping: float, stiffness: float
) -> None:
    """Refuse a body that cannot exist."""
    for name, value in (("--mass", mass), ("--inertia", inertia), ("--com-distance", com_distance)):
        if not value > 0:
            raise ValueError(f"{name} is {value:g}; it must be positive.")
    if damping < 0 or stiffness < 0:
        raise ValueError("--damping and --stiffness cannot be negative.")
    if inertia < mass * com_distance**2:
        raise ValueError(
            f"--inertia {inertia:g} is less than m l^2 = {mass * com_distance**2:.3g} kg m^2: "
            "no rigid body has that (Eq. 12)."
        )
