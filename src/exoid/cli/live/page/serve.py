"""`--serve`: the page on a port of this computer, and its address for who is to look."""

from collections.abc import Iterator
from contextlib import contextmanager
from socket import (
    AF_INET,
    SO_REUSEADDR,
    SOCK_DGRAM,
    SOCK_STREAM,
    SOL_SOCKET,
    gaierror,
    getaddrinfo,
    gethostname,
    socket,
)

from exoid.cli.live.page.access import access_to
from exoid.files.extras import require
from exoid.watching.board import Board

EVERYWHERE = ("0.0.0.0", "::")  # what listens on every address has none to be opened
ELSEWHERE = ("192.0.2.1", 9)  # an address for examples (RFC 5737), behind whatever leads outside


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


def own_address() -> str:
    """By which others can reach this computer; connecting so sends nothing."""
    with socket(AF_INET, SOCK_DGRAM) as made:
        try:
            made.connect(ELSEWHERE)
            return made.getsockname()[0]
        except OSError:  # it is in no network
            return gethostname()


@contextmanager
def serving(board: Board, name: str, made: socket, host: str) -> Iterator[str]:
    """The page's address, as long as it is there."""
    from exoid.cli.live.page.server import PageServer

    access = access_to(host)
    server = PageServer(board, name, access, made)
    name = own_address() if host in EVERYWHERE else host
    shown = f"[{name}]" if ":" in name else name
    token = "" if access.token is None else f"?token={access.token}"
    try:
        yield f"http://{shown}:{server.port}/{token}"
    finally:
        server.close()
