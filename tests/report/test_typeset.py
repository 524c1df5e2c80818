"""Symbols of quantities are italic, units, numbers and words upright: ISO 80000-1, 7.1."""

import pytest
from markupsafe import Markup

from exoid.fitting.model.user_values import DECLARED
from exoid.fitting.result.estimates.owned import MOUNTING
from exoid.fitting.result.estimates.ratios import RATIOS
from exoid.pendulum.catalogue import MEASURES
from exoid.report.words.typeset import GREEK, formula, mathtext, typeset


@pytest.mark.parametrize(
    ("symbol", "html", "printed"),
    [
        ("m", "<i>m</i>", "$m$"),
        ("tau / J", "<i>τ</i> / <i>J</i>", r"$τ\,/\,J$"),
        ("phi_s", "<i>φ</i><sub>s</sub>", r"$φ_{\mathrm{s}}$"),
        ("A1", "<i>A</i><sub>1</sub>", r"$A_{\mathrm{1}}$"),
        ("A1 / (1.6 A0)", "<i>A</i><sub>1</sub> / (1.6 <i>A</i><sub>0</sub>)", None),
        ("zero", "zero", "zero"),
    ],
)
def test_a_symbol_is_italic_with_its_index_below(symbol, html, printed):
    assert formula(symbol) == html
    assert printed in (None, mathtext(symbol))


@pytest.mark.parametrize(
    "symbol",
    [
        *(each.symbol for each in (*DECLARED.values(), *MEASURES.values())),
        *(symbol for symbol, *_ in (*RATIOS.values(), *MOUNTING.values())),
    ],
)
def test_no_symbol_shows_how_it_is_typed(symbol):
    shown = Markup(formula(symbol)).striptags()
    assert "_" not in shown
    assert not set(GREEK) & set(shown.split())


@pytest.mark.parametrize(
    ("words", "html"),
    [
        ("This tells m l g / J, c / J.",
         "This tells <i>m</i> <i>l</i> <i>g</i> / <i>J</i>, <i>c</i> / <i>J</i>."),
        ("m and J up 3.4 %", "<i>m</i> and <i>J</i> up 3.4 %"),
        ("torque tau [N m]", "torque <i>τ</i> [N m]"),
        ("J = 0.3 ± 0.1 kg m^2", "<i>J</i> = 0.3 ± 0.1 kg m²"),
        ("0.43 m long, 3 N m s/rad, in N m over time in s", None),
        ("leg c.csv, C:/c/d, I-d and e.m", None),
    ],
)  # fmt: skip
def test_in_a_sentence_symbols_are_italic_and_units_and_names_are_not(words, html):
    assert typeset(words) == (words if html is None else html)


def test_what_a_file_says_stays_text():
    assert "<b>" not in typeset("<b>m</b> & J")
    assert typeset("it's <d>").striptags() == "it's <d>"
    assert typeset(formula("m")) == "<i>m</i>"
