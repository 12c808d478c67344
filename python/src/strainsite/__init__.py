"""Client of the strainsite service: where the strain films go in a smart tire, and how sure that is.

import strainsite

with strainsite.local() as client:
    result = client.submit("studies/foot-tire.toml").wait().result()
    print(result.locations_frame())
"""

from .client import Client, Preset, Presets
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
    Cost,
    CutPoint,
    ErrorParts,
    Evaluation,
    FailedPoint,
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

__all__ = [
    "AnswerError",
    "Busy",
    "Choice",
    "Client",
    "Cost",
    "CountForecast",
    "CutPoint",
    "DocumentError",
    "ErrorParts",
    "Estimate",
    "Evaluation",
    "ExpectedAccuracy",
    "FailedPoint",
    "Fault",
    "Forecast",
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
    "WaitTimeout",
    "local",
]
