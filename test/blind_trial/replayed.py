# What `replay` makes of the component files of a report, on logs that the report knows and on further logs of the rig.
# Further logs lie with the sealed label; no diagnosis has seen them.
"""Gaps of component files by `replay`."""
import json
import math
import os
import subprocess
import tempfile

import numpy as np

from figures import number, rate
from trial_case import read_json

SAME_GAP = 0.01        # relative: a gap is found again by replay
UNITS = {"N": 1.0, "kN": 1e3, "MN": 1e6}


def replay(binary, config, component, log):
    """Forces [N] of a component along a log."""
    with tempfile.TemporaryDirectory() as scratch:
        out = os.path.join(scratch, "out.csv")
        subprocess.run([binary, "--config", config, "--component", component, "--log", log, "--output", out],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        return np.loadtxt(out, delimiter=",", skiprows=1, usecols=2)


def recorded_force(path):
    """The force [N] of a log as the rigs write them."""
    with open(path, encoding="utf-8") as file:
        unit = file.readline().strip().split(",")[2].split("_")[1]
    return np.loadtxt(path, delimiter=",", skiprows=1, usecols=2) * UNITS[unit]


def gap_of(parts):
    """The gap of [(difference, force)] over several logs."""
    return math.sqrt(np.mean([np.mean(d**2) / np.var(f) for d, f in parts]))


def hold_out_gaps(binary, case, folder, config, component):
    """Gap of a component file on the hold-out logs: (against the measured force, against the true one)."""
    stored, measured, true = np.load(case.sealed), [], []
    for i, log in enumerate(read_json(os.path.join(folder, "case.json"))["hold_out"]):
        force = replay(binary, config, component, os.path.join(folder, log))
        rig = recorded_force(os.path.join(folder, log))
        measured.append((rig - force, rig))
        # A bench that cuts the beginning of a log leaves it shorter than what is sealed.
        if len(stored[f"hold_out_{i + 1}"]) == len(force):
            true.append((stored[f"hold_out_{i + 1}"] - force, rig))
    return gap_of(measured), gap_of(true) if true else None


def replay_rows(binary, cases, cases_folder):
    """How many reports' gap.augmented is found again by replay, to 1 %; and the gap to the noise-free force."""
    agree, rest = [], []
    for case in cases:
        folder = os.path.join(cases_folder, case.name)
        info = read_json(os.path.join(folder, "case.json"))
        if not case.named or case.file("augmented.yaml") is None or not info["hold_out"]:
            continue
        try:
            gap, true = hold_out_gaps(binary, case, folder, case.file("augmented.yaml"), info["component"])
        except (subprocess.CalledProcessError, OSError, ValueError):
            agree.append(False)
            continue
        agree.append(abs(gap - case.gaps_as_recorded["augmented"]) <= SAME_GAP * gap)
        rest.append(true)
    return {"agree": rate(agree), "gap_to_true_force": number(rest)}


# ---- further logs ----------------------------------------------------------------------------------------------------


def re_estimated(label, component, ratios):
    """The component file (JSON, which is YAML) with the values of the sealed label's file times the report's ratios."""
    file, used = label["file"], set()

    def times(key, value):
        used.add(key)
        ratio = ratios.get(key)
        return value if ratio is None else value * ratio
    if "elements" in file:
        entries = [dict({k: times(f"{kind}[{i}].{k}", v) for k, v in values.items()}, type=kind)
                   for i, (kind, values) in enumerate(file["elements"])]
        content = {"model": "elements", "elements": entries}
    else:
        content = {"model": file["model"],
                   "specification": {k: times(k, v) for k, v in file["specification"].items()}}
    if set(ratios) - used:
        raise ValueError(f"the report re-estimates {sorted(set(ratios) - used)}, which the file does not have")
    return json.dumps({"components": {component: content}})


def write_further(case, folder):
    """The sealed further logs as files; returns [(path, force [N])]."""
    stored, label, out = np.load(case.sealed), case.label, []
    ambient = label["parameters"].get("temperature")
    before = label["factors"]["logs"] + label["factors"]["hold_out"]
    count = sum(name.startswith("further_") and name.endswith("_force") for name in stored.files)
    for i in range(count):
        z, force = (stored[f"further_{i + 1}_{what}"].astype(float) for what in ("displacement", "force"))
        columns = [np.arange(len(z)) / label["factors"]["sampling_rate"], z, force]
        header = "time_s,displacement_m,force_N"
        if ambient:
            columns.append(ambient["start"][before + i] + ambient["rise"][before + i] * np.linspace(0.0, 1.0, len(z)))
            header += ",temperature_degC"
        path = os.path.join(folder, f"further_{i + 1}.csv")
        np.savetxt(path, np.stack(columns, axis=1), "%.9g", ",", header=header, comments="")
        out.append((path, force))
    return out


# What a rig may do to a log by default (docs/parameters.md, keys of `rig`), as standard deviations: zero of the force,
# of its range; gain; delay in samples. Residuals have about so many values that do not depend on each other.
ZERO, GAIN, DELAY, INDEPENDENT = 0.10, 0.005, 0.5, 50


def without_trend(difference):
    """Without a slow trend of the log's own, which no simulation predicts (`kTrendsPerLog` in fit/free_in_log.h)."""
    time = np.linspace(0.0, 1.0, len(difference))
    columns = np.stack([time - 0.5] + [np.cos(np.pi * k * time) for k in range(1, 9)], axis=1)
    return difference - columns @ np.linalg.lstsq(columns, difference, rcond=None)[0]


def with_own_gain(simulated, force):
    """With the log's own gain of the force's channel, which no simulation predicts."""
    centred = simulated - simulated.mean()
    square = centred @ centred
    return simulated * (centred @ force / square) if square > 0.0 else simulated


def after_rig(difference, force, zero=True):
    """What a log differs by once a zero, a gain and a delay of the force within a rig's tolerances are taken out of it:
    the gaps of a report are measured like that. Where an offset or drift is named, the zero stays."""
    columns = [GAIN * force, DELAY * np.gradient(force)] + [np.full_like(force, ZERO * np.ptp(force))] * zero
    matrix = np.stack(columns, axis=1)
    variance = np.mean(difference**2) * len(force) / INDEPENDENT
    normal = matrix.T @ matrix / variance + np.eye(len(columns))
    return difference - matrix @ np.linalg.solve(normal, matrix.T @ difference / variance)


def further_gaps(binary, case, cases_folder):
    """Gaps on the further logs of {re_estimated, augmented, surrogate} as far as the report has them; and whether the
    re-estimated component is the report's: `replay` of it finds the gap that the report gives on the hold-out logs."""
    folder = os.path.join(cases_folder, case.name)
    info = read_json(os.path.join(folder, "case.json"))
    ratios = {k: v for k, v in case.report["own_parameters"]["ratio_to_configured"].items() if v is not None}
    with tempfile.TemporaryDirectory() as scratch:
        configs = {"re_estimated": os.path.join(scratch, "re_estimated.yaml")}
        with open(configs["re_estimated"], "w", encoding="utf-8") as file:
            file.write(re_estimated(case.label, info["component"], ratios))
        for what in ("augmented", "surrogate"):
            if case.file(what + ".yaml"):
                configs[what] = case.file(what + ".yaml")
        logs, zero = write_further(case, scratch), not {"force_offset", "force_drift"} & set(case.named)

        def left(what, path, force):
            named = case.named if what == "augmented" else []
            simulated = replay(binary, configs[what], info["component"], path)
            if "sensor_gain" in named:
                simulated = with_own_gain(simulated, force)
            rest = after_rig(force - simulated, force, zero)
            return without_trend(rest) if "force_drift" in named else rest
        gaps = {what: gap_of([(left(what, path, force), force) for path, force in logs]) for what in configs}
        gaps["same_re_estimated"] = None
        if info["hold_out"]:
            again, _ = hold_out_gaps(binary, case, folder, configs["re_estimated"], info["component"])
            stated = case.gaps_as_recorded["re_estimated"]
            gaps["same_re_estimated"] = abs(again - stated) <= SAME_GAP * stated
    return gaps


def measure_further(binary, cases, cases_folder):
    """Sets `further` of each case of trial 2 that has a report with gaps; what `replay` refuses is told in `error`."""
    for case in cases:
        if case.report is None or case.verdict == "check_bench" or case.gaps.get("re_estimated") is None:
            continue
        try:
            case.further = further_gaps(binary, case, cases_folder)
        except (subprocess.CalledProcessError, OSError, ValueError, KeyError) as error:
            case.further = {"error": str(error)}
