# One case of a trial as the scorer sees it: the sealed label beside the report, from folders or from a campaign.
# The only module that reads the labels.
"""A label beside its report."""
import json
import os
import sys

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

    def __init__(self, label, report, run, folder=None, sealed=None):
        # A missing report counts as a failure everywhere.
        self.label, self.report, self.run, self.folder = label, report, run, folder
        self.sealed = sealed      # path of the sealed logs
        self.further = None       # gaps on further logs, once they are measured
        self.name, self.kind, self.truth = label["case"], label["kind"], label["effects"]
        report = report or {}
        self.verdict = report.get("verdict", "missing")
        self.named = list(report.get("effects") or [])
        self.sets = [list(s) for s in report.get("confounded") or []]
        self.candidates = report.get("candidates") or []
        self.closed = report.get("closed") or {}
        self.gaps = report.get("gap") or {}
        self.findings = report.get("rig_findings") or []
        self.gaps_as_recorded = report.get("gap_as_recorded") or self.gaps

    def file(self, name):
        """Path of a file of the report, or None where it has none."""
        path = os.path.join(self.folder, name) if self.folder else ""
        return path if os.path.isfile(path) else None

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
        """Of a single effect: these logs show it."""
        gap = self.label["gap"]
        return gap["visible"] >= VISIBLE_SHARE * gap["full"] and self.visible_over_noise >= VISIBLE_OVER_NOISE

    @property
    def both_observable(self):
        """Of a pair: each effect alone would be observable."""
        gaps, floor = self.label["gap"]["single"].values(), self.label["noise"]["floor"]
        return all(g["visible"] >= max(VISIBLE_SHARE * g["full"], VISIBLE_OVER_NOISE * floor) for g in gaps)

    @property
    def true_closed(self):
        """The fraction that was really closed: by the reported gaps, but down to the true noise floor; 1 is all."""
        try:
            before, after = float(self.gaps["re_estimated"]), float(self.gaps["augmented"])
        except (KeyError, TypeError, ValueError):
            return None
        span = before - self.label["noise"]["floor_hold_out"]
        return min(1.0, (before - after) / span) if span > 0.0 else None  # a model may follow the noise by luck

    @property
    def probability(self):
        """Of the effect named first, or of the top candidate."""
        by_name = {c.get("effect"): c.get("probability") for c in self.candidates}
        value = by_name.get(self.first)
        if value is None and self.candidates:
            value = max((c.get("probability") or 0.0) for c in self.candidates)
        return value


# ---- from files ------------------------------------------------------------------------------------------------------


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
            cases.append(Case(label, read_json(os.path.join(folder, "report.json")) if folder else None, run, folder,
                              os.path.join(arguments.labels, label["case"] + ".npz")))
    return cases
