# The laws of the effects of a virtual rig, one or more per effect. Some of them have the form that the diagnosis fits:
# sliders, Prony, dead zone, linear stop, ramp, mass, offset, delay.
"""Laws of effects. `LAWS[effect]` is a list of functions that draw an Effect from (rng, scale)."""
import dataclasses
import math

import numpy as np
from scipy.signal import butter, fftconvolve, lfilter
from scipy.special import erf

from .effect import Effect

LAWS = {}


def law(effect, name):
    """Register a function that draws a law of an effect."""
    def register(maker):
        def named(rng, scale):
            return dataclasses.replace(maker(rng, scale), name=effect, law=name)
        LAWS.setdefault(effect, []).append(named)
        return maker
    return register


def log_uniform(rng, low, high):
    return float(np.exp(rng.uniform(math.log(low), math.log(high))))


def each(function):
    """Return the function of a parallel law from a function of one log."""
    return lambda z, rate: [function(x, rate) for x in z]


# ---- friction: rate independent, from a law in the path of the displacement ------------------------------------------

FRICTION_RATE = 1000.0


def on_friction_grid(function):
    """Run a scalar loop at up to 1 kHz, with linear interpolation in between."""
    def run(z, rate):
        skip = max(1, int(round(rate / FRICTION_RATE)))
        out = []
        for x in z:
            coarse = function(x[::skip], rate / skip)
            n = np.arange(len(x))
            out.append(coarse if skip == 1 else np.interp(n, n[::skip], coarse))
        return out
    return run


def friction_effect(function, scale, parameters):
    return Effect("parallel", on_friction_grid(function), 1.2 * scale.stiffness * scale.amplitude, parameters)


def slip_length(rng, scale):
    return scale.amplitude * log_uniform(rng, 0.03, 0.4)


def in_small_steps(slope, length, limit=math.inf):
    """Return a friction force over its limit, from its slope `slope(h, step)`. Steps are at most length/4."""
    def run(z, rate):
        out, h = np.empty_like(z), 0.0
        for i, step in enumerate((np.diff(z, prepend=z[0]) / length).tolist()):
            parts = 1 + int(abs(step) * 4.0)
            step /= parts
            for _ in range(parts):
                h += step * slope(h, step)
            h = min(limit, max(-limit, h))
            out[i] = h
        return out
    return run


@law("friction", "bouc_wen")
def bouc_wen(rng, scale):
    zy, n, beta = slip_length(rng, scale), rng.uniform(1.0, 2.2), rng.uniform(0.5, 0.85)

    def slope(h, step):
        return 1.0 - abs(h) ** n * (beta * (1.0 if step * h > 0.0 else -1.0) + 1.0 - beta)
    return friction_effect(in_small_steps(slope, zy), scale, {"zy": zy, "n": n, "beta": beta})


@law("friction", "dahl")
def dahl(rng, scale):
    zy, power = slip_length(rng, scale), rng.uniform(0.6, 1.6)

    def slope(h, step):
        return max(0.0, 1.0 - math.copysign(1.0, step) * h) ** power
    return friction_effect(in_small_steps(slope, zy, 1.0), scale, {"zy": zy, "power": power})


@law("friction", "coulomb_finite_stiffness")
def coulomb(rng, scale):
    zy = slip_length(rng, scale)

    def run(z, rate):
        out, h = np.empty_like(z), 0.0
        for i, step in enumerate((np.diff(z, prepend=z[0]) / zy).tolist()):
            h = min(1.0, max(-1.0, h + step))
            out[i] = h
        return out
    return friction_effect(run, scale, {"zy": zy})


@law("friction", "random_iwan")
def random_iwan(rng, scale):
    """Return Jenkins sliders in parallel, whose total force is 1 if all slide."""
    count = int(rng.integers(4, 11))
    thresholds = slip_length(rng, scale) * np.exp(rng.normal(0.0, 0.9, count))
    weights = rng.dirichlet(np.ones(count))

    def run(z, rate):
        skip = max(1, int(round(rate / FRICTION_RATE)))
        coarse = [x[::skip] for x in z]
        steps = np.zeros((max(len(x) for x in coarse), len(z), 1))
        for i, x in enumerate(coarse):
            steps[:len(x), i, 0] = np.diff(x, prepend=x[0])
        state, history = np.zeros((len(z), count)), np.empty(steps.shape[:2])
        shares = weights / thresholds
        for i in range(len(steps)):
            state += steps[i]
            np.clip(state, -thresholds, thresholds, out=state)
            history[i] = state @ shares
        return [np.interp(np.arange(len(x)), np.arange(0, len(x), skip), history[:len(c), i])
                for i, (x, c) in enumerate(zip(z, coarse))]
    return Effect("parallel", run, 1.2 * scale.stiffness * scale.amplitude,
                  {"thresholds": thresholds.tolist(), "weights": weights.tolist()})


# ---- elastic laws: functions of the displacement alone ---------------------------------------------------------------


def elastic_effect(function, scale, parameters, strongest=1.0):
    """Return an effect of `function` of z divided by the largest amplitude, scaled to 1 at that amplitude."""
    size = max(abs(float(function(np.array([1.0]))[0])), abs(float(function(np.array([-1.0]))[0])), 1e-12)
    return Effect("parallel", each(lambda z, rate: function(z / scale.amplitude) / size),
                  strongest * scale.stiffness * scale.amplitude, parameters)


@law("progressive_stiffness", "logarithmic")
def progressive_logarithmic(rng, scale):
    lock = rng.uniform(1.08, 2.0)

    def run(x):
        y = np.minimum(np.abs(x) / lock, 0.95)
        return np.sign(x) * (-np.log1p(-y) - y)
    return elastic_effect(run, scale, {"lock": lock})


@law("progressive_stiffness", "power")
def progressive_power(rng, scale):
    p = rng.uniform(1.6, 4.0)
    return elastic_effect(lambda x: np.sign(x) * np.abs(x) ** p, scale, {"p": p})


@law("progressive_stiffness", "tan")
def progressive_tan(rng, scale):
    s = rng.uniform(0.7, 1.2)

    def run(x):
        y = np.clip(s * x, -1.45, 1.45)
        return np.tan(y) - y
    return elastic_effect(run, scale, {"s": s})


@law("asymmetric_stiffness", "hyperbolic")
def asymmetric_hyperbolic(rng, scale):
    s = rng.uniform(0.15, 0.6) * rng.choice([-1.0, 1.0])
    return elastic_effect(lambda x: x / (1.0 - np.clip(s * x, -0.9, 0.9)) - x, scale, {"s": s})


@law("asymmetric_stiffness", "two_slopes")
def asymmetric_slopes(rng, scale):
    side, soft = rng.choice([-1.0, 1.0]), rng.uniform(0.0, 0.15)
    return elastic_effect(lambda x: 0.5 * (x + side * (np.hypot(x, soft) - soft)), scale,
                          {"side": side, "soft": soft}, 0.7)


def stop_effect(rng, scale, contact, parameters):
    """Return a stop at 55 to 85 % of the largest displacement, on one side or on both sides."""
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
    return elastic_effect(run, scale, parameters, 6.0)


@law("bump_stop", "hertz")
def bump_hertz(rng, scale):
    p = rng.choice([1.0, 1.5, 2.0], p=[0.25, 0.5, 0.25])
    return stop_effect(rng, scale, lambda d: np.maximum(d, 0.0) ** p, {"power": float(p)})


@law("bump_stop", "exponential")
def bump_exponential(rng, scale):
    depth = rng.uniform(0.1, 0.3)
    return stop_effect(rng, scale, lambda d: np.expm1(np.maximum(d, 0.0) / depth), {"depth": depth})


def play_effect(scale, function, parameters):
    # The play is limited so that the motion of every log exceeds it.
    return Effect("play", lambda z, rate, g: [function(x, g) for x in z], 0.6 * scale.least_amplitude, parameters)


@law("free_play", "dead_zone")
def free_play_hard(rng, scale):
    shift = rng.uniform(-0.3, 0.3) if rng.random() < 0.4 else 0.0

    def run(z, g):
        y = z - shift * g
        return y - np.clip(y, -g, g) + (np.clip(-shift * g, -g, g) + shift * g)
    return play_effect(scale, run, {"shift": shift})


@law("free_play", "rounded_dead_zone")
def free_play_rounded(rng, scale):
    r = rng.uniform(0.05, 0.3)

    def run(z, g):
        w = r * g + 1e-15
        return 0.5 * (np.hypot(z - g, w) - np.hypot(z + g, w)) + z
    return play_effect(scale, run, {"rounding": r})


# ---- memory: kernels over the increments of displacement -------------------------------------------------------------


def kernel_effect(kernel, strongest, parameters):
    """Return a force of strength * sum_j kernel(t - t_j) dz_j."""
    def run(z, rate):
        t = (np.arange(len(z)) + 0.5) / rate
        return fftconvolve(np.diff(z, prepend=z[0]), kernel(t, rate))[:len(z)]
    return Effect("parallel", each(run), strongest, parameters)


@law("relaxation", "gruenwald_letnikov")
def relaxation_fractional(rng, scale):
    alpha, tempering = rng.uniform(0.12, 0.55), log_uniform(rng, 1.0, 8.0)

    def run(z, rate):
        j = np.arange(1, len(z))
        weights = np.concatenate([[1.0], np.cumprod((j - 1.0 - alpha) / j)]) * (rate * 0.1) ** alpha
        fade = np.exp(-np.arange(len(z)) / rate / tempering)
        return fftconvolve(z, weights * fade)[:len(z)] - z * np.sum(weights * fade)
    return Effect("parallel", each(run), 1.5 * scale.stiffness, {"alpha": alpha, "tempering": tempering})


@law("relaxation", "kohlrausch")
def relaxation_kohlrausch(rng, scale):
    tau, beta = log_uniform(rng, 0.01, 0.6), rng.uniform(0.35, 0.8)
    return kernel_effect(lambda t, rate: np.exp(-(t / tau) ** beta), 1.5 * scale.stiffness, {"tau": tau, "beta": beta})


@law("relaxation", "prony")
def relaxation_prony(rng, scale):
    count = int(rng.integers(1, 4))
    taus = np.array([log_uniform(rng, 0.006, 1.5) for _ in range(count)])
    weights = rng.dirichlet(np.ones(count) * 2.0)
    return kernel_effect(lambda t, rate: np.exp(-t[:, None] / taus) @ weights, 1.5 * scale.stiffness,
                         {"tau": taus.tolist(), "weight": weights.tolist()})


@law("creep", "log_time")
def creep_log(rng, scale):
    start = rng.uniform(2.0, 6.0)
    return kernel_effect(lambda t, rate: -np.log1p(t / start), 0.35 * scale.stiffness, {"start": start})


@law("creep", "slow_kohlrausch")
def creep_kohlrausch(rng, scale):
    tau, beta = log_uniform(rng, 10.0, 60.0), rng.uniform(0.7, 1.0)
    return kernel_effect(lambda t, rate: np.exp(-(t / tau) ** beta) - 1.0, 0.7 * scale.stiffness,
                         {"tau": tau, "beta": beta})


@law("viscous_damping", "thinning")
def damping_thinning(rng, scale):
    q = 1e-3 if rng.random() < 0.4 else rng.uniform(0.2, 1.0)
    speed = scale.speed
    return Effect("parallel", each(lambda z, rate: speed * (np.arcsinh(q * (np.gradient(z) * rate / speed)) / q)),
                  1.2 * scale.stiffness / (2 * np.pi * 0.5 * scale.top_frequency), {"q": q})


# ---- coupling of rate and amplitude: flow that stress or motion accelerates ----------------------------------------------


@law("rate_amplitude_coupling", "eyring_flow")
def coupling_eyring(rng, scale):
    """Integrate df/dt = dz/dt - w s sinh(f/s) by Heun's method, with f in units of the displacement."""
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
    return friction_effect(run, scale, {"w": w, "s": s})


@law("payne_effect", "kraus_kinetics")
def payne_kraus(rng, scale):
    """A Maxwell element whose stiffness is the share N of intact filler contacts (Kraus, J. Appl. Polym. Sci. 39, 1984).

    dN/dt = ((1 - N) (half/a)^m - N (a/half)^m) / T, where `a` is the largest recent distance from the mean position.
    """
    m, half = rng.uniform(0.45, 0.8), scale.amplitude * log_uniform(rng, 0.05, 0.5)
    time, recent, tau = log_uniform(rng, 0.3, 4.0), log_uniform(rng, 0.5, 2.0), log_uniform(rng, 0.1, 2.0)

    def run(z, rate):
        out, decay, fade = np.empty_like(z), math.exp(-1.0 / (rate * tau)), math.exp(-1.0 / (rate * recent))
        intact, force, mean, amplitude, before = 1.0, 0.0, float(z[0]), 0.0, float(z[0])
        for i, x in enumerate(z.tolist()):
            mean += (x - mean) * 0.5 / (rate * recent)
            amplitude = max(abs(x - mean), amplitude * fade)
            breaks = (max(amplitude, 1e-3 * half) / half) ** m
            speed = (breaks + 1.0 / breaks) / time
            settled = 1.0 / (1.0 + breaks * breaks)
            intact = settled + (intact - settled) * math.exp(-speed / rate)
            force = decay * force + intact * (x - before)
            before, out[i] = x, force / scale.amplitude
        return out
    return friction_effect(run, scale, {"m": m, "half": half, "time": time, "recent": recent, "tau": tau})


# ---- softening and heating: factors on the specimen's force ----------------------------------------------------------


def running_peaks(z, training):
    """Return the largest past |z| at each sample. It carries over between training logs, but not to others."""
    out, past = [], 0.0
    for i, x in enumerate(z):
        start = past if i < training else 0.0
        out.append(np.maximum(np.maximum.accumulate(np.abs(x)), start))
        past = float(out[-1][-1])
    return out


def factor_effect(factors, strongest, parameters):
    """Return an effect from `factors(z, elastic, rest, rate)`, the loss of stiffness at strength 1 in each log."""
    def run(z, elastic, rest, rate, strength):
        losses = factors(z, elastic, rest, rate)
        return [(1.0 - strength * x) * (a + b) for x, a, b in zip(losses, elastic, rest)]
    return Effect("factor", run, strongest, parameters)


@law("stress_softening", "ogden_roxburgh")
def softening_ogden_roxburgh(rng, scale):
    m, b = log_uniform(rng, 0.02, 0.2), rng.uniform(0.0, 0.4)
    top = 0.5 * scale.amplitude**2

    def factors(z, elastic, rest, rate):
        out = []
        for x, peak in zip(z, running_peaks(z, scale.training)):
            energy, past = 0.5 * x**2 / top, 0.5 * peak**2 / top
            out.append(erf((past - energy) / (m + b * past)))
        return out
    return factor_effect(factors, 0.5, {"m": m, "b": b})


@law("stress_softening", "cyclic_damage")
def softening_damage(rng, scale):
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
    return factor_effect(factors, 0.6, {"cycles": cycles, "shape": shape})


def temperatures(force, z, rate, tau_fast, tau_slow, share):
    """Return the temperature rise of a two-node body that the loss heats, from 0 at the start of each log up to 1."""
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


@law("self_heating", "two_nodes_linear")
def heating_linear(rng, scale):
    """Elastic force falls in proportion to the temperature, all other force by a factor more."""
    fast, slow, share = rng.uniform(6.0, 25.0), rng.uniform(60.0, 240.0), rng.uniform(0.3, 0.8)
    extra = rng.uniform(1.0, 1.8)

    def run(z, elastic, rest, rate, strength):
        force = [a + b for a, b in zip(elastic, rest)]
        for _ in range(2):
            warm = temperatures(force, z, rate, fast, slow, share)
            force = [a * np.maximum(1.0 - strength * w, 0.1) + b * np.maximum(1.0 - strength * extra * w, 0.1)
                     for a, b, w in zip(elastic, rest, warm)]
        return force
    return Effect("factor", run, 0.45, {"tau_fast": fast, "tau_slow": slow, "share": share, "loss_factor": extra})


# ---- the rig ---------------------------------------------------------------------------------------------------------


@law("series_compliance", "hardening_joint")
def series_hardening(rng, scale):
    e = rng.uniform(0.0, 0.3)
    top = scale.stiffness * scale.amplitude
    return Effect("mount", lambda f, s: s * f / scale.stiffness * (1.0 - e * np.tanh((f / top) ** 2)),
                  0.45, {"hardening": e})


@law("lift_off", "rough_seat")
def contact_rough(rng, scale):
    """An unglued seat in series with the specimen. Its rough faces separate gradually: the opening grows with the
    logarithm of the force (Greenwood).

    While it is open, a guide of 1/strength - 1 times the stiffness holds the specimen, at strength 1 none. The fixed
    point of the step is the law of the seat: for smooth faces, force and opening are >= 0, and one of them is 0.
    """
    roughness = scale.amplitude * log_uniform(rng, 0.002, 0.02)

    def run(z, inner, force, s):
        guide, w = scale.stiffness * (1.0 / s - 1.0), s * roughness
        ahead = force + guide * (inner - z)
        step = ahead / (2.0 * scale.stiffness + guide)  # stiffer than the specimen in both directions
        return z + scale.side * (w * np.logaddexp(0.0, scale.side * (inner - step - z) / w))
    return Effect("contact", run, 1.0, {"roughness": roughness, "side": scale.side})


@law("inertia", "rigid_mass")
def inertia_rigid(rng, scale):
    return Effect("added", each(lambda z, rate: np.gradient(np.gradient(z)) * rate**2),
                  scale.stiffness / (2 * np.pi * 0.6 * scale.top_frequency) ** 2, {})


def shifted(x, samples):
    """Return x delayed by a number of samples, which may be a fraction. Before its start, x is at rest."""
    n = np.arange(len(x), dtype=float)
    return np.interp(n - samples, n, x, left=x[0])


@law("time_delay", "late_displacement")
def delay_displacement(rng, scale):
    return Effect("displacement", lambda z, rate, s: [shifted(x, s * rate) for x in z], 0.012, {})


@law("time_delay", "late_force")
def delay_force(rng, scale):
    return Effect("transducer", lambda f, rate, s: [shifted(x, s * rate) for x in f], 0.012, {})


def filtered(force, rate, numerator, denominator):
    """Apply an analogue filter (coefficients in s) at any rate to logs that were constant before their start."""
    out = []
    for x in force:
        n = len(x) + 2048
        s = 2j * np.pi * np.fft.rfftfreq(n, 1.0 / rate)
        response = np.polyval(numerator, s) / np.polyval(denominator, s)
        out.append(x[0] + np.fft.irfft(np.fft.rfft(x - x[0], n) * response, n)[:len(x)])
    return out


@law("time_delay", "butterworth_2")
def delay_butterworth(rng, scale):
    def run(force, rate, s):
        return filtered(force, rate, *butter(2, math.sqrt(2.0) / s, analog=True))
    return Effect("transducer", run, math.sqrt(2.0) / (2 * np.pi * 1.8 * scale.top_frequency), {})


def added_logs(maker, scale, parameters, strongest=0.5):
    """Return forces that are drawn once per log, as functions of time that can be evaluated at any rate."""
    shares = [maker(n) for n in scale.lengths]

    def run(z, rate):
        skip = int(round(scale.rate / rate))
        return [share[::skip][:len(x)] for share, x in zip(shares, z)]
    return Effect("added", run, strongest * scale.force, parameters)


@law("force_offset", "constant")
def offset_constant(rng, scale):
    sign = rng.choice([-1.0, 1.0])
    return added_logs(lambda n: np.full(n, sign), scale, {"sign": sign})


def unit(x):
    return (x - x[0]) / max(float(np.std(x)), 1e-30)


@law("force_drift", "ramp")
def drift_ramp(rng, scale):
    sign = rng.choice([-1.0, 1.0])
    spread = rng.uniform(0.0, 0.4)
    return added_logs(
        lambda n: sign * (1.0 + spread * rng.normal()) * np.arange(n) / scale.rate / 15.0, scale,
                      {"spread": spread})


@law("force_drift", "random_walk")
def drift_walk(rng, scale):
    return added_logs(lambda n: unit(np.cumsum(rng.standard_normal(n))), scale, {})


@law("force_drift", "one_over_f")
def drift_pink(rng, scale):
    slope = rng.uniform(1.2, 2.0)

    def maker(n):
        f = np.fft.rfftfreq(n, 1.0 / scale.rate)
        f[0] = np.inf
        spectrum = f ** (-0.5 * slope) * np.exp(2j * np.pi * rng.random(len(f))) * (f < 2.0)
        return unit(np.fft.irfft(spectrum, n))
    return added_logs(maker, scale, {"slope": slope})


# ---- hydraulic mounts: a column of fluid between two chambers --------------------------------------------------------


@law("fluid_inertia", "stiffening_chamber")
def stiffening_chamber(rng, scale):
    """A column of fluid q'' + 2 d w q' = w^2 f, with the force f = x (1 + cube x^2) of the chamber and x = z - q
    divided by the amplitude. The chamber stiffens under pressure."""
    cube = rng.uniform(0.05, 0.4)
    w, d = 2 * np.pi * scale.top_frequency * log_uniform(rng, 0.25, 0.8), rng.uniform(0.08, 0.4)

    def chamber(x):
        return x * (1.0 + cube * min(x * x, 9.0))

    def run(z, rate):
        parts = max(1, int(math.ceil(8.0 * w / rate)))
        h, out = 1.0 / (rate * parts), np.empty_like(z)
        q, v, before = 0.0, 0.0, float(z[0])
        start = before
        for i, x in enumerate(z.tolist()):
            for part in range(1, parts + 1):
                force = chamber((before + (x - before) * part / parts - start - q) / scale.amplitude)
                v += h * w * (w * force - 2.0 * d * v)
                q += h * scale.amplitude * v
            out[i] = chamber((x - start - q) / scale.amplitude)
            before = x
        return out
    return Effect("parallel", each(run), 2.0 * scale.stiffness * scale.amplitude, {"cube": cube, "w": [w], "d": [d]})


# ---- effects that are not in the list -------------------------------------------------------------------------------


@law("unknown:load_cell_saturation", "soft_clip")
def saturation(rng, scale):
    p = rng.uniform(6.0, 16.0)
    top = 4.0 * scale.force

    def run(force, rate, s):
        limit = top / (8.0 * s + 1e-9)
        return [x / (1.0 + np.abs(x / limit) ** p) ** (1.0 / p) for x in force]
    return Effect("transducer", run, 1.0, {"p": p})


@law("unknown:mains_hum", "harmonics")
def hum(rng, scale):
    f, shares = rng.normal(50.0, 0.02), rng.dirichlet(np.ones(3))

    def maker(n):
        t = np.arange(n) / scale.rate
        depth, beat = rng.uniform(0.0, 0.6), rng.uniform(0.03, 0.3)
        tone = sum(w * np.sin(2 * np.pi * (i + 1) * f * t + rng.uniform(0, 6.28)) for i, w in enumerate(shares))
        return tone * (1.0 + depth * np.sin(2 * np.pi * beat * t))
    return added_logs(maker, scale, {"frequency": f}, 0.8)


@law("unknown:stick_slip", "bursts_at_reversal")
def stick_slip(rng, scale):
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
    return Effect("added", logs, 2.0 * scale.force, {"frequency": f, "decay": decay})


@law("unknown:cross_talk", "other_axis")
def cross_talk(rng, scale):
    f, width = rng.uniform(0.5, 12.0), rng.uniform(0.1, 0.5)

    def maker(n):
        g = np.fft.rfftfreq(n, 1.0 / scale.rate)
        spectrum = np.exp(-0.5 * ((g - f) / (width * f)) ** 2) * np.exp(2j * np.pi * rng.random(len(g)))
        x = np.fft.irfft(spectrum, n)
        return x / np.std(x)
    return added_logs(maker, scale, {"frequency": f, "width": width}, 0.6)


# ---- friction behind a clearance -------------------------------------------------------------------------------------


@law("backlash", "damper_in_a_hard_joint")
def backlash_damper(rng, scale):
    """A dashpot behind a clearance with a contact that hardens: F = c dw/dt = k d^1.5 for a contact of depth d."""
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
    return friction_effect(run, scale, {"gap": gap, "w": w, "depth": depth})


EFFECTS = tuple(k for k in LAWS if not k.startswith("unknown:"))
UNKNOWN = tuple(k for k in LAWS if k.startswith("unknown:"))


def draw(rng, scale, effect):
    """Draw one of the laws of an effect."""
    makers = LAWS[effect]
    return makers[int(rng.integers(len(makers)))](rng, scale)
