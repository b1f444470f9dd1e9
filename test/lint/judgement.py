#!/usr/bin/python3
"""Checks that the verdict is determined in one file, from the probabilities of one posterior alone, without further
numbers or comparisons.

Usage: judgement.py FOLDER_OF_THE_PACKAGE. Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import re
import sys

JUDGE = "src/diagnosis/judge/"
# These files determine the verdict: of a judgement, of logs without a judgement, and of a contradictory report.
SAYS = {JUDGE + "answer.cpp", "src/diagnosis/prepare/bench_evidence.cpp", "src/diagnosis/invariants.cpp"}
SEES = {"diagnosis/judge/answer.h", "diagnosis/judge/set_posterior.h", "rubber_suspension/diagnosis/posterior.h",
        "rubber_suspension/diagnosis/verdict.h"}              # the verdict is a function of what these declare
COMPARE = {JUDGE + "answer.cpp", JUDGE + "set_posterior.cpp"}  # these compare probabilities with each other
FITTED = {JUDGE + "numbers.h", JUDGE + "numbers.cpp", JUDGE + "fitted_numbers.cpp"}
NAMED = {"kListed", "kMajority", "kWorthListing", "kLeastSquare", "kTypicalBlocks"}  # meanings, units; no thresholds
PLAIN = {"0", "1", "2", "0.0", "0.5", "1.0"}                  # factors in formulas, and indices of hypotheses

SAID = re.compile(r"(?<!Verdict )\b(?:verdict\w*\s*=|return)\s+(?:diagnosis::)?Verdict::|\?\s*Verdict::")
INCLUDE = re.compile(r'^#include "([^"]+)"')
COMPARISON = re.compile(r" (?:<|>|<=|>=|==|!=) ")
COUNTS = re.compile(r"\bfor \(|\.size\(\)|\.end\(\)|\.at\(\)|\.terms")  # loops, sizes, results of searches, texts
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?(?:e[-+]?\d+)?(?![\w.])")


def code_lines(path):
    """Yield number and text of each line, without comments and strings."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        yield number, line if line.startswith("#include") else re.sub(r'"[^"]*"|//.*', "", line)


def of_verdicts(name, line):
    if name.startswith("src/diagnosis/") and name not in SAYS and SAID.search(line):
        return "says a verdict; only the answer to a posterior does"
    include = INCLUDE.match(line)
    if include and name in (JUDGE + "answer.cpp", JUDGE + "answer.h") and include.group(1) not in SEES:
        return f"includes {include.group(1)}: a verdict is a function of the posterior alone"
    return None


def of_judge(name, line):
    if not name.startswith(JUDGE) or line.startswith("#"):
        return None
    if name not in COMPARE and COMPARISON.search(line) and not COUNTS.search(line):
        return "compares; only probabilities are compared, for the verdict"
    declared = re.search(r"constexpr \w+ (k\w+) =", line)
    if name not in FITTED and not (declared and declared.group(1) in NAMED):
        others = [number for number in NUMBER.findall(line) if number not in PLAIN]
        if others:
            return f"{others[0]} is set by hand; the numbers of the judgement are fitted (numbers.cpp)"
    return None


def check(root):
    found = 0
    for path in sorted(p for p in (root / "src").rglob("*") if p.suffix in (".h", ".cpp")):
        name = str(path.relative_to(root))
        for number, line in code_lines(path):
            for reason in filter(None, (of_verdicts(name, line), of_judge(name, line))):
                print(f"{name}:{number}: {reason}")
                found += 1
    if not (root / JUDGE).is_dir():
        print(f"{root}: no {JUDGE}")
        found += 1
    return found


if __name__ == "__main__":
    sys.exit(1 if check(pathlib.Path(sys.argv[1]).resolve()) else 0)
