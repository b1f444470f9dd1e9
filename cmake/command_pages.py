#!/usr/bin/python3
"""Generates files from the --help-all of the commands: man pages, the completion of rubber-suspension for bash, the
list that its --help prints, and the page docs/commands.md.

Usage: command_pages.py VERSION FOLDER PROGRAM...
"""

import gzip
import itertools
import pathlib
import re
import subprocess
import sys
import textwrap

WIDTH, INDENT = 100, 20  # of the list of commands
# Names, placeholder, meaning, and continuation lines of the meaning.
OPTION = re.compile(r"^  (\S+)((?: \S+)*)(?:  +(\S.*))?((?:\n   .*)*)$", re.M)
EXIT_STATUS = (".SH EXIT STATUS\n0, or 1 where the data could not be used, or 2 on wrong options; errors are one line on the "
               "standard error.\n")
REFERENCE = """# Reference of the commands

Written by every build from what they print: `rosrun rubber_suspension COMMAND --help-all`. All exit with
0, with 1 where the data could not be used, with 2 on wrong options; errors are one line on stderr.
"""


class Help:
    """The parts of the output of a command with --help-all (src/command_line/help.h)."""

    def __init__(self, program):
        self.command = pathlib.Path(program).name
        self.text = subprocess.run([program, "--help-all"], check=True, stdout=subprocess.PIPE, text=True).stdout
        head, _, self.examples = self.text.partition("\nExamples:\n")
        self.description, self.usage, options = re.split(rf"^Usage: {self.command}(.*)$", head, maxsplit=1, flags=re.M)
        self.options = [(names.split(","), placeholder.strip(), " ".join((meaning + more).split()))
                        for names, placeholder, meaning, more in OPTION.findall(options)]

    def phrase(self):
        """Returns the first sentence of the description for lists, without capital and full stop."""
        sentence = " ".join(self.description.split("\n\n")[0].split()).split(". ")[0]
        return sentence[:1].lower() + sentence[1:].rstrip(".")

    def with_placeholder(self, word):
        return " ".join(names[-1] for names, placeholder, _ in self.options if placeholder.startswith(word))


def roff(text):
    """Escapes text for roff: hyphens must not become dashes, nor lines requests."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def lines_in_roff(text):
    """Returns lines in roff; those that begin with blanks keep their layout."""
    result = ""
    for laid_out, lines in itertools.groupby(text.rstrip("\n").split("\n"), lambda line: line.startswith(" ")):
        block = "".join(roff(line) + "\n" if line else ".PP\n" for line in lines)
        result += f".nf\n{block}.fi\n" if laid_out else block
    return result


def page_of(name, version, phrase, body):
    """Returns a man page without a date, so that builds are reproducible."""
    return (f'.TH {roff(name.upper())} 1 "" "rubber_suspension {version}" "User Commands"\n'
            f".SH NAME\n{roff(name)} \\- {roff(phrase)}\n.SH SYNOPSIS\n.B {body}")


def man_page(entry, version):
    body = f"rubber\\-suspension {roff(entry.command)}\n{roff(entry.usage.strip())}\n"
    body += ".SH DESCRIPTION\n" + lines_in_roff(entry.description) + ".SH OPTIONS\n"
    for names, placeholder, meaning in entry.options:
        names = ", ".join(f"\\fB{roff(name)}\\fR" for name in names)
        body += f".TP\n{names}" + (f" \\fI{roff(placeholder)}\\fR" if placeholder else "") + f"\n{roff(meaning)}\n"
    if entry.examples:
        body += ".SH EXAMPLES\n" + lines_in_roff(entry.examples)
    return page_of(f"rubber-suspension-{entry.command}", version, entry.phrase(),
                   body + EXIT_STATUS + ".SH SEE ALSO\n.BR rubber\\-suspension (1)\n")


def man_page_of_all(entries, version):
    body = ("rubber\\-suspension\n.I COMMAND\n[OPTIONS]\n.SH DESCRIPTION\nRuns a command of the package rubber_suspension, as "
            "rosrun does, without looking for the package first.\n.SH COMMANDS\n")
    for entry in entries:
        body += f".TP\n.BR rubber\\-suspension\\-{roff(entry.command)} (1)\n{roff(entry.phrase())}\n"
    return page_of("rubber-suspension", version, "simulates rubber components of vehicle suspensions and diagnoses the gap to "
                   "measured logs", body + EXIT_STATUS)


def completion(entries):
    cases = ""
    for entry in entries:
        options = " ".join(name for names, _, _ in entry.options for name in names if name.startswith("--"))
        cases += (f'    {entry.command}) options="{options}" files="{entry.with_placeholder("FILE")}" '
                  f'folders="{entry.with_placeholder("FOLDER")}" ;;\n')
    template = pathlib.Path(__file__).with_name("completion.bash").read_text(encoding="utf-8")
    names = " ".join(entry.command for entry in entries)
    return template.replace("@COMMANDS@", names).replace("    @CASES@\n", cases)


def command_list(entries):
    lines = (textwrap.wrap(entry.phrase(), WIDTH, initial_indent=f"  {entry.command:<{INDENT - 2}}",
                           subsequent_indent=" " * INDENT, break_on_hyphens=False) for entry in entries)
    return "".join("\n".join(part) + "\n" for part in lines)


def reference(entries):
    return REFERENCE + "".join(f"\n## {e.command}\n\n```\n{e.text.rstrip()}\n```\n" for e in entries)


def main(version, folder, programs):
    entries = sorted((Help(program) for program in programs), key=lambda entry: entry.command)
    pages = {f"rubber-suspension-{entry.command}": man_page(entry, version) for entry in entries}
    pages["rubber-suspension"] = man_page_of_all(entries, version)
    for name, text in pages.items():
        (folder / f"{name}.1.gz").write_bytes(gzip.compress(text.encode(), mtime=0))
    for name, write in (("rubber-suspension", completion), ("commands.txt", command_list), ("commands.md", reference)):
        (folder / name).write_text(write(entries), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:])
