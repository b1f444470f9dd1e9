#!/usr/bin/python3
# A blind trial as a campaign, from nothing to figures: on several processors, machines or a cluster, going on where it
# was interrupted. What writes the jobs file reads the cases only, never the labels.
"""Generate, run and score a blind trial, with the bank that criteria are calibrated on, as one campaign."""
import argparse
import json
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

from virtual_rig import implant  # noqa: E402

BENCH = "running_start,zeros,spikes,pink,gain"

# Cases of each set: `bank` and `bench` (the bank as benches are) to calibrate on, the others to be judged by; of the
# implants without their controls. Logs last 30 to 60 s, or the share of it that is given.
SIZES = {
    "tiny": {"bank": 2, "bench": 1, "test": 2, "trial_2": 2, "implants": 1, "duration": 0.15},
    "five-minutes": {"bank": 12, "bench": 8, "test": 16, "trial_2": 16, "implants": 3, "duration": 1.0},
    "night": {"bank": 400, "bench": 400, "test": 400, "trial_2": 400, "implants": 60, "duration": 1.0},
}
CALIBRATED_ON = ("bank", "bench")
# By trial: the set that judges it, with the name of its figures, and those that need measured logs.
JUDGED_BY = {1: {"test": "score"}, 2: {"trial_2": "score", "implants": "implants"}}


def call(*command, output=None):
    """Print or write what it prints; a failure ends all."""
    words = [str(word) for word in command]
    if output is None:
        status = subprocess.run(words, check=False).returncode
    else:
        with open(output, "w", encoding="utf-8") as file:
            status = subprocess.run(words, check=False, stdout=file).returncode
    if status != 0:
        sys.exit(f"as_campaign.py: {' '.join(words[:3])} ends with {status}")


def names_of(cases):
    names = sorted(n for n in os.listdir(cases) if os.path.isfile(os.path.join(cases, n, "case.json")))
    if not names:
        sys.exit(f"as_campaign.py: {cases}: holds no cases")
    return names


def entry(cases, name):
    """One entry of a jobs file, SET_CASE: the logs in the order of the case. Each case is a type of its own."""
    with open(os.path.join(cases, name, "case.json"), encoding="utf-8") as file:
        case = json.load(file)
    group = f"{os.path.basename(cases)}_{name}"
    keys = {"command": "diagnose", "folders": os.path.join(os.path.abspath(cases), name), "config": "component.yaml",
            "component": case["component"], "type": group, "log": case["logs"]}
    if case["hold_out"]:
        keys["hold_out"] = case["hold_out"]
    if os.path.basename(cases) == "trial_2":
        keys["reports"] = "full"  # with surrogate.yaml, which is scored on further logs
    return f"  {group}: {json.dumps(keys)}\n"  # what is JSON is YAML


def write_jobs(folders, path):
    """The jobs file of these folders of cases."""
    entries = [entry(cases.rstrip("/"), name) for cases in folders for name in names_of(cases)]
    with open(path, "w", encoding="utf-8") as file:
        file.write("settings: {reports: data, evidence: true}\njobs:\n" + "".join(entries))
    print(f"{len(entries)} cases: {path}")


def sets_of(trial):
    """The sets of a trial: to calibrate on, then to be judged by; without measured logs there are no implants."""
    sets = [*CALIBRATED_ON, *JUDGED_BY[trial]]
    if "implants" in sets and not implant.available():
        print(f"as_campaign.py: no measured logs below {implant.data_folder()} (RUBBER_SUSPENSION_DATA names their "
              "folder): the implants are left out")
        sets.remove("implants")
    return sets


def generate(size, seed, threads, folder, sets):
    """All sets that are not there yet."""
    for name in sets:
        cases = os.path.join(folder, name)
        if not os.path.isdir(cases):
            unfinished = cases + ".unfinished"
            call(sys.executable, os.path.join(HERE, "generate.py"), "--set", "bank" if name == "bench" else name,
                 "--cases", SIZES[size][name], "--seed", seed + sets.index(name), "--duration",
                 SIZES[size]["duration"], "--bench", BENCH if name == "bench" else "", "--jobs", threads, "--output",
                 unfinished, "--labels", cases + "_labels", output=os.devnull)
            os.rename(unfinished, cases)


def whole_trial(arguments):
    folder, programs = arguments.output, arguments.programs
    campaign, tool = os.path.join(folder, "campaign"), os.path.join(programs, "campaign")
    os.makedirs(folder, exist_ok=True)
    sets = sets_of(arguments.trial)
    generate(arguments.size, arguments.seed, arguments.threads, folder, sets)
    if not os.path.exists(os.path.join(campaign, "manifest.jsonl")):
        write_jobs([os.path.join(folder, name) for name in sets], os.path.join(folder, "jobs.yaml"))
        call(tool, "make", "--jobs", os.path.join(folder, "jobs.yaml"), "--output", campaign, "--threads",
             arguments.threads)
    if arguments.until == "make":
        print(f"as_campaign.py: run or submit {campaign}, then call this again without --until")
        return
    call(tool, "run", campaign, "--threads", arguments.threads)
    call(tool, "collect", campaign)
    score_all(arguments.trial, folder, campaign, programs, sets)


def score_all(trial, folder, campaign, programs, sets):
    """score.md and score.json of the trial, in trial 2 implants.md and .json, too; calibration.md of both banks."""
    for name in sets[len(CALIBRATED_ON):]:
        figures = os.path.join(folder, JUDGED_BY[trial][name])
        further = ["--replay", os.path.join(programs, "replay")] if name == "trial_2" else []
        call(sys.executable, os.path.join(HERE, "score.py"), "--cases", os.path.join(folder, name), "--campaign",
             campaign, "--json", figures + ".json", "--markdown", figures + ".md", *further)
    labels = [word for name in CALIBRATED_ON for word in ("--labels", os.path.join(folder, name + "_labels"))]
    page = os.path.join(folder, "calibration.md")
    call(os.path.join(programs, "judge_again"), "--campaign", campaign, *labels, output=page)
    with open(page, encoding="utf-8") as file:
        print("\nCalibration on the bank, nothing of which enters the trial:\n\n" + file.read(), end="")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--size", choices=list(SIZES), help="from nothing to figures, of this size")
    parser.add_argument("--trial", type=int, choices=list(JUDGED_BY), default=1,
                        help="2: sealed laws, every base model, further logs, implants in measured logs")
    parser.add_argument("--seed", type=int, help="of the first set; the others take the next ones")
    parser.add_argument("--programs", help="folder of the commands `campaign`, `judge_again` and `replay`")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--until", choices=["make"], help="stop there, to run the campaign on a cluster")
    parser.add_argument("--output", help="folder of all that is made; what is there already stays")
    parser.add_argument("--cases", action="append", help="instead: folder that generate.py wrote; writes --jobs")
    parser.add_argument("--jobs", help="jobs file to write")
    arguments = parser.parse_args()
    whole = [arguments.size, arguments.seed is not None, arguments.programs, arguments.output]
    if all(whole) and not (arguments.cases or arguments.jobs):
        whole_trial(arguments)
    elif arguments.cases and arguments.jobs and not any(whole):
        write_jobs(arguments.cases, arguments.jobs)
    else:
        parser.error("accepted: --size SIZE --seed N --programs FOLDER --output FOLDER, or --cases FOLDER --jobs FILE")


if __name__ == "__main__":
    main()
