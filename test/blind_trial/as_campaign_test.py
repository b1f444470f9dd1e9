# A very small blind trial with its calibration, from nothing to figures through `campaign`.
# as_campaign_test.py FOLDER: that of the commands `campaign` and `judge_again`.
"""Tests of the blind trial as a campaign."""
import filecmp
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import numpy as np  # noqa: E402

import as_campaign  # noqa: E402
import wrong_sheets  # noqa: E402

SIZE = as_campaign.SIZES["tiny"]
SETS = (*as_campaign.CALIBRATED_ON, *as_campaign.JUDGED_BY[1])
CASES = sum(SIZE[name] for name in SETS)


def trial(programs, folder, *more):
    """What `as_campaign.py` prints of a whole trial in that folder."""
    return subprocess.run([sys.executable, os.path.join(HERE, "as_campaign.py"), "--size", "tiny", "--seed", "3",
                           "--programs", programs, "--output", folder, *more], check=True, capture_output=True,
                          text=True).stdout


class TrialTest(unittest.TestCase):
    """Two cases of the bank, one of a bench, two of the trial, with short logs."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory(prefix="rubber_suspension_trial_")
        cls.folder = os.path.join(cls.scratch.name, "trial")
        cls.campaign = os.path.join(cls.folder, "campaign")
        cls.said = cls.trial()
        with open(os.path.join(cls.campaign, "table.json"), encoding="utf-8") as file:
            cls.rows = {row["group"]: row for row in json.load(file)["jobs"]}

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    @classmethod
    def trial(cls):
        return trial(TrialTest.programs, cls.folder)

    def read(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8") as file:
            return file.read()

    def test_every_case_is_a_job(self):
        self.assertEqual(len(self.rows), CASES)
        self.assertEqual({row["status"] for row in self.rows.values()}, {"done"})
        self.assertEqual({name.split("_")[0] for name in self.rows}, set(SETS))

    def test_the_trial_alone_is_scored(self):
        result = json.loads(self.read("score.json"))
        self.assertEqual((result["cases"], result["missing"], result["cost"]["of"]), (SIZE["test"], 0, SIZE["test"]))
        for case in result["by_case"]:
            self.assertEqual(case["verdict"], self.rows["test_" + case["case"]]["values"]["verdict"])
        self.assertIn(f"Blind trial: {SIZE['test']} cases, 0 without a report", self.read("score.md"))

    def test_the_banks_alone_are_calibrated_on(self):
        page = self.read("calibration.md")
        counted = re.search(r"^(\d+) cases, (\d+) of them without evidence", page)
        self.assertIsNotNone(counted, page)
        self.assertEqual((int(counted[1]), int(counted[2])), (SIZE["bank"] + SIZE["bench"], 0))
        self.assertRegex(page, rf"(?m)^\| all \| {counted[1]} \|")
        table = re.search(r"\| stated (.*?)(\n\n|$)", page, re.DOTALL)[1]
        stated = re.findall(r"^\| \S+ to \S+ \| (\d+) \|", table, re.MULTILINE)
        self.assertEqual(sum(map(int, stated)), int(counted[1]))

    def test_the_evidence_gives_the_verdicts_again(self):
        said = subprocess.run([os.path.join(self.programs, "judge_again"), "--verdicts", "--campaign", self.campaign,
                               "--labels", os.path.join(self.folder, "bank_labels"), "--labels",
                               os.path.join(self.folder, "test_labels")], check=True, capture_output=True, text=True)
        again = dict(re.findall(r"^(\w+): (\w+) \[.*\]$", said.stdout, re.MULTILINE))
        self.assertEqual(again, {name: row["values"]["verdict"] for name, row in self.rows.items()
                                 if not name.startswith("bench")})

    def test_nothing_is_done_twice(self):
        before = self.read("score.json")
        self.assertIn(f"0 jobs done, 0 failed, {CASES} passed over", self.trial())
        self.assertEqual(self.read("score.json"), before)

    def test_an_unfinished_campaign_is_not_scored(self):
        record = os.path.join(self.campaign, "results", self.rows["test_case_000"]["id"][:2],
                              self.rows["test_case_000"]["id"][2:] + ".json")
        os.rename(record, record + ".away")
        try:
            said = subprocess.run([sys.executable, os.path.join(HERE, "score.py"), "--cases",
                                   os.path.join(self.folder, "test"), "--campaign", self.campaign], check=False,
                                  capture_output=True, text=True)
        finally:
            os.rename(record + ".away", record)
        self.assertNotEqual(said.returncode, 0)
        self.assertIn("test_case_000 is not done", said.stderr)


class Trial2Test(unittest.TestCase):
    """The same with trial 2: without measured logs, and so without implants, which is said."""

    def test_it_is_scored_on_further_logs(self):
        with tempfile.TemporaryDirectory(prefix="rubber_suspension_trial_") as scratch:
            with mock.patch.dict(os.environ, RUBBER_SUSPENSION_DATA=os.path.join(scratch, "nothing")):
                said = trial(TrialTest.programs, os.path.join(scratch, "trial"), "--trial", "2")
            with open(os.path.join(scratch, "trial", "score.json"), encoding="utf-8") as file:
                result = json.load(file)
        self.assertRegex(said, "no measured logs below .*: the implants are left out")
        self.assertEqual((result["cases"], result["missing"]), (SIZE["trial_2"], 0))
        for case in result["by_case"]:
            self.assertGreater(case["further"]["re_estimated"], 0.0)
            self.assertIsNot(case["further"]["same_re_estimated"], False)


class WrongSheetsTest(unittest.TestCase):
    """One bench of each model whose sheet is wrong."""

    def write(self, folder):
        cases = os.path.join(folder, "cases")
        subprocess.run([os.path.join(HERE, "wrong_sheets.py"), cases, "--cases", "4", "--replay",
                        os.path.join(TrialTest.programs, "replay")], check=True, capture_output=True)
        return [os.path.join(cases, name) for name in sorted(os.listdir(cases))]

    def test_lack_nothing_that_the_sheet_could_not(self):
        with tempfile.TemporaryDirectory() as folder:
            for case in self.write(folder):
                for name in ("sines", "road"):
                    measured = np.loadtxt(os.path.join(case, name + ".csv"), delimiter=",", skiprows=1)[:, 2]
                    force = os.path.join(folder, "force.csv")
                    subprocess.run([os.path.join(TrialTest.programs, "replay"), "--config", case + "/component.yaml", "--log",
                                    f"{case}/{name}.csv", "--output", force, "--force"], check=True, capture_output=True)
                    simulated = np.loadtxt(force, delimiter=",", skiprows=1)[:, -1]
                    gap = np.std(measured - simulated) / np.std(measured)
                    self.assertGreater(gap, wrong_sheets.NOISE)  # the sheet is wrong,
                    self.assertLess(gap, 4.0 * wrong_sheets.OFF["static_stiffness"])  # by what sheets are off

    def test_are_the_same_of_the_same_seed(self):
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
            for first, second in zip(self.write(one), self.write(other)):
                self.assertEqual(filecmp.cmpfiles(first, second, os.listdir(first), shallow=False)[1:], ([], []))


if __name__ == "__main__":
    TrialTest.programs = sys.argv.pop(1)
    unittest.main()
