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
    """Logs of one machine, and what is at work in it by how it was made and tested."""

    logs: str        # pattern below the folder of the data
    effects: tuple   # one of these has to be named first
    also: tuple      # may be named besides; anything else is an effect too many


FIT = {
    # Secant stiffness falls with amplitude and with history; loops stiffen towards their tips.
    "bearing": Machine("hdrb/*.csv", ("friction", "stress_softening"), ("progressive_stiffness",)),
    # Force falls under a constant displacement; a film that is pulled one way has no friction to speak of.
    "film": Machine("adhesive_film/shear_relaxation_*.csv", ("relaxation", "creep"),
                    ("progressive_stiffness", "asymmetric_stiffness")),
    # Force falls by 15 to 67 % under a constant displacement, and rises steeply at the largest strain.
    "film_cyclic": Machine("film_cyclic/*.csv", ("relaxation", "creep"),
                           ("progressive_stiffness", "asymmetric_stiffness", "bump_stop")),
    # Pressure times area, and the friction of the seal.
    "seal": Machine("rod_seal/*.csv", ("friction", "force_offset"), ("viscous_damping",)),
    # The fluid yields, the gas accumulator adds a constant force.
    "damper": Machine("mr_damper/low_*.csv", ("friction", "force_offset"), ("viscous_damping",)),
    "energised_damper": Machine("mr_damper/high_*.csv", ("friction", "force_offset"), ("viscous_damping",)),
}
JUDGE = {
    "friction_damper_20": Machine("friction_damper/*20*.csv", ("friction", "backlash"), ()),
    "friction_damper_70": Machine("friction_damper/*70*.csv", ("friction", "backlash"), ()),
    "friction_pair": Machine("friction_pair/*.csv", ("friction",), ()),
    "damper_run_4_1": Machine("mr_damper/sine_4_1*.csv", ("friction", "force_offset"), ("viscous_damping",)),
    "damper_run_4_2": Machine("mr_damper/sine_4_2*.csv", ("friction", "force_offset"), ("viscous_damping",)),
}
HALVES = {"fit": FIT, "judge": JUDGE}


def guess_yaml(name, base):
    """Spring and dashpot as a data sheet that is a guess; without dashpot next to none."""
    damping = 1e-3 if base.c0 > 0.0 else 1e-4
    frequency = damping * base.k0 / (math.pi * base.c0) if base.c0 > 0.0 else 1.0
    numbers = {"dynamic_stiffness": base.k0, "nominal_frequency": frequency, "relative_damping": damping}
    lines = ["components:", f"  {name}:", "    model: kelvin_voigt", "    specification:", "      tolerance: guess"]
    return "\n".join(lines + [f"      {key}: {float(value)!r}" for key, value in numbers.items()]) + "\n"


def write(name, machine, data, output, labels):
    """The case in OUTPUT/NAME, its label beside; False where the logs are missing."""
    paths = sorted(glob.glob(os.path.join(data, machine.logs)))
    if not paths:
        return False
    logs = tuple(os.path.relpath(path, data) for path in paths)
    measured = implant.Measured(implant.Machine("", logs, (), True, ()))
    folder = os.path.join(output, name)
    os.makedirs(folder, exist_ok=True)
    for path in paths:
        shutil.copy(path, folder)
    with open(os.path.join(folder, "component.yaml"), "w", encoding="utf-8") as file:
        file.write(guess_yaml(name, measured.base))
    with open(os.path.join(folder, "case.json"), "w", encoding="utf-8") as file:
        json.dump({"component": name, "logs": [os.path.basename(path) for path in paths], "hold_out": []}, file,
                  indent=1)
    with open(os.path.join(labels, name + ".json"), "w", encoding="utf-8") as file:
        json.dump({"case": name, "set": "machines", "kind": "machine", "effects": machine.effects,
                   "also": machine.also, "unknown": None}, file, indent=1)
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
        print(name if found else f"{name}: no log {machine.logs} below {arguments.data}", flush=True)
    if not written:
        sys.exit("machines.py: no cases")


if __name__ == "__main__":
    main()
