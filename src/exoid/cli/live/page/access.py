"""Who may look at the page: this computer; others with a token, under a name that nobody rebinds.

A page of the web can have its name lead to this computer and read what is served here. It comes
with a Host of its own, which is refused.
"""

from collections.abc import Awaitable, Callable, Mapping, MutableMapping
from dataclasses import dataclass
from ipaddress import ip_address
from secrets import compare_digest, token_urlsafe
from socket import gethostname
from typing import Any
from urllib.parse import parse_qs

LOCAL = ("127.0.0.1", "localhost", "::1")
BEARER = "bearer "

Scope = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[MutableMapping[str, Any]]]
Send = Callable[[MutableMapping[str, Any]], Awaitable[None]]
App = Callable[[Scope, Receive, Send], Awaitable[None]]


@dataclass(frozen=True)
class Access:
    """To what is served on `host`; without a token nobody but this computer can reach it."""

    host: str
    token: str | None

    def allows_name(self, name: str) -> bool:
        """Is it a name by which this computer is called, and no other's?"""
        if is_address(name):
            return self.token is not None or name in LOCAL
        return name in LOCAL or (
            self.token is not None and name.lower() in (self.host.lower(), gethostname().lower())
        )

    def allows_token(self, told: str) -> bool:
        """In a time that does not tell how much of it is right."""
        return self.token is None or compare_digest(told.encode(), self.token.encode())


def access_to(host: str) -> Access:
    """With a new token for any but this computer."""
    return Access(host, None if host in LOCAL else token_urlsafe(24))


def guarded(app: App, access: Access) -> App:
    """The app, for those who may look."""

    async def guard(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await app(scope, receive, send)
            return
        headers = {
            key.decode("latin-1"): value.decode("latin-1") for key, value in scope["headers"]
        }
        if not access.allows_name(name_in(headers.get("host", ""))):
            await refuse(send, 421, "This is not the name of this computer.")
        elif not access.allows_token(token_in(headers, scope["query_string"].decode("latin-1"))):
            await refuse(send, 403, "The address lacks the token that exoid live has printed.")
        else:
            await app(scope, receive, send)

    return guard


def name_in(host: str) -> str:
    """A Host without its port, an address of IPv6 without its brackets."""
    if host.startswith("["):
        return host[1:].partition("]")[0]
    return host.partition(":")[0]


def token_in(headers: Mapping[str, str], query: str) -> str:
    """From the address, or from an Authorization header."""
    said = headers.get("authorization", "")
    if said.lower().startswith(BEARER):
        return said[len(BEARER) :].strip()
    return parse_qs(query).get("token", [""])[0]


def is_address(name: str) -> bool:
    try:
        ip_address(name)
    except ValueError:
        return False
    return True


async def refuse(send: Send, status: int, words: str) -> None:
    kind = [(b"content-type", b"text/plain; charset=utf-8")]
    await send({"type": "http.response.start", "status": status, "headers": kind})
    await send({"type": "http.response.body", "body": words.encode()})
