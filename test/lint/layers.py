#!/usr/bin/python3
"""Checks the layers: includes point in one direction only, only ros_interface, bag and the main programs use ROS, and
each folder of diagnosis/ declares in its own namespace.

Usage: layers.py FOLDER_OF_THE_PACKAGE. Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import re
import sys

# The layers that each layer may include, apart from itself.
BELOW = {
    "processor": set(),
    "element": {"processor"},
    "kernel": {"processor", "element"},
    "component": {"element", "kernel"},
    "response": {"element", "component"},
    "estimation": {"element", "component", "response", "numerics"},
    "numerics": {"processor"},
    "log": {"element", "kernel", "numerics"},
    "io": {"element", "component", "response", "estimation", "log"},
    "gap": {"element", "component", "response", "estimation", "numerics", "log", "io"},
    "measurement": {"element", "kernel", "component", "response", "estimation", "numerics", "log", "io", "gap"},
    "fit": {
        "processor", "element", "kernel", "component", "response", "estimation", "numerics", "log", "io", "gap",
        "measurement"},
    "command": {"element", "component", "response", "estimation", "log", "io", "gap", "measurement", "fit"},
    "diagnosis": {
        "element", "component", "response", "estimation", "numerics", "log", "io", "gap", "measurement", "fit"},
    "campaign": {
        "element", "component", "response", "estimation", "numerics", "log", "io", "gap", "measurement", "fit", "command",
        "diagnosis"},
    "fmi": {"element", "kernel", "component", "response", "estimation", "log", "io"},
    "python": {"element", "component", "response", "estimation", "log", "io", "gap", "measurement", "fit", "diagnosis"},
    "vehicle": {"element", "component", "response", "estimation", "log", "io"},
    "node": {"element", "component", "response", "estimation", "log", "io", "gap", "measurement"},
    "bag": {"element", "component", "log"},
    "command_line": {"element", "component", "response", "estimation", "log", "io", "gap", "bag"},
    "ros_interface": {
        "element", "component", "response", "estimation", "log", "io", "gap", "measurement", "fit", "diagnosis", "node",
        "bag"},
    "benchmark": {"element", "component", "estimation", "numerics", "log", "io", "gap", "diagnosis"},
}
# The folders and single headers of diagnosis/ that each folder in it may include. Files beside the folders may include
# all of them.
WITHIN_DIAGNOSIS = {
    "prepare": set(),
    "judge": set(),
    "live": set(),
    "hypotheses": {"judge"},
    "results": {"prepare", "judge", "hypotheses"},
    "experiment": {"prepare", "judge", "hypotheses"},
    "words": {"experiment/next_experiment.h", "hypotheses/workings.h"},
    "table": {"words", "prepare", "judge", "hypotheses", "experiment", "results"},
    "report": {
        "words", "prepare/bench_evidence.h", "judge/evidence_json.h", "hypotheses/workings.h"},
}
# These folders come last. They receive values, and must not call an earlier step. A function that writes is no step.
ENDS = {"words", "report"}
NO_STEPS = {"judge::toJson"}
KNOW_ROS = {"bag", "ros_interface", "apps"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
ROS_HEADER = re.compile(
    r"^(ros|rosbag|roscpp|rosgraph_msgs|nodelet|pluginlib|class_loader|diagnostic_updater|xmlrpcpp|tf2?|actionlib"
    r"|[a-z_0-9]+_msgs|std_srvs|dynamic_reconfigure|topic_tools|message_filters|rostest)/"
)
OWN_MESSAGE = re.compile(r"^rubber_suspension/[A-Z]\w*\.h$")
OWN_HEADER = re.compile(r"^(?:rubber_suspension/)?([a-z_]+)/")
NAMESPACE = re.compile(r"^namespace (rubber_suspension[\w:]*) \{", re.M)
CALL = re.compile(r"\b((?:prepare|hypotheses|judge|results|experiment|table)::(?:\w+::)*[a-z]\w*)\(")
OF_DIAGNOSIS = re.compile(r"(?:^|/src/)diagnosis/([a-z_]+)/")


def layer_of(path, root):
    """Return the folder below include/rubber_suspension/ or src/ that contains a file."""
    parts = path.relative_to(root).parts
    return parts[2] if parts[0] == "include" else parts[1]


def violation_within(path, header):
    """Return why a file of diagnosis/ must not include a header of another folder in it, or None if it may."""
    own, other = OF_DIAGNOSIS.search(path.as_posix()), OF_DIAGNOSIS.search(header)
    if own is None or other is None or own.group(1) == other.group(1):
        return None
    if not {other.group(1), header.partition("diagnosis/")[2]} & WITHIN_DIAGNOSIS.get(own.group(1), set()):
        return f"diagnosis/{own.group(1)} must not depend on {header}"
    return None


def steps_called(path, line):
    """Return the earlier steps of a diagnosis that a line calls, if the file is in one of the last folders."""
    own = OF_DIAGNOSIS.search(path.as_posix())
    called = set(CALL.findall(line)) - NO_STEPS if own and own.group(1) in ENDS else ()
    return [f"calls {step}(): diagnosis/{own.group(1)} takes values alone" for step in sorted(called)]


def violation_of_namespace(path, text, root):
    """Return the violation if a file of diagnosis/ uses neither the namespace of its folder nor that of the layer."""
    parts = path.relative_to(root).parts
    if parts[:2] != ("src", "diagnosis"):
        return None
    layer = "rubber_suspension::diagnosis"
    own = "::".join((layer,) + parts[2:-1])
    opened = set(NAMESPACE.findall(text))
    if opened - {own, layer} or own not in opened and path.suffix == ".h":
        return f"declares in {', '.join(sorted(opened))}; the namespace of its folder is {own}"
    return None


def violation(layer, header):
    """Return why a file of this layer must not include the header, or None if it may."""
    if layer not in KNOW_ROS and (ROS_HEADER.match(header) or OWN_MESSAGE.match(header)):
        return f"{layer} must not know ROS"
    own = OWN_HEADER.match(header)
    if own is None or layer == "apps" or own.group(1) == layer:
        return None
    if own.group(1) in BELOW and own.group(1) not in BELOW[layer]:
        return f"{layer} must not depend on {own.group(1)}"
    return None


def check(root):
    found = 0
    files = sorted(p for folder in ("include", "src") for p in (root / folder).rglob("*") if p.suffix in (".h", ".cpp"))
    if not files:
        print(f"{root}: no sources")
        return 1
    for path in files:
        layer = layer_of(path, root)
        if layer not in BELOW and layer != "apps":
            print(f"{path}: folder `{layer}` is no layer; layers are {', '.join(BELOW)}")
            found += 1
            continue
        text = path.read_text()
        reason = violation_of_namespace(path, text, root)
        if reason:
            print(f"{path}: {reason}")
            found += 1
        for number, line in enumerate(text.splitlines(), 1):
            match = INCLUDE.match(line)
            reason = match and (violation(layer, match.group(1)) or violation_within(path, match.group(1)))
            reasons = [f"includes {match.group(1)}: {reason}"] if reason else steps_called(path, line)
            for one in reasons:
                print(f"{path}:{number}: {one}")
            found += len(reasons)
    return found


if __name__ == "__main__":
    sys.exit(1 if check(pathlib.Path(sys.argv[1]).resolve()) else 0)
