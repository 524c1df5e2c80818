"""The commands of a study, as one calls them."""

import json
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

SCRIPT = Path(sys.executable).with_name("exoid")


def exoid(*words: object) -> str:
    """What a command says.

    **Raises** `RuntimeError` where it cannot do what it was told.
    """
    said = subprocess.run([SCRIPT, "study", *map(str, words)], capture_output=True, text=True)
    if said.returncode > 1:
        raise RuntimeError(f"study {words[0]} ended with {said.returncode}: {said.stderr}")
    return said.stdout


def run(study: Path, results: Path, workers: int, steps: str = "drops,fit") -> float:
    """What is wrong with a data set is printed, it is run, and the seconds are returned."""
    print(exoid("check", study))
    began = time.monotonic()
    print(exoid("run", study, "-o", results, "--steps", steps, "--workers", workers))
    return time.monotonic() - began


def report(results: Path, quantities: list[str]) -> dict[str, Any]:
    """Groups compared, by its document."""
    document, page = results / "report.json", results / "report.html"
    asked = [word for each in quantities for word in ("--quantity", each)]
    files = ("-o", page, "--json", document, "--force")
    print(exoid("report", results, "--by", "group", *asked, *files))
    return json.loads(document.read_text(encoding="utf-8"))
