"""exoid effects: what a model may have beside Eq. 9, by the names that options take."""

from typing import Annotated

import typer

from exoid.cli.inputs.terms import OwnTerms, own_terms, terms_asked
from exoid.cli.outputs.results import show


def effects(
    names: Annotated[
        list[str] | None,
        typer.Argument(help="Those to explain, as coulomb_friction. Without one, all are listed."),
    ] = None,
    terms: OwnTerms = None,
) -> None:
    """List the effects that --with and --between take.

    Simple torques that only 'exoid diagnose' tries stand last. With a name its equation, the range
    of its values, the recording that would show it apart from others, and its source.

    \b
    Examples:
      exoid effects                        all of them, a line each
      exoid effects coulomb_friction       one in full
      exoid effects --terms my_terms.py    with terms of your own
    """
    own = own_terms(terms)
    from exoid.cli.outputs.effects import explain_effect, print_effects
    from exoid.mismatch.novel.nameless import NAMELESS
    from exoid.physics.library import library
    from exoid.physics.term import name_of

    simple = tuple(sorted(NAMELESS, key=name_of))
    chosen = terms_asked(names, (*own, *simple), option="effects") if names else ()
    if not chosen:
        show(lambda console: print_effects((*own, *library()), simple, console))
    for each in chosen:
        term = each if isinstance(each, type) else type(each)
        show(lambda console, term=term: explain_effect(term, console))
