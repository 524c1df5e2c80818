"""The page of `exoid live --serve`: who may look, what is seen, and who is held up: nobody."""

import json
import re
import signal
import socket
import time
from dataclasses import replace
from http.client import HTTPConnection
from urllib.parse import parse_qs, urlsplit

import pytest
from command_line import LIMIT

from exoid.cli.inputs.reading import EXAMPLE
from exoid.cli.live.page.access import Access, name_in, token_in
from exoid.cli.live.page.serve import listening_on, serving
from exoid.cli.live.page.server import PageServer
from exoid.cli.live.page.state import now
from exoid.watching.board import Board, Weight
from exoid.watching.estimate.moment import Moment, Quantity

PATIENCE = 60_000  # ms, for a machine that does other things as well


def moment(time=1.0, value=27.3, angle=-1.0) -> Moment:
    from exoid.online.model.trust import Phase, Trust

    names = ("gravity_over_inertia", "stiffness_over_inertia", "damping_over_inertia")
    known = tuple(Quantity(name, value, 0.1, "1/s^2") for name in names)
    return Moment(time, angle, 0.0, Phase.MOVING, Trust.GOOD, 1, known, known)


@pytest.fixture
def board():
    found = Board(state="following")
    found.show(moment())
    return found


@pytest.fixture
def address(board):
    with serving(board, "leg", listening_on("127.0.0.1", 0), "127.0.0.1") as found:
        yield found


def get(address, path="/", **headers):
    """Status and content, over a connection of its own."""
    parts = urlsplit(address)
    connection = HTTPConnection(parts.hostname, parts.port, timeout=10)
    connection.request("GET", path, headers=headers)
    answer = connection.getresponse()
    return answer, connection


def status(address, path="/", **headers) -> int:
    answer, connection = get(address, path, **headers)
    connection.close()
    return answer.status


def event_in(answer) -> tuple[str, object]:
    name = answer.readline().decode().removeprefix("event: ").strip()
    content = json.loads(answer.readline().decode().removeprefix("data: "))
    answer.readline()
    return name, content


def test_a_page_needs_nothing_of_the_network(address):
    answer, connection = get(address)
    text = answer.read().decode()
    connection.close()
    assert answer.status == 200
    assert "default-src 'none'" in answer.headers["Content-Security-Policy"]
    found = set(re.findall(r"https?://[^\"' )]+", text))
    assert found == {"http://www.w3.org/2000/svg"}  # a name, which no browser asks for
    assert " src=" not in text
    assert "<link" not in text


@pytest.mark.parametrize(
    ("host", "expected"),
    [
        ("localhost", 200),
        ("127.0.0.1:8710", 200),
        ("[::1]:8710", 200),
        ("rebound.example", 421),
        ("127.0.0.1.rebound.example", 421),
        ("192.168.1.5", 421),
        ("", 421),
    ],
)
def test_only_names_of_this_computer_are_answered(address, host, expected):
    assert status(address, Host=host) == expected
    if expected != 200:
        assert status(address, "/events", Host=host) == expected


def posted(address, path="/weight", **headers) -> int:
    parts = urlsplit(address)
    connection = HTTPConnection(parts.hostname, parts.port, timeout=10)
    connection.request("POST", path, headers=headers)
    found = connection.getresponse().status
    connection.close()
    return found


def test_a_weight_is_switched_by_the_page_and_by_no_other_of_the_web(board, address):
    own = address.rstrip("/")
    assert posted(address, Origin=own) == 404  # none was declared
    turned = []
    board.weight = Weight("1 kg", lambda: len(turned) % 2 == 0, lambda: turned.append(1))
    assert now(board)["weight"] == "1 kg on"
    assert posted(address) == 403
    assert posted(address, Origin="http://another.example") == 403
    assert posted(address, Origin=own, Host="rebound.example") == 421
    assert status(address, "/weight") == 405  # a picture's address switches nothing
    assert turned == []
    assert posted(address, Origin=own) == 204
    assert now(board)["weight"] == "1 kg off"
    with serving(board, "leg", listening_on("0.0.0.0", 0), "0.0.0.0") as shown:
        other = f"http://127.0.0.1:{urlsplit(shown).port}"
        token = parse_qs(urlsplit(shown).query)["token"][0]
        assert posted(other, Origin=other) == 403
        assert posted(other, f"/weight?token={token}", Origin=other) == 204


def test_other_computers_need_the_token_that_was_printed(board):
    with serving(board, "leg", listening_on("0.0.0.0", 0), "0.0.0.0") as shown:
        token = parse_qs(urlsplit(shown).query)["token"][0]
        assert urlsplit(shown).hostname not in ("0.0.0.0", None)  # which nobody can open
        address = f"http://127.0.0.1:{urlsplit(shown).port}/"
        assert len(token) >= 32
        assert status(address) == 403
        assert status(address, "/events") == 403
        assert status(address, f"/?token={token[:-1]}") == 403
        assert status(address, f"/?token={token}") == 200
        assert status(address, Authorization=f"Bearer {token}") == 200
        assert status(address, f"/?token={token}", Host="rebound.example") == 421


def test_a_token_is_compared_in_constant_time(monkeypatch):
    asked = []
    monkeypatch.setattr(
        "exoid.cli.live.page.access.compare_digest", lambda *each: bool(asked.append(each))
    )
    assert not Access("0.0.0.0", "abc").allows_token("abd")
    assert asked == [(b"abd", b"abc")]


def test_a_host_and_a_token_are_read_as_they_may_be_written():
    assert [name_in(each) for each in ("a:1", "[::1]:80", "a")] == ["a", "::1", "a"]
    assert token_in({"authorization": "bearer x "}, "token=y") == "x"
    assert token_in({}, "a=1&token=y%2B") == "y+"


def test_who_comes_late_gets_the_past_first_and_then_the_newest(address, board):
    board.show(moment(2.0, 27.4))
    answer, connection = get(address, "/events")
    assert event_in(answer) == (
        "past",
        [[at, *[value, 0.1] * 3, None, None] for at, value in ((1.0, 27.3), (2.0, 27.4))],
    )
    name, first = event_in(answer)
    assert (name, first["moment"]["time_s"]) == ("now", 2.0)
    for at in range(3, 50):
        board.show(moment(float(at)))
    # Of what it missed, it gets no moments (but where one came between two), and the curves.
    found = [event_in(answer)]
    while found[-1][0] != "now" or found[-1][1]["moment"]["time_s"] != 49.0:
        found.append(event_in(answer))
    assert len(found) <= 4
    assert "past" in dict(found)
    connection.close()


def test_a_reader_who_does_not_read_holds_nobody_up_and_the_others_get_all(address, board):
    parts = urlsplit(address)
    slow = socket.create_connection((parts.hostname, parts.port))
    slow.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    slow.sendall(b"GET /events HTTP/1.1\r\nHost: localhost\r\n\r\n")
    taken = []
    for at in range(100):
        begin = time.perf_counter()
        board.show(moment(float(at), angle=at / 100))
        taken.append(time.perf_counter() - begin)
        time.sleep(0.005)
    assert sorted(taken)[90] < 1e-3  # s; a moment is shown in microseconds, whoever reads
    answer, connection = get(address, "/events")
    assert event_in(answer)[0] == "past"
    assert event_in(answer)[1]["moment"]["time_s"] == 99.0
    connection.close()
    slow.close()


def test_readers_are_let_go_at_the_end(board):
    with serving(board, "leg", listening_on("127.0.0.1", 0), "127.0.0.1") as address:
        answer, connection = get(address, "/events")
        event_in(answer)
        board.state = "ended"
        begin = time.monotonic()
    assert time.monotonic() - begin < 5.0
    assert answer.read().decode().rstrip().endswith("event: end\ndata: null")
    connection.close()
    with pytest.raises(ConnectionRefusedError):
        status(address)


def test_a_port_that_is_taken_is_refused_in_one_line(command):
    with listening_on("127.0.0.1", 0) as taken:
        port = taken.getsockname()[1]
        done = command("live", EXAMPLE, "--serve", "--port", port)
    assert done.returncode == 2
    assert f"nobody can listen on port {port} of 127.0.0.1" in done.stderr.splitlines()[-1]
    assert "nobody can listen" in refusal_of_host(command)


def refusal_of_host(command) -> str:
    done = command("live", EXAMPLE, "--serve", "--host", "no.such.host.example", "--port", 0)
    assert done.returncode == 2
    return done.stderr.splitlines()[-1]


@pytest.fixture(scope="module")
def browser():
    import shutil

    playwright = pytest.importorskip(
        "playwright.sync_api", reason="playwright is not installed: pip install playwright"
    )
    names = ("chromium", "chromium-browser", "google-chrome")
    program = next(filter(None, map(shutil.which, names)), None)
    if program is None:
        pytest.skip("no Chromium is installed: on Debian, apt-get install chromium")
    with playwright.sync_playwright() as driver:
        started = driver.chromium.launch(executable_path=program, args=["--no-sandbox"])
        yield started
        started.close()


@pytest.fixture
def page(browser):
    context = browser.new_context(viewport={"width": 1180, "height": 880})
    opened = context.new_page()
    opened.said, opened.asked = [], []
    opened.on("console", lambda message: opened.said.append(message.text))
    opened.on("pageerror", lambda fault: opened.said.append(str(fault)))
    opened.on("request", lambda request: opened.asked.append(request.url))
    yield opened
    context.close()


@pytest.mark.slow
def test_a_browser_shows_the_moving_leg_and_what_is_known(page, address, board):
    page.goto(address)
    page.wait_for_selector("#rows tr", timeout=PATIENCE)
    for at in range(2, 14):
        board.show(moment(at / 10, angle=-1.0 - at / 100))
        time.sleep(0.02)
    page.wait_for_selector("#angle:text-is('-64.7°')", timeout=PATIENCE)
    assert page.inner_text("#trust") == "good: gravity over inertia is known to 1 %"
    assert page.inner_text("#doing") == "moving freely"
    assert "27.30" in page.inner_text("#rows")
    assert page.locator(".chart .curve").count() == 3
    turned = page.locator("#measured").get_attribute("style")
    assert "rotate(64.7" in turned
    # The simulated leg falls by itself from where the movement began: it need not be the same.
    assert "rotate(" in page.locator("#simulated").get_attribute("style")
    assert page.said == []
    assert {urlsplit(each).netloc for each in page.asked} == {urlsplit(address).netloc}


@pytest.mark.slow
def test_curves_have_a_scale_and_the_inertia_has_one_once_it_is_told(page, address, board):
    page.goto(address)
    page.wait_for_selector("#rows tr", timeout=PATIENCE)
    board.show(moment(2.0))
    page.wait_for_selector(".scale span >> nth=8", timeout=PATIENCE)
    assert page.locator("figure:visible").count() == 3
    assert page.locator("#loaded").is_hidden()  # no weight was declared
    # The band of 27.3 and an error of 0.1, with a twelfth of it above and below.
    assert page.locator(".scale").nth(0).inner_text().split() == ["27.42", "27.30", "27.18"]
    known = (Quantity("inertia", 0.42, 0.01, "kg m^2"),)
    for at in (3.0, 3.1, 3.2):
        board.show(replace(moment(at), others=known))
        time.sleep(0.1)
    page.wait_for_selector("figure:visible .scale >> nth=3", timeout=PATIENCE)
    scale = page.locator("figure:visible .scale").nth(3).inner_text().split()
    assert scale == ["0.432", "0.420", "0.408"]
    assert page.said == []


@pytest.mark.slow
def test_a_browser_whose_connection_breaks_comes_back_by_itself(page, address, board, monkeypatch):
    whole, begun = PageServer.told, []

    async def breaking(self):
        begun.append(1)
        sent = 0
        async for each in whole(self):
            yield each
            sent += 1
            if len(begun) == 1 and sent == 2:
                return  # as where a network drops it: nobody said that this is the end

    monkeypatch.setattr(PageServer, "told", breaking)
    page.goto(address)
    page.wait_for_selector("#link:has-text('trying again')", timeout=PATIENCE)
    board.show(moment(2.0, 28.5))
    page.wait_for_selector("#link:text-is('live')", timeout=PATIENCE)
    page.wait_for_selector("#rows td:text-is('28.50')", timeout=PATIENCE)
    assert len(begun) == 2


@pytest.mark.slow
def test_ctrl_c_ends_the_command_and_its_page(page, command):
    process = command.start("live", EXAMPLE, "--speed", 1, "--serve", "--port", 0, "--no-refine")
    page.goto(told(process, "the page"))
    page.wait_for_selector("#doing:has-text('at rest')", timeout=PATIENCE)
    begin = time.monotonic()
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=LIMIT)
    assert process.returncode == 0
    assert time.monotonic() - begin < 15.0
    assert "waiting for a free movement" in said or "drop" in said
    page.wait_for_selector("#link:text-is('ended')", timeout=PATIENCE)


@pytest.mark.slow
def test_when_a_file_is_over_the_page_says_so_and_stays_until_ctrl_c(page, command):
    process = command.start("live", EXAMPLE, "--serve", "--port", 0)
    address = told(process, "the file is over; its page stays until Ctrl-C")
    page.goto(address)
    page.wait_for_selector("#link:text-is('the file is over')", timeout=PATIENCE)
    assert page.inner_text("#doing") == "the file is over"
    assert page.inner_text("#trust") == "enough: another drop would hardly change a thing"
    assert page.inner_text("#next") == "-"
    assert "0.4201" in page.inner_text("#rows")
    process.send_signal(signal.SIGINT)
    said, _ = process.communicate(timeout=LIMIT)
    assert process.returncode == 0
    assert said.splitlines()[0].startswith("88.4 s, 4 drops so far, 6 left out; enough")
    page.wait_for_selector("#link:text-is('ended')", timeout=PATIENCE)


def told(process, what: str) -> str:
    """The address that the command says so."""
    lines = []
    while not (found := re.search(rf"{what}: (http://\S+)", "".join(lines[-1:]))):
        lines.append(process.stderr.readline())
        assert lines[-1], "".join(lines)
    return found[1]
