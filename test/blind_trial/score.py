#!/usr/bin/python3
# Compares what reports state beside the verdict with the sealed labels: the rules of reports, gaps that `replay` gives,
# the share closed on further logs, time and memory. judge_again counts the right verdicts.
"""Score the reports of a blind trial."""
import argparse
import json
import math
import os
import subprocess

import numpy as np

import invariants
from replayed import Case, further_gaps, is_found_again, read_json


def known(values):
    return [value for value in values if value is not None]


def rate(flags):
    """Return {hits, of, rate, interval_95} with Wilson's interval. Flags that are None are not counted."""
    flags = [bool(flag) for flag in known(flags)]
    n, k = len(flags), sum(flags)
    if n == 0:
        return {"hits": 0, "of": 0, "rate": None, "interval_95": None}
    z, p = 1.96, k / n
    middle = (p + z * z / (2 * n)) / (1 + z * z / n)
    half = z * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n)) / (1 + z * z / n)
    return {"hits": k, "of": n, "rate": p, "interval_95": [max(0.0, middle - half), min(1.0, middle + half)]}


def median(values):
    """Return the median and the number of values as {value, of}."""
    values = known(values)
    return {"value": float(np.median(values)) if values else None, "of": len(values)}


def text(figure):
    """Format a figure for a cell of a table."""
    if "rate" not in figure:
        return "-" if figure["value"] is None else f"{figure['value']:.3f} (of {figure['of']})"
    if figure["rate"] is None:
        return "-"
    low, high = figure["interval_95"]
    return f"{100 * figure['rate']:.0f} % ({figure['hits']}/{figure['of']}, {100 * low:.0f} to {100 * high:.0f} %)"


def closed_on_further(case, what="augmented"):
    """Return the fraction of the gap that a component file closes on further logs, which is 1 for a perfect model."""
    gaps = case.further or {}
    span = gaps.get("re_estimated", 0.0) - case.label["noise"].get("floor_further", 0.0)
    return min(1.0, (gaps["re_estimated"] - gaps[what]) / span) if what in gaps and span > 0.0 else None


def is_covered(case):
    """Return True if interval_95 contains the fraction closed on further logs, None if the report names no effect."""
    closed = closed_on_further(case)
    if closed is None or not case.report["effects"]:
        return None
    low, high = case.report["closed"]["interval_95"]
    return low <= closed <= high


def measure_further(binary, cases, labels):
    """Set the attribute `further` of each case with further logs to their gaps, or to `error` if replay fails."""
    for case in cases:
        if "file" in case.label and case.report and case.report["verdict"] not in ("check_bench", "defect"):
            try:
                case.further = further_gaps(binary, case, os.path.join(labels, case.label["case"] + ".npz"))
            except (subprocess.CalledProcessError, OSError, ValueError, KeyError) as error:
                case.further = {"error": str(error)}


def rows_of(cases, binary):
    """Return the rows of the table as (name, figure)."""
    reports = [case.report for case in cases if case.report]
    rows = [("cases with a report", rate(case.report is not None for case in cases)),
            ("reports without a defect", rate(report["verdict"] != "defect" for report in reports))]
    if binary:
        rows += [("`augmented.yaml` replayed: gap as reported",
                  rate(is_found_again(binary, case) for case in cases if case.report)),
                 ("further logs: re-estimated component as reported",
                  rate((case.further or {}).get("same_re_estimated") for case in cases)),
                 ("further logs: median of what `augmented.yaml` closes", median(map(closed_on_further, cases))),
                 ("further logs: median of what `surrogate.yaml` closes",
                  median(closed_on_further(case, "surrogate") for case in cases)),
                 ("further logs: intervals that cover what is closed", rate(map(is_covered, cases)))]
    checked = [invariants.checked(report) for report in reports]
    return rows + [(f"rule: {name}", rate(checks[name] for checks in checked)) for name in invariants.CHECKS]


def cost_of(cases):
    """Return the time and the memory that the diagnoses took."""
    runs = known(case.run for case in cases)
    if not runs:
        return {}
    seconds = [run["seconds"] for run in runs]
    return {"median_seconds": float(np.median(seconds)), "p95_seconds": float(np.percentile(seconds, 95)),
            "longest_seconds": max(seconds), "peak_memory_bytes": max(run["peak_memory_bytes"] for run in runs),
            "failed": sum(run["exit_status"] != 0 for run in runs), "timed_out": sum(run["timed_out"] for run in runs),
            "of": len(runs)}


def score(cases, binary=None):
    """Return all figures as a dictionary for JSON."""
    by_case = [{"case": case.label["case"], "further": case.further,
                "verdict": case.report["verdict"] if case.report else "missing"} for case in cases]
    return {"rows": dict(rows_of(cases, binary)), "cost": cost_of(cases), "by_case": by_case}


def markdown(result):
    lines = ["| figure | reached |", "|---|---|"]
    lines += [f"| {name} | {text(figure)} |" for name, figure in result["rows"].items()]
    cost = result["cost"]
    if cost:
        lines += ["", "Time per case: median {median_seconds:.1f} s, 95 % below {p95_seconds:.1f} s, longest "
                  "{longest_seconds:.1f} s; peak memory {0:.0f} MiB; {failed} failed, {timed_out} timed out, of {of}."
                  .format(cost["peak_memory_bytes"] / 2**20, **cost)]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", required=True, help="folder that generate.py wrote")
    parser.add_argument("--reports", required=True, help="folder that run.py wrote")
    parser.add_argument("--labels", help="folder of the sealed labels (default: CASES_labels)")
    parser.add_argument("--json", help="write the figures there as well")
    parser.add_argument("--replay", help="path of `replay`: also measure component files of the reports on the hold-out "
                        "logs, and on further logs where generate.py wrote some")
    arguments = parser.parse_args()
    labels = arguments.labels or arguments.cases.rstrip("/") + "_labels"
    if not os.path.isdir(labels):
        parser.error(f"--labels {labels}: no such folder")
    found = [read_json(os.path.join(labels, name)) for name in sorted(os.listdir(labels)) if name.endswith(".json")]
    cases = [Case(label, arguments.cases, os.path.join(arguments.reports, label["case"])) for label in found]
    if not cases:
        parser.error(f"--labels {labels}: holds no labels")
    if arguments.replay:
        measure_further(arguments.replay, cases, labels)
    result = score(cases, arguments.replay)
    print(markdown(result), end="")
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(result, file, indent=1)


if __name__ == "__main__":
    main()
