#!/usr/bin/python3
"""Checks that the table in CONTRIBUTING.md lists all tests of ctest with their tiers.

Usage: tests.py FOLDER_OF_THE_PACKAGE BUILD_FOLDER. Prints a line per violation; exit status 1 if there is any. With a
third argument, a part of test names or '', it runs these tests instead, one by one, and prints the real time and the
CPU time of each [s]. With a fourth argument `write`, it also writes the CPU times to the table.
"""

import fnmatch
import json
import os
import pathlib
import re
import resource
import subprocess
import sys
import time

ROW = re.compile(r"^\| `([\w*.]+)` \| (quick|all) \|", re.MULTILINE)
CATKIN = re.compile(r"^_ctest_\w+?_(?=gtest_|rostest_)")  # prefix of names made by catkin


def tests_of(build):
    """Return the properties of each test by its name, without the prefix of catkin."""
    told = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], check=True, capture_output=True).stdout
    return {CATKIN.sub("", test["name"]): test for test in json.loads(told)["tests"]}


def properties(test):
    return {entry["name"]: entry["value"] for entry in test["properties"]}


def check(root, build):
    rows = ROW.findall((root / "CONTRIBUTING.md").read_text())
    tiers = {name: properties(test).get("LABELS", ["none"])[0] for name, test in tests_of(build).items()}
    problems = []
    for name, tier in tiers.items():
        found = [row_tier for pattern, row_tier in rows if fnmatch.fnmatchcase(name, pattern)]
        if found != [tier]:
            problems.append(f"{name}: tier {tier} by its label, {', '.join(found) or 'no row'} in the table")
    if "all" in tiers.values():  # otherwise the build has the quick tier only
        problems += [f"{pattern}: in the table, but no test" for pattern, _ in rows
                     if not fnmatch.filter(tiers, pattern)]
    for problem in problems:
        print(f"CONTRIBUTING.md: {problem}")
    return bool(problems)


def used():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def time_tests(build, part):
    failed, seconds = False, {}
    for name, test in tests_of(build).items():
        if part not in name or "command" not in test:
            continue
        more = properties(test)
        environment = dict(line.split("=", 1) for line in more.get("ENVIRONMENT", []))
        before, start = used(), time.monotonic()
        status = subprocess.run(test["command"], cwd=more["WORKING_DIRECTORY"], env={**os.environ, **environment},
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode
        failed |= status not in (0, more.get("SKIP_RETURN_CODE"))
        seconds[name] = used() - before
        print(f"{name}: {time.monotonic() - start:.1f} s, processor {seconds[name]:.1f} s, exit status {status}",
              flush=True)
    return failed, seconds


def write(root, seconds):
    def with_seconds(row):
        names = fnmatch.filter(seconds, row[1])
        total = sum(seconds[name] for name in names)
        return f"| `{row[1]}` | {row[2]} | {total:.{0 if total > 9.5 else 1}f} |" if names else row[0]

    page = root / "CONTRIBUTING.md"
    page.write_text(re.sub(ROW.pattern + r" [\d.?]+ \|", with_seconds, page.read_text(), flags=re.MULTILINE))


def main():
    root, build = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    if len(sys.argv) == 3:
        return check(root, build)
    failed, seconds = time_tests(build, sys.argv[3])
    if sys.argv[4:] == ["write"]:
        write(root, seconds)
    return failed


if __name__ == "__main__":
    sys.exit(main())
