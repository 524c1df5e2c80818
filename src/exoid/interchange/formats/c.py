"""A header of C: the torques of the fitted leg for the firmware of a device."""

from collections.abc import Iterable, Mapping

from exoid.interchange.formats.c_frame import FRAME, HELPERS, MEMORY
from exoid.interchange.formula.expression import Expression, make, number, symbol
from exoid.interchange.formula.single import functions, made_of, used
from exoid.interchange.formula.spell import Language, lines, single, spell
from exoid.interchange.model.described import described, in_c_comment
from exoid.interchange.model.formulas import friction, undriven
from exoid.interchange.model.joint import Exported, Joint, Kept, Part

TORQUE_LIMIT, RATE_LIMIT = 5.0, 20.0  # N m and N m/s: a tenth of what moves a leg fast
MOVING = ("angle", "rate", "seconds", "x")
FORMS = {
    "neg": "-{0}",
    "select": "({0} ? {1} : {2})",
    "not": "!{0}",
    "and": "({0} && {1})",
    "or": "({0} || {1})",
}


def in_c(name: str) -> str:
    """A constant in capitals; what moves as it is."""
    stem, _, at = name.rpartition("_memory_")
    if stem:
        return f"memory.{stem}[{at}]"
    return name if name in MOVING else f"EXOID_LEG_{name.upper()}"


WORDS = Language(single, in_c, lambda name: f"exoid_leg_{name}", FORMS)


def c(joint: Joint) -> Exported:
    """The header.

    **Raises** `ValueError` where a term is no torque that angle, rate and a memory make.
    """
    acting = [part for part in undriven(joint.parts) if held(part)]
    resting = [part for part in acting if part.torque.value != 0.0]
    remembering = [part for part in resting if part.begun.size]
    formulas = torques(joint, resting)
    memory = memory_of(remembering)
    needed = made_of({**formulas, **memory})
    return Exported(
        FRAME.format(
            described="\n".join(commented(joint)),
            thigh_angle=single(joint.thigh_angle),
            torque_limit=single(TORQUE_LIMIT),
            rate_limit=single(RATE_LIMIT),
            constants="\n".join(constants(joint, acting)),
            helpers="\n".join(HELPERS[each] for each in HELPERS if each in needed),
            functions="\n".join(
                function(name, ("x",), root) for name, root in functions().items() if name in needed
            ),
            **{name: body(formulas[name]) for name in ("gravity", "stiffness", "damping")},
            friction=body(formulas["friction"], ("angle", "rate")),
            terms="".join(terms(formulas, resting, remembering)),
            memory=", exoid_leg_memory memory" if remembering else "",
            passed=", memory" if remembering else "",
            added="".join(map(added, resting)),
        ),
        tuple(kept(joint, acting)),
    )


def commented(joint: Joint) -> Iterable[str]:
    """What it is and what its numbers rest on, as lines of a comment."""
    return (f" * {in_c_comment(each)}".rstrip() for each in described(joint))


def held(part: Part) -> bool:
    """Is it part of the leg's own torque? What only muscles, or sensors, do is told in words.

    **Raises** `ValueError` where it is, and C cannot have it.
    """
    if not part.pushes or part.term.voluntary:
        return False
    why = None
    if part.hangs_on & {"time", "acceleration"}:
        why = f"it hangs on the {' and '.join(sorted(part.hangs_on & {'time', 'acceleration'}))}"
    elif part.shows:
        why = "it is a body that moves by itself"
    elif part.friction.symbols & {"rate"} and part.torque.value != 0.0:
        why = "its friction changes with the speed"
    elif unable := used({"": part.torque, " ": part.friction}) & {"sqrt", "log"}:
        why = f"it computes {', '.join(unable)}, which takes a mathematics library"
    if why is not None:
        raise ValueError(
            f"the C header has no feed-forward for {part.name} ({part.title}): {why}. Export "
            "it for Python, or fit without it."
        )
    return True


def torques(joint: Joint, resting: Iterable[Part]) -> dict[str, Expression]:
    """Every torque of its own by its name [N m]."""
    tilted = make("add", symbol("angle"), symbol("thigh_angle"))
    level = friction(joint.parts)
    still = make("le", make("abs", symbol("rate")), symbol("still"))
    against = make("neg", make("mul", level, make("sign", symbol("rate"))))
    return {
        "gravity": make("neg", make("mul", symbol("gravity"), make("cos", tilted))),
        "stiffness": make("neg", make("mul", symbol("stiffness"), symbol("angle"))),
        "damping": make("neg", make("mul", symbol("damping"), symbol("rate"))),
        "friction": make("select", still, number(0.0), against)
        if level.value != 0.0
        else number(0.0),
        **{part.name: part.torque for part in resting},
    }


def memory_of(parts: Iterable[Part]) -> dict[str, Expression]:
    """What every entry of the memory becomes."""
    found = {}
    for part in parts:
        for at, (rate, within) in enumerate(zip(part.rates, part.within, strict=True)):
            own = symbol(f"{part.name}_memory_{at}")
            moved = make("add", own, make("mul", symbol("seconds"), rate))
            found[f"{part.name}[{at}]"] = moved
            found[f"{part.name}[{at}] within"] = within
    return found


def constants(joint: Joint, acting: Iterable[Part]) -> Iterable[str]:
    """Every number with its error and origin."""
    own = (one for part in acting for one in part.numbers)
    for each in (*joint.numbers, joint.gravity, *own):
        said = in_c_comment(f"{each.symbol}: {each.origin}")
        yield f"#define {in_c(each.name)} {single(each.value)} /* {said} */"
    yield f"#define {in_c('number')} {single(float(joint.number))} /* of the segment, from 0 */"


def body(root: Expression, taken: Iterable[str] = ()) -> str:
    """The lines of a function that returns it; `taken` are its arguments."""
    *before, last = lines({"found": root}, WORDS, "const float {0} = {1};")
    unused = [f"(void){each};" for each in taken if not any(map(each.__eq__, root.symbols))]
    returned = f"return {last.partition(' = ')[2]}"
    return "\n".join(f"    {each}" for each in (*unused, *before, returned))


def function(name: str, taken: Iterable[str], root: Expression, comment: str = "") -> str:
    """A function of its own."""
    given = ", ".join(f"float {each}" for each in taken)
    return f"{comment}static inline float exoid_leg_{name}({given})\n{{\n{body(root, taken)}\n}}\n"


def terms(
    formulas: Mapping[str, Expression], resting: Iterable[Part], remembering: list[Part]
) -> Iterable[str]:
    """A function for every term, below what they remember."""
    if remembering:
        yield remembered(remembering)
    for part in resting:
        comment = f"\n/* {in_c_comment(part.title)} [N m]. */\n"
        said = function(part.name, ("angle", "rate"), formulas[part.name], comment)
        if part.begun.size:
            said = said.replace("float rate)", "float rate, exoid_leg_memory memory)", 1)
        yield said


def remembered(parts: list[Part]) -> str:
    """The type of the memory and how it goes on."""
    formulas = memory_of(parts)
    return MEMORY.format(
        members="\n".join(f"    float {part.name}[{part.begun.size}];" for part in parts),
        begun="\n".join(
            f"    {{{', '.join(single(float(each)) for each in part.begun)}}}," for part in parts
        ),
        rates="\n".join(assigned(formulas, within=False)),
        within="\n".join(assigned(formulas, within=True)),
    )


def assigned(formulas: Mapping[str, Expression], *, within: bool) -> Iterable[str]:
    for name, root in formulas.items():
        entry, _, last = name.partition(" ")
        if bool(last) is within:
            yield f"    next.{entry} = {spell(root, WORDS)};"


def added(part: Part) -> str:
    memory = ", memory" if part.begun.size else ""
    return f"    torque = torque + exoid_leg_{part.name}(angle, rate{memory});\n"


def kept(joint: Joint, acting: list[Part]) -> Iterable[Kept]:
    """What became of each thing."""
    yield Kept("leg", "exact", "gravity, stiffness, damping, J acceleration")
    names = [part.name for part in acting]
    for part in joint.parts:
        if part.name in names:
            name = "friction" if part.friction.value != 0.0 else part.name
            how = "approximate" if part.begun.size else "exact"
            remark = ", remembered by Euler's method" if part.begun.size else ""
            yield Kept(part.name, how, f"exoid_leg_{name}{remark}")
        else:
            whose = "the muscles'" if part.term.voluntary else "the sensors'"
            yield Kept(part.name, "in words", f"comment: {whose}, not the leg's")
    if joint.driven:
        yield Kept("drive", "in words", "comment: the muscles', not the leg's")
