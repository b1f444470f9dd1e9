# Sealed laws of memory in time: relaxation, creep, damping, softening by past motion, heating.
# Times are drawn by the actuator's frequencies and by the length of the logs, so that a log can show them.
"""Relaxation, creep, damping, softening and heating."""
import math

import numpy as np
from scipy.signal import lfilter
from scipy.special import exp1

from ..laws import Effect, damping_effect, each, factor_effect, kernel_effect, log_uniform
from .registry import angular, law, span


@law("relaxation", "havriliak_negami")
def havriliak_negami(rng, scale, name, law_name):
    """1 - 1 / (1 + (i w tau)^a)^b in the frequency domain (Havriliak and Negami 1967, Polymer 8)."""
    tau, a, b = log_uniform(rng, 0.3, 20.0) / angular(scale), rng.uniform(0.45, 0.85), rng.uniform(0.4, 0.9)

    def run(z, rate):
        n = 4 * len(z)
        w = 2j * np.pi * np.fft.rfftfreq(n, 1.0 / rate)
        response = 1.0 - (1.0 + (w * tau) ** a) ** -b
        # Held at its end and led back slowly, so that the period of the transform does not show.
        tail = np.interp(np.arange(n - len(z)), [0, len(z), n - 2 * len(z), n - len(z)], [z[-1], z[-1], z[0], z[0]])
        return np.fft.irfft(np.fft.rfft(np.concatenate([z, tail]) - z[0]) * response, n)[:len(z)]
    return Effect(name, law_name, "parallel", each(run), 1.5 * scale.stiffness, {"tau": tau, "a": a, "b": b})


@law("relaxation", "box_spectrum")
def box_spectrum(rng, scale, name, law_name):
    """All relaxation times between two alike (Fung 1972, quasi-linear viscoelasticity): E1(t / high) - E1(t / low)."""
    low = log_uniform(rng, 0.1, 2.0) / angular(scale)
    high = low * log_uniform(rng, 5.0, 100.0)
    return kernel_effect(name, law_name, lambda t, rate: (exp1(t / high) - exp1(t / low)) / math.log(high / low),
                         1.5 * scale.stiffness, {"low": low, "high": high})


@law("creep", "consolidation")
def consolidation(rng, scale, name, law_name):
    """What diffuses out of a layer stops carrying load (Terzaghi 1923): sum over odd n of exp(-n^2 t / tau) / n^2."""
    tau = span(scale) * rng.uniform(0.3, 1.5)
    n = np.arange(1, 60, 2)

    def kernel(t, rate):
        few = np.geomspace(t[0], t[-1], 400)
        share = 8.0 / np.pi**2 * np.sum(np.exp(-np.outer(few, n**2) / tau) / n**2, axis=1)
        return np.interp(t, few, share) - 1.0
    return kernel_effect(name, law_name, kernel, 0.7 * scale.stiffness, {"tau": tau})


@law("creep", "ross")
def ross(rng, scale, name, law_name):
    """-t / (t + tau), the hyperbola of Ross 1937 (creep of concrete)."""
    tau = span(scale) * rng.uniform(0.1, 0.6)
    return kernel_effect(name, law_name, lambda t, rate: -t / (t + tau), 0.5 * scale.stiffness, {"tau": tau})


@law("viscous_damping", "carreau")
def carreau(rng, scale, name, law_name):
    """v (1 + (q v)^2)^((n - 1) / 2) (Carreau 1972, Trans. Soc. Rheology 16)."""
    q, n = rng.uniform(0.2, 1.0), rng.uniform(0.55, 0.95)
    return damping_effect(name, law_name, lambda v: v * (1.0 + (q * v) ** 2) ** (0.5 * (n - 1.0)), scale,
                          {"q": q, "n": n})


@law("viscous_damping", "squeeze_film")
def squeeze_film(rng, scale, name, law_name):
    """Oil between plates: v over the cube of the clearance, which the displacement changes (Reynolds 1886)."""
    b = rng.uniform(0.05, 0.2) * rng.choice([-1.0, 1.0])
    strongest = 1.2 * scale.stiffness / (0.5 * angular(scale))
    return Effect(name, law_name, "parallel",
                  each(lambda z, rate: np.gradient(z) * rate / (1.0 - b * z / scale.amplitude) ** 3), strongest,
                  {"b": b})


# ---- softening by past motion, heating -------------------------------------------------------------------------------


def fading_peaks(z, rate, tau, training):
    """Largest past |z| that fades with tau; carried from one training log to the next, new for each hold-out log."""
    out, past = [], 0.0
    for i, x in enumerate(z):
        start = past if i < training else 0.0
        skip = max(1, len(x) // 8000)
        top = np.maximum.reduceat(np.abs(x), np.arange(0, len(x), skip))
        t = np.arange(len(top)) * skip / rate
        # max over the past of |z| exp(-(t - t') / tau), in logarithms so that nothing overflows
        grown = np.log(np.maximum(top, 1e-30)) + t / tau
        grown[0] = max(grown[0], math.log(max(start, 1e-30)))
        peak = np.exp(np.maximum.accumulate(grown) - t / tau)
        out.append(np.maximum(np.interp(np.arange(len(x)), np.arange(0, len(x), skip), peak), np.abs(x)))
        past = float(out[-1][-1])
    return out


@law("stress_softening", "healing")
def healing(rng, scale, name, law_name):
    """Softer inside what the motion has reached, which heals in time (after Diani, Fayolle and Gilormini 2009)."""
    tau, power = span(scale) * log_uniform(rng, 0.7, 5.0), rng.uniform(0.7, 1.6)

    def factors(z, elastic, rest, rate):
        return [((peak - np.abs(x)) / (peak + 0.1 * scale.amplitude)) ** power
                for x, peak in zip(z, fading_peaks(z, rate, tau, scale.training))]
    return factor_effect(name, law_name, factors, 0.6, {"tau": tau, "power": power})


@law("stress_softening", "saturating_damage")
def saturating_damage(rng, scale, name, law_name):
    """1 - (1 - exp(-M / a)) / (M / a) for good, M the largest past displacement (Simo 1987, CMAME 60)."""
    a = scale.amplitude * rng.uniform(0.1, 0.5)

    def factors(z, elastic, rest, rate):
        peaks = fading_peaks(z, rate, 1e9 * span(scale), scale.training)
        return [1.0 + np.expm1(-peak / a) * a / np.maximum(peak, 1e-6 * a) for peak in peaks]
    return factor_effect(name, law_name, factors, 0.7, {"a": a})


def warmth(force, z, rate, scale, times, weights):
    """Temperature rise of a body of several time constants, each log from cold; about 1 after a log of hard work."""
    skip = max(1, int(rate / (2.0 * scale.top_frequency)))
    out = []
    for f, x in zip(force, z):
        work = np.add.reduceat(f * np.gradient(x), np.arange(0, len(x), skip))
        rise = np.zeros_like(work)
        for tau, weight in zip(times, weights):
            keep = math.exp(-skip / rate / tau)
            rise += weight * lfilter([1.0], [1.0, -keep], work)
        rise = np.maximum(lfilter([0.1], [1.0, -0.9], rise), 0.0)
        out.append(np.interp(np.arange(len(x)), np.arange(0, len(x), skip), rise))
    unit = 0.03 * scale.force * scale.speed * span(scale)
    return [x / unit for x in out]


def heating_effect(rng, scale, name, law_name, response, parameters):
    """`response(strength, warmth)` is the factor on the stiffness; losses fall faster."""
    times = span(scale) * rng.uniform(0.3, 2.0) / np.array([1.0, 4.0, 9.0, 16.0])
    weights, extra = np.array([0.62, 0.2, 0.11, 0.07]), rng.uniform(1.1, 1.7)

    def run(z, elastic, rest, rate, strength):
        force = [a + b for a, b in zip(elastic, rest)]
        for _ in range(2):
            warm = warmth(force, z, rate, scale, times, weights)
            force = [a * response(strength, w) + b * response(strength * extra, w)
                     for a, b, w in zip(elastic, rest, warm)]
        return force
    return Effect(name, law_name, "factor", run, 1.0, dict(parameters, times=times.tolist(), loss_factor=extra))


@law("self_heating", "layer_hyperbolic")
def heating_layer(rng, scale, name, law_name):
    """A layer that loses heat at its faces, modes of diffusion; stiffness over 1 + s T."""
    return heating_effect(rng, scale, name, law_name, lambda s, w: 1.0 / (1.0 + s * w), {})


@law("self_heating", "wlf_layer")
def heating_wlf(rng, scale, name, law_name):
    """The same layer; stiffness by the shift of Williams, Landel and Ferry 1955 (JACS 77) at a weak slope."""
    c = rng.uniform(1.0, 3.0)
    return heating_effect(rng, scale, name, law_name, lambda s, w: np.exp(-s * w * c / (c + w)), {"c": c})


@law("temperature", "transition_tail")
def transition_tail(rng, scale, name, law_name):
    """Another temperature in each log, drifting within it: the tail of the glass transition, in losses most of all.

    The thermometer's column shows it: `start` and `rise` [degC] of each log.
    """
    start = rng.uniform(5.0, 40.0, len(scale.lengths))
    rise = rng.uniform(-6.0, 6.0, len(scale.lengths))

    def run(z, elastic, rest, rate, strength):
        out = []
        for i, (a, b) in enumerate(zip(elastic, rest)):
            warm = 0.05 * (start[i] + rise[i] * np.linspace(0.0, 1.0, len(a)) - 20.0)
            glassy = 0.5 * np.expm1(-2.0 * warm)
            out.append(a * (1.0 + strength * glassy) + b * np.exp(-2.5 * strength * warm))
        return out
    return Effect(name, law_name, "factor", run, 0.4, {"start": start.tolist(), "rise": rise.tolist()})
