#!/usr/bin/python3
"""Tests of messages about options: options without effect are refused, misspelt options are named, unusual values cause
a warning, each in one line on stderr. The examples in the help work as printed.

Usage: usage_test.py FOLDER_OF_THE_COMMANDS
"""
import fcntl
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAMS = pathlib.Path(sys.argv[1]).resolve()
CONFIG = pathlib.Path(__file__).resolve().parents[2] / "config"
EXAMPLE = str(CONFIG / "example.yaml")
BUSH = str(CONFIG / "diagnosis_example" / "component.yaml")
LOG = str(CONFIG / "diagnosis_example" / "log_1_sweep.csv")
WRONG_USAGE = 2

# Command line, and words in its single line on stderr.
REFUSED = (
    ("estimate --data-sheet x.yaml --csv x.csv", "--csv has no effect with --data-sheet"),
    ("estimate --data-sheet x.yaml --component a", "--component has no effect with --data-sheet"),
    ("estimate --data-sheet x.yaml --without-rig", "--without-rig has no effect with --data-sheet"),
    ("estimate --data-sheet x.yaml --json", "--json has no effect with --data-sheet"),
    (f"estimate --config {EXAMPLE} --output x.yaml", "--output has no effect without --from-log, --from-table or --data-sheet"),
    (f"estimate --config {EXAMPLE} --sampling-rate 100", "--sampling-rate has no effect without --from-log"),
    (f"estimate --config {EXAMPLE} --from-log {LOG} --amplitude 1e-3", "--amplitude has no effect with --from-log"),
    (f"estimate --config {EXAMPLE} --force", "--force has no effect because no file is written"),
    ("replay --config c --log x.bag --output o.csv --decimal ,", "--segment and --bridge have no effect on a bag"),
    (f"play_log --component a --log {LOG} --paused --step 1", "--paused has no effect with --step"),
    (f"play_log --component a --log {LOG} --force", "--force has no effect because no file is written"),
    (f"check_force --component a --log {LOG} --tolerance 1 --config-component b", "has no effect without --config"),
    ("benchmark --quick --long-log 60", "--quick has no effect with --long-log"),
    ("benchmark_latency --soak 1000 --sampling-rate 100", "--sampling-rate has no effect with --soak"),
    (f"half_bogie --config c --track {LOG} --reset a", "--reset has no effect without --forces topics"),
    (f"diagnose --config {BUSH} --log {LOG} --hold-out {LOG} --output o", "is the same file as --log"),
    (f"diagnose --config {BUSH} --log {LOG} --output o --direction x --plot p.svg", "--plot has no effect with --direction"),
    (f"diagnose --config {BUSH} --log {LOG} --output o --direction x --direction x", "--direction: x is given twice"),
    (f"replay --config {BUSH} --log {LOG} --output o --sampling-rate 0", "out of range; accepted: greater than 0"),
    (f"replay --config {BUSH} --log {LOG} --output o --unit mm,kN", "accepted: QUANTITY=UNIT"),
    (f"replay --config {BUSH} --log {LOG} --output o --decimal ;", "accepted: , or . (comma or point)"),
    # The messages suggest what was probably meant.
    (f"replay --confg {BUSH} --log {LOG}", "no option --confg (did you mean --config?)"),
    (f"estimate {BUSH}", f"accepted: --config {BUSH}"),
    (f"replay --config {BUSH} --log {LOG} --output o --rate 9", "no option --rate (did you mean --sampling-rate?)"),
    (f"play_log --component a --log {LOG} --rate 2", "no option --rate (did you mean --sampling-rate?)"),
    (f"play_log --component a --log {LOG} --speed 2", "no option --speed (did you mean --playback-speed?)"),
    (f"estimate --config {BUSH} --amplitude 2,5mm", "--amplitude: '2,5mm': a decimal comma (did you mean '2.5mm'?)"),
    (f"estimate --config {BUSH} --amplitude=-2mm", "'-2mm' is out of range; accepted: greater than 0 mm"),
    (f"estimate --config {BUSH} --frequency 1e308", "is out of range; accepted: greater than 0, at most 1e+30 Hz"),
    (f"replay --config {BUSH} --log {LOG} --output o --columns froce=2", "(did you mean 'force'?)"),
)


def run(line):
    command, *arguments = line.split()
    return subprocess.run([PROGRAMS / command, *arguments], capture_output=True, text=True, timeout=60, check=False)


class Usage(unittest.TestCase):
    def test_refusals(self):
        for line, message in REFUSED:
            if not (PROGRAMS / line.split()[0]).exists():  # half_bogie needs Simbody
                continue
            with self.subTest(line), tempfile.TemporaryDirectory() as folder:
                answer = run(line.replace("--output o", f"--output {folder}/o"))
                self.assertEqual(answer.returncode, WRONG_USAGE, answer.stderr)
                self.assertIn(message, answer.stderr)
                self.assertEqual(answer.stderr.count("\n"), 1)


# These commands have examples that take no node and no minutes. Each finds the output of earlier ones in this order.
EXEMPLIFIED = ("csv_to_bag", "bag_to_csv", "replay", "export", "estimate", "diagnose",
               "campaign", "reference", "half_bogie")
ELSEWHERE = ("man -l", "--forces topics")  # examples that need a node or a program that may be missing
SHEET = ("data_sheet:\n  component: bush\n  load: compression\n  shore_a: 60\n  loaded_area: 100 cm^2\n"
         "  layer_thickness: 20 mm\n  shape_factor: 1.25\n  dynamic_to_static_ratio: 1.4\n  nominal_frequency: 4 Hz\n"
         "  loss_angle: 5.7 deg\n")
JOBS = "jobs:\n  one:\n    command: replay\n    config: component.yaml\n    log: log.csv\n"


def examples_of(command):
    """Return the command lines under "Examples" in --help."""
    answer = subprocess.run([PROGRAMS / command, "--help"], capture_output=True, text=True, timeout=60, check=True)
    text = answer.stdout.partition("\nExamples:\n")[2].replace("\\\n", " ")
    return [line.strip() for line in text.splitlines() if not line.startswith("  #")]


class Examples(unittest.TestCase):
    def test_work_as_printed(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            for path in (BUSH, EXAMPLE, CONFIG / "half_bogie.yaml", CONFIG / "hung_body.yaml"):
                (folder / pathlib.Path(path).name).write_text(pathlib.Path(path).read_text(encoding="utf-8"), encoding="utf-8")
            rows = pathlib.Path(LOG).read_text(encoding="utf-8").splitlines()[:2001]
            cells = [row.split(",") for row in rows]
            for file, lines in {
                "log.csv": rows, "log_2.csv": rows[:1] + rows[1001:], "track.csv": [",".join(row[:2]) for row in cells],
                "programme.csv": [",".join(row[:2]) for row in cells], "raw.csv": rows[1:],
                "untimed.csv": [",".join(row[1:]) for row in cells], "sheet.yaml": [SHEET], "jobs.yaml": [JOBS],
            }.items():
                (folder / file).write_text("\n".join(lines) + "\n", encoding="utf-8")
            for command in EXEMPLIFIED:
                if not (PROGRAMS / command).exists():
                    continue
                calls = examples_of(command)
                self.assertEqual(len(calls), 3)
                for call in calls:
                    if not any(word in call for word in ELSEWHERE):
                        self.check(call, folder)

    def check(self, call, folder):
        rosrun = 'rosrun() { "$PROGRAMS/$2" "${@:3}"; }; '
        with self.subTest(call):
            answer = subprocess.run(["bash", "-c", rosrun + call], cwd=folder, capture_output=True, text=True, timeout=300,
                                    env={**os.environ, "PROGRAMS": str(PROGRAMS)}, check=False)
            self.assertEqual(answer.returncode, 0, answer.stderr)


class Folders(unittest.TestCase):
    def test_one_run_at_a_time_writes_into_a_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            descriptor = os.open(folder, os.O_RDONLY)
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX)  # as a run in progress does
                answer = run(f"diagnose --config {BUSH} --log {LOG} --output {folder}")
            finally:
                os.close(descriptor)
            self.assertEqual(answer.returncode, WRONG_USAGE)
            self.assertIn(f"{folder}: another run is writing into this folder; accepted: another folder", answer.stderr)
            self.assertEqual(answer.stderr.count("\n"), 1)
            self.assertEqual(os.listdir(folder), [])

    def test_a_run_that_fails_leaves_no_folder(self):
        with tempfile.TemporaryDirectory() as folder:
            answer = run(f"diagnose --config {BUSH} --log /nowhere.csv --output {folder}/report")
            self.assertNotEqual(answer.returncode, 0)
            self.assertEqual(os.listdir(folder), [])


class Warnings(unittest.TestCase):
    """Tests that warnings change neither the exit status nor the result."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def write(self, name, text):
        path = pathlib.Path(self.folder.name) / name
        path.write_text(text, encoding="utf-8")
        return path

    def check(self, line, warning):
        answer = run(line)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.assertRegex(answer.stderr, warning)
        return answer

    def test_of_metres(self):
        self.check(f"estimate --config {BUSH} --amplitude 5 --points 2", "warning: .*5 m is .*; a number without a unit is in metres")
        usual = run(f"estimate --config {BUSH} --amplitude 2mm --points 2")
        self.assertNotIn("warning", usual.stderr)

    def test_of_millimetres_in_a_column_of_metres(self):
        # The example, a log in mm and kN, is read as if its displacements were in metres.
        text = pathlib.Path(LOG).read_text(encoding="utf-8")
        self.assertIn("displacement_mm", text)
        odd = self.write("odd.csv", text.replace("displacement_mm", "displacement_m", 1))
        output = pathlib.Path(self.folder.name) / "o.csv"
        self.check(f"replay --config {BUSH} --log {odd} --output {output}", "warning: .*odd.csv: .* softer than the model predicts")
        self.assertTrue(output.exists())
        self.assertNotIn("warning", run(f"replay --config {BUSH} --log {LOG} --output {output}").stderr)

    def test_of_none_without_what_a_rig_adds(self):
        rubber = "components: {b: {model: elements, elements: [{type: spring, stiffness: 1e6}]"
        alone = self.write("alone.yaml", rubber + "}}\n")
        on_rig = self.write("rig.yaml", rubber + ", add: [{type: time_delay, delay: 0.004}, {type: inertia, mass: 20, of_rig: true}]}}\n")
        answers = [run(f"estimate --config {config} --points 2{option}").stdout
                   for config, option in ((alone, ""), (on_rig, " --without-rig"), (on_rig, ""))]
        self.assertEqual(answers[0], answers[1])
        self.assertIn("inertia", answers[2])

    def test_of_stiffnesses_that_nearly_agree(self):
        config = self.write("c.yaml", "components:\n  b:\n    model: multi_maxwell\n    specification: {static_stiffness: "
                            "10 kN/mm, dynamic_stiffness: 12.49 kN/mm, nominal_frequency: 4, maximum_stiffness: 12.5 "
                            "kN/mm, high_frequency: 25}\n")
        self.check(f"estimate --config {config} --points 2", "warning: b: maximum_stiffness: 12.5 kN/mm is only 0.08 % above")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
