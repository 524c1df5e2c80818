"""The command line: one file, one command. Only this floor prints."""

import os
import sys

# Small matrices only: threads of the linear algebra library cost more than they bring.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


def main() -> None:
    """Run a command. Bad input ends with one line and exit code 2, a failed computation with 1."""
    from exoid.cli.app import app

    try:
        app(standalone_mode=False)
        code = 0
    except (Exception, KeyboardInterrupt) as fault:
        code = explain(fault)
    sys.stdout.flush()
    sys.stderr.flush()
    # Tearing down XLA takes a third of a second that nobody needs to wait for.
    os._exit(code)


def explain(fault: BaseException) -> int:
    """Say what went wrong, in one line where the user can mend it; the exit code."""
    from typer import Abort, Exit
    from typer.exceptions import TyperException

    if isinstance(fault, Exit):
        return fault.exit_code
    if isinstance(fault, TyperException):
        fault.show()
        return 2
    if isinstance(fault, Abort | KeyboardInterrupt):
        return 130
    if isinstance(fault, BrokenPipeError):  # the reader of our output has seen enough
        return 0
    if isinstance(fault, ArithmeticError) and not isinstance(fault, ZeroDivisionError):
        print(f"exoid: {fault}", file=sys.stderr)
        return 1
    if isinstance(fault, ValueError | OSError):
        print(f"exoid: {one_line(fault)}", file=sys.stderr)
        return 2
    raise fault


def one_line(fault: Exception) -> str:
    """The message; an error of the operating system as "FILE: reason"."""
    if isinstance(fault, OSError) and fault.strerror:
        return f"{fault.filename}: {fault.strerror}" if fault.filename else fault.strerror
    return " ".join(str(fault).split())
