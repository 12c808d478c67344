"""Client of the strainsite service: where the strain films go in a smart tire, and how sure that is.

import strainsite

with strainsite.local() as client:
    result = client.submit("studies/foot-tire.toml").wait().result()
    print(result.locations_frame())
"""

from typing import TYPE_CHECKING

from . import recordings as recordings
from .answers._generated import *  # noqa: F403 - all that answers consist of
from .answers.comparison import Comparison as Comparison
from .answers.maps import StrainMap as StrainMap
from .answers.result import Result as Result
from .answers.skins import Surface as Surface
from .client import Client as Client
from .errors import AnswerError as AnswerError
from .errors import BagError as BagError
from .errors import Busy as Busy
from .errors import DocumentError as DocumentError
from .errors import Fault as Fault
from .errors import FitFailed as FitFailed
from .errors import InvalidDocument as InvalidDocument
from .errors import LocalServerError as LocalServerError
from .errors import MissingExtra as MissingExtra
from .errors import NotFound as NotFound
from .errors import ProblemError as ProblemError
from .errors import Refused as Refused
from .errors import ServerLost as ServerLost
from .errors import StrainsiteError as StrainsiteError
from .errors import StudyCancelled as StudyCancelled
from .errors import StudyFailed as StudyFailed
from .errors import WaitTimeout as WaitTimeout
from .forces.estimator import Estimator as Estimator
from .forces.left_out import LeftOutRows as LeftOutRows
from .forces.report import FitReport as FitReport
from .forces.report import ForceReport as ForceReport
from .local import local as local
from .own.analyse import analyse as analyse
from .own.sensitivity import Sensitivity as Sensitivity
from .recordings.recording import Recording as Recording
from .recordings.stamps import TopicTimes as TopicTimes
from .study import Study as Study
from .sweep import Sweep as Sweep

if not TYPE_CHECKING:
    # All classes and functions above. Type checkers would read a list of names alone; without one all imports above
    # are public to them.
    __all__ = [
        name for name, thing in sorted(globals().items()) if getattr(thing, "__module__", "").startswith(__name__)
    ]
