#!/usr/bin/python3
"""Checks that all commands have one style of --help, --help-all and --version, equal to docs/commands.md.

Usage: commands.py VERSION PAGE PRINTED_PAGE PROGRAM... Prints a line per violation; exit status 1 if there is any.
"""

import pathlib
import re
import subprocess
import sys


WIDTH = 100  # characters per line of a terminal and of a page
SCREEN = 30  # largest number of lines of --help
EXAMPLES = 3
# Name, placeholder, and description with its continuation lines.
OPTION = re.compile(r"^  ((?:-\w,)?--[\w-]+)(?: (\S+))?[^\n]*?\s{2,}(\S[^\n]*(?:\n {28}[^\n]*)*)$", re.M)


def run(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60, check=False)


def violations(program, version):
    command = program.name
    answer = run(program, "--help")
    text = answer.stdout
    if answer.returncode != 0 or answer.stderr:
        yield f"--help ends with {answer.returncode} and says '{answer.stderr.strip()}' on stderr"
    first = text.split("\n\n")[0].split("\nUsage")[0].splitlines()[0] if text else ""
    if not re.match(r"[A-Z][a-z]+s ", first) or not re.split(r"\nUsage|\n\n", text)[0].endswith("."):
        yield f"--help does not begin with a sentence that says what the command does: '{first}'"
    for line in text.splitlines():
        if len(line) > WIDTH and not line.startswith("Usage"):
            yield f"--help has a line of {len(line)} characters, more than {WIDTH}: '{line[:40]}...'"
    if f"Usage: {command} " not in text:
        yield f"--help lacks 'Usage: {command}'"
    for option in ("--help", "--version"):
        if option not in text:
            yield f"--help does not name {option}"
    yield from screen_violations(command, text, run(program, "--help-all").stdout)
    answer = run(program, "--version")
    if (answer.returncode, answer.stdout) != (0, f"{command} {version}\n"):
        yield f"--version prints '{answer.stdout.strip()}', not '{command} {version}'"
    answer = run(program, "--no-such-option")
    if answer.returncode != 2 or not re.fullmatch(rf"{command}: .*\n", answer.stderr) or answer.stdout:
        yield f"a wrong option ends with {answer.returncode} and '{answer.stderr.strip()}', not with 2 and one line"
    answer = run(program, "--versoin")
    if answer.returncode != 2 or "(did you mean --version?)" not in answer.stderr:
        yield f"a misspelt option ends with {answer.returncode} and '{answer.stderr.strip()}', without the right one"


def screen_violations(command, screen, everything):
    """Check that --help is one screen with examples, and that --help-all contains it and more in the same style."""
    if screen.count("\n") > SCREEN:
        yield f"--help has {screen.count(chr(10))} lines, more than a screen of {SCREEN}"
    known = options_in(everything)
    for option in sorted(options_in(screen) - known):
        yield f"--help names {option}, which --help-all does not"
    for line in everything.splitlines():
        if len(line) > WIDTH and not line.startswith("Usage"):
            yield f"--help-all has a line of {len(line)} characters, more than {WIDTH}: '{line[:40]}...'"
    examples = screen.partition("\nExamples:\n")[2]
    calls = re.findall(rf"^  rosrun rubber_suspension {command} ", examples, re.M)
    if len(calls) != EXAMPLES or not everything.endswith(examples):
        yield f"--help has {len(calls)} examples, not {EXAMPLES}, or --help-all has others"
    yield from option_violations(everything)


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][\w-]*", text))


def option_violations(text):
    """Check the style of options: a placeholder that names the value, a description without capital and full stop."""
    for option, placeholder, description in OPTION.findall(text):
        if placeholder in ("TEXT", "INT", "UINT", "FLOAT"):
            yield f"--help does not say what {option} takes"
        if description.endswith("."):
            yield f"--help ends the description of {option} with a full stop"
        if re.match(r"[A-Z][a-z]", description) and option not in ("-h,--help", "--help-all", "--version"):
            yield f"--help begins the description of {option} with a capital letter"


def sections(page):
    """Return the text of each command in a reference page by its name. The introduction has an empty name."""
    parts = re.split(r"^## (\w+)$", page, flags=re.M)
    return dict(zip(["", *parts[1::2]], [part.strip() for part in parts[::2]]))


def page_violations(page, printed_page, commands):
    """Compare the page with the printed one, except for commands that are not built because a library is missing."""
    page, printed = sections(page.read_text()), sections(printed_page.read_text())
    for name in ["", *commands]:
        if name not in printed:
            yield f"{printed_page}: {name} is missing"
        elif page.get(name) != printed[name]:
            yield (f"docs/commands.md: {name or 'the introduction'} differs from what is printed; "
                   f"after a change: cp {printed_page} docs/commands.md")


def main(version, page, printed_page, programs):
    found = 0
    for program in programs:
        for violation in violations(program, version):
            print(f"{program.name}: {violation}")
            found += 1
    for violation in page_violations(page, printed_page, [program.name for program in programs]):
        print(violation)
        found += 1
    return found


if __name__ == "__main__":
    paths = [pathlib.Path(path) for path in sys.argv[2:]]
    sys.exit(1 if main(sys.argv[1], paths[0], paths[1], paths[2:]) else 0)
