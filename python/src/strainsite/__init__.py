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
from .answers.indices import CoarserIndices, ErrorParts, FormMisses, Output
from .answers.maps import StrainMap
from .answers.model import Choice, Input, Model, StudyIdentity
from .answers.points import Cost, CutPoint, Evaluation, FailedPoint, LocationStrain
from .answers.preset import Preset, Presets
from .answers.ranked import Layout, LayoutScore, Location
from .answers.result import Result
from .answers.signals import Claim, FilmPair, SignalCurve, SignalError, SignalRow, Signals, StressWidth
from .answers.summary import Design, DesignCounts, StudySummary, SweepSummary
from .client import Client
from .errors import (
    AnswerError,
    Busy,
    DocumentError,
    Fault,
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
from .local import local
from .study import Study
from .sweep import Sweep

__all__ = [
    "AnswerError",
    "Busy",
    "Choice",
    "Claim",
    "Client",
    "CoarserIndices",
    "ComparedIndex",
    "ComparedLocation",
    "ComparedStudy",
    "Comparison",
    "Cost",
    "CountForecast",
    "CutPoint",
    "Design",
    "DesignCounts",
    "DesignEstimate",
    "DocumentError",
    "ErrorParts",
    "Estimate",
    "Evaluation",
    "ExpectedAccuracy",
    "FailedPoint",
    "Fault",
    "FilmPair",
    "Forecast",
    "FormMisses",
    "Input",
    "InvalidDocument",
    "Layout",
    "LayoutScore",
    "LocalServerError",
    "Location",
    "LocationStrain",
    "MissingExtra",
    "Model",
    "NotFound",
    "Output",
    "Preset",
    "Presets",
    "ProblemError",
    "Refused",
    "Result",
    "ServerLost",
    "SignalCurve",
    "SignalError",
    "SignalRow",
    "Signals",
    "SolveForecast",
    "StrainMap",
    "StrainsiteError",
    "StressWidth",
    "Study",
    "StudyCancelled",
    "StudyFailed",
    "StudyIdentity",
    "StudySummary",
    "Sweep",
    "SweepEstimate",
    "SweepSummary",
    "WaitTimeout",
    "local",
]
