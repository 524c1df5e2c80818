"""Asks exoid, as its command line would be asked, within a worker that has it loaded.

The document is the one that `exoid fit FILE --json OUT` and `exoid diagnose FILE --json OUT` write.
"""

import io
import json
import signal
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import Any

LIMIT = 900  # s of the processor for one answer: a busy machine starves none
TASKS = 16  # answers of one worker, before it gives the memory of their programs back
CRASHED = 3


@dataclass(frozen=True)
class Answer:
    """How a command ended; `document` is its JSON, where it wrote one."""

    code: int  # its exit code; 3: it crashed
    said: str  # its last line, where the code is not 0
    seconds: float
    document: dict[str, Any] | None


def ask_all(questions: dict[Path, list[str]], folder: Path, workers: int) -> Iterator[Path]:
    """Asks the commands of each table, and yields it when its answers are there; those of an
    earlier run are kept.
    """
    folder.mkdir(parents=True, exist_ok=True)
    tables = [table for table, commands in questions.items() if commands]
    for some in batched(tables, TASKS * workers):
        with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
            jobs = {pool.submit(ask, table, questions[table], folder): table for table in some}
            for job in as_completed(jobs):
                job.result()
                yield jobs[job]


def batched(tables: list[Path], size: int) -> Iterator[list[Path]]:
    for first in range(0, len(tables), size):
        yield tables[first : first + size]


def ask(table: Path, commands: list[str], folder: Path) -> None:
    """Writes NAME.COMMAND.json as the command does, .txt with all it printed, .end with its end."""
    for command in commands:
        target = folder / f"{table.stem}.{command}.json"
        ended = target.with_suffix(".end")
        if ended.exists():
            continue
        began = time.monotonic()
        code, printed = run(command, table, target)
        last = (printed.strip().splitlines() or [""])[-1][:300] if code else ""
        target.with_suffix(".txt").write_text(printed, encoding="utf-8")
        end = {"code": code, "said": last, "seconds": round(time.monotonic() - began, 2)}
        ended.write_text(json.dumps(end) + "\n", encoding="utf-8")


def answer_of(folder: Path, name: str, command: str) -> Answer:
    target = folder / f"{name}.{command}.json"
    end = json.loads(target.with_suffix(".end").read_text(encoding="utf-8"))
    written = target.exists()
    return Answer(**end, document=json.loads(target.read_text("utf-8")) if written else None)


def run(command: str, table: Path, target: Path) -> tuple[int, str]:
    """The exit code, and all that was printed."""
    from exoid.cli import silence_libraries
    from exoid.cli.app import app

    silence_libraries()
    said, code = io.StringIO(), 0
    signal.signal(signal.SIGPROF, give_up)
    signal.setitimer(signal.ITIMER_PROF, LIMIT)
    with redirect_stdout(said), redirect_stderr(said):
        try:
            code = app([command, str(table), "--json", str(target)], standalone_mode=False) or 0
        except (Exception, SystemExit) as fault:
            code = explained(fault)
        finally:
            signal.setitimer(signal.ITIMER_PROF, 0)
    return code, said.getvalue()


def explained(fault: BaseException) -> int:
    """The exit code; what the command line does not expect is a crash."""
    from exoid.cli.terminal.faults import explain

    try:
        return explain(fault)
    except Exception as crash:
        print(f"crash: {type(crash).__name__}: {' '.join(str(crash).split())}")
        return CRASHED


def give_up(*_: Any) -> None:
    raise TimeoutError(f"no answer within {LIMIT} s of the processor")
