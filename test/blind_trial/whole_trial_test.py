# Tests a very small blind trial from the generation of cases to the figures, and wrong data sheets.
# Usage: whole_trial_test.py FOLDER. The folder contains the commands `diagnose`, `judge_again` and `replay`.
"""Tests of the blind trial with the real commands."""
import filecmp
import os
import re
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))

import numpy as np  # noqa: E402

import replayed  # noqa: E402
import wrong_sheets  # noqa: E402

PROGRAMS = sys.argv.pop(1) if __name__ == "__main__" else ""
REPLAY = os.path.join(PROGRAMS, "replay")


def script(name, *words):
    """Return the output of a script in this folder."""
    return subprocess.run([os.path.join(HERE, name), *words], check=True, capture_output=True, text=True).stdout


class TrialTest(unittest.TestCase):
    """Tests of three cases with short logs and faults of a bench."""

    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory(prefix="rubber_suspension_trial_")
        cls.addClassCleanup(scratch.cleanup)
        cls.cases, cls.reports = (os.path.join(scratch.name, name) for name in ("bank", "bank_reports"))
        script("generate.py", "--cases", "3", "--seed", "3", "--duration", "0.2", "--further", "2", "--bench",
               "zeros,gain", "--form-error", "--output", cls.cases)
        script("run.py", "--cases", cls.cases, "--diagnose", os.path.join(PROGRAMS, "diagnose"), "--reports", cls.reports,
               "--evidence", "--timeout", "600")

    def judged(self, *words):
        return subprocess.run([os.path.join(PROGRAMS, "judge_again"), *words, self.cases], check=True,
                              capture_output=True, text=True).stdout

    def test_the_evidence_gives_the_verdicts_again(self):
        reports = {f"bank/{name}": replayed.read_json(os.path.join(self.reports, name, "report.json"))["verdict"]
                   for name in os.listdir(self.reports)}
        self.assertEqual(dict(re.findall(r"^(\S+): (\w+) \[.*\]$", self.judged("--verdicts"), re.MULTILINE)), reports)

    def test_every_case_is_counted(self):
        page = self.judged()
        self.assertIn("3 cases, 0 of them without evidence", page)
        self.assertRegex(page, r"(?m)^\| all \| 3 \|")
        table = re.search(r"\| stated (.*?)(\n\n|$)", page, re.DOTALL)[1]
        self.assertEqual(sum(map(int, re.findall(r"^\| \S+ to \S+ \| (\d+) \|", table, re.MULTILINE))), 3)

    def test_reports_keep_the_rules_and_are_found_again(self):
        figures = os.path.join(self.reports, "score.json")
        script("score.py", "--cases", self.cases, "--reports", self.reports, "--replay", REPLAY, "--json", figures)
        result = replayed.read_json(figures)
        os.remove(figures)
        self.assertEqual((result["cost"]["of"], result["cost"]["failed"]), (3, 0))
        for name, figure in result["rows"].items():
            if "rate" in figure and "intervals" not in name:
                self.assertEqual(figure["hits"], figure["of"], name)
        for case in result["by_case"]:
            self.assertGreater(case["further"]["re_estimated"], 0.0)


class WrongSheetsTest(unittest.TestCase):
    """Tests of one bench of each model with a wrong data sheet."""

    def write(self, folder):
        cases = os.path.join(folder, "cases")
        script("wrong_sheets.py", cases, "--cases", "4", "--replay", REPLAY)
        return [os.path.join(cases, name) for name in sorted(os.listdir(cases))]

    def test_lack_nothing_that_the_sheet_could_not(self):
        with tempfile.TemporaryDirectory() as folder:
            for case in self.write(folder):
                for name in ("sines", "road"):
                    log = f"{case}/{name}.csv"
                    measured = replayed.recorded_force(log)
                    simulated = replayed.replay(REPLAY, case + "/component.yaml", "bush", log)
                    gap = np.std(measured - simulated) / np.std(measured)
                    self.assertGreater(gap, wrong_sheets.NOISE)  # the sheet is wrong
                    self.assertLess(gap, 4.0 * wrong_sheets.OFF["static_stiffness"])  # by errors of usual size

    def test_are_the_same_of_the_same_seed(self):
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
            for first, second in zip(self.write(one), self.write(other)):
                self.assertEqual(filecmp.cmpfiles(first, second, os.listdir(first), shallow=False)[1:], ([], []))


if __name__ == "__main__":
    unittest.main()
