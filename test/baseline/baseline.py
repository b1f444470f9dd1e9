#!/usr/bin/python3
# Compares two builds of the package, run alternately on folders of cases: conclusions, evidence, forces of `replay` and
# of the node, CPU time and memory. It shows that a change has no effect, by comparison with the build before.
"""Compare an old and a new build on folders of cases.

A case is a folder with component.yaml and either case.json (component, logs, hold_out or table, as the generators of
test/blind_trial write it) or logs named log_*.csv. The exit status is 1 if a verdict, the evidence or a force differs.
"""
import argparse
import dataclasses
import glob
import json
import math
import os
import shlex
import statistics
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "blind_trial"))

from run import description, run_one  # noqa: E402

NODE_PORT = 11411  # port of the master for a log that is played; another bench may use the default port of ROS
CONCLUSION = ("verdict", "effects", "confounded", "gap", "closed", "candidates")


@dataclasses.dataclass
class Build:
    """The programs of a build in its devel or install space."""

    name: str
    space: str

    def program(self, name):
        return os.path.join(self.space, "lib", "rubber_suspension", name)


def cases_of(folders):
    """Yield the cases in each folder, or the folder itself if it is a case."""
    for folder in folders:
        inner = sorted(os.path.dirname(p) for p in glob.glob(os.path.join(folder, "*", "component.yaml")))
        found = inner or [folder] * os.path.isfile(os.path.join(folder, "component.yaml"))
        if not found:
            raise SystemExit(f"baseline.py: {folder}: holds no case; accepted: folders with component.yaml and logs")
        yield from found


def differences(old, new, path=""):
    """Yield (path, relative difference) of numbers and (path, inf) of other values. Ignore keys that only `new` has."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key, value in old.items():
            yield from differences(value, new[key], f"{path}.{key}") if key in new else [(f"{path}.{key}", math.inf)]
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        for index, (one, other) in enumerate(zip(old, new)):
            yield from differences(one, other, f"{path}[{index}]")
    elif old != new:
        numbers = all(isinstance(x, (int, float)) and not isinstance(x, bool) for x in (old, new))
        yield path, abs(old - new) / max(abs(old), abs(new)) if numbers else math.inf


def read_json(path):
    if not os.path.isfile(path):
        return None
    with open(path, encoding="utf-8") as file:
        return json.load(file)


def compare(old, new, tolerance):
    """Return None if two values agree within the tolerance, and otherwise the largest difference."""
    found = [d for d in differences(old, new) if d[1] > tolerance]
    if not found:
        return None
    path, size = max(found, key=lambda d: d[1])
    return f"{len(found)} values, most {path.lstrip('.')}" + (f" by {size:.1e}" if math.isfinite(size) else "")


def replay(build, case, folder, output):
    """Return the forces that `replay` writes for each log, as bytes."""
    forces = {}
    for log in case.get("logs", []) + case.get("hold_out", []):
        path = os.path.join(output, f"replay_{os.path.basename(log)}.csv")
        run([build.program("replay"), "--config", os.path.join(folder, "component.yaml"), "--component",
             case["component"], "--log", os.path.join(folder, log), "--output", path], path)
        forces[log] = content(path)
    return forces


def play(build, case, folder, output):
    """Return the forces with which a running node answers the first log."""
    records = os.path.join(output, "node")
    launch = ["roslaunch", "-p", str(NODE_PORT), "rubber_suspension", "bench.launch", "plot:=false",
              "playback_speed:=0", f"config:={os.path.join(folder, 'component.yaml')}",
              f"component:={case['component']}", f"log:={os.path.join(folder, case['logs'][0])}", f"output:={records}"]
    path = os.path.join(records, f"{case['component']}_force.csv")
    setup = os.path.join(build.space, "setup.bash")
    run(["bash", "-c", f". {shlex.quote(setup)} && exec {shlex.join(launch)}"], path)
    return content(path)


def run(command, expected):
    """Run a command. If it fails without writing the expected file, print the end of its output."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if result.returncode != 0 and not os.path.exists(expected):
        print(result.stdout.decode(errors="replace")[-500:], file=sys.stderr)


def content(path):
    if not os.path.exists(path):
        return None
    with open(path, "rb") as file:
        return file.read()


def run_case(builds, folder, output, options):
    """Run both builds on a case. Return the differences, and the CPU seconds and memory of each build."""
    case = description(folder)
    found, costs = {}, {}
    for build in builds:
        place = os.path.join(output, build.name)
        result = run_one(build.program("diagnose"), folder, place, options.timeout, evidence=True)
        costs[build.name] = (result["cpu_seconds"], result["peak_memory_bytes"])
        report = read_json(os.path.join(place, "report.json")) or {}
        found[build.name] = {
            "status": result["exit_status"],
            "conclusion": {key: report.get(key) for key in CONCLUSION},
            "report": {key: value for key, value in report.items() if key != "meta"},
            "evidence": read_json(os.path.join(place, "evidence.json")),
            "replay": replay(build, case, folder, place),
            "node": play(build, case, folder, place) if options.node and case.get("logs") else None}
    old, new = found["old"], found["new"]
    differ = {key: compare(old[key], new[key], options.tolerance) for key in old}
    if options.node and case.get("logs") and new["node"] != new["replay"][case["logs"][0]]:
        differ["node"] = "the node's forces are not those of replay"
    return {key: what for key, what in differ.items() if what}, costs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cases", nargs="+", help="folders of cases, or cases")
    parser.add_argument("--old", required=True, help="devel or install space of the build before the change")
    parser.add_argument("--new", required=True, help="that of the build with it")
    parser.add_argument("--output", required=True, help="folder for the reports of both")
    parser.add_argument("--tolerance", type=float, default=0.0, help="largest relative difference of a number (0)")
    parser.add_argument("--node", action="store_true", help="play the first log of each case through a node as well")
    parser.add_argument("--timeout", type=float, default=300.0, help="limit for one diagnosis [s]")
    options = parser.parse_args()
    builds = [Build("old", os.path.abspath(options.old)), Build("new", os.path.abspath(options.new))]
    for build in builds:
        if not os.access(build.program("diagnose"), os.X_OK):
            parser.error(f"{build.space}: has no program lib/rubber_suspension/diagnose; accepted: a devel or install space")
    costs, different = [], {}
    folders = [os.path.abspath(folder) for folder in cases_of(options.cases)]
    for number, folder in enumerate(folders):
        name = "/".join(folder.split(os.sep)[-2:])
        by_turns = builds if number % 2 == 0 else builds[::-1]
        output = os.path.join(os.path.abspath(options.output), name)
        differ, cost = run_case(by_turns, folder, output, options)
        costs.append(cost)
        for key, what in differ.items():
            different.setdefault(key, []).append(name)
        print(f"{number + 1}/{len(folders)} {name}: CPU {cost['old'][0]:.1f} and {cost['new'][0]:.1f} s; "
              + ("; ".join(f"{key} differs: {what}" for key, what in differ.items()) or "equal"), flush=True)
    return summary(costs, different, options.node)


def summary(costs, different, with_node):
    """Print the medians of both builds and the differences, and return the exit status."""
    print(f"\n{len(costs)} cases")
    for index, what, scale in ((0, "CPU [s]", 1.0), (1, "peak memory [MiB]", 2.0 ** -20)):
        old, new = ([cost[name][index] * scale for cost in costs] for name in ("old", "new"))
        ratios = [b / a for a, b in zip(old, new)]
        print(f"{what:18} median {statistics.median(old):8.2f} and {statistics.median(new):8.2f}, sum {sum(old):9.1f} and "
              f"{sum(new):9.1f}, ratio of a case: median {statistics.median(ratios):.3f}, largest {max(ratios):.3f}")
    for key in ["status", "conclusion", "report", "evidence", "replay"] + ["node"] * with_node:
        cases = different.get(key, [])
        print(f"{key:18} " + (f"differs in {len(cases)}: {', '.join(cases)}" if cases else "equal in all"))
    return 1 if set(different) - {"report"} else 0


if __name__ == "__main__":
    sys.exit(main())
