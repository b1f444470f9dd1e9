# Sealed laws of hysteresis: friction, flow that rate and amplitude share, backlash.
# Each turns displacement into a force over a typical one, all logs at once; strengths are scaled from outside.
"""Friction, rate-amplitude coupling and backlash."""
import math

import numpy as np
from scipy.signal import fftconvolve

from ..laws import Effect, each, log_uniform
from .registry import angular, law, loop_effect


@law("friction", "endochronic_singular")
def endochronic(rng, scale, name, law_name):
    """Memory that fades along the path, not in time, with a weakly singular kernel (Valanis 1980, Arch. Mech. 32)."""
    length, alpha = scale.amplitude * log_uniform(rng, 0.08, 0.4), rng.uniform(0.15, 0.5)
    step = length / 15.0
    way = (np.arange(180) + 0.5) * step / length
    kernel = way ** -alpha * np.exp(-way)
    kernel /= np.sum(kernel) * step

    def run(z, rate):
        path = np.cumsum(np.abs(np.diff(z, prepend=z[0])))
        grid = np.arange(0.0, path[-1] + step, step)
        along = np.interp(grid, path, z)
        force = fftconvolve(np.diff(along, prepend=along[0]), kernel)[:len(grid)]
        return np.interp(path, grid, force)
    return Effect(name, law_name, "parallel", each(run), 1.2 * scale.stiffness * scale.amplitude,
                  {"length": length, "alpha": alpha})


@law("friction", "coleman_hodgdon")
def coleman_hodgdon(rng, scale, name, law_name):
    """dF = (h(z) dz - F |dz|) / length, stiffer off the centre (Coleman and Hodgdon 1986, Int. J. Eng. Sci. 24)."""
    length, dip = scale.amplitude * log_uniform(rng, 0.05, 0.3), rng.uniform(0.2, 0.6)
    width = scale.amplitude * rng.uniform(0.2, 0.6)

    def run(z, dt):
        steps = np.diff(z, axis=0, prepend=z[:1])
        target = np.sign(steps) * (1.0 - dip / np.cosh(z / width) ** 2)
        decay = np.exp(-np.abs(steps) / length)
        out, force = np.empty_like(z), np.zeros(z.shape[1])
        for i in range(len(z)):
            force = target[i] + (force - target[i]) * decay[i]
            out[i] = force
        return out
    return loop_effect(name, law_name, run, scale, {"length": length, "dip": dip, "width": width})


@law("rate_amplitude_coupling", "stretched_chain_flow")
def chain_flow(rng, scale, name, law_name):
    """Flow with a power of the stress, easier the more the chains are stretched (Bergstrom and Boyce 1998, JMPS 46)."""
    w, m = angular(scale) * log_uniform(rng, 0.03, 0.4), rng.uniform(2.0, 4.5)
    s, chain = scale.amplitude * log_uniform(rng, 0.05, 0.4), rng.uniform(0.3, 1.0)

    def run(z, dt):
        steps = np.diff(z, axis=0, prepend=z[:1])
        ease = w * dt * (0.3 + np.abs(z) / scale.amplitude) ** chain
        out, force = np.empty_like(z), np.zeros(z.shape[1])
        for i in range(len(z)):
            force = (force + steps[i]) / (1.0 + ease[i] * (np.abs(force) / s) ** (m - 1.0))
            out[i] = force
        return out / scale.amplitude
    return loop_effect(name, law_name, run, scale, {"w": w, "m": m, "s": s, "chain": chain})


@law("rate_amplitude_coupling", "overstress")
def overstress(rng, scale, name, law_name):
    """Flow by a power of the stress beyond a threshold (Perzyna 1966, Adv. Appl. Mech. 9), implicit in time."""
    w, n = angular(scale) * log_uniform(rng, 0.05, 0.6), rng.uniform(1.3, 3.0)
    threshold = scale.amplitude * log_uniform(rng, 0.05, 0.2)
    s = scale.amplitude * rng.uniform(0.1, 0.3)

    def run(z, dt):
        steps = np.diff(z, axis=0, prepend=z[:1])
        out, force = np.empty_like(z), np.zeros(z.shape[1])
        for i in range(len(z)):
            force = force + steps[i]
            over = np.maximum(np.abs(force) - threshold, 0.0)
            force = np.sign(force) * (np.abs(force) - over + over / (1.0 + w * dt * (over / s) ** (n - 1.0)))
            out[i] = force
        return out / scale.amplitude
    return loop_effect(name, law_name, run, scale, {"w": w, "n": n, "threshold": threshold, "s": s})


@law("backlash", "orifice_damper_in_worn_eye")
def worn_eye(rng, scale, name, law_name):
    """A damper whose speed grows with the square of its force, in an eye worn so that contact builds up gradually."""
    gap = scale.amplitude * log_uniform(rng, 0.06, 0.3)
    w, s = angular(scale) * log_uniform(rng, 0.5, 3.0), scale.amplitude * rng.uniform(0.1, 0.4)

    def contact(u):
        return u**3 / (u**2 + gap**2)

    def run(z, dt):
        out, damper = np.empty_like(z), z[0].copy()
        parts = max(1, int(math.ceil(6.0 * w * dt)))
        steps = np.diff(z, axis=0, prepend=z[:1]) / parts
        for i in range(len(z)):
            for part in range(parts):
                u = z[i] - steps[i] * (parts - 1 - part) - damper
                force = contact(u)
                move = force * np.abs(force) / s * (w * dt / parts)
                damper = damper + np.clip(move, -0.4 * np.abs(u), 0.4 * np.abs(u))
            out[i] = contact(z[i] - damper)
        return out / scale.amplitude
    return loop_effect(name, law_name, run, scale, {"gap": gap, "w": w, "s": s})
