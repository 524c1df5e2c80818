"""exoid study run: every recording of a data set through drops, fit and diagnosis."""

from dataclasses import asdict
from pathlib import Path
from typing import Annotated

import typer

from exoid.cli.commands.study.init import Folder
from exoid.cli.inputs.assumptions import Bound, BoundsOption, Fix, Prior, assumed
from exoid.cli.inputs.choices import Clip, Misfit, Seed
from exoid.cli.inputs.data_set import opened
from exoid.cli.inputs.terms import With, terms_asked
from exoid.cli.outputs.destination import Force, Json, check_outputs
from exoid.cli.outputs.results import show
from exoid.cli.outputs.study_run import (
    check_results,
    doubted,
    exchanged_sides,
    kept_when_interrupted,
    print_outcome,
)
from exoid.cli.outputs.written import Outputs
from exoid.cli.terminal.progress import progress
from exoid.cli.terminal.say import say
from exoid.cli.terminal.waiting import in_phases


def run(
    dataset: Folder,
    results: Annotated[
        Path, typer.Option("--output", "-o", help="Folder of the tables.", metavar="RESULTS")
    ],
    steps: Annotated[
        str, typer.Option(help="Of drops, fit and diagnose.", metavar="STEP,...")
    ] = "drops,fit",
    workers: Annotated[
        int | None, typer.Option(min=1, help="Processes of this machine. Else one for every core.")
    ] = None,
    scheduler: Annotated[
        str | None,
        typer.Option(help="The Dask scheduler of a cluster in their place.", metavar="tcp://..."),
    ] = None,
    multistart: Annotated[int, typer.Option(min=1, max=100_000, help="Number of starts.")] = 64,
    seed: Seed = 0,
    prior: Prior = None,
    weight: Annotated[
        float, typer.Option("--lambda", min=0.0, max=1e6, help="Weight of the prior, Eq. 11.")
    ] = 1.0,
    bounds: BoundsOption = "body",
    fix: Fix = None,
    bound: Bound = None,
    smooth: Annotated[int, typer.Option(min=1, help="Samples of the moving average, Eq. 3.")] = 1,
    misfit: Annotated[Misfit, typer.Option(help="paper: Eq. 11 as printed.")] = "weighted",
    clip: Annotated[Clip, typer.Option(help="As of exoid fit.")] = "free",
    with_term: With = None,
    json: Json = None,
    force: Force = False,
) -> None:
    """Measure every recording of a data set, and write the tables.

    recordings.parquet has a row for every recording, quantities.parquet one for every quantity,
    segment and recording. A recording that fails is a row with its reason. What every step
    computed is kept: run again, only what is new, has changed or was not asked before is computed,
    and a run that was killed goes on where it was. Exit code 1: none could be measured.

    \b
    Examples:
      exoid study run study -o results
      exoid study run study -o results --steps drops,fit,diagnose --workers 8
      exoid study run study -o results --with coulomb_friction    where knees rub
      exoid study run archive -o results --scheduler tcp://10.0.0.7:8786
    """
    check_outputs((json, ()), force=force)
    check_results(results)
    if workers is not None and scheduler is not None:
        raise ValueError("--workers are of this machine, --scheduler names others: leave one out.")
    from exoid.studies.dataset.check.check import check_dataset
    from exoid.studies.engine.run_study import check_packages, run_study
    from exoid.studies.engine.settings import Settings

    check_packages()
    asked = {"seed": seed, **assumed(prior, bounds, fix, bound)}
    more = {"multistart": multistart, "weight": weight, "smooth": smooth}
    fitted = {**asked, **more, "misfit": misfit, "clip": clip}
    if with_term:
        fitted["terms"] = terms_asked(with_term, ())
    named = tuple(each.strip() for each in steps.split(","))
    settings = Settings(named, fitted, asked)
    found = opened(dataset)
    checked = in_phases(lambda told: check_dataset(found, 0, told), "looking at recordings")
    say(*doubted(str(dataset), checked.errors))
    with kept_when_interrupted(), progress("recordings") as told:
        made = run_study(found, results, settings, count=workers, scheduler=scheduler, told=told)
    show(lambda console: print_outcome(made, results, console))
    say(*exchanged_sides(results))
    files = Outputs()
    files.put_document(json, lambda: {**asdict(made), "folder": str(results), "steps": named})
    files.end(follows=made.ok + made.partly > 0)
