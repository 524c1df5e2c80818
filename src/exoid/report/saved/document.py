"""A frozen dataclass as a file: JSON, or netCDF with a group for every dataclass within."""

import json
from collections.abc import Sequence
from hashlib import sha256
from importlib.metadata import version
from io import BytesIO
from pathlib import Path
from typing import Any, TypeVar

from exoid.files.replacing import replacing
from exoid.report.saved.node import DocumentError, OtherLayout, in_json, text
from exoid.report.saved.pack import pack
from exoid.report.saved.read_groups import read_group
from exoid.report.saved.seal import LAYOUT, sealed, unsealed
from exoid.report.saved.unpack import Reader, unpack
from exoid.report.saved.write_groups import write_group

Of = TypeVar("Of")
JSON = ".json"


def write(one: Any, path: Path) -> None:
    """Write a dataclass as netCDF, or as JSON (.json), in full or not at all."""
    content = to_json(one).encode() if path.suffix.lower() == JSON else to_netcdf(one)
    with replacing(path) as part:
        part.write_bytes(content)


def read(of: type[Of], path: Path, *, own: Sequence[type] = ()) -> Of:
    """What `write` was given; `own` are classes of a user that it may hold.

    **Raises** `DocumentError` where the file is another one, or not as it was written.
    """
    take = from_json if path.suffix.lower() == JSON else from_netcdf
    return take(of, path.read_bytes(), own)


def to_netcdf(one: Any) -> bytes:
    """A dataclass as netCDF, and a line with the SHA-256 of it."""
    import h5netcdf

    content = BytesIO()
    with h5netcdf.File(content, "w") as file:
        write_group(file, pack(one, type(one), "", {}), {})
    return sealed(content.getvalue())


def from_netcdf(of: type[Of], content: bytes, own: Sequence[type] = ()) -> Of:
    """What `to_netcdf` was given."""
    import h5py

    whole, writer = unsealed(content)
    with h5py.File(BytesIO(whole), "r") as file:
        node = read_group(file)
    return restored(of, node, writer, own)


def to_json(one: Any) -> str:
    """A dataclass as JSON, with the SHA-256 of what it says."""
    content = in_json(pack(one, type(one), "", {}))
    document = {"exoid": version("exoid"), "layout": LAYOUT, "content": content}
    return text({**document, "sha256": digest(document)})


def from_json(of: type[Of], content: bytes | str, own: Sequence[type] = ()) -> Of:
    """What `to_json` was given."""
    try:
        document = json.loads(content)
        told = document.pop("sha256")
    except (ValueError, LookupError, AttributeError, TypeError) as fault:
        raise DocumentError(
            "this is no result that was saved: what --json writes is for other programs. Name what "
            "--save wrote (.nc, .json), or save it again."
        ) from fault
    if told != digest(document):
        raise DocumentError("it is damaged, or was changed (SHA-256). Save it again.")
    if document["layout"] != LAYOUT:
        raise DocumentError(f"exoid {document['exoid']} has another layout. Save it again.")
    return restored(of, document["content"], document["exoid"], own)


def digest(document: Any) -> str:
    """Of what a document says, however it is spaced."""
    return sha256(json.dumps(document, separators=(",", ":")).encode()).hexdigest()


def restored(of: type[Of], node: Any, writer: str, own: Sequence[type]) -> Of:
    try:
        return unpack(node, of, "", Reader(own, {}))
    except OtherLayout as fault:
        raise DocumentError(
            f"it was saved by exoid {writer}, with other fields than this one has: {fault}. "
            "Save it again."
        ) from fault
