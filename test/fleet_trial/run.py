#!/usr/bin/python3
# Virtual fleets from nothing to figures: generate, `campaign make`, `run`, `collect`, score. What is done is not done again.
"""Run the check of the fleet statistics on virtual fleets."""
import argparse
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def call(*command):
    """What it prints goes on; a failure ends all."""
    status = subprocess.run([str(word) for word in command], check=False).returncode
    if status != 0:
        sys.exit(f"run.py: {command[0]} {command[1]} ends with {status}")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--campaign", required=True, help="path of the command `campaign`")
    parser.add_argument("--pieces", type=int, default=12, help="test pieces of each fleet")
    parser.add_argument("--draws", type=int, default=8, help="fleets of each kind")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--fleet", action="append", default=[], help="kinds of fleets (default: all)")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--output", required=True, help="folder of all that is made; what is there already stays")
    arguments = parser.parse_args()
    fleets, campaign = arguments.output, os.path.join(arguments.output, "campaign")
    if not os.path.exists(os.path.join(fleets, "labels.json")):
        kinds = [word for kind in arguments.fleet for word in ("--fleet", kind)]
        call(sys.executable, os.path.join(HERE, "generate.py"), "--pieces", arguments.pieces, "--draws", arguments.draws,
             "--seed", arguments.seed, "--output", fleets, "--jobs", arguments.threads, *kinds)
    if not os.path.exists(os.path.join(campaign, "manifest.jsonl")):
        call(arguments.campaign, "make", "--jobs", os.path.join(fleets, "jobs.yaml"), "--output", campaign)
    call(arguments.campaign, "run", campaign, "--threads", arguments.threads)
    call(arguments.campaign, "collect", campaign)
    call(sys.executable, os.path.join(HERE, "score.py"), "--fleets", fleets, "--campaign", campaign, "--json",
         os.path.join(fleets, "score.json"))


if __name__ == "__main__":
    main()
