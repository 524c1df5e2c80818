"""Terms of a user's own, from a module or a file."""

import importlib
import importlib.util
import sys
from functools import partial
from pathlib import Path


def own_terms(name: str):
    """The terms of a module, or of a file."""
    from exoid.physics.library import check_terms, terms_of

    path = Path(name)
    if path.suffix == ".py":
        if not path.is_file():
            raise ValueError(f"--terms {name}: there is no such file. Check the name.")
        spec = importlib.util.spec_from_file_location(path.stem, path)
        assert spec is not None  # a .py file has one
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[path.stem] = module
        load = partial(spec.loader.exec_module, module)
    else:
        module, load = None, partial(importlib.import_module, name)
    try:
        module = load() or module
    except Exception as fault:  # whatever a user's file may raise
        raise ValueError(f"--terms {name}: {type(fault).__name__}: {fault}") from fault
    assert module is not None  # loaded, one way or the other
    found = tuple(terms_of(module))
    if not found:
        raise ValueError(f"--terms {name}: no class of exoid.PhysicsTerm or SensorTerm in it.")
    check_terms(found)
    return found
