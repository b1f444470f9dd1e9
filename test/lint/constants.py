#!/usr/bin/python3
"""Checks that pi has one spelling in the sources: element::kPi of element/constants.h.

Usage: constants.py FOLDER_OF_THE_PACKAGE. Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import re
import sys

HOME = "include/rubber_suspension/element/constants.h"
PI = re.compile(r"\bM_PI\w*|\bM_1_PI\b|\bM_2_PI\b|(?<![\d.])3\.14(?:1\d*)?(?!\d)|(?<![\d.])6\.28(?:3\d*)?(?!\d)")
PI_BY_FUNCTION = re.compile(r"\b(?:acos\(-1(?:\.0?)?\)|4(?:\.0?)? \* (?:std::)?atan\(1(?:\.0?)?\)|constants::pi\b)")


def check(root):
    found = 0
    files = sorted(p for folder in ("include", "src", "test") for p in (root / folder).rglob("*")
                   if p.suffix in (".h", ".cpp"))
    if not files or root / HOME not in files:
        print(f"{root}: no sources, or no {HOME}")
        return 1
    for path in files:
        if path == root / HOME:
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            spelling = PI.search(line) or PI_BY_FUNCTION.search(line)
            if spelling:
                print(f"{path}:{number}: {spelling[0]}; accepted: element::kPi of {HOME}")
                found += 1
    return found


if __name__ == "__main__":
    sys.exit(1 if check(pathlib.Path(sys.argv[1]).resolve()) else 0)
