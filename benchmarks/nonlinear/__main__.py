"""Names what is hidden in EMPS, Silverbox and Bouc-Wen, and simulates what was not seen.

python -m benchmarks.nonlinear                  # ten minutes
python -m benchmarks.nonlinear --only EMPS
"""

import argparse
from dataclasses import replace
from time import perf_counter

import jax

from exoid import diagnose, load
from exoid.fitting.solve.program_cache import keep_programs_in

from .ahead import missed, rms
from .part import first_part, later_part
from .systems import SYSTEMS, System


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.nonlinear",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("--only", choices=[each.name for each in SYSTEMS], action="append")
    options = parser.parse_args()
    jax.config.update("jax_enable_x64", True)
    keep_programs_in()
    for system in SYSTEMS:
        if options.only and system.name not in options.only:
            continue
        if not system.path.exists():
            print(f"{system.name}: skipped, there is no {system.path}")
            continue
        print("\n".join(told(system)), flush=True)


def told(system: System) -> list[str]:
    """What was found in the first part of a system's recording, and what that is worth later."""
    whole = load(system.path).recording
    whole = replace(whole, subject=replace(whole.subject, **system.subject))
    begun, early, later = perf_counter(), first_part(whole), later_part(whole)
    found = diagnose([(system.name, early)], multistart=16)
    seconds = perf_counter() - begun
    before, after = found.before, found.after or found.before
    own = rms(missed(before, later)), rms(missed(after, later))
    lines = [
        f"{system.name}: {found.verdict}, {', '.join(found.selected) or 'no name'} "
        f"(hidden: {' or '.join(system.hidden)}); or {', '.join(found.equivalent) or 'none'}; "
        f"{seconds:.0f} s",
        f"  seen           {rms(missed(before, early, same_begin=True)):.3g} -> "
        f"{rms(missed(after, early, same_begin=True)):.3g} {system.unit} "
        "(Eq. 9 alone -> with what was found)",
        f"  unseen, begun by its first 50 samples  {own[0]:.3g} -> {own[1]:.3g} {system.unit}",
    ]
    if len(whole.segments) == 1:
        split = early.segments[0].time.size
        run = [rms(missed(one, whole, same_begin=True)[split:]) for one in (before, after)]
        lines.append(
            f"  unseen, from the file's first sample {run[0]:.3g} -> {run[1]:.3g} {system.unit}"
        )
    numbers = {**after.parameters, **after.of_terms}
    values = [
        f"{name} {each.value:.5g}" for name, each in numbers.items() if each.value is not None
    ]
    return [
        *lines,
        f"  others: {system.published}",
        f"  told:   {', '.join(values)}",
        f"  others: {system.parameters}",
        "",
    ]


if __name__ == "__main__":
    main()
