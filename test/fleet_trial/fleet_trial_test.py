# A small check of the fleet statistics with virtual test pieces, from logs to verdicts.
# Usage: fleet_trial_test.py CAMPAIGN, the path of the command.
"""Tests of the fleet statistics with simulated logs."""
import json
import os
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

from generate import FLEETS, SCATTER, generate  # noqa: E402

PIECES = 8


class FleetTest(unittest.TestCase):
    """Tests with six fleets of eight test pieces. Thresholds are minimum requirements for such small fleets."""

    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory(prefix="rubber_suspension_fleets_") as folder:
            cls.labels = {label["test_piece"]: label for label in generate(PIECES, 4, folder)}
            out = os.path.join(folder, "campaign")
            for words in (("make", "--jobs", os.path.join(folder, "jobs.yaml"), "--output", out),
                          ("run", out, "--threads", "2"), ("collect", out)):
                subprocess.run([cls.campaign, *words], check=True, stdout=subprocess.DEVNULL)
            with open(os.path.join(out, "table.json"), encoding="utf-8") as file:
                cls.jobs = json.load(file)["jobs"]
            with open(os.path.join(out, "fleet.json"), encoding="utf-8") as file:
                cls.fleet = json.load(file)
        cls.types = {kind["name"]: kind for kind in cls.fleet["types"]}

    def test_every_piece_is_diagnosed(self):
        self.assertEqual([job["status"] for job in self.jobs], ["done"] * PIECES * len(FLEETS))
        self.assertNotIn("check_bench", [job["values"]["verdict"] for job in self.jobs])

    def intervals(self, parameter):
        """Return the interval of the median for each type."""
        return {name: row["median_interval_95"] for name, kind in self.types.items() for row in kind["parameters"]
                if row["name"] == parameter and "median_interval_95" in row}

    def test_scatter_is_told_from_an_effect(self):
        effects = {job["test_piece"]: job["values"]["effects"] for job in self.jobs}
        with_effect = [piece for piece, label in self.labels.items() if label["effect"]]
        self.assertGreaterEqual([effects[piece] for piece in with_effect].count("friction"), 2)  # of 3
        wrong = [job["test_piece"] for job in self.jobs
                 if job["values"]["effects"] and "parameter_error" not in job["values"]["alternatives"]
                 and job["test_piece"] not in with_effect and not job["type"].startswith("soft_rig")]
        self.assertLessEqual(len(wrong), 1, wrong)
        friction = self.types["effect_in_some"]["effects"][0]
        self.assertEqual(friction["name"], "friction")
        self.assertLess(friction["interval_95"][0], 3 / PIECES)
        self.assertGreater(friction["interval_95"][1], 3 / PIECES)

    def test_a_wrong_value_common_to_a_type_is_told_from_scatter(self):
        truths = {"wrong_values": 0.1, "scatter": 0.0, "effect_in_some": 0.0}
        missed = {parameter: [fleet for fleet, (low, high) in self.intervals(parameter).items()
                              if fleet in truths and not low <= truths[fleet] <= high] for parameter in SCATTER}
        for parameter, fleets in missed.items():
            self.assertLessEqual(len(fleets), 1, parameter)
        self.assertNotIn("wrong_values", missed["static_stiffness"])
        self.assertNotIn("scatter", missed["static_stiffness"])
        self.assertGreater(self.intervals("static_stiffness")["wrong_values"][0], 0.02)

    def test_outliers_are_far_out(self):
        pieces = {job["id"]: job["test_piece"] for job in self.jobs}
        far_out = {pieces[one["id"]] for kind in self.fleet["types"] for one in kind["far_out"]}
        outliers = {piece for piece, label in self.labels.items() if label["outlier"]}
        self.assertEqual(len(outliers), 1)
        self.assertLessEqual(outliers, far_out)
        self.assertLessEqual(len(far_out - outliers), 1, far_out)

    def test_a_rig_that_gives_way_takes_more_of_the_stiff_type(self):
        medians = {row["type"]: row["median"] for row in self.fleet["rigs"] if row["parameter"] == "static_stiffness"}
        # A compliance of 2.5e-8 m/N reduces ln K by log(1 + 2.5e-8 K): 2.5 % at 1 MN/m, 11.8 % at 5 MN/m.
        self.assertLess(medians["soft_rig_stiff"], medians["soft_rig_soft"] - 0.05)


if __name__ == "__main__":
    FleetTest.campaign = sys.argv.pop(1)
    unittest.main()
