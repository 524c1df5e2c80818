"""In which other unit a number that cannot be true would be one: a hint for who wrote it."""

OTHER = {  # unit: the units that people write instead, and how much of it one of them is
    "m": (("cm", 0.01), ("mm", 0.001), ("inches", 0.0254), ("feet", 0.3048)),
    "kg": (("g", 0.001), ("pounds", 0.4536), ("newtons", 0.102)),
    "rad": (("degrees", 0.017453),),
    "s": (("ms", 0.001),),
}
USUAL = {"height": (0.8, 2.2), "body_mass": (8.0, 200.0)}  # m and kg, of people
SLIPS = (0.1, 10.0)  # of a decimal point by one place


def unit_hint(key: str, unit: str, value: float, limits: tuple[float, float]) -> str:
    """A question, and what the number would be; empty where no unit makes it likely."""
    plain = key.lstrip("-").replace("-", "_").removesuffix(f"_{unit}")
    low, high = USUAL.get(plain, limits)
    slips = [slip * value for slip in SLIPS if plain in USUAL and low <= slip * value <= high]
    each = [f"{slip:.3g} {unit} if its decimal point slipped" for slip in slips]
    each += [
        f"{value * factor:.3g} {unit} if it is in {name}"
        for name, factor in OTHER.get(unit, ())
        if low <= value * factor <= high and value * factor > 0
    ]
    return f" It would be {' or '.join(each)}." if each else ""
