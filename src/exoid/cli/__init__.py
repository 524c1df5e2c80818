"""The command line: one file, one command. Only this floor prints."""

import gc
import os
import sys

from exoid.cli.terminal.faults import INTERRUPTED, complain, explain
from exoid.cli.terminal.stopping import end_beside, end_in_order
from exoid.cli.terminal.streams import lost_output, outlast_readers

# Small matrices only: threads of the linear algebra library cost more than they bring.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# XLA writes about its own affairs to stderr, past Python.
os.environ.setdefault("TF_CPP_MIN_LOG_LEVEL", "3")
OBJECTS = 100_000  # between looks for cycles of them: every 700, they take a fiftieth of a command


def main() -> None:
    """Run a command. Bad input ends with one line and exit code 2, a failed computation with 1."""
    try:
        gc.set_threshold(OBJECTS)
        outlast_readers()
        end_in_order()
        silence_libraries()
        from exoid.cli.app import app

        code = app(standalone_mode=False) or 0
        if code == INTERRUPTED:
            code = explain(KeyboardInterrupt())
    except (Exception, KeyboardInterrupt, SystemExit) as fault:
        code = explain(fault)
    if code == INTERRUPTED:
        end_beside()
    if (lost := lost_output()) is not None:
        code = complain(
            f"standard output: {lost.strerror}. What was said there is cut. Make room, or send it "
            "elsewhere.",
            code or 1,
        )
    # Tearing down XLA takes a third of a second that nobody needs to wait for.
    os._exit(code)


def silence_libraries() -> None:
    """What libraries tell developers is not for users; PYTHONWARNINGS still shows it."""
    import logging
    import warnings

    logging.getLogger().addHandler(logging.NullHandler())
    if not sys.warnoptions:
        warnings.simplefilter("ignore")
