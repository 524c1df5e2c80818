"""The shapes and types that functions of exoid are annotated with, checked whenever one is called.

As `jaxtyping.jaxtyped`, which looks at every argument twice, binds a signature in each call, and
takes a function inside another apart whenever that is called: a third of what a fit takes.
"""

import inspect
from collections.abc import Callable
from dataclasses import is_dataclass
from functools import wraps
from types import CodeType, FunctionType
from typing import Any, get_type_hints

import jaxtyping
from beartype import BeartypeConf, beartype
from jaxtyping import TypeCheckError

CHECK = beartype(conf=BeartypeConf(violation_type=TypeCheckError))
ORIGINAL = jaxtyping.jaxtyped
SCOPE = ORIGINAL("context")  # of the names of axes
# What runs when its caller has other axes: generators and coroutines.
LATER = inspect.CO_GENERATOR | inspect.CO_COROUTINE | inspect.CO_ASYNC_GENERATOR
ITSELF = "__beartype_func"  # by which what beartype makes has the function
_inside: dict[CodeType, FunctionType] = {}  # what was made of functions inside others


def install(rooms: list[str]) -> None:
    """Check these packages, which nobody has imported yet."""
    jaxtyping.install_import_hook(rooms, "beartype.beartype")
    jaxtyping.jaxtyped = lambda *, typechecker: checked


def checked(made: Any) -> Any:
    """The same function or class, which checks what it is given and gives."""
    if inspect.isclass(made):
        if is_dataclass(made) and getattr(made.__init__, "__globals__", None) is not globals():
            made.__init__ = checked(made.__init__)
        return made
    if not made.__annotations__:
        return made
    if made.__code__.co_flags & LATER:
        return ORIGINAL(made, typechecker=beartype)
    return in_scope_of_its_own(made, once_for_all(made))


def in_scope_of_its_own(made: FunctionType, checking: Callable[..., Any]) -> Callable[..., Any]:
    @wraps(made)
    def called(*given, **named):
        __tracebackhide__ = True
        with SCOPE:
            return checking(*given, **named)

    return called


def once_for_all(made: FunctionType) -> Callable[..., Any]:
    """What beartype makes of it; for a function inside another, whenever that is called, what it
    made of the first one.
    """
    if "<locals>" not in made.__qualname__:
        return resolved(made)
    known = _inside.get(made.__code__)
    if known is None:
        known = _inside[made.__code__] = resolved(made)
    if ITSELF not in (known.__kwdefaults__ or {}):
        return resolved(made)
    code, names = known.__code__, known.__globals__
    again = FunctionType(code, names, known.__name__, known.__defaults__, known.__closure__)
    again.__kwdefaults__ = known.__kwdefaults__ | {ITSELF: made}
    return again


def resolved(made: FunctionType) -> Any:
    """What beartype makes of it, where annotations that are words stand for what they name. One
    that names nothing, as what only type checkers import, may be anything.
    """
    made.__annotations__ = {
        name: told(annotation, made.__globals__)
        for name, annotation in made.__annotations__.items()
    }
    return CHECK(made)


def told(annotation: Any, names: dict[str, Any]) -> Any:
    def of(value):
        del value

    of.__annotations__ = {"value": annotation}
    try:
        return get_type_hints(of, names, include_extras=True)["value"]
    except Exception:
        return Any
