# Computes gaps of the component files of a report with `replay`: on the logs of the report, and on further logs of the
# rig. The further logs are stored with the sealed label (generate.py --further) and unknown to the diagnosis.
"""Gaps of component files, computed by `replay`."""
import json
import math
import os
import subprocess
import tempfile

import numpy as np

from virtual_rig.case import RATE, TRAINING, HOLD_OUT

SAME_GAP = 0.01        # relative tolerance between two computations of a gap
UNITS = {"N": 1.0, "kN": 1e3, "MN": 1e6}


def replay(binary, config, component, log):
    """Return the forces [N] of a component on a log, from `replay`."""
    with tempfile.TemporaryDirectory() as scratch:
        out = os.path.join(scratch, "out.csv")
        subprocess.run([binary, "--config", config, "--component", component, "--log", log, "--output", out],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return np.loadtxt(out, delimiter=",", skiprows=1, usecols=2)


def write_log(path, columns, digits=9):
    """Write a log of time [s], displacement [m], and optionally force [N] and temperature [degC]."""
    names = ("time_s", "displacement_m", "force_N", "temperature_degC")[:len(columns)]
    np.savetxt(path, np.column_stack(columns), f"%.{digits}g", ",", header=",".join(names), comments="")


def force_along(binary, config, component, time, displacement, digits=9):
    """Return the forces [N] along a motion. Raises subprocess.CalledProcessError if the data sheet has no solution."""
    with tempfile.TemporaryDirectory() as scratch:
        motion = os.path.join(scratch, "motion.csv")
        write_log(motion, (time, displacement), digits)
        return replay(binary, config, component, motion)


def read_json(path):
    """Return the content of a JSON file, or None if it is missing or invalid."""
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


class Case:
    """A sealed label and the report on its case."""

    def __init__(self, label, cases, report):
        self.label, self.folder, self.report_folder = label, os.path.join(cases, label["case"]), report
        self.report = read_json(os.path.join(report, "report.json"))
        self.run = read_json(os.path.join(report, "run.json"))
        self.info = read_json(os.path.join(self.folder, "case.json"))
        self.further = None  # gaps on further logs, or None before they are computed

    def file(self, name):
        """Return the path of a component file of the report, or None if it is missing."""
        path = os.path.join(self.report_folder, name + ".yaml")
        return path if os.path.isfile(path) else None

    def hold_out_gap(self, binary, config):
        """Return the gap of a component file on the held-out logs, as recorded."""
        logs = [os.path.join(self.folder, log) for log in self.info["hold_out"]]
        forces = [(replay(binary, config, self.info["component"], log), recorded_force(log)) for log in logs]
        return gap_of([(rig - force, rig) for force, rig in forces])


def recorded_force(path):
    """Return the force [N] of a log as the rigs write it."""
    with open(path, encoding="utf-8") as file:
        unit = file.readline().strip().split(",")[2].split("_")[1]
    return np.loadtxt(path, delimiter=",", skiprows=1, usecols=2) * UNITS[unit]


def gap_of(parts):
    """Return the gap over several logs, given as [(difference, force)]."""
    return math.sqrt(np.mean([np.mean(d**2) / np.var(f) for d, f in parts]))


def is_found_again(binary, case):
    """Return True if `replay` of augmented.yaml gives the reported gap on the held-out logs, None without that file."""
    config = case.file("augmented")
    if config is None or not case.info["hold_out"]:
        return None
    try:
        gap = case.hold_out_gap(binary, config)
    except (subprocess.CalledProcessError, OSError, ValueError):
        return False
    return abs(gap - case.report["gap_as_recorded"]["augmented"]) <= SAME_GAP * gap


# ---- further logs ----------------------------------------------------------------------------------------------------


def re_estimated(file, component, ratios):
    """Return a label's component `file` with its values times the report's ratios (as JSON, which is YAML)."""
    used = set()

    def times(key, value):
        used.add(key)
        return value * ratios.get(key, 1.0)
    if file["elements"]:
        entries = [dict({k: times(f"{kind}[{i}].{k}", v) for k, v in values.items()}, type=kind)
                   for i, (kind, values) in enumerate(file["elements"])]
        content = {"model": "elements", "elements": entries}
    else:
        content = {"model": file["model"], "specification": {k: times(k, v) for k, v in file["specification"].items()}}
    if set(ratios) - used:
        raise ValueError(f"the report re-estimates {sorted(set(ratios) - used)}, which the file does not have")
    return json.dumps({"components": {component: content}})


def write_further(sealed, ambient, folder):
    """Write the further logs; return [(path, force [N])]. `ambient` is the temperature if it is the effect."""
    stored, out = np.load(sealed), []
    for i in range(sum(name.startswith("further_") and name.endswith("_force") for name in stored.files)):
        z, force = (stored[f"further_{i + 1}_{what}"].astype(float) for what in ("displacement", "force"))
        columns = [np.arange(len(z)) / RATE, z, force]
        if ambient:
            log = TRAINING + HOLD_OUT + i
            columns.append(ambient["start"][log] + ambient["rise"][log] * np.linspace(0.0, 1.0, len(z)))
        path = os.path.join(folder, f"further_{i + 1}.csv")
        write_log(path, columns)
        out.append((path, force))
    return out


def further_gaps(binary, case, sealed):
    """Return the gaps of {re_estimated, augmented, surrogate} on the further logs, and whether `replay` of the
    re-estimated component gives the reported gap on the held-out logs.

    An offset of the force is removed from each log, as in reports, unless the report names an offset. A drift or a gain
    that is new in each log cannot be predicted. A report that names one has no gap of the augmented component.
    """
    report, component = case.report, case.info["component"]
    ratios = {k: v for k, v in report["own_parameters"]["ratio_to_configured"].items() if v is not None}
    share_of_mean = 0.0 if "force_offset" in report["effects"] else 1.0
    with tempfile.TemporaryDirectory() as scratch:
        configs = {"re_estimated": os.path.join(scratch, "re_estimated.yaml")}
        with open(configs["re_estimated"], "w", encoding="utf-8") as file:
            file.write(re_estimated(case.label["file"], component, ratios))
        configs.update({what: case.file(what) for what in ("augmented", "surrogate") if case.file(what)})
        if {"force_drift", "sensor_gain"} & set(report["effects"]):
            configs.pop("augmented", None)
        logs = write_further(sealed, case.label["parameters"].get("temperature"), scratch)

        def left(config, path, force):
            difference = force - replay(binary, config, component, path)
            return difference - share_of_mean * np.mean(difference), force
        gaps = {what: gap_of([left(config, *log) for log in logs]) for what, config in configs.items()}
        again, stated = case.hold_out_gap(binary, configs["re_estimated"]), report["gap_as_recorded"]["re_estimated"]
        return dict(gaps, same_re_estimated=abs(again - stated) <= SAME_GAP * stated)
