"""Studies whose recordings are fitted, one after the other, and what is to be said of them all."""

import argparse
from dataclasses import replace

from exoid.physics.library import library
from exoid.physics.term import name_of
from exoid.studies.engine.settings import Settings

from .replications import replications
from .summary import summary
from .world import World


def by_fits(options: argparse.Namespace) -> None:
    """Each study that is fitted is named, and at the end is a table."""
    world = replace(World().of(options.people), unlike=options.unlike)
    known = {name_of(term): term for term in library()}
    terms = tuple(known[name] for name in options.terms.split(",") if name)
    asked = {"multistart": options.multistart, **({"terms": terms} if terms else {})}
    settings = Settings(("fit",), asked)
    seeds = range(options.seed, options.seed + options.replications)
    studies = list(replications(world, settings, seeds, options.to))
    print("\n".join(summary(world, studies)))
