"""Recordings of other programs as the CSV files that `strainsite force` reads."""

from .bag_reader import from_bag as from_bag
from .recording import Recording as Recording
from .stamps import TopicTimes as TopicTimes
