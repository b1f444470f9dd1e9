#!/usr/bin/python3
# Runs a blind trial as a campaign: on several processors, machines or a cluster, going on where it was interrupted.
# It reads the cases only, never the labels.
"""Turn the cases of a blind trial into a jobs file for `campaign`, and what a campaign found into reports to score."""
import argparse
import json
import os
import shutil
import sys


def quoted(text):
    """Text as YAML; what is JSON is YAML."""
    return json.dumps(text)


def entry(cases, name):
    """One entry of a jobs file: the logs in the order of the case."""
    with open(os.path.join(cases, name, "case.json"), encoding="utf-8") as file:
        case = json.load(file)
    lines = [f"  {name}:", "    command: diagnose", f"    folders: {quoted(os.path.join(os.path.abspath(cases), name))}",
             "    config: component.yaml", f"    component: {quoted(case['component'])}", f"    log: {quoted(case['logs'])}"]
    if case["hold_out"]:
        lines.append(f"    hold_out: {quoted(case['hold_out'])}")
    return "\n".join(lines) + "\n"


def write_jobs(cases, path):
    names = sorted(n for n in os.listdir(cases) if os.path.isfile(os.path.join(cases, n, "case.json")))
    if not names:
        sys.exit(f"as_campaign.py: --cases {cases}: holds no cases")
    with open(path, "w", encoding="utf-8") as file:
        file.write("settings: {reports: data}\njobs:\n" + "".join(entry(cases, name) for name in names))
    print(f"{len(names)} cases: {path}")


def write_reports(campaign, folder):
    """The layout that score.py reads; without time and memory of each case, since jobs share their process."""
    failed = 0
    with open(os.path.join(campaign, "manifest.jsonl"), encoding="utf-8") as manifest:
        jobs = [json.loads(line) for line in manifest if '"command"' in line]
    for job in jobs:
        name = os.path.join(job["id"][:2], job["id"][2:])
        record_path = os.path.join(campaign, "results", name + ".json")
        if not os.path.exists(record_path):
            sys.exit(f"as_campaign.py: {job['group']} is not done; `campaign run` goes on with it")
        with open(record_path, encoding="utf-8") as file:
            record = json.load(file)
        target = os.path.join(folder, job["group"])
        os.makedirs(target, exist_ok=True)
        for report in record["files"]:
            shutil.copyfile(os.path.join(campaign, "reports", name, report), os.path.join(target, report))
        failed += record["status"] != "done"
    print(f"{len(jobs)} cases, {failed} failed: {folder}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", help="folder that generate.py wrote: writes --jobs")
    parser.add_argument("--jobs", help="jobs file to write")
    parser.add_argument("--campaign", help="folder of the campaign when it is done: writes --reports")
    parser.add_argument("--reports", help="folder for one folder of reports per case")
    arguments = parser.parse_args()
    if arguments.cases and arguments.jobs and not arguments.campaign:
        write_jobs(arguments.cases, arguments.jobs)
    elif arguments.campaign and arguments.reports and not arguments.cases:
        write_reports(arguments.campaign, arguments.reports)
    else:
        parser.error("accepted: --cases FOLDER --jobs FILE, or --campaign FOLDER --reports FOLDER")


if __name__ == "__main__":
    main()
