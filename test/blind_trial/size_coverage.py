#!/usr/bin/python3
# Computes how often the 95 % interval of the size of an effect contains the true size, on new benches. Their laws have
# another form than the fitted ones. The true size is the number that the listed law would need.
"""Coverage of sizes. Usage: size_coverage.py FOLDER --diagnose PATH --replay PATH [--benches 60] [--seed 2] [--jobs 1]
Prints, for each kind and for all kinds, how many sizes of named effects lie in their interval. Benches that already
exist in FOLDER with their report are not made again.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess

import numpy as np

from replayed import force_along, write_log

RATE = 250.0
SECONDS = 20.0
TIME = np.arange(0.0, SECONDS, 1.0 / RATE)
STIFFNESS = 1.2e6  # of the base component [N/m]; sizes are of this order
SHEET_ERROR = 0.1  # standard deviation of the data sheet's numbers, equal to its tolerance
SHEET = """components:
  bush:
    model: maxwell
    specification:
      static_stiffness: {:.6g}
      dynamic_stiffness: {:.6g}
      nominal_frequency: 4
      break_frequency: {:.6g}
"""


def motions(rng):
    """Return the displacements of the logs [m]. The last log is held out."""
    fade = np.clip(np.minimum(TIME, SECONDS - TIME) / 0.5, 0.0, 1.0)

    def sines(largest):
        parts = [a * np.sin(2 * np.pi * f * TIME + p) for a, f, p in
                 zip((1.2, 0.8, 0.5, 0.25), rng.uniform(0.8, 1.25, 4) * (0.5, 2.1, 5.3, 11.0), rng.uniform(0, 6.28, 4))]
        total = sum(parts) * fade
        return largest * total / np.abs(total).max()
    sweep = 0.9e-3 * np.sin(2 * np.pi * np.cumsum(np.geomspace(0.2, 15.0, TIME.size)) / RATE) * fade
    hold = np.interp(TIME, [0, 1, 10, 10.5, 15, 16, 20], np.array([0, 2, 2, -1.5, -1.5, 0, 0]) * 1e-3)
    return {"sines": sines(2.4e-3), "sweep": sweep, "hold": hold, "unseen": sines(2.2e-3)}


# ---- laws: (rng) -> {size: truth}, and either an added force or a function of the motion or of the force ------------

def dahl(rng):
    """Friction whose slope falls with another power than that of any fitted law."""
    force, slip, power = rng.uniform(120, 300), rng.uniform(0.03e-3, 0.2e-3), rng.uniform(0.7, 1.4)
    # By Masing's rule, the displacement from a reversal at the limit to zero force is half of that from rest.
    half = 0.5 * slip * (np.log(2.0) if abs(power - 1) < 1e-9 else (1 - 2.0 ** (1 - power)) / (power - 1))

    def law(z):
        out, h = np.empty_like(z), 0.0
        for i, step in enumerate(np.diff(z, prepend=z[0]) / slip):
            sign, parts = np.sign(step), 1 + int(abs(step) * 8)
            for _ in range(parts):
                h += step / parts * max(0.0, 1.0 - sign * h) ** power
            out[i] = h = min(1.0, max(-1.0, h))
        return force * out
    return {"force_in_largest_loop": force, "displacement": half}, law, None


def stop(rng):
    """A rubber stop whose force is a power of the depth."""
    gap, power = rng.uniform(1.0e-3, 1.6e-3), rng.uniform(1.1, 1.9)
    most = rng.uniform(0.4, 1.0) * 1500.0

    def law(z):
        depth = np.maximum(np.abs(z) - gap, 0.0) / (2.4e-3 - gap)
        return most * np.sign(z) * depth ** power
    return {"gap": gap}, law, None


def spectrum(low, high, total):
    """Closely spaced Maxwell elements in a band, with exact steps."""
    rates = 2 * np.pi * np.geomspace(low, high, 9)

    def law(z):
        out = np.zeros_like(z)
        for rate in rates:
            decay, q = np.exp(-rate / RATE), 0.0
            for i, step in enumerate(np.diff(z, prepend=z[0])):
                q = decay * q + total / rates.size * step * (1 - decay) / (rate / RATE)
                out[i] += q
        return out
    return law


def relaxation(rng):
    """Relaxation that is slower than the element of the base, so that the base's values cannot imitate it."""
    total = rng.uniform(0.15, 0.35) * STIFFNESS
    low = rng.uniform(0.1, 0.2)
    return {"stiffness": total}, spectrum(low, 6.0 * low, total), None


def creep(rng):
    slope = rng.uniform(0.06, 0.15) * STIFFNESS
    low, high = 1.0 / (2 * np.pi * 100.0), 1.0 / (2 * np.pi * 0.3)
    return {"stiffness_per_decade": slope}, spectrum(low, high, slope * np.log10(high / low)), None


def mass(rng):
    """A fixture on a slightly flexible joint, whose resonance is far above the frequencies of the motion."""
    m, resonance = rng.uniform(8.0, 25.0), 2 * np.pi * rng.uniform(60.0, 100.0)

    def law(z):
        f = np.fft.rfftfreq(z.size, 1.0 / RATE)
        w = 2 * np.pi * f
        return np.fft.irfft(-m * w**2 / (1 - (w / resonance) ** 2 + 0.1j * w / resonance) * np.fft.rfft(z) *
                            (f < 40.0), z.size)
    return {"mass": m}, law, None


def play(rng):
    """Free play between rounded faces."""
    gap, rounding = rng.uniform(0.05e-3, 0.15e-3), rng.uniform(0.1, 0.4)
    width = rounding * gap
    return {"gap": gap}, "play", lambda z: z + 0.5 * (np.hypot(z - gap, width) - np.hypot(z + gap, width))


def delay(rng):
    """A second-order filter of the force. Its delay at low frequencies is the true value."""
    late = rng.uniform(2e-3, 5e-3)
    rate = 2.0 / late
    return {"delay": late}, "filter", lambda f: np.fft.irfft(
        np.fft.rfft(f) / (1 + 2j * np.pi * np.fft.rfftfreq(f.size, 1 / RATE) / rate) ** 2, f.size)


KINDS = {"friction": dahl, "bump_stop": stop, "relaxation": relaxation, "creep": creep, "inertia": mass,
         "free_play": play, "time_delay": delay}


def write_bench(folder, kind, rng, replay):
    os.makedirs(folder, exist_ok=True)
    values = np.array([1e6, 1.3e6, 3.0])
    sheet = values * rng.normal(1.0, SHEET_ERROR, 3)
    while sheet[1] < 1.05 * sheet[0]:  # repeat while the model has no solution
        sheet = values * rng.normal(1.0, SHEET_ERROR, 3)
    for name, numbers in (("true", values), ("component", sheet)):
        with open(f"{folder}/{name}.yaml", "w", encoding="utf-8") as file:
            file.write(SHEET.format(*numbers))
    truth, law, other = KINDS[kind](rng)
    for name, z in motions(rng).items():
        force = force_along(replay, f"{folder}/true.yaml", "bush", TIME, other(z) if law == "play" else z, 12)
        if law == "filter":
            force = other(force)
        elif law != "play":
            force = force + law(z)
        force = force + 0.005 * force.std() * rng.standard_normal(force.size) + rng.normal(0.0, 10.0)
        z = z + 0.5e-6 * rng.standard_normal(z.size)
        write_log(f"{folder}/{name}.csv", (TIME, z, force), 7)
    with open(f"{folder}/truth.json", "w", encoding="utf-8") as file:
        json.dump({"kind": kind, "sizes": truth}, file)


def run(folder, number, kind, options):
    if not os.path.exists(f"{folder}/report/report.json"):
        write_bench(folder, kind, np.random.default_rng([options.seed, number]), options.replay)
        command = [options.diagnose, "--config", f"{folder}/component.yaml", "--threads", "1", "--log"]
        command += [f"{folder}/{name}.csv" for name in ("sines", "sweep", "hold")]
        subprocess.run(command + ["--hold-out", f"{folder}/unseen.csv", "--output", f"{folder}/report"], check=False,
                       capture_output=True)
    with open(f"{folder}/truth.json", encoding="utf-8") as file:
        truth = json.load(file)
    with open(f"{folder}/report/report.json", encoding="utf-8") as file:
        return truth, json.load(file)


def sizes(truth, report):
    """Return (name, true size, reported size) of each size that the report states for the effect."""
    if truth["kind"] not in report["effects"]:
        return []
    found = {s["name"]: s for s in report["effect_sizes"] if s["owner"] == truth["kind"]}
    out = []
    for name, value in truth["sizes"].items():
        size = next((found[n] for n in (name, "total_" + name) if n in found), None)
        if size is not None:
            out.append((name, value, size))
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--diagnose", required=True)
    parser.add_argument("--replay", required=True)
    parser.add_argument("--benches", type=int, default=60)
    parser.add_argument("--seed", type=int, default=2)
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    kinds = [list(KINDS)[i % len(KINDS)] for i in range(options.benches)]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        done = list(pool.map(lambda i: run(f"{options.folder}/bench_{i:03d}", i, kinds[i], options),
                             range(options.benches)))
    held = {}
    for number, (truth, report) in enumerate(done):
        for name, value, size in sizes(truth, report):
            low, high = size["interval_95"]
            held.setdefault(truth["kind"], []).append(low <= value <= high)
            print(f"bench_{number:03d} {truth['kind']:18} {name:22} {value:12.5g} {low:12.5g} to {high:12.5g} "
                  f"{'' if low <= value <= high else 'missed'}")
        if not sizes(truth, report):
            print(f"bench_{number:03d} {truth['kind']:18} told as {report['verdict']} {report['effects']}")
    every = [h for kind in held.values() for h in kind]
    for kind, hits in [*held.items(), ("pooled", every)]:
        print(f"{kind:18} {sum(hits)} of {len(hits)}: {100.0 * np.mean(hits) if hits else 0.0:.0f} %")


if __name__ == "__main__":
    main()
