# Scores implants in measured logs: what a report names beyond that of the same log without the implant.
# What the machine itself shows is true or not, nobody knows; so only the implant counts.
"""Figures of the implants."""
import collections

from figures import number, rate, text


def more_named(case, control):
    """Effects that the implant adds to what is named."""
    return [e for e in case.named if control is None or e not in control.named]


def score(cases):
    """Everything as a dict that JSON can hold."""
    controls = {c.name: c for c in cases if c.kind == "control"}
    rows = []
    for case in (c for c in cases if c.kind == "implant"):
        control = controls.get(case.label["control"])
        accepted = case.label["accepted"]
        # What is named without the implant cannot show that the implant was seen.
        before = bool(control) and any(e in control.named for e in accepted)
        more = more_named(case, control)
        rows.append({"case": case.name, "machine": case.label["machine"], "implant": case.truth[0],
                     "law": case.label["law"], "wanted": case.label["wanted"], "verdict": case.verdict,
                     "named": case.named, "more": more, "control": control.named if control else None,
                     "named_before": before, "found": any(e in more for e in accepted),
                     "others": [e for e in more if e not in accepted]})
    return {"cases": len(cases), "missing": sum(c.report is None for c in cases), "implants": rows,
            "controls": {c.label["machine"]: {"verdict": c.verdict, "named": c.named, "gap": c.gaps}
                         for c in controls.values()},
            "found": rates(rows, lambda row: "all"), "by_machine": rates(rows, lambda row: row["machine"]),
            "by_implant": rates(rows, lambda row: row["implant"]),
            "by_gap": rates(rows, lambda row: f"{row['wanted']:g}"),
            "named_before": sum(row["named_before"] for row in rows),
            "others": number(len(row["others"]) for row in rows)}


def rates(rows, key):
    groups = collections.defaultdict(list)
    for row in rows:
        if not row["named_before"]:
            groups[key(row)].append(row["found"])
    return {name: rate(flags) for name, flags in sorted(groups.items())}


def markdown(result):
    out = [f"Implants in measured logs: {len(result['implants'])} of {result['cases']} cases, {result['missing']} "
           f"without a report; in {result['named_before']} the effect is named without the implant, too, which are "
           "left out of the rates.", "",
           "| the implant is among what is named beyond the control | found |", "|---|---|"]
    for title in ("found", "by_machine", "by_implant", "by_gap"):
        out += [f"| {name} | {text(figure)} |" for name, figure in result[title].items()]
    out += ["", "| machine | verdict without implant | named |", "|---|---|---|"]
    out += [f"| {name} | {row['verdict']} | {', '.join(row['named'])} |" for name, row in result["controls"].items()]
    out += ["", "| machine | implant | law | gap | verdict | named | found |", "|---|---|---|---|---|---|---|"]
    out += [f"| {r['machine']} | {r['implant']} | {r['law']} | {r['wanted']:g} | {r['verdict']} | "
            f"{', '.join(r['named'])} | {'(before)' if r['named_before'] else 'yes' if r['found'] else 'no'} |"
            for r in result["implants"]]
    return "\n".join(out) + "\n"
