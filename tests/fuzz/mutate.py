"""Ways in which a file is damaged: by a disk, by a line, by an editor, by another program."""

import random
from collections.abc import Callable, Sequence

Mutator = Callable[[random.Random, bytearray, Sequence[bytes]], None]

WORDS = (b"", b"nan", b"inf", b"-1", b"1e999", b"1_0", b"--", b'"', b"\0", b"\x1b[31m", b"\xc2\xa0",
         b"\xd9\xa1", b"0x1F", b"\r", b",,", b"99999999999999999999", b"=", b"[", b"#", b"%s%n",
         b"\xef\xbb\xbf", b"\xff", b"1,5", b";", b"\t", b"[[" * 40, b"9" * 400)  # fmt: skip
NUMBERS = (0, 1, 2, 8, 0x7F, 0x80, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF)
MOST = 3  # damages of one file
ALONE = 0.7  # the share of files with one


def place(draw: random.Random, content: bytearray) -> int:
    """Anywhere, the head as often as all the rest of a long file."""
    most = len(content) if draw.random() < 0.6 else min(len(content), 256)
    return draw.randrange(most) if most else 0


def flip(draw, content, _others) -> None:
    """One bit."""
    if content:
        content[place(draw, content)] ^= 1 << draw.randrange(8)


def byte(draw, content, _others) -> None:
    if content:
        content[place(draw, content)] = draw.randrange(256)


def insert(draw, content, _others) -> None:
    at = place(draw, content)
    content[at:at] = draw.randbytes(draw.choice((1, 1, 1, 2, 4, 50)))


def drop(draw, content, _others) -> None:
    at = place(draw, content)
    del content[at : at + draw.choice((1, 1, 1, 2, 4, 50))]


def cut(draw, content, _others) -> None:
    del content[place(draw, content) :]


def repeat(draw, content, _others) -> None:
    """A stretch twice."""
    at = place(draw, content)
    piece = content[at : at + draw.choice((1, 4, 16, 100, 1000))]
    content[at:at] = piece


def exchange(draw, content, _others) -> None:
    """Two stretches change places."""
    size = draw.choice((1, 4, 16, 100))
    one, other = sorted((place(draw, content), place(draw, content)))
    if one + size <= other and other + size <= len(content):
        piece = content[one : one + size]
        content[one : one + size] = content[other : other + size]
        content[other : other + size] = piece


def erase(draw, content, _others) -> None:
    """A stretch of zeros or ones, as a disk leaves it."""
    at, size = place(draw, content), draw.choice((1, 8, 64, 512))
    piece = content[at : at + size]
    content[at : at + size] = draw.choice((b"\0", b"\xff")) * len(piece)


def number(draw, content, _others) -> None:
    """An integer at a border of its range, where one could stand."""
    size = draw.choice((1, 2, 4, 8))
    at = place(draw, content) // size * size
    value = draw.choice(NUMBERS) % 256**size
    piece = value.to_bytes(size, draw.choice(("little", "big")))
    content[at : at + size] = piece[: len(content) - at]


def link(draw, content, _others) -> None:
    """A place of the file where another, or itself, may be pointed at."""
    at = place(draw, content) // 8 * 8
    to = draw.choice((at, max(at - 24, 0), place(draw, content) // 8 * 8))
    content[at : at + 8] = to.to_bytes(8, "little")[: len(content) - at]


def word(draw, content, _others) -> None:
    """What a text should not hold there, in the place of some letters."""
    at = place(draw, content)
    content[at : at + draw.choice((0, 1, 1, 2, 6))] = draw.choice(WORDS)


def digit(draw, content, _others) -> None:
    """A digit in the place of another."""
    at = place(draw, content)
    found = next((n for n in range(at, len(content)) if chr(content[n]).isdigit()), None)
    if found is not None:
        content[found] = ord(draw.choice("0123456789"))


def line(draw, content, _others) -> None:
    """A line twice, gone, or at another place."""
    lines = bytes(content).split(b"\n")
    one, other = draw.randrange(len(lines)), draw.randrange(len(lines))
    kind = draw.randrange(3)
    if kind == 0:
        lines.insert(other, lines[one])
    elif kind == 1:
        del lines[one]
    else:
        lines[one], lines[other] = lines[other], lines[one]
    content[:] = b"\n".join(lines)


def splice(draw, content, others) -> None:
    """The end of another file behind the begin of this one."""
    other = draw.choice(others)
    at = draw.randrange(len(other) + 1)
    content[place(draw, content) :] = other[at:]


MUTATORS: tuple[Mutator, ...] = (
    flip, flip, byte, insert, drop, cut, repeat, exchange, erase, number, link, word, digit, line,
    splice,
)  # fmt: skip


def mutated(draw: random.Random, content: bytes, others: Sequence[bytes]) -> bytes:
    """A damaged copy; `others` are files of the same format."""
    found = bytearray(content)
    for _ in range(1 if draw.random() < ALONE else draw.randint(2, MOST)):
        draw.choice(MUTATORS)(draw, found, others)
    return bytes(found)
