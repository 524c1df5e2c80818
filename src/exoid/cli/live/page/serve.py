"""`--serve`: the page on a port of this computer, and its address for who is to look."""

from collections.abc import Iterator
from contextlib import contextmanager
from socket import SO_REUSEADDR, SOCK_STREAM, SOL_SOCKET, gaierror, getaddrinfo, socket

from exoid.cli.live.page.access import access_to
from exoid.files.extras import require
from exoid.watching.board import Board


def check_server() -> None:
    """**Raises** `ValueError` where the packages that serve a page are missing."""
    for package in ("starlette", "uvicorn"):
        require(package, "a page is served")


def listening_on(host: str, port: int) -> socket:
    """**Raises** `ValueError` where nobody can listen there."""
    try:
        family, *_, address = getaddrinfo(host, port, type=SOCK_STREAM)[0]
        return bound(socket(family, SOCK_STREAM), address)
    except (OSError, gaierror, UnicodeError) as fault:
        reason = getattr(fault, "strerror", None) or fault
        raise ValueError(
            f"--serve: nobody can listen on port {port} of {host}: {reason}. Give another --port, "
            "or 0 for any, or another --host."
        ) from fault


def bound(made: socket, address) -> socket:
    """The socket, listening there, or closed."""
    try:
        made.setsockopt(SOL_SOCKET, SO_REUSEADDR, 1)
        made.bind(address)
        made.listen()
    except OSError:
        made.close()
        raise
    return made


@contextmanager
def serving(board: Board, name: str, made: socket, host: str) -> Iterator[str]:
    """The page's address, as long as it is there."""
    from exoid.cli.live.page.server import PageServer

    access = access_to(host)
    server = PageServer(board, name, access, made)
    shown = f"[{host}]" if ":" in host else host
    token = "" if access.token is None else f"?token={access.token}"
    try:
        yield f"http://{shown}:{server.port}/{token}"
    finally:
        server.close()
