"""Client of the strainsite service: where the strain films go in a smart tire, and how sure that is.

import strainsite

with strainsite.local() as client:
    result = client.submit("studies/foot-tire.toml").wait().result()
    print(result.locations_frame())
"""

from .answers.compared import ComparedIndex, ComparedLocation, ComparedStudy
from .answers.comparison import Comparison
from .answers.estimate import (
    CountForecast,
    DesignEstimate,
    Estimate,
    ExpectedAccuracy,
    Forecast,
    SolveForecast,
    SweepEstimate,
)
from .answers.findings import (
    Candidate,
    Candidates,
    FrontLayout,
    Knee,
    LayoutFindings,
    LayoutLoad,
    LayoutSearch,
    OrderAgreement,
    StrainRing,
)
from .answers.indices import CoarserIndices, ErrorParts, FormMisses, Output
from .answers.maps import StrainMap
from .answers.model import Choice, Input, Model, StudyIdentity
from .answers.points import Cost, CutPoint, Evaluation, FailedPoint, LocationStrain
from .answers.ranked import (
    AlikeContacts,
    DeadFilm,
    FilmPlace,
    Layout,
    LayoutError,
    LayoutScore,
    LoadScore,
    Location,
)
from .answers.result import Answer, GradedNote, LayoutAnswer, LeftOut, PlaceAnswer, Preview, Result, Surer
from .answers.signals import Claim, FilmPair, SignalCurve, SignalError, SignalRow, Signals, StressWidth
from .answers.summary import Design, DesignCounts, Preset, Presets, StudySummary, SweepSummary
from .client import Client
from .errors import (
    AnswerError,
    Busy,
    DocumentError,
    Fault,
    FitFailed,
    InvalidDocument,
    LocalServerError,
    MissingExtra,
    NotFound,
    ProblemError,
    Refused,
    ServerLost,
    StrainsiteError,
    StudyCancelled,
    StudyFailed,
    WaitTimeout,
)
from .fields.sections import FailedNode, RingLoad, Rings, SectionNode, Sections, WheelRing
from .fields.surface import Surface
from .forces.estimator import Estimator, EstimatorSummary, FitProgress
from .forces.known import (
    AskewError,
    DeadFilmError,
    ElsewhereError,
    FilmAnglesReport,
    ForceError,
    ForceFindings,
    ForcePrice,
    SplitError,
    TableError,
    TableReport,
    WorstContact,
)
from .forces.left_out import LeftOutRows
from .forces.published import (
    Contradiction,
    PrintedFigures,
    PublishedRow,
    PublishedTables,
    RigFigures,
    TimeConstantRow,
)
from .forces.report import FitCost, FitReport, ForceReport, ModelReport, RecordingFigures, SplitReport, SplitReports
from .forces.trial import TrialError
from .local import local
from .study import Study
from .sweep import Sweep

__all__ = [
    "AlikeContacts",
    "Answer",
    "AnswerError",
    "AskewError",
    "Busy",
    "Candidate",
    "Candidates",
    "Choice",
    "Claim",
    "Client",
    "CoarserIndices",
    "ComparedIndex",
    "ComparedLocation",
    "ComparedStudy",
    "Comparison",
    "Contradiction",
    "Cost",
    "CountForecast",
    "CutPoint",
    "DeadFilm",
    "DeadFilmError",
    "Design",
    "DesignCounts",
    "DesignEstimate",
    "DocumentError",
    "ElsewhereError",
    "ErrorParts",
    "Estimate",
    "Estimator",
    "EstimatorSummary",
    "Evaluation",
    "ExpectedAccuracy",
    "FailedNode",
    "FailedPoint",
    "Fault",
    "FilmAnglesReport",
    "FilmPair",
    "FilmPlace",
    "FitCost",
    "FitFailed",
    "FitProgress",
    "FitReport",
    "ForceError",
    "ForceFindings",
    "ForcePrice",
    "ForceReport",
    "Forecast",
    "FormMisses",
    "FrontLayout",
    "GradedNote",
    "Input",
    "InvalidDocument",
    "Knee",
    "Layout",
    "LayoutAnswer",
    "LayoutError",
    "LayoutFindings",
    "LayoutLoad",
    "LayoutScore",
    "LayoutSearch",
    "LeftOut",
    "LeftOutRows",
    "LoadScore",
    "LocalServerError",
    "Location",
    "LocationStrain",
    "MissingExtra",
    "Model",
    "ModelReport",
    "NotFound",
    "OrderAgreement",
    "Output",
    "PlaceAnswer",
    "Preset",
    "Presets",
    "Preview",
    "PrintedFigures",
    "ProblemError",
    "PublishedRow",
    "PublishedTables",
    "RecordingFigures",
    "Refused",
    "Result",
    "RigFigures",
    "RingLoad",
    "Rings",
    "SectionNode",
    "Sections",
    "ServerLost",
    "SignalCurve",
    "SignalError",
    "SignalRow",
    "Signals",
    "SolveForecast",
    "SplitError",
    "SplitReport",
    "SplitReports",
    "StrainMap",
    "StrainRing",
    "StrainsiteError",
    "StressWidth",
    "Study",
    "StudyCancelled",
    "StudyFailed",
    "StudyIdentity",
    "StudySummary",
    "Surer",
    "Surface",
    "Sweep",
    "SweepEstimate",
    "SweepSummary",
    "TableError",
    "TableReport",
    "TimeConstantRow",
    "TrialError",
    "WaitTimeout",
    "WheelRing",
    "WorstContact",
    "local",
]
