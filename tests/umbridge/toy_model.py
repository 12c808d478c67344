"""Ishigami's function and a sum, served by PyPI's umbridge on this machine alone.

Usage: toy_model.py PORT FILE   each point that is run becomes a line of the file
"""

import functools
import math
import sys
import time

import umbridge
from aiohttp import web


def values(x):
    """Both outputs at a point."""
    return [math.sin(x[0]) * (1 + 0.1 * x[2] ** 4) + 7 * math.sin(x[1]) ** 2, 3.0 + x[0]]


class Toy(umbridge.Model):
    """A model that takes its time, and fails, if it is asked to."""

    def __init__(self, ran):
        super().__init__("toy")
        self.ran = ran

    def get_input_sizes(self, config):
        return [1, 2]

    def get_output_sizes(self, config):
        return [1, 1]

    def supports_evaluate(self):
        return True

    def __call__(self, parameters, config):
        x = parameters[0] + parameters[1]
        with open(self.ran, "a") as ran:
            ran.write(f"{x!r}\n")
        time.sleep(config.get("seconds", 0))
        if x[0] > config.get("raises_beyond", math.inf):
            raise RuntimeError("diverged")
        found = [[value] for value in values(x)]
        if x[0] < config.get("nan_below", -math.inf):
            found[0] = [math.nan]
        return found


if __name__ == "__main__":
    # The package would listen on every interface.
    web.run_app = functools.partial(web.run_app, host="127.0.0.1", print=None)
    umbridge.serve_models([Toy(sys.argv[2])], int(sys.argv[1]), max_workers=100)
