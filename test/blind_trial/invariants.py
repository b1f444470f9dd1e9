# Rules for the content of every report: verdict, gaps, noise floor, interval and probabilities agree (docs/diagnosis.md
# lists the rules). They use report.json alone. Before a report is written, src/diagnosis/invariants.cpp checks the same
# rules on the result and on the words of the page. A report that violates a rule has the verdict `defect`.
"""Invariants of a report."""
import math

LISTED = 0.02           # smallest probability of effects in listed sets
WORTH_SAYING = 0.02     # smallest reported change of the logarithm of a value
SLACK = 1e-3            # tolerance for rounded sums, fractions and gaps
NAMING = ("named", "confounded", "partly")
WEIGHED = ("none", "parameter_error", "unknown", *NAMING)  # verdicts for which the judgement compares probabilities
CHECKS = {}             # functions by the name of their rule


def rule(name, verdicts=None):
    """Register a check for reports with these verdicts, by default for all reports."""
    def register(check):
        CHECKS[name] = lambda report: None if verdicts and report["verdict"] not in verdicts else check(report)
        return check
    return register


@rule("no invariant was broken within the diagnosis")
def tells_a_verdict(report):
    return report["verdict"] != "defect"


@rule("effects are named if and only if the verdict names effects")
def verdict_has_its_effects(report):
    return bool(report["effects"]) == (report["verdict"] in NAMING)


@rule("with the verdict named, the gap falls and its interval excludes 0, or the data sheet is right", NAMING)
def named_closes(report):
    """Check that the gap falls with a closed share above 0, or that values come nearer to the data sheet."""
    gap = report["gap"]
    if report.get("withheld"):
        return None
    if gap["augmented"] < gap["re_estimated"] and report["closed"]["interval_95"][0] > 0.0:
        return True
    values, named = (next((trial["chi_squared"] for trial in report["trials"] if set(trial["effects"]) == set(effects)),
                          0.0) for effects in ([], report["effects"]))
    return gap["augmented"] < gap["as_configured"] and named < values


@rule("the share closed agrees with the gaps", NAMING)
def closed_is_of_the_gaps(report):
    gap = report["gap"]
    span = gap["re_estimated"] - gap["noise_floor"]
    if span <= 0.0:
        return False
    fraction = (gap["re_estimated"] - gap["augmented"]) / span
    # If more than the noise floor is closed, the share may be reported as the whole gap.
    return abs(min(fraction, 1.0) - min(report["closed"]["fraction"], 1.0)) <= SLACK


@rule("the interval contains the share closed", NAMING)
def interval_holds_the_fraction(report):
    low, high = report["closed"]["interval_95"]
    return low - SLACK <= report["closed"]["fraction"] <= high + SLACK


@rule("the parts removed from the logs add up", WEIGHED)
def taken_out_adds_up(report):
    """Check that the squares add up: gap as recorded, minus the parts that were removed, is the gap of the log."""
    if "taken_out" not in report:
        return None
    for log in report["admission"]:
        shares = [t["share_of_force"] for t in report["taken_out"] if t["log"] == log["log"]]
        left = log["gap_as_recorded"] ** 2 - sum(abs(s) * s for s in shares)
        if abs(left - log["gap"] ** 2) > SLACK * (1.0 + left):
            return False
    return True


@rule("no other fit predicts unseen data better")
def no_fit_predicts_better(report):
    """Check that the error on held-out blocks is at least that on fitted blocks, except for 2 % by chance. A law
    without a model has no error."""
    trials = [trial for trial in report.get("trials", []) if None not in (trial["in_sample"], trial["held_out"])]
    return all(trial["in_sample"] <= 1.02 * trial["held_out"] * (1.0 + SLACK) for trial in trials)


@rule("the noise floor is not above any gap")
def floor_is_least(report):
    """Check that the noise floor is not larger than the smallest gap of any model."""
    gap = report["gap"]
    gaps = [gap["as_configured"], gap["re_estimated"], gap["augmented"]]
    gaps += [c.get("gap") for c in report["candidates"]]
    return gap["noise_floor"] <= min(g for g in gaps if g is not None) * (1.0 + SLACK)


@rule("the probabilities add up to 1", WEIGHED)
def posterior_is_one(report):
    return abs(sum(report["posterior"].values()) - 1.0) <= SLACK


@rule("the verdict is the most probable explanation", WEIGHED)
def verdict_is_the_likeliest(report):
    """Check that the kind of the verdict has the largest posterior probability."""
    says = {"none": "none", "parameter_error": "parameter_error", "unknown": "none_of_these", "named": "effects",
            "confounded": "effects", "partly": "effects"}[report["verdict"]]
    return report["posterior"][says] >= max(report["posterior"].values()) - SLACK


def probability_of(report, effect):
    return max((c["probability"] for c in report["candidates"] if c["effect"] == effect), default=0.0)


@rule("the probabilities of effects agree with the sets that contain them", WEIGHED)
def candidates_are_of_the_sets(report):
    """Check that all sets together are as probable as any effect, and not more than the sum over the effects."""
    effects = report["posterior"]["effects"]
    probabilities = [c["probability"] for c in report["candidates"]]
    if any(probability_of(report, one["effect"]) > 0.0 for one in report.get("excluded", [])):
        return False
    return max(probabilities) <= effects + SLACK and sum(probabilities) >= effects - SLACK


@rule("the first set in the list is the named set", NAMING)
def first_set_is_named(report):
    return sorted(report["confounded"][0]) == sorted(report["effects"])


@rule("no set contains an improbable effect", NAMING)
def sets_are_probable(report):
    """Check that all listed sets but the first contain only effects with a probability of at least 2 %."""
    return all(probability_of(report, effect) >= LISTED - SLACK for s in report["confounded"][1:] for effect in s)


@rule("alternatives are sorted by probability", WEIGHED)
def alternatives_follow(report):
    """Check that the probabilities decrease and, together with that of the answer, add up to at most 1."""
    others = [a["probability"] for a in report["alternatives"]]
    return others == sorted(others, reverse=True) and report["probability"] + sum(others) <= 1.0 + SLACK


@rule("the headline has the largest change")
def headline_is_the_largest(report):
    """Check that the sentence names the value that is farthest off beyond its interval. The band of frequencies and
    values at a bound of the fit are exempt."""
    far = []
    for size in report.get("model_sizes", []):
        given, value, (low, high) = size["configured"], size["value"], size["interval_95"]
        if size["name"] in ("high_frequency", "low_frequency") or any(
                bound and value == end for bound, end in zip(size["at_bound"], (low, high))):
            continue
        if given and value and given > 0.0 and value > 0.0 and not low <= given <= high:
            far.append((abs(math.log(value / given)), given, value))
    far = sorted((f for f in far if f[0] > WORTH_SAYING), reverse=True)
    said = report["sentence"].partition(" in the component file")[0]
    if not far or " % too " not in said or "force channel" in said:
        return None
    percent = f"{abs(far[0][1] / far[0][2] - 1.0) * 100.0:.0f} %"
    return f" is {percent} too " in said


@rule("shares add up to the removed part of the gap", WEIGHED)
def shares_add_up(report):
    """Check that the shares of values and effects add up to the part of the configured gap that was removed."""
    gap = report["gap"]
    removed = 1.0 - gap["augmented"] / gap["as_configured"]
    return abs(sum(report["share_of_configured_gap"].values()) - removed) <= SLACK


@rule("the written file is not worse on any log")
def file_leaves_no_more(report):
    """Check that the file has no larger gap in a log or in all logs. A withheld effect is not written."""
    logs = report.get("left_of_logs", [])
    if any(log["written"] ** 2 > log["as_configured"] ** 2 + log["allowed"] + SLACK ** 2 for log in logs):
        return False
    if sum(log["written"] ** 2 - log["as_configured"] ** 2 for log in logs) > len(logs) * SLACK ** 2:
        return False
    written = {c["effect"] for c in report["candidates"] if c.get("law") == "written"}
    return not any(one["effect"] in written for one in report.get("withheld", []))


@rule("the numbers of named effects equal the numbers in the written file", NAMING)
def numbers_are_of_the_file(report):
    if "table" in report or "withheld" not in report:
        return None
    withheld = {one["effect"] for one in report["withheld"]}
    of_file = [c for c in report["candidates"] if c["effect"] in report["effects"] and c["effect"] not in withheld]
    return all(c["law"] == "written" and c["gap"] == report["gap"]["augmented"] for c in of_file)


@rule("each named effect removes some of the gap", NAMING)
def each_effect_removes(report):
    if "table" in report or "squares_removed_at_least" not in report:
        return None
    return all(report["squares_removed_at_least"][effect] > 0.0 for effect in report["effects"])


@rule("an interval that ends at a bound is marked")
def bounds_are_said(report):
    """Check that the interval of a size is marked as a bound if it ends at 0."""
    return all(size["at_bound"][0] for size in report.get("effect_sizes", [])
               if size["interval_95"][0] == 0.0 and size["value"] > 0.0)


@rule("the shares in `where` add up to 1")
def where_is_one(report):
    return None if not report["where"] else abs(sum(cell["share"] for cell in report["where"]) - 1.0) <= SLACK


@rule("the cells in `where` add up to the gap")
def where_adds_up(report):
    if "table" in report or not report["where"] or "squared_gap" not in report["where"][0] or "left_of_logs" not in report:
        return None
    return all(abs(sum(cell["squared_gap"] for cell in report[cells]) - report["gap"][gap] ** 2) <= SLACK * SLACK + 1e-9
               for cells, gap in (("where", "as_configured"), ("where_after", "augmented")) if report[cells])


@rule("a next experiment where confounded or unknown", ("confounded", "unknown"))
def next_experiment_is_there(report):
    return bool(report["next_experiment"].strip())


@rule("with the verdict unknown or partly, there is a surrogate", ("unknown", "partly"))
def surrogate_is_there(report):
    return None if "table" in report else "surrogate" in report


def checked(report):
    """Return for each rule: True, False, or None if it does not apply. An unreadable report violates a rule."""
    out = {}
    for name, check in CHECKS.items():
        try:
            out[name] = check(report)
        except (KeyError, TypeError, IndexError, ValueError):
            out[name] = None if report.get("verdict") in ("check_bench", "defect") else False
    return out
