# Sealed laws of what is in no list of effects: some follow from the motion, some do not.
# A diagnosis is to name none of them but the inertia track, which entered the list after it was written.
"""What rigs invent."""
import math

import numpy as np
from scipy.signal import fftconvolve

from ..laws import Effect, added_logs, each, log_uniform
from .registry import angular, law, over_logs, span


@law("fluid_inertia", "inertia_track_with_orifice")
def inertia_track(rng, scale, name, law_name):
    """A fluid column between chambers: q'' + 2 d w q' + e |q'| q' + w^2 q = w^2 z; the force is that of z - q."""
    w, d = angular(scale) * rng.uniform(0.25, 0.7), rng.uniform(0.02, 0.06)
    e = rng.uniform(0.05, 0.3) / scale.amplitude

    def run(z, dt):
        parts = max(1, int(math.ceil(8.0 * w * dt)))
        h = dt / parts
        out, q, v = np.empty_like(z), z[0].copy(), np.zeros(z.shape[1])
        steps = np.diff(z, axis=0, prepend=z[:1]) / parts
        for i in range(len(z)):
            for part in range(parts):
                drive = z[i] - steps[i] * (parts - 1 - part)
                v = (v + h * w * w * (drive - q)) / (1.0 + h * (2.0 * d * w + e * np.abs(v)))
                q = q + h * v
            out[i] = z[i] - q
        return out
    return Effect(name, law_name, "added", over_logs(scale, run), 2.0 * scale.stiffness, {"w": w, "d": d, "e": e})


@law("unknown:load_cell_saturation", "slow_recovery")
def slow_recovery(rng, scale, name, law_name):
    """Beyond its range the amplifier charges up, and what it has taken in leaks away slowly."""
    tau = 1.0 / angular(scale) * log_uniform(rng, 10.0, 60.0)

    def run(force, rate, s):
        top = max(8.0 * scale.force * (1.0 - s), 0.02 * scale.force)
        kernel = np.exp(-np.arange(int(8.0 * tau * rate)) / rate / tau) / rate / tau
        out = []
        for x in force:
            over = np.sign(x) * np.maximum(np.abs(x) - top, 0.0)
            out.append(x - 0.5 * over - 4.0 * fftconvolve(over, kernel)[:len(x)])
        return out
    return Effect(name, law_name, "transducer", run, 1.0, {"tau": tau})


@law("unknown:mains_hum", "rectifier_comb")
def rectifier_comb(rng, scale, name, law_name):
    """Pulses of a six-pulse rectifier on the railway's or the public mains, whichever the log can hold."""
    f = 50.0 if scale.rate > 1200.0 else 16.7
    f *= rng.normal(1.0, 2e-4)
    sharp = rng.uniform(2.0, 5.0)

    def maker(n):
        phase = 2.0 * np.pi * f * np.arange(n) / scale.rate + rng.uniform(0.0, 6.28)
        pulses = np.exp(sharp * (np.cos(phase) - 1.0)) - np.exp(-sharp * (np.cos(phase) + 1.0))
        return pulses / np.std(pulses)
    return added_logs(rng, name, law_name, maker, scale, {"frequency": f, "sharp": sharp}, 0.8)


@law("unknown:pump_ripple", "wandering_speed")
def pump_ripple(rng, scale, name, law_name):
    """Pulsation of the hydraulic supply, whose speed follows the load on the net."""
    f = scale.top_frequency * rng.uniform(0.5, 2.0)

    def maker(n):
        few = np.cumsum(rng.standard_normal(60))
        speed = 1.0 + 0.05 * np.interp(np.linspace(0.0, 59.0, n), np.arange(60), few) / max(np.std(few), 1e-9)
        phase = 2.0 * np.pi * np.cumsum(f * speed) / scale.rate
        return np.sin(phase) + 0.4 * np.sin(2.0 * phase + 1.0)
    return added_logs(rng, name, law_name, maker, scale, {"frequency": f}, 0.8)


@law("unknown:stick_slip", "squeal_along_the_path")
def squeal(rng, scale, name, law_name):
    """A seal slips each time it has been dragged for a while, and rings."""
    f, decay = scale.top_frequency * rng.uniform(1.5, 3.0), rng.uniform(2.0, 6.0)
    length, seed = scale.amplitude * log_uniform(rng, 0.3, 1.5), int(rng.integers(2**31))

    def run(z, rate):
        draw = np.random.default_rng(seed)
        path = np.cumsum(np.abs(np.diff(z, prepend=z[0])))
        at = np.cumsum(length * draw.uniform(0.5, 1.5, 2 + int(2.0 * path[-1] / length)))
        at = np.searchsorted(path, at[at < path[-1]])
        impulses = np.zeros_like(z)
        impulses[at] = np.sign(np.gradient(z)[at]) * draw.uniform(0.5, 1.5, len(at))
        t = np.arange(int(6.0 * decay / f * rate)) / rate
        return fftconvolve(impulses, np.exp(-t * f / decay) * np.sin(2.0 * np.pi * f * t))[:len(z)]
    return Effect(name, law_name, "added", each(run), 2.0 * scale.force, {"frequency": f, "length": length})


@law("unknown:cross_talk", "stiffened_by_another_axis")
def stiffened(rng, scale, name, law_name):
    """Another axis moves by a programme of its own, and this one is the stiffer the further that one is out."""
    f, seed = scale.top_frequency * rng.uniform(0.03, 0.3), int(rng.integers(2**31))
    squares = []
    for n in scale.lengths:
        few = max(8, int(2.0 * f * n / scale.rate))
        other = np.random.default_rng([seed, len(squares)]).standard_normal(few)
        squares.append(np.interp(np.linspace(0.0, few - 1.0, n), np.arange(few), other) ** 2)

    def run(z, rate):
        skip = int(round(scale.rate / rate))
        return [x * y[::skip][:len(x)] for x, y in zip(z, squares)]
    return Effect(name, law_name, "added", run, 0.6 * scale.stiffness, {"frequency": f})


@law("unknown:floor_vibration", "passing_trains")
def floor_vibration(rng, scale, name, law_name):
    """Trains pass the building: bursts of narrow noise that nothing in the log announces."""
    f, bursts = scale.top_frequency * rng.uniform(0.2, 1.2), int(rng.integers(1, 5))

    def maker(n):
        g, t = np.fft.rfftfreq(n, 1.0 / scale.rate), np.arange(n) / scale.rate
        band = np.exp(-0.5 * ((g - f) / (0.15 * f)) ** 2) * np.exp(2j * np.pi * rng.random(len(g)))
        noise, window = np.fft.irfft(band, n), np.zeros(n)
        for centre in rng.uniform(0.1, 0.9, bursts) * t[-1]:
            window += np.exp(-0.5 * ((t - centre) / (0.04 * span(scale))) ** 2)
        return noise / np.std(noise) * window
    return added_logs(rng, name, law_name, maker, scale, {"frequency": f, "bursts": bursts}, 1.5)


@law("unknown:standing_wave", "echo")
def echo(rng, scale, name, law_name):
    """Waves run up and down in a long block and come back weaker: what it adds at its resonances."""
    late, loss = rng.uniform(0.25, 0.6) / scale.top_frequency, rng.uniform(0.5, 0.8)

    def run(z, rate):
        n, out = np.arange(len(z), dtype=float), np.zeros_like(z)
        for i in range(1, 12):
            out += (-loss) ** i * (np.interp(n - i * late * rate, n, z, left=z[0]) - z)
        return out
    return Effect(name, law_name, "added", each(run), 2.0 * scale.stiffness, {"late": late, "loss": loss})
