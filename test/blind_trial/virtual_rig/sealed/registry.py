# The list of the sealed laws, and how a law that steps through time runs over all logs at once.
# Lengths of time are measured by the logs and the actuator, never in absolute seconds: rigs may be fast or slow.
"""Registry of the sealed laws."""
import functools

import numpy as np

from .. import laws

LAWS = {}
law = functools.partial(laws.law, registry=LAWS)


def span(scale):
    """Duration of the longest log [s]."""
    return max(scale.lengths) / scale.rate


def angular(scale):
    """Highest angular frequency of the actuator [rad/s]."""
    return 2.0 * np.pi * scale.top_frequency


def over_logs(scale, function):
    """A parallel law: `function(z, dt)` takes all logs as the columns of a table, at half the rate of the fine grid."""
    def run(z, rate):
        skip = max(1, int(round(2.0 * rate / scale.rate)))
        coarse = [x[::skip] for x in z]
        longest = max(len(x) for x in coarse)
        table = np.stack([np.pad(x, (0, longest - len(x)), mode="edge") for x in coarse], axis=1)
        force = function(table, skip / rate)
        return [np.interp(np.arange(len(x)), np.arange(0, len(x), skip), force[:len(c), i])
                for i, (x, c) in enumerate(zip(z, coarse))]
    return run


def loop_effect(name, law_name, function, scale, parameters):
    """A law over all logs whose force is about 1 where it is largest."""
    return laws.Effect(name, law_name, "parallel", over_logs(scale, function), 1.2 * scale.stiffness * scale.amplitude,
                       parameters)
