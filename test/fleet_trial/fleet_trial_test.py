# A small check of the fleet statistics on virtual test pieces, from logs to verdicts, and tests of its scorer.
# fleet_trial_test.py CAMPAIGN: the path of the command.
"""Tests of the fleet statistics on simulated logs."""
import contextlib
import io
import os
import subprocess
import sys
import tempfile
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)

import score  # noqa: E402

PIECES = 8
FLEETS = ("scatter", "wrong_values", "effect_in_some", "outliers", "soft_rig_soft", "soft_rig_stiff")


class FleetTest(unittest.TestCase):
    """Six fleets of eight test pieces. Thresholds are what such small fleets have to reach, not what they can."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="rubber_suspension_fleets_")
        fleets = [word for fleet in FLEETS for word in ("--fleet", fleet)]
        subprocess.run([sys.executable, os.path.join(HERE, "run.py"), "--campaign", FleetTest.campaign, "--pieces",
                        str(PIECES), "--draws", "1", "--seed", "4", "--output", cls.folder.name, *fleets], check=True,
                       stdout=subprocess.DEVNULL)
        cls.pieces, cls.fleet = score.load(cls.folder.name, os.path.join(cls.folder.name, "campaign"))
        cls.result = score.score(cls.pieces, cls.fleet)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_piece_is_diagnosed(self):
        self.assertEqual((self.result["pieces"], self.result["failed"]), (PIECES * len(FLEETS), 0))
        self.assertFalse([p.row["test_piece"] for p in self.pieces if p.verdict == "check_bench"])

    def medians(self, parameter):
        """By kind of fleet, with their intervals."""
        return {kind["name"].rsplit("_", 1)[0]: (row["median"], row.get("median_interval_95"))
                for kind in self.fleet["types"] for row in kind["parameters"] if row["name"] == parameter}

    def test_scatter_is_told_from_an_effect(self):
        causes = self.result["causes"]
        self.assertGreaterEqual(causes["effect named"]["hits"], 2, causes)  # of 3
        self.assertLessEqual(causes["effect named where there is none"]["hits"], 1, causes)
        friction = next(kind for kind in self.fleet["types"] if kind["name"].startswith("effect_in_some"))["effects"][0]
        self.assertEqual(friction["name"], "friction")
        self.assertLess(friction["interval_95"][0], 3 / PIECES)
        self.assertGreater(friction["interval_95"][1], 3 / PIECES)

    def test_a_wrong_value_common_to_a_type_is_told_from_scatter(self):
        median, (low, high) = self.medians("static_stiffness")["wrong_values"]
        self.assertGreater(low, 0.02)
        self.assertTrue(low <= 0.1 <= high, (low, median, high))
        _, (low, high) = self.medians("static_stiffness")["scatter"]
        self.assertTrue(low <= 0.0 <= high, (low, high))
        for row in self.result["coverage"].values():
            self.assertGreaterEqual(row["hits"], row["of"] - 1, self.result["coverage"])

    def test_outliers_are_far_out(self):
        out = [p for p in self.pieces if p.label["outlier"]]
        self.assertEqual(len(out), 1)
        self.assertTrue(out[0].far_out)
        self.assertLessEqual(self.result["far_out"]["others that are far out"]["hits"], 1)

    def test_a_rig_that_gives_way_takes_more_of_the_stiff_type(self):
        medians = {row["type"].rsplit("_", 1)[0]: row["median"] for row in self.fleet["rigs"]
                   if row["parameter"] == "static_stiffness"}
        # 2.5e-8 m/N take log(1 + 2.5e-8 K): 2.5 % of 1 MN/m, 11.8 % of 5 MN/m, the scatter of eight pieces aside.
        self.assertLess(medians["soft_rig_stiff"], medians["soft_rig_soft"] - 0.05)


class ScoreTest(unittest.TestCase):
    """The scorer on findings whose score is known."""

    @staticmethod
    def piece(fleet, verdict, **label):
        full = {"fleet": fleet, "draw": 0, "outlier": False, "effect": "", "wrong": {}, "compliance": 0.0, **label}
        return score.Piece(full, {"values": {"verdict": verdict, "effects": ""}, "status": "done"})

    def test_who_is_far_out(self):
        pieces = [self.piece("outliers", "parameter_error", outlier=True), self.piece("outliers", "none"),
                  self.piece("scatter", "none")]
        pieces[0].far_out = pieces[2].far_out = True
        row = score.far_out(pieces)
        self.assertEqual(row["outliers found"], {"hits": 1, "of": 1})
        self.assertEqual(row["others that are far out"], {"hits": 1, "of": 2})
        self.assertEqual(row["fleets in which another is far out"], {"hits": 1, "of": 2})
        self.assertEqual(score.verdicts(pieces)["outliers"], {"parameter_error": 1, "none": 1})

    def test_coverage(self):
        wrong = dict.fromkeys(score.STIFFNESSES, 0.1)
        found = [{"name": "static_stiffness", "median": 0.09, "median_interval_95": [0.06, 0.12]},
                 {"name": "dynamic_stiffness", "median": 0.05, "median_interval_95": [0.04, 0.06]}]
        fleet = {"types": [{"name": "wrong_values_0", "parameters": found}]}
        rows = score.coverage([self.piece("wrong_values", "parameter_error", wrong=wrong)], fleet)
        self.assertEqual(rows["static_stiffness"], {"hits": 1, "of": 1})
        self.assertEqual(rows["dynamic_stiffness"], {"hits": 0, "of": 1})

    def test_the_page_has_a_row_for_each_fleet(self):
        pieces = [self.piece(kind, "none", wrong={"static_stiffness": 0.0}) for kind in score.FLEETS]
        fleet = {"types": [], "rigs": []}
        text = io.StringIO()
        with contextlib.redirect_stdout(text):
            print(score.markdown(score.score(pieces, fleet)))
        for kind in score.FLEETS:
            self.assertIn(f"| `{kind}` | none: 1 |", text.getvalue())


if __name__ == "__main__":
    FleetTest.campaign = sys.argv.pop(1)
    unittest.main()
