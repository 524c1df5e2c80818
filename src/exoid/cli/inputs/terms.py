"""What the model has beside Eq. 9, as options name it: terms of the library, or of a user's own."""

import importlib
import importlib.util
import sys
from functools import partial
from pathlib import Path
from typing import Annotated, Any

import typer

With = Annotated[
    list[str] | None,
    typer.Option(
        "--with",
        help="A term beside Eq. 9, such as coulomb_friction or gyro_bias, alone or with its "
        "values as hysteresis=0.1,0.03; repeat. 'exoid effects' lists them.",
        metavar="TERM",
    ),
]
OwnTerms = Annotated[
    str | None,
    typer.Option(
        "--terms",
        help="Your own terms: a module, or a file .py, with classes of exoid's Term.",
        metavar="MODULE",
    ),
]
Between = Annotated[
    str | None,
    typer.Option(
        help="Rival causes to tell apart, such as coulomb_friction,hysteresis; what acts together "
        "with a + between, as hysteresis,coulomb_friction+cubic_stiffness.",
        metavar="TERMS",
    ),
]
Model = Annotated[
    Path | None,
    typer.Option(help="The model of a saved result (.nc, .json): its terms.", metavar="FILE"),
]


def own_terms(name: str | None) -> tuple[Any, ...]:
    """The terms of a user's own, from a module or a file; none where none is named."""
    if name is None:
        return ()
    from exoid.physics.library import check_terms, terms_of

    path = Path(name)
    if path.suffix == ".py":
        if not path.is_file():
            raise ValueError(f"--terms {name}: there is no such file. Check the name.")
        spec = importlib.util.spec_from_file_location(f"terms_of_{path.stem}", path)
        assert spec is not None  # a .py file has one
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[spec.name] = module
        load = partial(spec.loader.exec_module, module)
    else:
        module, load = None, partial(importlib.import_module, name)
    try:
        module = load() or module
    except (Exception, SystemExit) as fault:  # whatever a user's file may raise
        raise ValueError(f"--terms {name}: {type(fault).__name__}: {fault}") from fault
    assert module is not None  # loaded, one way or the other
    found = tuple(terms_of(module))
    if not found:
        raise ValueError(f"--terms {name}: no class of exoid.PhysicsTerm or SensorTerm in it.")
    check_terms(found)
    return found


def terms_asked(
    given: list[str] | None,
    own: tuple,
    saved: tuple = (),
    *,
    valued_all: bool = False,
    option: str = "--with",
) -> tuple[Any, ...]:
    """Classes and instances of terms: those of a saved model, then those that were named.

    **Raises** `ValueError` (one sentence) where a name is none, or a value cannot be, or is missing
    where all are to be `valued_all`; where terms of one's `own` are loaded and none is asked for.
    """
    from exoid.physics.term import name_of

    if own and not (given or saved):
        raise ValueError(
            f"--terms only says where your own terms are: give {option} with the names of those "
            f"that you want; there are {', '.join(map(name_of, own))}."
        )
    if not (given or saved):
        return ()
    from exoid.physics.library import library, resembled

    known = {name_of(term): term for term in (*library(), *own)}
    found = {name_of(type(term)): term for term in saved}
    said = set()
    for word in given or []:
        name, equals, rest = word.partition("=")
        name = name.strip()
        if name in said:
            raise ValueError(f"{option} {name}: it was said before. Say it once.")
        said.add(name)
        if name not in known:
            raise ValueError(f"{option} {name}: there is no such term; {resembled(name, known)}")
        asked = equals or valued_all
        found[name] = valued(name, known[name], rest) if asked else known[name]
    return tuple(found.values())


def rivals_asked(between: str, own: tuple) -> tuple[tuple[Any, ...], ...]:
    """The terms between which to tell, or the sets of terms.

    **Raises** `ValueError` where a name is none, there are no two, or one is said twice.
    """
    words = [word.strip() for word in between.split(",") if word.strip()]
    found = tuple(terms_asked(word.split("+"), own, option="--between") for word in words)
    if len(found) < 2:
        raise ValueError(f"--between {between}: name two terms or more, with commas between.")
    for number, word in enumerate(words):
        if set(found[number]) in map(set, found[:number]):
            raise ValueError(f"--between {word}: it was said before. Say it once.")
    return found


def names_of(terms: tuple[Any, ...]) -> list[str]:
    """Their names, as settings keep them."""
    from exoid.physics.term import name_of

    return [name_of(each if isinstance(each, type) else type(each)) for each in terms]


def loaded(path: Path, own: tuple):
    """A result as it was saved, with a user's own terms."""
    from exoid.report.saved.saved_result import load_result

    return load_result(path, terms=own)


def saved_model(model: Path, own: tuple):
    """The fitted leg with its terms, of a saved fit."""
    return model_in(loaded(model, own), model)


def model_in(saved, path: Path):
    """The same of what was loaded from `path`."""
    found = saved.result.model
    if found is None:
        raise ValueError(
            f"{path}: every segment was fitted alone there: it holds no one model. Fit without "
            "--each."
        )
    return found


def body_in(saved) -> dict[str, float]:
    """Body mass and height of whom a saved result is of, where it says so."""
    found = saved.recordings[:1]
    known = {"body_mass": "body_mass_kg", "height": "height_m"}
    return {name: one[key] for one in found for name, key in known.items() if one.get(key)}


def undecided_in(saved, path: Path) -> str | None:
    """What to say of a fit whose terms a saved diagnosis named without telling them from others."""
    from exoid.fitting.result.estimates.estimate import RIVALS

    found = saved.diagnosis
    after = found.after if found else None
    wider = after and any(RIVALS in (one.limited_by or {}) for one in after.ratios.values())
    alike = [each.replace("_", " ") for each in found.equivalent] if found and wider else []
    if len(alike) < 2:
        return None
    return (
        f"{path} cannot tell {' from '.join(alike)}: each ± here is of one of them alone, "
        "each ± in that diagnosis holds the others, too."
    )


def suspected_in(model: Path, own: tuple) -> list[str]:
    """The causes that a saved diagnosis leaves open; none of a fit, or of an answer with a leg that
    can be planned for.
    """
    found = loaded(model, own).diagnosis
    if found is None:
        return []
    after = found.after
    whole = after is not None and after.follows and after.parameters["inertia"].value is not None
    return [] if whole else rivals_in(found)


def rivals_in(found) -> list[str]:
    """The causes of a name that a diagnosis suspects, alone or in sets, as --between takes them; of
    those that push alike whatever is recorded the first.
    """
    from exoid.mismatch.novel.nameless import NAMELESS
    from exoid.physics.term import name_of
    from exoid.report.words.diagnosis.certainty import pushes

    nameless = set(map(name_of, NAMELESS))
    rivals: dict[frozenset[str], str] = {}
    for each in found.suspected:
        if each.terms and not nameless & {*each.terms}:
            rivals.setdefault(pushes(each.terms), "+".join(each.terms))
    return list(rivals.values())


def valued(name: str, term: type, text: str):
    """A term with the values that were said: in their order, or each as PARAMETER:VALUE."""
    from exoid.fitting.model.term_parameters import term_of
    from exoid.physics.parameter import declarations

    declared = dict(declarations(term))
    form = ", ".join(f"{each} [{one.unit}]" for each, one in declared.items())
    said: dict[str, float] = {}
    for place, part in enumerate(text.split(",") if text else []):
        parameter, colon, number = part.rpartition(":")
        parameter = parameter.strip() if colon else [*declared, ""][min(place, len(declared))]
        try:
            value = float(number)
        except ValueError:
            raise ValueError(
                f"--with {name}={text}: {number!r} is no number; give {form}."
            ) from None
        if parameter not in declared:
            raise ValueError(f"--with {name}={text}: {name} has {form}, and no more.")
        one = declared[parameter]
        if not one.lower <= value <= one.upper:
            raise ValueError(
                f"--with {name}={text}: {parameter} is {one.lower:g} to {one.upper:g} {one.unit}."
            )
        said[parameter] = value
    missing = [each for each in declared if each not in said]
    if missing:
        raise ValueError(f"--with {name}: {', '.join(missing)} is missing; give {form}.")
    return term_of(term, lambda called, _: said[called.rpartition(".")[2]])
