# Scores trial 2: every output of a report, clean benches and those as benches are apart, against the goals.
# What counts as right depends on the kind of the case; `right` says how.
"""Figures of trial 2."""
import collections

import numpy as np

import invariants
from figures import calibration_error, number, rate, text

BENCHES = ("clean", "as benches are")
REACHED = 0.7           # a case has the gap that it was drawn for if so much of it is left by re-estimation
LEFT_ALONE = ("none", "parameter_error")
FACTORS = ("kind", "base_model", "logs", "hold_out", "sampling_rate")
# Effects of the rig that a report may tell as what the rig did to each log, within its tolerances, instead.
TOLD_AS = {"force_offset": ("force_zero", "displacement_zero"), "time_delay": ("delay",),
           "sensor_gain": ("sensor_gain",)}
TRUTHS = {"none": "none", "parameter_error": "parameter_error", "unknown": "none_of_these"}  # all others: effects


def right(case):
    """Whether the report says of the case what is true."""
    names = set(case.truth) <= set(case.named)
    if case.kind == "single":
        return case.right
    if case.kind in ("pair", "triple"):
        return names
    if case.kind == "mixed":
        return names and case.verdict == "partly"
    if case.kind == "unknown":
        return case.verdict == "unknown"
    return case.verdict in LEFT_ALONE


def told(case):
    """Right, or what the rig does is told of half of the logs or more, and nothing wrong is named."""
    if right(case):
        return True
    logs = {f["log"] for f in case.findings if f["finding"] in TOLD_AS.get(case.truth[0], ())}
    count = case.label["factors"]["logs"] + case.label["factors"]["hold_out"]
    return not case.named and len(logs) >= 0.5 * count


def too_many(case):
    """An effect is named that is not there; where all that is there is outside the list, refusing is scored instead."""
    return case.report is None or bool(set(case.named) - set(case.truth))


def reaches(case):
    return case.label["gap"]["visible"] >= REACHED * case.label["gap"]["wanted"]


def closed_by_surrogate(case):
    """As the report has it, on unseen data where it says so."""
    surrogate = (case.report or {}).get("surrogate")
    if case.verdict != "unknown":
        return None
    if not surrogate:
        return 0.0
    unseen = surrogate.get("gap_unseen") or {}
    before, after = unseen.get("before"), unseen.get("after")
    if before is None or after is None:
        before, after = case.gaps["re_estimated"], surrogate["gap"]
    span = before - case.gaps["noise_floor"]
    return (before - after) / span if span > 0.0 else None


def closed_on_further(case, what="augmented"):
    """What a component file of the report really closes on logs that nobody has shown it, down to the true floor."""
    gaps = case.further or {}
    span = gaps.get("re_estimated", 0.0) - case.label["noise"]["floor_further"]
    if what not in gaps or span <= 0.0:
        return None
    return min(1.0, (gaps["re_estimated"] - gaps[what]) / span)


def covered(case):
    """Whether the stated interval covers that."""
    true, interval = closed_on_further(case), case.closed.get("interval_95")
    if not case.named or true is None or not interval or None in interval:
        return None
    return interval[0] <= true <= interval[1]


def where_overlap(case):
    """How far `where` agrees with the truth on which logs the gap is in: the share that both have in common."""
    true = case.label.get("where")
    cells = (case.report or {}).get("where")
    if not true or len(true) < 2 or not cells:
        return None
    stated = dict.fromkeys(true, 0.0)
    for cell in cells:
        stated[cell["log"]] = stated.get(cell["log"], 0.0) + cell["share"]
    return sum(min(share, true.get(log, 0.0)) for log, share in stated.items())


def known(values):
    return [v for v in values if v is not None]


# ---- tables ----------------------------------------------------------------------------------------------------------


def goal_rows(cases):
    """Rows (name, figure, goal clean, goal as benches are): a goal is a least or, where it is a pair, a range."""
    by_kind = collections.defaultdict(list)
    for case in cases:
        by_kind[case.kind].append(case)
    large = [c for c in by_kind["single"] if not c.small]
    small = [c for c in by_kind["single"] if c.small]
    judged = [c for c in cases if c.kind != "unknown"]
    alone = by_kind["none"] + by_kind["parameter_error"]
    unlisted, naming = by_kind["unknown"], [c for c in cases if c.named]

    def share(group):
        return rate(right(c) for c in group)
    return [
        ("right first, gap 10 %", share(large), 0.97, 0.92),
        ("right first, gap 10 % that re-estimation leaves", share(filter(reaches, large)), 0.97, 0.92),
        ("right first, gap 10 %, observable", share(c for c in large if c.observable), 0.97, 0.92),
        ("right first, gap 10 %, or told as what the rig did", rate(map(told, large)), None, None),
        ("right first, gap 3 %", share(small), 0.92, 0.80),
        ("right first, gap 3 % that re-estimation leaves", share(filter(reaches, small)), 0.92, 0.80),
        ("right first, gap 3 %, observable", share(c for c in small if c.observable), 0.92, 0.80),
        ("right first, gap 3 %, or told as what the rig did", rate(map(told, small)), None, None),
        ("an effect too many", rate(map(too_many, judged)), (0.0, 0.02), (0.0, 0.05)),
        ("gap-free or wrong values left alone", share(alone), 0.99, 0.97),
        ("gap-free left alone", share(by_kind["none"]), None, None),
        ("wrong values left alone", share(by_kind["parameter_error"]), None, None),
        ("pairs both", share(by_kind["pair"]), 0.92, 0.80),
        ("pairs both, each observable", share(c for c in by_kind["pair"] if c.both_observable), 0.92, 0.80),
        ("triples all", share(by_kind["triple"]), 0.75, None),
        ("listed and unlisted: `partly` with the name", share(by_kind["mixed"]), 0.85, 0.75),
        ("listed and unlisted: the name, whatever the verdict",
         rate(set(c.truth) <= set(c.named) for c in by_kind["mixed"]), None, None),
        ("unlisted refused", share(unlisted), None, None),
        ("closed, median of single effects of 10 %", number(c.closed.get("fraction") or 0.0 for c in large), 0.97,
         0.92),
        ("closed on further logs, median of the same", number(known(map(closed_on_further, large))), 0.97, 0.92),
        ("closed by the surrogate where `unknown`, median", number(known(map(closed_by_surrogate, cases))), 0.6, 0.5),
        ("closed by the surrogate on further logs, median",
         number(known(closed_on_further(c, "surrogate") for c in cases if c.verdict == "unknown")), 0.6, 0.5),
        ("intervals that cover what is closed on further logs", rate(known(map(covered, naming))), (0.92, 0.98),
         (0.92, 0.98)),
        ("`where` by log: share in common with the truth, median",
         number(known(where_overlap(c) for c in cases if c.kind != "none")), None, None),
        ("re-estimated component found again by replay",
         rate(known((c.further or {}).get("same_re_estimated") for c in cases)), None, None),
        ("reports of which every invariant holds",
         rate(all(v is not False for v in invariants.checked(c.report).values()) for c in cases if c.report), None,
         None),
    ]


def met(figure, goal):
    value = figure.get("rate", figure.get("value"))
    if goal is None or value is None:
        return ""
    low, high = goal if isinstance(goal, tuple) else (goal, np.inf)
    return "yes" if low <= value <= high else "no"


def goal_table(cases):
    out = []
    tables = [goal_rows([c for c in cases if c.label["factors"]["bench"] == bench]) for bench in BENCHES]
    for clean, benched in zip(*tables):
        out.append({"name": clean[0], "clean": clean[1], "clean_goal": clean[2], "clean_met": met(clean[1], clean[2]),
                    "bench": benched[1], "bench_goal": benched[3], "bench_met": met(benched[1], benched[3])})
    return out


def verdict_counts(cases):
    out = collections.defaultdict(collections.Counter)
    for case in cases:
        out[case.label["factors"]["kind"]][case.verdict] += 1
    return {kind: dict(counts.most_common()) for kind, counts in sorted(out.items())}


def probabilities(cases):
    """How true stated probabilities are, over all cases with a report: of each effect, of the first name, of what the
    gap is made of."""
    reports = [c for c in cases if c.report and c.report.get("posterior")]
    effects = [(one["probability"], one["effect"] in c.truth) for c in reports for one in c.candidates]
    kinds = [(c.report["posterior"][k] or 0.0, k == TRUTHS.get(c.kind, "effects")) for c in reports
             for k in ("none", "parameter_error", "effects", "none_of_these")]
    first = [(c.probability, c.first in c.truth) for c in reports if c.named]
    truth = [c.report["posterior"][TRUTHS.get(c.kind, "effects")] or 0.0 for c in reports]  # null: nothing was judged
    return {"of each effect": calibration_error(effects), "of the first name": calibration_error(first),
            "of none, wrong values, effects, none of these": calibration_error(kinds),
            "mean logarithm of the posterior of the truth":
                {"value": float(np.mean(np.log(np.maximum(truth, 1e-6)))) if truth else None, "of": len(truth)}}


def invariant_counts(cases):
    found = [invariants.checked(c.report) for c in cases if c.report]
    return {name: rate(known(f[name] for f in found)) for name in invariants.CHECKS}


def splits(cases):
    """Right by the levels of each factor; by law for single effects and for what is in no list."""
    out = collections.OrderedDict()
    for factor in FACTORS:
        for value in sorted({c.label["factors"][factor] for c in cases}):
            out[f"{factor} {value:g}" if isinstance(value, (int, float)) else f"{factor} {value}"] = [
                c for c in cases if c.label["factors"][factor] == value]
    for value in sorted({item for c in cases for item in c.label["laws"].items()}):
        out[f"{value[0]} by {value[1]}"] = [c for c in cases if c.kind in ("single", "unknown")
                                            and value in c.label["laws"].items()]
    return {name: {bench: rate(right(c) for c in group if c.label["factors"]["bench"] == bench) for bench in BENCHES}
            for name, group in out.items() if group}


def case_rows(cases):
    """One line per case, for whoever looks into the failures."""
    return [{"case": c.name, "factors": c.label["factors"], "truth": c.truth, "unlisted": c.label["unknown"],
             "laws": c.label["laws"], "verdict": c.verdict, "named": c.named, "right": right(c),
             "posterior": (c.report or {}).get("posterior"), "probability": c.probability, "closed": c.closed,
             "closed_on_further": closed_on_further(c), "further": c.further, "gap": c.gaps,
             "visible_gap": c.label["gap"]["visible"], "noise": c.label["noise"], "observable": c.observable,
             "broken": [n for n, holds in invariants.checked(c.report).items() if holds is False] if c.report else None}
            for c in cases]


def score(cases):
    """Everything as a dict that JSON can hold."""
    return {"cases": len(cases), "missing": sum(c.report is None for c in cases), "goals": goal_table(cases),
            "verdicts": verdict_counts(cases), "probabilities": probabilities(cases),
            "invariants": invariant_counts(cases), "splits": splits(cases), "by_case": case_rows(cases)}


# ---- Markdown --------------------------------------------------------------------------------------------------------


def goal_text(goal):
    if goal is None:
        return ""
    if isinstance(goal, tuple):
        return f"{goal[0]:g} to {goal[1]:g}"
    return f"{goal:g}"


def markdown(result):
    out = [f"Trial 2: {result['cases']} cases, {result['missing']} without a report.", "",
           "| | clean | goal | met | as benches are | goal | met |", "|---|---|---|---|---|---|---|"]
    out += [f"| {row['name']} | {text(row['clean'])} | {goal_text(row['clean_goal'])} | {row['clean_met']} | "
            f"{text(row['bench'])} | {goal_text(row['bench_goal'])} | {row['bench_met']} |" for row in result["goals"]]
    out += ["", "| kind | verdicts |", "|---|---|"]
    out += [f"| {kind} | {', '.join(f'{k} {v}' for k, v in counts.items())} |"
            for kind, counts in result["verdicts"].items()]
    out += ["", "| stated probability | expected calibration error |", "|---|---|"]
    out += [f"| {name} | {text(figure)} |" for name, figure in result["probabilities"].items()]
    for name, figure in result["probabilities"].items():
        if figure.get("bins"):
            out += ["", f"| {name}: stated | true | of |", "|---|---|---|"]
            out += [f"| {b['probability']:.2f} | {b['right']:.2f} | {b['of']} |" for b in figure["bins"]]
    out += ["", "| invariant of a report | holds |", "|---|---|"]
    out += [f"| {name} | {text(figure)} |" for name, figure in result["invariants"].items()]
    out += ["", "| right, split | clean | as benches are |", "|---|---|---|"]
    out += [f"| {name} | {text(row['clean'])} | {text(row['as benches are'])} |"
            for name, row in result["splits"].items()]
    return "\n".join(out) + "\n"
