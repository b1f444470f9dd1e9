#!/usr/bin/python3
# Benches without a missing effect: the model describes each component exactly, and only its data sheet is wrong. With
# --gain, the gain of the force sensor is wrong too, and the errors of the sheet are smaller.
"""Cases of wrong data sheets. Usage: wrong_sheets.py OUTPUT --replay PATH [--cases 60] [--seed 21] [--gain] [--jobs 1]

Writes cases and labels in the format of generate.py, for run.py and judge_again.
"""
import argparse
import concurrent.futures
import json
import os
import subprocess

import numpy as np

from replayed import force_along, write_log
from virtual_rig.base import sheet_factor

RATE = 500.0
TIME = np.arange(0.0, 20.0, 1.0 / RATE)
# Numbers of the true data sheet of each model.
STIFFNESSES = {"static_stiffness": 0.95e6, "dynamic_stiffness": 1.3e6}
OPERATING_POINT = {"nominal_frequency": 5.0, "nominal_amplitude": 1e-3}
MODELS = {
    "multi_maxwell": {**STIFFNESSES, "maximum_stiffness": 1.45e6, "high_frequency": 24.0},
    "multi_maxwell of 3": {**STIFFNESSES, "maximum_stiffness": 1.45e6, "high_frequency": 24.0},
    "maxwell": {**STIFFNESSES, "maximum_stiffness": 1.45e6},
    "maxwell_dashpot": {**STIFFNESSES, "break_frequency": 8.0, "relative_damping": 0.27},
}
# Relative standard deviations of the numbers of a sheet. The operating point, and damping taken from a loop, have no error.
OFF = {"static_stiffness": 0.1, "dynamic_stiffness": 0.1, "maximum_stiffness": 0.1, "high_frequency": 0.05}
OFF_BESIDE_GAIN = 0.3  # factor on all of OFF if the gain is wrong
GAINS = (1.03, 1.5)  # or their reciprocals
NOISE, ZERO, JITTER = 0.005, 0.01, 0.5e-6  # relative to the RMS force; the same; of the displacement [m]


def write_component(path, model, values):
    name, _, elements = model.partition(" of ")
    lines = ["components:", "  bush:", f"    model: {name}", "    specification:"]
    lines += [f"      {key}: {value:.6g}" for key, value in {**values, **OPERATING_POINT}.items()]
    lines += [f"      maxwell_elements: {elements}"] if elements else []
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def motions(rng):
    """Return the displacements of the logs [m]. The last log is held out."""
    fade = np.clip(np.minimum(TIME, TIME[-1] - TIME) / 0.5, 0.0, 1.0)
    tones = zip((1.2, 0.8, 0.5, 0.3), (0.5, 2.1, 5.3, 11.0), rng.uniform(0.0, 2.0 * np.pi, 4))
    sines = sum(a * np.sin(2.0 * np.pi * f * TIME + phase) for a, f, phase in tones)
    sweep = 0.9 * np.sin(2.0 * np.pi * np.cumsum(np.geomspace(0.2, 18.0, TIME.size)) / RATE)
    hold = np.interp(TIME, [0, 1, 8, 8.5, 14, 15, 20], [0, 2, 2, -1.5, -1.5, 0, 0])
    frequency = np.fft.rfftfreq(TIME.size, 1.0 / RATE)
    shape = np.where((frequency > 0.2) & (frequency < 15.0), 1.0 / np.maximum(frequency, 0.2), 0.0)
    road = np.fft.irfft(shape * (rng.standard_normal(frequency.size) + 1j * rng.standard_normal(frequency.size)), TIME.size)
    return {"sines": 1e-3 * sines * fade, "sweep": 1e-3 * sweep * fade, "hold": 1e-3 * hold,
            "road": 0.8e-3 * road / road.std() * fade}


def has_solution(replay, component, displacement):
    try:
        force_along(replay, component, "bush", TIME, displacement)
    except subprocess.CalledProcessError:
        return False
    return True


def write_case(number, options):
    rng = np.random.default_rng([options.seed, number, int(options.gain)])
    model = list(MODELS)[number % len(MODELS)]
    name = f"case_{number:03d}"
    folder = os.path.join(options.output, name)
    os.makedirs(folder, exist_ok=True)
    logs, config = motions(rng), f"{folder}/component.yaml"
    write_component(config, model, MODELS[model])
    forces = {log: force_along(options.replay, config, "bush", TIME, z) for log, z in logs.items()}
    share = OFF_BESIDE_GAIN if options.gain else 1.0
    while True:  # repeat until the sheet has a solution
        sheet = {key: value * sheet_factor(rng, share * OFF.get(key, 0.0)) for key, value in MODELS[model].items()}
        write_component(config, model, sheet)
        if has_solution(options.replay, config, logs["road"]):
            break
    gain = np.exp(rng.choice([-1, 1]) * rng.uniform(*np.log(GAINS))) if options.gain else 1.0
    for log, z in logs.items():
        size = forces[log].std()
        force = forces[log] + size * (NOISE * rng.standard_normal(TIME.size) + ZERO * rng.standard_normal())
        write_log(f"{folder}/{log}.csv", (TIME, z + JITTER * rng.standard_normal(TIME.size), gain * force))
    with open(f"{folder}/case.json", "w", encoding="utf-8") as file:
        json.dump({"component": "bush", "logs": [f"{log}.csv" for log in list(logs)[:-1]], "hold_out": ["road.csv"]}, file)
    with open(os.path.join(options.output + "_labels", name + ".json"), "w", encoding="utf-8") as file:
        json.dump({"case": name, "set": "wrong_sheets", "seed": options.seed, "unknown": None, "bench": "clean",
                   "kind": "single" if options.gain else "parameter_error",
                   "effects": ["sensor_gain"] if options.gain else [],
                   "share": {"sensor_gain": abs(gain - 1.0)} if options.gain else {},
                   "gap": {"wanted": 0.0}, "noise": {"floor": NOISE}}, file)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", help="folder of the cases; labels go into OUTPUT_labels")
    parser.add_argument("--replay", required=True, help="the program `replay`")
    parser.add_argument("--cases", type=int, default=60)
    parser.add_argument("--seed", type=int, default=21)
    parser.add_argument("--gain", action="store_true", help="a wrong gain besides, and a sheet that is off by 3 %%")
    parser.add_argument("--jobs", type=int, default=1)
    options = parser.parse_args()
    options.output = options.output.rstrip("/")
    os.makedirs(options.output + "_labels", exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        list(pool.map(lambda number: write_case(number, options), range(options.cases)))
    print(f"{options.cases} cases in {options.output}")


if __name__ == "__main__":
    main()
