#!/usr/bin/python3
"""Checks that launch files stay on the loopback interface: each node gets ROS_IP and ROS_HOSTNAME from the argument
`ip` with the default 127.0.0.1, and an included file of this package gets the same argument.

Usage: launch.py FOLDER_OF_THE_PACKAGE. Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import sys
import xml.etree.ElementTree as ElementTree

LOOPBACK = "127.0.0.1"


def violations(launch):
    """Return the violations in the root element of a launch file."""
    found = []
    defaults = [arg.get("default") for arg in launch.findall("arg") if arg.get("name") == "ip"]
    if defaults != [LOOPBACK]:
        found.append(f"argument ip with the default {LOOPBACK} is missing")
    for node in launch.iter("node"):
        for name in ("ROS_IP", "ROS_HOSTNAME"):
            values = [env.get("value") for env in node.findall("env") if env.get("name") == name]
            if values != ["$(arg ip)"]:
                found.append(f"node {node.get('name')} does not get {name} from ip")
    for include in launch.iter("include"):
        values = [arg.get("value") for arg in include.findall("arg") if arg.get("name") == "ip"]
        if "$(dirname)" in include.get("file", "") and values != ["$(arg ip)"]:
            found.append(f"included {include.get('file')} does not get ip")
    return found


def main():
    """Check all files in launch/, and print the violations."""
    files = sorted((pathlib.Path(sys.argv[1]) / "launch").glob("*.launch"))
    wrong = [f"{path}: {text}" for path in files for text in violations(ElementTree.parse(path).getroot())]
    print("\n".join(wrong), end="\n" if wrong else "")
    if not files:
        print("no launch file found")
    sys.exit(1 if wrong or not files else 0)


if __name__ == "__main__":
    main()
