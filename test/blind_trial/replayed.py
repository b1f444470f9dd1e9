# What `replay` makes of the component files of a report: on logs that the report knows, and on further logs of the rig,
# which lie with the sealed label (generate.py --further) and which no diagnosis has seen.
"""Gaps of component files by `replay`."""
import json
import math
import os
import subprocess
import tempfile

import numpy as np

from virtual_rig.case import RATE, TRAINING, HOLD_OUT

SAME_GAP = 0.01        # relative: replay finds the gap again
UNITS = {"N": 1.0, "kN": 1e3, "MN": 1e6}


def replay(binary, config, component, log):
    """Forces [N] of a component along a log."""
    with tempfile.TemporaryDirectory() as scratch:
        out = os.path.join(scratch, "out.csv")
        subprocess.run([binary, "--config", config, "--component", component, "--log", log, "--output", out],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return np.loadtxt(out, delimiter=",", skiprows=1, usecols=2)


def write_log(path, columns, digits=9):
    """A log of time [s], displacement [m], force [N] and temperature [degC], as far as there are columns."""
    names = ("time_s", "displacement_m", "force_N", "temperature_degC")[:len(columns)]
    np.savetxt(path, np.column_stack(columns), f"%.{digits}g", ",", header=",".join(names), comments="")


def force_along(binary, config, component, time, displacement, digits=9):
    """Forces [N] of a component along a motion. Throws subprocess.CalledProcessError where its sheet has no solution."""
    with tempfile.TemporaryDirectory() as scratch:
        motion = os.path.join(scratch, "motion.csv")
        write_log(motion, (time, displacement), digits)
        return replay(binary, config, component, motion)


def read_json(path):
    """The content of a file; None where there is none, or no JSON."""
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


class Case:
    """A sealed label beside the report on its case."""

    def __init__(self, label, cases, report):
        self.label, self.folder, self.report_folder = label, os.path.join(cases, label["case"]), report
        self.report = read_json(os.path.join(report, "report.json"))
        self.run = read_json(os.path.join(report, "run.json"))
        self.info = read_json(os.path.join(self.folder, "case.json"))
        self.further = None  # gaps on further logs, once they are measured

    def file(self, name):
        """Path of a component file of the report, or None where it has none."""
        path = os.path.join(self.report_folder, name + ".yaml")
        return path if os.path.isfile(path) else None

    def hold_out_gap(self, binary, config):
        """Gap of a component file on the hold-out logs, as recorded."""
        logs = [os.path.join(self.folder, log) for log in self.info["hold_out"]]
        forces = [(replay(binary, config, self.info["component"], log), recorded_force(log)) for log in logs]
        return gap_of([(rig - force, rig) for force, rig in forces])


def recorded_force(path):
    """The force [N] of a log as the rigs write them."""
    with open(path, encoding="utf-8") as file:
        unit = file.readline().strip().split(",")[2].split("_")[1]
    return np.loadtxt(path, delimiter=",", skiprows=1, usecols=2) * UNITS[unit]


def gap_of(parts):
    """The gap of [(difference, force)] over several logs."""
    return math.sqrt(np.mean([np.mean(d**2) / np.var(f) for d, f in parts]))


def is_found_again(binary, case):
    """Whether `replay` of augmented.yaml finds gap_as_recorded.augmented on the hold-out logs; None without the file."""
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
    """The component file (JSON, which is YAML) of a label's `file`, its values times the report's ratios."""
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
    """The sealed further logs as files; returns [(path, force [N])]. `ambient` is the temperature where it is an effect."""
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
    """Gaps on the further logs of {re_estimated, augmented, surrogate} as far as the report has them; and whether the
    re-estimated component is the report's: `replay` of it finds the gap that the report gives on the hold-out logs.

    A zero of the force is taken out of each log, as reports do, unless the report names an offset. A drift or a gain
    that is new in each log cannot be predicted: a report that names one has no gap of the augmented component.
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
