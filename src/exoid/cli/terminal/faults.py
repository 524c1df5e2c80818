"""What went wrong, in one line for a person, and the exit code of it."""

import re
import sys
from contextlib import suppress
from traceback import walk_tb

from exoid.files.system_errors import told

# Those that compute. What they say of arrays is not for users.
LIBRARIES = ("numpy", "scipy", "jax", "jaxlib", "equinox", "optimistix", "lineax", "diffrax")
ONE_MORE = "Got unexpected extra argument(s) "
INTERRUPTED = 130  # as shells have it: 128 and the number of the signal
UNREAD = re.compile(r"Input should be a valid (number|integer), .*")
UNKNOWN = re.compile(r"No such command '([\w-]+)'")
BEYOND = re.compile(r"Input should be (greater|less) than( or equal to)? (\S+)")
INSTEAD = {  # what to do where an option's value is refused
    "--body-mass": "give it in kg, as --body-mass 72 (a pound is 0.4536 kg)",
    "--height": "give it in m, as --height 1.76",
    "--zero": "of any other angle, as of a straight knee that reads 180 deg, write "
    "angle_zero_deg = 180 below [sensors] of the sidecar",
}


def explain(fault: BaseException) -> int:
    """Say what went wrong, in one line; the exit code."""
    from typer import Abort

    if isinstance(fault, SystemExit | BrokenPipeError):  # the reader of our output has seen enough
        return 0
    if isinstance(fault, Abort | KeyboardInterrupt):
        return complain("interrupted", INTERRUPTED)
    if isinstance(fault, ArithmeticError) and not isinstance(fault, ZeroDivisionError):
        return complain(fault, 1)
    if isinstance(fault, MemoryError) or "RESOURCE_EXHAUSTED" in str(fault):
        return complain("out of memory: use fewer starts, or shorter recordings.", 1)
    if isinstance(fault, ValueError) and foreign(fault):
        return complain(
            "the computation broke down on this recording, which is a fault of exoid. Check its "
            "units and marks, and report it with the recording.",
            1,
        )
    if isinstance(fault, ValueError | OSError):
        return complain(one_line(fault), 2)
    return explain_usage(fault)


def foreign(fault: BaseException) -> bool:
    """Did a library raise it, so that its words are not for users? Names in front do not count."""
    while fault.__cause__ is not None and str(fault).endswith(str(fault.__cause__)):
        fault = fault.__cause__
    frames = list(walk_tb(fault.__traceback__))
    if not frames:
        return False
    return frames[-1][0].f_globals.get("__name__", "").partition(".")[0] in LIBRARIES


def explain_usage(fault: BaseException) -> int:
    """What is wrong in the command line itself; anything else is a fault of ours, and is raised."""
    from typer.exceptions import TyperException

    if not isinstance(fault, TyperException):
        raise fault
    message = " ".join(fault.format_message().replace("Value error, ", "").split())
    message = BEYOND.sub(r"it must be \1 than\2 \3", message)
    message = advised(UNREAD.sub(r"this is no plain \1", message))
    context = getattr(fault, "ctx", None)
    if context is None:
        return complain(message, 2)
    if (extra := message.removeprefix(ONE_MORE)) != message:
        message = f"{context.command_path} takes {taken(context)} only: give {extra.strip('(). ')} "
        message += "a command of its own"
    end = "" if message.endswith("?") else "."
    return complain(f"{message.rstrip('.')}{end} Try '{context.command_path} --help'.", 2)


def advised(message: str) -> str:
    """With what would do instead, where an option's value was refused, or no command is called
    what a function of the library is.
    """
    found = [words for option, words in INSTEAD.items() if f"for '{option}'" in message]
    return "; ".join([message.rstrip("."), *found, *in_python(message)])


def in_python(message: str) -> list[str]:
    """That an unknown command is a function of the library, where it is."""
    import exoid

    found = UNKNOWN.match(message)
    name = found[1].replace("-", "_") if found else ""
    called = name.islower() and name in exoid.__all__
    return [f"it is a function of the library: exoid.{name} in Python"] if called else []


def taken(context) -> str:
    """The arguments that a command takes."""
    each = [one for one in context.command.params if one.param_type_name == "argument"]
    return " and ".join(one.name.upper() for one in each) or "options"


def complain(message: object, code: int) -> int:
    from exoid.cli.terminal.options import as_options
    from exoid.files.visible import visible

    with suppress(OSError):  # nobody is there to read it
        print(visible(as_options(f"exoid: {message}")), file=sys.stderr, flush=True)
    return code


def one_line(fault: Exception) -> str:
    """The message; an error of the operating system as "FILE: reason. What to do."."""
    if not isinstance(fault, OSError) or not fault.strerror:
        return " ".join(str(fault).split())
    return f"{fault.filename}: {told(fault)}" if fault.filename else told(fault)
