"""What a fit found: values with their errors and reasons, not bare numbers."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, fields, replace
from math import hypot
from typing import Annotated, Any

import numpy as np
from jaxtyping import Float

from exoid.files.named import Named
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.misfit.uncertainty import Information, Shares, Source
from exoid.fitting.model.user_values import Means
from exoid.fitting.multistart.search_result import SearchResult
from exoid.fitting.result import summary
from exoid.fitting.result.conditions import Conditions
from exoid.fitting.solve.problem import Problem
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.term import Term
from exoid.physics.torque import NoTorque

RIVALS = "rival causes"  # what limits a number where a diagnosis cannot tell causes apart
Curve = Float[np.ndarray, " sample"]


@dataclass(frozen=True)
class Estimate:
    """A quantity as the tables print it. `value` is None where nothing determines it."""

    symbol: str
    title: str
    unit: str
    value: float | None
    standard_error: float | None
    expected: float | None = None
    expected_deviation: float | None = None
    lower: float | None = None
    upper: float | None = None
    shares: Shares | None = None  # of its precision; None where there is none
    reason: str | None = None  # why there is no value, or no error
    limited_by: dict[str, float] | None = None  # share of its variance that each systematic makes
    by_hand: Means | None = None  # fixed, bounded or expected by the user
    if_slack: float | None = None  # error more, for a spring slack elsewhere than at full extension

    @property
    def determined_by(self) -> Source | None:
        return None if self.shares is None else self.shares.source

    def widened(self, by: float, least: float = 0.0, cause: str | None = None) -> "Estimate":
        """With an error of `least`, and a standard deviation more, that a `cause` makes; where no
        error is, there is none to widen. What its systematics make of it stays.
        """
        error = hypot(max(self.standard_error or 0.0, least), by)
        if not self.standard_error or error == self.standard_error:
            return self
        kept = (self.standard_error / error) ** 2
        shares = {name: kept * share for name, share in (self.limited_by or {}).items()}
        more = {} if cause is None else {cause: shares.get(cause, 0.0) + 1 - kept}
        return replace(self, standard_error=error, limited_by=shares | more)

    @property
    def set_by(self) -> str | None:
        """Who determined the value, in words that tell the user's own hand from exoid's."""
        if self.by_hand == "fix":
            return "fixed by you"
        if self.by_hand == "bound" and self.shares is not None and self.shares.bound == 1.0:
            return "your bound"
        if (self.by_hand, self.determined_by) == ("prior", "prior"):
            return "your prior"
        if (self.by_hand, self.determined_by) == ("prior", "both"):
            return "both, your prior"
        if self.shares is not None and self.determined_by == "data":
            return self.shares.kind or "data"
        return self.determined_by


@dataclass(frozen=True, eq=False)
class SegmentFit:
    """Measured and simulated motion of one segment, at the samples that were fitted.

    nan is what was not measured or does not count, and where the simulation has ended.
    """

    name: str
    kind: str
    period: Annotated[float | None, "s"]
    torque_amplitude: Estimate | None  # None where no voluntary torque acts
    added_mass: Annotated[float, "kg"]
    angle_rmse: Annotated[float, "rad"]
    velocity_rmse: Annotated[float | None, "rad/s"]
    angle_noise: Annotated[float, "rad"]
    velocity_noise: Annotated[float | None, "rad/s"]
    time: Annotated[Curve, "s"]  # from the first fitted sample
    angle: Annotated[Curve, "rad"]  # measured
    angular_velocity: Annotated[Curve | None, "rad/s"]  # measured
    simulated_angle: Annotated[Curve, "rad"]
    simulated_velocity: Annotated[Curve, "rad/s"]
    begins: Annotated[float, "s"] = 0.0  # its first fitted sample on the clock of the recording
    conditions: Conditions | None = None  # to simulate it again; older files have none
    left_out: Annotated[float, "s"] = 0.0  # behind its release: what kept the leg back there
    caught: Annotated[float | None, "s"] = None  # on that clock: a hand, and nothing behind counts

    def __repr__(self) -> str:
        return f"<SegmentFit {self.name}: {self.kind}, {self.time.size} samples>"


@dataclass(frozen=True)
class MountingFit:
    """What a recording owned, where the fit tells more of it than was declared."""

    recording: str
    added_mass_distance: Estimate | None = None
    added_mass: Estimate | None = None
    added_mass_gyration: Estimate | None = None
    zero: Estimate | None = None  # of the encoder
    tilt: Estimate | None = None  # of the thigh, beyond its declared angle
    gyro_scale: Estimate | None = None
    gyro_bias: Estimate | None = None
    clock: Estimate | None = None
    torque_zero: Estimate | None = None  # of the torque's sensor
    torque_gain: Estimate | None = None  # of the same, less 1

    @property
    def known(self) -> dict[str, Estimate]:
        each = {f.name: getattr(self, f.name) for f in fields(self)[1:]}
        return {name: one for name, one in each.items() if one is not None}


@dataclass(frozen=True, eq=False)
class MultistartReport:
    """Where the starts ended. `members` are sets that fit as well as the best, one per start."""

    starts: int
    succeeded: int
    at_best: int
    loss: Float[np.ndarray, " start"]  # of the data alone, inf where a start failed
    failures: dict[str, int]  # reason: number of starts
    family: dict[str, tuple[float, float]]  # parameter: its range at the same ratios
    members: dict[str, Float[np.ndarray, " member"]]
    distinct: int  # minima found


@dataclass(frozen=True, eq=False)
class FitResult:
    """The chosen parameters and ratios, how well they fit, and what else fits as well.

    >>> result = exoid.fit("drops.csv")
    >>> each = result.ratios["damping_over_inertia"]
    >>> round(each.value, 1), each.unit, each.determined_by
    (0.8, '1/s', 'data')
    """

    parameters: dict[str, Estimate]  # mass, inertia, com_distance, damping, stiffness (, torque)
    ratios: dict[str, Estimate]
    torque_amplitude: Estimate | None  # mean over the voluntary segments, None where none is
    segments: list[SegmentFit]
    mountings: list[MountingFit]
    multistart: MultistartReport
    loss: float  # half the sum of squares of data and prior, in units of noise
    disturbance: Disturbance  # what besides noise is in the residual
    torque_frequency: str | None  # the reading of Eq. 4 that fits better, None without cycles
    other_reading_rmse: float | None  # rad, of the reading that fits worse, where both were tried
    prior: str
    terms: dict[str, dict[str, Estimate]] = field(default_factory=dict)  # by term and parameter
    leg: LegParameters | None = None  # of the model; None where every segment was fitted alone
    thigh_angle: Annotated[float, "rad"] = 0.0
    fitted_terms: tuple[Term, ...] = ()  # with the fit's values
    notes: list[str] = field(default_factory=list)
    basis: "Basis | None" = field(default=None, metadata={"saved": False})  # None: each alone
    set_aside: list[str] = field(default_factory=list)  # of the notes: what was not fitted
    gravity_moment: Estimate | None = None  # m l g of the parameters; older files have none
    astray: str | None = None  # why the simulation does not follow the recording, where it does not

    def __post_init__(self) -> None:
        terms = {name: Named(each) for name, each in self.terms.items()}
        each = {"parameters": self.parameters, "ratios": self.ratios, "terms": terms}
        for name, value in each.items():
            object.__setattr__(self, name, Named(value))

    @property
    def follows(self) -> bool:
        """Does the simulation follow the recording? Where it does not, no number is worth a thing.

        `astray` says why, and the first of the `notes` what to do.
        """
        return self.astray is None

    @property
    def of_terms(self) -> dict[str, Estimate]:
        """What the terms have, as coulomb_friction.level."""
        return {
            f"{term}.{name}": each
            for term, parameters in self.terms.items()
            for name, each in parameters.items()
        }

    @property
    def of_leg(self) -> dict[str, Estimate]:
        """The parameters, and the moment of gravity about the knee."""
        moment = self.gravity_moment
        return self.parameters | ({} if moment is None else {"gravity_moment": moment})

    @property
    def model(self) -> LegModel | None:
        """The fitted leg with its terms, as `exoid.simulate` takes it; driven by nothing.

        Where nothing tells the scale, it is a leg that moves alike. None where every segment was
        fitted alone.
        """
        if self.leg is None:
            return None
        return LegModel(self.leg, NoTorque(), np.asarray(self.thigh_angle), self.fitted_terms)

    def __repr__(self) -> str:
        return summary.lines(self)

    def _repr_html_(self) -> str:
        return summary.page(self)

    def to_dataframe(self) -> Any:
        """Parameters and ratios for pandas: a row each, with error, unit and what determined it."""
        return summary.frame(self)

    @property
    def noise_scale(self) -> float:
        """By which standard errors at least were widened beyond the sensors' noise."""
        return self.disturbance.scale

    @property
    def samples(self) -> int:
        return sum(each.time.size for each in self.segments)

    @property
    def angle_rmse(self) -> float:
        """rad, over all segments."""
        return pooled(self.segments, lambda each: each.angle_rmse)

    @property
    def velocity_rmse(self) -> float | None:
        """rad/s, over the segments that have a gyro."""
        known = [each for each in self.segments if each.velocity_rmse is not None]
        return pooled(known, lambda each: each.velocity_rmse or 0.0) if known else None

    @property
    def angle_noise(self) -> float:
        """rad, the floor that no model can go below."""
        return pooled(self.segments, lambda each: each.angle_noise)


@dataclass(frozen=True, eq=False)
class Basis:
    """What a result rests on, for those who ask further: profiles, posterior, plans."""

    problem: Problem
    ended: SearchResult
    information: Information


def pooled(segments: Sequence[SegmentFit], of: Callable[[SegmentFit], float]) -> float:
    """Root of the mean square over the samples of the segments."""
    each = [(of(segment), segment.time.size) for segment in segments]
    return float(np.sqrt(sum(v * v * n for v, n in each) / sum(n for _, n in each)))
