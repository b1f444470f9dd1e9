# Motion of the actuator of a virtual rig: sines, sweeps, track-like noise, holds, preloads, triangles. Every log starts
# at rest at zero. The limited bandwidth of the actuator smooths all motion.
"""Displacement programmes [m] on a fine time grid."""
import numpy as np
from scipy.signal import butter, lfilter

KINDS = ("sines", "sweep", "track", "holds", "preloaded_sines", "triangle", "amplitude_sweep", "two_tone")

# Test programmes: kinds of motion and probability. Some do not show all effects, as in real tests.
PROGRAMMES = {
    "rich": (KINDS, 0.42),
    "sines_only": (("sines", "amplitude_sweep", "preloaded_sines"), 0.12),
    "one_amplitude": (("sines", "sweep"), 0.06),
    "track": (("track", "track", "track", "sines", "sweep"), 0.12),
    "static": (("holds", "triangle", "sines"), 0.12),
    "subset": (None, 0.16),
}


class Actuator:
    """Limits of a rig: amplitude [m], amplitude times frequency [m Hz], frequency [Hz], sampling rate [Hz]."""

    def __init__(self, rng, amplitude, rate):
        self.amplitude = amplitude
        self.top_frequency = rng.uniform(12.0, 30.0)
        self.product = amplitude * rng.uniform(2.0, 8.0)
        self.rate = rate
        self.smoothing = butter(2, rng.uniform(45.0, 90.0) / (0.5 * rate))
        self.levels = None

    def limit(self, frequency):
        return np.minimum(self.amplitude, self.product / np.maximum(frequency, 1e-6))

    def level(self, rng):
        """Draw an amplitude as a share of the largest amplitude."""
        if self.levels is not None:
            return float(rng.choice(self.levels))
        return float(np.exp(rng.uniform(np.log(0.1), 0.0)))

    def frequency(self, rng, low=0.2):
        return float(np.exp(rng.uniform(np.log(low), np.log(self.top_frequency))))


def envelope(n, edge):
    """Return a window of n samples with raised-cosine edges of `edge` samples."""
    edge = max(1, min(edge, n // 3))
    window = np.ones(n)
    rise = 0.5 - 0.5 * np.cos(np.pi * np.arange(edge) / edge)
    window[:edge], window[-edge:] = rise, rise[::-1]
    return window


def sines(rng, rig, n, amplitude_scale=1.0):
    """Return blocks of sines with random frequency and amplitude. The last block may repeat the first one."""
    count = int(rng.integers(4, 10))
    length = n // count
    blocks = [(rig.frequency(rng), rig.level(rng)) for _ in range(count)]
    if rng.random() < 0.4:
        blocks[-1] = blocks[0]
    out = np.zeros(n)
    for i, (f, level) in enumerate(blocks):
        f = max(f, 2.0 * rig.rate / length)
        a = min(level * rig.amplitude, rig.limit(f)) * amplitude_scale
        t = np.arange(length) / rig.rate
        out[i * length:(i + 1) * length] = a * np.sin(2 * np.pi * f * t) * envelope(length, int(0.4 * rig.rate))
    return out


def sweep(rng, rig, n):
    low, high = rng.uniform(0.1, 0.5), rig.top_frequency
    f = np.geomspace(low, high, n)
    if rng.random() < 0.3:
        f = f[::-1].copy()
    phase = 2 * np.pi * np.cumsum(f) / rig.rate
    return rig.level(rng) ** 0.5 * rig.limit(f) * np.sin(phase) * envelope(n, int(rig.rate))


def track(rng, rig, n):
    """Return noise in a band. Its amplitude spectrum is a falling power of the frequency."""
    low, high, slope = rng.uniform(0.1, 0.6), rig.top_frequency * rng.uniform(0.4, 1.0), rng.uniform(0.6, 1.8)
    f = np.fft.rfftfreq(n, 1.0 / rig.rate)
    shape = np.zeros_like(f)
    band = (f >= low) & (f <= high)
    shape[band] = f[band] ** -slope
    x = np.fft.irfft(shape * (rng.standard_normal(len(f)) + 1j * rng.standard_normal(len(f))), n)
    x = x / np.max(np.abs(x))
    return rig.amplitude * rng.uniform(0.5, 1.0) * x * envelope(n, int(rig.rate))


def holds(rng, rig, n):
    out, i, level = np.zeros(n), int(0.5 * rig.rate), 0.0
    while i < n:
        target = 0.0 if rng.random() < 0.2 else rng.choice([-1.0, 1.0]) * rig.level(rng) * rig.amplitude
        ramp = int(np.exp(rng.uniform(np.log(0.05), np.log(0.6))) * rig.rate)
        hold = int(rng.uniform(3.0, 14.0) * rig.rate)
        path = np.concatenate([np.linspace(level, target, ramp), np.full(hold, target)])[:n - i]
        out[i:i + len(path)] = path
        i, level = i + len(path), target
    return out


def preloaded_sines(rng, rig, n):
    preload = rng.choice([-1.0, 1.0]) * rng.uniform(0.25, 0.6) * rig.amplitude
    ramp = int(rng.uniform(0.5, 2.0) * rig.rate)
    out = np.full(n, preload)
    out[:ramp] = preload * (0.5 - 0.5 * np.cos(np.pi * np.arange(ramp) / ramp))
    out[ramp:] += sines(rng, rig, n - ramp, rng.uniform(0.3, 0.6))
    return out


def triangle(rng, rig, n):
    out, i = np.zeros(n), int(0.3 * rig.rate)
    while i < n:
        f, a = np.exp(rng.uniform(np.log(0.08), np.log(1.5))), rig.level(rng) * rig.amplitude
        cycles = max(1, int(rng.uniform(4.0, 15.0) * f))
        phase = np.arange(int(cycles / f * rig.rate)) * f / rig.rate
        wave = a * (1.0 - 4.0 * np.abs((phase + 0.25) % 1.0 - 0.5))
        wave = wave[:n - i]
        out[i:i + len(wave)] = wave
        i += len(wave)
    return out


def amplitude_sweep(rng, rig, n):
    f = np.exp(rng.uniform(np.log(0.4), np.log(8.0)))
    a = float(rig.limit(f)) * (1.0 if rig.levels is None else float(np.max(rig.levels)))
    t = np.arange(n) / rig.rate
    shape = np.interp(t / t[-1], [0.0, rng.uniform(0.4, 0.8), 1.0], [0.0, 1.0, 0.05])
    return a * shape * np.sin(2 * np.pi * f * t)


def two_tone(rng, rig, n):
    t = np.arange(n) / rig.rate
    slow, fast = rng.uniform(0.1, 0.6), rng.uniform(4.0, rig.top_frequency)
    a = rng.uniform(0.5, 0.8) * rig.amplitude
    b = min(rng.uniform(0.05, 0.3) * rig.amplitude, float(rig.limit(fast)))
    return (a * np.sin(2 * np.pi * slow * t) + b * np.sin(2 * np.pi * fast * t)) * envelope(n, int(rig.rate))


_MAKERS = {"sines": sines, "sweep": sweep, "track": track, "holds": holds, "preloaded_sines": preloaded_sines,
           "triangle": triangle, "amplitude_sweep": amplitude_sweep, "two_tone": two_tone}


def make(rng, rig, kind, duration):
    """Return the actual motion of the actuator in a log of `duration` [s]."""
    n = int(round(duration * rig.rate))
    command = _MAKERS[kind](rng, rig, n)
    while not np.any(command):  # all holds of a short log may be at zero
        command = _MAKERS[kind](rng, rig, n)
    # Every log has enough motion: its peak is at least a quarter of the largest amplitude.
    command *= max(1.0, 0.25 * rig.amplitude / np.max(np.abs(command)))
    lead = int(0.1 * rig.rate)
    command = np.concatenate([np.zeros(lead), command[:n - lead]])
    return lfilter(*rig.smoothing, command)


def draw_programme(rng, rig, training, hold_out):
    """Return the kinds of the logs, the name of the programme, and a pair of training logs that repeat (or None)."""
    names = list(PROGRAMMES)
    weights = np.array([PROGRAMMES[k][1] for k in names])
    name = str(rng.choice(names, p=weights / weights.sum()))
    kinds = PROGRAMMES[name][0]
    if kinds is None:
        kinds = tuple(rng.choice(KINDS, size=int(rng.integers(2, 5)), replace=False))
    if name == "one_amplitude":
        rig.levels = [float(rng.uniform(0.4, 1.0))]
        rig.product = 100.0 * rig.amplitude
        rig.top_frequency = min(rig.top_frequency, 15.0)
    first = list(rng.permutation(kinds))
    chosen = [str(first[i]) if i < len(first) else str(rng.choice(kinds)) for i in range(training)]
    chosen = [str(k) for k in rng.permutation(chosen)]
    held = [str(rng.choice(chosen)) if rng.random() < 0.8 else str(rng.choice(kinds)) for _ in range(hold_out)]
    repeat = None
    if training > 1 and rng.random() < 0.35:
        source = int(rng.integers(0, training - 1))
        repeat = (source, training - 1)
        chosen[-1] = chosen[source]
    return chosen, held, name, repeat
