"""A file's last line: its layout, who wrote it, and the SHA-256 of all that comes before.

It is checked before a library parses the file, which a single wrong bit may send round for ever.
HDF5 does not look at what stands behind its end.
"""

import re
from hashlib import sha256
from importlib.metadata import version

from exoid.report.saved.node import DocumentError

LAYOUT = 1
LINE = re.compile(rb"\nexoid document (\d+) of exoid (\S+) sha256 ([0-9a-f]{64})\n\Z")
SAVED = b"\x89HDF", b"{"  # how HDF5 and JSON begin
LENGTH = 200  # bytes, of the longest line
EARLIER = (b"exoid fit", b"format_version")  # in every file of exoid without such a line


def sealed(content: bytes) -> bytes:
    """The content and its line."""
    said = f"\nexoid document {LAYOUT} of exoid {version('exoid')} sha256 ".encode()
    return b"".join([content, said, sha256(content + said).hexdigest().encode(), b"\n"])


def unsealed(content: bytes) -> tuple[bytes, str]:
    """The content as it was written, and the version of exoid that wrote it."""
    found = LINE.search(content, max(0, len(content) - LENGTH))
    if found is None:
        if all(each in content for each in EARLIER):
            raise DocumentError(
                "this was saved by an earlier exoid, in another layout. Save it again."
            )
        if not content.startswith(SAVED):
            raise DocumentError(
                "this is no result of exoid. Of a recording, fit it first, and name what that "
                "saves: exoid fit RECORDING --save RESULT.nc."
            )
        raise DocumentError(
            "this is no result of exoid, or it is not whole. Name another, or save it again."
        )
    layout, writer, digest = (each.decode() for each in found.groups())
    if sha256(content[: found.start(3)]).hexdigest() != digest:
        raise DocumentError(
            "it is damaged, or was changed since exoid saved it (SHA-256). Save it again."
        )
    if int(layout) != LAYOUT:
        raise DocumentError(f"it was saved by exoid {writer} in another layout. Save it again.")
    return content[: found.start()], writer
