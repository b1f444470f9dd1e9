#!/usr/bin/python3
# Writes cases of a virtual rig by an independent author, and diagnoses them for judge_again. That rig is not part of
# the package.
"""Run a bank of cases by an independent author through a diagnosis."""
import argparse
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, epilog="The bank has a program write_cases.py OUTPUT --cases NUMBER --seed SEED that "
        "writes folders of cases and OUTPUT_labels. Even seeds are for fitting numbers, odd ones for judging.")
    parser.add_argument("bank", help="folder of the bank")
    parser.add_argument("output", help="folder of the cases; labels and reports are in OUTPUT_labels and _reports")
    parser.add_argument("--cases", type=int, default=60)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--diagnose", help="path of the command; without it the cases are only written")
    parser.add_argument("--jobs", type=int, default=1, help="cases at a time")
    parser.add_argument("--timeout", type=float, default=300.0, help="limit for one case [s]")
    arguments = parser.parse_args()
    writer = os.path.join(arguments.bank, "write_cases.py")
    if not os.path.isfile(writer):
        parser.error(f"{writer}: not found; accepted: a folder with write_cases.py")
    output = arguments.output.rstrip("/")
    subprocess.run([sys.executable, writer, output, "--cases", str(arguments.cases), "--seed", str(arguments.seed)],
                   check=True)
    if arguments.diagnose:
        sys.exit(subprocess.run([sys.executable, os.path.join(HERE, "run.py"), "--cases", output, "--diagnose",
                                 arguments.diagnose, "--reports", output + "_reports", "--evidence", "--jobs",
                                 str(arguments.jobs), "--timeout", str(arguments.timeout)], check=False).returncode)


if __name__ == "__main__":
    main()
