#!/usr/bin/python3
"""Holds every command to one style of --help and --version, and the page that `reference commands` prints to all of them.

Usage: commands.py FOLDER_OF_THE_COMMANDS VERSION COMMAND...; one line per violation, exit status 1 if there is any.
"""

import pathlib
import re
import subprocess
import sys



def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60, check=False)


def violations(folder, command, version):
    program = folder / command
    answer = run(program, "--help")
    text = answer.stdout
    if answer.returncode != 0 or answer.stderr:
        yield f"--help ends with {answer.returncode} and says '{answer.stderr.strip()}' on stderr"
    first = text.split("\n\n")[0].split("\nUsage")[0].splitlines()[0] if text else ""
    if not re.match(r"[A-Z].*[.:]$", first):
        yield f"--help does not begin with a sentence: '{first}'"
    if f"Usage: {command} " not in text:
        yield f"--help lacks 'Usage: {command}'"
    for option in ("--help", "--version"):
        if option not in text:
            yield f"--help does not name {option}"
    for line in text.splitlines():
        match = re.match(r"  (-\S.*?)(?:\s{2,}(\S.*))?$", line)
        if match and match.group(2) and match.group(2).endswith("."):
            yield f"--help ends the description of {match.group(1).split()[0]} with a full stop"
    answer = run(program, "--version")
    if (answer.returncode, answer.stdout) != (0, f"{command} {version}\n"):
        yield f"--version prints '{answer.stdout.strip()}', not '{command} {version}'"
    answer = run(program, "--no-such-option")
    if answer.returncode != 2 or not re.fullmatch(rf"{command}: .*\n", answer.stderr) or answer.stdout:
        yield f"a wrong option ends with {answer.returncode} and '{answer.stderr.strip()}', not with 2 and one line"


def main(folder, version, commands):
    found = 0
    for command in commands:
        for violation in violations(folder, command, version):
            print(f"{command}: {violation}")
            found += 1
    page = run(folder / "reference", "commands").stdout
    for command in commands:
        if f"\n## {command}\n" not in page:
            print(f"reference commands: {command} is missing")
            found += 1
    return found


if __name__ == "__main__":
    sys.exit(1 if main(pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3:]) else 0)
