"""What a fit found: values with their errors and reasons, not bare numbers."""

from dataclasses import dataclass, field, fields
from typing import Annotated, Any

import numpy as np
from jaxtyping import Float

from exoid.files.named import Named
from exoid.fitting.misfit.missed import Disturbance
from exoid.fitting.result import summary
from exoid.fitting.result.estimates.basis import Basis
from exoid.fitting.result.estimates.estimate import Estimate
from exoid.fitting.result.segment_fit import SegmentFit, pooled
from exoid.physics.leg import LegModel, LegParameters
from exoid.physics.term import Term
from exoid.physics.torque import NoTorque


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
    damping_under_load: Estimate | None = None  # over that with the least mass, less 1
    stiffness_under_load: Estimate | None = None
    distance_apart: Estimate | None = None  # log r of the heaviest of several masses less lightest
    extent_apart: Estimate | None = None  # m^2, and k^2

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
    basis: Basis | None = field(default=None, metadata={"saved": False})  # `basis_to` says why
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

    def basis_to(self, wanted: str) -> Basis:
        """What the fit rests on, wanted to do this with.

        **Raises** `ValueError` where it has none: a saved fit, or one of every segment alone.
        """
        if self.basis is not None:
            return self.basis
        if self.leg is None:
            raise ValueError(f"every segment was fitted alone: there is no one fit to {wanted}.")
        raise ValueError(
            f"this fit was saved, and a file holds its numbers alone: to {wanted}, fit the "
            "recording again."
        )

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
