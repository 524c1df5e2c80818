"""What to do about an error of the operating system."""

import errno

NAME = "Check the name."
RIGHTS = "Ask for the right to it, or name another."
ADVICE = {
    errno.ENOENT: NAME,
    errno.ENOTDIR: NAME,
    errno.EISDIR: "Name a file.",
    errno.ENAMETOOLONG: "Choose a shorter name.",
    errno.EACCES: RIGHTS,
    errno.EPERM: RIGHTS,
    errno.ENOSPC: "Make room there, or name another disk.",
    errno.EDQUOT: "Delete files of yours there, or name another disk.",
    errno.EFBIG: "Name another disk, which takes larger files.",
    errno.EROFS: "Name a disk that can be written to.",
    errno.EIO: "The disk, or the way to it, fails: name another.",
}


def told(fault: OSError) -> str:
    """What the system says, and what to do where that is known: "Reason. Advice."."""
    said = f"{fault.strerror or 'the system does not say why'}."
    advice = ADVICE.get(fault.errno or 0)
    return f"{said} {advice}" if advice else said
