# What every report of a diagnosis must say of itself, whatever it found: verdict, gaps, floor, interval and
# probabilities agree. Only what report.json shows; how the reports look to a reader is tested elsewhere.
"""Invariants of a report."""
REST = (1.0, 0.02)      # a rest is beyond the noise if it is more than so many floors, and more than this of the force
SLACK = 1e-3            # of sums, fractions and gaps, which are rounded
NAMING = ("named", "confounded", "partly")
QUIET = ("none", "parameter_error", "unknown", "check_bench")


def beyond_noise(report, which):
    gap, floor = report["gap"][which], report["gap"]["noise_floor"]
    return gap ** 2 - floor ** 2 > (1.0 + SLACK) * max(REST[0] * floor, REST[1]) ** 2


def verdict_has_its_effects(report):
    return bool(report["effects"]) == (report["verdict"] in NAMING)


def parameter_error_leaves_noise(report):
    return None if report["verdict"] != "parameter_error" else not beyond_noise(report, "re_estimated")


def none_leaves_noise(report):
    return None if report["verdict"] != "none" else not beyond_noise(report, "as_configured")


def named_leaves_noise(report):
    """A rest beyond the noise is `partly`."""
    return None if report["verdict"] != "named" else not beyond_noise(report, "augmented")


def named_closes(report):
    """The gap falls on unseen data, and the interval of what is closed excludes 0."""
    if report["verdict"] not in NAMING:
        return None
    interval = report["closed"]["interval_95"]
    return report["gap"]["augmented"] < report["gap"]["re_estimated"] and interval[0] > 0.0


def closed_is_of_the_gaps(report):
    if report["verdict"] not in NAMING:
        return None
    gap = report["gap"]
    span = gap["re_estimated"] - gap["noise_floor"]
    if span <= 0.0:
        return False
    fraction = (gap["re_estimated"] - gap["augmented"]) / span
    # What is closed beyond the floor may be given as all.
    return abs(min(fraction, 1.0) - min(report["closed"]["fraction"], 1.0)) <= SLACK


def interval_holds_the_fraction(report):
    if report["verdict"] not in NAMING:
        return None
    low, high = report["closed"]["interval_95"]
    return low - SLACK <= report["closed"]["fraction"] <= high + SLACK


def taken_out_adds_up(report):
    """In squares: what a log leaves as recorded, less what was taken out of it, is what it leaves."""
    if "taken_out" not in report or report["verdict"] == "check_bench":
        return None
    for log in report["admission"]:
        shares = [t["share_of_force"] for t in report["taken_out"] if t["log"] == log["log"]]
        left = log["gap_as_recorded"] ** 2 - sum(abs(s) * s for s in shares)
        if abs(left - log["gap"] ** 2) > SLACK * (1.0 + left):
            return False
    return True


def floor_is_least(report):
    """The floor is no more than the least gap of any model."""
    gap = report["gap"]
    gaps = [gap["as_configured"], gap["re_estimated"], gap["augmented"]]
    gaps += [c.get("gap") for c in report["candidates"]]
    return gap["noise_floor"] <= min(g for g in gaps if g is not None) * (1.0 + SLACK)


def posterior_is_one(report):
    if report["verdict"] == "check_bench":  # no answer was weighed
        return None
    return abs(sum(report["posterior"].values()) - 1.0) <= SLACK


def verdict_is_the_likeliest(report):
    """`unknown` only if none of these is the likeliest, and so for the others."""
    says = {"none": "none", "parameter_error": "parameter_error", "unknown": "none_of_these", "named": "effects",
            "confounded": "effects", "partly": "effects"}.get(report["verdict"])
    if says is None:
        return None
    return report["posterior"][says] >= max(report["posterior"].values()) - SLACK


def first_is_the_likeliest(report):
    """The effect named first is in the first set that cannot be told apart."""
    return None if report["verdict"] not in NAMING else any(report["effects"][0] in s for s in report["confounded"])


def where_is_one(report):
    return None if not report["where"] else abs(sum(cell["share"] for cell in report["where"]) - 1.0) <= SLACK


def next_experiment_is_there(report):
    return None if report["verdict"] not in ("confounded", "unknown") else bool(report["next_experiment"].strip())


def surrogate_is_there(report):
    return None if report["verdict"] not in ("unknown", "partly") else "surrogate" in report


CHECKS = {
    "effects if and only if the verdict names any": verdict_has_its_effects,
    "none: what is left is noise": none_leaves_noise,
    "parameter_error: what is left is noise": parameter_error_leaves_noise,
    "named: what is left is noise": named_leaves_noise,
    "named: the gap falls, and the interval excludes 0": named_closes,
    "closed is of the gaps": closed_is_of_the_gaps,
    "the interval holds what is closed": interval_holds_the_fraction,
    "what was taken out adds up": taken_out_adds_up,
    "the floor is no more than any gap": floor_is_least,
    "the posterior adds up to 1": posterior_is_one,
    "the verdict is the likeliest": verdict_is_the_likeliest,
    "the first name is in a set": first_is_the_likeliest,
    "where adds up to 1": where_is_one,
    "a next experiment where confounded or unknown": next_experiment_is_there,
    "a surrogate where unknown or partly": surrogate_is_there,
}


def checked(report):
    """By check: True, False, or None where it does not apply. What cannot be read does not hold."""
    out = {}
    for name, check in CHECKS.items():
        try:
            out[name] = check(report)
        except (KeyError, TypeError, IndexError, ValueError):
            out[name] = None if report.get("verdict") == "check_bench" else False
    return out
