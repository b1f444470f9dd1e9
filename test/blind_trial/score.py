#!/usr/bin/python3
# Compares the reports of a diagnosis with the sealed labels of a blind trial: the goals, then class by class.
# The only program that reads the labels.
"""Score the reports of a blind trial."""
import argparse
import collections
import json
import math
import os
import sys

import numpy as np

import replayed
import score_implants
import score_trial_2
from figures import calibration_error, met, number, rate, text
from trial_case import NAMING, Case, load  # noqa: F401  (Case is for callers)

# ---- figures ---------------------------------------------------------------------------------------------------------


def covered(case):
    interval = case.closed.get("interval_95")
    if case.true_closed is None or not interval or None in interval:
        return None
    return interval[0] <= case.true_closed <= interval[1]


def stated(cases):
    """Probability of the effect named first, and whether it is there."""
    return [(c.probability, c.first in c.truth) for c in cases]


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
        ("expected calibration error of the first name", calibration_error(stated(naming)), 0.05, False),
        ("expected calibration error, single effects",
         calibration_error(stated(c for c in single if c.named)), 0.05, False),
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


# ---- output ----------------------------------------------------------------------------------------------------------


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
    return "\n".join(out) + "\n"


def cost_lines(result):
    c = result["cost"]
    if not c:
        return []
    peak = c["peak_memory_bytes"]
    memory = "" if peak is None else f"peak memory {peak / 2**20:.0f} MiB; "
    return ["", f"Time per case: median {c['median_seconds']:.1f} s, 95 % below {c['p95_seconds']:.1f} s, longest "
            f"{c['longest_seconds']:.1f} s; {memory}{c['failed']} failed, {c['timed_out']} timed out, of {c['of']}."]


def replay_lines(result):
    if not result.get("replay"):
        return []
    return ["", f"`augmented.yaml` replayed: gap as reported {text(result['replay']['agree'])}; "
            f"median gap to the noise-free force {text(result['replay']['gap_to_true_force'])}."]


def case_rows(cases):
    """One line per case, for whoever looks into the failures."""
    return [{"case": c.name, "kind": c.kind, "truth": c.truth or c.label["unknown"], "laws": c.label["laws"],
             "verdict": c.verdict, "named": c.named, "sets": c.sets, "probability": c.probability,
             "closed": c.closed.get("fraction"), "true_closed": c.true_closed, "gap": c.gaps,
             "visible_gap": c.label["gap"]["visible"], "full_gap": c.label["gap"]["full"],
             "noise_floor_hold_out": c.label["noise"]["floor_hold_out"], "observable": c.observable,
             "programme": c.label["programme"], "model": c.label["model"]} for c in cases]


def score(cases):
    """Everything as a dict that JSON can hold."""
    goals = [{"name": n, "figure": f, "goal": g, "larger": up, "met": met(f, g, up)}
             for n, f, g, up in goal_rows(cases)]
    return {"cases": len(cases), "missing": sum(c.report is None for c in cases), "goals": goals,
            "classes": class_rows(cases), "unknown": unknown_rows(cases), "splits": split_rows(cases),
            "cost": cost_rows(cases), "by_case": case_rows(cases)}


def score_set(cases, arguments):
    """(figures, tables) by the set that the cases are of."""
    sets = {c.label.get("set") for c in cases}
    if sets == {"implants"}:
        result = score_implants.score(cases)
        return result, score_implants.markdown(result)
    if sets == {"trial_2"}:
        if arguments.replay:
            replayed.measure_further(arguments.replay, cases, arguments.cases)
        result = score_trial_2.score(cases)
        result["cost"] = cost_rows(cases)
    else:
        result = score(cases)
    if arguments.replay:
        result["replay"] = replayed.replay_rows(arguments.replay, cases, arguments.cases)
    tables = score_trial_2.markdown(result) if sets == {"trial_2"} else markdown(result)
    return result, tables + "\n".join(cost_lines(result) + replay_lines(result)) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", required=True, help="folder that generate.py wrote")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--reports", help="folder that run.py wrote")
    source.add_argument("--campaign", help="folder of a campaign over a jobs file of as_campaign.py")
    parser.add_argument("--labels", help="folder of the sealed labels (default: CASES_labels)")
    parser.add_argument("--json", help="write the figures there as well")
    parser.add_argument("--markdown", help="write the tables there as well")
    parser.add_argument("--replay", help="path of `replay`: also check augmented.yaml on the hold-out logs, and in trial 2 "
                        "on further logs")
    arguments = parser.parse_args()
    arguments.labels = arguments.labels or arguments.cases.rstrip("/") + "_labels"
    if not os.path.isdir(arguments.labels):
        parser.error(f"--labels {arguments.labels}: no such folder")
    cases = load(arguments)
    if not cases:
        parser.error(f"--labels {arguments.labels}: holds no labels")
    result, tables = score_set(cases, arguments)
    print(tables, end="")
    for path, content in ((arguments.markdown, tables), (arguments.json, json.dumps(result, indent=1) + "\n")):
        if path:
            with open(path, "w", encoding="utf-8") as file:
                file.write(content)
    return 0


if __name__ == "__main__":
    sys.exit(main())
