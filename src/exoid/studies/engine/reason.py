"""Why a recording has no result, in one sentence for a table."""

from exoid.files.column_asked import COLUMN
from exoid.files.library_faults import is_ours
from exoid.files.system_errors import told
from exoid.files.visible import visible


def reason_of(fault: BaseException) -> str:
    """What went wrong."""
    if isinstance(fault, MemoryError) or "RESOURCE_EXHAUSTED" in str(fault):
        return "it takes more memory than a worker has: record or cut it shorter."
    if isinstance(fault, OSError) and fault.strerror:
        return visible(told(fault))
    if isinstance(fault, ValueError | ArithmeticError) and is_ours(fault):
        said = COLUMN.sub(r"\1 = \2 below [columns] in its sidecar", str(fault))
        return visible(" ".join(said.split()))
    return (
        "the computation broke down on this recording, which is a fault of exoid "
        f"({type(fault).__name__}). Check its units and marks, and report it with the recording."
    )
