"""Tests of the comparison of two builds. Programs that write given files replace the real ones."""
import contextlib
import io
import json
import os
import tempfile
import unittest
from unittest import mock

import baseline

PROGRAM = """#!/usr/bin/python3
import os, shutil, sys
given = os.path.join(os.path.dirname(sys.argv[0]), "given")
output = sys.argv[sys.argv.index("--output") + 1]
if os.path.basename(sys.argv[0]) == "replay":
    shutil.copy(os.path.join(given, "force.csv"), output)
else:
    for name in ("report.json", "evidence.json"):
        shutil.copy(os.path.join(given, name), output)
"""
REPORT = {"verdict": "named", "effects": ["friction"], "gap": {"augmented": 0.02}, "meta": {"date": "today"}}


class BaselineTest(unittest.TestCase):
    """Tests with an old and a new build and two cases of a bench."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory(prefix="rubber_suspension_baseline_")
        self.addCleanup(scratch.cleanup)
        self.folder = scratch.name
        for case in ("cases/one", "cases/two"):  # the second case runs the new build first
            self.write(f"{case}/component.yaml", "components:\n  bush:\n    model: elements\n")
            self.write(f"{case}/log_1.csv", "time_s,displacement_m,force_N\n")
        for build in ("old", "new"):
            for program in ("diagnose", "replay"):
                self.write(f"{build}/lib/rubber_suspension/{program}", PROGRAM)
                os.chmod(os.path.join(self.folder, f"{build}/lib/rubber_suspension/{program}"), 0o755)
            self.give(build, REPORT, {"chi_squared": [1.0, 2.0]}, "0,0,1\n")

    def write(self, name, text):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)

    def give(self, build, report, evidence, force):
        given = f"{build}/lib/rubber_suspension/given/"
        self.write(given + "report.json", json.dumps(report))
        self.write(given + "evidence.json", json.dumps(evidence))
        self.write(given + "force.csv", force)

    def compared(self, *more):
        """Return the exit status and output of the script."""
        printed = io.StringIO()
        arguments = ["baseline.py", os.path.join(self.folder, "cases"), "--old", os.path.join(self.folder, "old"), "--new",
                     os.path.join(self.folder, "new"), "--output", os.path.join(self.folder, "output"), *more]
        with contextlib.redirect_stdout(printed), mock.patch("sys.argv", arguments):
            status = baseline.main()
        return status, printed.getvalue()

    def test_equal_builds_are_equal(self):
        self.give("new", {**REPORT, "meta": {"date": "tomorrow"}, "added": 1}, {"chi_squared": [1.0, 2.0]}, "0,0,1\n")
        status, printed = self.compared()
        self.assertEqual(status, 0, printed)
        self.assertEqual(printed.count("equal in all"), 5, printed)
        self.assertIn("peak memory [MiB]", printed)

    def test_each_difference_is_found(self):
        for what, given in (("conclusion", ({**REPORT, "verdict": "none"}, {"chi_squared": [1.0, 2.0]}, "0,0,1\n")),
                            ("evidence", (REPORT, {"chi_squared": [1.0, 2.0000001]}, "0,0,1\n")),
                            ("replay", (REPORT, {"chi_squared": [1.0, 2.0]}, "0,0,1.0\n"))):
            with self.subTest(what):
                self.give("new", *given)
                status, printed = self.compared()
                self.assertEqual(status, 1, printed)
                self.assertRegex(printed, f"{what} +differs in 2: ")

    def test_a_tolerance_is_relative(self):
        self.give("new", REPORT, {"chi_squared": [1.0, 2.0000001]}, "0,0,1\n")
        self.assertEqual(self.compared("--tolerance", "1e-7")[0], 0)
        self.assertEqual(self.compared("--tolerance", "1e-9")[0], 1)

    def test_a_key_that_is_gone_is_a_difference(self):
        self.give("new", {key: value for key, value in REPORT.items() if key != "effects"}, {"chi_squared": [1.0, 2.0]},
                  "0,0,1\n")
        self.assertEqual(self.compared()[0], 1)

    def test_a_folder_without_cases_is_refused(self):
        with self.assertRaisesRegex(SystemExit, "holds no case"):
            list(baseline.cases_of([os.path.join(self.folder, "old")]))


if __name__ == "__main__":
    unittest.main()
