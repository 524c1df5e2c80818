"""What a term is called in an exported file, where some names are taken."""

from exoid.physics.term import Term, name_of

NUMBERS = ("com", "drive", "gyro", "thigh", "torque")  # begin a constant that every file has
TORQUES = ("gravity", "stiffness", "damping", "friction", "passive", "feed_forward", "limited")
HELPERS = ("abs", "sign", "max", "min", "floor", "round", "two_to", "cos", "sin", "exp", "tanh")
KINDS = ("memory", "begun", "remembered", "frame", "still")
WORDS = (
    *("auto", "bool", "break", "case", "catch", "char", "class", "const", "continue", "default"),
    *("delete", "do", "double", "else", "enum", "extern", "float", "for", "friend", "goto", "if"),
    *("inline", "int", "long", "mutable", "namespace", "new", "operator", "private", "protected"),
    *("public", "register", "restrict", "return", "short", "signed", "sizeof", "static", "struct"),
    *("switch", "template", "this", "throw", "try", "typedef", "typename", "union", "unsigned"),
    *("using", "virtual", "void", "volatile", "while"),
)  # of C and C++, which nothing else may bear
TAKEN = frozenset((*NUMBERS, *TORQUES, *HELPERS, *KINDS, *WORDS))


def called(term: type[Term]) -> str:
    """Its name, with more to it where the file calls something else so."""
    name = name_of(term)
    return f"{name}_term" if name in TAKEN else name
