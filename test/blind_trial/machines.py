#!/usr/bin/python3
# Cases of real machines of which people know what is at work: their logs with a spring and a dashpot for a model.
# Half of the machines are for fitting numbers, half for judging.
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
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from virtual_rig import implant  # noqa: E402


@dataclasses.dataclass
class Machine:
    """Logs of one machine, or a table with its component file, and what is at work in it."""

    data: str        # pattern below the folder of the data
    effects: tuple   # one of these has to be named first
    also: tuple      # may be named besides; anything else is an effect too many
    why: str         # by how it was made and tested, whatever a model says
    rig: str         # machines of one rig depend on each other
    config: str = ""  # of a table


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
    "seal": Machine("rod_seal/*.csv", ("friction", "force_offset"), ("viscous_damping",), *SEAL),
    "x_ring": Machine("seals/x_ring_*.csv", ("friction", "force_offset"), ("viscous_damping",), *SEAL),
    "damper": Machine("mr_damper/low_*.csv", ("friction", "force_offset"), ("viscous_damping",), *DAMPER),
    "energised_damper": Machine("mr_damper/high_*.csv", ("friction", "force_offset"), ("viscous_damping",), *DAMPER),
    "silverbox": Machine("silverbox/*.csv", ("inertia",),
                         ("progressive_stiffness", "asymmetric_stiffness", "viscous_damping", "force_offset"),
                         "a mass on a spring with a cubic part, a little damping and an offset, as a circuit", "silverbox"),
}
JUDGE = {
    "friction_damper_20": Machine("friction_damper/*20*.csv", ("friction", "backlash"), (), *CLEARANCE),
    "friction_damper_70": Machine("friction_damper/*70*.csv", ("friction", "backlash"), (), *CLEARANCE),
    "friction_pair": Machine("friction_pair/*.csv", ("friction",), (), "two dry bodies rub against each other",
                             "friction_pair"),
    "damper_run_4_1": Machine("mr_damper/sine_4_1*.csv", ("friction", "force_offset"), ("viscous_damping",), *DAMPER),
    "damper_run_4_2": Machine("mr_damper/sine_4_2*.csv", ("friction", "force_offset"), ("viscous_damping",), *DAMPER),
    "lip_seal": Machine("seals/lip_seal_*.csv", ("friction", "force_offset"), ("viscous_damping",), *SEAL),
    "dma_mid": Machine("dma_temperature/mid.csv", ("temperature",), (), *POLYMER, "dma_temperature/mid.yaml"),
    "dma_narrow": Machine("dma_temperature/narrow.csv", ("temperature",), (), *POLYMER, "dma_temperature/narrow.yaml"),
}
COMPONENT_OF_TABLES = "c"  # in their component files
HALVES = {"fit": FIT, "judge": JUDGE}


def guess_yaml(name, base):
    """Spring and dashpot as a data sheet that is a guess; without dashpot next to none."""
    damping = 1e-3 if base.c0 > 0.0 else 1e-4
    frequency = damping * base.k0 / (math.pi * base.c0) if base.c0 > 0.0 else 1.0
    numbers = {"dynamic_stiffness": base.k0, "nominal_frequency": frequency, "relative_damping": damping}
    lines = ["components:", f"  {name}:", "    model: kelvin_voigt", "    specification:", "      tolerance: guess"]
    return "\n".join(lines + [f"      {key}: {float(value)!r}" for key, value in numbers.items()]) + "\n"


def write(name, machine, data, output, labels):
    """The case in OUTPUT/NAME, its label beside; False where the data are missing."""
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
        logs = tuple(os.path.relpath(path, data) for path in paths)
        base = implant.Measured(implant.Machine("", logs, (), True, ())).base
        with open(os.path.join(folder, "component.yaml"), "w", encoding="utf-8") as file:
            file.write(guess_yaml(name, base))
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
    parser.add_argument("--data", default=implant.data_folder(),
                        help="folder of the measured logs (default: RUBBER_SUSPENSION_DATA, or data/ of the package)")
    arguments = parser.parse_args()
    os.environ["RUBBER_SUSPENSION_DATA"] = arguments.data  # where implant.Measured reads
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
