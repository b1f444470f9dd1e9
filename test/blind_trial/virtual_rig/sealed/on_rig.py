# Sealed laws of what the rig adds between actuator and log: compliance, contact, mass, delay, offset, drift.
# They act at the same stages as those of virtual_rig/laws.py.
"""Series compliance, contact, inertia, delay, offset, drift."""
import math

import numpy as np
from scipy.signal import lfilter

from ..laws import Effect, added_logs, contact_effect, each, filtered, unit
from .registry import angular, law, span


@law("series_compliance", "rough_faces")
def rough_faces(rng, scale, name, law_name):
    """Rough faces close with the power 2/3 of the force, on top of a linear bracket (after Hertz)."""
    e, soft = rng.uniform(0.15, 0.4), rng.uniform(0.05, 0.2)
    top = scale.stiffness * scale.amplitude

    def bend(f, s):
        return s * f / scale.stiffness * (1.0 - e + e * ((f / top) ** 2 + soft**2) ** (-1.0 / 6.0))
    return Effect(name, law_name, "mount", bend, 0.45, {"e": e, "soft": soft})


@law("series_compliance", "opening_flange")
def opening_flange(rng, scale, name, law_name):
    """A bolted flange that opens beyond its preload in one direction, and is softer there (VDI 2230)."""
    e, preload, side = rng.uniform(0.3, 0.8), rng.uniform(0.2, 0.6), rng.choice([-1.0, 1.0])
    top = scale.stiffness * scale.amplitude

    def bend(f, s):
        x = side * f / top - preload
        opened = 0.05 * np.logaddexp(0.0, np.clip(x / 0.05, -60.0, None))
        return s * (f / scale.stiffness + side * e * scale.amplitude * opened)
    return Effect(name, law_name, "mount", bend, 0.45, {"e": e, "preload": preload, "side": side})


@law("lift_off", "peeled_lip")
def peeled_lip(rng, scale, name, law_name):
    """A tacky lip peels: it lets go over a short way, along a parabola, and then of all."""
    way = scale.amplitude * rng.uniform(0.01, 0.06)

    def opening(x, w):
        return np.maximum(x, 0.0) + np.maximum(w - np.abs(x), 0.0) ** 2 / (4.0 * w)
    return contact_effect(name, law_name, scale, opening, way, {"way": way})


@law("inertia", "lever")
def lever(rng, scale, name, law_name):
    """A lever whose reduced mass depends on its angle: m(z) z'' + m'(z) z'^2 / 2 (Lagrange)."""
    e = rng.uniform(0.02, 0.12) * rng.choice([-1.0, 1.0])

    def run(z, rate):
        speed = np.gradient(z) * rate
        return (1.0 + e * z / scale.amplitude) * np.gradient(speed) * rate + 0.5 * e / scale.amplitude * speed**2
    return Effect(name, law_name, "added", each(run), scale.stiffness / (0.6 * angular(scale)) ** 2, {"e": e})


@law("time_delay", "all_pass")
def all_pass(rng, scale, name, law_name):
    """A phase equaliser in the force channel: (1 - s T / 2) / (1 + s T / 2)."""
    def run(force, rate, s):
        return filtered(force, rate, [-0.5 * s, 1.0], [0.5 * s, 1.0])
    return Effect(name, law_name, "transducer", run, 1.0 / angular(scale), {})


@law("time_delay", "integrating_converter")
def integrating_converter(rng, scale, name, law_name):
    """A converter that gives the mean over its window, so half of that late; the strength is the delay."""
    def run(force, rate, s):
        out = []
        for x in force:
            past = np.concatenate([[0.0], np.cumsum(0.5 * (x[1:] + x[:-1]))])
            n = np.arange(len(x), dtype=float)
            window = max(2.0 * s * rate, 1e-6)
            early = np.where(n < window, past[0] + (n - window) * x[0], np.interp(n - window, n, past))
            out.append((past - early) / window)
        return out
    return Effect(name, law_name, "transducer", run, 0.8 / angular(scale), {})


@law("force_offset", "settling_amplifier")
def settling_amplifier(rng, scale, name, law_name):
    """A zero that is off in all logs, the last few per cent of it only once the amplifier has settled."""
    sign, late = rng.choice([-1.0, 1.0]), rng.uniform(0.02, 0.08)
    tau = span(scale) * rng.uniform(0.05, 0.2)
    return added_logs(rng, name, law_name, lambda n: sign * (1.0 - late * np.exp(-np.arange(n) / scale.rate / tau)),
                      scale, {"sign": sign, "late": late, "tau": tau})


@law("force_drift", "room_swing")
def room_swing(rng, scale, name, law_name):
    """The hall's heating swings slowly, and the bridge with it: a part of a sine in each log."""
    period = span(scale) * rng.uniform(1.3, 3.0)

    def maker(n):
        phase = rng.uniform(0.0, 2.0 * np.pi)
        return np.sin(2.0 * np.pi * np.arange(n) / scale.rate / period + phase) - math.sin(phase)
    return added_logs(rng, name, law_name, maker, scale, {"period": period})


@law("force_drift", "creeping_bridge")
def creeping_bridge(rng, scale, name, law_name):
    """A strain gauge's glue gives way now and then, by the root of the time since."""
    count = int(rng.integers(1, 4))

    def maker(n):
        t, out = np.arange(n) / scale.rate, np.zeros(n)
        for start in rng.uniform(0.0, 0.6, count) * n / scale.rate:
            out += rng.choice([-1.0, 1.0]) * rng.uniform(0.5, 1.0) * np.sqrt(np.maximum(t - start, 0.0))
        return unit(lfilter([0.01], [1.0, -0.99], out))
    return added_logs(rng, name, law_name, maker, scale, {"count": count})


@law("sensor_gain", "two_ranges")
def two_ranges(rng, scale, name, law_name):
    """The amplifier's ranges do not agree: the logs in the upper one read too much, or too little.

    Only a difference between logs shows: a gain common to all is a stiffness.
    """
    upper = rng.permutation(len(scale.lengths)) % 2
    sign = rng.choice([-1.0, 1.0])

    def run(force, rate, s):
        return [x * (1.0 + sign * s * high) for x, high in zip(force, upper)]
    return Effect(name, law_name, "transducer", run, 0.6, {"upper": upper.tolist(), "sign": sign})
