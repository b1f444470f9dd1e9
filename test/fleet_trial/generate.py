#!/usr/bin/python3
# Writes virtual fleets: components of one type with scatter between test pieces, whose truth the labels alone know.
# The rigs are those of the blind trial, which share no code with the package. The same seed gives the same files.
"""Generate virtual fleets: logs of many test pieces of one type, a jobs file for `campaign`, and labels."""
import argparse
import json
import math
import multiprocessing
import os
import sys

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(variable, "1")
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "blind_trial"))

import numpy as np  # noqa: E402

from virtual_rig import base as bases  # noqa: E402
from virtual_rig import case, excitation, laws  # noqa: E402
from virtual_rig.effect import Effect, Scale  # noqa: E402
from virtual_rig.rig import Rig, Ruler  # noqa: E402

RATE = 250.0      # of the logs [Hz]
FINE = 4          # samples of the rig's own grid per sample of a log
TOP_FREQUENCY = 10.0  # of the motion [Hz]
NOISE = 0.003     # of the force, as a share of its standard deviation
KINDS = ("sines", "sweep", "holds", "track")
SCATTER = {"static_stiffness": 0.04, "dynamic_stiffness": 0.02, "maximum_stiffness": 0.02}
# Standard deviations of logarithms: that of the static one moves all three (hardness of the rubber), the others are
# steps on top of it, so that no piece has a dynamic stiffness below its static one by chance alone.

# What the fleets of one draw are. `scatter` is in units of SCATTER, `wrong` and `size` are logarithms, `gap` is what the
# effect leaves after re-estimation, `compliance` is that of the rig [m/N], `stiffness` the static one [N/m]. Types of
# the same `rig` are tested on one; the types of the rig "good" differ in nothing but what is said of each.
SOFT, MIDDLE, STIFF = {"stiffness": 1e6}, {"stiffness": 2.2e6}, {"stiffness": 5e6}
ON_SOFT_RIG = {"rig": "soft", "scatter": 1.0, "compliance": 2.5e-8}
ON_GAIN_RIG = {"rig": "gain", "scatter": 1.0, "gain": 0.94}
OWN_VALUES = {"rig": "own", "scatter": 1.0, "own": 0.08}
FLEETS = {
    "exact": {"rig": "good", "gain": 1.003},  # within the tolerance of 0.5 %
    "scatter": {"rig": "good", "scatter": 1.0},
    "wrong_values": {"rig": "good", "scatter": 1.0, "wrong": dict.fromkeys(SCATTER, 0.10)},
    "one_wrong_value": {"rig": "good", "scatter": 0.5, "wrong": {"maximum_stiffness": 0.08}},
    "effect_in_some": {"rig": "good", "scatter": 1.0, "effect": "friction", "share": 0.4, "gap": 0.08},
    "effect_in_all": {"rig": "good", "scatter": 1.0, "effect": "friction", "share": 1.0, "gap": 0.08},
    "outliers": {"rig": "good", "scatter": 0.5, "outliers": 0.15, "size": 0.25},
    "soft_rig_soft": dict(ON_SOFT_RIG, **SOFT),
    "soft_rig_middle": dict(ON_SOFT_RIG, **MIDDLE),
    "soft_rig_stiff": dict(ON_SOFT_RIG, **STIFF),
    "gain_soft": dict(ON_GAIN_RIG, **SOFT),
    "gain_stiff": dict(ON_GAIN_RIG, **STIFF),
    "own_soft": dict(OWN_VALUES, **SOFT),
    "own_middle": dict(OWN_VALUES, **MIDDLE),
    "own_stiff": dict(OWN_VALUES, **STIFF),
}


def specification_of(fleet, rng):
    """What the component file of a type says [SI]."""
    static = FLEETS[fleet].get("stiffness") or laws.log_uniform(rng, 5e5, 5e6)
    dynamic = static * rng.uniform(1.3, 1.45)
    return {"static_stiffness": float(f"{static:.5g}"), "dynamic_stiffness": float(f"{dynamic:.5g}"),
            "maximum_stiffness": float(f"{dynamic * rng.uniform(1.25, 1.35):.5g}"), "nominal_frequency": 4.0,
            "high_frequency": 25.0, "maxwell_elements": 3}


def wrong_of(plan, rng):
    """By how much the type is off, as logarithms."""
    return plan.get("wrong") or dict.fromkeys(SCATTER, plan.get("own", 0.0) * rng.standard_normal())


def piece_of(plan, wrong, specification, rng):
    """A test piece's own specification, and its logarithms over that of the file, which are the truth."""
    for _ in range(1000):
        steps = {name: plan.get("scatter", 0.0) * size * rng.standard_normal() for name, size in SCATTER.items()}
        common = steps["static_stiffness"]
        logs = {name: (common if name == "static_stiffness" else common + step) + wrong.get(name, 0.0)
                for name, step in steps.items()}
        piece = {k: v * math.exp(logs.get(k, 0.0)) if k in logs else v for k, v in specification.items()}
        try:
            return piece, logs, bases.from_specification("multi_maxwell", piece)
        except bases.Unsolvable:
            continue
    raise RuntimeError("no test piece could be drawn")


def compliance(size):
    """The rig gives way by `size` [m/N]."""
    return Effect("mount", lambda force, strength: strength * force, size, {}, "series_compliance", "linear")


def programme(rng, seconds):
    """The displacements of one type's test: the same for each piece, as a test bench runs them."""
    actuator = excitation.Actuator(rng, 2e-3, RATE * FINE)
    actuator.top_frequency = TOP_FREQUENCY
    actuator.smoothing = excitation.butter(2, 45.0 / (0.5 * RATE * FINE))
    return [moving(rng, actuator, kind, seconds) for kind in KINDS]


def moving(rng, actuator, kind, seconds):
    """A log that moves for half a second at least: of short holds, all levels may be drawn at 0."""
    while True:
        with np.errstate(divide="ignore", invalid="ignore"):
            z = excitation.make(rng, actuator, kind, seconds)
        if np.count_nonzero(np.abs(np.diff(z[::FINE])) > 1e-3 * actuator.amplitude) > 0.5 * RATE:
            return z


def one(job):
    """Write one test piece; returns its label."""
    fleet, draw, number, pieces, seconds, seed, output = job
    plan = FLEETS[fleet]
    place = [list(FLEETS).index(fleet), draw]
    type_rng = np.random.default_rng(np.random.SeedSequence([seed, 1, *place]))
    specification = specification_of(fleet, type_rng)
    wrong = wrong_of(plan, type_rng)
    z = programme(type_rng, seconds)
    marked = set(type_rng.permutation(pieces)[:round(plan.get("share", plan.get("outliers", 0.0)) * pieces)].tolist())
    rng = np.random.default_rng(np.random.SeedSequence([seed, 2, *place, number]))
    piece, logs, base = piece_of(plan, wrong, specification, rng)
    outlier = "outliers" in plan and number in marked
    if outlier:
        factor = plan["size"] * (1.0 if rng.random() < 0.5 else -1.0)
        logs = {name: value + factor for name, value in logs.items()}
        piece = {k: v * math.exp(factor) if k in logs else v for k, v in piece.items()}
        base = bases.from_specification("multi_maxwell", piece)
    force, label = measured(plan, base, z, rng, "effect" in plan and number in marked, seconds)
    folder = os.path.join(output, f"{fleet}_{draw}", f"piece_{number:02d}")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "component.yaml"), "w", encoding="utf-8") as file:
        file.write(component_yaml(specification))
    for i, (x, f) in enumerate(zip(z, force)):
        path = os.path.join(folder, f"log_{i + 1}.csv")
        case.write_log(path, RATE, x[::FINE], f, case.UNITS_Z[1], case.UNITS_F[0], None)
    return dict(label, fleet=fleet, draw=draw, number=number, outlier=outlier, specification=specification,
                wrong=wrong, logarithms=logs)


def measured(plan, base, z, rng, has_effect, seconds):
    """Forces with noise on the grid of the logs, and what of the label follows from them."""
    effects, strengths = [], {}
    if has_effect:
        scale = scale_of(base, z, seconds)
        effects.append(laws.draw(rng, scale, plan["effect"]))
        ruler = Ruler(Rig(base, z, RATE * FINE, effects), FINE)
        strengths[id(effects[0])] = ruler.strength_for(effects[0], plan["gap"], True)[0]
    if "compliance" in plan:
        effects.append(compliance(plan["compliance"]))
        strengths[id(effects[-1])] = plan["compliance"]
    exact = [plan.get("gain", 1.0) * f for f in Rig(base, z, RATE * FINE, effects).force(strengths)]
    force = [f[::FINE] + NOISE * np.std(f) * rng.standard_normal(len(f[::FINE])) for f in exact]
    return force, {"effect": plan["effect"] if has_effect else "", "compliance": plan.get("compliance", 0.0),
                   "gain": plan.get("gain", 1.0)}


def scale_of(base, z, seconds):
    rate = RATE * FINE
    peaks = [float(np.max(np.abs(x))) for x in z]
    force = base.force(z, rate)
    return Scale(stiffness=base.k0 + 0.5 * sum(base.k), amplitude=max(peaks), least_amplitude=min(peaks),
                 speed=float(np.sqrt(np.mean([np.mean((np.gradient(x) * rate) ** 2) for x in z]))),
                 force=float(np.mean([np.std(f) for f in force])), top_frequency=12.0, training=len(z),
                 lengths=[len(x) for x in z], rate=rate)


def component_yaml(specification):
    lines = ["components:", "  bush:", "    model: multi_maxwell", "    specification:"]
    return "\n".join(lines + [f"      {k}: {v!r}" for k, v in specification.items()]) + "\n"


def jobs_yaml(names):
    """One entry for each fleet of each draw: a type of its own, on the rig of its kind."""
    entry = ('  {0}: {{folders: "{0}/piece_*", command: diagnose, config: component.yaml, log: "log_*.csv", type: {0}, '
             'test_rig: {1}}}\n')
    rigs = {name: FLEETS[name.rsplit("_", 1)[0]]["rig"] + name[name.rindex("_"):] for name in names}
    return "settings: {reports: none}\njobs:\n" + "".join(entry.format(name, rigs[name]) for name in names)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pieces", type=int, required=True, help="test pieces of each fleet")
    parser.add_argument("--draws", type=int, default=1, help="fleets of each kind")
    parser.add_argument("--seconds", type=float, default=12.0, help="length of each log")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--output", required=True, help="folder of the fleets, with jobs.yaml and labels.json")
    parser.add_argument("--fleet", action="append", choices=list(FLEETS), help="kinds of fleets (default: all)")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    jobs = [(fleet, draw, number, arguments.pieces, arguments.seconds, arguments.seed, arguments.output)
            for fleet in arguments.fleet or FLEETS for draw in range(arguments.draws)
            for number in range(arguments.pieces)]
    with multiprocessing.Pool(arguments.jobs) as pool:
        labels = pool.map(one, jobs, chunksize=1)
    names = list(dict.fromkeys(f"{label['fleet']}_{label['draw']}" for label in labels))
    with open(os.path.join(arguments.output, "jobs.yaml"), "w", encoding="utf-8") as file:
        file.write(jobs_yaml(names))
    with open(os.path.join(arguments.output, "labels.json"), "w", encoding="utf-8") as file:
        json.dump({"seed": arguments.seed, "pieces": labels}, file, indent=1)
    print(f"{len(labels)} test pieces in {len(names)} fleets: {arguments.output}")


if __name__ == "__main__":
    main()
