"""In which other unit a number that cannot be true would be one: a hint for who wrote it."""

OTHER = {  # unit: the units that people write instead, and how much of it one of them is
    "m": (("cm", 0.01), ("mm", 0.001), ("inches", 0.0254), ("feet", 0.3048)),
    "kg": (("g", 0.001), ("pounds", 0.4536), ("newtons", 0.102)),
    "rad": (("degrees", 0.017453),),
    "s": (("ms", 0.001),),
}
USUAL = {"height_m": (0.8, 2.2), "body_mass_kg": (8.0, 200.0)}


def unit_hint(key: str, unit: str, value: float, limits: tuple[float, float]) -> str:
    """A question, and what the number would be; empty where no unit makes it likely."""
    low, high = USUAL.get(key.lstrip("-").replace("-", "_"), USUAL.get(key, limits))
    each = [
        f"{value * factor:.3g} {unit} if it is in {name}"
        for name, factor in OTHER.get(unit, ())
        if low <= value * factor <= high and value * factor > 0
    ]
    return f" It would be {' or '.join(each)}." if each else ""
