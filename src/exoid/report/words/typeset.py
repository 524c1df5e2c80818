"""Symbols as they are typeset: letters of quantities italic, units and words upright.

ISO 80000-1, 7.1: symbols of quantities are italic, their descriptive subscripts and units upright.
"""

import re

from markupsafe import Markup, escape

PRINTED = {"^2": "²", "^3": "³", "->": "→"}  # a terminal has only what a keyboard has
GREEK = {"tau": "τ", "phi": "φ", "omega": "ω", "w": "ω"}
ATOM = re.compile(
    r"(?<![A-Za-z_&])(?P<name>tau|phi|omega|[A-Za-z])(?:_(?P<word>[a-z]+|\d+)|(?P<number>\d+))?(?![A-Za-z])"
)
SYMBOL = re.compile(r"`([^`]*)`")
NAMED = r"(?:(?:tau|phi|omega)(?:_(?:[a-z]+|\d+))?|[mJldcTr](?:_[a-z])?|[Fawt]_[a-z]|A[01]|D\d)"
CHAIN = rf"{NAMED}(?: (?:{NAMED}|g)(?!\w))*"
UNIT = r"[A-Za-z][A-Za-z²³^0-9]*"
PROSE = re.compile(
    r"(?P<kept>\[[^\]]*\]"  # a unit in brackets
    rf"|(?:(?<=\d )|\b(?:in|per) |\bN ){UNIT}(?:[ /]{UNIT})?(?!\w))"
    rf"|(?<![\w;'./\\:-])(?P<formula>{CHAIN}(?: / {CHAIN})?)(?![\w'/\\=&-]|\.\w)"
)


def tidy(words: str) -> str:
    """Powers and arrows as signs of their own."""
    for typed, printed in PRINTED.items():
        words = words.replace(typed, printed)
    return words


def formula(symbol: str) -> Markup:
    """A symbol or a ratio of symbols (`m l g / J`, `phi_s`) as HTML, which plotly reads too."""
    return Markup(ATOM.sub(as_html, str(escape(symbol))))


def as_html(atom: re.Match[str]) -> str:
    low = atom["word"] or atom["number"]
    return f"<i>{letter(atom)}</i>" + (f"<sub>{low}</sub>" if low else "")


def mathtext(symbol: str) -> str:
    """The same for matplotlib."""
    spaced = ATOM.sub(as_mathtext, symbol).replace(" ", r"\,")
    return f"${spaced}$" if ATOM.search(symbol) else symbol


def as_mathtext(atom: re.Match[str]) -> str:
    low = atom["word"] or atom["number"]
    return letter(atom) + (rf"_{{\mathrm{{{low}}}}}" if low else "")


def with_mathtext(words: str) -> str:
    """Words with symbols between backticks, for matplotlib."""
    return SYMBOL.sub(lambda found: mathtext(found[1]), tidy(words))


def with_formulas(words: str) -> Markup:
    """The same as HTML."""
    parts = SYMBOL.split(tidy(words))
    set_ = [formula(part) if at % 2 else escape(part) for at, part in enumerate(parts)]
    return Markup("".join(set_)).replace("\n", Markup("<br>"))


def letter(atom: re.Match[str]) -> str:
    return GREEK.get(atom["name"], atom["name"])


def typeset(words: str) -> Markup:
    """A sentence as HTML: the symbols in it typeset, powers as signs; what is typeset stays."""
    if isinstance(words, Markup):
        return words
    return Markup(PROSE.sub(in_prose, str(escape(tidy(words)))))


def in_prose(found: re.Match[str]) -> str:
    return found["kept"] or str(formula(found["formula"]))
