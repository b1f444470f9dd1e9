# Errors that a bench adds to a log: offsets, a recording that starts in motion, spikes, coloured noise, gain, delay and
# held values.
"""Faults of a bench, applied to finished logs."""
import numpy as np

# Values for a `size` of 1. Sizes of 0.5 and 2 give half and twice as much.
NUISANCES = {
    "zeros": 0.03,          # share of the range of either channel, new in each log
    "running_start": 0.10,  # share of the log that is cut off at its beginning, so that it starts in motion
    "spikes": 3,            # samples per log, of 3 to 10 standard deviations, in either channel
    "pink": 0.005,          # standard deviation of 1/f noise, relative to that of the force
    "gain": 0.003,          # relative error of the force sensor, equal in all logs
    "delay": 0.25,          # share of the time step; late or early, new in each log (a common delay is an effect)
    "held": 0.002,          # share of the force samples that repeat the previous sample, in runs of 5 to 20
}


def apply(logs, names, size, rng):
    """Return the logs with these faults, and a description of the faults for the label."""
    unknown = [name for name in names if name not in NUISANCES]
    if unknown:
        raise ValueError(f"no fault of a bench: {unknown}; known are {sorted(NUISANCES)}")
    done = {"size": size, "faults": list(names)}
    common = {"gain": 1.0 + rng.choice([-1.0, 1.0]) * NUISANCES["gain"] * size}
    out = []
    for kind, z, f in logs:
        z, f = z.copy(), f.copy()
        for name in names:
            z, f = APPLY[name](z, f, size, rng, common)
        out.append((kind, z, f))
    return out, done


def running_start(z, f, size, rng, common):
    """Cut off the beginning of the log, up to the first fast motion after a share `running_start` of it."""
    earliest = int(NUISANCES["running_start"] * size * len(z) * rng.uniform(0.5, 1.0))
    speed = np.abs(np.gradient(z))
    fast = np.flatnonzero(speed[earliest:len(z) // 2] > np.sqrt(np.mean(speed**2)))
    start = earliest + (int(fast[0]) if len(fast) else 0)
    return z[start:], f[start:]


def zeros(z, f, size, rng, common):
    share = NUISANCES["zeros"] * size
    return z + rng.uniform(-share, share) * np.ptp(z), f + rng.uniform(-share, share) * np.ptp(f)


def spikes(z, f, size, rng, common):
    for _ in range(max(1, int(round(NUISANCES["spikes"] * size)))):
        channel = f if rng.random() < 0.7 else z
        channel[rng.integers(len(channel))] += rng.choice([-1.0, 1.0]) * rng.uniform(3.0, 10.0) * np.std(channel)
    return z, f


def pink(z, f, size, rng, common):
    return z, f + NUISANCES["pink"] * size * np.std(f) * pink_noise(rng, len(f))


def pink_noise(rng, n):
    """Return noise with a standard deviation of 1 and a 1/f spectrum down to the length of the log."""
    spectrum = np.fft.rfft(rng.standard_normal(n))
    k = np.arange(len(spectrum))
    spectrum[1:] /= np.sqrt(k[1:])
    spectrum[0] = 0.0
    noise = np.fft.irfft(spectrum, n)
    return noise / np.std(noise)


def gain(z, f, size, rng, common):
    return z, f * common["gain"]


def delay(z, f, size, rng, common):
    late = rng.uniform(-1.0, 1.0) * NUISANCES["delay"] * size
    n = np.arange(len(f))
    return z, np.interp(n - late, n, f)


def held(z, f, size, rng, common):
    left = int(NUISANCES["held"] * size * len(f))
    while left > 0:
        run = int(rng.integers(5, 21))
        start = int(rng.integers(1, len(f) - run))
        f[start:start + run] = f[start - 1]
        left -= run
    return z, f


APPLY = {"zeros": zeros, "running_start": running_start, "spikes": spikes, "pink": pink, "gain": gain, "delay": delay,
         "held": held}
