"""The page, and its events, from a thread of its own. Nobody who looks can hold up who follows.

A reader is sent what the board shows when it is ready for more: what it missed meanwhile it never
gets, so nothing waits in a queue.
"""

import asyncio
import json
from collections.abc import AsyncIterator
from functools import cache
from socket import socket
from threading import Thread
from typing import Any

import uvicorn
from jinja2 import Environment, PackageLoader, StrictUndefined
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import HTMLResponse, Response, StreamingResponse
from starlette.routing import Route

from exoid.cli.live.page.access import Access, guarded
from exoid.cli.live.page.state import now, past
from exoid.watching.board import Board

EVERY = 0.1  # s between two events
MANY = 5  # moments that a reader can miss without a gap in a curve
SIGN = 2.0  # s after which one is sent where nothing has changed, so that a lost reader is seen
PATIENCE = 1  # s that readers have to hear of the end
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'unsafe-inline'; "
    "style-src 'unsafe-inline'; connect-src 'self'; img-src data:; frame-ancestors 'none'",
    "Referrer-Policy": "no-referrer",  # the address may hold the token
    "X-Content-Type-Options": "nosniff",
    "Cache-Control": "no-store",
}


class PageServer:
    """Serves a board on a socket until it is closed."""

    def __init__(self, board: Board, name: str, access: Access, listening: socket):
        self.board, self.name, self.listening = board, name, listening
        self.closing = False
        routes = [
            Route("/", self.page),
            Route("/events", self.events),
            Route("/weight", self.weight, methods=["POST"]),
        ]
        config = uvicorn.Config(
            guarded(Starlette(routes=routes), access),
            lifespan="off",
            log_level="critical",
            timeout_graceful_shutdown=PATIENCE,
            server_header=False,
        )
        self.server = uvicorn.Server(config)
        self.thread = Thread(target=self.server.run, args=([listening],), daemon=True)
        self.thread.start()

    @property
    def port(self) -> int:
        return self.listening.getsockname()[1]

    def close(self) -> None:
        """Readers get the last of it, and are let go."""
        self.closing = True
        self.server.should_exit = True
        self.thread.join(PATIENCE + 2)
        self.listening.close()

    async def page(self, request: Request) -> HTMLResponse:
        return HTMLResponse(
            templates().get_template("live.html").render(name=self.name), headers=HEADERS
        )

    async def events(self, request: Request) -> StreamingResponse:
        return StreamingResponse(self.told(), media_type="text/event-stream", headers=HEADERS)

    async def weight(self, request: Request) -> Response:
        """The weight is put on, or taken off: by this page alone, and by no other of the web."""
        headers = request.headers
        if headers.get("origin", "").partition("://")[2] != headers.get("host"):
            return Response("This is for the page itself.", 403)
        if self.board.weight is None:
            return Response("No weight was declared: --added-mass KG.", 404)
        self.board.weight.turn()
        return Response(status_code=204)

    async def told(self) -> AsyncIterator[str]:
        """The past first, then the newest, as soon as the reader has taken what was before; and the
        past again, where much has come meanwhile.
        """
        seen, said, quiet = -MANY, "", 0.0
        while not self.closing:
            if self.board.number > seen + MANY or seen < 0:
                yield event("past", past(self.board))
            seen = self.board.number
            news = event("now", now(self.board))
            if news != said or quiet >= SIGN:
                said, quiet = news, 0.0
                yield news
            quiet += EVERY
            await asyncio.sleep(EVERY)
        yield event("now", now(self.board))
        yield event("end", None)


def event(name: str, content: Any) -> str:
    """As the browser's EventSource reads it."""
    return f"event: {name}\ndata: {json.dumps(content, allow_nan=False)}\n\n"


@cache
def templates() -> Environment:
    """Whatever a template shows is escaped."""
    return Environment(
        loader=PackageLoader("exoid.cli.live.page"), autoescape=True, undefined=StrictUndefined
    )
