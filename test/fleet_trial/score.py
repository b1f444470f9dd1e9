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


def read_json(path):
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def kind_of(name):
    """(kind, draw) of a fleet or rig by its name in the jobs file."""
    kind, draw = name.rsplit("_", 1)
    return kind, int(draw)


class Piece:
    """A label beside the row of the table, and whether the fleet report has it far out."""

    def __init__(self, label, row):
        self.label, self.row = label, row
        self.fleet, self.plan = label["fleet"], FLEETS[label["fleet"]]
        self.verdict = row["values"].get("verdict", row["status"])
        self.effects = [e for e in row["values"].get("effects", "").split(", ") if e]
        self.may_be_values = "parameter_error" in row["values"].get("alternatives", "")
        self.far_out = False


def load(folder, campaign):
    """Pieces and the findings on their fleets."""
    labels = {(p["fleet"], p["draw"], p["number"]): p for p in read_json(os.path.join(folder, "labels.json"))["pieces"]}
    fleet = read_json(os.path.join(campaign, "fleet.json"))
    pieces = {}
    for row in read_json(os.path.join(campaign, "table.json"))["jobs"]:
        number = int(row["test_piece"].rsplit("_", 1)[1])
        pieces[row["id"]] = Piece(labels[(*kind_of(row["type"]), number)], row)
    for kind in fleet["types"]:
        for one in kind["far_out"]:
            pieces[one["id"]].far_out = True
    return list(pieces.values()), fleet


# ---- figures ---------------------------------------------------------------------------------------------------------


def share(flags):
    flags = list(flags)
    return {"hits": sum(flags), "of": len(flags)}


def true_median(plan, label, parameter):
    """Of the logarithms of a type, which are normal."""
    return label["wrong"].get(parameter, 0.0) + math.log(plan.get("gain", 1.0))


def coverage(pieces, fleet):
    """By parameter: intervals of the median that hold the truth, where there is scatter, no outlier, no soft rig."""
    labels = {f"{p.fleet}_{p.label['draw']}": p.label for p in pieces}
    hits = {parameter: [] for parameter in STIFFNESSES}
    for kind in fleet["types"]:
        plan = FLEETS[kind_of(kind["name"])[0]]
        plain = "scatter" in plan and "outliers" not in plan and "compliance" not in plan
        for found in kind["parameters"]:
            if found["name"] in hits and "median_interval_95" in found and plain:
                low, high = found["median_interval_95"]
                hits[found["name"]].append(low <= true_median(plan, labels[kind["name"]], found["name"]) <= high)
    return {parameter: share(flags) for parameter, flags in hits.items()}


def causes(pieces):
    with_effect = [p for p in pieces if p.label["effect"]]
    without = [p for p in pieces if not p.label["effect"] and p.plan["rig"] not in ("soft", "gain")]
    return {"effect named": share(p.effects == [p.label["effect"]] for p in with_effect),
            "effect named where there is none": share(bool(p.effects) and not p.may_be_values for p in without)}


def far_out(pieces):
    outliers = [p for p in pieces if p.label["outlier"]]
    others = [p for p in pieces if not p.label["outlier"]]
    fleets = collections.defaultdict(bool)
    for p in others:
        fleets[p.fleet, p.label["draw"]] |= p.far_out
    return {"outliers found": share(p.far_out for p in outliers),
            "others that are far out": share(p.far_out for p in others),
            "fleets in which another is far out": share(fleets.values())}


def verdicts(pieces):
    """By kind of fleet: how often each verdict is."""
    return {kind: dict(collections.Counter(p.verdict for p in pieces if p.fleet == kind))
            for kind in FLEETS if any(p.fleet == kind for p in pieces)}


def score(pieces, fleet):
    return {"pieces": len(pieces), "failed": sum(p.row["status"] != "done" for p in pieces), "causes": causes(pieces),
            "coverage": coverage(pieces, fleet), "verdicts": verdicts(pieces), "far_out": far_out(pieces)}


# ---- output ----------------------------------------------------------------------------------------------------------


def ratio(figure):
    return f"{figure['hits']} of {figure['of']}"


def markdown(result):
    out = [f"{result['pieces']} test pieces, {result['failed']} failed.", "", "| | |", "|---|---|"]
    out += [f"| {name} | {ratio(figure)} |" for name, figure in {**result["causes"], **result["far_out"]}.items()]
    out += [f"| interval of the median holds it: `{name}` | {ratio(figure)} |"
            for name, figure in result["coverage"].items()]
    out += ["", "| fleet | verdicts |", "|---|---|"]
    for name, row in result["verdicts"].items():
        out.append(f"| `{name}` | " + ", ".join(f"{k}: {v}" for k, v in row.items()) + " |")
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
