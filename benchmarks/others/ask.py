"""Asks exoid, as its command line would be asked, within a worker that has it loaded.

The document is the one that `exoid fit FILE --json OUT` and `exoid diagnose FILE --json OUT` write.
"""

import io
import json
import signal
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import redirect_stderr, redirect_stdout
from multiprocessing import get_context
from pathlib import Path
from typing import Any

LIMIT = 900  # s of one answer
TASKS = 30  # answers of one worker, before it gives its memory back


def answer_path(folder: Path, name: str, command: str) -> Path:
    return folder / f"{name}.{command}.json"


def ask_all(tables: list[Path], commands: list[str], folder: Path, workers: int):
    """Yields each table when its answers are there; those of an earlier run are kept."""
    folder.mkdir(parents=True, exist_ok=True)
    pool = ProcessPoolExecutor(workers, mp_context=get_context("spawn"), max_tasks_per_child=TASKS)
    with pool:
        jobs = {pool.submit(ask, table, commands, folder): table for table in tables}
        for job in as_completed(jobs):
            job.result()
            yield jobs[job]


def ask(table: Path, commands: list[str], folder: Path) -> None:
    for command in commands:
        target = answer_path(folder, table.stem, command)
        if not target.exists():
            said, fault = run(command, table, target)
            target.with_suffix(".txt").write_text(said, encoding="utf-8")
            if fault is not None and not target.exists():
                target.write_text(json.dumps({"refused": fault}) + "\n", encoding="utf-8")


def run(command: str, table: Path, target: Path) -> tuple[str, str | None]:
    """All that was printed, and why there is no answer."""
    from exoid.cli import explain, silence_libraries
    from exoid.cli.app import app

    silence_libraries()
    said, code = io.StringIO(), 0
    signal.signal(signal.SIGALRM, give_up)
    signal.alarm(LIMIT)
    with redirect_stdout(said), redirect_stderr(said):
        try:
            code = app([command, str(table), "--json", str(target)], standalone_mode=False) or 0
        except (Exception, SystemExit) as fault:
            code = explained(explain, fault)
        finally:
            signal.alarm(0)
    lines = said.getvalue().strip().splitlines() or [""]
    return said.getvalue(), None if code == 0 else f"{code}: {lines[-1][:300]}"


def explained(explain, fault: BaseException) -> int:
    """The exit code; what the command line does not expect is a crash."""
    try:
        return explain(fault)
    except Exception as crash:
        print(f"crash: {type(crash).__name__}: {crash}")
        return 3


def give_up(*_: Any) -> None:
    raise TimeoutError(f"no answer within {LIMIT} s")


def load(path: Path) -> dict[str, Any] | None:
    """An answer, {"refused": why}, or None where nobody asked."""
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None
