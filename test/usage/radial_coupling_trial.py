#!/usr/bin/python3
"""Diagnoses x of bushes, some of which have a force that depends on the radius of x and y in a form of no element.

Usage: radial_coupling_trial.py FOLDER_OF_THE_COMMANDS [--benches 20] [--others 30] [--seed 1]

Each bench has a spring, two Maxwell elements, sliders with a round limit and noise, and is measured in three logs in
which x, y and z move independently. On coupled benches the radial force stiffens by a power, a hyperbolic sine, a
tangent or a chain that locks, times a smooth random factor of 10 to 30 %; half of their models have no stiffening, the
others stiffen in each direction separately. Other benches lack another effect or none. The trial fails if
radial_coupling is named first on fewer than nine in ten coupled benches, or at all on another bench.
"""
import argparse
import concurrent.futures
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

SAMPLES, STEP, LOGS = 3000, 0.004, 3
LARGEST = 2e-3  # amplitude of x [m]
OTHERS = ("nothing", "friction", "progressive_stiffness", "relaxation", "by z", "round friction", "bump_stop", "viscous_damping",
          "stiffening of y", "values")
FORMS = {
    "power": lambda s, p: s ** (2.0 + 2.0 * p),
    "sinh": lambda s, p: np.sinh((1.0 + 2.0 * p) * s) - (1.0 + 2.0 * p) * s,
    "tan": lambda s, p: np.tan((0.8 + 0.5 * p) * s) - (0.8 + 0.5 * p) * s,
    "locking": lambda s, p: -np.log1p(-s / (1.15 + p)) - s / (1.15 + p),
}


def motion(rng, amplitude):
    """Return a motion of up to some 6 Hz, whose frequency and amplitude change slowly."""
    time = STEP * np.arange(SAMPLES)
    frequency = 3.5 + 2.5 * np.sin(rng.uniform(0.6, 1.0) * time + rng.uniform(0.0, 6.0))
    envelope = 0.55 + 0.45 * np.sin(rng.uniform(0.9, 1.4) * time + rng.uniform(0.0, 6.0))
    return amplitude * envelope * np.sin(2.0 * np.pi * np.cumsum(frequency) * STEP + rng.uniform(0.0, 6.0)) * np.minimum(1.0, time / 0.2)


def maxwell(z, stiffness, frequency):
    decay = np.exp(-2.0 * np.pi * frequency * STEP)
    gain = stiffness * (1.0 - decay) / (2.0 * np.pi * frequency * STEP)
    force = np.zeros_like(z)
    for i in range(1, len(z)):
        force[i] = decay * force[i - 1] + gain * (z[i] - z[i - 1])
    return force


def sliders(path, yields, stiffness, is_round):
    """Return the force of sliders in parallel, whose limits are round, or separate for each direction."""
    stretch, force = np.zeros((len(yields), 2)), np.zeros_like(path)
    for i in range(1, len(path)):
        stretch += path[i] - path[i - 1]
        size = np.linalg.norm(stretch, axis=1, keepdims=True) if is_round else np.abs(stretch)
        stretch *= np.minimum(1.0, yields[:, None] / np.maximum(size, 1e-30))
        force[i] = stiffness @ stretch
    return force


def radial_form(rng):
    """Return a name and h(r) of the force h(r) (x, y), without unit: a form times a smooth random factor."""
    name = rng.choice(sorted(FORMS))
    p, error = rng.uniform(), rng.uniform(0.1, 0.3)
    waves, phases = rng.uniform(1.0, 5.0, 3), rng.uniform(0.0, 2.0 * np.pi, 3)
    largest = 1.7 * LARGEST

    def secant(r):
        s = np.minimum(np.maximum(r / largest, 1e-9), 1.0)
        factor = 1.0 + error * sum(np.cos(w * s + q) for w, q in zip(waves, phases)) / np.sqrt(1.5)
        return FORMS[name](s, p) * np.maximum(factor, 0.1) / s
    return secant, name


class Bench:
    """A random bush, its model as the manufacturer would write it, and three logs."""

    def __init__(self, rng, kind):
        self.kind, self.form = kind, ""
        k = 10.0 ** rng.uniform(5.7, 6.6)
        branches = [(rng.uniform(0.1, 0.25) * k, rng.uniform(0.7, 1.5)), (rng.uniform(0.1, 0.25) * k, rng.uniform(6.0, 12.0))]
        rubs = kind == "round friction" or (kind != "friction" and rng.uniform() < 0.5)
        yields = LARGEST * np.geomspace(0.01, 0.3, 6)
        limit = rng.uniform(0.04, 0.1) * k * LARGEST
        slider_stiffness = limit / len(yields) / yields
        paths = [np.column_stack([motion(rng, LARGEST), motion(rng, rng.uniform(0.6, 1.4) * LARGEST), motion(rng, LARGEST)])
                 for _ in range(LOGS)]
        forces = []
        for path in paths:
            force = k * path
            for stiffness, frequency in branches:
                force += np.column_stack([maxwell(z, stiffness, frequency) for z in path.T])
            if rubs or kind == "friction":
                force[:, :2] += sliders(path[:, :2], yields, slider_stiffness, kind in ("coupled", "round friction"))
            forces.append(force)
        size = rng.uniform(0.08, 0.25) * rms(forces)
        added = [np.zeros_like(path[:, :2]) for path in paths]
        own = ""
        if kind == "coupled":
            secant, self.form = radial_form(rng)
            knows = rng.uniform() < 0.5
            self.form += ", each direction known" if knows else ""
            for path, more in zip(paths, added):
                more += secant(np.hypot(path[:, 0], path[:, 1]))[:, None] * path[:, :2]
            alone = [secant(np.abs(path[:, :2])) * path[:, :2] for path in paths]
            scale = size / rms([m - a * knows for m, a in zip(added, alone)])
            added = [scale * more for more in added]
            if knows:
                points = np.linspace(0.0, 2.0 * LARGEST, 41)[1:]
                own = table(points, scale * secant(points) * points)
        else:
            column = 1 if kind == "stiffening of y" else 0
            for path, more in zip(paths, added):
                more[:, column] += lacking(kind, path)
            if np.any(added[0]):
                added = [size / rms(added, column) * more for more in added]
        noise = 0.005 * rms(forces)
        self.logs = [(path, force + np.column_stack([more, np.zeros(SAMPLES)]) + rng.normal(0.0, noise, path.shape))
                     for path, force, more in zip(paths, forces, added)]
        off = (lambda: rng.uniform(0.85, 1.15)) if kind == "values" else (lambda: rng.uniform(0.97, 1.03))
        listed = f"{{type: spring, stiffness: {k * off()}}}"
        for stiffness, frequency in branches:
            listed += f", {{type: maxwell, stiffness: {stiffness * off()}, break_frequency: {frequency * off()}}}"
        if rubs:
            listed += (f", {{type: iwan_table, yield_displacement: {list(map(float, yields))}, "
                       f"stiffness: {list(map(float, slider_stiffness))}}}")
        directions = "".join(f"      {d}: {{model: elements, elements: [{listed}{own if d != 'z' else ''}]}}\n" for d in "xyz")
        self.model = "components:\n  bush:\n    directions:\n" + directions


def lacking(kind, path):
    """Return the force in x or y that the model lacks, without unit."""
    x, y, z = path.T / LARGEST
    if kind in ("progressive_stiffness", "stiffening of y"):
        s = 2.0 * (y if kind == "stiffening of y" else x)
        return np.sinh(s) - s
    if kind == "relaxation":
        return maxwell(x, 1.0, 3.0)
    if kind == "viscous_damping":
        return np.gradient(x)
    if kind == "by z":
        return x * z
    if kind == "bump_stop":
        return np.sign(x) * np.maximum(np.abs(x) - 0.6, 0.0)
    return np.zeros_like(x)


def rms(parts, column=0):
    return float(np.sqrt(np.mean(np.concatenate(parts)[:, column] ** 2)))


def table(points, forces):
    both = np.concatenate([-points[::-1], [0.0], points])
    force = np.concatenate([-forces[::-1], [0.0], forces])
    return f", {{type: spring_table, displacement: {list(map(float, both))}, force: {list(map(float, force))}, monotone: 0}}"


def diagnose(programs, seed, kind):
    """Diagnose a bench, and return it with the verdict, the effects named in x, and the gaps."""
    bench = Bench(np.random.default_rng(seed), kind)
    with tempfile.TemporaryDirectory(prefix="radial.") as scratch:
        folder = pathlib.Path(scratch)
        (folder / "bush.yaml").write_text(bench.model)
        names = []
        for i, (path, force) in enumerate(bench.logs):
            names.append(folder / f"log_{i}.csv")
            columns = np.column_stack([STEP * np.arange(SAMPLES), path, np.zeros((SAMPLES, 3)), force, np.zeros((SAMPLES, 3))])
            np.savetxt(names[-1], columns, delimiter=",", fmt="%.9g", comments="",
                       header="time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm")
        answer = subprocess.run([programs / "diagnose", "--config", folder / "bush.yaml", "--log", *names, "--output", folder / "report",
                                 "--direction", "x", "--threads", "1"], capture_output=True, text=True, check=False, timeout=900)
        if answer.returncode != 0:
            return bench, "failed", [answer.stderr.strip()], 0.0, 0.0
        report = json.loads((folder / "report/report.json").read_text())["directions"][0]
        played = subprocess.run([programs / "replay", "--config", folder / "report/augmented.yaml", "--log", names[0], "--output",
                                 folder / "played.csv"], capture_output=True, text=True, check=False, timeout=900)
        verdict = report["verdict"] if played.returncode == 0 else "augmented.yaml: " + played.stderr
        return bench, verdict, report["effects"], report["gap"]["as_configured"], report["gap"]["augmented"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("programs", type=lambda name: pathlib.Path(name).resolve())
    parser.add_argument("--benches", type=int, default=20, help="that are coupled")
    parser.add_argument("--others", type=int, default=30, help="that are not")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=1)
    options = parser.parse_args()
    kinds = ["coupled"] * options.benches + [OTHERS[i % len(OTHERS)] for i in range(options.others)]
    first = named = failed = 0
    with concurrent.futures.ThreadPoolExecutor(options.workers) as pool:
        jobs = [pool.submit(diagnose, options.programs, 1000 * options.seed + i, kind) for i, kind in enumerate(kinds)]
        for i, job in enumerate(jobs):
            bench, verdict, effects, before, after = job.result()
            coupled = bench.kind == "coupled"
            first += coupled and effects[:1] == ["radial_coupling"]
            named += not coupled and "radial_coupling" in effects
            failed += verdict not in ("none", "parameter_error", "named", "partly", "confounded", "unknown")
            print(f"{i:3d}  {bench.kind:22s} {bench.form:32s} {verdict:16s} {', '.join(effects):40s} {before:.4f} {after:.4f}", flush=True)
    print(f"radial_coupling first on {first} of {options.benches}, named on {named} of {options.others} others")
    return 0 if first >= 0.9 * options.benches and named == 0 and failed == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
