# The laws by which the effects of a virtual rig act: several for each effect, some held back for the sealed test set.
# Several share their form with what the diagnosis fits: sliders, Prony, dead zone, linear stop, ramp, mass, offset, delay.
"""Effect laws. `LAWS[effect]` is a list of (law, maker, test_only); a maker draws an Effect from (rng, scale)."""
import math

import numpy as np
from scipy.signal import bessel, butter, fftconvolve, lfilter
from scipy.special import erf

from .effect import Effect

LAWS = {}


def law(effect, name, test_only=False, registry=LAWS):
    """Register a maker of an effect's law."""
    def register(maker):
        registry.setdefault(effect, []).append((name, lambda rng, scale: maker(rng, scale, effect, name), test_only))
        return maker
    return register


def log_uniform(rng, low, high):
    return float(np.exp(rng.uniform(math.log(low), math.log(high))))


def each(function):
    """A parallel law that works on one log."""
    return lambda z, rate: [function(x, rate) for x in z]


# ---- friction: rate independent, from a law in the path of the displacement ------------------------------------------

FRICTION_RATE = 1000.0


def on_friction_grid(function):
    """Run a scalar loop at no more than 1 kHz, linear in between."""
    def run(z, rate):
        skip = max(1, int(round(rate / FRICTION_RATE)))
        out = []
        for x in z:
            coarse = function(x[::skip], rate / skip)
            n = np.arange(len(x))
            out.append(coarse if skip == 1 else np.interp(n, n[::skip], coarse))
        return out
    return run


def friction_effect(name, law_name, function, scale, parameters):
    return Effect(name, law_name, "parallel", on_friction_grid(function), 1.2 * scale.stiffness * scale.amplitude,
                  parameters)


def slip_length(rng, scale):
    return scale.amplitude * log_uniform(rng, 0.03, 0.4)


@law("friction", "bouc_wen")
def bouc_wen(rng, scale, name, law_name):
    zy, n, beta = slip_length(rng, scale), rng.uniform(1.0, 2.2), rng.uniform(0.5, 0.85)

    def run(z, rate):
        steps = np.diff(z, prepend=z[0]) / zy
        out, h = np.empty_like(z), 0.0
        for i, step in enumerate(steps.tolist()):
            parts = 1 + int(abs(step) * 4.0)
            step /= parts
            for _ in range(parts):
                sign = 1.0 if step * h > 0.0 else -1.0
                h += step * (1.0 - abs(h) ** n * (beta * sign + 1.0 - beta))
            out[i] = h
        return out
    return friction_effect(name, law_name, run, scale, {"zy": zy, "n": n, "beta": beta})


@law("friction", "dahl")
def dahl(rng, scale, name, law_name):
    zy, power = slip_length(rng, scale), rng.uniform(0.6, 1.6)

    def run(z, rate):
        steps = np.diff(z, prepend=z[0]) / zy
        out, h = np.empty_like(z), 0.0
        for i, step in enumerate(steps.tolist()):
            parts = 1 + int(abs(step) * 4.0)
            step /= parts
            sign = 1.0 if step > 0.0 else -1.0
            for _ in range(parts):
                h += step * max(0.0, 1.0 - sign * h) ** power
            h = min(1.0, max(-1.0, h))
            out[i] = h
        return out
    return friction_effect(name, law_name, run, scale, {"zy": zy, "power": power})


@law("friction", "coulomb_finite_stiffness")
def coulomb(rng, scale, name, law_name):
    zy = slip_length(rng, scale)

    def run(z, rate):
        out, h = np.empty_like(z), 0.0
        for i, step in enumerate((np.diff(z, prepend=z[0]) / zy).tolist()):
            h = min(1.0, max(-1.0, h + step))
            out[i] = h
        return out
    return friction_effect(name, law_name, run, scale, {"zy": zy})


def iwan_effect(name, law_name, thresholds, weights, scale, parameters):
    """Jenkins sliders in parallel, all sliders of all logs in one step; force 1 when all slide."""
    def run(z, rate):
        skip = max(1, int(round(rate / FRICTION_RATE)))
        coarse = [x[::skip] for x in z]
        steps = np.zeros((max(len(x) for x in coarse), len(z), 1))
        for i, x in enumerate(coarse):
            steps[:len(x), i, 0] = np.diff(x, prepend=x[0])
        state, history = np.zeros((len(z), len(thresholds))), np.empty(steps.shape[:2])
        shares = weights / thresholds
        for i in range(len(steps)):
            state += steps[i]
            np.maximum(state, -thresholds, out=state)
            np.minimum(state, thresholds, out=state)
            history[i] = state @ shares
        return [np.interp(np.arange(len(x)), np.arange(0, len(x), skip), history[:len(c), i])
                for i, (x, c) in enumerate(zip(z, coarse))]
    return Effect(name, law_name, "parallel", run, 1.2 * scale.stiffness * scale.amplitude, parameters)


@law("friction", "random_iwan")
def random_iwan(rng, scale, name, law_name):
    count = int(rng.integers(4, 11))
    thresholds = slip_length(rng, scale) * np.exp(rng.normal(0.0, 0.9, count))
    weights = rng.dirichlet(np.ones(count))
    return iwan_effect(name, law_name, thresholds, weights, scale,
                       {"thresholds": thresholds.tolist(), "weights": weights.tolist()})


@law("friction", "lugre", test_only=True)
def lugre(rng, scale, name, law_name):
    zy, bump, stribeck = slip_length(rng, scale), rng.uniform(0.0, 0.25), 0.3 * scale.speed

    def run(z, rate):
        dt, out, h = 1.0 / rate, np.empty_like(z), 0.0
        for i, v in enumerate((np.diff(z, prepend=z[0]) * rate).tolist()):
            level = (1.0 + bump * math.exp(-(v / stribeck) ** 2)) * zy
            decay = math.exp(-abs(v) / level * dt)
            target = level if v > 0.0 else -level
            h = target + (h - target) * decay
            out[i] = h / zy
        return out
    return friction_effect(name, law_name, run, scale, {"zy": zy, "stribeck": bump})


@law("friction", "power_law_iwan", test_only=True)
def power_law_iwan(rng, scale, name, law_name):
    chi, longest = rng.uniform(-0.8, 0.2), scale.amplitude * log_uniform(rng, 0.2, 0.9)
    edges = np.geomspace(0.005, 1.0, 15)
    weights = np.diff(edges ** (chi + 2.0))
    return iwan_effect(name, law_name, longest * 0.5 * (edges[1:] + edges[:-1]), weights / weights.sum(), scale,
                       {"chi": chi, "longest": longest})


# ---- elastic laws: functions of the displacement alone ---------------------------------------------------------------


def elastic_effect(name, law_name, function, scale, parameters, strongest=1.0):
    """`function` takes z over the largest amplitude; its share is scaled to 1 N at that amplitude, then by strength."""
    size = max(abs(float(function(np.array([1.0]))[0])), abs(float(function(np.array([-1.0]))[0])), 1e-12)
    return Effect(name, law_name, "parallel", each(lambda z, rate: function(z / scale.amplitude) / size),
                  strongest * scale.stiffness * scale.amplitude, parameters)


@law("progressive_stiffness", "logarithmic")
def progressive_logarithmic(rng, scale, name, law_name):
    lock = rng.uniform(1.08, 2.0)

    def run(x):
        y = np.minimum(np.abs(x) / lock, 0.95)
        return np.sign(x) * (-np.log1p(-y) - y)
    return elastic_effect(name, law_name, run, scale, {"lock": lock})


@law("progressive_stiffness", "power")
def progressive_power(rng, scale, name, law_name):
    p = rng.uniform(1.6, 4.0)
    return elastic_effect(name, law_name, lambda x: np.sign(x) * np.abs(x) ** p, scale, {"p": p})


@law("progressive_stiffness", "tan")
def progressive_tan(rng, scale, name, law_name):
    s = rng.uniform(0.7, 1.2)
    limit = 1.45

    def run(x):
        y = np.clip(s * x, -limit, limit)
        return np.tan(y) - y
    return elastic_effect(name, law_name, run, scale, {"s": s})


@law("progressive_stiffness", "gent", test_only=True)
def progressive_gent(rng, scale, name, law_name):
    lock = rng.uniform(1.15, 1.8)
    return elastic_effect(name, law_name, lambda x: x / (1.0 - np.minimum((x / lock) ** 2, 0.9)) - x, scale,
                          {"lock": lock})


@law("progressive_stiffness", "inverse_langevin", test_only=True)
def progressive_langevin(rng, scale, name, law_name):
    lock = rng.uniform(1.1, 1.6)

    def run(x):
        y = np.clip(x / lock, -0.93, 0.93)
        return y * (3.0 - y**2) / (1.0 - y**2) - 3.0 * y
    return elastic_effect(name, law_name, run, scale, {"lock": lock})


@law("asymmetric_stiffness", "hyperbolic")
def asymmetric_hyperbolic(rng, scale, name, law_name):
    s = rng.uniform(0.15, 0.6) * rng.choice([-1.0, 1.0])
    return elastic_effect(name, law_name, lambda x: x / (1.0 - np.clip(s * x, -0.9, 0.9)) - x, scale, {"s": s})


@law("asymmetric_stiffness", "two_slopes")
def asymmetric_slopes(rng, scale, name, law_name):
    side, soft = rng.choice([-1.0, 1.0]), rng.uniform(0.0, 0.15)
    return elastic_effect(name, law_name, lambda x: 0.5 * (x + side * (np.hypot(x, soft) - soft)), scale,
                          {"side": side, "soft": soft}, 0.7)


@law("asymmetric_stiffness", "neo_hookean", test_only=True)
def asymmetric_neo_hookean(rng, scale, name, law_name):
    length, side = rng.uniform(2.5, 6.0), rng.choice([-1.0, 1.0])

    def run(x):
        stretch = 1.0 - side * x / length
        return -side * length * ((stretch - stretch ** -2) / 3.0) - x
    return elastic_effect(name, law_name, run, scale, {"length": length, "side": side})


@law("asymmetric_stiffness", "ogden", test_only=True)
def asymmetric_ogden(rng, scale, name, law_name):
    a, length, side = rng.uniform(2.5, 5.0), rng.uniform(2.0, 5.0), rng.choice([-1.0, 1.0])

    def run(x):
        stretch = 1.0 - side * x / length
        return -side * length * (stretch ** (a - 1.0) - stretch ** (-0.5 * a - 1.0)) / (1.5 * a) - x
    return elastic_effect(name, law_name, run, scale, {"a": a, "length": length, "side": side})


def stop_effect(rng, scale, name, law_name, contact, parameters):
    """A stop at 55 to 85 % of the largest displacement; one side, the other, or both."""
    gap, side = rng.uniform(0.55, 0.85), str(rng.choice(["upper", "lower", "both", "both"]))
    other = gap * rng.uniform(0.9, 1.1)

    def run(x):
        out = np.zeros_like(x)
        if side in ("upper", "both"):
            out += contact(x - gap)
        if side in ("lower", "both"):
            out -= contact(-x - (other if side == "both" else gap))
        return out
    parameters.update({"gap": gap * scale.amplitude, "side": side})
    return elastic_effect(name, law_name, run, scale, parameters, 6.0)


@law("bump_stop", "hertz")
def bump_hertz(rng, scale, name, law_name):
    p = rng.choice([1.0, 1.5, 2.0], p=[0.25, 0.5, 0.25])
    return stop_effect(rng, scale, name, law_name, lambda d: np.maximum(d, 0.0) ** p, {"power": float(p)})


@law("bump_stop", "exponential")
def bump_exponential(rng, scale, name, law_name):
    depth = rng.uniform(0.1, 0.3)
    return stop_effect(rng, scale, name, law_name, lambda d: np.expm1(np.maximum(d, 0.0) / depth), {"depth": depth})


@law("bump_stop", "soft_contact", test_only=True)
def bump_soft(rng, scale, name, law_name):
    rounding = rng.uniform(0.01, 0.03)
    return stop_effect(rng, scale, name, law_name,
                       lambda d: rounding * np.logaddexp(0.0, np.clip(d / rounding, -60.0, None)) ** 1.2,
                       {"rounding": rounding})


def play_effect(name, law_name, scale, function, parameters):
    # No log may lie inside the play altogether.
    return Effect(name, law_name, "play", lambda z, rate, g: [function(x, g) for x in z], 0.6 * scale.least_amplitude,
                  parameters)


@law("free_play", "dead_zone")
def free_play_hard(rng, scale, name, law_name):
    shift = rng.uniform(-0.3, 0.3) if rng.random() < 0.4 else 0.0

    def run(z, g):
        y = z - shift * g
        return y - np.clip(y, -g, g) + (np.clip(-shift * g, -g, g) + shift * g)
    return play_effect(name, law_name, scale, run, {"shift": shift})


@law("free_play", "rounded_dead_zone")
def free_play_rounded(rng, scale, name, law_name):
    r = rng.uniform(0.05, 0.3)

    def run(z, g):
        w = r * g + 1e-15
        return 0.5 * (np.hypot(z - g, w) - np.hypot(z + g, w)) + z
    return play_effect(name, law_name, scale, run, {"rounding": r})


@law("free_play", "soft_zone", test_only=True)
def free_play_soft(rng, scale, name, law_name):
    rest = rng.uniform(0.03, 0.15)
    return play_effect(name, law_name, scale, lambda z, g: z - (1.0 - rest) * np.clip(z, -g, g), {"rest": rest})


# ---- memory: kernels over the increments of displacement -------------------------------------------------------------


def kernel_effect(name, law_name, kernel, strongest, parameters, divide=1):
    """force = strength * sum_j kernel(t - t_j) dz_j; the kernel may live on a grid coarser by `divide`."""
    def run(z, rate):
        t = (np.arange(len(z)) + 0.5) / rate
        return fftconvolve(np.diff(z, prepend=z[0]), kernel(t, rate))[:len(z)]
    return Effect(name, law_name, "parallel", each(run), strongest, parameters)


@law("relaxation", "gruenwald_letnikov")
def relaxation_fractional(rng, scale, name, law_name):
    alpha, tempering = rng.uniform(0.12, 0.55), log_uniform(rng, 1.0, 8.0)

    def run(z, rate):
        j = np.arange(1, len(z))
        weights = np.concatenate([[1.0], np.cumprod((j - 1.0 - alpha) / j)]) * (rate * 0.1) ** alpha
        fade = np.exp(-np.arange(len(z)) / rate / tempering)
        return fftconvolve(z, weights * fade)[:len(z)] - z * np.sum(weights * fade)
    return Effect(name, law_name, "parallel", each(run), 1.5 * scale.stiffness, {"alpha": alpha, "tempering": tempering})


@law("relaxation", "kohlrausch")
def relaxation_kohlrausch(rng, scale, name, law_name):
    tau, beta = log_uniform(rng, 0.01, 0.6), rng.uniform(0.35, 0.8)
    return kernel_effect(name, law_name, lambda t, rate: np.exp(-(t / tau) ** beta), 1.5 * scale.stiffness,
                         {"tau": tau, "beta": beta})


@law("relaxation", "prony")
def relaxation_prony(rng, scale, name, law_name):
    count = int(rng.integers(1, 4))
    taus = np.array([log_uniform(rng, 0.006, 1.5) for _ in range(count)])
    weights = rng.dirichlet(np.ones(count) * 2.0)
    return kernel_effect(name, law_name, lambda t, rate: np.exp(-t[:, None] / taus) @ weights, 1.5 * scale.stiffness,
                         {"tau": taus.tolist(), "weight": weights.tolist()})


@law("relaxation", "lognormal_spectrum", test_only=True)
def relaxation_lognormal(rng, scale, name, law_name):
    centre, width = log_uniform(rng, 0.02, 0.4), rng.uniform(0.8, 2.0)
    x = np.linspace(-2.5, 2.5, 13)
    taus, weights = centre * np.exp(width * x), np.exp(-0.5 * x**2) / np.exp(-0.5 * x**2).sum()
    return kernel_effect(name, law_name, lambda t, rate: np.exp(-t[:, None] / taus) @ weights, 1.5 * scale.stiffness,
                         {"centre": centre, "width": width})


@law("creep", "log_time")
def creep_log(rng, scale, name, law_name):
    start = rng.uniform(2.0, 6.0)
    return kernel_effect(name, law_name, lambda t, rate: -np.log1p(t / start), 0.35 * scale.stiffness, {"start": start})


@law("creep", "slow_kohlrausch")
def creep_kohlrausch(rng, scale, name, law_name):
    tau, beta = log_uniform(rng, 10.0, 60.0), rng.uniform(0.7, 1.0)
    return kernel_effect(name, law_name, lambda t, rate: np.exp(-(t / tau) ** beta) - 1.0, 0.7 * scale.stiffness,
                         {"tau": tau, "beta": beta})


@law("creep", "power_time", test_only=True)
def creep_power(rng, scale, name, law_name):
    start, m = rng.uniform(3.0, 8.0), rng.uniform(0.2, 0.5)
    return kernel_effect(name, law_name, lambda t, rate: 1.0 - (1.0 + t / start) ** m, 0.4 * scale.stiffness,
                         {"start": start, "m": m})


def damping_effect(name, law_name, function, scale, parameters):
    """`function` takes the velocity over its RMS."""
    speed = scale.speed
    return Effect(name, law_name, "parallel", each(lambda z, rate: speed * function(np.gradient(z) * rate / speed)),
                  1.2 * scale.stiffness / (2 * np.pi * 0.5 * scale.top_frequency), parameters)


@law("viscous_damping", "thinning")
def damping_thinning(rng, scale, name, law_name):
    q = 1e-3 if rng.random() < 0.4 else rng.uniform(0.2, 1.0)
    return damping_effect(name, law_name, lambda v: np.arcsinh(q * v) / q, scale, {"q": q})


@law("viscous_damping", "turbulent", test_only=True)
def damping_turbulent(rng, scale, name, law_name):
    q = rng.uniform(0.1, 0.6)
    return damping_effect(name, law_name, lambda v: v * np.sqrt(1.0 + (q * v) ** 2), scale, {"q": q})


# ---- coupling of rate and amplitude: flow that stress or motion accelerates ----------------------------------------------


@law("rate_amplitude_coupling", "eyring_flow")
def coupling_eyring(rng, scale, name, law_name):
    """df/dt = dz/dt - w s sinh(f/s), f in units of the displacement; Heun's method."""
    w = 2 * np.pi * scale.top_frequency * log_uniform(rng, 0.03, 0.5)
    s = scale.amplitude * log_uniform(rng, 0.05, 0.4)

    def run(z, rate):
        out, f, dt = np.empty_like(z), 0.0, 1.0 / rate
        flow = lambda f: w * s * math.sinh(max(-8.0, min(8.0, f / s)))
        dz = np.diff(z, prepend=z[0])
        for i, step in enumerate(dz):
            first = flow(f)
            f += step - 0.5 * dt * (first + flow(f + step - dt * first))
            out[i] = f / scale.amplitude
        return out
    return friction_effect(name, law_name, run, scale, {"w": w, "s": s})


@law("rate_amplitude_coupling", "thixotropic", test_only=True)
def coupling_thixotropic(rng, scale, name, law_name):
    """A relaxing force whose stiffness is a structure that motion breaks and rest builds up again."""
    w = 2 * np.pi * scale.top_frequency * log_uniform(rng, 0.03, 0.3)
    path, build = scale.amplitude * log_uniform(rng, 0.2, 2.0), log_uniform(rng, 0.05, 2.0)

    def run(z, rate):
        out, f, whole, decay = np.empty_like(z), 0.0, 1.0, math.exp(-w / rate)
        dz = np.diff(z, prepend=z[0])
        for i, step in enumerate(dz):
            whole += (1.0 - whole) / (build * rate) - whole * abs(step) / path
            whole = min(1.0, max(0.0, whole))
            f = decay * f + whole * step * (1.0 - decay) * rate / w
            out[i] = f / scale.amplitude
        return out
    return friction_effect(name, law_name, run, scale, {"w": w, "path": path, "build": build})


# ---- softening and heating: factors on the specimen's force ----------------------------------------------------------


def running_peaks(z, training):
    """Largest past |z| at each sample; carried from one training log to the next, anew for each hold-out log."""
    out, past = [], 0.0
    for i, x in enumerate(z):
        start = past if i < training else 0.0
        out.append(np.maximum(np.maximum.accumulate(np.abs(x)), start))
        past = float(out[-1][-1])
    return out


def factor_effect(name, law_name, factors, strongest, parameters):
    """`factors(z, elastic, rest, rate)` gives the loss of stiffness at strength 1, a list over the logs."""
    def run(z, elastic, rest, rate, strength):
        losses = factors(z, elastic, rest, rate)
        return [(1.0 - strength * x) * (a + b) for x, a, b in zip(losses, elastic, rest)]
    return Effect(name, law_name, "factor", run, strongest, parameters)


@law("stress_softening", "ogden_roxburgh")
def softening_ogden_roxburgh(rng, scale, name, law_name):
    m, b = log_uniform(rng, 0.02, 0.2), rng.uniform(0.0, 0.4)
    top = 0.5 * scale.amplitude**2

    def factors(z, elastic, rest, rate):
        out = []
        for x, peak in zip(z, running_peaks(z, scale.training)):
            energy, past = 0.5 * x**2 / top, 0.5 * peak**2 / top
            out.append(erf((past - energy) / (m + b * past)))
        return out
    return factor_effect(name, law_name, factors, 0.5, {"m": m, "b": b})


@law("stress_softening", "cyclic_damage")
def softening_damage(rng, scale, name, law_name):
    cycles, shape = rng.uniform(0.7, 2.0), rng.uniform(1.0, 3.0)

    def factors(z, elastic, rest, rate):
        skip = max(1, int(rate / 100.0))
        out, damage = [], 0.0
        for i, (x, peak) in enumerate(zip(z, running_peaks(z, scale.training))):
            damage = damage if i < scale.training else 0.0
            path = np.abs(np.diff(x, prepend=x[0]))
            path = np.add.reduceat(path, np.arange(0, len(x), skip)).tolist()
            course = np.empty(len(path))
            for j, (step, top) in enumerate(zip(path, peak[::skip].tolist())):
                if top > 0.0:
                    damage += (top / scale.amplitude - damage) * -math.expm1(-step / (4.0 * cycles * top))
                course[j] = damage
            n = np.arange(len(x))
            inside = 1.0 - (np.abs(x) / np.maximum(peak, 1e-12)) ** shape
            out.append(np.interp(n, n[::skip], course) * inside)
        return out
    return factor_effect(name, law_name, factors, 0.6, {"cycles": cycles, "shape": shape})


@law("stress_softening", "distance_to_peak", test_only=True)
def softening_distance(rng, scale, name, law_name):
    p = rng.uniform(0.4, 1.0)

    def factors(z, elastic, rest, rate):
        return [((peak - np.abs(x)) / scale.amplitude) ** p for x, peak in zip(z, running_peaks(z, scale.training))]
    return factor_effect(name, law_name, factors, 0.6, {"p": p})


def temperatures(force, z, rate, tau_fast, tau_slow, share):
    """Rise of a two-node body that takes up the loss power, each log from cold; the hottest of all is 1."""
    skip = max(1, int(rate / 50.0))
    out = []
    for f, x in zip(force, z):
        power = f * np.gradient(x)
        power = np.add.reduceat(power, np.arange(0, len(power), skip))
        rise = np.zeros_like(power)
        for tau, weight in ((tau_fast, share), (tau_slow, 1.0 - share)):
            e = math.exp(-skip / rate / tau)
            rise += weight * lfilter([1.0], [1.0, -e], power)
        smooth = 1.0 - math.exp(-skip / rate / 1.0)
        rise = np.maximum(lfilter([smooth], [1.0, smooth - 1.0], rise), 0.0)
        n = np.arange(len(x))
        out.append(np.interp(n, n[::skip], rise))
    top = max(float(x.max()) for x in out)
    return [x / max(top, 1e-30) for x in out]


def heating_effect(rng, name, law_name, response, parameters):
    fast, slow, share = rng.uniform(6.0, 25.0), rng.uniform(60.0, 240.0), rng.uniform(0.3, 0.8)
    extra = rng.uniform(1.0, 1.8)
    parameters.update({"tau_fast": fast, "tau_slow": slow, "share": share, "loss_factor": extra})

    def run(z, elastic, rest, rate, strength):
        force = [a + b for a, b in zip(elastic, rest)]
        for _ in range(2):
            warm = temperatures(force, z, rate, fast, slow, share)
            force = [a * response(strength, w) + b * response(strength * extra, w)
                     for a, b, w in zip(elastic, rest, warm)]
        return force
    return Effect(name, law_name, "factor", run, 0.45, parameters)


@law("self_heating", "two_nodes_linear")
def heating_linear(rng, scale, name, law_name):
    return heating_effect(rng, name, law_name, lambda s, w: np.maximum(1.0 - s * w, 0.1), {})


@law("self_heating", "two_nodes_exponential", test_only=True)
def heating_exponential(rng, scale, name, law_name):
    return heating_effect(rng, name, law_name, lambda s, w: np.exp(-1.2 * s * w), {})


# ---- the rig ---------------------------------------------------------------------------------------------------------


@law("series_compliance", "hardening_joint")
def series_hardening(rng, scale, name, law_name):
    e = rng.uniform(0.0, 0.3)
    top = scale.stiffness * scale.amplitude
    return Effect(name, law_name, "mount", lambda f, s: s * f / scale.stiffness * (1.0 - e * np.tanh((f / top) ** 2)),
                  0.45, {"hardening": e})


@law("series_compliance", "uneven_joint", test_only=True)
def series_uneven(rng, scale, name, law_name):
    e = rng.uniform(-0.1, 0.1)
    top = scale.stiffness * scale.amplitude
    return Effect(name, law_name, "mount", lambda f, s: s * f / scale.stiffness * (1.0 + e * np.tanh(3.0 * f / top)),
                  0.45, {"unevenness": e})


def contact_effect(name, law_name, scale, opening, width, parameters):
    """A seat that is not glued, in series with the specimen: `opening(x, width)` is x above 0, rounded by the seat.

    Where it is open a guide holds the specimen, less so the stronger the effect: at strength 1 nothing does. The law of
    the seat is where its step leads nowhere: with an exact maximum, force >= 0, opening >= 0, one of them 0.
    """
    def run(z, inner, force, s):
        guide = scale.stiffness * (1.0 / s - 1.0)
        ahead = force + guide * (inner - z)
        step = ahead / (2.0 * scale.stiffness + guide)  # as stiff as the specimen is in no direction
        return z + scale.side * opening(scale.side * (inner - step - z), s * width)
    return Effect(name, law_name, "contact", run, 1.0, dict(parameters, side=scale.side))


@law("lift_off", "rough_seat")
def contact_rough(rng, scale, name, law_name):
    """Rough faces that lose touch by and by: the opening grows with the logarithm of the force (Greenwood)."""
    w = scale.amplitude * log_uniform(rng, 0.002, 0.02)
    return contact_effect(name, law_name, scale, lambda x, w: w * np.logaddexp(0.0, x / w), w, {"roughness": w})


@law("lift_off", "cushioned_seat", test_only=True)
def contact_cushioned(rng, scale, name, law_name):
    """Air below the lip: force times opening is constant (Boyle)."""
    w = scale.amplitude * log_uniform(rng, 0.005, 0.05)
    return contact_effect(name, law_name, scale, lambda x, w: 0.5 * (x + np.hypot(x, w)), w, {"cushion": w})


@law("inertia", "rigid_mass")
def inertia_rigid(rng, scale, name, law_name):
    return Effect(name, law_name, "added", each(lambda z, rate: np.gradient(np.gradient(z)) * rate**2),
                  scale.stiffness / (2 * np.pi * 0.6 * scale.top_frequency) ** 2, {})


@law("inertia", "elastic_fixture", test_only=True)
def inertia_elastic(rng, scale, name, law_name):
    f, damping = rng.uniform(90.0, 200.0), rng.uniform(0.02, 0.1)

    def run(z, rate):
        w = 2 * np.pi * f / rate
        r = math.exp(-damping * w)
        a = [1.0, -2.0 * r * math.cos(w * math.sqrt(1 - damping**2)), r * r]
        x = lfilter([sum(a)], a, z)
        return np.gradient(np.gradient(x)) * rate**2
    return Effect(name, law_name, "added", each(run), scale.stiffness / (2 * np.pi * 0.6 * scale.top_frequency) ** 2,
                  {"fixture_frequency": f, "damping": damping})


def shifted(x, samples):
    """x later by a number of samples that need not be whole; at rest before its start."""
    n = np.arange(len(x), dtype=float)
    return np.interp(n - samples, n, x, left=x[0])


@law("time_delay", "late_displacement")
def delay_displacement(rng, scale, name, law_name):
    return Effect(name, law_name, "displacement", lambda z, rate, s: [shifted(x, s * rate) for x in z], 0.012, {})


@law("time_delay", "late_force")
def delay_force(rng, scale, name, law_name):
    return Effect(name, law_name, "transducer", lambda f, rate, s: [shifted(x, s * rate) for x in f], 0.012, {})


def filtered(force, rate, numerator, denominator):
    """An analogue filter (coefficients in s) on logs that were constant before their start, whatever the rate."""
    out = []
    for x in force:
        n = len(x) + 2048
        s = 2j * np.pi * np.fft.rfftfreq(n, 1.0 / rate)
        response = np.polyval(numerator, s) / np.polyval(denominator, s)
        out.append(x[0] + np.fft.irfft(np.fft.rfft(x - x[0], n) * response, n)[:len(x)])
    return out


@law("time_delay", "butterworth_2")
def delay_butterworth(rng, scale, name, law_name):
    def run(force, rate, s):
        return filtered(force, rate, *butter(2, math.sqrt(2.0) / s, analog=True))
    return Effect(name, law_name, "transducer", run, math.sqrt(2.0) / (2 * np.pi * 1.8 * scale.top_frequency), {})


@law("time_delay", "bessel_4", test_only=True)
def delay_bessel(rng, scale, name, law_name):
    def run(force, rate, s):
        return filtered(force, rate, *bessel(4, 1.0 / s, analog=True, norm="delay"))
    return Effect(name, law_name, "transducer", run, 0.006, {})


def added_logs(rng, name, law_name, maker, scale, parameters, strongest=0.5):
    """A share drawn once for every log, as a function of time that can be taken at any rate."""
    shares = [maker(n) for n in scale.lengths]

    def run(z, rate):
        skip = int(round(scale.rate / rate))
        return [share[::skip][:len(x)] for share, x in zip(shares, z)]
    return Effect(name, law_name, "added", run, strongest * scale.force, parameters)


@law("force_offset", "constant")
def offset_constant(rng, scale, name, law_name):
    sign = rng.choice([-1.0, 1.0])
    return added_logs(rng, name, law_name, lambda n: np.full(n, sign), scale, {"sign": sign})


@law("force_offset", "re_zeroed", test_only=True)
def offset_re_zeroed(rng, scale, name, law_name):
    sign = rng.choice([-1.0, 1.0])
    return added_logs(rng, name, law_name, lambda n: np.full(n, sign * rng.normal(1.0, 0.03)), scale, {"sign": sign})


def unit(x):
    return (x - x[0]) / max(float(np.std(x)), 1e-30)


@law("force_drift", "ramp")
def drift_ramp(rng, scale, name, law_name):
    sign = rng.choice([-1.0, 1.0])
    spread = rng.uniform(0.0, 0.4)
    return added_logs(rng, name, law_name,
                      lambda n: sign * (1.0 + spread * rng.normal()) * np.arange(n) / scale.rate / 15.0, scale,
                      {"spread": spread})


@law("force_drift", "random_walk")
def drift_walk(rng, scale, name, law_name):
    return added_logs(rng, name, law_name, lambda n: unit(np.cumsum(rng.standard_normal(n))), scale, {})


@law("force_drift", "one_over_f")
def drift_pink(rng, scale, name, law_name):
    slope = rng.uniform(1.2, 2.0)

    def maker(n):
        f = np.fft.rfftfreq(n, 1.0 / scale.rate)
        f[0] = np.inf
        spectrum = f ** (-0.5 * slope) * np.exp(2j * np.pi * rng.random(len(f))) * (f < 2.0)
        return unit(np.fft.irfft(spectrum, n))
    return added_logs(rng, name, law_name, maker, scale, {"slope": slope})


@law("force_drift", "warm_up", test_only=True)
def drift_warm_up(rng, scale, name, law_name):
    tau, sign = rng.uniform(15.0, 60.0), rng.choice([-1.0, 1.0])
    return added_logs(rng, name, law_name,
                      lambda n: sign * rng.uniform(0.8, 1.2) * -2.0 * np.expm1(-np.arange(n) / scale.rate / tau), scale,
                      {"tau": tau})


# ---- hydraulic mounts: a column of fluid between two chambers --------------------------------------------------------


def track_effect(rng, scale, name, law_name, chamber, shares, parameters):
    """Columns of fluid side by side, each q'' + 2 d w q' = w^2 f; f = chamber(z - sum q) is the force.

    `shares` of the columns are their cross sections: what flows through all of them leaves the chamber.
    """
    w = [2 * np.pi * scale.top_frequency * log_uniform(rng, 0.25, 0.8) for _ in shares]
    d = [rng.uniform(0.08, 0.4) for _ in shares]

    def run(z, rate):
        parts = max(1, int(math.ceil(8.0 * max(w) / rate)))
        h, out = 1.0 / (rate * parts), np.empty_like(z)
        q, v, before = [0.0] * len(w), [0.0] * len(w), float(z[0])
        start = before
        for i, x in enumerate(z.tolist()):
            for part in range(1, parts + 1):
                force = chamber((before + (x - before) * part / parts - start - sum(q)) / scale.amplitude)
                for j, share in enumerate(shares):
                    v[j] += h * w[j] * (share * w[j] * force - 2.0 * d[j] * v[j])
                    q[j] += h * scale.amplitude * v[j]
            out[i] = chamber((x - start - sum(q)) / scale.amplitude)
            before = x
        return out
    parameters.update({"w": w, "d": d})
    return Effect(name, law_name, "parallel", each(run), 2.0 * scale.stiffness * scale.amplitude, parameters)


@law("fluid_inertia", "stiffening_chamber")
def stiffening_chamber(rng, scale, name, law_name):
    """The rubber that bulges by the pressure stiffens: its last part as a cube."""
    cube = rng.uniform(0.05, 0.4)
    return track_effect(rng, scale, name, law_name, lambda x: x * (1.0 + cube * min(x * x, 9.0)), (1.0,),
                        {"cube": cube})


@law("fluid_inertia", "two_tracks", test_only=True)
def two_tracks(rng, scale, name, law_name):
    """A long and a short track side by side."""
    share = rng.uniform(0.3, 0.7)
    return track_effect(rng, scale, name, law_name, lambda x: x, (share, 1.0 - share), {"share": share})


# ---- what is in nobody's list ----------------------------------------------------------------------------------------


@law("unknown:load_cell_saturation", "soft_clip")
def saturation(rng, scale, name, law_name):
    p = rng.uniform(6.0, 16.0)
    top = 4.0 * scale.force

    def run(force, rate, s):
        limit = top / (8.0 * s + 1e-9)
        return [x / (1.0 + np.abs(x / limit) ** p) ** (1.0 / p) for x in force]
    return Effect(name, law_name, "transducer", run, 1.0, {"p": p})


@law("unknown:mains_hum", "harmonics")
def hum(rng, scale, name, law_name):
    f, shares = rng.normal(50.0, 0.02), rng.dirichlet(np.ones(3))

    def maker(n):
        t = np.arange(n) / scale.rate
        depth, beat = rng.uniform(0.0, 0.6), rng.uniform(0.03, 0.3)
        tone = sum(w * np.sin(2 * np.pi * (i + 1) * f * t + rng.uniform(0, 6.28)) for i, w in enumerate(shares))
        return tone * (1.0 + depth * np.sin(2 * np.pi * beat * t))
    return added_logs(rng, name, law_name, maker, scale, {"frequency": f}, 0.8)


@law("unknown:stick_slip", "bursts_at_reversal")
def stick_slip(rng, scale, name, law_name):
    f, decay = rng.uniform(25.0, 70.0), rng.uniform(0.05, 0.2)

    def run(z, rate):
        v = np.gradient(z)
        turns = np.flatnonzero((v[1:] * v[:-1] < 0.0) & (np.abs(z[1:]) > 0.05 * scale.amplitude))
        impulses = np.zeros_like(z)
        impulses[turns] = np.sign(z[turns]) * rng_state.uniform(0.5, 1.5, len(turns))
        t = np.arange(int(6.0 * decay * rate)) / rate
        return fftconvolve(impulses, np.exp(-t / decay) * np.sin(2 * np.pi * f * t))[:len(z)]
    seed = int(rng.integers(2**31))
    rng_state = None

    def logs(z, rate):
        nonlocal rng_state
        rng_state = np.random.default_rng(seed)
        return [run(x, rate) for x in z]
    return Effect(name, law_name, "added", logs, 2.0 * scale.force, {"frequency": f, "decay": decay})


@law("unknown:cable_drag", "catching_cable", test_only=True)
def cable(rng, scale, name, law_name):
    period, phase = scale.amplitude * rng.uniform(0.12, 0.35), rng.uniform(0, 6.28)
    return Effect(name, law_name, "added",
                  each(lambda z, rate: np.sin(2 * np.pi * z / period + phase) - math.sin(phase)), 0.6 * scale.force,
                  {"period": period})


@law("unknown:cross_talk", "other_axis")
def cross_talk(rng, scale, name, law_name):
    f, width = rng.uniform(0.5, 12.0), rng.uniform(0.1, 0.5)

    def maker(n):
        g = np.fft.rfftfreq(n, 1.0 / scale.rate)
        spectrum = np.exp(-0.5 * ((g - f) / (width * f)) ** 2) * np.exp(2j * np.pi * rng.random(len(g)))
        x = np.fft.irfft(spectrum, n)
        return x / np.std(x)
    return added_logs(rng, name, law_name, maker, scale, {"frequency": f, "width": width}, 0.6)


@law("unknown:gain_switching", "loose_connector", test_only=True)
def gain_switching(rng, scale, name, law_name):
    states = []
    for n in scale.lengths:
        edges = np.sort(rng.integers(0, n, size=2 * int(rng.integers(2, 7))))
        state = np.zeros(n)
        for a, b in zip(edges[::2], edges[1::2]):
            state[a:b] = 1.0
        states.append(state)

    def run(force, rate, s):
        skip = int(round(scale.rate / rate))
        return [x * (1.0 - s * state[::skip][:len(x)]) for x, state in zip(force, states)]
    return Effect(name, law_name, "transducer", run, 0.7, {})


@law("unknown:spikes", "electrostatic", test_only=True)
def spikes(rng, scale, name, law_name):
    per_second = log_uniform(rng, 1.0, 8.0)

    def maker(n):
        x = np.zeros(n)
        where = rng.integers(0, n, size=max(1, int(n / scale.rate * per_second)))
        x[where] = rng.standard_normal(len(where))
        e = math.exp(-1.0 / (scale.rate * 0.006))
        return lfilter([1.0], [1.0, -e], x)
    return added_logs(rng, name, law_name, maker, scale, {"per_second": per_second}, 6.0)


# ---- forms of friction, softening and play that the laws above do not have -------------------------------------------


@law("friction", "pressed_by_displacement", test_only=True)
def friction_pressed(rng, scale, name, law_name):
    """A slider whose limit grows with the square of the displacement, as where a wedge presses it."""
    zy, growth = slip_length(rng, scale), rng.uniform(0.5, 4.0)

    def run(z, rate):
        out, f = np.empty_like(z), 0.0
        limit = zy * (1.0 + growth * (z / scale.amplitude) ** 2)
        for i, (step, most) in enumerate(zip(np.diff(z, prepend=z[0]), limit)):
            f = min(most, max(-most, f + step))
            out[i] = f / scale.amplitude
        return out
    return friction_effect(name, law_name, run, scale, {"zy": zy, "growth": growth})


@law("stress_softening", "broken_links", test_only=True)
def softening_links(rng, scale, name, law_name):
    """Parallel links that break for good where the displacement first exceeds what each of them bears."""
    strength, m = scale.amplitude * rng.uniform(0.3, 1.2), rng.uniform(1.0, 2.5)

    def run(z, rate):
        return [x / scale.amplitude * np.exp(-(peak / strength) ** m)
                for x, peak in zip(z, running_peaks(z, scale.training))]
    return Effect(name, law_name, "parallel", run, 1.5 * scale.stiffness * scale.amplitude,
                  {"strength": strength, "m": m})


@law("backlash", "damper_in_a_hard_joint")
def backlash_damper(rng, scale, name, law_name):
    """A dashpot behind a clearance whose contact hardens: F = c dw/dt = k d^1.5, d the depth of contact."""
    gap = scale.amplitude * log_uniform(rng, 0.03, 0.25)
    w, depth = 2 * np.pi * scale.top_frequency * rng.uniform(1.0, 4.0), scale.amplitude * rng.uniform(0.02, 0.1)

    def run(z, rate):
        out, damper = np.empty_like(z), float(z[0])
        parts = max(1, int(math.ceil(4.0 * w / rate)))
        for i, x in enumerate(z.tolist()):
            before = z[i - 1] if i else x
            for part in range(1, parts + 1):
                contact = before + (x - before) * part / parts - damper
                beyond = math.copysign(max(abs(contact) - gap, 0.0), contact)
                force = beyond * math.sqrt(abs(beyond) / depth)
                move = w * force / (rate * parts)
                damper += math.copysign(min(abs(move), abs(beyond)), move)
            out[i] = force / scale.amplitude
        return out
    return friction_effect(name, law_name, run, scale, {"gap": gap, "w": w, "depth": depth})


@law("backlash", "dahl_behind_clearance", test_only=True)
def backlash_dahl(rng, scale, name, law_name):
    """Dahl's friction that moves only once a clearance is used up, which the other end of it follows."""
    gap, zy = scale.amplitude * log_uniform(rng, 0.03, 0.25), scale.amplitude * log_uniform(rng, 0.02, 0.1)

    def run(z, rate):
        out, stand, f = np.empty_like(z), float(z[0]), 0.0
        for i, x in enumerate(z.tolist()):
            moved = max(x - gap, min(x + gap, stand)) - stand
            stand += moved
            in_contact = abs(x - stand) > gap * (1.0 - 1e-9)  # at rest, too: friction holds there
            f = f + moved * (1.0 - math.copysign(1.0, moved) * f / zy) if in_contact else 0.0
            f = max(-zy, min(zy, f))
            out[i] = f / scale.amplitude
        return out
    return friction_effect(name, law_name, run, scale, {"gap": gap, "zy": zy})


EFFECTS = tuple(k for k in LAWS if not k.startswith("unknown:"))
UNKNOWN = tuple(k for k in LAWS if k.startswith("unknown:"))


def draw(rng, scale, effect, test_set, registry=LAWS):
    """An Effect of that name; held-back laws in the test set only."""
    makers = [(n, m) for n, m, held_back in registry[effect] if test_set or not held_back]
    return makers[int(rng.integers(len(makers)))][1](rng, scale)


def available(effects, test_set):
    return [e for e in effects if any(test_set or not held_back for _, _, held_back in LAWS[e])]
