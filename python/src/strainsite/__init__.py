"""Client of the strainsite service: where the strain films go in a smart tire, and how sure that is.

import strainsite

with strainsite.local() as client:
    result = client.submit("studies/foot-tire.toml").wait().result()
    print(result.locations_frame())
"""

from .client import Client, Preset, Presets
from .comparison import ComparedIndex, ComparedLocation, ComparedStudy, Comparison
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
from .estimate import CountForecast, Estimate, ExpectedAccuracy, Forecast, SolveForecast
from .local import local
from .maps import StrainMap
from .result import (
    Choice,
    CoarserIndices,
    Cost,
    CutPoint,
    ErrorParts,
    Evaluation,
    FailedPoint,
    FormMisses,
    Input,
    Layout,
    LayoutScore,
    Location,
    LocationStrain,
    Model,
    Output,
    Result,
    StudyIdentity,
)
from .study import Study, StudySummary
from .sweep import Design, DesignCounts, DesignEstimate, Sweep, SweepEstimate, SweepSummary

__all__ = [
    "AnswerError",
    "Busy",
    "Choice",
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
    "SolveForecast",
    "StrainMap",
    "StrainsiteError",
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
