#!/usr/bin/python3
# The judgement's numbers, fitted until they stand still: they are part of the search and of the rig's priors as well, so
# that new numbers give new evidence.
"""Repeat evidence and fit until no number of the judgement moves by more than 5 %."""
import argparse
import math
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
JUDGE = os.path.join(HERE, "..", "..", "src", "diagnosis", "judge")
SOURCE = os.path.join(JUDGE, "fitted_numbers.cpp")
LEAST = 0.05  # of a number; of the odds, where it is their logarithm
NUMBER = re.compile(r'fitted\.(\w+(?:\["\w+"\])?) = ([-+.\de]+);')
POSITIVE = re.compile(r'\{"(\w+)",[^{}]*&N::\w+,\s*true')


def numbers_of(text):
    """The numbers in the source that `judge_again --calibrate` writes."""
    return {name: float(value) for name, value in NUMBER.findall(text)}


def moved(old, new, positive):
    """The numbers that moved too far, came or went, with both values; those that are not positive are logarithms."""
    result = {}
    for name in sorted(set(old) | set(new)):
        before, after = old.get(name, math.nan), new.get(name, math.nan)
        if not abs(after - before) <= LEAST * (abs(before) if name in positive else 1.0):
            result[name] = (before, after)
    return result


def positive_numbers():
    """Names of those that are positive, by their table."""
    with open(os.path.join(JUDGE, "numbers.cpp"), encoding="utf-8") as file:
        return set(POSITIVE.findall(file.read()))


def read_numbers():
    """Those of the tree."""
    with open(SOURCE, encoding="utf-8") as file:
        return numbers_of(file.read())


def programs_of(build):
    """The folder of the programs of a build, built again."""
    subprocess.run(["cmake", "--build", build, "--target", "diagnose", "judge_again"], check=True)
    folders = [folder for folder, _, names in os.walk(build) if {"diagnose", "judge_again"} <= set(names)]
    if not folders:
        sys.exit(f"{build}: no folder with diagnose and judge_again; accepted: a build with tests")
    return folders[0]


def fit_once(arguments):
    """Evidence of all cases and a fit of the numbers to it."""
    programs = programs_of(arguments.build)
    for cases in arguments.cases:
        # Cases that fail are judged as wrong.
        subprocess.run([sys.executable, os.path.join(HERE, "run.py"), "--cases", cases, "--diagnose",
                        os.path.join(programs, "diagnose"), "--reports", cases + "_reports", "--evidence", "--jobs",
                        str(arguments.jobs), "--timeout", str(arguments.timeout)], check=False)
    subprocess.run([os.path.join(programs, "judge_again"), "--calibrate", SOURCE, *arguments.cases], check=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", help="folder of a build with tests, of this tree")
    parser.add_argument("cases", nargs="+", help="folders of cases to fit on, labels in CASES_labels beside each")
    parser.add_argument("--rounds", type=int, default=4, help="of evidence and fit, at most")
    parser.add_argument("--jobs", type=int, default=2, help="cases at a time")
    parser.add_argument("--timeout", type=float, default=300.0, help="limit for one case [s]")
    arguments = parser.parse_args()
    arguments.cases = [cases.rstrip("/") for cases in arguments.cases]
    for cases in arguments.cases:
        if not os.path.isdir(cases + "_labels"):
            parser.error(f"{cases}: no {cases}_labels; accepted: folders that generate.py or other_hand.py wrote")
    for round_number in range(1, arguments.rounds + 1):
        before = read_numbers()
        fit_once(arguments)
        changes = moved(before, read_numbers(), positive_numbers())
        print(f"round {round_number}: {len(changes)} numbers moved by more than {LEAST:.0%}", flush=True)
        for name, (old, new) in changes.items():
            print(f"  {name}: {old:.4g} to {new:.4g}", flush=True)
        if not changes:
            return 0
    return 1


if __name__ == "__main__":
    sys.exit(main())
