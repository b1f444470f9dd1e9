#!/usr/bin/python3
"""Tests of the command rubber-suspension, its completion in bash, its man pages, and the script that generates them.
Usage: dispatcher_test.py FOLDER_OF_THE_COMMAND FOLDER_OF_THE_PAGES VERSION COMMAND...
"""
import gzip
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = pathlib.Path(sys.argv[1]) / "rubber-suspension"
PAGES = pathlib.Path(sys.argv[2])
VERSION = sys.argv[3]
COMMANDS = sys.argv[4:]
ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIG = ROOT / "config" / "example.yaml"


def run(*arguments, program=PROGRAM):
    return subprocess.run([program, *arguments], capture_output=True, text=True, timeout=60, check=False)


def completions(*words):
    """Return the completions of the last word in bash."""
    script = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); compopt() { :; }; _rubber_suspension; ' \
             'printf "%s\\n" "${COMPREPLY[@]}"'
    answer = subprocess.run(["bash", "-c", script, "bash", PAGES / "rubber-suspension", str(PROGRAM), *words],
                            capture_output=True, text=True, timeout=60, check=True)
    return answer.stdout.split()


def rosrun_completions(*words):
    """Return the completions after rosrun in a shell that has read setup.sh only."""
    script = '. "$1"; shift; function=$(complete -p rosrun | sed -E "s/.* -F ([^ ]+) .*/\\1/"); compopt() { :; }; ' \
             'COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); "$function" rosrun; printf "%s\n" "${COMPREPLY[@]}"'
    answer = subprocess.run(["bash", "--norc", "-c", script, "bash", PROGRAM.parents[1] / "setup.sh", "rosrun", *words],
                            capture_output=True, text=True, timeout=60, check=True)
    return answer.stdout.split()


class Dispatcher(unittest.TestCase):
    def test_lists_every_command(self):
        answer = run("--help")
        self.assertEqual(answer.returncode, 0, answer.stderr)
        for command in [*COMMANDS, "generate_track", "live_plot", "render_report"]:
            self.assertIn(command, answer.stdout)
        self.assertEqual(run("--version").stdout, f"rubber-suspension {VERSION}\n")

    def test_becomes_the_command(self):
        for command in COMMANDS:
            self.assertEqual(run(command, "--version").stdout, f"{command} {VERSION}\n")
        self.assertIn("--sampling-rate", run("generate_track", "--help").stdout)
        answer = run("estimate", "--config", "/nonexistent.yaml")
        self.assertEqual(answer.returncode, 1)
        self.assertTrue(answer.stderr.startswith("estimate: /nonexistent.yaml"), answer.stderr)

    def test_scripts_show_a_screen_with_examples(self):
        for script in ("generate_track", "live_plot"):
            text = run(script, "--help").stdout
            self.assertLessEqual(text.count("\n"), 30)
            self.assertEqual(text.count(f"  rosrun rubber_suspension {script} --"), 3)

    def test_works_by_a_link(self):
        with tempfile.TemporaryDirectory() as folder:
            link = pathlib.Path(folder) / "rs"
            link.symlink_to(PROGRAM)
            self.assertEqual(run("replay", "--version", program=link).stdout, f"replay {VERSION}\n")

    def test_names_the_command_that_was_meant(self):
        answer = run("repaly")
        self.assertEqual(answer.returncode, 2)
        self.assertRegex(answer.stderr, r"\Arubber-suspension: unknown command 'repaly' \(did you mean 'replay'\?\); accepted: .*\n\Z")
        answer = run()
        self.assertEqual(answer.returncode, 2)
        self.assertIn("the command is missing; accepted: ", answer.stderr)


class Completion(unittest.TestCase):
    def test_of_commands_and_options(self):
        self.assertEqual(completions("rep"), [c for c in ("replay", "reproduce_paper") if c in COMMANDS])
        self.assertEqual(completions("replay", "--con"), ["--config"])
        self.assertIn("--sampling-rate", completions("generate_track", "--s"))

    def test_of_files_and_components(self):
        self.assertEqual(completions("replay", "--config", str(CONFIG)[:-1]), [str(CONFIG)])
        self.assertEqual(completions("replay", "--config", str(CONFIG), "--component", "left"), ["left_secondary"])
        folders = completions("diagnose", "--log", "x", "--output", str(CONFIG.parents[1]) + "/conf")
        self.assertEqual(folders, [str(CONFIG.parent)])


    def test_behind_rosrun(self):
        self.assertEqual(rosrun_completions("rubber_suspension", "replay", "--con"), ["--config"])
        self.assertIn("--sampling-rate", rosrun_completions("rubber_suspension", "replay", "--s"))
        self.assertEqual(rosrun_completions("rubber_suspension", "replay", "--config", str(CONFIG), "--component", "left"),
                         ["left_secondary"])
        self.assertIn("--sampling-rate", rosrun_completions("rubber_suspension", "generate_track", "--s"))

    def test_leaves_the_rest_to_rosbash(self):
        self.assertIn("rubber_suspension", rosrun_completions("rubber_susp"))


class ManPages(unittest.TestCase):
    def test_are_all_there(self):
        names = {path.name for path in PAGES.glob("*.1.gz")}
        self.assertEqual(names, {"rubber-suspension.1.gz", *(f"rubber-suspension-{c}.1.gz" for c in COMMANDS)})

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_are_valid(self):
        for path in PAGES.glob("*.1.gz"):
            text = subprocess.run(["gzip", "-dc", path], capture_output=True, check=True).stdout
            answer = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=text, capture_output=True, check=False)
            self.assertEqual((answer.returncode, answer.stderr), (0, b""), path.name)


HELP = """Simulates a component on a log. Nothing else; a line
.so /etc/passwd \\n

Parameters:
  ~max_gap            longest time
Usage: replay [OPTIONS] [page]

Positionals:
  page                      page to print (a, b; default
                            a)

Options:
  -h,--help                 Print this help message and exit
  --config FILE             component file (required)
  --connect-timeout SECONDS
                            time to wait for the node (0.01 to 1e+06;
                            default 300)
  --components COUNT ...    numbers of components
  --output FOLDER           folder of the report

Examples:
  # A log
  rosrun rubber_suspension replay --log a.csv \\
      --output b.csv
"""


class Script(unittest.TestCase):
    """Tests of the output of cmake/command_pages.py for the help of one command."""

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            program = folder / "replay"
            program.write_text(f"#!/bin/sh\ncat <<'END'\n{HELP}END\n", encoding="ascii")
            program.chmod(0o755)
            subprocess.run([ROOT / "cmake" / "command_pages.py", "1.2.3", folder, program], check=True)
            cls.man = gzip.decompress((folder / "rubber-suspension-replay.1.gz").read_bytes()).decode()
            cls.completion, cls.list, cls.reference = (
                (folder / page).read_text(encoding="utf-8") for page in ("rubber-suspension", "commands.txt", "commands.md"))

    def test_man_page_has_the_options_in_roff(self):
        for part in ('.TH RUBBER\\-SUSPENSION\\-REPLAY 1 "" "rubber_suspension 1.2.3"',
                     "rubber\\-suspension\\-replay \\- simulates a component on a log\n", "\n[OPTIONS] [page]\n",
                     ".TP\n\\fBpage\\fR\npage to print (a, b; default a)\n",
                     ".TP\n\\fB\\-h\\fR, \\fB\\-\\-help\\fR\n",
                     ".TP\n\\fB\\-\\-config\\fR \\fIFILE\\fR\ncomponent file (required)\n",
                     "\\fISECONDS\\fR\ntime to wait for the node (0.01 to 1e+06; default 300)\n",
                     ".nf\n  ~max_gap            longest time\n.fi\n", ".SH EXAMPLES\n.nf\n  # A log\n"):
            self.assertIn(part, self.man)

    def test_no_text_is_a_request_of_roff(self):
        self.assertIn("\n\\&.so /etc/passwd \\en\n", self.man)

    def test_list_has_the_phrase_of_each_command(self):
        self.assertEqual(self.list, "  replay            simulates a component on a log\n")

    def test_completion_knows_options_files_and_folders(self):
        self.assertIn('    replay) options="--help --config --connect-timeout --components --output" files="--config" '
                      'folders="--output" ;;\n', self.completion)

    def test_reference_has_the_help_as_it_is(self):
        self.assertTrue(self.reference.endswith(f"\n## replay\n\n```\n{HELP}```\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
