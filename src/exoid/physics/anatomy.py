"""What anatomy expects of a lower leg of a given body mass and height (Eq. 5-8, 14).

Two rigid segments, shank and foot, hang from the knee; the ankle is at a right angle. Plain floats.
"""

from dataclasses import dataclass
from math import hypot, pi
from typing import Literal, NamedTuple

TableName = Literal["de_leva", "winter", "dumas", "paper"]
Sex = Literal["female", "male"]

# Where the foot hangs, as fractions of body height. Below the ankle: Dumas 2007, 40 mm at 1.77 m.
# Ahead of it: de Leva 1996 (44 % of 0.148 H from the heel) less heel to ankle, about 0.034 H.
FOOT_BELOW = 0.0226
FOOT_AHEAD = 0.0316

# Knee to toe, ankle at a right angle: 0.285 H down to the sole, 0.118 H forward (Winter 2009).
REACH = hypot(0.285, 0.118)

SHANK_RADIUS = 0.05 / 1.80  # of body height; engineering estimate, the paper gives no number

# Between-subject scatter, relative. Engineering estimates: each is at least the disagreement of the
# tables below about one and the same man (mass 4 %, com_distance 6 %, inertia 7 %) and leaves room
# for build. Measuring shank_length does not narrow them: it is the mass that scatters.
MASS_SCATTER = 0.10
COM_DISTANCE_SCATTER = 0.06
INERTIA_SCATTER = 0.15

# A relaxed, healthy knee, from a pendulum test (omicsonline.org 2161-0673-S6-001, Fig. 1):
# peaks .94, .60, .38, .26 rad at a period of 1.10 s give 2.6-3.2 N m/rad beside gravity and
# 0.32-0.41 N m s/rad. One record: the 60 % is an engineering estimate of how healthy knees differ.
KNEE_STIFFNESS = 2.9  # N m/rad
KNEE_DAMPING = 0.36  # N m s/rad
KNEE_SCATTER = 0.60


@dataclass(frozen=True)
class Expected:
    """A value and its standard deviation between people, both in the unit of the parameter."""

    value: float
    standard_deviation: float


@dataclass(frozen=True)
class ExpectedLeg:
    """What to expect of one leg before it has moved."""

    mass: Expected  # kg, shank and foot
    inertia: Expected  # kg m^2, about the knee
    com_distance: Expected  # m, from the knee
    damping: Expected  # N m s/rad
    stiffness: Expected  # N m/rad
    source: str


class Fractions(NamedTuple):
    """One anthropometric table: masses of body mass, lengths of body height or segment length."""

    shank_mass: float
    foot_mass: float
    shank_length: float  # knee to ankle, of body height
    shank_com: float  # from the knee, of shank length
    shank_gyration: float  # about the shank's COM, flexion axis, of shank length
    foot_gyration: float  # about the foot's COM, flexion axis, of body height
    foot_below: float = FOOT_BELOW  # COM of the foot below the ankle, of body height
    foot_ahead: float = FOOT_AHEAD  # and ahead of it


# Zatsiorsky-Seluyanov as adjusted by de Leva, J Biomech 29(9):1223-1230, 1996: shank knee to ankle
# centre (440.3 of 1741 mm, 438.6 of 1735 mm), foot length 258.1 and 228.3 mm.
DE_LEVA = {
    "male": Fractions(0.0433, 0.0137, 0.2529, 0.4395, 0.246, 0.245 * 0.1482),
    "female": Fractions(0.0481, 0.0129, 0.2528, 0.4352, 0.263, 0.279 * 0.1316),
}
# Winter, Biomechanics and Motor Control of Human Movement, 4th ed. 2009, Table 4.1 (Dempster);
# the foot's length there is ankle to ball, here 0.076 H.
WINTER = Fractions(0.0465, 0.0145, 0.246, 0.433, 0.302, 0.475 * 0.076)
# Dumas, Cheze, Verriest, J Biomech 40(3):543-553, 2007: shank 433 of 1770 mm (388 of 1610 mm), foot
# 265 mm (233 mm), whose COM lies 101 mm (63 mm) ahead of and 40 mm (51 mm) below the ankle.
DUMAS = {
    "male": Fractions(0.048, 0.012, 0.2446, 0.410, 0.28, 0.36 * 0.1497, 0.0226, 0.0572),
    "female": Fractions(0.045, 0.010, 0.2410, 0.404, 0.28, 0.36 * 0.1447, 0.0315, 0.0391),
}
# The paper's 5 % and 2 % (Eq. 5-6); it does not say where the parts hang: Winter's geometry.
PAPER = WINTER._replace(shank_mass=0.05, foot_mass=0.02)


def expected_leg(
    body_mass: float,
    height: float,
    *,
    table: TableName = "de_leva",
    sex: Sex | None = None,
    shank_length: float | None = None,
    shank_radius: float | None = None,
) -> ExpectedLeg:
    """The leg that anatomy expects of a body mass [kg] and a height [m], by one of four tables.

    - `de_leva` (default), `dumas`: by sex; without one, the mean of female and male.
    - `winter`: one table for all.
    - `paper`: Eq. 5-8 and J = m l^2 + theta of Eq. 12 as printed: only the shank's own theta, by
      Eq. 8 with its capsule as printed, the foot's left out. That is 17 % below both segments'.

    A measured `shank_length` [m], knee to ankle, takes the place of the table's. `shank_radius`
    [m] enters Eq. 8 alone. The foot hangs 0.0226 H below and 0.0316 H ahead of the ankle (Dumas:
    its own place); 1 cm more or less changes the inertia by about 0.01 kg m^2.

    **Raises** `ValueError` when body mass and height are not those of one person in kg and m.
    """
    check_body(body_mass, height)
    part = fractions(table, sex)
    length = part.shank_length * height if shank_length is None else shank_length
    if not 0.12 <= length / height <= 0.36:
        raise ValueError(f"shank_length {length:g} m does not fit a height of {height:g} m.")
    if table == "paper":
        radius = SHANK_RADIUS * height if shank_radius is None else shank_radius
        theta = capsule_inertia(part.shank_mass * body_mass, length, radius, as_printed=True)
        inertia = leg_mass(part, body_mass) * com_distance(part, height, length) ** 2 + theta
    else:
        inertia = two_segment_inertia(part, body_mass, height, length)
    return ExpectedLeg(
        mass=scattered(leg_mass(part, body_mass), MASS_SCATTER),
        inertia=scattered(inertia, INERTIA_SCATTER),
        com_distance=scattered(com_distance(part, height, length), COM_DISTANCE_SCATTER),
        damping=scattered(KNEE_DAMPING, KNEE_SCATTER),
        stiffness=scattered(KNEE_STIFFNESS, KNEE_SCATTER),
        source=f"anatomy, table {table}" + (f", {sex}" if sex else ""),
    )


def paper_prior(body_mass: float = 77.0, height: float = 1.80) -> ExpectedLeg:
    """The paper's expected vector (Eq. 14), scaled from its subject (77 kg, 1.80 m) to another.

    m = 0.07 body mass, l by height, J by mass and height squared; d and c as printed. All standard
    deviations are 1 in the parameter's own unit: Eq. 11 weighs every difference alike.

    Eq. 14 does not follow from Eq. 5-8: for its subject those give l = 0.276 m, not 0.2461, and
    J = 0.48 kg m^2 (0.58 with the foot's part), not 0.35; J - m l^2 of Eq. 14 is the theta of a
    shin 0.25 m long.
    Its d = 30 is some eighty times a relaxed knee's: d and c of its source look interchanged.
    """
    check_body(body_mass, height)
    heavier, taller = body_mass / 77.0, height / 1.80
    values = (0.07 * body_mass, 0.35 * heavier * taller**2, 0.2461 * taller, 30.0, 2.0)
    return ExpectedLeg(*(Expected(value, 1.0) for value in values), source="paper, Eq. 14")


def reach(height: float) -> float:
    """The greatest distance of any mass of the leg from the knee axis [m]: 0.555 m at 1.80 m.

    Knee to toe with the ankle at a right angle. With it J <= reach m l holds for every such leg,
    the upper bound that Eq. 12 lacks.
    """
    check_height(height)
    return REACH * height


def capsule_inertia(
    mass: float, length: float, radius: float, *, as_printed: bool = False
) -> float:
    """Inertia of a solid capsule about a transverse axis through its centre [kg m^2] (Eq. 8).

    `length` [m] is from tip to tip, so that the cylinder is h = length - 2 radius long, and with
    the density rho = mass / (V_cylinder + V_sphere):

        theta = rho V_cylinder (h^2/12 + r^2/4) + rho V_sphere (2 r^2/5 + h^2/4 + 3 h r/8)

    `as_printed` puts the paper's h^2/2 in place of h^2/4, a known slip that makes a shin's theta
    32-36 % too large.
    """
    h, r = length - 2 * radius, radius
    if not (mass > 0 and r > 0 and h >= 0):
        raise ValueError(
            f"a capsule of {mass:g} kg, length {length:g} m and radius {radius:g} m does not "
            "exist: the length includes both round ends."
        )
    cylinder, sphere = pi * r**2 * h, 4 / 3 * pi * r**3
    density = mass / (cylinder + sphere)
    ends = h**2 / 2 if as_printed else h**2 / 4
    return density * (
        cylinder * (h**2 / 12 + r**2 / 4) + sphere * (2 * r**2 / 5 + ends + 3 * h * r / 8)
    )


def fractions(table: TableName, sex: Sex | None) -> Fractions:
    if sex not in (None, "female", "male"):
        raise ValueError(f"sex is {sex!r}; it can be 'female', 'male' or None (their mean).")
    match table:
        case "winter":
            return WINTER
        case "paper":
            return PAPER
        case "de_leva" | "dumas":
            both = DE_LEVA if table == "de_leva" else DUMAS
            return both[sex] if sex else mean(both["female"], both["male"])
    raise ValueError(f"table is {table!r}; it can be de_leva, winter, dumas or paper.")


def mean(one: Fractions, other: Fractions) -> Fractions:
    return Fractions(*((a + b) / 2 for a, b in zip(one, other, strict=True)))


def leg_mass(part: Fractions, body_mass: float) -> float:
    """Eq. 5-6: shank and foot as fractions of body mass."""
    return (part.shank_mass + part.foot_mass) * body_mass


def com_distance(part: Fractions, height: float, shank_length: float) -> float:
    """Eq. 7: the norm of the mass-weighted mean of both COM, d_S and d_F, seen from the knee."""
    below, ahead = foot_com(part, height, shank_length)
    whole = part.shank_mass + part.foot_mass
    down = (part.shank_mass * part.shank_com * shank_length + part.foot_mass * below) / whole
    return hypot(down, part.foot_mass * ahead / whole)


def two_segment_inertia(
    part: Fractions, body_mass: float, height: float, shank_length: float
) -> float:
    """J = sum of m (distance^2 + gyration^2) over shank and foot, about the knee (Steiner)."""
    below, ahead = foot_com(part, height, shank_length)
    shank = (part.shank_com**2 + part.shank_gyration**2) * shank_length**2
    foot = below**2 + ahead**2 + (part.foot_gyration * height) ** 2
    return body_mass * (part.shank_mass * shank + part.foot_mass * foot)


def foot_com(part: Fractions, height: float, shank_length: float) -> tuple[float, float]:
    """d_F: how far the foot's COM lies below the knee and ahead of the shank [m]."""
    return shank_length + part.foot_below * height, part.foot_ahead * height


def scattered(value: float, relative: float) -> Expected:
    return Expected(value, relative * value)


def check_body(body_mass: float, height: float) -> None:
    check_height(height)
    if not 2.0 <= body_mass <= 400.0:
        raise ValueError(f"body_mass {body_mass:g} kg is no person's. Is it in grams or pounds?")
    index = body_mass / height**2
    if not 10.0 <= index <= 80.0:
        raise ValueError(
            f"body_mass {body_mass:g} kg and height {height:g} m make a body mass index of "
            f"{index:.3g}, beyond 10 to 80. Check both: kg, and m."
        )


def check_height(height: float) -> None:
    if not 0.4 <= height <= 2.6:
        raise ValueError(f"height {height:g} m is no person's. It must be in metres; is it in cm?")
