"""What the service answers, class by class.

Made from web/openapi.json by python/generate: not edited by hand.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

__all__ = [
    "AlikeContacts",
    "AlikeError",
    "Answer",
    "AskewError",
    "AssumptionChange",
    "AssumptionFindings",
    "AwaySweep",
    "BeginningsReport",
    "Candidate",
    "Candidates",
    "CarcassState",
    "Choice",
    "Claim",
    "CoarserIndices",
    "ColumnLook",
    "ColumnSeries",
    "ComparedAnswer",
    "ComparedFigure",
    "ComparedIndex",
    "ComparedLocation",
    "ComparedStudy",
    "ComparisonAnswer",
    "ContactError",
    "ContactFindings",
    "Cost",
    "CountForecast",
    "CutPoint",
    "DeadFilm",
    "DeadFilmError",
    "Design",
    "DesignCounts",
    "DesignEstimate",
    "DriftError",
    "ElsewhereError",
    "Engine",
    "EngineList",
    "ErrorParts",
    "ErrorSources",
    "Estimate",
    "EstimatorSummary",
    "EstimatorZero",
    "Evaluation",
    "ExpectedAccuracy",
    "Extremes",
    "FailedNode",
    "FailedPoint",
    "FilmAnglesReport",
    "FilmError",
    "FilmPair",
    "FilmPlace",
    "FilmSignal",
    "FilmState",
    "FitCost",
    "FitEstimate",
    "FitProgress",
    "ForceError",
    "ForceFindings",
    "ForcePrice",
    "Forecast",
    "FormMisses",
    "FrontLayout",
    "GapLook",
    "GapsLook",
    "GaugeError",
    "GaugeReading",
    "GradedNote",
    "Inflated",
    "Input",
    "InputShare",
    "InputsAnswer",
    "InputsBeside",
    "Knee",
    "Layout",
    "LayoutAnswer",
    "LayoutError",
    "LayoutFindings",
    "LayoutLoad",
    "LayoutScore",
    "LayoutSearch",
    "LeftOut",
    "LoadScore",
    "LoadShear",
    "LoadedReport",
    "Location",
    "LocationError",
    "LocationStrain",
    "LoneSample",
    "LoneSamples",
    "Look",
    "MemberReport",
    "MenuFindings",
    "Model",
    "ModelIndexError",
    "ModelOutput",
    "ModelPoints",
    "ModelReport",
    "Output",
    "PlaceAnswer",
    "Preset",
    "Presets",
    "Preview",
    "Question",
    "Reached",
    "RecordingFault",
    "RecordingFigures",
    "RecordingLook",
    "RecordingSeries",
    "Refusal",
    "ResponseError",
    "RestedReport",
    "RestsOn",
    "RingLoad",
    "Rings",
    "Section",
    "SectionNode",
    "Sections",
    "ShearError",
    "ShearScore",
    "SheetFilm",
    "SignalCurve",
    "SignalError",
    "SignalRow",
    "Signals",
    "SignalsAnswer",
    "SolveForecast",
    "SolvedScene",
    "SplitError",
    "SplitReport",
    "SplitReports",
    "StrainRing",
    "Strains",
    "StressWidth",
    "StudyIdentity",
    "StudySummary",
    "Surer",
    "SweepEstimate",
    "SweepSummary",
    "TableError",
    "TableReport",
    "TaskCounts",
    "ToldQuantity",
    "TradeAnswer",
    "TradeRow",
    "TrialError",
    "WheelRing",
    "WorstContact",
    "WorstForce",
]

ComparisonTable = Literal["locations", "designs"]
"""Table of a comparison."""

State = Literal["queued", "running", "done", "failed", "cancelled"]
"""State of a study."""

Table = Literal["indices", "locations", "layouts", "trade", "films", "points", "signals", "candidates", "forces"]
"""Table of a study."""


@dataclass(frozen=True, kw_only=True)
class AlikeContacts:
    """Two contacts that readings can hardly tell apart."""

    angle_deg: float
    """Angle of the first, degrees; its depth is that of the load."""
    other_angle_deg: float
    """Angle of the second, degrees."""
    other_depth_mm: float
    """Depth of the second, mm."""
    sigmas: float
    """Distance of their readings in standard deviations of the noise."""


@dataclass(frozen=True, kw_only=True)
class AlikeError:
    """Error where contacts differ in angle, load and shear alone."""

    error: TrialError
    """Error of the estimates then."""
    in_contact: TrialError
    """Error of the rows with a contact alone."""


@dataclass(frozen=True, kw_only=True)
class Answer:
    """Answer of a study: where the films go, how sure that is, and what could overturn it."""

    sentence: str
    """The answer: the best layout and what it knows; where no layouts are asked for the best place, or the input
    that matters more than the depth below it."""
    brief: str | None = None
    """The answer in few characters, as lists of studies show it: `12 y films, 10.7 degrees`; None in results of
    earlier versions."""
    verdict: str
    """The weaker of the verdicts on layout and place, where several places are ranked; without layouts that on what
    the sentence tells. One of `certain`, `likely`, `tied`, `unknown`."""
    reason: str
    """Reason why it isn't surer, or why it is certain, with the figures that decide; whole sentences."""
    place: PlaceAnswer | None = None
    """The best place; None where no location has an index."""
    layout: LayoutAnswer | None = None
    """The layout that answers the question, or the knee of the trade; None where none is asked for, or none has a
    score."""
    trade: TradeAnswer | None = None
    """The trade of films against errors; None where no layout has a score."""
    films: tuple[SheetFilm, ...] = ()
    """Films of the answer's layout, one by one, as they are glued."""
    rests_on: RestsOn | None = None
    """Assumptions that its layout's figures rest on most; None where no layout answers."""
    inputs: InputsAnswer | None = None
    """Inputs that matter, of all there are; None where the strain at the contact centre has no index."""
    signals: SignalsAnswer | None = None
    """The film that gives most, where films' signals are read."""
    left_out: LeftOut | None = None
    """Part that the model leaves out and that changes strains most; None where no effect is known."""
    surer: Surer | None = None
    """Price of a surer answer; None at the top of the ladder. Not part of the result's hash."""


@dataclass(frozen=True, kw_only=True)
class AskewError:
    """Error with films askew."""

    std_deg: float
    """Standard deviation of the films' places around the wheel, degrees."""
    error: TrialError
    """Error of the estimates then."""


@dataclass(frozen=True, kw_only=True)
class AssumptionChange:
    """An assumption, changed."""

    of: str
    """Name of the assumption: `noise`, `drift`, `gain`, `place`, `pressure`, `camber` or `friction`."""
    words: str
    """Change in words, as in `a pressure 10 % lower`."""
    angle_error_deg: float
    """The angle's error then, degrees."""
    force_error_n: float
    """The force's error then, N."""
    times: float
    """Larger of both errors' ratios to those as assumed; of a smaller error one over that."""
    better_rank: int | None = None
    """Rank of a layout of no more films that does better then, by more than chance; None where this one stays."""
    meets: bool | None = None
    """Whether it keeps to the limits of the question then; None where none is asked, or none was kept as assumed."""


@dataclass(frozen=True, kw_only=True)
class AssumptionFindings:
    """Figures of the layout that answers, with what they rest on changed, one at a time."""

    rank: int
    """Rank of that layout."""
    angle_error_deg: float
    """95 of 100 contact angles are estimated better than this at the worst load, degrees, as assumed."""
    force_error_n: float
    """Error of the vertical force at the load where that is largest, root mean square, N, as assumed."""
    changes: tuple[AssumptionChange, ...]
    """Changed assumptions, the one that changes the figures most first."""
    unchanged: tuple[str, ...]
    """Assumptions that weren't changed, in words: those that the document names no value of, and those whose scene
    has no answer."""


@dataclass(frozen=True, kw_only=True)
class AwaySweep:
    """Sweep whose designs other machines solve, or did."""

    tasks: TaskCounts
    """Tasks of the round."""
    because: str | None = None
    """Reason why the first of those that wait does, in the engine's words."""
    designs: int
    """Designs of the round."""
    designs_ended: int
    """Designs of the round whose task was taken in and that have ended."""
    refused: tuple[Refusal, ...]
    """Nodes that handed in nothing, and why."""
    said: tuple[str, ...]
    """Further words about it, the latest last."""
    sweep: str
    """Identifier of the sweep."""
    ended: str | None = None
    """Time at which nothing of it went on any more; None while something does. What was left then has its turns at
    home."""


@dataclass(frozen=True, kw_only=True)
class BeginningsReport:
    """Errors of left-out runs by where they begin."""

    loaded: tuple[LoadedReport, ...]
    """Runs that begin under a load, which is taken for nothing where the first reading is taken off."""
    rested: tuple[RestedReport, ...]
    """Runs that are zeroed after lifting."""
    rest_s: float | None = None
    """Least rest after which the error is at most 1.2 times that of the same rows as recorded, s; None where no
    recorded rest is long enough."""
    advice: str
    """Sentences that follow from it: when to zero, and what a begin under load does."""


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A kind of film: where in the section, along which direction, how large."""

    section_deg: float
    """Section angle from the crown, degrees."""
    direction: str
    """Direction of its length."""
    length_mm: float | None = None
    """Length of the film, mm; None of a point."""
    width_mm: float | None = None
    """Width of the film, mm; None of a point."""
    signal: float
    """Largest signal around the wheel, over all loads."""
    angle_information: float
    """Root of the mean information on the contact angle over the turn and the loads, 1/degree, at the noise of the
    layouts."""
    depth_information: float
    """Root of the mean information on the depth, 1/mm."""
    angle_information_error: float | None = None
    """Error of the information on the angle by the coarser mesh."""


@dataclass(frozen=True, kw_only=True)
class Candidates:
    """Kinds of film for layouts, by several criteria."""

    candidates: tuple[Candidate, ...]
    """Every section angle and direction."""


@dataclass(frozen=True, kw_only=True)
class CarcassState:
    """Least and greatest values over the whole textile layer."""

    fibre_stretch: Extremes
    """Stretch of the fibres."""
    tension_n_per_mm: Extremes
    """Tension along the fibres: force per reference length across a family, N/mm; negative in compression."""


@dataclass(frozen=True, kw_only=True)
class Choice:
    """A modelling choice with its reason."""

    what: str
    """The part."""
    why: str
    """The reason."""
    effect: float | None = None
    """Effect of leaving it out: the largest change of a strain at P1, P2, ... at the means when it is modelled, over
    the largest strain of that direction there."""


@dataclass(frozen=True, kw_only=True)
class Claim:
    """Whether a claim holds of one film."""

    tire: str
    """Name of the tire."""
    film: str
    """Model of the film. One of `bare`, `transfer`, `coupled`."""
    position: str
    """Position of the film in the section."""
    direction: str
    """Direction of its length."""
    claim: str
    """Claim about the curve. One of `voltage rises with load`, `voltage falls with pressure`, `linear over the
    contact angle`."""
    holds: str
    """Whether it holds. One of `yes`, `no`, `uncertain`."""
    detail: str
    """Course of the curve, in words."""


@dataclass(frozen=True, kw_only=True)
class CoarserIndices:
    """Indices of the same points on a coarser mesh: the witness of the mesh's error, and of how much of it two
    studies share."""

    first_order: tuple[float, ...]
    """First-order index of each input."""
    factor: float
    """Error of the finer mesh over its difference from the coarser one."""


@dataclass(frozen=True, kw_only=True)
class ColumnLook:
    """Column that was looked at. Figures of a force are in newtons, those of the time in seconds."""

    column: str
    """Name of the column in the file."""
    taken: str
    """Part that the column is taken for. One of `time`, `force`, `signal`, `cycle`, `nothing`."""
    force: str | None = None
    """Name that estimates give the force; None of other columns."""
    newtons: float | None = None
    """Newtons of one of a force's unit; None of other columns."""
    time_unit: str | None = None
    """Unit of a time in words; None of other columns."""
    measured: int
    """Rows with a number."""
    empty: int
    """Empty cells, and words for them."""
    texts: int
    """Cells with text, which are read in columns that are taken for nothing or tell cycles apart."""
    least: float | None = None
    """Least number; None of none."""
    greatest: float | None = None
    """Greatest number; None of none."""
    noise: float | None = None
    """Deviation of the noise: median size of the differences between neighbours, over sqrt(2) 0.6745."""
    unloaded: float | None = None
    """Median where no force acts: where each is below a twentieth of its largest."""
    drift: float | None = None
    """Median of the last third of the rows without a force less that of the first third; None of fewer than 30 such
    rows."""
    lone: LoneSamples
    """Samples that stand alone: away from both neighbours by more than 20 robust deviations of the differences
    between neighbours."""
    suspicions: tuple[str, ...]
    """Sentences on what makes the column suspect."""


@dataclass(frozen=True, kw_only=True)
class ColumnSeries:
    """A column over time."""

    column: str
    """Name of the column in the file."""
    least: tuple[float | None, ...]
    """Least number of each bin; None where there is none."""
    greatest: tuple[float | None, ...]
    """Greatest number of each bin; None where there is none."""


@dataclass(frozen=True, kw_only=True)
class ComparedAnswer:
    """Layout by which a study is compared."""

    rank: int
    """Place among the studies, 1 is best."""
    layout_rank: int
    """Rank of the layout in its study's `layouts`."""
    words: str
    """Description of the layout, as in `12 films along y at the crown, one every 30 degrees`."""
    film_count: int
    """All its films."""
    meets: bool | None = None
    """Whether it keeps to the limits that the document asks for; None where it asks for none."""
    verdict: str
    """Certainty of the layout within its study. One of `certain`, `likely`, `tied`, `unknown`."""
    angle_deg: ComparedFigure
    """Error of the contact angle in 95 of 100 contacts at the worst load, degrees."""
    force_n: ComparedFigure | None = None
    """Root mean square error of the vertical force at the worst load, N; None where the study doesn't estimate it."""
    trade: tuple[TradeRow, ...]
    """Best layout of each number of films."""


@dataclass(frozen=True, kw_only=True)
class ComparedFigure:
    """Figure of a layout beside the baseline's."""

    value: float
    """The figure."""
    error: float | None = None
    """Claimed error of the figure; None where there is no coarser mesh."""
    difference: float | None = None
    """The figure minus the baseline's; None in the baseline."""
    difference_error: float | None = None
    """Error of the difference; None where one of both isn't known."""
    verdict: str | None = None
    """Whether the difference is beyond its error. One of `real`, `noise`, `unknown`."""


@dataclass(frozen=True, kw_only=True)
class ComparedIndex:
    """An index beside the baseline's."""

    gsi_percent: float | None = None
    """The index, percent."""
    error_percent: float | None = None
    """Error of the index, percentage points."""
    difference_percent: float | None = None
    """The index minus the baseline's, percentage points; None in the baseline."""
    difference_error_percent: float | None = None
    """Error of the difference, percentage points: less than both errors together, where both meshes err alike."""
    verdict: str | None = None
    """Whether the difference is beyond its error. One of `real`, `noise`, `unknown`."""


@dataclass(frozen=True, kw_only=True)
class ComparedLocation:
    """A location in one of the studies."""

    study: str
    """The study."""
    location: str
    """P1, P2, ..."""
    rank: int
    """1 is best."""
    rank_certain: bool
    """Whether the errors leave no doubt about this rank."""
    rank_change: int | None = None
    """Places lost since the baseline, negative when gained, where equal locations share the place of the first of
    them; None there, and where it hasn't the location."""
    rank_verdict: str | None = None
    """Whether a change of the place is `real` (both places are certain), `noise` or `unknown`; None without one."""
    x: ComparedIndex
    """First-order index of the location's own depth for the x strain at the contact centre."""
    y: ComparedIndex
    """First-order index of the location's own depth for the y strain at the contact centre."""


@dataclass(frozen=True, kw_only=True)
class ComparedStudy:
    """A study of those compared."""

    id: str
    """Identifier of the study."""
    name: str
    """Name of the study, or that of the design."""
    set: dict[str, Any] | None = None
    """Settings of the design, by path; None for a study that belongs to no sweep."""
    state: str
    """`queued`, `running`, `done`, `failed` or `cancelled`."""
    reason: str | None = None
    """Reason why there is no result."""
    spec_sha256: str | None = None
    """SHA-256 of its document."""
    version: str | None = None
    """Versions of the program and the solver."""
    level: str | None = None
    """Mesh level."""
    reaction_n: float | None = None
    """Vertical force at the means, N."""
    std_strain_x: float | None = None
    """Standard deviation of the x strain at the contact centre: the signal of a film there."""
    std_strain_y: float | None = None
    """Standard deviation of the y strain there."""
    best: str | None = None
    """First of the ranking."""
    best_certain: bool | None = None
    """Whether its errors leave no doubt about that."""
    answer: ComparedAnswer | None = None
    """Layout by which it is compared; None where no layout has a score."""
    layout_spacing_deg: float | None = None
    """Angle between the units of that layout, degrees."""
    layout_position: str | None = None
    """Position of that layout's units."""
    cost: Cost | None = None
    """Cost of the study."""


@dataclass(frozen=True, kw_only=True)
class ComparisonAnswer:
    """The study that answers best."""

    sentence: str
    """The study that answers best with its layout, and the next, in a sentence."""
    verdict: str
    """Certainty that no other study answers better. One of `certain`, `likely`, `tied`, `unknown`."""


@dataclass(frozen=True, kw_only=True)
class ComparisonFields:
    """The table."""

    answer: ComparisonAnswer | None = None
    """The study that answers best, with its layout; None unless two have a layout."""
    baseline: str | None = None
    """The study that differences are taken from; None when none of them has a result."""
    studies: tuple[ComparedStudy, ...]
    """The studies in the order asked for."""
    rows: tuple[ComparedLocation, ...]
    """Every location of every study that has a result, best first."""
    notes: tuple[str, ...]
    """Notes that the reader must know before believing the differences, whole sentences."""


@dataclass(frozen=True, kw_only=True)
class ContactError:
    """Simulated errors of contacts that differ from the usual one in a single quantity."""

    of: str
    """The quantity, as `layouts.contacts` names it; `noise`: none differs."""
    words: str
    """Name for people."""
    p95_angle_error_deg: float
    """95 % of contact angles are estimated better than this, degrees."""
    force_error_n: float
    """Error of the vertical force, root mean square, N."""


@dataclass(frozen=True, kw_only=True)
class ContactFindings:
    """Response surface of contacts as they come, and how far it is off at contacts that it hasn't seen."""

    laws: tuple[str, ...]
    """Quantities with what their laws reach from and to, in words."""
    checks: int
    """Contacts of all quantities at once by which it was judged."""
    signal_error_rms: float
    """Root mean square error of the signals there within 30 degrees of the contact, over the crown's largest at that
    depth."""
    signal_claim: float | None = None
    """Claim that 95 % of the errors of signals at other such contacts are within this, over the crown's largest:
    Student's t for so few contacts. None of a study before claims."""
    signal_error_largest: float
    """Largest error of a signal there, over the crown's largest."""
    slope_error_rms: float | None = None
    """Root mean square error of the signals' slopes over the contact's angle there, over the crown's steepest; none
    of a study that didn't judge them."""
    slope_claim: float | None = None
    """Claim for such slopes."""
    slope_error_largest: float | None = None
    """Largest error of such a slope."""
    force_error_n: float
    """Root mean square error of the vertical force there, N."""
    force_claim_n: float | None = None
    """Claim for the force, N."""
    short: tuple[str, ...] = ()
    """Quantities whose laws reach beyond what could be solved, in words: what is drawn ends there."""


@dataclass(frozen=True, kw_only=True)
class Cost:
    """Cost of a study."""

    solves: int
    """Points of the plan."""
    coarser_solves: int
    """Points of the plan solved once more on a coarser mesh, for the error of the mesh."""
    effect_solves: int
    """Solves that show what the model leaves out."""
    signal_solves: int
    """Solves of films' signals, on both meshes."""
    layout_solves: int
    """Solves of layouts' loads, on both meshes."""
    table_solves: int
    """Solves of a rig's table of responses."""
    rungs_wall_s: tuple[float, ...] = ()
    """Wall-clock time of each rung of the climb, s."""
    reused: int
    """Points taken from the archive instead of being solved."""
    newton_iterations: int
    """Newton iterations of all solves."""
    factorisations: int
    """Factorisations of all solves, without the tangent that the solves from one equilibrium share."""
    wall_s: float
    """Wall-clock time of this run, s."""
    cpu_s: float
    """Processor time of this run's own threads, s; 0 where the system doesn't tell it."""
    peak_memory_bytes: int
    """Peak memory of the process, bytes."""
    factorisation_share: float
    """Share of the solves' time in numeric factorisation."""
    substitution_share: float
    """Share in substitutions with the factor, and in the contact solved between them."""
    assembly_share: float
    """Share in assembly."""
    other_share: float
    """Share in all the rest, and in solves that found no equilibrium."""


@dataclass(frozen=True, kw_only=True)
class CountForecast:
    """A number of solves with its range."""

    least: int
    """Least count."""
    expected: int
    """Likeliest count, as far as can be told."""
    most: int
    """Greatest count."""


@dataclass(frozen=True, kw_only=True)
class CutPoint:
    """The response at the means."""

    values: tuple[float, ...]
    """Input values."""
    reaction_n: float
    """Vertical force, N."""
    depth_mm: float
    """Height of the ground at the contact centre above the inflated outer radius, mm."""
    inflated_outer_radius_mm: float
    """Outer radius after inflation, mm."""
    locations: tuple[LocationStrain, ...]
    """Strains at P1, P2, ..."""
    residual_history: tuple[tuple[float, ...], ...]
    """Newton residuals of its load steps."""


@dataclass(frozen=True, kw_only=True)
class DeadFilm:
    """Score that is left when a film dies."""

    film: int
    """The film, counted from 0."""
    simulated_p95_angle_error_deg: float | None = None
    """Simulated 95th percentile of the angle's error without it, degrees."""
    bayes_angle_error_deg: float | None = None
    """Bound of the angle with a flat prior without it, root mean square, degrees."""


@dataclass(frozen=True, kw_only=True)
class DeadFilmError:
    """Error with a film dead."""

    film: int
    """The film, counted from 0."""
    error: TrialError
    """Error of the estimates without it."""


@dataclass(frozen=True, kw_only=True)
class Design:
    """A design of the sweep."""

    ordinal: int
    """Ordinal of the design in the sweep."""
    name: str
    """Name that tells it from the others."""
    set: dict[str, Any]
    """Values by path."""
    study: StudySummary
    """The study that answers for it."""


@dataclass(frozen=True, kw_only=True)
class DesignCounts:
    """Designs by where they stand."""

    queued: int
    """Wait for their turn."""
    running: int
    """Are being solved."""
    done: int
    """Have a result."""
    failed: int
    """Have none, and their study says why."""
    cancelled: int
    """Were cancelled."""


@dataclass(frozen=True, kw_only=True)
class DesignEstimate:
    """Estimate of a design's cost."""

    name: str
    """Name that tells it from the others."""
    estimate: Estimate
    """Estimate of its study."""


@dataclass(frozen=True, kw_only=True)
class DriftError:
    """Error with another drift of the readings."""

    drift: str
    """The drift in words, as a share of a film's full scale."""
    error: TrialError
    """Error of the estimates then."""
    in_contact: TrialError
    """Error of the rows with a contact alone."""


@dataclass(frozen=True, kw_only=True)
class ElsewhereError:
    """Error on another tire."""

    tire: str
    """Difference from the study's tire, in words."""
    learnt: bool
    """Whether estimators learnt from runs on it, too."""
    error: TrialError
    """Error of the estimates there."""


@dataclass(frozen=True, kw_only=True)
class Engine:
    """Engine, with the sweeps that it has or had."""

    name: str
    """Name of the engine, as `?engine=` has it. One of `slurm`, `command`."""
    tasks: TaskCounts
    """Tasks of all its sweeps."""
    sweeps: tuple[AwaySweep, ...]
    """Sweeps whose tasks go on, and others, newest first."""


@dataclass(frozen=True, kw_only=True)
class EngineList:
    """Engines that a service has."""

    engines: tuple[Engine, ...]
    """Each engine that clients may name."""


@dataclass(frozen=True, kw_only=True)
class ErrorParts:
    """Parts of the error of an index, absolute."""

    mesh: float | None = None
    """Error of the mesh."""
    quadrature: float | None = None
    """Error of the quadrature rule."""
    decomposition: float | None = None
    """Error of the decomposition."""
    total: float | None = None
    """Sum of the parts, the largest over the inputs; None where the mesh's part isn't known."""
    reason: str | None = None
    """Reason why a part is None."""


@dataclass(frozen=True, kw_only=True)
class ErrorSources:
    """Sources of a layout's error of the contact angle at the study's own load: root mean squares over all contact
    angles, to first order, degrees."""

    noise_deg: float
    """Error by the noise of the readings."""
    inputs_deg: tuple[float, ...]
    """Error by each input of the study, which the estimate takes at its mean."""


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """Estimate of what a study will cost, and be worth."""

    solves: SolveForecast
    """Equilibria to solve."""
    wall_s: Forecast | None = None
    """Wall-clock time; None where `reason` says why."""
    peak_memory_bytes: int
    """Largest resident memory of the process, bytes."""
    database_bytes: int = 0
    """Room that its points and result take in the database, bytes; 0 in results of earlier versions."""
    accuracy: ExpectedAccuracy
    """Accuracy that the answer is expected to have."""
    threads: int
    """Solves at once."""
    measured_solves: int
    """Solves of this database by which the times were corrected for this machine; 0: the times are those of another
    machine."""
    reasons: tuple[str, ...]
    """Reasons why figures are ranges or None, whole sentences."""
    unlikely: tuple[str, ...] = ()
    """Values that the physics makes unlikely, each with what may have been meant."""


@dataclass(frozen=True, kw_only=True)
class EstimatorSummary:
    """An estimator in its queue, at work, or at its end. Times are RFC 3339, UTC."""

    id: str
    """UUID, ordered by time."""
    name: str
    """Free text."""
    state: str
    """State of the estimator. One of `queued`, `running`, `done`, `failed`, `cancelled`."""
    error: str | None = None
    """Reason why it failed, a sentence."""
    created: str
    """Time at which it was submitted."""
    started: str | None = None
    """Time at which it was first started."""
    finished: str | None = None
    """Time at which it ended."""
    forces: tuple[str, ...]
    """The forces' columns, N."""
    recordings: tuple[RecordingFigures, ...]
    """Recordings that it is learnt from."""
    progress: FitProgress | None = None
    """Progress while it runs; None otherwise."""
    estimate: FitEstimate | None = None
    """Estimate of what learning takes, once it has its turn; None for estimators of earlier versions."""


@dataclass(frozen=True, kw_only=True)
class EstimatorZero:
    """Zero that an estimator was given: what its signals are without a force."""

    file: str
    """Recording without load that it is from."""
    set: str
    """Time at which it was given."""
    signals: tuple[str, ...]
    """Signals' columns."""
    zero: tuple[float, ...]
    """Each signal's median over the recording's rows without a force, in its own unit."""


@dataclass(frozen=True, kw_only=True)
class Evaluation:
    """A point that has an outcome."""

    ordinal: int
    """Ordinal of the point in the plan."""
    key: str
    """Hash of all that determines its outcome."""
    level: str | None = None
    """Mesh level."""
    values: tuple[float, ...] | None = None
    """The inputs' values; None when its scene hasn't one of them."""
    reaction_n: float | None = None
    """Vertical force, N; None without an equilibrium."""
    depth_mm: float | None = None
    """Height of the ground at the contact centre above the inflated outer radius, mm; absent without an equilibrium."""
    locations: tuple[LocationStrain, ...] | None = None
    """Strains at P1, P2, ...; None without an equilibrium."""
    newton_iterations: int | None = None
    """Newton iterations; None without an equilibrium."""
    wall_s: float
    """Wall-clock time of the solve, s."""
    reason: str | None = None
    """Reason why there is no equilibrium."""
    reached: Reached | None = None
    """Loads of the last equilibrium before."""


@dataclass(frozen=True, kw_only=True)
class ExpectedAccuracy:
    """Accuracy that studies of this kind had where that was measured: the largest error of the ten indices that the
    paper's study ranks by, absolute."""

    fidelity: str
    """Mesh and method of the answer, in a few words."""
    error_true: float | None = None
    """Difference from the finest reference."""
    error_claimed: float | None = None
    """Error that the answer claimed itself."""
    reason: str | None = None
    """Reason why there are no figures."""


@dataclass(frozen=True, kw_only=True)
class Extremes:
    """Least and greatest value of a field."""

    min: float
    """Least value."""
    max: float
    """Greatest value."""


@dataclass(frozen=True, kw_only=True)
class FailedNode:
    """A node without an equilibrium."""

    value: float
    """Value of the input."""
    reason: str
    """Reason, a sentence."""


@dataclass(frozen=True, kw_only=True)
class FailedPoint:
    """A point without a response."""

    ordinal: int
    """Ordinal in the plan."""
    values: tuple[float, ...]
    """Input values."""
    cause: str
    """Cause of the failure."""


@dataclass(frozen=True, kw_only=True)
class FilmAnglesReport:
    """Glued films solved with the tire around the wheel, on undragged ground; errors are over the largest signal of
    their kind."""

    level: str
    """Mesh level of the tire with a film."""
    angles_deg: tuple[float, ...]
    """Angles from the contact, degrees; films that lie askew on both sides of it."""
    loads_n: tuple[float, ...]
    """Loads, N."""
    tested: int
    """Solves between them that tested the signals; 0 where none did, or where one of them has no equilibrium."""
    signal_rms: float | None = None
    """Root mean square of their signals' errors; None where nothing was tested."""
    signal_worst: float | None = None
    """The largest; None where nothing was tested."""
    transfer_worst: float
    """The largest error of a transfer alone, which is solved for films above the contact."""


@dataclass(frozen=True, kw_only=True)
class FilmError:
    """Estimated discretisation errors of a film, absolute: the change from the next coarser mesh, times Richardson's
    factor."""

    mean_strain_1: float
    """Error of the mean strain along."""
    mean_strain_2: float
    """Error of the mean strain across."""
    mean_tension_1_n_per_mm: float
    """Error of the mean tension along, N/mm."""
    mean_tension_2_n_per_mm: float
    """Error of the mean tension across, N/mm."""
    charge_nc: float
    """Error of the charge, nC."""
    open_circuit_v: float
    """Error of the open circuit's voltage, V."""
    output_v: float
    """Error of the amplifier's voltage, V."""


@dataclass(frozen=True, kw_only=True)
class FilmPair:
    """The difference of two films at the crown, 30 degrees before and behind a point of the wheel, as the contact
    moves away from that point."""

    tire: str
    """Name of the tire."""
    film: str
    """Model of the films. One of `bare`, `transfer`, `coupled`."""
    direction: str
    """Direction of their length."""
    contact_deg: tuple[float, ...]
    """Wheel angles from that point to the contact, degrees."""
    values: tuple[float | None, ...]
    """Open circuit's voltage of the film that the contact comes to minus that of the other one, V; None where it
    isn't solved."""
    monotone: str | None = None
    """Trend of the difference. One of `up`, `down`, `no`."""
    linear_r2: float | None = None
    """Share of the variance that a line explains."""


@dataclass(frozen=True, kw_only=True)
class FilmPlace:
    """A film of a layout."""

    theta_deg: float
    """Wheel angle, degrees."""
    phi_deg: float
    """Section angle from the crown, degrees."""
    angle_deg: float
    """Angle of its length to the circumferential direction, degrees: 0 is x, 90 is y."""


@dataclass(frozen=True, kw_only=True)
class FilmSignal:
    """Signal that the contact adds to a film since inflation: means over its area, and what its amplifier reads of
    them."""

    mean_strain_1: float
    """Mean strain along: stretch relative to the inflated state minus one."""
    mean_strain_2: float
    """Mean strain across."""
    mean_tension_1_n_per_mm: float
    """Mean tension along, N/mm."""
    mean_tension_2_n_per_mm: float
    """Mean tension across, N/mm."""
    curvature_change_1_per_mm: float
    """Change of curvature along, 1/mm, positive where the surface becomes more hollow towards the cavity."""
    curvature_change_2_per_mm: float
    """Change of curvature across, 1/mm."""
    charge_nc: float
    """Charge, nC."""
    capacitance_pf: float
    """Capacitance of the film, pF."""
    open_circuit_v: float
    """Voltage where nothing draws charge, V."""
    output_v: float
    """Amplitude at the amplifier, for presses of its frequency, V."""
    output_std_v: float
    """Standard deviation of that by the amplifier's noise, the gain and the temperature, V."""
    charge_by_pressure_nc_per_kpa: float
    """Change of the charge by a rise of the cavity's pressure, nC per kPa."""
    charge_by_warming_nc_per_k: float
    """Change of the charge by warming, nC per K."""
    time_constant_s: float | None = None
    """Time in which the reading of a held press falls to 1/e, s; absent where it stays."""
    state: str
    """Whether the film bears that, and the amplifier shows it. One of `ok`, `beyond-yield`, `saturated`, `wrinkled`."""


@dataclass(frozen=True, kw_only=True)
class FilmState:
    """Least and greatest values over the whole film, relative to its unstressed state in the undeformed tire."""

    stretch_x: dict[str, Any]
    """Least and greatest value of a field."""
    stretch_y: dict[str, Any]
    """Least and greatest value of a field."""
    tension_x_n_per_mm: dict[str, Any]
    """Least and greatest value of a field."""
    tension_y_n_per_mm: dict[str, Any]
    """Least and greatest value of a field."""
    mean_strain_1: float
    """Mean strain along: stretch relative to the inflated state minus one."""
    mean_strain_2: float
    """Mean strain across."""
    mean_tension_1_n_per_mm: float
    """Mean tension along, N/mm."""
    mean_tension_2_n_per_mm: float
    """Mean tension across, N/mm."""
    curvature_change_1_per_mm: float
    """Change of curvature along, 1/mm, positive where the surface becomes more hollow towards the cavity."""
    curvature_change_2_per_mm: float
    """Change of curvature across, 1/mm."""
    charge_nc: float
    """Charge, nC."""
    capacitance_pf: float
    """Capacitance of the film, pF."""
    open_circuit_v: float
    """Voltage where nothing draws charge, V."""
    output_v: float
    """Amplitude at the amplifier, for presses of its frequency, V."""
    output_std_v: float
    """Standard deviation of that by the amplifier's noise, the gain and the temperature, V."""
    charge_by_pressure_nc_per_kpa: float
    """Change of the charge by a rise of the cavity's pressure, nC per kPa."""
    charge_by_warming_nc_per_k: float
    """Change of the charge by warming, nC per K."""
    time_constant_s: float | None = None
    """Time in which the reading of a held press falls to 1/e, s; absent where it stays."""
    state: str
    """Whether the film bears that, and the amplifier shows it. One of `ok`, `beyond-yield`, `saturated`, `wrinkled`."""
    bare: FilmSignal | None = None
    """Signal without the film's stiffness, following the bare wall; absent where nobody asked."""
    error: FilmError | None = None
    """Estimated discretisation errors; absent where nobody asked, or there is no coarser mesh."""


@dataclass(frozen=True, kw_only=True)
class FitCost:
    """Cost of a fit."""

    candidates: int
    """Candidates that were judged, of all forces."""
    wall_s: float
    """Wall clock, s."""


@dataclass(frozen=True, kw_only=True)
class FitEstimate:
    """Estimate of what a fit takes."""

    wall_s: Forecast
    """Wall-clock time, s: by the sizes of the recordings, on another machine."""
    peak_memory_bytes: int
    """Bound of the memory, bytes."""
    threads: int
    """Threads that it has."""


@dataclass(frozen=True, kw_only=True)
class FitProgress:
    """Progress of a fit."""

    stage: str
    """Stage of the fit. One of `reading`, `start-value`, `judging`, `learning`."""
    done: int
    """Pieces of work of this stage that are done."""
    of: int
    """Pieces of work of this stage; 0 until that is known."""


@dataclass(frozen=True, kw_only=True)
class FitReportFields:
    """The report of a fit."""

    recordings: tuple[RecordingFigures, ...]
    """Recordings that were learnt from."""
    forces: tuple[ForceReportFields, ...]
    """Findings for each force."""
    promise: str
    """Promise of the intervals, a sentence."""
    notes: tuple[str, ...]
    """Notes that a reader should know before believing it, a sentence each."""
    cost: FitCost
    """Cost of the fit."""


@dataclass(frozen=True, kw_only=True)
class ForceError:
    """Error of one force by a layout's films, with an estimator that is learnt from runs of a virtual rig."""

    axis: str
    """`fx`: along the wheel, `fy`: across it, `fz`: vertical."""
    chosen: str
    """The model that is chosen by left-out runs; `mean` where none is better than the training mean. One of `mean`,
    `ridge`, `gpr`, `ann`, `blend`."""
    features: str
    """The features it reads. One of `raw`, `baseline`, `slopes`, `rolling`, `all`, `whole`."""
    useful: bool
    """Whether its error on left-out runs is at most 95 % of the training mean's."""
    splits: tuple[SplitError, ...]
    """The chosen model by random rows, by later rows, and by whole runs (cycles where there is one run)."""
    leak: float | None = None
    """Error on left-out runs over that on random rows, both as shares of the training mean's error on the same rows:
    how far a random split would have misled. Null of the training mean."""
    fresh: TrialError
    """Error on runs that nobody learnt from: films have other gains there."""
    in_contact: TrialError | None = None
    """Error there of the rows with a contact alone."""
    drift: tuple[DriftError, ...] = ()
    """Errors there where readings drift otherwise, learnt anew with each drift."""
    alike: AlikeError | None = None
    """Error on an upright wheel over flat ground at the scene's pressure, learnt anew; absent where all contacts are
    such."""
    dead: DeadFilmError | None = None
    """Error there with the one film dead whose loss costs most; None where the training mean is given, which reads
    no film."""
    askew: AskewError
    """Error there with films that lie elsewhere than those that were learnt from."""
    elsewhere: tuple[ElsewhereError, ...] = ()
    """Errors of these films on other tires."""
    worst_contact: WorstContact | None = None
    """Place on the wheel where contacts are known worst; None where too few touch."""
    floor_n: float | None = None
    """Estimate of the least root of the mean squared error that one instant's readings allow, N: the bound of Cramer
    and Rao with what is known of the gait before, for films that hold their charge."""
    reason: str | None = None
    """Reason why numbers are None."""


@dataclass(frozen=True, kw_only=True)
class ForceFindings:
    """Findings of a virtual rig."""

    table: TableReport | None = None
    """The table of responses that the rig reads; absent where there is none."""
    price: tuple[ForcePrice, ...] = ()
    """Prices of a force's error: for each force the layouts by which it is known better than by any with as many
    films or fewer."""
    assumed: tuple[str, ...] = ()
    """Assumptions on the rig that no source states, whole sentences; empty where nothing was learnt."""
    reasons: tuple[str, ...] = ()
    """Reasons why something is missing, whole sentences."""


@dataclass(frozen=True, kw_only=True)
class ForcePrice:
    """A layout that knows a force better than all that have as many films or fewer."""

    axis: str
    """`fx`: along the wheel, `fy`: across it, `fz`: vertical."""
    films: int
    """Count of the layout's films."""
    rmse_n: float
    """Root of the mean squared error on runs that nobody learnt from, N."""
    layout_rank: int
    """The layout's rank."""


@dataclass(frozen=True, kw_only=True)
class ForceReportFields:
    """Findings for a force."""

    force: str
    """Column of the force."""
    chosen: str
    """The model that estimates it; `mean` where nothing is better. One of `mean`, `ridge`, `gpr`, `ann`, `blend`."""
    chosen_features: str
    """The features it reads. One of `raw`, `baseline`, `slopes`, `rolling`, `all`, `whole`."""
    rolled_r2: float | None = None
    """R2 of the chosen model where forces are rolled against signals: what chance would do."""
    beginnings: BeginningsReport | None = None
    """Errors of the chosen model on left-out runs by where they begin; left out where no run was."""
    models: tuple[ModelReport, ...]
    """All candidates, the chosen one first, then by their error."""


@dataclass(frozen=True, kw_only=True)
class Forecast:
    """A figure with its range."""

    least: float
    """Least value."""
    expected: float
    """Likeliest value, as far as can be told."""
    most: float
    """Greatest value."""


@dataclass(frozen=True, kw_only=True)
class FormMisses:
    """Misses of a form at the check points: the witness of the method's error, and of how much of it two studies
    share."""

    nodes: tuple[int, ...]
    """Number of the node of its input's rule at each coordinate of each check point, point after point."""
    residuals: tuple[float, ...]
    """Strain minus the form's at each check point, over the standard deviation."""
    contributions: tuple[float, ...]
    """Contributions of each of them to the error of a first-order index, input after input."""
    weight: float
    """Probability of the interactions, which the residuals stand for."""
    fitted: int
    """Count of the form's numbers that were fitted to the check points."""
    images: tuple[int, ...] = ()
    """Number of each check point's mirror image, whose strains are its own from the other end; absent where contact
    or inputs aren't symmetric."""


@dataclass(frozen=True, kw_only=True)
class FrontLayout:
    """A layout that no other beats with as few films."""

    film_count: int
    """Count of its films."""
    simulated_p95_angle_error_deg: float
    """Simulated 95th percentile of the angle's error at its worst load, degrees."""
    index: int
    """Index in the list of layouts, from 0."""


@dataclass(frozen=True, kw_only=True)
class GapLook:
    """Time without a row."""

    line: int
    """Line in the file of the row before it."""
    begin_s: float
    """Time of that row, s."""
    length_s: float
    """Time to the next row, s."""


@dataclass(frozen=True, kw_only=True)
class GapsLook:
    """Intervals longer than ten typical ones."""

    count: int
    """Count of them."""
    longest: GapLook | None = None
    """The longest one; None where there is none."""
    first: tuple[GapLook, ...]
    """The first 20, in the order of time."""


@dataclass(frozen=True, kw_only=True)
class GaugeError:
    """Estimated discretisation errors, absolute: root mean square of recovered minus raw values over the faces
    around the point."""

    strain: float
    """Error of the strain since inflation."""
    stretch: float
    """Error of the stretch."""
    green_lagrange: float
    """Error of the Green-Lagrange strain."""
    von_mises_mpa: float
    """Error of the von Mises stress, MPa."""


@dataclass(frozen=True, kw_only=True)
class GaugeReading:
    """Strain of a material line."""

    theta_deg: float
    """Wheel angle from the contact centre, degrees, positive in the rolling direction."""
    phi_deg: float
    """Section angle from the crown, degrees; from bead to bead."""
    angle_deg: float
    """Angle of the material line to the circumferential direction, drawn on the undeformed tire, degrees: 0 is x, 90
    is y."""
    strain: float
    """The signal: stretch relative to the inflated state, minus one."""
    stretch: float
    """Stretch relative to the undeformed tire."""
    green_lagrange: float
    """Green-Lagrange strain relative to the undeformed tire, (stretch^2 - 1) / 2."""
    von_mises_mpa: float
    """Von Mises stress of the rubber at the point, MPa."""
    error: GaugeError | None = None
    """Estimated discretisation errors; absent when the solver has no estimate."""


@dataclass(frozen=True, kw_only=True)
class GradedNote:
    """A note with its grade."""

    grade: str
    """Effect on the answer. One of `changes-answer`, `bears-on-figure`, `for-the-record`."""
    about: str
    """Topic of the note. One of `place`, `layout`, `map`, `indices`, `signals`, `model`, `cost`."""
    text: str
    """Whole sentences."""


@dataclass(frozen=True, kw_only=True)
class Inflated:
    """The inflated tire before contact."""

    crown_stretch_x: float
    crown_stretch_y: float
    outer_radius_mm: float
    """Outer radius at the crown, mm."""


@dataclass(frozen=True, kw_only=True)
class Input:
    """An input as it was understood."""

    name: str
    """Name of the input."""
    vary: str
    """Path of the scene's field."""
    distribution: dict[str, Any]
    """Distribution as in the document."""


@dataclass(frozen=True, kw_only=True)
class InputShare:
    """Share of an input."""

    input: str
    """Name of the input."""
    index: float
    """First-order index, 0 to 1."""
    error: float | None = None
    """Claimed error of the index; None where it isn't known."""


@dataclass(frozen=True, kw_only=True)
class InputsAnswer:
    """Inputs in the order in which they matter for the strain at the contact centre."""

    sentence: str
    """The inputs that matter most, in a sentence."""
    verdict: str | None = None
    """Certainty that the first matters most. One of `certain`, `likely`, `tied`, `unknown`."""
    reason: str | None = None
    """Reason for the verdict, with the figures that decide."""
    location: str
    """Location at the contact centre."""
    direction: str
    """Direction of the strain: the one that varies more, of those asked for."""
    shares: tuple[InputShare, ...]
    """Share of each input, the greatest first."""
    beside: tuple[InputsBeside, ...] = ()
    """Inputs that matter for what else the study is about: a film's volts, the layout's error of the angle."""


@dataclass(frozen=True, kw_only=True)
class InputsBeside:
    """Inputs in the order in which they matter for another quantity than a strain, to first order in all of them."""

    quantity: str
    """Name of the quantity."""
    sentence: str
    """The inputs that matter most, in a sentence."""
    std: float
    """Standard deviation of the quantity by all of them together, in its unit."""
    unit: str
    """Unit of the quantity: `V`, `degrees`."""
    shares: tuple[InputShare, ...]
    """Share of each input, the greatest first; of a layout's error also that of `noise`."""


@dataclass(frozen=True, kw_only=True)
class Knee:
    """Knee: the number of units from which on more of them bring no more than their number."""

    section_deg: float
    """Section angle from the crown, degrees."""
    films: tuple[str, ...]
    """Directions of the films of each unit."""
    units: int | None = None
    """The number of units; None where even the most that were tried aren't enough."""
    dense_deg: float
    """Worst bound times the root of the number of units of a dense ring, degrees."""
    of_60_deg: float | None = None
    """Ratio of the worst bound times the root of the number of units every 60 degrees to that of a dense ring; None
    where they are blind."""


@dataclass(frozen=True, kw_only=True)
class Layout:
    """A layout in the ranking."""

    rank: int
    """1 is best. Layouts of equal score share the rank of the first of them."""
    rank_certain: bool | None = None
    """Whether the errors leave no doubt about its place; absent of one that wasn't ranked."""
    name: str | None = None
    """Name of a layout that was listed film by film, or found by the search; absent of a regular one."""
    spacing_deg: float | None = None
    """Angle between neighbouring units, degrees; None of a layout without units."""
    turn_deg: float | None = None
    """Angle of the first unit from the mark, degrees, where no film may lie there; absent of 0."""
    units: int
    """Number of units; of a layout without units its number of films."""
    position: str
    """Meridional position: a name, an angle such as `30 deg`, or `mixed`."""
    films: tuple[str, ...]
    """Directions of the films of each unit: `x`, `y`, or an angle such as `45`."""
    staggered: bool = False
    """Whether the films of a unit are spread evenly between two units."""
    film_count: int
    """All films of the wheel."""
    places: tuple[FilmPlace, ...] = ()
    """The films of a layout without units, one by one."""
    doubt: str | None = None
    """Figures that may be off by more than a fifth, in words."""
    score: LayoutScore
    """Scores at the load where the angle's error is largest."""
    worst_load_n: float | None = None
    """Load of these scores, N."""
    worst_force: WorstForce | None = None
    """Error of the vertical force at the load where that is largest; absent of a layout without scores."""
    contacts: tuple[ContactError, ...] = ()
    """Errors of contacts that differ in nothing and in each quantity of `layouts.contacts` alone, each at the load
    where it is largest; absent where contacts don't differ."""
    told: tuple[ToldQuantity, ...] = ()
    """Errors of what films tell of a contact beside angle and force, each at the load where it is largest; absent
    where contacts don't differ, or an estimate averages over them."""
    loads: tuple[LoadScore, ...]
    """Scores at every load."""
    error_sources: ErrorSources | None = None
    """Noise and inputs as sources of the angle's error; absent where the study has no map, and of films that the map
    doesn't show."""
    force_error: tuple[ForceError, ...] | None = None
    """Errors of the forces along, across and vertical on a virtual rig; absent where the study has none, and of
    layouts that a search found."""


@dataclass(frozen=True, kw_only=True)
class LayoutAnswer:
    """The layout that answers the question; where none is asked, the knee of the trade."""

    rank: int
    """Rank in `layouts`."""
    words: str
    """Description of the layout, as in `12 films along y at the crown, one every 30 degrees`."""
    units: int
    """Count of its units; of a layout without units of its films."""
    film_count: int
    """All its films."""
    angle_error_deg: float
    """95 of 100 simulated contacts are estimated better than this at the worst load, degrees."""
    error_deg: float | None = None
    """Claimed error of that, degrees; None where there is no coarser mesh."""
    tied_with: tuple[int, ...]
    """Ranks of layouts that the errors can't tell from it."""
    verdict: str
    """Certainty that no layout that was tried answers better with as few films; where limits are asked, that it
    meets them and fewer films don't. One of `certain`, `likely`, `tied`, `unknown`."""
    reason: str
    """Reason for the verdict, with the figures that decide; where forces along and across are unknown, too, also
    what tells them from the angle."""


@dataclass(frozen=True, kw_only=True)
class LayoutError:
    """Claimed errors of a layout's scores, each in the unit of its score."""

    worst_angle_error_deg: float | None = None
    """Error of the bound of the angle, worst angle, degrees."""
    rms_angle_error_deg: float | None = None
    """Error of the bound of the angle, root mean square, degrees."""
    worst_depth_error_mm: float | None = None
    """Error of the bound of the depth, mm."""
    simulated_rms_angle_error_deg: float | None = None
    """Error of the simulated root mean square, degrees."""
    simulated_p95_angle_error_deg: float | None = None
    """Error of the simulated 95th percentile, degrees."""
    force_error_n: float | None = None
    """Error of the force's error, N."""


@dataclass(frozen=True, kw_only=True)
class LayoutFindings:
    """Findings of a study's layouts together: loads, knees, fronts, kinds of film."""

    level: str
    """Mesh level of the fields, which is fine to 60 degrees from the contact."""
    unit: str
    """Unit of films' signals: `strain`, or `V` of glued ones. Noise, weakest signals, candidates' signals and rings
    are in it."""
    size_mm: tuple[float, ...] | None = None
    """Length and width of the layouts' films, mm; absent of points."""
    coarser_level: str | None = None
    """Coarser level that shows their errors."""
    loads: tuple[LayoutLoad, ...]
    """The loads at which layouts are scored."""
    contacts: ContactFindings | None = None
    """Contacts as they come, where the document has their laws."""
    films: FilmAnglesReport | None = None
    """Films that are glued on and solved with the tire around the wheel: how far their signals are off, and would be
    by a transfer alone."""
    assumptions: AssumptionFindings | None = None
    """Assumptions of the layout that answers, changed one at a time; absent where no layout answers."""
    menu: MenuFindings | None = None
    """Menu of layouts, where the document names none."""
    front: tuple[FrontLayout, ...]
    """Layouts that no other beats with as few films, least films first."""
    tau_of_bound: float | None = None
    """Kendall's tau between the order by simulated errors and that by the bound's worst error times the root of the
    number of films."""
    searches: tuple[LayoutSearch, ...] = ()
    """Searches, and what they looked at."""
    candidates: tuple[Candidate, ...]
    """Kinds of film, ranked by several criteria."""
    rings: tuple[StrainRing, ...]
    """Films' signals around the wheel."""
    reasons: tuple[str, ...] = ()
    """Reasons why something is missing, whole sentences."""


@dataclass(frozen=True, kw_only=True)
class LayoutLoad:
    """A load at which layouts are scored."""

    depth_mm: float | None = None
    """Height of the ground above the inflated outer radius, mm."""
    load_n: float | None = None
    """Vertical force, N."""
    force_slope_n_per_mm: float | None = None
    """Derivative of the force by the depth, N/mm."""
    shear: LoadShear | None = None
    """Shear findings by dragging the ground, where forces along and across the wheel are unknown, too."""
    knees: tuple[Knee, ...]
    """Knees: the number of units from which on each section angle and set of films is dense enough."""
    reason: str | None = None
    """Reason why there are no scores."""


@dataclass(frozen=True, kw_only=True)
class LayoutScore:
    """Scores of a layout: how well it sees the contact, over all angles at which it can touch down."""

    weakest_signal: float | None = None
    """Signal of the film that sees most, strain or volts of a glued one, at the contact angle where that is least."""
    worst_angle_error_deg: float | None = None
    """Cramer-Rao bound of the contact angle, worst angle, degrees."""
    rms_angle_error_deg: float | None = None
    """Cramer-Rao bound of the contact angle, root mean square over the angles, degrees."""
    worst_depth_error_mm: float | None = None
    """Cramer-Rao bound of a uniform depth, worst angle, mm."""
    bayes_angle_error_deg: float | None = None
    """Bound of the contact angle's error with a flat prior, root mean square over the angles, degrees: finite where
    the others aren't."""
    simulated_rms_angle_error_deg: float | None = None
    """Error of the contact angle as estimated from noisy readings, root mean square, degrees."""
    simulated_rms_angle_error_deg_se: float | None = None
    """Standard error of the root mean square by the number of simulated contacts, degrees."""
    simulated_p95_angle_error_deg: float | None = None
    """95 % of simulated contacts are estimated better than this, degrees."""
    simulated_p95_angle_error_deg_se: float | None = None
    """Standard error of the 95th percentile by the number of simulated contacts, degrees."""
    lost_share: float | None = None
    """Share of simulated contacts that are off by more than 20 degrees."""
    simulated_rms_depth_error_mm: float | None = None
    """Error of the depth as estimated, root mean square, mm."""
    force_error_n: float | None = None
    """Error of the depth as a vertical force, N: by the slope of force over depth."""
    force_error_n_se: float | None = None
    """Standard error of the force's error by the number of simulated contacts, N."""
    alike: AlikeContacts | None = None
    """The two contacts, more than 20 degrees apart, that look most alike."""
    dead: DeadFilm | None = None
    """Score with the one film dead whose loss costs most, where that was asked for."""
    contacts: tuple[ContactError, ...] = ()
    """Errors of contacts that differ in nothing (`noise`) and in each quantity of `layouts.contacts` alone; absent
    where contacts don't differ."""
    told: tuple[ToldQuantity, ...] = ()
    """Errors of what films tell of a contact beside angle and force; absent where contacts don't differ, or an
    estimate averages over them."""
    shear: ShearScore | None = None
    """Score with forces along and across the wheel unknown, too, where that was asked for."""
    noise_strain: float | None = None
    """Noise of each film assumed for the bounds, strain; None of glued films."""
    noise_v: float | None = None
    """Noise of each glued film assumed for the bounds, V; absent of bare ones."""
    error: LayoutError | None = None
    """Errors by the mesh and the number of simulated contacts; absent where there is no coarser mesh."""
    reason: str | None = None
    """Reason why numbers are None."""


@dataclass(frozen=True, kw_only=True)
class LayoutSearch:
    """Search for layouts, and what it looked at."""

    films: int
    """Films of the layouts."""
    places: int
    """Places that a film may have."""
    method: str
    """`exhaustive`, or `greedy and exchange`."""
    criterion: str
    """Criterion of the search: `bound`, or `interval errors`, which count contacts that are mistaken for others,
    too."""
    looked_at: int
    """Layouts whose criterion was computed."""
    bayes_angle_error_deg: float | None = None
    """Bound of the angle with a flat prior of the best one, root mean square over angles and loads, degrees; None
    where no layout of so many films was found that has room."""
    best: tuple[FilmPlace, ...]
    """Films of the best layout."""


@dataclass(frozen=True, kw_only=True)
class LeftOut:
    """Part that the model leaves out."""

    what: str
    """Name of the part, as in `model.left_out`."""
    why: str
    """Reason for leaving it out, as in `model.left_out`."""
    effect: float
    """Largest change of a strain at P1, P2, ... over the largest strain of its direction."""
    sentence: str
    """Sentence that says what it would do."""


@dataclass(frozen=True, kw_only=True)
class LeftOutRowsFields:
    """Rows that the chosen model of a force hadn't learnt from: truth, estimate and interval."""

    force: str
    """The force's column."""
    run: tuple[int, ...]
    """Each row's run, by its place among the recordings."""
    time_s: tuple[float, ...]
    """Each row's time, s."""
    truth_n: tuple[float, ...]
    """Measured force, N."""
    estimate_n: tuple[float, ...]
    """Estimated force, N."""
    low_n: tuple[float, ...]
    """The interval's low end, N."""
    high_n: tuple[float, ...]
    """The interval's high end, N."""


@dataclass(frozen=True, kw_only=True)
class LoadScore:
    """A layout's scores at one load."""

    depth_mm: float | None = None
    """Height of the ground above the inflated outer radius, mm."""
    load_n: float | None = None
    """Vertical force, N."""
    score: LayoutScore
    """The scores."""


@dataclass(frozen=True, kw_only=True)
class LoadShear:
    """Findings by dragging the ground a little at a load."""

    slopes_n_per_mm: tuple[float, ...]
    """Forces along the wheel and across it by the shifts that way, N/mm."""
    sliding_n: float
    """Force from which the ground slides: the coefficient of friction times the load, N."""


@dataclass(frozen=True, kw_only=True)
class LoadedReport:
    """Left-out runs that begin under a load."""

    share: float
    """Share of the run's largest force."""
    load_n: float
    """Mean load at the beginning, N."""
    rmse_n: float
    """N"""
    recorded_rmse_n: float
    """RMSE of the same rows of the runs as recorded, N."""


@dataclass(frozen=True, kw_only=True)
class Location:
    """One candidate location in the ranking."""

    name: str
    """P1, P2, ..."""
    input: str | None = None
    """The input that is this location's own: the depth of the station below it."""
    rank: int
    """1 is best. Equal locations, as mirror images are, share the rank of the first of them, and follow each other
    in the order of their names."""
    gsi_x_percent: float | None = None
    """100 times the first-order index of this location's own depth for the x strain at the centre."""
    gsi_y_percent: float | None = None
    """100 times the first-order index of this location's own depth for the y strain at the centre."""
    gsi_x_error_percent: float | None = None
    """Error of `gsi_x_percent`, percentage points."""
    gsi_y_error_percent: float | None = None
    """Error of `gsi_y_percent`, percentage points."""
    mean_gsi_x_percent: float | None = None
    """Mean over the x strains at all locations."""
    mean_gsi_y_percent: float | None = None
    """Mean over the y strains at all locations."""
    own_gsi_x_percent: float | None = None
    """For the x strain at this location itself."""
    own_gsi_y_percent: float | None = None
    """For the y strain at this location itself."""
    mdrm_gsi_x_percent: float | None = None
    """Index by M-DRM for `gsi_x_percent`, valid or not: the paper's Table 2 as the paper computed it."""
    mdrm_gsi_y_percent: float | None = None
    """Index by M-DRM for `gsi_y_percent`, valid or not: the paper's Table 2 as the paper computed it."""
    rank_x: int | None = None
    """Rank by the x strain alone, which equal locations share."""
    rank_y: int | None = None
    """Rank by the y strain alone, which equal locations share."""
    rank_certain: bool
    """Whether the errors leave no doubt about this rank, which equal locations share."""


@dataclass(frozen=True, kw_only=True)
class LocationError:
    """Estimated discretisation errors at a location, absolute: see [`crate::gauge::GaugeError`]."""

    strain_x: float
    """Error of the circumferential strain."""
    strain_y: float
    """Error of the meridional strain."""
    von_mises_mpa: float
    """Error of the von Mises stress, MPa."""


@dataclass(frozen=True, kw_only=True)
class LocationStrain:
    """Strain at a named location."""

    name: str
    """P1, P2, ..."""
    theta_deg: float
    """Angle from the contact centre, degrees, positive in the rolling direction."""
    strain_x: float
    """Circumferential strain."""
    strain_y: float
    """Meridional strain."""
    von_mises_mpa: float
    """Von Mises stress of the rubber at the inner surface, MPa."""
    error: LocationError | None = None
    """Estimated discretisation errors; absent when the solver has no estimate."""


@dataclass(frozen=True, kw_only=True)
class LoneSample:
    """A sample that stands alone."""

    line: int
    """Line in the file."""
    time_s: float
    """Time, s."""
    value: float
    """Value."""


@dataclass(frozen=True, kw_only=True)
class LoneSamples:
    """Samples that stand alone."""

    count: int
    """Count of them."""
    first: tuple[LoneSample, ...]
    """The first 20."""


@dataclass(frozen=True, kw_only=True)
class Look:
    """Look at recordings: what each column is taken for, and what stands in it."""

    recordings: tuple[RecordingLook, ...]
    """Recordings that can be read, in the order in which they were given."""
    faults: tuple[RecordingFault, ...]
    """Faults of those that can't be, as learning from them tells."""
    refusals: tuple[RecordingFault, ...]
    """Reasons for which nothing would be learnt from them, though they can be read."""


@dataclass(frozen=True, kw_only=True)
class MemberReport:
    """A model that is part of a blend."""

    model: str
    """The model. One of `mean`, `ridge`, `gpr`, `ann`, `blend`."""
    features: str
    """The features it reads. One of `raw`, `baseline`, `slopes`, `rolling`, `all`, `whole`."""


@dataclass(frozen=True, kw_only=True)
class MenuFindings:
    """Layouts that were tried, and those of the menu that aren't in the list."""

    screened: int
    """Count of those that weren't simulated: their bounds show that others with as few films are better."""
    without_room: int
    """Count of those whose films have no room."""
    sentence: str
    """Sentence that says what was tried."""


@dataclass(frozen=True, kw_only=True)
class Model:
    """Summary of a model: what was modelled and what was left out."""

    dimension: str
    """`3d`, `3d-half` or `3d-quarter`."""
    level: str
    """Mesh level."""
    elements: int
    """Number of solid elements."""
    dofs: int
    """Free displacement unknowns."""
    modelled: tuple[Choice, ...]
    """Parts of the scene in the model."""
    left_out: tuple[Choice, ...]
    """Parts of the scene left out."""


@dataclass(frozen=True, kw_only=True)
class ModelIndexError:
    """Errors of first-order indices: what they are off by at most, in all and in parts."""

    quadrature: float | None = None
    """Error of the nodes' number."""
    decomposition: float | None = None
    """Error of the form."""
    sampling: float | None = None
    """Error of the sample."""
    floor: float
    """Share of the variance that is rounding of doubles."""
    lost: float | None = None
    """Error of runs that failed."""
    rounding: float | None = None
    """Error of digits that weren't printed."""
    total: float | None = None
    """Error of the worst index, all parts together."""
    by_input: tuple[float, ...] | None = None
    """Error of each input's index."""


@dataclass(frozen=True, kw_only=True)
class ModelOutput:
    """Indices of an output, one an input."""

    name: str
    """Name of the output."""
    mean: float | None = None
    """Mean, in the output's units."""
    variance: float | None = None
    """Variance, in the output's units squared."""
    first_order: tuple[float, ...] | None = None
    """First-order index of each input: its share of the variance alone."""
    total: tuple[float, ...] | None = None
    """Total index of each input: its share with all that it interacts in."""
    second_order: tuple[float, ...] | None = None
    """Share of each pair of inputs alone, in the order 12, 13, .., 23, ..; None where the method has none."""
    status: str
    """End of the analysis: `ok`, `constant`, `product-form-broken` or `unusable`."""
    reason: str | None = None
    """Reason why a number is missing, and what else a reader should know."""
    method: str
    """Form behind the indices."""
    mdrm_first_order: tuple[float, ...] | None = None
    """First-order indices of the product form where it is broken."""
    mdrm_total: tuple[float, ...] | None = None
    """Total indices of the product form where it is broken."""
    error: ModelIndexError
    """Errors of the first-order indices."""


@dataclass(frozen=True, kw_only=True)
class ModelPoints:
    """Points of a model, each a value of every input."""

    ids: tuple[int, ...]
    """Number of each point, by which its values are sent."""
    rows: tuple[tuple[float, ...], ...]
    """Values of the inputs at each point, in the inputs' units."""


@dataclass(frozen=True, kw_only=True)
class ModelReport:
    """Report of a candidate."""

    model: str
    """The model. One of `mean`, `ridge`, `gpr`, `ann`, `blend`."""
    features: str
    """The features it reads. One of `raw`, `baseline`, `slopes`, `rolling`, `all`, `whole`."""
    members: tuple[MemberReport, ...] = ()
    """The models whose median a blend is; left out of others."""
    validation: SplitReport
    """Figures on the split that chooses."""
    splits: SplitReports
    """Figures on every split; None where there is none, the reason in the notes."""
    leak_factor: float | None = None
    """RMSE on the strictest split over that on the random one: how far a random split would have misled."""
    better_than_mean: bool
    """Whether its error is at most 95 % of the training mean's on the split that chooses."""


@dataclass(frozen=True, kw_only=True)
class Output:
    """Indices of one strain."""

    location: str
    """P1, P2, ..."""
    direction: str
    """`x` circumferential, `y` meridional."""
    mean: float | None = None
    """Mean strain."""
    std: float | None = None
    """Standard deviation of the strain."""
    first_order: tuple[float, ...] | None = None
    """First-order index of each input."""
    total: tuple[float, ...] | None = None
    """Total index of each input."""
    method: str
    """Form that gave `first_order` and `total`: `mdrm`, `additive`, `shifted`, `corrected`, `bivariate`, `tensor`,
    `pce` or `saltelli`."""
    status: str
    """`ok`, `constant`, `product-form-broken` or `unusable`."""
    reason: str | None = None
    """Reason why the status isn't `ok`."""
    mdrm_first_order: tuple[float, ...] | None = None
    """Indices that M-DRM gave, when its product form is broken."""
    error: ErrorParts
    """Error of the first-order indices, absolute."""
    coarser: CoarserIndices | None = None
    """The indices on a coarser mesh, where there is one."""
    misses: FormMisses | None = None
    """Misses of the method's form at the check points, where it has any."""


@dataclass(frozen=True, kw_only=True)
class PlaceAnswer:
    """The location that ranks first."""

    names: tuple[str, ...]
    """All that share the first rank or, where the verdict is tied, can't be told from the first."""
    direction: str
    """Direction of the strain, of those asked for, whose index is larger there."""
    index: float
    """First-order index of the location's own depth for that strain at the contact centre, 0 to 1."""
    error: float | None = None
    """Claimed error of the score; None where it isn't known."""
    verdict: str
    """Certainty of the first rank, by what locations are ranked by. One of `certain`, `likely`, `tied`, `unknown`."""
    reason: str
    """Reason for the verdict, with the figures that decide."""
    sentence: str
    """The place in a sentence."""


@dataclass(frozen=True, kw_only=True)
class Preset:
    """A document to start from."""

    name: str
    """Name in `scene = { preset = ... }`."""
    title: str
    """Title of the scene."""
    document: dict[str, Any]
    """The document."""
    comment: str
    """Purpose of the scene."""


@dataclass(frozen=True, kw_only=True)
class Presets:
    """The documents that ship."""

    studies: tuple[Preset, ...]
    """Whole studies."""
    scenes: tuple[Preset, ...]
    """Scenes alone."""


@dataclass(frozen=True, kw_only=True)
class Preview:
    """A study's places and layouts on the draft mesh. It claims nothing: no error is known."""

    claim: str
    """Claim of the preview: `none`."""
    level: str
    """Mesh level: `draft`."""
    wall_s: float
    """Time from the request to the answer, s."""
    solves: int
    """Points that were solved."""
    left_out: tuple[str, ...]
    """Parts that the study would have beside, whole sentences."""
    inputs: tuple[Input, ...]
    """Inputs that varied."""
    answer: Answer | None = None
    """The answer, with the layout and its films; its verdict is unknown. Null where nothing has an index."""
    locations: tuple[Location, ...]
    """Ranked locations."""
    cut_point: CutPoint
    """The response at the means."""
    map: dict[str, Any] | None = None
    """A map of 31 x 11 places at most; None where the document asks for none."""
    notes: tuple[str, ...]
    """Notes that the user must know before believing the numbers, whole sentences."""


@dataclass(frozen=True, kw_only=True)
class Question:
    """Question that a study's layouts answer: the best with so many films, or the fewest films that keep errors
    within limits."""

    films: int | None = None
    """Most films of a layout, those that are glued on already among them."""
    angle_deg: float | None = None
    """Largest error of the contact angle that is allowed, degrees: of 95 in 100 contacts at the worst load."""
    force_n: float | None = None
    """Largest error of the vertical force that is allowed, N: root mean square at the worst load."""
    cost: float | None = None
    """Most that a layout may cost, in the currency of `film_cost` and `channel_cost`."""
    film_cost: float | None = None
    """Cost of a film that isn't glued on already."""
    channel_cost: float | None = None
    """Cost of a channel of the amplifier: every film has one."""


@dataclass(frozen=True, kw_only=True)
class Reached:
    """Loads that a failed solve got to."""

    pressure_mpa: float
    """Internal pressure of the last equilibrium, MPa."""
    depths_mm: tuple[float, ...] = ()
    """Station depths of the last equilibrium, mm."""
    load_n: float | None = None
    """Vertical force of the ground at the last equilibrium, N, where it is to press with one."""


@dataclass(frozen=True, kw_only=True)
class RecordingFault:
    """A fault of a document: where it is, and what would be right."""

    pointer: str
    """JSON pointer (RFC 6901) to the faulty value; empty for the document itself."""
    detail: str
    """Sentence that says what is wrong and what would be right."""


@dataclass(frozen=True, kw_only=True)
class RecordingFigures:
    """Figures of a recording."""

    file: str
    """File of the recording."""
    rows: int
    """Count of its rows."""
    labelled: int
    """Rows with at least one force."""
    cycles: int
    """Count of its cycles."""
    rate_hz: float | None = None
    """Rows a second, pauses apart."""
    sha256: str
    """Hash of its text."""


@dataclass(frozen=True, kw_only=True)
class RecordingLook:
    """Recording that was looked at."""

    file: str
    """Name of the file."""
    rows: int
    """Count of its rows."""
    begin_s: float
    """Time of the first row, s."""
    duration_s: float
    """Time from the first row to the last, s."""
    rate_hz: float | None = None
    """Rows a second; None of one row."""
    gaps: GapsLook
    """Intervals longer than ten typical ones."""
    cycles: int
    """Cycles, by the recipe's rule."""
    labelled: int
    """Rows with at least one force."""
    columns: tuple[ColumnLook, ...]
    """Columns in the order of the file."""
    notes: tuple[str, ...]
    """Sentences on the recording as a whole: forces that are converted, or that there are none."""
    series: RecordingSeries | None = None
    """Columns over time, for plots; left out where nobody asked for them."""


@dataclass(frozen=True, kw_only=True)
class RecordingSeries:
    """Columns of a recording over time, in bins of equal length from its first row to its last."""

    bin_s: float
    """Length of a bin, s."""
    columns: tuple[ColumnSeries, ...]
    """Columns with numbers, but for the time."""


@dataclass(frozen=True, kw_only=True)
class Refusal:
    """Reason why a node handed in nothing."""

    node: str
    """Name of the node."""
    because: str
    """A sentence."""


@dataclass(frozen=True, kw_only=True)
class ResponseError:
    """Estimated errors: absolute, of the largest reported value of each kind."""

    strain_x: float
    strain_y: float
    reaction_n: float
    """Contact penetration's share of the reaction, N."""


@dataclass(frozen=True, kw_only=True)
class RestedReport:
    """Left-out runs that are zeroed after lifting."""

    rest_s: float
    """Rest between lifting and zero, s."""
    liftings: int
    """Number of liftings that were followed by such a rest."""
    rmse_n: float
    """N"""
    recorded_rmse_n: float
    """RMSE of the same rows of the runs as recorded, N."""


@dataclass(frozen=True, kw_only=True)
class RestsOn:
    """Assumptions that the figures of the layout that answers rest on most, in words."""

    sentence: str
    """The figures as assumed, and with each of the three changes that move them most; whole sentences."""
    brief: str
    """The one that moves them most in few characters, as in `pressure: 2.31 N`, and what would answer with a change
    in this one's place; empty where none moves a figure by a tenth."""


@dataclass(frozen=True, kw_only=True)
class ResultFields:
    """The whole answer."""

    study: StudyIdentity
    """Identity of the study."""
    answer: Answer | None = None
    """The answer in a sentence, and how sure it is; absent where nothing has a rank."""
    model: Model
    """Model that was solved."""
    inputs: tuple[Input, ...]
    """Inputs that varied."""
    outputs: tuple[Output, ...]
    """Every location and direction with its indices."""
    locations: tuple[Location, ...]
    """Ranked locations."""
    layouts: tuple[Layout, ...]
    """Ranked layouts."""
    layout_findings: LayoutFindings | None = None
    """Findings of the layouts together; absent where no layouts are asked for."""
    signals: Signals | None = None
    """Films' signals over load, pressure and contact angle; absent where the study asks for none."""
    forces: ForceFindings | None = None
    """Findings of a virtual rig; absent where the study has none."""
    notes: tuple[str, ...]
    """Notes that the user must know before believing the numbers, whole sentences: the texts of `graded_notes`."""
    graded_notes: tuple[GradedNote, ...]
    """Notes with what each does to the answer."""
    failed_points: tuple[FailedPoint, ...]
    """Points that have no equilibrium, with their causes; the indices are taken from the others."""
    cut_point: CutPoint
    """The cut point's own response in short: reaction and strains at the means."""
    climb: dict[str, Any] | None = None
    """Climb to the accuracy asked for; absent where a level was asked for."""
    cost: Cost
    """Cost of the study. Not part of the result's hash."""
    estimate: Estimate | None = None
    """Estimate of the cost when the run began; not part of the result's hash either. Absent where nobody asked."""


@dataclass(frozen=True, kw_only=True)
class RingLoad:
    """A load of layouts."""

    depth_mm: float
    """Height of the ground above the inflated outer radius, mm."""
    load_n: float | None = None
    """Vertical force, N; None where it isn't known."""


@dataclass(frozen=True, kw_only=True)
class Rings:
    """Rings around the whole wheel."""

    unit: str
    """Unit of the lists named `strain` and, by the depth, `slope`: `strain`, or `V` where layouts are of glued
    films."""
    rings: tuple[WheelRing, ...]
    """A ring for each section angle that layouts have; none where the study asks for no layouts."""


@dataclass(frozen=True, kw_only=True)
class Section:
    """Strains over the section above the contact centre."""

    crown: Strains
    """0 degrees from the crown."""
    shoulder: Strains
    """45 degrees from the crown."""
    sidewall: Strains
    """90 degrees from the crown."""


@dataclass(frozen=True, kw_only=True)
class SectionNode:
    """A solved node."""

    value: float
    """Value of the input."""
    ordinal: int
    """Place among the study's points."""
    cut_point: bool
    """Whether it is the cut point, where the input is at its mean, too."""
    reaction_n: float
    """Vertical force, N."""
    strain_x: tuple[float, ...]
    """Circumferential strain, rows x columns."""
    strain_y: tuple[float, ...]
    """Meridional strain, rows x columns."""
    displacement_mm: tuple[tuple[float, ...], ...]
    """Displacements from `inflated_mm` to the node's equilibrium, mm, rows x columns: also where the input changes
    the inflated state."""


@dataclass(frozen=True, kw_only=True)
class Sections:
    """Strains and displacements over the map along the line of one input; all others are at their means."""

    input: str
    """Name of the input."""
    vary: str
    """Path of the scene's field."""
    theta_deg: tuple[float, ...]
    """Angles of the columns from the contact centre, degrees."""
    phi_deg: tuple[float, ...]
    """Angles of the rows from the crown, degrees."""
    inflated_mm: tuple[tuple[float, ...], ...]
    """Places of the map's points in the inflated state at the means, mm, rows x columns."""
    nodes: tuple[SectionNode, ...]
    """The solved nodes, by value. A design of scattered points has the means alone."""
    failed: tuple[FailedNode, ...]
    """Nodes that have no equilibrium, by value."""


@dataclass(frozen=True, kw_only=True)
class SensitivityFields:
    """Indices as far as the values tell, and the points that are still to be run."""

    inputs: tuple[str, ...]
    """Names of the inputs."""
    outputs: tuple[ModelOutput, ...]
    """Outputs with their indices; none while the method's first points lack values."""
    evaluations: int
    """Points that have values."""
    wanted: int
    """Points that are still to be run; 0 at the end."""
    points: ModelPoints
    """Points that are still to be run."""
    advice: str | None = None
    """Advice, a sentence, where the indices say little or points are missing."""


@dataclass(frozen=True, kw_only=True)
class ShearError:
    """Claimed errors of bounds with four unknowns, each in the unit of its bound."""

    worst_angle_error_deg: float | None = None
    """Error of the bound of the angle, degrees."""
    worst_force_error_n: tuple[float | None, ...] | None = None
    """Errors of the bounds of the forces, N."""


@dataclass(frozen=True, kw_only=True)
class ShearScore:
    """Cramer-Rao bounds with four unknowns: contact angle, depth, and the ground's shifts along the wheel and across
    it, about a contact that isn't dragged.

    A shift across that no film feels doesn't enter.
    """

    worst_angle_error_deg: float | None = None
    """Bound of the contact angle, worst angle, degrees."""
    worst_force_error_n: tuple[float | None, ...] | None = None
    """Bounds of the ground's forces on the tire along the wheel, across it (None where no film feels it) and up,
    worst angle, N."""
    error: ShearError | None = None
    """Errors by the mesh; absent where there is no coarser one."""
    reason: str | None = None
    """Quantity that can't be told, in words."""


@dataclass(frozen=True, kw_only=True)
class SheetFilm:
    """A film of the answer, and where it is glued on the tire that isn't inflated."""

    number: int
    """Number of the film, from 1, around the wheel from the mark."""
    theta_deg: float
    """Wheel angle from the mark in the rolling direction, degrees."""
    arc_mm: float
    """Arc on the inner surface from the mark to the film's middle, around the wheel at its section angle, mm."""
    circle_mm: float
    """Arc once around the wheel there, mm."""
    phi_deg: float
    """Section angle from the crown, degrees."""
    from_bead_mm: float
    """Arc on the inner surface from the nearer bead, where the wall ends, to the film's middle, mm."""
    from_crown_mm: float
    """Arc from the crown to the film's middle, negative on the side of negative section angles, mm."""
    direction: str
    """Direction of its length: `x`, `y`, or an angle such as `45`."""
    length_mm: float | None = None
    """Length of the film, mm; None of a point."""
    width_mm: float | None = None
    """Width of the film, mm; None of a point."""
    connector_arc_mm: float | None = None
    """Arc from the mark to its connector, which is at the end nearer to a bead, and of a film along the wheel at the
    end ahead, mm."""
    connector_from_bead_mm: float | None = None
    """Arc from the nearer bead to its connector, mm."""
    lead_mm: float | None = None
    """Length of a lead from its connector straight to the bead, and along that to the mark on the shorter way, mm."""
    expected_strain: float | None = None
    """Strain that it reads with the contact at it, at the depth below; None of glued films, and where it isn't
    known."""
    expected_v: float | None = None
    """Open circuit's voltage that a glued film reads so, V; None of bare films."""
    expected_depth_mm: float | None = None
    """Depth of that contact: the load in the middle, mm."""


@dataclass(frozen=True, kw_only=True)
class SignalCurve:
    """The open circuit's voltage of one film over loads, pressures or contact angles."""

    tire: str
    """Name of the tire."""
    film: str
    """Model of the film. One of `bare`, `transfer`, `coupled`."""
    position: str
    """Position of the film in the section."""
    direction: str
    """Direction of its length."""
    over: str
    """Quantity that changes along it. One of `load`, `pressure`, `contact`."""
    slope: float | None = None
    """Slope of the line of least squares, V per N, per MPa or per degree; None of fewer than two points."""
    monotone: str | None = None
    """Trend of the curve; None of fewer than two points. One of `up`, `down`, `no`."""
    monotone_certain: bool
    """Whether every step is larger than the errors of its two ends together."""
    linear_r2: float | None = None
    """Share of the variance that the line explains; None of fewer than three points, and where nothing varies."""


@dataclass(frozen=True, kw_only=True)
class SignalError:
    """Errors of a film's reading by the mesh, absolute: the change from the next coarser mesh, times Richardson's
    factor."""

    strain: float
    """Error of the strain."""
    charge_nc: float
    """Error of the charge, nC."""
    open_circuit_v: float
    """Error of the open circuit's voltage, V."""
    output_v: float
    """Error of the amplifier's voltage, V."""


@dataclass(frozen=True, kw_only=True)
class SignalRow:
    """Reading of one film at one pressing."""

    tire: str
    """Name of the tire; the study's own is `own`."""
    film: str
    """Model of the film. One of `bare`, `transfer`, `coupled`."""
    position: str
    """Position of the film in the section."""
    direction: str
    """Direction of its length: x circumferential, y meridional."""
    over: str
    """Curve that it is a point of. One of `load`, `pressure`, `contact`."""
    load_n: float
    """Vertical force of the ground, N."""
    pressure_mpa: float
    """Internal pressure, MPa."""
    contact_deg: float
    """Wheel angle from the film to the contact, degrees."""
    depth_mm: float | None = None
    """Height of the ground above the inflated outer radius, mm."""
    strain: float | None = None
    """Mean strain along the film since inflation."""
    tension_1_n_per_mm: float | None = None
    """Mean tension along the film since inflation, N/mm."""
    charge_nc: float | None = None
    """Charge, nC."""
    open_circuit_v: float | None = None
    """Voltage where nothing draws charge, V."""
    output_v: float | None = None
    """Amplitude at the amplifier, V."""
    output_std_v: float | None = None
    """Standard deviation of that by noise, gain and temperature, V."""
    state: str | None = None
    """Whether the film bears that, and the amplifier shows it: `ok`, `beyond-yield`, `saturated` or `wrinkled`; None
    where that isn't known."""
    error: SignalError | None = None
    """Errors by the mesh; None without a coarser mesh."""
    reason: str | None = None
    """Reason why numbers are None."""


@dataclass(frozen=True, kw_only=True)
class Signals:
    """Films' signals over load, pressure and contact angle."""

    rows: tuple[SignalRow, ...]
    """Readings of each film at each pressing."""
    curves: tuple[SignalCurve, ...]
    """The rows as curves of the open circuit's voltage."""
    pairs: tuple[FilmPair, ...]
    """Two films around the wheel, read against each other."""
    widths: tuple[StressWidth, ...]
    """Widths around the wheel over which the contact is felt."""
    claims: tuple[Claim, ...]
    """Claims about such films, and what holds of them."""


@dataclass(frozen=True, kw_only=True)
class SignalsAnswer:
    """The film that gives most, at the largest load on the study's own tire."""

    sentence: str
    """The film in a sentence, with the next."""
    verdict: str
    """Certainty that none of those read gives more. One of `certain`, `likely`, `tied`, `unknown`."""
    reason: str
    """Reason for the verdict, with the figures that decide."""
    film: str
    """Model of the film: the most detailed of those that are read. One of `bare`, `transfer`, `coupled`."""
    position: str
    """Position of the film in the section."""
    direction: str
    """Direction of its length: `x` or `y`."""
    load_n: float
    """Vertical force of the ground, N."""
    open_circuit_v: float
    """Voltage where nothing draws charge, V."""
    error_v: float | None = None
    """Claimed error of that, V; None without a coarser mesh."""


@dataclass(frozen=True, kw_only=True)
class SolveForecast:
    """Equilibria that are expected to be solved."""

    own: int
    """Points on the meshes of the answer and of the rungs before it."""
    coarser: int
    """Points solved once more on coarser meshes, for the error of the mesh."""
    effects: int
    """Solves that show what the model leaves out."""
    signals: int
    """Solves of films' signals, on both meshes."""
    layouts: int
    """Solves of layouts' loads, on both meshes."""
    tables: int
    """Solves of a rig's table of responses."""
    known: int
    """Solves among these that the database has already: they cost nothing."""
    left: CountForecast
    """Solves that are left."""


@dataclass(frozen=True, kw_only=True)
class SolvedScene:
    """Equilibrium of a scene.

    Strains are stretches relative to the inflated state minus one, on the inner surface; x circumferential, y
    meridional.
    """

    reaction_n: float
    """Force of the ground on the whole tire along the ground's normal, N."""
    force_n: tuple[float, ...] | None = None
    """Force of the ground on the whole tire, N, in the wheel's frame: along the wheel (x), along the axle (y) and in
    the wheel's plane upwards (z, the reaction of an upright wheel). Friction pulls the way that the ground is
    dragged. Absent where the solver doesn't tell."""
    moment_nmm: tuple[float, ...] | None = None
    """Moment of the ground's forces about the wheel's centre, N mm, in the wheel's frame: x, y, z as `force_n`.
    Absent where the solver doesn't tell."""
    depth_mm: float
    """Height of the ground at the contact centre, mm, along its normal from where flat ground touches the inflated
    tire."""
    locations: tuple[LocationStrain, ...]
    """P1, P2, ... in order."""
    section: Section
    """Crown, shoulder and sidewall above the contact centre."""
    inflated: Inflated
    """The inflated state before contact."""
    error: ResponseError
    """Estimated discretisation errors of the readout."""
    max_volume_change: float
    """Largest |J - 1| of an element's mean."""
    newton_iterations: int
    """Newton iterations of all load steps of this solve."""
    residual_history: tuple[tuple[float, ...], ...]
    """Residual norms relative to the forces of the problem, one list per load step."""
    model: Model
    """Model that was solved."""
    gauges: tuple[GaugeReading, ...] = ()
    """Readings, one per gauge asked for, in the order asked."""
    carcass: CarcassState | None = None
    """State of the textile layer; absent without one."""
    film: FilmState | None = None
    """State of the film; absent without one."""
    derivatives: tuple[dict[str, Any], ...] = ()
    """Derivatives by the numbers asked for, in the order asked."""
    status: str
    """Status: `converged`."""
    wall_s: float
    """Time of the solve, s."""
    unlikely: tuple[str, ...]
    """Values that are unlikely in the scene or at its film's amplifier, whole sentences."""


@dataclass(frozen=True, kw_only=True)
class SplitError:
    """The chosen model on rows that were left out by one split."""

    by: str
    """The split: `random` readings of the begin of one run, whose neighbours are learnt from; later `time`; whole
    `run`s or `cycle`s. One of `random`, `cycle`, `run`, `time`, `frequency`."""
    rmse_n: float | None = None
    """Root of the mean squared error, N."""
    rmse_interval_n: tuple[float, float] | None = None
    """95 % of the bootstrap's samples of whole cycles, N."""
    nrmse_percent: float | None = None
    """RMSE over the range of the tested forces, %."""
    mean_nrmse_percent: float | None = None
    """NRMSE of the training mean, %."""
    r2: float | None = None
    """Coefficient of determination."""
    coverage: float | None = None
    """Share of tested rows within their 95 % intervals, whose width was learnt from other groups."""
    width_n: float | None = None
    """Mean width of these intervals, N."""
    reason: str | None = None
    """Reason why numbers are None."""


@dataclass(frozen=True, kw_only=True)
class SplitReport:
    """A candidate on one split."""

    by: str
    """The split. One of `random`, `cycle`, `run`, `time`, `frequency`."""
    rmse_n: float
    """Root of the mean squared error, N."""
    sound_rmse_n: float | None = None
    """RMSE of the tested rows that aren't suspect, which chooses, N; left out where none is suspect."""
    rmse_interval_n: tuple[float, float] | None = None
    """95 % of the bootstrap's samples of whole cycles, N."""
    nrmse_percent: float | None = None
    """RMSE over the range of the tested forces, %."""
    mean_nrmse_percent: float | None = None
    """NRMSE of the training mean, %."""
    r2: float | None = None
    """Coefficient of determination."""
    coverage: float | None = None
    """Share of tested rows within their 95 % intervals, whose width was learnt from other groups."""
    width_n: float | None = None
    """Mean width of these intervals, N."""


@dataclass(frozen=True, kw_only=True)
class SplitReports:
    """A candidate on every split."""

    random: SplitReport | None = None
    """A fifth of the rows, drawn at random."""
    cycle: SplitReport | None = None
    """Cycles left out."""
    run: SplitReport | None = None
    """Runs left out."""
    time: SplitReport | None = None
    """Later rows on earlier ones."""
    frequency: SplitReport | None = None
    """Slow, middling or fast cycles left out."""


@dataclass(frozen=True, kw_only=True)
class StrainRing:
    """Signals around the wheel at one load, of one kind of film: strains, or volts of glued films."""

    section_deg: float
    """Section angle from the crown, degrees."""
    direction: str
    """Direction."""
    depth_mm: float
    """Depth of the load, mm."""
    strain: tuple[float, ...]
    """Strains from -180 to 179 degrees from the contact."""
    by_depth: tuple[float, ...]
    """Derivative by the depth, 1/mm."""
    strain_error: float | None = None
    """Largest error of the signal by the coarser mesh."""
    by_depth_error: float | None = None
    """Largest error of the derivative by the coarser mesh, 1/mm."""


@dataclass(frozen=True, kw_only=True)
class Strains:
    """Names of strains and their errors."""

    strain_x: float
    strain_y: float


@dataclass(frozen=True, kw_only=True)
class StressWidth:
    """A Gaussian in the von Mises stress of the inner surface around the wheel at the crown: offset + amplitude
    exp(-angle^2 / (2 width^2))."""

    tire: str
    """Name of the tire."""
    load_n: float
    """Vertical force of the ground, N."""
    depth_mm: float | None = None
    """Height of the ground above the inflated outer radius, mm."""
    amplitude_mpa: float | None = None
    """Amplitude, MPa."""
    width_deg: float | None = None
    """Standard deviation, degrees around the wheel."""
    offset_mpa: float | None = None
    """Stress far from the contact, MPa."""
    r2: float | None = None
    """Share of the variance within 60 degrees of the contact that the Gaussian explains."""
    reason: str | None = None
    """Reason why numbers are None."""


@dataclass(frozen=True, kw_only=True)
class StudyIdentity:
    """Identity of a study: which document, which program."""

    id: str
    """Identifier in the database."""
    name: str
    """Name from the document."""
    spec_sha256: str
    """SHA-256 of the canonical document."""
    version: str
    """Version of strainsite and its solver."""


@dataclass(frozen=True, kw_only=True)
class StudySummary:
    """A study in the queue, at work, or at its end. Times are RFC 3339, UTC."""

    id: str
    """UUID, ordered by time."""
    name: str
    """Name in lists: the document's, unless it was changed since."""
    state: str
    """State of the study. One of `queued`, `running`, `done`, `failed`, `cancelled`."""
    spec_sha256: str
    """SHA-256 of the canonical document."""
    points_total: int | None = None
    """Points of its plan, as far as that is known."""
    points_done: int
    """Points that have an outcome."""
    error: str | None = None
    """Reason why it failed, a sentence."""
    priority: int
    """Priority: studies of higher ones go first, those of the same in turns."""
    created: str
    """Time at which it was submitted."""
    started: str | None = None
    """Time at which it was first started."""
    finished: str | None = None
    """Time at which it ended."""
    archived: str | None = None
    """Time at which it was archived; None unless it is."""
    brief: str | None = None
    """The answer in few characters, as in `12 y films, 10.7 degrees`; None before there is one."""


@dataclass(frozen=True, kw_only=True)
class Surer:
    """Price of a surer answer."""

    sentence: str
    """Sentence that says what the next level would do, and how long it would take."""
    level: str
    """Mesh level to ask for."""
    times: float | None = None
    """Work over that of this study with nothing solved before, by the law of solve times; None of solvers without
    one."""
    expected_s: float | None = None
    """Expected wall-clock time with what the database has, s; None where it can't be told."""


@dataclass(frozen=True, kw_only=True)
class SweepEstimate:
    """Estimate of a sweep's cost."""

    designs: tuple[DesignEstimate, ...]
    """Each design; what an earlier one solves is known to it."""
    left: CountForecast
    """Solves left of all designs."""
    wall_s: Forecast | None = None
    """Wall-clock time of all; None where a design's own is, which says why."""
    peak_memory_bytes: int
    """Largest memory of any design, bytes."""
    database_bytes: int
    """Room that all designs take in the database, bytes."""


@dataclass(frozen=True, kw_only=True)
class SweepSummary:
    """A sweep as far as it is. Times are RFC 3339, UTC."""

    id: str
    """UUID, ordered by time."""
    name: str
    """Name in lists: as it was submitted, unless it was changed since."""
    state: str
    """`queued` before any design is begun, `running` while some aren't ended, `cancelled` when any was, `done` when
    any has a result. One of `queued`, `running`, `done`, `failed`, `cancelled`."""
    counts: DesignCounts
    """Designs by where they stand."""
    points_total: int | None = None
    """Points of all designs, once all of their plans are known."""
    points_done: int
    """Points that have an outcome."""
    priority: int
    """Priority of its studies."""
    created: str
    """Time at which it was submitted."""
    finished: str | None = None
    """Time at which its last design ended."""
    archived: str | None = None
    """Time at which it was archived; None unless it is."""
    worked_s: float
    """Time in which any of its designs was at work so far, s."""


@dataclass(frozen=True, kw_only=True)
class TableError:
    """Errors of a table over all kinds of film, wheel angles and tested solves, relative."""

    solves: int
    """Solves that it was tested by."""
    signal_rms: float
    """Root mean square of a signal's error, over the largest signal of its kind."""
    signal_worst: float
    """The largest."""
    angle_slope_rms: float
    """Root mean square of the error of a slope over the wheel angle, over the largest of its kind."""
    angle_slope_worst: float
    """The largest."""
    depth_slope_rms: float
    """Root mean square of the error of a slope over the depth, over the largest of its kind."""
    depth_slope_worst: float
    """The largest."""
    force_worst: float
    """The largest error of a force's component, over the largest load."""


@dataclass(frozen=True, kw_only=True)
class TableReport:
    """A table of a tire's responses to any contact."""

    level: str
    """Mesh level."""
    largest_load_n: float
    """The largest load, N."""
    largest_shift_mm: float
    """The largest shift of the ground at that load, along the wheel and across, mm; 0 where there is no friction."""
    solves: int
    """Solves, those that test it included."""
    error: TableError | None = None
    """Error of the table; None where a load that tests it has no equilibrium."""
    films: FilmAnglesReport | None = None
    """Wheel angles of glued films as an axis; absent for films that resist nothing."""


@dataclass(frozen=True, kw_only=True)
class TaskCounts:
    """Tasks by where they stand."""

    waiting: int
    """Tasks that wait for a machine."""
    running: int
    """Tasks that a machine does; of a command of the user's all that it hasn't handed in."""
    ended: int
    """Tasks that have ended."""


@dataclass(frozen=True, kw_only=True)
class ToldQuantity:
    """Error of what films tell of a quantity that contacts differ in."""

    of: str
    """The quantity, as `layouts.contacts` names it, or a load in the wheel's frame: `fx_n`, `fy_n`, `mx_nmm`,
    `my_nmm`, `mz_nmm`."""
    words: str
    """Name for people."""
    error: float
    """Error of its estimate, root mean square over contacts, in its own unit."""
    error_se: float | None = None
    """Standard error of it by the number of simulated contacts; none of a study before it was told, nor are the next
    two."""
    claim: float | None = None
    """Claimed error of it, by that and the coarser mesh."""
    load_n: float | None = None
    """Load at which it is this large, N: the worst one."""
    deviation: float
    """Standard deviation over contacts: the error where films tell nothing."""
    known: bool
    """Whether films tell something of it: the error is at least a tenth less than the deviation."""


@dataclass(frozen=True, kw_only=True)
class TradeAnswer:
    """Trade of films against errors: the best layout of each number of films, and which of them answers the
    question."""

    question: Question
    """Question of the document; empty where none is asked."""
    rows: tuple[TradeRow, ...]
    """Best layout of each number of films, fewest first: that with the least error of the angle, or the one that
    comes closest to the limits asked for."""
    picked: int | None = None
    """Row that answers, from 0: the question's, or the knee where none is asked; None where no layout meets the
    question."""
    knee: int | None = None
    """Knee, a row from 0: from there on twice the films don't halve the error; None where every layout loses the
    contact."""
    tried: int
    """Layouts that were tried: named in the document, found by its search, or on its menu."""
    screened: int
    """Layouts of the menu that weren't simulated, as their bounds show that others with as few films are better."""
    without_room: int
    """Layouts of the menu whose films have no room."""
    most_films: int | None = None
    """Most films that the question allows, by their number and their cost; None where it has no limit."""
    menu: str
    """Sentence that says what was tried."""


@dataclass(frozen=True, kw_only=True)
class TradeRow:
    """Best layout of a number of films."""

    film_count: int
    """Number of films."""
    rank: int
    """Rank of the layout in `layouts`."""
    index: int
    """Index of the layout in the list of layouts, from 0: mirror images share a rank."""
    words: str
    """Description of the layout, as in `12 films along y at the crown, one every 30 degrees`."""
    angle_error_deg: float
    """Simulated 95th percentile of the angle's error at its worst load, degrees."""
    angle_claim_deg: float | None = None
    """Claimed error of that, degrees; None where there is no coarser mesh."""
    force_error_n: float | None = None
    """Root mean square error of the vertical force at the load where that is largest, N."""
    force_claim_n: float | None = None
    """Claimed error of that, N; None where there is no coarser mesh."""
    cost: float | None = None
    """Cost of the films that aren't glued on already, and of a channel for each; None where the question tells no
    costs."""
    meets: bool | None = None
    """Whether it meets every limit that is asked for; None where none is."""
    is_front: bool
    """Whether fewer films do worse."""


@dataclass(frozen=True, kw_only=True)
class TrialError:
    """Estimates against true forces on runs that nobody learnt from, rows in the air among them."""

    rmse_n: float | None = None
    """Root of the mean squared error, N."""
    nrmse_percent: float | None = None
    """RMSE over the range of the true forces, %; None where these don't vary."""
    r2: float | None = None
    """Coefficient of determination; None where the true forces don't vary."""
    coverage: float | None = None
    """Share of the true forces within their 95 % intervals."""
    outside: float | None = None
    """Share of the rows that are flagged: one of their signals is beyond what was learnt from."""


@dataclass(frozen=True, kw_only=True)
class WheelRing:
    """Both directions around the wheel at one section angle."""

    section_deg: float
    """Section angle from the crown, degrees."""
    load: RingLoad | None = None
    """The load at which it is read."""
    theta_deg: tuple[float, ...]
    """Angles from the contact, degrees: from -180 on."""
    strain_x: tuple[float, ...] | None = None
    """Circumferential strain; None where no layout has such a film."""
    strain_y: tuple[float, ...] | None = None
    """Meridional strain; None where no layout has such a film."""
    slope_x_per_mm: tuple[float, ...] | None = None
    """Derivative of the circumferential strain by the depth, 1/mm."""
    slope_y_per_mm: tuple[float, ...] | None = None
    """Derivative of the meridional strain by the depth, 1/mm."""


@dataclass(frozen=True, kw_only=True)
class WorstContact:
    """Contacts about one wheel angle."""

    deg: float
    """Middle of five degrees of the wheel."""
    rmse_n: float
    """Root of the mean squared error of rows with a contact there, N."""


@dataclass(frozen=True, kw_only=True)
class WorstForce:
    """Error of the vertical force at the load where it is largest."""

    error_n: float
    """The error, root mean square over contacts, N."""
    claim_n: float | None = None
    """Claimed error of that, N; None where there is no coarser mesh."""
    load_n: float | None = None
    """The load, N."""


COLUMNS: dict[str, list[tuple[str, str, str | None]]] = {
    "indices": [
        ("location", "/output/location", None),
        ("direction", "/output/direction", None),
        ("input", "/input/name", None),
        ("first_order", "/own/first_order", None),
        ("total", "/own/total", None),
        ("error_mesh", "/output/error/mesh", None),
        ("error_quadrature", "/output/error/quadrature", None),
        ("error_decomposition", "/output/error/decomposition", None),
        ("error_total", "/output/error/total", None),
        ("mean_strain", "/output/mean", None),
        ("std_strain", "/output/std", None),
        ("method", "/output/method", None),
        ("status", "/output/status", None),
        ("mdrm_first_order", "/own/mdrm_first_order", None),
    ],
    "locations": [
        ("rank", "/location/rank", None),
        ("name", "/location/name", None),
        ("input", "/location/input", None),
        ("gsi_x_percent", "/location/gsi_x_percent", None),
        ("gsi_y_percent", "/location/gsi_y_percent", None),
        ("mean_gsi_x_percent", "/location/mean_gsi_x_percent", None),
        ("mean_gsi_y_percent", "/location/mean_gsi_y_percent", None),
        ("own_gsi_x_percent", "/location/own_gsi_x_percent", None),
        ("own_gsi_y_percent", "/location/own_gsi_y_percent", None),
        ("mdrm_gsi_x_percent", "/location/mdrm_gsi_x_percent", None),
        ("mdrm_gsi_y_percent", "/location/mdrm_gsi_y_percent", None),
        ("rank_x", "/location/rank_x", None),
        ("rank_y", "/location/rank_y", None),
        ("rank_certain", "/location/rank_certain", None),
        ("gsi_x_error_percent", "/location/gsi_x_error_percent", None),
        ("gsi_y_error_percent", "/location/gsi_y_error_percent", None),
    ],
    "layouts": [
        ("rank", "/layout/rank", None),
        ("spacing_deg", "/layout/spacing_deg", None),
        ("units", "/layout/units", None),
        ("position", "/layout/position", None),
        ("films", "/layout/films", None),
        ("weakest_signal_strain", "/layout/score/weakest_signal", "strain"),
        ("weakest_signal_v", "/layout/score/weakest_signal", "V"),
        ("worst_angle_error_deg", "/layout/score/worst_angle_error_deg", None),
        ("rms_angle_error_deg", "/layout/score/rms_angle_error_deg", None),
        ("worst_depth_error_mm", "/layout/score/worst_depth_error_mm", None),
        ("noise_strain", "/layout/score/noise_strain", None),
        ("noise_v", "/layout/score/noise_v", None),
        ("reason", "/layout/score/reason", None),
        ("rank_certain", "/layout/rank_certain", None),
        ("name", "/layout/name", None),
        ("staggered", "/layout/staggered", None),
        ("film_count", "/layout/film_count", None),
        ("bayes_angle_error_deg", "/layout/score/bayes_angle_error_deg", None),
        ("simulated_rms_angle_error_deg", "/layout/score/simulated_rms_angle_error_deg", None),
        ("simulated_p95_angle_error_deg", "/layout/score/simulated_p95_angle_error_deg", None),
        ("simulated_p95_error_deg", "/layout/score/error/simulated_p95_angle_error_deg", None),
        ("lost_share", "/layout/score/lost_share", None),
        ("simulated_rms_depth_error_mm", "/layout/score/simulated_rms_depth_error_mm", None),
        ("force_error_n", "/layout/score/force_error_n", None),
        ("alike_sigmas", "/layout/score/alike/sigmas", None),
        ("worst_angle_mesh_error_deg", "/layout/score/error/worst_angle_error_deg", None),
        ("doubt", "/layout/doubt", None),
        ("shear_angle_error_deg", "/layout/score/shear/worst_angle_error_deg", None),
        ("shear_force_x_error_n", "/layout/score/shear/worst_force_error_n/0", None),
        ("shear_force_y_error_n", "/layout/score/shear/worst_force_error_n/1", None),
        ("shear_force_z_error_n", "/layout/score/shear/worst_force_error_n/2", None),
        ("shear_reason", "/layout/score/shear/reason", None),
        ("turn_deg", "/layout/turn_deg", None),
        ("worst_load_n", "/layout/worst_load_n", None),
        ("worst_force_error_n", "/layout/worst_force/error_n", None),
        ("worst_force_load_n", "/layout/worst_force/load_n", None),
    ],
    "trade": [
        ("film_count", "/trade/film_count", None),
        ("layout", "/trade/words", None),
        ("angle_error_deg", "/trade/angle_error_deg", None),
        ("angle_claim_deg", "/trade/angle_claim_deg", None),
        ("force_error_n", "/trade/force_error_n", None),
        ("force_claim_n", "/trade/force_claim_n", None),
        ("cost", "/trade/cost", None),
        ("meets", "/trade/meets", None),
        ("is_front", "/trade/is_front", None),
        ("rank", "/trade/rank", None),
    ],
    "films": [
        ("film", "/film/number", None),
        ("theta_deg", "/film/theta_deg", None),
        ("arc_mm", "/film/arc_mm", None),
        ("phi_deg", "/film/phi_deg", None),
        ("from_bead_mm", "/film/from_bead_mm", None),
        ("from_crown_mm", "/film/from_crown_mm", None),
        ("direction", "/film/direction", None),
        ("length_mm", "/film/length_mm", None),
        ("width_mm", "/film/width_mm", None),
        ("connector_arc_mm", "/film/connector_arc_mm", None),
        ("connector_from_bead_mm", "/film/connector_from_bead_mm", None),
        ("lead_mm", "/film/lead_mm", None),
        ("expected_strain", "/film/expected_strain", None),
        ("expected_v", "/film/expected_v", None),
        ("expected_depth_mm", "/film/expected_depth_mm", None),
    ],
    "candidates": [
        ("section_deg", "/film/section_deg", None),
        ("direction", "/film/direction", None),
        ("length_mm", "/film/length_mm", None),
        ("width_mm", "/film/width_mm", None),
        ("signal", "/film/signal", "strain"),
        ("signal_v", "/film/signal", "V"),
        ("angle_information", "/film/angle_information", None),
        ("angle_information_error", "/film/angle_information_error", None),
        ("depth_information", "/film/depth_information", None),
    ],
    "signals": [
        ("tire", "/row/tire", None),
        ("film", "/row/film", None),
        ("position", "/row/position", None),
        ("direction", "/row/direction", None),
        ("over", "/row/over", None),
        ("load_n", "/row/load_n", None),
        ("pressure_mpa", "/row/pressure_mpa", None),
        ("contact_deg", "/row/contact_deg", None),
        ("depth_mm", "/row/depth_mm", None),
        ("strain", "/row/strain", None),
        ("tension_1_n_per_mm", "/row/tension_1_n_per_mm", None),
        ("charge_nc", "/row/charge_nc", None),
        ("open_circuit_v", "/row/open_circuit_v", None),
        ("output_v", "/row/output_v", None),
        ("output_std_v", "/row/output_std_v", None),
        ("state", "/row/state", None),
        ("strain_error", "/row/error/strain", None),
        ("charge_error_nc", "/row/error/charge_nc", None),
        ("open_circuit_error_v", "/row/error/open_circuit_v", None),
        ("output_error_v", "/row/error/output_v", None),
        ("reason", "/row/reason", None),
    ],
    "forces": [
        ("layout_rank", "/layout/rank", None),
        ("films", "/layout/film_count", None),
        ("force", "/force/axis", None),
        ("chosen", "/force/chosen", None),
        ("features", "/force/features", None),
        ("useful", "/force/useful", None),
        ("leak", "/force/leak", None),
        ("bound_n", "/force/floor_n", None),
        ("fresh_rmse_n", "/force/fresh/rmse_n", None),
        ("fresh_nrmse_percent", "/force/fresh/nrmse_percent", None),
        ("fresh_r2", "/force/fresh/r2", None),
        ("fresh_coverage", "/force/fresh/coverage", None),
        ("contact_rmse_n", "/force/in_contact/rmse_n", None),
        ("contact_nrmse_percent", "/force/in_contact/nrmse_percent", None),
        ("contact_r2", "/force/in_contact/r2", None),
        ("contact_coverage", "/force/in_contact/coverage", None),
        ("dead_rmse_n", "/force/dead/error/rmse_n", None),
        ("dead_nrmse_percent", "/force/dead/error/nrmse_percent", None),
        ("dead_r2", "/force/dead/error/r2", None),
        ("dead_coverage", "/force/dead/error/coverage", None),
        ("askew_rmse_n", "/force/askew/error/rmse_n", None),
        ("askew_nrmse_percent", "/force/askew/error/nrmse_percent", None),
        ("askew_r2", "/force/askew/error/r2", None),
        ("askew_coverage", "/force/askew/error/coverage", None),
        ("left_out_rmse_n", "/left_out/rmse_n", None),
        ("left_out_nrmse_percent", "/left_out/nrmse_percent", None),
        ("mean_nrmse_percent", "/left_out/mean_nrmse_percent", None),
        ("worst_contact_deg", "/force/worst_contact/deg", None),
        ("worst_contact_rmse_n", "/force/worst_contact/rmse_n", None),
        ("reason", "/force/reason", None),
    ],
    "models": [
        ("force", "/force/force", None),
        ("model", "/model/model", None),
        ("features", "/model/features", None),
        ("chosen", "/chosen", None),
        ("by", "/model/validation/by", None),
        ("rmse_n", "/model/validation/rmse_n", None),
        ("nrmse_percent", "/model/validation/nrmse_percent", None),
        ("mean_nrmse_percent", "/model/validation/mean_nrmse_percent", None),
        ("r2", "/model/validation/r2", None),
        ("coverage", "/model/validation/coverage", None),
        ("width_n", "/model/validation/width_n", None),
        ("rmse_low_n", "/model/validation/rmse_interval_n/0", None),
        ("rmse_high_n", "/model/validation/rmse_interval_n/1", None),
        ("random_rmse_n", "/model/splits/random/rmse_n", None),
        ("cycle_rmse_n", "/model/splits/cycle/rmse_n", None),
        ("run_rmse_n", "/model/splits/run/rmse_n", None),
        ("time_rmse_n", "/model/splits/time/rmse_n", None),
        ("frequency_rmse_n", "/model/splits/frequency/rmse_n", None),
        ("leak_factor", "/model/leak_factor", None),
        ("better_than_mean", "/model/better_than_mean", None),
    ],
    "compared_locations": [
        ("location", "/row/location", None),
        ("rank", "/row/rank", None),
        ("rank_certain", "/row/rank_certain", None),
        ("rank_change", "/row/rank_change", None),
        ("rank_verdict", "/row/rank_verdict", None),
        ("gsi_percent_x", "/row/x/gsi_percent", None),
        ("error_percent_x", "/row/x/error_percent", None),
        ("difference_percent_x", "/row/x/difference_percent", None),
        ("difference_error_percent_x", "/row/x/difference_error_percent", None),
        ("verdict_x", "/row/x/verdict", None),
        ("gsi_percent_y", "/row/y/gsi_percent", None),
        ("error_percent_y", "/row/y/error_percent", None),
        ("difference_percent_y", "/row/y/difference_percent", None),
        ("difference_error_percent_y", "/row/y/difference_error_percent", None),
        ("verdict_y", "/row/y/verdict", None),
        ("spec_sha256", "/study/spec_sha256", None),
        ("version", "/study/version", None),
        ("baseline", "/comparison/baseline", None),
    ],
    "designs": [
        ("state", "/study/state", None),
        ("reason", "/study/reason", None),
        ("answer_rank", "/study/answer/rank", None),
        ("layout", "/study/answer/words", None),
        ("film_count", "/study/answer/film_count", None),
        ("meets", "/study/answer/meets", None),
        ("angle_error_deg", "/study/answer/angle_deg/value", None),
        ("angle_claim_deg", "/study/answer/angle_deg/error", None),
        ("angle_difference_deg", "/study/answer/angle_deg/difference", None),
        ("angle_difference_error_deg", "/study/answer/angle_deg/difference_error", None),
        ("angle_verdict", "/study/answer/angle_deg/verdict", None),
        ("force_error_n", "/study/answer/force_n/value", None),
        ("force_claim_n", "/study/answer/force_n/error", None),
        ("force_difference_n", "/study/answer/force_n/difference", None),
        ("force_difference_error_n", "/study/answer/force_n/difference_error", None),
        ("force_verdict", "/study/answer/force_n/verdict", None),
        ("layout_verdict", "/study/answer/verdict", None),
        ("level", "/study/level", None),
        ("reaction_n", "/study/reaction_n", None),
        ("std_strain_x", "/study/std_strain_x", None),
        ("std_strain_y", "/study/std_strain_y", None),
        ("best", "/study/best", None),
        ("best_certain", "/study/best_certain", None),
        ("layout_spacing_deg", "/study/layout_spacing_deg", None),
        ("layout_position", "/study/layout_position", None),
        ("solves", "/study/cost/solves", None),
        ("coarser_solves", "/study/cost/coarser_solves", None),
        ("effect_solves", "/study/cost/effect_solves", None),
        ("reused", "/study/cost/reused", None),
        ("wall_s", "/study/cost/wall_s", None),
        ("cpu_s", "/study/cost/cpu_s", None),
        ("spec_sha256", "/study/spec_sha256", None),
        ("version", "/study/version", None),
        ("baseline", "/comparison/baseline", None),
    ],
    "rungs": [
        ("label", "/rung/label", None),
        ("level", "/rung/fidelity/level", None),
        ("method", "/rung/fidelity/method", None),
        ("nodes", "/rung/fidelity/nodes", None),
        ("check_points", "/rung/fidelity/check_points", None),
        ("wall_s", "/rung/wall_s", None),
        ("cpu_s", "/rung/cpu_s", None),
        ("solves", "/rung/solves", None),
        ("error_true", "/rung/error_true", None),
        ("error_claimed", "/rung/error_claimed", None),
        ("covered", "/rung/covered", None),
        ("ranking_agrees", "/rung/ranking_agrees", None),
        ("pareto", "/rung/pareto", None),
    ],
}
