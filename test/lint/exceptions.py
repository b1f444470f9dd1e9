#!/usr/bin/python3
"""Checks that every public header states what it throws, and names exceptions if its source throws.

Usage: exceptions.py FOLDER_OF_THE_PACKAGE. Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import re
import sys

SAID = re.compile(r"\b[Tt]hrows?\b")
THROWN = re.compile(r"\bthrow \w|\brefuseValue\(|\brefuseIf[<(]")


def source_of(root, header):
    return root / "src" / header.relative_to(root / "include" / "rubber_suspension").with_suffix(".cpp")


def violation(root, header):
    text = " ".join(line.strip().lstrip("/<").strip() for line in header.read_text().splitlines() if "//" in line)
    source = source_of(root, header)
    if not SAID.search(text):
        return "does not say what it throws; where that is nothing: 'Throws nothing.'"
    if source.exists() and THROWN.search(source.read_text()) and not re.search(r"throws?\b(?! nothing)", text, re.I):
        return f"says that it throws nothing, but {source.relative_to(root)} does"
    return None


def main(root):
    headers = sorted((root / "include").rglob("*.h"))
    found = [f"{header.relative_to(root)}: {reason}" for header in headers if (reason := violation(root, header))]
    print("\n".join(found), end="\n" if found else "")
    return found or not headers


if __name__ == "__main__":
    sys.exit(1 if main(pathlib.Path(sys.argv[1]).resolve()) else 0)
