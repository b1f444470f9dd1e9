#!/usr/bin/python3
# Compares what `campaign collect` says of virtual fleets with their labels. The only program that reads the labels.
"""Score the findings of a campaign on virtual fleets."""
import argparse
import collections
import json
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from generate import FLEETS, SCATTER  # noqa: E402

STIFFNESSES = tuple(SCATTER)
WORTH_SAYING = 0.02  # as `campaign` has it: a logarithm below it is within what a bench can hold
SCATTERS, COMMON = "scatter between test pieces", "wrong values common to the type"


def read_json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def kind_of(name):
    """(kind, draw) of a fleet or rig by its name in the jobs file."""
    kind, draw = name.rsplit("_", 1)
    return kind, int(draw)


class Piece:
    """A label beside the row of the table and what the fleet changed."""

    def __init__(self, label, row):
        self.label, self.row = label, row
        self.fleet, self.plan = label["fleet"], FLEETS[label["fleet"]]
        self.verdict = row["values"].get("verdict", row["status"])
        self.effects = [e for e in row["values"].get("effects", "").split(", ") if e]
        self.may_be_values = "parameter_error" in row["values"].get("alternatives", "")
        self.changed_to, self.stands_out = None, False

    @property
    def right_change(self):
        """What the fleet should say of a verdict of wrong values; None: it should stay."""
        if self.label["outlier"] or self.label["effect"]:
            return None
        if self.plan["rig"] in ("soft", "gain"):
            return COMMON  # what the rig takes of all of them
        return COMMON if max(abs(v) for v in self.label["wrong"].values()) > WORTH_SAYING else SCATTERS


def load(folder, campaign):
    """Pieces and the findings on their fleets."""
    labels = {(p["fleet"], p["draw"], p["number"]): p for p in read_json(os.path.join(folder, "labels.json"))["pieces"]}
    fleet = read_json(os.path.join(campaign, "fleet.json"))
    pieces = {}
    for row in read_json(os.path.join(campaign, "table.json"))["jobs"]:
        number = int(row["test_piece"].rsplit("_", 1)[1])
        pieces[row["id"]] = Piece(labels[(*kind_of(row["type"]), number)], row)
    for kind in fleet["types"]:
        for one in kind["changed"]:
            pieces[one["id"]].changed_to = one["to"]
        for one in kind["stand_out"]:
            pieces[one["id"]].stands_out = True
    return list(pieces.values()), fleet


# ---- figures ---------------------------------------------------------------------------------------------------------


def share(flags):
    flags = list(flags)
    return {"hits": sum(flags), "of": len(flags)}


def true_mean(plan, label, parameter):
    """Of the logarithms of a type."""
    return label["wrong"].get(parameter, 0.0) + math.log(plan.get("gain", 1.0))


def true_scatter(plan, parameter):
    step = 0.0 if parameter == "static_stiffness" else SCATTER[parameter]
    return plan.get("scatter", 0.0) * math.hypot(SCATTER["static_stiffness"], step)


def coverage(pieces, fleet):
    """By parameter: intervals of mean and scatter that hold the truth, where there is scatter, no outlier, no soft rig."""
    labels = {f"{p.fleet}_{p.label['draw']}": p.label for p in pieces}
    out = {}
    for parameter in STIFFNESSES:
        means, scatters = [], []
        for kind in fleet["types"]:
            plan = FLEETS[kind_of(kind["name"])[0]]
            for found in kind["parameters"]:
                plain = "scatter" in plan and "outliers" not in plan and "compliance" not in plan
                if found["name"] == parameter and "mean" in found and plain:
                    low, high = found["mean_interval_95"]
                    means.append(low <= true_mean(plan, labels[kind["name"]], parameter) <= high)
                    low, high = found["scatter_interval_95"]
                    scatters.append(low <= true_scatter(plan, parameter) <= high)
        out[parameter] = {"mean": share(means), "scatter": share(scatters)}
    return out


def causes(pieces):
    with_effect = [p for p in pieces if p.label["effect"]]
    without = [p for p in pieces if not p.label["effect"] and p.plan["rig"] not in ("soft", "gain")]
    return {"effect named": share(p.effects == [p.label["effect"]] for p in with_effect),
            "effect named where there is none": share(bool(p.effects) and not p.may_be_values for p in without)}


def changes(pieces):
    """By kind of fleet: verdicts that the fleet changed, how many rightly, and those that it should have and did not."""
    out = {}
    for kind in FLEETS:
        group = [p for p in pieces if p.fleet == kind]
        if group:
            changed = [p for p in group if p.changed_to]
            left = [p for p in group if p.verdict in ("parameter_error", "confounded") and not p.changed_to
                    and p.right_change]
            out[kind] = {"pieces": len(group), "changed": len(changed), "left": len(left),
                         "right": sum(p.changed_to == p.right_change for p in changed),
                         "wrong": dict(collections.Counter(p.changed_to for p in changed
                                                           if p.changed_to != p.right_change))}
    return out


def stand_outs(pieces):
    outliers = [p for p in pieces if p.label["outlier"]]
    others = [p for p in pieces if not p.label["outlier"]]
    fleets = collections.defaultdict(bool)
    for p in others:
        fleets[p.fleet, p.label["draw"]] |= p.stands_out
    return {"outliers found": share(p.stands_out for p in outliers),
            "others that stand out": share(p.stands_out for p in others),
            "fleets in which another stands out": share(fleets.values())}


def score(pieces, fleet):
    return {"pieces": len(pieces), "failed": sum(p.row["status"] != "done" for p in pieces), "causes": causes(pieces),
            "coverage": coverage(pieces, fleet), "changes": changes(pieces), "stand_outs": stand_outs(pieces)}


# ---- output ----------------------------------------------------------------------------------------------------------


def ratio(figure):
    return f"{figure['hits']} of {figure['of']}"


def markdown(result):
    out = [f"{result['pieces']} test pieces, {result['failed']} failed.", "", "| | |", "|---|---|"]
    out += [f"| {name} | {ratio(figure)} |" for name, figure in {**result["causes"], **result["stand_outs"]}.items()]
    out += ["", "| interval of 95 % that holds the truth | mean | scatter |", "|---|---|---|"]
    out += [f"| `{name}` | {ratio(row['mean'])} | {ratio(row['scatter'])} |"
            for name, row in result["coverage"].items()]
    out += ["", "| fleet | test pieces | verdicts changed | rightly | should have been | wrongly said |",
            "|---|---|---|---|---|---|"]
    for name, row in result["changes"].items():
        wrong = ", ".join(f"{k}: {v}" for k, v in row["wrong"].items())
        out.append(f"| `{name}` | {row['pieces']} | {row['changed']} | {row['right']} | {row['left']} | {wrong} |")
    return "\n".join(out) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--fleets", required=True, help="folder that generate.py wrote")
    parser.add_argument("--campaign", required=True, help="folder of the campaign, collected")
    parser.add_argument("--json", help="write the figures there as well")
    arguments = parser.parse_args()
    result = score(*load(arguments.fleets, arguments.campaign))
    print(markdown(result), end="")
    if arguments.json:
        with open(arguments.json, "w", encoding="utf-8") as file:
            json.dump(result, file, indent=1)


if __name__ == "__main__":
    main()
