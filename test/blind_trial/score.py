#!/usr/bin/python3
# Compares the reports of a diagnosis with the sealed labels of a blind trial: the goals, then class by class.
# The only program that reads the labels.
"""Score the reports of a blind trial."""
import argparse
import collections
import json
import math
import os
import subprocess
import sys
import tempfile

import numpy as np

SMALL_GAP = 0.035     # cases that were asked for a gap of about 3 %
NAMING = ("named", "confounded", "partly")
# A single effect counts as observable if these logs show it at all: re-estimation of the base leaves 5 % of it, and
# this is more than one and a half times the noise.
VISIBLE_SHARE, VISIBLE_OVER_NOISE = 0.05, 1.5


def read_json(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


class Case:
    """A label beside its report."""

    def __init__(self, label, report, run, folder=None):
        # A missing report counts as a failure everywhere.
        self.label, self.report, self.run, self.folder = label, report, run, folder
        self.name, self.kind, self.truth = label["case"], label["kind"], label["effects"]
        report = report or {}
        self.verdict = report.get("verdict", "missing")
        self.named = list(report.get("effects") or [])
        self.sets = [list(s) for s in report.get("confounded") or []]
        self.candidates = report.get("candidates") or []
        self.closed = report.get("closed") or {}
        self.gaps = report.get("gap") or {}

    @property
    def first(self):
        return self.named[0] if self.named else None

    @property
    def right(self):
        """Of a single effect: named, and named first."""
        return bool(self.truth) and self.first == self.truth[0]

    @property
    def ambiguity(self):
        return {e for s in self.sets for e in s}

    @property
    def small(self):
        return self.kind == "single" and 0.0 < self.label["gap"]["wanted"] < SMALL_GAP

    @property
    def visible_over_noise(self):
        return self.label["gap"]["visible"] / max(self.label["noise"]["floor"], 1e-9)

    @property
    def observable(self):
        gap = self.label["gap"]
        return gap["visible"] >= VISIBLE_SHARE * gap["full"] and self.visible_over_noise >= VISIBLE_OVER_NOISE

    @property
    def both_observable(self):
        """Of a pair: each effect alone would be observable."""
        gaps, floor = self.label["gap"]["single"].values(), self.label["noise"]["floor"]
        return all(g["visible"] >= max(VISIBLE_SHARE * g["full"], VISIBLE_OVER_NOISE * floor) for g in gaps)

    @property
    def true_closed(self):
        """The fraction that was really closed: by the reported gaps, but down to the true noise floor."""
        try:
            before, after = float(self.gaps["re_estimated"]), float(self.gaps["augmented"])
        except (KeyError, TypeError, ValueError):
            return None
        span = before - self.label["noise"]["floor_hold_out"]
        return (before - after) / span if span > 0.0 else None

    @property
    def probability(self):
        """Of the effect named first, or of the top candidate."""
        by_name = {c.get("effect"): c.get("probability") for c in self.candidates}
        value = by_name.get(self.first)
        if value is None and self.candidates:
            value = max((c.get("probability") or 0.0) for c in self.candidates)
        return value


# ---- figures ---------------------------------------------------------------------------------------------------------


def rate(flags):
    """{hits, of, rate, interval_95} with Wilson's interval."""
    flags = [bool(f) for f in flags]
    n, k = len(flags), sum(flags)
    if n == 0:
        return {"hits": 0, "of": 0, "rate": None, "interval_95": None}
    z, p = 1.96, k / n
    middle = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n)
    return {"hits": k, "of": n, "rate": p, "interval_95": [max(0.0, middle - half), min(1.0, middle + half)]}


def number(values):
    """{value: median, of: count}."""
    values = [v for v in values if v is not None]
    return {"value": float(np.median(values)) if values else None, "of": len(values)}


def calibration_error(cases):
    """Expected calibration error of the first-named effect's probability, ten bins."""
    pairs = [(c.probability, c.first in c.truth) for c in cases if c.probability is not None]
    if not pairs:
        return {"value": None, "of": 0, "bins": []}
    bins, error = [], 0.0
    for low in np.arange(10) / 10.0:
        inside = [(p, hit) for p, hit in pairs if low <= p < low + 0.1 or (p >= 1.0 and low > 0.85)]
        if inside:
            mean, hits = float(np.mean([p for p, _ in inside])), float(np.mean([h for _, h in inside]))
            bins.append({"probability": mean, "right": hits, "of": len(inside)})
            error += abs(mean - hits) * len(inside) / len(pairs)
    return {"value": error, "of": len(pairs), "bins": bins}


def covered(case):
    interval = case.closed.get("interval_95")
    if case.true_closed is None or not interval or None in interval:
        return None
    return interval[0] <= case.true_closed <= interval[1]


def set_size(cases):
    sizes = [len(c.ambiguity) for c in cases if c.sets]
    return {"value": float(np.mean(sizes)) if sizes else None, "of": len(sizes)}


def by_truth(singles):
    groups = collections.defaultdict(list)
    for case in singles:
        groups[case.truth[0]].append(case)
    return dict(sorted(groups.items()))


def goal_rows(cases):
    """Rows (name, figure, goal, whether larger is better) as the goals have them."""
    single = [c for c in cases if c.kind == "single"]
    shown = [c for c in single if c.observable]
    pairs = [c for c in cases if c.kind == "pair"]
    clean = [c for c in cases if c.kind in ("none", "parameter_error")]
    unknown = [c for c in cases if c.kind == "unknown"]
    naming = [c for c in cases if c.named]
    worst = {name: rate(c.right for c in group) for name, group in by_truth(shown).items()}
    worst = min(worst.items(), key=lambda item: item[1]["rate"], default=("-", rate([])))
    rows = [
        ("right effect first, single effects", rate(c.right for c in single), 0.95, True),
        ("right effect first, single and observable", rate(c.right for c in shown), 0.95, True),
        (f"worst effect, observable ({worst[0]})", worst[1], 0.80, True),
        ("truth in the ambiguity set, single effects", rate(c.truth[0] in c.ambiguity for c in single), 0.98, True),
        ("truth in the ambiguity set, observable", rate(c.truth[0] in c.ambiguity for c in shown), 0.98, True),
        ("mean size of the ambiguity set", set_size(single), 1.3, False),
        ("right effect first, gap of 3 %", rate(c.right for c in single if c.small), 0.85, True),
        ("right effect first, gap of 3 %, observable", rate(c.right for c in shown if c.small), 0.85, True),
        ("both named, pairs", rate(set(c.truth) <= set(c.named) for c in pairs), 0.80, True),
        ("both named, pairs of which each is observable",
         rate(set(c.truth) <= set(c.named) for c in pairs if c.both_observable), 0.80, True),
        ("at least one named and no wrong one, pairs",
         rate(bool(c.named) and set(c.named) <= set(c.truth) for c in pairs), None, True),
        ("effect named on none or parameter error", rate(c.verdict in NAMING + ("missing",) or c.named for c in clean), 0.02, False),
        ("exact verdict on none", rate(c.verdict == "none" for c in clean if c.kind == "none"), None, True),
        ("exact verdict on parameter error",
         rate(c.verdict == "parameter_error" for c in clean if c.kind == "parameter_error"), None, True),
        ("effect outside the list refused (verdict unknown)", rate(c.verdict == "unknown" for c in unknown), 0.85, True),
        ("effect outside the list, nothing named", rate(c.report is not None and not c.named for c in unknown), None, True),
        ("gap closed on unseen logs, median of single effects (as reported)",
         number(c.closed.get("fraction") or 0.0 for c in single), 0.95, True),
        ("the same down to the true noise floor", number(c.true_closed for c in single if c.named), 0.95, True),
        ("intervals of the gap closed that cover the truth",
         rate(f for f in (covered(c) for c in naming) if f is not None), 0.92, True),
        ("expected calibration error of the first name", calibration_error(naming), 0.05, False),
        ("expected calibration error, single effects", calibration_error([c for c in single if c.named]), 0.05, False),
    ]
    return rows


def class_rows(cases):
    """Per effect: figures and what was named in its place."""
    out = {}
    for name, group in by_truth([c for c in cases if c.kind == "single"]).items():
        wrong = collections.Counter(c.first or f"({c.verdict})" for c in group if not c.right)
        out[name] = {"right": rate(c.right for c in group), "observable": rate(c.right for c in group if c.observable),
                     "in_set": rate(name in c.ambiguity for c in group), "set_size": set_size(group),
                     "closed": number(c.closed.get("fraction") for c in group if c.right),
                     "instead": dict(wrong.most_common())}
    return out


def unknown_rows(cases):
    groups = collections.defaultdict(list)
    for case in cases:
        if case.kind == "unknown":
            groups[case.label["unknown"]].append(case)
    return {name: {"refused": rate(c.verdict == "unknown" for c in group),
                   "instead": dict(collections.Counter(
                       "+".join(c.named) or f"({c.verdict})" for c in group if c.verdict != "unknown").most_common())}
            for name, group in sorted(groups.items())}


def split_rows(cases):
    """Right first among single effects, split by what might matter."""
    single = [c for c in cases if c.kind == "single"]
    splits = collections.OrderedDict()
    for low, high in ((0, 1.5), (1.5, 3), (3, 10), (10, 30), (30, math.inf)):
        splits[f"visible gap {low} to {high} times the noise"] = [c for c in single if low <= c.visible_over_noise < high]
    for key in ("programme", "model"):
        for value in sorted({c.label[key] for c in single}):
            splits[f"{key} {value}"] = [c for c in single if c.label[key] == value]
    for flag, name in ((True, "file's parameters slightly wrong"), (False, "file's parameters true")):
        splits[name] = [c for c in single if (c.label["parameter_error"] is not None) == flag]
    for value in sorted({item for c in single for item in c.label["laws"].items()}):
        splits[f"{value[0]} by {value[1]}"] = [c for c in single if value in c.label["laws"].items()]
    return {name: rate(c.right for c in group) for name, group in splits.items() if group}


def cost_rows(cases):
    runs = [c.run for c in cases if c.run]
    if not runs:
        return {}
    seconds = [r["seconds"] for r in runs]
    return {"median_seconds": float(np.median(seconds)), "p95_seconds": float(np.percentile(seconds, 95)),
            "longest_seconds": max(seconds),
            "peak_memory_bytes": max((r["peak_memory_bytes"] or 0) for r in runs) or None,
            "failed": sum(r["exit_status"] != 0 for r in runs), "timed_out": sum(r["timed_out"] for r in runs),
            "of": len(runs)}


# ---- replay: does augmented.yaml keep what the report says? ----------------------------------------------------------


def replayed_gap(binary, case, folder, report_folder):
    """Gap of augmented.yaml on the hold-out logs: (against the measured force, against the true one)."""
    info, measured, true = read_json(os.path.join(folder, "case.json")), [], []
    stored = np.load(os.path.join(case.labels, case.name + ".npz"))
    for i, log in enumerate(info["hold_out"]):
        with tempfile.TemporaryDirectory() as scratch:
            out = os.path.join(scratch, "out.csv")
            subprocess.run([binary, "--config", os.path.join(report_folder, "augmented.yaml"), "--component",
                            info["component"], "--log", os.path.join(folder, log), "--output", out],
                           check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            force = np.loadtxt(out, delimiter=",", skiprows=1, usecols=2)
        path = os.path.join(folder, log)
        with open(path, encoding="utf-8") as file:
            unit = file.readline().strip().split(",")[2].split("_")[1]
        rig = np.loadtxt(path, delimiter=",", skiprows=1, usecols=2) * {"N": 1.0, "kN": 1e3, "MN": 1e6}[unit]
        measured.append(np.mean((rig - force) ** 2) / np.var(rig))
        true.append(np.mean((stored[f"hold_out_{i + 1}"] - force) ** 2) / np.var(rig))
    return math.sqrt(np.mean(measured)), math.sqrt(np.mean(true))


def replay_rows(binary, cases, arguments):
    """How many reports' gap.augmented is found again by replay, to 1 %."""
    agree, rest = [], []
    for case in cases:
        report_folder = case.folder
        if not case.named or report_folder is None or not os.path.isfile(os.path.join(report_folder, "augmented.yaml")):
            continue
        case.labels = arguments.labels
        try:
            gap, true = replayed_gap(binary, case, os.path.join(arguments.cases, case.name), report_folder)
        except (subprocess.CalledProcessError, OSError, ValueError):
            agree.append(False)
            continue
        agree.append(abs(gap - case.gaps["augmented"]) <= 0.01 * gap)
        rest.append(true)
    return {"agree": rate(agree), "gap_to_true_force": number(rest)}


# ---- output ----------------------------------------------------------------------------------------------------------


def text(figure):
    """A figure in a cell of a table."""
    if "rate" in figure:
        if figure["rate"] is None:
            return "-"
        low, high = figure["interval_95"]
        return f"{100 * figure['rate']:.0f} % ({figure['hits']}/{figure['of']}, {100 * low:.0f} to {100 * high:.0f} %)"
    return "-" if figure["value"] is None else f"{figure['value']:.3f} (of {figure['of']})"


def met(figure, goal, larger):
    value = figure.get("rate", figure.get("value"))
    if goal is None or value is None:
        return ""
    return "yes" if (value >= goal if larger else value <= goal) else "no"


def markdown(result):
    out = [f"Blind trial: {result['cases']} cases, {result['missing']} without a report.", "",
           "| goal | reached | wanted | met |", "|---|---|---|---|"]
    for row in result["goals"]:
        wanted = "" if row["goal"] is None else f"{'at least' if row['larger'] else 'at most'} {row['goal']:g}"
        out.append(f"| {row['name']} | {text(row['figure'])} | {wanted} | {row['met']} |")
    out += ["", "| effect | right first | of the observable | truth in set | mean set | median closed | named instead |",
            "|---|---|---|---|---|---|---|"]
    for name, row in result["classes"].items():
        instead = ", ".join(f"{k} {v}" for k, v in row["instead"].items())
        out.append(f"| {name} | {text(row['right'])} | {text(row['observable'])} | {text(row['in_set'])} | "
                   f"{text(row['set_size'])} | {text(row['closed'])} | {instead} |")
    out += ["", "| outside the list | refused | instead |", "|---|---|---|"]
    for name, row in result["unknown"].items():
        out.append(f"| {name} | {text(row['refused'])} | {', '.join(f'{k} {v}' for k, v in row['instead'].items())} |")
    out += ["", "| single effects, split | right first |", "|---|---|"]
    out += [f"| {name} | {text(figure)} |" for name, figure in result["splits"].items()]
    if result["cost"]:
        c = result["cost"]
        peak = c["peak_memory_bytes"]
        memory = "" if peak is None else f"peak memory {peak / 2**20:.0f} MiB; "
        out += ["", f"Time per case: median {c['median_seconds']:.1f} s, 95 % below {c['p95_seconds']:.1f} s, longest "
                f"{c['longest_seconds']:.1f} s; {memory}"
                f"{c['failed']} failed, {c['timed_out']} timed out, of {c['of']}."]
    if result.get("replay"):
        out += ["", f"`augmented.yaml` replayed: gap as reported {text(result['replay']['agree'])}; "
                f"median gap to the noise-free force {text(result['replay']['gap_to_true_force'])}."]
    return "\n".join(out) + "\n"


def case_rows(cases):
    """One line per case, for whoever looks into the failures."""
    return [{"case": c.name, "kind": c.kind, "truth": c.truth or c.label["unknown"], "laws": c.label["laws"],
             "verdict": c.verdict, "named": c.named, "sets": c.sets, "probability": c.probability,
             "closed": c.closed.get("fraction"), "true_closed": c.true_closed, "gap": c.gaps,
             "visible_gap": c.label["gap"]["visible"], "full_gap": c.label["gap"]["full"],
             "noise_floor_hold_out": c.label["noise"]["floor_hold_out"], "observable": c.observable,
             "programme": c.label["programme"], "model": c.label["model"]} for c in cases]


def reports_of_campaign(folder, cases):
    """By case: the folder of its report, and what stands for run.json, without memory: jobs share their process."""
    prefix, found = os.path.basename(cases.rstrip("/")) + "_", {}
    with open(os.path.join(folder, "manifest.jsonl"), encoding="utf-8") as manifest:
        jobs = [job for job in map(json.loads, manifest) if job.get("group", "").startswith(prefix)]
    for job in jobs:
        place = os.path.join(job["id"][:2], job["id"][2:])
        record = read_json(os.path.join(folder, "results", place + ".json"))
        if record is None:
            sys.exit(f"score.py: {job['group']} is not done; `campaign run` goes on with it")
        failed = record["status"] != "done"
        run = {"seconds": record["seconds"], "peak_memory_bytes": None, "exit_status": int(failed),
               "timed_out": failed and "took longer than the limit" in record["error"]}
        found[job["group"][len(prefix):]] = (None if failed else os.path.join(folder, "reports", place), run)
    return found


def load(arguments):
    cases = []
    jobs = reports_of_campaign(arguments.campaign, arguments.cases) if arguments.campaign else None
    for file in sorted(os.listdir(arguments.labels)):
        if file.endswith(".json"):
            label = read_json(os.path.join(arguments.labels, file))
            if jobs is None:
                folder = os.path.join(arguments.reports, label["case"])
                run = read_json(os.path.join(folder, "run.json"))
            else:
                folder, run = jobs.get(label["case"], (None, None))
            cases.append(Case(label, read_json(os.path.join(folder, "report.json")) if folder else None, run, folder))
    return cases


def score(cases):
    """Everything as a dict that JSON can hold."""
    goals = [{"name": n, "figure": f, "goal": g, "larger": up, "met": met(f, g, up)}
             for n, f, g, up in goal_rows(cases)]
    return {"cases": len(cases), "missing": sum(c.report is None for c in cases), "goals": goals,
            "classes": class_rows(cases), "unknown": unknown_rows(cases), "splits": split_rows(cases),
            "cost": cost_rows(cases), "by_case": case_rows(cases)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", required=True, help="folder that generate.py wrote")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--reports", help="folder that run.py wrote")
    source.add_argument("--campaign", help="folder of a campaign over a jobs file of as_campaign.py")
    parser.add_argument("--labels", help="folder of the sealed labels (default: CASES_labels)")
    parser.add_argument("--json", help="write the figures there as well")
    parser.add_argument("--markdown", help="write the tables there as well")
    parser.add_argument("--replay", help="path of `replay`: also check augmented.yaml on the hold-out logs")
    arguments = parser.parse_args()
    arguments.labels = arguments.labels or arguments.cases.rstrip("/") + "_labels"
    if not os.path.isdir(arguments.labels):
        parser.error(f"--labels {arguments.labels}: no such folder")
    cases = load(arguments)
    if not cases:
        parser.error(f"--labels {arguments.labels}: holds no labels")
    result = score(cases)
    if arguments.replay:
        result["replay"] = replay_rows(arguments.replay, cases, arguments)
    tables = markdown(result)
    print(tables, end="")
    for path, content in ((arguments.markdown, tables), (arguments.json, json.dumps(result, indent=1) + "\n")):
        if path:
            with open(path, "w", encoding="utf-8") as file:
                file.write(content)
    return 0


if __name__ == "__main__":
    sys.exit(main())
