"""What the commands compute, its heavy parts loaded when they run."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

AGREED, RARE = 1.01, 0.01  # r_hat and share of divergences up to which draws are good


def prepare() -> None:
    """Compute in float64, with programs kept in the user's cache folder."""
    import jax

    from exoid.fitting.solve.program_cache import keep_programs_in

    jax.config.update("jax_enable_x64", True)
    keep_programs_in()


def compute(named, each: bool, options: dict):
    """The fit."""
    if each:
        from exoid.fitting.apart.fit_each import fit_each as fit
    else:
        from exoid.fitting.estimate import fit
    return soundly(named, lambda: fit(named, **options))


def diagnosed(named, own, options: dict, told):
    """The diagnosis; programs that are missing are made by two processes."""
    from exoid.fitting.solve.cores.ahead import ahead
    from exoid.mismatch.missing_physics import diagnose as find
    from exoid.mismatch.rehearsal import rehearse

    with ahead(rehearse, named):
        return soundly(named, lambda: find(named, terms=own, told=told, **options))


def soundly(named, work: Callable[[], Any]):
    """What `work` finds, with programs kept between processes; a refusal names the recordings."""
    from exoid.fitting.solve.program_cache import with_sound_programs

    prepare()
    try:
        return with_sound_programs(work)
    except ValueError as fault:
        raise ValueError(f"{', '.join(name for name, _ in named)}: {fault}") from fault


def ask(result):
    """What the recording told."""
    from exoid.trust.identify import identify

    return identify(result)


def profiled(result):
    """The profile of every quantity."""
    from exoid.fitting.errors.profile import profiles

    return profiles(result)


def check_posterior(each: bool) -> None:
    """Refuse what cannot be drawn from, before anything is computed."""
    from exoid.fitting.errors.posterior import check_packages

    if each:
        raise ValueError("--posterior draws around one fit of all segments: leave --each out.")
    check_packages()


def write_posterior(result, seed: int, path: Path) -> str:
    """Draws from the fit in a file, and how far to trust them."""
    from exoid.files.replacing import replacing
    from exoid.fitting.errors.posterior import r_hat, sample, to_netcdf
    from exoid.fitting.solve.program_cache import with_sound_programs

    drawn = with_sound_programs(lambda: sample(result, seed=seed))
    with replacing(path) as part:
        to_netcdf(drawn, part)
    (chains, draws), worst = drawn.diverging.shape, max(r_hat(drawn).values())
    diverging = drawn.diverging.mean()
    said = f"{draws} draws x {chains} chains, r_hat up to {worst:.3f}, {diverging:.1%} divergences"
    if worst <= AGREED and diverging <= RARE:
        return said
    return f"{said}. The chains have not explored it all: take these draws with caution."
