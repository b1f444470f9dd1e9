#!/usr/bin/python3
# Writes measured logs of real machines with known effects as cases. Their model is a spring with a dashpot. Half of the
# machines are for fitting the numbers of the judgement, the other half for evaluating them.
"""Write measured logs of machines with a known cause as cases of a trial."""
import argparse
import dataclasses
import glob
import json
import math
import os
import shutil
import sys

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(variable, "1")

import numpy as np  # noqa: E402
from scipy.signal import savgol_filter  # noqa: E402

UNITS = {"m": 1.0, "mm": 1e-3, "um": 1e-6, "N": 1.0, "kN": 1e3, "MN": 1e6}
PACKAGE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.environ.get("RUBBER_SUSPENSION_DATA") or os.path.join(PACKAGE, "data")


@dataclasses.dataclass
class Machine:
    """Logs of a machine, or a table with its component file, and the effects that act in the machine."""

    data: str        # file pattern in the folder of data
    effects: tuple   # one of these must be named first
    also: tuple      # may be named in addition; any other effect is one too many
    why: str         # evidence from construction and tests, independent of any model
    rig: str         # machines of the same rig are not independent
    config: str = ""  # component file of a table


FRICTION_AND_OFFSET = (("friction", "force_offset"), ("viscous_damping",))
DAMPER = ("the fluid yields, the gas accumulator adds a constant force", "mr_damper")
SEAL = ("pressure times area, and the friction of the seal, which grows with pressure", "rod_seal")
CLEARANCE = ("dry friction of a band, with play in its joints", "friction_damper")
POLYMER = ("the rates follow the temperature, as the shift factors in its repository say", "dma_temperature")

FIT = {
    "bearing": Machine("hdrb/*.csv", ("friction", "stress_softening"), ("progressive_stiffness",),
                       "secant stiffness falls with amplitude and with history; loops stiffen towards their tips",
                       "hdrb"),
    "film": Machine("adhesive_film/shear_relaxation_*.csv", ("relaxation", "creep"),
                    ("progressive_stiffness", "asymmetric_stiffness"),
                    "the force falls under a constant displacement; a film that is pulled one way has no friction to "
                    "speak of", "film"),
    "film_cyclic": Machine("film_cyclic/*.csv", ("relaxation", "creep"),
                           ("progressive_stiffness", "asymmetric_stiffness", "bump_stop"),
                           "the force falls by 15 to 67 % in the holds, and rises steeply at the largest strain; creep is "
                           "relaxation slower than the motion", "film"),
    "seal": Machine("rod_seal/*.csv", *FRICTION_AND_OFFSET, *SEAL),
    "x_ring": Machine("seals/x_ring_*.csv", *FRICTION_AND_OFFSET, *SEAL),
    "damper": Machine("mr_damper/low_*.csv", *FRICTION_AND_OFFSET, *DAMPER),
    "energised_damper": Machine("mr_damper/high_*.csv", *FRICTION_AND_OFFSET, *DAMPER),
    "silverbox": Machine("silverbox/*.csv", ("inertia",),
                         ("progressive_stiffness", "asymmetric_stiffness", "viscous_damping", "force_offset"),
                         "a mass on a spring with a cubic part, a little damping and an offset, as a circuit", "silverbox"),
}
JUDGE = {
    "friction_damper_20": Machine("friction_damper/*20*.csv", ("friction", "backlash"), (), *CLEARANCE),
    "friction_damper_70": Machine("friction_damper/*70*.csv", ("friction", "backlash"), (), *CLEARANCE),
    "friction_pair": Machine("friction_pair/*.csv", ("friction",), (), "two dry bodies rub against each other",
                             "friction_pair"),
    "damper_run_4_1": Machine("mr_damper/sine_4_1*.csv", *FRICTION_AND_OFFSET, *DAMPER),
    "damper_run_4_2": Machine("mr_damper/sine_4_2*.csv", *FRICTION_AND_OFFSET, *DAMPER),
    "lip_seal": Machine("seals/lip_seal_*.csv", *FRICTION_AND_OFFSET, *SEAL),
    "dma_mid": Machine("dma_temperature/mid.csv", ("temperature",), (), *POLYMER, "dma_temperature/mid.yaml"),
    "dma_narrow": Machine("dma_temperature/narrow.csv", ("temperature",), (), *POLYMER, "dma_temperature/narrow.yaml"),
}
COMPONENT_OF_TABLES = "c"  # name of the component in the files of tables
HALVES = {"fit": FIT, "judge": JUDGE}


def read_log(path):
    """Return time [s], displacement [m] and force [N] of a log."""
    with open(path, encoding="utf-8") as file:
        units = [column.split("_")[-1] for column in file.readline().strip().split(",")]
    t, z, f = np.loadtxt(path, delimiter=",", skiprows=1, usecols=(0, 1, 2)).T
    return t, z * UNITS[units[1]], f * UNITS[units[2]]


def spring_and_dashpot(paths):
    """Fit stiffness [N/m], damping [N s/m] and an offset by least squares. The values are rounded to two digits, as a
    user would write them. All logs are resampled to one even grid, and the displacement is smoothed."""
    logs = [read_log(path) for path in paths]
    rate = 1.0 / min(float(np.median(np.diff(t))) for t, _, _ in logs)
    displacement, force, columns = [], [], []
    for t, z, f in logs:
        grid = np.arange(t[0], t[-1] + 0.5 / rate, 1.0 / rate)
        smooth = savgol_filter(np.interp(grid, t, z), 9, 3)
        displacement.append(smooth)
        force.append(np.interp(grid, t, f))
        columns.append(np.stack([smooth, np.gradient(smooth) * rate, np.ones_like(smooth)], axis=1))
    force = np.concatenate(force)
    k, c, _ = np.linalg.lstsq(np.concatenate(columns), force, rcond=None)[0]
    spring = max(k, 0.02 * np.std(force) / np.std(np.concatenate(displacement)))
    return float(f"{spring:.2g}"), float(f"{max(c, 0.0):.2g}")


def guess_yaml(name, stiffness, dashpot):
    """Return the data sheet of a spring and dashpot as a guess. Without a dashpot, the damping is nearly zero."""
    damping = 1e-3 if dashpot > 0.0 else 1e-4
    frequency = damping * stiffness / (math.pi * dashpot) if dashpot > 0.0 else 1.0
    numbers = {"dynamic_stiffness": stiffness, "nominal_frequency": frequency, "relative_damping": damping}
    lines = ["components:", f"  {name}:", "    model: kelvin_voigt", "    specification:", "      tolerance: guess"]
    return "\n".join(lines + [f"      {key}: {float(value)!r}" for key, value in numbers.items()]) + "\n"


def write(name, machine, data, output, labels):
    """Write the case to OUTPUT/NAME with its label. Return False if the data are missing."""
    paths = sorted(glob.glob(os.path.join(data, machine.data)))
    if not paths:
        return False
    folder = os.path.join(output, name)
    os.makedirs(folder, exist_ok=True)
    for path in paths:
        shutil.copy(path, folder)
    names = [os.path.basename(path) for path in paths]
    case = {"component": name, "logs": names, "hold_out": []}
    if machine.config:
        case = {"component": COMPONENT_OF_TABLES, "logs": [], "hold_out": [], "table": names[0]}
        shutil.copy(os.path.join(data, machine.config), os.path.join(folder, "component.yaml"))
    else:
        with open(os.path.join(folder, "component.yaml"), "w", encoding="utf-8") as file:
            file.write(guess_yaml(name, *spring_and_dashpot(paths)))
    with open(os.path.join(folder, "case.json"), "w", encoding="utf-8") as file:
        json.dump(case, file, indent=1)
    with open(os.path.join(labels, name + ".json"), "w", encoding="utf-8") as file:
        json.dump({"case": name, "set": "machines", "kind": "machine", "effects": machine.effects,
                   "also": machine.also, "why": machine.why, "rig": machine.rig, "unknown": None}, file, indent=1)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("output", help="folder of the cases; labels are in OUTPUT_labels")
    parser.add_argument("--half", choices=list(HALVES), default="fit", help="fit: numbers; judge: once per version")
    parser.add_argument("--data", default=DATA,
                        help="folder of the measured logs (default: RUBBER_SUSPENSION_DATA, or data/ of the package)")
    arguments = parser.parse_args()
    labels = arguments.output.rstrip("/") + "_labels"
    os.makedirs(labels, exist_ok=True)
    written = 0
    for name, machine in HALVES[arguments.half].items():
        found = write(name, machine, arguments.data, arguments.output, labels)
        written += found
        print(name if found else f"{name}: nothing at {machine.data} below {arguments.data}", flush=True)
    if not written:
        sys.exit("machines.py: no cases")


if __name__ == "__main__":
    main()
