# Writes virtual fleets: components of a type that scatter. Only the labels state the true values. The rigs are those of
# the blind trial, which share no code with the package. The same seed gives the same files.
"""Virtual fleets: logs of many test pieces of one type, a jobs file for `campaign`, and labels."""
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

SECONDS = 12.0    # duration of each log
RATE = 250.0      # sampling rate of the logs [Hz]
FINE = 4          # samples of the rig's grid per sample of a log
TOP_FREQUENCY = 10.0  # highest frequency of the motion [Hz]
NOISE = 0.003     # noise of the force, relative to the standard deviation of the force
KINDS = ("sines", "sweep", "holds", "track")
SCATTER = {"static_stiffness": 0.04, "dynamic_stiffness": 0.02, "maximum_stiffness": 0.02}
# These are standard deviations of logarithms. That of the static stiffness (hardness of the rubber) changes all three.
# The others are added, so that chance alone does not make a dynamic stiffness smaller than the static one.

# The fleets. `seed` is part of the seed of their draws. `scatter` is in units of SCATTER, `wrong` and `size` are
# logarithms, `gap` is the gap after re-estimation, `compliance` that of the rig [m/N], `stiffness` the static stiffness
# [N/m]. Types with the same `rig` share one. Those on the rig "good" differ only in the other entries.
SOFT_RIG = {"rig": "soft", "scatter": 1.0, "compliance": 2.5e-8}
FLEETS = {
    "scatter": {"seed": 1, "rig": "good", "scatter": 1.0},
    "wrong_values": {"seed": 2, "rig": "good", "scatter": 1.0, "wrong": dict.fromkeys(SCATTER, 0.10)},
    "effect_in_some": {"seed": 4, "rig": "good", "scatter": 1.0, "effect": "friction", "share": 0.4, "gap": 0.08},
    "outliers": {"seed": 6, "rig": "good", "scatter": 0.5, "outliers": 0.15, "size": 0.25},
    "soft_rig_soft": {"seed": 7, **SOFT_RIG, "stiffness": 1e6},
    "soft_rig_stiff": {"seed": 9, **SOFT_RIG, "stiffness": 5e6},
}


def specification_of(fleet, rng):
    """Return the numbers of the component file of a type [SI]."""
    static = FLEETS[fleet].get("stiffness") or laws.log_uniform(rng, 5e5, 5e6)
    dynamic = static * rng.uniform(1.3, 1.45)
    return {"static_stiffness": float(f"{static:.5g}"), "dynamic_stiffness": float(f"{dynamic:.5g}"),
            "maximum_stiffness": float(f"{dynamic * rng.uniform(1.25, 1.35):.5g}"), "nominal_frequency": 4.0,
            "high_frequency": 25.0, "maxwell_elements": 3}


def piece_of(plan, wrong, specification, rng):
    """Return the specification of a test piece, and the true values: the logarithms of its ratios to the file."""
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
    """Return the effect of a rig with a compliance of `size` [m/N]."""
    return Effect("mount", lambda force, strength: strength * force, size, {}, "series_compliance", "linear")


def programme(rng):
    """Return the displacements in the test of a type. They are equal for all test pieces, as on a test bench."""
    actuator = excitation.Actuator(rng, 2e-3, RATE * FINE)
    actuator.top_frequency = TOP_FREQUENCY
    actuator.smoothing = excitation.butter(2, 45.0 / (0.5 * RATE * FINE))
    return [moving(rng, actuator, kind) for kind in KINDS]


def moving(rng, actuator, kind):
    """Return a log with at least half a second of motion, because the levels of short holds may all be 0."""
    while True:
        with np.errstate(divide="ignore", invalid="ignore"):
            z = excitation.make(rng, actuator, kind, SECONDS)
        if np.count_nonzero(np.abs(np.diff(z[::FINE])) > 1e-3 * actuator.amplitude) > 0.5 * RATE:
            return z


def one(job):
    """Write one test piece and return its label."""
    fleet, number, pieces, seed, output = job
    plan = FLEETS[fleet]
    type_rng = np.random.default_rng(np.random.SeedSequence([seed, 1, plan["seed"], 0]))
    specification = specification_of(fleet, type_rng)
    wrong = plan.get("wrong", {})
    if not wrong:
        type_rng.standard_normal()  # keeps the random draws equal to those of earlier versions
    z = programme(type_rng)
    marked = set(type_rng.permutation(pieces)[:round(plan.get("share", plan.get("outliers", 0.0)) * pieces)].tolist())
    rng = np.random.default_rng(np.random.SeedSequence([seed, 2, plan["seed"], 0, number]))
    piece, logs, base = piece_of(plan, wrong, specification, rng)
    outlier = "outliers" in plan and number in marked
    if outlier:
        factor = plan["size"] * (1.0 if rng.random() < 0.5 else -1.0)
        logs = {name: value + factor for name, value in logs.items()}
        piece = {k: v * math.exp(factor) if k in logs else v for k, v in piece.items()}
        base = bases.from_specification("multi_maxwell", piece)
    has_effect = "effect" in plan and number in marked
    force = measured(plan, base, z, rng, has_effect)
    folder = os.path.join(output, fleet, f"piece_{number:02d}")
    os.makedirs(folder, exist_ok=True)
    with open(os.path.join(folder, "component.yaml"), "w", encoding="utf-8") as file:
        file.write(component_yaml(specification))
    for i, (x, f) in enumerate(zip(z, force)):
        path = os.path.join(folder, f"log_{i + 1}.csv")
        case.write_log(path, RATE, x[::FINE], f, case.UNITS_Z[1], case.UNITS_F[0], None)
    return {"fleet": fleet, "test_piece": f"{fleet}/piece_{number:02d}", "outlier": outlier,
            "effect": plan["effect"] if has_effect else ""}


def measured(plan, base, z, rng, has_effect):
    """Return the forces with noise on the grid of the logs."""
    effects, strengths = [], {}
    if has_effect:
        effects.append(laws.draw(rng, scale_of(base, z), plan["effect"]))
        ruler = Ruler(Rig(base, z, RATE * FINE, effects), FINE)
        strengths[id(effects[0])] = ruler.strength_for(effects[0], plan["gap"], True)[0]
    if "compliance" in plan:
        effects.append(compliance(plan["compliance"]))
        strengths[id(effects[-1])] = plan["compliance"]
    exact = Rig(base, z, RATE * FINE, effects).force(strengths)
    return [f[::FINE] + NOISE * np.std(f) * rng.standard_normal(len(f[::FINE])) for f in exact]


def scale_of(base, z):
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


def generate(pieces, seed, output):
    """Write all fleets with `pieces` test pieces each, and a jobs file. Each fleet is a type, measured on its rig.

    Returns a label for each test piece.
    """
    jobs = [(fleet, number, pieces, seed, output) for fleet in FLEETS for number in range(pieces)]
    with multiprocessing.Pool(2) as pool:
        labels = pool.map(one, jobs, chunksize=1)
    entry = ('  {0}: {{folders: "{0}/piece_*", command: diagnose, config: component.yaml, log: "log_*.csv", type: {0}, '
             'test_rig: {1}}}\n')
    with open(os.path.join(output, "jobs.yaml"), "w", encoding="utf-8") as file:
        file.write("settings: {reports: none}\njobs:\n" +
                   "".join(entry.format(name, plan["rig"]) for name, plan in FLEETS.items()))
    return labels
